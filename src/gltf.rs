//! The files of glTF 2.0, as the specification has them: JSON, binary containers, accessors, animation samplers, meshes.
//!
//! This room knows the format and no scene. `interchange` maps what a file holds to a scene and back.

mod accessor;
mod container;
mod document;
pub mod json;
mod materials;
mod meshes;
mod sampler;
mod skins;
mod uri;
mod write;

pub use accessor::MOST_ZEROS;
pub use container::{Container, DataUriError, GlbError, data_uri, decoded_data_uri, glb};
pub use document::{Document, GltfError, MOST_BUFFER_BYTES, MOST_NUMBERS, ReadFile, UNDERSTOOD};
pub use materials::{MOST_MILLION_PIXELS, MOST_PIXELS_A_SIDE};
pub use meshes::{MeshReader, PrimitiveMesh, unique_name};
pub use sampler::{Course, Curve, Sampled};
pub use uri::relative_path;
pub use write::Writer;
