//! `inbetween join`: a film from numbered images.

use super::arguments::JoinArguments;
use super::places::Places;
use super::progress::{telling, watched};
use super::{CliError, misuse};
use crate::export::JoinRequest;
use crate::film::{FormatProblem, format_of_path};

/// Joins the images of the folder.
///
/// # Errors
/// [`CliError`]
pub fn run(arguments: &JoinArguments) -> Result<(), CliError> {
    telling(arguments.progress, || join(arguments))
}

fn join(arguments: &JoinArguments) -> Result<(), CliError> {
    let places = Places::default().reads("DIR", &arguments.folder).writes("--output", &arguments.output);
    places.tells(arguments.progress).check()?;
    let Some(format) = format_of_path(&arguments.output) else {
        return Err(misuse(&FormatProblem::NoFilm.to_string()));
    };
    let request = JoinRequest {
        folder: &arguments.folder,
        still: arguments.frame_format,
        frames: arguments.frames.as_ref(),
        format,
        fps: arguments.fps,
        output: &arguments.output,
    };
    Ok(request.write(&mut watched(arguments.progress))?)
}
