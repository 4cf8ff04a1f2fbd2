//! A texture as a target, and its way back to the CPU.

use crate::frame::Frame;
use crate::picture::Image;
use crate::render::gpu::{Gpu, GpuError};
use crate::render::read_back::{Drawn, ReadBack};
use crate::render::renderer::{Renderer, Target, Viewport};

/// A texture to draw into, with its way back to the CPU. Kept for a run of pictures of one size, it allocates nothing more on the GPU
/// than a buffer for each picture that is on its way or being read.
#[derive(Debug)]
pub struct Offscreen {
    texture: wgpu::Texture,
    view: wgpu::TextureView,
    back: ReadBack,
}

impl Offscreen {
    /// What a renderer for these targets is made for: sRGB, 8 bits a channel.
    pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;

    /// A target of so many pixels.
    ///
    /// # Errors
    ///
    /// [`GpuError::Size`] where a side is 0 or longer than the adapter can draw.
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
    /// [`GpuError::ReadBack`] where the device is lost.
    pub fn render(&mut self, gpu: &Gpu, renderer: &mut Renderer, frame: &Frame) -> Result<Image, GpuError> {
        self.draw(gpu, renderer, frame).map(|drawn| drawn.rows().to_image())
    }

    /// As [`Offscreen::render`], with no copy of the picture.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] where the device is lost.
    pub fn draw(&mut self, gpu: &Gpu, renderer: &mut Renderer, frame: &Frame) -> Result<Drawn, GpuError> {
        Ok(self.draw_while(gpu, renderer, frame, || ())?.0)
    }

    /// As [`Offscreen::draw`], with something else done while the picture is drawn.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] where the device is lost.
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

    /// Starts drawing a frame; [`Offscreen::read`] waits for it. One can be read while the next are drawn.
    pub fn submit(&mut self, gpu: &Gpu, renderer: &mut Renderer, frame: &Frame) {
        let viewport = Viewport::whole(self.texture.width(), self.texture.height());
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        renderer.encode(gpu, &mut encoder, frame, Target { view: &self.view, viewport });
        self.back.submit(gpu, Vec::new(), encoder, &self.texture);
    }

    /// Pictures that were submitted and not read.
    #[must_use]
    pub fn under_way(&self) -> usize {
        self.back.under_way()
    }

    /// Waits for the picture that was submitted first of those that were not read, and for nothing that was submitted after it.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] where nothing was submitted or the device is lost.
    pub fn read(&mut self, gpu: &Gpu) -> Result<Drawn, GpuError> {
        self.back.read(gpu)
    }
}
