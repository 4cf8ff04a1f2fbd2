//! The output of `render`, chosen by the ending of its name.

use super::super::arguments::RenderArguments;
use super::super::targets::{format_named, is_folder};
use super::super::{CliError, misuse};
use crate::film::{ComparedAs, Format, NOT_WRITTEN, PNG, still_names, written_endings};
use crate::storage;
use crate::text::listed;
use crate::words::texts;

/// What is to be written.
#[derive(Clone, Copy)]
pub struct Output {
    /// The format of the file or of a folder's files.
    pub format: &'static Format,
    /// Whether it is one image; else it is a film, or a folder of numbered images.
    pub is_one_image: bool,
}

impl Output {
    /// What the arguments ask for.
    ///
    /// # Errors
    /// Wrong usage: an ending that is not written, or options that do not go with it.
    pub fn of(arguments: &RenderArguments) -> Result<Self, CliError> {
        let path = &arguments.output;
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        let ending = ending.as_deref().unwrap_or_default();
        let is_folder = is_folder(path, 1);
        let of_folder = arguments.frame_format.unwrap_or(&PNG);
        if is_folder && arguments.format.is_some() {
            return Err(misuse(texts::PLACES_FORMAT_OF_FOLDER.english()));
        }
        let format = if is_folder { None } else { format_named(arguments.format, path)? };
        let output = match format {
            _ if is_folder => Self { format: of_folder, is_one_image: false },
            Some(format) if !format.is_still() => Self { format, is_one_image: false },
            Some(format) if arguments.fps.is_some() && !format.of_films().is_still() => {
                Self { format: format.of_films(), is_one_image: false }
            }
            Some(_) if arguments.fps.is_some() => {
                return Err(misuse("with --fps, --output names a film or a folder for the numbered images"));
            }
            Some(format) => Self { format, is_one_image: true },
            None if NOT_WRITTEN.contains(&ending) => return Err(misuse(&not_written(ending))),
            None if arguments.fps.is_some() && storage::is_standard(path) => {
                return Err(misuse(texts::PLACES_NO_FRAMES.english()));
            }
            None if arguments.fps.is_some() => Self { format: of_folder, is_one_image: false },
            None => Self { format: &PNG, is_one_image: true },
        };
        output.check(arguments)?;
        check_refining(arguments)?;
        if arguments.comparing.how() == ComparedAs::Ghosts && (arguments.ghosts.is_some() || arguments.strobe.is_some())
        {
            return Err(misuse(
                "--compare-as ghosts shows ghosts of its own: --ghosts and --strobe go with side-by-side",
            ));
        }
        let is_film = !output.is_one_image && !output.format.is_still();
        if is_film && arguments.manifest().is_some() && storage::is_standard(path) {
            // Its hash is that of the file.
            return Err(misuse(&texts::places_needs_a_file("--output").to_string()));
        }
        Ok(output)
    }

    /// Whether the options go with it.
    fn check(self, arguments: &RenderArguments) -> Result<(), CliError> {
        if !self.is_one_image {
            if arguments.at.is_some()
                || arguments.keyframe.is_some()
                || arguments.sheet.is_some()
                || arguments.id
                || arguments.strobe.is_some()
            {
                let names = listed(&still_names(), "or");
                return Err(misuse(&format!(
                    "--at, --keyframe, --sheet, --strobe and --id make one image: --output names a {names}"
                )));
            }
        } else if arguments.frames.is_some() {
            return Err(misuse("--frames is for films and folders; --at is for one image"));
        } else if arguments.sheet.is_none()
            && arguments.strobe.is_none()
            && (arguments.from.is_some() || arguments.to.is_some())
        {
            return Err(misuse(
                "--from and --to are for films, folders, contact sheets and --strobe; --at is for one image",
            ));
        }
        if arguments.id && self.format != &PNG {
            return Err(misuse("--id writes a 16-bit grey PNG: --output names a PNG"));
        }
        if arguments.frame_format.is_some() && (self.is_one_image || !self.format.is_still()) {
            return Err(misuse("--frame-format is for a folder of numbered images"));
        }
        let option = if arguments.clean { "--clean" } else { "--missing" };
        if (arguments.clean || arguments.missing) && (self.is_one_image || !self.format.is_still()) {
            return Err(misuse(&format!("{option} is for a folder of numbered images")));
        }
        Ok(())
    }
}

/// Whether the options of refined pictures go with the quality.
fn check_refining(arguments: &RenderArguments) -> Result<(), CliError> {
    let refining = &arguments.refining;
    match refining.of_refined() {
        Some(option) if !refining.quality.is_refined() => Err(misuse(&format!(
            "{option} is for refined pictures: give --quality good, film, poster or a number above 1"
        ))),
        _ if refining.quality.is_refined() && arguments.samples.is_some_and(|samples| samples > 1) => Err(misuse(
            "--samples 4 is for plain pictures: a sub-frame has one sample a pixel, and --quality says how many there are",
        )),
        _ => Ok(()),
    }
}

fn not_written(ending: &str) -> String {
    let mut written: Vec<String> = Vec::new();
    for ending in written_endings().concat().iter().map(|ending| format!(".{ending}")) {
        if !written.contains(&ending) {
            written.push(ending);
        }
    }
    format!("--output ends in .{ending}: {} and folders can be written", written.join(", "))
}
