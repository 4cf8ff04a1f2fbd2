//! YUV4MPEG2: uncompressed YUV 4:2:0 with a line of text before each picture. Colours as in ITU-R BT.601, limited range.

use std::io::Write;

use super::{FilmError, Plan};
use crate::render::Image;

/// A Y4M stream that is being written.
pub struct Y4mFilm<W: Write> {
    plan: Plan,
    output: W,
    bytes: Vec<u8>,
}

impl<W: Write> Y4mFilm<W> {
    pub(super) fn new(plan: Plan, mut output: W) -> Result<Self, FilmError> {
        let Plan { width, height, frames_per_second, .. } = plan;
        let header =
            format!("YUV4MPEG2 W{width} H{height} F{frames_per_second}:1 Ip A1:1 C420jpeg XCOLORRANGE=LIMITED\n");
        output.write_all(header.as_bytes())?;
        Ok(Self { plan, output, bytes: Vec::new() })
    }

    pub(super) fn plan(&self) -> Plan {
        self.plan
    }

    pub(super) fn push(&mut self, image: &Image) -> Result<(), FilmError> {
        self.bytes.clear();
        self.bytes.extend_from_slice(b"FRAME\n");
        self.bytes.extend(image.rgba.chunks_exact(4).map(|pixel| luma(rgb(pixel))));
        for chroma in [blue as fn([i32; 3]) -> i32, red] {
            let width = image.width as usize;
            for rows in image.rgba.chunks(2 * 4 * width) {
                let (first, second) = rows.split_at(4 * width);
                let second = if second.is_empty() { first } else { second };
                for (above, below) in first.chunks(8).zip(second.chunks(8)) {
                    // An odd width or height repeats its last column or row.
                    let corners = [&above[..4], &above[above.len() - 4..], &below[..4], &below[below.len() - 4..]];
                    let sum: i32 = corners.into_iter().map(|pixel| chroma(rgb(pixel))).sum();
                    self.bytes.push(level(128 + ((sum + (2 << 16)) >> 18)));
                }
            }
        }
        self.output.write_all(&self.bytes)?;
        Ok(())
    }

    pub(super) fn finish(mut self) -> Result<(), FilmError> {
        Ok(self.output.flush()?)
    }
}

/// Red, green and blue; what is translucent over black.
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
