//! The reference: the right keyframes.

use std::path::Path;

use crate::files::FileError;
use crate::grading::folder;
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeList, PlayRange};
use crate::scene::SceneGraph;
use crate::text_layouts::read_keyframes;

/// The right keyframes.
#[derive(Clone, Debug)]
pub struct Reference {
    /// The keyframes, enough to play.
    pub list: KeyframeList,
    /// Their interpolation.
    pub interpolation: Interpolation,
    /// Milliseconds between them.
    pub ms_between_keyframes: u32,
    /// The bytes of a file that holds them; of a script, a keyframe file of what it made.
    pub bytes: Vec<u8>,
}

impl Reference {
    /// Reads a keyframe file, or runs a script that makes one. `path` is named in errors.
    ///
    /// # Errors
    /// [`FileError`]
    pub(super) fn read(path: &Path, given: Vec<u8>, scene: &SceneGraph) -> Result<Self, FileError> {
        let bad = |problem: String| FileError::new(path.display(), problem);
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
        Ok(Self { list, interpolation, ms_between_keyframes, bytes })
    }

    /// The played part of the keyframes.
    #[must_use]
    pub fn range(&self) -> PlayRange<'_> {
        PlayRange::new(&self.list).expect("it was checked when it was read")
    }
}
