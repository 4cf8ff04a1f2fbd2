//! Arguments of `join`.

use std::path::PathBuf;

use clap::Args;

use super::ProgressKind;
use super::values::{film_format, still_format};
use crate::film::{Format, FrameNumbers, MOST_FRAMES_PER_SECOND};

/// The long help.
pub const HELP: &str = "\
Make a film of the numbered images in a folder, as `render --fps N -o DIR` writes them: the bytes that `render -o FILM` gives. Nothing \
is written unless all images are there, whole and of one size.";

/// Arguments of `join`.
#[derive(Debug, Args)]
pub struct JoinArguments {
    /// The folder with frame-00000.png and on.
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// The film to write.
    #[arg(short, long, value_name = "OUT.gif|OUT.apng|OUT.mp4|OUT.y4m")]
    pub output: PathBuf,
    /// The film's format, where OUT has no ending that tells it, as - has none.
    #[arg(long, value_name = "FORMAT", value_parser = film_format())]
    pub format: Option<&'static Format>,
    /// Frames a second: those with which the images were drawn.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(MOST_FRAMES_PER_SECOND)))]
    pub fps: u32,
    /// The frames to join, as in 0-59, 60-119:2 or 0,7,12-14 [default: from 0 to the last that is there].
    #[arg(long, value_name = "NUMBERS", value_parser = FrameNumbers::parse)]
    pub frames: Option<FrameNumbers>,
    /// The format of the images, if the folder has them in several.
    #[arg(long, value_name = "FORMAT", value_parser = still_format())]
    pub frame_format: Option<&'static Format>,
    /// How progress is told.
    #[arg(long, value_enum, default_value_t)]
    pub progress: ProgressKind,
    /// Print JSON: output, format, fps.
    #[arg(long)]
    pub json: bool,
}
