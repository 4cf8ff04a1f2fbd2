//! Meshes, skins, materials and textures into a glTF file; and a library of meshes as a file.

use std::borrow::Borrow;
use std::collections::BTreeMap;
use std::sync::Arc;

use glam::{Affine3A, Quat, Vec3};
use serde_json::{Map, json};

use super::Writer;
use crate::gltf::json::{self, Index};
use crate::model::{Material, MeshLibrary, Skin, Texture, TriangleMesh, Wrap};

const UNLIT: &str = "KHR_materials_unlit";
const EMISSIVE_STRENGTH: &str = "KHR_materials_emissive_strength";
const NEAREST: u32 = 9728;
const LINEAR: u32 = 9729;
const LINEAR_BETWEEN_SMALLER_PICTURES: u32 = 9987;
/// How far from 1 the sum of a vertex's weights may be, for each weight: so much comes from their rounding, says the specification.
const WEIGHT_ROUNDING: f32 = 2e-7;

impl MeshLibrary {
    /// A binary glTF file of meshes: for each one a node at the root and a mesh with its name, and one primitive with its material. The base
    /// colour's factor is white; the mesh's node carries the joints of its skin, in the bind pose. Equal meshes make equal bytes.
    ///
    /// # Panics
    /// If the file would have 4 GiB or more.
    #[must_use]
    pub fn to_glb<M: Borrow<TriangleMesh>>(meshes: &[M]) -> Vec<u8> {
        let mut writer = Writer::new();
        let mut roots = Vec::new();
        for mesh in meshes {
            let mesh = mesh.borrow();
            let node = writer.root.nodes.len();
            roots.push(node);
            writer.root.nodes.push(json::Node { name: Some(mesh.name.clone()), ..json::Node::default() });
            let material = writer.material(&mesh.material, Vec3::ONE);
            let index = writer.mesh(mesh, material);
            writer.root.nodes[node].mesh = Some(index);
            if let Some(skin) = &mesh.skin {
                let joints: Vec<Index> = skin.joint_from_shape.iter().map(|joint| writer.bound_joint(joint)).collect();
                writer.root.nodes[node].children.clone_from(&joints);
                let skin = writer.skin(skin, joints);
                writer.root.nodes[node].skin = Some(skin);
            }
        }
        if !roots.is_empty() {
            writer.root.scenes.push(json::Scene { nodes: roots, ..json::Scene::default() });
            writer.root.scene = Some(0);
        }
        writer.into_glb()
    }
}

impl Writer {
    /// A mesh with one primitive.
    pub fn mesh(&mut self, mesh: &TriangleMesh, material: Index) -> Index {
        let mut attributes = BTreeMap::new();
        let mut attribute = |name: &str, accessor| attributes.insert(name.to_owned(), accessor);
        attribute("POSITION", self.positions(&mesh.positions));
        attribute("NORMAL", self.vectors(&mesh.normals));
        if !mesh.colours.is_empty() {
            attribute("COLOR_0", self.vertex_values(&mesh.colours));
        }
        if !mesh.texture_coordinates.is_empty() {
            attribute("TEXCOORD_0", self.texture_coordinates(&mesh.texture_coordinates));
        }
        if let Some(skin) = &mesh.skin {
            let (joints, weights): (Vec<_>, Vec<_>) =
                skin.joints.iter().zip(&skin.weights).map(|(&joints, &weights)| influences(joints, weights)).unzip();
            attribute("JOINTS_0", self.joints(&joints));
            attribute("WEIGHTS_0", self.vertex_values(&weights));
        }
        let indices = Some(self.indices(&mesh.indices));
        let primitive = json::Primitive { attributes, indices, material: Some(material), ..json::Primitive::default() };
        let mesh = json::Mesh { name: Some(mesh.name.clone()), primitives: vec![primitive], ..json::Mesh::default() };
        self.root.meshes.push(mesh);
        self.root.meshes.len() - 1
    }

    /// A skin whose joints are these nodes.
    pub fn skin(&mut self, skin: &Skin, joints: Vec<Index>) -> Index {
        let matrices = self.matrices(&skin.joint_from_shape);
        self.root.skins.push(json::Skin { inverse_bind_matrices: Some(matrices), joints, ..json::Skin::default() });
        self.root.skins.len() - 1
    }

    /// A node in the place of a joint in the bind pose. Readers need only its inverse bind matrix, so one that no translation, rotation
    /// and scale can say is said as near as they can.
    fn bound_joint(&mut self, joint_from_shape: &Affine3A) -> Index {
        let (scale, rotation, translation) = joint_from_shape.inverse().to_scale_rotation_translation();
        let is_whole = scale.is_finite() && rotation.is_normalized() && translation.is_finite();
        let node = if is_whole {
            json::Node {
                translation: (translation != Vec3::ZERO).then_some(translation.to_array()),
                rotation: (rotation != Quat::IDENTITY).then_some(rotation.to_array()),
                scale: (scale != Vec3::ONE).then_some(scale.to_array()),
                ..json::Node::default()
            }
        } else {
            json::Node::default()
        };
        self.root.nodes.push(node);
        self.root.nodes.len() - 1
    }

    /// A material with the factor of its base colour, in linear light; an equal one that is there already serves again.
    pub fn material(&mut self, material: &Material, base_colour: Vec3) -> Index {
        let mut extensions = Map::new();
        if material.is_unlit {
            extensions.insert(UNLIT.to_owned(), json!({}));
        }
        // Readers of the extension show the base colour alone.
        let emissive = if material.is_unlit { Vec3::ZERO } else { material.emissive };
        // A factor ends at 1; what is brighter has a strength.
        let strength = emissive.max_element().max(1.0);
        if strength > 1.0 {
            extensions.insert(EMISSIVE_STRENGTH.to_owned(), json!({ "emissiveStrength": strength }));
        }
        for name in extensions.keys() {
            if !self.root.extensions_used.contains(name) {
                self.root.extensions_used.push(name.clone());
            }
        }
        let texture = material.texture.as_ref().map(|texture| self.texture(texture));
        let [red, green, blue] = base_colour.to_array();
        let written = json::Material {
            pbr_metallic_roughness: Some(json::MetallicRoughness {
                base_color_factor: Some([red, green, blue, material.opacity]),
                base_color_texture: texture.map(|index| json::TextureInfo { index, ..json::TextureInfo::default() }),
                metallic_factor: Some(material.metallic),
                roughness_factor: Some(material.roughness),
                ..json::MetallicRoughness::default()
            }),
            emissive_factor: (emissive != Vec3::ZERO).then(|| (emissive / strength).to_array()),
            alpha_mode: material.alpha_cutoff.map(|_| "MASK".to_owned()),
            alpha_cutoff: material.alpha_cutoff,
            double_sided: material.is_double_sided.then_some(true),
            extensions,
            ..json::Material::default()
        };
        same_or_new(&mut self.root.materials, written)
    }

    fn texture(&mut self, texture: &Arc<Texture>) -> Index {
        let wrap = |wrap: Wrap| match wrap {
            Wrap::Repeat => 10497,
            Wrap::Mirror => 33648,
            Wrap::Clamp => 33071,
        };
        let filters = if texture.is_pixelated { (NEAREST, NEAREST) } else { (LINEAR, LINEAR_BETWEEN_SMALLER_PICTURES) };
        let sampler = json::Sampler {
            mag_filter: Some(filters.0),
            min_filter: Some(filters.1),
            wrap_s: Some(wrap(texture.wrap[0])),
            wrap_t: Some(wrap(texture.wrap[1])),
        };
        let sampler = same_or_new(&mut self.root.samplers, sampler);
        let source = self.image(&texture.file, texture.media_type);
        let written = json::Texture { sampler: Some(sampler), source: Some(source), ..json::Texture::default() };
        same_or_new(&mut self.root.textures, written)
    }

    fn image(&mut self, file: &[u8], media_type: &str) -> Index {
        if let Some(&image) = self.images.get(file) {
            return image;
        }
        let view = self.picture_view(file);
        let media_type = Some(media_type.to_owned());
        self.root.images.push(json::Image { mime_type: media_type, buffer_view: Some(view), ..json::Image::default() });
        let image = self.root.images.len() - 1;
        self.images.insert(file.to_vec(), image);
        image
    }
}

/// The index of a value in a list, to which it is added if it is not there.
fn same_or_new<T: PartialEq>(list: &mut Vec<T>, value: T) -> Index {
    list.iter().position(|same| *same == value).unwrap_or_else(|| {
        list.push(value);
        list.len() - 1
    })
}

/// A vertex's joints and weights as the specification wants them: no joint twice, joint 0 where the weight is 0, and a sum of 1.
fn influences(mut joints: [u8; 4], mut weights: [f32; 4]) -> ([u8; 4], [f32; 4]) {
    for later in 1..4 {
        if let Some(first) = (0..later).find(|&first| joints[first] == joints[later] && weights[first] > 0.0) {
            weights[first] += weights[later];
            weights[later] = 0.0;
        }
    }
    for (joint, weight) in joints.iter_mut().zip(&weights) {
        if *weight == 0.0 {
            *joint = 0;
        }
    }
    let sum: f32 = weights.iter().sum();
    let count = weights.iter().filter(|weight| **weight > 0.0).count();
    if sum > 0.0 && (sum - 1.0).abs() > WEIGHT_ROUNDING * count as f32 {
        weights = weights.map(|weight| weight / sum);
    }
    (joints, weights)
}
