//! The shapes, one file each: dimensions and their ranges, and intersection with rays. The renderer makes the meshes.

mod capsule;
mod cone;
mod cylinder;
mod mesh;
mod plane;
mod ray;
mod rounded_box;
mod sphere;

pub use capsule::Capsule;
pub use cone::Cone;
pub use cylinder::Cylinder;
pub use mesh::{MeshShape, StandingSkin};
pub use plane::Plane;
pub use rounded_box::RoundedBox;
pub use sphere::Sphere;

use glam::Vec3;

use super::checks::NodeChecks;
use super::file::SceneError;
use super::shape::MeshKind;

/// The interface of every shape. Shape space has its origin at the centre, and the axis along Y.
pub(super) trait Solid {
    /// Its name in scene files.
    fn name(&self) -> &'static str;

    /// The unit mesh that it is an instance of; `None` for a triangle mesh.
    fn mesh(&self) -> Option<MeshKind>;

    /// Checks the dimensions.
    ///
    /// # Errors
    /// [`SceneError::Value`]: the first dimension that is not allowed.
    fn check(&self, checks: NodeChecks<'_>) -> Result<(), SceneError>;

    /// Half the extents of the axis-aligned box around it, in shape space.
    fn half_extents(&self) -> Vec3;

    /// The radius of its rounded edges in scene units; 0 for sharp ones.
    fn rounding(&self) -> f32 {
        0.0
    }

    /// The farthest that it reaches along a direction in shape space: the largest dot product of one of its points with it.
    fn reach(&self, direction: Vec3) -> f32;

    /// Where a ray enters it, in lengths of `direction`; origin and direction in shape space. A ray from inside passes through.
    fn enter(&self, origin: Vec3, direction: Vec3) -> Option<f32>;

    /// Its dimensions as JSON, by their names in scene files. A mesh has only its name: its joints are paths of a scene.
    fn fields(&self) -> Vec<(&'static str, String)>;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Shape;

    #[track_caller]
    fn check(shape: &Shape, origin: [f32; 3], direction: [f32; 3], expected: Option<f32>) {
        let found = shape.enter(Vec3::from(origin), Vec3::from(direction));
        match (found, expected) {
            (Some(found), Some(expected)) => assert!((found - expected).abs() < 1e-5, "{found}, expected {expected}"),
            _ => assert_eq!(found, expected),
        }
    }

    #[test]
    fn a_shape_reaches_as_far_as_its_points() {
        let all = [
            Shape::Capsule(Capsule { radius: 0.3, height: 2.0 }),
            Shape::Cone(Cone { radius: 0.7, height: 2.0 }),
            Shape::Cylinder(Cylinder { radius: 0.4, height: 1.2 }),
            Shape::Sphere(Sphere { radius: 0.8 }),
            Shape::Box(RoundedBox { size: Vec3::new(1.0, 0.6, 2.0), bevel: 0.0 }),
        ];
        for shape in all {
            // Rays from far away towards the shape's middle and its surroundings give points of it.
            let mut points = Vec::new();
            for a in -24..=24 {
                for b in -24..=24 {
                    for axis in 0..6 {
                        let (u, v) = (a as f32 * 0.05, b as f32 * 0.05);
                        let side = if axis % 2 == 0 { 5.0 } else { -5.0 };
                        let origin = match axis / 2 {
                            0 => Vec3::new(side, u, v),
                            1 => Vec3::new(u, side, v),
                            _ => Vec3::new(u, v, side),
                        };
                        let direction = match axis / 2 {
                            0 => Vec3::X,
                            1 => Vec3::Y,
                            _ => Vec3::Z,
                        } * -side.signum();
                        points.extend(shape.enter(origin, direction).map(|length| origin + direction * length));
                    }
                }
            }
            for direction in [Vec3::Y, Vec3::NEG_Y, Vec3::new(0.3, -1.0, 0.2), Vec3::new(-2.0, 0.5, 1.0), Vec3::X] {
                let farthest = points.iter().map(|point| point.dot(direction)).fold(f32::NEG_INFINITY, f32::max);
                let reach = shape.reach(direction);
                let off = reach - farthest;
                assert!((-1e-4..0.1).contains(&off), "{shape:?} {direction}: {reach} and {farthest}");
            }
        }
        let plane = Shape::Plane(Plane { size: [2.0, 6.0] });
        assert_eq!(plane.reach(Vec3::new(1.0, -5.0, -2.0)), 7.0);
        // The edge of a box is a quarter of a circle.
        let rounded = Shape::Box(RoundedBox { size: Vec3::splat(2.0), bevel: 0.5 });
        let diagonal = Vec3::new(0.0, -1.0, 1.0).normalize();
        assert!((rounded.reach(diagonal) - (2.0_f32.sqrt() * 0.5 + 0.5)).abs() < 1e-6);
        assert_eq!(rounded.reach(Vec3::NEG_Y), 1.0);
    }

    #[test]
    fn each_shape_is_met_from_outside_and_passed_from_inside() {
        let capsule = Shape::Capsule(Capsule { radius: 1.0, height: 4.0 });
        let cone = Shape::Cone(Cone { radius: 1.0, height: 2.0 });
        let cylinder = Shape::Cylinder(Cylinder { radius: 1.0, height: 2.0 });
        check(
            &Shape::Box(RoundedBox { size: Vec3::new(2.0, 4.0, 6.0), bevel: 0.1 }),
            [5.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0],
            Some(4.0),
        );
        check(&Shape::Box(RoundedBox { size: Vec3::splat(2.0), bevel: 0.1 }), [5.0, 1.5, 0.0], [-1.0, 0.0, 0.0], None);
        check(&Shape::Box(RoundedBox { size: Vec3::splat(2.0), bevel: 0.1 }), [0.0; 3], [-1.0, 0.0, 0.0], None);
        check(&Shape::Sphere(Sphere { radius: 1.0 }), [0.0, 0.0, 5.0], [0.0, 0.0, -2.0], Some(2.0));
        check(&Shape::Sphere(Sphere { radius: 1.0 }), [0.0, 0.0, 5.0], [0.0, 0.0, 1.0], None);
        check(&cylinder, [0.0, 5.0, 0.5], [0.0, -1.0, 0.0], Some(4.0));
        check(&cylinder, [0.0, 5.0, 1.5], [0.0, -1.0, 0.0], None);
        check(&cylinder, [5.0, 0.5, 0.0], [-1.0, 0.0, 0.0], Some(4.0));
        check(&capsule, [0.0, 5.0, 0.0], [0.0, -1.0, 0.0], Some(3.0));
        check(&capsule, [5.0, 0.0, 0.0], [-1.0, 0.0, 0.0], Some(4.0));
        check(&cone, [5.0, 0.0, 0.0], [-1.0, 0.0, 0.0], Some(4.5));
        check(&cone, [5.0, 0.9, 0.0], [-1.0, 0.0, 0.0], Some(4.95));
        check(&cone, [0.25, -5.0, 0.0], [0.0, 1.0, 0.0], Some(4.0));
        check(&cone, [5.0, 1.5, 0.0], [-1.0, 0.0, 0.0], None);
        check(&Shape::Plane(Plane { size: [2.0, 2.0] }), [0.5, 3.0, 0.5], [0.0, -1.0, 0.0], Some(3.0));
        check(&Shape::Plane(Plane { size: [2.0, 2.0] }), [1.5, 3.0, 0.5], [0.0, -1.0, 0.0], None);
    }
}
