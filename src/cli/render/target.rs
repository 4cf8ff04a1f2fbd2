//! What is to be written, by the ending of its name.

use super::super::arguments::RenderArguments;
use super::super::{CliError, misuse};
use crate::export::Target;
use crate::film::Format;
use crate::storage;

impl Target {
    /// What the arguments ask for.
    ///
    /// # Errors
    /// Wrong usage: an ending that is not written, or options that do not go with it.
    pub(super) fn of(arguments: &RenderArguments) -> Result<Self, CliError> {
        let output = &arguments.output;
        let ending = output.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        let is_folder = storage::is_folder(output) || output.to_string_lossy().ends_with(std::path::is_separator);
        let target = match ending.as_deref() {
            _ if is_folder => Self::Folder,
            Some("gif") => Self::Film(Format::Gif),
            Some("apng") => Self::Film(Format::Apng),
            Some("y4m") => Self::Film(Format::Y4m),
            Some("mp4") => Self::Mp4,
            Some(other @ ("jpg" | "jpeg" | "webp" | "webm" | "avi" | "mov" | "mkv" | "bmp" | "tif" | "tiff")) => {
                return Err(misuse(&format!(
                    "--output ends in .{other}: .png, .gif, .apng, .y4m, .mp4 and folders can be written"
                )));
            }
            Some("png") if arguments.fps.is_some() => {
                return Err(misuse("with --fps, --output names a film or a folder for the numbered images"));
            }
            _ if arguments.fps.is_some() => Self::Folder,
            _ => Self::Image,
        };
        if target != Self::Image {
            if arguments.at.is_some() || arguments.keyframe.is_some() || arguments.sheet.is_some() || arguments.id {
                return Err(misuse("--at, --keyframe, --sheet and --id make one image: --output names a PNG"));
            }
        } else if arguments.sheet.is_none() && (arguments.from.is_some() || arguments.to.is_some()) {
            return Err(misuse("--from and --to are for films, folders and contact sheets; --at is for one image"));
        }
        Ok(target)
    }
}
