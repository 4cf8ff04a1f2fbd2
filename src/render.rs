//! Drawing: a [`Frame`](crate::frame::Frame) in, pixels out, on any texture view.
//!
//! [`Gpu`] is the adapter and its device. [`Renderer`] draws a frame into any texture view, of a window or not. [`Offscreen`] is a texture
//! with read-back to the CPU; [`Image`] is the result.
//!
//! This module does not know the editor or the user interface. Colours are linear light until the last step of each fragment shader. Depth
//! is reversed: 1 at the near plane, 0 at infinity. No shader uses derivatives, so that a picture has the same bytes each time.

mod arrange;
mod bounds;
mod choice;
mod contact;
mod described;
mod detail;
mod edges;
mod gpu;
mod identity;
mod instances;
mod light;
mod look;
mod offscreen;
mod pipelines;
#[cfg(not(target_arch = "wasm32"))]
mod quiet;
mod read_back;
mod refine;
mod renderer;
mod shaders;
mod sub_frames;
mod targets;
mod triangles;
mod uniforms;
mod watch;

use crate::unit_mesh as mesh;

pub use crate::picture::Image;
pub use arrange::Arrangement;
pub use choice::{DRIVER_VARIABLES, SELECTED_DRIVERS, SOFTWARE_DRIVER, software_alone};
pub use described::adapter_facts;
pub use gpu::{Gpu, GpuError};
pub use identity::node_picture;
pub use offscreen::Offscreen;
pub use read_back::{Drawn, ReadBack};
pub use refine::Refiner;
pub use renderer::{Background, Renderer, Target, Viewport, default_samples};
pub use sub_frames::{Refinement, SubFrame};
pub use triangles::Skinning;
