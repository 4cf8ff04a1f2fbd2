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
    /// The maximum error of the silhouette, relative to the radius. It ignores the short edges inside box corners and across the quads
    /// of a capsule's caps.
    pub flattening: f32,
}

impl Level {
    pub(super) const fn new(kind: MeshKind, cut: Cut, radius: f32, flattening: f32) -> Self {
        Self { kind, cut, radius, flattening }
    }

    /// The finest mesh of a kind.
    pub fn finest(kind: MeshKind) -> Self {
        LEVELS[LEVELS_OF_KIND[kind as usize].0]
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
            Cut::Bevel(steps) => rounded_box::mesh(steps),
            Cut::Faces(cuts) => sphere::mesh(cuts),
            Cut::Around(steps) if self.kind == MeshKind::Cone => cone::mesh(steps),
            Cut::Around(steps) => cylinder::mesh(steps),
            Cut::Capsule(steps, rings) => capsule::mesh(steps, rings),
            Cut::Flat => plane::mesh(),
        }
    }
}

/// The levels of each kind, the finest first, in the order of [`MeshKind::ALL`].
const OF_KINDS: [&[Level]; MeshKind::ALL.len()] =
    [&rounded_box::LEVELS, &sphere::LEVELS, &cylinder::LEVELS, &cone::LEVELS, &capsule::LEVELS, &plane::LEVELS];
/// How many meshes there are.
pub const MESHES: usize = {
    let (mut count, mut kind) = (0, 0);
    while kind < OF_KINDS.len() {
        count += OF_KINDS[kind].len();
        kind += 1;
    }
    count
};
/// All of them: kinds in their order, of each the finest first.
pub const LEVELS: [Level; MESHES] = {
    let mut levels = [OF_KINDS[0][0]; MESHES];
    let (mut index, mut kind) = (0, 0);
    while kind < OF_KINDS.len() {
        let mut level = 0;
        while level < OF_KINDS[kind].len() {
            levels[index] = OF_KINDS[kind][level];
            index += 1;
            level += 1;
        }
        kind += 1;
    }
    levels
};
/// Where each kind's meshes are in [`LEVELS`]: the first and the last.
pub const LEVELS_OF_KIND: [(usize, usize); MeshKind::ALL.len()] = {
    let mut ranges = [(MESHES, 0); MeshKind::ALL.len()];
    let mut index = 0;
    while index < MESHES {
        let of_kind = &mut ranges[LEVELS[index].kind as usize];
        if of_kind.0 == MESHES {
            of_kind.0 = index;
        }
        of_kind.1 = index;
        index += 1;
    }
    ranges
};
/// The plane's index in [`LEVELS`].
pub const PLANE: usize = LEVELS_OF_KIND[MeshKind::Plane as usize].0;
