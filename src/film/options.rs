//! What a film of the keyframes is to be: the options of an export, as plain data.

use std::path::{Path, PathBuf};

use super::{Format, GIF};
use crate::words::Message;

/// What is behind everything.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ExportBackground {
    /// The sky's gradient.
    #[default]
    Sky,
    /// Red, green and blue in sRGB.
    Colour([u8; 3]),
    /// Nothing: opacity 0.
    Transparent,
}

/// An export.
#[derive(Clone, Debug, PartialEq)]
pub struct ExportOptions {
    /// The file, or the folder of frames.
    pub path: PathBuf,
    /// What is written.
    pub format: &'static Format,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Frames a second, 1 to 1000.
    pub fps: u32,
    /// The key times at which it begins and ends; `None`: all that plays.
    pub range: Option<[f64; 2]>,
    /// How many neighbouring keyframes on each side are shown as ghosts.
    pub ghosts: u8,
    /// An eye of the scene by its path, or `turntable`; `None`: the scene's first eye.
    pub camera: Option<String>,
    /// Samples a pixel, 1 or 4; `None`: as many as suit the GPU adapter.
    pub samples: Option<u32>,
    /// What is behind everything.
    pub background: ExportBackground,
}

impl ExportOptions {
    /// The longest side of a picture, in pixels; what the GPU adapter takes may be less.
    pub const LONGEST_SIDE: u32 = 65_536;

    /// What the command line does with nothing said, to a GIF beside the keyframe file.
    #[must_use]
    pub fn beside(keyframe_file: &Path) -> Self {
        let format = &GIF;
        Self {
            path: format.film_path(&keyframe_file.with_extension("")),
            format,
            size: [640, 480],
            fps: format.usual_frames_per_second,
            range: None,
            ghosts: 0,
            camera: None,
            samples: None,
            background: ExportBackground::Sky,
        }
    }
}

/// How an export ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExportEnd {
    /// It was written, with so many frames.
    Written(usize),
    /// It was cancelled. Of a folder, so many frames were written already, each of them whole; of a file, nothing.
    Cancelled(usize),
    /// It failed, for this reason.
    Failed(Message),
}
