//! Where the handles are in the view, and which of them a pixel takes.
//!
//! Handles have the size of the arcball, whatever the node's distance. They are placed about the node's centre by a parallel projection
//! along the view, as the arcball is: drawing, taking and dragging agree to the pixel, also at the view's border.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};

use super::{Axis, GizmoAxes, Handle, HandleKind};
use crate::camera::Camera;
use crate::editor::Editor;

/// Radius of the rings about the axes, in radii of the arcball.
const RING: f32 = 1.06;
/// Radius of the ring about the line of sight.
const VIEW_RING: f32 = 1.2;
/// Where an arrow begins.
const ARROW_FROM: f32 = 1.28;
/// Where its tip is.
const ARROW_TO: f32 = 1.62;
/// How far a square's middle is along each of its two axes, and half its side.
const SQUARE: (f32, f32) = (1.02, 0.09);
/// How far the line along the axis of a held arrow reaches to both sides, in radii of the arcball.
const GUIDE: f32 = 4.0;
/// The pieces that a ring is drawn in.
const PIECES: usize = 72;
/// Along the view, an arrow cannot be dragged: its direction's largest part towards the viewer.
const STEEPEST_ARROW: f32 = 0.94;
/// Seen from its edge, a square cannot be dragged: its normal's least part towards the viewer.
const FLATTEST_SQUARE: f32 = 0.2;

/// A piece of a handle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// One end and the other, in pixels from the node's centre: x to the right, y up, z towards the viewer.
    pub ends: [Vec3; 2],
    /// Whether it lies behind the node's centre, as the far half of a ring does.
    pub is_behind: bool,
}

/// The handles of the primary node, as a camera sees them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gizmo {
    pub(super) camera: Camera,
    /// The node's centre, in world space.
    pub centre_in_world: Vec3,
    pub(super) centre_px: Vec2,
    pub(super) depth: f32,
    pub(super) radius_px: f32,
    /// The axes of the handles that are shown.
    pub axes: GizmoAxes,
    /// What a unit along each axis is in world space, for each of [`GizmoAxes::ALL`].
    in_world: [[Vec3; 3]; 4],
}

impl Gizmo {
    /// What a unit along a handle's axis is in world space.
    pub(super) fn unit_in_world(&self, axes: GizmoAxes, axis: Axis) -> Vec3 {
        self.in_world[axes as usize][axis.index()]
    }

    /// The direction of an axis as it is seen: x to the right, y up, z towards the viewer. Zero where the axis has no length.
    pub(super) fn direction(&self, axes: GizmoAxes, axis: Axis) -> Vec3 {
        let in_world = self.unit_in_world(axes, axis).normalize_or_zero();
        self.camera.world_from_eye.inverse().transform_vector(in_world)
    }

    /// An axis of a ring, at right angles to the two others also where the parent's space is askew.
    pub(super) fn ring_axes(&self, handle: Handle) -> Option<[Vec3; 3]> {
        let [first, second] = handle.axis.others().map(|axis| self.direction(handle.axes, axis));
        let normal = first.cross(second).try_normalize()?;
        Some([first, normal.cross(first), normal])
    }

    /// Scene units for a pixel, at the node's centre.
    pub(super) fn units_per_pixel(&self) -> f32 {
        self.depth * self.camera.units_per_pixel_at_unit_depth()
    }

    /// The handles that are shown, the outer ring last.
    pub fn handles(&self) -> impl Iterator<Item = Handle> + '_ {
        let axes = self.axes;
        let of = move |kind| Axis::ALL.map(|axis| Handle { kind, axis, axes });
        let all = of(HandleKind::Turn).into_iter().chain(of(HandleKind::Move)).chain(of(HandleKind::Plane));
        let is_view = |handle: &Handle| *handle == Handle::TURN_IN_VIEW;
        all.filter(move |handle| self.is_shown(*handle) && !is_view(handle)).chain([Handle::TURN_IN_VIEW])
    }

    fn is_shown(&self, handle: Handle) -> bool {
        let direction = self.direction(handle.axes, handle.axis);
        match handle.kind {
            HandleKind::Turn => self.ring_axes(handle).is_some(),
            HandleKind::Move => direction != Vec3::ZERO && direction.z.abs() < STEEPEST_ARROW,
            HandleKind::Plane => self.ring_axes(handle).is_some_and(|[.., normal]| normal.z.abs() > FLATTEST_SQUARE),
        }
    }

    /// The lines that a handle consists of; none where its axis has no length.
    #[must_use]
    pub fn parts(&self, handle: Handle) -> Vec<Part> {
        let in_front = |ends| Part { ends, is_behind: false };
        match handle.kind {
            HandleKind::Turn => self.ring(handle),
            HandleKind::Move => {
                let direction = self.direction(handle.axes, handle.axis) * self.radius_px;
                vec![in_front([direction * ARROW_FROM, direction * ARROW_TO])]
            }
            HandleKind::Plane => {
                let [first, second] = handle.axis.others().map(|axis| self.direction(handle.axes, axis));
                let (middle, half) = SQUARE;
                let corner = |a: f32, b: f32| {
                    (first * half.mul_add(a, middle) + second * half.mul_add(b, middle)) * self.radius_px
                };
                let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
                (0..4).map(|index| in_front([corners[index], corners[(index + 1) % 4]])).collect()
            }
        }
    }

    /// The arcball's outline, in lines as [`Part::ends`] are.
    pub fn arcball(&self) -> impl Iterator<Item = [Vec3; 2]> + use<'_> {
        let point = |piece| circle_point(piece, [Vec3::X, Vec3::Y]) * self.radius_px;
        (0..PIECES).map(move |piece| [point(piece), point(piece + 1)])
    }

    /// A long line through the node's centre, along a handle's axis.
    #[must_use]
    pub fn guide(&self, handle: Handle) -> [Vec3; 2] {
        let reach = self.direction(handle.axes, handle.axis) * self.radius_px * GUIDE;
        [-reach, reach]
    }

    fn ring(&self, handle: Handle) -> Vec<Part> {
        let Some([first, second, normal]) = self.ring_axes(handle) else { return Vec::new() };
        let radius_px = self.radius_px * if handle == Handle::TURN_IN_VIEW { VIEW_RING } else { RING };
        // Seen from the front, a ring has no far half.
        let is_round = normal.z.abs() > 0.999;
        let point = |piece| circle_point(piece, [first, second]) * radius_px;
        (0..PIECES)
            .map(|piece| {
                let ends = [point(piece), point(piece + 1)];
                Part { ends, is_behind: !is_round && ends[0].z + ends[1].z < 0.0 }
            })
            .collect()
    }

    /// Where a point is, given in pixels from the node's centre as [`Part::ends`] are, in world space.
    #[must_use]
    pub fn point_in_world(&self, from_centre_px: Vec3) -> Vec3 {
        let ray = self.camera.ray_through(self.centre_px + Vec2::new(from_centre_px.x, -from_centre_px.y));
        // Not behind the eye, however near the node is.
        let depth = (self.depth - from_centre_px.z * self.units_per_pixel()).max(self.depth * 0.1);
        ray.origin_in_world + ray.direction_in_world * depth
    }

    /// The handle at a pixel: the nearest within `reach_px`. The near half of a ring is preferred to the far half of another.
    #[must_use]
    pub fn handle_at(&self, at_px: Vec2, reach_px: f32) -> Option<Handle> {
        let mut nearest: Option<(bool, f32, Handle)> = None;
        for handle in self.handles() {
            let parts = self.parts(handle);
            let is_inside = handle.kind == HandleKind::Plane && self.is_inside(&parts, at_px);
            for part in parts {
                let distance = if is_inside { 0.0 } else { self.distance_px(part, at_px) };
                let is_nearer =
                    nearest.is_none_or(|(is_behind, least, _)| (part.is_behind, distance) < (is_behind, least));
                if distance <= reach_px && is_nearer {
                    nearest = Some((part.is_behind, distance, handle));
                }
            }
        }
        nearest.map(|(.., handle)| handle)
    }

    fn seen_px(&self, from_centre_px: Vec3) -> Vec2 {
        self.centre_px + Vec2::new(from_centre_px.x, -from_centre_px.y)
    }

    fn distance_px(&self, part: Part, at_px: Vec2) -> f32 {
        let [from, to] = part.ends.map(|end| self.seen_px(end));
        let along = to - from;
        let length_squared = along.length_squared();
        let share = if length_squared > 0.0 { (at_px - from).dot(along) / length_squared } else { 0.0 };
        (from + along * share.clamp(0.0, 1.0)).distance(at_px)
    }

    /// Whether a pixel is inside of a square, which its parts go around.
    fn is_inside(&self, square: &[Part], at_px: Vec2) -> bool {
        let sides = square.iter().map(|part| {
            let [from, to] = part.ends.map(|end| self.seen_px(end));
            (to - from).perp_dot(at_px - from)
        });
        let sides: Vec<f32> = sides.collect();
        sides.iter().all(|side| *side > 0.0) || sides.iter().all(|side| *side < 0.0)
    }

    /// Where a handle can be taken: the middle of a part of its own that no other handle covers. For tests and tours.
    #[must_use]
    pub fn grip_px(&self, handle: Handle, reach_px: f32) -> Option<Vec2> {
        let parts = self.parts(handle).into_iter().filter(|part| !part.is_behind);
        let middles = parts.map(|part| self.seen_px((part.ends[0] + part.ends[1]) * 0.5));
        middles.into_iter().find(|&middle| self.handle_at(middle, reach_px) == Some(handle))
    }
}

/// A point of the circle through the ends of two axes.
fn circle_point(piece: usize, [first, second]: [Vec3; 2]) -> Vec3 {
    #[expect(clippy::cast_precision_loss, reason = "there are few pieces")]
    let (sin, cos) = (piece as f32 * TAU / PIECES as f32).sin_cos();
    first * cos + second * sin
}

impl Editor {
    /// The handles of the chosen node, of several of the primary, for a view of this camera. `None` where none is chosen, it is the eye,
    /// or its centre is out of sight.
    #[must_use]
    pub fn gizmo(&self, camera: &Camera) -> Option<Gizmo> {
        let rbt = self.session.chosen.primary()?;
        if Some(rbt) == self.eye() {
            return None;
        }
        let (arcball, (centre_in_world, _)) = {
            let manipulation = self.manipulation(camera);
            (manipulation.arcball?, manipulation.arcball_in_world?)
        };
        let (centre_px, depth) = camera.project(centre_in_world)?;
        let pose = self.edited_pose();
        Some(Gizmo {
            camera: *camera,
            centre_in_world,
            centre_px,
            depth,
            radius_px: arcball.radius_px,
            axes: self.session.gizmo_axes,
            in_world: GizmoAxes::ALL.map(|axes| self.units_in_world(&pose, axes, rbt)),
        })
    }

    /// Whether the handles are shown, if there are any: they hide with the arcball, by themselves, and while something plays.
    #[must_use]
    pub fn shows_gizmo(&self) -> bool {
        self.session.shows_arcball && self.session.shows_gizmo && !self.is_playing()
    }

    /// The handle that a press at a pixel takes, `reach_px` around it; none where handles are hidden.
    #[must_use]
    pub fn handle_at(&self, camera: &Camera, at_px: Vec2, reach_px: f32) -> Option<Handle> {
        self.shows_gizmo().then(|| self.gizmo(camera)?.handle_at(at_px, reach_px))?
    }
}
