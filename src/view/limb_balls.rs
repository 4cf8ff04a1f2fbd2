//! Balls at the ends of limbs, which can be dragged.

use std::sync::LazyLock;

use glam::Vec3;

use crate::colour::Colour;
use crate::editor::{Editor, LimbBall};
use crate::frame::{Dot, Frame};
use crate::pose::RbtIndex;

const RIM_PX: f32 = 13.0;
const BALL_PX: f32 = 9.0;
const MARK_PX: f32 = 23.0;
const MARKED_BALL_PX: f32 = 13.0;

/// Linear-light colours, computed once.
static BALL: LazyLock<Vec3> = LazyLock::new(|| Colour::PATH.to_linear());
static MARKED: LazyLock<Vec3> = LazyLock::new(|| Colour::ACCENT.to_linear());

fn dot(ball: LimbBall, colour: Vec3, opacity: f32, diameter_px: f32) -> Dot {
    Dot { centre_in_world: ball.end_in_world, colour: colour.extend(opacity), diameter_px }
}

/// Adds the balls of the robots of the chosen node and of the node under the pointer.
pub fn add_limb_balls(frame: &mut Frame, editor: &Editor, hovered: Option<RbtIndex>) {
    for ball in editor.limb_balls(hovered) {
        frame.dots.extend([dot(ball, Vec3::ZERO, 0.4, RIM_PX), dot(ball, *BALL, 0.9, BALL_PX)]);
    }
}

/// Highlights a ball: the one under the pointer or being dragged.
pub fn mark_limb_ball(frame: &mut Frame, ball: LimbBall) {
    frame.dots.extend([dot(ball, *MARKED, 0.4, MARK_PX), dot(ball, *MARKED, 1.0, MARKED_BALL_PX)]);
}
