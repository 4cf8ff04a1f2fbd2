//! Endings that no user asked for in the window: signals, faults, a display that goes away.

use std::any::Any;
#[cfg(not(target_arch = "wasm32"))]
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
#[cfg(not(target_arch = "wasm32"))]
use std::thread;
#[cfg(not(target_arch = "wasm32"))]
use std::time::Duration;

use winit::event_loop::ActiveEventLoop;
#[cfg(not(target_arch = "wasm32"))]
use winit::event_loop::{EventLoop, EventLoopProxy};

#[cfg(not(target_arch = "wasm32"))]
use super::UserEvent;
use super::WindowError;
#[cfg(not(target_arch = "wasm32"))]
use super::shell::Shell;
#[cfg(not(target_arch = "wasm32"))]
use crate::journal::Ending;
#[cfg(not(target_arch = "wasm32"))]
use crate::signals;

#[cfg(not(target_arch = "wasm32"))]
/// So long a window may take to end after a signal. What was done is in the journal already.
const PATIENCE: Duration = Duration::from_secs(5);
#[cfg(target_os = "linux")]
/// The exit status where the display has gone.
const DISPLAY_GONE: i32 = 1;

/// Where the window keeps its journal now, for threads that end the program; `None` where it keeps none.
#[derive(Clone, Debug, Default)]
pub struct Whereabouts(Arc<Mutex<Option<PathBuf>>>);

impl Whereabouts {
    /// The journal is there from now on.
    pub fn set(&self, journal: Option<PathBuf>) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = journal;
    }

    /// The sentence on why the program ends, and how work comes back.
    fn sentence(&self, error: WindowError) -> String {
        with_journal(error, self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()).to_string()
    }
}

#[cfg(not(target_arch = "wasm32"))]
/// Signals, which end the program at once until there is a window.
#[derive(Clone, Default)]
pub struct Signals {
    window: Arc<Mutex<Option<EventLoopProxy<UserEvent>>>>,
    journal: Whereabouts,
}

#[cfg(not(target_arch = "wasm32"))]
impl Signals {
    /// Listens from now on.
    #[must_use]
    pub fn listen() -> Self {
        let this = Self::default();
        let Self { window, journal } = this.clone();
        let mut is_first = true;
        signals::listen(move |signal| {
            let window = window.lock().unwrap_or_else(PoisonError::into_inner).take();
            let asked = window.is_some_and(|window| window.send_event(UserEvent::Signal(signal)).is_ok());
            let sentence = journal.sentence(WindowError::Signalled { signal });
            if !(asked && std::mem::take(&mut is_first)) {
                return Some(sentence);
            }
            // A window that hangs is not waited for. Without the thread, the next signal ends it.
            let _ = thread::Builder::new().name("patience".to_owned()).spawn(move || {
                thread::sleep(PATIENCE);
                signals::end(128 + signal, &sentence);
            });
            None
        });
        this
    }
}

#[cfg(not(target_arch = "wasm32"))]
/// Runs the window to its end, and ends its journal.
///
/// # Errors
/// [`WindowError`]
pub fn run_to_end(event_loop: EventLoop<UserEvent>, mut shell: Shell, signals: &Signals) -> Result<(), WindowError> {
    shell.keep_whereabouts(signals.journal.clone());
    *signals.window.lock().unwrap_or_else(PoisonError::into_inner) = Some(event_loop.create_proxy());
    let ended = catch_unwind(AssertUnwindSafe(|| event_loop.run_app(&mut shell)));
    let (error, ending) = match (ended, shell.take_error()) {
        // What panics where the display has gone is not the fault of the last command.
        (Err(_) | Ok(Err(_)), _) if display::has_gone() => (Some(WindowError::DisplayGone), Ending::Unwanted),
        (Err(panic), _) => (Some(WindowError::Panicked { reason: reason(panic.as_ref()) }), Ending::Fault),
        (Ok(_), Some(error)) => (Some(error), Ending::Unwanted),
        (Ok(Err(error)), None) => (Some(WindowError::Ended { reason: error.to_string() }), Ending::Unwanted),
        (Ok(Ok(())), None) => (None, Ending::Quit),
    };
    display::forget();
    let journal = shell.end_journal(ending);
    if !matches!(ending, Ending::Quit) {
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

/// Has the program say how work comes back when the X server goes away.
pub fn watch_display(event_loop: &ActiveEventLoop, journal: Whereabouts) {
    display::watch(event_loop, journal);
}

/// Xlib ends the program by `exit` at the moment when it finds that the X server has gone, and returns to nobody. Two watch for that,
/// and the first of them ends the program: a thread with a connection of its own, which sleeps as long as the server is there; and a
/// value of the main thread, which the C library drops within `exit` (glibc does; elsewhere the thread must be the faster one).
#[cfg(target_os = "linux")]
mod display {
    use std::cell::Cell;
    use std::thread;

    use winit::event_loop::ActiveEventLoop;
    use winit::platform::x11::ActiveEventLoopExtX11 as _;
    use x11rb::connection::Connection as _;

    use super::{DISPLAY_GONE, Whereabouts};
    use crate::signals;
    use crate::window::WindowError;

    thread_local! {
        static AT_EXIT: AtExit = const { AtExit(Cell::new(None)) };
    }

    struct AtExit(Cell<Option<Whereabouts>>);

    impl Drop for AtExit {
        fn drop(&mut self) {
            let Some(journal) = self.0.take() else { return };
            let error = if is_there() {
                WindowError::Ended { reason: "a library gave up".to_owned() }
            } else {
                WindowError::DisplayGone
            };
            signals::end_within_exit(DISPLAY_GONE, &journal.sentence(error));
        }
    }

    pub(super) fn watch(event_loop: &ActiveEventLoop, journal: Whereabouts) {
        if !event_loop.is_x11() {
            return;
        }
        AT_EXIT.with(|at_exit| at_exit.0.set(Some(journal.clone())));
        let Ok((connection, _)) = x11rb::connect(None) else { return };
        let _ = thread::Builder::new().name("display".to_owned()).spawn(move || {
            while connection.wait_for_event().is_ok() {}
            signals::end(DISPLAY_GONE, &journal.sentence(WindowError::DisplayGone));
        });
    }

    /// Whether there was an X server, and it has gone.
    pub(super) fn has_gone() -> bool {
        AT_EXIT.with(|at_exit| {
            let journal = at_exit.0.take();
            let is_watched = journal.is_some();
            at_exit.0.set(journal);
            is_watched && !is_there()
        })
    }

    /// The window has ended.
    pub(super) fn forget() {
        AT_EXIT.with(|at_exit| at_exit.0.set(None));
    }

    fn is_there() -> bool {
        x11rb::connect(None).is_ok()
    }
}

/// Elsewhere the event loop returns with an error.
#[cfg(not(target_os = "linux"))]
mod display {
    pub(super) fn watch(_: &super::ActiveEventLoop, _: super::Whereabouts) {}

    pub(super) fn has_gone() -> bool {
        false
    }

    pub(super) fn forget() {}
}
