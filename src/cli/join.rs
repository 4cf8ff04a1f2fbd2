//! `inbetween join`: a film from numbered images.

use serde_json::json;

use super::arguments::JoinArguments;
use super::places::Places;
use super::progress::{telling, watched};
use super::targets::format_named;
use super::{CliError, Common, misuse, output};
use crate::export::JoinRequest;
use crate::film::{Format, FormatProblem};
use crate::storage::{is_standard, output_name};
use crate::words::texts;

/// Joins the images of the folder.
///
/// # Errors
/// [`CliError`]
pub fn run(arguments: &JoinArguments, common: Common<'_>) -> Result<(), CliError> {
    telling(arguments.progress, || join(arguments, common))
}

fn join(arguments: &JoinArguments, common: Common<'_>) -> Result<(), CliError> {
    if is_standard(&arguments.folder) {
        return Err(misuse(&texts::places_no_folder("DIR").to_string()));
    }
    let places = Places::default().reads("DIR", &arguments.folder).writes("--output", &arguments.output);
    let places = if arguments.json { places.prints("--json") } else { places };
    places.tells(arguments.progress).check()?;
    let named = format_named(arguments.format, &arguments.output)?;
    let Some(format) = named.map(Format::of_films) else { return Err(misuse(&FormatProblem::NoFilm.to_string())) };
    let request = JoinRequest {
        folder: &arguments.folder,
        still: arguments.frame_format,
        frames: arguments.frames.as_ref(),
        format,
        fps: arguments.fps,
        output: &arguments.output,
    };
    let mut watch = watched(common.progress(arguments.progress), output_name(&arguments.output));
    request.write(&mut watch)?;
    if !arguments.json {
        return Ok(());
    }
    let object = json!({"output": output_name(&arguments.output), "format": format.ending, "fps": arguments.fps});
    output::say(&format!("{object}\n"))
}
