//! The levels of detail of each kind.
//!
//! Where something round is cut into flat pieces, their corners are put outside the true surface by as much as the middles of their edges
//! are inside ([`Level::fitted`]): half the error of corners on the surface, and so down to half as many triangles for the same error.

use glam::Vec3;

use super::{Mesh, capsule, cone, cylinder, plane, rounded_box, sphere};
use crate::scene::MeshKind;

/// How round parts are cut into flat ones.
#[derive(Clone, Copy, Debug)]
pub(super) enum Cut {
    /// A box's rounded edges, in so many steps; in none they are sharp, and the box is drawn with no rounding.
    Bevel(u16),
    /// Each edge of the icosahedron that a sphere is made from, in so many.
    Faces(u16),
    /// A cylinder or cone, in so many steps around.
    Around(u16),
    /// A capsule, in so many steps around, and so many from its equator to each pole.
    Capsule(u16, u16),
    /// Nothing is round.
    Flat,
}

/// One mesh of a kind.
#[derive(Clone, Copy, Debug)]
pub struct Level {
    /// What it is a mesh of.
    pub kind: MeshKind,
    pub(super) cut: Cut,
    /// What the radius of an instance is multiplied by. A box's rounding is made smaller, which moves its bevels outwards.
    pub(super) radius: f32,
    /// How far an edge's middle lies below the true surface or its ends above, at most, as a part of the radius: how far its
    /// silhouette is wrong. A box's few edges inside its rounded corners do not count, unless there is one triangle in each, nor do
    /// those across the four-sided pieces of a capsule's ends.
    pub flattening: f32,
}

impl Level {
    const fn new(kind: MeshKind, cut: Cut, radius: f32, flattening: f32) -> Self {
        Self { kind, cut, radius, flattening }
    }

    /// The finest mesh of a kind.
    pub fn finest(kind: MeshKind) -> Self {
        LEVELS[PLACES[kind as usize].0]
    }

    /// Half extents and rounding of an instance that shows a shape with these.
    pub fn fitted(self, half_extents: Vec3, rounding: f32) -> (Vec3, f32) {
        let fitted = rounding * self.radius;
        match self.kind {
            MeshKind::Box | MeshKind::Sphere => (half_extents, fitted),
            MeshKind::Cylinder | MeshKind::Cone => (half_extents * Vec3::new(self.radius, 1.0, self.radius), rounding),
            MeshKind::Capsule => (half_extents + (fitted - rounding), fitted),
            MeshKind::Plane => (half_extents, rounding),
        }
    }

    /// Its corners and triangles.
    pub(super) fn mesh(self) -> Mesh {
        match self.cut {
            Cut::Bevel(0) => {
                let mut mesh = rounded_box(1);
                // The faces come first.
                mesh.indices.truncate(6 * 6);
                mesh
            }
            Cut::Bevel(steps) => rounded_box(steps),
            Cut::Faces(cuts) => sphere(cuts),
            Cut::Around(steps) if self.kind == MeshKind::Cone => cone(steps),
            Cut::Around(steps) => cylinder(steps),
            Cut::Capsule(steps, rings) => capsule(steps, rings),
            Cut::Flat => plane(),
        }
    }
}

/// Meshes in all.
pub const MESHES: usize = 17;
/// All of them: kinds in their order, of each the finest first.
pub const LEVELS: [Level; MESHES] = [
    Level::new(MeshKind::Box, Cut::Bevel(3), 0.945, 0.020_3),
    Level::new(MeshKind::Box, Cut::Bevel(2), 0.905, 0.039_4),
    Level::new(MeshKind::Box, Cut::Bevel(1), 0.664, 0.107_2),
    Level::new(MeshKind::Box, Cut::Bevel(0), 0.0, 0.732_1),
    Level::new(MeshKind::Sphere, Cut::Faces(4), 1.006_7, 0.006_7),
    Level::new(MeshKind::Sphere, Cut::Faces(3), 1.010_9, 0.010_9),
    Level::new(MeshKind::Sphere, Cut::Faces(2), 1.025_1, 0.025_1),
    Level::new(MeshKind::Cylinder, Cut::Around(32), 1.002_4, 0.002_4),
    Level::new(MeshKind::Cylinder, Cut::Around(20), 1.006_2, 0.006_2),
    Level::new(MeshKind::Cylinder, Cut::Around(10), 1.025_1, 0.025_1),
    Level::new(MeshKind::Cone, Cut::Around(32), 1.002_4, 0.002_4),
    Level::new(MeshKind::Cone, Cut::Around(20), 1.006_2, 0.006_2),
    Level::new(MeshKind::Cone, Cut::Around(10), 1.025_1, 0.025_1),
    Level::new(MeshKind::Capsule, Cut::Capsule(18, 4), 1.007_7, 0.011_7),
    Level::new(MeshKind::Capsule, Cut::Capsule(12, 3), 1.017_3, 0.017_4),
    Level::new(MeshKind::Capsule, Cut::Capsule(10, 2), 1.025_1, 0.052_9),
    Level::new(MeshKind::Plane, Cut::Flat, 1.0, 0.0),
];
/// Where each kind's meshes are in [`LEVELS`]: the first and the last.
pub const PLACES: [(usize, usize); MeshKind::ALL.len()] = {
    let mut places = [(MESHES, 0); MeshKind::ALL.len()];
    let mut place = 0;
    while place < MESHES {
        let of_kind = &mut places[LEVELS[place].kind as usize];
        if of_kind.0 == MESHES {
            of_kind.0 = place;
        }
        of_kind.1 = place;
        place += 1;
    }
    places
};
/// The plane's place in [`LEVELS`].
pub const PLANE: usize = MESHES - 1;
