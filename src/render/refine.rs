//! Refined pictures: the mean of many sub-frames in linear light, before the tone curve.

use std::collections::VecDeque;

use crate::frame::Frame;
use crate::render::gpu::Gpu;
use crate::render::renderer::{Background, Part, Renderer, Target, Viewport, colour_attachment, set_viewport};
use crate::render::shaders::{self, Corner, Source, Variant};
use crate::render::sub_frames::{Refinement, SubFrame};
use crate::render::targets::texture_view;

/// Format of the sum.
pub(super) const SUM_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;

/// Adds sub-frames, one at a time, and shows their mean.
#[derive(Debug)]
pub struct Refiner {
    refinement: Refinement,
    /// Draws sub-frames.
    scene: Renderer,
    /// Draws lines, ghosts and outlines over their mean.
    overlay: Renderer,
    sums: Option<Sums>,
    layout: wgpu::BindGroupLayout,
    mean_pipeline: wgpu::RenderPipeline,
    count: u32,
    /// The last sub-frames that were submitted, the oldest first.
    under_way: VecDeque<wgpu::SubmissionIndex>,
}

/// Sub-frames that may be under way: their uploads are in memory.
const MOST_UNDER_WAY: usize = 3;

/// The textures of one size. The sum is kept in two in turn: what is read is not what is written.
#[derive(Debug)]
struct Sums {
    size_px: [u32; 2],
    /// Each with the binding that reads it.
    sums: [(wgpu::TextureView, wgpu::BindGroup); 2],
}

impl Refiner {
    /// A refiner of pictures for targets of a format.
    #[must_use]
    pub fn new(gpu: &Gpu, target_format: wgpu::TextureFormat, refinement: Refinement) -> Self {
        let device = &gpu.device;
        let scene = Renderer::of_part(gpu, SUM_FORMAT, 1, Part::SubFrame);
        let sum = wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
            ty: wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: false },
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            },
            count: None,
        };
        let layout =
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("sum"), entries: &[sum] });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("sums"),
            bind_group_layouts: &[Some(scene.globals_layout()), Some(&layout)],
            immediate_size: 0,
        });
        let variant = Variant {
            encodes_srgb: !target_format.is_srgb(),
            is_software: gpu.is_software,
            is_multisampled: false,
            is_sub_frame: false,
            corner: Corner::Unit,
        };
        let module = shaders::module(device, Source::Refine, variant);
        let mean_pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("mean"),
            layout: Some(&pipeline_layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("whole_vertex"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("mean_fragment"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(target_format.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        Self {
            refinement,
            overlay: Renderer::of_part(gpu, target_format, 1, Part::Overlay),
            sums: None,
            mean_pipeline,
            scene,
            layout,
            count: 0,
            under_way: VecDeque::new(),
        }
    }

    /// How pictures are refined.
    #[must_use]
    pub const fn refinement(&self) -> &Refinement {
        &self.refinement
    }

    /// Sets the background of the next pictures.
    pub fn set_background(&mut self, background: Background) {
        self.scene.set_background(background);
    }

    /// Leaves the edges of ghosts as they are: for who draws them several times, each time moved, and takes the mean.
    pub const fn leave_edges_of_ghosts(&mut self) {
        self.overlay.leave_edges();
    }

    /// Begins another picture.
    pub const fn restart(&mut self) {
        self.count = 0;
    }

    /// The number of sub-frames that were added.
    #[must_use]
    pub const fn count(&self) -> u32 {
        self.count
    }

    /// The sub-frame that is added next; `None` if the picture has all of them.
    #[must_use]
    pub fn next(&self) -> Option<SubFrame> {
        (self.count < self.refinement.sub_frames).then(|| self.refinement.sub_frame(self.count))
    }

    /// Draws the next sub-frame of a picture of this size in pixels, adds it to the others, and submits the work. `frame` is the scene at
    /// the moment of the sub-frame's [`SubFrame::shutter`]; its ghosts, lines and dots are ignored. A size that differs from the last
    /// begins another picture. Nothing happens when the picture has all its sub-frames.
    pub fn add(&mut self, gpu: &Gpu, frame: &mut Frame, size_px: [u32; 2]) {
        if self.sums.as_ref().is_none_or(|sums| sums.size_px != size_px) {
            self.sums = Some(Sums::new(gpu, &self.layout, size_px));
            self.count = 0;
        }
        let (Some(sub_frame), Some(sums)) = (self.next(), &self.sums) else { return };
        let (steady, steadily_lit) = (frame.view, frame.lighting);
        frame.view = sub_frame.view(&steady, frame.lens, size_px);
        frame.lighting.sun_degrees = self.refinement.sun_degrees.unwrap_or(frame.lighting.sun_degrees);
        let [before, after] = [self.count, self.count + 1].map(|count| &sums.of(count).0);
        self.scene.begin_sub_frame(gpu, sub_frame.light(&frame.lighting), before);
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        if self.count == 0 {
            drop(begin(&mut encoder, before, wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT)));
        }
        let viewport = Viewport::whole(size_px[0], size_px[1]);
        self.scene.encode(gpu, &mut encoder, frame, Target { view: after, viewport });
        (frame.view, frame.lighting) = (steady, steadily_lit);
        self.under_way.push_back(gpu.queue.submit([encoder.finish()]));
        if self.under_way.len() > MOST_UNDER_WAY {
            let submission_index = self.under_way.pop_front();
            // A lost device is reported when the picture is read.
            let _ = gpu.device.poll(wgpu::PollType::Wait { submission_index, timeout: None });
        }
        self.count += 1;
    }

    /// Appends what shows the mean of the sub-frames so far, and over it what is no part of the scene: ghosts, lines, dots, the outline. The
    /// target's viewport has the size of the sub-frames. Without any sub-frame nothing is drawn.
    pub fn show(&mut self, gpu: &Gpu, encoder: &mut wgpu::CommandEncoder, frame: &Frame, target: Target<'_>) {
        let Some(sums) = self.sums.as_ref().filter(|_| self.count > 0) else { return };
        let Some(viewport) = target.viewport.inside() else { return };
        let target = Target { viewport, ..target };
        let mut showing = begin(encoder, target.view, wgpu::LoadOp::Clear(self.overlay.clear_colour()));
        set_viewport(&mut showing, target.viewport);
        showing.set_pipeline(&self.mean_pipeline);
        showing.set_bind_group(0, self.scene.globals(), &[]);
        showing.set_bind_group(1, &sums.of(self.count).1, &[]);
        showing.draw(0..3, 0..1);
        drop(showing);
        if frame.has_overlay() {
            self.overlay.encode(gpu, encoder, frame, target);
        }
    }
}

impl Sums {
    fn new(gpu: &Gpu, layout: &wgpu::BindGroupLayout, size_px: [u32; 2]) -> Self {
        let device = &gpu.device;
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
        let sums = [(); 2].map(|()| {
            let sum = texture_view(device, "sum", SUM_FORMAT, 1, size_px, usage);
            let resource = wgpu::BindingResource::TextureView(&sum);
            let binding = device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("sum"),
                layout,
                entries: &[wgpu::BindGroupEntry { binding: 0, resource }],
            });
            (sum, binding)
        });
        Self { size_px, sums }
    }

    /// The sum of the first `count` sub-frames.
    const fn of(&self, count: u32) -> &(wgpu::TextureView, wgpu::BindGroup) {
        let [even, odd] = &self.sums;
        if count.is_multiple_of(2) { even } else { odd }
    }
}

/// Begins a pass on one target, without depth.
fn begin<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    view: &wgpu::TextureView,
    load: wgpu::LoadOp<wgpu::Color>,
) -> wgpu::RenderPass<'a> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("sums"),
        color_attachments: &[colour_attachment(view, load)],
        ..Default::default()
    })
}
