//! Which mistakes an animation can reveal, and how to change its keyframes so that it reveals the others.
//!
//! A mistake is revealed if a program that makes it shows some node, at some of the key times, farther from the right result than the
//! tolerances. It is hidden if there is one way to make it, in one of the playbacks, that is not revealed.

use std::iter;

use glam::{DQuat, DVec3};

use super::catalogue::{Form, Mistake, forms};
use super::compare::Comparison;
use super::rules::{LINEAR, Rules, SPLINE};
use super::samples::{Row, Tolerances};
use super::sequence::Sequence;
use crate::interpolation::Interpolation;
use crate::pose::RbtIndex;

/// The most changes that are tried for one mistake.
const MOST_TRIES: usize = 3_000;

/// How a playback is judged.
#[derive(Clone, Copy, Debug)]
pub struct Judged<'a> {
    /// The right keyframes.
    pub sequence: &'a Sequence,
    /// The playbacks that are judged.
    pub playbacks: &'a [Interpolation],
    /// The key times that are looked at, in ascending order.
    pub key_times: &'a [f64],
    /// How far translations may be off, in scene units.
    pub units: f64,
    /// How far rotations may be off, in degrees.
    pub degrees: f64,
}

/// A mistake that is not revealed.
#[derive(Clone, Debug)]
pub struct Hidden {
    /// The mistake.
    pub mistake: &'static Mistake,
    /// The playbacks in which it is not revealed.
    pub playbacks: Vec<Interpolation>,
    forms: Vec<Form>,
}

/// A change of one node's keyframes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeyframeChange {
    /// The node.
    pub node: RbtIndex,
    /// The first keyframe that is changed, counted from 0.
    pub first: usize,
    /// The last one.
    pub last: usize,
    /// What is done.
    pub kind: ChangeKind,
}

/// What is done to a node in a keyframe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChangeKind {
    /// The four components of its quaternion get the opposite sign. The pose stays the same.
    OppositeSign,
    /// It is turned about an axis of its own, x, y or z, by this many degrees.
    Turn(char, u16),
    /// Both: it is turned, and its quaternion gets the opposite sign.
    TurnAndOppositeSign(char, u16),
    /// It is turned by this many degrees, about its x axis in the first keyframe and about its y axis in the last.
    TurnAboutTwoAxes(u16),
    /// It is moved along its parent's x axis by this many tenths of a scene unit.
    Move(u16),
    /// Both: it is turned about its x axis by this many degrees, and moved along its parent's x axis by one scene unit.
    TurnAndMove(u16),
}

/// The mistakes that can be made in the playbacks: those that are revealed, and those that are not, in the catalogue's order.
#[must_use]
pub fn revealing(judged: &Judged) -> (Vec<&'static Mistake>, Vec<Hidden>) {
    let (mut revealed, mut hidden): (Vec<&'static Mistake>, Vec<Hidden>) = (Vec::new(), Vec::new());
    for form in forms().filter(|form| judged.playbacks.contains(&interpolation(form))) {
        let mistake = form.entry.mistake;
        if mistake.is_right() {
            continue;
        }
        if judged.reveals(judged.sequence, &form) {
            if revealed.last() != Some(&mistake) {
                revealed.push(mistake);
            }
            continue;
        }
        match hidden.last_mut().filter(|hidden| hidden.mistake == mistake) {
            Some(hidden) => {
                hidden.forms.push(form);
                if !hidden.playbacks.contains(&interpolation(&form)) {
                    hidden.playbacks.push(interpolation(&form));
                }
            }
            None => hidden.push(Hidden { mistake, playbacks: vec![interpolation(&form)], forms: vec![form] }),
        }
    }
    revealed.retain(|mistake| hidden.iter().all(|hidden| hidden.mistake != *mistake));
    (revealed, hidden)
}

/// A change of the keyframes that reveals a hidden mistake; `None` if there is no single one among those that are tried.
#[must_use]
pub fn change_that_reveals(judged: &Judged, hidden: &Hidden) -> Option<KeyframeChange> {
    changes(judged.sequence).take(MOST_TRIES).find(|change| {
        let changed = changed(judged.sequence, change);
        hidden.forms.iter().all(|form| judged.reveals(&changed, form))
    })
}

fn interpolation(form: &Form) -> Interpolation {
    if form.is_spline { Interpolation::CatmullRom } else { Interpolation::Linear }
}

impl Judged<'_> {
    /// Whether a program that makes a mistake in this way shows something else than the right one.
    fn reveals(&self, sequence: &Sequence, form: &Form) -> bool {
        let end = sequence.last_key_time();
        let last_before_end = self.key_times.iter().copied().filter(|key_time| *key_time < end).fold(0.0, f64::max);
        let exact = Tolerances { translation: [0.0; 3], rotation: [0.0; 4] };
        let comparison = Comparison { sequence, tolerances: exact, last_before_end, is_lenient: false };
        let (rules, right) = (form.rules(), if form.is_spline { SPLINE } else { LINEAR });
        let mut places = self
            .key_times
            .iter()
            .flat_map(|key_time| (0..sequence.nodes()).map(move |node| (*key_time, RbtIndex::new(node))));
        places.any(|(key_time, node)| {
            let shown = comparison.row(&rules, None, key_time, node);
            shown.is_some_and(|shown| self.is_off(&comparison, shown, &right))
        })
    }

    /// Whether a row is farther from the right result than the tolerances. Only the direction of a quaternion counts, not its length.
    fn is_off(&self, comparison: &Comparison, mut shown: Row, right: &Rules) -> bool {
        let length = shown.rotation_wxyz.iter().map(|component| component * component).sum::<f64>().sqrt();
        if !shown.translation.is_finite() || !length.is_finite() || length < f64::MIN_POSITIVE {
            return true;
        }
        shown.rotation_wxyz = shown.rotation_wxyz.map(|component| component / length);
        let units = comparison.move_off(&shown, right.timing, right.moves).squared.sqrt();
        // The distance of two unit quaternions is twice the sine of a quarter of the angle.
        let distance = comparison.turn_off(&shown, right.timing, &right.turns).squared.sqrt();
        let degrees = 4.0 * (distance / 2.0).min(1.0).asin().to_degrees();
        units > self.units || degrees > self.degrees
    }
}

/// Changes to try, the simplest first, then those of the nodes that turn most, played keyframes first.
fn changes(sequence: &Sequence) -> impl Iterator<Item = KeyframeChange> + use<> {
    let axes = |kind: fn(char, u16) -> ChangeKind, degrees| ['x', 'y', 'z'].map(|axis| kind(axis, degrees));
    let kinds = iter::once(ChangeKind::OppositeSign)
        .chain([2, 60, 120, 170].into_iter().flat_map(|degrees| axes(ChangeKind::Turn, degrees)))
        .chain(axes(ChangeKind::TurnAndOppositeSign, 60))
        .chain([ChangeKind::TurnAboutTwoAxes(60)])
        .chain([2, 10].map(ChangeKind::Move))
        .chain([ChangeKind::TurnAndMove(60)]);
    let kinds: Vec<ChangeKind> = kinds.collect();
    let last = sequence.keyframes() - 1;
    let places: Vec<(usize, usize)> = (1..last)
        .map(|index| (index, index))
        .chain((1..last - 1).map(|index| (index, index + 1)))
        .chain([(0, 0), (last, last)])
        .collect();
    let nodes = by_turns(sequence);
    kinds.into_iter().flat_map(move |kind| {
        let nodes = nodes.clone();
        places.clone().into_iter().flat_map(move |(first, last)| {
            nodes.clone().into_iter().map(move |node| KeyframeChange { node, first, last, kind })
        })
    })
}

/// The nodes that turn most, and of those that turn least the last: the first nodes of a scene are often its eye and its ground.
fn by_turns(sequence: &Sequence) -> Vec<RbtIndex> {
    const OF_EACH: usize = 4;
    let turns = |node: usize| -> f64 {
        let at = |index: usize| sequence.at(index as isize, RbtIndex::new(node)).rotation;
        (1..sequence.keyframes()).map(|index| 1.0 - at(index - 1).dot(at(index)).abs()).sum()
    };
    let mut nodes: Vec<(f64, usize)> = (0..sequence.nodes()).map(|node| (turns(node), node)).collect();
    nodes.sort_by(|one, other| other.0.total_cmp(&one.0).then(other.1.cmp(&one.1)));
    let count = nodes.len();
    let indices = (0..count).filter(|index| *index < OF_EACH || *index + OF_EACH >= count);
    let resting = nodes.iter().position(|(turns, _)| *turns < 1e-9).unwrap_or(count);
    let indices: Vec<usize> =
        indices.filter(|index| *index < resting).chain(resting..count.min(resting + OF_EACH)).collect();
    indices.into_iter().map(|index| RbtIndex::new(nodes[index].1)).collect()
}

/// A sequence of the changed node alone: what the others show stays as it is.
fn changed(sequence: &Sequence, change: &KeyframeChange) -> Sequence {
    sequence.of_node(change.node, |index, transform| {
        if !(change.first..=change.last).contains(&index) {
            return;
        }
        let turned = |axis: char, degrees: u16| {
            let axis = match axis {
                'x' => DVec3::X,
                'y' => DVec3::Y,
                _ => DVec3::Z,
            };
            transform.rotation * DQuat::from_axis_angle(axis, f64::from(degrees).to_radians())
        };
        match change.kind {
            ChangeKind::OppositeSign => transform.rotation = -transform.rotation,
            ChangeKind::Turn(axis, degrees) => transform.rotation = turned(axis, degrees),
            ChangeKind::TurnAndOppositeSign(axis, degrees) => transform.rotation = -turned(axis, degrees),
            ChangeKind::TurnAboutTwoAxes(degrees) => {
                transform.rotation = turned(if index == change.first { 'x' } else { 'y' }, degrees);
            }
            ChangeKind::TurnAndMove(degrees) => {
                transform.rotation = turned('x', degrees);
                transform.translation.x += 1.0;
            }
            ChangeKind::Move(tenths) => transform.translation.x += f64::from(tenths) / 10.0,
        }
    })
}

#[cfg(test)]
mod tests;
