//! Submissions whose keyframes are the same: a hint for a person, and no more.

use super::super::marks::Marks;
use super::super::rubric::Rubric;
use crate::animation_diff::distances;
use crate::keyframe::KeyframeList;

/// Keyframes that differ by no more are the same: texts print six decimals or fewer. In scene units and degrees.
const ROUNDING: (f64, f64) = (2e-4, 0.03);

/// The groups of submissions whose keyframes are equal within rounding, as indices, in order. Those that are the reference's do not count:
/// there, all right submissions are alike. Nor do lists without keyframes.
pub fn groups(all: &[Marks], rubric: &Rubric) -> Vec<Vec<usize>> {
    let reference = rubric.reference.as_ref().map(|reference| &reference.list);
    let mut groups: Vec<(&KeyframeList, Vec<usize>)> = Vec::new();
    for (index, marks) in all.iter().enumerate() {
        let Some(list) = marks.keyframes.as_ref().filter(|list| !list.is_empty()) else { continue };
        if reference.is_some_and(|reference| are_equal(list, reference)) {
            continue;
        }
        match groups.iter_mut().find(|(first, _)| are_equal(first, list)) {
            Some((_, group)) => group.push(index),
            None => groups.push((list, vec![index])),
        }
    }
    groups.into_iter().map(|(_, group)| group).filter(|group| group.len() > 1).collect()
}

fn are_equal(one: &KeyframeList, other: &KeyframeList) -> bool {
    let (one, other) = (one.as_slice(), other.as_slice());
    one.len() == other.len()
        && one.iter().zip(other).all(|(one, other)| {
            one.pose.len() == other.pose.len()
                && one.pose.iter().zip(other.pose.iter()).all(|(one, other)| {
                    let (units, degrees) = distances(one, other);
                    units <= ROUNDING.0 && degrees <= ROUNDING.1
                })
        })
}
