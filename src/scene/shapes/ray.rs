//! Shared by shapes that intersect rays: intervals of the ray, in lengths of its direction.

use glam::{Vec3, Vec3Swizzles as _};

/// The start of an interval, if the interval is not empty and starts in front of the origin.
pub(super) fn entering(enter: f32, leave: f32) -> Option<f32> {
    (enter <= leave && enter > 0.0).then_some(enter)
}

/// The roots of `a s² + 2 b s + c = 0` in order: the interval inside. If `a` is 0: the whole ray, or nothing.
fn quadratic(a: f32, half_b: f32, c: f32) -> Option<(f32, f32)> {
    if a <= f32::MIN_POSITIVE {
        return (c <= 0.0).then_some((f32::NEG_INFINITY, f32::INFINITY));
    }
    let discriminant = half_b * half_b - a * c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    Some(((-half_b - root) / a, (-half_b + root) / a))
}

/// Where a coordinate lies within ±`half`.
pub(super) fn within_slab(origin: f32, direction: f32, half: f32) -> Option<(f32, f32)> {
    if direction == 0.0 {
        return (origin.abs() <= half).then_some((f32::NEG_INFINITY, f32::INFINITY));
    }
    let (a, b) = ((-half - origin) / direction, (half - origin) / direction);
    Some((a.min(b), a.max(b)))
}

/// Where a ray enters a ball.
pub(super) fn enter_sphere(origin: Vec3, direction: Vec3, centre: Vec3, radius: f32) -> Option<f32> {
    let from_centre = origin - centre;
    let (enter, leave) = quadratic(
        direction.length_squared(),
        from_centre.dot(direction),
        from_centre.length_squared() - radius * radius,
    )?;
    entering(enter, leave)
}

/// The part of a ray within a cylinder along Y without ends.
fn within_tube(origin: Vec3, direction: Vec3, radius: f32) -> Option<(f32, f32)> {
    quadratic(
        direction.xz().length_squared(),
        origin.xz().dot(direction.xz()),
        origin.xz().length_squared() - radius * radius,
    )
}

/// Where a ray enters a cylinder along Y with flat ends.
pub(super) fn enter_cylinder(origin: Vec3, direction: Vec3, radius: f32, half_height: f32) -> Option<f32> {
    let (low, high) = within_slab(origin.y, direction.y, half_height)?;
    let (enter, leave) = within_tube(origin, direction, radius)?;
    entering(low.max(enter), high.min(leave))
}
