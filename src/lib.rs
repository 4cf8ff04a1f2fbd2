//! Inbetween, a desktop 3D keyframe animator.

pub mod camera;
pub mod cli;
pub mod clock;
pub mod compare;
pub mod editor;
pub mod frame;
pub mod interpolation;
pub mod json;
pub mod keyframe;
pub mod pose;
pub mod rbt;
pub mod render;
pub mod scene;
pub mod storage;
pub mod timed;
pub mod ui;
pub mod window;
