//! Suppresses output of graphics drivers on standard error.
//!
//! Vulkan layers print warnings about the desktop (`XDG_RUNTIME_DIR is invalid or not set`) although pictures are correct. Real problems
//! are returned as errors. With `RUST_LOG` set, standard error is not redirected.

#[cfg(unix)]
use std::sync::{Mutex, PoisonError};

/// Standard error belongs to the process: without the lock, two threads could leave it redirected.
#[cfg(unix)]
static REDIRECTING: Mutex<()> = Mutex::new(());

/// Runs a function that loads drivers, with standard error redirected.
#[cfg(unix)]
pub fn without_driver_chatter<T>(ask: impl FnOnce() -> T) -> T {
    use rustix::fs::{Mode, OFlags, open};
    use rustix::io::fcntl_dupfd_cloexec;
    use rustix::stdio::{dup2_stderr, stderr};

    if std::env::var_os("RUST_LOG").is_some() {
        return ask();
    }
    let _guard = REDIRECTING.lock().unwrap_or_else(PoisonError::into_inner);
    let kept = fcntl_dupfd_cloexec(stderr(), 0);
    let nowhere = open("/dev/null", OFlags::WRONLY | OFlags::CLOEXEC, Mode::empty());
    let (Ok(kept), Ok(nowhere)) = (kept, nowhere) else { return ask() };
    if dup2_stderr(&nowhere).is_err() {
        return ask();
    }
    let _restore = Restore(kept);
    ask()
}

/// Restores standard error on drop, also if a driver panics.
#[cfg(unix)]
struct Restore(rustix::fd::OwnedFd);

#[cfg(unix)]
impl Drop for Restore {
    fn drop(&mut self) {
        let _ = rustix::stdio::dup2_stderr(&self.0);
    }
}

/// Runs a function that loads drivers.
#[cfg(not(unix))]
pub fn without_driver_chatter<T>(ask: impl FnOnce() -> T) -> T {
    ask()
}
