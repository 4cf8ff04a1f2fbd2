//! A target that is no window's, and the way back to the CPU.

use std::sync::mpsc;

use crate::frame::Frame;
use crate::render::gpu::{Gpu, GpuError};
use crate::render::image::{Image, Rows};
use crate::render::renderer::{Renderer, Viewport};

/// A texture to draw into and the buffer that brings it back. Kept for a run of pictures of one size, it allocates nothing more on
/// the GPU.
#[derive(Debug)]
pub struct Offscreen {
    width: u32,
    height: u32,
    texture: wgpu::Texture,
    view: wgpu::TextureView,
    buffer: wgpu::Buffer,
    row_bytes: u32,
    submitted: Option<Submitted>,
}

/// A picture that is being drawn.
#[derive(Debug)]
struct Submitted {
    index: wgpu::SubmissionIndex,
    mapped: mpsc::Receiver<Result<(), wgpu::BufferAsyncError>>,
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
        let limit = gpu.largest_side_px();
        let row_bytes = (4 * u64::from(width)).next_multiple_of(u64::from(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT));
        let size = row_bytes * u64::from(height);
        if !(1..=limit).contains(&width) || !(1..=limit).contains(&height) || size > gpu.device.limits().max_buffer_size
        {
            return Err(GpuError::Size { width, height, limit });
        }
        let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("offscreen"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: Self::FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("read back"),
            size,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        Ok(Self { width, height, texture, view, buffer, row_bytes: row_bytes as u32, submitted: None })
    }

    /// Draws a frame and waits for its picture.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] where the device is lost.
    pub fn render(&mut self, gpu: &Gpu, renderer: &mut Renderer, frame: &Frame) -> Result<Image, GpuError> {
        self.submit(gpu, renderer, frame);
        self.read(gpu)
    }

    /// Starts drawing a frame; [`Offscreen::read`] waits for it. With two of these one can be read while the other is drawn.
    /// A picture that was not read is dropped.
    pub fn submit(&mut self, gpu: &Gpu, renderer: &mut Renderer, frame: &Frame) {
        if self.submitted.take().is_some() {
            self.buffer.unmap();
        }
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        renderer.encode(gpu, &mut encoder, frame, &self.view, Viewport::whole(self.width, self.height));
        encoder.copy_texture_to_buffer(
            self.texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &self.buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(self.row_bytes),
                    rows_per_image: None,
                },
            },
            self.texture.size(),
        );
        let index = gpu.queue.submit([encoder.finish()]);
        let (sender, mapped) = mpsc::channel();
        self.buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // Nobody listens where the picture was dropped.
            let _ = sender.send(result);
        });
        self.submitted = Some(Submitted { index, mapped });
    }

    /// Waits for the picture that was last submitted, and for nothing that was submitted after it.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] where nothing was submitted or the device is lost.
    #[expect(clippy::redundant_closure_for_method_calls, reason = "the method itself is for one lifetime only")]
    pub fn read(&mut self, gpu: &Gpu) -> Result<Image, GpuError> {
        self.read_rows(gpu, |rows| rows.to_image())
    }

    /// As [`Offscreen::read`], as a PNG: [`Rows::to_png`], with no copy of the picture in between.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] where nothing was submitted or the device is lost; inside it what the encoder says.
    #[expect(clippy::redundant_closure_for_method_calls, reason = "the method itself is for one lifetime only")]
    pub fn read_png(&mut self, gpu: &Gpu) -> Result<Result<Vec<u8>, png::EncodingError>, GpuError> {
        self.read_rows(gpu, |rows| rows.to_png())
    }

    fn read_rows<T>(&mut self, gpu: &Gpu, take: impl FnOnce(&Rows<'_>) -> T) -> Result<T, GpuError> {
        let failed = |reason: String| GpuError::ReadBack { adapter: gpu.info.name.clone(), reason };
        let Submitted { index, mapped } =
            self.submitted.take().ok_or_else(|| failed("nothing was drawn".to_owned()))?;
        let until = wgpu::PollType::Wait { submission_index: Some(index), timeout: None };
        gpu.device.poll(until).map_err(|error| failed(error.to_string()))?;
        mapped.recv().map_err(|error| failed(error.to_string()))?.map_err(|error| failed(error.to_string()))?;
        let taken = {
            let bytes = self.buffer.get_mapped_range(..).map_err(|error| failed(error.to_string()))?;
            take(&Rows { width: self.width, height: self.height, row_bytes: self.row_bytes as usize, bytes: &bytes })
        };
        self.buffer.unmap();
        Ok(taken)
    }
}
