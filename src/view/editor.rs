//! The frame of an editor's state.

use glam::Vec2;

use super::comparison::{add_compared, add_comparison};
use super::frustum::add_eyes;
use super::ghosts::{Neighbours, add_ghosts};
use super::gizmo::add_gizmo;
use super::motion_path::add_path;
use super::scene::{frame_of_scene, outline};
use crate::camera::Camera;
use crate::editor::Editor;
use crate::frame::{ArcballMark, Frame};
use crate::pose::{Pose, RbtIndex};

/// The picture that an editor displays, `size_px` pixels wide and high, with the chosen nodes outlined and the arcball.
#[must_use]
pub fn frame_of_editor(editor: &Editor, size_px: Vec2) -> Frame {
    frame_of_displayed(editor, &editor.displayed_pose(), &editor.camera(size_px))
}

/// What a screenshot of an editor shows: with overlays what [`frame_of_editor`] does, without them the scene alone, as exports have it.
#[must_use]
pub fn picture_of_editor(editor: &Editor, size_px: Vec2, has_overlays: bool) -> Frame {
    if has_overlays {
        return frame_of_editor(editor, size_px);
    }
    let camera = editor.camera(size_px);
    frame_of_scene(editor.scene(), &editor.displayed_pose(), editor.seconds(), &camera, editor.eye())
}

/// What the recorded camera sees ([`Editor::recorded_eye`]) with the displayed pose: the scene alone.
#[must_use]
pub fn frame_of_recorded_eye(editor: &Editor, pose: &Pose, size_px: Vec2) -> Frame {
    let (scene, seconds, (_, eye)) = (editor.scene(), editor.seconds(), editor.recorded_eye());
    let world_from_eye = scene.world_from_rbt(pose, seconds, eye);
    let camera = Camera { world_from_eye, vertical_fov: scene.vertical_fov(), size_px };
    frame_of_scene(scene, pose, seconds, &camera, Some(eye))
}

/// Like [`frame_of_editor`], if the caller already has the displayed pose ([`Editor::displayed_pose`]), with any camera.
#[must_use]
pub fn frame_of_displayed(editor: &Editor, pose: &Pose, camera: &Camera) -> Frame {
    let session = editor.session();
    let mut frame = frame_of_scene(editor.scene(), pose, editor.seconds(), camera, editor.eye());
    outline(&mut frame, editor.scene(), &session.chosen);
    if let Some(gizmo) = editor.gizmo(camera).filter(|_| editor.shows_gizmo()) {
        add_gizmo(&mut frame, editor, &gizmo);
    } else if session.shows_arcball && !editor.is_playing() {
        frame.arcball = editor
            .manipulation(camera)
            .arcball_in_world
            .map(|(centre_in_world, radius)| ArcballMark { centre_in_world, radius });
    }
    add_eyes(&mut frame, editor, pose);
    if session.shows_motion_path {
        add_path(&mut frame, editor);
    }
    let keyframes = &editor.document().keyframes;
    if let Some(current) = keyframes.current().filter(|_| !editor.is_playing()) {
        let only: &[RbtIndex] = if session.ghosts_of_chosen { &session.chosen } else { &[] };
        let neighbours = Neighbours { keyframes, from: [current.get(); 2], count: session.ghosts, only };
        add_ghosts(&mut frame, editor.scene(), editor.seconds(), neighbours);
    }
    add_comparison(&mut frame, editor);
    add_compared(&mut frame, editor);
    frame
}
