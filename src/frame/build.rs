//! From a scene, a pose and a camera to a [`Frame`].

use glam::{Affine3A, Vec2};

use super::{ArcballMark, DrawItem, Frame, View, overlays};
use crate::camera::Camera;
use crate::editor::{Editor, PathDot};
use crate::pose::{Pose, RbtIndex};
use crate::scene::{NodeKind, PlacedShape, SceneGraph};

impl View {
    /// The matrices of a camera.
    #[must_use]
    pub fn new(camera: &Camera) -> Self {
        Self {
            eye_from_world: camera.eye_from_world(),
            world_from_eye: camera.world_from_eye.to_affine(),
            clip_from_eye: camera.clip_from_eye(),
            vertical_fov: camera.vertical_fov,
            aspect: camera.size_px.x / camera.size_px.y,
        }
    }
}

impl Frame {
    /// The picture of a scene under a pose, `seconds` into the keys at their own times, with the shapes of `chosen` outlined.
    #[must_use]
    pub fn new(scene: &SceneGraph, pose: &Pose, seconds: f64, camera: &Camera, chosen: Option<RbtIndex>) -> Self {
        let world_from_node = scene.world_from_nodes(pose, seconds);
        let items = scene
            .nodes_with_ids()
            .filter_map(|(id, node)| {
                let NodeKind::Shape(placed) = &node.kind else { return None };
                let outlined = chosen.is_some() && scene.carrying_rbt(id) == chosen;
                Some(draw_item(placed, world_from_node[id.get()].get(), seconds, id.get(), outlined))
            })
            .collect();
        Self { view: View::new(camera), items, ghosts: Vec::new(), lines: Vec::new(), dots: Vec::new(), arcball: None }
    }

    /// Outlines the shapes of a node too, as where a click would choose it. `scene` is the one that the picture was made of.
    pub fn outline(&mut self, scene: &SceneGraph, rbt: RbtIndex) {
        let shapes = scene.nodes_with_ids().filter(|(_, node)| matches!(node.kind, NodeKind::Shape(_)));
        for (item, (id, _)) in self.items.iter_mut().zip(shapes) {
            item.outlined |= scene.carrying_rbt(id) == Some(rbt);
        }
    }

    /// Marks a dot of the motion path, as where a press would take it.
    pub fn mark_dot(&mut self, dot: PathDot) {
        overlays::add_mark(self, dot);
    }

    /// Makes lines and dots wider by a factor: what they are in points becomes pixels of a dense screen.
    pub fn scale_strokes(&mut self, factor: f32) {
        for line in &mut self.lines {
            line.width_px *= factor;
        }
        for dot in &mut self.dots {
            dot.diameter_px *= factor;
        }
    }

    /// The picture that an editor displays, `size_px` pixels wide and high, with the chosen node outlined and the arcball.
    #[must_use]
    pub fn of_editor(editor: &Editor, size_px: Vec2) -> Self {
        Self::of_displayed(editor, &editor.displayed_pose(), size_px)
    }

    /// As [`Frame::of_editor`], of the pose that the editor displays, [`Editor::displayed_pose`].
    #[must_use]
    pub fn of_displayed(editor: &Editor, pose: &Pose, size_px: Vec2) -> Self {
        let camera = editor.camera(size_px);
        let session = editor.session();
        let mut frame = Self::new(editor.scene(), pose, editor.seconds(), &camera, session.chosen);
        if session.shows_arcball && !editor.is_playing() {
            frame.arcball = editor
                .manipulation(&camera)
                .arcball_in_world
                .map(|(centre_in_world, radius)| ArcballMark { centre_in_world, radius });
        }
        if session.shows_path {
            overlays::add_path(&mut frame, editor);
        }
        overlays::add_ghosts(&mut frame, editor);
        if session.compares {
            overlays::add_comparison(&mut frame, editor);
        }
        frame
    }
}

pub(super) fn draw_item(
    placed: &PlacedShape,
    world_from_shape: Affine3A,
    seconds: f64,
    place: usize,
    outlined: bool,
) -> DrawItem {
    DrawItem {
        mesh: placed.shape.mesh(),
        world_from_shape,
        half_extents: placed.shape.half_extents(),
        rounding: placed.shape.rounding(),
        colour: placed.colour_at(seconds),
        node: u32::try_from(place).expect("a scene has fewer than 2^32 nodes"),
        outlined,
    }
}
