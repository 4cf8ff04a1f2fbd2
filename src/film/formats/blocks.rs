//! What changes from picture to picture, in blocks: lossy encoders pack blocks, and small noise is no change.

use crate::picture::Image;

/// The side of a block in pixels.
const BLOCK: usize = 8;
/// A block keeps its pixels while no channel of them is farther off than this, in levels.
const HELD_LEVELS: u8 = 1;

/// A rectangle of a picture.
#[derive(Debug, PartialEq, Eq)]
pub struct Part {
    /// Left edge in pixels; a multiple of 8.
    pub left: u32,
    /// Top edge in pixels; a multiple of 8.
    pub top: u32,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Red, green, blue and opacity of each pixel. In an opaque film opacity is 0 where nothing changes, and the colour there is
    /// that of a neighbour.
    pub rgba: Vec<u8>,
}

/// What a film shows.
pub struct Canvas {
    width: usize,
    is_opaque: bool,
    /// Pixels as they were when their block last changed. Empty before the first picture.
    held: Vec<u8>,
}

impl Canvas {
    /// Before the first picture of a film of this width in pixels.
    pub const fn new(width: usize, is_opaque: bool) -> Self {
        Self { width, is_opaque, held: Vec::new() }
    }

    /// The part that the next picture changes: all, of the first one; `None` if nothing.
    pub fn changes(&mut self, image: &Image) -> Option<Part> {
        let height = image.height as usize;
        if self.held.is_empty() {
            self.held.clone_from(&image.rgba);
            return Some(self.part([0, self.width, 0, height], |_, _| true));
        }
        let columns = self.width.div_ceil(BLOCK);
        let mut changed = vec![false; columns * height.div_ceil(BLOCK)];
        let pairs = self.held.as_chunks::<4>().0.iter().zip(image.rgba.as_chunks::<4>().0);
        for (place, (held, new)) in pairs.enumerate() {
            if held.iter().zip(new).any(|(held, new)| held.abs_diff(*new) > HELD_LEVELS) {
                changed[place / self.width / BLOCK * columns + place % self.width / BLOCK] = true;
            }
        }
        let is_changed = |x: usize, y: usize| changed[y / BLOCK * columns + x / BLOCK];
        let (held, new) = (self.held.as_chunks_mut::<4>().0, image.rgba.as_chunks::<4>().0);
        for (place, (held, new)) in held.iter_mut().zip(new).enumerate() {
            if is_changed(place % self.width, place / self.width) {
                *held = *new;
            }
        }
        let blocks = || (0..changed.len()).filter(|block| changed[*block]);
        let (left, right) =
            (blocks().map(|block| block % columns).min()?, blocks().map(|block| block % columns).max()?);
        let (top, bottom) = (blocks().min()? / columns, blocks().max()? / columns);
        let edges = [left, right + 1, top, bottom + 1].map(|edge| edge * BLOCK);
        Some(self.part([edges[0], edges[1].min(self.width), edges[2], edges[3].min(height)], is_changed))
    }

    /// The part of a picture that changes nothing.
    pub fn corner(&self) -> Part {
        let height = self.held.len() / 4 / self.width;
        self.part([0, BLOCK.min(self.width), 0, BLOCK.min(height)], |_, _| true)
    }

    fn part(&self, [left, right, top, bottom]: [usize; 4], is_changed: impl Fn(usize, usize) -> bool) -> Part {
        let width = right - left;
        let mut rgba: Vec<u8> = Vec::with_capacity(4 * width * (bottom - top));
        for y in top..bottom {
            for x in left..right {
                let own = 4 * (y * self.width + x);
                let pixel: [u8; 4] = [0, 1, 2, 3].map(|channel| self.held[own + channel]);
                if !self.is_opaque || is_changed(x, y) {
                    rgba.extend(pixel);
                    continue;
                }
                // Edges cost bytes, so the colour goes on from the left or from above.
                let before = if x > left { rgba.len().checked_sub(4) } else { rgba.len().checked_sub(4 * width) };
                let [red, green, blue, _] = before.map_or(pixel, |at| [0, 1, 2, 3].map(|channel| rgba[at + channel]));
                rgba.extend([red, green, blue, 0]);
            }
        }
        let [left, width, top, height] = [left, width, top, bottom - top].map(|length| length as u32);
        Part { left, top, width, height, rgba }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(pixel: impl Fn(u32, u32) -> u8) -> Image {
        let levels = (0..20).flat_map(|y| (0..30).map(move |x| (x, y))).map(|(x, y)| pixel(x, y));
        Image { width: 30, height: 20, rgba: levels.flat_map(|level| [level, level, level, 255]).collect() }
    }

    #[test]
    fn a_part_has_the_blocks_that_changed() {
        let mut canvas = Canvas::new(30, true);
        let whole = canvas.changes(&image(|x, _| x as u8)).unwrap();
        assert_eq!((whole.left, whole.top, whole.width, whole.height), (0, 0, 30, 20));
        assert_eq!(whole.rgba, image(|x, _| x as u8).rgba);
        assert_eq!(canvas.changes(&image(|x, _| x as u8)), None);
        let moved = |x: u32, y: u32| if (x, y) == (9, 3) || (x, y) == (25, 12) { 200 } else { x as u8 };
        let part = canvas.changes(&image(moved)).unwrap();
        // The last column of blocks is narrower.
        assert_eq!((part.left, part.top, part.width, part.height), (8, 0, 22, 16));
        for (place, pixel) in part.rgba.as_chunks::<4>().0.iter().enumerate() {
            let (x, y) = (8 + place as u32 % 22, place as u32 / 22);
            let has_changed = x < 16 && y < 8 || x >= 24 && y >= 8;
            assert_eq!(pixel[3], if has_changed { 255 } else { 0 }, "{x} {y}");
            assert!(!has_changed || pixel[0] == moved(x, y), "{x} {y}");
        }
    }

    #[test]
    fn noise_is_no_change_and_does_not_add_up() {
        let mut canvas = Canvas::new(30, true);
        canvas.changes(&image(|_, _| 100));
        assert_eq!(canvas.changes(&image(|x, _| 99 + (x % 3) as u8)), None);
        assert_eq!(canvas.changes(&image(|_, _| 101)), None);
        assert!(canvas.changes(&image(|_, _| 102)).is_some());
    }

    #[test]
    fn a_translucent_part_replaces_all_that_it_covers() {
        let mut canvas = Canvas::new(30, false);
        let clear = Image { width: 30, height: 20, rgba: vec![0; 4 * 600] };
        canvas.changes(&clear);
        let mut dotted = clear.clone();
        dotted.rgba[4 * 31..4 * 32].copy_from_slice(&[9, 8, 7, 90]);
        let part = canvas.changes(&dotted).unwrap();
        assert_eq!((part.width, part.height, &part.rgba[4 * 9..4 * 10]), (8, 8, &[9, 8, 7, 90][..]));
        assert!(part.rgba.chunks_exact(4).enumerate().all(|(place, pixel)| place == 9 || pixel == [0; 4]));
    }
}
