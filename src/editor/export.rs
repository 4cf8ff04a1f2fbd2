//! What a film of the keyframes is to be: the options of an export, as plain data.

use std::path::{Path, PathBuf};

use super::{CommandError, Editor};
use crate::words::{Message, Phrase, texts};

/// What is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ExportFormat {
    /// A folder of numbered PNGs.
    Frames,
    /// Animated GIF.
    #[default]
    Gif,
    /// Animated PNG.
    Apng,
    /// Uncompressed YUV 4:2:0.
    Y4m,
    /// MP4, through ffmpeg.
    Mp4,
}

impl ExportFormat {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Gif, Self::Apng, Self::Mp4, Self::Y4m, Self::Frames];

    /// The ending of its files' names, without the dot; a folder has none.
    #[must_use]
    pub const fn ending(self) -> Option<&'static str> {
        match self {
            Self::Frames => None,
            Self::Gif => Some("gif"),
            Self::Apng => Some("apng"),
            Self::Y4m => Some("y4m"),
            Self::Mp4 => Some("mp4"),
        }
    }

    /// A path, ending as this format's do: the ending of another format is replaced, anything else is kept.
    #[must_use]
    pub fn path(self, path: &Path) -> PathBuf {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        let is_own = |format: Self| format.ending().is_some_and(|own| ending.as_deref() == Some(own));
        let bare = if Self::ALL.into_iter().any(is_own) { path.with_extension("") } else { path.to_owned() };
        let Some(own) = self.ending() else { return bare };
        let mut name = bare.into_os_string();
        name.push(".");
        name.push(own);
        name.into()
    }

    /// Why there is no film of that size, pace and background; `None` where there is. In a few words, to stand after a colon.
    #[must_use]
    pub fn problem(self, [width, height]: [u32; 2], fps: Option<u32>, is_seen_through: bool) -> Option<Phrase> {
        if is_seen_through && matches!(self, Self::Mp4 | Self::Y4m) {
            return Some(texts::EXPORT_NO_OPACITY);
        }
        if self == Self::Mp4 && (width % 2 == 1 || height % 2 == 1) {
            return Some(texts::EXPORT_ODD_SIZE);
        }
        if self == Self::Gif && fps.is_some_and(|fps| fps > MOST_GIF_FRAMES_PER_SECOND) {
            return Some(texts::EXPORT_GIF_TOO_FAST);
        }
        None
    }

    /// Frames a second where nothing else is said: in a GIF what is four hundredths of a second exactly.
    #[must_use]
    pub fn usual_frames_per_second(self) -> u32 {
        if self == Self::Gif { 25 } else { 30 }
    }
}

/// A GIF's pictures last two hundredths of a second at least.
const MOST_GIF_FRAMES_PER_SECOND: u32 = 50;

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
    pub format: ExportFormat,
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
    /// The most neighbouring keyframes on each side that are shown as ghosts.
    pub const MOST_GHOSTS: u8 = 20;
    /// The most frames a second.
    pub const MOST_FPS: u32 = 1000;
    /// The longest side of a picture, in pixels; what the GPU adapter takes may be less.
    pub const LONGEST_SIDE: u32 = 65_536;

    /// What the command line does with nothing said, to a GIF beside the keyframe file.
    #[must_use]
    pub fn beside(keyframe_file: &Path) -> Self {
        let format = ExportFormat::default();
        Self {
            path: format.path(&keyframe_file.with_extension("")),
            format,
            size: [640, 480],
            fps: format.usual_frames_per_second(),
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

impl Editor {
    /// Takes in how an export to a path ended.
    pub fn exported(&mut self, path: &Path, end: ExportEnd) {
        let path = path.display();
        match end {
            ExportEnd::Written(frames) => self.say_outcome(texts::file_exported(frames, path)),
            ExportEnd::Cancelled(0) => self.say_outcome(texts::FILE_EXPORT_CANCELLED),
            ExportEnd::Cancelled(frames) => self.say_outcome(texts::file_export_cancelled_within(frames, path)),
            ExportEnd::Failed(reason) => self.say_error(&CommandError::Export { reason }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_end_as_the_format_does() {
        let path = |format: ExportFormat, path: &str| format.path(Path::new(path)).to_string_lossy().into_owned();
        assert_eq!(path(ExportFormat::Gif, "a/walk"), "a/walk.gif");
        assert_eq!(path(ExportFormat::Gif, "a/walk.GIF"), "a/walk.gif");
        assert_eq!(path(ExportFormat::Mp4, "a/walk.gif"), "a/walk.mp4");
        assert_eq!(path(ExportFormat::Apng, "v1.2"), "v1.2.apng");
        assert_eq!(path(ExportFormat::Frames, "a/walk.gif"), "a/walk");
    }

    #[test]
    fn what_cannot_be_is_said() {
        let problem = |format: ExportFormat| format.problem([641, 480], Some(60), true).is_some();
        assert_eq!(ExportFormat::ALL.map(problem), [true, false, true, true, false]);
        assert!(ExportFormat::Mp4.problem([640, 480], Some(60), false).is_none());
    }
}
