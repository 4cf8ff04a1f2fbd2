//! Points whose place in the world matters, such as the sole of a foot that stands.

use glam::Vec3;

use super::Samples;
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;

/// A point of a node that has to stay near its place in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Watched {
    /// The nodes from the topmost one down, each with the transform from its parent's space to that of the node before it.
    pub chain: Vec<(Rbt, RbtIndex)>,
    /// The point in the last node's space.
    pub point: Vec3,
    /// For each sample the distance in scene units that it may be off; infinite where it does not matter.
    pub units: Vec<f32>,
}

impl Watched {
    /// Where the point is under a pose.
    #[must_use]
    pub fn in_world(&self, pose: &Pose) -> Vec3 {
        self.along(|rbt| pose.get(rbt))
    }

    fn along(&self, local: impl Fn(RbtIndex) -> Rbt) -> Vec3 {
        let below = |point: Vec3, &(above, rbt): &(Rbt, RbtIndex)| (above * local(rbt)).transform_point(point);
        self.chain.iter().rev().fold(self.point, below)
    }
}

/// A watched point, and where the samples have it.
pub(super) struct Points<'a> {
    watched: &'a Watched,
    /// For each node of the chain its track, or its transform if it does not move.
    links: Vec<(Rbt, Result<usize, Rbt>)>,
    places: Vec<Vec3>,
}

impl<'a> Points<'a> {
    /// `place`: for each node the index of its track, if it moves.
    pub(super) fn of(watched: &'a Watched, samples: &Samples, place: &[Option<usize>]) -> Self {
        let still = |rbt: RbtIndex| samples.poses()[0].get(rbt);
        let links = watched.chain.iter().map(|&(above, rbt)| (above, place[rbt.get()].ok_or_else(|| still(rbt))));
        let places = samples.poses().iter().map(|pose| watched.in_world(pose)).collect();
        Self { watched, links: links.collect(), places }
    }

    /// How far the point is off in a sample, in parts of what it may be: above 1 beyond that. The number is a square.
    pub(super) fn excess(&self, sample: usize, played: impl Fn(usize) -> Rbt) -> f32 {
        let most = self.watched.units[sample];
        if most == f32::INFINITY {
            return 0.0;
        }
        let below = |point: Vec3, (above, link): &(Rbt, Result<usize, Rbt>)| {
            let local = link.map_or_else(|still| still, &played);
            (*above * local).transform_point(point)
        };
        let place = self.links.iter().rev().fold(self.watched.point, below);
        place.distance_squared(self.places[sample]) / (most * most)
    }
}
