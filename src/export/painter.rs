//! Draws frames into pictures, without a window.

use glam::Vec2;

use super::ExportError;
use crate::film::StillEncoder;
use crate::frame::Frame;
use crate::picture::PngMemory;
use crate::render::{Background, Drawn, Gpu, GpuError, Image, Offscreen, Renderer, default_samples};

/// Width and height of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Width, at least 1.
    pub width: u32,
    /// Height, at least 1.
    pub height: u32,
}

impl std::fmt::Display for Size {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{}x{}", self.width, self.height)
    }
}

/// A renderer with its target.
pub struct Painter {
    size: Size,
    samples: u32,
    gpu: Gpu,
    renderer: Renderer,
    offscreen: Offscreen,
}

impl Painter {
    /// A painter of pictures of a size on the best adapter that needs no display; `samples` per pixel, by default as many as suit it.
    ///
    /// # Errors
    /// [`GpuError`]: there is no adapter, or it cannot draw pictures of this size.
    pub fn headless(size: Size, samples: Option<u32>) -> Result<Self, GpuError> {
        Self::on(Gpu::headless()?, size, samples)
    }

    /// A painter of pictures of a size on an adapter; `samples` per pixel, by default as many as suit it.
    ///
    /// # Errors
    /// [`GpuError::Size`] if the adapter cannot draw pictures of this size; what [`Gpu::check`] says.
    pub fn on(gpu: Gpu, size: Size, samples: Option<u32>) -> Result<Self, GpuError> {
        let offscreen = Offscreen::new(&gpu, size.width, size.height)?;
        let samples = samples.unwrap_or_else(|| default_samples(gpu.is_software));
        let renderer = Renderer::new(&gpu, Offscreen::FORMAT, samples);
        let painter = Self { size, samples, gpu, renderer, offscreen };
        if let Err(error) = painter.gpu.check() {
            // The driver would wait for its work.
            std::mem::forget(painter);
            return Err(error);
        }
        Ok(painter)
    }

    /// The pictures' width and height in pixels.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "sides are far below 2^24")]
    pub fn size_px(&self) -> Vec2 {
        Vec2::new(self.size.width as f32, self.size.height as f32)
    }

    /// Draws a frame.
    ///
    /// # Errors
    /// [`GpuError`]
    pub fn image(&mut self, frame: &Frame) -> Result<Image, GpuError> {
        self.offscreen.render(&self.gpu, &mut self.renderer, frame)
    }

    /// Starts to draw the next frame of a run, if there is one, and returns the picture of the previous one, if there was one. The next
    /// frame is drawn while the previous picture is read back.
    ///
    /// # Errors
    /// [`GpuError`]
    pub fn next_drawn(&mut self, frame: Option<&Frame>) -> Result<Option<Drawn>, GpuError> {
        let was_under_way = self.offscreen.under_way() > 0;
        if let Some(frame) = frame {
            self.offscreen.submit(&self.gpu, &mut self.renderer, frame);
        }
        was_under_way.then(|| self.offscreen.read(&self.gpu)).transpose()
    }

    /// Draws a frame and encodes it as a PNG: 8 bits a channel, not interlaced.
    ///
    /// # Errors
    /// [`ExportError`]
    pub fn png(&mut self, frame: &Frame) -> Result<Vec<u8>, ExportError> {
        self.encoded(frame, |size| Box::new(PngMemory::new(size[0], size[1])))
    }

    /// Draws a frame and encodes it. The encoder is made while the GPU draws.
    ///
    /// # Errors
    /// [`ExportError`]
    pub fn encoded(
        &mut self,
        frame: &Frame,
        start: impl FnOnce([u32; 2]) -> Box<dyn StillEncoder>,
    ) -> Result<Vec<u8>, ExportError> {
        let Self { offscreen, gpu, renderer, size, .. } = self;
        let (drawn, mut encoder) = offscreen.draw_while(gpu, renderer, frame, || start([size.width, size.height]))?;
        encoder.encode(&drawn.rows())?;
        Ok(encoder.into_bytes())
    }

    /// Sets the background of the following frames.
    pub fn set_background(&mut self, background: Background) {
        self.renderer.set_background(background);
    }

    /// The pictures' width and height in pixels.
    #[must_use]
    pub const fn size(&self) -> Size {
        self.size
    }

    /// The GPU adapter.
    #[must_use]
    pub const fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Samples per pixel.
    #[must_use]
    pub const fn samples(&self) -> u32 {
        self.samples
    }
}
