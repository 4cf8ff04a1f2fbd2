//! The frame that a camera sees at a moment.

use glam::{Mat3, Quat, Vec2, Vec3};

use num_rational::BigRational;
use num_traits::FromPrimitive as _;

use super::exposure::{Exposure, Focus, OpenTime};
use super::{ExportError, Moment, MomentPose, Source};
use crate::blend::AlignedAffine;
use crate::camera::Camera;
use crate::colour::Colour;
use crate::frame::{DrawItem, Frame, Lens};
use crate::interpolation::Interpolation;
use crate::keyframe::{Blend, PlayRange};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::scene::SceneGraph;
use crate::view::{Neighbours, add_compared_nodes, add_ghosts, add_strobe, frame_of_nodes, frame_of_scene};

/// The downward angle of the turntable's camera, in degrees.
const TURNTABLE_DOWN: f32 = 12.0;

/// The position of the camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Viewpoint {
    /// One of the scene's eyes.
    Eye(RbtIndex),
    /// A camera that circles the world's origin.
    Turntable,
}

impl Viewpoint {
    /// The node that is looked from; `None` for a camera that is no node.
    const fn node(self) -> Option<RbtIndex> {
        match self {
            Self::Eye(rbt) => Some(rbt),
            Self::Turntable => None,
        }
    }

    /// The viewpoint with a name; by default the scene's first eye.
    ///
    /// # Errors
    /// [`ExportError::NoCamera`]
    pub fn named(name: Option<&str>, scene: &SceneGraph) -> Result<Self, ExportError> {
        let Some(name) = name else { return Ok(Self::Eye(scene.eyes()[0])) };
        if let Some(&eye) = scene.eyes().iter().find(|&&eye| scene.rbt_path(eye) == name) {
            return Ok(Self::Eye(eye));
        }
        if name == "turntable" {
            return Ok(Self::Turntable);
        }
        let eyes = scene.eyes().iter().map(|&eye| scene.rbt_path(eye).to_owned()).collect();
        Err(ExportError::NoCamera { name: name.to_owned(), eyes })
    }
}

/// A scene with its animation and a camera.
pub struct Stage<'a> {
    source: Source<'a>,
    viewpoint: Viewpoint,
    ghosts: u8,
    size_px: Vec2,
    /// How far the turntable's camera is from the world's centre, in scene units.
    distance: f32,
    open: OpenTime,
    lens: Option<SharpAt>,
    /// Moments that every picture shows besides its own, the earliest first.
    strobe: &'a [Moment],
    /// The blend between keyframes; `None`: the animation's.
    blend: Option<Blend>,
    /// Other blends, shown as ghosts.
    compared: Vec<(Blend, Colour)>,
}

/// A lens and the node at which it is sharp.
#[derive(Clone, Copy, Debug)]
struct SharpAt {
    node: RbtIndex,
    radius: f32,
}

/// The nearest distance of what a lens makes sharp, in scene units.
const NEAREST_FOCUS: f32 = 0.05;

impl<'a> Stage<'a> {
    /// A stage for pictures of a size, with `ghosts` keyframes before and after as ghosts.
    #[must_use]
    pub fn new(source: Source<'a>, viewpoint: Viewpoint, ghosts: u8, size_px: Vec2) -> Self {
        let mut stage = Self {
            source,
            viewpoint,
            ghosts,
            size_px,
            distance: 1.0,
            open: OpenTime::default(),
            lens: None,
            strobe: &[],
            blend: None,
            compared: Vec::new(),
        };
        if viewpoint == Viewpoint::Turntable {
            stage.distance = stage.fitting_distance();
        }
        stage
    }

    /// Sets how its pictures are taken, in a film of `frames` at a rate.
    ///
    /// # Errors
    /// [`ExportError::NoFocus`]: the scene has no such node.
    pub fn expose(&mut self, exposure: &Exposure<'_>, fps: u32, frames: usize) -> Result<(), ExportError> {
        self.open = exposure.shutter.open_time(fps, frames);
        let scene = self.source.scene;
        let sharp_at = |focus: &Focus<'_>| -> Result<_, ExportError> {
            let node = scene.find_rbt(focus.node);
            let node = node.ok_or_else(|| ExportError::NoFocus { path: focus.node.to_owned() })?;
            Ok(SharpAt { node, radius: focus.radius(scene.vertical_fov()) })
        };
        self.lens = exposure.focus.as_ref().map(sharp_at).transpose()?;
        Ok(())
    }

    /// Sets the moments that every picture shows besides its own, the earliest first.
    pub const fn strobe(&mut self, earlier: &'a [Moment]) {
        self.strobe = earlier;
    }

    /// Sets the blend between keyframes in place of the animation's interpolation, for all but the camera.
    pub const fn blend(&mut self, blend: Blend) {
        self.blend = Some(blend);
    }

    /// Sets what other blends give as ghosts, each in its colour.
    pub fn compare(&mut self, others: Vec<(Blend, Colour)>) {
        self.compared = others;
    }

    /// Whether its shutter is open for longer than a moment.
    pub(super) fn is_open(&self) -> bool {
        self.open.seconds > 0.0
    }

    /// The picture at a part of the shutter's time, 0 to 1, without ghosts. Before the first and after the last moment of the animation
    /// nothing moves.
    ///
    /// # Errors
    /// [`ExportError`]: the moment does not exist.
    pub(super) fn frame_in_shutter(&self, moment: &Moment, part: f64) -> Result<Frame, ExportError> {
        let after = part - self.open.before;
        let seconds = after * self.open.seconds;
        let shown = match (moment.shown, self.source.animation) {
            (MomentPose::KeyTime(key_time), Some(animation)) => {
                let range = PlayRange::new(&animation.keyframes).map_err(|cause| self.source.unplayable(cause))?;
                let units = BigRational::from_f64(seconds * 1000.0 / f64::from(animation.ms_between_keyframes));
                let elapsed = range.timing().elapsed_at(key_time) + units.unwrap_or_default();
                MomentPose::KeyTime(range.timing().key_time_at(&elapsed))
            }
            (shown, _) => shown,
        };
        self.frame_of_scene(&Moment {
            shown,
            seconds: moment.seconds + seconds,
            turn: moment.turn + after * self.open.turn,
            number: moment.number,
        })
    }

    /// The picture at a moment.
    ///
    /// # Errors
    /// [`ExportError`]: the moment does not exist.
    pub fn frame(&self, moment: &Moment) -> Result<Frame, ExportError> {
        let mut frame = self.frame_of_scene(moment)?;
        if self.ghosts > 0 {
            self.add_ghosts(&mut frame, moment);
        }
        for &(blend, colour) in &self.compared {
            let nodes = self.world_from_nodes(moment, Some(blend))?;
            add_compared_nodes(&mut frame, self.source.scene, &nodes, colour);
        }
        let earlier = self.strobe.iter().map(|earlier| self.world_from_nodes(earlier, self.blend));
        add_strobe(&mut frame, self.source.scene, &earlier.collect::<Result<Vec<_>, _>>()?);
        Ok(frame)
    }

    fn frame_of_scene(&self, moment: &Moment) -> Result<Frame, ExportError> {
        let scene = self.source.scene;
        let pose = self.pose(moment.shown, None)?;
        let camera = self.camera(&pose, moment);
        let world_from_node = match self.blend {
            None => scene.world_from_nodes(&pose, moment.seconds),
            blend => self.world_from_nodes(moment, blend)?,
        };
        let mut frame = frame_of_nodes(scene, &world_from_node, moment.seconds, &camera, self.viewpoint.node());
        frame.lens = self.lens.map(|SharpAt { node, radius }| {
            let sharp_in_world = world_from_node[scene.rbt_node(node).get()].get().translation;
            let in_eye = frame.view.eye_from_world.transform_point3a(sharp_in_world);
            Lens { radius, focus_distance: (-in_eye.z).max(NEAREST_FOCUS) }
        });
        Ok(frame)
    }

    /// Where all nodes are in the world, in arena order, by a blend; `None`: by the animation's interpolation.
    fn world_from_nodes(&self, moment: &Moment, blend: Option<Blend>) -> Result<Vec<AlignedAffine>, ExportError> {
        let scene = self.source.scene;
        let interpolation = match (blend, moment.shown, self.source.animation) {
            // No pose holds what these give.
            (Some(blend @ (Blend::Nlerp | Blend::Matrices)), MomentPose::KeyTime(key_time), Some(animation)) => {
                let range = PlayRange::new(&animation.keyframes).map_err(|cause| self.source.unplayable(cause))?;
                range.check(key_time).map_err(|cause| self.source.unplayable(cause))?;
                let blended = |rbt| range.blended_at(key_time, blend, rbt);
                let nodes = scene.world_from_nodes_with(moment.seconds, blended);
                return Ok(nodes.into_iter().map(AlignedAffine::from).collect());
            }
            (Some(Blend::Played(interpolation)), ..) => Some(interpolation),
            _ => None,
        };
        Ok(scene.world_from_nodes(&self.pose(moment.shown, interpolation)?, moment.seconds))
    }

    /// The pose of a moment, by an interpolation; `None`: the animation's.
    fn pose(&self, shown: MomentPose, interpolation: Option<Interpolation>) -> Result<Pose, ExportError> {
        let (Some(animation), scene) = (self.source.animation, self.source.scene) else {
            return Ok(self.source.scene.rest_pose().clone());
        };
        match shown {
            MomentPose::Rest => Ok(scene.rest_pose().clone()),
            MomentPose::Keyframe(index) => {
                let keyframe = animation.keyframes.get(index);
                keyframe.map(|keyframe| keyframe.pose.clone()).ok_or_else(|| {
                    let index = i64::try_from(index.get()).unwrap_or(i64::MAX);
                    self.source.no_keyframe(index, &animation.keyframes)
                })
            }
            MomentPose::KeyTime(key_time) => PlayRange::new(&animation.keyframes)
                .and_then(|range| range.pose_at(key_time, interpolation.unwrap_or(animation.interpolation)))
                .map_err(|cause| self.source.unplayable(cause)),
        }
    }

    fn camera(&self, pose: &Pose, moment: &Moment) -> Camera {
        let scene = self.source.scene;
        let world_from_eye = match self.viewpoint {
            Viewpoint::Eye(eye) => scene.world_from_rbt(pose, moment.seconds, eye),
            Viewpoint::Turntable => self.world_from_turntable(moment.turn),
        };
        Camera { world_from_eye, vertical_fov: scene.vertical_fov(), size_px: self.size_px }
    }

    fn world_from_turntable(&self, turn: f64) -> Rbt {
        #[expect(clippy::cast_possible_truncation, reason = "an angle needs no more than f32")]
        let around = (turn * std::f64::consts::TAU) as f32;
        let rotation = Quat::from_rotation_y(around) * Quat::from_rotation_x(-TURNTABLE_DOWN.to_radians());
        Rbt::new(rotation * Vec3::new(0.0, 0.0, self.distance), rotation)
    }

    /// The distance from which every shape except planes is in view from all sides.
    fn fitting_distance(&self) -> f32 {
        let scene = self.source.scene;
        let pose = self.source.shown(None, None).and_then(|shown| self.pose(shown, None));
        let pose = pose.unwrap_or_else(|_| scene.rest_pose().clone());
        let camera =
            Camera { world_from_eye: Rbt::IDENTITY, vertical_fov: scene.vertical_fov(), size_px: self.size_px };
        let frame = frame_of_scene(scene, &pose, 0.0, &camera, None);
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
        let farthest = frame.items.iter().filter(|item| !item.is_ground()).map(reach).fold(0.5, f32::max);
        let half_height = (scene.vertical_fov() * 0.5).tan();
        let half_angle = (half_height * (self.size_px.x / self.size_px.y).min(1.0)).atan();
        farthest / half_angle.sin()
    }

    /// The list's keyframes before and after the moment.
    fn add_ghosts(&self, frame: &mut Frame, moment: &Moment) {
        let Some(animation) = self.source.animation else { return };
        // The moment's position in the list, whose first keyframe is not played.
        let here = match moment.shown {
            MomentPose::Rest => return,
            #[expect(clippy::cast_precision_loss, reason = "no list has 2^52 keyframes")]
            MomentPose::Keyframe(index) => index.get() as f64,
            MomentPose::KeyTime(key_time) => key_time + 1.0,
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it lies in the list")]
        let from = [here.ceil() as usize, here.floor() as usize];
        let neighbours = Neighbours { keyframes: &animation.keyframes, from, count: self.ghosts, only: &[] };
        add_ghosts(frame, self.source.scene, moment.seconds, neighbours);
    }
}
