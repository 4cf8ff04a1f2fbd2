//! Inbetween, a desktop 3D keyframe animator.

pub mod rbt;
pub mod scene;
pub mod frame;
pub mod render;
