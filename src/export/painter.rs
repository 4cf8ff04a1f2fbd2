//! Draws frames into pictures, without a window.

use glam::Vec2;

use super::{ExportError, Exposed};
use crate::film::StillEncoder;
use crate::frame::Frame;
use crate::picture::{PictureSum, PngMemory, Rows};
use crate::render::{
    Background, Drawn, Gpu, GpuError, Image, Offscreen, Refinement, Refiner, Renderer, default_samples,
};

/// Width and height of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Width, at least 1.
    pub width: u32,
    /// Height, at least 1.
    pub height: u32,
}

impl Size {
    /// A width and a height.
    #[must_use]
    pub const fn of([width, height]: [u32; 2]) -> Self {
        Self { width, height }
    }
}

impl std::fmt::Display for Size {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{}x{}", self.width, self.height)
    }
}

/// A picture that was drawn.
pub enum Picture {
    /// As the adapter drew it.
    Drawn(Drawn),
    /// Made of several that it drew.
    Made(Image),
}

impl Picture {
    /// Its pixels.
    #[must_use]
    pub fn rows(&self) -> Rows<'_> {
        match self {
            Self::Drawn(drawn) => drawn.rows(),
            Self::Made(image) => image.rows(),
        }
    }

    /// The picture in memory of its own.
    #[must_use]
    pub fn into_image(self) -> Image {
        match self {
            Self::Drawn(drawn) => drawn.rows().to_image(),
            Self::Made(image) => image,
        }
    }
}

/// A renderer with its target.
pub struct Painter {
    size: Size,
    samples: u32,
    gpu: Gpu,
    renderer: Renderer,
    /// Draws in place of the renderer, where pictures are refined.
    refiner: Option<Refiner>,
    offscreen: Offscreen,
    /// Of the picture that was submitted last all but its last part, where it is made of several.
    parts: Option<PictureSum>,
}

/// Over refined pictures lines and ghosts are drawn so often, in different places of the pixel; less often where there are fewer sub-frames.
/// More would cost a film of ghosts more than it shows: they are translucent.
const MOST_OVERLAYS: u32 = 8;

impl Painter {
    /// A painter of pictures of a size on the best adapter that needs no display; `samples` per pixel, by default as many as suit it.
    ///
    /// # Errors
    /// [`GpuError`]: there is no adapter, or it cannot draw pictures of this size.
    #[cfg(not(target_arch = "wasm32"))]
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
        let painter = Self { size, samples, gpu, renderer, refiner: None, offscreen, parts: None };
        if let Err(error) = painter.gpu.check() {
            // The driver would wait for its work.
            std::mem::forget(painter);
            return Err(error);
        }
        Ok(painter)
    }

    /// Sets how the following pictures are refined; `None`: they are plain.
    pub fn refine(&mut self, refinement: Option<Refinement>) {
        if self.refiner.as_ref().map(Refiner::refinement) != refinement.as_ref() {
            self.refiner = refinement.map(|refinement| {
                let is_of_parts = refinement.sub_frames > 1;
                let mut refiner = Refiner::new(&self.gpu, Offscreen::FORMAT, refinement);
                if is_of_parts {
                    refiner.leave_edges_of_ghosts();
                }
                refiner
            });
        }
    }

    /// The pictures' width and height in pixels.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "sides are far below 2^24")]
    pub fn size_px(&self) -> Vec2 {
        Vec2::new(self.size.width as f32, self.size.height as f32)
    }

    /// Draws a frame in which nothing moves.
    ///
    /// # Errors
    /// [`GpuError`]
    pub fn image(&mut self, frame: &Frame) -> Result<Image, GpuError> {
        self.clear();
        self.submit::<GpuError>(frame, |_| Ok(None))?;
        self.read().map(Picture::into_image)
    }

    /// Draws a picture.
    ///
    /// # Errors
    /// [`ExportError`]
    pub fn exposed(&mut self, picture: &Exposed<'_>) -> Result<Image, ExportError> {
        self.clear();
        self.submit_exposed(picture)?;
        Ok(self.read()?.into_image())
    }

    /// Starts to draw the next picture of a run, if there is one, and returns the previous one, if there was one. The next picture is drawn
    /// while the previous one is read back, unless it is made of several.
    ///
    /// # Errors
    /// [`ExportError`]
    pub fn next_drawn(&mut self, picture: Option<&Exposed<'_>>) -> Result<Option<Picture>, ExportError> {
        let was_under_way = self.offscreen.under_way() > 0;
        let is_of_parts = picture.is_some_and(|picture| self.overlays(&picture.frame) > 1);
        let before = (was_under_way && is_of_parts).then(|| self.read()).transpose()?;
        if let Some(picture) = picture {
            self.submit_exposed(picture)?;
        }
        if before.is_some() || !was_under_way {
            return Ok(before);
        }
        Ok(Some(self.read()?))
    }

    /// Draws a frame in which nothing moves and encodes it as a PNG: 8 bits a channel, not interlaced.
    ///
    /// # Errors
    /// [`ExportError`]
    pub fn png(&mut self, frame: Frame) -> Result<Vec<u8>, ExportError> {
        self.encoded(&Exposed::still(frame), |size| Box::new(PngMemory::new(size[0], size[1])))
    }

    /// Draws a picture and encodes it. The encoder is made while the GPU draws.
    ///
    /// # Errors
    /// [`ExportError`]
    pub fn encoded(
        &mut self,
        picture: &Exposed<'_>,
        start: impl FnOnce([u32; 2]) -> Box<dyn StillEncoder>,
    ) -> Result<Vec<u8>, ExportError> {
        self.clear();
        self.submit_exposed(picture)?;
        let mut encoder = start([self.size.width, self.size.height]);
        encoder.encode(&self.read()?.rows())?;
        Ok(encoder.into_bytes())
    }

    /// Starts to draw a picture with nothing over the scene, or a plain one; [`Self::image_if_there`] takes it.
    ///
    /// # Errors
    /// [`ExportError`]
    pub fn begin(&mut self, picture: &Exposed<'_>) -> Result<(), ExportError> {
        self.clear();
        self.submit_exposed(picture)
    }

    /// The picture that was begun, if it is there; nothing is waited for. `None`: it is under way.
    ///
    /// # Errors
    /// [`GpuError`]
    pub fn image_if_there(&mut self) -> Result<Option<Image>, GpuError> {
        Ok(self.offscreen.read_if_there(&self.gpu)?.map(|drawn| drawn.rows().to_image()))
    }

    fn submit_exposed(&mut self, picture: &Exposed<'_>) -> Result<(), ExportError> {
        self.submit(&picture.frame, |shutter| picture.moved(shutter))
    }

    /// Starts to draw a frame. `moved` gives it after a part of the shutter's time, or `None` if nothing moves. Where the picture is made of
    /// several no other may be under way.
    fn submit<E: From<GpuError>>(
        &mut self,
        frame: &Frame,
        mut moved: impl FnMut(f64) -> Result<Option<Frame>, E>,
    ) -> Result<(), E> {
        let overlays = self.overlays(frame);
        let Self { offscreen, gpu, renderer, refiner, size, parts, .. } = self;
        let Some(refiner) = refiner else {
            offscreen.submit(gpu, renderer, frame);
            return Ok(());
        };
        let size_px = [size.width, size.height];
        refiner.restart();
        let mut steady = None;
        while let Some(sub_frame) = refiner.next() {
            let mut moved = moved(sub_frame.shutter)?;
            let shown = moved.as_mut().unwrap_or_else(|| steady.get_or_insert_with(|| frame.clone()));
            let own = shown.items.len();
            shown.expose(frame, sub_frame.shutter);
            refiner.add(gpu, shown, size_px);
            shown.items.truncate(own);
        }
        if overlays == 0 || cfg!(target_arch = "wasm32") {
            // A page may not wait for parts.
            offscreen.submit_refined(gpu, refiner, frame);
            return Ok(());
        }
        let mut over = steady.unwrap_or_else(|| frame.clone());
        over.ghosts.retain(|ghost| ghost.moment.is_none());
        let places = Refinement::of(overlays);
        for number in 0..overlays {
            over.view = places.sub_frame(number).view(&frame.view, None, size_px);
            offscreen.submit_refined(gpu, refiner, &over);
            if number + 1 < overlays {
                let part = offscreen.read(gpu)?;
                match parts {
                    Some(sum) => sum.add(&part.rows()),
                    None => *parts = Some(PictureSum::of(&part.rows())),
                }
            }
        }
        Ok(())
    }

    /// How often what is no part of the scene is drawn over a refined picture, to smooth its edges; 0 if there is nothing or the picture is
    /// plain.
    fn overlays(&self, frame: &Frame) -> u32 {
        let Some(refiner) = &self.refiner else { return 0 };
        if frame.has_overlay() { refiner.refinement().sub_frames.min(MOST_OVERLAYS) } else { 0 }
    }

    /// Waits for the oldest picture under way.
    fn read(&mut self) -> Result<Picture, GpuError> {
        let drawn = self.offscreen.read(&self.gpu)?;
        let Some(mut sum) = self.parts.take() else { return Ok(Picture::Drawn(drawn)) };
        sum.add(&drawn.rows());
        Ok(Picture::Made(sum.mean()))
    }

    /// Drops pictures under way.
    fn clear(&mut self) {
        self.offscreen.clear();
        self.parts = None;
    }

    /// Sets the background of the following frames.
    pub fn set_background(&mut self, background: Background) {
        self.renderer.set_background(background);
        if let Some(refiner) = &mut self.refiner {
            refiner.set_background(background);
        }
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
