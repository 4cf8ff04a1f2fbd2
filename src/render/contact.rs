//! The shade on the ground under shapes that stand on it.
//!
//! A plain picture has no shadows of the sky, so that feet would seem to float. The footprint of a shape near the ground darkens it, and
//! the more the nearer the shape is.

use glam::{Vec2, Vec3};

use crate::frame::{DrawItem, Frame};
use crate::render::bounds::Bounds;

/// The shapes that have a shade, in the frame's order.
const MOST_SHAPES: usize = 512;
/// The opacity of the shade of a shape that touches the ground.
const OPACITY: f32 = 0.5;
/// The part of a shape's half extents that its footprint has: most shapes are rounder than their boxes.
const FOOTPRINT: f32 = 0.8;
/// From this distance on there is no shade, in scene units: the ground fades into the haze.
const FARTHEST: f32 = 40.0;

/// A shade.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// On the ground, in world space.
    pub centre_in_world: Vec3,
    /// Half the footprint's side along the ground, and half of the side at a right angle to it.
    pub across_in_world: Vec3,
    /// The other half side.
    pub deep_in_world: Vec3,
    /// How far the shade reaches beyond the footprint, in scene units.
    pub reach: f32,
    /// At the footprint, from 0 to 1.
    pub opacity: f32,
}

/// The highest level plane: what shapes stand on.
pub fn ground(frame: &Frame) -> Option<&DrawItem> {
    let is_level = |item: &&DrawItem| {
        let up = item.world_from_shape.matrix3.y_axis.normalize_or_zero();
        item.is_ground() && up.y > 0.99
    };
    let height = |item: &DrawItem| item.world_from_shape.translation.y;
    frame.items.iter().filter(is_level).max_by(|a, b| height(a).total_cmp(&height(b)))
}

/// The shades of a frame; `bounds` are the boxes of its items.
pub fn contacts(frame: &Frame, bounds: &[Bounds]) -> impl Iterator<Item = Contact> {
    let eye = Vec3::from(frame.view.world_from_eye.translation);
    let ground = ground(frame).map(Bounds::of);
    let shade = move |(item, bounds): (&DrawItem, &Bounds)| {
        let ground = ground.as_ref().filter(|_| !item.is_ground() && !item.is_hidden)?;
        contact(bounds, ground, eye)
    };
    frame.items.iter().zip(bounds).filter_map(shade).take(MOST_SHAPES)
}

fn contact(bounds: &Bounds, ground: &Bounds, eye: Vec3) -> Option<Contact> {
    let tall = bounds.reach(Vec3::Y);
    let gap = bounds.centre_in_world.y - tall - ground.centre_in_world.y;
    let nearness = 1.0 - gap.abs() / (2.0 * tall).max(1e-6);
    let haze = 1.0 - bounds.centre_in_world.distance(eye) / FARTHEST;
    if nearness <= 0.0 || haze <= 0.0 {
        return None;
    }
    // The ellipse that the half edges span on the ground has the footprint's directions as its axes.
    let on_ground = bounds.half_edges_in_world.map(|edge| Vec2::new(edge.x, edge.z));
    let [xx, xz, zz] = on_ground
        .iter()
        .fold([0.0; 3], |[xx, xz, zz], edge| [xx + edge.x * edge.x, xz + edge.x * edge.y, zz + edge.y * edge.y]);
    let across = Vec2::from_angle(0.5 * (2.0 * xz).atan2(xx - zz));
    let half =
        |direction: Vec2| FOOTPRINT * on_ground.iter().map(|edge| edge.dot(direction).abs()).sum::<f32>().max(1e-4);
    let in_world = |direction: Vec2| Vec3::new(direction.x, 0.0, direction.y) * half(direction);
    let (across_in_world, deep_in_world) = (in_world(across), in_world(across.perp()));
    let least = across_in_world.length().min(deep_in_world.length());
    let reach = (0.25 * least + 0.6 * tall).min(1.5 * least);
    let centre = bounds.centre_in_world.with_y(ground.centre_in_world.y);
    // Beyond the ground's border there is nothing to darken.
    let on_plane = |axis: Vec3| {
        let half_side = axis.length();
        let side = axis / half_side.max(1e-6);
        let extent = (across_in_world.dot(side).abs() + deep_in_world.dot(side).abs()) + reach;
        (centre - ground.centre_in_world).dot(side).abs() + extent < half_side
    };
    let is_inside = on_plane(ground.half_edges_in_world[0]) && on_plane(ground.half_edges_in_world[2]);
    let opacity = OPACITY * nearness * nearness * haze.min(1.0);
    is_inside.then_some(Contact { centre_in_world: centre, across_in_world, deep_in_world, reach, opacity })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn a_box(centre: Vec3, half_extents: Vec3) -> Bounds {
        let [x, y, z] = half_extents.to_array();
        Bounds { centre_in_world: centre, half_edges_in_world: [Vec3::X * x, Vec3::Y * y, Vec3::Z * z] }
    }

    fn shade(centre: Vec3, half_extents: Vec3) -> Option<Contact> {
        let ground = a_box(Vec3::new(0.0, -1.0, 0.0), Vec3::new(10.0, 0.0, 10.0));
        contact(&a_box(centre, half_extents), &ground, Vec3::new(0.0, 1.0, 5.0))
    }

    #[test]
    fn what_stands_on_the_ground_shades_it_most_and_what_floats_not_at_all() {
        let opacity = |height: f32| shade(Vec3::new(0.0, height, 0.0), Vec3::splat(0.5)).map(|contact| contact.opacity);
        let standing = opacity(-0.5).expect("a shade");
        let near = opacity(-0.3).expect("a shade");
        assert!(standing > near && near > 0.0, "{standing} {near}");
        assert_eq!(opacity(0.6), None);
        assert_eq!(opacity(-3.0), None);
    }

    #[test]
    fn the_footprint_lies_along_the_shape() {
        let contact = shade(Vec3::new(1.0, -0.9, 2.0), Vec3::new(0.2, 0.1, 0.5)).expect("a shade");
        assert_eq!(contact.centre_in_world, Vec3::new(1.0, -1.0, 2.0));
        let mut sides = [contact.across_in_world, contact.deep_in_world].map(|side| side.abs().max_element());
        sides.sort_by(f32::total_cmp);
        assert!((sides[0] - 0.16).abs() < 1e-5 && (sides[1] - 0.4).abs() < 1e-5, "{sides:?}");
    }

    #[test]
    fn beyond_the_grounds_border_there_is_no_shade() {
        assert!(shade(Vec3::new(9.9, -0.5, 0.0), Vec3::splat(0.5)).is_none());
        assert!(shade(Vec3::new(9.9, -0.5, 9.9), Vec3::splat(0.5)).is_none());
        assert!(shade(Vec3::new(8.0, -0.5, 0.0), Vec3::splat(0.5)).is_some());
    }
}
