//! A player of glTF files that knows nothing of the exporter: nodes, meshes, cameras, channels; poses by slerp, by components, or by cubics.

use std::collections::BTreeMap;

use glam::{DMat4, DQuat, DVec3, DVec4};
use inbetween::gltf::{Container, json};

/// How values between linear keys are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Blend {
    Slerp,
    Components,
}

struct Channel {
    node: usize,
    path: String,
    times: Vec<f64>,
    values: Vec<DVec4>,
    is_cubic: bool,
}

/// A file that can be played.
pub struct Player {
    pub root: json::Root,
    pub parents: Vec<Option<usize>>,
    channels: Vec<Channel>,
    binary: Vec<u8>,
}

impl Player {
    pub fn of(file: &[u8]) -> Self {
        let container = Container::of(file).unwrap();
        Self::new(serde_json::from_slice(container.json).unwrap(), container.binary.unwrap_or_default())
    }

    pub fn new(root: json::Root, binary: &[u8]) -> Self {
        let mut parents = vec![None; root.nodes.len()];
        for (index, node) in root.nodes.iter().enumerate() {
            for &child in &node.children {
                assert_eq!(parents[child].replace(index), None, "a node has one parent");
            }
        }
        let floats = |accessor: usize| floats(&root, binary, accessor);
        let mut channels = Vec::new();
        for animation in &root.animations {
            for channel in &animation.channels {
                let sampler = &animation.samplers[channel.sampler];
                let path = channel.target.path.clone();
                let parts = if path == "rotation" { 4 } else { 3 };
                let value = |part: &[f64]| DVec4::new(part[0], part[1], part[2], part.get(3).copied().unwrap_or(0.0));
                let times = floats(sampler.input);
                assert!(times.windows(2).all(|pair| pair[0] < pair[1]) && times[0] >= 0.0, "times ascend from 0");
                channels.push(Channel {
                    node: channel.target.node.unwrap(),
                    path,
                    times,
                    values: floats(sampler.output).chunks_exact(parts).map(value).collect(),
                    is_cubic: sampler.interpolation.as_deref() == Some("CUBICSPLINE"),
                });
            }
        }
        Self { root, parents, channels, binary: binary.to_vec() }
    }

    /// The matrices of an accessor.
    pub fn matrices(&self, accessor: usize) -> Vec<DMat4> {
        let floats = floats(&self.root, &self.binary, accessor);
        floats.chunks_exact(16).map(DMat4::from_cols_slice).collect()
    }

    /// The times of the keys of a node's property.
    pub fn times(&self, node: usize, path: &str) -> &[f64] {
        let channel = self.channels.iter().find(|channel| channel.node == node && channel.path == path);
        channel.map(|channel| &channel.times[..]).unwrap_or_default()
    }

    /// The value of the key at a time of a node's property, as the file has it.
    pub fn key(&self, node: usize, path: &str, seconds: f64) -> Option<DVec4> {
        let channel = self.channels.iter().find(|channel| channel.node == node && channel.path == path)?;
        let key = channel.times.iter().position(|time| *time == seconds)?;
        Some(channel.values[key])
    }

    /// Translation, rotation and scale of each node.
    pub fn pose(&self, seconds: f64, blend: Blend) -> Vec<(DVec3, DQuat, DVec3)> {
        let of_node = |node: &json::Node| {
            let [translation, scale] = [(node.translation, 0.0), (node.scale, 1.0)].map(|(value, default)| {
                value.map_or(DVec3::splat(default), |value| glam::Vec3::from(value).as_dvec3())
            });
            let rotation = node.rotation.map_or(DQuat::IDENTITY, |value| glam::Quat::from_array(value).as_dquat());
            (translation, rotation, scale)
        };
        let mut pose: Vec<_> = self.root.nodes.iter().map(of_node).collect();
        for channel in &self.channels {
            let value = channel.at(seconds, blend);
            let node = &mut pose[channel.node];
            match channel.path.as_str() {
                "translation" => node.0 = value.truncate(),
                "rotation" => node.1 = DQuat::from_vec4(value.normalize()),
                "scale" => node.2 = value.truncate(),
                other => panic!("{other}"),
            }
        }
        pose
    }

    /// `world_from_node` of each node.
    pub fn world(&self, seconds: f64, blend: Blend) -> Vec<DMat4> {
        let own = |(translation, rotation, scale)| DMat4::from_scale_rotation_translation(scale, rotation, translation);
        let parent_from_node: Vec<DMat4> = self.pose(seconds, blend).into_iter().map(own).collect();
        let world = |node: usize| {
            let up = std::iter::successors(Some(node), |&at| self.parents[at]);
            up.fold(DMat4::IDENTITY, |world, at| parent_from_node[at] * world)
        };
        (0..parent_from_node.len()).map(world).collect()
    }

    /// The path that a node has by the names of those above it.
    pub fn names(&self, node: usize) -> String {
        let name = self.root.nodes[node].name.clone().unwrap();
        self.parents[node].map_or(name.clone(), |parent| format!("{}/{name}", self.names(parent)))
    }
}

/// The numbers of an accessor of floats.
fn floats(root: &json::Root, binary: &[u8], accessor: usize) -> Vec<f64> {
    let accessor = &root.accessors[accessor];
    assert_eq!(accessor.component_type, 5126);
    let parts = BTreeMap::from([("SCALAR", 1), ("VEC3", 3), ("VEC4", 4), ("MAT4", 16)])[accessor.kind.as_str()];
    let view = &root.buffer_views[accessor.buffer_view.unwrap()];
    let start = view.byte_offset.unwrap_or(0) + accessor.byte_offset.unwrap_or(0);
    let bytes = &binary[start..start + 4 * parts * accessor.count];
    bytes.chunks_exact(4).map(|float| f32::from_le_bytes(float.try_into().unwrap()).into()).collect()
}

impl Channel {
    fn at(&self, seconds: f64, blend: Blend) -> DVec4 {
        let value = |key: usize| if self.is_cubic { self.values[3 * key + 1] } else { self.values[key] };
        let after = self.times.partition_point(|&time| time <= seconds);
        if after == 0 || after == self.times.len() {
            return value(after.saturating_sub(1));
        }
        let (start, end) = (self.times[after - 1], self.times[after]);
        let t = (seconds - start) / (end - start);
        let (from, to) = (value(after - 1), value(after));
        if self.is_cubic {
            let (out, into) = (self.values[3 * after - 1] * (end - start), self.values[3 * after] * (end - start));
            let (t2, t3) = (t * t, t * t * t);
            return from * (2.0 * t3 - 3.0 * t2 + 1.0)
                + out * (t3 - 2.0 * t2 + t)
                + to * (3.0 * t2 - 2.0 * t3)
                + into * (t3 - t2);
        }
        if self.path != "rotation" || blend == Blend::Components {
            assert!(self.path != "rotation" || from.dot(to) >= 0.0, "signs follow each other");
            return from.lerp(to, t);
        }
        DVec4::from(DQuat::from_vec4(from).slerp(DQuat::from_vec4(to), t))
    }
}
