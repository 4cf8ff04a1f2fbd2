//! The motion path of the chosen node: a line through its keyframes with a dot at each.

use std::sync::LazyLock;

use glam::Vec3;

use crate::colour::Colour;
use crate::editor::{Editor, PathDot};
use crate::frame::{Dot, Frame, Line};
use crate::keyframe::{KeyframeIndex, PlayRange};

/// Line segments between two keyframes, unless the list is long.
const PIECES_PER_INTERVAL: usize = 32;
/// The largest number of line segments.
const MOST_PIECES: usize = 4096;
/// Width of the path in pixels.
const PATH_WIDTH_PX: f32 = 2.0;
const DOT_PX: f32 = 8.0;
const CURRENT_DOT_PX: f32 = 11.0;
const MARK_PX: f32 = 21.0;

/// Linear-light colours, computed once.
static PATH: LazyLock<Vec3> = LazyLock::new(|| Colour::PATH.to_linear());
static CURRENT: LazyLock<Vec3> = LazyLock::new(|| Colour::ACCENT.to_linear());

/// Adds the path that the chosen node takes through its keyframes: a line with a dot at each, with the pieces that are not played fainter.
/// The eye has no path: it would pass through the camera.
pub(super) fn add_path(frame: &mut Frame, editor: &Editor) {
    let Some(chosen) = editor.path_node() else { return };
    let document = editor.document();
    let keyframes = &document.keyframes;
    let count = keyframes.len();
    if count < 2 {
        return;
    }
    let scene = editor.scene();
    let node = scene.rbt_node(chosen);
    let at_keyframe = |index: usize| {
        let pose = &keyframes.as_slice()[index].pose;
        scene.world_from_node(pose, editor.seconds(), node).translation.into()
    };
    let played = PlayRange::new(keyframes).ok();
    let pieces = (MOST_PIECES / count).clamp(1, PIECES_PER_INTERVAL);
    let colour = *PATH;
    let mut line = |from_in_world: Vec3, to_in_world: Vec3, opacity: f32| {
        frame.lines.push(Line { from_in_world, to_in_world, colour: colour.extend(opacity), width_px: PATH_WIDTH_PX });
    };
    for start in 0..count - 1 {
        let is_played = start > 0 && start + 2 < count;
        match played.as_ref().filter(|_| is_played) {
            None => line(at_keyframe(start), at_keyframe(start + 1), 0.3),
            Some(range) => {
                let mut from = at_keyframe(start);
                for piece in 1..=pieces {
                    #[expect(clippy::cast_precision_loss, reason = "there are few pieces")]
                    let alpha = piece as f32 / pieces as f32;
                    let to: Vec3 = scene
                        .world_from_node_with(editor.seconds(), node, |rbt| {
                            range.rbt_at(KeyframeIndex::new(start), alpha, document.interpolation, rbt).to_affine()
                        })
                        .translation
                        .into();
                    line(from, to, 0.85);
                    from = to;
                }
            }
        }
    }
    for index in 0..count {
        let is_current = keyframes.current() == Some(KeyframeIndex::new(index));
        let steers = played.is_some() && (index == 0 || index + 1 == count);
        let colour = if is_current { *CURRENT } else { colour };
        frame.dots.push(Dot {
            centre_in_world: at_keyframe(index),
            colour: colour.extend(if steers && !is_current { 0.5 } else { 1.0 }),
            diameter_px: if is_current { CURRENT_DOT_PX } else { DOT_PX },
        });
    }
}

/// Highlights a dot of the motion path: the one under the pointer or being dragged.
pub fn mark_dot(frame: &mut Frame, dot: PathDot) {
    let mark = |opacity: f32, diameter_px: f32| Dot {
        centre_in_world: dot.centre_in_world,
        colour: CURRENT.extend(opacity),
        diameter_px,
    };
    frame.dots.extend([mark(0.4, MARK_PX), mark(1.0, CURRENT_DOT_PX)]);
}
