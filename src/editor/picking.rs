//! Which node the pointer is at.

use glam::Vec2;

use super::{Command, Editor, Eye, KeyAt, SelectionCommand};
use crate::camera::Camera;
use crate::pose::RbtIndex;
use crate::scene::{Channel, NodeId, NodeKind, Part, Pick};

/// How far from a part a click may miss it, in points.
pub const CLICK_REACH: f32 = 8.0;
/// Rings of rays around a pixel that meets no part, nearest first, and rays on each.
const RINGS: u8 = 4;
const RAYS_ON_RING: u8 = 12;

impl Editor {
    /// The scene's eyes that are not looked from and have no shape of their own or below them. They show as wires.
    pub fn bare_eyes(&self) -> impl Iterator<Item = RbtIndex> {
        let scene = self.scene();
        let is_bare = |rbt| {
            let nodes = &scene.nodes()[scene.subtree(scene.rbt_node(rbt))];
            nodes.iter().all(|node| !matches!(node.kind, NodeKind::Shape(_)))
        };
        scene.eyes().iter().copied().filter(move |&rbt| Some(rbt) != self.eye() && is_bare(rbt))
    }

    /// The bare eye whose tip is at most `reach_px` from a pixel, and its depth: the nearest one.
    fn bare_eye_near(&self, camera: &Camera, at_px: Vec2, reach_px: f32) -> Option<(RbtIndex, f32)> {
        let pose = self.displayed_pose();
        let seen = self.bare_eyes().filter_map(|rbt| {
            let world_from_eye = self.scene().world_from_rbt(&pose, self.seconds(), rbt);
            let (seen_px, depth) = camera.project(world_from_eye.translation)?;
            (seen_px.distance(at_px) <= reach_px).then_some((rbt, depth))
        });
        seen.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The node that poses record whose part is nearest to a pixel, at most `reach_px` away: what a click there chooses. The ground is no
    /// part; the tip of an eye's wires is one.
    #[must_use]
    pub fn part_near(&self, camera: &Camera, at_px: Vec2, reach_px: f32) -> Option<RbtIndex> {
        self.taken_near(camera, at_px, reach_px)?.rbt()
    }

    /// What a click at a pixel takes: the nearest part, at most `reach_px` away.
    #[must_use]
    pub fn taken_near(&self, camera: &Camera, at_px: Vec2, reach_px: f32) -> Option<Part> {
        let picker = self.scene().picker(&self.displayed_pose(), self.seconds(), self.eye());
        // Distances of rays through pixels are depths.
        let direct = picker.nearest(camera.ray_through(at_px)).map(|hit| hit.distance);
        if let Some((eye, depth)) = self.bare_eye_near(camera, at_px, reach_px)
            && direct.is_none_or(|hit| hit > depth)
        {
            return Some(Part::Rbt(eye));
        }
        let rings = (1..=RINGS).flat_map(|ring| {
            let radius = reach_px * f32::from(ring) / f32::from(RINGS);
            (0..RAYS_ON_RING).map(move |ray| {
                let angle = std::f32::consts::TAU * f32::from(ray) / f32::from(RAYS_ON_RING);
                Vec2::from_angle(angle) * radius
            })
        });
        std::iter::once(Vec2::ZERO)
            .chain(rings)
            .find_map(|by| self.part_of(picker.nearest(camera.ray_through(at_px + by))?))
    }

    fn part_of(&self, hit: Pick) -> Option<Part> {
        match hit.rbt {
            Some(rbt) => Some(Part::Rbt(rbt)),
            None if hit.is_ground => None,
            None => self.keyed_node(hit.shape).map(Part::Keyed),
        }
    }

    /// The nearest node, this one or one above it, that has keys at their own times.
    fn keyed_node(&self, id: NodeId) -> Option<NodeId> {
        let scene = self.scene();
        let has_keys =
            |id: &NodeId| Channel::ALL.into_iter().any(|channel| !scene.key_seconds(*id, channel).is_empty());
        std::iter::successors(Some(id), |&id| scene.node(id).parent).find(has_keys)
    }

    /// What a click on a node does that no choice can move: selects its keys, or those of the nearest node above it that has any.
    #[must_use]
    pub fn selecting_keys_of(&self, id: NodeId) -> Command {
        let scene = self.scene();
        let keys = self.keyed_node(id).map_or_else(Vec::new, |id| {
            let path = &scene.node(id).path;
            let of = |channel| scene.key_seconds(id, channel).iter().map(move |&at| KeyAt::new(path, channel, at));
            Channel::ALL.into_iter().flat_map(of).collect()
        });
        Command::Selection(SelectionCommand::TimedKeys(keys))
    }

    /// The node after the primary one, among those whose parts lie behind each other at a pixel, and the nearest after the farthest.
    /// What Ctrl+click chooses.
    #[must_use]
    pub fn part_behind(&self, camera: &Camera, at_px: Vec2, reach_px: f32) -> Option<RbtIndex> {
        let picker = self.scene().picker(&self.displayed_pose(), self.seconds(), self.eye());
        let behind = picker.nodes_along(camera.ray_through(at_px));
        let place = behind.iter().position(|&rbt| Some(rbt) == self.session().chosen.primary());
        match place {
            Some(place) => Some(behind[(place + 1) % behind.len()]),
            None => behind.first().copied().or_else(|| self.part_near(camera, at_px, reach_px)),
        }
    }

    /// Whether a pixel is inside of the arcball of the chosen nodes, while that shows.
    #[must_use]
    pub fn is_in_arcball(&self, camera: &Camera, at_px: Vec2) -> bool {
        let session = self.session();
        let shows = session.shows_arcball && !session.chosen.is_empty() && !self.is_playing();
        let arcball = shows.then(|| self.manipulation(camera).arcball).flatten();
        arcball.is_some_and(|ball| ball.centre_px.distance(at_px) < ball.radius_px)
    }

    /// Whether one looks from the work eye.
    #[must_use]
    pub fn is_work_eye(&self) -> bool {
        self.session().eye == Eye::Work
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;
    use std::sync::Arc;

    use super::*;
    use crate::editor::{Command, ViewCommand};
    use crate::scene::{DEFAULT_SCENE, built_in_scene};

    const SIZE: Vec2 = Vec2::new(800.0, 600.0);

    fn looking_from(eye: Eye) -> Editor {
        let scene = Arc::new(built_in_scene(DEFAULT_SCENE).unwrap());
        let mut editor = Editor::new(scene, PathBuf::from("a.json"));
        editor.apply(Command::View(ViewCommand::SetEye(eye))).unwrap();
        editor
    }

    fn seen_px(editor: &Editor, path: &str) -> Vec2 {
        let rbt = editor.scene().find_rbt(path).unwrap();
        let world_from_rbt = editor.scene().world_from_rbt(&editor.displayed_pose(), 0.0, rbt);
        editor.camera(SIZE).project(world_from_rbt.translation).unwrap().0
    }

    fn near(editor: &Editor, at_px: Vec2) -> Option<&str> {
        editor.part_near(&editor.camera(SIZE), at_px, 8.0).map(|rbt| editor.scene().rbt_path(rbt))
    }

    #[test]
    fn a_near_miss_meets_the_part_and_a_far_one_nothing() {
        let editor = looking_from(Eye::Work);
        let knee = seen_px(&editor, "robot1/left_hip/left_knee");
        let camera = editor.camera(SIZE);
        let is_met = |x: f32| camera_meets(&editor, &camera, knee - Vec2::X * x);
        let edge = (0_u8..100).map(f32::from).find(|&x| !is_met(x)).unwrap();
        assert!(near(&editor, knee - Vec2::X * (edge + 5.0)).is_some());
        assert_eq!(near(&editor, knee - Vec2::X * (edge + 12.0)), None);
    }

    fn camera_meets(editor: &Editor, camera: &Camera, at_px: Vec2) -> bool {
        let picker = editor.scene().picker(&editor.displayed_pose(), 0.0, editor.eye());
        picker.nearest(camera.ray_through(at_px)).is_some_and(|hit| hit.rbt.is_some())
    }

    #[test]
    fn the_recorded_camera_can_be_chosen_by_its_wires_unless_one_looks_from_it() {
        let editor = looking_from(Eye::Work);
        assert_eq!(near(&editor, seen_px(&editor, "sky") + Vec2::X), Some("sky"));
        assert_eq!(looking_from(Eye::Recorded(0)).bare_eyes().count(), 0);
    }

    #[test]
    fn going_on_meets_what_lies_behind_and_begins_again() {
        let mut editor = looking_from(Eye::Work);
        editor.apply(Command::View(ViewCommand::LookFrom(crate::editor::Side::Right))).unwrap();
        let at_px = seen_px(&editor, "robot2");
        let camera = editor.camera(SIZE);
        let mut chosen = Vec::new();
        for _ in 0..12 {
            let next = editor.part_behind(&camera, at_px, 8.0);
            chosen.push(editor.scene().rbt_path(next.unwrap()).to_owned());
            editor.apply(Command::View(ViewCommand::Choose(next))).unwrap();
        }
        assert!(chosen.contains(&"robot1".to_owned()) && chosen.contains(&"robot2".to_owned()), "{chosen:?}");
        let round = chosen.iter().skip(1).position(|path| *path == chosen[0]).unwrap() + 1;
        assert!((0..chosen.len() - round).all(|index| chosen[index] == chosen[index + round]), "{chosen:?}");
    }
}
