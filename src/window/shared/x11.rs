//! Shared memory with the X server, on a connection of its own.

use std::io;

use memmap2::MmapMut;
use rustix::fs::{MemfdFlags, SealFlags, fcntl_add_seals, ftruncate, memfd_create};
use thiserror::Error;
use winit::raw_window_handle::{HasWindowHandle, RawWindowHandle};
use winit::window::Window;
use x11rb::connection::Connection;
use x11rb::errors::{ConnectionError, ReplyError, ReplyOrIdError};
use x11rb::protocol::shm::{self, ConnectionExt as _};
use x11rb::protocol::xproto::{ConnectionExt as _, CreateGCAux, Gcontext, ImageFormat, ImageOrder, VisualClass};
use x11rb::protocol::{Event, xproto};
use x11rb::rust_connection::RustConnection;

use crate::render::{Gpu, GpuError, ReadBack};

/// Why a picture did not arrive.
#[derive(Debug, Error)]
pub enum SharedError {
    /// The picture did not come back.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The server cannot be asked.
    #[error("the X server cannot be reached: {0}")]
    Connection(#[from] ConnectionError),
    /// The server refuses.
    #[error("the X server refuses: {0}")]
    Reply(#[from] ReplyError),
    /// The server has no more names.
    #[error("the X server has no name left: {0}")]
    Id(#[from] ReplyOrIdError),
    /// The server refused something before.
    #[error("the X server refused a picture: {0:?}")]
    Refused(x11rb::x11_utils::X11Error),
    /// There is no memory to share.
    #[error("no memory can be shared: {0}")]
    Memory(#[from] io::Error),
}

/// A window's pictures on their way through memory, on a connection of their own.
pub struct Shared {
    server: RustConnection,
    window: xproto::Window,
    context: Gcontext,
    depth: u8,
    buffers: Option<Buffers>,
}

/// The buffers for pictures of one size.
struct Buffers {
    texture: wgpu::Texture,
    back: ReadBack,
    /// As long as the read-back's buffer, or longer.
    memory: Option<Memory>,
}

/// Memory that the server reads.
struct Memory {
    bytes: MmapMut,
    segment: shm::Seg,
}

impl Shared {
    /// The format of pictures: that of the windows of X servers, where the lowest byte comes first.
    pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Bgra8Unorm;

    /// For a window; `None` where it is not an X server's, or the server can share no memory with this process.
    pub fn new(window: &Window) -> Option<Self> {
        let window = match window.window_handle().ok()?.as_raw() {
            RawWindowHandle::Xlib(handle) => xproto::Window::try_from(handle.window).ok()?,
            RawWindowHandle::Xcb(handle) => handle.window.get(),
            _ => return None,
        };
        let (server, _) = RustConnection::connect(None).ok()?;
        let version = server.shm_query_version().ok()?.reply().ok()?;
        let depth = server.get_geometry(window).ok()?.reply().ok()?.depth;
        let visual = server.get_window_attributes(window).ok()?.reply().ok()?.visual;
        if (version.major_version, version.minor_version) < (1, 2) || !is_plain(&server, depth, visual) {
            return None;
        }
        let context = server.generate_id().ok()?;
        let silent = CreateGCAux::new().graphics_exposures(0);
        server.create_gc(context, window, &silent).ok()?.check().ok()?;
        // A server elsewhere says only now that it cannot share.
        Memory::new(&server, 4096).ok()?.give_back(&server).ok()?;
        Some(Self { server, window, context, depth, buffers: None })
    }

    /// The texture to draw on: it keeps what was drawn. `configuration` says what it is to be like.
    pub fn texture(
        &mut self,
        gpu: &Gpu,
        configuration: &wgpu::SurfaceConfiguration,
    ) -> Result<wgpu::Texture, SharedError> {
        let &wgpu::SurfaceConfiguration { width, height, format, .. } = configuration;
        if let Some(buffers) = &self.buffers
            && (buffers.texture.width(), buffers.texture.height()) == (width, height)
        {
            return Ok(buffers.texture.clone());
        }
        let memory = self.buffers.take().and_then(|buffers| buffers.memory);
        let back = ReadBack::new(gpu, width, height)?;
        let copied_to = wgpu::TextureUsages::COPY_DST;
        let texture = gpu.picture_texture("window", format, [width, height], copied_to, &configuration.view_formats);
        self.buffers = Some(Buffers { texture: texture.clone(), back, memory });
        Ok(texture)
    }

    /// Submits what draws on the texture that was asked for last, the encoder's commands last, waits for it and shows it. What the
    /// server has against it is said with the next.
    pub fn show(
        &mut self,
        gpu: &Gpu,
        window: &Window,
        before: Vec<wgpu::CommandBuffer>,
        encoder: wgpu::CommandEncoder,
    ) -> Result<(), SharedError> {
        let Buffers { texture, back, memory } = self.buffers.as_mut().expect("there is a texture to draw on");
        back.submit(gpu, before, encoder, texture);
        let drawn = match back.read(gpu) {
            Ok(drawn) => drawn,
            Err(error) => {
                // A device that is lost is replaced, and this with it: no other way would show anything.
                log::warn!("a picture of the window is lost: {error}");
                return Ok(());
            }
        };
        let rows = drawn.rows();
        // Requests are done one after another: once this one is, the picture before has been read.
        self.server.get_input_focus()?.reply()?;
        while let Some(event) = self.server.poll_for_event()? {
            if let Event::Error(error) = event {
                return Err(SharedError::Refused(error));
            }
        }
        if let Some(small) = memory.take_if(|memory| memory.bytes.len() < rows.bytes.len()) {
            small.give_back(&self.server)?;
        }
        let memory = match memory {
            Some(memory) => memory,
            None => memory.insert(Memory::new(&self.server, rows.bytes.len())?),
        };
        memory.bytes[..rows.bytes.len()].copy_from_slice(rows.bytes);
        window.pre_present_notify();
        let [width, height, stride] = [rows.width, rows.height, rows.row_bytes as u32 / 4].map(|side| side as u16);
        self.server.shm_put_image(
            self.window,
            self.context,
            stride,
            height,
            0,
            0,
            width,
            height,
            0,
            0,
            self.depth,
            ImageFormat::Z_PIXMAP.into(),
            false,
            memory.segment,
            0,
        )?;
        self.server.flush()?;
        Ok(())
    }
}

impl Memory {
    fn new(server: &RustConnection, len: usize) -> Result<Self, SharedError> {
        let flags = MemfdFlags::CLOEXEC | MemfdFlags::ALLOW_SEALING;
        let file = memfd_create(c"inbetween picture", flags).map_err(io::Error::from)?;
        ftruncate(&file, len as u64).map_err(io::Error::from)?;
        fcntl_add_seals(&file, SealFlags::SHRINK | SealFlags::SEAL).map_err(io::Error::from)?;
        #[expect(unsafe_code, reason = "memory that is shared can be had in no other way")]
        // SAFETY: the file cannot be shortened, and only the server has it too, which is told to map it read-only.
        let bytes = unsafe { MmapMut::map_mut(&file) }?;
        let segment = server.generate_id()?;
        server.shm_attach_fd(segment, file, true)?.check()?;
        Ok(Self { bytes, segment })
    }

    fn give_back(self, server: &RustConnection) -> Result<(), SharedError> {
        Ok(server.shm_detach(self.segment)?.check()?)
    }
}

/// Whether a visual's pixels are four bytes: blue, green, red and one that is opacity at most, which pictures have all of.
fn is_plain(server: &RustConnection, depth: u8, visual: xproto::Visualid) -> bool {
    let setup = server.setup();
    let has_four_bytes = setup.pixmap_formats.iter().any(|it| it.depth == depth && it.bits_per_pixel == 32);
    let depths = setup.roots.iter().flat_map(|screen| &screen.allowed_depths);
    let mut visuals = depths.filter(|it| it.depth == depth).flat_map(|it| &it.visuals);
    let has_masks = visuals.any(|it| {
        it.visual_id == visual
            && it.class == VisualClass::TRUE_COLOR
            && (it.red_mask, it.green_mask, it.blue_mask) == (0x00ff_0000, 0xff00, 0xff)
    });
    has_four_bytes && has_masks && setup.image_byte_order == ImageOrder::LSB_FIRST
}
