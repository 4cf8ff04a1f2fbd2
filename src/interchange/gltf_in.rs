//! glTF files as scenes and animations.
//!
//! A node of the file is an RBT node, its meshes are shapes below it, its scale is a control node below it, its camera makes it an eye. An
//! animation becomes keyframes, or timed keys with their own times. What cannot be had is named in the report.

mod bones;
mod choice;
mod keyframes;
mod motion;
mod own;
mod pace;
mod scene;
mod shapes;
mod sight;
mod steering;
mod tree;

pub use self::choice::{AnimationChoice, Contents};
use self::choice::{chosen_animation, chosen_scene};
pub use self::keyframes::Moving;
use self::keyframes::Played;
use self::motion::Motion;
use self::own::{Kind, OwnScene};

use self::scene::{Allowed, Parts, scene_text, world_from_nodes};
use self::sight::{FOV_DEGREES, Sight};
use self::tree::{ROUNDED_ONE, TreeNode, place};
use super::reduce::Tolerance;
use crate::decode;
use crate::gltf::json::Root;
use crate::gltf::{Container, Document, GltfError, ReadFile, data_uri};
use crate::model::MeshLibrary;
use crate::scene::{LARGEST_MESHES_BYTES, SceneGraph, scene_from_json};
use crate::words::{Message, all_of, texts};

/// The largest glTF file that is read, and the largest file beside it, in bytes.
pub const LARGEST_MODEL_BYTES: u64 = 1 << 29;
/// How far timed keys may be from splines, in degrees and in parts of the model's size.
const TIMED_ALLOWED: (f64, f64) = (0.05, 1e-4);

/// How a file is read.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The name of the scene that is made.
    pub name: String,
    /// The animation; the first one without a choice.
    pub animation: Option<AnimationChoice>,
    /// The number of the scene from 0; the file's own without a choice.
    pub gltf_scene: Option<usize>,
    /// Whether the animation becomes timed keys of control nodes, with the file's times, in place of poses.
    pub is_timed: bool,
}

/// What was read.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The scene with its meshes.
    pub scene: SceneGraph,
    /// What moves the poses, if anything does.
    pub moving: Option<Moving>,
    /// How far keyframes may be from it if nothing else is asked for.
    pub tolerance: Tolerance,
    /// What was taken, simplified and left out: sentences.
    pub report: Vec<Message>,
    /// The scenes and animations that were not taken: sentences with the options of the command line that take them.
    pub others: Vec<Message>,
}

/// Reads a glTF file, text or binary. `read_file` reads a file beside it, by a path relative to its folder and not out of it.
///
/// # Errors
/// A message with the place in the file: it is no glTF 2.0 that can be read, or no scene can be made of it.
pub fn imported(file: &[u8], read_file: &mut ReadFile<'_>, options: &Options) -> Result<Imported, Message> {
    let document = Document::read(file, read_file).map_err(|error| error.message())?;
    Import { document: &document, options, notes: Vec::new(), others: Vec::new() }.run(read_file)
}

/// What a file has to choose from.
///
/// # Errors
/// A message with the place in the file: it is no glTF.
pub fn contents(file: &[u8]) -> Result<Contents, Message> {
    let container = Container::of(file).map_err(|error| error.message())?;
    let root: Root = decode::json(container.json).map_err(|error| error.message())?;
    Ok(Contents::of(&root))
}

struct Import<'a> {
    document: &'a Document<'a>,
    options: &'a Options,
    notes: Vec<Message>,
    others: Vec<Message>,
}

impl Import<'_> {
    fn run(mut self, read_file: &mut ReadFile<'_>) -> Result<Imported, Message> {
        let (document, root) = (self.document, &self.document.root);
        let scene = chosen_scene(root, self.options.gltf_scene, &mut self.others)?;
        let mut tree = tree::tree(root, scene).map_err(message)?;
        let animation = chosen_animation(root, self.options.animation.as_ref(), &mut self.others)?;
        let motion = match animation {
            Some(animation) => Motion::read(document, animation, &mut tree, &mut self.notes).map_err(message)?,
            None => Motion::none(tree.len()),
        };
        let mut parts = shapes::Parts::new(document, read_file, &tree);
        let shapes = tree.iter().map(|node| parts.of_node(node)).collect::<Result<Vec<_>, _>>().map_err(message)?;
        let (meshes, mut notes) = parts.into_notes();
        self.notes.append(&mut notes);
        let is_joint = joints(&tree, &shapes);
        let (is_eye, fov_degrees) = self.eyes(&tree)?;
        let all_timed = self.options.is_timed;
        let is_timed: Vec<bool> = tree
            .iter()
            .zip(&motion.nodes)
            .map(|(node, moved)| {
                let is_control = matches!(node.own.kind, Kind::Control { .. });
                is_control || (all_timed && (moved.is_rigid() || moved.scale.is_some()))
            })
            .collect();
        let own = OwnScene::of(root, scene);
        let is_own = own.is_some();
        let world = world_from_nodes(&tree);
        let sight = Sight::of(&tree, &world, &shapes, &meshes, is_eye.contains(&true), is_own);
        // Where nothing is drawn, all nodes are joints to be seen.
        let is_bone = vec![meshes.is_empty() && !is_own; tree.len()];
        let (degrees, part_of_size) = TIMED_ALLOWED;
        let allowed = Allowed { radians: degrees.to_radians(), units: part_of_size * sight.size };
        let start = if all_timed || is_own { 0.0 } else { motion.span[0] };
        let parts = Parts {
            tree: &tree,
            motion: &motion,
            shapes: &shapes,
            meshes: &meshes,
            is_timed: &is_timed,
            is_bone: &is_bone,
            is_joint: &is_joint,
            is_eye: &is_eye,
            start,
            allowed,
            sight: &sight,
        };
        let names = parts.names();
        let mut eyes: Vec<String> = sight.eye.iter().map(|(name, ..)| name.clone()).collect();
        eyes.extend(parts.eyes(&names));
        let mut name = self.options.name.clone();
        let mut fov_degrees = fov_degrees;
        let mut lighting = None;
        if let Some(own) = own {
            // Cameras say which nodes are eyes; this says in which order.
            let place = |eye: &String| own.eyes.iter().position(|own| own == eye).unwrap_or(usize::MAX);
            eyes.sort_by_key(place);
            name = own.name.unwrap_or(name);
            fov_degrees = own.fov_degrees.unwrap_or(fov_degrees);
            lighting = own.lighting;
        }
        let library = if meshes.is_empty() { Vec::new() } else { MeshLibrary::to_glb(&meshes) };
        if library.len() as u64 > LARGEST_MESHES_BYTES {
            return Err(texts::gltf_in_too_large(library.len().div_ceil(1 << 20), LARGEST_MESHES_BYTES >> 20));
        }
        let library = if meshes.is_empty() { String::new() } else { data_uri("model/gltf-binary", &library) };
        let text = scene_text(&name, &eyes, fov_degrees, lighting, &library, parts.nodes(&names)).to_string();
        let scene = scene_from_json(&text).map_err(|error| error.message())?;
        let mut report = vec![summary(&tree, &meshes)];
        if sight.factor != 1.0 {
            report.push(texts::gltf_in_scaled(format!("{:.2}", sight.size), sight.factor));
        }
        let rounded = tree::most_rounded(&tree);
        if rounded > ROUNDED_ONE {
            report.push(texts::gltf_in_rounded_scales(ROUNDED_ONE, format!("{:.6}", rounded * sight.size)));
        }
        let tolerance = Tolerance::for_size(sight.size);
        let moving = match animation {
            Some(_) if all_timed => {
                report.push(texts::gltf_in_timed(is_timed.iter().filter(|is_timed| **is_timed).count()));
                None
            }
            Some(animation) => {
                let played =
                    Played { tree: &tree, motion: &motion, is_timed: &is_timed, start, scene: &scene, tolerance };
                played.moving(own::pace(root, animation), &mut report)?
            }
            None => None,
        };
        report.append(&mut self.notes);
        report.extend(left_out(root));
        Ok(Imported { scene, moving, tolerance, report, others: self.others })
    }

    /// Which nodes have a camera, and the field of view in degrees.
    fn eyes(&mut self, tree: &[TreeNode]) -> Result<(Vec<bool>, f32), Message> {
        let mut fov: Option<f32> = None;
        let mut is_eye = vec![false; tree.len()];
        for (node, is_eye) in tree.iter().zip(&mut is_eye) {
            let Some(camera) = self.document.root.nodes[node.index].camera else { continue };
            let to = format!("/cameras/{camera}");
            let json = self.document.root.cameras.get(camera);
            let json = json.ok_or_else(|| message(GltfError::leads_nowhere(place(node.index), &to)))?;
            let Some(perspective) = &json.perspective else {
                self.notes.push(texts::gltf_note_orthographic(&node.path));
                continue;
            };
            // Radians in single precision are degrees with noise.
            let degrees = (perspective.yfov.to_degrees() * 1e4).round() / 1e4;
            *is_eye = true;
            match fov {
                None => fov = Some(degrees),
                Some(first) if first != degrees => self.notes.push(texts::gltf_note_field_of_view(&node.path)),
                Some(_) => {}
            }
        }
        Ok((is_eye, fov.unwrap_or(FOV_DEGREES)))
    }
}

fn message(error: GltfError) -> Message {
    error.message()
}

/// By node of the tree: whether it moves vertices that are drawn.
fn joints(tree: &[TreeNode], shapes: &[Vec<shapes::MeshPart>]) -> Vec<bool> {
    let mut is_joint = vec![false; tree.len()];
    let joints = shapes.iter().flatten().flat_map(|part| &part.joints);
    joints.for_each(|&joint| is_joint[joint] = true);
    is_joint
}

fn summary(tree: &[TreeNode], meshes: &[crate::model::TriangleMesh]) -> Message {
    let triangles: usize = meshes.iter().map(|mesh| mesh.indices.len() / 3).sum();
    let skins = meshes.iter().filter(|mesh| mesh.skin.is_some()).count();
    texts::gltf_in_summary(
        texts::count_nodes(tree.len()),
        texts::count_meshes(meshes.len()),
        texts::count_triangles(triangles),
        texts::count_skins(skins),
    )
}

/// Extensions that are not shown.
fn left_out(root: &crate::gltf::json::Root) -> Option<Message> {
    let names: Vec<&str> = root
        .extensions_used
        .iter()
        .map(String::as_str)
        .filter(|name| !crate::gltf::UNDERSTOOD.contains(name))
        .collect();
    (!names.is_empty()).then(|| texts::gltf_note_extensions(all_of(&names)))
}
