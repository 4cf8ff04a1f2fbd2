//! What is to be written, by the ending of its name.

use super::super::arguments::RenderArguments;
use super::super::{CliError, misuse};
use crate::film::Format;
use crate::storage;

/// Frames a second where nothing else is said.
pub const FRAMES_PER_SECOND: u32 = 30;
/// The same in a GIF: four hundredths of a second exactly.
const GIF_FRAMES_PER_SECOND: u32 = 25;
/// A GIF's pictures last two hundredths of a second at least.
const MOST_GIF_FRAMES_PER_SECOND: u32 = 50;

/// What is to be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// One PNG.
    Image,
    /// A folder of numbered PNGs.
    Folder,
    /// A film that is encoded here.
    Film(Format),
    /// A film that ffmpeg encodes.
    Mp4,
}

impl Target {
    /// What the arguments ask for.
    ///
    /// # Errors
    /// Wrong usage: an ending that is not written, or options that do not go with it.
    pub fn of(arguments: &RenderArguments) -> Result<Self, CliError> {
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
        if target == Self::Film(Format::Gif) && arguments.fps.is_some_and(|fps| fps > MOST_GIF_FRAMES_PER_SECOND) {
            return Err(misuse("a GIF shows at most 50 frames a second"));
        }
        Ok(target)
    }

    /// Frames a second where none are named.
    pub fn usual_frames_per_second(self) -> u32 {
        if self == Self::Film(Format::Gif) { GIF_FRAMES_PER_SECOND } else { FRAMES_PER_SECOND }
    }
}
