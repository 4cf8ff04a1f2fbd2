//! Pointer, wheel and keys over the scene, without a window: what the window does with the same events, beside the script lines that do
//! the same.

mod choosing;
mod course;
mod handles;
mod keys;
mod posing;
mod reaching;
mod table;
mod touching;
