//! Eyes without a shape, such as the sky camera, as wires: the pyramid that they see the beginning of.

use std::sync::LazyLock;

use glam::Vec3;

use crate::colour::Colour;
use crate::editor::Editor;
use crate::frame::{Frame, Line};
use crate::pose::Pose;

/// Depth of the pyramid, in scene units.
const DEPTH: f32 = 0.5;
/// Width over height of what it frames; that of pictures depends on their size.
const ASPECT: f32 = 4.0 / 3.0;
/// Height of the mark on its upper side, as a part of its own half height.
const MARK: f32 = 0.5;
const WIDTH_PX: f32 = 1.5;
const OPACITY: f32 = 0.7;

/// Linear-light colours, computed once.
static AT_REST: LazyLock<Vec3> = LazyLock::new(|| Colour::TEXT.to_linear());
static CHOSEN: LazyLock<Vec3> = LazyLock::new(|| Colour::ACCENT.to_linear());

/// Adds the wires of all eyes that are not looked from and have no shape. `pose` must be the frame's.
pub(super) fn add_eyes(frame: &mut Frame, editor: &Editor, pose: &Pose) {
    let scene = editor.scene();
    let half_height = DEPTH * (scene.vertical_fov() * 0.5).tan();
    for eye in editor.bare_eyes() {
        let world_from_eye = scene.world_from_rbt(pose, editor.seconds(), eye);
        let at = |x: f32, y: f32| {
            world_from_eye.transform_point(Vec3::new(x * ASPECT * half_height, y * half_height, -DEPTH))
        };
        let corners = [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)];
        let apex = world_from_eye.translation;
        let top = at(0.0, 1.0 + MARK);
        let is_chosen = editor.session().chosen.contains(&eye);
        let colour = if is_chosen { CHOSEN.extend(1.0) } else { AT_REST.extend(OPACITY) };
        let mut line = |from_in_world, to_in_world| {
            frame.lines.push(Line { from_in_world, to_in_world, colour, width_px: WIDTH_PX });
        };
        for (index, corner) in corners.into_iter().enumerate() {
            line(apex, corner);
            line(corner, corners[(index + 1) % corners.len()]);
        }
        line(at(-MARK, 1.0), top);
        line(top, at(MARK, 1.0));
    }
}
