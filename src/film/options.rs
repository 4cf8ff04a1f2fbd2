//! The options of an export, as plain data.

use std::path::{Path, PathBuf};

use super::{Format, GIF, Quality};
use crate::lighting::BuiltInLighting;
use crate::words::Message;

/// The background.
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

/// The options of an export.
#[derive(Clone, Debug, PartialEq)]
pub struct ExportOptions {
    /// The file, or the folder of frames.
    pub path: PathBuf,
    /// The format of the file, or of the frames in the folder.
    pub format: &'static Format,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Frames per second, 1 to 1000.
    pub fps: u32,
    /// The key times at which it begins and ends; `None`: the whole playing range.
    pub range: Option<[f64; 2]>,
    /// The number of neighbouring keyframes on each side that are shown as ghosts.
    pub ghosts: u8,
    /// An eye of the scene by its path, or `turntable`; `None`: the scene's first eye.
    pub camera: Option<String>,
    /// Samples a pixel of plain pictures, 1 or 4; `None`: the adapter's default.
    pub samples: Option<u32>,
    /// The quality of its pictures.
    pub quality: Quality,
    /// The light; `None`: the scene's.
    pub lighting: Option<BuiltInLighting>,
    /// The background.
    pub background: ExportBackground,
}

impl ExportOptions {
    /// The longest side of a picture, in pixels; the GPU adapter's limit may be lower.
    pub const LONGEST_SIDE: u32 = 65_536;

    /// The defaults of the command line, written to a GIF next to the keyframe file.
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
            quality: Quality::DRAFT,
            lighting: None,
            background: ExportBackground::Sky,
        }
    }
}

/// The result of an export.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExportEnd {
    /// It was written, with this number of frames.
    Written(usize),
    /// It was cancelled. In a folder, this number of complete frames was written; a file was not written.
    Cancelled(usize),
    /// It failed, with this message.
    Failed(Message),
}
