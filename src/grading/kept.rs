//! Marks and pictures as they are kept between runs: what follows from the contents of a submission, and not from its name.

use serde::{Deserialize, Serialize};

use super::finding::{Answer, Finding, SampleFinding};
use super::item::{Evidence, Item};
use super::marks::Marks;
use super::note::Note;
use super::rubric::Rubric;
use super::studio::ReportPicture;
use super::submission::Submission;
use crate::diagnosis::mistakes;
use crate::interpolation::Interpolation;
use crate::keyframe::{Easing, Keyframe, KeyframeList};
use crate::pose::Pose;
use crate::rbt::Rbt;

/// The marks and pictures of a submission.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Kept {
    /// Points, reason and evidence of each item of the rubric.
    items: Vec<(f64, String, Option<String>)>,
    samples: Vec<KeptSamples>,
    keyframe_file: Option<String>,
    keyframes: Option<Vec<KeptKeyframe>>,
    /// The text, and whether it wants a look.
    notes: Vec<(String, bool)>,
    /// Why no keyframes could be read.
    unread: Option<String>,
    pictures: Option<Vec<ReportPicture>>,
}

#[derive(Deserialize, Serialize)]
struct KeptSamples {
    file: String,
    playback: String,
    finding: Result<KeptFinding, String>,
}

/// Whether it is explained; name, residual and playback of each answer.
type KeptFinding = (bool, Vec<(String, f64, String)>);

#[derive(Deserialize, Serialize)]
struct KeptKeyframe {
    /// Seven numbers a node, as their bits: nothing is rounded.
    bits: Vec<u32>,
    name: Option<String>,
    duration: f64,
    easing: String,
}

impl Kept {
    /// What is kept of a submission.
    pub fn of(marks: &Marks) -> Self {
        let item = |item: &Item| {
            let evidence = item.evidence.map(|evidence| evidence.id().to_owned());
            (item.points, item.reason.clone(), evidence)
        };
        let samples = |samples: &SampleFinding| {
            let answer =
                |answer: &Answer| (answer.name.clone(), answer.residual, answer.interpolation.name().to_owned());
            let finding = samples.diagnosis.as_ref().map_err(Clone::clone);
            KeptSamples {
                file: samples.file.clone(),
                playback: samples.interpolation.name().to_owned(),
                finding: finding.map(|found| (found.is_explained, found.answers.iter().map(answer).collect())),
            }
        };
        let keyframe = |keyframe: &Keyframe| KeptKeyframe {
            bits: keyframe.pose.iter().flat_map(bits).collect(),
            name: keyframe.name.as_deref().map(str::to_owned),
            duration: keyframe.duration,
            easing: keyframe.easing.name().to_owned(),
        };
        Self {
            items: marks.items.iter().map(item).collect(),
            samples: marks.samples.iter().map(samples).collect(),
            keyframe_file: marks.keyframe_file.clone(),
            keyframes: marks.keyframes.as_ref().map(|list| list.as_slice().iter().map(keyframe).collect()),
            notes: marks.notes.iter().map(|note| (note.text.clone(), note.wants_a_look)).collect(),
            unread: marks.unread.clone(),
            pictures: marks.pictures.clone(),
        }
    }

    /// The marks of a submission with the same contents; `None` if they do not fit the rubric.
    pub fn restored(self, submission: &Submission, rubric: &Rubric) -> Option<Marks> {
        let kinds: Vec<_> = rubric.items().collect();
        if kinds.len() != self.items.len() {
            return None;
        }
        let items = kinds.into_iter().zip(self.items).map(|((kind, out_of), (points, reason, evidence))| {
            let evidence = evidence.map(|id| Evidence::from_id(&id).ok_or(())).transpose().ok()?;
            Some(Item { kind, points, out_of, reason, evidence, is_by_hand: false })
        });
        let keyframes = self.keyframes.map(|all| {
            let all: Option<_> = all.into_iter().map(KeptKeyframe::restored).collect();
            all.map(KeyframeList::new).ok_or(())
        });
        Some(Marks {
            items: items.collect::<Option<_>>()?,
            samples: self.samples.into_iter().map(KeptSamples::restored).collect::<Option<_>>()?,
            keyframe_file: self.keyframe_file,
            unread: self.unread,
            keyframes: keyframes.transpose().ok()?,
            notes: self.notes.into_iter().map(|(text, wants_a_look)| Note { text, wants_a_look }).collect(),
            pictures: self.pictures,
            ..Marks::unmarked(submission)
        })
    }
}

impl KeptSamples {
    fn restored(self) -> Option<SampleFinding> {
        let diagnosis = match self.finding {
            Ok((is_explained, answers)) => {
                let answers = answers.into_iter().map(|(name, residual, playback)| {
                    let known = |name: &str| mistakes().find(|mistake| mistake.name == name);
                    let mistakes = name.split(" + ").map(known).collect::<Option<_>>()?;
                    Some(Answer { residual, mistakes, interpolation: Interpolation::from_name(&playback)?, name })
                });
                let answers: Vec<Answer> = answers.collect::<Option<_>>()?;
                if answers.is_empty() {
                    return None;
                }
                Ok(Finding { is_explained, answers })
            }
            Err(problem) => Err(problem),
        };
        let interpolation = Interpolation::from_name(&self.playback)?;
        Some(SampleFinding { file: self.file, interpolation, diagnosis, shown: None })
    }
}

impl KeptKeyframe {
    fn restored(self) -> Option<Keyframe> {
        let (nodes, rest) = self.bits.as_chunks::<7>();
        if !rest.is_empty() {
            return None;
        }
        let rbts = nodes.iter().map(|bits| {
            let [x, y, z, rx, ry, rz, rw] = bits.map(f32::from_bits);
            Rbt { translation: glam::Vec3::new(x, y, z), rotation: glam::Quat::from_xyzw(rx, ry, rz, rw) }
        });
        let pose = Pose::new(rbts.collect());
        let easing = Easing::from_name(&self.easing)?;
        Some(Keyframe { pose, name: self.name.map(Into::into), duration: self.duration, easing })
    }
}

fn bits(rbt: Rbt) -> [u32; 7] {
    let ([x, y, z], [rx, ry, rz, rw]) = (rbt.translation.to_array(), rbt.rotation.to_array());
    [x, y, z, rx, ry, rz, rw].map(f32::to_bits)
}
