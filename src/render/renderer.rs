//! The renderer: draws a frame into any texture view.

mod meshes;
mod outline;
mod picture;

use std::mem;
use std::ops::Range;

use bytemuck::cast_slice;
use glam::{Vec3, Vec4};

use crate::frame::Frame;
use crate::render::arrange::{Arranged, Arrangement};
use crate::render::bounds::{Bounds, rectangle_px};
use crate::render::detail::Detail;
use crate::render::gpu::Gpu;
use crate::render::instances::{INSTANCES_START, Packed};
use crate::render::light::{Light, SunBox, most_texels};
use crate::render::look;
use crate::render::mesh::{MeshRange, Vertex, geometry};
use crate::render::pipelines::Pipelines;
use crate::render::refine::SUM_FORMAT;
use crate::render::shaders::{Corner, Variant};
use crate::render::targets::{SunMaps, Targets, texture_view};
use crate::render::triangles::{JointRows, MeshCache, Skinning, Skins};
use crate::render::uniforms::Globals;

/// The default number of samples per pixel: 4 on a GPU, 1 if the CPU draws, because each sample costs as much as a picture.
#[must_use]
pub fn default_samples(is_software: bool) -> u32 {
    if is_software { 1 } else { 4 }
}

/// The background of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Background {
    /// The sky's gradient.
    #[default]
    Sky,
    /// One linear-light colour, 0 to 1.
    Colour(Vec3),
    /// Transparent: opacity 0.
    Transparent,
}

/// The part of a target that a picture fills, in pixels from the target's top left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Viewport {
    /// The whole target's width and height.
    pub target_px: [u32; 2],
    /// The x coordinate of the left border.
    pub x: u32,
    /// The y coordinate of the upper border.
    pub y: u32,
    /// The picture's width.
    pub width: u32,
    /// The picture's height.
    pub height: u32,
}

/// The target of a picture.
#[derive(Clone, Copy, Debug)]
pub struct Target<'a> {
    /// A view of `viewport.target_px` pixels in the renderer's format; all of it is cleared.
    pub view: &'a wgpu::TextureView,
    /// The part that the picture fills.
    pub viewport: Viewport,
}

impl Viewport {
    /// The whole of a target.
    #[must_use]
    pub fn whole(width: u32, height: u32) -> Self {
        Self { target_px: [width, height], x: 0, y: 0, width, height }
    }

    /// The part of this viewport that is inside its target; `None` if it is outside.
    pub(super) fn inside(self) -> Option<Self> {
        let width = self.width.min(self.target_px[0].saturating_sub(self.x));
        let height = self.height.min(self.target_px[1].saturating_sub(self.y));
        (width > 0 && height > 0).then_some(Self { width, height, ..self })
    }
}

/// What of a frame a renderer draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// All of it.
    Whole,
    /// Its scene, as light before the tone curve.
    SubFrame,
    /// What is no part of the scene: ghosts, lines, dots, the outline. The target keeps what it shows.
    Overlay,
}

/// Draws frames into views of one format. It keeps its buffers, textures and pipelines from frame to frame.
///
/// ```no_run
/// use inbetween::frame::Frame;
/// use inbetween::render::{Gpu, GpuError, Image, Offscreen, Renderer, default_samples};
///
/// fn picture(frame: &Frame) -> Result<Image, GpuError> {
///     let gpu = Gpu::headless()?;
///     let mut renderer = Renderer::new(&gpu, Offscreen::FORMAT, default_samples(gpu.is_software));
///     Offscreen::new(&gpu, 640, 480)?.render(&gpu, &mut renderer, frame)
/// }
/// ```
#[derive(Debug)]
pub struct Renderer {
    format: wgpu::TextureFormat,
    samples: u32,
    part: Part,
    /// Whether lines smooth the edges of shapes and ghosts.
    smooths_edges: bool,
    /// The light of the shadow map, for a sub-frame.
    light: Option<Light>,
    background: Background,
    pipelines: Pipelines,
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    frame_buffer: wgpu::Buffer,
    globals: wgpu::BindGroup,
    /// The sum of the sub-frames before, for a sub-frame.
    sum_before: Option<wgpu::TextureView>,
    /// The sun maps: shadow maps of several sizes.
    sun_maps: SunMaps,
    targets: Option<Targets>,
    arrangement: Arrangement,
    arranged: Arranged,
    packed: Packed,
    /// The content of the GPU's buffer.
    uploaded: Packed,
    meshes: MeshCache,
    skins: Skins,
    /// The vertices of [`Self::skins`].
    skinned: Option<wgpu::Buffer>,
    joints: Option<JointRows>,
    /// The box that the sun map was drawn for.
    sun_map_box: Option<SunBox>,
    sun_map_draws: u64,
    /// True until the sun map is first drawn, for software drivers only. They compile a pipeline on a driver thread at its first draw.
    is_cold: bool,
}

impl Renderer {
    /// A renderer for targets of a format, with 1 or 4 samples a pixel ([`default_samples`]).
    #[must_use]
    pub fn new(gpu: &Gpu, target_format: wgpu::TextureFormat, samples: u32) -> Self {
        Self::of_part(gpu, target_format, samples, Part::Whole)
    }

    /// A renderer of a part of frames.
    pub(super) fn of_part(gpu: &Gpu, target_format: wgpu::TextureFormat, samples: u32, part: Part) -> Self {
        let device = &gpu.device;
        let samples = if samples > 1 { 4 } else { 1 };
        let variant = Variant {
            encodes_srgb: !target_format.is_srgb(),
            is_software: gpu.is_software,
            is_multisampled: samples > 1,
            is_sub_frame: part == Part::SubFrame,
            corner: Corner::Unit,
        };
        let pipelines = Pipelines::new(device, target_format, samples, variant);
        // A sub-frame has its own.
        let sum_before = (part == Part::SubFrame)
            .then(|| texture_view(device, "no sum", SUM_FORMAT, 1, [1, 1], wgpu::TextureUsages::TEXTURE_BINDING));
        let (frame_buffer, globals) = frame_buffer(device, &pipelines, 16 * 1024, sum_before.as_ref());
        let geometry = geometry();
        let vertices = filled_buffer(device, cast_slice(&geometry.vertices), wgpu::BufferUsages::VERTEX);
        let indices = filled_buffer(device, cast_slice(&geometry.indices), wgpu::BufferUsages::INDEX);
        Self {
            format: target_format,
            samples,
            part,
            smooths_edges: samples == 1 && part != Part::SubFrame,
            light: None,
            background: Background::Sky,
            pipelines,
            vertices,
            indices,
            frame_buffer,
            globals,
            sum_before,
            sun_maps: SunMaps::default(),
            targets: None,
            arrangement: Arrangement::default(),
            arranged: Arranged::default(),
            packed: Packed::default(),
            uploaded: Packed::default(),
            meshes: MeshCache::default(),
            skins: Skins::new(Skinning::of_adapter(gpu.is_software)),
            skinned: None,
            joints: None,
            sun_map_box: None,
            sun_map_draws: 0,
            is_cold: gpu.is_software,
        }
    }

    /// The format of the views that this renderer draws into.
    #[must_use]
    pub fn target_format(&self) -> wgpu::TextureFormat {
        self.format
    }

    /// Leaves the edges of the next frames as they are.
    pub(super) const fn leave_edges(&mut self) {
        self.smooths_edges = false;
    }

    /// Sets the background of the next frames.
    pub fn set_background(&mut self, background: Background) {
        self.background = background;
    }

    /// Sets the light of the shadow map of the next sub-frame, and the sum that it adds to.
    pub(super) fn begin_sub_frame(&mut self, gpu: &Gpu, light: Light, sum_before: &wgpu::TextureView) {
        self.light = Some(Light { backdrop: self.backdrop(), ..light });
        self.globals = globals(&gpu.device, &self.pipelines, &self.frame_buffer, Some(sum_before));
        self.sum_before = Some(sum_before.clone());
    }

    /// The light behind everything, and its opacity.
    fn backdrop(&self) -> Vec4 {
        match self.background {
            Background::Sky | Background::Transparent => Vec4::ZERO,
            Background::Colour(colour) => colour.map(look::untoned).extend(1.0),
        }
    }

    /// The layout of the globals' binding.
    pub(super) const fn globals_layout(&self) -> &wgpu::BindGroupLayout {
        &self.pipelines.globals_layout
    }

    /// The binding of the globals of the frame that was encoded last.
    pub(super) const fn globals(&self) -> &wgpu::BindGroup {
        &self.globals
    }

    /// Sets how items of the next frames are arranged.
    pub fn set_arrangement(&mut self, arrangement: Arrangement) {
        self.arrangement = arrangement;
    }

    /// Sets who moves the vertices of skins of the next frames; at first [`Skinning::of_adapter`]. Pictures differ by rounding only.
    pub fn set_skinning(&mut self, skinning: Skinning) {
        self.skins = Skins::new(skinning);
        self.meshes = MeshCache::default();
    }

    /// Counts how often the sun map was drawn: only when shapes or its box moved.
    #[must_use]
    pub fn sun_map_draws(&self) -> u64 {
        self.sun_map_draws
    }

    /// Draws a frame and submits the work.
    pub fn render(&mut self, gpu: &Gpu, frame: &Frame, target: Target<'_>) {
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.encode(gpu, &mut encoder, frame, target);
        gpu.queue.submit([encoder.finish()]);
    }

    /// Like [`Renderer::render`], but appends to an encoder. The caller must submit it before encoding another frame.
    pub fn encode(&mut self, gpu: &Gpu, encoder: &mut wgpu::CommandEncoder, frame: &Frame, target: Target<'_>) {
        let Some(viewport) = target.viewport.inside() else { return };
        let target = Target { viewport, ..target };
        if self.targets.as_ref().is_none_or(|targets| targets.size_px != viewport.target_px) {
            self.targets = Some(Targets::new(&gpu.device, self.format, self.samples, viewport.target_px));
        }
        let detail = match self.arrangement {
            Arrangement::AsGiven => Detail::FINEST,
            _ => Detail::of_picture(&frame.view, viewport.height, self.samples_across()),
        };
        let items_moved = self.arranged.take(frame, detail, self.arrangement);
        self.pipelines.light(&frame.lighting);
        let light = self.light.unwrap_or_else(|| Light::plain(&frame.lighting));
        let most_texels = most_texels(viewport.height, &light, gpu.is_software);
        let sun = match self.part {
            Part::Overlay => None,
            Part::Whole | Part::SubFrame => SunBox::fit(frame, &light, &self.arranged.bounds, most_texels),
        };
        let size_texels = sun.as_ref().map(|sun| sun.size_texels);
        self.sun_maps.take(&gpu.device, &self.pipelines, most_texels, size_texels);
        let globals = Globals::new(frame, &light, sun.as_ref(), viewport);
        let is_map_due = sun.is_some() && (items_moved || sun != self.sun_map_box);
        let of_sun_map = sun.as_ref().filter(|_| is_map_due).map(Detail::of_sun_map);
        self.take_meshes(gpu, frame, is_map_due);
        self.packed.pack(frame, &self.arranged, &globals, detail, of_sun_map, &self.skins);
        if self.part == Part::Whole {
            self.packed.pack_contacts(frame, &self.arranged);
        }
        if self.smooths_edges {
            self.packed.pack_edges(frame, &self.arranged, detail, self.part == Part::Whole);
        }
        self.upload(gpu);
        if is_map_due {
            self.sun_map_draws += 1;
            if mem::take(&mut self.is_cold) {
                self.draw_first_sun_map(gpu, frame);
            } else {
                self.draw_sun_map(&gpu.device, encoder, frame);
            }
        }
        // No sun box: the sun map still holds an older frame. Storing `None` forces a redraw when a box exists again.
        self.sun_map_box = sun;
        self.draw_picture(&gpu.device, encoder, frame, target);
        if self.part == Part::SubFrame {
            return;
        }
        let outlined = frame.items.iter().filter(|item| item.outlined).map(Bounds::of);
        if let Some(rectangle) =
            rectangle_px(&frame.view, outlined, [viewport.width, viewport.height], look::OUTLINE_PX + 3.0)
        {
            self.draw_outline(gpu, encoder, frame, target, rectangle);
        }
    }

    /// Samples along a pixel's side, for the choice of meshes. Sub-frames are samples too.
    fn samples_across(&self) -> f32 {
        if self.part == Part::SubFrame { 1.2 } else { (self.samples as f32).sqrt() }
    }

    /// Uploads the packed bytes that the GPU does not have yet.
    fn upload(&mut self, gpu: &Gpu) {
        let needed = self.packed.bytes.len() as u64;
        let grows = self.frame_buffer.size() < needed;
        if grows {
            let size = needed.next_power_of_two();
            (self.frame_buffer, self.globals) =
                frame_buffer(&gpu.device, &self.pipelines, size, self.sum_before.as_ref());
        }
        if grows {
            gpu.queue.write_buffer(&self.frame_buffer, 0, &self.packed.bytes);
        } else {
            for range in changed(&self.uploaded.bytes, &self.packed.bytes) {
                gpu.queue.write_buffer(&self.frame_buffer, range.start as u64, &self.packed.bytes[range]);
            }
        }
        mem::swap(&mut self.packed, &mut self.uploaded);
    }

    fn bind_instances(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_bind_group(0, &self.globals, &[]);
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_vertex_buffer(1, self.frame_buffer.slice(INSTANCES_START as u64..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
    }

    /// Draws a unit mesh after [`Self::bind_instances`]. WebGL2 has no first vertex, so the buffer begins there.
    fn draw_mesh(&self, pass: &mut wgpu::RenderPass<'_>, mesh: &MeshRange, instances: &Range<u32>) {
        if !instances.is_empty() {
            let start = mesh.first_vertex as usize * size_of::<Vertex>();
            pass.set_vertex_buffer(0, self.vertices.slice(start as u64..));
            pass.draw_indexed(mesh.indices.clone(), 0, instances.clone());
        }
    }
}

/// Ranges in which bytes differ from `before`, or lie past its end, rounded to whole blocks.
fn changed<'a>(before: &'a [u8], after: &'a [u8]) -> impl Iterator<Item = Range<usize>> + 'a {
    const PIECE: usize = 4096;
    let pieces = (0..after.len()).step_by(PIECE).map(|start| start..(start + PIECE).min(after.len()));
    let mut pieces = pieces.filter(|piece| before.get(piece.clone()) != Some(&after[piece.clone()])).peekable();
    std::iter::from_fn(move || {
        let mut range = pieces.next()?;
        while let Some(next) = pieces.next_if(|next| next.start == range.end) {
            range.end = next.end;
        }
        Some(range)
    })
}

pub(super) fn set_viewport(pass: &mut wgpu::RenderPass<'_>, viewport: Viewport) {
    let Viewport { x, y, width, height, .. } = viewport;
    pass.set_viewport(x as f32, y as f32, width as f32, height as f32, 0.0, 1.0);
    pass.set_scissor_rect(x, y, width, height);
}

#[expect(clippy::unnecessary_wraps, reason = "a pass takes it so")]
pub(super) fn colour_attachment(
    view: &wgpu::TextureView,
    load: wgpu::LoadOp<wgpu::Color>,
) -> Option<wgpu::RenderPassColorAttachment<'_>> {
    let ops = wgpu::Operations { load, store: wgpu::StoreOp::Store };
    Some(wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops })
}

fn depth_attachment(
    view: &wgpu::TextureView,
    load: wgpu::LoadOp<f32>,
    store: wgpu::StoreOp,
) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    wgpu::RenderPassDepthStencilAttachment {
        view,
        depth_ops: Some(wgpu::Operations { load, store }),
        stencil_ops: None,
    }
}

fn filled_buffer(device: &wgpu::Device, bytes: &[u8], usage: wgpu::BufferUsages) -> wgpu::Buffer {
    use wgpu::util::DeviceExt;
    device.create_buffer_init(&wgpu::util::BufferInitDescriptor { label: None, contents: bytes, usage })
}

/// The buffer that holds a whole frame, and the binding of its globals.
fn frame_buffer(
    device: &wgpu::Device,
    pipelines: &Pipelines,
    size: u64,
    sum_before: Option<&wgpu::TextureView>,
) -> (wgpu::Buffer, wgpu::BindGroup) {
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("frame"),
        size,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let globals = globals(device, pipelines, &buffer, sum_before);
    (buffer, globals)
}

/// The binding of a frame's globals, and of the sum that a sub-frame adds to.
fn globals(
    device: &wgpu::Device,
    pipelines: &Pipelines,
    buffer: &wgpu::Buffer,
    sum_before: Option<&wgpu::TextureView>,
) -> wgpu::BindGroup {
    let binding = wgpu::BufferBinding { buffer, offset: 0, size: std::num::NonZeroU64::new(INSTANCES_START as u64) };
    let buffer = wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::Buffer(binding) };
    let sum =
        sum_before.map(|view| wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(view) });
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("globals"),
        layout: &pipelines.globals_layout,
        entries: &std::iter::once(buffer).chain(sum).collect::<Vec<_>>(),
    })
}
