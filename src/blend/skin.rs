//! Linear blend skinning of all vertices of a mesh on the processor: two of a vertex's matrices at a time, or all four.
//!
//! A vertex costs some 10 ns, and is computed once a picture, however many passes draw it.

use bytemuck::{Pod, Zeroable};
use fearless_simd::prelude::*;
use fearless_simd::{dispatch, f32x16};
use glam::{Affine3A, Vec3, Vec3A};

use super::Level;
use crate::model::{Skin, TriangleMesh};

/// A vertex of a mesh in world space.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct SkinnedVertex {
    /// Its position.
    pub position: [f32; 3],
    /// Its unit normal; 0 where its matrices make nothing of it.
    pub normal: [f32; 3],
}

/// The vertices of a skin as the loop over them reads them.
#[derive(Clone, Debug)]
pub struct SkinVertices(Vec<SkinVertex>);

/// One cache line.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct SkinVertex {
    position: Vec3,
    normal: Vec3,
    joints: [u8; 4],
    weights: [f32; 4],
}

impl SkinVertices {
    /// The vertices of a mesh with its skin. Joints that the skin lacks count as its first.
    #[must_use]
    pub fn new(mesh: &TriangleMesh, skin: &Skin) -> Self {
        let count = skin.joint_from_shape.len();
        let vertices = mesh.positions.iter().zip(&mesh.normals).zip(skin.joints.iter().zip(&skin.weights));
        let vertices = vertices.map(|((&position, &normal), (&joints, &weights))| {
            let joints = joints.map(|joint| if usize::from(joint) < count { joint } else { 0 });
            SkinVertex { position, normal, joints, weights }
        });
        Self(vertices.collect())
    }

    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// Appends the vertices of a skin in world space. `world_from_bind`: for each joint, shape space in the bind pose to world space; at least
/// as many as the skin has joints.
pub fn skin(level: Level, vertices: &SkinVertices, world_from_bind: &[Affine3A], into: &mut Vec<SkinnedVertex>) {
    let columns = |world_from_bind: &Affine3A| {
        let axes = world_from_bind.matrix3;
        let columns = [axes.x_axis, axes.y_axis, axes.z_axis, world_from_bind.translation];
        let mut joined = [0.0; 16];
        for (place, column) in joined.chunks_exact_mut(4).zip(columns) {
            place[..3].copy_from_slice(&column.to_array());
        }
        joined
    };
    let matrices: Vec<[f32; 16]> = world_from_bind.iter().map(columns).collect();
    into.reserve(vertices.len());
    dispatch!(level, simd => skin_with(simd, &vertices.0, &matrices, into));
}

#[inline(always)]
fn skin_with<S: Simd>(simd: S, vertices: &[SkinVertex], matrices: &[[f32; 16]], into: &mut Vec<SkinnedVertex>) {
    for vertex in vertices {
        let mut sum = f32x16::splat(simd, 0.0);
        for (&joint, &weight) in vertex.joints.iter().zip(&vertex.weights) {
            let matrix = f32x16::from_slice(simd, &matrices[usize::from(joint)]);
            sum = matrix.mul_add(f32x16::splat(simd, weight), sum);
        }
        let mut columns = [0.0; 16];
        sum.store_slice(&mut columns);
        let column = |index: usize| Vec3A::new(columns[index], columns[index + 1], columns[index + 2]);
        let (x, y, z, translation) = (column(0), column(4), column(8), column(12));
        let (p, n) = (vertex.position, vertex.normal);
        // The cofactor matrix transforms normals for any affine that does not mirror.
        let normal = y.cross(z) * n.x + z.cross(x) * n.y + x.cross(y) * n.z;
        let position = x * p.x + y * p.y + z * p.z + translation;
        into.push(SkinnedVertex { position: position.to_array(), normal: normal.normalize_or_zero().to_array() });
    }
}

#[cfg(test)]
mod tests {
    use glam::Quat;

    use super::*;
    use crate::blend::widest;
    use crate::model::Material;

    #[test]
    fn vertices_are_where_their_joints_carry_them() {
        let positions: Vec<Vec3> = (0..37).map(|index| Vec3::new(index as f32 * 0.1, 1.0, -0.5)).collect();
        let count = positions.len();
        let joints = (0..count).map(|index| [0, 1, (index % 2) as u8, 1]).collect();
        let weights: Vec<[f32; 4]> =
            (0..count).map(|index| [1.0 - index as f32 / 36.0, index as f32 / 36.0, 0.0, 0.0]).collect();
        let bind = Affine3A::from_translation(Vec3::NEG_X);
        let mesh = TriangleMesh {
            name: "bar".to_owned(),
            normals: vec![Vec3::Y; count],
            positions: positions.clone(),
            colours: Vec::new(),
            texture_coordinates: Vec::new(),
            indices: Vec::new(),
            material: Material::default(),
            skin: Some(Skin { joints, weights: weights.clone(), joint_from_shape: vec![Affine3A::IDENTITY, bind] }),
        };
        let vertices = SkinVertices::new(&mesh, mesh.skin.as_ref().unwrap());
        let turned = Affine3A::from_rotation_translation(Quat::from_rotation_z(1.0), Vec3::new(0.0, 2.0, 0.0));
        let joints = [Affine3A::from_translation(Vec3::X), turned * bind];
        for level in [widest(), Level::baseline()] {
            let mut skinned = Vec::new();
            skin(level, &vertices, &joints, &mut skinned);
            assert_eq!(skinned.len(), count);
            for ((skinned, position), weights) in skinned.iter().zip(&positions).zip(&weights) {
                let expected = joints[0].transform_point3(*position) * weights[0]
                    + joints[1].transform_point3(*position) * weights[1];
                assert!(Vec3::from(skinned.position).abs_diff_eq(expected, 1e-5));
                let normal = Vec3::from(skinned.normal);
                assert!(normal.is_normalized());
                let expected = Vec3::Y * weights[0] + joints[1].transform_vector3(Vec3::Y) * weights[1];
                assert!(normal.angle_between(expected) < 1e-3);
            }
        }
    }
}
