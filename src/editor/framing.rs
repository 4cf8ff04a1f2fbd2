//! Where the work eye stands to show something: a side of the scene, the chosen nodes, everything.

use glam::Vec3;

use super::apply::CommandResult;
use super::manipulate::ARCBALL_RADIUS;
use super::{Editor, Eye, WorkEye};
use crate::pose::RbtIndex;
use crate::scene::NodeKind;
use crate::words::texts;

/// Width over height of the narrowest view that shows all that is meant to be in sight.
const ASPECT: f32 = 4.0 / 3.0;
/// Room around it.
const MARGIN: f32 = 1.05;

/// A side to look from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// From +Z, which robots face.
    Front,
    /// From −Z.
    Back,
    /// From +X.
    Right,
    /// From −X.
    Left,
    /// From +Y.
    Top,
    /// From −Y.
    Bottom,
}

impl Side {
    /// All of them, with the words that scripts use.
    pub const NAMES: [(Self, &'static str); 6] = [
        (Self::Front, "front"),
        (Self::Back, "back"),
        (Self::Right, "right"),
        (Self::Left, "left"),
        (Self::Top, "top"),
        (Self::Bottom, "bottom"),
    ];

    /// Yaw and pitch of the work eye, in degrees.
    const fn angles(self) -> [f32; 2] {
        match self {
            Self::Front => [0.0, 0.0],
            Self::Back => [180.0, 0.0],
            Self::Right => [90.0, 0.0],
            Self::Left => [-90.0, 0.0],
            Self::Top => [0.0, 90.0],
            Self::Bottom => [0.0, -90.0],
        }
    }
}

impl Editor {
    /// Looks from the work eye, which is put somewhere first.
    fn look_from(&mut self, eye: Option<WorkEye>) -> CommandResult {
        if let Some(eye) = eye {
            self.set_work_eye(eye)?;
        }
        if self.is_work_eye() { Ok(None) } else { self.set_eye(Eye::Work) }
    }

    pub(super) fn look_from_side(&mut self, side: Side) -> CommandResult {
        let [yaw_degrees, pitch_degrees] = side.angles();
        self.look_from(Some(WorkEye { yaw_degrees, pitch_degrees, ..self.session.work_eye }))
    }

    pub(super) fn look_from_node(&mut self, node: Option<RbtIndex>) -> CommandResult {
        let meant = self.meant(node)?;
        let rbt = meant[meant.len() - 1];
        let world_from_node = self.scene().world_from_rbt(&self.displayed_pose(), self.seconds(), rbt);
        self.look_from(Some(WorkEye::at(world_from_node, self.session.work_eye.distance)))?;
        Ok(Some(texts::view_work_eye_at(self.scene().rbt_path(rbt))))
    }

    pub(super) fn level(&mut self) -> CommandResult {
        self.look_from(Some(WorkEye { pitch_degrees: 0.0, ..self.session.work_eye }))
    }

    pub(super) fn show_all(&mut self) -> CommandResult {
        self.look_from(self.showing(self.session.work_eye, false))
    }

    pub(super) fn show_chosen(&mut self) -> CommandResult {
        if self.session.chosen.is_empty() {
            return Err(self.nothing_chosen());
        }
        self.look_from(self.showing(self.session.work_eye, true))
    }

    pub(super) fn reset_work_eye(&mut self) -> CommandResult {
        self.look_from(Some(self.first_work_eye()))
    }

    /// Where the work eye stands at first: everything is in sight.
    pub(super) fn first_work_eye(&self) -> WorkEye {
        self.showing(WorkEye::default(), false).unwrap_or_default()
    }

    /// An eye with the angles of another, so near that all shapes but planes are just in sight, and the arcballs of their nodes; of the
    /// chosen nodes and what hangs below them only, if wanted. `None` where there are none.
    fn showing(&self, eye: WorkEye, only_chosen: bool) -> Option<WorkEye> {
        let scene = self.scene();
        let world_from_node = scene.world_from_nodes(&self.displayed_pose(), self.seconds());
        let rotation = eye.rotation();
        let eye_from_world = rotation.inverse();
        let (mut corners, mut origins) = (Vec::new(), Vec::new());
        for (id, node) in scene.nodes_with_ids() {
            let NodeKind::Shape(placed) = &node.kind else { continue };
            let rbt = scene.carrying_rbt(id);
            let is_of = |rbt| self.session.chosen.iter().any(|&chosen| chosen == rbt || scene.is_above(chosen, rbt));
            let is_wanted = !only_chosen || rbt.is_some_and(is_of);
            if placed.shape.is_ground() || !is_wanted {
                continue;
            }
            let (world_from_shape, half_extents) = scene.box_of(id, placed, |id| world_from_node[id.get()].get());
            corners.extend((0..8_u8).map(|corner| {
                let sign = |bit: u8| if corner >> bit & 1 == 0 { 1.0 } else { -1.0 };
                let corner = half_extents * Vec3::new(sign(0), sign(1), sign(2));
                eye_from_world * world_from_shape.transform_point3(corner)
            }));
            origins.extend(
                rbt.map(|rbt| {
                    eye_from_world * Vec3::from(world_from_node[scene.rbt_node(rbt).get()].get().translation)
                }),
            );
        }
        let low = corners.iter().copied().reduce(Vec3::min)?;
        let high = corners.iter().copied().reduce(Vec3::max)?;
        let centre = (low + high) * 0.5;
        let half_height = (scene.vertical_fov() * 0.5).tan();
        // How far the eye must be from the plane through the centre to see a point at most at this part of the way to the view's sides.
        let distance = |point: &Vec3, x: f32, y: f32| {
            let Vec3 { x: right, y: up, z: towards } = (*point - centre) * MARGIN;
            towards + (right.abs() / (half_height * x)).max(up.abs() / (half_height * y))
        };
        let of_corners = corners.iter().map(|point| distance(point, ASPECT, 1.0));
        let ball = 2.0 * ARCBALL_RADIUS;
        let of_origins = origins.iter().map(|point| distance(point, ASPECT - ball, 1.0 - ball));
        let distance = of_corners.chain(of_origins).fold(0.0, f32::max);
        WorkEye { distance, target_in_world: rotation * centre, ..eye }.in_range()
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;
    use std::sync::Arc;

    use glam::Vec2;

    use crate::editor::Editor;
    use crate::scene::{DEFAULT_SCENE, built_in_scene};

    #[test]
    fn a_chosen_robot_is_in_sight_with_its_limbs() {
        let size_px = Vec2::new(800.0, 600.0);
        let mut editor = Editor::new(Arc::new(built_in_scene(DEFAULT_SCENE).unwrap()), PathBuf::from("a.json"));
        editor.session.chosen = editor.scene().find_rbt("robot2").into();
        editor.show_chosen().unwrap();
        let camera = editor.camera(size_px);
        for end in [glam::Vec3::new(2.4, -2.0, 0.0), glam::Vec3::new(3.9, 1.75, 0.0), glam::Vec3::new(0.1, 1.75, 0.0)] {
            let (seen_px, _) = camera.project(end).unwrap();
            assert!(seen_px.min_element() > 0.0 && seen_px.cmplt(size_px).all(), "{end}: {seen_px}");
        }
        assert!(editor.session.work_eye.distance < 0.8 * editor.first_work_eye().distance);
    }

    #[test]
    fn at_first_both_robots_and_the_arcball_of_every_part_are_in_sight() {
        let size_px = Vec2::new(800.0, 600.0);
        let mut editor = Editor::new(Arc::new(built_in_scene(DEFAULT_SCENE).unwrap()), PathBuf::from("a.json"));
        editor.set_eye(super::Eye::Work).unwrap();
        let camera = editor.camera(size_px);
        let scene = Arc::clone(editor.scene());
        for rbt in scene.rbt_indices().filter(|&rbt| scene.rbt_path(rbt).starts_with("robot")) {
            editor.session.chosen = Some(rbt).into();
            let ball = editor.manipulation(&camera).arcball.unwrap();
            let (low, high) = (ball.centre_px - ball.radius_px, ball.centre_px + ball.radius_px);
            assert!(low.min_element() >= 0.0 && high.cmple(size_px).all(), "{}: {ball:?}", scene.rbt_path(rbt));
        }
        for foot_or_head in [glam::Vec3::new(2.4, -2.0, 0.0), glam::Vec3::new(-2.0, 2.3, 0.0)] {
            let (seen_px, _) = camera.project(foot_or_head).unwrap();
            assert!(seen_px.min_element() > 0.0 && seen_px.cmplt(size_px).all(), "{seen_px}");
        }
    }
}
