//! Verdicts on playback: what samples show, or how the keyframes play here where the rubric says so.

use super::{MOST_FRAMES, Marker, NO_REFERENCE, UNREADABLE};
use crate::animation_diff::{Played, frame_times_ms};
use crate::diagnosis::{Diagnosis, Mistake};
use crate::grading::item::{Evidence, ItemKind, Verdict};
use crate::grading::judgement::Judgement;
use crate::grading::off::Off;
use crate::grading::samples::SampleDiagnosis;
use crate::interpolation::Interpolation;
use crate::keyframe::PlayRange;
use crate::pose::RbtIndex;

const HAND_IN: &str = "hand in a CSV file of them, as for diagnose.";

impl Marker<'_> {
    /// Samples of that playback decide; of several files that which earns the most.
    pub(super) fn playback(&self, interpolation: Interpolation) -> Verdict {
        let shown = self.samples.iter().filter(|show| show.interpolation == interpolation);
        let verdicts = shown.map(|show| self.playback_shown(show));
        match verdicts.reduce(|one, other| if other.share > one.share { other } else { one }) {
            Some(verdict) => verdict.by(Evidence::Samples),
            None if self.rubric.assumes_playback => self.assumed(self.playback_of_keyframes(interpolation)),
            None => {
                let playback = ItemKind::Playback(interpolation).title();
                Verdict::unmet(format!("No samples show {playback}: {HAND_IN}"))
            }
        }
    }

    /// A verdict on keyframes in place of samples. It rests on nothing if they cannot be read.
    fn assumed(&self, verdict: Verdict) -> Verdict {
        if self.list().is_some() { verdict.by(Evidence::Assumed) } else { verdict }
    }

    fn playback_shown(&self, show: &SampleDiagnosis) -> Verdict {
        let playback = match &show.playback {
            Ok(playback) => playback,
            Err(problem) => return Verdict::unmet(format!("{}: {problem}.", show.file)),
        };
        let mut reason = format!("{}: {}", show.file, playback.reason(self.scene, self.rubric));
        if let (false, Ok(diagnosis)) = (playback.is_right(), &show.diagnosis) {
            reason.push(' ');
            reason.push_str(&explanation(diagnosis, show.explains_own));
        }
        Verdict::share(playback.share(self.rubric), reason)
    }

    /// How this program plays the keyframes, beside how it plays the reference's.
    fn playback_of_keyframes(&self, interpolation: Interpolation) -> Verdict {
        let Some(list) = self.list() else { return Verdict::unmet(UNREADABLE) };
        let range = match PlayRange::new(list) {
            Ok(range) => range,
            Err(error) => return Verdict::unmet(format!("{error}.")),
        };
        let Some(reference) = &self.rubric.reference else { return Verdict::unmet(NO_REFERENCE) };
        if self.follows_through {
            return Verdict::met("Its own keyframes play, and they lost their points already.");
        }
        let (expected, ms_between_keyframes) = (reference.range(), reference.ms_between_keyframes);
        let played = |range| Played { range, interpolation, ms_between_keyframes };
        let (right, own) = (played(&expected), played(&range));
        let times = frame_times_ms(&right.length_ms(), self.rubric.fps, MOST_FRAMES);
        let Some(times) = times.filter(|times| times.len() <= MOST_FRAMES) else {
            return Verdict::unmet(format!("More than {MOST_FRAMES} frames to compare."));
        };
        let credit = &self.rubric.credit;
        let mut judgement = Judgement::default();
        for ms in &times {
            let (shown, pose) = match (own.pose_at(ms), right.pose_at(ms)) {
                (Ok(shown), Ok(pose)) => (shown, pose),
                (Err(error), _) | (_, Err(error)) => return Verdict::unmet(format!("{error}.")),
            };
            let key_time = right.key_time_at(ms);
            for (node, (shown, pose)) in shown.iter().zip(pose.iter()).enumerate() {
                judgement.take(key_time, RbtIndex::new(node), Off::between(shown, pose), credit);
            }
        }
        let judgement = judgement.closed();
        let clause = judgement.clause(self.scene, credit);
        Verdict::share(judgement.share(credit), format!("Its keyframes, played by Inbetween: {clause}."))
    }

    /// Where the samples begin and end; without any, whether the ends of the keyframes are the reference's.
    pub(super) fn range_and_end(&self) -> Verdict {
        let of_file = |show: &SampleDiagnosis| match &show.playback {
            Ok(playback) => Verdict::share(playback.ends.share, format!("{}: {}.", show.file, playback.ends.clause)),
            Err(problem) => Verdict::unmet(format!("{}: {problem}.", show.file)),
        };
        // Every playback has to begin and end where it should.
        let verdicts = self.samples.iter().map(of_file);
        match verdicts.reduce(|one, other| if other.share < one.share { other } else { one }) {
            Some(verdict) => verdict.by(Evidence::Samples),
            None if self.rubric.assumes_playback => self.assumed(self.range_of_keyframes()),
            None => Verdict::unmet(format!("No samples show where playback begins and ends: {HAND_IN}")),
        }
    }

    fn range_of_keyframes(&self) -> Verdict {
        if self.follows_through && self.list().is_some_and(|list| PlayRange::new(list).is_ok()) {
            return Verdict::met("Its own keyframes play, and they lost their points already.");
        }
        self.keyframes.ends()
    }
}

/// What the diagnosis says of samples that are not right: a sentence. It earns and costs no points.
fn explanation(diagnosis: &Diagnosis, explains_own: bool) -> String {
    let best = diagnosis.best();
    if !diagnosis.is_explained() {
        return "None of the known mistakes explains it.".to_owned();
    }
    if best.is_right() {
        let whose = if explains_own { "the submission's own keyframes" } else { "the reference" };
        return format!("Diagnosis: {}. It is right playback of {whose}.", best.name);
    }
    let advice = |mistake: &&Mistake| format!("{} {}", mistake.what, mistake.change).trim_end().to_owned();
    let advice: Vec<String> = best.mistakes.iter().map(advice).collect();
    format!("Diagnosis: {}. {}", best.name, advice.join(" "))
}
