//! Meshes of a glTF file as shapes below nodes.

use std::collections::{HashMap, HashSet};

use glam::{DAffine3, DMat3, DVec3, Vec3};

use super::tree::TreeNode;
use crate::gltf::json::Index;
use crate::gltf::{Document, GltfError, MeshReader, ReadFile, unique_name};
use crate::model::TriangleMesh;
use crate::words::{Message, texts};

/// A shape of a node.
#[derive(Clone, Debug)]
pub(super) struct MeshPart {
    /// Which of the meshes.
    pub mesh: usize,
    /// The name that it is to have.
    pub name: String,
    /// Where it is in the node's space: its mesh has its origin at the middle of its box. The origin for what joints move.
    pub centre: Vec3,
    /// Linear red, green and blue.
    pub colour: Vec3,
    /// The joints that move it, as nodes of the tree; empty for what moves with its node.
    pub joints: Vec<usize>,
}

/// What makes two shapes have one mesh: the primitive, its skin, and what was done to its vertices.
#[derive(Clone, PartialEq, Eq, Hash)]
struct Source {
    mesh: Index,
    primitive: usize,
    skin: Option<Index>,
    done: [u64; 12],
}

/// All meshes of a scene, and the shapes that show them.
pub(super) struct Parts<'a, 'f> {
    document: &'a Document<'a>,
    reader: MeshReader<'a, 'f>,
    tree: &'a [TreeNode],
    place_of: HashMap<Index, usize>,
    read: HashMap<Source, Option<MeshPart>>,
    names: HashSet<String>,
    /// The meshes, each for a shape or several.
    pub meshes: Vec<TriangleMesh>,
    /// What was left out.
    pub notes: Vec<Message>,
}

impl<'a, 'f> Parts<'a, 'f> {
    pub fn new(document: &'a Document<'a>, read_file: &'a mut ReadFile<'f>, tree: &'a [TreeNode]) -> Self {
        Self {
            document,
            reader: MeshReader::new(document, read_file),
            tree,
            place_of: tree.iter().enumerate().map(|(at, node)| (node.index, at)).collect(),
            read: HashMap::new(),
            names: HashSet::new(),
            meshes: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// The shapes of a node.
    pub fn of_node(&mut self, node: &TreeNode) -> Result<Vec<MeshPart>, GltfError> {
        let json = &self.document.root.nodes[node.index];
        let Some(mesh) = json.mesh.filter(|_| !node.own.is_solid()) else { return Ok(Vec::new()) };
        let Some(primitives) = self.document.root.meshes.get(mesh).map(|mesh| mesh.primitives.len()) else {
            return Err(GltfError::leads_nowhere(super::tree::place(node.index), &format!("/meshes/{mesh}")));
        };
        let skin = match json.skin {
            Some(skin) => self.joints(skin, node)?.map(|joints| (skin, joints)),
            None => None,
        };
        let mut parts = Vec::new();
        for primitive in 0..primitives {
            // Vertices of a skin do not follow their own node.
            let done = if skin.is_some() { DAffine3::IDENTITY } else { node.node_from_mesh };
            let source = Source {
                mesh,
                primitive,
                skin: skin.as_ref().map(|(skin, _)| *skin),
                done: done.to_cols_array().map(f64::to_bits),
            };
            if !self.read.contains_key(&source) {
                let part = self.part(&source, skin.as_ref().map_or(&[], |(_, joints)| joints), node)?;
                self.read.insert(source.clone(), part);
            }
            parts.extend(self.read[&source].clone());
        }
        Ok(parts)
    }

    /// What was left out and simplified by now.
    pub fn into_notes(mut self) -> (Vec<TriangleMesh>, Vec<Message>) {
        self.notes.append(&mut self.reader.notes);
        (self.meshes, self.notes)
    }

    /// The joints of a skin, as nodes of the tree; `None`, with a note, if one is not in this scene.
    fn joints(&mut self, skin: Index, node: &TreeNode) -> Result<Option<Vec<usize>>, GltfError> {
        let Some(json) = self.document.root.skins.get(skin) else {
            return Err(GltfError::leads_nowhere(super::tree::place(node.index), &format!("/skins/{skin}")));
        };
        let joints: Option<Vec<usize>> = json.joints.iter().map(|joint| self.place_of.get(joint).copied()).collect();
        if joints.is_none() {
            self.notes.push(texts::gltf_note_joints_elsewhere(&node.path));
        }
        Ok(joints)
    }

    fn part(&mut self, source: &Source, joints: &[usize], node: &TreeNode) -> Result<Option<MeshPart>, GltfError> {
        let of_file = self.document.root.meshes[source.mesh].name.as_deref();
        let wanted = node.own.mesh_name().or(of_file).unwrap_or_default().to_owned();
        let Some(read) = self.reader.primitive(source.mesh, source.primitive, source.skin, "")? else {
            return Ok(None);
        };
        let mut mesh = read.mesh;
        if mesh.skin.is_none() {
            changed(&mut mesh, node.node_from_mesh);
        }
        let centre = centred(&mut mesh);
        if let Some(skin) = &mut mesh.skin {
            for (matrix, joint) in skin.joint_from_shape.iter_mut().zip(&read.joints) {
                // A mirror below the joint is not in our joint; what is left of it acts here.
                let joint_from_mesh = self.tree[joints[*joint]].node_from_mesh.as_affine3a() * *matrix;
                *matrix = joint_from_mesh * glam::Affine3A::from_translation(centre);
            }
        }
        if !is_finite(&mesh) {
            return Err(GltfError::new(format!("/meshes/{}", source.mesh), texts::GLTF_IN_NOT_FINITE));
        }
        mesh.name = unique_name(&wanted.replace('/', "_"), "mesh", &mut self.names);
        let part = MeshPart {
            mesh: self.meshes.len(),
            // Joints alone place what they move.
            centre: if mesh.skin.is_some() { Vec3::ZERO } else { centre },
            name: if wanted.is_empty() { "mesh".to_owned() } else { wanted.replace('/', "_") },
            colour: read.colour,
            joints: if mesh.skin.is_some() {
                read.joints.iter().map(|&joint| joints[joint]).collect()
            } else {
                Vec::new()
            },
        };
        self.meshes.push(mesh);
        Ok(Some(part))
    }
}

/// Whether products of a mesh's numbers with transforms are numbers still.
fn is_finite(mesh: &TriangleMesh) -> bool {
    let matrices = mesh.skin.iter().flat_map(|skin| &skin.joint_from_shape);
    let are_coordinates = mesh.texture_coordinates.iter().all(|coordinates| coordinates.is_finite());
    are_coordinates
        && mesh.positions.iter().all(|position| position.is_finite())
        && matrices.copied().all(|matrix| matrix.is_finite())
}

/// Applies a transform to a mesh.
fn changed(mesh: &mut TriangleMesh, by: DAffine3) {
    if by == DAffine3::IDENTITY {
        return;
    }
    let determinant = by.matrix3.determinant();
    // Where the transform flattens the mesh, normals stay.
    let of_normals = if determinant == 0.0 { DMat3::IDENTITY } else { by.matrix3.inverse().transpose() };
    for position in &mut mesh.positions {
        *position = by.transform_point3(position.as_dvec3()).as_vec3();
    }
    for normal in &mut mesh.normals {
        *normal = (of_normals * normal.as_dvec3()).normalize_or(DVec3::Y).as_vec3();
    }
    if determinant < 0.0 {
        mesh.indices.chunks_exact_mut(3).for_each(|triangle| triangle.swap(1, 2));
    }
}

/// Moves a mesh so that its origin is at the middle of its box, and says where that was.
fn centred(mesh: &mut TriangleMesh) -> Vec3 {
    let least = mesh.positions.iter().copied().reduce(Vec3::min).unwrap_or_default();
    let most = mesh.positions.iter().copied().reduce(Vec3::max).unwrap_or_default();
    let centre = least.midpoint(most);
    // What is at the middle but for rounding stays to the bit.
    if centre.abs().max_element() <= 1e-6 * (most - least).max_element() {
        return Vec3::ZERO;
    }
    mesh.positions.iter_mut().for_each(|position| *position -= centre);
    centre
}
