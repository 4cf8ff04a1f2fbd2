//! Picking: the nearest shape that a ray meets.

use glam::{Vec3, Vec3Swizzles as _};

use super::graph::{NodeId, NodeKind, SceneGraph};
use super::shape::Shape;
use crate::pose::{Pose, RbtIndex};

/// A half line in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts, in world space.
    pub origin_in_world: Vec3,
    /// Where it goes, in world space; of any length but zero.
    pub direction_in_world: Vec3,
}

/// What a ray met first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pick {
    /// The shape's node.
    pub shape: NodeId,
    /// The RBT node that carries it; `None` for a plane, which is ground, and for a shape that none carries.
    pub rbt: Option<RbtIndex>,
    /// How far along the ray, in lengths of its direction; above 0.
    pub distance: f32,
}

impl SceneGraph {
    /// The nearest shape that `ray` meets under `pose`, `seconds` into the keys at their own times, in front of its origin.
    ///
    /// Rounded edges of boxes count as sharp ones. A ray from inside a shape passes through it.
    #[must_use]
    pub fn pick(&self, pose: &Pose, seconds: f64, ray: Ray) -> Option<Pick> {
        let world_from_node = self.world_from_nodes(pose, seconds);
        let mut nearest: Option<Pick> = None;
        for (id, node) in self.nodes_with_ids() {
            let NodeKind::Shape(placed) = &node.kind else { continue };
            let shape_from_world = world_from_node[id.get()].get().inverse();
            let origin = shape_from_world.transform_point3(ray.origin_in_world);
            let direction = shape_from_world.transform_vector3(ray.direction_in_world);
            let Some(distance) = intersect(&placed.shape, origin, direction) else { continue };
            if nearest.is_none_or(|pick| distance < pick.distance) {
                let is_ground = matches!(placed.shape, Shape::Plane { .. });
                nearest = Some(Pick { shape: id, rbt: self.carrying_rbt(id).filter(|_| !is_ground), distance });
            }
        }
        nearest
    }
}

/// Where a ray enters a shape, in lengths of `direction`; origin and direction in shape space.
fn intersect(shape: &Shape, origin: Vec3, direction: Vec3) -> Option<f32> {
    match *shape {
        Shape::Box { size, .. } => enter_box(origin, direction, size * 0.5),
        Shape::Sphere { radius } => enter_sphere(origin, direction, Vec3::ZERO, radius),
        Shape::Cylinder { radius, height } => {
            let (low, high) = within_slab(origin.y, direction.y, height * 0.5)?;
            let (enter, leave) = quadratic(
                direction.xz().length_squared(),
                origin.xz().dot(direction.xz()),
                origin.xz().length_squared() - radius * radius,
            )?;
            entering(low.max(enter), high.min(leave))
        }
        Shape::Cone { radius, height } => enter_cone(origin, direction, radius, height),
        Shape::Capsule { radius, height } => {
            let half = height * 0.5 - radius;
            let side = within_slab(origin.y, direction.y, half).and_then(|(low, high)| {
                let (enter, leave) = quadratic(
                    direction.xz().length_squared(),
                    origin.xz().dot(direction.xz()),
                    origin.xz().length_squared() - radius * radius,
                )?;
                entering(low.max(enter), high.min(leave))
            });
            [
                side,
                enter_sphere(origin, direction, Vec3::Y * half, radius),
                enter_sphere(origin, direction, Vec3::NEG_Y * half, radius),
            ]
            .into_iter()
            .flatten()
            .min_by(f32::total_cmp)
        }
        Shape::Plane { size: [x, z] } => {
            let distance = -origin.y / direction.y;
            let hit = origin + direction * distance;
            (distance > 0.0 && distance.is_finite() && hit.x.abs() <= x * 0.5 && hit.z.abs() <= z * 0.5)
                .then_some(distance)
        }
    }
}

/// An interval of the ray counts where it is not empty and begins in front.
fn entering(enter: f32, leave: f32) -> Option<f32> {
    (enter <= leave && enter > 0.0).then_some(enter)
}

/// The roots of `a s² + 2 b s + c = 0` in order: where the ray is inside. With no slope: all of it, or nothing.
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
fn within_slab(origin: f32, direction: f32, half: f32) -> Option<(f32, f32)> {
    if direction == 0.0 {
        return (origin.abs() <= half).then_some((f32::NEG_INFINITY, f32::INFINITY));
    }
    let (a, b) = ((-half - origin) / direction, (half - origin) / direction);
    Some((a.min(b), a.max(b)))
}

fn enter_box(origin: Vec3, direction: Vec3, half: Vec3) -> Option<f32> {
    let (mut enter, mut leave) = (f32::NEG_INFINITY, f32::INFINITY);
    for axis in 0..3 {
        let (low, high) = within_slab(origin[axis], direction[axis], half[axis])?;
        enter = enter.max(low);
        leave = leave.min(high);
    }
    entering(enter, leave)
}

fn enter_sphere(origin: Vec3, direction: Vec3, centre: Vec3, radius: f32) -> Option<f32> {
    let from_centre = origin - centre;
    let (enter, leave) = quadratic(
        direction.length_squared(),
        from_centre.dot(direction),
        from_centre.length_squared() - radius * radius,
    )?;
    entering(enter, leave)
}

/// A cone with its apex at y = +height/2 and its base at y = −height/2.
fn enter_cone(origin: Vec3, direction: Vec3, radius: f32, height: f32) -> Option<f32> {
    let slope = radius / height;
    let below_apex = height * 0.5 - origin.y;
    let (a, half_b, c) = (
        direction.xz().length_squared() - (slope * direction.y).powi(2),
        origin.xz().dot(direction.xz()) + slope * slope * below_apex * direction.y,
        origin.xz().length_squared() - (slope * below_apex).powi(2),
    );
    let within = |distance: f32| {
        let hit = origin + direction * distance;
        (distance > 0.0 && hit.y.abs() <= height * 0.5 + 1e-6 * height).then_some(distance)
    };
    let discriminant = half_b * half_b - a * c;
    let side = if a == 0.0 || discriminant < 0.0 {
        [None, None]
    } else {
        let root = discriminant.sqrt();
        [within((-half_b - root) / a), within((-half_b + root) / a)]
    };
    let to_base = (-height * 0.5 - origin.y) / direction.y;
    let on_base = origin + direction * to_base;
    let base = (to_base > 0.0 && to_base.is_finite() && on_base.xz().length() <= radius).then_some(to_base);
    let is_inside = origin.y.abs() < height * 0.5 && c < 0.0;
    if is_inside {
        return None;
    }
    side.into_iter().chain([base]).flatten().min_by(f32::total_cmp)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(shape: Shape, origin: [f32; 3], direction: [f32; 3], expected: Option<f32>) {
        let found = intersect(&shape, Vec3::from(origin), Vec3::from(direction));
        match (found, expected) {
            (Some(found), Some(expected)) => assert!((found - expected).abs() < 1e-5, "{found}, expected {expected}"),
            _ => assert_eq!(found, expected),
        }
    }

    #[test]
    fn each_shape_is_met_from_outside_and_passed_from_inside() {
        let capsule = Shape::Capsule { radius: 1.0, height: 4.0 };
        let cone = Shape::Cone { radius: 1.0, height: 2.0 };
        let cylinder = Shape::Cylinder { radius: 1.0, height: 2.0 };
        check(Shape::Box { size: Vec3::new(2.0, 4.0, 6.0), bevel: 0.1 }, [5.0, 0.0, 0.0], [-1.0, 0.0, 0.0], Some(4.0));
        check(Shape::Box { size: Vec3::splat(2.0), bevel: 0.1 }, [5.0, 1.5, 0.0], [-1.0, 0.0, 0.0], None);
        check(Shape::Box { size: Vec3::splat(2.0), bevel: 0.1 }, [0.0; 3], [-1.0, 0.0, 0.0], None);
        check(Shape::Sphere { radius: 1.0 }, [0.0, 0.0, 5.0], [0.0, 0.0, -2.0], Some(2.0));
        check(Shape::Sphere { radius: 1.0 }, [0.0, 0.0, 5.0], [0.0, 0.0, 1.0], None);
        check(cylinder, [0.0, 5.0, 0.5], [0.0, -1.0, 0.0], Some(4.0));
        check(cylinder, [0.0, 5.0, 1.5], [0.0, -1.0, 0.0], None);
        check(cylinder, [5.0, 0.5, 0.0], [-1.0, 0.0, 0.0], Some(4.0));
        check(capsule, [0.0, 5.0, 0.0], [0.0, -1.0, 0.0], Some(3.0));
        check(capsule, [5.0, 0.0, 0.0], [-1.0, 0.0, 0.0], Some(4.0));
        check(cone, [5.0, 0.0, 0.0], [-1.0, 0.0, 0.0], Some(4.5));
        check(cone, [5.0, 0.9, 0.0], [-1.0, 0.0, 0.0], Some(4.95));
        check(cone, [0.25, -5.0, 0.0], [0.0, 1.0, 0.0], Some(4.0));
        check(cone, [5.0, 1.5, 0.0], [-1.0, 0.0, 0.0], None);
        check(Shape::Plane { size: [2.0, 2.0] }, [0.5, 3.0, 0.5], [0.0, -1.0, 0.0], Some(3.0));
        check(Shape::Plane { size: [2.0, 2.0] }, [1.5, 3.0, 0.5], [0.0, -1.0, 0.0], None);
    }
}
