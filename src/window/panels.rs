//! Draws the panels on the GPU. Panels beside the scene are kept in a texture, which is redrawn only where it changed; each picture
//! copies it. Shapes over the scene are drawn for each picture.

use egui::epaint::ClippedShape;
use egui::{ClippedPrimitive, Color32, Context, Pos2, Rect, Shape, TextureId, pos2};
use egui_wgpu::{RendererOptions, ScreenDescriptor};
use web_time::Instant;

use super::damage::{self, Areas};
use super::now;
use crate::render::Gpu;

/// Draws the panels, and keeps them in a texture.
pub struct PanelPainter {
    renderer: egui_wgpu::Renderer,
    format: wgpu::TextureFormat,
    canvas: Option<Canvas>,
    /// What is on the canvas, and what lies over the scene.
    shown: Vec<ClippedShape>,
    over: Vec<ClippedPrimitive>,
    /// Whether the GPU's buffers hold what lies over the scene.
    is_over_uploaded: bool,
}

/// The texture with the panels as they were drawn last.
struct Canvas {
    texture: wgpu::Texture,
    view: wgpu::TextureView,
    layout: WindowLayout,
    /// Nothing was filled yet.
    is_fresh: bool,
}

/// How the window is divided into scene and panels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WindowLayout {
    /// The window's width and height, in pixels.
    pub size_px: [u32; 2],
    /// Where the scene is, in whole pixels.
    pub scene_px: Rect,
    /// Pixels a point.
    pub pixels_per_point: f32,
    /// Whether what is beside the scene can be copied; otherwise all of it is drawn each time.
    pub can_copy: bool,
}

impl WindowLayout {
    fn window(&self) -> Rect {
        let [width, height] = self.size_px.map(pixels);
        Rect::from_min_max(Pos2::ZERO, pos2(width, height))
    }

    /// The area that is drawn for each picture.
    fn over(&self) -> Rect {
        if self.can_copy { self.scene_px.intersect(self.window()) } else { self.window() }
    }

    /// The areas around it: above, below, left and right. Some may be empty.
    fn beside(&self) -> [Rect; 4] {
        let (window, over) = (self.window(), self.over());
        [
            Rect::from_min_max(window.min, pos2(window.max.x, over.min.y)),
            Rect::from_min_max(pos2(window.min.x, over.max.y), window.max),
            Rect::from_min_max(pos2(window.min.x, over.min.y), pos2(over.min.x, over.max.y)),
            Rect::from_min_max(pos2(over.max.x, over.min.y), pos2(window.max.x, over.max.y)),
        ]
    }

    fn screen(&self) -> ScreenDescriptor {
        ScreenDescriptor { size_in_pixels: self.size_px, pixels_per_point: self.pixels_per_point }
    }
}

impl PanelPainter {
    /// For targets of a format.
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat) -> Self {
        let options = RendererOptions { dithering: false, ..RendererOptions::default() };
        Self {
            renderer: egui_wgpu::Renderer::new(&gpu.device, format, options),
            format,
            canvas: None,
            shown: Vec::new(),
            over: Vec::new(),
            is_over_uploaded: false,
        }
    }

    /// Has panels show a texture in sRGB's own numbers, in place of one that they showed before.
    pub fn show_texture(&mut self, gpu: &Gpu, view: &wgpu::TextureView, before: Option<TextureId>) -> TextureId {
        let filter = wgpu::FilterMode::Linear;
        let Some(id) = before else { return self.renderer.register_native_texture(&gpu.device, view, filter) };
        self.renderer.update_egui_texture_from_wgpu_texture(&gpu.device, view, filter, id);
        id
    }

    /// Takes in what panels consist of now, and fills what of it changed. Says when cutting it into triangles was done.
    pub fn update(
        &mut self,
        gpu: &Gpu,
        context: &Context,
        shapes: Vec<ClippedShape>,
        textures: &mut egui::TexturesDelta,
        layout: WindowLayout,
    ) -> Instant {
        let has_textures = !textures.set.is_empty();
        for (id, deltas) in textures.set.drain() {
            for delta in deltas {
                self.renderer.update_texture(&gpu.device, &gpu.queue, id, &delta);
            }
        }
        let kept = self.canvas.take().filter(|canvas| canvas.layout == layout);
        let areas = if kept.is_none() || has_textures {
            Areas::whole(layout.window())
        } else {
            damage::between(&self.shown, &shapes, layout.pixels_per_point)
        };
        self.shown = shapes;
        let canvas = kept.unwrap_or_else(|| Canvas::new(gpu, self.format, layout));
        if areas.touch(layout.over()) {
            self.over = self.cut(context, &layout, [layout.over()], false);
            self.is_over_uploaded = false;
        }
        let beside = areas.iter().flat_map(|area| layout.beside().map(|part| part.intersect(area)));
        let filled = self.cut(context, &layout, beside, true);
        let cut = now();
        self.fill(gpu, canvas, &filled);
        cut
    }

    /// Shapes in areas, as triangles; on a ground that hides what was there before, where that is wanted.
    fn cut(
        &self,
        context: &Context,
        layout: &WindowLayout,
        areas: impl IntoIterator<Item = Rect>,
        has_ground: bool,
    ) -> Vec<ClippedPrimitive> {
        let mut wanted = Vec::new();
        for area in areas.into_iter().filter(Rect::is_positive) {
            let clip_rect = area / layout.pixels_per_point;
            if has_ground {
                let shape = Shape::rect_filled(clip_rect.expand(8.0), 0.0, Color32::BLACK);
                wanted.push(ClippedShape::new(clip_rect, shape));
            }
            for shape in &self.shown {
                if damage::extent(shape, layout.pixels_per_point).intersect(area).is_positive() {
                    let clip_rect = shape.clip_rect.intersect(clip_rect);
                    wanted.push(ClippedShape { clip_rect, ..shape.clone() });
                }
            }
        }
        if wanted.is_empty() { Vec::new() } else { context.tessellate(wanted, layout.pixels_per_point) }
    }

    fn fill(&mut self, gpu: &Gpu, mut canvas: Canvas, jobs: &[ClippedPrimitive]) {
        if !jobs.is_empty() {
            let screen = canvas.layout.screen();
            let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            let mut buffers = self.renderer.update_buffers(&gpu.device, &gpu.queue, &mut encoder, jobs, &screen);
            self.is_over_uploaded = false;
            let load = if canvas.is_fresh { wgpu::LoadOp::Clear(wgpu::Color::BLACK) } else { wgpu::LoadOp::Load };
            canvas.is_fresh = false;
            let pass = begin_pass(&mut encoder, &canvas.view, load);
            self.renderer.render(&mut pass.forget_lifetime(), jobs, &screen);
            buffers.push(encoder.finish());
            gpu.queue.submit(buffers);
        }
        self.canvas = Some(canvas);
    }

    /// Puts the panels on a target around the scene that is there, and over it. `view` is one of the target in the panels' format.
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        target: &wgpu::Texture,
        view: &wgpu::TextureView,
    ) -> Vec<wgpu::CommandBuffer> {
        let Some(canvas) = &self.canvas else { return Vec::new() };
        let layout = canvas.layout;
        for part in layout.beside().into_iter().filter(Rect::is_positive) {
            canvas.copy(encoder, target, part);
        }
        if self.over.is_empty() {
            return Vec::new();
        }
        let screen = layout.screen();
        let mut buffers = Vec::new();
        if !self.is_over_uploaded {
            buffers = self.renderer.update_buffers(&gpu.device, &gpu.queue, encoder, &self.over, &screen);
            self.is_over_uploaded = true;
        }
        let pass = begin_pass(encoder, view, wgpu::LoadOp::Load);
        self.renderer.render(&mut pass.forget_lifetime(), &self.over, &screen);
        buffers
    }

    /// Forgets textures that panels no longer use, once what used them is submitted.
    pub fn free(&mut self, textures: &mut egui::TexturesDelta) {
        for id in textures.free.drain() {
            self.renderer.free_texture(&id);
        }
    }
}

impl Canvas {
    fn new(gpu: &Gpu, format: wgpu::TextureFormat, layout: WindowLayout) -> Self {
        let texture = gpu.picture_texture("panels", format, layout.size_px, wgpu::TextureUsages::empty(), &[]);
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Self { texture, view, layout, is_fresh: true }
    }

    fn copy(&self, encoder: &mut wgpu::CommandEncoder, target: &wgpu::Texture, part: Rect) {
        let [x, y] = whole(part.min);
        let [right, bottom] = whole(part.max);
        let origin = wgpu::Origin3d { x, y, z: 0 };
        let side =
            |texture| wgpu::TexelCopyTextureInfo { texture, mip_level: 0, origin, aspect: wgpu::TextureAspect::All };
        let size = wgpu::Extent3d { width: right - x, height: bottom - y, depth_or_array_layers: 1 };
        encoder.copy_texture_to_texture(side(&self.texture), side(target), size);
    }
}

fn begin_pass<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    view: &wgpu::TextureView,
    load: wgpu::LoadOp<wgpu::Color>,
) -> wgpu::RenderPass<'a> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("panels"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load, store: wgpu::StoreOp::Store },
        })],
        ..Default::default()
    })
}

#[expect(clippy::cast_precision_loss, reason = "windows are small")]
const fn pixels(side: u32) -> f32 {
    side as f32
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "they are whole and not negative")]
const fn whole(at: Pos2) -> [u32; 2] {
    [at.x as u32, at.y as u32]
}

#[cfg(test)]
mod tests;
