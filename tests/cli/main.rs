//! The command line, by running the binary: bytes in; bytes, files and exit statuses out.

mod check;
mod compare;
mod convert;
mod films;
mod playback;
mod render;
mod sample;
mod sandbox;
mod script;
mod usage;
mod verify;
