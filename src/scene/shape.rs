//! Shapes: the geometry under RBT nodes, as dimensions and a colour. No meshes here; those are the renderer's.

use glam::{Affine3A, Quat, Vec3, Vec4};

use super::channel::Channel;
use super::tracks::Tracks;
use crate::colour::Colour;

/// A solid in its own shape space: centred at the origin, its axis along Y. Lengths in scene units, all positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A box with rounded edges.
    Box {
        /// Full extents along x, y and z.
        size: Vec3,
        /// Radius of the rounded edges, at most half the smallest extent.
        bevel: f32,
    },
    /// A ball.
    Sphere {
        /// Radius.
        radius: f32,
    },
    /// A cylinder along Y.
    Cylinder {
        /// Radius.
        radius: f32,
        /// Full height.
        height: f32,
    },
    /// A cone along Y, its apex up.
    Cone {
        /// Radius of the base.
        radius: f32,
        /// Full height.
        height: f32,
    },
    /// A cylinder along Y with a half ball at each end.
    Capsule {
        /// Radius.
        radius: f32,
        /// Full height, both caps included; at least twice the radius.
        height: f32,
    },
    /// A flat square in the plane y = 0, seen from above; it carries the grid that fades with distance.
    Plane {
        /// Full extents along x and z.
        size: [f32; 2],
    },
}

/// The six meshes that every shape is an instance of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum MeshKind {
    /// [`Shape::Box`].
    Box,
    /// [`Shape::Sphere`].
    Sphere,
    /// [`Shape::Cylinder`].
    Cylinder,
    /// [`Shape::Cone`].
    Cone,
    /// [`Shape::Capsule`].
    Capsule,
    /// [`Shape::Plane`].
    Plane,
}

impl MeshKind {
    /// All of them, in drawing order.
    pub const ALL: [Self; 6] = [Self::Box, Self::Sphere, Self::Cylinder, Self::Cone, Self::Capsule, Self::Plane];
}

impl Shape {
    /// Which mesh this shape is an instance of.
    #[must_use]
    pub fn mesh(&self) -> MeshKind {
        match self {
            Self::Box { .. } => MeshKind::Box,
            Self::Sphere { .. } => MeshKind::Sphere,
            Self::Cylinder { .. } => MeshKind::Cylinder,
            Self::Cone { .. } => MeshKind::Cone,
            Self::Capsule { .. } => MeshKind::Capsule,
            Self::Plane { .. } => MeshKind::Plane,
        }
    }

    /// Half the extents of the axis-aligned box around the shape, in shape space. A plane's is 0 along y.
    #[must_use]
    pub fn half_extents(&self) -> Vec3 {
        match *self {
            Self::Box { size, .. } => size * 0.5,
            Self::Sphere { radius } => Vec3::splat(radius),
            Self::Cylinder { radius, height } | Self::Cone { radius, height } | Self::Capsule { radius, height } => {
                Vec3::new(radius, height * 0.5, radius)
            }
            Self::Plane { size: [x, z] } => Vec3::new(x * 0.5, 0.0, z * 0.5),
        }
    }

    /// The radius by which edges are rounded: a box's bevel, a ball's and a capsule's radius; 0 for the others.
    #[must_use]
    pub fn rounding(&self) -> f32 {
        match *self {
            Self::Box { bevel, .. } => bevel,
            Self::Sphere { radius } | Self::Capsule { radius, .. } => radius,
            Self::Cylinder { .. } | Self::Cone { .. } | Self::Plane { .. } => 0.0,
        }
    }
}

/// Where a shape is under the node that carries it: first scaled, then turned, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Translation in the parent node's space, in scene units.
    pub translation: Vec3,
    /// Rotation.
    pub rotation: Quat,
    /// Scale along each axis of the shape; above 0.
    pub scale: Vec3,
}

/// A shape with its colour and its place under the node that carries it.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedShape {
    /// The solid.
    pub shape: Shape,
    /// Its colour, where no keys say otherwise.
    pub colour: Colour,
    tracks: Tracks,
    placement: Placement,
    parent_from_shape: Affine3A,
}

impl PlacedShape {
    /// A shape in its place.
    #[must_use]
    pub fn new(shape: Shape, colour: Colour, tracks: Tracks, placement: Placement) -> Self {
        let Placement { translation, rotation, scale } = placement;
        let parent_from_shape = Affine3A::from_scale_rotation_translation(scale, rotation, translation);
        Self { shape, colour, tracks, placement, parent_from_shape }
    }

    /// The same with other timed keys.
    #[must_use]
    pub fn with_tracks(&self, tracks: Tracks) -> Self {
        Self { tracks, ..self.clone() }
    }

    /// Its timed keys: those of its colour.
    #[must_use]
    pub const fn tracks(&self) -> &Tracks {
        &self.tracks
    }

    /// Where it is.
    #[must_use]
    pub const fn placement(&self) -> Placement {
        self.placement
    }

    /// Where it is, with any scale: shape space to the parent node's space.
    #[must_use]
    pub const fn parent_from_shape(&self) -> Affine3A {
        self.parent_from_shape
    }

    /// Its linear-light colour at a time.
    #[must_use]
    pub fn colour_at(&self, seconds: f64) -> Vec3 {
        self.tracks.numbers_at(Channel::Colour, seconds).map_or_else(|| self.colour.to_linear(), Vec4::truncate)
    }
}
