//! The stub for systems without shared memory.

use std::convert::Infallible;

use winit::window::Window;

use crate::render::Gpu;

/// Never exists on this system.
pub struct Shared(Infallible);

impl Shared {
    pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Bgra8Unorm;

    pub const fn new(_: &Window) -> Option<Self> {
        None
    }

    pub fn texture(&mut self, _: &Gpu, _: &wgpu::SurfaceConfiguration) -> Result<wgpu::Texture, Infallible> {
        match self.0 {}
    }

    pub fn show(
        &mut self,
        _: &Gpu,
        _: &Window,
        _: Vec<wgpu::CommandBuffer>,
        _: wgpu::CommandEncoder,
    ) -> Result<(), Infallible> {
        match self.0 {}
    }
}
