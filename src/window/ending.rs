//! Endings that no user asked for in the window: signals, faults, a display that goes away.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;

use winit::event_loop::{EventLoop, EventLoopProxy};

use super::shell::Shell;
use super::{UserEvent, WindowError};
use crate::journal::Ending;

/// So long a window may take to end after a signal. What was done is in the journal already.
#[cfg(unix)]
const PATIENCE: std::time::Duration = std::time::Duration::from_secs(5);

/// Runs the window to its end, and ends its journal.
///
/// # Errors
/// [`WindowError`]
pub fn run_to_end(event_loop: EventLoop<UserEvent>, mut shell: Shell) -> Result<(), WindowError> {
    listen(event_loop.create_proxy());
    let ended = catch_unwind(AssertUnwindSafe(|| event_loop.run_app(&mut shell)));
    let (error, ending) = match (ended, shell.take_error()) {
        (Err(panic), _) => (Some(WindowError::Panicked { reason: reason(panic.as_ref()) }), Ending::Fault),
        (Ok(_), Some(error)) => (Some(error), Ending::Unwanted),
        (Ok(Err(error)), None) => (Some(WindowError::Ended { reason: error.to_string() }), Ending::Unwanted),
        (Ok(Ok(())), None) => (None, Ending::Quit),
    };
    let journal = shell.end_journal(ending);
    if ending == Ending::Fault {
        // What it holds may be in any state: the system takes it.
        std::mem::forget(shell);
    }
    match error {
        None => Ok(()),
        Some(error) => Err(with_journal(error, journal)),
    }
}

fn with_journal(error: WindowError, journal: Option<PathBuf>) -> WindowError {
    match journal {
        Some(journal) => WindowError::Unsaved { error: Box::new(error), journal },
        None => error,
    }
}

/// What a panic said.
pub fn reason(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().cloned();
    text.or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned())).unwrap_or_default()
}

/// Tells the window of signals that ask for the end.
#[cfg(unix)]
fn listen(proxy: EventLoopProxy<UserEvent>) {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    // Where they cannot be heard, they end the program as ever; all that was done is in the journal.
    let Ok(mut signals) = signal_hook::iterator::Signals::new([SIGTERM, SIGHUP, SIGINT]) else { return };
    let _ = std::thread::Builder::new().name("signals".to_owned()).spawn(move || {
        let Some(signal) = signals.forever().next() else { return };
        let _ = proxy.send_event(UserEvent::Signal(signal));
        std::thread::sleep(PATIENCE);
        std::process::exit(128 + signal);
    });
}

/// Says how work comes back when the X server goes away. Xlib ends the program at that moment and returns to nobody, so that this has a
/// connection and a thread of its own, which sleeps as long as the server is there.
#[cfg(target_os = "linux")]
pub fn watch_display(event_loop: &winit::event_loop::ActiveEventLoop) {
    use std::io::Write as _;
    use winit::platform::x11::ActiveEventLoopExtX11 as _;
    use x11rb::connection::Connection as _;

    if !event_loop.is_x11() {
        return;
    }
    let Ok((connection, _)) = x11rb::connect(None) else { return };
    let _ = std::thread::Builder::new().name("display".to_owned()).spawn(move || {
        while connection.wait_for_event().is_ok() {}
        let sentence = "the display has gone; what was not saved is in the journal: `inbetween recover` gets it back\n";
        let _ = std::io::stderr().write_all(sentence.as_bytes());
        std::process::exit(1);
    });
}

/// Elsewhere the event loop returns with an error.
#[cfg(not(target_os = "linux"))]
pub fn watch_display(_: &winit::event_loop::ActiveEventLoop) {}

/// Tells the window of what asks for the end.
#[cfg(not(unix))]
fn listen(proxy: EventLoopProxy<UserEvent>) {
    const SIGINT: i32 = 2;
    let _ = ctrlc::set_handler(move || drop(proxy.send_event(UserEvent::Signal(SIGINT))));
}
