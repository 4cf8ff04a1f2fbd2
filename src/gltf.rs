//! The files of glTF 2.0, as the specification has them: JSON, binary containers, accessors, animation samplers, meshes.
//!
//! This room knows the format and no scene. `interchange` maps what a file holds to a scene and back.

mod container;
pub mod json;

pub use container::{Container, DataUriError, GlbError, data_uri, decoded_data_uri, glb};
