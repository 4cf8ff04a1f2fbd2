//! The node tree of one scene of a glTF file: checked, in pre-order, with rigid transforms and scales above 0.
//!
//! A mirroring scale has no place in our scenes, so it is moved down to the meshes: below a mirror P each transform M becomes P M P, and
//! what remains at the end, P, is applied to the vertices. Poses stay rigid, and the picture is the same.

use std::collections::HashSet;

use glam::{DAffine3, DMat3, DMat4, DQuat, DVec3};

use super::own::{Kind, OwnNode};
use crate::gltf::json::{self, Index, Root};
use crate::gltf::{GltfError, unique_name};
use crate::scene::MOST_LEVELS;
use crate::words::texts;

/// How far the axes of a matrix may be from right angles and still be taken as a rotation and a scale.
const SHEAR_BOUND: f64 = 1e-4;
/// The least factor of a scale: 0 hides a part, and a scene's scales are above 0.
pub(super) const LEAST_SCALE: f64 = 1e-6;
/// Scales that differ by less, in parts, are one scale.
pub(super) const SAME_SCALE: f64 = 1e-5;

/// How far each factor of a scale may be from 1 and still be what rounding has made of 1. It moves a point by less than that part of the
/// size of the model, for each such node above it.
pub(super) const ROUNDED_ONE: f64 = 1e-5;

/// A node of the scene.
#[derive(Clone, Debug)]
pub(super) struct TreeNode {
    /// Its index in the file.
    pub index: Index,
    /// The node above it, in the tree.
    pub parent: Option<usize>,
    /// How many are above it.
    pub depth: usize,
    /// Its name: not empty, without `/`, like that of no sibling.
    pub name: String,
    /// The names from the root down to it, joined by `/`, without those that are not part of paths.
    pub path: String,
    /// What the file says that it was.
    pub own: OwnNode,
    /// `parent_from_node`: translation, rotation, scale. The scale's factors are above 0.
    pub rest: Trs,
    /// From the mesh's space to this node's: the mirror that remains, and what no rotation and scale can say.
    pub node_from_mesh: DAffine3,
    /// How its animation is changed.
    pub change: Change,
    /// The nodes below it, in the tree.
    pub children: Vec<usize>,
    /// How far the scale of the file is from that of the rest, which is 1 for it; most often 0.
    pub rounded_by: f64,
}

impl TreeNode {
    /// Sets the scale of the rest. One that is rounding away from 1 is 1, so that it needs no control node; control nodes and shapes of our
    /// own have any scale.
    pub fn set_scale(&mut self, scale: DVec3) {
        let off = (scale - DVec3::ONE).abs().max_element();
        let is_one = self.own.kind == Kind::Rbt && off <= ROUNDED_ONE;
        self.rounded_by = if is_one { off } else { 0.0 };
        self.rest.scale = if is_one { DVec3::ONE } else { scale };
    }

    /// Whether the paths of the nodes below contain its name.
    pub fn is_in_paths(&self) -> bool {
        self.own.kind != Kind::Control { is_in_paths: false }
    }
}

/// A translation, a rotation and a scale: scaled first, translated last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Trs {
    pub translation: DVec3,
    pub rotation: DQuat,
    pub scale: DVec3,
}

impl Trs {
    pub fn to_affine(self) -> DAffine3 {
        DAffine3::from_scale_rotation_translation(self.scale, self.rotation, self.translation)
    }
}

/// What mirrors above and in a node do to its translations and rotations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Change {
    /// The mirror above it: 1 or −1 along each axis, with an odd number of −1 or none.
    mirror: DVec3,
    /// The signs of its own scale.
    pub signs: DVec3,
    /// A half turn that remains of both.
    turn: DQuat,
    /// The mirror below it.
    below: DVec3,
}

impl Change {
    fn new(mirror: DVec3, signs: DVec3) -> Self {
        let both = mirror * signs;
        let is_mirror = both.element_product() < 0.0;
        // Two axes that are turned around are a half turn about the third.
        let turn = match both.to_array() {
            [_, -1.0, -1.0] if !is_mirror => DQuat::from_xyzw(1.0, 0.0, 0.0, 0.0),
            [-1.0, _, -1.0] if !is_mirror => DQuat::from_xyzw(0.0, 1.0, 0.0, 0.0),
            [-1.0, -1.0, _] if !is_mirror => DQuat::from_xyzw(0.0, 0.0, 1.0, 0.0),
            _ => DQuat::IDENTITY,
        };
        Self { mirror, signs, turn, below: if is_mirror { both } else { DVec3::ONE } }
    }

    pub fn translation(self, translation: DVec3) -> DVec3 {
        self.mirror * translation
    }

    pub fn rotation(self, rotation: DQuat) -> DQuat {
        let vector = rotation.xyz() * self.mirror * self.mirror.element_product();
        let mirrored = DQuat::from_xyzw(vector.x, vector.y, vector.z, rotation.w);
        if self.turn == DQuat::IDENTITY { mirrored } else { mirrored * self.turn }
    }
}

/// The nodes of one scene, each before those below it.
///
/// # Errors
/// [`GltfError`]: an index that leads nowhere, a cycle, a node below two others, too many levels, a transform that no scene can have.
pub(super) fn tree(root: &Root, scene: Option<Index>) -> Result<Vec<TreeNode>, GltfError> {
    let parents = parents(root)?;
    let roots: Vec<Index> = match scene {
        Some(scene) => root.scenes[scene].nodes.clone(),
        None => (0..root.nodes.len()).filter(|&node| parents[node].is_none()).collect(),
    };
    let scene_place = || format!("/scenes/{}", scene.unwrap_or(0));
    let mut seen = HashSet::new();
    for &node in &roots {
        match parents.get(node) {
            None => return Err(GltfError::leads_nowhere(scene_place(), &place(node))),
            Some(Some(_)) => return Err(GltfError::new(place(node), texts::GLTF_IN_ROOT_WITH_PARENT)),
            Some(None) if !seen.insert(node) => {
                return Err(GltfError::new(scene_place(), texts::gltf_in_twice(place(node))));
            }
            Some(None) => {}
        }
    }
    let moved = moved_nodes(root);
    let mut nodes: Vec<TreeNode> = Vec::new();
    // The names below a node that is not part of paths are among those beside it.
    let mut names: Vec<HashSet<String>> = vec![HashSet::new()];
    let mut names_below: Vec<usize> = Vec::new();
    let mut open: Vec<(Index, Option<usize>)> = roots.into_iter().rev().map(|node| (node, None)).collect();
    // Shapes whose joints alone place them stand apart in our own files: they go back to where they were.
    let mut apart: Vec<Index> = Vec::new();
    let mut is_whole = false;
    loop {
        let Some((index, parent)) = open.pop() else {
            if is_whole {
                return Ok(nodes);
            }
            is_whole = true;
            let owner = |index: &Index| {
                let above = OwnNode::of(&root.nodes[*index], false).path_above()?.to_owned();
                nodes.iter().position(|node| node.path == above && node.own.kind != Kind::Shape)
            };
            open.extend(apart.iter().rev().map(|index| (*index, owner(index))));
            continue;
        };
        let at = nodes.len();
        let above = parent.map(|parent| &nodes[parent]);
        let depth = above.map_or(0, |above| above.depth + 1);
        if depth >= MOST_LEVELS {
            return Err(GltfError::new(place(index), texts::gltf_in_too_deep(MOST_LEVELS)));
        }
        let json = &root.nodes[index];
        let own = OwnNode::of(json, moved.contains(&index));
        if own.kind == Kind::Root && parent.is_none() {
            open.extend(json.children.iter().rev().map(|&child| (child, None)));
            continue;
        }
        if own.kind == Kind::Shape && json.skin.is_some() && parent.is_none() && !is_whole {
            apart.push(index);
            continue;
        }
        let is_in_paths = own.kind != Kind::Control { is_in_paths: false };
        let beside = parent.map_or(0, |parent| names_below[parent]);
        let wanted = own.name().or(json.name.as_deref()).unwrap_or_default().replace('/', "_");
        let name = unique_name(&wanted, &format!("node_{index}"), &mut names[beside]);
        let named_above =
            std::iter::successors(above, |node| Some(&nodes[node.parent?])).find(|node| node.is_in_paths());
        let path = named_above.map_or_else(|| name.clone(), |above| format!("{}/{name}", above.path));
        let mirror = above.map_or(DVec3::ONE, |above| above.change.below);
        let is_leaf = json.children.is_empty() && !moved.contains(&index) && json.camera.is_none();
        let (rest, change, node_from_mesh) = transform(json, index, &path, mirror, is_leaf)?;
        if let Some(parent) = parent {
            nodes[parent].children.push(at);
        }
        let mut node = TreeNode {
            index,
            parent,
            depth,
            name,
            path,
            own,
            rest,
            node_from_mesh,
            change,
            children: Vec::new(),
            rounded_by: 0.0,
        };
        node.set_scale(rest.scale);
        nodes.push(node);
        names_below.push(if is_in_paths { names.len() } else { beside });
        if is_in_paths {
            names.push(HashSet::new());
        }
        open.extend(json.children.iter().rev().map(|&child| (child, Some(at))));
    }
}

/// The most that scales taken as 1 move any point, in parts of the model's size.
pub(super) fn most_rounded(tree: &[TreeNode]) -> f64 {
    let mut sums: Vec<f64> = Vec::with_capacity(tree.len());
    for node in tree {
        sums.push(node.rounded_by + node.parent.map_or(0.0, |parent| sums[parent]));
    }
    sums.into_iter().fold(0.0, f64::max)
}

/// A node's place in the JSON.
pub(super) fn place(node: Index) -> String {
    format!("/nodes/{node}")
}

/// The node above each one.
fn parents(root: &Root) -> Result<Vec<Option<Index>>, GltfError> {
    let mut parents = vec![None; root.nodes.len()];
    for (index, node) in root.nodes.iter().enumerate() {
        for &child in &node.children {
            match parents.get_mut(child) {
                None => return Err(GltfError::leads_nowhere(place(index), &place(child))),
                Some(Some(first)) => {
                    let problem = texts::gltf_in_two_parents(place(*first), place(index));
                    return Err(GltfError::new(place(child), problem));
                }
                Some(parent) => *parent = Some(index),
            }
        }
    }
    // Each node has at most one parent, so nodes that no root leads to go in a circle.
    let mut is_reached: Vec<bool> = parents.iter().map(Option::is_none).collect();
    let mut open: Vec<Index> = (0..parents.len()).filter(|&node| is_reached[node]).collect();
    while let Some(node) = open.pop() {
        for &child in &root.nodes[node].children {
            is_reached[child] = true;
            open.push(child);
        }
    }
    match is_reached.iter().position(|is_reached| !is_reached) {
        Some(node) => Err(GltfError::new(place(node), texts::GLTF_IN_CYCLE)),
        None => Ok(parents),
    }
}

/// The nodes that animations or skins move: they are more than places of meshes.
fn moved_nodes(root: &Root) -> HashSet<Index> {
    let animated = root.animations.iter().flat_map(|animation| &animation.channels);
    let animated = animated.filter_map(|channel| channel.target.node);
    animated.chain(root.skins.iter().flat_map(|skin| skin.joints.iter().copied())).collect()
}

/// A node's transform, below a mirror.
fn transform(
    json: &json::Node,
    index: Index,
    path: &str,
    mirror: DVec3,
    is_leaf: bool,
) -> Result<(Trs, Change, DAffine3), GltfError> {
    let (trs, sheared) = match json.matrix {
        None => (of_fields(json, index)?, None),
        Some(matrix) => decomposed(&matrix.map(f64::from)),
    };
    if sheared.is_some() && !is_leaf {
        return Err(GltfError::new(place(index), texts::gltf_in_shear(path)));
    }
    let signs = DVec3::select(trs.scale.cmplt(DVec3::ZERO), DVec3::NEG_ONE, DVec3::ONE);
    let change = Change::new(mirror, signs);
    let rest = Trs {
        translation: change.translation(trs.translation),
        rotation: change.rotation(trs.rotation),
        scale: trs.scale.abs().max(DVec3::splat(LEAST_SCALE)),
    };
    let below = DAffine3::from_scale(change.below);
    Ok((rest, change, sheared.map_or(below, |sheared| below * sheared)))
}

fn of_fields(json: &json::Node, index: Index) -> Result<Trs, GltfError> {
    let rotation = json.rotation.map_or(DQuat::IDENTITY, |rotation| DQuat::from_array(rotation.map(f64::from)));
    let length = rotation.length();
    if length < 1e-3 {
        return Err(GltfError::new(place(index), texts::gltf_rotation(0)));
    }
    Ok(Trs {
        translation: DVec3::from(json.translation.unwrap_or_default().map(f64::from)),
        rotation: if (length - 1.0).abs() > 1e-6 { rotation / length } else { rotation },
        scale: DVec3::from(json.scale.unwrap_or([1.0; 3]).map(f64::from)),
    })
}

/// A matrix as translation, rotation and scale; with shear, as a translation and a rotation, and what comes before them.
fn decomposed(columns: &[f64; 16]) -> (Trs, Option<DAffine3>) {
    let whole = DAffine3::from_mat4(DMat4::from_cols_array(columns));
    let linear = whole.matrix3;
    let mut scale = DVec3::new(linear.x_axis.length(), linear.y_axis.length(), linear.z_axis.length());
    if linear.determinant() < 0.0 {
        scale.x = -scale.x;
    }
    let axes = DMat3::from_cols(linear.x_axis / scale.x, linear.y_axis / scale.y, linear.z_axis / scale.z);
    let off = axes.transpose() * axes - DMat3::IDENTITY;
    let worst = off.to_cols_array().into_iter().fold(0.0, |worst: f64, entry| worst.max(entry.abs()));
    // An axis of no length has no direction.
    if scale.abs().min_element() > 0.0 && worst < SHEAR_BOUND {
        let rotation = DQuat::from_mat3(&axes).normalize();
        return (Trs { translation: whole.translation, rotation, scale }, None);
    }
    // A rotation that turns x and the plane of x and y as the matrix does, as far as it has such.
    let x = linear.x_axis.normalize_or(DVec3::X);
    let y = linear.y_axis.reject_from_normalized(x).normalize_or(x.any_orthonormal_vector());
    let rotation = DQuat::from_mat3(&DMat3::from_cols(x, y, x.cross(y))).normalize();
    let rigid = Trs { translation: whole.translation, rotation, scale: DVec3::ONE };
    (rigid, Some(rigid.to_affine().inverse() * whole))
}
