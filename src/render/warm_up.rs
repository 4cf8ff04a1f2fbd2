//! Draws that nobody sees. A software driver compiles a pipeline at its first draw, on a thread of its own: given that draw early, it
//! compiles one pipeline while the next is being made.

use crate::render::pipelines::DEPTH_FORMAT;
use crate::render::targets::texture_view;

/// A target of one pixel, with the formats and samples of a picture.
#[derive(Debug)]
pub struct WarmUp {
    colour: wgpu::TextureView,
    depth: wgpu::TextureView,
}

impl WarmUp {
    /// A target like those of a picture.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat, samples: u32) -> Self {
        let attachment = wgpu::TextureUsages::RENDER_ATTACHMENT;
        Self {
            colour: texture_view(device, "warm-up", format, samples, [1, 1], attachment),
            depth: texture_view(device, "warm-up depth", DEPTH_FORMAT, samples, [1, 1], attachment),
        }
    }

    /// Submits a pass of its own.
    pub fn submit(&self, device: &wgpu::Device, queue: &wgpu::Queue, draw: impl FnOnce(&mut wgpu::RenderPass<'_>)) {
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("warm-up"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.colour,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Discard,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Discard }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        draw(&mut pass);
        drop(pass);
        queue.submit([encoder.finish()]);
    }
}
