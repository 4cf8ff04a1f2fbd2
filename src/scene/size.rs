//! How long the text of a scene file is, without making it.

use super::channel::Channel;
use super::graph::{NodeKind, SceneGraph};
use super::shape::{PlacedShape, Shape};
use super::tracks::Tracks;
use crate::json::quoted_bytes_at_most;

/// The largest scene file that is read: 256 MiB.
pub const LARGEST_SCENE_BYTES: u64 = 256 << 20;

/// Upper bound of the lines of a node besides its keys: the fields, and the brackets of lists.
const MOST_LINES: u64 = 16;
/// Upper bound of the text of these lines, without name and indentation.
const MOST_NODE_BYTES: u64 = 800;
/// Upper bound of the text of a key, without indentation.
const MOST_KEY_BYTES: u64 = 128;
/// Upper bound of the text around nodes and the eyes' paths.
const MOST_HEAD_BYTES: u64 = 400;

impl SceneGraph {
    /// An upper bound of the length of the scene's file in bytes. Takes time for each node, not for each key.
    #[must_use]
    pub fn file_bytes_at_most(&self) -> u64 {
        let eyes: u64 = self.eyes().iter().map(|&eye| quoted_bytes_at_most(self.rbt_path(eye)) + 2).sum();
        let nodes: u64 = self
            .nodes()
            .iter()
            .map(|node| {
                let indentation = 4 * node.depth as u64 + 16;
                let keys = match &node.kind {
                    NodeKind::Rbt(_) => 0,
                    NodeKind::Shape(placed) => key_count(placed.tracks()),
                    NodeKind::Control(tracks) => key_count(tracks),
                };
                let of_mesh = match &node.kind {
                    NodeKind::Shape(PlacedShape { shape: Shape::Mesh(mesh), .. }) => {
                        let joints =
                            mesh.joints().iter().map(|&joint| quoted_bytes_at_most(&self.node(joint).path) + 2);
                        quoted_bytes_at_most(&mesh.mesh().name) + joints.sum::<u64>()
                    }
                    _ => 0,
                };
                let lines = MOST_NODE_BYTES + MOST_LINES * indentation;
                quoted_bytes_at_most(&node.name) + of_mesh + lines + keys * (MOST_KEY_BYTES + indentation)
            })
            .sum();
        // Base 64 makes four bytes of three.
        let meshes = self.meshes().map_or(0, |meshes| (meshes.glb.len() as u64).div_ceil(3) * 4);
        MOST_HEAD_BYTES + meshes + quoted_bytes_at_most(self.name()) + eyes + nodes
    }
}

fn key_count(tracks: &Tracks) -> u64 {
    Channel::ALL.into_iter().filter_map(|channel| tracks.get(channel)).map(|track| track.len() as u64).sum()
}

#[cfg(test)]
mod tests {
    use glam::{Quat, Vec3};

    use super::*;
    use crate::scene::{KeyValue, built_in_scene, built_in_scene_names, scene_to_json};

    #[track_caller]
    fn check(scene: &SceneGraph) {
        let (long, most) = (scene_to_json(scene).len() as u64, scene.file_bytes_at_most());
        assert!(long <= most, "{long} bytes of at most {most}");
    }

    #[test]
    fn no_file_is_longer_than_its_bound() {
        for name in built_in_scene_names() {
            check(&built_in_scene(name).unwrap());
        }
        let mut scene = built_in_scene("two-robots").unwrap();
        for _ in 0..200 {
            scene = scene.with_control_above(scene.find("robot1").unwrap()).unwrap().0;
        }
        let rotation = Quat::from_xyzw(-0.000_123_456_79, -0.000_999_999_9, -1.234_567_8e-10, -1.0);
        let scale = Vec3::new(0.000_123_456_79, 0.000_999_999_9, 0.333_333_34);
        let vector = Vec3::new(-1.234_567_8e-38, -0.000_123_456_79, -999_999.94);
        for level in 2..100 {
            let id = scene.find(&format!("robot1_control{level}")).unwrap();
            for seconds in [-123_456.123_456_789, 1e-7, 0.1 + 0.2] {
                for value in [KeyValue::Rotation(rotation), KeyValue::Translation(vector), KeyValue::Scale(scale)] {
                    scene = scene.with_key(id, seconds, value).unwrap();
                }
            }
            scene = scene.with_control_renamed(id, &format!("{level}\u{1}\"\\가")).unwrap();
        }
        check(&scene);
    }
}
