//! The rubric as it is written: parsing, and the first invalid value.

use std::path::Path;

use serde::Deserialize;

use super::Points;
use super::credit::{self, Band};
use crate::animation_diff::Tolerances;
use crate::decode::{self, DecodeError};
use crate::grading::late::Late;
use crate::grading::requirements::{Requirements, RequirementsText};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RubricText {
    pub format: String,
    pub version: u64,
    #[serde(default)]
    pub title: String,
    #[serde(default)]
    pub reference: Option<String>,
    #[serde(default)]
    pub script: Option<String>,
    #[serde(default)]
    pub keyframe_file: Vec<String>,
    #[serde(default)]
    pub tolerances: TolerancesText,
    #[serde(default = "default_fps")]
    pub fps: u32,
    #[serde(default)]
    pub playback: PlaybackText,
    #[serde(default = "default_samples_per_interval")]
    pub samples_per_interval: u32,
    #[serde(default)]
    pub bands: Vec<BandText>,
    #[serde(default)]
    pub share_of_frames: bool,
    #[serde(default)]
    pub follow_through: bool,
    #[serde(default)]
    pub align_keyframes: bool,
    #[serde(default)]
    pub late: Option<Late>,
    pub points: Points,
    #[serde(default)]
    pub requirements: RequirementsText,
}

/// What earns points for playback where no samples were handed in.
#[derive(Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum PlaybackText {
    /// Nothing.
    #[default]
    Samples,
    /// How this program plays the submitted keyframes.
    Assumed,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BandText {
    translation: f64,
    rotation_degrees: f64,
    share: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct TolerancesText {
    pub translation: f64,
    pub rotation_degrees: f64,
}

impl Default for TolerancesText {
    fn default() -> Self {
        let Tolerances { translation, rotation_degrees } = Tolerances::default();
        Self { translation, rotation_degrees }
    }
}

impl TolerancesText {
    pub fn tolerances(&self) -> Tolerances {
        Tolerances { translation: self.translation, rotation_degrees: self.rotation_degrees }
    }
}

const fn default_samples_per_interval() -> u32 {
    4
}

const fn default_fps() -> u32 {
    10
}

/// Parses a rubric: TOML where its name ends so, else JSON.
pub(super) fn parse(path: &Path, bytes: &[u8]) -> Result<RubricText, DecodeError> {
    let is_toml = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    if is_toml { decode::toml(bytes) } else { decode::json(bytes) }
}

impl RubricText {
    /// The wider bands.
    pub fn bands(&self) -> Vec<Band> {
        let band = |band: &BandText| Band {
            tolerances: Tolerances { translation: band.translation, rotation_degrees: band.rotation_degrees },
            share: band.share,
        };
        self.bands.iter().map(band).collect()
    }

    /// The numbers of the requirements.
    ///
    /// # Errors
    /// The first invalid one, as a sentence.
    pub fn requirements(&self) -> Result<Requirements, String> {
        self.requirements.checked(|requirement| self.points.of(requirement) > 0.0)
    }

    /// The first invalid value of the rubric but for its requirements, as a sentence.
    pub fn problem(&self) -> Option<String> {
        if self.format != "inbetween.rubric" {
            return Some(format!("format is {:?}, expected \"inbetween.rubric\"", self.format));
        }
        if self.version != 1 {
            return Some(format!("version is {}, and this program reads version 1", self.version));
        }
        if !(1..=1000).contains(&self.fps) {
            return Some(format!("fps is {}, expected a whole number from 1 to 1000", self.fps));
        }
        if self.samples_per_interval > 1000 {
            let count = self.samples_per_interval;
            return Some(format!("samples_per_interval is {count}, expected a whole number from 0 to 1000"));
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
            minimum_keyframes,
            minimum_nodes_moved,
            uses_catmull_rom,
            above_ground,
            no_jumps,
            script_runs,
        } = self.points;
        let numbers = [
            ("points.readable", readable),
            ("points.keyframe_count", keyframe_count),
            ("points.each_keyframe", each_keyframe),
            ("points.linear_playback", linear_playback),
            ("points.catmull_rom_playback", catmull_rom_playback),
            ("points.range_and_end", range_and_end),
            ("points.script", script),
            ("points.minimum_keyframes", minimum_keyframes),
            ("points.minimum_nodes_moved", minimum_nodes_moved),
            ("points.uses_catmull_rom", uses_catmull_rom),
            ("points.above_ground", above_ground),
            ("points.no_jumps", no_jumps),
            ("points.script_runs", script_runs),
            ("tolerances.translation", self.tolerances.translation),
            ("tolerances.rotation_degrees", self.tolerances.rotation_degrees),
        ];
        if let Some((name, number)) = numbers.into_iter().find(|(_, number)| !(0.0..=1e6).contains(number)) {
            return Some(format!("{name} is {number}, expected 0 to 1000000"));
        }
        let needs_reference = [
            ("points.keyframe_count", keyframe_count),
            ("points.each_keyframe", each_keyframe),
            ("points.script", script),
        ];
        let needing = needs_reference.into_iter().find(|(_, points)| *points > 0.0 && self.reference.is_none());
        if let Some((name, _)) = needing {
            return Some(format!("{name} is there, but reference names no file"));
        }
        if self.playback == PlaybackText::Assumed && self.reference.is_none() {
            return Some("playback is \"assumed\", but reference names no file to compare with".to_owned());
        }
        if let Some(problem) = credit::problem(self.tolerances.tolerances(), &self.bands()) {
            return Some(problem);
        }
        if let Some(problem) = self.late.as_ref().and_then(Late::problem) {
            return Some(problem);
        }
        let has_no_script = script > 0.0 && self.script.is_none();
        has_no_script.then(|| "points.script is there, but script names no file".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files;
    use crate::grading::rubric::LARGEST_BYTES;

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
