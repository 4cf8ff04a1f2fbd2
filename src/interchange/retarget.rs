//! Motion from one skeleton to another, by a map of nodes.
//!
//! Each mapped node turns in the world as its node of the source does, from rest poses that are aligned: where both have a bone below,
//! the two bones point the same way at all times. The hips move as the source's, scaled by the length of the legs. Feet that stand stay
//! in place: their limbs reach.

mod feet;
mod map;
mod motion;
#[cfg(test)]
mod tests;
mod way;

use glam::{DVec3, Vec3};
use num_rational::BigRational;
use num_traits::FromPrimitive as _;

use super::MOST_NODE_POSES;
use super::reduce::{Choice, LONGEST_SECONDS, Reduced, Samples, Tolerance, Watched, reduced_watching};
use crate::interpolation::Interpolation;
use crate::keyframe::{Animation, PlayRange, to_f64};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::scene::SceneGraph;
use crate::words::{Message, texts};

pub use feet::{Standing, standing};
pub use map::{LARGEST_MAP_BYTES, MapError, RetargetMap};

use map::Pairs;

/// The longest time between samples, in seconds: a foot must not go on between two.
const LONGEST_STEP: f64 = 0.02;

/// How far a foot that stands may be off in the keyframes, in parts of the leg's length.
const STANDS: f32 = 0.002;

/// A scene and its motion.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The scene.
    pub scene: &'a SceneGraph,
    /// Its poses.
    pub samples: &'a Samples,
}

/// The motion of another skeleton.
#[derive(Clone, Debug)]
pub struct Retargeted {
    samples: Samples,
    top: RbtIndex,
    /// The feet that stand at times, each with the length of its leg.
    feet: Vec<(Watched, f64)>,
    /// What was done: a sentence each.
    notes: Vec<Message>,
}

/// Keyframes of the motion, and how its feet stand as they play.
#[derive(Clone, Debug)]
pub struct RetargetedKeyframes {
    /// The keyframes.
    pub reduced: Reduced,
    /// One for each foot that stands at times.
    pub feet: Vec<Standing>,
    /// What was done: a sentence each.
    pub notes: Vec<Message>,
}

/// Gives the source's motion to the mapped nodes of a scene. All others keep their rest pose.
///
/// # Errors
/// The map does not fit the scenes, or there are too many samples, as a sentence.
pub fn retargeted(source: Source<'_>, target: &SceneGraph, map: &RetargetMap) -> Result<Retargeted, Message> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a number of samples")]
    let finer = (source.samples.duration() / LONGEST_STEP) as usize;
    let (frames, nodes) = (source.samples.len() + finer, target.rbt_count());
    if frames.saturating_mul(nodes) > MOST_NODE_POSES {
        return Err(texts::bvh_too_many_frames(frames, nodes, MOST_NODE_POSES));
    }
    let pairs = Pairs::of(map, source.scene, target)?;
    let samples = source.samples.at_least_every(LONGEST_STEP);
    let source = Source { samples: &samples, ..source };
    let motion = motion::Motion::of(source, target, &pairs);
    let (samples, plants) = feet::stood(&motion, &pairs);
    if let Some(node) = samples.poses().iter().flat_map(Pose::iter).position(|rbt| !rbt.is_in_bounds()) {
        return Err(texts::bvh_too_far(target.rbt_path(RbtIndex::new(node % target.rbt_count()))));
    }
    let top = target.topmost(pairs.nodes[0].onto);
    let mut notes = vec![texts::retarget_report(
        texts::count_nodes(pairs.nodes.len()),
        target.rbt_path(top),
        format!("{:.4}", motion.factor),
    )];
    let feet: Vec<(Watched, f64)> = plants
        .planted
        .iter()
        .zip(&pairs.feet)
        // One that is never planted flies or slides all the time.
        .filter(|(planted, _)| planted.contains(&true))
        .map(|(planted, foot)| {
            #[expect(clippy::cast_possible_truncation, reason = "poses are f32")]
            let most = STANDS * foot.length as f32;
            let units = planted.iter().map(|&planted| if planted { most } else { f32::INFINITY }).collect();
            (watched(target, foot.lower, foot.end, units), foot.length)
        })
        .collect();
    if plants.short > 0 {
        notes.push(texts::retarget_short(texts::count_frames(plants.short)));
    }
    Ok(Retargeted { samples, top, feet, notes })
}

impl Retargeted {
    /// The topmost node of the skeleton that moves.
    #[must_use]
    pub const fn top(&self) -> RbtIndex {
        self.top
    }

    /// The poses.
    #[must_use]
    pub const fn samples(&self) -> &Samples {
        &self.samples
    }

    /// Keyframes that play so, and what their feet do.
    #[must_use]
    pub fn keyframes(self, choice: Choice, interpolation: Interpolation) -> RetargetedKeyframes {
        let watched: Vec<Watched> = self.feet.iter().map(|(watched, _)| watched.clone()).collect();
        let reduced = reduced_watching(&self.samples, choice, interpolation, &watched);
        let feet: Vec<Standing> =
            self.feet.iter().map(|(watched, length)| standing(&reduced.animation, watched, *length)).collect();
        let mut notes = self.notes;
        notes.push(reduced.message());
        if !feet.is_empty() {
            let times: usize = feet.iter().map(|foot| foot.stances).sum();
            let worst = feet.iter().map(|foot| foot.slide).fold(0.0, f64::max);
            notes.push(texts::retarget_feet(times, format!("{:.2}", 100.0 * worst)));
        }
        RetargetedKeyframes { reduced, feet, notes }
    }
}

/// How often an animation is sampled, in frames a second.
const FRAMES_A_SECOND: f64 = 60.0;

/// The poses of an animation of a scene, 60 a second.
///
/// # Errors
/// It has too few keyframes or is too long, as a sentence.
pub fn sampled(scene: &SceneGraph, animation: &Animation) -> Result<Samples, Message> {
    let range = PlayRange::new(&animation.keyframes).map_err(|error| error.message())?;
    let unit = f64::from(animation.ms_between_keyframes) / 1000.0;
    let seconds = to_f64(&range.timing().total()) * unit;
    #[expect(clippy::cast_precision_loss, reason = "no scene has 2^52 nodes")]
    let most = (MOST_NODE_POSES as f64 / scene.rbt_count() as f64 / FRAMES_A_SECOND).min(LONGEST_SECONDS);
    if seconds > most {
        return Err(texts::reduced_too_long(format!("{seconds}"), format!("{most:.0}")));
    }
    let pose_at = |seconds: f64| {
        let elapsed = BigRational::from_f64(seconds / unit).unwrap_or_default();
        let pose = range.pose_at(range.timing().key_time_at(&elapsed), animation.interpolation);
        // Key times are within the range.
        pose.unwrap_or_else(|_| scene.rest_pose().clone())
    };
    Samples::of(seconds, FRAMES_A_SECOND, pose_at).map_err(|error| error.message())
}

/// The usual tolerance for a scene: 0.5 degree, and a thousandth of the largest extent of its RBT nodes below a node at rest.
#[must_use]
pub fn tolerance_for(scene: &SceneGraph, top: RbtIndex) -> Tolerance {
    let points = scene
        .rbt_indices()
        .filter(|&rbt| rbt == top || scene.is_above(top, rbt))
        .map(|rbt| scene.world_from_rbt(scene.rest_pose(), 0.0, rbt).translation.as_dvec3());
    let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) = points.fold(start, |(low, high), point| (low.min(point), high.max(point)));
    Tolerance::for_size((high - low).max_element().max(1e-3))
}

/// A point of a node, with the nodes above it.
fn watched(scene: &SceneGraph, last: RbtIndex, point: Vec3, units: Vec<f32>) -> Watched {
    let above = |&rbt: &RbtIndex| scene.limb_nodes(rbt).upper;
    let mut chain: Vec<(Rbt, RbtIndex)> = std::iter::successors(Some(last), above)
        .map(|rbt| {
            // Control nodes stand between the two.
            let parent = scene.world_from_parent(scene.rest_pose(), 0.0, rbt);
            let carrying =
                above(&rbt).map(|above| scene.world_from_node(scene.rest_pose(), 0.0, scene.rbt_node(above)));
            (Rbt::from_affine(&carrying.map_or(parent, |carrying| carrying.inverse() * parent)), rbt)
        })
        .collect();
    chain.reverse();
    Watched { chain, point, units }
}
