//! The system's clipboard takes what is copied. What is pasted comes as [`UserEvent::Pasted`](crate::window::UserEvent::Pasted): a
//! browser gives nothing unasked.

use egui::{OutputCommand, PlatformOutput};
use winit::window::Window;

/// The system's clipboard.
pub struct Clipboard;

impl Clipboard {
    /// The clipboard.
    pub const fn new(_: &Window, _: &mut egui_winit::State) -> Self {
        Self
    }

    /// Does nothing: the press of a key is no paste here.
    pub const fn fill_in(&mut self, _: &mut egui_winit::State, _: bool) {}

    /// Gives the system what the panels copy.
    pub fn take(&mut self, output: &PlatformOutput) {
        for command in &output.commands {
            if let OutputCommand::CopyText(text) = command {
                super::copy(text);
            }
        }
    }
}
