//! What is to be written.

use crate::editor::ExportFormat;
use crate::film::Format;

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

impl From<ExportFormat> for Target {
    fn from(format: ExportFormat) -> Self {
        match format {
            ExportFormat::Frames => Self::Folder,
            ExportFormat::Gif => Self::Film(Format::Gif),
            ExportFormat::Apng => Self::Film(Format::Apng),
            ExportFormat::Y4m => Self::Film(Format::Y4m),
            ExportFormat::Mp4 => Self::Mp4,
        }
    }
}

impl Target {
    /// The format of what moves; one picture has none.
    #[must_use]
    pub const fn format(self) -> Option<ExportFormat> {
        match self {
            Self::Image => None,
            Self::Folder => Some(ExportFormat::Frames),
            Self::Film(Format::Gif) => Some(ExportFormat::Gif),
            Self::Film(Format::Apng) => Some(ExportFormat::Apng),
            Self::Film(Format::Y4m) => Some(ExportFormat::Y4m),
            Self::Mp4 => Some(ExportFormat::Mp4),
        }
    }

    /// Frames a second where none are named.
    #[must_use]
    pub fn usual_frames_per_second(self) -> u32 {
        self.format().unwrap_or_default().usual_frames_per_second()
    }
}
