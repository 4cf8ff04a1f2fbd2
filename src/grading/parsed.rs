//! Classifies and parses the files of a submission, each once.

use serde_json::Value;

use super::folder;
use super::submission::Member;
use super::trace;
use crate::diagnosis::SampleRows;
use crate::interpolation::Interpolation;
use crate::keyframe::KeyframeList;
use crate::scene::SceneGraph;
use crate::script::Line;
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
    pub inferred: Option<String>,
    /// The keyframes.
    pub list: KeyframeList,
    /// How the file says that they are interpolated.
    pub interpolation: Interpolation,
    /// Milliseconds between keyframes.
    pub ms_between_keyframes: u32,
}

/// A submission, parsed.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// Why none of its files could be read.
    pub problem: Option<String>,
    /// The keyframes of the first file that holds some; without such a file, those that the script makes.
    pub keyframes: Result<ParsedKeyframes, String>,
    /// The first keyframe file's bytes, whether or not they can be read: what the submission's own script reads.
    pub first_keyframe_file: Option<Vec<u8>>,
    /// Samples of playback, at most `MOST_SAMPLES` files.
    pub samples: Vec<ParsedFile<SampleRows>>,
    /// How many files of samples there are.
    pub samples_count: usize,
    /// The first hotkey script.
    pub script: Option<ParsedFile<Vec<Line>>>,
    /// The first trace of a script: its objects.
    pub trace: Option<ParsedFile<Vec<Value>>>,
}

/// The kind of a submission's file.
enum Kind {
    Samples,
    Trace,
    Script(Result<Vec<Line>, String>),
    Keyframes,
    /// Sources of programs, pictures and the like.
    Other,
}

const KEYFRAME_ENDINGS: [&str; 10] = ["json", "txt", "csv", "dat", "key", "keys", "kf", "anim", "py", "out"];

/// Determines the kind of a file. Samples: the first line contains `key_time`. Trace: `.jsonl`, or `trace` in the name. Script: `script` in
/// the name, or a `.txt` file that parses as one and is not empty. Keyframes: by the extension, or a name without a dot.
fn kind_of(member: &Member, scene: &SceneGraph) -> Kind {
    let name = member.name.rsplit('/').next().unwrap_or_default().to_ascii_lowercase();
    let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
    let start = String::from_utf8_lossy(&member.bytes[..member.bytes.len().min(300)]).to_ascii_lowercase();
    if start.lines().next().unwrap_or_default().contains("key_time") {
        return Kind::Samples;
    }
    if ending == "jsonl" || name.contains("trace") {
        return Kind::Trace;
    }
    let is_named_script = name.contains("script");
    if is_named_script || ending == "txt" {
        let lines = folder::read_script(&member.bytes, scene);
        if is_named_script || lines.as_ref().is_ok_and(|lines| !lines.is_empty()) {
            return Kind::Script(lines);
        }
    }
    if KEYFRAME_ENDINGS.contains(&ending) || !name.contains('.') { Kind::Keyframes } else { Kind::Other }
}

impl Parsed {
    /// Classifies and parses the files of a submission, or records why they cannot be read.
    #[must_use]
    pub fn new(members: Result<Vec<Member>, String>, scene: &SceneGraph) -> Self {
        let (members, problem) = match members {
            Ok(members) => (members, None),
            Err(problem) => (Vec::new(), Some(problem)),
        };
        let mut keyframe_files = Vec::new();
        let mut samples = Vec::new();
        let mut samples_count = 0;
        let (mut script, mut trace) = (None, None);
        for member in members {
            match kind_of(&member, scene) {
                Kind::Keyframes => keyframe_files.push(member),
                Kind::Samples => {
                    samples_count += 1;
                    if samples.len() < MOST_SAMPLES {
                        let content = samples_of(&member.bytes, scene);
                        samples.push(ParsedFile { name: member.name, content });
                    }
                }
                Kind::Script(content) => {
                    script.get_or_insert(ParsedFile { name: member.name, content });
                }
                Kind::Trace => {
                    trace.get_or_insert_with(|| ParsedFile {
                        content: trace::objects(&member.bytes),
                        name: member.name,
                    });
                }
                Kind::Other => {}
            }
        }
        let keyframes = keyframes_of(&keyframe_files, script.as_ref(), scene);
        // If the files cannot be read, that is the reason for missing keyframes.
        let keyframes = keyframes.map_err(|found| problem.clone().unwrap_or(found));
        let first_keyframe_file = keyframe_files.into_iter().next().map(|member| member.bytes);
        Self { problem, keyframes, first_keyframe_file, samples, samples_count, script, trace }
    }
}

fn samples_of(bytes: &[u8], scene: &SceneGraph) -> Result<SampleRows, String> {
    if bytes.len() > LARGEST_SAMPLES_BYTES {
        return Err(format!("{} bytes, and at most {LARGEST_SAMPLES_BYTES} are read", bytes.len()));
    }
    SampleRows::from_csv(bytes, scene.rbt_count()).map_err(|error| error.to_string())
}

/// The keyframes of the first file that has some, or those that the script makes; otherwise the error of the first file.
fn keyframes_of(
    files: &[Member],
    script: Option<&ParsedFile<Vec<Line>>>,
    scene: &SceneGraph,
) -> Result<ParsedKeyframes, String> {
    let mut problem = None;
    for member in files {
        match keyframes_in(&member.name, &member.bytes, scene) {
            Ok(read) => return Ok(read),
            Err(found) => problem = problem.or(Some(found)),
        }
    }
    if let (None, Some(ParsedFile { name, content })) = (&problem, script) {
        let made = content.clone().and_then(|lines| folder::run(&lines, scene, None));
        let made = made.map_err(|problem| format!("{name}: {problem}"))?.keyframe_file();
        return keyframes_in(name, &made, scene);
    }
    Err(problem.unwrap_or_else(|| "there is no keyframe file".to_owned()))
}

fn keyframes_in(file: &str, bytes: &[u8], scene: &SceneGraph) -> Result<ParsedKeyframes, String> {
    let read = read_keyframes(bytes, scene).map_err(|problems| {
        let more =
            if problems.len() > 1 { format!(" (and {} more problems)", problems.len() - 1) } else { String::new() };
        format!("{file}: {}{more}", problems.first().map_or("", String::as_str))
    })?;
    let inferred = read.report.as_ref().map(|report| format!("{file}: {}", report.to_string().replace('\n', "; ")));
    let count = read.file.keyframes.len();
    if count > MOST_KEYFRAMES {
        return Err(format!("{file}: {count} keyframes, and at most {MOST_KEYFRAMES} are graded"));
    }
    let (list, interpolation, ms_between_keyframes) = read.file.into_parts();
    let (file, bytes) = (file.to_owned(), bytes.to_owned());
    Ok(ParsedKeyframes { file, bytes, inferred, list, interpolation, ms_between_keyframes })
}
