//! Scenes and animations from and to the formats of other programs: bytes in, values and a report out.
//!
//! Nothing here touches files. Callers read and write them.

pub mod bvh;
pub mod figure;
pub mod gltf_in;
pub mod gltf_out;
pub mod reduce;
pub mod retarget;

/// The most nodes times poses of a dense animation: some hundred megabytes.
const MOST_NODE_POSES: usize = 1 << 23;
