//! What is seen: frames of a scene in a pose, with ghosts, and of what an editor displays.
//!
//! Films and pictures ask for [`frame_of_scene`] and [`add_ghosts`], which know no editor; the window and scripts ask for
//! [`frame_of_editor`], which adds the motion path, the arcball and the comparison. Only `editor`, `motion_path` and `comparison` in here
//! may name the editor.

mod comparison;
mod editor;
mod ghosts;
mod motion_path;
mod scene;

pub use editor::{frame_of_displayed, frame_of_editor};
pub use ghosts::{Neighbours, add_ghosts};
pub use motion_path::mark_dot;
pub use scene::{frame_of_scene, outline};
