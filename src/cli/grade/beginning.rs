//! Before anything is graded: `grade --check` and `grade --example`.

use std::path::{Path, PathBuf};

use crate::cli::places::Places;
use crate::cli::{CliError, Common, misuse, output};
use crate::files::{self, scene};
use crate::grading::{Rubric, RubricCheck, example};
use crate::storage;
use crate::text::listed;
use crate::words::texts;

/// Prints which known mistakes a rubric's reference reveals, as sentences or as JSON.
///
/// # Errors
/// [`CliError`]: a bad rubric or scene.
pub fn check(rubric: &Path, is_json: bool, named_scene: Option<&Path>) -> Result<(), CliError> {
    Places::with_scene(named_scene).reads("RUBRIC", rubric).check()?;
    let scene = scene::load(named_scene)?;
    let rubric = Rubric::load(rubric, &scene)?;
    let check = RubricCheck::of(&rubric, &scene);
    output::say(&if is_json { check.json() } else { check.sentences() })
}

/// Writes the files to start from into a folder. Nothing is overwritten.
///
/// # Errors
/// [`CliError`]: one of the files is there already, a bad scene, a folder that cannot be written to.
pub fn write_example(folder: &Path, common: Common<'_>) -> Result<(), CliError> {
    let named_scene = common.scene;
    if storage::is_standard(folder) {
        return Err(misuse(&texts::places_no_folder("--example").to_string()));
    }
    let scene = scene::load(named_scene)?;
    let files = example(&scene, named_scene.and_then(Path::to_str)).map(|(name, text)| (name, folder.join(name), text));
    let in_the_way: Vec<&PathBuf> =
        files.iter().map(|(_, path, _)| path).filter(|path| storage::exists(path)).collect();
    if let Some(path) = in_the_way.first() {
        return Err(CliError::bad_input(path.display(), texts::STORAGE_IN_THE_WAY));
    }
    files::create_folder(folder)?;
    for (_, path, text) in &files {
        files::write(path, text.as_bytes())?;
    }
    if common.is_quiet {
        return Ok(());
    }
    let names = files.each_ref().map(|(name, ..)| *name);
    output::say(&format!("Wrote {} to {}. Begin with README.md.\n", listed(&names, "and"), folder.display()))
}
