//! Where the results of several inputs go: one file, or a folder with a file for each.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use super::{CliError, misuse};
use crate::files::{self, FileError};
use crate::film::{Format, format_of_path};
use crate::storage;
use crate::words::texts;

/// Whether an output is a folder: one that is there, a name that ends like one, or that of several results.
pub fn is_folder(output: &Path, results: usize) -> bool {
    let ends_like_one = output.to_string_lossy().ends_with(std::path::is_separator);
    !storage::is_standard(output) && (results > 1 || ends_like_one || storage::is_folder(output))
}

/// The ending of an output's name in small letters, if it is a file with one.
pub fn ending_of(output: &Path, results: usize) -> Option<String> {
    let ending = output.extension().filter(|_| !is_folder(output, results))?;
    Some(ending.to_string_lossy().to_ascii_lowercase())
}

/// The format of a file: the one that was named, or that of its ending; `None` where neither tells one.
///
/// # Errors
/// Wrong usage: they are two.
pub fn format_named(named: Option<&'static Format>, output: &Path) -> Result<Option<&'static Format>, CliError> {
    match (named, format_of_path(output)) {
        (Some(named), Some(found)) if named.ending != found.ending => {
            let option = format!("--format {}", named.ending);
            Err(misuse(&texts::places_ending_contradicts(found.ending, option).to_string()))
        }
        (named, found) => Ok(named.or(found)),
    }
}

/// The results of the inputs. In a folder, the result of `NAME.txt` is `NAME.` and the ending. The output is a folder where
/// [`is_folder`] says so, and where `needs_folder`.
///
/// # Errors
/// Wrong usage: several results, and the output is standard output or has the ending of a file; two results with one name.
pub fn targets(inputs: &[PathBuf], output: &Path, ending: &str, needs_folder: bool) -> Result<Vec<PathBuf>, CliError> {
    let needs_folder = needs_folder || inputs.len() > 1;
    if storage::is_standard(output) || !(needs_folder || is_folder(output, inputs.len())) {
        return if needs_folder {
            Err(misuse(&texts::places_no_folder("--output").to_string()))
        } else {
            Ok(vec![output.to_owned()])
        };
    }
    if output.extension().is_some_and(|found| found == ending) && !storage::is_folder(output) {
        return Err(misuse(&texts::places_folder_for_several(output.display()).to_string()));
    }
    let mut sources: HashMap<PathBuf, &Path> = HashMap::new();
    let mut targets = Vec::with_capacity(inputs.len());
    for input in inputs {
        let stem =
            if storage::is_standard(input) { "standard-input".as_ref() } else { input.file_stem().unwrap_or_default() };
        let mut name = stem.to_owned();
        name.push(".");
        name.push(ending);
        let target = output.join(name);
        if let Some(other) = sources.insert(target.clone(), input) {
            let [one, other] = [other, input].map(storage::input_name);
            return Err(misuse(&texts::places_same_result(one, other, target.display()).to_string()));
        }
        targets.push(target);
    }
    Ok(targets)
}

/// Makes the folder of a target in an output that is a folder.
///
/// # Errors
/// [`FileError`]
pub fn make_folder(output: &Path, target: &Path) -> Result<(), FileError> {
    if target == output { Ok(()) } else { files::create_folder(output) }
}
