//! `inbetween diff`: how far two animations are apart, node by node, as they play.

use std::fmt::Write as _;
use std::path::Path;

use num_rational::BigRational;
use num_traits::ToPrimitive as _;
use serde_json::{Value, json};

use super::arguments::DiffArguments;
use super::{CliError, output, reading};
use crate::difference::{Deviation, Difference, Played, Tolerances, compare};
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeList, LARGEST_FILE_BYTES, PlayRange, to_f64, whole};
use crate::scene::SceneGraph;
use crate::storage;

/// The most frames that are compared.
const MOST_FRAMES: usize = 1_000_000;

/// Prints the differences, as a table or as JSON.
///
/// # Errors
/// [`CliError::Beyond`] where the animations are apart by more than the tolerances, or play for different times;
/// [`CliError::Trouble`] where they cannot be compared.
pub fn run(arguments: &DiffArguments, scene: Result<SceneGraph, CliError>) -> Result<(), CliError> {
    let trouble = |error: CliError| CliError::Trouble { sentences: vec![error.to_string()] };
    let report = scene.and_then(|scene| report(arguments, &scene)).map_err(trouble)?;
    output::print(|output| output.write_all(report.text.as_bytes())).map_err(trouble)?;
    if report.is_within { Ok(()) } else { Err(CliError::Beyond) }
}

struct Report {
    text: String,
    is_within: bool,
}

struct Side {
    list: KeyframeList,
    interpolation: Interpolation,
    ms_between_keyframes: u32,
}

fn load(file: &Path, scene: &SceneGraph, interpolation: Option<Interpolation>) -> Result<Side, CliError> {
    let place = file.display();
    let bytes = storage::read(file, LARGEST_FILE_BYTES).map_err(|error| CliError::bad_input(place, error))?;
    let read = reading::keyframes(&bytes, scene).map_err(|problems| CliError::BadInput {
        sentences: problems.iter().map(|problem| format!("{}: {problem}", file.display())).collect(),
    })?;
    for warning in read.warnings() {
        output::complain(&format!("{}: warning: {warning}", file.display()));
    }
    let (list, in_file, ms_between_keyframes) = read.file.into_parts();
    Ok(Side { list, interpolation: interpolation.unwrap_or(in_file), ms_between_keyframes })
}

fn report(arguments: &DiffArguments, scene: &SceneGraph) -> Result<Report, CliError> {
    let a = load(&arguments.a, scene, arguments.interpolation)?;
    let b = load(&arguments.b, scene, arguments.interpolation)?;
    let range = |side: &Side, file: &Path| {
        PlayRange::new(&side.list).map(|_| ()).map_err(|error| CliError::bad_input(file.display(), error))
    };
    range(&a, &arguments.a)?;
    range(&b, &arguments.b)?;
    let ranges = [&a, &b].map(|side| PlayRange::new(&side.list));
    let [Ok(range_a), Ok(range_b)] = &ranges else { unreachable!("both were found long enough to play") };
    let played = |side: &Side, range| Played {
        range,
        interpolation: side.interpolation,
        ms_between_keyframes: side.ms_between_keyframes,
    };
    let (played_a, played_b) = (played(&a, range_a), played(&b, range_b));
    let tolerances =
        Tolerances { translation: arguments.tolerance_translation, rotation_degrees: arguments.tolerance_rotation };
    let length_ms = played_a.length_ms().max(played_b.length_ms());
    let times = times_ms(&length_ms, arguments.fps).ok_or_else(|| {
        CliError::bad_input(
            arguments.a.display(),
            format!("more than {MOST_FRAMES} frames to compare: choose a lower --fps"),
        )
    })?;
    let difference = compare(played_a, played_b, &times, tolerances)
        .map_err(|error| CliError::bad_input(arguments.a.display(), error))?;
    let mut notes = Vec::new();
    if played_a.length_ms() != played_b.length_ms() {
        notes.push(format!(
            "they play for different times, {} ms and {} ms: the shorter one is compared by its end from there on",
            to_f64(&played_a.length_ms()),
            to_f64(&played_b.length_ms())
        ));
    }
    if a.interpolation != b.interpolation {
        notes.push(format!("the first is played {}, the second {}", a.interpolation.name(), b.interpolation.name()));
    }
    let is_within = difference.is_within() && played_a.length_ms() == played_b.length_ms();
    let shown = Shown { difference: &difference, scene, tolerances, frames: times.len(), notes: &notes, is_within };
    Ok(Report { text: if arguments.json { shown.json(arguments.fps) } else { shown.table() }, is_within })
}

/// Frame k at k · 1000/fps ms while that is short of the end, and the end; `None` where they are too many.
pub fn times_ms(length_ms: &BigRational, fps: u32) -> Option<Vec<BigRational>> {
    let period = whole(1000) / whole(fps as usize);
    let before_end = (length_ms / &period).ceil().to_integer().to_usize().filter(|&frames| frames <= MOST_FRAMES)?;
    let mut times: Vec<BigRational> = (0..before_end).map(|frame| whole(frame) * &period).collect();
    times.push(length_ms.clone());
    Some(times)
}

struct Shown<'a> {
    difference: &'a Difference,
    scene: &'a SceneGraph,
    tolerances: Tolerances,
    frames: usize,
    notes: &'a [String],
    is_within: bool,
}

impl Shown<'_> {
    /// What exceeds its tolerance first: key time, node, and which part.
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

    fn json(&self, fps: u32) -> String {
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
        let value = json!({
            "within_tolerance": self.is_within,
            "tolerance_translation": self.tolerances.translation,
            "tolerance_rotation": self.tolerances.rotation_degrees,
            "fps": fps,
            "frames": self.frames,
            "notes": self.notes,
            "first_exceeded": first,
            "nodes": nodes,
        });
        format!("{value}\n")
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
        let Tolerances { translation, rotation_degrees } = self.tolerances;
        let frames = self.frames;
        let _ = match self.first_exceeded() {
            Some((key_time, node, part)) => writeln!(
                text,
                "Beyond the tolerances ({translation} units, {rotation_degrees} degrees) over {frames} frames, first the {part} of \
                 {node} at key time {key_time:.4}."
            ),
            None => writeln!(
                text,
                "Within the tolerances ({translation} units, {rotation_degrees} degrees) over {frames} frames{}.",
                if self.is_within { "" } else { ", but not of one length" }
            ),
        };
        text
    }
}
