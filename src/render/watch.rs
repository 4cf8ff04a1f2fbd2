//! Drivers that hang: they are asked on a thread of their own, and given up after a time.

#[cfg(not(target_arch = "wasm32"))]
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use super::gpu::GpuError;

/// How long a driver may take to open, or to do its first work.
pub(super) const PATIENCE: Duration = Duration::from_secs(18);

/// Runs what calls a driver on a thread of its own, which is started before the driver is called. Where it takes longer than
/// `patience`, the thread stays behind.
///
/// # Errors
/// [`GpuError::NoThreads`], [`GpuError::Hangs`] without a name, or what the work returns.
#[cfg(not(target_arch = "wasm32"))]
pub(super) fn watched<T: Send + 'static>(
    patience: Duration,
    work: impl FnOnce() -> Result<T, GpuError> + Send + 'static,
) -> Result<T, GpuError> {
    let (done, is_done) = channel();
    let thread = thread::Builder::new().name("driver".to_owned()).spawn(move || {
        // Whoever waited may be gone.
        let _ = done.send(work());
    });
    let thread = thread.map_err(cannot_start)?;
    match is_done.recv_timeout(patience) {
        Ok(outcome) => outcome,
        Err(RecvTimeoutError::Timeout) => Err(GpuError::Hangs { adapter: None, seconds: patience.as_secs() }),
        Err(RecvTimeoutError::Disconnected) => match thread.join() {
            Err(panic) => std::panic::resume_unwind(panic),
            Ok(()) => Err(GpuError::NoAdapter),
        },
    }
}

/// The error that explains why a driver fails, where no thread can be started any more.
pub(super) fn no_threads() -> Option<GpuError> {
    thread::Builder::new().spawn(|| ()).err().map(cannot_start)
}

fn cannot_start(error: std::io::Error) -> GpuError {
    GpuError::NoThreads { reason: error.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_hangs_is_given_up() {
        let (keep, hang) = channel::<()>();
        let outcome = watched(Duration::from_millis(20), move || {
            let _ = hang.recv();
            Ok(())
        });
        drop(keep);
        assert!(matches!(outcome, Err(GpuError::Hangs { adapter: None, .. })), "{outcome:?}");
        assert_eq!(watched(PATIENCE, || Ok(7)).unwrap(), 7);
    }
}
