//! Presents CPU-drawn pictures through memory shared with an X server (MIT-SHM). A driver that sends them through a socket needs a quarter
//! of a picture's time for it. Only available on Linux and with a local X server.

#[cfg(not(target_os = "linux"))]
mod nowhere;
#[cfg(target_os = "linux")]
mod x11;

#[cfg(not(target_os = "linux"))]
pub use nowhere::Shared;
#[cfg(target_os = "linux")]
pub use x11::Shared;
