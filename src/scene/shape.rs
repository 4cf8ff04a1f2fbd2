//! Shapes: the geometry under RBT nodes, as dimensions and a colour. The meshes are in the renderer.

use std::fmt;

use glam::{Affine3A, Quat, Vec3, Vec4};
use serde::de::{Error as _, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::channel::Channel;
use super::shapes::{Capsule, Cone, Cylinder, MeshShape, Plane, RoundedBox, Solid, Sphere};
use super::tracks::Tracks;
use crate::colour::Colour;
use crate::model::{DEFAULT_ROUGHNESS, Material};

/// A solid in its own shape space: centred at the origin, its axis along Y. Lengths in scene units, all positive.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A box with rounded edges.
    Box(RoundedBox),
    /// A ball.
    Sphere(Sphere),
    /// A cylinder along Y.
    Cylinder(Cylinder),
    /// A cone along Y, its apex up.
    Cone(Cone),
    /// A cylinder along Y with a half ball at each end.
    Capsule(Capsule),
    /// A flat square in the plane y = 0.
    Plane(Plane),
    /// A mesh of triangles.
    Mesh(MeshShape),
}

/// The six unit meshes that shapes other than triangle meshes are instances of.
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
    /// All meshes, in drawing order.
    pub const ALL: [Self; 6] = [Self::Box, Self::Sphere, Self::Cylinder, Self::Cone, Self::Capsule, Self::Plane];
}

/// The shapes' names in scene files.
const NAMES: [&str; 7] = ["box", "sphere", "cylinder", "cone", "capsule", "plane", "mesh"];

/// A shape as a scene file has it.
pub(super) enum ShapeText {
    /// A shape that is whole by itself.
    Solid(Shape),
    /// A mesh, by its name among the meshes of the scene.
    Mesh(MeshText),
}

/// A mesh as a scene file has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MeshText {
    /// Its name among the meshes of the scene.
    pub name: String,
    /// The paths of the nodes that move its skin.
    #[serde(default)]
    pub joints: Vec<String>,
}

impl<'de> Deserialize<'de> for ShapeText {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ShapeVisitor;

        impl<'de> Visitor<'de> for ShapeVisitor {
            type Value = ShapeText;

            fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                formatter.write_str("decode.kind.shape")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut fields: A) -> Result<ShapeText, A::Error> {
                let name = fields.next_key::<String>()?.ok_or_else(|| A::Error::custom("decode.kind.shape"))?;
                let shape = match name.as_str() {
                    "box" => ShapeText::Solid(Shape::Box(fields.next_value()?)),
                    "sphere" => ShapeText::Solid(Shape::Sphere(fields.next_value()?)),
                    "cylinder" => ShapeText::Solid(Shape::Cylinder(fields.next_value()?)),
                    "cone" => ShapeText::Solid(Shape::Cone(fields.next_value()?)),
                    "capsule" => ShapeText::Solid(Shape::Capsule(fields.next_value()?)),
                    "plane" => ShapeText::Solid(Shape::Plane(fields.next_value()?)),
                    "mesh" => ShapeText::Mesh(fields.next_value()?),
                    _ => return Err(A::Error::unknown_field(&name, &NAMES)),
                };
                match fields.next_key::<String>()? {
                    None => Ok(shape),
                    Some(_) => Err(A::Error::custom("decode.kind.one-shape")),
                }
            }
        }

        deserializer.deserialize_map(ShapeVisitor)
    }
}

impl Shape {
    /// The shape as a trait object: the only match over its kinds.
    pub(super) fn solid(&self) -> &dyn Solid {
        match self {
            Self::Box(shape) => shape,
            Self::Sphere(shape) => shape,
            Self::Cylinder(shape) => shape,
            Self::Cone(shape) => shape,
            Self::Capsule(shape) => shape,
            Self::Plane(shape) => shape,
            Self::Mesh(shape) => shape,
        }
    }

    /// The name of its kind in scene files: `box`.
    #[must_use]
    pub fn kind_name(&self) -> &'static str {
        self.solid().name()
    }

    /// Which unit mesh this shape is an instance of; `None` for a triangle mesh.
    #[must_use]
    pub fn mesh(&self) -> Option<MeshKind> {
        self.solid().mesh()
    }

    /// The material of a mesh of triangles.
    #[must_use]
    pub fn material(&self) -> Option<&Material> {
        if let Self::Mesh(mesh) = self { Some(&mesh.mesh().material) } else { None }
    }

    /// Whether it is ground, which is any plane.
    #[must_use]
    pub const fn is_ground(&self) -> bool {
        matches!(self, Self::Plane(_))
    }

    /// Half the extents of the axis-aligned box around the shape, in shape space. A plane's is 0 along y. A skinned mesh has them as its
    /// triangles are stored, without its joints.
    #[must_use]
    pub fn half_extents(&self) -> Vec3 {
        self.solid().half_extents()
    }

    /// The radius by which edges are rounded: a box's bevel, a ball's and a capsule's radius; 0 for the others.
    #[must_use]
    pub fn rounding(&self) -> f32 {
        self.solid().rounding()
    }

    /// The farthest that it reaches along a direction, in shape space and in lengths of the direction: exact, rounded edges included.
    #[must_use]
    pub fn reach(&self, direction: Vec3) -> f32 {
        self.solid().reach(direction)
    }

    /// Where a ray enters it, in lengths of `direction`; origin and direction in shape space. Rounded edges of boxes are treated as sharp.
    /// A mesh is met at its nearest triangle, from either side, as its triangles are stored, without its joints.
    #[must_use]
    pub fn enter(&self, origin: Vec3, direction: Vec3) -> Option<f32> {
        self.solid().enter(origin, direction)
    }
}

/// What a shape says of its surface besides the colour. What it does not say, the material of its mesh says, or the default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Finish {
    /// 0 (a mirror) to 1.
    pub roughness: Option<f32>,
    /// 0 to 1 (a metal).
    pub metalness: Option<f32>,
}

/// The placement of a shape under its parent node: scaled, then rotated, then translated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Translation in the parent node's space, in scene units.
    pub translation: Vec3,
    /// Rotation; a unit quaternion.
    pub rotation: Quat,
    /// Scale along each axis of the shape; above 0.
    pub scale: Vec3,
}

/// A shape with its colour and its placement under its parent node.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedShape {
    /// The solid.
    pub shape: Shape,
    /// Its colour without timed keys.
    pub colour: Colour,
    /// What it says of its surface besides the colour.
    pub finish: Finish,
    tracks: Tracks,
    placement: Placement,
    parent_from_shape: Affine3A,
}

impl PlacedShape {
    /// A shape with a placement and a colour.
    #[must_use]
    pub fn new(shape: Shape, colour: Colour, tracks: Tracks, placement: Placement) -> Self {
        let Placement { translation, rotation, scale } = placement;
        let parent_from_shape = Affine3A::from_scale_rotation_translation(scale, rotation, translation);
        Self { shape, colour, finish: Finish::default(), tracks, placement, parent_from_shape }
    }

    /// The same shape with another finish.
    #[must_use]
    pub fn with_finish(self, finish: Finish) -> Self {
        Self { finish, ..self }
    }

    /// How rough its surface is, 0 to 1: as it says, else as the material of its mesh says.
    #[must_use]
    pub fn roughness(&self) -> f32 {
        self.finish.roughness.unwrap_or_else(|| self.shape.material().map_or(DEFAULT_ROUGHNESS, |of| of.roughness))
    }

    /// How much of a metal it is, 0 to 1: as it says, else as the material of its mesh says.
    #[must_use]
    pub fn metalness(&self) -> f32 {
        self.finish.metalness.unwrap_or_else(|| self.shape.material().map_or(0.0, |of| of.metallic))
    }

    /// The same shape with other timed keys.
    #[must_use]
    pub fn with_tracks(&self, tracks: Tracks) -> Self {
        Self { tracks, ..self.clone() }
    }

    /// Its timed keys: those of its colour.
    #[must_use]
    pub const fn tracks(&self) -> &Tracks {
        &self.tracks
    }

    /// Its placement.
    #[must_use]
    pub const fn placement(&self) -> Placement {
        self.placement
    }

    /// The placement as an affine, scale included: shape space to the parent node's space.
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
