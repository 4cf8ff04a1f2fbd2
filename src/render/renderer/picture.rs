//! The passes of a picture: the sun's map, the scene, and what is drawn over it.

use std::ops::Range;
use std::thread;

use super::{Background, Part, Renderer, Target, colour_attachment, depth_attachment, set_viewport};
use crate::colour::srgb_from_linear;
use crate::frame::Frame;
use crate::render::gpu::Gpu;
use crate::render::instances::Packed;
use crate::render::look;
use crate::render::mesh::{PLANE, geometry};
use crate::render::pipelines::Kind;
use crate::render::targets::{SunMap, Targets};

impl Renderer {
    /// Submits the sun map at once, so that the driver compiles the code shared by all pipelines while those of the picture are created.
    /// A software driver then compiles each pipeline while the next one is created.
    pub(super) fn draw_first_sun_map(&self, gpu: &Gpu, frame: &Frame) {
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.draw_sun_map(&gpu.device, &mut encoder, frame);
        let commands = encoder.finish();
        thread::scope(|scope| {
            // Create the pipelines on a new thread. The driver's thread wakes at submit and may take this core. If the thread cannot be
            // started, pipelines are created on first use.
            let make = || {
                let compiles_early = gpu.is_software && self.samples == 1;
                let pixel = compiles_early.then(|| Targets::one_pixel(&gpu.device, self.format));
                let edges = (!self.uploaded.edges.is_empty()).then_some(Kind::Edge);
                for kind in self.kinds_behind_lines().chain(edges) {
                    self.pipelines.get(&gpu.device, kind);
                    if let Some(pixel) = &pixel {
                        self.draw_first(gpu, kind, pixel);
                    }
                }
            };
            let _ = thread::Builder::new().name("pipelines".to_owned()).spawn_scoped(scope, make);
            gpu.queue.submit([commands]);
        });
    }

    /// Draws something by a pipeline into a pixel that nobody sees: a software driver compiles its shaders then.
    fn draw_first(&self, gpu: &Gpu, kind: Kind, [colour, depth]: &[wgpu::TextureView; 2]) {
        let Some(sun_map) = self.sun_maps.in_use() else { return };
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("first"),
            color_attachments: &[colour_attachment(colour, wgpu::LoadOp::Clear(wgpu::Color::BLACK))],
            depth_stencil_attachment: Some(depth_attachment(depth, wgpu::LoadOp::Clear(0.0), wgpu::StoreOp::Discard)),
            ..Default::default()
        });
        self.bind_instances(&mut pass);
        pass.set_bind_group(1, &sun_map.bind_group, &[]);
        let first = |instances: &Range<u32>| instances.start..instances.end.min(instances.start + 1);
        if kind == Kind::Edge {
            let Packed { edges, edges_start, .. } = &self.uploaded;
            self.draw_quads(&gpu.device, &mut pass, kind, &first(edges), *edges_start);
        } else {
            pass.set_pipeline(self.pipelines.get(&gpu.device, kind));
            pass.draw_indexed(0..3, 0, 0..1);
        }
        drop(pass);
        gpu.queue.submit([encoder.finish()]);
    }

    /// The pipelines that are needed before lines are drawn, in drawing order: occluders first.
    fn kinds_behind_lines(&self) -> impl Iterator<Item = Kind> {
        let is_any = |meshes: &[Range<u32>]| meshes.iter().any(|instances| !instances.is_empty());
        let (shapes, plane) = self.uploaded.seen.split_at(PLANE);
        let needed = match self.part {
            Part::Overlay => [(Kind::Depth, true), (Kind::Depth, false), (Kind::Depth, false)],
            Part::Whole | Part::SubFrame => {
                let (sky, is_needed) = match (self.background, self.part) {
                    (Background::Sky, _) => (Kind::Sky, true),
                    (_, part) => (Kind::Backdrop, part == Part::SubFrame),
                };
                [(Kind::Shape, is_any(shapes)), (Kind::Plane, is_any(plane)), (sky, is_needed)]
            }
        };
        needed.into_iter().filter_map(|(kind, is_needed)| is_needed.then_some(kind))
    }

    pub(super) fn draw_sun_map(&self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, frame: &Frame) {
        let Some(SunMap { size_texels: [width, height], kind, view, .. }) = self.sun_maps.in_use() else { return };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("sun map"),
            depth_stencil_attachment: Some(depth_attachment(view, wgpu::LoadOp::Clear(1.0), wgpu::StoreOp::Store)),
            ..Default::default()
        });
        // The border keeps the farthest depth, so that lookups outside the map are lit.
        pass.set_scissor_rect(1, 1, width - 2, height - 2);
        pass.set_pipeline(self.pipelines.get(device, *kind));
        self.bind_instances(&mut pass);
        for (mesh, instances) in geometry().ranges.iter().zip(&self.uploaded.casters) {
            self.draw_mesh(&mut pass, mesh, instances);
        }
        self.draw_triangles(device, &mut pass, frame, *kind, &self.uploaded.triangles.casters);
    }

    /// Draws the picture into its target, by one pass.
    pub(super) fn draw_picture(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        frame: &Frame,
        target: Target<'_>,
    ) {
        let Some(targets) = &self.targets else { return };
        let has_outline = frame.items.iter().any(|item| item.outlined);
        let keep_depth = if has_outline { wgpu::StoreOp::Store } else { wgpu::StoreOp::Discard };
        let load = match self.part {
            Part::Overlay => wgpu::LoadOp::Load,
            Part::Whole | Part::SubFrame => wgpu::LoadOp::Clear(self.clear_colour()),
        };
        let attachment = match &targets.samples {
            Some(view) => Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target: Some(target.view),
                ops: wgpu::Operations { load, store: wgpu::StoreOp::Discard },
            }),
            None => colour_attachment(target.view, load),
        };
        let depth = depth_attachment(&targets.depth, wgpu::LoadOp::Clear(0.0), keep_depth);
        let mut pass = begin("picture", encoder, attachment, depth, target);
        self.draw_scene(device, &mut pass, frame);
        if self.part != Part::SubFrame {
            self.draw_overlay(device, &mut pass, frame);
        }
    }

    /// Draws shapes, planes and the sky; in an overlay their depth alone.
    fn draw_scene(&self, device: &wgpu::Device, pass: &mut wgpu::RenderPass<'_>, frame: &Frame) {
        let Some(sun_map) = self.sun_maps.in_use() else { return };
        self.bind_instances(pass);
        pass.set_bind_group(1, &sun_map.bind_group, &[]);
        let of_triangles = if self.part == Part::Overlay { Kind::Depth } else { Kind::Shape };
        self.draw_triangles(device, pass, frame, of_triangles, &self.uploaded.triangles.seen);
        self.bind_instances(pass);
        let (meshes, items) = (&geometry().ranges, &self.uploaded.seen);
        for kind in self.kinds_behind_lines() {
            pass.set_pipeline(self.pipelines.get(device, kind));
            match kind {
                Kind::Sky | Kind::Backdrop => pass.draw(0..3, 0..1),
                Kind::Plane => self.draw_mesh(pass, &meshes[PLANE], &items[PLANE]),
                Kind::Depth => meshes.iter().zip(items).for_each(|(mesh, of_mesh)| self.draw_mesh(pass, mesh, of_mesh)),
                _ => meshes[..PLANE].iter().zip(items).for_each(|(mesh, of_mesh)| self.draw_mesh(pass, mesh, of_mesh)),
            }
        }
        let Packed { edges, edges_start, .. } = &self.uploaded;
        self.draw_quads(device, pass, Kind::Edge, edges, *edges_start);
    }

    /// Draws what is no part of the scene: lines, ghosts, the arcball, dots.
    fn draw_overlay(&self, device: &wgpu::Device, pass: &mut wgpu::RenderPass<'_>, frame: &Frame) {
        let strokes_start = self.uploaded.strokes_start;
        // Lines come before ghosts, whose depth would hide them.
        for kind in [Kind::LineHidden, Kind::Line] {
            self.draw_quads(device, pass, kind, &self.uploaded.lines, strokes_start);
        }
        if !frame.ghosts.is_empty() {
            for kind in [Kind::GhostDepth, Kind::Ghost] {
                self.draw_triangles(device, pass, frame, kind, &self.uploaded.triangles.ghosts);
                self.bind_instances(pass);
                pass.set_pipeline(self.pipelines.get(device, kind));
                for (mesh, instances) in geometry().ranges.iter().zip(&self.uploaded.ghosts) {
                    self.draw_mesh(pass, mesh, instances);
                }
            }
            let Packed { ghost_edges, edges_start, .. } = &self.uploaded;
            self.draw_quads(device, pass, Kind::GhostEdge, ghost_edges, *edges_start);
        }
        self.draw_quads(device, pass, Kind::LineOnTop, &self.uploaded.arcball, strokes_start);
        self.draw_quads(device, pass, Kind::Dot, &self.uploaded.dots, strokes_start);
    }

    /// Draws what has four corners an instance, and lies in the buffer from `start` bytes on.
    fn draw_quads(
        &self,
        device: &wgpu::Device,
        pass: &mut wgpu::RenderPass<'_>,
        kind: Kind,
        instances: &Range<u32>,
        start: usize,
    ) {
        if !instances.is_empty() {
            pass.set_pipeline(self.pipelines.get(device, kind));
            pass.set_vertex_buffer(0, self.frame_buffer.slice(start as u64..));
            pass.draw(0..4, instances.clone());
        }
    }

    pub(in crate::render) fn clear_colour(&self) -> wgpu::Color {
        let colour = match self.background {
            Background::Sky => look::PALETTE.surround,
            Background::Colour(colour) => colour,
            Background::Transparent => return wgpu::Color::TRANSPARENT,
        };
        let encode = |channel: f32| f64::from(if self.format.is_srgb() { channel } else { srgb_from_linear(channel) });
        wgpu::Color { r: encode(colour.x), g: encode(colour.y), b: encode(colour.z), a: 1.0 }
    }
}

/// A pass that fills a viewport.
fn begin<'a>(
    label: &str,
    encoder: &'a mut wgpu::CommandEncoder,
    colour: Option<wgpu::RenderPassColorAttachment<'_>>,
    depth: wgpu::RenderPassDepthStencilAttachment<'_>,
    target: Target<'_>,
) -> wgpu::RenderPass<'a> {
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments: &[colour],
        depth_stencil_attachment: Some(depth),
        ..Default::default()
    });
    set_viewport(&mut pass, target.viewport);
    pass
}
