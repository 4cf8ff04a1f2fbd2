//! Motions of the dragged node: "do M to O with respect to A" (Gortler, chapters 4 and 8).
//!
//! O is the chosen node, or the eye. A, the auxiliary frame, has the translation of O and the rotation of the eye, so that a drag to
//! the right moves to the right on screen and turns happen about the node's own centre. The eye itself moves ego-style, by its own
//! frame; the sky camera can move about the world's centre instead.

use glam::{Quat, Vec2, Vec3};

use super::{Editor, Eye, SkyMode};
use crate::camera::{Arcball, Camera};
use crate::pose::RbtIndex;
use crate::rbt::Rbt;

/// Radius of the arcball, as a part of the view's smaller side.
pub(super) const ARCBALL_RADIUS: f32 = 0.25;
/// Depth that counts for moving the eye itself, in scene units.
const EGO_DEPTH: f32 = 4.0;
/// How much of the depth one notch of the wheel goes.
const WHEEL_STEP: f32 = 0.08;

/// What a drag does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DragKind {
    /// Turns, by the arcball.
    Rotate,
    /// Moves in the view's plane.
    Translate,
    /// Moves along the view.
    Dolly,
}

/// How the dragged node moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Style {
    /// A node other than the eye, by the arcball around it.
    Node,
    /// The sky camera about the world's centre: the world seems to be dragged, so the motion is inverted.
    Orbit,
    /// The eye by its own frame. Turns are inverted, so that the point under the pointer stays under it.
    Ego,
}

/// The dragged node, its auxiliary frame and its arcball: what turns a drag into a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Manipulation {
    style: Style,
    camera: Camera,
    /// The ball that a drag turns; `None` where the eye turns by itself, or the centre is out of sight.
    pub arcball: Option<Arcball>,
    /// The centre of the ball in world space, and its radius in scene units.
    pub arcball_in_world: Option<(Vec3, f32)>,
    /// Scene units for each pixel of a drag.
    units_per_pixel: f32,
}

impl Manipulation {
    /// The motion M for a drag from one pixel to another (origin at the view's top left, y down), in the auxiliary frame.
    #[must_use]
    pub fn motion(&self, kind: DragKind, from_px: Vec2, to_px: Vec2) -> Rbt {
        let by_px = to_px - from_px;
        let motion = match kind {
            DragKind::Rotate => Rbt::from_rotation(self.rotation(from_px, to_px)),
            DragKind::Translate => Rbt::from_translation(Vec3::new(by_px.x, -by_px.y, 0.0) * self.units_per_pixel),
            DragKind::Dolly => Rbt::from_translation(Vec3::new(0.0, 0.0, by_px.y) * self.units_per_pixel),
        };
        match (self.style, kind) {
            (Style::Orbit, _) | (Style::Ego, DragKind::Rotate) => motion.inverse(),
            (Style::Node | Style::Ego, _) => motion,
        }
    }

    /// The motion M for turns of the wheel: up is positive and moves the dragged node forward along the view.
    #[must_use]
    pub fn wheel(&self, notches: f32) -> Rbt {
        let depth = self.units_per_pixel / self.camera.units_per_pixel_at_unit_depth();
        Rbt::from_translation(Vec3::new(0.0, 0.0, -notches * WHEEL_STEP * depth))
    }

    fn rotation(&self, from_px: Vec2, to_px: Vec2) -> Quat {
        if let Some(arcball) = self.arcball {
            return arcball.rotation(from_px, to_px);
        }
        let radians = (to_px - from_px) * self.camera.vertical_fov / self.camera.size_px.y;
        Quat::from_rotation_x(radians.y) * Quat::from_rotation_y(radians.x)
    }
}

impl Editor {
    /// The camera of what is displayed, for a picture of this size in pixels.
    #[must_use]
    pub fn camera(&self, size_px: Vec2) -> Camera {
        Camera {
            world_from_eye: self.world_from_eye(&self.displayed_pose()),
            vertical_fov: self.document.scene.vertical_fov(),
            size_px,
        }
    }

    /// How a drag moves one of the dragged nodes.
    fn style_of(&self, rbt: Option<RbtIndex>) -> Style {
        if rbt != self.eye() {
            Style::Node
        } else if self.session.eye == Eye::Recorded(0)
            && self.session.chosen.is_empty()
            && self.session.sky_mode == SkyMode::WorldCentre
        {
            Style::Orbit
        } else {
            Style::Ego
        }
    }

    /// How a drag in a view of this camera moves the dragged node.
    #[must_use]
    pub fn manipulation(&self, camera: &Camera) -> Manipulation {
        let style = self.style_of(self.dragged_node());
        let centre_in_world = match style {
            Style::Node => {
                let pose = self.displayed_pose();
                let own = |node| self.scene().world_from_rbt(&pose, self.seconds(), node).translation;
                self.common_centre(&pose).or(self.dragged_node().map(own))
            }
            Style::Orbit => Some(Vec3::ZERO),
            Style::Ego => None,
        };
        let unit = camera.units_per_pixel_at_unit_depth();
        let seen = centre_in_world.and_then(|centre| camera.project(centre).map(|seen| (centre, seen)));
        let radius_px = ARCBALL_RADIUS * camera.size_px.min_element();
        let units_per_pixel = unit * seen.map_or(EGO_DEPTH, |(_, (_, depth))| depth);
        Manipulation {
            style,
            camera: *camera,
            arcball: seen.map(|(_, (centre_px, _))| Arcball { centre_px, radius_px }),
            arcball_in_world: seen.map(|(centre, _)| (centre, radius_px * units_per_pixel)),
            units_per_pixel,
        }
    }

    /// The dragged nodes after a motion with respect to their auxiliary frames: a new `parent_from_node` each. Of a chain, what hangs
    /// below another moved node is only carried along, unless each turns about its own origin.
    pub(super) fn moved(&self, motion: Rbt) -> Vec<(RbtIndex, Rbt)> {
        let pose = &self.edited_pose();
        let seconds = self.seconds();
        let scene = &self.document.scene;
        let world_from_eye = self.world_from_eye(pose);
        let nodes = if motion.translation == Vec3::ZERO { self.turned_nodes() } else { self.topmost_dragged() };
        let common = self.common_centre(pose);
        let moved = |rbt| {
            let world_from_object = scene.world_from_rbt(pose, seconds, rbt);
            let world_from_auxiliary = match self.style_of(Some(rbt)) {
                Style::Node => Rbt::new(common.unwrap_or(world_from_object.translation), world_from_eye.rotation),
                Style::Orbit => Rbt::from_rotation(world_from_eye.rotation),
                Style::Ego => world_from_object,
            };
            let (before, after) = (pose.get(rbt), self.moved_by(pose, rbt, motion, world_from_auxiliary));
            // What a motion leaves alone keeps its bits: a drag is hundreds of motions, whose roundings would add up.
            let turns_in_place =
                motion.translation == Vec3::ZERO && world_from_auxiliary.translation == world_from_object.translation;
            let translation = if turns_in_place { before.translation } else { after.translation };
            let rotation = if motion.rotation == Quat::IDENTITY { before.rotation } else { after.rotation };
            (rbt, Rbt { translation, rotation })
        };
        nodes.into_iter().map(moved).collect()
    }
}
