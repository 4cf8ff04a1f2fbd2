//! What joints make of the vertices of skins.
//!
//! A driver that draws on the processor runs vertex shaders on one thread, and again for each pass. So the processor moves the vertices
//! there, once a picture, by wide instructions; a GPU does it itself, from a texture with the joints' matrices, and takes one draw call
//! for all instances of a mesh.
//!
//! `cargo bench --bench skins` measures both. A picture of 65,000 triangles with 60 joints at 1280x720, with their shadow, takes llvmpipe
//! 54 ms on all threads together if the processor moves the vertices, 57 ms if the vertex shader does; ten of them take 275 and 284 ms.

use std::collections::HashMap;
use std::sync::Arc;

use glam::Affine3A;

use crate::blend::{self, SkinVertices, SkinnedVertex};
use crate::frame::{Frame, ItemMesh, are_same_meshes};
use crate::model::TriangleMesh;
use crate::render::arrange::Arranged;
use crate::render::instances::rows;

/// Who moves the vertices of skins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Skinning {
    /// The processor, before it draws.
    Processor,
    /// The vertex shader.
    Shader,
}

impl Skinning {
    /// What is faster: the processor where it also draws, as measured by `cargo bench --bench skins`.
    #[must_use]
    pub const fn of_adapter(is_software: bool) -> Self {
        if is_software { Self::Processor } else { Self::Shader }
    }
}

/// The skins of a frame. Memory is reused from frame to frame.
#[derive(Debug)]
pub struct Skins {
    skinning: Skinning,
    meshes: Vec<Arc<TriangleMesh>>,
    /// For each mesh its vertices, once a skin of it was wanted.
    sources: Vec<Option<SkinVertices>>,
    world_from_bind: Vec<Affine3A>,
    /// The first vertex of each skin, by its first joint.
    places: HashMap<u32, u32>,
    /// The vertices of all skins in world space, those of a skin together.
    pub vertices: Vec<SkinnedVertex>,
}

impl Skins {
    /// No skins.
    pub fn new(skinning: Skinning) -> Self {
        Self {
            skinning,
            meshes: Vec::new(),
            sources: Vec::new(),
            world_from_bind: Vec::new(),
            places: HashMap::new(),
            vertices: Vec::new(),
        }
    }

    /// Who moves them.
    pub const fn skinning(&self) -> Skinning {
        self.skinning
    }

    /// The first vertex of a skin by its first joint; `None` where the shader moves it.
    pub fn first_vertex(&self, first_joint: u32) -> Option<u32> {
        self.places.get(&first_joint).copied()
    }

    /// Moves the skins of a frame that may be visible or, if the shadow map is due, cast a shadow. Returns whether any vertex is new.
    pub fn take(&mut self, frame: &Frame, arranged: &Arranged, is_map_due: bool) -> bool {
        if self.skinning == Skinning::Shader || frame.world_from_bind.is_empty() {
            return false;
        }
        let skin = |mesh: ItemMesh| match mesh {
            ItemMesh::Skin { mesh, first_joint } => Some((mesh, first_joint)),
            ItemMesh::Unit(_) | ItemMesh::Triangles { .. } => None,
        };
        let seen = arranged.seen_triangles.iter().flatten().flatten().map(|&index| frame.items[index as usize].mesh);
        let casters = frame.items.iter().filter(|_| is_map_due).map(|item| item.mesh);
        let ghosts = frame.ghosts.iter().map(|ghost| ghost.item.mesh);
        let wanted: Vec<(u32, u32)> = seen.chain(casters).chain(ghosts).filter_map(skin).collect();
        let has_meshes = are_same_meshes(&self.meshes, &frame.meshes);
        let is_there = has_meshes
            && self.world_from_bind == frame.world_from_bind
            && wanted.iter().all(|(_, first_joint)| self.places.contains_key(first_joint));
        if is_there {
            return false;
        }
        if !has_meshes {
            self.meshes.clone_from(&frame.meshes);
            self.sources.clear();
            self.sources.resize(frame.meshes.len(), None);
        }
        self.world_from_bind.clone_from(&frame.world_from_bind);
        self.places.clear();
        self.vertices.clear();
        for (mesh, first_joint) in wanted {
            let of_mesh = &frame.meshes[mesh as usize];
            let Some(skin) = of_mesh.skin.as_ref().filter(|_| !self.places.contains_key(&first_joint)) else {
                continue;
            };
            let source = self.sources[mesh as usize].get_or_insert_with(|| SkinVertices::new(of_mesh, skin));
            self.places.insert(first_joint, self.vertices.len() as u32);
            blend::skin(blend::widest(), source, frame.joints_of(mesh, first_joint), &mut self.vertices);
        }
        true
    }
}

/// So many joints are in a row of the texture: three texels each.
const JOINTS_A_ROW: u32 = 256;

/// The texture from which the vertex shader takes the joints' matrices.
#[derive(Debug)]
pub struct JointRows {
    texture: wgpu::Texture,
    /// The texture as group 3.
    pub bind_group: wgpu::BindGroup,
    world_from_bind: Vec<Affine3A>,
}

impl JointRows {
    /// A texture for as many joints, without content.
    fn new(device: &wgpu::Device, layout: &wgpu::BindGroupLayout, joints: usize) -> Self {
        let height = (joints as u32).div_ceil(JOINTS_A_ROW).next_power_of_two();
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("joints"),
            size: wgpu::Extent3d { width: 3 * JOINTS_A_ROW, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Float,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("joints"),
            layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&view) }],
        });
        Self { texture, bind_group, world_from_bind: Vec::new() }
    }

    /// The texture with these matrices, in place of another.
    pub fn with(
        before: Option<Self>,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layout: &wgpu::BindGroupLayout,
        world_from_bind: &[Affine3A],
    ) -> Self {
        let needed = (world_from_bind.len() as u32).div_ceil(JOINTS_A_ROW);
        let fitting = before.filter(|before| before.texture.height() >= needed);
        let mut rows_of = fitting.unwrap_or_else(|| Self::new(device, layout, world_from_bind.len()));
        if rows_of.world_from_bind != world_from_bind {
            rows_of.world_from_bind = world_from_bind.to_vec();
            let mut texels: Vec<[f32; 4]> = world_from_bind.iter().flat_map(rows).collect();
            let width = 3 * JOINTS_A_ROW;
            texels.resize((needed * width) as usize, [0.0; 4]);
            queue.write_texture(
                rows_of.texture.as_image_copy(),
                bytemuck::cast_slice(&texels),
                wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(16 * width), rows_per_image: None },
                wgpu::Extent3d { width, height: needed, depth_or_array_layers: 1 },
            );
        }
        rows_of
    }
}
