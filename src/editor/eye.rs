//! What the scene is looked at from: an eye of the scene, which keyframes record, or the work eye, which nothing records.

use glam::{Quat, Vec2, Vec3};

use super::apply::CommandResult;
use super::{Command, CommandError, Editor, ViewCommand};
use crate::camera::Camera;
use crate::pose::{Pose, RbtIndex};
use crate::rbt::{LARGEST_COORDINATE, Rbt};
use crate::words::texts;

/// How much nearer one notch of the wheel brings the work eye.
const ZOOM_STEP: f32 = 1.15;
/// A direction whose horizontal part is shorter than this is vertical.
const STEEP: f32 = 1e-6;

/// What one looks from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Eye {
    /// The work eye: no node, and in no keyframe.
    Work,
    /// The node with this index in [`crate::scene::SceneGraph::eyes`].
    Recorded(usize),
}

impl Eye {
    /// The index of an eye of the scene; `None` for the work eye.
    #[must_use]
    pub const fn recorded(self) -> Option<usize> {
        match self {
            Self::Work => None,
            Self::Recorded(index) => Some(index),
        }
    }
}

/// Where the work eye stands: on a sphere around a target that it looks at, with the horizon level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkEye {
    /// How far it has gone around the vertical axis, in degrees from -180 to 180: at 0 it stands on the target's +Z side, at 90 on +X.
    pub yaw_degrees: f32,
    /// How high it stands, in degrees from -90 to 90: at 90 it looks straight down.
    pub pitch_degrees: f32,
    /// Distance from the target, in scene units within [`WorkEye::DISTANCES`].
    pub distance: f32,
    /// What it looks at, in world space.
    pub target_in_world: Vec3,
}

impl WorkEye {
    /// Distances that it can have from its target, in scene units.
    pub const DISTANCES: std::ops::RangeInclusive<f32> = 0.125..=1e5;

    /// At the origin of a frame, looking along its −Z with the horizon level, at what is so far away.
    #[must_use]
    pub fn at(world_from_frame: Rbt, distance: f32) -> Self {
        let (back, up) = (world_from_frame.transform_vector(Vec3::Z), world_from_frame.transform_vector(Vec3::Y));
        // Straight up or down, the frame's Y axis says what is at the top of the view.
        let around = if back.x.hypot(back.z) < STEEP { up * -back.y.signum() } else { back };
        Self {
            yaw_degrees: around.x.atan2(around.z).to_degrees(),
            pitch_degrees: back.y.atan2(back.x.hypot(back.z)).to_degrees(),
            distance,
            target_in_world: world_from_frame.translation - back * distance,
        }
    }

    /// World from eye space: −Z forward, Y up.
    #[must_use]
    pub fn world_from_eye(&self) -> Rbt {
        let rotation = self.rotation();
        Rbt::new(self.target_in_world + rotation * Vec3::new(0.0, 0.0, self.distance), rotation)
    }

    /// The turn from the world's axes to its own.
    #[must_use]
    pub fn rotation(&self) -> Quat {
        let (yaw, pitch) = (self.yaw_degrees.to_radians(), self.pitch_degrees.to_radians());
        Quat::from_rotation_y(yaw) * Quat::from_rotation_x(-pitch)
    }

    /// It with every number in its range; `None` where one is not finite.
    #[must_use]
    pub fn in_range(self) -> Option<Self> {
        let Self { yaw_degrees, pitch_degrees, distance, target_in_world } = self;
        let is_finite =
            yaw_degrees.is_finite() && pitch_degrees.is_finite() && distance.is_finite() && target_in_world.is_finite();
        // A yaw in range is kept bit for bit, so that lines read back equal.
        let is_wound = yaw_degrees.abs() > 180.0;
        is_finite.then(|| Self {
            yaw_degrees: if is_wound { (yaw_degrees + 180.0).rem_euclid(360.0) - 180.0 } else { yaw_degrees },
            pitch_degrees: pitch_degrees.clamp(-90.0, 90.0),
            distance: distance.clamp(*Self::DISTANCES.start(), *Self::DISTANCES.end()),
            target_in_world: target_in_world.clamp(Vec3::splat(-LARGEST_COORDINATE), Vec3::splat(LARGEST_COORDINATE)),
        })
    }

    /// It after a motion with respect to the frame at its target with its own axes. Turns go around the target, and what would tilt the
    /// horizon is left out. Of a translation, x and y move the target too; z changes the distance.
    #[must_use]
    pub fn moved(self, motion: Rbt) -> Self {
        let rotation = self.rotation();
        let back = rotation * motion.rotation * Vec3::Z;
        let has_turned = motion.rotation != Quat::IDENTITY;
        let is_steep = back.x.hypot(back.z) < STEEP;
        let Vec3 { x, y, z } = motion.translation;
        Self {
            yaw_degrees: if has_turned && !is_steep { back.x.atan2(back.z).to_degrees() } else { self.yaw_degrees },
            pitch_degrees: if has_turned { back.y.clamp(-1.0, 1.0).asin().to_degrees() } else { self.pitch_degrees },
            distance: self.distance + z,
            target_in_world: self.target_in_world + rotation * Vec3::new(x, y, 0.0),
        }
    }

    /// Where it is on the way to another, at a part of it from 0 to 1: around by the shorter way, and nearer or farther evenly.
    #[must_use]
    pub fn towards(self, to: Self, part: f32) -> Self {
        let around = (to.yaw_degrees - self.yaw_degrees + 180.0).rem_euclid(360.0) - 180.0;
        let eye = Self {
            yaw_degrees: self.yaw_degrees + around * part,
            pitch_degrees: self.pitch_degrees + (to.pitch_degrees - self.pitch_degrees) * part,
            distance: self.distance * (to.distance / self.distance).powf(part),
            target_in_world: self.target_in_world.lerp(to.target_in_world, part),
        };
        eye.in_range().unwrap_or(to)
    }

    /// It after a drag over the view: to the right by a positive x, downwards by a positive y. The scene follows the pointer; the smaller
    /// side of the view is half a turn.
    #[must_use]
    pub fn orbited(self, by_px: Vec2, camera: &Camera) -> Self {
        let degrees = by_px * (180.0 / camera.size_px.min_element());
        let eye =
            Self { yaw_degrees: self.yaw_degrees - degrees.x, pitch_degrees: self.pitch_degrees + degrees.y, ..self };
        eye.in_range().unwrap_or(self)
    }

    /// It after a drag over the view that takes the point under the pointer along, at the target's depth.
    #[must_use]
    pub fn panned(self, by_px: Vec2, camera: &Camera) -> Self {
        let by = by_px * camera.units_per_pixel_at_unit_depth() * self.distance;
        let target_in_world = self.target_in_world + self.rotation() * Vec3::new(-by.x, by.y, 0.0);
        Self { target_in_world, ..self }.in_range().unwrap_or(self)
    }

    /// It nearer by notches of the wheel, or farther. What is under the pixel, at the target's depth, stays there.
    #[must_use]
    pub fn zoomed(self, notches: f32, at_px: Vec2, camera: &Camera) -> Self {
        self.at_distance(self.distance * ZOOM_STEP.powf(-notches), at_px, camera)
    }

    /// It so many times as near. What is under the pixel, at the target's depth, stays there.
    #[must_use]
    pub fn zoomed_by(self, factor: f32, at_px: Vec2, camera: &Camera) -> Self {
        self.at_distance(self.distance / factor, at_px, camera)
    }

    fn at_distance(self, distance: f32, at_px: Vec2, camera: &Camera) -> Self {
        let Some(Self { distance, .. }) = (Self { distance, ..self }).in_range() else { return self };
        let from_centre = (at_px - camera.size_px * 0.5) * camera.units_per_pixel_at_unit_depth() * self.distance;
        let to_point = self.rotation() * Vec3::new(from_centre.x, -from_centre.y, 0.0);
        let target_in_world = self.target_in_world + to_point * (1.0 - distance / self.distance);
        Self { distance, target_in_world, ..self }.in_range().unwrap_or(self)
    }
}

impl Default for WorkEye {
    /// From the front, a little to the right and from above, at both robots of the built-in scene.
    fn default() -> Self {
        Self { yaw_degrees: 20.0, pitch_degrees: 12.0, distance: 8.0, target_in_world: Vec3::new(0.0, 0.2, 0.0) }
    }
}

impl Editor {
    /// The RBT node that is looked from; `None`: the work eye.
    #[must_use]
    pub fn eye(&self) -> Option<RbtIndex> {
        self.session.eye.recorded().map(|eye| self.scene().eyes()[eye])
    }

    /// The eye of the scene that is in force or was last, and its index.
    #[must_use]
    pub fn recorded_eye(&self) -> (usize, RbtIndex) {
        let eyes = self.scene().eyes();
        let index = self.session.recorded_eye;
        eyes.get(index).map_or((0, eyes[0]), |&eye| (index, eye))
    }

    /// World from eye space, with the scene in a pose.
    #[must_use]
    pub(super) fn world_from_eye(&self, pose: &Pose) -> Rbt {
        match self.eye() {
            Some(eye) => self.document.scene.world_from_rbt(pose, self.seconds(), eye),
            None => self.session.work_eye.world_from_eye(),
        }
    }

    /// The node whose frame a drag goes by: the primary of the chosen ones, or the eye; `None`: the work eye.
    #[must_use]
    pub fn dragged_node(&self) -> Option<RbtIndex> {
        self.session.chosen.primary().or_else(|| self.eye())
    }

    /// A command without what it depends on: `eye-next` as the eye that it leads to. What keeps a record writes this.
    #[must_use]
    pub fn meant_by(&self, command: Command) -> Command {
        match command {
            Command::View(ViewCommand::NextEye) => Command::View(ViewCommand::SetEye(self.next_eye())),
            command => command,
        }
    }

    /// The scene's eyes one after the other, and the work eye before the first where it was used.
    pub(super) fn next_eye(&self) -> Eye {
        let next = self.session.eye.recorded().map_or(0, |eye| eye + 1);
        let is_past_last = next >= self.scene().eyes().len();
        match (is_past_last, self.session.has_used_work_eye) {
            (false, _) => Eye::Recorded(next),
            (true, true) => Eye::Work,
            (true, false) => Eye::Recorded(0),
        }
    }

    pub(super) fn set_eye(&mut self, eye: Eye) -> CommandResult {
        let said = match eye {
            Eye::Work => texts::VIEW_LOOKS_FROM_WORK_EYE.into(),
            Eye::Recorded(index) => {
                let missing = CommandError::NotInScene { what: texts::VALUE_EYE };
                let rbt = *self.scene().eyes().get(index).ok_or(missing)?;
                texts::view_looks_from(self.scene().rbt_path(rbt))
            }
        };
        self.commit_gesture();
        self.session.eye = eye;
        self.session.recorded_eye = eye.recorded().unwrap_or(self.session.recorded_eye);
        self.session.has_used_work_eye |= eye == Eye::Work;
        Ok(Some(said))
    }

    pub(super) fn set_work_eye(&mut self, eye: WorkEye) -> CommandResult {
        self.session.work_eye = eye.in_range().ok_or(CommandError::NotAValue { what: texts::VALUE_POSITION })?;
        Ok(None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_stands_where_its_angles_say() {
        let eye = |yaw_degrees, pitch_degrees| {
            let target_in_world = Vec3::new(1.0, 2.0, 3.0);
            WorkEye { yaw_degrees, pitch_degrees, distance: 4.0, target_in_world }.world_from_eye()
        };
        for (yaw, pitch, expected, up) in [
            (0.0, 0.0, Vec3::new(1.0, 2.0, 7.0), Vec3::Y),
            (90.0, 0.0, Vec3::new(5.0, 2.0, 3.0), Vec3::Y),
            (0.0, 90.0, Vec3::new(1.0, 6.0, 3.0), Vec3::NEG_Z),
        ] {
            let world_from_eye = eye(yaw, pitch);
            assert!(world_from_eye.translation.abs_diff_eq(expected, 1e-5), "{world_from_eye:?}");
            assert!(world_from_eye.transform_vector(Vec3::Y).abs_diff_eq(up, 1e-5), "{world_from_eye:?}");
        }
    }

    #[test]
    fn at_a_frame_it_looks_along_its_minus_z_with_the_horizon_level() {
        let target_in_world = Vec3::new(1.0, 2.0, 3.0);
        for (yaw_degrees, pitch_degrees) in [(0.0, 0.0), (-120.0, 40.0), (30.0, 90.0), (-60.0, -90.0)] {
            let eye = WorkEye { yaw_degrees, pitch_degrees, distance: 4.0, target_in_world };
            let again = WorkEye::at(eye.world_from_eye(), 4.0);
            let (expected, found) = (eye.world_from_eye(), again.world_from_eye());
            assert!(found.translation.abs_diff_eq(expected.translation, 1e-5), "{again:?}");
            assert!(found.rotation.dot(expected.rotation).abs() > 0.99999, "{again:?} for {eye:?}");
        }
        let rolled = Rbt::new(Vec3::ONE, Quat::from_rotation_y(0.5) * Quat::from_rotation_z(1.0));
        let eye = WorkEye::at(rolled, 2.0);
        assert!((eye.yaw_degrees - 0.5_f32.to_degrees()).abs() < 1e-4 && eye.pitch_degrees.abs() < 1e-4, "{eye:?}");
        assert!(eye.world_from_eye().translation.abs_diff_eq(Vec3::ONE, 1e-5));
    }

    #[test]
    fn turns_keep_the_horizon_level_and_the_target() {
        let eye = WorkEye { yaw_degrees: 30.0, pitch_degrees: 20.0, ..WorkEye::default() };
        let turn = Rbt::from_rotation(Quat::from_rotation_y(0.7) * Quat::from_rotation_z(0.4));
        let moved = eye.moved(turn);
        assert!(moved.world_from_eye().transform_vector(Vec3::X).y.abs() < 1e-6);
        assert_eq!((moved.distance, moved.target_in_world), (eye.distance, eye.target_in_world));
        assert!((moved.yaw_degrees - eye.yaw_degrees).abs() > 20.0, "{moved:?}");
    }

    fn camera(eye: WorkEye) -> Camera {
        Camera { world_from_eye: eye.world_from_eye(), vertical_fov: 1.0, size_px: Vec2::new(640.0, 480.0) }
    }

    #[test]
    fn orbits_go_around_the_target_and_stop_at_the_poles() {
        let eye = WorkEye::default();
        let moved = eye.orbited(Vec2::new(48.0, 24.0), &camera(eye));
        assert_eq!((moved.yaw_degrees, moved.pitch_degrees), (eye.yaw_degrees - 18.0, eye.pitch_degrees + 9.0));
        assert_eq!(moved.orbited(Vec2::new(0.0, 1e4), &camera(eye)).pitch_degrees, 90.0);
        let (before, after) = (camera(eye).project(eye.target_in_world), camera(moved).project(eye.target_in_world));
        assert!(before.unwrap().0.distance(after.unwrap().0) < 1e-2);
    }

    #[test]
    fn the_point_under_the_pointer_stays_there_in_pans_and_zooms() {
        let eye = WorkEye { yaw_degrees: 50.0, pitch_degrees: 30.0, ..WorkEye::default() };
        let before = camera(eye);
        let at_px = Vec2::new(500.0, 100.0);
        let ray = before.ray_through(at_px);
        let point_in_world = ray.origin_in_world + ray.direction_in_world * eye.distance;
        let by_px = Vec2::new(-70.0, 30.0);
        let seen = |eye: WorkEye| camera(eye).project(point_in_world).unwrap().0;
        assert!(seen(eye.panned(by_px, &before)).distance(at_px + by_px) < 1e-2);
        for notches in [1.0, -2.5] {
            let zoomed = eye.zoomed(notches, at_px, &before);
            assert!(seen(zoomed).distance(at_px) < 1e-2 && (zoomed.distance < eye.distance) == (notches > 0.0));
        }
        assert_eq!(eye.zoomed(1e3, at_px, &before).distance, *WorkEye::DISTANCES.start());
    }

    #[test]
    fn numbers_out_of_range_are_moved_into_it() {
        let target_in_world = Vec3::new(2e6, 0.0, 0.0);
        let eye = WorkEye { yaw_degrees: 270.0, pitch_degrees: 100.0, distance: 0.0, target_in_world };
        let kept = eye.in_range().unwrap();
        assert_eq!((kept.yaw_degrees, kept.pitch_degrees, kept.distance), (-90.0, 90.0, 0.125));
        assert_eq!(kept.target_in_world.x, LARGEST_COORDINATE);
        assert_eq!(WorkEye { distance: f32::NAN, ..eye }.in_range(), None);
    }
}
