//! Poses with names: files in the user's own folder of poses, or anywhere.

use std::path::{Path, PathBuf};

use crate::editor::{FileOutcome, Written};
use crate::pose_file::{LARGEST_POSE_BYTES, PoseFile, is_pose_name, shipped_poses};
use crate::storage;
use crate::words::texts;

/// The ending of a pose's file.
const ENDING: &str = ".json";
/// The most poses of the user's own that are listed.
const MOST_OWN: usize = 500;

/// The file of the pose that a user names: a text with a folder or the ending `.json` is a path, any other the name of a file in the
/// user's own folder of poses.
///
/// # Errors
/// The system has no folder for settings.
pub fn path(name: &str) -> FileOutcome<PathBuf> {
    if is_path(name) {
        return Ok(PathBuf::from(name));
    }
    let folder = storage::poses_path().ok_or(texts::POSES_NO_FOLDER)?;
    Ok(folder.join(format!("{name}{ENDING}")))
}

fn is_path(name: &str) -> bool {
    name.contains(['/', '\\']) || name.ends_with(ENDING)
}

/// Reads the file of a pose.
///
/// # Errors
/// Why it cannot be read.
pub fn read(name: &str) -> FileOutcome<Vec<u8>> {
    let path = path(name)?;
    storage::read(&path, LARGEST_POSE_BYTES).map_err(|error| {
        let is_missing =
            matches!(&error, storage::StorageError::System(error) if error.kind() == std::io::ErrorKind::NotFound);
        if is_path(name) || !is_missing {
            return error.message();
        }
        let names: Vec<&str> = shipped_poses().iter().map(|pose| pose.name.as_str()).collect();
        texts::poses_unknown(names.join(", "))
    })
}

/// Writes the file of a pose. What the file held before is copied beside it. The user's own folder is made where it is missing.
///
/// # Errors
/// Why it was not written; a regular file is then unchanged.
pub fn write(name: &str, text: &str) -> FileOutcome<(PathBuf, Written)> {
    let path = path(name)?;
    let write = || {
        if let Some(folder) = storage::poses_path().filter(|folder| path.parent() == Some(folder.as_path())) {
            storage::create_folder(&folder)?;
        }
        let kept = storage::keep_copy(&path)?;
        storage::write(&path, text.as_bytes())?;
        Ok(Written { kept, ..Written::default() })
    };
    let written = write().map_err(|error: storage::StorageError| error.message())?;
    Ok((path, written))
}

/// The user's own poses, by name. Files that are none are left out: they are named when they are asked for.
#[must_use]
pub fn own() -> Vec<PoseFile> {
    storage::poses_path().map(|folder| in_folder(&folder)).unwrap_or_default()
}

fn in_folder(folder: &Path) -> Vec<PoseFile> {
    let Ok((entries, _)) = storage::list(folder, MOST_OWN) else { return Vec::new() };
    let names = entries.iter().filter_map(|entry| Some((&entry.path, entry.name.strip_suffix(ENDING)?)));
    let mut poses: Vec<PoseFile> = names
        .filter(|(_, name)| is_pose_name(name))
        .filter_map(|(file, name)| {
            let bytes = storage::read(file, LARGEST_POSE_BYTES).ok()?;
            let pose = PoseFile::from_json(&bytes).ok()?;
            Some(PoseFile { name: name.to_owned(), ..pose })
        })
        .collect();
    poses.sort_by(|a, b| a.name.cmp(&b.name));
    poses
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_of_the_own_folder_and_paths_are_paths() {
        for name in ["a.json", "b/a", "b\\a", "/tmp/a.json"] {
            assert_eq!(path(name), Ok(PathBuf::from(name)));
        }
        let Some(folder) = storage::poses_path() else { return };
        assert_eq!(path("my wave"), Ok(folder.join("my wave.json")));
    }

    #[test]
    fn the_poses_of_a_folder_are_those_that_can_be_read() {
        let folder = tempfile::tempdir().unwrap();
        let text = crate::pose_file::shipped_poses()[2].to_json();
        for (name, text) in [("b.json", text.as_str()), ("a.json", &text), ("broken.json", "{"), ("notes.txt", &text)] {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        let names: Vec<String> = in_folder(folder.path()).into_iter().map(|pose| pose.name).collect();
        assert_eq!(names, ["a", "b"]);
    }
}
