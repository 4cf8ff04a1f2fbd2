//! YUV4MPEG2: uncompressed YUV 4:2:0 with a line of text before each picture. Colours as in ITU-R BT.601, limited range.

use std::io::Write;

use super::{MOST_FRAMES_PER_SECOND, no_limit};
use crate::film::{Encoder, FilmEncoder, FilmError, FilmFormat, Format, Plan};
use crate::picture::Image;

/// Uncompressed YUV 4:2:0 (YUV4MPEG2), as input of other encoders.
pub static Y4M: Format = Format {
    name: "Y4M",
    ending: "y4m",
    has_opacity: false,
    usual_frames_per_second: 30,
    most_frames_per_second: MOST_FRAMES_PER_SECOND,
    limit: no_limit,
    encoder: Encoder::Film(STREAM),
};

/// Begins a stream, for a file or for ffmpeg.
pub(super) const STREAM: FilmFormat =
    FilmFormat { sample_frames: 0, start: |plan, _, output| Ok(Box::new(Y4mFilm::new(plan, output)?)) };

/// A Y4M stream that is being written.
struct Y4mFilm<W: Write> {
    output: W,
    bytes: Vec<u8>,
}

impl<W: Write> Y4mFilm<W> {
    fn new(plan: Plan, mut output: W) -> Result<Self, FilmError> {
        let Plan { width, height, frames_per_second, .. } = plan;
        let header =
            format!("YUV4MPEG2 W{width} H{height} F{frames_per_second}:1 Ip A1:1 C420jpeg XCOLORRANGE=LIMITED\n");
        output.write_all(header.as_bytes())?;
        Ok(Self { output, bytes: Vec::new() })
    }
}

impl<W: Write + Send> FilmEncoder for Y4mFilm<W> {
    fn push(&mut self, image: &Image, _start_ms: f64, _end_ms: f64) -> Result<(), FilmError> {
        self.bytes.clear();
        self.bytes.extend_from_slice(b"FRAME\n");
        self.bytes.extend(image.rgba.chunks_exact(4).map(|pixel| luma(rgb(pixel))));
        for chroma in [blue as fn([i32; 3]) -> i32, red] {
            let width = image.width as usize;
            for rows in image.rgba.chunks(2 * 4 * width) {
                let (first, second) = rows.split_at(4 * width);
                let second = if second.is_empty() { first } else { second };
                for (above, below) in first.chunks(8).zip(second.chunks(8)) {
                    // With an odd width or height the last column or row is repeated.
                    let corners = [&above[..4], &above[above.len() - 4..], &below[..4], &below[below.len() - 4..]];
                    let sum: i32 = corners.into_iter().map(|pixel| chroma(rgb(pixel))).sum();
                    self.bytes.push(level(128 + ((sum + (2 << 16)) >> 18)));
                }
            }
        }
        self.output.write_all(&self.bytes)?;
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> Result<(), FilmError> {
        Ok(self.output.flush()?)
    }
}

/// Red, green and blue, composited over black.
fn rgb(pixel: &[u8]) -> [i32; 3] {
    let opacity = i32::from(pixel[3]);
    [0, 1, 2].map(|channel| i32::from(pixel[channel]) * opacity / 255)
}

fn level(value: i32) -> u8 {
    value.clamp(0, 255).to_le_bytes()[0]
}

// The coefficients of BT.601 for 8 bits, limited range, times 65536.

fn luma([r, g, b]: [i32; 3]) -> u8 {
    level(16 + ((16_829 * r + 33_039 * g + 6_416 * b + (1 << 15)) >> 16))
}

fn blue([r, g, b]: [i32; 3]) -> i32 {
    -9_714 * r - 19_070 * g + 28_784 * b
}

fn red([r, g, b]: [i32; 3]) -> i32 {
    28_784 * r - 24_103 * g - 4_681 * b
}
