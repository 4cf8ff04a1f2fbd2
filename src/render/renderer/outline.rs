//! The outline around the chosen node's shapes.

use super::{Renderer, Target, colour_attachment, depth_attachment, set_viewport};
use crate::frame::Frame;
use crate::render::gpu::Gpu;
use crate::render::mesh::geometry;
use crate::render::pipelines::Kind;
use crate::render::targets::Targets;

impl Renderer {
    /// Draws one outline around all outlined shapes, inside a rectangle in pixels from the viewport's corner.
    pub(super) fn draw_outline(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        frame: &Frame,
        Target { view, viewport }: Target<'_>,
        [x, y, width, height]: [u32; 4],
    ) {
        let device = &gpu.device;
        let Some(targets) = &mut self.targets else { return };
        targets.mask(device, &self.pipelines);
        let Some(Targets { depth, mask: Some(mask), .. }) = &self.targets else { return };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("mask"),
            color_attachments: &[colour_attachment(&mask.view, wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT))],
            depth_stencil_attachment: Some(depth_attachment(depth, wgpu::LoadOp::Load, wgpu::StoreOp::Store)),
            ..Default::default()
        });
        set_viewport(&mut pass, viewport);
        self.bind_instances(&mut pass);
        for kind in [Kind::MaskAll, Kind::MaskVisible] {
            self.draw_triangles(device, &mut pass, frame, kind, &self.uploaded.triangles.outlined);
            self.bind_instances(&mut pass);
            pass.set_pipeline(self.pipelines.get(device, kind));
            for (mesh, instances) in geometry().ranges.iter().zip(&self.uploaded.outlined) {
                self.draw_mesh(&mut pass, mesh, instances);
            }
        }
        drop(pass);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("outline"),
            color_attachments: &[colour_attachment(view, wgpu::LoadOp::Load)],
            ..Default::default()
        });
        set_viewport(&mut pass, viewport);
        pass.set_scissor_rect(viewport.x + x, viewport.y + y, width, height);
        pass.set_pipeline(self.pipelines.get(device, Kind::Outline));
        pass.set_bind_group(0, &self.globals, &[]);
        pass.set_bind_group(1, &mask.bind_group, &[]);
        pass.draw(0..3, 0..1);
    }
}
