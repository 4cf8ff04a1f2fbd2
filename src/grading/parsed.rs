//! Classifies and parses the files of a submission, each once.

use std::borrow::Cow;

use serde_json::Value;

use super::content::{Content, Unreadable, content_of};
use super::folder;
use super::names::{PreferredNames, ending, has_ending_of_results, has_keyframe_ending, speaks_of_keyframes};
use super::note::Note;
use super::rubric::Rubric;
use super::submission::{Contents, Member, Skipped, Why, shortly, skipped_notes};
use super::trace;
use crate::diagnosis::SampleRows;
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeFile, KeyframeList, keyframes_to_json};
use crate::scene::SceneGraph;
use crate::script::Line;
use crate::text::counted;
use crate::text_layouts::read_keyframes;

/// The largest file of samples in a submission, in bytes.
const LARGEST_SAMPLES_BYTES: usize = 4 << 20;
/// The most files of samples in a submission.
pub const MOST_SAMPLES: usize = 4;
/// The most keyframes in a submission.
const MOST_KEYFRAMES: usize = 2_000;

/// The parsed content of a file, or why it cannot be read.
#[derive(Clone, Debug)]
pub struct ParsedFile<T> {
    /// Its path in the submission.
    pub name: String,
    /// What it holds, or a sentence.
    pub content: Result<T, String>,
}

/// Keyframes that were read.
#[derive(Clone, Debug)]
pub struct ParsedKeyframes {
    /// The file that they are from, or the script that made them.
    pub file: String,
    /// The bytes of that file; of a script, a keyframe file of what it made.
    pub bytes: Vec<u8>,
    /// What was inferred of a text's layout.
    pub inferred: Option<Note>,
    /// The keyframes.
    pub list: KeyframeList,
    /// How the file says that they are interpolated.
    pub interpolation: Interpolation,
    /// Milliseconds between keyframes.
    pub ms_between_keyframes: u32,
    /// The interpolation and the milliseconds, each where the file holds it. No text does.
    pub held: (Option<Interpolation>, Option<u32>),
}

impl ParsedKeyframes {
    /// How the keyframes play: the interpolation and the milliseconds between them. What the file does not hold is as in the reference,
    /// if there is one.
    #[must_use]
    pub fn pace(&self, rubric: &Rubric) -> (Interpolation, u32) {
        let usual = rubric.reference.as_ref().map_or((self.interpolation, self.ms_between_keyframes), |reference| {
            (reference.interpolation, reference.ms_between_keyframes)
        });
        (self.held.0.unwrap_or(usual.0), self.held.1.unwrap_or(usual.1))
    }

    /// A keyframe file of these keyframes. What the file does not hold is as in the reference, if there is one: nobody can hand it in by such a file.
    #[must_use]
    pub fn with_pace_of(&self, rubric: &Rubric, scene: &SceneGraph) -> Cow<'_, [u8]> {
        if let (Some(_), Some(_)) = self.held {
            return Cow::Borrowed(&self.bytes);
        }
        let (interpolation, ms) = self.pace(rubric);
        keyframes_to_json(scene, &self.list, interpolation, ms).into_bytes().into()
    }
}

/// A submission, parsed.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// Why none of its files could be read.
    pub problem: Option<String>,
    /// The keyframes of the likeliest file that holds some; without such a file, those that the script makes.
    pub keyframes: Result<ParsedKeyframes, String>,
    /// The bytes of that keyframe file, or of the likeliest that cannot be read: what the submission's own script reads.
    pub first_keyframe_file: Option<Vec<u8>>,
    /// Samples of playback, at most `MOST_SAMPLES` files.
    pub samples: Vec<ParsedFile<SampleRows>>,
    /// How many files of samples there are.
    pub samples_count: usize,
    /// The likeliest hotkey script.
    pub script: Option<ParsedFile<Vec<Line>>>,
    /// The likeliest trace of a script: its objects.
    pub trace: Option<ParsedFile<Vec<Value>>>,
    /// What else was found, and what was skipped.
    pub notes: Vec<Note>,
}

/// A file that holds no keyframes, as they may have been meant.
struct Failed {
    member: Member,
    why: Unreadable,
}

impl Failed {
    /// Whether it is to blame where there are no keyframes.
    fn is_to_blame(&self, preferred: &PreferredNames) -> bool {
        let (name, why) = (&self.member.name, &self.why);
        let is_named_so = has_keyframe_ending(name) && (speaks_of_keyframes(name) || why.is_empty);
        why.is_alike || (is_named_so && !why.is_source) || preferred.fit(name)
    }

    /// Those that are likelier to be meant come first.
    fn rank(&self, preferred: &PreferredNames) -> impl Ord + use<> {
        let (name, why) = (&self.member.name, &self.why);
        let is_no_match = (!has_keyframe_ending(name), !speaks_of_keyframes(name), !why.is_alike);
        (preferred.place(name), is_no_match, preferred.rank(name))
    }
}

/// The files of a submission by what they are.
#[derive(Default)]
struct Sorted {
    /// The keyframe file to grade, with what was inferred.
    best: Option<(Member, KeyframeFile, Option<Note>)>,
    /// The place of the best's name among the rubric's.
    place: usize,
    /// Other keyframe files: their names and numbers of keyframes.
    others: Vec<(String, usize)>,
    failed: Vec<Failed>,
    samples: Vec<Member>,
    scripts: Vec<Member>,
    traces: Vec<Member>,
}

impl Sorted {
    /// Sorts files that come in their order of rank.
    fn new(members: Vec<Member>, preferred: &PreferredNames, scene: &SceneGraph) -> Self {
        let mut sorted = Self::default();
        for member in members {
            match content_of(&member.bytes, scene) {
                Content::Samples => sorted.samples.push(member),
                Content::Trace => sorted.traces.push(member),
                Content::Script => sorted.scripts.push(member),
                // Nothing else is named so.
                Content::Unreadable(why) if !why.is_alike && ending(&member.name) == "jsonl" => {
                    sorted.traces.push(member);
                }
                Content::Unreadable(why) => sorted.failed.push(Failed { member, why }),
                Content::Keyframes(file, inferred) => sorted.add_keyframes(member, file, inferred, preferred),
            }
        }
        sorted.failed.sort_by_cached_key(|failed| failed.rank(preferred));
        sorted
    }

    fn add_keyframes(
        &mut self,
        member: Member,
        file: KeyframeFile,
        inferred: Option<Note>,
        preferred: &PreferredNames,
    ) {
        let count = file.keyframes.len();
        if count > MOST_KEYFRAMES {
            let problem = format!("{count} keyframes, and at most {MOST_KEYFRAMES} are graded");
            self.failed.push(Failed {
                member,
                why: Unreadable { problem, is_empty: false, is_alike: true, is_source: false },
            });
            return;
        }
        let place = preferred.place(&member.name);
        match &mut self.best {
            // One without keyframes gives way to one that has some, where the rubric prefers neither.
            Some((_, best, _)) if place > self.place || !best.keyframes.is_empty() || count == 0 => {
                self.others.push((member.name, count));
            }
            Some(best) => {
                let (before, ..) = std::mem::replace(best, (member, file, inferred));
                self.others.push((before.name, 0));
            }
            None => {
                self.best = Some((member, file, inferred));
                self.place = place;
            }
        }
    }

    /// Sentences about what was found beside the files that are graded.
    fn notes(&self, preferred: &PreferredNames) -> Vec<Note> {
        let mut notes = Vec::new();
        if let Some((best, ..)) = &self.best
            && !self.others.is_empty()
        {
            let others = self.others.iter().map(|(name, count)| format!("{name} ({})", counted(*count, "keyframe")));
            let others: Vec<String> = others.collect();
            let text = format!("The keyframes are those of {}; also found: {}.", best.name, shortly(&others));
            notes.push(Note::to_look_at(text));
        }
        for (what, files) in [("script", &self.scripts), ("trace", &self.traces)] {
            if let [first, others @ ..] = files.as_slice()
                && !others.is_empty()
            {
                let others: Vec<&str> = others.iter().map(|member| member.name.as_str()).collect();
                let text = format!("The {what} is {}; also found: {}.", first.name, shortly(&others));
                notes.push(Note::to_look_at(text));
            }
        }
        if self.best.is_some() {
            let (alike, others): (Vec<&Failed>, Vec<&Failed>) =
                self.failed.iter().partition(|failed| failed.is_to_blame(preferred));
            if let [first, more @ ..] = alike.as_slice() {
                let more: Vec<&str> = more.iter().map(|failed| failed.member.name.as_str()).collect();
                let more = if more.is_empty() { String::new() } else { format!("; nor {}", shortly(&more)) };
                let text = format!("{} cannot be read as keyframes: {}{more}.", first.member.name, first.why.problem);
                notes.push(Note::to_look_at(text));
            }
            let others: Vec<&str> = others.iter().map(|failed| failed.member.name.as_str()).collect();
            if !others.is_empty() {
                let wants_a_look = others.iter().any(|name| has_ending_of_results(name));
                let text = format!("Neither keyframes, samples, trace nor script: {}.", shortly(&others));
                notes.push(Note { text, wants_a_look });
            }
        }
        notes
    }
}

impl Parsed {
    /// Classifies and parses the files of a submission.
    #[must_use]
    pub fn new(contents: Contents, preferred: &PreferredNames, scene: &SceneGraph) -> Self {
        let Contents { members, skipped, problem } = contents;
        let sorted = Sorted::new(members, preferred, scene);
        let mut notes = sorted.notes(preferred);
        notes.extend(skipped_notes(&skipped));
        let Sorted { best, failed, samples, scripts, traces, .. } = sorted;
        let samples_count = samples.len();
        let samples = samples.into_iter().take(MOST_SAMPLES);
        let samples = samples.map(|Member { name, bytes }| ParsedFile { name, content: samples_of(&bytes, scene) });
        let script = scripts.into_iter().next();
        let script =
            script.map(|Member { name, bytes }| ParsedFile { name, content: folder::read_script(&bytes, scene) });
        let trace = traces.into_iter().next();
        let trace = trace.map(|Member { name, bytes }| ParsedFile { name, content: trace::objects(&bytes) });
        let blamed = failed.iter().find(|failed| failed.is_to_blame(preferred));
        let first_unreadable = blamed.map(|failed| failed.member.bytes.clone());
        let keyframes = match (best, blamed, &script) {
            (Some((member, file, inferred)), ..) => Ok(graded(member, file, inferred)),
            (None, Some(Failed { member, why }), _) => Err(format!("{}: {}", member.name, why.problem)),
            (None, None, Some(script)) => keyframes_made(script, scene),
            // If the files cannot be read, that is the reason for missing keyframes.
            (None, None, None) => Err(problem.clone().unwrap_or_else(|| reason_for_none(&failed, &skipped))),
        };
        let first_keyframe_file = keyframes.as_ref().ok().map(|read| read.bytes.clone()).or(first_unreadable);
        let first_keyframe_file = first_keyframe_file.filter(|_| keyframes_are_of_a_file(&keyframes, script.as_ref()));
        Self {
            problem,
            keyframes,
            first_keyframe_file,
            samples: samples.collect(),
            samples_count,
            script,
            trace,
            notes,
        }
    }
}

impl Parsed {
    /// What the script that was handed in does with the keyframes that were handed in; `None` without a script.
    #[must_use]
    pub fn ran(&self, rubric: &Rubric, scene: &SceneGraph) -> Option<Result<folder::Ran, String>> {
        let script = self.script.as_ref()?;
        let read = self.keyframes.as_ref().ok();
        let keyframes = self.first_keyframe_file.as_deref().map(|bytes| match read {
            Some(read) => read.with_pace_of(rubric, scene),
            None => bytes.into(),
        });
        let lines = script.content.as_ref().map_err(Clone::clone);
        Some(lines.and_then(|lines| folder::run(lines, scene, keyframes.as_deref())))
    }
}

/// Whether keyframes are from a file and not made by the script, which begins without a keyframe file.
fn keyframes_are_of_a_file(
    keyframes: &Result<ParsedKeyframes, String>,
    script: Option<&ParsedFile<Vec<Line>>>,
) -> bool {
    !matches!((keyframes, script), (Ok(read), Some(script)) if read.file == script.name)
}

fn graded(member: Member, file: KeyframeFile, inferred: Option<Note>) -> ParsedKeyframes {
    let Member { name, bytes } = member;
    let inferred = inferred.map(|Note { text, wants_a_look }| Note { text: format!("{name}: {text}"), wants_a_look });
    let held = (file.interpolation, file.ms_between_keyframes);
    let (list, interpolation, ms_between_keyframes) = file.into_parts();
    ParsedKeyframes { file: name, bytes, inferred, list, interpolation, ms_between_keyframes, held }
}

fn samples_of(bytes: &[u8], scene: &SceneGraph) -> Result<SampleRows, String> {
    if bytes.len() > LARGEST_SAMPLES_BYTES {
        return Err(format!("{} bytes, and at most {LARGEST_SAMPLES_BYTES} are read", bytes.len()));
    }
    SampleRows::from_csv(bytes, scene.rbt_count()).map_err(|error| error.to_string())
}

/// The keyframes that a script makes.
fn keyframes_made(script: &ParsedFile<Vec<Line>>, scene: &SceneGraph) -> Result<ParsedKeyframes, String> {
    let ParsedFile { name, content } = script;
    let located = |problem: String| format!("{name}: {problem}");
    let lines = content.as_ref().map_err(|problem| located(problem.clone()))?;
    let bytes = folder::run(lines, scene, None).map_err(located)?.keyframe_file();
    let read = read_keyframes(&bytes, scene).map_err(|problems| located(problems.join("; ")))?;
    Ok(graded(Member { name: name.clone(), bytes }, read.file, None))
}

/// Why there are no keyframes, where no file looks like some: the archives that were not opened, and the files that were looked at.
fn reason_for_none(failed: &[Failed], skipped: &[Skipped]) -> String {
    let mut reason = "there is no keyframe file".to_owned();
    let unopened = skipped.iter().filter_map(|skipped| match &skipped.why {
        Why::Problem(problem) => Some(format!("{}: {problem}", skipped.name)),
        _ => None,
    });
    for problem in unopened.take(2) {
        reason.push_str("; ");
        reason.push_str(&problem);
    }
    let mut looked_at: Vec<&str> = failed.iter().map(|failed| failed.member.name.as_str()).collect();
    looked_at.sort_unstable();
    if !looked_at.is_empty() {
        reason.push_str("; looked at: ");
        reason.push_str(&shortly(&looked_at));
    }
    let others: Vec<Skipped> =
        skipped.iter().filter(|skipped| !matches!(skipped.why, Why::Problem(_))).cloned().collect();
    if looked_at.is_empty() && !others.is_empty() {
        let sentences: Vec<String> = skipped_notes(&others).into_iter().map(|note| note.text).collect();
        let sentences = sentences.join(" ").replacen("Skipped", "skipped", 1);
        reason.push_str("; ");
        reason.push_str(sentences.trim_end_matches('.'));
    }
    reason
}
