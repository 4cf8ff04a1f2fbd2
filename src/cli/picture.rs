//! Frames to PNG files, with no window.

use glam::Vec2;

use super::CliError;
use super::arguments::Size;
use crate::frame::Frame;

/// A renderer with its target.
pub struct Painter {
    size: Size,
}

impl Painter {
    /// Acquires a GPU adapter for pictures of a size; with as many samples a pixel as suit it, unless told.
    ///
    /// # Errors
    /// [`CliError`] where there is none.
    pub fn new(size: Size, samples: Option<u32>) -> Result<Self, CliError> {
        let _ = (size, samples);
        Err(CliError::bad_input("inbetween", "this build has no renderer"))
    }

    /// The pictures' width and height in pixels.
    #[expect(clippy::cast_precision_loss, reason = "sides are far below 2^24")]
    pub fn size_px(&self) -> Vec2 {
        Vec2::new(self.size.width as f32, self.size.height as f32)
    }

    /// Draws a frame and encodes it: 8 bits a channel, not interlaced.
    ///
    /// # Errors
    /// [`CliError`]
    pub fn png(&mut self, _frame: &Frame) -> Result<Vec<u8>, CliError> {
        Err(CliError::bad_input("inbetween", "this build has no renderer"))
    }
}
