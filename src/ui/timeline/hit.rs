//! Layout and hit tests of the timeline.

use egui::{Pos2, Rect, pos2, vec2};

use super::columns::Columns;
use super::half_turn::has_half_turn;
use super::scale::Scale;
use crate::keyframe::{Easing, StretchEnd};
use crate::ui::theme::ROW;

/// Width of the column of names.
pub const LABELS: f32 = 184.0;
/// Height of the ruler.
pub const RULER: f32 = 36.0;
/// Half a diamond on the summary row, at most.
pub const RADIUS: f32 = 6.0;
/// Half a diamond on a node's row, at most.
pub const SMALL_RADIUS: f32 = 4.5;
/// The distance between diamonds below which they merge.
pub const LEAST_GAP: f32 = 6.0;
/// From a diamond's middle to the grip of the interval that ends there.
const GRIP: f32 = 13.0;
/// Intervals shorter than this have no grip: there would be no room for it between the diamonds.
const LEAST_FOR_GRIP: f32 = 34.0;
/// Height of the bar of the played range, at the lower edge of the ruler.
pub const RANGE_BAR: f32 = 7.0;
/// Width and height of a keyframe's picture in the strip.
const THUMBNAIL: egui::Vec2 = vec2(48.0, 36.0);
/// Height of the strip of pictures.
const STRIP: f32 = THUMBNAIL.y + 6.0;
/// A lower timeline has no strip: the rows come first.
const LEAST_FOR_STRIP: f32 = 184.0;
/// Intervals shorter than this have no room for a warning.
const LEAST_FOR_WARNING: f32 = 44.0;
/// Intervals at least this long show their easing in the middle.
pub const LEAST_FOR_EASING: f32 = 64.0;
/// From the first and the last selected diamond to the edges of the box around them.
pub const EDGE: f32 = 11.0;
/// How far from such an edge it can be taken.
const EDGE_REACH: f32 = 3.0;
/// How far from the middle of a small thing it can be taken.
const REACH: f32 = 5.0;

/// The areas of the timeline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout {
    /// The tabs and the buttons, over the names.
    pub header: Rect,
    /// Names of rows.
    pub labels: Rect,
    /// Seconds, numbers, the played range.
    pub ruler: Rect,
    /// All rows of diamonds.
    pub tracks: Rect,
    /// Pictures of keyframes; empty where there is no room for them.
    pub strip: Rect,
    /// The summary row of all nodes.
    pub summary: Rect,
    /// The rows of nodes.
    pub nodes: Rect,
}

impl Layout {
    /// The areas of a timeline in a rectangle, where there is room with a strip of pictures.
    #[must_use]
    pub fn of(whole: Rect, has_strip: bool) -> Self {
        let labels = LABELS.min(whole.width() * 0.5);
        let cut = whole.left() + labels;
        let top = whole.top() + RULER.min(whole.height());
        let tracks = Rect::from_min_max(pos2(cut, top), whole.max);
        let strip = if has_strip && whole.height() >= LEAST_FOR_STRIP { STRIP } else { 0.0 };
        let strip = tracks.with_max_y(top + strip);
        let below = strip.bottom();
        let summary = tracks.with_min_y(below).with_max_y((below + ROW).min(tracks.bottom()));
        Self {
            header: Rect::from_min_max(whole.min, pos2(cut, top)),
            labels: Rect::from_min_max(pos2(whole.left(), top), pos2(cut, whole.bottom())),
            ruler: Rect::from_min_max(pos2(cut, whole.top()), pos2(whole.right(), top)),
            tracks,
            strip,
            summary,
            nodes: tracks.with_min_y(summary.bottom()),
        }
    }

    /// Ruler and tracks together: all that follows the scale.
    #[must_use]
    pub fn scaled(&self) -> Rect {
        self.ruler.union(self.tracks)
    }
}

/// What is at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hit {
    /// The ruler: a drag scrubs.
    Ruler,
    /// The first played keyframe's handle.
    RangeStart,
    /// The last played keyframe's handle.
    RangeEnd,
    /// A keyframe.
    Diamond(usize),
    /// An edge of the box around the selected keyframes.
    StretchEdge(StretchEnd),
    /// The time handle of the interval that begins at a keyframe.
    Grip(usize),
    /// The warning on the interval that begins at a keyframe.
    HalfTurnWarning(usize),
    /// Nothing: a drag selects what it surrounds.
    Empty,
}

/// Everything that hit tests need.
#[derive(Clone, Copy, Debug)]
pub struct Target<'a> {
    /// The areas.
    pub layout: &'a Layout,
    /// The scale.
    pub scale: &'a Scale,
    /// The keyframes' times.
    pub columns: &'a Columns,
    /// The first and the last keyframe that play; `None` where none does.
    pub range: Option<(usize, usize)>,
    /// The first and the last selected keyframe, if two or more are selected.
    pub stretch: Option<(usize, usize)>,
    /// Whether there are rows; where there are graphs instead, the tracks scrub as the ruler does.
    pub has_rows: bool,
    /// How many rows of nodes there are.
    pub rows: usize,
    /// How far the rows of nodes are scrolled.
    pub scroll: f32,
}

impl Target<'_> {
    /// What is at a point.
    #[must_use]
    pub fn at(&self, at: Pos2) -> Hit {
        let layout = self.layout;
        if layout.ruler.contains(at) {
            return self.range_handle(at).unwrap_or(Hit::Ruler);
        }
        if !self.has_rows {
            return Hit::Ruler;
        }
        if layout.strip.contains(at) {
            let pictures = self.thumbnails();
            let found = pictures.into_iter().find(|(_, rect)| rect.contains(at));
            return found.map_or(Hit::Empty, |(index, _)| Hit::Diamond(index));
        }
        let row_middle = if layout.summary.contains(at) {
            Some(layout.summary.center().y)
        } else {
            self.node_row_at(at.y).map(|row| self.row_middle(row))
        };
        if let Some(end) = self.stretch_edge_at(at) {
            return Hit::StretchEdge(end);
        }
        let Some(row_middle) = row_middle else { return Hit::Empty };
        if layout.summary.contains(at)
            && let Some(index) = self.grip_at(at.x)
        {
            return Hit::Grip(index);
        }
        match self.diamond_at(at.x) {
            Some(index) if (at.y - row_middle).abs() <= RADIUS + 3.0 => Hit::Diamond(index),
            _ if layout.summary.contains(at) => {
                let warned = self.half_turn_warnings().find(|(_, x)| (x - at.x).abs() <= REACH + 3.0);
                warned.map_or(Hit::Empty, |(index, _)| Hit::HalfTurnWarning(index))
            }
            _ => Hit::Empty,
        }
    }

    /// The keyframes whose pictures are in sight, and where those stand: all of them where there is room, else every second, every
    /// fourth and so on, so that panning changes none.
    #[must_use]
    pub fn thumbnails(&self) -> Vec<(usize, Rect)> {
        if self.layout.strip.height() <= 0.0 {
            return Vec::new();
        }
        let least = THUMBNAIL.x + 4.0;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "floats saturate")]
        let stride = (f64::from(least) / self.scale.view.points_per_unit).ceil().clamp(1.0, 1e6) as usize;
        let stride = stride.next_power_of_two();
        let seen = self.columns.within(&self.scale.in_sight(THUMBNAIL.x));
        let mut free_from = f32::NEG_INFINITY;
        let mut found = Vec::new();
        for index in (seen.start.next_multiple_of(stride)..seen.end).step_by(stride) {
            let x = self.scale.x_of(self.columns.time(index));
            if x >= free_from {
                free_from = x + least;
                let centre = pos2(x, self.layout.strip.center().y);
                found.push((index, Rect::from_center_size(centre, THUMBNAIL)));
            }
        }
        found
    }

    /// The intervals in sight in which a node turns by nearly half a turn, and where their marks stand: in the middle, or beside the
    /// easing there.
    pub fn half_turn_warnings(&self) -> impl Iterator<Item = (usize, f32)> + '_ {
        let keyframes = self.columns.keyframes();
        let nodes = keyframes.first().map_or(0, |keyframe| keyframe.pose.len());
        let seen = self.columns.within(&self.scale.in_sight(0.0));
        // Where hundreds are in sight, none has room.
        let seen = if seen.len() > 200 { 0..0 } else { seen.start.saturating_sub(1)..seen.end };
        seen.filter_map(move |index| {
            let from = self.scale.x_of(self.columns.time(index));
            let to = self.scale.x_of(self.columns.time_after(index));
            if to - from < LEAST_FOR_WARNING || !has_half_turn(keyframes, index, 0..nodes) {
                return None;
            }
            let has_easing = keyframes[index].easing != Easing::Linear && to - from >= LEAST_FOR_EASING;
            Some((index, f32::midpoint(from, to) - if has_easing { 25.0 } else { 0.0 }))
        })
    }

    /// The keyframe whose column is at a horizontal position.
    #[must_use]
    pub fn diamond_at(&self, x: f32) -> Option<usize> {
        let index = self.columns.nearest(self.scale.time_at(x))?;
        ((self.scale.x_of(self.columns.time(index)) - x).abs() <= RADIUS + 1.5).then_some(index)
    }

    /// The box around the selected keyframes, over the rows of nodes: there is room for its edges.
    #[must_use]
    pub fn stretch_box(&self) -> Option<Rect> {
        let (first, last) = self.stretch.filter(|_| self.has_rows)?;
        let x = |index: usize| self.scale.x_of(self.columns.time(index));
        Some(Rect::from_x_y_ranges(x(first) - EDGE..=x(last) + EDGE, self.layout.nodes.y_range()))
    }

    fn stretch_edge_at(&self, at: Pos2) -> Option<StretchEnd> {
        let edges = self.stretch_box().filter(|edges| edges.y_range().contains(at.y))?;
        let is_near = |x: f32| (x - at.x).abs() <= EDGE_REACH;
        let ends = [(edges.right(), StretchEnd::End), (edges.left(), StretchEnd::Start)];
        ends.into_iter().find(|(x, _)| is_near(*x)).map(|(_, end)| end)
    }

    fn range_handle(&self, at: Pos2) -> Option<Hit> {
        let (first, last) = self.range.filter(|_| at.y >= self.layout.ruler.bottom() - RANGE_BAR - 2.0)?;
        let distance = |index: usize| (self.scale.x_of(self.columns.time(index)) - at.x).abs();
        let (to_first, to_last) = (distance(first), distance(last));
        if to_first.min(to_last) > REACH + 2.0 {
            None
        } else if to_first < to_last {
            Some(Hit::RangeStart)
        } else {
            Some(Hit::RangeEnd)
        }
    }

    /// Where the grip of the interval that begins at a keyframe stands, if it has one. It stands at the interval's end; that of the
    /// first at its beginning, which is the end that a change of its length moves.
    #[must_use]
    pub fn grip_x(&self, index: usize) -> Option<f32> {
        if index + 1 >= self.columns.len() {
            return None;
        }
        let from = self.scale.x_of(self.columns.time(index));
        let to = self.scale.x_of(self.columns.time(index + 1));
        (to - from >= LEAST_FOR_GRIP).then_some(if index == 0 { from + GRIP } else { to - GRIP })
    }

    fn grip_at(&self, x: f32) -> Option<usize> {
        let index = self.columns.insertion(self.scale.time_at(x)).checked_sub(1)?;
        self.grip_x(index).filter(|grip| (grip - x).abs() <= REACH).map(|_| index)
    }

    /// The row of a node at a height.
    #[must_use]
    pub fn node_row_at(&self, y: f32) -> Option<usize> {
        if !self.layout.nodes.y_range().contains(y) {
            return None;
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "floats saturate")]
        let row = ((y - self.layout.nodes.top() + self.scroll) / ROW).max(0.0) as usize;
        (row < self.rows).then_some(row)
    }

    /// The middle of a node's row.
    #[must_use]
    pub fn row_middle(&self, row: usize) -> f32 {
        self.row_rect(row).center().y
    }

    /// A node's row.
    #[must_use]
    pub fn row_rect(&self, row: usize) -> Rect {
        #[expect(clippy::cast_precision_loss, reason = "trees are not that long")]
        let top = self.layout.nodes.top() - self.scroll + row as f32 * ROW;
        Rect::from_min_size(pos2(self.layout.nodes.left(), top), vec2(self.layout.nodes.width(), ROW))
    }

    /// The rows of nodes that are in sight.
    #[must_use]
    pub fn rows_in_sight(&self) -> std::ops::Range<usize> {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "floats saturate")]
        let (first, end) = (
            (self.scroll / ROW).floor().max(0.0) as usize,
            ((self.scroll + self.layout.nodes.height()) / ROW).ceil().max(0.0) as usize,
        );
        first.min(self.rows)..end.min(self.rows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keyframe::{Keyframe, KeyframeList};
    use crate::pose::Pose;
    use crate::ui::timeline::scale::VisibleTime;

    fn check(at: Pos2, expected: Hit) {
        let list = KeyframeList::new((0..6).map(|_| Keyframe::new(Pose::new(Vec::new()))).collect());
        let mut columns = Columns::default();
        columns.update(&list);
        let layout = Layout::of(Rect::from_min_size(Pos2::ZERO, vec2(1000.0, 160.0)), true);
        // Keyframe k stands at 200 + 100 k.
        let view = VisibleTime { start: -1.0 - (200.0 - f64::from(LABELS)) / 100.0, points_per_unit: 100.0 };
        let scale = Scale { left: layout.tracks.left(), right: layout.tracks.right(), view };
        let target = Target {
            layout: &layout,
            scale: &scale,
            columns: &columns,
            range: Some((1, 4)),
            stretch: Some((2, 3)),
            has_rows: true,
            rows: 3,
            scroll: 0.0,
        };
        assert_eq!(target.at(at), expected, "at {at}");
    }

    #[test]
    fn everything_is_where_it_is_drawn() {
        let all = RULER + ROW / 2.0;
        check(pos2(350.0, 8.0), Hit::Ruler);
        check(pos2(303.0, RULER - 3.0), Hit::RangeStart);
        check(pos2(603.0, RULER - 3.0), Hit::RangeEnd);
        check(pos2(303.0, 8.0), Hit::Ruler);
        check(pos2(400.0, all), Hit::Diamond(2));
        check(pos2(405.0, all + 4.0), Hit::Diamond(2));
        check(pos2(350.0, all), Hit::Empty);
        check(pos2(387.0, all), Hit::Grip(1));
        check(pos2(213.0, all), Hit::Grip(0));
        check(pos2(400.0, all + ROW), Hit::Diamond(2));
        check(pos2(385.0, all + ROW), Hit::Empty);
        check(pos2(400.0, all + 3.0 * ROW), Hit::Diamond(2));
        check(pos2(400.0, all + 4.0 * ROW), Hit::Empty);
        check(pos2(700.0, all), Hit::Diamond(5));
        check(pos2(389.0, all + ROW), Hit::StretchEdge(StretchEnd::Start));
        check(pos2(511.0, all + ROW), Hit::StretchEdge(StretchEnd::End));
        check(pos2(511.0, all), Hit::Empty);
        check(pos2(900.0, all), Hit::Empty);
    }
}
