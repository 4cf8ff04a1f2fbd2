//! Which images `compare` compares with which.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::super::{CliError, misuse};
use crate::files::FileError;
use crate::storage::{self, input_name};
use crate::words::texts;

/// The most images of a folder that are compared.
const MOST_IMAGES: usize = 100_000;

/// Two images; or one that has no other of its name in the other folder.
pub struct Pair {
    pub first: PathBuf,
    pub second: Option<PathBuf>,
    /// The folder that has no such image; empty where there is a second one.
    pub folder: PathBuf,
    /// Whether they are of two folders that are compared.
    pub is_of_folders: bool,
}

impl Pair {
    fn of(first: &Path, second: &Path) -> Self {
        let second = Some(second.to_owned());
        Self { first: first.to_owned(), second, folder: PathBuf::new(), is_of_folders: false }
    }

    /// The second image.
    pub fn other(&self) -> Option<PathBuf> {
        self.second.clone()
    }

    /// What it is called in results.
    pub fn name(&self) -> String {
        input_name(self.second.as_ref().unwrap_or(&self.first))
    }

    /// The fields that name it.
    pub fn json(&self) -> Value {
        json!({"a": input_name(&self.first), "b": self.second.as_deref().map(input_name)})
    }
}

/// The first image with each of the others; or the images of two folders by their names.
///
/// # Errors
/// Wrong usage: a folder beside images; status 2: a folder that cannot be read, or two that have no image.
pub fn pairs(first: &Path, others: &[PathBuf]) -> Result<Vec<Pair>, CliError> {
    let is_folder = |path: &Path| !storage::is_standard(path) && storage::is_folder(path);
    match (is_folder(first), others) {
        (false, others) if !others.iter().any(|other| is_folder(other)) => {
            Ok(others.iter().map(|other| Pair::of(first, other)).collect())
        }
        (true, [other]) if is_folder(other) => {
            of_folders(first, other).map_err(|error| CliError::from(error).into_trouble())
        }
        _ => Err(misuse(texts::COMPARE_TWO_FOLDERS.english())),
    }
}

fn of_folders(first: &Path, second: &Path) -> Result<Vec<Pair>, FileError> {
    let (a, b) = (images(first)?, images(second)?);
    if a.is_empty() && b.is_empty() {
        return Err(FileError::new(first.display(), texts::COMPARE_NO_IMAGES));
    }
    let pair = |name: &OsString| match (a.contains(name), b.contains(name)) {
        (true, true) => Pair { is_of_folders: true, ..Pair::of(&first.join(name), &second.join(name)) },
        (true, false) => Pair { first: first.join(name), second: None, folder: second.to_owned(), is_of_folders: true },
        _ => Pair { first: second.join(name), second: None, folder: first.to_owned(), is_of_folders: true },
    };
    Ok(a.union(&b).map(pair).collect())
}

/// The names of the PNG images of a folder.
fn images(folder: &Path) -> Result<BTreeSet<OsString>, FileError> {
    let (entries, _) =
        storage::list(folder, MOST_IMAGES).map_err(|reason| FileError::storage(folder.display(), reason))?;
    let is_png = |path: &&PathBuf| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    let paths: Vec<PathBuf> = entries.into_iter().map(|entry| entry.path).collect();
    Ok(paths.iter().filter(is_png).filter_map(|path| Some(path.file_name()?.to_owned())).collect())
}
