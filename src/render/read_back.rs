//! Read-back of pictures to the CPU.

use std::collections::VecDeque;
use std::sync::mpsc;

use crate::picture::Rows;
use crate::render::gpu::{Gpu, GpuError};

/// Reads back textures of one size with 4 bytes per pixel. It allocates only a buffer for each picture in flight.
#[derive(Debug)]
pub struct ReadBack {
    width: u32,
    height: u32,
    row_bytes: u32,
    under_way: VecDeque<Submitted>,
    /// Receives the buffers of pictures that were read, from any thread.
    give_back: mpsc::Sender<wgpu::Buffer>,
    free: mpsc::Receiver<wgpu::Buffer>,
}

/// A picture that is being drawn.
#[derive(Debug)]
struct Submitted {
    index: wgpu::SubmissionIndex,
    buffer: wgpu::Buffer,
    mapped: mpsc::Receiver<Result<(), wgpu::BufferAsyncError>>,
}

/// A finished picture in a mapped buffer.
#[derive(Debug)]
pub struct Drawn {
    width: u32,
    height: u32,
    row_bytes: u32,
    /// Mapped until it is dropped.
    bytes: Option<wgpu::BufferView>,
    buffer: wgpu::Buffer,
    give_back: mpsc::Sender<wgpu::Buffer>,
}

impl Drawn {
    /// Its pixels, in the texture's format.
    #[must_use]
    pub fn rows(&self) -> Rows<'_> {
        let bytes = self.bytes.as_deref().unwrap_or_default();
        Rows { width: self.width, height: self.height, row_bytes: self.row_bytes as usize, bytes }
    }
}

impl Drop for Drawn {
    fn drop(&mut self) {
        self.bytes = None;
        self.buffer.unmap();
        // The receiver is gone if the target was dropped.
        let _ = self.give_back.send(self.buffer.clone());
    }
}

impl ReadBack {
    /// For textures of this size in pixels.
    ///
    /// # Errors
    ///
    /// [`GpuError::Size`] if a side is 0 or longer than the adapter can draw.
    pub fn new(gpu: &Gpu, width: u32, height: u32) -> Result<Self, GpuError> {
        let limit = gpu.largest_side_px();
        let row_bytes = (4 * u64::from(width)).next_multiple_of(u64::from(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT));
        let size = row_bytes * u64::from(height);
        if !(1..=limit).contains(&width) || !(1..=limit).contains(&height) || size > gpu.device.limits().max_buffer_size
        {
            return Err(GpuError::Size { width, height, limit });
        }
        let (give_back, free) = mpsc::channel();
        Ok(Self { width, height, row_bytes: row_bytes as u32, under_way: VecDeque::new(), give_back, free })
    }

    /// Submits commands that draw on a texture, the encoder's last, and a copy of the texture. [`ReadBack::read`] waits for it.
    pub fn submit(
        &mut self,
        gpu: &Gpu,
        mut before: Vec<wgpu::CommandBuffer>,
        mut encoder: wgpu::CommandEncoder,
        texture: &wgpu::Texture,
    ) {
        let buffer = self.free.try_recv().unwrap_or_else(|_| self.new_buffer(gpu));
        let layout =
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(self.row_bytes), rows_per_image: None };
        encoder.copy_texture_to_buffer(
            texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo { buffer: &buffer, layout },
            wgpu::Extent3d { width: self.width, height: self.height, depth_or_array_layers: 1 },
        );
        before.push(encoder.finish());
        let index = gpu.queue.submit(before);
        let (sender, mapped) = mpsc::channel();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // The receiver is gone if the picture was dropped.
            let _ = sender.send(result);
        });
        self.under_way.push_back(Submitted { index, buffer, mapped });
    }

    fn new_buffer(&self, gpu: &Gpu) -> wgpu::Buffer {
        let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("read back"),
            size: u64::from(self.row_bytes) * u64::from(self.height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        if gpu.is_software {
            // A new buffer is filled with zeros when it is mapped. That makes the system provide its pages now, while the driver is busy
            // with earlier work, and not while a picture is waited for.
            let (sender, mapped) = mpsc::channel();
            buffer.map_async(wgpu::MapMode::Read, .., move |result| {
                let _ = sender.send(result);
            });
            let _ = gpu.device.poll(wgpu::PollType::Poll);
            // An error is reported when the picture is read.
            if !matches!(mapped.try_recv(), Ok(Err(_))) {
                buffer.unmap();
            }
        }
        buffer
    }

    /// The number of pictures that were submitted and not read.
    #[must_use]
    pub fn under_way(&self) -> usize {
        self.under_way.len()
    }

    /// Drops pictures that were submitted and not read.
    pub fn clear(&mut self) {
        self.under_way.clear();
    }

    /// The oldest picture that was not read, if it is there; nothing is waited for. `None`: it is under way.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] if nothing was submitted or the device is lost.
    pub fn read_if_there(&mut self, gpu: &Gpu) -> Result<Option<Drawn>, GpuError> {
        let failed = |reason: String| GpuError::ReadBack { adapter: gpu.info.name.clone(), reason };
        gpu.device.poll(wgpu::PollType::Poll).map_err(|error| failed(error.to_string()))?;
        let Some(first) = self.under_way.front() else { return Err(failed("nothing was drawn".to_owned())) };
        match first.mapped.try_recv() {
            Err(mpsc::TryRecvError::Empty) => return Ok(None),
            Err(error) => return Err(failed(error.to_string())),
            Ok(mapped) => mapped.map_err(|error| failed(error.to_string()))?,
        }
        let Submitted { buffer, .. } =
            self.under_way.pop_front().ok_or_else(|| failed("nothing was drawn".to_owned()))?;
        self.drawn(buffer).map(Some).map_err(failed)
    }

    /// Waits for the oldest picture that was not read, and for nothing that was submitted after it.
    ///
    /// # Errors
    ///
    /// [`GpuError::ReadBack`] if nothing was submitted or the device is lost.
    pub fn read(&mut self, gpu: &Gpu) -> Result<Drawn, GpuError> {
        let failed = |reason: String| GpuError::ReadBack { adapter: gpu.info.name.clone(), reason };
        let Submitted { index, buffer, mapped } =
            self.under_way.pop_front().ok_or_else(|| failed("nothing was drawn".to_owned()))?;
        let until = wgpu::PollType::Wait { submission_index: Some(index), timeout: None };
        gpu.device.poll(until).map_err(|error| failed(error.to_string()))?;
        mapped.recv().map_err(|error| failed(error.to_string()))?.map_err(|error| failed(error.to_string()))?;
        self.drawn(buffer).map_err(failed)
    }

    fn drawn(&self, buffer: wgpu::Buffer) -> Result<Drawn, String> {
        let bytes = Some(buffer.get_mapped_range(..).map_err(|error| error.to_string())?);
        let Self { width, height, row_bytes, .. } = *self;
        Ok(Drawn { width, height, row_bytes, bytes, buffer, give_back: self.give_back.clone() })
    }
}
