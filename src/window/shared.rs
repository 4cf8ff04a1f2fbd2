//! Pictures that the CPU drew, in memory that an X server reads: a driver may send each of them through a socket, which takes a
//! quarter of the time. Elsewhere than on Linux there is no such way.

#[cfg(not(target_os = "linux"))]
mod nowhere;
#[cfg(target_os = "linux")]
mod x11;

#[cfg(not(target_os = "linux"))]
pub use nowhere::Shared;
#[cfg(target_os = "linux")]
pub use x11::Shared;
