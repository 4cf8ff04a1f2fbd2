//! Meshes of triangles: what the GPU keeps of them, what joints make of them, and their draw calls.

mod cache;
mod draws;
mod layouts;
mod mips;
mod skins;
mod surface;

pub use cache::{MeshCache, MeshForm};
pub use draws::{TriangleDraw, TriangleDraws};
pub use layouts::{joints_layout, material_layout, surface_buffer, weights_buffer};
pub use skins::{JointRows, Skinning, Skins};
