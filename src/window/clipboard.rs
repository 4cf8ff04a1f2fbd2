//! The system's clipboard on X11, Windows and macOS, for text alone: pictures would cost the whole of the crate `image`. On Wayland
//! `egui_winit` asks the compositor itself; elsewhere it has a clipboard of its own, of which this makes the system's.

use egui::{Event, OutputCommand, PlatformOutput, PointerButton};
use winit::raw_window_handle::{HasDisplayHandle as _, RawDisplayHandle};
use winit::window::Window;

/// The system's clipboard. Nothing on Wayland, and where there is none.
pub struct Clipboard(Option<arboard::Clipboard>);

impl Clipboard {
    /// The clipboard for a window whose events `input` takes in.
    pub fn new(window: &Window, input: &mut egui_winit::State) -> Self {
        let display = window.display_handle().map(|display| display.as_raw());
        if matches!(display, Ok(RawDisplayHandle::Wayland(_))) {
            return Self(None);
        }
        let system = arboard::Clipboard::new().inspect_err(|error| log::warn!("there is no clipboard: {error}")).ok();
        if system.is_some() {
            // A paste is only announced if there is something to paste.
            input.set_clipboard_text(" ".to_owned());
        }
        Self(system)
    }

    /// Brings the system's text to a paste that the last event of the window became. `is_typing`: a text field has the keyboard.
    pub fn fill_in(&mut self, input: &mut egui_winit::State, is_typing: bool) {
        let Some(system) = &mut self.0 else { return };
        let events = &mut input.egui_input_mut().events;
        match events.last_mut() {
            Some(Event::Paste(pasted)) => match system.get_text() {
                Ok(text) => *pasted = text.replace("\r\n", "\n"),
                Err(_) => drop(events.pop()),
            },
            Some(&mut Event::PointerButton { pos, button: PointerButton::Middle, pressed: true, .. }) if is_typing => {
                if let Some(text) = selected(system).filter(|text| !text.is_empty()) {
                    events.push(Event::MiddleClickPaste { pos, text });
                }
            }
            _ => {}
        }
    }

    /// Gives the system what the panels copy.
    pub fn take(&mut self, output: &PlatformOutput) {
        let Some(system) = &mut self.0 else { return };
        for command in &output.commands {
            let done = match command {
                OutputCommand::CopyText(text) => system.set_text(text),
                OutputCommand::TextSelectionSettled(text) => select(system, text),
                _ => Ok(()),
            };
            if let Err(error) = done {
                log::warn!("the clipboard does not take a text: {error}");
            }
        }
    }
}

/// The text that is selected in any window, which X11 pastes by the middle button.
#[cfg(all(unix, not(target_os = "macos")))]
fn selected(system: &mut arboard::Clipboard) -> Option<String> {
    use arboard::{GetExtLinux as _, LinuxClipboardKind};
    system.get().clipboard(LinuxClipboardKind::Primary).text().ok()
}

#[cfg(all(unix, not(target_os = "macos")))]
fn select(system: &mut arboard::Clipboard, text: &str) -> Result<(), arboard::Error> {
    use arboard::{LinuxClipboardKind, SetExtLinux as _};
    system.set().clipboard(LinuxClipboardKind::Primary).text(text)
}

#[cfg(not(all(unix, not(target_os = "macos"))))]
fn selected(_: &mut arboard::Clipboard) -> Option<String> {
    None
}

#[cfg(not(all(unix, not(target_os = "macos"))))]
fn select(_: &mut arboard::Clipboard, _: &str) -> Result<(), arboard::Error> {
    Ok(())
}
