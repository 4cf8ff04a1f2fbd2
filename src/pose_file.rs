//! Poses with names: the file that holds one, those that are shipped, and where one goes in a scene.
//!
//! A pose says of each node how it differs from its rest, so that it means the same for bodies of other proportions.

use std::sync::LazyLock;

use glam::{Quat, Vec3};
use serde::Deserialize;
use thiserror::Error;

use crate::decode::{self, DecodeError};
use crate::json;
use crate::pose::{Pose, RbtIndex};
use crate::rbt::{Rbt, are_coordinates};
use crate::rotation_rules::Mending;
use crate::scene::SceneGraph;
use crate::words::{Message, display_by_message, quoted, texts};

const FORMAT: &str = "inbetween.pose";
const VERSION: u32 = 1;
/// The largest file of a pose that is read.
pub const LARGEST_POSE_BYTES: u64 = 4 << 20;
/// The longest name of a pose, in characters.
pub const LONGEST_POSE_NAME: usize = 60;

/// A pose with a name, of a whole scene or of a node and what hangs below it.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseFile {
    /// Its name: one line that is not blank.
    pub name: String,
    /// The path of the node that it was taken of; `None`: of the whole scene.
    pub root: Option<String>,
    /// Its nodes, each once.
    pub nodes: Vec<PosedNode>,
}

/// How a node differs from its rest.
#[derive(Clone, Debug, PartialEq)]
pub struct PosedNode {
    /// Its path below the root, which itself has an empty one; in a pose of the whole scene its whole path.
    pub path: String,
    /// What turns its rest rotation into the pose's, in its parent's space.
    pub turned: Quat,
    /// What is added to its rest translation, in its parent's space.
    pub moved: Vec3,
}

/// Where the nodes of a pose go in a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// Nodes with their new `parent_from_node`.
    pub placed: Vec<(RbtIndex, Rbt)>,
    /// The paths that the scene has no RBT node for.
    pub missing: Vec<String>,
}

/// Why bytes are not the file of a pose.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PoseFileError {
    /// Not JSON of the right shape.
    Json(#[from] DecodeError),
    /// `format` names something else.
    Format {
        /// The value in the file.
        found: String,
    },
    /// `version` is not one that this program reads.
    Version {
        /// The value in the file.
        found: u32,
    },
    /// The name is blank, too long or has a control character.
    Name {
        /// The value in the file.
        found: String,
    },
    /// Two nodes have one path.
    Twice {
        /// The path.
        path: String,
    },
    /// `turned` is no unit quaternion.
    Turned {
        /// The node's path.
        path: String,
        /// The length in the file.
        length: f64,
    },
    /// `moved` is not in bounds.
    Moved {
        /// The node's path.
        path: String,
    },
}

display_by_message!(PoseFileError);

impl PoseFileError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Json(error) => error.message(),
            Self::Format { found } => texts::settings_format(found, FORMAT),
            Self::Version { found } => texts::settings_version(*found, VERSION),
            Self::Name { found } => texts::pose_file_name(quoted(found), LONGEST_POSE_NAME),
            Self::Twice { path } => texts::pose_file_twice(quoted(path)),
            Self::Turned { path, length } => texts::pose_file_turned(quoted(path), *length),
            Self::Moved { path } => texts::pose_file_moved(quoted(path)),
        }
    }
}

#[derive(Deserialize)]
struct Header {
    format: String,
    version: u32,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(rename = "format")]
    _format: String,
    #[serde(rename = "version")]
    _version: u32,
    name: String,
    root: Option<String>,
    nodes: Vec<FileNode>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FileNode {
    path: String,
    turned: [f32; 4],
    #[serde(default)]
    moved: [f32; 3],
}

/// Whether a text can be the name of a pose.
#[must_use]
pub fn is_pose_name(name: &str) -> bool {
    name.trim() == name
        && !name.is_empty()
        && name.chars().count() <= LONGEST_POSE_NAME
        && !name.contains(|character: char| character.is_control())
}

impl PoseFile {
    /// Reads the file of a pose.
    ///
    /// # Errors
    /// [`PoseFileError`]; a file with any error is refused as a whole.
    pub fn from_json(bytes: &[u8]) -> Result<Self, PoseFileError> {
        let header: Header = decode::json(bytes)?;
        if header.format != FORMAT {
            return Err(PoseFileError::Format { found: header.format });
        }
        if header.version != VERSION {
            return Err(PoseFileError::Version { found: header.version });
        }
        let file: File = decode::json(bytes)?;
        if !is_pose_name(&file.name) {
            return Err(PoseFileError::Name { found: file.name });
        }
        let mut paths: Vec<&str> = file.nodes.iter().map(|node| node.path.as_str()).collect();
        paths.sort_unstable();
        if let Some(twice) = paths.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(PoseFileError::Twice { path: twice[0].to_owned() });
        }
        let node = |FileNode { path, turned, moved }| {
            let (turned, moved) = (Quat::from_array(turned), Vec3::from(moved));
            if !are_coordinates(moved) {
                return Err(PoseFileError::Moved { path });
            }
            let length = turned.as_dquat().length();
            match Mending::of_length(length) {
                Mending::Keep => Ok(PosedNode { path, turned, moved }),
                Mending::Normalise => Ok(PosedNode { path, turned: turned.normalize(), moved }),
                Mending::Refuse => Err(PoseFileError::Turned { path, length }),
            }
        };
        let nodes = file.nodes.into_iter().map(node).collect::<Result<_, _>>()?;
        Ok(Self { name: file.name, root: file.root, nodes })
    }

    /// The text of the file. It reads back to the same pose.
    #[must_use]
    pub fn to_json(&self) -> String {
        let mut text = format!("{{\n  \"format\": \"{FORMAT}\",\n  \"version\": {VERSION},\n  \"name\": ");
        json::push_quoted(&mut text, &self.name);
        if let Some(root) = &self.root {
            text.push_str(",\n  \"root\": ");
            json::push_quoted(&mut text, root);
        }
        text.push_str(",\n  \"nodes\": [");
        for (place, node) in self.nodes.iter().enumerate() {
            text.push_str(if place == 0 { "\n    {\"path\": " } else { ",\n    {\"path\": " });
            json::push_quoted(&mut text, &node.path);
            text.push_str(", \"turned\": ");
            json::push_f32s(&mut text, &node.turned.to_array());
            // -0 is written: it reads back to the same bits.
            if node.moved.to_array().map(f32::to_bits) != [0; 3] {
                text.push_str(", \"moved\": ");
                json::push_f32s(&mut text, &node.moved.to_array());
            }
            text.push('}');
        }
        text.push_str("\n  ]\n}\n");
        text
    }

    /// The pose of a node and all below it, or of the whole scene without its first eye. Of a whole body, a root with no RBT node above
    /// it, the place on the ground and the heading are left out.
    #[must_use]
    pub fn of(scene: &SceneGraph, pose: &Pose, root: Option<RbtIndex>, name: String) -> Self {
        let below = root.map(|root| scene.subtree(scene.rbt_node(root)));
        let is_meant = |rbt: &RbtIndex| match &below {
            Some(below) => below.contains(&scene.rbt_node(*rbt).get()),
            None => *rbt != scene.eyes()[0],
        };
        let root_path = root.map(|root| scene.rbt_path(root).to_owned());
        let node = |rbt| {
            let mut by = from_rest(scene, pose, rbt);
            if Some(rbt) == root && is_whole(scene, rbt) {
                by = Rbt::new(Vec3::Y * by.translation.y, heading(by.rotation).conjugate() * by.rotation);
            }
            let path = scene.rbt_path(rbt);
            let path = root_path.as_deref().map_or(path, |root| path[root.len()..].trim_start_matches('/'));
            PosedNode { path: path.to_owned(), turned: by.rotation.normalize(), moved: by.translation }
        };
        let nodes = scene.rbt_indices().filter(is_meant).map(node).collect();
        Self { name, root: root_path, nodes }
    }

    /// The node that the pose is for where this one is chosen: itself, or the nearest above it that has nodes of the pose below it. With
    /// none chosen the node that the pose was taken of. `None` where there is none.
    #[must_use]
    pub fn root_in(&self, scene: &SceneGraph, chosen: Option<RbtIndex>) -> Option<RbtIndex> {
        let Some(chosen) = chosen else { return scene.find_rbt(self.root.as_deref()?) };
        let fits = |&rbt: &RbtIndex| {
            self.nodes
                .iter()
                .filter(|node| !node.path.is_empty())
                .any(|node| Self::find(scene, Some(rbt), &node.path).is_some())
        };
        if self.nodes.iter().all(|node| node.path.is_empty()) {
            return Some(chosen);
        }
        let above =
            |rbt: &RbtIndex| scene.node(scene.rbt_node(*rbt)).parent.and_then(|above| scene.carrying_rbt(above));
        std::iter::successors(Some(chosen), above).find(fits)
    }

    fn find(scene: &SceneGraph, root: Option<RbtIndex>, path: &str) -> Option<RbtIndex> {
        match root {
            Some(root) if path.is_empty() => Some(root),
            Some(root) => scene.find_rbt(&format!("{}/{path}", scene.rbt_path(root))),
            None => scene.find_rbt(path),
        }
    }

    /// Where the nodes go below a root, or for a pose of a whole scene in the scene. A whole body keeps its place on the ground and its
    /// heading in `live`.
    #[must_use]
    pub fn fit(&self, scene: &SceneGraph, live: &Pose, root: Option<RbtIndex>) -> Fit {
        let mut fit = Fit { placed: Vec::new(), missing: Vec::new() };
        for node in &self.nodes {
            let Some(rbt) = Self::find(scene, root, &node.path) else {
                fit.missing.push(node.path.clone());
                continue;
            };
            let rest = scene.rest_pose().get(rbt);
            let mut placed = Rbt::new(rest.translation + node.moved, node.turned * rest.rotation);
            if Some(rbt) == root && is_whole(scene, rbt) {
                let before = live.get(rbt);
                let heading = heading(from_rest(scene, live, rbt).rotation);
                let translation = Vec3 { y: placed.translation.y, ..before.translation };
                placed = Rbt::new(translation, heading * placed.rotation);
            }
            fit.placed.push((rbt, placed.renormalized()));
        }
        fit
    }
}

/// How a node differs from its rest.
fn from_rest(scene: &SceneGraph, pose: &Pose, rbt: RbtIndex) -> Rbt {
    let (rest, placed) = (scene.rest_pose().get(rbt), pose.get(rbt));
    Rbt::new(placed.translation - rest.translation, placed.rotation * rest.rotation.conjugate())
}

/// Whether no RBT node stands above a node.
fn is_whole(scene: &SceneGraph, rbt: RbtIndex) -> bool {
    scene.node(scene.rbt_node(rbt)).parent.and_then(|above| scene.carrying_rbt(above)).is_none()
}

/// The part of a rotation that turns about y.
fn heading(rotation: Quat) -> Quat {
    let about_y = Quat::from_xyzw(0.0, rotation.y, 0.0, rotation.w);
    if about_y.length_squared() > 1e-12 { about_y.normalize() } else { Quat::IDENTITY }
}

/// The poses that are shipped, in the order in which lists show them.
#[must_use]
pub fn shipped_poses() -> &'static [PoseFile] {
    static POSES: LazyLock<Vec<PoseFile>> = LazyLock::new(|| {
        let texts = [
            include_str!("../assets/poses/rest.json"),
            include_str!("../assets/poses/t.json"),
            include_str!("../assets/poses/wave.json"),
            include_str!("../assets/poses/step-left.json"),
            include_str!("../assets/poses/step-right.json"),
            include_str!("../assets/poses/sit.json"),
            include_str!("../assets/poses/point.json"),
            include_str!("../assets/poses/reach.json"),
            include_str!("../assets/poses/bow.json"),
            include_str!("../assets/poses/cheer.json"),
        ];
        texts.map(|text| PoseFile::from_json(text.as_bytes()).expect("a test reads all of them")).to_vec()
    });
    &POSES
}

/// The shipped pose of this name, in any case.
#[must_use]
pub fn shipped_pose(name: &str) -> Option<&'static PoseFile> {
    shipped_poses().iter().find(|pose| pose.name.eq_ignore_ascii_case(name))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{DEFAULT_SCENE, built_in_scene};

    #[test]
    fn the_shipped_poses_fit_the_robots_and_read_back() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let names: Vec<&str> = shipped_poses().iter().map(|pose| pose.name.as_str()).collect();
        assert_eq!(names, ["rest", "T", "wave", "step left", "step right", "sit", "point", "reach", "bow", "cheer"]);
        for pose in shipped_poses() {
            assert_eq!(PoseFile::from_json(pose.to_json().as_bytes()).as_ref(), Ok(pose));
            for robot in ["robot1", "robot2"] {
                let root = pose.root_in(&scene, scene.find_rbt(&format!("{robot}/right_hip/right_knee"))).unwrap();
                assert_eq!(scene.rbt_path(root), robot);
                let fit = pose.fit(&scene, scene.rest_pose(), Some(root));
                assert_eq!((fit.placed.len(), fit.missing.len()), (10, 0), "{} of {robot}", pose.name);
            }
        }
    }

    #[test]
    fn a_body_keeps_its_place_and_heading() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let root = scene.find_rbt("robot2").unwrap();
        let mut live = scene.rest_pose().clone();
        let about_y = Quat::from_rotation_y(1.0);
        live.set(root, Rbt::new(Vec3::new(5.0, 3.0, -4.0), about_y * Quat::from_rotation_z(0.2)));
        let placed = shipped_pose("sit").unwrap().fit(&scene, &live, Some(root)).placed[0].1;
        assert_eq!((placed.translation.x, placed.translation.z), (5.0, -4.0));
        assert!(placed.translation.y < 0.1, "it sits on the ground");
        assert!(placed.rotation.dot(about_y).abs() > 1.0 - 1e-6);
        // What is taken of a body has neither.
        let taken = PoseFile::of(&scene, &live, Some(root), "mine".to_owned());
        assert_eq!(taken.nodes[0].moved, Vec3::Y * 2.0);
        assert!(taken.nodes[0].turned.dot(Quat::from_rotation_z(0.2)).abs() > 1.0 - 1e-5);
    }

    #[test]
    fn what_is_taken_goes_back_where_it_was() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let mut pose = scene.rest_pose().clone();
        for rbt in scene.rbt_indices().skip(1) {
            let by = 0.01 * rbt.get() as f32;
            let rest = pose.get(rbt);
            pose.set(rbt, Rbt::new(rest.translation + Vec3::splat(by), Quat::from_rotation_x(by)));
        }
        for root in [None, scene.find_rbt("robot1"), scene.find_rbt("robot1/left_shoulder")] {
            let taken = PoseFile::of(&scene, &pose, root, "mine".to_owned());
            let fit = taken.fit(&scene, &pose, taken.root_in(&scene, None));
            assert!(fit.missing.is_empty());
            for (rbt, placed) in fit.placed {
                assert!(placed.translation.distance(pose.get(rbt).translation) < 1e-5, "{}", scene.rbt_path(rbt));
                assert!(placed.rotation.dot(pose.get(rbt).rotation).abs() > 1.0 - 1e-6, "{}", scene.rbt_path(rbt));
            }
        }
    }

    #[test]
    fn what_is_wrong_is_said_with_its_place() {
        let file = |name: &str, nodes: &str| {
            format!(r#"{{"format": "inbetween.pose", "version": 1, "name": {name:?}, "nodes": [{nodes}]}}"#)
        };
        let node = r#"{"path": "a", "turned": [0, 0, 0, 1]}"#;
        for (text, said) in [
            (String::new(), "line 1 column 1: the file ends"),
            (r#"{"format": "inbetween.scene", "version": 1}"#.to_owned(), "\"inbetween.scene\""),
            (r#"{"format": "inbetween.pose", "version": 2}"#.to_owned(), "its version is 2"),
            (file("a", "").replace("name", "names"), "unknown field \"names\""),
            (file(" ", ""), "\" \" is no name of a pose"),
            (file("a", &format!("{node}, {node}")), "node \"a\" twice"),
            (file("a", r#"{"path": "b", "turned": [0, 0, 0, 2]}"#), "node \"b\""),
            (file("a", r#"{"path": "b", "turned": [0, 0, 0, 1], "moved": [0, 2e6, 0]}"#), "node \"b\""),
        ] {
            let error = PoseFile::from_json(text.as_bytes()).unwrap_err().to_string();
            assert!(error.contains(said), "{error} does not say {said}");
        }
    }
}
