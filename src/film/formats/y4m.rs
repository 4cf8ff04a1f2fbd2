//! YUV4MPEG2: uncompressed YUV 4:2:0 with a line of text before each picture. Limited range.
//!
//! The header has no place for the matrix. A file is in that of ITU-R BT.601, which programs assume. A stream for ffmpeg is in that of
//! BT.709, and ffmpeg is told so.

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
    encoder: Encoder::Film(FilmFormat {
        sample_frames: 0,
        start: |plan, _, output| Ok(Box::new(Y4mFilm::new(plan, BT_601, output)?)),
    }),
};

/// A stream for ffmpeg: like the file, in the matrix of BT.709.
pub(super) const BT_709_STREAM: FilmFormat =
    FilmFormat { sample_frames: 0, start: |plan, _, output| Ok(Box::new(Y4mFilm::new(plan, BT_709, output)?)) };

/// What a level of red, green and blue adds to luma and to the two chromas, for 8 bits and limited range, times 65536.
struct Matrix {
    luma: [i32; 3],
    blue: [i32; 3],
    red: [i32; 3],
}

const BT_601: Matrix =
    Matrix { luma: [16_829, 33_039, 6_416], blue: [-9_714, -19_070, 28_784], red: [28_784, -24_103, -4_681] };

const BT_709: Matrix =
    Matrix { luma: [11_966, 40_254, 4_064], blue: [-6_596, -22_188, 28_784], red: [28_784, -26_145, -2_639] };

/// A Y4M stream that is being written.
struct Y4mFilm<W: Write> {
    output: W,
    matrix: Matrix,
    bytes: Vec<u8>,
}

impl<W: Write> Y4mFilm<W> {
    fn new(plan: Plan, matrix: Matrix, mut output: W) -> Result<Self, FilmError> {
        let Plan { width, height, frames_per_second, .. } = plan;
        let header =
            format!("YUV4MPEG2 W{width} H{height} F{frames_per_second}:1 Ip A1:1 C420jpeg XCOLORRANGE=LIMITED\n");
        output.write_all(header.as_bytes())?;
        Ok(Self { output, matrix, bytes: Vec::new() })
    }
}

impl<W: Write + Send> FilmEncoder for Y4mFilm<W> {
    fn push(&mut self, image: &Image, _start_ms: f64, _end_ms: f64) -> Result<(), FilmError> {
        self.bytes.clear();
        self.bytes.extend_from_slice(b"FRAME\n");
        let Matrix { luma, blue, red } = self.matrix;
        self.bytes
            .extend(image.rgba.chunks_exact(4).map(|pixel| level(16 + ((weighed(pixel, luma) + (1 << 15)) >> 16))));
        for chroma in [blue, red] {
            let width = image.width as usize;
            for rows in image.rgba.chunks(2 * 4 * width) {
                let (first, second) = rows.split_at(4 * width);
                let second = if second.is_empty() { first } else { second };
                for (above, below) in first.chunks(8).zip(second.chunks(8)) {
                    // With an odd width or height the last column or row is repeated.
                    let corners = [&above[..4], &above[above.len() - 4..], &below[..4], &below[below.len() - 4..]];
                    let sum: i32 = corners.into_iter().map(|pixel| weighed(pixel, chroma)).sum();
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

/// The weighed sum of red, green and blue, composited over black.
fn weighed(pixel: &[u8], weights: [i32; 3]) -> i32 {
    let opacity = i32::from(pixel[3]);
    (0..3).map(|channel| i32::from(pixel[channel]) * opacity / 255 * weights[channel]).sum()
}

fn level(value: i32) -> u8 {
    value.clamp(0, 255).to_le_bytes()[0]
}
