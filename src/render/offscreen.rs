//! A texture as a render target, with read-back to the CPU.

use crate::frame::Frame;
use crate::picture::Image;
use crate::render::gpu::{Gpu, GpuError};
use crate::render::read_back::{Drawn, ReadBack};
use crate::render::refine::Refiner;
use crate::render::renderer::{Renderer, Target, Viewport};

/// A texture to draw into, with read-back to the CPU. For a run of pictures of one size it allocates only a buffer for each picture in
/// flight.
#[derive(Debug)]
pub struct Offscreen {
    texture: wgpu::Texture,
    view: wgpu::TextureView,
    back: ReadBack,
}

impl Offscreen {
    /// The texture format: sRGB, 8 bits per channel.
    pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;

    /// A target of this size in pixels.
    ///
    /// # Errors
    ///
    /// [`GpuError::Size`] if a side is 0 or longer than the adapter can draw.
    pub fn new(gpu: &Gpu, width: u32, height: u32) -> Result<Self, GpuError> {
        let back = ReadBack::new(gpu, width, height)?;
        let texture =
            gpu.picture_texture("offscreen", Self::FORMAT, [width, height], wgpu::TextureUsages::empty(), &[]);
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Ok(Self { texture, view, back })
    }

    /// Draws a frame and waits for its picture. Pictures that were submitted and not read are dropped.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] if the device is lost.
    pub fn render(&mut self, gpu: &Gpu, renderer: &mut Renderer, frame: &Frame) -> Result<Image, GpuError> {
        self.draw(gpu, renderer, frame).map(|drawn| drawn.rows().to_image())
    }

    /// Like [`Offscreen::render`], without a copy of the picture.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] if the device is lost.
    pub fn draw(&mut self, gpu: &Gpu, renderer: &mut Renderer, frame: &Frame) -> Result<Drawn, GpuError> {
        Ok(self.draw_while(gpu, renderer, frame, || ())?.0)
    }

    /// Like [`Offscreen::draw`], and runs `meanwhile` while the picture is drawn.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] if the device is lost.
    pub fn draw_while<T>(
        &mut self,
        gpu: &Gpu,
        renderer: &mut Renderer,
        frame: &Frame,
        meanwhile: impl FnOnce() -> T,
    ) -> Result<(Drawn, T), GpuError> {
        self.back.clear();
        self.submit(gpu, renderer, frame);
        let done = meanwhile();
        Ok((self.read(gpu)?, done))
    }

    /// Starts drawing a frame; [`Offscreen::read`] waits for it. A picture can be read while the next ones are drawn.
    pub fn submit(&mut self, gpu: &Gpu, renderer: &mut Renderer, frame: &Frame) {
        let viewport = Viewport::whole(self.texture.width(), self.texture.height());
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        renderer.encode(gpu, &mut encoder, frame, Target { view: &self.view, viewport });
        self.back.submit(gpu, Vec::new(), encoder, &self.texture);
    }

    /// Starts showing a refined picture, `frame` as [`Refiner::show`] takes it; [`Offscreen::read`] waits for it.
    pub fn submit_refined(&mut self, gpu: &Gpu, refiner: &mut Refiner, frame: &Frame) {
        let viewport = Viewport::whole(self.texture.width(), self.texture.height());
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        refiner.show(gpu, &mut encoder, frame, Target { view: &self.view, viewport });
        self.back.submit(gpu, Vec::new(), encoder, &self.texture);
    }

    /// Draws a refined picture of a frame in which nothing moves, and waits for it.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] if the device is lost.
    pub fn render_refined(&mut self, gpu: &Gpu, refiner: &mut Refiner, frame: &Frame) -> Result<Image, GpuError> {
        self.begin_refined(gpu, refiner, frame);
        self.read(gpu).map(|drawn| drawn.rows().to_image())
    }

    /// Starts to draw a refined picture of a frame in which nothing moves. Pictures that were submitted and not read are dropped.
    pub fn begin_refined(&mut self, gpu: &Gpu, refiner: &mut Refiner, frame: &Frame) {
        self.back.clear();
        refiner.restart();
        let mut of_sub_frames = frame.clone();
        while refiner.next().is_some() {
            refiner.add(gpu, &mut of_sub_frames, [self.texture.width(), self.texture.height()]);
        }
        self.submit_refined(gpu, refiner, frame);
    }

    /// The oldest picture that was not read, if it is there; nothing is waited for. `None`: it is under way.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] if nothing was submitted or the device is lost.
    pub fn read_if_there(&mut self, gpu: &Gpu) -> Result<Option<Drawn>, GpuError> {
        self.back.read_if_there(gpu)
    }

    /// Drops pictures that were submitted and not read.
    pub fn clear(&mut self) {
        self.back.clear();
    }

    /// The number of pictures that were submitted and not read.
    #[must_use]
    pub fn under_way(&self) -> usize {
        self.back.under_way()
    }

    /// Waits for the oldest picture that was not read, and for nothing that was submitted after it.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] if nothing was submitted or the device is lost.
    pub fn read(&mut self, gpu: &Gpu) -> Result<Drawn, GpuError> {
        self.back.read(gpu)
    }
}
