//! Identity pictures: for each pixel the node that it shows, as an integer. One sample per pixel, with the geometry of colour pictures.

use std::mem::size_of;
use std::sync::mpsc;

use bytemuck::{cast_slice, pod_collect_to_vec};
use wgpu::util::{BufferInitDescriptor, DeviceExt};

use crate::frame::Frame;
use crate::render::arrange::{Arranged, Arrangement};
use crate::render::detail::Detail;
use crate::render::gpu::{Gpu, GpuError};
use crate::render::instances::{INSTANCES_START, Instance, Packed};
use crate::render::light::Light;
use crate::render::mesh::{Vertex, geometry};
use crate::render::pipelines::{DEPTH_FORMAT, Form};
use crate::render::renderer::Viewport;
use crate::render::shaders::{self, Source, Variant};
use crate::render::triangles::{MeshCache, MeshForm, Skinning, Skins, material_layout, surface_buffer};
use crate::render::uniforms::Globals;

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R32Uint;

/// For each pixel, rows from the top, the index of the nearest shape's node plus 1; 0 for none. Ghosts and overlays are ignored.
///
/// # Errors
/// [`GpuError::Size`] if a side is 0 or longer than the adapter can draw; [`GpuError::ReadBack`].
pub fn node_picture(gpu: &Gpu, frame: &Frame, width: u32, height: u32) -> Result<Vec<u32>, GpuError> {
    let limit = gpu.largest_side_px();
    if !(1..=limit).contains(&width) || !(1..=limit).contains(&height) {
        return Err(GpuError::Size { width, height, limit });
    }
    let device = &gpu.device;
    let mut packed = Packed::default();
    let mut arranged = Arranged::default();
    let detail = Detail::of_picture(&frame.view, height, 1.0);
    arranged.take(frame, detail, Arrangement::SortedAndCut);
    let mut skins = Skins::new(Skinning::Processor);
    skins.take(frame, &arranged, false);
    packed.pack(
        frame,
        &arranged,
        &Globals::new(frame, &Light::plain(&frame.lighting), None, Viewport::whole(width, height)),
        detail,
        None,
        &skins,
    );
    let usage = wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::VERTEX;
    // The globals' binding ends at the start of the instances, also if there are none.
    let buffer =
        |contents: &[u8], usage| device.create_buffer_init(&BufferInitDescriptor { label: None, contents, usage });
    let frame_buffer = buffer(&packed.bytes, usage);
    let geometry = geometry();
    let vertices = buffer(cast_slice(&geometry.vertices), wgpu::BufferUsages::VERTEX);
    let indices = buffer(cast_slice(&geometry.indices), wgpu::BufferUsages::INDEX);
    let layouts = Layouts::new(device);
    let mut meshes = MeshCache::default();
    meshes.take(device, &gpu.queue, &layouts.material, &frame.meshes, false);
    let skinned = (!skins.vertices.is_empty()).then(|| buffer(cast_slice(&skins.vertices), wgpu::BufferUsages::VERTEX));
    let pipeline_of = |form: Form| pipeline(device, &layouts, form);
    let unit_pipeline = pipeline_of(Form::Unit);
    let globals = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("identity globals"),
        layout: &layouts.globals,
        entries: &[wgpu::BindGroupEntry {
            binding: 0,
            resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                buffer: &frame_buffer,
                offset: 0,
                size: std::num::NonZeroU64::new(INSTANCES_START as u64),
            }),
        }],
    });
    let texture = |format, usage| {
        device.create_texture(&wgpu::TextureDescriptor {
            label: Some("identity"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage,
            view_formats: &[],
        })
    };
    let attachment = wgpu::TextureUsages::RENDER_ATTACHMENT;
    let target = texture(FORMAT, attachment | wgpu::TextureUsages::COPY_SRC);
    let whole = wgpu::TextureViewDescriptor::default();
    let (view, depth) = (target.create_view(&whole), texture(DEPTH_FORMAT, attachment).create_view(&whole));
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("identity"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &depth,
                depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Discard }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        pass.set_pipeline(&unit_pipeline);
        pass.set_bind_group(0, &globals, &[]);
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.set_vertex_buffer(1, frame_buffer.slice(INSTANCES_START as u64..));
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint16);
        for (mesh, instances) in geometry.ranges.iter().zip(&packed.seen).filter(|(_, seen)| !seen.is_empty()) {
            pass.draw_indexed(mesh.indices.clone(), mesh.first_vertex, instances.clone());
        }
        let mut pipelines: [Option<wgpu::RenderPipeline>; MeshForm::COUNT] = Default::default();
        for draw in &packed.triangles.seen {
            let Some(mesh) = meshes.get(&frame.meshes[draw.mesh]) else { continue };
            pass.set_pipeline(pipelines[mesh.form.index()].get_or_insert_with(|| pipeline_of(Form::Mesh(mesh.form))));
            pass.set_bind_group(2, &mesh.material, &[]);
            mesh.bind(&mut pass, draw, skinned.as_ref(), &frame_buffer, INSTANCES_START as u64);
            pass.draw_indexed(0..mesh.index_count(), 0, draw.instances.clone());
        }
    }
    read_back(gpu, encoder, &target)
}

fn read_back(gpu: &Gpu, mut encoder: wgpu::CommandEncoder, target: &wgpu::Texture) -> Result<Vec<u32>, GpuError> {
    let failed = |reason: String| GpuError::ReadBack { adapter: gpu.info.name.clone(), reason };
    let size = target.size();
    let row_bytes = (4 * size.width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("identity"),
        size: u64::from(row_bytes) * u64::from(size.height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row_bytes), rows_per_image: None };
    encoder.copy_texture_to_buffer(target.as_image_copy(), wgpu::TexelCopyBufferInfo { buffer: &buffer, layout }, size);
    gpu.queue.submit([encoder.finish()]);
    let (sender, receiver) = mpsc::channel();
    buffer.map_async(wgpu::MapMode::Read, .., move |result| {
        // The receiver is gone if the wait failed.
        let _ = sender.send(result);
    });
    gpu.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|error| failed(error.to_string()))?;
    receiver.recv().map_err(|error| failed(error.to_string()))?.map_err(|error| failed(error.to_string()))?;
    let padded = buffer.get_mapped_range(..).map_err(|error| failed(error.to_string()))?;
    let rows = padded.chunks_exact(row_bytes as usize);
    Ok(rows.flat_map(|row| pod_collect_to_vec::<u8, u32>(&row[..4 * size.width as usize])).collect())
}

struct Layouts {
    globals: wgpu::BindGroupLayout,
    material: wgpu::BindGroupLayout,
}

impl Layouts {
    fn new(device: &wgpu::Device) -> Self {
        let globals = wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let descriptor = wgpu::BindGroupLayoutDescriptor { label: Some("identity globals"), entries: &[globals] };
        Self { globals: device.create_bind_group_layout(&descriptor), material: material_layout(device) }
    }
}

fn pipeline(device: &wgpu::Device, layouts: &Layouts, form: Form) -> wgpu::RenderPipeline {
    let (is_masked, is_double_sided) = match form {
        Form::Unit => (false, false),
        Form::Mesh(form) => (form.is_masked, form.is_double_sided),
    };
    // Integers need no encoding, and there is one sample per pixel.
    let variant = Variant {
        encodes_srgb: false,
        is_software: false,
        is_multisampled: false,
        is_sub_frame: false,
        corner: form.corner(),
    };
    let (source, vertex, fragment) = if is_masked {
        (Source::Masked, "masked_identity_vertex", "masked_identity_fragment")
    } else {
        (Source::Identity, "identity_vertex", "identity_fragment")
    };
    let module = &shaders::module(device, source, variant);
    let groups = [Some(&layouts.globals), None, is_masked.then_some(&layouts.material)];
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("identity"),
        bind_group_layouts: &groups[..if is_masked { 3 } else { 1 }],
        immediate_size: 0,
    });
    let corner = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3];
    let instance = wgpu::vertex_attr_array![
        2 => Float32x4, 3 => Float32x4, 4 => Float32x4, 5 => Float32x4, 6 => Float32x3, 7 => Uint32, 8 => Float32
    ];
    let buffer = |array_stride: usize, step_mode, attributes| {
        Some(wgpu::VertexBufferLayout { array_stride: array_stride as u64, step_mode, attributes })
    };
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("identity"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(vertex),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[
                buffer(size_of::<Vertex>(), wgpu::VertexStepMode::Vertex, &corner),
                buffer(size_of::<Instance>(), wgpu::VertexStepMode::Instance, &instance),
                is_masked.then(surface_buffer),
            ],
        },
        primitive: wgpu::PrimitiveState {
            cull_mode: (!is_double_sided).then_some(wgpu::Face::Back),
            ..Default::default()
        },
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH_FORMAT,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::GreaterEqual),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(FORMAT.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
