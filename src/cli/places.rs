//! Where a command reads and writes: nothing is read twice from standard input, and no file is written twice or over an input.

use std::path::Path;

use super::arguments::ProgressKind;
use super::{CliError, misuse, scene};
use crate::storage::{self, Place};
use crate::words::texts;

/// The inputs and outputs of a command, by the names that the user knows them by.
#[derive(Debug, Default)]
pub struct Places {
    all: Vec<Named>,
}

#[derive(Debug)]
struct Named {
    /// What the user calls it.
    name: String,
    /// Two of one kind may name one file: a script may write the keyframe file that it reads. `None`: nothing else may name its file.
    kind: Option<&'static str>,
    place: Place,
    is_written: bool,
}

impl Places {
    /// The inputs and outputs of a command that reads a scene.
    pub fn with_scene(scene: Option<&Path>) -> Self {
        let places = Self::default();
        match scene::file_of(scene) {
            Some(file) => {
                // Its meshes are as good as part of it.
                let meshes = Some(file.with_extension("glb")).filter(|meshes| storage::exists(meshes));
                let places = places.reads("--scene", file);
                meshes.into_iter().fold(places, |places, meshes| places.reads("--scene", &meshes))
            }
            None => places,
        }
    }

    /// Adds an input.
    pub fn reads(self, kind: &'static str, path: &Path) -> Self {
        self.reads_as(kind.to_owned(), kind, path)
    }

    /// Adds an input whose name is not its kind's.
    pub fn reads_as(mut self, name: String, kind: &'static str, path: &Path) -> Self {
        self.all.push(Named { name, kind: Some(kind), place: Place::of_input(path), is_written: false });
        self
    }

    /// Adds an output.
    pub fn writes(self, kind: &'static str, path: &Path) -> Self {
        self.writes_as(kind.to_owned(), kind, path)
    }

    /// Adds an output whose name is not its kind's.
    pub fn writes_as(mut self, name: String, kind: &'static str, path: &Path) -> Self {
        self.all.push(Named { name, kind: Some(kind), place: Place::of_output(path), is_written: true });
        self
    }

    /// Adds an output of which there may be many: none may be another's file.
    pub fn writes_once(mut self, name: String, path: &Path) -> Self {
        self.all.push(Named { name, kind: None, place: Place::of_output(path), is_written: true });
        self
    }

    /// Adds standard output where progress goes there.
    pub fn tells(self, progress: ProgressKind) -> Self {
        if progress == ProgressKind::Openjd { self.prints("--progress openjd") } else { self }
    }

    /// Adds what is written to standard output anyway.
    pub fn prints(mut self, kind: &'static str) -> Self {
        self.all.push(Named { name: kind.to_owned(), kind: Some(kind), place: Place::Standard, is_written: true });
        self
    }

    /// Checks that they go together.
    ///
    /// # Errors
    /// Wrong usage, with the names of two that do not.
    pub fn check(mut self) -> Result<(), CliError> {
        // By place, and in the order given where that is the same: equal places are neighbours.
        let key = |named: &Named| match &named.place {
            Place::File(path) => Some((0, Some(path.clone()))),
            Place::Standard => Some((1 + usize::from(named.is_written), None)),
            Place::Stream => None,
        };
        self.all.sort_by_cached_key(key);
        for same in self.all.chunk_by(|one, other| key(one) == key(other)) {
            let first = &same[0];
            let conflict = match first.place {
                Place::Stream => None,
                Place::Standard => same.get(1).map(|second| (first, second)),
                Place::File(_) => {
                    let is_any_written = same.iter().any(|named| named.is_written);
                    let is_other =
                        |named: &&Named| is_any_written && (named.kind.is_none() || named.kind != first.kind);
                    same.iter().skip(1).find(is_other).map(|second| (first, second))
                }
            };
            if let Some((one, other)) = conflict {
                let sentence = match (&one.place, one.is_written) {
                    (Place::File(_) | Place::Stream, _) => texts::places_same_file(&one.name, &other.name),
                    (Place::Standard, false) => texts::places_both_read_standard(&one.name, &other.name),
                    (Place::Standard, true) => texts::places_both_write_standard(&one.name, &other.name),
                };
                return Err(misuse(&sentence.to_string()));
            }
        }
        Ok(())
    }
}
