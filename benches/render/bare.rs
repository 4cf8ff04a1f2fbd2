//! The least that any wgpu program does for a picture: clear, draw one box, read back. What the renderer is measured against.

use std::sync::mpsc;

use bytemuck::{bytes_of, cast_slice};
use glam::camera::rh::proj::directx::perspective_infinite_reverse;
use glam::{Mat4, Vec3};
use wgpu::util::DeviceExt;

/// The picture's width in pixels.
pub const WIDTH: u32 = 640;
/// The picture's height in pixels.
pub const HEIGHT: u32 = 480;
const COLOUR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;
const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

const SHADER: &str = "
@group(0) @binding(0) var<uniform> clip_from_box: mat4x4f;

struct Pixel {
    @builtin(position) in_clip: vec4f,
    @location(0) normal: vec3f,
}

@vertex
fn corner(@location(0) place: vec3f, @location(1) normal: vec3f) -> Pixel {
    return Pixel(clip_from_box * vec4f(place, 1.0), normal);
}

@fragment
fn paint(pixel: Pixel) -> @location(0) vec4f {
    let light = 0.3 + 0.7 * max(dot(normalize(pixel.normal), vec3f(0.0, 0.6, 0.8)), 0.0);
    return vec4f(vec3f(0.8, 0.2, 0.1) * light, 1.0);
}
";

/// A device, a pipeline and the textures of one picture.
pub struct Bare {
    device: wgpu::Device,
    queue: wgpu::Queue,
    pipeline: wgpu::RenderPipeline,
    uniform: wgpu::Buffer,
    group: wgpu::BindGroup,
    corners: wgpu::Buffer,
    target: wgpu::Texture,
    target_view: wgpu::TextureView,
    depth_view: wgpu::TextureView,
    read_back: wgpu::Buffer,
}

impl Bare {
    pub fn new() -> Self {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = wgpu::Backends::VULKAN;
        descriptor.flags = wgpu::InstanceFlags::empty();
        let instance = wgpu::Instance::new(descriptor);
        let adapter =
            pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default())).expect("an adapter");
        let (device, queue) =
            pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default())).expect("a device");
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl(SHADER.into()),
        });
        let attributes = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3];
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: None,
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: None,
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[Some(wgpu::VertexBufferLayout {
                    array_stride: 24,
                    step_mode: wgpu::VertexStepMode::Vertex,
                    attributes: &attributes,
                })],
            },
            primitive: wgpu::PrimitiveState { cull_mode: Some(wgpu::Face::Back), ..Default::default() },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::GreaterEqual),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: None,
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(COLOUR.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        let uniform = device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: 64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() }],
        });
        let corners = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: None,
            contents: cast_slice(&box_corners()),
            usage: wgpu::BufferUsages::VERTEX,
        });
        let texture = |format, usage| {
            device.create_texture(&wgpu::TextureDescriptor {
                label: None,
                size: wgpu::Extent3d { width: WIDTH, height: HEIGHT, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage,
                view_formats: &[],
            })
        };
        let target = texture(COLOUR, wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC);
        let depth = texture(DEPTH, wgpu::TextureUsages::RENDER_ATTACHMENT);
        let read_back = device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: u64::from(4 * WIDTH * HEIGHT),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let target_view = target.create_view(&wgpu::TextureViewDescriptor::default());
        let depth_view = depth.create_view(&wgpu::TextureViewDescriptor::default());
        Self { device, queue, pipeline, uniform, group, corners, target, target_view, depth_view, read_back }
    }

    /// One picture, read back.
    pub fn draw(&self) -> Vec<u8> {
        let clip_from_eye = perspective_infinite_reverse(60.0_f32.to_radians(), 4.0 / 3.0, 0.05);
        let clip_from_box =
            clip_from_eye * Mat4::from_translation(Vec3::new(0.0, 0.0, -4.0)) * Mat4::from_rotation_y(0.6);
        self.queue.write_buffer(&self.uniform, 0, bytes_of(&clip_from_box));
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.target_view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::WHITE), store: wgpu::StoreOp::Store },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth_view,
                depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Discard }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.set_vertex_buffer(0, self.corners.slice(..));
        pass.draw(0..36, 0..1);
        drop(pass);
        encoder.copy_texture_to_buffer(
            self.target.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &self.read_back,
                layout: wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * WIDTH), rows_per_image: None },
            },
            self.target.size(),
        );
        self.queue.submit([encoder.finish()]);
        let (sender, receiver) = mpsc::channel();
        self.read_back.map_async(wgpu::MapMode::Read, .., move |result| sender.send(result).expect("a listener"));
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("the device");
        receiver.recv().expect("an answer").expect("a mapped buffer");
        let picture = self.read_back.get_mapped_range(..).expect("a mapped buffer").to_vec();
        self.read_back.unmap();
        picture
    }
}

/// Place and normal of each of the 36 corners of a box's triangles, anticlockwise from outside.
fn box_corners() -> Vec<[Vec3; 2]> {
    let mut corners = Vec::new();
    for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
        for normal in [axis, -axis] {
            let u = Vec3::new(normal.y, normal.z, normal.x);
            let v = normal.cross(u);
            for (a, b) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                corners.push([(normal + u * a + v * b) * 0.5, normal]);
            }
        }
    }
    corners
}
