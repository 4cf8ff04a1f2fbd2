//! Idle work of the window: thumbnails of visible keyframes, one at a time.

use std::time::Duration;

use glam::Vec2;
use web_time::Instant;

use super::now;
use super::shell::Shell;
use crate::camera::Camera;
use crate::editor::Editor;
use crate::frame::Frame;
use crate::pose::Pose;
use crate::ui::THUMBNAIL_PX;
use crate::view::frame_of_scene;

/// The idle time before a thumbnail is made.
const REST: Duration = Duration::from_millis(40);

/// How long the window waits before it looks whether a picture is drawn.
pub(super) const LOOK: Duration = Duration::from_millis(2);

impl Shell {
    /// When the next picture is due: none while something moves, is held, or is not wanted.
    pub(super) fn plan_thumbnail(&mut self) {
        let is_busy = self.editor.is_playing() || self.editor.is_dragging() || self.hands.is_held();
        let is_wanted = !is_busy && self.ui.wanted_thumbnail().is_some();
        // While timed keys run, the window is never idle. A thumbnail that is due stays due.
        let kept = self.thumbnail_due.filter(|_| self.editor.wants_ticks());
        let is_begun = self.thumbnail_of.is_some();
        self.thumbnail_due = kept.or_else(|| now().checked_add(REST)).filter(|_| is_wanted || is_begun);
    }

    /// Starts a picture where one is due, and shows it once it is there.
    pub(super) fn make_thumbnail(&mut self, at: Instant) {
        if self.thumbnail_due.is_none_or(|due| due > at) {
            return;
        }
        self.thumbnail_due = None;
        let Some(stage) = &mut self.stage else { return };
        // Where it cannot be made, the window says so elsewhere: its own pictures come from the same device.
        if let Some(pose) = self.thumbnail_of.take() {
            match stage.thumbnail() {
                Ok(Some(picture)) => {
                    self.ui.put_thumbnail(&stage.context, pose, &picture.rgba);
                    self.request_redraw();
                }
                Ok(None) => {
                    self.thumbnail_of = Some(pose);
                    self.thumbnail_due = at.checked_add(LOOK);
                }
                Err(_) => {}
            }
        } else if let Some(pose) = self.ui.wanted_thumbnail().cloned()
            && stage.begin_thumbnail(&thumbnail_frame(&self.editor, &pose)).is_ok()
        {
            self.thumbnail_of = Some(pose);
            self.thumbnail_due = at.checked_add(LOOK);
        }
    }
}

/// The picture of a keyframe's pose, from the scene's first eye, with nothing over it.
fn thumbnail_frame(editor: &Editor, pose: &Pose) -> Frame {
    let scene = editor.scene();
    let [width, height] = THUMBNAIL_PX;
    #[expect(clippy::cast_precision_loss, reason = "it is a small picture")]
    let camera = Camera {
        world_from_eye: scene.world_from_rbt(pose, 0.0, scene.eyes()[0]),
        vertical_fov: scene.vertical_fov(),
        size_px: Vec2::new(width as f32, height as f32),
    };
    frame_of_scene(scene, pose, 0.0, &camera, Some(scene.eyes()[0]))
}
