//! A capture as a scene: joints are RBT nodes, bones are capsules, frames are samples.

use std::collections::HashSet;

use glam::{DQuat, DVec3, Quat, Vec3};

use super::{Capture, Rigid};
use crate::colour::Colour;
use crate::interchange::figure::{Figure, joints_of};
use crate::interchange::reduce::Samples;
use crate::pose::Pose;
use crate::rbt::Rbt;
use crate::scene::shapes::{Capsule, Plane, Sphere};
use crate::scene::{Joint, PlacedShape, Placement, SceneBuilder, SceneError, SceneGraph, Shape, Tracks};
use crate::words::{Message, texts};

/// The height that a captured person gets, in scene units: that of the robots.
pub const PERSON_HEIGHT: f64 = 4.3;

/// A scene made of a capture.
#[derive(Clone, Debug)]
pub struct CapturedScene {
    /// An eye, a ground, and the joints.
    pub scene: SceneGraph,
    /// The frames as poses; `None` of a capture without frames.
    pub samples: Option<Samples>,
    /// What was taken, simplified and left out: a sentence each.
    pub notes: Vec<Message>,
}

/// Makes a scene of a capture. `scale`: scene units for one unit of the file; without it the capture gets [`PERSON_HEIGHT`].
///
/// The lowest point of the motion is on the ground, y = 0, and the first root begins at x = z = 0.
///
/// # Errors
/// A capture without extent or too large a one, or one too long for an animation, as a sentence.
pub fn scene_of(capture: &Capture, name: &str, scale: Option<f64>) -> Result<CapturedScene, Message> {
    let turned = standing(capture, name, scale, true)?;
    match turned {
        // Only a person tells which way is up.
        Standing { is_turned: true, is_person: false, .. } => Ok(standing(capture, name, scale, false)?.made),
        Standing { made, .. } => Ok(made),
    }
}

/// A scene, and what decides whether its up axis was guessed well.
struct Standing {
    made: CapturedScene,
    is_turned: bool,
    is_person: bool,
}

/// The scene of a capture. `may_turn`: whether y becomes the up axis where it seems to be z.
fn standing(capture: &Capture, name: &str, scale: Option<f64>, may_turn: bool) -> Result<Standing, Message> {
    let measured = Measured::of(capture, may_turn);
    if measured.height.is_nan() || measured.height <= 0.0 {
        return Err(texts::BVH_NO_SIZE.into());
    }
    let factor = scale.unwrap_or(PERSON_HEIGHT / measured.height);
    let (names, renamed) = names(capture);
    let size = factor * measured.height;
    let placing = Placing { capture, measured: &measured, factor, radius: 0.03 * size };
    let rest = placing.pose(None)?;
    let build = |joints: &[Joint]| built(capture, name, &names, &placing, &rest, joints);
    let error = |error: SceneError| error.message();
    let plain = build(&[]).map_err(error)?;
    // Limbs can be told once there is a tree.
    let figure = Figure::of(&plain);
    let joints = figure.as_ref().map_or_else(Vec::new, |figure| joints_of(&plain, figure));
    let scene = build(&joints).map_err(error)?;
    let mut samples: Option<Samples> = None;
    for frame in 0..capture.frames {
        let pose = whole_pose(&scene, &placing.pose(Some(frame))?);
        match &mut samples {
            None => samples = Some(Samples::starting_with(pose)),
            #[expect(clippy::cast_precision_loss, reason = "there are less than 2^52 frames")]
            Some(samples) => {
                samples.push(frame as f64 * capture.frame_seconds, pose).map_err(|error| error.message())?;
            }
        }
    }
    let made = CapturedScene { notes: notes(capture, &measured, factor, scale.is_some(), renamed), scene, samples };
    Ok(Standing { made, is_turned: measured.upright != DQuat::IDENTITY, is_person: figure.is_some() })
}

fn notes(capture: &Capture, measured: &Measured, factor: f64, is_asked: bool, renamed: Vec<String>) -> Vec<Message> {
    let rate = (1e3 / capture.frame_seconds).round() / 1e3;
    let mut notes = vec![texts::bvh_report(
        texts::count_joints(capture.joints.len()),
        texts::count_frames(capture.frames),
        format!("{rate}"),
    )];
    let scaled = if is_asked { texts::bvh_scaled_by } else { texts::bvh_scaled };
    notes.push(scaled(format!("{factor:.4}"), format!("{:.2}", factor * measured.height)));
    if measured.upright != DQuat::IDENTITY {
        notes.push(texts::BVH_TURNED.into());
    }
    if capture.said_frames != capture.frames {
        notes.push(texts::bvh_frame_count(capture.said_frames, capture.frames));
    }
    if capture
        .joints
        .iter()
        .flat_map(|joint| &joint.channels)
        .any(|channel| matches!(channel, super::Channel::Scale(_)))
    {
        notes.push(texts::BVH_SCALES.into());
    }
    if !renamed.is_empty() {
        notes.push(texts::bvh_renamed(renamed.join(", ")));
    }
    if capture.frames == 0 {
        notes.push(texts::BVH_NO_FRAMES.into());
    }
    notes
}

/// The measures of a capture, in the file's unit.
struct Measured {
    /// The rotation that makes y the up axis.
    upright: DQuat,
    height: f64,
    /// What is moved to the origin: at rest, and in the frames.
    rest_origin: DVec3,
    origin: DVec3,
    /// The corners of a box around the whole motion.
    low: DVec3,
    high: DVec3,
}

impl Measured {
    fn of(capture: &Capture, may_turn: bool) -> Self {
        let extent = |points: &[DVec3]| {
            let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
            points.iter().fold(start, |(low, high), &point| (low.min(point), high.max(point)))
        };
        let points = |frame, upright: DQuat| -> Vec<DVec3> {
            capture.points(&capture.locals(frame)).into_iter().map(|point| upright * point).collect()
        };
        let first = (capture.frames > 0).then_some(0);
        let is_flat = |frame| {
            let (low, high) = extent(&points(frame, DQuat::IDENTITY));
            high.z - low.z > 1.5 * (high.y - low.y)
        };
        let is_z_up = may_turn && is_flat(None) && is_flat(first);
        let upright = if is_z_up { DQuat::from_rotation_x(-std::f64::consts::FRAC_PI_2) } else { DQuat::IDENTITY };
        let rest = points(None, upright);
        let (rest_low, rest_high) = extent(&rest);
        let begin = points(first, upright);
        let (first_low, first_high) = extent(&begin);
        let (mut low, mut high) = (first_low, first_high);
        let mut lowest: Vec<f64> = (0..capture.frames)
            .map(|frame| {
                let (frame_low, frame_high) = extent(&points(Some(frame), upright));
                (low, high) = (low.min(frame_low), high.max(frame_high));
                frame_low.y
            })
            .collect();
        lowest.sort_by(f64::total_cmp);
        // A few frames may be off: the lowest fiftieth of them does not count.
        let ground = lowest.get(lowest.len() / 50).copied().unwrap_or(rest_low.y);
        let up = rest_high.y - rest_low.y;
        Self {
            upright,
            height: up.max(first_high.y - first_low.y),
            rest_origin: DVec3::new(rest[0].x, rest_low.y, rest[0].z),
            origin: DVec3::new(begin[0].x, ground, begin[0].z),
            low,
            high,
        }
    }
}

/// Where joints go in the scene.
struct Placing<'a> {
    capture: &'a Capture,
    measured: &'a Measured,
    factor: f64,
    /// The radius of the thickest bones, in scene units: the ground is so far below the lowest joint.
    radius: f64,
}

impl Placing<'_> {
    /// A position of the file in the scene, of a root: other positions are only scaled.
    fn placed(&self, position: DVec3, frame: Option<usize>) -> DVec3 {
        let Measured { upright, rest_origin, origin, .. } = self.measured;
        let origin = if frame.is_some() { origin } else { rest_origin };
        self.factor * (*upright * position - *origin) + DVec3::Y * self.radius
    }

    /// `parent_from_joint` of all joints in scene units.
    fn pose(&self, frame: Option<usize>) -> Result<Vec<Rbt>, Message> {
        let place = |(index, local): (usize, Rigid)| {
            let joint = &self.capture.joints[index];
            let Rigid { translation, rotation } = local;
            let (translation, rotation) = match joint.parent {
                Some(_) => (self.factor * translation, rotation),
                None => (self.placed(translation, frame), self.measured.upright * rotation),
            };
            let rbt = Rbt::new(translation.as_vec3(), rotation.as_quat().normalize());
            let is_good = rbt.is_in_bounds() && rbt.is_finite();
            is_good.then_some(rbt).ok_or_else(|| texts::bvh_too_far(joint.name.as_str()))
        };
        self.capture.locals(frame).into_iter().enumerate().map(place).collect()
    }
}

/// A pose of the scene with these transforms of the joints, which come last; the eye and the ground stay.
fn whole_pose(scene: &SceneGraph, joints: &[Rbt]) -> Pose {
    let rest = scene.rest_pose();
    let before = rest.len() - joints.len();
    Pose::new(rest.iter().take(before).chain(joints.iter().copied()).collect())
}

/// The names of the nodes above all joints.
const SKY: &str = "sky";
const GROUND: &str = "ground";

/// A name for each joint that no sibling has, and the names that are not those of the file.
fn names(capture: &Capture) -> (Vec<String>, Vec<String>) {
    let mut taken: HashSet<(Option<usize>, String)> =
        [SKY, GROUND].into_iter().map(|name| (None, name.to_owned())).collect();
    let mut renamed = Vec::new();
    let name = |(index, joint): (usize, &super::CapturedJoint)| {
        let plain = joint.name.replace('/', "_");
        let plain = if plain.is_empty() { format!("joint_{index}") } else { plain };
        let numbered = (2..).map(|number: usize| format!("{plain}_{number}"));
        let mut free = std::iter::once(plain.clone()).chain(numbered);
        let name = free.find(|name| taken.insert((joint.parent, name.clone()))).unwrap_or(plain.clone());
        if name != joint.name {
            renamed.push(name.clone());
        }
        name
    };
    (capture.joints.iter().enumerate().map(name).collect(), renamed)
}

/// The scene. `joints`: what reaching knows of each RBT node, or nothing.
fn built(
    capture: &Capture,
    name: &str,
    names: &[String],
    placing: &Placing<'_>,
    rest: &[Rbt],
    joints: &[Joint],
) -> Result<SceneGraph, SceneError> {
    let mut builder = SceneBuilder::new();
    builder.open_rbt(SKY, eye(placing))?;
    builder.close();
    builder.open_rbt(GROUND, Rbt::IDENTITY)?;
    #[expect(clippy::cast_possible_truncation, reason = "shapes are f32")]
    let size = (100.0 * placing.factor * placing.measured.height).min(1e6) as f32;
    let plane = Shape::Plane(Plane { size: [size, size] });
    builder.shape("plane", placed(plane, Colour::from_rgb(0x7d, 0x87, 0x91), Vec3::ZERO, Quat::IDENTITY))?;
    builder.close();
    let mut open: Vec<usize> = Vec::new();
    for (index, joint) in capture.joints.iter().enumerate() {
        while open.last().copied() != joint.parent {
            open.pop();
            builder.close();
        }
        builder.open_rbt(&names[index], rest[index])?;
        // The eye and the ground come before the joints.
        builder.joint(joints.get(index + 2).copied().unwrap_or_default());
        open.push(index);
        bones(&mut builder, capture, index, names, placing, rest)?;
    }
    builder.finish(name, &[SKY.to_owned()], 60.0)
}

fn placed(shape: Shape, colour: Colour, translation: Vec3, rotation: Quat) -> PlacedShape {
    PlacedShape::new(shape, colour, Tracks::default(), Placement { translation, rotation, scale: Vec3::ONE })
}

/// The shapes of a joint: a capsule to each joint and end below it, a ball where there is none.
fn bones(
    builder: &mut SceneBuilder,
    capture: &Capture,
    index: usize,
    names: &[String],
    placing: &Placing<'_>,
    rest: &[Rbt],
) -> Result<(), SceneError> {
    let joint = &capture.joints[index];
    let below = (index + 1..capture.joints.len()).take_while(|&other| capture.joints[other].parent.is_some());
    let children: Vec<usize> = below.filter(|&other| capture.joints[other].parent == Some(index)).collect();
    let mut taken: HashSet<String> = children.iter().map(|&child| names[child].clone()).collect();
    let to_children = children.iter().map(|&child| rest[child].translation);
    let to_ends = joint.ends.iter().map(|&end| (placing.factor * end).as_vec3());
    #[expect(clippy::cast_possible_truncation, reason = "shapes are f32")]
    let (radius, colour) = (placing.radius as f32, colour_of(capture, index));
    let mut shapes: Vec<PlacedShape> = to_children
        .chain(to_ends)
        .filter(|tip| tip.is_finite() && tip.length() > 0.01 * radius && tip.length() < 1e6)
        .map(|tip| {
            let length = tip.length();
            let radius = (0.1 * length).clamp(0.3 * radius, radius).min(length / 2.0);
            let turn = Quat::from_rotation_arc(Vec3::Y, tip / length);
            placed(Shape::Capsule(Capsule { radius, height: length }), colour, tip / 2.0, turn)
        })
        .collect();
    let is_seen = (1e-6..1e6).contains(&radius);
    if shapes.is_empty() && children.is_empty() && is_seen {
        shapes.push(placed(Shape::Sphere(Sphere { radius }), colour, Vec3::ZERO, Quat::IDENTITY));
    }
    for shape in shapes {
        let mut free =
            (1..).map(|number: usize| if number == 1 { "bone".to_owned() } else { format!("bone_{number}") });
        let name = free.find(|name| taken.insert(name.clone())).unwrap_or_default();
        builder.shape(&name, shape)?;
    }
    Ok(())
}

/// Sides have colours of their own, by the position at rest.
fn colour_of(capture: &Capture, index: usize) -> Colour {
    let joint = &capture.joints[index];
    let above = std::iter::successors(Some(index), |&index| capture.joints[index].parent);
    let x: f64 =
        above.map(|index| capture.joints[index].offset.x).sum::<f64>() + joint.ends.first().map_or(0.0, |end| end.x);
    let root = {
        let top = std::iter::successors(Some(index), |&index| capture.joints[index].parent).last().unwrap_or(index);
        capture.joints[top].offset.x
    };
    let across = x - root;
    let size = capture.joints.iter().map(|joint| joint.offset.length()).fold(0.0, f64::max);
    if across > 0.2 * size {
        Colour::from_rgb(0xdd, 0x7a, 0x45)
    } else if across < -0.2 * size {
        Colour::from_rgb(0x4f, 0xa3, 0xad)
    } else {
        Colour::from_rgb(0xed, 0xb2, 0x66)
    }
}

/// An eye in front of the motion, far enough to see all of it.
fn eye(placing: &Placing<'_>) -> Rbt {
    let Measured { low, high, .. } = placing.measured;
    let corner = |corner: DVec3| placing.factor * (corner - placing.measured.origin);
    let (low, high) = (corner(*low), corner(*high));
    let middle = (low + high) / 2.0;
    let radius = (high - low).length() / 2.0;
    // The field of view is 60 degrees high, and wider than that.
    let distance =
        1.1 * ((high.y - low.y).max((high.x - low.x) / 1.5) / 2.0 / 30f64.to_radians().tan() + (high.z - low.z) / 2.0);
    let distance = distance.max(0.2 * radius);
    let pitch = 0.12;
    let back = DQuat::from_rotation_x(-pitch);
    let place = (middle + back * (DVec3::Z * distance)).clamp(DVec3::splat(-1e6), DVec3::splat(1e6));
    Rbt::new(place.as_vec3(), back.as_quat().normalize())
}
