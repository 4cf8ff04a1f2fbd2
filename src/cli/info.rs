//! `inbetween info`: what a keyframe file holds, and how long its film is.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::arguments::InfoArguments;
use super::each::{Done, Telling, each, tell};
use super::places::Places;
use super::reading::Notes;
use super::{CliError, Common, Ended, output, reading, scene};
use crate::export::{Animation, ExportError, FrameTime, Moments, Source, Span, Viewpoint};
use crate::keyframe::PlayRange;
use crate::scene::{Channel, NodeKind, SceneGraph, Tracks};
use crate::storage::input_name;
use crate::text::counted;
use crate::text_layouts::Report;

/// Prints what the files and the scene hold; of several, each by itself.
///
/// # Errors
/// [`CliError`]
pub fn run(arguments: &InfoArguments, common: Common<'_>) -> Result<Ended, CliError> {
    let places = Places::with_scene(common.scene);
    arguments.files.iter().fold(places, |places, file| places.reads("FILE", file)).check()?;
    let scene = &scene::load(common.scene)?;
    if let [] | [_] = arguments.files.as_slice() {
        let mut notes = Notes::default();
        let (lines, fields) =
            described(arguments.files.first().map(PathBuf::as_path), scene, arguments, common, &mut notes)?;
        notes.say();
        output::say(&if arguments.json { format!("{fields:#}\n") } else { lines })?;
        return Ok(Ended::Well);
    }
    let shown = |file: &PathBuf| input_name(file);
    let named = |file: &PathBuf| json!({"file": input_name(file)});
    let mut is_first = true;
    let outcomes = each(&arguments.files, common, shown, named, |file, notes| {
        let (lines, fields) = described(Some(file), scene, arguments, common, notes)?;
        let before = if std::mem::take(&mut is_first) { "" } else { "\n" };
        Ok(Done::well(format!("{before}{lines}"), fields))
    })?;
    tell(outcomes, Telling { is_json: arguments.json, data: None })
}

/// What a file and the scene hold, in lines and as JSON.
fn described(
    file: Option<&Path>,
    scene: &SceneGraph,
    arguments: &InfoArguments,
    common: Common<'_>,
    notes: &mut Notes,
) -> Result<(String, Value), CliError> {
    let read = file.map(|file| reading::noted_keyframes(file, scene, common, notes)).transpose()?;
    let report = read.as_ref().and_then(|read| read.report.clone());
    let animation = read.map(|read| Animation::of(read.file, None));
    let film = Film::of(Source { scene, animation: animation.as_ref(), file }, arguments.fps)?;
    let info = Info { file, scene, animation: animation.as_ref(), report: report.as_ref(), film, fps: arguments.fps };
    Ok((info.lines(), info.json()))
}

/// The film that `render` makes of the whole file.
struct Film {
    frames: usize,
    seconds: f64,
}

impl Film {
    /// Nothing that plays or moves is a film of no frames.
    fn of(source: Source<'_>, fps: u32) -> Result<Self, ExportError> {
        let Some(animation) = source.animation else {
            let Some(seconds) = source.scene.last_second().filter(|&seconds| seconds > 0.0) else {
                return Ok(Self { frames: 0, seconds: 0.0 });
            };
            return Self::with_frames(source, fps, seconds);
        };
        let Ok(range) = PlayRange::new(&animation.keyframes) else { return Ok(Self { frames: 0, seconds: 0.0 }) };
        let end = FrameTime::at_key_time(range.last_key_time() as f64, animation.ms_between_keyframes, range.timing());
        Self::with_frames(source, fps, end.ms / 1000.0)
    }

    fn with_frames(source: Source<'_>, fps: u32, seconds: f64) -> Result<Self, ExportError> {
        let viewpoint = Viewpoint::named(None, source.scene)?;
        let frames = Moments::of_film(Span::default(), source, viewpoint, fps)?.all.len();
        Ok(Self { frames, seconds })
    }
}

struct Info<'a> {
    file: Option<&'a Path>,
    scene: &'a SceneGraph,
    animation: Option<&'a Animation>,
    /// What was inferred from a text; a keyframe file has none.
    report: Option<&'a Report>,
    film: Film,
    fps: u32,
}

impl Info<'_> {
    fn json(&self) -> Value {
        let (keys, last_second) = self.timed_keys();
        let keyframes = self.animation.map(|animation| {
            json!({
                "count": animation.keyframes.len(),
                "played": played(animation),
                "interpolation": animation.interpolation.name(),
                "ms_between_keyframes": animation.ms_between_keyframes,
                "durations": animation.keyframes.as_slice().iter().map(|keyframe| keyframe.duration).collect::<Vec<f64>>(),
            })
        });
        json!({
            "file": self.file.map(input_name),
            "text": self.report.map(|report| report.summary.to_string()),
            "scene": self.scene.name(),
            "nodes": self.scene.rbt_count(),
            "scene_nodes": self.scene.nodes().len(),
            "keyframes": keyframes,
            "timed_keys": {"count": keys, "last_seconds": last_second},
            "seconds": self.film.seconds,
            "fps": self.fps,
            "frames": self.film.frames,
        })
    }

    fn lines(&self) -> String {
        let mut lines: Vec<(&str, String)> = Vec::new();
        if let Some(file) = self.file {
            let kind = self.report.map_or_else(|| "a keyframe file".to_owned(), |report| report.summary.to_string());
            lines.push(("file", format!("{}: {kind}", input_name(file))));
        }
        let (nodes, all) = (self.scene.rbt_count(), self.scene.nodes().len());
        lines.push(("scene", format!("{}: {}, {nodes} of them in poses", self.scene.name(), counted(all, "node"))));
        if let Some(animation) = self.animation {
            let count = animation.keyframes.len();
            let are_played = match played(animation) {
                0 => "too few to play: an animation has 4 or more".to_owned(),
                played => format!("{played} of them played"),
            };
            lines.push(("keyframes", format!("{count}, {are_played}")));
            lines.push(("interpolation", animation.interpolation.name().to_owned()));
            lines.push(("between", format!("{} ms", animation.ms_between_keyframes)));
            lines.push(("durations", durations(animation)));
        }
        let (keys, last_second) = self.timed_keys();
        let until = last_second.map_or_else(String::new, |seconds| format!(", the last at {seconds} s"));
        lines.push(("timed keys", format!("{keys}{until}")));
        lines.push(("length", format!("{} s", self.film.seconds)));
        let numbers = self.film.frames.checked_sub(1).map_or_else(String::new, |last| format!(": 0 to {last}"));
        lines.push(("frames", format!("{} with {} a second{numbers}", self.film.frames, self.fps)));
        let mut text = String::new();
        for (name, value) in lines {
            let _ = writeln!(text, "{name:<15}{value}");
        }
        text
    }

    /// How many timed keys the scene has, and the time of the last, in seconds.
    fn timed_keys(&self) -> (usize, Option<f64>) {
        let of_tracks = |tracks: &Tracks| -> usize {
            Channel::ALL.iter().filter_map(|channel| tracks.get(*channel)).map(|track| track.keys().count()).sum()
        };
        let of_node = |kind: &NodeKind| match kind {
            NodeKind::Rbt(_) => 0,
            NodeKind::Shape(placed) => of_tracks(placed.tracks()),
            NodeKind::Control(tracks) => of_tracks(tracks),
        };
        (self.scene.nodes().iter().map(|node| of_node(&node.kind)).sum(), self.scene.last_second())
    }
}

/// How many keyframes of the list are played: all but the first and the last, if these are enough.
fn played(animation: &Animation) -> usize {
    PlayRange::new(&animation.keyframes).map_or(0, |range| range.last_key_time() + 1)
}

fn durations(animation: &Animation) -> String {
    let own: Vec<f64> =
        animation.keyframes.as_slice().iter().map(|keyframe| keyframe.duration).filter(|&d| d != 1.0).collect();
    let (Some(least), Some(most)) = (own.iter().copied().reduce(f64::min), own.iter().copied().reduce(f64::max)) else {
        return "1 each".to_owned();
    };
    let range = if least == most { least.to_string() } else { format!("{least} to {most}") };
    format!("{} of {} differ from 1: {range}", own.len(), animation.keyframes.len())
}
