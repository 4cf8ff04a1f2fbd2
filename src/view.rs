//! Makes frames: of a scene in a pose, with ghosts, and of the state of an editor.
//!
//! Exports use [`frame_of_nodes`], [`add_ghosts`], [`add_strobe`] and [`add_compared_nodes`], which do not depend on the editor. The window
//! and scripts use [`frame_of_editor`], which adds the motion path, the arcball, the handles and the comparison. Only the files `editor`, `frustum`, `motion_path`,
//! `gizmo`, `limb_balls` and `comparison` may name the editor.

mod comparison;
mod editor;
mod frustum;
mod ghosts;
mod gizmo;
mod limb_balls;
mod motion_path;
mod scene;

pub use comparison::{BLEND_COLOURS, PoseDifference, blend_off, compared_off};
pub use editor::{frame_of_displayed, frame_of_editor, frame_of_recorded_eye, picture_of_editor};
pub use ghosts::{Neighbours, add_compared_nodes, add_ghosts, add_strobe};
pub use gizmo::light_handle;
pub use limb_balls::{add_limb_balls, mark_limb_ball};
pub use motion_path::mark_dot;
pub use scene::{frame_of_nodes, frame_of_scene, light};
