//! Presents pictures: through the driver's surface, or through memory shared with the X server.

use std::sync::Arc;

use winit::window::Window;

use super::shared::Shared;
use crate::render::{Gpu, GpuError};
use crate::words::texts;

/// Where a window's pictures are drawn and shown.
pub struct Screen {
    window: Arc<Window>,
    surface: wgpu::Surface<'static>,
    configuration: wgpu::SurfaceConfiguration,
    is_configured: bool,
    scene_format: wgpu::TextureFormat,
    /// Shared memory, if it is available.
    shared: Option<Shared>,
}

/// The texture that the next picture is drawn on.
pub enum DrawTarget {
    /// The next texture of the surface.
    OfSurface(wgpu::SurfaceTexture),
    /// A texture that is copied to memory shared with the X server.
    Shared(wgpu::Texture),
}

impl DrawTarget {
    /// The texture.
    pub const fn texture(&self) -> &wgpu::Texture {
        match self {
            Self::OfSurface(shown) => &shown.texture,
            Self::Shared(texture) => texture,
        }
    }
}

impl Screen {
    /// For a window and its surface.
    ///
    /// # Errors
    /// [`GpuError::NoSurface`]
    pub fn new(gpu: &Gpu, window: Arc<Window>, surface: wgpu::Surface<'static>) -> Result<Self, GpuError> {
        let no_surface = || GpuError::NoSurface { reason: texts::GPU_CANNOT_DRAW_ON_SURFACE.into() };
        let size = window.inner_size();
        let mut configuration =
            surface.get_default_config(&gpu.adapter, size.width.max(1), size.height.max(1)).ok_or_else(no_surface)?;
        // The panels blend in sRGB's own numbers, the scene in linear light: one texture, two views of it.
        let capabilities = surface.get_capabilities(&gpu.adapter);
        let flags = gpu.adapter.get_downlevel_capabilities().flags;
        let plain = capabilities
            .formats
            .iter()
            .copied()
            .find(|format| matches!(format, wgpu::TextureFormat::Bgra8Unorm | wgpu::TextureFormat::Rgba8Unorm));
        let mut scene_format = configuration.format;
        if let Some(plain) = plain.filter(|_| flags.contains(wgpu::DownlevelFlags::SURFACE_VIEW_FORMATS)) {
            configuration.format = plain;
            scene_format = plain.add_srgb_suffix();
            configuration.view_formats = vec![scene_format];
        } else if let Some(plain) = plain.filter(|_| cfg!(target_arch = "wasm32")) {
            // The shaders encode the scene.
            (configuration.format, scene_format) = (plain, plain);
        }
        configuration.usage |= wgpu::TextureUsages::COPY_DST & capabilities.usages;
        configuration.present_mode = wgpu::PresentMode::AutoVsync;
        configuration.desired_maximum_frame_latency = 1;
        let shared =
            if gpu.is_software && configuration.format == Shared::FORMAT { Shared::new(&window) } else { None };
        Ok(Self { window, surface, configuration, is_configured: false, scene_format, shared })
    }

    /// The format of the view of a picture that the scene is drawn on.
    pub const fn scene_format(&self) -> wgpu::TextureFormat {
        self.scene_format
    }

    /// The format of the view that the panels are drawn on, and of the picture.
    pub const fn format(&self) -> wgpu::TextureFormat {
        self.configuration.format
    }

    /// A picture's width and height, in pixels.
    pub const fn size_px(&self) -> [u32; 2] {
        [self.configuration.width, self.configuration.height]
    }

    /// Whether something can be copied onto pictures.
    pub const fn can_copy_to(&self) -> bool {
        self.shared.is_some() || self.configuration.usage.contains(wgpu::TextureUsages::COPY_DST)
    }

    /// Sets the size of pictures in pixels.
    pub fn resize(&mut self, size_px: [u32; 2]) {
        if size_px != self.size_px() {
            [self.configuration.width, self.configuration.height] = size_px;
            self.is_configured = false;
        }
    }

    /// The surface is configured anew before it is drawn on again.
    pub const fn outdate(&mut self) {
        self.is_configured = false;
    }

    /// The picture to draw on, where there is one now; a surface that went out of date is configured anew once. Where pictures can no
    /// longer be shared the window is to be drawn anew: on the surface other things may be possible.
    pub fn next(&mut self, gpu: &Gpu) -> Option<DrawTarget> {
        if let Some(shared) = &mut self.shared {
            match shared.texture(gpu, &self.configuration) {
                Ok(texture) => return Some(DrawTarget::Shared(texture)),
                Err(error) => {
                    self.give_up_sharing(&error);
                    return None;
                }
            }
        }
        for _ in 0..2 {
            if !self.is_configured {
                self.surface.configure(&gpu.device, &self.configuration);
                self.is_configured = true;
            }
            match self.surface.get_current_texture() {
                wgpu::CurrentSurfaceTexture::Success(texture) => return Some(DrawTarget::OfSurface(texture)),
                wgpu::CurrentSurfaceTexture::Suboptimal(texture) => {
                    self.is_configured = false;
                    return Some(DrawTarget::OfSurface(texture));
                }
                wgpu::CurrentSurfaceTexture::Lost => {
                    self.is_configured = false;
                    if let Ok(surface) = gpu.instance.create_surface(Arc::clone(&self.window)) {
                        self.surface = surface;
                    }
                }
                wgpu::CurrentSurfaceTexture::Outdated => self.is_configured = false,
                wgpu::CurrentSurfaceTexture::Timeout
                | wgpu::CurrentSurfaceTexture::Occluded
                | wgpu::CurrentSurfaceTexture::Validation => return None,
            }
        }
        None
    }

    /// Submits what draws on a picture, the encoder's commands last, and shows it.
    pub fn show(
        &mut self,
        gpu: &Gpu,
        picture: DrawTarget,
        mut before: Vec<wgpu::CommandBuffer>,
        encoder: wgpu::CommandEncoder,
    ) {
        match (picture, &mut self.shared) {
            (DrawTarget::OfSurface(texture), _) => {
                before.push(encoder.finish());
                gpu.queue.submit(before);
                self.window.pre_present_notify();
                gpu.queue.present(texture);
            }
            (DrawTarget::Shared(_), Some(shared)) => {
                if let Err(error) = shared.show(gpu, &self.window, before, encoder) {
                    self.give_up_sharing(&error);
                }
            }
            // Sharing is given up where there is no picture.
            (DrawTarget::Shared(_), None) => {}
        }
    }

    fn give_up_sharing(&mut self, error: &dyn std::error::Error) {
        log::warn!("pictures are no longer shared with the display server: {error}");
        self.shared = None;
        self.window.request_redraw();
    }
}
