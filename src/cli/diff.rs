//! `inbetween diff`: how far two animations are apart, node by node, as they play.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::arguments::DiffArguments;
use super::each::{Done, Telling, each, tell};
use super::places::Places;
use super::reading::Notes;
use super::{CliError, Common, Ended, reading, scene};
use crate::animation_diff::{Deviation, Difference, Played, Tolerances, compare, frame_times_ms};
use crate::files::FileError;
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeList, PlayRange, to_f64};
use crate::scene::SceneGraph;
use crate::storage::input_name;

/// The most frames that are compared.
const MOST_FRAMES: usize = 1_000_000;

/// Prints the differences, as tables or as JSON. The animations are [`Ended::Beyond`] where any two are apart by more than the
/// tolerances, or play for different times. Quiet, one line says so of those that are.
///
/// # Errors
/// [`CliError`] with status 2: they cannot be compared.
pub fn run(arguments: &DiffArguments, common: Common<'_>) -> Result<Ended, CliError> {
    let others = &arguments.others;
    let places = Places::with_scene(common.scene).reads("A", &arguments.a);
    others.iter().fold(places, |places, other| places.reads("B", other)).check()?;
    let reference = || -> Result<_, CliError> {
        let scene = scene::load(common.scene)?;
        let mut notes = Notes::default();
        let a = Side::load(&arguments.a, &scene, arguments.interpolation, common, &mut notes)?;
        notes.say();
        Ok((scene, a))
    };
    let (scene, a) = reference().map_err(CliError::into_trouble)?;
    let range = a.range(&arguments.a).map_err(|error| CliError::from(error).into_trouble())?;
    let shown = |other: &PathBuf| input_name(other);
    let named = |other: &PathBuf| json!({"a": input_name(&arguments.a), "b": input_name(other)});
    let outcomes = each(others, common, shown, named, |other, notes| {
        let pair = Pair { arguments, scene: &scene, a: &a, range_a: &range, other };
        pair.compare(common, notes).map_err(CliError::into_trouble)
    })?;
    tell(outcomes, Telling { is_json: arguments.json, data: None }).map_err(CliError::into_trouble)
}

struct Side {
    list: KeyframeList,
    interpolation: Interpolation,
    ms_between_keyframes: u32,
}

impl Side {
    fn load(
        file: &Path,
        scene: &SceneGraph,
        interpolation: Option<Interpolation>,
        common: Common<'_>,
        notes: &mut Notes,
    ) -> Result<Self, FileError> {
        let read = reading::noted_keyframes(file, scene, common, notes)?;
        let (list, in_file, ms_between_keyframes) = read.file.into_parts();
        Ok(Self { list, interpolation: interpolation.unwrap_or(in_file), ms_between_keyframes })
    }

    fn range(&self, file: &Path) -> Result<PlayRange<'_>, FileError> {
        PlayRange::new(&self.list).map_err(|error| FileError::new(input_name(file), error))
    }

    fn played<'a>(&self, range: &'a PlayRange<'a>) -> Played<'a> {
        Played { range, interpolation: self.interpolation, ms_between_keyframes: self.ms_between_keyframes }
    }
}

/// The reference and one other.
struct Pair<'a> {
    arguments: &'a DiffArguments,
    scene: &'a SceneGraph,
    a: &'a Side,
    range_a: &'a PlayRange<'a>,
    other: &'a Path,
}

impl Pair<'_> {
    fn compare(&self, common: Common<'_>, notes: &mut Notes) -> Result<Done, CliError> {
        let Self { arguments, scene, a, range_a, other } = self;
        let b = Side::load(other, scene, arguments.interpolation, common, notes)?;
        let range_b = b.range(other)?;
        let (played_a, played_b) = (a.played(range_a), b.played(&range_b));
        let tolerances =
            Tolerances { translation: arguments.tolerance_translation, rotation_degrees: arguments.tolerance_rotation };
        let length_ms = played_a.length_ms().max(played_b.length_ms());
        let bad = |problem: String| CliError::bad_input(input_name(&arguments.a), problem);
        let times = frame_times_ms(&length_ms, arguments.fps, MOST_FRAMES)
            .ok_or_else(|| bad(format!("more than {MOST_FRAMES} frames to compare: choose a lower --fps")))?;
        let difference = compare(played_a, played_b, &times, tolerances).map_err(|error| bad(error.to_string()))?;
        let mut remarks = Vec::new();
        if played_a.length_ms() != played_b.length_ms() {
            remarks.push(format!(
                "they play for different times, {} ms and {} ms: the shorter one is compared by its end from there on",
                to_f64(&played_a.length_ms()),
                to_f64(&played_b.length_ms())
            ));
        }
        if a.interpolation != b.interpolation {
            remarks.push(format!(
                "the first is played {}, the second {}",
                a.interpolation.name(),
                b.interpolation.name()
            ));
        }
        let is_within = difference.is_within() && played_a.length_ms() == played_b.length_ms();
        let frames = times.len();
        let report =
            DifferenceReport { difference: &difference, scene, tolerances, frames, notes: &remarks, is_within };
        let name = input_name(other);
        let lines = match (common.is_quiet, is_within, arguments.others.len()) {
            (true, true, _) => String::new(),
            (true, false, _) => format!("{name}: {}\n", report.summary()),
            (false, _, 1) => report.table(),
            (false, ..) => format!("{name}:\n{}\n", report.table()),
        };
        let ended = if is_within { Ended::Well } else { Ended::Beyond };
        Ok(Done::ended(ended, lines, report.json(arguments.fps)))
    }
}

struct DifferenceReport<'a> {
    difference: &'a Difference,
    scene: &'a SceneGraph,
    tolerances: Tolerances,
    frames: usize,
    notes: &'a [String],
    is_within: bool,
}

impl DifferenceReport<'_> {
    /// The first difference beyond its tolerance: key time, node and part.
    fn first_exceeded(&self) -> Option<(f64, &str, &'static str)> {
        let parts = self
            .difference
            .nodes
            .iter()
            .zip(self.scene.rbt_paths())
            .flat_map(|(node, path)| [(node.translation, path, "translation"), (node.rotation, path, "rotation")]);
        parts
            .filter_map(|(deviation, path, part)| Some((deviation.exceeds_at?, path, part)))
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }

    fn json(&self, fps: u32) -> Value {
        let deviation = |deviation: &Deviation| {
            json!({"largest": deviation.largest, "largest_at": deviation.largest_at, "rms": deviation.rms,
                "exceeds_at": deviation.exceeds_at})
        };
        let nodes: Vec<Value> = self
            .difference
            .nodes
            .iter()
            .zip(self.scene.rbt_paths())
            .map(|(node, path)| {
                json!({"node": path, "translation": deviation(&node.translation), "rotation": deviation(&node.rotation)})
            })
            .collect();
        let first = self
            .first_exceeded()
            .map(|(key_time, node, part)| json!({"key_time": key_time, "node": node, "part": part}));
        json!({
            "within_tolerance": self.is_within,
            "tolerance_translation": self.tolerances.translation,
            "tolerance_rotation": self.tolerances.rotation_degrees,
            "fps": fps,
            "frames": self.frames,
            "notes": self.notes,
            "first_exceeded": first,
            "nodes": nodes,
        })
    }

    fn table(&self) -> String {
        let width = self.scene.rbt_paths().map(|path| path.chars().count()).max().unwrap_or(0).max(4);
        let mut text = format!(
            "{:width$}  {:>12} {:>12}  {:>12} {:>12}  exceeds at\n{:width$}  {:>12} {:>12}  {:>12} {:>12}  key time\n",
            "node",
            "translation",
            "translation",
            "rotation",
            "rotation",
            "",
            "largest",
            "rms",
            "largest deg",
            "rms deg"
        );
        for (node, path) in self.difference.nodes.iter().zip(self.scene.rbt_paths()) {
            let exceeds = match (node.translation.exceeds_at, node.rotation.exceeds_at) {
                (Some(a), Some(b)) => format!("{:.4}", a.min(b)),
                (Some(at), None) | (None, Some(at)) => format!("{at:.4}"),
                (None, None) => "-".to_owned(),
            };
            let _ = writeln!(
                text,
                "{path:width$}  {:>12.6} {:>12.6}  {:>12.6} {:>12.6}  {exceeds}",
                node.translation.largest, node.translation.rms, node.rotation.largest, node.rotation.rms
            );
        }
        for note in self.notes {
            let _ = writeln!(text, "Note: {note}.");
        }
        let _ = writeln!(text, "{}", self.summary());
        text
    }

    /// Whether they are within the tolerances, and what is not first: a sentence.
    fn summary(&self) -> String {
        let Tolerances { translation, rotation_degrees } = self.tolerances;
        let frames = self.frames;
        match self.first_exceeded() {
            Some((key_time, node, part)) => format!(
                "Beyond the tolerances ({translation} units, {rotation_degrees} degrees) over {frames} frames, first the {part} of \
                 {node} at key time {key_time:.4}."
            ),
            None => format!(
                "Within the tolerances ({translation} units, {rotation_degrees} degrees) over {frames} frames{}.",
                if self.is_within { "" } else { ", but not of one length" }
            ),
        }
    }
}
