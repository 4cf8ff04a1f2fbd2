//! Verdicts on the items of a rubric.

use super::folder;
use super::item::{ItemKind, Verdict};
use super::parsed::{Parsed, ParsedFile};
use super::rubric::Rubric;
use super::samples::SampleDiagnosis;
use super::trace;
use crate::animation_diff::{Played, compare, distances, frame_times_ms};
use crate::diagnosis::{CORRECT, CORRECT_CATMULL_ROM, Mistake};
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeList, PlayRange};
use crate::pose::Pose;
use crate::scene::SceneGraph;
use crate::script::Line;

/// The most frames at which playback is compared.
const MOST_FRAMES: usize = 20_000;

const UNREADABLE: &str = "The keyframes cannot be read.";
const NO_REFERENCE: &str = "The rubric has no reference.";

/// Everything that verdicts depend on.
pub struct Marker<'a> {
    /// The rubric.
    pub rubric: &'a Rubric,
    /// The scene.
    pub scene: &'a SceneGraph,
    /// The submission.
    pub parsed: &'a Parsed,
    /// What its samples show.
    pub samples: &'a [SampleDiagnosis],
}

impl Marker<'_> {
    /// The verdict on one item.
    pub fn verdict(&self, kind: ItemKind) -> Verdict {
        match kind {
            ItemKind::Readable => self.readable(),
            ItemKind::KeyframeCount => self.count(),
            ItemKind::Keyframe(index) => self.keyframe(index),
            ItemKind::Playback(interpolation) => self.playback(interpolation),
            ItemKind::RangeAndEnd => self.range_and_end(),
            ItemKind::Script => self.script(),
        }
    }

    fn list(&self) -> Option<&KeyframeList> {
        self.parsed.keyframes.as_ref().ok().map(|read| &read.list)
    }

    fn readable(&self) -> Verdict {
        match &self.parsed.keyframes {
            Ok(read) => Verdict::met(format!("{} holds {} keyframes.", read.file, read.list.len())),
            Err(problem) => Verdict::unmet(problem),
        }
    }

    fn count(&self) -> Verdict {
        let Some(list) = self.list() else { return Verdict::unmet(UNREADABLE) };
        let Some(reference) = &self.rubric.reference else { return Verdict::unmet(NO_REFERENCE) };
        let (found, expected) = (list.len(), reference.list.len());
        if found == expected {
            Verdict::met(format!("{found} keyframes."))
        } else {
            Verdict::unmet(format!("{found} keyframes, expected {expected}."))
        }
    }

    fn keyframe(&self, index: usize) -> Verdict {
        let Some(list) = self.list() else { return Verdict::unmet(UNREADABLE) };
        match list.as_slice().get(index) {
            None => Verdict::unmet("It is not there."),
            Some(found) => match &self.rubric.reference {
                Some(reference) => self.same_pose(&found.pose, &reference.list.as_slice()[index].pose),
                None => Verdict::unmet(NO_REFERENCE),
            },
        }
    }

    fn same_pose(&self, found: &Pose, expected: &Pose) -> Verdict {
        let tolerances = self.rubric.tolerances;
        for ((found, expected), path) in found.iter().zip(expected.iter()).zip(self.scene.rbt_paths()) {
            let (translation, degrees) = distances(found, expected);
            if translation > tolerances.translation {
                return Verdict::unmet(format!("The translation of {path} is {translation:.4} units off."));
            }
            if degrees > tolerances.rotation_degrees {
                return Verdict::unmet(format!("The rotation of {path} is {degrees:.3} degrees off."));
            }
        }
        Verdict::met("As in the reference.")
    }

    /// Samples of that playback decide; without any, how the keyframes play here.
    fn playback(&self, interpolation: Interpolation) -> Verdict {
        match self.samples.iter().find(|show| show.interpolation == interpolation) {
            Some(show) => playback_shown(show, interpolation),
            None => self.playback_of_keyframes(interpolation),
        }
    }

    fn playback_of_keyframes(&self, interpolation: Interpolation) -> Verdict {
        let Some(list) = self.list() else { return Verdict::unmet(UNREADABLE) };
        let range = match PlayRange::new(list) {
            Ok(range) => range,
            Err(error) => return Verdict::unmet(format!("{error}.")),
        };
        let Some(reference) = &self.rubric.reference else { return Verdict::unmet(NO_REFERENCE) };
        let (expected, ms_between_keyframes) = (reference.range(), reference.ms_between_keyframes);
        let played = |range| Played { range, interpolation, ms_between_keyframes };
        let (right, own) = (played(&expected), played(&range));
        let times = frame_times_ms(&right.length_ms(), self.rubric.fps, MOST_FRAMES);
        let Some(times) = times.filter(|times| times.len() <= MOST_FRAMES) else {
            return Verdict::unmet(format!("More than {MOST_FRAMES} frames to compare."));
        };
        let difference = match compare(right, own, &times, self.rubric.tolerances) {
            Ok(difference) => difference,
            Err(error) => return Verdict::unmet(error.to_string()),
        };
        let beyond = difference.nodes.iter().zip(self.scene.rbt_paths()).filter_map(|(node, path)| {
            let at =
                [node.translation.exceeds_at, node.rotation.exceeds_at].into_iter().flatten().min_by(f64::total_cmp)?;
            Some((at, path, node))
        });
        match beyond.min_by(|a, b| a.0.total_cmp(&b.0)) {
            None => Verdict::met(format!("Its keyframes play as the reference's over {} frames.", times.len())),
            Some((at, path, node)) => Verdict::unmet(format!(
                "Its keyframes play otherwise from key time {at:.3} on: {path} is up to {:.4} units and {:.3} degrees off.",
                node.translation.largest, node.rotation.largest
            )),
        }
    }

    fn range_and_end(&self) -> Verdict {
        let wrong = self.samples.iter().find_map(|show| {
            let best = show.diagnosis.as_ref().ok().filter(|diagnosis| diagnosis.is_explained())?.best();
            best.is_about_range().then_some((best, &show.file))
        });
        if let Some((best, file)) = wrong {
            let what: Vec<&str> =
                best.mistakes.iter().filter(|mistake| mistake.is_about_range()).map(|m| m.what).collect();
            return Verdict::unmet(format!("{file}: {}. {}", best.name, what.join(" ")));
        }
        let Some(list) = self.list() else { return Verdict::unmet(UNREADABLE) };
        let Some(reference) = &self.rubric.reference else { return Verdict::unmet(NO_REFERENCE) };
        let (keyframes, expected) = (list.as_slice(), reference.list.as_slice());
        if keyframes.len() != expected.len() {
            return Verdict::unmet(format!(
                "{} keyframes play another range than {}.",
                keyframes.len(),
                expected.len()
            ));
        }
        let last = expected.len() - 2;
        for (what, index) in [("first", 1), ("last", last)] {
            let verdict = self.same_pose(&keyframes[index].pose, &expected[index].pose);
            if !verdict.is_met() {
                return Verdict::unmet(format!("The {what} played keyframe, {index}: {}", verdict.reason));
            }
        }
        Verdict::met(format!("It plays from keyframe 1 to keyframe {last}."))
    }

    /// A trace decides; without one the submission's own script, or what the rubric's script does with its keyframes.
    fn script(&self) -> Verdict {
        let Some(script) = &self.rubric.script else { return Verdict::unmet("The rubric has no script.") };
        let expected = match &script.expected {
            Ok(expected) => expected,
            Err(problem) => return Verdict::unmet(problem),
        };
        let (what, problem_at, found) = if let Some(ParsedFile { name, content }) = &self.parsed.trace {
            (name.clone(), name, content.clone())
        } else if let Some(ParsedFile { name, content }) = &self.parsed.script {
            let read = self.parsed.keyframes.as_ref().ok();
            let keyframes = self.parsed.first_keyframe_file.as_deref().map(|bytes| match read {
                Some(read) => read.with_pace_of(self.rubric, self.scene),
                None => bytes.into(),
            });
            let run = |lines: &Vec<Line>| folder::run(lines, self.scene, keyframes.as_deref());
            let ran = content.as_ref().map_err(Clone::clone).and_then(run);
            (name.clone(), name, ran.map(|ran| trace::objects_of(&ran.trace)))
        } else {
            let Ok(read) = &self.parsed.keyframes else { return Verdict::unmet(UNREADABLE) };
            let ran = folder::run(&script.lines, self.scene, Some(&read.with_pace_of(self.rubric, self.scene)));
            (format!("the script with {}", read.file), &read.file, ran.map(|ran| trace::objects_of(&ran.trace)))
        };
        match found {
            Ok(found) => trace::compared(&what, &found, expected),
            Err(problem) => Verdict::unmet(format!("{problem_at}: {problem}.")),
        }
    }
}

/// The verdict on a playback by its samples.
fn playback_shown(show: &SampleDiagnosis, interpolation: Interpolation) -> Verdict {
    let right = match interpolation {
        Interpolation::Linear => CORRECT,
        Interpolation::CatmullRom => CORRECT_CATMULL_ROM,
    };
    let diagnosis = match &show.diagnosis {
        Ok(diagnosis) => diagnosis,
        Err(problem) => return Verdict::unmet(format!("{}: {problem}.", show.file)),
    };
    let best = diagnosis.best();
    let found = format!("{}: {}, residual {:.2e}.", show.file, best.name, best.residual);
    let is_among = |name| diagnosis.candidates[..diagnosis.equals].iter().any(|candidate| candidate.name == name);
    // A missing end is graded with the range.
    if diagnosis.is_explained() && is_among(right) {
        return Verdict::met(found);
    }
    let advice = |mistake: &&Mistake| match mistake.change {
        "" => format!("{} Expected {right}.", mistake.what),
        change => format!("{} {change}", mistake.what),
    };
    Verdict::unmet(if diagnosis.is_explained() {
        let advice: Vec<String> = best.mistakes.iter().map(advice).collect();
        format!("{found} {}", advice.join(" "))
    } else {
        format!(
            "{}: none of the known mistakes explains the samples; {} is nearest, residual {:.2e}.",
            show.file, best.name, best.residual
        )
    })
}
