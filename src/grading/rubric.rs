//! The rubric: graded items and their points, as JSON or TOML.

mod credit;
mod points;
mod reference;
mod text;

use std::path::{Path, PathBuf};

pub use credit::{Band, Credit};
pub use points::Points;
pub use reference::Reference;

use text::{PlaybackText, parse};

use super::check::Revealed;
use super::folder::{self, Traced};
use super::hash::Hashed;
use super::item::ItemKind;
use super::late::Late;
use super::names::PreferredNames;
use super::requirements::{Requirement, Requirements};
use crate::animation_diff::Tolerances;
use crate::files::{self, FileError};
use crate::interpolation::Interpolation;
use crate::scene::SceneGraph;
use crate::script::Line;
use crate::text::counted;

/// The largest rubric, and the largest of the files that it names, in bytes.
const LARGEST_BYTES: u64 = 64 << 20;

/// A rubric and the files that it names.
#[derive(Clone, Debug)]
pub struct Rubric {
    /// The title of the report.
    pub title: String,
    /// The points.
    pub points: Points,
    /// The tolerances.
    pub tolerances: Tolerances,
    /// How errors become shares of the points.
    pub credit: Credit,
    /// Whether submissions without samples earn points for playback by how this program plays their keyframes.
    pub assumes_playback: bool,
    /// How many samples of each node are asked in each interval between keyframes; 0 if none are.
    pub samples_per_interval: usize,
    /// Frames a second at which playback is compared that is played by this program.
    pub fps: u32,
    /// The right keyframes, where submissions are compared with some.
    pub reference: Option<Reference>,
    /// What lateness costs; `None` if nothing.
    pub late: Option<Late>,
    /// The numbers of the requirements.
    pub requirements: Requirements,
    /// How keyframe files are named, to choose among several.
    pub keyframe_file: PreferredNames,
    /// The hotkey script, where one is graded.
    pub script: Option<RubricScript>,
    /// The files that it names.
    pub files: Vec<PathBuf>,
    /// Its own file, then those that it names: names and bytes.
    pub sources: Vec<(String, Vec<u8>)>,
    /// Which known mistakes the reference reveals.
    pub revealed: Revealed,
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
        let count = self.reference.as_ref().map_or(0, |reference| reference.list.len());
        let keyframes = (0..count).map(move |index| (ItemKind::Keyframe(index), points.each_keyframe));
        let after = [
            (ItemKind::Playback(Interpolation::Linear), points.linear_playback),
            (ItemKind::Playback(Interpolation::CatmullRom), points.catmull_rom_playback),
            (ItemKind::RangeAndEnd, points.range_and_end),
            (ItemKind::Script, points.script),
        ];
        let requirements =
            Requirement::ALL.map(|requirement| (ItemKind::Requirement(requirement), points.of(requirement)));
        before.into_iter().chain(keyframes).chain(after).chain(requirements).filter(|(_, out_of)| *out_of > 0.0)
    }
}

impl Rubric {
    /// Its own file, then those that it names, by their contents.
    pub fn hashes(&self) -> impl Iterator<Item = Hashed> {
        self.sources.iter().map(|(name, bytes)| Hashed::new(name, bytes))
    }

    /// Reads a rubric and the files that it names, by paths from its own folder.
    ///
    /// # Errors
    /// [`FileError`]
    pub fn load(path: &Path, scene: &SceneGraph) -> Result<Self, FileError> {
        Self::read(path, scene, |_, path| files::read(path, LARGEST_BYTES))
    }

    /// The same with files that `read` gives, by the names by which the rubric and its text call them, and their paths.
    ///
    /// # Errors
    /// [`FileError`]
    pub fn read(
        path: &Path,
        scene: &SceneGraph,
        read: impl Fn(&str, &Path) -> Result<Vec<u8>, FileError>,
    ) -> Result<Self, FileError> {
        let bad = |problem: String| FileError::new(path.display(), problem);
        let own_name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        let bytes = read(&own_name, path)?;
        let text = parse(path, &bytes).map_err(|error| FileError::new(path.display(), error))?;
        if let Some(problem) = text.problem() {
            return Err(bad(problem));
        }
        let requirements = text.requirements().map_err(bad)?;
        let (least, nodes) = (requirements.minimum_nodes_moved, scene.rbt_count());
        if text.points.minimum_nodes_moved > 0.0 && least > nodes as u64 {
            return Err(bad(format!(
                "requirements.minimum_nodes_moved is {least}, and the scene has {} that keyframes move",
                counted(nodes, "node")
            )));
        }
        let keyframe_file =
            PreferredNames::new(&text.keyframe_file).map_err(|problem| bad(format!("keyframe_file: {problem}")))?;
        let mut sources = vec![(own_name, bytes)];
        let folder = path.parent().unwrap_or(Path::new(""));
        // Standard input is read by its own name alone.
        let beside = |name: &str| if name == "-" { PathBuf::from(name) } else { folder.join(name) };
        let files = text.script.iter().chain(&text.reference).map(|name| beside(name)).collect();
        let script = text.script.as_deref().map(|name| {
            let path = beside(name);
            Ok((read(name, &path)?, path))
        });
        let script = script.transpose()?;
        sources.extend(script.iter().zip(&text.script).map(|((bytes, _), name)| (name.clone(), bytes.clone())));
        let lines = script.map(|(bytes, path)| {
            folder::read_script(&bytes, scene).map_err(|problem| FileError::new(path.display(), problem))
        });
        let lines = lines.transpose()?;
        let reference = text.reference.as_deref().map(|name| {
            let path = beside(name);
            let bytes = read(name, &path)?;
            sources.push((name.to_owned(), bytes.clone()));
            Reference::read(&path, bytes, scene)
        });
        let reference = reference.transpose()?;
        let bytes = reference.as_ref().map(|reference| reference.bytes.as_slice());
        let script =
            lines.map(|lines| RubricScript { expected: folder::run(&lines, scene, bytes).map(|ran| ran.trace), lines });
        let tolerances = text.tolerances.tolerances();
        let credit = Credit {
            share_of_frames: text.share_of_frames,
            follow_through: text.follow_through,
            align_keyframes: text.align_keyframes,
            ..Credit::new(tolerances, text.bands())
        };
        let mut rubric = Self {
            title: text.title,
            points: text.points,
            tolerances,
            credit,
            assumes_playback: text.playback == PlaybackText::Assumed,
            samples_per_interval: text.samples_per_interval as usize,
            fps: text.fps,
            reference,
            late: text.late,
            requirements,
            keyframe_file,
            script,
            files,
            sources,
            revealed: Revealed::default(),
        };
        rubric.revealed = Revealed::by(&rubric);
        Ok(rubric)
    }
}
