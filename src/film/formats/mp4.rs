//! MP4 (H.264), which the user's ffmpeg encodes from a Y4M stream.

use super::{MOST_FRAMES_PER_SECOND, y4m};
use crate::film::{Encoder, Format};
use crate::words::texts;

/// MP4, through ffmpeg.
pub static MP4: Format = Format {
    name: "MP4",
    ending: "mp4",
    has_opacity: false,
    usual_frames_per_second: 30,
    most_frames_per_second: MOST_FRAMES_PER_SECOND,
    // Colours are stored for squares of two by two pixels.
    limit: |[width, height], _| (width % 2 == 1 || height % 2 == 1).then_some(texts::EXPORT_ODD_SIZE),
    encoder: Encoder::Ffmpeg(y4m::BT_709_STREAM),
};
