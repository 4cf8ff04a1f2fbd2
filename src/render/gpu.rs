//! The adapter and its device, for a window or for none.

use std::hint::black_box;
use std::thread;

use thiserror::Error;

use super::choice::chosen_drivers;
#[cfg(not(target_arch = "wasm32"))]
use super::quiet::without_driver_chatter;
#[cfg(not(target_arch = "wasm32"))]
use super::watch::watched;
use super::watch::{PATIENCE, no_threads};
use crate::render::{mesh, shaders};
use crate::words::{Argument, Message, display_by_message, texts};

/// Why drawing is not possible. Each message names the missing part and how to install it.
#[derive(Debug, Error)]
pub enum GpuError {
    /// No driver offers an adapter.
    NoAdapter,
    /// The adapter refuses to open a device.
    NoDevice {
        /// The adapter's name.
        adapter: String,
        /// The driver's message.
        reason: String,
    },
    /// The window system offers no surface to draw on.
    NoSurface {
        /// The driver's message, or that the adapter cannot draw on the surface.
        reason: Argument,
    },
    /// The picture has no pixels, or more in a row or column than the adapter can draw.
    Size {
        /// The requested width, in pixels.
        width: u32,
        /// The requested height, in pixels.
        height: u32,
        /// The longest side that the adapter can draw, in pixels.
        limit: u32,
    },
    /// The threads that drawing needs cannot be started.
    NoThreads {
        /// The system's message.
        reason: String,
    },
    /// The driver does not answer.
    Hangs {
        /// The adapter's name and driver, where the driver said so much.
        adapter: Option<String>,
        /// For so long.
        seconds: u64,
    },
    /// Reading the picture back failed.
    ReadBack {
        /// The adapter's name.
        adapter: String,
        /// The driver's message.
        reason: String,
    },
}

display_by_message!(GpuError);

impl GpuError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::NoAdapter => with_choice(texts::GPU_NO_ADAPTER.into()),
            Self::NoDevice { adapter, reason } => with_choice(texts::gpu_no_device(adapter, reason)),
            Self::NoThreads { reason } => texts::gpu_no_threads(reason),
            Self::Hangs { adapter: Some(adapter), seconds } => {
                with_choice(texts::gpu_adapter_hangs(adapter, seconds.to_string()))
            }
            Self::Hangs { adapter: None, seconds } => with_choice(texts::gpu_driver_hangs(seconds.to_string())),
            Self::NoSurface { reason } => texts::gpu_no_surface(reason.clone()),
            Self::Size { width, height, limit } => texts::gpu_size(*width, *height, *limit),
            Self::ReadBack { adapter, reason } => texts::gpu_not_read_back(adapter, reason),
        }
    }
}

/// The message, with the variables that have drivers chosen.
fn with_choice(problem: Message) -> Message {
    match chosen_drivers() {
        Some(variables) => texts::gpu_chosen(problem, variables),
        None => problem,
    }
}

/// The size of a block whose freeing makes glibc keep freed memory afterwards, up to twice this size.
const KEPT_BYTES: usize = 16 << 20;

/// Starts preparations for a renderer in the background and returns. They are done before the driver has opened.
fn prepare_ahead() {
    // A software driver allocates and frees megabytes for each picture. If the allocator returns them to the system each time, each new
    // page costs a fault: a fifth of a film's time. glibc decides by the largest block freed so far (mallopt(3), M_MMAP_THRESHOLD); the
    // block need not have been written to.
    drop(black_box(Vec::<u8>::with_capacity(KEPT_BYTES)));
    // Without a thread it is done when it is needed.
    let _ = thread::Builder::new().name("prepare".to_owned()).spawn(|| {
        shaders::parse_usual();
        let _ = mesh::geometry();
        for level in 0..mesh::MESHES {
            let _ = mesh::edges(level);
        }
    });
}

/// An adapter with its open device and queue. A copy is the same device.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// The instance that the adapter belongs to.
    pub instance: wgpu::Instance,
    /// The adapter.
    pub adapter: wgpu::Adapter,
    /// Its device.
    pub device: wgpu::Device,
    /// The device's queue.
    pub queue: wgpu::Queue,
    /// The adapter's name, driver, backend and kind.
    pub info: wgpu::AdapterInfo,
    /// Whether the CPU draws. The work per pixel is then expensive.
    pub is_software: bool,
    /// The driver's first work, which shows whether it works at all.
    first_work: wgpu::SubmissionIndex,
}

impl Gpu {
    /// The best adapter that needs no display. Vulkan is tried first, because trying every backend costs tens of milliseconds. OpenGL is
    /// not tried: without a display its output differs between drivers.
    ///
    /// # Errors
    ///
    /// [`GpuError::NoAdapter`], [`GpuError::NoDevice`], [`GpuError::NoThreads`] and [`GpuError::Hangs`].
    #[cfg(not(target_arch = "wasm32"))]
    pub fn headless() -> Result<Self, GpuError> {
        let open = |backends| {
            let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
            descriptor.backends = backends;
            descriptor.flags = wgpu::InstanceFlags::empty();
            pollster::block_on(Self::open(wgpu::Instance::new(descriptor), None))
        };
        without_driver_chatter(|| {
            watched(PATIENCE, move || {
                prepare_ahead();
                let opened =
                    open(wgpu::Backends::VULKAN).or_else(|_| open(wgpu::Backends::PRIMARY - wgpu::Backends::VULKAN));
                opened.map_err(|error| no_threads().unwrap_or(error))
            })
        })
    }

    /// The best adapter that can draw on a window, and the window's surface. `display` and `window` are handles that are
    /// cheap to clone, such as winit's `OwnedDisplayHandle` and an `Arc<Window>`.
    ///
    /// # Errors
    ///
    /// [`GpuError::NoSurface`], and those of [`Gpu::headless`].
    #[cfg(not(target_arch = "wasm32"))]
    pub fn for_window<D, W>(display: &D, window: &W) -> Result<(Self, wgpu::Surface<'static>), GpuError>
    where
        D: wgpu::wgt::WgpuHasDisplayHandle + Clone,
        W: Into<wgpu::SurfaceTarget<'static>> + Clone,
    {
        let open = |backends| {
            let mut descriptor = wgpu::InstanceDescriptor::new_with_display_handle(Box::new(display.clone()));
            descriptor.backends = backends;
            descriptor.flags = wgpu::InstanceFlags::empty();
            let instance = watched(PATIENCE, move || {
                prepare_ahead();
                Ok(wgpu::Instance::new(descriptor))
            })?;
            // Some systems want surfaces made on the thread of the window.
            let surface = instance
                .create_surface(window.clone())
                .map_err(|error| GpuError::NoSurface { reason: error.to_string().into() })?;
            watched(PATIENCE, move || {
                let opened = pollster::block_on(Self::open(instance, Some(&surface)));
                let gpu = opened.map_err(|error| no_threads().unwrap_or(error))?;
                Ok((gpu, surface))
            })
        };
        without_driver_chatter(|| {
            open(wgpu::Backends::VULKAN).or_else(|error| match error {
                // Another backend would have to wait for it as well.
                GpuError::Hangs { .. } | GpuError::NoThreads { .. } => Err(error),
                _ => open(wgpu::Backends::all() - wgpu::Backends::VULKAN),
            })
        })
    }

    /// The adapter of a page, by WebGL2, and the surface of its canvas. A page may not wait, so this is asynchronous.
    ///
    /// # Errors
    /// [`GpuError::NoSurface`], [`GpuError::NoAdapter`] and [`GpuError::NoDevice`].
    #[cfg(target_arch = "wasm32")]
    pub async fn for_page(
        canvas: impl Into<wgpu::SurfaceTarget<'static>>,
    ) -> Result<(Self, wgpu::Surface<'static>), GpuError> {
        prepare_ahead();
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = wgpu::Backends::GL;
        descriptor.flags = wgpu::InstanceFlags::empty();
        let instance = wgpu::Instance::new(descriptor);
        let surface = instance
            .create_surface(canvas)
            .map_err(|error| GpuError::NoSurface { reason: error.to_string().into() })?;
        let gpu = Self::open(instance, Some(&surface)).await?;
        Ok((gpu, surface))
    }

    async fn open(instance: wgpu::Instance, surface: Option<&wgpu::Surface<'static>>) -> Result<Self, GpuError> {
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            compatible_surface: surface,
            ..Default::default()
        };
        let adapter = instance.request_adapter(&options).await.map_err(|_| GpuError::NoAdapter)?;
        let info = adapter.get_info();
        let supported = adapter.limits();
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("inbetween"),
            required_limits: wgpu::Limits::default().or_worse_values_from(&supported).using_resolution(supported),
            memory_hints: wgpu::MemoryHints::MemoryUsage,
            ..Default::default()
        };
        let (device, queue) = adapter
            .request_device(&descriptor)
            .await
            .map_err(|error| GpuError::NoDevice { adapter: info.name.clone(), reason: error.to_string() })?;
        let is_software = info.device_type == wgpu::DeviceType::Cpu;
        let first_work = first_work(&device, &queue);
        Ok(Self { instance, adapter, device, queue, info, is_software, first_work })
    }

    /// Waits until the driver has done its first work, which began when it was opened. A driver that lacks threads never ends it.
    ///
    /// # Errors
    /// [`GpuError::Hangs`] and [`GpuError::NoThreads`]: dropping what belongs to the device would then hang as well.
    pub fn check(&self) -> Result<(), GpuError> {
        if cfg!(target_arch = "wasm32") {
            // A page may not wait.
            return Ok(());
        }
        let first = wgpu::PollType::Wait { submission_index: Some(self.first_work.clone()), timeout: Some(PATIENCE) };
        match self.device.poll(first) {
            Err(wgpu::PollError::Timeout) => Err(no_threads().unwrap_or_else(|| GpuError::Hangs {
                adapter: Some(format!("{} ({})", self.info.name, self.info.driver)),
                seconds: PATIENCE.as_secs(),
            })),
            _ => Ok(()),
        }
    }

    /// A texture for pictures of this size with one sample per pixel, as a render target and copy source, plus the usages `more`. Each side
    /// must be from 1 to [`Gpu::largest_side_px`].
    #[must_use]
    pub fn picture_texture(
        &self,
        label: &str,
        format: wgpu::TextureFormat,
        [width, height]: [u32; 2],
        more: wgpu::TextureUsages,
        view_formats: &[wgpu::TextureFormat],
    ) -> wgpu::Texture {
        self.device.create_texture(&wgpu::TextureDescriptor {
            label: Some(label),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC | more,
            view_formats,
        })
    }

    /// The longest side of a picture, in pixels.
    #[must_use]
    pub fn largest_side_px(&self) -> u32 {
        self.device.limits().max_texture_dimension_2d
    }
}

/// Has the driver fill a pixel.
fn first_work(device: &wgpu::Device, queue: &wgpu::Queue) -> wgpu::SubmissionIndex {
    let pixel = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("first work"),
        size: wgpu::Extent3d::default(),
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8Unorm,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    });
    let view = pixel.create_view(&wgpu::TextureViewDescriptor::default());
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    drop(encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::BLACK), store: wgpu::StoreOp::Store },
        })],
        ..Default::default()
    }));
    queue.submit([encoder.finish()])
}
