//! Writes BVH: the RBT tree of a scene, and an animation sampled at a rate.

use std::fmt::Write as _;
use std::io;

use glam::{Affine3A, DAffine3, DQuat, DVec3, EulerRot};
use num_rational::BigRational;
use num_traits::ToPrimitive as _;

use super::Rigid;
use crate::interpolation::Interpolation;
use crate::keyframe::{Animation, PlayRange, SampleError, whole};
use crate::pose::{Pose, RbtIndex};
use crate::scene::SceneGraph;
use crate::words::{Message, texts};

/// How far the axes of a space may be from square, as a cosine.
const SQUARE: f64 = 1e-4;
/// How far a joint may be from its offset and still have no position of its own, in parts of the largest offset.
const STILL: f64 = 1e-6;

/// A BVH file of a scene, and of an animation or the rest pose.
pub struct BvhText<'a> {
    scene: &'a SceneGraph,
    animation: Option<(PlayRange<'a>, Interpolation, u32)>,
    fps: u32,
    frames: usize,
    /// The nodes that are joints, parents first.
    joints: Vec<RbtIndex>,
    /// For each joint the joint above it.
    parents: Vec<Option<usize>>,
    /// From its parent, at rest, in the space of the parent without its scale.
    offsets: Vec<DVec3>,
    /// Whether a joint has positions of its own.
    moves: Vec<bool>,
}

impl<'a> BvhText<'a> {
    /// The file's content. `top`: only this node and those below it are joints. `fps`: frames a second, at least 1. Scales of control
    /// nodes become part of the positions.
    ///
    /// # Errors
    /// Too few keyframes, or a node that scales shear, as a sentence.
    pub fn new(
        scene: &'a SceneGraph,
        animation: Option<&'a Animation>,
        top: Option<RbtIndex>,
        fps: u32,
    ) -> Result<Self, Message> {
        let animation = animation.map(|animation| {
            let range = PlayRange::new(&animation.keyframes).map_err(|error: SampleError| error.message())?;
            Ok::<_, Message>((range, animation.interpolation, animation.ms_between_keyframes))
        });
        let animation = animation.transpose()?;
        let frames = animation.as_ref().map_or(1, |(range, _, ms)| {
            let seconds = range.timing().total() * whole(*ms as usize) / whole(1000);
            // The last frame is not before the end.
            (seconds * whole(fps as usize)).ceil().to_integer().to_usize().unwrap_or(usize::MAX - 1) + 1
        });
        let is_joint = |rbt: &RbtIndex| top.is_none_or(|top| *rbt == top || scene.is_above(top, *rbt));
        let joints: Vec<RbtIndex> = scene.rbt_indices().filter(is_joint).collect();
        let parent = |&rbt: &RbtIndex| joints.binary_search(&scene.limb_nodes(rbt).upper?).ok();
        let parents: Vec<Option<usize>> = joints.iter().map(parent).collect();
        let moves = parents.iter().map(Option::is_none).collect();
        let mut text = Self { scene, animation, fps, frames, joints, parents, offsets: Vec::new(), moves };
        text.offsets = text.locals_of(scene.rest_pose(), 0.0)?.iter().map(|local| local.translation).collect();
        let size = text.offsets.iter().map(|offset| offset.length()).fold(1e-3, f64::max);
        for frame in 0..frames {
            for (joint, local) in text.locals(frame)?.iter().enumerate() {
                text.moves[joint] |= local.translation.distance(text.offsets[joint]) > STILL * size;
            }
        }
        Ok(text)
    }

    /// What was written, simplified and left out: a sentence each.
    #[must_use]
    pub fn notes(&self) -> Vec<Message> {
        let mut notes = vec![texts::bvh_written(
            texts::count_joints(self.parents.len()),
            texts::count_frames(self.frames),
            self.fps.to_string(),
        )];
        notes.push(texts::BVH_SHAPES.into());
        let roots = self.parents.iter().filter(|parent| parent.is_none()).count();
        if roots > 1 {
            notes.push(texts::bvh_roots(roots));
        }
        let is_moving = |&joint: &usize| self.moves[joint] && self.parents[joint].is_some();
        let moving: Vec<&str> = (0..self.joints.len()).filter(is_moving).map(|joint| self.path(joint)).collect();
        if !moving.is_empty() {
            notes.push(texts::bvh_moving(moving.join(", ")));
        }
        notes
    }

    fn path(&self, joint: usize) -> &'a str {
        self.scene.rbt_path(self.joints[joint])
    }

    /// Writes the text.
    ///
    /// # Errors
    /// `out` does not take it.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        let mut text = String::from("HIERARCHY\n");
        self.push_tree(&mut text);
        let _ = write!(text, "MOTION\nFrames: {}\nFrame Time: {}\n", self.frames, 1.0 / f64::from(self.fps));
        let mut angles = vec![[0.0; 3]; self.parents.len()];
        for frame in 0..self.frames {
            let locals = self.locals(frame).map_err(|error| io::Error::other(error.to_string()))?;
            let mut numbers = Vec::with_capacity(6 * locals.len());
            for (joint, local) in locals.iter().enumerate() {
                if self.moves[joint] {
                    numbers.extend(local.translation.to_array());
                }
                angles[joint] = nearest_angles(local.rotation, angles[joint]);
                numbers.extend(angles[joint]);
            }
            for (index, &number) in numbers.iter().enumerate() {
                text.push_str(if index == 0 { "" } else { " " });
                push_number(&mut text, number);
            }
            text.push('\n');
            out.write_all(text.as_bytes())?;
            text.clear();
        }
        Ok(())
    }

    /// The joints. Roots have no offset: their positions are in the frames, where all programs read them alike.
    fn push_tree(&self, text: &mut String) {
        let mut open: Vec<usize> = Vec::new();
        let mut has_child = vec![false; self.parents.len()];
        for parent in self.parents.iter().flatten() {
            has_child[*parent] = true;
        }
        let indent = |text: &mut String, depth: usize| text.extend(std::iter::repeat_n('\t', depth));
        let close = |text: &mut String, open: &mut Vec<usize>| {
            open.pop();
            indent(text, open.len());
            text.push_str("}\n");
        };
        for (joint, &parent) in self.parents.iter().enumerate() {
            while open.last().copied() != parent {
                close(text, &mut open);
            }
            let depth = open.len();
            let name = &self.scene.node(self.scene.rbt_node(self.joints[joint])).name;
            indent(text, depth);
            let _ = writeln!(text, "{} {}", if parent.is_some() { "JOINT" } else { "ROOT" }, plain(name));
            indent(text, depth);
            text.push_str("{\n");
            self.push_joint(text, joint, depth + 1);
            open.push(joint);
            if !has_child[joint] {
                let end = self.scene.limb_end(self.joints[joint], 0.0).unwrap_or_default().as_dvec3();
                for line in ["End Site", "{"] {
                    indent(text, depth + 1);
                    text.push_str(line);
                    text.push('\n');
                }
                push_offset(text, end, depth + 2);
                indent(text, depth + 1);
                text.push_str("}\n");
            }
        }
        while !open.is_empty() {
            close(text, &mut open);
        }
    }

    fn push_joint(&self, text: &mut String, joint: usize, depth: usize) {
        let is_root = self.parents[joint].is_none();
        push_offset(text, if is_root { DVec3::ZERO } else { self.offsets[joint] }, depth);
        text.extend(std::iter::repeat_n('\t', depth));
        text.push_str(if self.moves[joint] {
            "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
        } else {
            "CHANNELS 3 Zrotation Xrotation Yrotation\n"
        });
    }

    /// `parent_from_joint` of all joints in a frame.
    fn locals(&self, frame: usize) -> Result<Vec<Rigid>, Message> {
        let Some((range, interpolation, ms)) = &self.animation else {
            return self.locals_of(self.scene.rest_pose(), 0.0);
        };
        let seconds: BigRational = whole(frame) / whole(self.fps as usize);
        let elapsed = &seconds * whole(1000) / whole(*ms as usize);
        let key_time = range.timing().key_time_at(&elapsed);
        let pose = range.pose_at(key_time, *interpolation).map_err(|error| error.message())?;
        self.locals_of(&pose, seconds.to_f64().unwrap_or(f64::MAX))
    }

    /// `parent_from_joint` of all joints, where every joint's space is rigid: scales are in the positions.
    fn locals_of(&self, pose: &Pose, seconds: f64) -> Result<Vec<Rigid>, Message> {
        let world_from_node = self.scene.world_from_nodes_with(seconds, |rbt| pose.get(rbt).to_affine());
        let mut world_from_joint: Vec<Rigid> = Vec::with_capacity(self.parents.len());
        let mut locals = Vec::with_capacity(self.parents.len());
        for (joint, &rbt) in self.joints.iter().enumerate() {
            let node = self.scene.rbt_node(rbt);
            let sheared = || texts::bvh_sheared(self.path(joint));
            let world = rigid(&world_from_node[node.get()]).ok_or_else(sheared)?;
            locals.push(match self.parents[joint] {
                None => world,
                Some(parent) => {
                    let above: Rigid = world_from_joint[parent];
                    let back = above.rotation.conjugate();
                    Rigid {
                        translation: back * (world.translation - above.translation),
                        rotation: (back * world.rotation).normalize(),
                    }
                }
            });
            world_from_joint.push(world);
        }
        Ok(locals)
    }
}

/// The rotation and the translation of an affine map; `None` if its axes are not square to each other.
fn rigid(world_from_node: &Affine3A) -> Option<Rigid> {
    let DAffine3 { matrix3, translation } = world_from_node.as_daffine3();
    let axes = [matrix3.x_axis, matrix3.y_axis, matrix3.z_axis].map(DVec3::try_normalize);
    let [Some(x), Some(y), Some(z)] = axes else { return None };
    let is_square = [x.dot(y), y.dot(z), z.dot(x)].iter().all(|cosine| cosine.abs() < SQUARE);
    let matrix = glam::DMat3::from_cols(x, y, z);
    is_square.then(|| Rigid { translation, rotation: DQuat::from_mat3(&matrix).normalize() })
}

/// The angles about z, x and y in degrees, in this order of factors, that are nearest to earlier ones: programs interpolate them.
fn nearest_angles(rotation: DQuat, before: [f64; 3]) -> [f64; 3] {
    let (z, x, y) = rotation.to_euler(EulerRot::ZXY);
    let degrees = [z, x, y].map(f64::to_degrees);
    let other = [degrees[0] + 180.0, 180.0 - degrees[1], degrees[2] + 180.0];
    let near = |angles: [f64; 3]| {
        let mut angles = angles;
        for (angle, before) in angles.iter_mut().zip(before) {
            *angle -= 360.0 * ((*angle - before) / 360.0).round();
        }
        angles
    };
    let off = |angles: &[f64; 3]| angles.iter().zip(before).map(|(angle, before)| (angle - before).abs()).sum::<f64>();
    let (degrees, other) = (near(degrees), near(other));
    if off(&other) < off(&degrees) { other } else { degrees }
}

/// A name as one word.
fn plain(name: &str) -> String {
    let is_odd =
        |character: char| character.is_whitespace() || character.is_control() || matches!(character, '{' | '}');
    name.chars().map(|character| if is_odd(character) { '_' } else { character }).collect()
}

fn push_offset(text: &mut String, offset: DVec3, depth: usize) {
    text.extend(std::iter::repeat_n('\t', depth));
    text.push_str("OFFSET");
    for number in offset.to_array() {
        text.push(' ');
        push_number(text, number);
    }
    text.push('\n');
}

/// A number with up to eight decimals and no exponent.
fn push_number(text: &mut String, number: f64) {
    let rounded = (number * 1e8).round() / 1e8;
    // Adding zero makes a zero of minus zero.
    let _ = write!(text, "{}", rounded + 0.0);
}
