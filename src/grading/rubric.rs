//! The rubric: graded items and their points, as JSON or TOML.

use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::folder::{self, Traced};
use super::item::ItemKind;
use super::names::PreferredNames;
use crate::animation_diff::Tolerances;
use crate::decode::{self, DecodeError};
use crate::files::{self, FileError};
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeList, PlayRange};
use crate::scene::SceneGraph;
use crate::script::Line;
use crate::text_layouts::read_keyframes;

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
    keyframe_file: Vec<String>,
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

/// Points for each item. Items without points are not graded.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Points {
    /// For keyframes that can be read.
    pub readable: f64,
    /// For as many keyframes as the reference has.
    pub keyframe_count: f64,
    /// For each of the reference's keyframes.
    pub each_keyframe: f64,
    /// If linear playback matches the reference.
    pub linear_playback: f64,
    /// If Catmull-Rom playback matches the reference.
    pub catmull_rom_playback: f64,
    /// For beginning and ending where it should.
    pub range_and_end: f64,
    /// For a trace of the hotkey script that matches.
    pub script: f64,
}

/// A rubric and the files that it names.
#[derive(Clone, Debug)]
pub struct Rubric {
    /// The title of the report.
    pub title: String,
    /// The points.
    pub points: Points,
    /// The tolerances.
    pub tolerances: Tolerances,
    /// Frames a second at which playback is compared.
    pub fps: u32,
    /// The right keyframes, enough to play.
    pub reference: KeyframeList,
    /// The interpolation of the right keyframes.
    pub interpolation: Interpolation,
    /// Milliseconds between the right keyframes.
    pub ms_between_keyframes: u32,
    /// How keyframe files are named, to choose among several.
    pub keyframe_file: PreferredNames,
    /// The hotkey script, where one is graded.
    pub script: Option<RubricScript>,
    /// The files that it names.
    pub files: Vec<PathBuf>,
}

/// A hotkey script with its expected trace.
#[derive(Clone, Debug)]
pub struct RubricScript {
    /// Its lines.
    pub lines: Vec<Line>,
    /// The trace of a run with the reference, or why there is none.
    pub expected: Result<Vec<Traced>, String>,
}

impl Rubric {
    /// The graded items with their points, in the order of results.
    pub fn items(&self) -> impl Iterator<Item = (ItemKind, f64)> + use<> {
        let points = self.points;
        let before = [(ItemKind::Readable, points.readable), (ItemKind::KeyframeCount, points.keyframe_count)];
        let keyframes = (0..self.reference.len()).map(move |index| (ItemKind::Keyframe(index), points.each_keyframe));
        let after = [
            (ItemKind::Playback(Interpolation::Linear), points.linear_playback),
            (ItemKind::Playback(Interpolation::CatmullRom), points.catmull_rom_playback),
            (ItemKind::RangeAndEnd, points.range_and_end),
            (ItemKind::Script, points.script),
        ];
        before.into_iter().chain(keyframes).chain(after).filter(|(_, out_of)| *out_of > 0.0)
    }
}

/// Parses a rubric: TOML where its name ends so, else JSON.
fn parse(path: &Path, bytes: &[u8]) -> Result<RubricText, DecodeError> {
    let is_toml = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    if is_toml { decode::toml(bytes) } else { decode::json(bytes) }
}

impl RubricText {
    /// The first invalid value of the rubric, as a sentence.
    fn problem(&self) -> Option<String> {
        if self.format != "inbetween.rubric" {
            return Some(format!("format is {:?}, expected \"inbetween.rubric\"", self.format));
        }
        if self.version != 1 {
            return Some(format!("version is {}, and this program reads version 1", self.version));
        }
        if !(1..=1000).contains(&self.fps) {
            return Some(format!("fps is {}, expected a whole number from 1 to 1000", self.fps));
        }
        // Destructured, so that a new field cannot be forgotten.
        let Points {
            readable,
            keyframe_count,
            each_keyframe,
            linear_playback,
            catmull_rom_playback,
            range_and_end,
            script,
        } = self.points;
        let numbers = [
            ("points.readable", readable),
            ("points.keyframe_count", keyframe_count),
            ("points.each_keyframe", each_keyframe),
            ("points.linear_playback", linear_playback),
            ("points.catmull_rom_playback", catmull_rom_playback),
            ("points.range_and_end", range_and_end),
            ("points.script", script),
            ("tolerances.translation", self.tolerances.translation),
            ("tolerances.rotation_degrees", self.tolerances.rotation_degrees),
        ];
        if let Some((name, number)) = numbers.into_iter().find(|(_, number)| !(0.0..=1e6).contains(number)) {
            return Some(format!("{name} is {number}, expected 0 to 1000000"));
        }
        let has_no_script = script > 0.0 && self.script.is_none();
        has_no_script.then(|| "points.script is there, but script names no file".to_owned())
    }
}

impl Rubric {
    /// Reads a rubric and the files that it names, by paths from its own folder.
    ///
    /// # Errors
    /// [`FileError`]
    pub fn load(path: &Path, scene: &SceneGraph) -> Result<Self, FileError> {
        let bad = |problem: String| FileError::new(path.display(), problem);
        let text =
            parse(path, &files::read(path, LARGEST_BYTES)?).map_err(|error| FileError::new(path.display(), error))?;
        if let Some(problem) = text.problem() {
            return Err(bad(problem));
        }
        let keyframe_file =
            PreferredNames::new(&text.keyframe_file).map_err(|problem| bad(format!("keyframe_file: {problem}")))?;
        let folder = path.parent().unwrap_or(Path::new(""));
        // Standard input is read by its own name alone.
        let beside = |name: &str| if name == "-" { PathBuf::from(name) } else { folder.join(name) };
        let files = text.script.iter().chain([&text.reference]).map(|name| beside(name)).collect();
        let script = text.script.as_deref().map(|name| {
            let path = beside(name);
            Ok((files::read(&path, LARGEST_BYTES)?, path))
        });
        let script = script.transpose()?;
        let lines = script.map(|(bytes, path)| {
            folder::read_script(&bytes, scene).map_err(|problem| FileError::new(path.display(), problem))
        });
        let lines = lines.transpose()?;
        let Reference { bytes: reference_bytes, list: reference, interpolation, ms_between_keyframes } =
            Reference::load(&beside(&text.reference), scene)?;
        let script = lines.map(|lines| RubricScript {
            expected: folder::run(&lines, scene, Some(&reference_bytes)).map(|ran| ran.trace),
            lines,
        });
        let TolerancesText { translation, rotation_degrees } = text.tolerances;
        Ok(Self {
            title: text.title,
            points: text.points,
            tolerances: Tolerances { translation, rotation_degrees },
            fps: text.fps,
            reference,
            interpolation,
            ms_between_keyframes,
            keyframe_file,
            script,
            files,
        })
    }
}

/// The right keyframes, and the bytes of a file that holds them.
struct Reference {
    bytes: Vec<u8>,
    list: KeyframeList,
    interpolation: Interpolation,
    ms_between_keyframes: u32,
}

impl Reference {
    /// Reads a keyframe file, or runs a script that makes one.
    fn load(path: &Path, scene: &SceneGraph) -> Result<Self, FileError> {
        let bad = |problem: String| FileError::new(path.display(), problem);
        let given = files::read(path, LARGEST_BYTES)?;
        let (bytes, file) = match read_keyframes(&given, scene) {
            Ok(read) => (given, read.file),
            Err(problems) => {
                let Ok(lines) = folder::read_script(&given, scene) else {
                    return Err(FileError::all(path.display(), problems));
                };
                let made = folder::run(&lines, scene, None).map_err(bad)?.keyframe_file();
                let read = read_keyframes(&made, scene).map_err(|problems| bad(problems.join("; ")))?;
                (made, read.file)
            }
        };
        let (list, interpolation, ms_between_keyframes) = file.into_parts();
        PlayRange::new(&list).map_err(|error| bad(error.to_string()))?;
        Ok(Self { bytes, list, interpolation, ms_between_keyframes })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn broken_rubrics_are_sentences_with_a_place() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/grading");
        for name in ["rubric.json", "rubric.toml"] {
            let path = folder.join(name);
            let text = files::read(&path, LARGEST_BYTES).unwrap();
            assert!(parse(&path, &text).is_ok());
            let mut refused = 0;
            for at in 0..text.len() {
                let mut broken: Vec<Vec<u8>> = vec![text[..at].to_vec(), [&text[..at], &text[at + 1..]].concat()];
                for byte in [b'"', b'[', b'{', b'9', b'\n', 0, 0xff] {
                    broken.push([&text[..at], &[byte], &text[at + 1..]].concat());
                    broken.push([&text[..at], &[byte], &text[at..]].concat());
                }
                for text in broken {
                    if let Err(error) = parse(&path, &text).map(|_| ()) {
                        let lines = text.split(|&byte| byte == b'\n').count();
                        assert!((1..=lines).contains(&error.line) && error.column >= 1, "{error}");
                        assert!(!error.to_string().contains('\n'), "{error}");
                        refused += 1;
                    }
                }
            }
            assert!(refused > 1000, "{name}: {refused}");
        }
    }
}
