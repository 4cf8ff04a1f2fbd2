//! Primitives as triangle meshes (glTF 2.0, section 3.7), and the library of a scene's meshes.

use std::collections::{BTreeMap, HashSet};
use std::hash::BuildHasher;
use std::sync::Arc;

use glam::{Affine3A, Mat4, Vec2, Vec3, Vec4};

use super::document::{Document, GltfError, ReadFile};
use super::json::{Index, Primitive};
use super::materials::{MaterialRead, MaterialReader};
use super::skins::Weights;
use crate::model::{MOST_TRIANGLES, Material, MeshLibrary, Skin, TriangleMesh};
use crate::words::{Message, all_of, texts};

/// A primitive that was read.
#[derive(Clone, Debug)]
pub struct PrimitiveMesh {
    /// Its triangles in the space of the glTF mesh, with a name of the caller's.
    pub mesh: TriangleMesh,
    /// The factor of its base colour: linear red, green and blue.
    pub colour: Vec3,
    /// Of the skin's joints those that the mesh's skin has, in its order.
    pub joints: Vec<usize>,
}

/// Reads primitives.
pub struct MeshReader<'a, 'f> {
    document: &'a Document<'a>,
    materials: MaterialReader<'a, 'f>,
    read_materials: BTreeMap<Index, MaterialRead>,
    /// What was left out and simplified so far, each thing once.
    pub notes: Vec<Message>,
}

impl<'a, 'f> MeshReader<'a, 'f> {
    /// A reader of a file's primitives; `read_file` reads pictures beside it.
    pub fn new(document: &'a Document<'a>, read_file: &'a mut ReadFile<'f>) -> Self {
        let materials = MaterialReader::new(document, read_file);
        Self { document, materials, read_materials: BTreeMap::new(), notes: Vec::new() }
    }

    /// Reads a primitive of a mesh, moved by a skin if one is given; `None`, with a note, if it has no triangles.
    ///
    /// # Errors
    /// [`GltfError`]: something leads nowhere, or is too large, or contradicts itself.
    pub fn primitive(
        &mut self,
        mesh: Index,
        primitive: Index,
        skin: Option<Index>,
        name: &str,
    ) -> Result<Option<PrimitiveMesh>, GltfError> {
        let at = format!("/meshes/{mesh}/primitives/{primitive}");
        let json = self.document.root.meshes.get(mesh).and_then(|mesh| mesh.primitives.get(primitive));
        let json = json.ok_or_else(|| GltfError::leads_nowhere("/meshes", &at))?;
        let mut notes = std::mem::take(&mut self.notes);
        let read = self.read(json, skin, name, &at, &mut notes);
        let mut seen = HashSet::new();
        notes.retain(|note| seen.insert(note.to_string()));
        self.notes = notes;
        read
    }

    fn read(
        &mut self,
        json: &Primitive,
        skin: Option<Index>,
        name: &str,
        at: &str,
        notes: &mut Vec<Message>,
    ) -> Result<Option<PrimitiveMesh>, GltfError> {
        let document = self.document;
        let mode = json.mode.unwrap_or(4);
        if mode > 6 {
            return Err(GltfError::new(at, texts::gltf_mode(mode)));
        }
        if mode < 4 {
            notes.push(texts::gltf_note_no_triangles(at));
            return Ok(None);
        }
        let Some(&positions) = json.attributes.get("POSITION") else {
            notes.push(texts::gltf_note_no_positions(at));
            return Ok(None);
        };
        let positions: Vec<Vec3> = vectors(document.floats(positions)?);
        let attribute = Attributes { document, json, at, count: positions.len() };
        let indices = indices(document, json, mode, positions.len(), at)?;
        if indices.is_empty() {
            notes.push(texts::gltf_note_empty(at));
            return Ok(None);
        }
        let MaterialRead { mut material, colour, coordinates, coordinates_moved } = self.material(json, notes)?;
        let mut texture_coordinates: Vec<Vec2> = attribute.vectors(&format!("TEXCOORD_{coordinates}"))?;
        if let Some((turned, moved)) = coordinates_moved {
            for at in &mut texture_coordinates {
                *at = turned * *at + moved;
            }
        }
        if material.texture.is_some() && texture_coordinates.is_empty() {
            material.texture = None;
            notes.push(texts::gltf_note_without_coordinates(at));
        }
        attribute.note_left_out(coordinates, skin.is_some(), notes);
        let mut joints = Vec::new();
        let mesh = TriangleMesh {
            name: name.to_owned(),
            normals: attribute.vectors("NORMAL")?,
            colours: attribute.colours()?,
            texture_coordinates,
            skin: match skin {
                Some(skin) => self.skin(&attribute, skin, &mut joints, notes)?,
                None => None,
            },
            positions,
            indices,
            material,
        };
        if mesh.normals.is_empty() {
            notes.push(texts::gltf_note_normals(at));
        }
        Ok(Some(PrimitiveMesh { mesh: with_unit_normals(mesh), colour, joints }))
    }

    fn material(&mut self, json: &Primitive, notes: &mut Vec<Message>) -> Result<MaterialRead, GltfError> {
        let Some(index) = json.material else {
            let material = Material::default();
            return Ok(MaterialRead { material, colour: Vec3::ONE, coordinates: 0, coordinates_moved: None });
        };
        if let Some(read) = self.read_materials.get(&index) {
            return Ok(read.clone());
        }
        let read = self.materials.material(index, notes)?;
        self.read_materials.insert(index, read.clone());
        Ok(read)
    }

    /// The skin of a primitive, if it has weights. `joints` gets the joints that it has, of the skin's.
    fn skin(
        &self,
        attribute: &Attributes<'_>,
        skin: Index,
        joints: &mut Vec<usize>,
        notes: &mut Vec<Message>,
    ) -> Result<Option<Skin>, GltfError> {
        let place = format!("/skins/{skin}");
        let json = self.document.root.skins.get(skin).ok_or_else(|| GltfError::leads_nowhere(attribute.at, &place))?;
        let mut weights = Weights::new(json.joints.len());
        for set in 0.. {
            let (joints, strengths) = (format!("JOINTS_{set}"), format!("WEIGHTS_{set}"));
            let (Some(of), Some(by)) = (attribute.find(&joints), attribute.find(&strengths)) else { break };
            let (of, by) = (self.document.wholes::<4>(of)?, self.document.floats::<4>(by)?);
            attribute.check_count(&joints, of.len())?;
            attribute.check_count(&strengths, by.len())?;
            weights.add(of, by);
        }
        let Some((skin, used)) = weights.finish(attribute.at, notes)? else { return Ok(None) };
        let matrices: Vec<Affine3A> = match json.inverse_bind_matrices {
            None => vec![Affine3A::IDENTITY; json.joints.len()],
            Some(accessor) => {
                let matrices = self.document.floats::<16>(accessor)?;
                if matrices.len() < json.joints.len() {
                    let problem = texts::gltf_bind_matrices(matrices.len(), json.joints.len());
                    return Err(GltfError::new(place, problem));
                }
                matrices
                    .iter()
                    .enumerate()
                    .map(|(index, matrix)| affine(matrix, index, &place))
                    .collect::<Result<_, _>>()?
            }
        };
        let joint_from_shape = used.iter().map(|&joint| matrices[joint]).collect();
        *joints = used;
        Ok(Some(Skin { joint_from_shape, ..skin }))
    }
}

/// An inverse bind matrix.
fn affine(columns: &[f32; 16], index: usize, at: &str) -> Result<Affine3A, GltfError> {
    let matrix = Mat4::from_cols_array(columns);
    if (matrix.row(3) - Vec4::W).abs().max_element() > 1e-3 {
        return Err(GltfError::new(at, texts::gltf_bind_matrix(index)));
    }
    Ok(Affine3A::from_mat4(matrix))
}

/// The attributes of a primitive.
struct Attributes<'a> {
    document: &'a Document<'a>,
    json: &'a Primitive,
    at: &'a str,
    count: usize,
}

impl Attributes<'_> {
    fn find(&self, name: &str) -> Option<Index> {
        self.json.attributes.get(name).copied()
    }

    fn check_count(&self, name: &str, found: usize) -> Result<(), GltfError> {
        if found == self.count {
            return Ok(());
        }
        Err(GltfError::new(self.at, texts::gltf_vertex_count(name, found, self.count)))
    }

    /// The vectors of an attribute; none if the primitive does not have it.
    fn vectors<const N: usize, V: From<[f32; N]>>(&self, name: &str) -> Result<Vec<V>, GltfError> {
        let Some(accessor) = self.find(name) else { return Ok(Vec::new()) };
        let found = vectors(self.document.floats(accessor)?);
        self.check_count(name, found.len())?;
        Ok(found)
    }

    /// The colours, with or without opacities.
    fn colours(&self) -> Result<Vec<Vec4>, GltfError> {
        let Some(accessor) = self.find("COLOR_0") else { return Ok(Vec::new()) };
        let mut colours: Vec<Vec4> = if self.document.accessor(accessor)?.kind == "VEC3" {
            self.vectors("COLOR_0")?.into_iter().map(|colour: Vec3| colour.extend(1.0)).collect()
        } else {
            self.vectors("COLOR_0")?
        };
        for colour in &mut colours {
            *colour = colour.clamp(Vec4::ZERO, Vec4::ONE);
        }
        Ok(colours)
    }

    /// Notes what is not drawn.
    fn note_left_out(&self, coordinates: u32, is_skinned: bool, notes: &mut Vec<Message>) {
        if !self.json.targets.is_empty() {
            notes.push(texts::gltf_note_targets(self.at));
        }
        let coordinates = format!("TEXCOORD_{coordinates}");
        let is_read = |name: &str| {
            let of_skin = name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
            matches!(name, "POSITION" | "NORMAL" | "COLOR_0") || name == coordinates || (of_skin && is_skinned)
        };
        // Tangents only serve bumps, and first coordinates that no texture has are no loss.
        let left: Vec<&str> = self.json.attributes.keys().map(String::as_str).collect();
        let left: Vec<&str> =
            left.into_iter().filter(|name| !is_read(name) && !matches!(*name, "TANGENT" | "TEXCOORD_0")).collect();
        if !left.is_empty() {
            notes.push(texts::gltf_note_attributes(self.at, all_of(&left)));
        }
    }
}

fn vectors<const N: usize, V: From<[f32; N]>>(numbers: Vec<[f32; N]>) -> Vec<V> {
    numbers.into_iter().map(V::from).collect()
}

/// Three indices a triangle, of triangles, a strip or a fan.
fn indices(
    document: &Document<'_>,
    json: &Primitive,
    mode: u32,
    vertices: usize,
    at: &str,
) -> Result<Vec<u32>, GltfError> {
    let list: Vec<u32> = match json.indices {
        Some(accessor) => document.wholes::<1>(accessor)?.into_iter().map(|[index]| index).collect(),
        None => (0..vertices as u32).collect(),
    };
    if let Some(index) = list.iter().find(|index| **index as usize >= vertices) {
        return Err(GltfError::new(at, texts::gltf_index(*index, vertices)));
    }
    let triangles = if mode == 4 { list.len() / 3 } else { list.len().saturating_sub(2) };
    if triangles > MOST_TRIANGLES {
        return Err(GltfError::new(at, texts::gltf_too_many_triangles(triangles, MOST_TRIANGLES)));
    }
    Ok(match mode {
        5 => (0..triangles).flat_map(|at| [at, at + 1 + at % 2, at + 2 - at % 2].map(|at| list[at])).collect(),
        6 => (0..triangles).flat_map(|at| [at + 1, at + 2, 0].map(|at| list[at])).collect(),
        _ => list.into_iter().take(triangles * 3).collect(),
    })
}

/// The mesh with normals of unit length; without any, with vertices of their own and a flat normal for each triangle.
fn with_unit_normals(mut mesh: TriangleMesh) -> TriangleMesh {
    if !mesh.normals.is_empty() {
        for normal in &mut mesh.normals {
            // What is of unit length stays to the bit.
            if (normal.length_squared() - 1.0).abs() > 1e-5 {
                *normal = normal.normalize_or(Vec3::Y);
            }
        }
        return mesh;
    }
    let corners = std::mem::take(&mut mesh.indices);
    mesh.positions = taken(&mesh.positions, &corners);
    mesh.colours = taken(&mesh.colours, &corners);
    mesh.texture_coordinates = taken(&mesh.texture_coordinates, &corners);
    if let Some(skin) = &mut mesh.skin {
        skin.joints = taken(&skin.joints, &corners);
        skin.weights = taken(&skin.weights, &corners);
    }
    mesh.indices = (0..corners.len() as u32).collect();
    mesh.normals = mesh.triangles().flat_map(|[a, b, c]| [(b - a).cross(c - a).normalize_or(Vec3::Y); 3]).collect();
    mesh
}

/// The values of some vertices; none if there are none.
fn taken<T: Copy>(values: &[T], vertices: &[u32]) -> Vec<T> {
    if values.is_empty() { Vec::new() } else { vertices.iter().map(|&vertex| values[vertex as usize]).collect() }
}

impl MeshLibrary {
    /// Reads a binary glTF file as a library: each primitive with triangles is a mesh. A mesh has its glTF mesh's name; where that is
    /// empty or taken, a number is added. A mesh whose node has a skin is skinned. Pictures outside the file are left out.
    ///
    /// # Errors
    /// [`GltfError`]
    pub fn from_glb(glb: impl Into<Arc<[u8]>>) -> Result<Self, GltfError> {
        let glb = glb.into();
        let document = Document::read(&glb, &mut |_| Err(texts::GLTF_FILE_ALONE.into()))?;
        let mut no_files = |_: &str| Err(Message::from(texts::GLTF_FILE_ALONE));
        let mut reader = MeshReader::new(&document, &mut no_files);
        let mut names = HashSet::new();
        let mut meshes = Vec::new();
        for (mesh, json) in document.root.meshes.iter().enumerate() {
            let skin = document.root.nodes.iter().find(|node| node.mesh == Some(mesh)).and_then(|node| node.skin);
            for primitive in 0..json.primitives.len() {
                let name = unique_name(json.name.as_deref().unwrap_or_default(), "mesh", &mut names);
                let read = reader.primitive(mesh, primitive, skin, &name)?;
                meshes.extend(read.map(|read| Arc::new(read.mesh)));
            }
        }
        Ok(Self { glb: Arc::clone(&glb), meshes })
    }
}

/// A name that is not taken yet: the wanted one, `otherwise` in place of an empty one, with a number if needed.
pub fn unique_name(wanted: &str, otherwise: &str, taken: &mut HashSet<String, impl BuildHasher>) -> String {
    let wanted = if wanted.is_empty() { otherwise } else { wanted };
    let mut name = wanted.to_owned();
    let mut number = 1;
    while !taken.insert(name.clone()) {
        number += 1;
        name = format!("{wanted}_{number}");
    }
    name
}
