//! Meshes of triangles, rigid or with a skin.

use std::cell::OnceCell;
use std::sync::{Arc, OnceLock};

use glam::{Affine3A, Vec3};

use super::Solid;
use crate::blend::{self, SkinVertices, SkinnedVertex};
use crate::json::quoted;
use crate::model::{MOST_JOINTS, TriangleMesh, TriangleTree, may_meet_box, meets};
use crate::scene::checks::NodeChecks;
use crate::scene::file::SceneError;
use crate::scene::graph::NodeId;
use crate::scene::shape::MeshKind;

/// A mesh of triangles. Clones share it, and what is computed of it.
#[derive(Clone, Debug)]
pub struct MeshShape {
    mesh: Arc<TriangleMesh>,
    joints: Arc<[NodeId]>,
    measures: Arc<Measures>,
}

/// What is computed of a mesh once.
#[derive(Debug)]
struct Measures {
    half_extents: Vec3,
    /// For each joint of the skin the least and the largest coordinates of the vertices that it moves, in shape space; `None` for none.
    joint_boxes: Vec<Option<[Vec3; 2]>>,
    tree: OnceLock<TriangleTree>,
    skin: OnceLock<SkinVertices>,
}

/// A skin as its joints stand, for the rays of one look at it. Its vertices are moved once, for the first ray that comes near.
#[derive(Clone, Debug)]
pub struct StandingSkin {
    world_from_bind: Vec<Affine3A>,
    /// The box that the joints' boxes reach.
    reach: [Vec3; 2],
    /// The vertices in world space, and the box around them.
    moved: OnceCell<(Vec<SkinnedVertex>, [Vec3; 2])>,
}

/// The box around two.
fn joined([least, most]: [Vec3; 2], [other_least, other_most]: [Vec3; 2]) -> [Vec3; 2] {
    [least.min(other_least), most.max(other_most)]
}

impl PartialEq for MeshShape {
    /// Fast if the two share the mesh.
    fn eq(&self, other: &Self) -> bool {
        (Arc::ptr_eq(&self.mesh, &other.mesh) || self.mesh == other.mesh) && self.joints == other.joints
    }
}

impl MeshShape {
    /// A mesh. If it has a skin, its joints are given to the [`crate::scene::SceneBuilder`].
    #[must_use]
    pub fn new(mesh: Arc<TriangleMesh>) -> Self {
        let measures = Measures {
            half_extents: mesh.half_extents(),
            joint_boxes: joint_boxes(&mesh),
            tree: OnceLock::new(),
            skin: OnceLock::new(),
        };
        Self { mesh, joints: Arc::default(), measures: Arc::new(measures) }
    }

    /// The same mesh moved by these nodes of its scene: as many as its skin has joints.
    pub(in crate::scene) fn with_joints(&self, joints: Arc<[NodeId]>) -> Self {
        Self { joints, ..self.clone() }
    }

    /// The triangles.
    #[must_use]
    pub const fn mesh(&self) -> &Arc<TriangleMesh> {
        &self.mesh
    }

    /// The nodes that move its skin, in the order of [`crate::model::Skin::joint_from_shape`]; none for a rigid mesh.
    #[must_use]
    pub fn joints(&self) -> &[NodeId] {
        &self.joints
    }

    /// For each joint, shape space in the bind pose to world space, where nodes stand as `world_from_node` says.
    pub fn world_from_bind(&self, world_from_node: impl Fn(NodeId) -> Affine3A) -> impl Iterator<Item = Affine3A> {
        let skin = self.mesh.skin.as_ref();
        let joints = self.joints.iter().zip(skin.into_iter().flat_map(|skin| &skin.joint_from_shape));
        joints.map(move |(joint, joint_from_shape)| world_from_node(*joint) * *joint_from_shape)
    }

    /// The least and the largest coordinates that the skin can reach in world space, by the boxes of its joints.
    #[must_use]
    pub fn reach_of_skin(&self, world_from_bind: &[Affine3A]) -> [Vec3; 2] {
        let boxes = self.measures.joint_boxes.iter().zip(world_from_bind);
        let reached = boxes.filter_map(|(of_joint, world_from_bind)| Some(moved_box((*of_joint)?, world_from_bind)));
        reached.reduce(joined).unwrap_or_default()
    }

    /// The vertices of the skin in world space; empty without a skin.
    #[must_use]
    pub fn skinned(&self, world_from_bind: &[Affine3A]) -> Vec<SkinnedVertex> {
        let Some(skin) = self.mesh.skin.as_ref() else { return Vec::new() };
        let vertices = self.measures.skin.get_or_init(|| SkinVertices::new(&self.mesh, skin));
        let mut skinned = Vec::new();
        blend::skin(blend::widest(), vertices, world_from_bind, &mut skinned);
        skinned
    }

    /// The skin for the rays of one look, where the joints stand so.
    #[must_use]
    pub fn standing(&self, world_from_bind: Vec<Affine3A>) -> StandingSkin {
        StandingSkin { reach: self.reach_of_skin(&world_from_bind), world_from_bind, moved: OnceCell::new() }
    }

    /// Where a ray meets the skin, in lengths of `direction`, and the joint that moves it most there; origin and direction in world space.
    #[must_use]
    pub fn enter_skin(&self, skin: &StandingSkin, origin: Vec3, direction: Vec3) -> Option<(f32, NodeId)> {
        let may_meet = |[least, most]: [Vec3; 2]| may_meet_box(least, most, origin, direction.recip(), f32::INFINITY);
        if !may_meet(skin.reach) {
            return None;
        }
        let (vertices, around) = skin.moved.get_or_init(|| {
            let vertices = self.skinned(&skin.world_from_bind);
            let around = vertices.iter().map(|vertex| [Vec3::from(vertex.position); 2]).reduce(joined);
            (vertices, around.unwrap_or_default())
        });
        if !may_meet(*around) {
            return None;
        }
        let met = self.mesh.indices.chunks_exact(3).filter_map(|corners| {
            let triangle = [0, 1, 2].map(|corner| Vec3::from(vertices[corners[corner] as usize].position));
            Some((meets(&triangle, origin, direction)?, corners))
        });
        let (distance, corners) = met.min_by(|(a, _), (b, _)| a.total_cmp(b))?;
        Some((distance, self.strongest_joint(corners)?))
    }

    /// The joint that moves a triangle most.
    fn strongest_joint(&self, corners: &[u32]) -> Option<NodeId> {
        let skin = self.mesh.skin.as_ref()?;
        let mut shares = [0.0; MOST_JOINTS];
        for &corner in corners {
            for (joint, weight) in skin.joints[corner as usize].iter().zip(skin.weights[corner as usize]) {
                shares[usize::from(*joint)] += weight;
            }
        }
        let strongest = (0..self.joints.len()).max_by(|&a, &b| shares[a].total_cmp(&shares[b]).then(b.cmp(&a)))?;
        Some(self.joints[strongest])
    }
}

/// The box of the vertices that each joint moves.
fn joint_boxes(mesh: &TriangleMesh) -> Vec<Option<[Vec3; 2]>> {
    let Some(skin) = &mesh.skin else { return Vec::new() };
    let mut boxes: Vec<Option<[Vec3; 2]>> = vec![None; skin.joint_from_shape.len()];
    for ((&position, joints), weights) in mesh.positions.iter().zip(&skin.joints).zip(&skin.weights) {
        for (&joint, _) in joints.iter().zip(weights).filter(|(_, weight)| **weight > 0.0) {
            if let Some(of_joint) = boxes.get_mut(usize::from(joint)) {
                let [least, most] = of_joint.unwrap_or([position; 2]);
                *of_joint = Some([least.min(position), most.max(position)]);
            }
        }
    }
    boxes
}

/// The axis-aligned box around a moved box.
fn moved_box([least, most]: [Vec3; 2], world_from_bind: &Affine3A) -> [Vec3; 2] {
    let middle = world_from_bind.transform_point3((least + most) * 0.5);
    let half = (most - least) * 0.5;
    let axes = world_from_bind.matrix3;
    let reach = Vec3::from(axes.x_axis.abs() * half.x + axes.y_axis.abs() * half.y + axes.z_axis.abs() * half.z);
    [middle - reach, middle + reach]
}

impl Solid for MeshShape {
    fn name(&self) -> &'static str {
        "mesh"
    }

    fn mesh(&self) -> Option<MeshKind> {
        None
    }

    fn check(&self, checks: NodeChecks<'_>) -> Result<(), SceneError> {
        checks.coordinates("shape.mesh", self.measures.half_extents).map(|_| ())
    }

    fn half_extents(&self) -> Vec3 {
        self.measures.half_extents
    }

    fn reach(&self, direction: Vec3) -> f32 {
        self.mesh.positions.iter().map(|position| position.dot(direction)).fold(f32::NEG_INFINITY, f32::max)
    }

    fn enter(&self, origin: Vec3, direction: Vec3) -> Option<f32> {
        self.measures.tree.get_or_init(|| TriangleTree::new(self.mesh.triangles())).enter(origin, direction)
    }

    fn fields(&self) -> Vec<(&'static str, String)> {
        vec![("name", quoted(&self.mesh.name))]
    }
}
