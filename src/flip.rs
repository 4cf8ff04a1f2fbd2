//! The visible difference of two pictures: a score, and a picture of the errors.
//!
//! Pixels in, numbers out. The measure is LDR-FLIP (Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: "FLIP: A Difference
//! Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020): the difference that a person notices when
//! flipping between two pictures on a screen, 67 pixels to a degree. Colours are filtered by the eye's contrast sensitivity and compared in
//! a uniform colour space. Differences of edges and points increase the error.
//!
//! A verdict needs one number. FLIP's mean over the picture rates a moved hand lower than an invisible shift of all colours by one level.
//! So [`Comparison::score`] is the mean over the worst thousandth of the pixels: it is high if a difference is visible anywhere.

mod colour;
mod features;
mod filter;
mod heat;
mod pixel_error;

use thiserror::Error;

use crate::picture::Image;
use crate::words::{Message, texts};

/// The default tolerance: two pictures with at most this score look the same.
pub const DEFAULT_TOLERANCE: f32 = 0.06;

/// A pixel with a larger error than this differs strikingly.
pub const STRIKING: f32 = 0.3;

/// Why two pictures cannot be compared.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum CompareError {
    /// They have different sizes.
    #[error("the pictures have different sizes: {}x{} and {}x{}", .first[0], .first[1], .second[0], .second[1])]
    Sizes {
        /// Width and height of the first, in pixels.
        first: [u32; 2],
        /// Width and height of the second, in pixels.
        second: [u32; 2],
    },
    /// They have no pixels.
    #[error("the pictures have no pixels")]
    Empty,
}

/// The comparison of two pictures.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    width: u32,
    height: u32,
    errors: Vec<f32>,
    scores: Scores,
}

/// The numbers of a comparison, each from 0 (the same) to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scores {
    /// How different the pictures look: the mean FLIP error of the worst thousandth of the pixels.
    pub score: f32,
    /// FLIP's own number: the mean error of all pixels.
    pub mean: f32,
    /// The largest error of a pixel.
    pub largest: f32,
}

impl Scores {
    /// Whether the pictures look the same, up to a tolerance of the score.
    #[must_use]
    pub fn is_within(&self, tolerance: f32) -> bool {
        self.score <= tolerance
    }

    /// The result as a sentence.
    #[must_use]
    pub fn sentence(&self, tolerance: f32) -> Message {
        let [score, mean, largest] = [self.score, self.mean, self.largest].map(|number| format!("{number:.6}"));
        let say: fn(String, String, String, String) -> Message =
            if self.is_within(tolerance) { texts::flip_within } else { texts::flip_beyond };
        say(score, tolerance.to_string(), mean, largest)
    }
}

/// Checks that two pictures can be compared, by their widths and heights in pixels.
///
/// # Errors
/// [`CompareError::Sizes`]
pub fn check_sizes(first: [u32; 2], second: [u32; 2]) -> Result<(), CompareError> {
    if first == second { Ok(()) } else { Err(CompareError::Sizes { first, second }) }
}

/// Compares two pictures of one size. If either is translucent, both are composited over black and over white, and the larger error is
/// used. The order of the two does not matter.
///
/// # Errors
/// [`CompareError`]
pub fn compare(first: &Image, second: &Image) -> Result<Comparison, CompareError> {
    let (width, height) = (first.width, first.height);
    check_sizes([width, height], [second.width, second.height])?;
    if width == 0 || height == 0 {
        return Err(CompareError::Empty);
    }
    let size = [width as usize, height as usize];
    if first.rgba == second.rgba {
        let errors = vec![0.0; size[0] * size[1]];
        return Ok(Comparison { width, height, errors, scores: Scores::default() });
    }
    let is_opaque = |image: &Image| image.rgba.chunks_exact(4).all(|pixel| pixel[3] == u8::MAX);
    let over = |backdrop| pixel_error::errors(size, &first.rgba, &second.rgba, backdrop);
    let errors = if is_opaque(first) && is_opaque(second) {
        over(0.0)
    } else {
        over(0.0).into_iter().zip(over(1.0)).map(|(black, white)| black.max(white)).collect()
    };
    Ok(Comparison::of_errors(width, height, errors))
}

impl Comparison {
    fn of_errors(width: u32, height: u32, errors: Vec<f32>) -> Self {
        let mut ordered = errors.clone();
        let worst = ordered.len().div_ceil(1000);
        ordered.select_nth_unstable_by(worst - 1, |a, b| b.total_cmp(a));
        let largest = ordered[..worst].iter().copied().fold(0.0, f32::max);
        // Summed in picture order and in f64, so that the sum does not depend on the order of the selection.
        let mut worst_errors = ordered[..worst].to_vec();
        worst_errors.sort_by(f32::total_cmp);
        let scores = Scores { score: mean(&worst_errors), mean: mean(&errors), largest };
        Self { width, height, errors, scores }
    }

    /// The numbers.
    #[must_use]
    pub fn scores(&self) -> Scores {
        self.scores
    }

    /// The FLIP error of each pixel, 0 to 1, rows from the top.
    #[must_use]
    pub fn errors(&self) -> &[f32] {
        &self.errors
    }

    /// The share of the pixels whose error is above [`STRIKING`], 0 to 1.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a share needs no more digits")]
    pub fn striking(&self) -> f32 {
        let count = self.errors.iter().filter(|&&error| error > STRIKING).count();
        count as f32 / self.errors.len() as f32
    }

    /// A picture of the errors: from black (0) through violet and orange to pale yellow (1).
    #[must_use]
    pub fn difference(&self) -> Image {
        heat::picture(self.width, self.height, &self.errors)
    }
}

#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    reason = "a picture has far fewer than 2^52 pixels"
)]
fn mean(errors: &[f32]) -> f32 {
    let sum: f64 = errors.iter().copied().map(f64::from).sum();
    (sum / errors.len() as f64) as f32
}

#[cfg(test)]
mod tests;
