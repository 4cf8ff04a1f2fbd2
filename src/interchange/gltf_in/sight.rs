//! Where a model is put so that it is seen: its size, the ground below it, an eye before it.

use std::collections::HashSet;

use glam::{DAffine3, DQuat, DVec3, Mat3A, Vec3, Vec3A};
use serde_json::{Value, json};

use super::scene::{rotation, vector, with_children};
use super::shapes::MeshPart;
use super::tree::TreeNode;
use crate::gltf::unique_name;
use crate::model::TriangleMesh;

/// The sizes in scene units that need no change.
const FITTING: std::ops::RangeInclusive<f64> = 0.4..=12.0;
/// The size that others are brought near to, by a power of ten.
const WANTED: f64 = 2.0;
/// The vertical field of view of an eye that is made, in degrees.
pub(super) const FOV_DEGREES: f32 = 60.0;
/// The ground of the scenes that come with the program.
const GROUND: (f64, &str) = (400.0, "#7d8791");

/// An axis-aligned box in world space.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    least: DVec3,
    most: DVec3,
}

impl Bounds {
    fn of(points: impl Iterator<Item = DVec3>) -> Option<Self> {
        points.map(|point| Self { least: point, most: point }).reduce(Self::with)
    }

    fn with(self, other: Self) -> Self {
        Self { least: self.least.min(other.least), most: self.most.max(other.most) }
    }

    fn size(self) -> f64 {
        (self.most - self.least).max_element()
    }

    /// Whether it is a floor rather than a thing.
    fn is_flat(self) -> bool {
        let size = self.most - self.least;
        size.y <= 1e-3 * size.x.min(size.z)
    }
}

/// Where a model is seen.
#[derive(Clone, Debug)]
pub(super) struct Sight {
    /// The largest extent of the model in its own units, above 0.
    pub size: f64,
    /// The factor of the control node above the model; 1 without one.
    pub factor: f64,
    /// The name of that node.
    scale_name: String,
    /// The name of the ground, and how high it is in scene units.
    ground: Option<(String, f64)>,
    /// The name of the eye that is made, and where it is.
    pub eye: Option<(String, DVec3, DQuat)>,
}

impl Sight {
    /// Looks at a tree at rest. `has_eyes`: whether the file has cameras. `is_own`: whether this program made the file, with all of it.
    pub fn of(
        tree: &[TreeNode],
        world: &[DAffine3],
        shapes: &[Vec<MeshPart>],
        meshes: &[TriangleMesh],
        has_eyes: bool,
        is_own: bool,
    ) -> Self {
        let mut boxes: Vec<Bounds> = Vec::new();
        for (at, parts) in shapes.iter().enumerate() {
            boxes.extend(parts.iter().filter_map(|part| bounds(&meshes[part.mesh], part, world[at], world)));
        }
        if boxes.is_empty() {
            boxes.extend(Bounds::of(world.iter().map(|node| node.translation)));
        }
        let (floors, things): (Vec<Bounds>, Vec<Bounds>) = boxes.into_iter().partition(|bounds| bounds.is_flat());
        let whole = things.iter().copied().reduce(Bounds::with).or_else(|| floors.iter().copied().reduce(Bounds::with));
        let whole = whole.filter(|whole| whole.least.is_finite() && whole.most.is_finite());
        let whole = whole.unwrap_or(Bounds { least: DVec3::splat(-0.5), most: DVec3::splat(0.5) });
        let size = if whole.size() > 0.0 { whole.size() } else { 1.0 };
        let factor = if is_own || FITTING.contains(&size) {
            1.0
        } else {
            10.0_f64.powi(((WANTED / size).log10().round() as i32).clamp(-6, 6))
        };
        let mut names: HashSet<String> =
            tree.iter().filter(|node| node.parent.is_none()).map(|node| node.name.clone()).collect();
        let stands = |floor: &Bounds| {
            let middle = whole.least.midpoint(whole.most);
            let is_below = floor.most.y <= whole.least.y + 0.05 * size;
            is_below && floor.size() > size && (floor.least.x..=floor.most.x).contains(&middle.x)
        };
        let has_floor = !things.is_empty() && floors.iter().any(stands);
        let ground =
            (!is_own && !has_floor).then(|| (unique_name("ground", "ground", &mut names), whole.least.y * factor));
        let eye = (!has_eyes).then(|| {
            let middle = whole.least.midpoint(whole.most) * factor;
            let radius = (whole.most - whole.least).length() / 2.0 * factor;
            let radius = if radius > 0.0 { radius } else { 1.0 };
            let back = DVec3::new(0.0, 0.25, 1.0).normalize();
            let distance = 1.05 * radius / f64::from(FOV_DEGREES / 2.0).to_radians().sin();
            let turn = DQuat::from_rotation_x(-back.y.asin());
            (unique_name("sky", "sky", &mut names), middle + back * distance, turn)
        });
        Self { size, factor, scale_name: unique_name("scale", "scale", &mut names), ground, eye }
    }

    /// The model's roots with what is around them.
    pub fn around(&self, roots: Vec<Value>) -> Vec<Value> {
        let mut nodes = Vec::new();
        if let Some((name, at, turn)) = &self.eye {
            nodes.push(json!({ "name": name, "translation": vector(*at), "rotation": rotation(*turn) }));
        }
        if let Some((name, height)) = &self.ground {
            let (size, colour) = GROUND;
            let plane = json!({
                "name": "plane",
                "shape": { "plane": { "size": [size, size] } },
                "colour": colour,
                "translation": vector(DVec3::new(0.0, *height, 0.0)),
            });
            nodes.push(with_children(json!({ "name": name }), vec![plane]));
        }
        if self.factor == 1.0 || roots.is_empty() {
            nodes.extend(roots);
        } else {
            let control = json!({ "scale": [[0, self.factor]] });
            let node = json!({ "name": self.scale_name, "control": control, "in_paths": false });
            nodes.push(with_children(node, roots));
        }
        nodes
    }
}

/// The box around a shape in world space.
fn bounds(mesh: &TriangleMesh, part: &MeshPart, world_from_node: DAffine3, world: &[DAffine3]) -> Option<Bounds> {
    let Some(skin) = &mesh.skin else {
        let (centre, half) = (part.centre.as_dvec3(), mesh.half_extents().as_dvec3());
        let corners = (0..8).map(|corner| {
            let sign = |bit: u32| if corner & bit == 0 { -1.0 } else { 1.0 };
            world_from_node.transform_point3(centre + half * DVec3::new(sign(1), sign(2), sign(4)))
        });
        return Bounds::of(corners);
    };
    let matrices: Vec<glam::Affine3A> = part
        .joints
        .iter()
        .zip(&skin.joint_from_shape)
        .map(|(&joint, joint_from_shape)| world[joint].as_affine3a() * *joint_from_shape)
        .collect();
    let moved =
        mesh.positions.iter().zip(skin.joints.iter().zip(&skin.weights)).map(|(position, (joints, weights))| {
            let mut linear = Mat3A::ZERO;
            let mut translation = Vec3A::ZERO;
            for (joint, weight) in joints.iter().zip(weights) {
                linear += matrices[usize::from(*joint)].matrix3 * *weight;
                translation += matrices[usize::from(*joint)].translation * *weight;
            }
            Vec3::from(linear * Vec3A::from(*position) + translation).as_dvec3()
        });
    Bounds::of(moved)
}
