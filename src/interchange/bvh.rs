//! BVH, the text format of motion capture: a tree of joints with offsets, and channels of numbers for each frame.
//!
//! What the format leaves open is read as most programs write it. The channels of a joint are factors of its rotation in the order in
//! which the file lists them. A position channel replaces that coordinate of the offset. Lengths have no unit.

mod read;
mod scene;
#[cfg(test)]
mod tests;
mod write;

use glam::{DQuat, DVec3};
use thiserror::Error;

use crate::words::{Message, display_by_message, texts};

pub use read::{LARGEST_BVH_BYTES, read_bvh};
pub use scene::{CapturedScene, PERSON_HEIGHT, scene_of};
pub use write::BvhText;

/// What is wrong with a BVH file, and where.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub struct BvhError {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong, without the place.
    pub problem: Message,
}

display_by_message!(BvhError);

impl BvhError {
    /// The error as a message with its line.
    #[must_use]
    pub fn message(&self) -> Message {
        texts::bvh_at(self.line, self.problem.clone())
    }
}

/// What a number of a frame says of a joint. Axes are 0 for x, 1 for y, 2 for z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Channel {
    /// A coordinate of its position in its parent's space.
    Position(usize),
    /// A rotation about an axis, in degrees.
    Rotation(usize),
    /// A scale, which is left out.
    Scale(usize),
}

impl Channel {
    const NAMES: [(&str, Self); 9] = [
        ("Xposition", Self::Position(0)),
        ("Yposition", Self::Position(1)),
        ("Zposition", Self::Position(2)),
        ("Xrotation", Self::Rotation(0)),
        ("Yrotation", Self::Rotation(1)),
        ("Zrotation", Self::Rotation(2)),
        ("Xscale", Self::Scale(0)),
        ("Yscale", Self::Scale(1)),
        ("Zscale", Self::Scale(2)),
    ];
}

/// A joint of a capture.
#[derive(Clone, Debug, PartialEq)]
struct CapturedJoint {
    /// As the file has it; it may be empty.
    name: String,
    /// The joint above it, which comes before it; `None` for a root.
    parent: Option<usize>,
    /// From its parent, in the file's unit.
    offset: DVec3,
    channels: Vec<Channel>,
    /// Where bones end that no joint follows.
    ends: Vec<DVec3>,
}

/// A BVH file: joints, parents first, and frames.
#[derive(Clone, Debug, PartialEq)]
pub struct Capture {
    joints: Vec<CapturedJoint>,
    /// From a frame to the next, in seconds.
    frame_seconds: f64,
    frames: usize,
    /// The numbers of all frames, in the order of joints and channels.
    values: Vec<f64>,
    /// How many frames the file says that it has.
    said_frames: usize,
}

/// A translation and a rotation, in double precision.
#[derive(Clone, Copy, Debug)]
struct Rigid {
    translation: DVec3,
    rotation: DQuat,
}

impl Rigid {
    fn then(self, child: Self) -> Self {
        Self {
            translation: self.translation + self.rotation * child.translation,
            rotation: self.rotation * child.rotation,
        }
    }
}

impl Capture {
    /// How many joints there are.
    #[must_use]
    pub fn joint_count(&self) -> usize {
        self.joints.len()
    }

    /// How many frames there are.
    #[must_use]
    pub fn frame_count(&self) -> usize {
        self.frames
    }

    /// `parent_from_joint` of every joint, in the file's unit: at rest, or in a frame.
    fn locals(&self, frame: Option<usize>) -> Vec<Rigid> {
        let rest = |joint: &CapturedJoint| Rigid { translation: joint.offset, rotation: DQuat::IDENTITY };
        let Some(frame) = frame else { return self.joints.iter().map(rest).collect() };
        let width = self.values.len() / self.frames.max(1);
        let mut numbers = self.values[frame * width..(frame + 1) * width].iter();
        let posed = |joint: &CapturedJoint| {
            let mut local = rest(joint);
            for (channel, &number) in joint.channels.iter().zip(&mut numbers) {
                match *channel {
                    Channel::Position(axis) => local.translation[axis] = number,
                    Channel::Rotation(axis) => {
                        local.rotation *= DQuat::from_axis_angle(DVec3::AXES[axis], number.to_radians());
                    }
                    Channel::Scale(_) => {}
                }
            }
            local
        };
        self.joints.iter().map(posed).collect()
    }

    /// The positions of all joints and ends, given `parent_from_joint` of the joints.
    fn points(&self, locals: &[Rigid]) -> Vec<DVec3> {
        let mut world_from_joint: Vec<Rigid> = Vec::with_capacity(locals.len());
        let mut points = Vec::with_capacity(2 * locals.len());
        for (joint, &local) in self.joints.iter().zip(locals) {
            let world = joint.parent.map_or(local, |parent| world_from_joint[parent].then(local));
            points.push(world.translation);
            points.extend(joint.ends.iter().map(|&end| world.translation + world.rotation * end));
            world_from_joint.push(world);
        }
        points
    }
}
