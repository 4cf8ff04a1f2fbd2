//! `inbetween verify`: compares pictures with the references in a folder.

use std::path::Path;

use super::arguments::VerifyArguments;
use super::places::Places;
use super::progress::Progress;
use super::{CliError, Ended, misuse, output};
use crate::export::Painter;
use crate::files;
use crate::references::{LIST_NAME, References, Shot, read_list};
use crate::storage;
use crate::words::texts;

/// Renders what the folder's list says and compares it with the references beside it, or takes it as them.
///
/// # Errors
/// [`CliError`]: no GPU adapter, a bad list, a picture that cannot be drawn or written.
pub fn run(arguments: &VerifyArguments, scene: Option<&Path>) -> Result<Ended, CliError> {
    let folders = [("DIR", Some(&arguments.folder)), ("--output", arguments.output.as_ref())];
    if let Some((name, _)) = folders.iter().find(|(_, folder)| folder.is_some_and(|path| storage::is_standard(path))) {
        return Err(misuse(&texts::places_no_folder(*name).to_string()));
    }
    let painter = Painter::headless(super::render::DEFAULT_SIZE, Some(1))?;
    let folder = &arguments.folder;
    let shots = read_list(&folder.join(LIST_NAME))?;
    let actual = arguments.output.clone().unwrap_or_else(|| folder.join("actual"));
    places(&shots, folder, scene, (!arguments.update).then_some(&*actual)).check()?;
    let mut references = References::new(folder, scene, painter);
    if arguments.update {
        let lines = each(&shots, |shot| Ok(format!("{}: {}\n", shot.name, references.accept(shot)?)))?;
        output::say(&lines.concat())?;
        return Ok(Ended::Well);
    }
    files::create_folder(&actual)?;
    let mut bad = 0;
    let lines = each(&shots, |shot| {
        let verdict = references.verify(shot, &actual)?;
        bad += usize::from(!verdict.is_good());
        Ok(format!("{}: {verdict}\n", shot.name))
    })?;
    let count = shots.len();
    let summary = if bad == 0 {
        format!("all {count} as they should be\n")
    } else {
        format!("{bad} of {count} not as they should be: see {}\n", actual.display())
    };
    output::say(&(lines.concat() + &summary))?;
    Ok(if bad == 0 { Ended::Well } else { Ended::Beyond })
}

/// Where it reads and writes. `actual` is the folder for what is drawn; without it, the references are written.
fn places(shots: &[Shot], folder: &Path, scene: Option<&Path>, actual: Option<&Path>) -> Places {
    let mut places = Places::with_scene(scene).reads("the list", &folder.join(LIST_NAME));
    for shot in shots {
        let name = |what: &str| format!("{what} of \"{}\"", shot.name);
        let [animation, scene] = [&shot.file, &shot.scene].map(|file| file.as_ref().map(|file| folder.join(file)));
        if let Some(animation) = animation {
            places = places.reads_as(name("the file"), "the file", &animation);
        }
        if let Some(scene) = scene {
            places = places.reads_as(name("the scene"), "the scene", &scene);
        }
        let reference = folder.join(shot.reference());
        match actual {
            None => places = places.writes_once(name("the reference"), &reference),
            Some(actual) => {
                places = places.reads_as(name("the reference"), "the reference", &reference);
                places = places.writes_once(name("the picture"), &References::drawn_path(actual, shot));
                places = places.writes_once(name("the difference"), &References::difference_path(actual, shot));
            }
        }
    }
    places
}

/// Calls a function for each picture and shows the progress.
fn each(shots: &[Shot], mut line: impl FnMut(&Shot) -> Result<String, CliError>) -> Result<Vec<String>, CliError> {
    let mut progress = Progress::new("picture", shots.len());
    let mut lines = Vec::with_capacity(shots.len());
    for shot in shots {
        lines.push(line(shot)?);
        progress.step();
    }
    Ok(lines)
}
