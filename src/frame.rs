//! The interface between CPU and GPU: one picture as plain data.
//!
//! A [`Frame`] has all the data that the renderer needs: camera matrices, shapes in world space, ghosts, lines, dots, the arcball. It does
//! not depend on its source; [`crate::view`] makes frames. Tests of scenes check frames; only tests of pixels need an adapter.

use std::sync::Arc;

use glam::{Affine3A, Mat4, Vec3, Vec4};

use crate::camera::Camera;
use crate::lighting::Lighting;
use crate::model::TriangleMesh;
use crate::scene::MeshKind;

/// The most keyframes on each side whose ghosts are shown, in the window and in films.
pub const MOST_GHOSTS: u8 = 20;

/// The golden ratio less 1: multiples of it are spread evenly.
pub(crate) const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// The part of a ghost's opacity that surfaces have which face the eye. `shape.wgsl` has a copy.
const FACING: f32 = 0.75;

/// Camera matrices of one picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// World space to eye space (−Z forward, Y up); rigid.
    pub eye_from_world: Affine3A,
    /// The inverse of `eye_from_world`.
    pub world_from_eye: Affine3A,
    /// Eye space to clip space: right-handed perspective, infinite far plane, **reversed** depth (1 at the near plane, 0 at infinity).
    pub clip_from_eye: Mat4,
    /// Vertical field of view in radians.
    pub vertical_fov: f32,
    /// Width over height of the picture.
    pub aspect: f32,
}

impl View {
    /// The matrices of a camera.
    #[must_use]
    pub fn new(camera: &Camera) -> Self {
        Self {
            eye_from_world: camera.eye_from_world(),
            world_from_eye: camera.world_from_eye.to_affine(),
            clip_from_eye: camera.clip_from_eye(),
            vertical_fov: camera.vertical_fov,
            aspect: camera.size_px.x / camera.size_px.y,
        }
    }
}

/// What an item is drawn as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ItemMesh {
    /// A unit mesh of the renderer.
    Unit(MeshKind),
    /// A mesh of triangles, placed by the item's matrix.
    Triangles {
        /// Its index in [`Frame::meshes`].
        mesh: u32,
    },
    /// A mesh of triangles with a skin, placed by its joints.
    Skin {
        /// Its index in [`Frame::meshes`].
        mesh: u32,
        /// The index in [`Frame::world_from_bind`] of its first joint. The others follow it.
        first_joint: u32,
    },
}

impl From<MeshKind> for ItemMesh {
    fn from(kind: MeshKind) -> Self {
        Self::Unit(kind)
    }
}

/// One shape, ready to be drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawItem {
    /// The mesh of which it is an instance.
    pub mesh: ItemMesh,
    /// Shape space to world space, any affine. Of a skin: the placement of the box around it.
    pub world_from_shape: Affine3A,
    /// Half the shape's extents in shape space ([`crate::scene::Shape::half_extents`]); half those of the box around a skin.
    pub half_extents: Vec3,
    /// Radius of rounded edges in shape space ([`crate::scene::Shape::rounding`]).
    pub rounding: f32,
    /// Linear-light colour, 0 to 1.
    pub colour: Vec3,
    /// How rough the surface is, 0 (a mirror) to 1.
    pub roughness: f32,
    /// How much of a metal it is, 0 to 1: metals mirror in their own colour.
    pub metalness: f32,
    /// The index of the scene's node, for identity pictures.
    pub node: u32,
    /// Whether it belongs to the chosen node, which gets an outline in the accent colour.
    pub outlined: bool,
    /// Whether only its shadow shows: it belongs to the node that one looks from, and would be seen from inside.
    pub is_hidden: bool,
}

impl DrawItem {
    /// Whether it is ground, which is any plane. Ground casts no shadow, has no ghost, and is not part of a scene's extent.
    #[must_use]
    pub const fn is_ground(&self) -> bool {
        match self.mesh {
            ItemMesh::Unit(MeshKind::Plane) => true,
            ItemMesh::Unit(
                MeshKind::Box | MeshKind::Sphere | MeshKind::Cylinder | MeshKind::Cone | MeshKind::Capsule,
            )
            | ItemMesh::Triangles { .. }
            | ItemMesh::Skin { .. } => false,
        }
    }
}

/// A translucent, outlined copy of a shape, drawn over the scene without a shadow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ghost {
    /// Its geometry. `colour` is its tint; `outlined` is ignored.
    pub item: DrawItem,
    /// Opacity of the fill, 0 to 1.
    pub opacity: f32,
    /// The moment that it is of, by its number in a strobe. Such moments are scene: [`Frame::expose`]. `None`: it is no part of the scene.
    pub moment: Option<u32>,
}

/// A straight line in the scene, hidden by shapes in front of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// One end, in world space.
    pub from_in_world: Vec3,
    /// The other end, in world space.
    pub to_in_world: Vec3,
    /// Linear-light red, green, blue, and opacity.
    pub colour: Vec4,
    /// Width in pixels.
    pub width_px: f32,
}

/// A round dot in the scene, always facing the eye and never hidden.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dot {
    /// Its centre, in world space.
    pub centre_in_world: Vec3,
    /// Linear-light red, green, blue, and opacity.
    pub colour: Vec4,
    /// Diameter in pixels.
    pub diameter_px: f32,
}

/// The ball that a drag turns, drawn as a thin wire sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcballMark {
    /// Its centre, in world space.
    pub centre_in_world: Vec3,
    /// Its radius, in scene units.
    pub radius: f32,
}

/// A lens, which blurs what is nearer or farther than its focus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// Half the width of its opening, in scene units.
    pub radius: f32,
    /// The distance of what is sharp, along the view's axis, in scene units; more than 0.
    pub focus_distance: f32,
}

/// All data of one picture.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The camera's matrices.
    pub view: View,
    /// The lens of refined pictures; `None` is a point, to which everything is sharp.
    pub lens: Option<Lens>,
    /// The sun and the sky.
    pub lighting: Lighting,
    /// Opaque shapes.
    pub items: Vec<DrawItem>,
    /// Translucent shapes.
    pub ghosts: Vec<Ghost>,
    /// Lines, such as the motion path.
    pub lines: Vec<Line>,
    /// Dots, such as the keyframes on the motion path.
    pub dots: Vec<Dot>,
    /// The arcball, if it is shown.
    pub arcball: Option<ArcballMark>,
    /// The meshes of triangles of which items and ghosts are instances.
    pub meshes: Vec<Arc<TriangleMesh>>,
    /// For the joints of all skins, shape space in the bind pose to world space.
    pub world_from_bind: Vec<Affine3A>,
}

impl PartialEq for Frame {
    /// Meshes are equal only if they are the same: frames are compared for each picture.
    fn eq(&self, other: &Self) -> bool {
        let Self { view, lens, lighting, items, ghosts, lines, dots, arcball, meshes, world_from_bind } = self;
        (view, lens, lighting, items, ghosts, lines, dots, arcball, world_from_bind)
            == (
                &other.view,
                &other.lens,
                &other.lighting,
                &other.items,
                &other.ghosts,
                &other.lines,
                &other.dots,
                &other.arcball,
                &other.world_from_bind,
            )
            && are_same_meshes(meshes, &other.meshes)
    }
}

/// Whether two frames have the very same meshes.
#[must_use]
pub fn are_same_meshes(one: &[Arc<TriangleMesh>], other: &[Arc<TriangleMesh>]) -> bool {
    one.len() == other.len() && one.iter().zip(other).all(|(one, other)| Arc::ptr_eq(one, other))
}

impl Frame {
    /// A picture of nothing in the light of the day.
    #[must_use]
    pub fn empty(view: View) -> Self {
        Self {
            view,
            lens: None,
            lighting: Lighting::default(),
            items: Vec::new(),
            ghosts: Vec::new(),
            lines: Vec::new(),
            dots: Vec::new(),
            arcball: None,
            meshes: Vec::new(),
            world_from_bind: Vec::new(),
        }
    }

    /// Whether another frame shows the same scene in the same view. What is drawn over the scene may differ.
    #[must_use]
    pub fn has_same_scene(&self, other: &Self) -> bool {
        let are_alike = |(one, other): (&DrawItem, &DrawItem)| DrawItem { outlined: other.outlined, ..*one } == *other;
        self.view == other.view
            && self.lens == other.lens
            && self.lighting == other.lighting
            && self.items.len() == other.items.len()
            && self.items.iter().zip(&other.items).all(are_alike)
            && self.world_from_bind == other.world_from_bind
            && are_same_meshes(&self.meshes, &other.meshes)
    }

    /// Adds, as items, the moments of a strobe that are exposed at a part of the exposure, 0 to 1: each for as much of it as its ghosts hide
    /// in plain pictures, at other times than the others. `strobe` is the frame that has them; this one is of the same scene, perhaps later.
    pub fn expose(&mut self, strobe: &Self, part: f64) {
        let is_exposed = |ghost: &&Ghost| {
            let moment = ghost.moment.map(|moment| (part + f64::from(moment) * GOLDEN).fract());
            moment.is_some_and(|passed| passed < f64::from(FACING * ghost.opacity))
        };
        self.items.extend(strobe.ghosts.iter().filter(is_exposed).map(|ghost| ghost.item));
        // The joints of ghosts follow those of the scene.
        let own = self.world_from_bind.len().min(strobe.world_from_bind.len());
        self.world_from_bind.extend_from_slice(&strobe.world_from_bind[own..]);
    }

    /// Whether there is anything besides the scene: ghosts, lines, dots, the arcball, an outline. Moments of a strobe are scene.
    #[must_use]
    pub fn has_overlay(&self) -> bool {
        !(self.ghosts.iter().all(|ghost| ghost.moment.is_some())
            && self.lines.is_empty()
            && self.dots.is_empty()
            && self.arcball.is_none())
            || self.items.iter().any(|item| item.outlined)
    }

    /// The matrices of a skin: those from its first joint on, as many as its mesh has joints.
    #[must_use]
    pub fn joints_of(&self, mesh: u32, first_joint: u32) -> &[Affine3A] {
        let count = self.meshes[mesh as usize].skin.as_ref().map_or(0, |skin| skin.joint_from_shape.len());
        &self.world_from_bind[first_joint as usize..][..count]
    }

    /// Scales the widths of lines and dots, for screens with several pixels per point.
    pub fn scale_strokes(&mut self, factor: f32) {
        for line in &mut self.lines {
            line.width_px *= factor;
        }
        for dot in &mut self.dots {
            dot.diameter_px *= factor;
        }
    }
}
