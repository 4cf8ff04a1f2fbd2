//! Pictures that the CPU drew, in memory that an X server reads: a driver may send each of them through a socket, which takes a
//! quarter of the time.

#[cfg(all(unix, not(target_os = "macos")))]
pub use x11::Shared;

#[cfg(not(all(unix, not(target_os = "macos"))))]
pub use nowhere::Shared;

#[cfg(all(unix, not(target_os = "macos")))]
mod x11 {
    use std::num::NonZeroU32;
    use std::sync::Arc;

    use winit::event_loop::{ActiveEventLoop, OwnedDisplayHandle};
    use winit::raw_window_handle::{HasDisplayHandle, RawDisplayHandle};
    use winit::window::Window;

    use crate::render::{Gpu, ReadBack};

    /// A window's pictures on their way through memory.
    pub struct Shared {
        surface: softbuffer::Surface<OwnedDisplayHandle, Arc<Window>>,
        kept: Option<(wgpu::Texture, ReadBack)>,
    }

    impl Shared {
        /// The format of pictures: that of an X server's windows, on processors that put the lowest byte first.
        pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Bgra8Unorm;

        /// For a window, if it is an X server's.
        pub fn new(event_loop: &ActiveEventLoop, window: &Arc<Window>) -> Option<Self> {
            let display = event_loop.owned_display_handle();
            let is_x11 = display
                .display_handle()
                .is_ok_and(|handle| matches!(handle.as_raw(), RawDisplayHandle::Xlib(_) | RawDisplayHandle::Xcb(_)));
            if !is_x11 || cfg!(target_endian = "big") {
                return None;
            }
            let context = softbuffer::Context::new(display).ok()?;
            let surface = softbuffer::Surface::new(&context, Arc::clone(window)).ok()?;
            Some(Self { surface, kept: None })
        }

        /// The texture to draw on: it keeps what was drawn. `configuration` says what it is to be like.
        pub fn texture(
            &mut self,
            gpu: &Gpu,
            configuration: &wgpu::SurfaceConfiguration,
        ) -> Result<wgpu::Texture, String> {
            let &wgpu::SurfaceConfiguration { width, height, format, .. } = configuration;
            if let Some((texture, _)) = &self.kept
                && (texture.width(), texture.height()) == (width, height)
            {
                return Ok(texture.clone());
            }
            let side = |side| NonZeroU32::new(side).ok_or("the window has no size");
            self.surface.resize(side(width)?, side(height)?).map_err(|error| error.to_string())?;
            let back = ReadBack::new(gpu, width, height).map_err(|error| error.to_string())?;
            let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some("window"),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                    | wgpu::TextureUsages::COPY_SRC
                    | wgpu::TextureUsages::COPY_DST,
                view_formats: &configuration.view_formats,
            });
            self.kept = Some((texture.clone(), back));
            Ok(texture)
        }

        /// Submits what draws on the texture, the encoder's commands last, waits for it and shows it.
        pub fn show(
            &mut self,
            gpu: &Gpu,
            window: &Window,
            before: Vec<wgpu::CommandBuffer>,
            encoder: wgpu::CommandEncoder,
            texture: &wgpu::Texture,
        ) -> Result<(), String> {
            let Some((_, back)) = &mut self.kept else { return Ok(()) };
            back.submit(gpu, before, encoder, texture);
            let drawn = back.read(gpu).map_err(|error| error.to_string())?;
            let mut shown = self.surface.buffer_mut().map_err(|error| error.to_string())?;
            let row_bytes = 4 * texture.width() as usize;
            let shown_rows = bytemuck::cast_slice_mut::<u32, u8>(&mut shown).chunks_exact_mut(row_bytes);
            for (shown, drawn) in shown_rows.zip(drawn.rows().rows()) {
                shown.copy_from_slice(drawn);
            }
            window.pre_present_notify();
            shown.present().map_err(|error| error.to_string())
        }
    }
}

#[cfg(not(all(unix, not(target_os = "macos"))))]
mod nowhere {
    use std::sync::Arc;

    use winit::event_loop::ActiveEventLoop;
    use winit::window::Window;

    use crate::render::Gpu;

    /// There is none here.
    pub enum Shared {}

    impl Shared {
        pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Bgra8Unorm;

        pub const fn new(_: &ActiveEventLoop, _: &Arc<Window>) -> Option<Self> {
            None
        }

        pub fn texture(&mut self, _: &Gpu, _: &wgpu::SurfaceConfiguration) -> Result<wgpu::Texture, String> {
            match *self {}
        }

        pub fn show(
            &mut self,
            _: &Gpu,
            _: &Window,
            _: Vec<wgpu::CommandBuffer>,
            _: wgpu::CommandEncoder,
            _: &wgpu::Texture,
        ) -> Result<(), String> {
            match *self {}
        }
    }
}
