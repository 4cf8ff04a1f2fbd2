//! What a camera sees at a moment.

use glam::{Mat3, Quat, Vec2, Vec3};

use super::{ExportError, Moment, Shown, Source};
use crate::camera::Camera;
use crate::frame::{DrawItem, Frame, Ghost};
use crate::keyframe::{KeyframeIndex, PlayRange};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::scene::{Colour, MeshKind, SceneGraph};
use crate::words::texts;

/// How far the turntable's camera looks down, in degrees.
const TURNTABLE_DOWN: f32 = 12.0;
/// Ghosts of keyframes before and after.
const BEFORE: &str = "#e08a4b";
const AFTER: &str = "#4ba3d9";
/// Opacity of the nearest ghost.
const GHOST_OPACITY: f32 = 0.42;

/// Where it is seen from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// One of the scene's eyes.
    Eye(RbtIndex),
    /// A camera that goes around the world's centre.
    Turntable,
}

impl View {
    /// The view of that name; the scene's first eye where none is named.
    ///
    /// # Errors
    /// [`ExportError::BadInput`]: there is no such eye.
    pub fn named(name: Option<&str>, scene: &SceneGraph) -> Result<Self, ExportError> {
        let Some(name) = name else { return Ok(Self::Eye(scene.eyes()[0])) };
        if let Some(&eye) = scene.eyes().iter().find(|&&eye| scene.rbt_path(eye) == name) {
            return Ok(Self::Eye(eye));
        }
        if name == "turntable" {
            return Ok(Self::Turntable);
        }
        let eyes: Vec<&str> = scene.eyes().iter().map(|&eye| scene.rbt_path(eye)).collect();
        Err(ExportError::bad_input(texts::export_camera(name), texts::export_eyes(eyes.join(", "))))
    }
}

/// A scene with its animation and a camera.
pub struct Stage<'a> {
    source: Source<'a>,
    view: View,
    ghosts: u8,
    size_px: Vec2,
    /// How far the turntable's camera is from the world's centre, in scene units.
    distance: f32,
}

impl<'a> Stage<'a> {
    /// A stage for pictures of a size, with the ghosts of so many keyframes before and after.
    #[must_use]
    pub fn new(source: Source<'a>, view: View, ghosts: u8, size_px: Vec2) -> Self {
        let mut stage = Self { source, view, ghosts, size_px, distance: 1.0 };
        if view == View::Turntable {
            stage.distance = stage.fitting_distance();
        }
        stage
    }

    /// The picture at a moment.
    ///
    /// # Errors
    /// [`ExportError::BadInput`]: the moment is not there.
    pub fn frame(&self, moment: &Moment) -> Result<Frame, ExportError> {
        let pose = self.pose(moment.shown)?;
        let camera = self.camera(&pose, moment);
        let mut frame = Frame::new(self.source.scene, &pose, moment.seconds, &camera, None);
        if self.ghosts > 0 {
            self.add_ghosts(&mut frame, moment, &camera);
        }
        Ok(frame)
    }

    fn pose(&self, shown: Shown) -> Result<Pose, ExportError> {
        let (Some(animation), scene) = (self.source.animation, self.source.scene) else {
            return Ok(self.source.scene.rest_pose().clone());
        };
        match shown {
            Shown::Rest => Ok(scene.rest_pose().clone()),
            Shown::Keyframe(index) => {
                let keyframe = animation.keyframes.get(index);
                keyframe
                    .map(|keyframe| keyframe.pose.clone())
                    .ok_or_else(|| self.source.bad_input(texts::EXPORT_LOST_KEYFRAME))
            }
            Shown::KeyTime(key_time) => PlayRange::new(&animation.keyframes)
                .and_then(|range| range.pose_at(key_time, animation.interpolation))
                .map_err(|error| self.source.bad_input(error.message())),
        }
    }

    fn camera(&self, pose: &Pose, moment: &Moment) -> Camera {
        let scene = self.source.scene;
        let world_from_eye = match self.view {
            View::Eye(eye) => scene.world_from_rbt(pose, moment.seconds, eye),
            View::Turntable => self.world_from_turntable(moment.turn),
        };
        Camera { world_from_eye, vertical_fov: scene.vertical_fov(), size_px: self.size_px }
    }

    fn world_from_turntable(&self, turn: f64) -> Rbt {
        #[expect(clippy::cast_possible_truncation, reason = "an angle needs no more than f32")]
        let around = (turn * std::f64::consts::TAU) as f32;
        let rotation = Quat::from_rotation_y(around) * Quat::from_rotation_x(-TURNTABLE_DOWN.to_radians());
        Rbt::new(rotation * Vec3::new(0.0, 0.0, self.distance), rotation)
    }

    /// The distance from which every shape but planes is in view, however the camera stands.
    fn fitting_distance(&self) -> f32 {
        let scene = self.source.scene;
        let pose = self.source.shown(None, None).and_then(|shown| self.pose(shown));
        let pose = pose.unwrap_or_else(|_| scene.rest_pose().clone());
        let camera =
            Camera { world_from_eye: Rbt::IDENTITY, vertical_fov: scene.vertical_fov(), size_px: self.size_px };
        let frame = Frame::new(scene, &pose, 0.0, &camera, None);
        let reach = |item: &DrawItem| {
            let matrix = Mat3::from(item.world_from_shape.matrix3);
            let radius = (0..8_u8)
                .map(|corner| {
                    let sign = |bit: u8| if corner >> bit & 1 == 0 { 1.0 } else { -1.0 };
                    (matrix * (item.half_extents * Vec3::new(sign(0), sign(1), sign(2)))).length()
                })
                .fold(0.0, f32::max);
            item.world_from_shape.translation.length() + radius
        };
        let farthest = frame.items.iter().filter(|item| item.mesh != MeshKind::Plane).map(reach).fold(0.5, f32::max);
        let half_height = (scene.vertical_fov() * 0.5).tan();
        let half_angle = (half_height * (self.size_px.x / self.size_px.y).min(1.0)).atan();
        farthest / half_angle.sin()
    }

    /// What moves, as it is in the keyframes around.
    fn add_ghosts(&self, frame: &mut Frame, moment: &Moment, camera: &Camera) {
        let (Some(animation), scene) = (self.source.animation, self.source.scene) else { return };
        let last = animation.keyframes.len().saturating_sub(1);
        // Where it is in the list; only played keyframes are shown.
        let here = match moment.shown {
            Shown::Rest => return,
            #[expect(clippy::cast_precision_loss, reason = "no list has 2^52 keyframes")]
            Shown::Keyframe(index) => index.get() as f64,
            Shown::KeyTime(key_time) => key_time + 1.0,
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it lies in the list")]
        let (before, after) = (here.ceil() as usize, here.floor() as usize);
        for step in (1..=usize::from(self.ghosts)).rev() {
            let opacity = GHOST_OPACITY * (1.0 - 0.6 * fraction(step - 1, self.ghosts));
            let places = [(before.checked_sub(step), BEFORE), (Some(after + step), AFTER)];
            for (place, tint) in places {
                let Some(place) = place.filter(|&place| place > 0 && place < last) else { continue };
                let Some(keyframe) = animation.keyframes.get(KeyframeIndex::new(place)) else { continue };
                let other = Frame::new(scene, &keyframe.pose, moment.seconds, camera, None);
                let tint = Colour::from_hex(tint).expect("the tints are of the form #rrggbb").to_linear();
                let moved = other.items.into_iter().zip(&frame.items).filter(|(ghost, item)| {
                    item.mesh != MeshKind::Plane && !ghost.world_from_shape.abs_diff_eq(item.world_from_shape, 1e-5)
                });
                let ghosts: Vec<Ghost> =
                    moved.map(|(item, _)| Ghost { item: DrawItem { colour: tint, ..item }, opacity }).collect();
                frame.ghosts.extend(ghosts);
            }
        }
    }
}

fn fraction(step: usize, of: u8) -> f32 {
    f32::from(u8::try_from(step).unwrap_or(u8::MAX)) / f32::from(of)
}
