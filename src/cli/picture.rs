//! Frames to PNG files, with no window.

use glam::Vec2;

use super::CliError;
use super::arguments::Size;
use crate::frame::Frame;
use crate::render::{Background, Gpu, Image, Offscreen, Renderer, default_samples};

/// A renderer with its target.
pub struct Painter {
    size: Size,
    samples: u32,
    gpu: Gpu,
    renderer: Renderer,
    offscreen: Offscreen,
}

impl Painter {
    /// Acquires a GPU adapter for pictures of a size; with as many samples a pixel as suit it, unless told.
    ///
    /// # Errors
    /// [`CliError::Gpu`] where there is none, or it cannot draw pictures so large.
    pub fn new(size: Size, samples: Option<u32>) -> Result<Self, CliError> {
        let gpu = super::quiet::without_driver_chatter(Gpu::headless)?;
        let offscreen = Offscreen::new(&gpu, size.width, size.height)?;
        let samples = samples.unwrap_or_else(|| default_samples(gpu.is_software));
        Ok(Self { size, samples, renderer: Renderer::new(&gpu, Offscreen::FORMAT, samples), offscreen, gpu })
    }

    /// The pictures' width and height in pixels.
    #[expect(clippy::cast_precision_loss, reason = "sides are far below 2^24")]
    pub fn size_px(&self) -> Vec2 {
        Vec2::new(self.size.width as f32, self.size.height as f32)
    }

    /// Draws a frame.
    ///
    /// # Errors
    /// [`CliError::Gpu`]
    pub fn image(&mut self, frame: &Frame) -> Result<Image, CliError> {
        Ok(self.offscreen.render(&self.gpu, &mut self.renderer, frame)?)
    }

    /// Draws a frame and encodes it: 8 bits a channel, not interlaced.
    ///
    /// # Errors
    /// [`CliError`]
    pub fn png(&mut self, frame: &Frame) -> Result<Vec<u8>, CliError> {
        Ok(self.image(frame)?.to_png()?)
    }

    /// What is behind everything from now on.
    pub fn set_background(&mut self, background: Background) {
        self.renderer.set_background(background);
    }

    /// The pictures' width and height in pixels.
    pub fn size(&self) -> Size {
        self.size
    }

    /// The GPU adapter, for naming it and for pictures of other kinds.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Samples a pixel.
    pub fn samples(&self) -> u32 {
        self.samples
    }
}
