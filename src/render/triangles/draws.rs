//! The draw calls of meshes of triangles: one for all instances of a mesh, or one for each skin that the processor moves.

use std::ops::Range;

use glam::Affine3A;

use super::skins::Skins;
use crate::frame::{DrawItem, Frame, ItemMesh};
use crate::render::arrange::Arranged;
use crate::render::instances::Instance;

/// Instances of a mesh that are drawn at once.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TriangleDraw {
    /// The index of the mesh in the frame.
    pub mesh: usize,
    /// The first of its vertices among those of the [skins](Skins::vertices); `None` for the mesh's own vertices.
    pub first_skinned: Option<u32>,
    /// The instances.
    pub instances: Range<u32>,
}

/// All draw calls of a frame.
#[derive(Debug, Default)]
pub struct TriangleDraws {
    /// Of what may be visible.
    pub seen: Vec<TriangleDraw>,
    /// Of what has an outline.
    pub outlined: Vec<TriangleDraw>,
    /// Of what casts a shadow; of nothing if the shadow map is not drawn.
    pub casters: Vec<TriangleDraw>,
    /// Of ghosts.
    pub ghosts: Vec<TriangleDraw>,
}

impl TriangleDraws {
    /// Makes the draw calls of a frame. `push` takes each instance and returns its index.
    pub fn pack(
        &mut self,
        frame: &Frame,
        arranged: &Arranged,
        is_map_due: bool,
        skins: &Skins,
        mut push: impl FnMut(&Instance) -> u32,
    ) {
        [&mut self.seen, &mut self.outlined, &mut self.casters, &mut self.ghosts].into_iter().for_each(Vec::clear);
        if frame.meshes.is_empty() {
            return;
        }
        let mut by_mesh: Vec<Vec<(&DrawItem, f32)>> = vec![Vec::new(); frame.meshes.len()];
        for (mesh, [plain, outlined]) in arranged.seen_triangles.iter().enumerate() {
            let item = |index: &u32| (&frame.items[*index as usize], 1.0);
            add(&mut self.seen, frame, mesh, plain.iter().map(item), skins, &mut push);
            add(&mut self.outlined, frame, mesh, outlined.iter().map(item), skins, &mut push);
        }
        self.seen.extend_from_slice(&self.outlined);
        if is_map_due {
            for item in &frame.items {
                if let ItemMesh::Triangles { mesh } | ItemMesh::Skin { mesh, .. } = item.mesh {
                    by_mesh[mesh as usize].push((item, 1.0));
                }
            }
            for (mesh, items) in by_mesh.iter_mut().enumerate() {
                add(&mut self.casters, frame, mesh, items.drain(..), skins, &mut push);
            }
        }
        for ghost in &frame.ghosts {
            if let ItemMesh::Triangles { mesh } | ItemMesh::Skin { mesh, .. } = ghost.item.mesh {
                by_mesh[mesh as usize].push((&ghost.item, ghost.opacity));
            }
        }
        for (mesh, items) in by_mesh.iter_mut().enumerate() {
            add(&mut self.ghosts, frame, mesh, items.drain(..), skins, &mut push);
        }
    }
}

/// Adds the draw calls of items of a mesh.
fn add<'a>(
    draws: &mut Vec<TriangleDraw>,
    frame: &Frame,
    mesh: usize,
    items: impl Iterator<Item = (&'a DrawItem, f32)>,
    skins: &Skins,
    push: &mut impl FnMut(&Instance) -> u32,
) {
    let first = draws.len();
    for (item, opacity) in items {
        let (first_joint, matrix) = match item.mesh {
            ItemMesh::Skin { mesh, first_joint } => {
                (Some(first_joint), frame.joints_of(mesh, first_joint).first().copied().unwrap_or_default())
            }
            _ => (None, item.world_from_shape),
        };
        let world_per_mesh = matrix.matrix3.determinant().abs().cbrt();
        let first_skinned = first_joint.and_then(|joint| skins.first_vertex(joint));
        // Vertices that the processor has moved are in world space.
        let world_from_shape = if first_joint.is_some() { Affine3A::IDENTITY } else { matrix };
        let joint = first_joint.unwrap_or_default();
        let index = push(&Instance::of_triangles(item, &world_from_shape, joint, world_per_mesh, opacity));
        match draws[first..].last_mut() {
            Some(last) if last.first_skinned.is_none() && first_skinned.is_none() => last.instances.end = index + 1,
            _ => draws.push(TriangleDraw { mesh, first_skinned, instances: index..index + 1 }),
        }
    }
}
