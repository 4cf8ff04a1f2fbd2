//! The rubric: what is graded, and for how many points; JSON or TOML.

use std::path::Path;

use serde::Deserialize;

use super::hotkeys;
use crate::cli::{CliError, reading};
use crate::difference::Tolerances;
use crate::keyframe::{DEFAULT_MS_BETWEEN_KEYFRAMES, KeyframeList, PlayRange};
use crate::scene::SceneGraph;
use crate::storage;

/// The largest rubric, and the largest of the files that it names, in bytes.
const LARGEST_BYTES: u64 = 64 << 20;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RubricText {
    format: String,
    version: u64,
    #[serde(default)]
    title: String,
    reference: String,
    #[serde(default)]
    script: Option<String>,
    #[serde(default)]
    tolerances: TolerancesText,
    #[serde(default = "default_fps")]
    fps: u32,
    points: Points,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, default)]
struct TolerancesText {
    translation: f64,
    rotation_degrees: f64,
}

impl Default for TolerancesText {
    fn default() -> Self {
        let Tolerances { translation, rotation_degrees } = Tolerances::default();
        Self { translation, rotation_degrees }
    }
}

const fn default_fps() -> u32 {
    10
}

/// Points for each thing that is graded; what is not named gives none and is left out.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Points {
    /// For keyframes that can be read.
    pub readable: f64,
    /// For as many keyframes as the reference has.
    pub keyframe_count: f64,
    /// For each of the reference's keyframes.
    pub each_keyframe: f64,
    /// For linear playback.
    pub linear_playback: f64,
    /// For Catmull-Rom playback.
    pub catmull_rom_playback: f64,
    /// For beginning and ending where it should.
    pub range_and_end: f64,
    /// For a trace of the hotkey script that matches.
    pub script: f64,
}

/// A rubric with all that it names.
#[derive(Clone, Debug)]
pub struct Rubric {
    /// What the report is headed by.
    pub title: String,
    /// The points.
    pub points: Points,
    /// What difference passes.
    pub tolerances: Tolerances,
    /// Frames a second at which playback is compared.
    pub fps: u32,
    /// The right keyframes, enough to play.
    pub reference: KeyframeList,
    /// Milliseconds between the right keyframes.
    pub ms_between_keyframes: u32,
    /// The reference's keyframe file, as a script reads it.
    pub reference_bytes: Vec<u8>,
    /// The hotkey script, where one is graded.
    pub script: Option<Vec<u8>>,
}

/// Parses a rubric: TOML where its name ends so, else JSON. What is wrong is a sentence that ends with its line and column.
fn parse(path: &Path, bytes: &[u8]) -> Result<RubricText, String> {
    let is_toml = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    if !is_toml {
        return serde_json::from_slice(bytes).map_err(|error| crate::json::sentence(&error));
    }
    let placed = |at: usize, what: &str| {
        let before = &bytes[..at.min(bytes.len())];
        let line = before.split(|byte| *byte == b'\n').count();
        let start = before.iter().rposition(|byte| *byte == b'\n').map_or(0, |newline| newline + 1);
        let column = String::from_utf8_lossy(&before[start..]).chars().count() + 1;
        format!("{what} at line {line} column {column}")
    };
    let text = std::str::from_utf8(bytes).map_err(|error| placed(error.valid_up_to(), "not UTF-8"))?;
    toml::from_str(text).map_err(|error| {
        // The parser's sentences may have lines; what is missing is missing at the end.
        let what = error.message().lines().collect::<Vec<_>>().join(", ");
        let is_missing = what.starts_with("missing field") && error.span().is_none_or(|span| span.start == 0);
        let at = if is_missing { bytes.len() } else { error.span().map_or(bytes.len(), |span| span.start) };
        placed(at, &what)
    })
}

/// Reads a rubric and the files that it names, by paths from its own folder.
///
/// # Errors
/// [`CliError::BadInput`]
pub fn load(path: &Path, scene: &SceneGraph) -> Result<Rubric, CliError> {
    let bad = |problem: String| CliError::bad_input(path.display(), problem);
    let bytes = storage::read(path, LARGEST_BYTES).map_err(|error| bad(error.to_string()))?;
    let text = parse(path, bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes)).map_err(bad)?;
    if text.format != "inbetween.rubric" {
        return Err(bad(format!("format is {:?}, expected \"inbetween.rubric\"", text.format)));
    }
    if text.version != 1 {
        return Err(bad(format!("version is {}, and this program reads version 1", text.version)));
    }
    if !(1..=1000).contains(&text.fps) {
        return Err(bad(format!("fps is {}, expected a whole number from 1 to 1000", text.fps)));
    }
    let Points {
        readable,
        keyframe_count,
        each_keyframe,
        linear_playback,
        catmull_rom_playback,
        range_and_end,
        script,
    } = text.points;
    let numbers = [
        ("points.readable", readable),
        ("points.keyframe_count", keyframe_count),
        ("points.each_keyframe", each_keyframe),
        ("points.linear_playback", linear_playback),
        ("points.catmull_rom_playback", catmull_rom_playback),
        ("points.range_and_end", range_and_end),
        ("points.script", script),
        ("tolerances.translation", text.tolerances.translation),
        ("tolerances.rotation_degrees", text.tolerances.rotation_degrees),
    ];
    if let Some((name, number)) = numbers.into_iter().find(|(_, number)| !(0.0..=1e6).contains(number)) {
        return Err(bad(format!("{name} is {number}, expected 0 to 1000000")));
    }
    if script > 0.0 && text.script.is_none() {
        return Err(bad("points.script is there, but script names no file".to_owned()));
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let read = |name: &str| {
        let path = folder.join(name);
        storage::read(&path, LARGEST_BYTES).map_err(|error| CliError::bad_input(path.display(), error))
    };
    let script = text.script.as_deref().map(read).transpose()?;
    if let (Some(bytes), Some(name)) = (&script, &text.script) {
        hotkeys::parse(bytes, scene).map_err(|problem| CliError::bad_input(folder.join(name).display(), problem))?;
    }
    let reference_path = folder.join(&text.reference);
    let bad_reference = |problem: String| CliError::bad_input(reference_path.display(), problem);
    let given = read(&text.reference)?;
    // A reference is a keyframe file or a script that makes one.
    let reference_bytes = match reading::keyframes(&given, scene) {
        Ok(_) => given,
        Err(_) if hotkeys::parse(&given, scene).is_ok() => {
            hotkeys::made_keyframes(&given, scene).map_err(bad_reference)?
        }
        Err(problems) => {
            return Err(CliError::BadInput {
                sentences: problems.iter().map(|p| format!("{}: {p}", reference_path.display())).collect(),
            });
        }
    };
    let file = reading::keyframes(&reference_bytes, scene).map_err(|problems| bad_reference(problems.join("; ")))?.file;
    let ms_between_keyframes = file.ms_between_keyframes.unwrap_or(DEFAULT_MS_BETWEEN_KEYFRAMES);
    let (reference, ..) = file.into_parts();
    PlayRange::new(&reference).map_err(|error| bad_reference(error.to_string()))?;
    let TolerancesText { translation, rotation_degrees } = text.tolerances;
    Ok(Rubric {
        title: text.title,
        points: text.points,
        tolerances: Tolerances { translation, rotation_degrees },
        fps: text.fps,
        reference,
        ms_between_keyframes,
        reference_bytes,
        script,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn broken_rubrics_are_sentences_with_a_place() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/grading");
        for name in ["rubric.json", "rubric.toml"] {
            let path = folder.join(name);
            let text = storage::read(&path, LARGEST_BYTES).unwrap();
            assert!(parse(&path, &text).is_ok());
            let mut refused = 0;
            for at in 0..text.len() {
                let mut broken: Vec<Vec<u8>> = vec![text[..at].to_vec(), [&text[..at], &text[at + 1..]].concat()];
                for byte in [b'"', b'[', b'{', b'9', b'\n', 0, 0xff] {
                    broken.push([&text[..at], &[byte], &text[at + 1..]].concat());
                    broken.push([&text[..at], &[byte], &text[at..]].concat());
                }
                for text in broken {
                    if let Err(sentence) = parse(&path, &text).map(|_| ()) {
                        let place =
                            sentence.rsplit_once(" at line ").and_then(|(_, place)| place.split_once(" column "));
                        let (line, column) = place.unwrap_or_else(|| panic!("{sentence}"));
                        assert!(line.parse::<usize>().is_ok() && column.parse::<usize>().is_ok(), "{sentence}");
                        assert!(!sentence.contains('\n'), "{sentence}");
                        refused += 1;
                    }
                }
            }
            assert!(refused > 1000, "{name}: {refused}");
        }
    }
}
