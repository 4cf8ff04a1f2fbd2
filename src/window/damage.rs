//! Damage tracking: the areas in which the shapes of two layouts differ.
//!
//! When the CPU draws, filling dominates the cost of panels, and little changes between two pictures.

use std::sync::Arc;

use egui::epaint::ClippedShape;
use egui::{Rect, Shape, pos2};

/// The most areas that are kept. Beyond that, the two nearest are merged.
const MOST: usize = 16;
/// How far beyond its outline a shape may colour pixels: soft edges and the points of mitred corners.
const BEYOND_PX: f32 = 3.0;

/// Areas in whole pixels of the window. No two of them overlap.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Areas(Vec<Rect>);

impl Areas {
    /// One area.
    pub fn whole(area: Rect) -> Self {
        Self(vec![area])
    }

    /// The areas.
    pub fn iter(&self) -> impl Iterator<Item = Rect> + '_ {
        self.0.iter().copied()
    }

    /// Whether one of them overlaps an area.
    pub fn touch(&self, area: Rect) -> bool {
        self.iter().any(|one| one.intersect(area).is_positive())
    }

    /// Adds an area; those that it overlaps become one with it.
    fn add(&mut self, area: Rect) {
        if !area.is_positive() {
            return;
        }
        let mut area = area;
        while let Some(index) = self.0.iter().position(|one| one.intersect(area).is_positive()) {
            area |= self.0.swap_remove(index);
        }
        self.0.push(area);
        if self.0.len() > MOST
            && let Some((first, second)) = self.nearest()
        {
            let second = self.0.swap_remove(second);
            let first = self.0.swap_remove(first);
            self.add(first | second);
        }
    }

    /// The two areas that grow least when they become one, the smaller place first.
    fn nearest(&self) -> Option<(usize, usize)> {
        let growth = |(first, second): &(usize, usize)| {
            let (first, second) = (self.0[*first], self.0[*second]);
            (first | second).area() - first.area() - second.area()
        };
        let pairs = (0..self.0.len()).flat_map(|second| (0..second).map(move |first| (first, second)));
        pairs.min_by(|first, second| growth(first).total_cmp(&growth(second)))
    }
}

/// The areas in which two layouts may look different: shapes that both have, in the same order, look alike wherever only they are.
pub fn between(before: &[ClippedShape], after: &[ClippedShape], pixels_per_point: f32) -> Areas {
    let start = before.iter().zip(after).take_while(|(one, other)| are_same(one, other)).count();
    let (before, after) = (&before[start..], &after[start..]);
    let end = before.iter().rev().zip(after.iter().rev()).take_while(|(one, other)| are_same(one, other)).count();
    let (before, after) = (&before[..before.len() - end], &after[..after.len() - end]);
    let mut areas = Areas::default();
    if before.len() == after.len() {
        for (one, other) in before.iter().zip(after).filter(|(one, other)| !are_same(one, other)) {
            areas.add(extent(one, pixels_per_point));
            areas.add(extent(other, pixels_per_point));
        }
    } else {
        for shape in before.iter().chain(after) {
            areas.add(extent(shape, pixels_per_point));
        }
    }
    areas
}

/// Where a shape may colour pixels, in whole pixels.
pub fn extent(shape: &ClippedShape, pixels_per_point: f32) -> Rect {
    let bounds = shape.transform_after_tessellation * shape.shape.visual_bounding_rect();
    if !(bounds.is_positive() || bounds.width() >= 0.0 && bounds.height() >= 0.0) {
        return Rect::NOTHING;
    }
    let beyond = BEYOND_PX / pixels_per_point;
    let area = bounds.expand(beyond).intersect(shape.clip_rect);
    if !area.is_positive() {
        return Rect::NOTHING;
    }
    Rect::from_min_max(
        pos2((area.min.x * pixels_per_point).floor(), (area.min.y * pixels_per_point).floor()),
        pos2((area.max.x * pixels_per_point).ceil(), (area.max.y * pixels_per_point).ceil()),
    )
}

/// Whether two shapes certainly look alike. A text that was laid out anew counts as another: to compare all its letters is not worth it.
fn are_same(one: &ClippedShape, other: &ClippedShape) -> bool {
    one.clip_rect == other.clip_rect
        && one.transform_after_tessellation == other.transform_after_tessellation
        && match (&one.shape, &other.shape) {
            (Shape::Text(one), Shape::Text(other)) => {
                Arc::ptr_eq(&one.galley, &other.galley)
                    && one.pos == other.pos
                    && one.underline == other.underline
                    && one.fallback_color == other.fallback_color
                    && one.override_text_color == other.override_text_color
                    && one.opacity_factor == other.opacity_factor
                    && one.angle == other.angle
            }
            (Shape::Callback(_), _) => false,
            (one, other) => one == other,
        }
}

#[cfg(test)]
mod tests {
    use egui::{Color32, Rect, Shape, pos2, vec2};

    use super::*;

    fn rect(x: f32, y: f32, width: f32, height: f32) -> Rect {
        Rect::from_min_size(pos2(x, y), vec2(width, height))
    }

    fn filled(area: Rect) -> ClippedShape {
        let shape = Shape::rect_filled(area, 0.0, Color32::RED);
        ClippedShape::new(rect(0.0, 0.0, 200.0, 100.0), shape)
    }

    fn sorted(areas: &Areas) -> Vec<Rect> {
        let mut all: Vec<_> = areas.iter().collect();
        all.sort_by(|one, other| one.min.x.total_cmp(&other.min.x));
        all
    }

    #[test]
    fn the_same_shapes_need_nothing() {
        let shapes = [filled(rect(10.0, 10.0, 20.0, 20.0)), filled(rect(50.0, 10.0, 20.0, 20.0))];
        assert_eq!(between(&shapes, &shapes, 1.0), Areas::default());
    }

    #[test]
    fn a_moved_shape_needs_its_old_and_its_new_place() {
        let still = filled(rect(0.0, 0.0, 200.0, 100.0));
        let before = [still.clone(), filled(rect(10.0, 10.0, 4.0, 20.0)), still.clone()];
        let after = [still.clone(), filled(rect(100.0, 10.0, 4.0, 20.0)), still];
        let expected = [rect(7.0, 7.0, 10.0, 26.0), rect(97.0, 7.0, 10.0, 26.0)];
        assert_eq!(sorted(&between(&before, &after, 1.0)), expected);
        let expected = [rect(17.0, 17.0, 14.0, 46.0), rect(197.0, 17.0, 14.0, 46.0)];
        assert_eq!(sorted(&between(&before, &after, 2.0)), expected);
    }

    #[test]
    fn a_shape_more_needs_its_place_and_what_is_not_in_order() {
        let [first, second, last] = [10.0, 50.0, 90.0].map(|x| filled(rect(x, 10.0, 10.0, 10.0)));
        let areas = between(&[first.clone(), last.clone()], &[first.clone(), second.clone(), last.clone()], 1.0);
        assert_eq!(sorted(&areas), [rect(47.0, 7.0, 16.0, 16.0)]);
        let areas = between(&[first.clone(), last.clone()], &[last, first], 1.0);
        assert_eq!(sorted(&areas), [rect(7.0, 7.0, 16.0, 16.0), rect(87.0, 7.0, 16.0, 16.0)]);
    }

    #[test]
    fn areas_never_overlap_and_are_few() {
        let (mut before, mut after) = (Vec::new(), Vec::new());
        for index in 0..60_u8 {
            let at = |shift: u32| {
                let step = u32::from(index) * 37 + shift;
                rect((step * 13 % 190) as f32, (step * 7 % 90) as f32, 3.0, 3.0)
            };
            before.push(filled(at(0)));
            after.push(filled(at(5)));
        }
        let areas: Vec<_> = between(&before, &after, 1.0).iter().collect();
        assert!(!areas.is_empty() && areas.len() <= MOST, "{}", areas.len());
        for (index, one) in areas.iter().enumerate() {
            assert!(areas[..index].iter().all(|other| !other.intersect(*one).is_positive()));
        }
        for shape in before.iter().chain(&after) {
            let extent = extent(shape, 1.0);
            assert!(areas.iter().any(|area| area.contains_rect(extent)), "{extent:?} is in no area");
        }
    }

    #[test]
    fn what_is_clipped_away_needs_nothing() {
        let outside = filled(rect(300.0, 10.0, 20.0, 20.0));
        assert_eq!(between(&[], &[outside], 1.0), Areas::default());
    }
}
