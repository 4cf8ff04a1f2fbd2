//! The window: events in, commands to the editor, pictures out, and the effects that the editor asks for.
//!
//! Only here are winit's names known and, for the window, the clock on the wall read. What can be decided without a window is
//! plain data with tables of tests: [`hotkeys`], [`motion_path`], [`limb_drag`] and [`mod@pointer`]. What the pointer does over the scene is in
//! [`hands`], which tests drive without a window.

mod beginning;
#[cfg(not(target_arch = "wasm32"))]
mod clipboard;
mod damage;
#[cfg(not(target_arch = "wasm32"))]
mod desktop;
#[cfg(not(target_arch = "wasm32"))]
mod dialog;
mod display;
mod easing;
mod effects;
mod ending;
#[cfg(not(target_arch = "wasm32"))]
mod export;
pub mod handle;
mod handling;
pub mod hands;
pub mod hotkeys;
mod idle;
mod inset;
mod keeper;
pub mod limb_drag;
mod meter;
pub mod motion_path;
mod outside;
#[cfg(target_arch = "wasm32")]
mod page;
mod panels;
mod place;
pub mod pointer;
mod rest;
mod screen;
mod screenshot;
mod settings_file;
mod shared;
mod shell;
mod stage;

#[cfg(not(target_arch = "wasm32"))]
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::time::Duration;

use egui_winit::accesskit_winit;
use thiserror::Error;
use web_time::Instant;
#[cfg(not(target_arch = "wasm32"))]
use winit::event_loop::EventLoop;

#[cfg(not(target_arch = "wasm32"))]
use crate::editor::{Command, Editor};
use crate::film::ExportEnd;
use crate::render::GpuError;
use crate::ui::PathPurpose;
#[cfg(not(target_arch = "wasm32"))]
pub use ending::Signals;
#[cfg(target_arch = "wasm32")]
pub use page::start;
#[cfg(target_arch = "wasm32")]
use page::{clipboard, desktop, dialog, export};
#[cfg(not(target_arch = "wasm32"))]
use shell::Shell;

/// Why the window cannot open, and what to install.
#[derive(Debug, Error)]
pub enum WindowError {
    /// No display answers.
    #[error(
        "no display can be opened ({reason}; {variables}): start this from a desktop session, set DISPLAY or WAYLAND_DISPLAY, or use a virtual one \
         (Debian: apt-get install xvfb libxkbcommon-x11-0, then xvfb-run inbetween); check, sample, render and script need none"
    )]
    NoDisplay {
        /// What the window system says.
        reason: String,
        /// What the variables say that name a display.
        variables: String,
    },
    /// No adapter can draw on the window.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The window system ended the program.
    #[error("the window system ended the program: {reason}")]
    Ended {
        /// What it says.
        reason: String,
    },
    /// The display has gone.
    #[error("the display has gone")]
    DisplayGone,
    /// A signal ended the program.
    #[error("ended by signal {signal}")]
    Signalled {
        /// Its number.
        signal: i32,
    },
    /// A fault of the program ended it.
    #[error("a fault of the program ended it: {reason}")]
    Panicked {
        /// What the panic said.
        reason: String,
    },
    /// The same, and something was not saved.
    #[error("{error}; what was not saved is in {}: `inbetween recover` gets it back", .journal.display())]
    Unsaved {
        /// What ended the program.
        error: Box<WindowError>,
        /// The journal.
        journal: PathBuf,
    },
}

/// What tests ask of a window.
#[derive(Clone, Copy, Debug, Default)]
pub struct ForTests {
    /// Whether it prints the number of lines in the journal and [`fingerprint`](crate::journal::fingerprint) after each command, what
    /// it says of the journal, and `picture` for each picture that it draws.
    pub prints: bool,
    /// The command of this number panics, counted from 1.
    pub panics_at: Option<u64>,
    /// Drawing panics after so many commands.
    pub panics_in_drawing_at: Option<u64>,
    /// The device is lost after so many commands, and no other opens.
    pub loses_device_at: Option<u64>,
}

/// Events that threads of this program send to the window's event loop.
#[derive(Clone, Debug)]
pub(crate) enum UserEvent {
    /// The system's dialog was answered, or is not there.
    PathChosen {
        /// What for.
        purpose: PathPurpose,
        /// What was proposed.
        proposed: PathBuf,
        /// Which; `None`: cancelled, or no dialog.
        path: Option<PathBuf>,
        /// How long it took.
        took: Duration,
    },
    /// An export has made progress.
    ExportAt {
        /// Frames that are drawn.
        done: usize,
        /// Frames in all.
        count: usize,
    },
    /// The export is over.
    ExportEnded(ExportEnd),
    /// No file manager shows this folder.
    NoFileManager(PathBuf),
    /// The desktop prefers these colours.
    DesktopTheme(egui::Theme),
    /// The device is gone: everything on it is made again, in a page once [`UserEvent::DeviceBack`] says that it can.
    DeviceLost,
    /// The page's device is open, or cannot be opened.
    #[cfg(target_arch = "wasm32")]
    DeviceOpened,
    /// The page's device, which was lost, can be opened again.
    #[cfg(target_arch = "wasm32")]
    DeviceBack,
    /// A text was pasted into the page.
    #[cfg(target_arch = "wasm32")]
    Pasted(String),
    /// Files came from the page: by a drop, or from its dialog.
    #[cfg(target_arch = "wasm32")]
    FileCame(PathBuf),
    /// A signal asks for the end.
    Signal(i32),
    /// A screen reader asks for something.
    Accessibility(accesskit_winit::WindowEvent),
}

impl From<accesskit_winit::Event> for UserEvent {
    fn from(event: accesskit_winit::Event) -> Self {
        Self::Accessibility(event.window_event)
    }
}

/// Opens the window on an editor, does `at_start`, and goes on until the user quits.
///
/// # Errors
/// [`WindowError`], all of them before the user can have changed anything but the last.
#[cfg(not(target_arch = "wasm32"))]
pub fn run(editor: Editor, at_start: Vec<Command>, signals: &Signals, tests: ForTests) -> Result<(), WindowError> {
    let event_loop = event_loop()?;
    let shell = Shell::new(editor, at_start, event_loop.create_proxy(), tests);
    ending::run_to_end(event_loop, shell, signals)
}

/// The event loop. Where a library of the window system is missing, its binding panics: that is no display either.
#[cfg(not(target_arch = "wasm32"))]
fn event_loop() -> Result<EventLoop<UserEvent>, WindowError> {
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let made = catch_unwind(AssertUnwindSafe(|| {
        let mut builder = EventLoop::with_user_event();
        display::choose(&mut builder);
        builder.build()
    }));
    std::panic::set_hook(hook);
    let reason = match made {
        Ok(Ok(event_loop)) => return Ok(event_loop),
        // winit puts the place in its own sources before the sentence.
        Ok(Err(error)) => error.to_string().rsplit(": ").next().unwrap_or_default().trim_end_matches('.').to_owned(),
        Err(panic) => panic
            .downcast_ref::<String>()
            .cloned()
            .or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned()))
            .unwrap_or_else(|| "a library of the window system is missing".to_owned()),
    };
    Err(WindowError::NoDisplay { reason, variables: display::variables() })
}

/// The wall clock.
#[must_use]
pub(crate) fn now() -> Instant {
    Instant::now()
}
