//! Pictures that the CPU drew, in memory that an X server reads: where a driver sends each of them through a socket, that is a quarter
//! of a picture's time. Elsewhere than on Linux, and where the server is another machine's, there is no such way.

#[cfg(not(target_os = "linux"))]
mod nowhere;
#[cfg(target_os = "linux")]
mod x11;

#[cfg(not(target_os = "linux"))]
pub use nowhere::Shared;
#[cfg(target_os = "linux")]
pub use x11::Shared;
