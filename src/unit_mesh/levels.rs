//! The levels of detail of each kind.
//!
//! A flat piece of a round surface has its corners as far outside the true surface as the middles of its edges are inside
//! ([`Level::fitted`]). This halves the error of corners on the surface, and needs as few as half the triangles for the same error.

use glam::Vec3;

use super::{Mesh, capsule, cone, cylinder, plane, rounded_box, sphere};
use crate::scene::MeshKind;

/// The subdivision of round parts.
#[derive(Clone, Copy, Debug)]
pub(super) enum Cut {
    /// A box whose rounded edges have this number of steps. With 0 the edges are sharp and the box is drawn without rounding.
    Bevel(u16),
    /// A sphere from an icosahedron whose edges are divided into this number of parts.
    Faces(u16),
    /// A cylinder or cone with this number of steps around the axis.
    Around(u16),
    /// A capsule: steps around the axis, and steps from the equator to each pole.
    Capsule(u16, u16),
    /// A flat shape.
    Flat,
}

/// One mesh of a kind.
#[derive(Clone, Copy, Debug)]
pub struct Level {
    /// The kind of shape.
    pub kind: MeshKind,
    pub(super) cut: Cut,
    /// Factor on the radius of an instance. A box's rounding is made smaller, which moves its bevels outwards.
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
    #[must_use]
    pub fn finest(kind: MeshKind) -> Self {
        LEVELS[LEVELS_OF_KIND[kind as usize].0]
    }

    /// Half extents and rounding of the instance for a shape's half extents and rounding.
    #[must_use]
    pub fn fitted(self, half_extents: Vec3, rounding: f32) -> (Vec3, f32) {
        let fitted = rounding * self.radius;
        match self.kind {
            MeshKind::Box | MeshKind::Sphere => (half_extents, fitted),
            MeshKind::Cylinder | MeshKind::Cone => (half_extents * Vec3::new(self.radius, 1.0, self.radius), rounding),
            MeshKind::Capsule => (half_extents + (fitted - rounding), fitted),
            MeshKind::Plane => (half_extents, rounding),
        }
    }

    /// Computes its vertices and triangles.
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
/// The number of meshes.
pub const MESHES: usize = {
    let (mut count, mut kind) = (0, 0);
    while kind < OF_KINDS.len() {
        count += OF_KINDS[kind].len();
        kind += 1;
    }
    count
};
/// All levels: by kind, then finest first.
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
/// For each kind, the indices of its finest and its coarsest level in [`LEVELS`].
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
