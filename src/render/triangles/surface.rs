//! What the vertices of a mesh have besides their place.

use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec4};

use crate::model::TriangleMesh;

/// `Surface` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct SurfaceVertex {
    coordinates: [f32; 2],
    /// Parts of 65535.
    colour: [u16; 4],
    /// Texels of the texture for each unit of length of the mesh.
    texels: f32,
}

impl SurfaceVertex {
    /// Those of all vertices of a mesh.
    pub fn all(mesh: &TriangleMesh) -> Vec<Self> {
        let texels = texels_per_length(mesh);
        let vertex = |index: usize| Self {
            coordinates: mesh.texture_coordinates.get(index).copied().unwrap_or_default().to_array(),
            colour: mesh
                .colours
                .get(index)
                .copied()
                .unwrap_or(Vec4::ONE)
                .to_array()
                .map(|part| (part.clamp(0.0, 1.0) * 65535.0).round() as u16),
            texels: texels.get(index).copied().unwrap_or_default(),
        };
        (0..mesh.positions.len()).map(vertex).collect()
    }
}

/// For each vertex the mean of its triangles by their areas: how many texels a unit of length of the mesh shows. Empty without a texture.
fn texels_per_length(mesh: &TriangleMesh) -> Vec<f32> {
    let Some(texture) = mesh.material.texture.as_ref().filter(|_| !mesh.texture_coordinates.is_empty()) else {
        return Vec::new();
    };
    let size = Vec2::from(texture.size_px.map(|side| side as f32));
    let mut sums = vec![[0.0_f32; 2]; mesh.positions.len()];
    for corners in mesh.indices.chunks_exact(3) {
        let corner = |place: usize| corners[place] as usize;
        let position = |place: usize| mesh.positions[corner(place)];
        let texel = |place: usize| mesh.texture_coordinates[corner(place)] * size;
        let area = (position(1) - position(0)).cross(position(2) - position(0)).length();
        let texels = (texel(1) - texel(0)).perp_dot(texel(2) - texel(0)).abs();
        if area > 0.0 {
            for place in 0..3 {
                let [sum, of] = &mut sums[corner(place)];
                *sum += (texels * area).sqrt();
                *of += area;
            }
        }
    }
    sums.into_iter().map(|[sum, of]| if of > 0.0 { sum / of } else { 0.0 }).collect()
}
