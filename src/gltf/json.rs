//! The JSON of a glTF file (glTF 2.0, section 5), read and written by the same types. Names and units are the specification's.
//!
//! Fields that no reader and no writer of this program uses are not here; a file's other fields are ignored. Indices are not checked:
//! whoever follows one looks whether it leads somewhere.

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// The index of an object in the list of its kind.
pub type Index = usize;

/// Whether a list is left out of the file: the specification allows no empty ones.
fn is_empty<T>(list: &[T]) -> bool {
    list.is_empty()
}

/// Properties of an application's own.
pub type Extras = Option<Value>;
/// Extensions by name.
pub type Extensions = Map<String, Value>;

/// A whole file.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Root {
    /// What wrote the file.
    pub asset: Asset,
    /// The scene that is shown.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scene: Option<Index>,
    /// The scenes.
    #[serde(skip_serializing_if = "is_empty")]
    pub scenes: Vec<Scene>,
    /// The nodes.
    #[serde(skip_serializing_if = "is_empty")]
    pub nodes: Vec<Node>,
    /// The meshes.
    #[serde(skip_serializing_if = "is_empty")]
    pub meshes: Vec<Mesh>,
    /// The skins.
    #[serde(skip_serializing_if = "is_empty")]
    pub skins: Vec<Skin>,
    /// The animations.
    #[serde(skip_serializing_if = "is_empty")]
    pub animations: Vec<Animation>,
    /// The cameras.
    #[serde(skip_serializing_if = "is_empty")]
    pub cameras: Vec<Camera>,
    /// The materials.
    #[serde(skip_serializing_if = "is_empty")]
    pub materials: Vec<Material>,
    /// The textures.
    #[serde(skip_serializing_if = "is_empty")]
    pub textures: Vec<Texture>,
    /// The pictures of textures.
    #[serde(skip_serializing_if = "is_empty")]
    pub images: Vec<Image>,
    /// How textures are looked up.
    #[serde(skip_serializing_if = "is_empty")]
    pub samplers: Vec<Sampler>,
    /// Lists of numbers.
    #[serde(skip_serializing_if = "is_empty")]
    pub accessors: Vec<Accessor>,
    /// Parts of buffers.
    #[serde(skip_serializing_if = "is_empty")]
    pub buffer_views: Vec<BufferView>,
    /// Bytes.
    #[serde(skip_serializing_if = "is_empty")]
    pub buffers: Vec<Buffer>,
    /// The names of extensions that the file uses.
    #[serde(skip_serializing_if = "is_empty")]
    pub extensions_used: Vec<String>,
    /// The names of extensions without which the file cannot be understood.
    #[serde(skip_serializing_if = "is_empty")]
    pub extensions_required: Vec<String>,
    /// Extensions of the whole file.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub extensions: Extensions,
    /// Properties of an application's own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extras: Extras,
}

/// What wrote the file.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Asset {
    /// The version of glTF: `2.0`.
    pub version: String,
    /// The least version that a reader must know.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min_version: Option<String>,
    /// The program that wrote it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub generator: Option<String>,
    /// Properties of an application's own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extras: Extras,
}

/// Roots of node trees.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Scene {
    /// Its name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The nodes at the top.
    #[serde(skip_serializing_if = "is_empty")]
    pub nodes: Vec<Index>,
    /// Properties of an application's own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extras: Extras,
}

/// A node: a transform, and what moves with it.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Node {
    /// Its name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The nodes below it.
    #[serde(skip_serializing_if = "is_empty")]
    pub children: Vec<Index>,
    /// `parent_from_node` by columns, in place of the three below.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub matrix: Option<[f32; 16]>,
    /// x, y, z.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub translation: Option<[f32; 3]>,
    /// A unit quaternion: x, y, z, w.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rotation: Option<[f32; 4]>,
    /// Factors along the node's axes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scale: Option<[f32; 3]>,
    /// Its mesh.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mesh: Option<Index>,
    /// The skin that moves its mesh.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub skin: Option<Index>,
    /// Its camera, which looks along −Z.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub camera: Option<Index>,
    /// Weights of the mesh's morph targets.
    #[serde(skip_serializing_if = "is_empty")]
    pub weights: Vec<f32>,
    /// Extensions by name.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub extensions: Extensions,
    /// Properties of an application's own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extras: Extras,
}

/// Primitives that share a node.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Mesh {
    /// Its name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// What is drawn, each with one material.
    pub primitives: Vec<Primitive>,
    /// Weights of its morph targets.
    #[serde(skip_serializing_if = "is_empty")]
    pub weights: Vec<f32>,
    /// Properties of an application's own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extras: Extras,
}

/// Triangles, lines or points of one material.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Primitive {
    /// Accessors by the names of attributes, such as `POSITION`.
    pub attributes: std::collections::BTreeMap<String, Index>,
    /// The accessor of indices.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub indices: Option<Index>,
    /// The material.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub material: Option<Index>,
    /// 0 points, 1 to 3 lines, 4 triangles (the default), 5 a strip, 6 a fan.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mode: Option<u32>,
    /// Morph targets.
    #[serde(skip_serializing_if = "is_empty")]
    pub targets: Vec<Value>,
    /// Extensions by name.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub extensions: Extensions,
    /// Properties of an application's own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extras: Extras,
}

/// Joints and their bind pose.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Skin {
    /// Its name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The accessor of matrices from mesh space to the joints' spaces; without it identities.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inverse_bind_matrices: Option<Index>,
    /// The joint at the top.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub skeleton: Option<Index>,
    /// The nodes that are joints.
    pub joints: Vec<Index>,
}

/// Channels that play together.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Animation {
    /// Its name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// What is moved.
    pub channels: Vec<Channel>,
    /// Values over time.
    pub samplers: Vec<AnimationSampler>,
    /// Properties of an application's own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extras: Extras,
}

/// One property of one node, moved by a sampler.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Channel {
    /// The sampler, in the animation's list.
    pub sampler: Index,
    /// The property.
    pub target: ChannelTarget,
}

/// A property of a node.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct ChannelTarget {
    /// The node; where it is missing, an extension says what is moved.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub node: Option<Index>,
    /// `translation`, `rotation`, `scale` or `weights`.
    pub path: String,
    /// Extensions by name.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub extensions: Extensions,
}

/// Values at times, and how they are interpolated.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct AnimationSampler {
    /// The accessor of times in seconds, ascending.
    pub input: Index,
    /// The accessor of values; for `CUBICSPLINE` three a time.
    pub output: Index,
    /// `LINEAR` (the default), `STEP` or `CUBICSPLINE`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub interpolation: Option<String>,
}

/// A camera.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Camera {
    /// Its name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// `perspective` or `orthographic`.
    #[serde(rename = "type")]
    pub kind: String,
    /// The field of view of a perspective camera.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub perspective: Option<Perspective>,
    /// An orthographic camera.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orthographic: Option<Value>,
}

/// The field of view of a perspective camera.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Perspective {
    /// Width over height.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub aspect_ratio: Option<f32>,
    /// The vertical field of view in radians.
    pub yfov: f32,
    /// The distance of the near plane.
    pub znear: f32,
    /// The distance of the far plane; without it, infinite.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub zfar: Option<f32>,
}

/// A material.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Material {
    /// Its name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Base colour, metallic and roughness.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pbr_metallic_roughness: Option<MetallicRoughness>,
    /// Bumps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal_texture: Option<Value>,
    /// Shade in corners.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub occlusion_texture: Option<Value>,
    /// Light that it gives off.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub emissive_texture: Option<Value>,
    /// Linear light that it gives off.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub emissive_factor: Option<[f32; 3]>,
    /// `OPAQUE` (the default), `MASK` or `BLEND`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alpha_mode: Option<String>,
    /// For `MASK`, 0.5 by default.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alpha_cutoff: Option<f32>,
    /// Whether triangles are seen from behind.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub double_sided: Option<bool>,
    /// Extensions by name.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub extensions: Extensions,
}

/// Base colour, metallic and roughness. The factors are 1 by default.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct MetallicRoughness {
    /// Linear red, green, blue, and opacity.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base_color_factor: Option<[f32; 4]>,
    /// What multiplies it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base_color_texture: Option<TextureInfo>,
    /// 0 to 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub metallic_factor: Option<f32>,
    /// 0 to 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roughness_factor: Option<f32>,
    /// What multiplies them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub metallic_roughness_texture: Option<Value>,
}

/// Which texture, by which coordinates.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct TextureInfo {
    /// The texture.
    pub index: Index,
    /// The number of the attribute `TEXCOORD_…`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tex_coord: Option<u32>,
    /// Extensions by name.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub extensions: Extensions,
}

/// A picture and how it is looked up.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Texture {
    /// How it is looked up.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sampler: Option<Index>,
    /// The picture; where it is missing, an extension has another kind of picture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<Index>,
    /// Extensions by name.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub extensions: Extensions,
}

/// A picture: a file, or a part of a buffer.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Image {
    /// Its name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// A file beside this one, or a data URI.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uri: Option<String>,
    /// `image/png` or `image/jpeg`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mime_type: Option<String>,
    /// Its bytes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub buffer_view: Option<Index>,
}

/// How a texture is looked up; the values are those of OpenGL.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Sampler {
    /// 9728 nearest, 9729 linear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mag_filter: Option<u32>,
    /// 9728 nearest, 9729 linear, 9984 to 9987 with smaller pictures.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min_filter: Option<u32>,
    /// 33071 clamp, 33648 mirror, 10497 repeat (the default).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wrap_s: Option<u32>,
    /// The same along y.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wrap_t: Option<u32>,
}

/// A list of scalars, vectors or matrices.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Accessor {
    /// Where its bytes are; without it, zeros.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub buffer_view: Option<Index>,
    /// Where it begins in the view, in bytes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub byte_offset: Option<usize>,
    /// 5120 i8, 5121 u8, 5122 i16, 5123 u16, 5125 u32, 5126 f32.
    pub component_type: u32,
    /// Whether integers stand for 0 to 1 or −1 to 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normalized: Option<bool>,
    /// The number of elements.
    pub count: usize,
    /// `SCALAR`, `VEC2`, `VEC3`, `VEC4`, `MAT2`, `MAT3` or `MAT4`.
    #[serde(rename = "type")]
    pub kind: String,
    /// The largest of each component.
    #[serde(skip_serializing_if = "is_empty")]
    pub max: Vec<f32>,
    /// The least of each component.
    #[serde(skip_serializing_if = "is_empty")]
    pub min: Vec<f32>,
    /// Elements that are other than in the view.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sparse: Option<Sparse>,
}

/// Elements that replace those of a view.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Sparse {
    /// How many.
    pub count: usize,
    /// Which ones, ascending.
    pub indices: SparseIndices,
    /// What they are.
    pub values: SparseValues,
}

/// Which elements are replaced.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct SparseIndices {
    /// Where the bytes are.
    pub buffer_view: Index,
    /// Where they begin in the view, in bytes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub byte_offset: Option<usize>,
    /// 5121 u8, 5123 u16, 5125 u32.
    pub component_type: u32,
}

/// What elements are replaced by, in the accessor's own form.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct SparseValues {
    /// Where the bytes are.
    pub buffer_view: Index,
    /// Where they begin in the view, in bytes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub byte_offset: Option<usize>,
}

/// A part of a buffer.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct BufferView {
    /// The buffer.
    pub buffer: Index,
    /// Where it begins, in bytes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub byte_offset: Option<usize>,
    /// Its length in bytes.
    pub byte_length: usize,
    /// From one element to the next, in bytes; without it they are close together.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub byte_stride: Option<usize>,
    /// 34962 vertices, 34963 indices.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target: Option<u32>,
    /// Extensions by name.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub extensions: Extensions,
}

/// Bytes: a file, a data URI, or the second chunk of a binary file.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Buffer {
    /// A file beside this one, or a data URI; without it, the binary file's second chunk.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uri: Option<String>,
    /// Its length in bytes.
    pub byte_length: usize,
}
