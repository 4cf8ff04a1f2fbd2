//! Marking one submission: points with reasons, and what its samples show.
//!
//! Pure: what was read goes in, marks come out. Work is bounded by counts, not by a clock, so that results are the same everywhere.

use serde_json::Value;

use super::gather::Member;
use super::hotkeys;
use super::rubric::Rubric;
use super::shown::{ShownPoses, thinned};
use crate::cli::diff::times_ms;
use crate::cli::reading;
use crate::diagnosis::{
    CORRECT, CORRECT_CATMULL_ROM, Diagnosis, EQUAL_RESIDUALS, LAST_SAMPLE_MISSING, Sequence, advice, diagnose,
    samples_from_csv,
};
use crate::difference::{Played, compare, distances};
use crate::interpolation::Interpolation;
use crate::keyframe::{DEFAULT_MS_BETWEEN_KEYFRAMES, Keyframe, KeyframeList, PlayRange};
use crate::pose::Pose;
use crate::scene::SceneGraph;

/// The largest file of samples in a submission, in bytes.
const LARGEST_SAMPLES_BYTES: usize = 4 << 20;
/// The most files of samples in a submission.
const MOST_SAMPLES: usize = 4;
/// The most keyframes in a submission.
const MOST_KEYFRAMES: usize = 2_000;
/// The most frames at which playback is compared.
const MOST_FRAMES: usize = 20_000;

/// One thing that was graded.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// Its name, as in the rubric; the keyframes are counted: `keyframe 3`.
    pub name: String,
    /// The points it got.
    pub points: f64,
    /// The points it could get.
    pub out_of: f64,
    /// Why: a sentence.
    pub reason: String,
}

/// What one file of samples shows.
#[derive(Clone, Debug, PartialEq)]
pub struct SamplesShow {
    /// The file.
    pub file: String,
    /// For which playback it stands.
    pub interpolation: Interpolation,
    /// What explains it, or why it cannot be told.
    pub diagnosis: Result<Diagnosis, String>,
    /// The poses that pictures are of.
    pub shown: Option<ShownPoses>,
}

/// All marks of a submission.
#[derive(Clone, Debug)]
pub struct Marks {
    /// The submission's name.
    pub name: String,
    /// What was graded, in the rubric's order.
    pub items: Vec<Item>,
    /// What its samples show.
    pub samples: Vec<SamplesShow>,
    /// The file that its keyframes are from, or a script.
    pub keyframe_file: Option<String>,
    /// Its keyframes, where they can be read.
    pub keyframes: Option<KeyframeList>,
    /// What else there is to say.
    pub notes: Vec<String>,
}

impl Marks {
    /// The points of all items.
    pub fn points(&self) -> f64 {
        self.items.iter().map(|item| item.points).sum()
    }

    /// The points that could be had.
    pub fn out_of(&self) -> f64 {
        self.items.iter().map(|item| item.out_of).sum()
    }
}

/// The files of a submission by what they are.
#[derive(Default)]
struct Parts<'a> {
    keyframes: Vec<&'a Member>,
    samples: Vec<&'a Member>,
    scripts: Vec<&'a Member>,
    traces: Vec<&'a Member>,
}

/// Sorts files by what they hold: samples by their header, scripts and traces by their first line or their name.
fn sorted<'a>(members: &'a [Member], scene: &SceneGraph) -> Parts<'a> {
    let mut parts = Parts::default();
    for member in members {
        let name = member.name.rsplit('/').next().unwrap_or_default().to_ascii_lowercase();
        let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
        let start = String::from_utf8_lossy(&member.bytes[..member.bytes.len().min(300)]).to_ascii_lowercase();
        if start.lines().next().unwrap_or_default().contains("key_time") {
            parts.samples.push(member);
        } else if ending == "jsonl" || name.contains("trace") {
            parts.traces.push(member);
        } else if name.contains("script")
            || (ending == "txt" && hotkeys::parse(&member.bytes, scene).is_ok_and(|lines| !lines.is_empty()))
        {
            parts.scripts.push(member);
        } else if ["json", "txt", "csv", "dat", "key", "keys", "kf", "anim", "py", "out"].contains(&ending)
            || !name.contains('.')
        {
            parts.keyframes.push(member);
        }
    }
    parts
}

struct Read {
    file: String,
    bytes: Vec<u8>,
    /// What was inferred of a text's layout.
    inferred: Option<String>,
    keyframes: Vec<Keyframe>,
    interpolation: Interpolation,
    ms_between_keyframes: u32,
}

/// The first file that holds keyframes, or else those that the script makes; otherwise what is wrong with the first.
fn read_keyframes(parts: &Parts<'_>, scene: &SceneGraph) -> Result<Read, String> {
    let mut problem = None;
    let read = |file: &str, bytes: &[u8]| -> Result<Read, String> {
        let read = reading::keyframes(bytes, scene).map_err(|problems| {
            let more =
                if problems.len() > 1 { format!(" (and {} more problems)", problems.len() - 1) } else { String::new() };
            format!("{file}: {}{more}", problems.first().map_or("", String::as_str))
        })?;
        let inferred = read.report.as_ref().map(|report| format!("{file}: {}", report.to_string().replace('\n', "; ")));
        let read = read.file;
        if read.keyframes.len() > MOST_KEYFRAMES {
            return Err(format!("{file}: {} keyframes, and at most {MOST_KEYFRAMES} are graded", read.keyframes.len()));
        }
        Ok(Read {
            file: file.to_owned(),
            bytes: bytes.to_owned(),
            inferred,
            interpolation: read.interpolation.unwrap_or_default(),
            ms_between_keyframes: read.ms_between_keyframes.unwrap_or(DEFAULT_MS_BETWEEN_KEYFRAMES),
            keyframes: read.keyframes,
        })
    };
    for member in &parts.keyframes {
        match read(&member.name, &member.bytes) {
            Ok(read) => return Ok(read),
            Err(found) => problem = problem.or(Some(found)),
        }
    }
    if let (None, Some(script)) = (&problem, parts.scripts.first()) {
        let made =
            hotkeys::made_keyframes(&script.bytes, scene).map_err(|error| format!("{}: {error}", script.name))?;
        return read(&script.name, &made);
    }
    Err(problem.unwrap_or_else(|| "there is no keyframe file".to_owned()))
}

/// Marks a submission's files, or notes why they could not be had.
pub fn mark(name: &str, members: Result<Vec<Member>, String>, rubric: &Rubric, scene: &SceneGraph) -> Marks {
    let mut notes = Vec::new();
    let members = members.unwrap_or_else(|problem| {
        notes.push(problem);
        Vec::new()
    });
    let parts = sorted(&members, scene);
    let read = read_keyframes(&parts, scene);
    let read = read.map_err(|problem| notes.first().cloned().unwrap_or(problem));
    notes.extend(read.as_ref().ok().and_then(|read| read.inferred.clone()));
    // Where reading gives no points, no item says what is wrong.
    notes.extend(read.as_ref().err().filter(|_| rubric.points.readable == 0.0 && notes.is_empty()).cloned());
    let list = read.as_ref().ok().map(|read| KeyframeList::new(read.keyframes.clone()));
    let samples = samples_show(&parts, read.as_ref().ok(), rubric, scene, &mut notes);
    let marker = Marker { rubric, scene, read: read.as_ref(), list: list.as_ref(), samples: &samples, parts: &parts };
    let points = &rubric.points;
    let mut items = Vec::new();
    let mut item = |name: &str, out_of: f64, verdict: &dyn Fn() -> Result<String, String>| {
        if out_of > 0.0 {
            let (points, reason) = match verdict() {
                Ok(reason) => (out_of, reason),
                Err(reason) => (0.0, reason),
            };
            items.push(Item { name: name.to_owned(), points, out_of, reason });
        }
    };
    item("readable", points.readable, &|| marker.readable());
    item("keyframe_count", points.keyframe_count, &|| marker.count());
    for place in 0..rubric.reference.len() {
        item(&format!("keyframe {place}"), points.each_keyframe, &|| marker.keyframe(place));
    }
    item("linear_playback", points.linear_playback, &|| marker.playback(Interpolation::Linear));
    item("catmull_rom_playback", points.catmull_rom_playback, &|| marker.playback(Interpolation::CatmullRom));
    item("range_and_end", points.range_and_end, &|| marker.range_and_end());
    item("script", points.script, &|| marker.script());
    let keyframe_file = read.as_ref().ok().map(|read| read.file.clone());
    Marks { name: name.to_owned(), items, samples, keyframe_file, keyframes: list, notes }
}

fn samples_show(
    parts: &Parts<'_>,
    read: Option<&Read>,
    rubric: &Rubric,
    scene: &SceneGraph,
    notes: &mut Vec<String>,
) -> Vec<SamplesShow> {
    if parts.samples.len() > MOST_SAMPLES {
        notes
            .push(format!("{} files of samples, and only the first {MOST_SAMPLES} are looked at", parts.samples.len()));
    }
    // What was shown is its own keyframes, or the reference's: the samples tell.
    let own = read.and_then(|read| Some((Sequence::new(&read.keyframes).ok()?, read.ms_between_keyframes)));
    let reference = Sequence::new(rubric.reference.as_slice()).ok().map(|right| (right, rubric.ms_between_keyframes));
    let sequences: Vec<(Sequence, u32)> = own.into_iter().chain(reference).collect();
    let against = |bytes: &[u8], (sequence, ms): &(Sequence, u32)| {
        let samples = samples_from_csv(bytes, scene.rbt_count(), *ms).map_err(|error| error.to_string())?;
        Ok(diagnose(sequence, &samples))
    };
    let nearer = |one: Diagnosis, other: Diagnosis| {
        if other.best().residual < one.best().residual - EQUAL_RESIDUALS { other } else { one }
    };
    let one = |member: &&Member| {
        let name = member.name.to_ascii_lowercase();
        let interpolation = if name.contains("catmull") || name.contains("spline") {
            Interpolation::CatmullRom
        } else if name.contains("linear") {
            Interpolation::Linear
        } else {
            read.map_or_else(Interpolation::default, |read| read.interpolation)
        };
        let diagnosis = if member.bytes.len() > LARGEST_SAMPLES_BYTES {
            Err(format!("{} bytes, and at most {LARGEST_SAMPLES_BYTES} are read", member.bytes.len()))
        } else {
            let diagnoses: Result<Vec<Diagnosis>, String> =
                sequences.iter().map(|sequence| against(&member.bytes, sequence)).collect();
            diagnoses.and_then(|diagnoses| {
                diagnoses.into_iter().reduce(nearer).ok_or_else(|| "there are no keyframes to compare with".to_owned())
            })
        };
        let shown = diagnosis.as_ref().ok().and_then(|_| {
            let samples = samples_from_csv(&member.bytes, scene.rbt_count(), rubric.ms_between_keyframes).ok()?;
            thinned(&samples, interpolation, rubric)
        });
        SamplesShow { file: member.name.clone(), interpolation, diagnosis, shown }
    };
    parts.samples.iter().take(MOST_SAMPLES).map(one).collect()
}

/// Everything that verdicts look at.
struct Marker<'a> {
    rubric: &'a Rubric,
    scene: &'a SceneGraph,
    read: Result<&'a Read, &'a String>,
    list: Option<&'a KeyframeList>,
    samples: &'a [SamplesShow],
    parts: &'a Parts<'a>,
}

impl Marker<'_> {
    fn read(&self) -> Result<&Read, String> {
        self.read.map_err(|_| "The keyframes cannot be read.".to_owned())
    }

    fn readable(&self) -> Result<String, String> {
        let read = self.read.map_err(Clone::clone)?;
        Ok(format!("{} holds {} keyframes.", read.file, read.keyframes.len()))
    }

    fn count(&self) -> Result<String, String> {
        let (found, expected) = (self.read()?.keyframes.len(), self.rubric.reference.len());
        if found == expected {
            Ok(format!("{found} keyframes."))
        } else {
            Err(format!("{found} keyframes, expected {expected}."))
        }
    }

    fn keyframe(&self, place: usize) -> Result<String, String> {
        let found = self.read()?.keyframes.get(place).ok_or("It is not there.")?;
        self.same_pose(&found.pose, &self.rubric.reference.as_slice()[place].pose)
    }

    fn same_pose(&self, found: &Pose, expected: &Pose) -> Result<String, String> {
        let nodes = found.iter().zip(expected.iter()).zip(self.scene.rbt_paths());
        for ((found, expected), path) in nodes {
            let (translation, degrees) = distances(found, expected);
            let tolerances = self.rubric.tolerances;
            if translation > tolerances.translation {
                return Err(format!("The translation of {path} is {translation:.4} units off."));
            }
            if degrees > tolerances.rotation_degrees {
                return Err(format!("The rotation of {path} is {degrees:.3} degrees off."));
            }
        }
        Ok("As in the reference.".to_owned())
    }

    fn playback(&self, interpolation: Interpolation) -> Result<String, String> {
        let right = if interpolation == Interpolation::Linear { CORRECT } else { CORRECT_CATMULL_ROM };
        if let Some(show) = self.samples.iter().find(|show| show.interpolation == interpolation) {
            let diagnosis = show.diagnosis.as_ref().map_err(|problem| format!("{}: {problem}.", show.file))?;
            let best = diagnosis.best();
            let is_among = |name| diagnosis.candidates[..diagnosis.equals].iter().any(|c| c.name == name);
            let place = format!("{}: {}, residual {:.2e}.", show.file, best.name, best.residual);
            // An end that is missing is another matter.
            if diagnosis.is_explained() && is_among(right) {
                return Ok(place);
            }
            let advice = advice(best.name).filter(|_| diagnosis.is_explained());
            return Err(match advice {
                None => format!(
                    "{}: no known mistake explains the samples; {} is nearest, residual {:.2e}.",
                    show.file, best.name, best.residual
                ),
                Some(advice) if advice.change.is_empty() => {
                    format!("{place} {} Expected {right}.", advice.what)
                }
                Some(advice) => format!("{place} {} {}", advice.what, advice.change),
            });
        }
        self.read()?;
        let list = self.list.ok_or("There are no keyframes.")?;
        let range = PlayRange::new(list).map_err(|error| format!("{error}."))?;
        let expected = PlayRange::new(&self.rubric.reference).map_err(|error| error.to_string())?;
        let played = |range| Played { range, interpolation, ms_between_keyframes: self.rubric.ms_between_keyframes };
        let (a, b) = (played(&expected), played(&range));
        let times = times_ms(&a.length_ms(), self.rubric.fps)
            .filter(|times| times.len() <= MOST_FRAMES)
            .ok_or_else(|| format!("More than {MOST_FRAMES} frames to compare."))?;
        let difference = compare(a, b, &times, self.rubric.tolerances).map_err(|error| error.to_string())?;
        let beyond = difference.nodes.iter().zip(self.scene.rbt_paths()).filter_map(|(node, path)| {
            let at =
                [node.translation.exceeds_at, node.rotation.exceeds_at].into_iter().flatten().min_by(f64::total_cmp)?;
            Some((at, path, node))
        });
        match beyond.min_by(|a, b| a.0.total_cmp(&b.0)) {
            None => Ok(format!("Its keyframes play as the reference's over {} frames.", times.len())),
            Some((at, path, node)) => Err(format!(
                "Its keyframes play otherwise from key time {at:.3} on: {path} is up to {:.4} units and {:.3} degrees off.",
                node.translation.largest, node.rotation.largest
            )),
        }
    }

    fn range_and_end(&self) -> Result<String, String> {
        let mistakes = ["all-keyframes-played", "one-keyframe-early", LAST_SAMPLE_MISSING];
        let shown = |show: &SamplesShow| show.diagnosis.as_ref().ok().filter(|d| d.is_explained()).map(Diagnosis::best);
        let wrong = self.samples.iter().find_map(|show| {
            shown(show).filter(|best| mistakes.contains(&best.name)).map(|best| (best.name, &show.file))
        });
        if let Some((name, file)) = wrong {
            let advice = advice(name).map_or("", |advice| advice.what);
            return Err(format!("{file}: {name}. {advice}"));
        }
        let keyframes = &self.read()?.keyframes;
        let expected = self.rubric.reference.as_slice();
        if keyframes.len() != expected.len() {
            return Err(format!("{} keyframes play another range than {}.", keyframes.len(), expected.len()));
        }
        for (what, place) in [("first", 1), ("last", expected.len() - 2)] {
            self.same_pose(&keyframes[place].pose, &expected[place].pose)
                .map_err(|reason| format!("The {what} played keyframe, {place}: {reason}"))?;
        }
        Ok(format!("It plays from keyframe 1 to keyframe {}.", expected.len() - 2))
    }

    fn script(&self) -> Result<String, String> {
        let script = self.rubric.script.as_ref().ok_or("The rubric has no script.")?;
        let expected = hotkeys::run(script, self.scene, Some(&self.rubric.reference_bytes))?.trace;
        let (what, found) = if let Some(trace) = self.parts.traces.first() {
            (trace.name.clone(), trace_lines(&trace.bytes).map_err(|problem| format!("{}: {problem}.", trace.name))?)
        } else if let Some(own) = self.parts.scripts.first() {
            let keyframes = self.parts.keyframes.first().map(|member| member.bytes.as_slice());
            let ran = hotkeys::run(&own.bytes, self.scene, keyframes)
                .map_err(|problem| format!("{}: {problem}.", own.name))?;
            (own.name.clone(), ran.trace)
        } else {
            let read = self.read()?;
            let ran = hotkeys::run(script, self.scene, Some(&read.bytes))
                .map_err(|problem| format!("{}: {problem}.", read.file))?;
            (format!("the script with {}", read.file), ran.trace)
        };
        let total = expected.len();
        for (step, expected) in expected.iter().enumerate() {
            let Some(found) = found.get(step) else {
                return Err(format!("{what}: the trace ends after {step} of {total} commands."));
            };
            for field in ["keyframes", "current", "playing", "key_time", "ms_between_keyframes", "interpolation"] {
                let (found, expected_value) = (found.get(field).unwrap_or(&Value::Null), &expected[field]);
                if !same(found, expected_value) {
                    return Err(format!(
                        "{what}: after command {} ({}), {field} is {found}, expected {expected_value}.",
                        step + 1,
                        expected["command"].as_str().unwrap_or_default()
                    ));
                }
            }
        }
        if found.len() > expected.len() {
            return Err(format!("{what}: {} commands, expected {}.", found.len(), expected.len()));
        }
        Ok(format!("{what}: all {} commands match.", expected.len()))
    }
}

/// Traces match where numbers agree to a millionth.
fn same(found: &Value, expected: &Value) -> bool {
    match (found.as_f64(), expected.as_f64()) {
        (Some(found), Some(expected)) => (found - expected).abs() <= 1e-6,
        _ => found == expected,
    }
}

fn trace_lines(bytes: &[u8]) -> Result<Vec<Value>, String> {
    let text = std::str::from_utf8(bytes).map_err(|error| format!("not UTF-8 at byte {}", error.valid_up_to()))?;
    let lines = (1..).zip(text.trim_start_matches('\u{feff}').lines()).filter(|(_, line)| !line.trim().is_empty());
    let values = lines.take(hotkeys::MOST_LINES + 1).map(|(number, line)| {
        serde_json::from_str(line).map_err(|error| format!("line {number}: not a JSON object: {error}"))
    });
    values.collect()
}
