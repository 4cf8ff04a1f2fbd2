//! Verdicts on the keyframes themselves.

use super::{NO_REFERENCE, UNREADABLE};
use crate::grading::alignment::alignment;
use crate::grading::item::{ItemKind, Verdict};
use crate::grading::off::Off;
use crate::grading::rubric::Rubric;
use crate::keyframe::KeyframeList;
use crate::pose::Pose;
use crate::scene::SceneGraph;

/// A submission's keyframes beside the reference's.
pub struct ComparedKeyframes<'a> {
    rubric: &'a Rubric,
    scene: &'a SceneGraph,
    list: Option<&'a KeyframeList>,
    /// For each of the reference's keyframes one of the submission's.
    compared: Vec<Option<usize>>,
}

impl<'a> ComparedKeyframes<'a> {
    /// `list` is `None` if the keyframes cannot be read.
    pub fn new(list: Option<&'a KeyframeList>, rubric: &'a Rubric, scene: &'a SceneGraph) -> Self {
        let compared = match (list, &rubric.reference) {
            (Some(list), Some(reference)) => alignment(&reference.list, list, &rubric.credit),
            _ => Vec::new(),
        };
        Self { rubric, scene, list, compared }
    }

    /// Whether an item about keyframes lost points.
    pub fn have_lost(&self) -> bool {
        self.rubric.items().any(|(kind, _)| match kind {
            ItemKind::KeyframeCount => !self.count().is_met(),
            ItemKind::Keyframe(index) => !self.keyframe(index).is_met(),
            _ => false,
        })
    }

    pub fn count(&self) -> Verdict {
        let Some(list) = self.list else { return Verdict::unmet(UNREADABLE) };
        let Some(reference) = &self.rubric.reference else { return Verdict::unmet(NO_REFERENCE) };
        let (found, expected) = (list.len(), reference.list.len());
        if found == expected {
            Verdict::met(format!("{found} keyframes."))
        } else {
            Verdict::unmet(format!("{found} keyframes, expected {expected}."))
        }
    }

    pub fn keyframe(&self, index: usize) -> Verdict {
        let Some(list) = self.list else { return Verdict::unmet(UNREADABLE) };
        let Some(reference) = &self.rubric.reference else { return Verdict::unmet(NO_REFERENCE) };
        let is_aligned = self.rubric.credit.align_keyframes;
        match self.compared.get(index).copied().flatten() {
            None if is_aligned => Verdict::unmet("No keyframe of the submission stands in its place."),
            None => Verdict::unmet("It is not there."),
            Some(found) => {
                let (shown, right) = (&list.as_slice()[found].pose, &reference.list.as_slice()[index].pose);
                let verdict = self.same_pose(shown, right);
                if !is_aligned {
                    return verdict;
                }
                let reason = format!("Compared with keyframe {found} of the submission. {}", verdict.reason);
                Verdict { reason, ..verdict }
            }
        }
    }

    /// Whether the first and the last played keyframe are the reference's.
    pub fn ends(&self) -> Verdict {
        let Some(list) = self.list else { return Verdict::unmet(UNREADABLE) };
        let Some(reference) = &self.rubric.reference else { return Verdict::unmet(NO_REFERENCE) };
        let (keyframes, expected) = (list.as_slice(), reference.list.as_slice());
        if keyframes.len() != expected.len() {
            let (found, expected) = (keyframes.len(), expected.len());
            return Verdict::unmet(format!("{found} keyframes play another range than {expected}."));
        }
        let last = expected.len() - 2;
        let ends = [("first", 1), ("last", last)].map(|(what, index)| {
            let verdict = self.same_pose(&keyframes[index].pose, &expected[index].pose);
            Verdict { reason: format!("The {what} played keyframe, {index}: {}", verdict.reason), ..verdict }
        });
        let worse = ends.into_iter().reduce(|one, other| if other.share < one.share { other } else { one });
        match worse {
            Some(worse) if !worse.is_met() => worse,
            _ => Verdict::met(format!("It plays from keyframe 1 to keyframe {last}.")),
        }
    }

    fn same_pose(&self, found: &Pose, expected: &Pose) -> Verdict {
        let credit = &self.rubric.credit;
        // The worst error in units of the tolerances need not be the one of the lowest band.
        let mut share = 1.0_f64;
        let mut worst: Option<(Off, &str)> = None;
        for ((found, expected), path) in found.iter().zip(expected.iter()).zip(self.scene.rbt_paths()) {
            let off = Off::between(found, expected);
            let of_node = off.share(credit);
            if of_node < 1.0 && worst.is_none_or(|(worst, _)| off.is_worse_than(&worst, credit)) {
                worst = Some((off, path));
            }
            share = share.min(of_node);
        }
        let Some((off, path)) = worst else { return Verdict::met("As in the reference.") };
        let part = if off.is_turn(credit) { "rotation" } else { "translation" };
        Verdict::share(share, format!("The {part} of {path} is {} off.", off.amount(credit)))
    }
}
