//! `inbetween verify`: compares pictures with the references in a folder.

use std::path::Path;

use super::arguments::VerifyArguments;
use super::progress::Progress;
use super::{CliError, Ended, output};
use crate::export::Painter;
use crate::files;
use crate::references::{LIST_NAME, References, Shot, read_list};

/// Renders what the folder's list says and compares it with the references beside it, or takes it as them.
///
/// # Errors
/// [`CliError`]: no GPU adapter, a bad list, a picture that cannot be drawn or written.
pub fn run(arguments: &VerifyArguments, scene: Option<&Path>) -> Result<Ended, CliError> {
    let painter = Painter::headless(super::render::DEFAULT_SIZE, Some(1))?;
    let folder = &arguments.folder;
    let shots = read_list(&folder.join(LIST_NAME))?;
    let mut references = References::new(folder, scene, painter);
    if arguments.update {
        let lines = each(&shots, |shot| Ok(format!("{}: {}\n", shot.name, references.accept(shot)?)))?;
        output::say(&lines.concat())?;
        return Ok(Ended::Well);
    }
    let actual = arguments.output.clone().unwrap_or_else(|| folder.join("actual"));
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
