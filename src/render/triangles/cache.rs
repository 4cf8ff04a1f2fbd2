//! What the GPU keeps of meshes and their textures from frame to frame.

#[cfg(test)]
mod tests;

use std::collections::HashMap;
use std::sync::Arc;

use bytemuck::{Pod, Zeroable, bytes_of, cast_slice};
use wgpu::util::{BufferInitDescriptor, DeviceExt};

use super::draws::TriangleDraw;
use super::mips::Mip;
use super::surface::SurfaceVertex;
use crate::model::{Material, Texture, TriangleMesh, Wrap};
use crate::render::mesh::Vertex;

/// Meshes that no frame needs now are kept while all together take no more: 256 MiB.
const MOST_KEPT_BYTES: u64 = 256 << 20;
/// The texture of materials without one.
const WHITE: [u8; 4] = [255; 4];

/// How the pipelines of meshes differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshForm {
    /// Whether the surface has holes.
    pub is_masked: bool,
    /// Whether triangles are drawn from behind too.
    pub is_double_sided: bool,
    /// Whether the vertex shader moves a skin.
    pub is_skinned: bool,
}

impl MeshForm {
    /// The number of forms.
    pub const COUNT: usize = 8;

    /// A number below [`Self::COUNT`] for each form.
    pub const fn index(self) -> usize {
        self.is_masked as usize | (self.is_double_sided as usize) << 1 | (self.is_skinned as usize) << 2
    }
}

/// `Material` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct MaterialUniform {
    emissive_and_unlit: [f32; 4],
    /// Cutoff of opacity, opacity; then nothing, to a size that uniforms have.
    factors: [f32; 4],
}

/// The joints of a vertex, as the vertex shader takes them.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct WeightsVertex {
    joints: [u8; 4],
    weights: [f32; 4],
}

/// A mesh on the GPU.
#[derive(Debug)]
pub struct MeshOnGpu {
    /// Kept so that no other mesh can have its address.
    mesh: Arc<TriangleMesh>,
    /// Positions and normals, as unit meshes have them.
    vertices: wgpu::Buffer,
    /// [`SurfaceVertex`]
    surface: wgpu::Buffer,
    /// Joints and weights, where the vertex shader moves a skin.
    weights: Option<wgpu::Buffer>,
    /// Three a triangle.
    indices: wgpu::Buffer,
    /// The material as group 2.
    pub material: wgpu::BindGroup,
    /// Its pipelines.
    pub form: MeshForm,
    used_in: u64,
}

impl MeshOnGpu {
    /// The number of indices.
    pub fn index_count(&self) -> u32 {
        self.mesh.indices.len() as u32
    }

    /// Sets the vertex and index buffers of a draw call. `skinned` are the vertices that the processor has moved.
    pub fn bind(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        draw: &TriangleDraw,
        skinned: Option<&wgpu::Buffer>,
        instances: &wgpu::Buffer,
        instances_start: u64,
    ) {
        let vertices = match (draw.first_skinned, skinned) {
            (Some(first), Some(skinned)) => skinned.slice(u64::from(first) * size_of::<Vertex>() as u64..),
            _ => self.vertices.slice(..),
        };
        pass.set_vertex_buffer(0, vertices);
        pass.set_vertex_buffer(1, instances.slice(instances_start..));
        pass.set_vertex_buffer(2, self.surface.slice(..));
        if let Some(weights) = &self.weights {
            pass.set_vertex_buffer(3, weights.slice(..));
        }
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
    }

    fn bytes(&self) -> u64 {
        let weights = self.weights.as_ref().map_or(0, wgpu::Buffer::size);
        self.vertices.size() + self.surface.size() + self.indices.size() + weights
    }
}

#[derive(Debug)]
struct TextureOnGpu {
    /// Kept so that no other texture can have its address.
    texture: Arc<Texture>,
    view: wgpu::TextureView,
    used_in: u64,
    bytes: u64,
}

/// All of them, by address.
#[derive(Debug, Default)]
pub struct MeshCache {
    meshes: HashMap<usize, MeshOnGpu>,
    textures: HashMap<usize, TextureOnGpu>,
    white: Option<wgpu::TextureView>,
    frames: u64,
}

fn address<T>(of: &Arc<T>) -> usize {
    Arc::as_ptr(of).addr()
}

impl MeshCache {
    /// Takes in the meshes of a frame, and lets others go.
    pub fn take(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layout: &wgpu::BindGroupLayout,
        meshes: &[Arc<TriangleMesh>],
        has_skinning_shader: bool,
    ) {
        self.take_within(MOST_KEPT_BYTES, device, queue, layout, meshes, has_skinning_shader);
    }

    fn take_within(
        &mut self,
        most_bytes: u64,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layout: &wgpu::BindGroupLayout,
        meshes: &[Arc<TriangleMesh>],
        has_skinning_shader: bool,
    ) {
        if meshes.is_empty() && self.meshes.is_empty() {
            return;
        }
        self.frames += 1;
        for mesh in meshes {
            if !self.meshes.contains_key(&address(mesh)) {
                let view = self.texture(device, queue, mesh.material.texture.as_ref());
                let made = made(device, layout, mesh, &view, has_skinning_shader);
                self.meshes.insert(address(mesh), made);
            }
            if let Some(mesh) = self.meshes.get_mut(&address(mesh)) {
                mesh.used_in = self.frames;
            }
            let texture = mesh.material.texture.as_ref().map(address);
            if let Some(texture) = texture.and_then(|texture| self.textures.get_mut(&texture)) {
                texture.used_in = self.frames;
            }
        }
        self.let_go(most_bytes);
    }

    /// A mesh of the last frame.
    pub fn get(&self, mesh: &Arc<TriangleMesh>) -> Option<&MeshOnGpu> {
        self.meshes.get(&address(mesh))
    }

    /// Lets go what nobody else has any more, and, beyond the bound, all that this frame does not need.
    fn let_go(&mut self, most_bytes: u64) {
        let (is_full, frames) = (self.bytes() > most_bytes, self.frames);
        let stays = |used_in: u64, others: usize| used_in == frames || !is_full && others > 0;
        self.meshes.retain(|_, mesh| stays(mesh.used_in, Arc::strong_count(&mesh.mesh) - 1));
        self.textures.retain(|_, texture| stays(texture.used_in, Arc::strong_count(&texture.texture) - 1));
    }

    /// What all of it takes.
    fn bytes(&self) -> u64 {
        self.meshes.values().map(MeshOnGpu::bytes).sum::<u64>()
            + self.textures.values().map(|texture| texture.bytes).sum::<u64>()
    }

    fn texture(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        texture: Option<&Arc<Texture>>,
    ) -> wgpu::TextureView {
        let Some(texture) = texture else {
            let white = || uploaded(device, queue, [1, 1], &WHITE).0;
            return self.white.get_or_insert_with(white).clone();
        };
        let made = || {
            let (view, bytes) = uploaded(device, queue, texture.size_px, &texture.pixels);
            TextureOnGpu { texture: Arc::clone(texture), view, used_in: 0, bytes }
        };
        self.textures.entry(address(texture)).or_insert_with(made).view.clone()
    }
}

fn uploaded(device: &wgpu::Device, queue: &wgpu::Queue, size_px: [u32; 2], pixels: &[u8]) -> (wgpu::TextureView, u64) {
    let mips = Mip::all(size_px, pixels, device.limits().max_texture_dimension_2d);
    let extent = |[width, height]: [u32; 2]| wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("texture"),
        size: extent(mips[0].size_px),
        mip_level_count: mips.len() as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8UnormSrgb,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (mip, mip_level) in mips.iter().zip(0..) {
        queue.write_texture(
            wgpu::TexelCopyTextureInfo { mip_level, ..texture.as_image_copy() },
            &mip.pixels,
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * mip.size_px[0]), rows_per_image: None },
            extent(mip.size_px),
        );
    }
    let bytes = mips.iter().map(|mip| mip.pixels.len() as u64).sum();
    (texture.create_view(&wgpu::TextureViewDescriptor::default()), bytes)
}

fn made(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    mesh: &Arc<TriangleMesh>,
    texture: &wgpu::TextureView,
    has_skinning_shader: bool,
) -> MeshOnGpu {
    let buffer = |contents: &[u8], usage| {
        device.create_buffer_init(&BufferInitDescriptor { label: Some("mesh"), contents, usage })
    };
    let vertex = wgpu::BufferUsages::VERTEX;
    let corners = mesh.positions.iter().zip(&mesh.normals);
    let vertices: Vec<Vertex> =
        corners.map(|(position, normal)| Vertex { core: position.to_array(), normal: normal.to_array() }).collect();
    let skin = mesh.skin.as_ref().filter(|_| has_skinning_shader);
    let weights = skin.map(|skin| {
        let weights = skin.joints.iter().zip(&skin.weights);
        let weights: Vec<_> = weights.map(|(&joints, &weights)| WeightsVertex { joints, weights }).collect();
        buffer(cast_slice(&weights), vertex)
    });
    let material = &mesh.material;
    MeshOnGpu {
        mesh: Arc::clone(mesh),
        vertices: buffer(cast_slice(&vertices), vertex),
        surface: buffer(cast_slice(&SurfaceVertex::all(mesh)), vertex),
        form: MeshForm {
            is_masked: material.alpha_cutoff.is_some(),
            is_double_sided: material.is_double_sided,
            is_skinned: weights.is_some(),
        },
        weights,
        indices: buffer(cast_slice(&mesh.indices), wgpu::BufferUsages::INDEX),
        material: bound(device, layout, material, texture),
        used_in: 0,
    }
}

/// The bind group of a material.
fn bound(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    material: &Material,
    texture: &wgpu::TextureView,
) -> wgpu::BindGroup {
    let [red, green, blue] = material.emissive.to_array();
    let uniform = MaterialUniform {
        emissive_and_unlit: [red, green, blue, if material.is_unlit { 1.0 } else { 0.0 }],
        factors: [material.alpha_cutoff.unwrap_or_default(), material.opacity, 0.0, 0.0],
    };
    let contents = bytes_of(&uniform);
    let usage = wgpu::BufferUsages::UNIFORM;
    let uniform = device.create_buffer_init(&BufferInitDescriptor { label: Some("material"), contents, usage });
    let wrap = material.texture.as_ref().map_or([Wrap::Repeat; 2], |texture| texture.wrap).map(|wrap| match wrap {
        Wrap::Repeat => wgpu::AddressMode::Repeat,
        Wrap::Mirror => wgpu::AddressMode::MirrorRepeat,
        Wrap::Clamp => wgpu::AddressMode::ClampToEdge,
    });
    let is_pixelated = material.texture.as_ref().is_some_and(|texture| texture.is_pixelated);
    let filter = if is_pixelated { wgpu::FilterMode::Nearest } else { wgpu::FilterMode::Linear };
    let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("texture"),
        address_mode_u: wrap[0],
        address_mode_v: wrap[1],
        mag_filter: filter,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        ..Default::default()
    });
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("material"),
        layout,
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(texture) },
            wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&sampler) },
            wgpu::BindGroupEntry { binding: 2, resource: uniform.as_entire_binding() },
        ],
    })
}
