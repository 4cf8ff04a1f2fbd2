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
        let mut by_mesh: Vec<Vec<(&DrawItem, Option<f32>)>> = vec![Vec::new(); frame.meshes.len()];
        for (mesh, [plain, outlined]) in arranged.seen_triangles.iter().enumerate() {
            let item = |index: &u32| (&frame.items[*index as usize], None);
            add(&mut self.seen, frame, mesh, plain.iter().map(item), skins, &mut push);
            add(&mut self.outlined, frame, mesh, outlined.iter().map(item), skins, &mut push);
        }
        self.seen.extend_from_slice(&self.outlined);
        if is_map_due {
            for item in &frame.items {
                if let ItemMesh::Triangles { mesh } | ItemMesh::Skin { mesh, .. } = item.mesh {
                    by_mesh[mesh as usize].push((item, None));
                }
            }
            for (mesh, items) in by_mesh.iter_mut().enumerate() {
                add(&mut self.casters, frame, mesh, items.drain(..), skins, &mut push);
            }
        }
        for ghost in &frame.ghosts {
            if let ItemMesh::Triangles { mesh } | ItemMesh::Skin { mesh, .. } = ghost.item.mesh {
                by_mesh[mesh as usize].push((&ghost.item, Some(ghost.opacity)));
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
    items: impl Iterator<Item = (&'a DrawItem, Option<f32>)>,
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
        let index =
            push(&Instance::of_triangles(item, &world_from_shape, joint, world_per_mesh, &frame.lighting, opacity));
        match draws[first..].last_mut() {
            Some(last) if last.first_skinned.is_none() && first_skinned.is_none() => last.instances.end = index + 1,
            _ => draws.push(TriangleDraw { mesh, first_skinned, instances: index..index + 1 }),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{Mat4, Vec3};

    use super::*;
    use crate::frame::View;
    use crate::model::{Material, Skin, TriangleMesh};
    use crate::render::arrange::Arrangement;
    use crate::render::detail::Detail;
    use crate::render::triangles::Skinning;

    /// Ten skins of one mesh with two joints, each in a pose of its own, and a ghost of the first.
    fn frame() -> Frame {
        let mesh = TriangleMesh {
            name: "triangle".to_owned(),
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
            normals: vec![Vec3::Z; 3],
            colours: Vec::new(),
            texture_coordinates: Vec::new(),
            indices: vec![0, 1, 2],
            material: Material::default(),
            skin: Some(Skin {
                joints: vec![[0, 1, 0, 0]; 3],
                weights: vec![[0.5, 0.5, 0.0, 0.0]; 3],
                joint_from_shape: vec![Affine3A::IDENTITY; 2],
            }),
        };
        let view = View {
            eye_from_world: Affine3A::IDENTITY,
            world_from_eye: Affine3A::IDENTITY,
            clip_from_eye: Mat4::IDENTITY,
            vertical_fov: 1.0,
            aspect: 1.0,
        };
        let mut frame = Frame::empty(view);
        frame.meshes.push(Arc::new(mesh));
        for index in 0..10_u8 {
            let pose = Affine3A::from_translation(Vec3::new(0.1 * f32::from(index), 0.0, -9.0));
            frame.items.push(DrawItem {
                mesh: ItemMesh::Skin { mesh: 0, first_joint: frame.world_from_bind.len() as u32 },
                world_from_shape: pose,
                half_extents: Vec3::ONE,
                rounding: 0.0,
                colour: Vec3::ONE,
                roughness: 0.6,
                metalness: 0.0,
                node: u32::from(index),
                outlined: false,
                is_hidden: false,
            });
            frame.world_from_bind.extend([pose; 2]);
        }
        frame
    }

    fn draws(skinning: Skinning) -> TriangleDraws {
        let frame = frame();
        let mut arranged = Arranged::default();
        arranged.take(&frame, Detail::FINEST, Arrangement::default());
        let mut skins = Skins::new(skinning);
        skins.take(&frame, &arranged, true);
        let mut draws = TriangleDraws::default();
        let mut count = 0;
        draws.pack(&frame, &arranged, true, &skins, |_| {
            count += 1;
            count - 1
        });
        draws
    }

    #[test]
    fn ten_skins_in_ten_poses_are_one_draw_call_where_the_shader_moves_them() {
        let by_shader = draws(Skinning::Shader);
        assert_eq!(by_shader.seen, [TriangleDraw { mesh: 0, first_skinned: None, instances: 0..10 }]);
        assert_eq!(by_shader.casters, [TriangleDraw { mesh: 0, first_skinned: None, instances: 10..20 }]);
        let by_processor = draws(Skinning::Processor);
        assert_eq!((by_processor.seen.len(), by_processor.casters.len()), (10, 10));
        let mut firsts: Vec<_> = by_processor.seen.iter().filter_map(|draw| draw.first_skinned).collect();
        firsts.sort_unstable();
        assert!(firsts.iter().copied().eq((0..10).map(|skin| 3 * skin)), "each has vertices of its own: {firsts:?}");
    }

    #[test]
    fn skins_are_moved_again_only_when_a_joint_moves() {
        let mut frame = frame();
        let mut arranged = Arranged::default();
        arranged.take(&frame, Detail::FINEST, Arrangement::default());
        let mut skins = Skins::new(Skinning::Processor);
        assert!(skins.take(&frame, &arranged, true));
        assert!(!skins.take(&frame, &arranged, false), "nothing has moved");
        frame.world_from_bind[3].translation.x += 1.0;
        assert!(skins.take(&frame, &arranged, false));
        assert_eq!(skins.vertices.len(), 30);
    }
}
