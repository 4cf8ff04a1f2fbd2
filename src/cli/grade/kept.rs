//! What `grade` keeps between runs: marks and pictures, so that only what has changed is graded again.

use std::path::{Path, PathBuf};

use crate::cli::CliError;
use crate::cli::arguments::GradeArguments;
use crate::files;
use crate::grading::{Basis, Cache, Key, MOST_KEPT_BYTES, hash};
use crate::storage;

/// The name of the file.
const NAME: &str = "grades.cache";
/// The largest program that is read to tell builds apart: 1 GiB.
const LARGEST_PROGRAM_BYTES: u64 = 1 << 30;

/// What tells builds of the program apart, also where two have the same version: the hash of its own bytes; `None` where these cannot be
/// read.
pub fn program() -> Option<Key> {
    let bytes = storage::read(&std::env::current_exe().ok()?, LARGEST_PROGRAM_BYTES).ok()?;
    Some(hash(&[&bytes]))
}

/// What stands for the hash where the program's bytes cannot be read: its version.
pub fn version() -> Key {
    env!("CARGO_PKG_VERSION").to_owned()
}

/// The file in which results are kept: in the folder that the arguments name, or in `.cache` in the folder of the results. `None` if
/// nothing is kept.
pub fn file(arguments: &GradeArguments, folder: &Path) -> Option<PathBuf> {
    // Results without names are handed on with their folder: file names in it may be names. A shard is itself what is kept.
    let keeps_unasked = !arguments.no_cache && !arguments.anonymous && arguments.shard.is_none();
    let folder = arguments.cache.clone().or_else(|| keeps_unasked.then(|| folder.join(".cache")));
    folder.map(|folder| folder.join(NAME))
}

/// The results of earlier runs. What cannot be read is left out.
pub fn read(file: Option<&Path>, basis: &Basis) -> Cache {
    let text = file.and_then(|file| storage::read(file, MOST_KEPT_BYTES as u64).ok());
    Cache::new(&text.unwrap_or_default(), basis)
}

/// Writes results for the next run.
///
/// # Errors
/// [`CliError`]: the folder cannot be written to.
pub fn write(file: Option<&Path>, cache: &Cache) -> Result<(), CliError> {
    let (Some(file), Some(text)) = (file, cache.text()) else { return Ok(()) };
    if let Some(folder) = file.parent() {
        files::create_folder(folder)?;
    }
    Ok(files::write(file, text.as_bytes())?)
}
