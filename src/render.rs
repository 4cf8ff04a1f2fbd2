//! Drawing: a [`Frame`](crate::frame::Frame) in, pixels out, on any texture view.
//!
//! [`Gpu`] is the adapter and its device; [`Renderer`] draws a frame into whatever view it is given and cannot tell a window's from
//! another; [`Offscreen`] is such a view with the way back to the CPU; [`Image`] is what comes back.
//!
//! Nothing here knows the editor, the interface or where a frame came from. Colours are linear light until the last step of each
//! fragment shader. Depth is reversed: 1 at the near plane, 0 at infinity. No shader uses derivatives, so that a picture is the
//! same to the byte whenever it is drawn.

mod arrange;
mod bounds;
mod detail;
mod gpu;
mod identity;
mod instances;
mod light;
mod look;
mod mesh;
mod offscreen;
mod pipelines;
mod quiet;
mod read_back;
mod renderer;
mod shaders;
mod targets;
mod uniforms;

pub use crate::picture::Image;
pub use arrange::Arrangement;
pub use gpu::{Gpu, GpuError};
pub use identity::node_picture;
pub use offscreen::Offscreen;
pub use read_back::{Drawn, ReadBack};
pub use renderer::{Background, Renderer, Target, Viewport, default_samples};
