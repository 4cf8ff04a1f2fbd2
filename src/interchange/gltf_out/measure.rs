//! How far what readers show is from what the program plays: for every node in the world, at many times.

use glam::{DMat3, DQuat, DVec3, DVec4, Quat, Vec3};

use super::keyed::{Keyed, Reader};
use super::motion::{Motion, Property, angle_between};
use crate::parallel::map_in_order;
use crate::scene::{Channel, Node, NodeId, NodeKind, SceneGraph};

/// How many times one thread measures before it takes the next ones.
const TIMES_AT_ONCE: usize = 64;

/// Translation, rotation and scale of a node under its parent.
#[derive(Clone, Copy, Debug)]
pub struct Local {
    translation: DVec3,
    rotation: DQuat,
    scale: DVec3,
}

impl Local {
    fn set(&mut self, property: Property, value: DVec4) {
        match property {
            Property::Translation => self.translation = value.truncate(),
            Property::Rotation => self.rotation = DQuat::from_vec4(value),
            Property::Scale => self.scale = value.truncate(),
        }
    }
}

/// A node in the world.
#[derive(Clone, Copy, Debug)]
struct World {
    rotation: DQuat,
    axes: DMat3,
    place: DVec3,
}

/// What a node is off.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Off {
    /// In radians, and the time in seconds.
    pub turned: (f64, f64),
    /// In scene units, and the time in seconds.
    pub moved: (f64, f64),
}

impl Off {
    fn worst(self, other: Self) -> Self {
        let later = |a: (f64, f64), b: (f64, f64)| if b.0 > a.0 { b } else { a };
        Self { turned: later(self.turned, other.turned), moved: later(self.moved, other.moved) }
    }
}

/// The nodes of a scene at rest, and how they hang together.
pub struct Tree {
    parents: Vec<Option<usize>>,
    rest: Vec<Local>,
    /// Whether each node is in the file at its own place.
    is_written: Vec<bool>,
    /// Whether scales may be above any node: then axes are compared besides rotations.
    is_scaled: bool,
}

impl Tree {
    /// The scene's tree, with the transforms that a file gives its nodes.
    pub fn of(scene: &SceneGraph, has_shapes: bool) -> Self {
        let local = |kind: &NodeKind| match kind {
            NodeKind::Rbt(rbt) => {
                let rbt = scene.rest_pose().get(*rbt);
                (rbt.translation, rbt.rotation, Vec3::ONE)
            }
            NodeKind::Shape(placed) => {
                let placement = placed.placement();
                (placement.translation, placement.rotation, placement.scale)
            }
            NodeKind::Control(_) => (Vec3::ZERO, Quat::IDENTITY, Vec3::ONE),
        };
        let rest = scene.nodes().iter().map(|node| {
            let (translation, rotation, scale) = local(&node.kind);
            Local {
                translation: translation.as_dvec3(),
                rotation: rotation.as_dquat().normalize(),
                scale: scale.as_dvec3(),
            }
        });
        let is_scaled = scene.nodes().iter().any(|node| match &node.kind {
            NodeKind::Control(tracks) => tracks.get(Channel::Scale).is_some(),
            NodeKind::Rbt(_) | NodeKind::Shape(_) => false,
        });
        // Joints place skins, and are measured themselves.
        let is_written = |(id, node): (NodeId, &Node)| match node.kind {
            NodeKind::Shape(_) => has_shapes && scene.skin(id).is_none(),
            NodeKind::Rbt(_) | NodeKind::Control(_) => true,
        };
        let is_written = scene.nodes_with_ids().map(is_written).collect();
        let parents = scene.nodes().iter().map(|node| node.parent.map(NodeId::get)).collect();
        Self { parents, rest: rest.collect(), is_written, is_scaled }
    }

    /// The node above each node.
    pub fn parents(&self) -> &[Option<usize>] {
        &self.parents
    }

    /// Where each node is at a time, in scene units.
    pub fn places(&self, motions: &[Motion], seconds: f64) -> Vec<DVec3> {
        let mut world = Vec::new();
        self.world(motions.iter().map(|motion| (motion.node, motion.property, motion.at(seconds))), &mut world);
        world.into_iter().map(|node| node.place).collect()
    }

    fn world(&self, moved: impl Iterator<Item = (usize, Property, DVec4)>, into: &mut Vec<World>) {
        let mut moved = moved.peekable();
        into.clear();
        for (node, parent) in self.parents.iter().enumerate() {
            let mut local = self.rest[node];
            while let Some((_, property, value)) = moved.next_if(|(of, ..)| *of == node) {
                local.set(property, value);
            }
            let axes = DMat3::from_quat(local.rotation) * DMat3::from_diagonal(local.scale);
            into.push(match parent.map(|parent| into[parent]) {
                None => World { rotation: local.rotation, axes, place: local.translation },
                Some(above) => World {
                    rotation: above.rotation * local.rotation,
                    axes: above.axes * axes,
                    place: above.place + above.axes * local.translation,
                },
            });
        }
    }

    /// The worst of each node over some times, under each of the readers.
    pub fn measured(&self, motions: &[Motion], keyed: &[Keyed], readers: &[Reader], times: &[f64]) -> Vec<Off> {
        let chunks: Vec<&[f64]> = times.chunks(TIMES_AT_ONCE).collect();
        let of_chunks = map_in_order(&chunks, |times| {
            let mut worst = vec![Off::default(); self.parents.len()];
            let (mut played, mut shown) = (Vec::new(), Vec::new());
            for &seconds in *times {
                self.world(
                    motions.iter().map(|motion| (motion.node, motion.property, motion.at(seconds))),
                    &mut played,
                );
                for &reader in readers {
                    let at = |keyed: &Keyed| (keyed.node, keyed.property, keyed.at(seconds, reader));
                    self.world(keyed.iter().map(at), &mut shown);
                    for (node, worst) in worst.iter_mut().enumerate().filter(|(node, _)| self.is_written[*node]) {
                        *worst = worst.worst(self.off(played[node], shown[node], seconds));
                    }
                }
            }
            worst
        });
        let mut worst = vec![Off::default(); self.parents.len()];
        for chunk in of_chunks {
            for (worst, off) in worst.iter_mut().zip(chunk) {
                *worst = worst.worst(off);
            }
        }
        worst
    }

    fn off(&self, played: World, shown: World, seconds: f64) -> Off {
        let mut turned = angle_between(played.rotation.into(), shown.rotation.into());
        if self.is_scaled {
            for axis in 0..3 {
                let [a, b] = [played, shown].map(|node| node.axes.col(axis).normalize_or_zero());
                turned = turned.max(2.0 * (0.5 * (a - b).length()).min(1.0).asin());
            }
        }
        Off { turned: (turned, seconds), moved: (played.place.distance(shown.place), seconds) }
    }
}
