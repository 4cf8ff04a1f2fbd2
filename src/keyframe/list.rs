//! The keyframe list with its current keyframe, and the edits that the hotkeys make.

use std::sync::{Arc, OnceLock};

use super::easing::Easing;
use super::timing::Timing;
use crate::interpolation::{ControlPoints, TangentDivisors, rbt_control_points};
use crate::pose::Pose;

/// The index of a keyframe in a list, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct KeyframeIndex(usize);

impl KeyframeIndex {
    /// The keyframe with this index.
    #[must_use]
    pub const fn new(index: usize) -> Self {
        Self(index)
    }

    /// The index, from 0.
    #[must_use]
    pub const fn get(self) -> usize {
        self.0
    }
}

/// A stored pose with the duration and easing of the interval that begins at it. Immutable: an edit replaces the keyframe.
#[derive(Clone, Debug, PartialEq)]
pub struct Keyframe {
    /// The recorded pose.
    pub pose: Pose,
    /// The name that a user gave it, if any; never empty.
    pub name: Option<Arc<str>>,
    /// The length of the interval that begins here, in units of the ms between keyframes: above 0; 1 by default.
    pub duration: f64,
    /// The easing of the interval that begins here.
    pub easing: Easing,
}

/// The lengths that an interval can have, in units of the ms between keyframes.
pub const DURATION_RANGE: std::ops::RangeInclusive<f64> = 0.001..=1000.0;

impl Keyframe {
    /// A keyframe of this pose, with no name, an interval of one unit and no easing.
    #[must_use]
    pub const fn new(pose: Pose) -> Self {
        Self { pose, name: None, duration: 1.0, easing: Easing::Linear }
    }

    /// The same keyframe with another pose.
    #[must_use]
    pub fn with_pose(&self, pose: Pose) -> Self {
        Self { pose, ..self.clone() }
    }

    /// Whether it has a name, a duration or an easing of its own.
    #[must_use]
    pub fn has_extras(&self) -> bool {
        self.name.is_some() || self.duration != 1.0 || self.easing != Easing::Linear
    }

    /// Whether two keyframes are equal; fast if they share storage.
    #[must_use]
    pub fn same_as(&self, other: &Self) -> bool {
        self.duration == other.duration
            && self.easing == other.easing
            && self.name == other.name
            && self.pose.same_as(&other.pose)
    }
}

/// The inner Bézier control points of one interval, for every RBT node.
pub(super) type IntervalControlPoints = ControlPoints<Pose>;

/// The data that copies of a list share: the keyframes and, for each interval, the control points, computed on first use.
#[derive(Debug, Default)]
struct Stored {
    keyframes: Vec<Keyframe>,
    control_points: Vec<OnceLock<IntervalControlPoints>>,
    timing: OnceLock<Option<Timing>>,
}

/// Keyframes in order and the current one. Cloning is cheap: copies share storage until one changes.
///
/// A list with keyframes always has a current one; an empty list has none.
///
/// ```
/// use inbetween::keyframe::{Keyframe, KeyframeIndex, KeyframeList};
/// use inbetween::pose::Pose;
///
/// let mut list = KeyframeList::new(vec![Keyframe::new(Pose::identity(22))]);
/// list.insert_after_current(Keyframe::new(Pose::identity(22)));
/// assert_eq!((list.len(), list.current()), (2, Some(KeyframeIndex::new(1))));
/// ```
#[derive(Clone, Debug, Default)]
pub struct KeyframeList {
    stored: Arc<Stored>,
    current: Option<KeyframeIndex>,
}

impl KeyframeList {
    /// A list of these keyframes, the first of them current.
    #[must_use]
    pub fn new(keyframes: Vec<Keyframe>) -> Self {
        let current = (!keyframes.is_empty()).then_some(KeyframeIndex(0));
        let control_points = (0..keyframes.len()).map(|_| OnceLock::new()).collect();
        Self { stored: Arc::new(Stored { keyframes, control_points, timing: OnceLock::new() }), current }
    }

    /// A list of these keyframes with a current one. It must be `None` if and only if there are no keyframes.
    #[must_use]
    pub fn with_current(keyframes: Vec<Keyframe>, current: Option<usize>) -> Self {
        debug_assert_eq!(current.is_none(), keyframes.is_empty(), "a list has a current keyframe unless it is empty");
        Self { current: current.map(KeyframeIndex), ..Self::new(keyframes) }
    }

    /// How many keyframes there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.stored.keyframes.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.stored.keyframes.is_empty()
    }

    /// All keyframes, in order.
    #[must_use]
    pub fn as_slice(&self) -> &[Keyframe] {
        &self.stored.keyframes
    }

    /// The keyframe with this index, if there is one.
    #[must_use]
    pub fn get(&self, index: KeyframeIndex) -> Option<&Keyframe> {
        self.stored.keyframes.get(index.0)
    }

    /// The index of the current keyframe; `None` only if the list is empty.
    #[must_use]
    pub const fn current(&self) -> Option<KeyframeIndex> {
        self.current
    }

    /// The current keyframe; `None` in an empty list.
    #[must_use]
    pub fn current_keyframe(&self) -> Option<&Keyframe> {
        self.get(self.current?)
    }

    /// The last index; `None` if the list is empty.
    #[must_use]
    pub fn last(&self) -> Option<KeyframeIndex> {
        self.len().checked_sub(1).map(KeyframeIndex)
    }

    /// Makes a keyframe current. Returns false and changes nothing if there is no such keyframe.
    pub fn set_current(&mut self, index: KeyframeIndex) -> bool {
        let exists = index.0 < self.len();
        if exists {
            self.current = Some(index);
        }
        exists
    }

    /// Inserts a keyframe right after the current one, or as the only one, and makes it current.
    pub fn insert_after_current(&mut self, keyframe: Keyframe) -> KeyframeIndex {
        self.insert(KeyframeIndex(self.current.map_or(0, |current| current.0 + 1)), keyframe)
    }

    /// Inserts a keyframe before `index`, which is at most the list's length, and makes it current.
    pub fn insert(&mut self, index: KeyframeIndex, keyframe: Keyframe) -> KeyframeIndex {
        let mut keyframes = self.stored.keyframes.clone();
        keyframes.insert(index.0, keyframe);
        *self = Self::with_current(keyframes, Some(index.0));
        index
    }

    /// Replaces a keyframe, which must exist. The current keyframe stays current.
    pub fn replace(&mut self, index: KeyframeIndex, keyframe: Keyframe) {
        let mut keyframes = self.stored.keyframes.clone();
        keyframes[index.0] = keyframe;
        *self = Self::with_current(keyframes, self.current.map(KeyframeIndex::get));
    }

    /// Removes the current keyframe and returns its index. The keyframe before it becomes current, or the new first one.
    pub fn delete_current(&mut self) -> Option<KeyframeIndex> {
        let removed = self.current?;
        let mut keyframes = self.stored.keyframes.clone();
        keyframes.remove(removed.0);
        let current = (!keyframes.is_empty()).then(|| removed.0.saturating_sub(1));
        *self = Self::with_current(keyframes, current);
        Some(removed)
    }

    /// When each played keyframe is reached; `None` for a list that is too short to play. Computed once for each state of the list.
    #[must_use]
    pub fn timing(&self) -> Option<&Timing> {
        self.stored.timing.get_or_init(|| Timing::of(&self.stored.keyframes)).as_ref()
    }

    /// The control points of the interval from keyframe `start` to the one after it, both of which must have another neighbour.
    ///
    /// Computed once for each state of the list.
    pub(super) fn control_points(&self, start: KeyframeIndex) -> &IntervalControlPoints {
        let start = start.0;
        self.stored.control_points[start].get_or_init(|| {
            let pose = |index: usize| self.stored.keyframes[index].pose.to_vec();
            let (before, from, to, after) = (pose(start - 1), pose(start), pose(start + 1), pose(start + 2));
            let duration = |index: usize| self.stored.keyframes[index].duration;
            let divisors = TangentDivisors::of([duration(start - 1), duration(start), duration(start + 1)]);
            let points = |rbt: usize| rbt_control_points([before[rbt], from[rbt], to[rbt], after[rbt]], divisors);
            let (after_start, before_end): (Vec<_>, Vec<_>) =
                (0..from.len()).map(points).map(|points| (points.after_start, points.before_end)).unzip();
            ControlPoints { after_start: Pose::new(after_start), before_end: Pose::new(before_end) }
        })
    }

    /// Whether the two lists share storage. If so they hold the same keyframes; the check takes constant time.
    #[must_use]
    pub fn shares_with(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.stored, &other.stored)
    }

    /// Whether two lists hold the same keyframes, regardless of the current one. Constant time if they share storage.
    #[must_use]
    pub fn same_keyframes(&self, other: &Self) -> bool {
        self.shares_with(other)
            || (self.len() == other.len() && self.as_slice().iter().zip(other.as_slice()).all(|(a, b)| a.same_as(b)))
    }
}

impl PartialEq for KeyframeList {
    fn eq(&self, other: &Self) -> bool {
        self.current == other.current && self.same_keyframes(other)
    }
}
