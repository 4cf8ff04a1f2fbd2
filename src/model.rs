//! Triangle meshes with their materials and skins, as data: a glTF file has them, shapes of a scene name them, the renderer draws them.
//!
//! Nothing of a mesh changes once it is made, so scenes, frames and the renderer share it.

mod format;
mod tree;

use std::sync::Arc;

use glam::{Affine3A, Vec2, Vec3, Vec4};

pub use format::ModelFormat;
pub use tree::{TriangleTree, may_meet_box, meets, nearer};

/// The most triangles of a mesh.
pub const MOST_TRIANGLES: usize = 4 << 20;
/// The most joints of a skin: a vertex names them by a byte.
pub const MOST_JOINTS: usize = 256;

/// Indexed triangles of one material, in shape space. Lengths in scene units; triangles run anticlockwise seen from outside.
///
/// The lists of a vertex's values are as long as `positions`, or empty where the mesh has no such values.
#[derive(Clone, Debug, PartialEq)]
pub struct TriangleMesh {
    /// Its name, unique in its [`MeshLibrary`].
    pub name: String,
    /// The vertices' positions. Shape space has its origin at the middle of their axis-aligned box.
    pub positions: Vec<Vec3>,
    /// Unit normals; never empty.
    pub normals: Vec<Vec3>,
    /// Linear-light colours and opacities, 0 to 1, that multiply the base colour.
    pub colours: Vec<Vec4>,
    /// Texture coordinates, with the origin at the picture's upper left corner.
    pub texture_coordinates: Vec<Vec2>,
    /// Three vertex indices a triangle.
    pub indices: Vec<u32>,
    /// How its surface looks.
    pub material: Material,
    /// What moves its vertices besides its node.
    pub skin: Option<Skin>,
}

/// How a surface looks: the metallic-roughness material of glTF 2.0, section 3.9. The base colour's factor is the colour of the shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The base colour and opacity, which multiply the shape's colour.
    pub texture: Option<Arc<Texture>>,
    /// 0 to 1.
    pub metallic: f32,
    /// 0 to 1.
    pub roughness: f32,
    /// Linear light that it gives off, each part at least 0.
    pub emissive: Vec3,
    /// Opacity of the base colour, 0 to 1; with a cutoff alone of importance.
    pub opacity: f32,
    /// Fragments whose opacity is below it are not drawn; `None` for an opaque surface.
    pub alpha_cutoff: Option<f32>,
    /// Whether its triangles are drawn from behind too.
    pub is_double_sided: bool,
    /// Whether it shows its base colour in any light (`KHR_materials_unlit`).
    pub is_unlit: bool,
}

/// The roughness of shapes that say none.
pub const DEFAULT_ROUGHNESS: f32 = 0.6;

impl Default for Material {
    /// An opaque material that is as matt as the other shapes.
    fn default() -> Self {
        Self {
            texture: None,
            metallic: 0.0,
            roughness: DEFAULT_ROUGHNESS,
            emissive: Vec3::ZERO,
            opacity: 1.0,
            alpha_cutoff: None,
            is_double_sided: false,
            is_unlit: false,
        }
    }
}

/// How a texture goes on beyond its border, along an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Wrap {
    /// It begins again.
    #[default]
    Repeat,
    /// It begins again, mirrored.
    Mirror,
    /// Its border goes on.
    Clamp,
}

/// A picture on a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// The file, as it was read.
    pub file: Arc<[u8]>,
    /// `image/png` or `image/jpeg`.
    pub media_type: &'static str,
    /// Width and height in pixels.
    pub size_px: [u32; 2],
    /// Rows from the top, four bytes a pixel: sRGB red, green and blue, and opacity that does not multiply them.
    pub pixels: Arc<[u8]>,
    /// Along x and y.
    pub wrap: [Wrap; 2],
    /// Whether pixels are not blended with their neighbours.
    pub is_pixelated: bool,
}

/// Linear blend skinning: a vertex is moved by the weighted sum of `world_from_joint * joint_from_shape`. The mesh's own node is ignored.
#[derive(Clone, Debug, PartialEq)]
pub struct Skin {
    /// For each vertex four indices in `joint_from_shape`.
    pub joints: Vec<[u8; 4]>,
    /// For each vertex the weights of these joints: at least 0, with a sum of 1.
    pub weights: Vec<[f32; 4]>,
    /// For each joint, shape space to the joint's space in the bind pose: glTF's inverse bind matrices.
    pub joint_from_shape: Vec<Affine3A>,
}

/// The meshes of a scene, and the binary glTF file that holds them.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshLibrary {
    /// The file's bytes.
    pub glb: Arc<[u8]>,
    /// Its meshes. No two have one name.
    pub meshes: Vec<Arc<TriangleMesh>>,
}

impl MeshLibrary {
    /// The mesh with a name.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<&Arc<TriangleMesh>> {
        self.meshes.iter().find(|mesh| mesh.name == name)
    }
}

impl TriangleMesh {
    /// A mesh without triangles.
    #[must_use]
    pub fn empty(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            positions: Vec::new(),
            normals: Vec::new(),
            colours: Vec::new(),
            texture_coordinates: Vec::new(),
            indices: Vec::new(),
            material: Material::default(),
            skin: None,
        }
    }

    /// Half the extents of the smallest axis-aligned box around the vertices whose middle is the origin, in shape space.
    #[must_use]
    pub fn half_extents(&self) -> Vec3 {
        self.positions.iter().fold(Vec3::ZERO, |half, position| half.max(position.abs()))
    }

    /// The corners of each triangle, in shape space.
    pub fn triangles(&self) -> impl Iterator<Item = [Vec3; 3]> + '_ {
        self.indices.chunks_exact(3).map(|corners| [0, 1, 2].map(|corner| self.positions[corners[corner] as usize]))
    }
}
