//! Painting of the timeline: ruler, rows, diamonds, playhead. Input is handled elsewhere.

use egui::{Align2, Color32, FontFamily, FontId, Painter, Rect, Shape, Stroke, pos2, vec2};

use super::drag::Drag;
use super::hit::{Hit, LEAST_FOR_EASING, LEAST_GAP, RADIUS, RANGE_BAR, SMALL_RADIUS, Target};
use super::numbers;
use super::rows::{Row, Subject, differs};
use super::scale::{marks, seconds_text};
use crate::editor::Editor;
use crate::keyframe::{Easing, Keyframe, KeyframeIndex};
use crate::ui::icons::diamond;
use crate::ui::theme::{CORNER, Tokens};
use crate::ui::words::Words;

/// Points from one labelled second to the next, at least.
const SECONDS_APART: f64 = 72.0;
/// How many keyframes of a merged group are looked at for a difference.
const LOOKED_AT: usize = 16;

/// Everything that painting needs.
#[derive(Clone, Copy)]
pub struct Look<'a> {
    /// All state.
    pub editor: &'a Editor,
    /// Where everything is.
    pub target: &'a Target<'a>,
    /// The current colours.
    pub tokens: &'a Tokens,
    /// The current language's words.
    pub words: Words,
    /// The widget under the pointer.
    pub hovered: Option<Hit>,
}

/// The font of the ruler.
pub(super) fn ruler_font() -> FontId {
    FontId::new(10.0, FontFamily::Monospace)
}

pub(super) fn keyframes<'a>(look: &Look<'a>) -> &'a [Keyframe] {
    look.editor.document().keyframes.as_slice()
}

/// Fills the background, lighter in the played range. Each pixel is filled once.
pub fn ground(painter: &Painter, look: &Look<'_>) {
    let area = look.target.layout.scaled();
    let (played, outside) = (look.tokens.panel, look.tokens.window);
    let Some((from, to)) = played_x(look) else {
        painter.rect_filled(area, 0.0, outside);
        return;
    };
    let (from, to) = (from.clamp(area.left(), area.right()), to.clamp(area.left(), area.right()));
    painter.rect_filled(area.with_max_x(from), 0.0, outside);
    painter.rect_filled(Rect::from_x_y_ranges(from..=to, area.y_range()), 0.0, played);
    painter.rect_filled(area.with_min_x(to), 0.0, outside);
}

fn played_x(look: &Look<'_>) -> Option<(f32, f32)> {
    let (first, last) = look.target.range?;
    let x = |index: usize| look.target.scale.x_of(look.target.columns.time(index));
    Some((x(first), x(last)))
}

/// Seconds, the numbers and names of keyframes, and the bar of what plays.
pub fn ruler(painter: &Painter, look: &Look<'_>) {
    let (ruler, tokens) = (look.target.layout.ruler, look.tokens);
    let painter = painter.with_clip_rect(ruler.intersect(painter.clip_rect()));
    painter.hline(ruler.x_range(), ruler.bottom() - 0.5, Stroke::new(1.0, tokens.line));
    seconds(&painter, look);
    numbers::show(&painter, look);
    if let Some((from, to)) = played_x(look) {
        let y = ruler.bottom() - 3.5;
        painter.hline(from..=to, y, Stroke::new(2.0, tokens.strong_line));
        for (x, hit, side) in [(from, Hit::RangeStart, 1.0), (to, Hit::RangeEnd, -1.0)] {
            let colour = if look.hovered == Some(hit) { tokens.accent } else { tokens.dim };
            let (top, bottom) = (ruler.bottom() - RANGE_BAR, ruler.bottom());
            let corners = vec![pos2(x, top), pos2(x + side * 7.0, top + RANGE_BAR / 2.0), pos2(x, bottom)];
            painter.add(Shape::convex_polygon(corners, colour, Stroke::NONE));
        }
    }
}

fn seconds(painter: &Painter, look: &Look<'_>) {
    let (ruler, tokens, scale) = (look.target.layout.ruler, look.tokens, look.target.scale);
    let seconds_per_unit = f64::from(look.editor.document().ms_between_keyframes) / 1000.0;
    let (step, parts) = marks(scale.view.points_per_unit / seconds_per_unit, SECONDS_APART);
    let small_step = step / f64::from(parts);
    let seen = scale.in_sight(40.0);
    #[expect(clippy::cast_possible_truncation, reason = "there are few marks in sight")]
    let (first, last) = (
        (seen.start() * seconds_per_unit / small_step).floor() as i64,
        (seen.end() * seconds_per_unit / small_step).ceil() as i64,
    );
    for mark in first.max(0)..=last {
        #[expect(clippy::cast_precision_loss, reason = "there are few marks in sight")]
        let at = mark as f64 * small_step;
        let x = scale.x_of(at / seconds_per_unit).round() + 0.5;
        let is_labelled = mark % i64::from(parts) == 0;
        let length = if is_labelled { 13.0 } else { 4.0 };
        let colour = if is_labelled { tokens.strong_line } else { tokens.line };
        painter.vline(x, ruler.top()..=ruler.top() + length, Stroke::new(1.0, colour));
        if is_labelled {
            let text = seconds_text(at, step);
            painter.text(pos2(x + 8.0, ruler.top() + 7.0), Align2::LEFT_CENTER, text, ruler_font(), tokens.dim);
        }
    }
}

/// Lines between rows and at the current keyframe.
pub fn lines(painter: &Painter, look: &Look<'_>) {
    let Target { layout, scale, columns, .. } = look.target;
    let line = Stroke::new(1.0, look.tokens.line);
    painter.hline(layout.tracks.x_range(), layout.summary.bottom() - 0.5, line);
    let nodes = painter.with_clip_rect(layout.nodes.intersect(painter.clip_rect()));
    for row in look.target.rows_in_sight() {
        nodes.hline(layout.tracks.x_range(), look.target.row_rect(row).bottom() - 0.5, line);
    }
    if let Some(current) = look.editor.document().keyframes.current() {
        let x = scale.x_of(columns.time(current.get())).round() + 0.5;
        painter.vline(x, layout.tracks.y_range(), Stroke::new(1.0, look.tokens.strong_line));
    }
}

/// How the diamonds of a group of keyframes look.
#[derive(Clone, Copy)]
struct Group {
    start: usize,
    end: usize,
    is_current: bool,
    is_selected: bool,
    is_hot: bool,
    steers: bool,
}

fn groups<'a>(look: &'a Look<'a>) -> impl Iterator<Item = (f32, Group)> + 'a {
    let Target { scale, columns, range, .. } = *look.target;
    let current = look.editor.document().keyframes.current().map(KeyframeIndex::get);
    let selected = &look.editor.session().selected;
    let count = columns.len();
    columns.groups(scale.in_sight(RADIUS + 2.0), scale.units(LEAST_GAP)).map(move |group| {
        let first_selected = selected.partition_point(|index| index.get() < group.start);
        let is_selected = selected.get(first_selected).is_some_and(|index| index.get() < group.end);
        let is_current = current.is_some_and(|current| group.contains(&current));
        let stands_for = if is_current { current.unwrap_or(group.start) } else { group.start };
        let is_hot = matches!(look.hovered, Some(Hit::Diamond(index)) if group.contains(&index));
        let steers = range.is_some() && (group.start == 0 || group.end == count) && group.len() == 1;
        let x = scale.x_of(columns.time(stands_for));
        (x, Group { start: group.start, end: group.end, is_current, is_selected, is_hot, steers })
    })
}

/// Diamonds are smaller where they stand close together.
fn radius(look: &Look<'_>, most: f32) -> f32 {
    #[expect(clippy::cast_possible_truncation, reason = "it is for points on a screen")]
    let gap = look.target.scale.view.points_per_unit as f32;
    (gap.max(LEAST_GAP) * 0.45).clamp(2.7, most)
}

/// The summary row of all nodes: the intervals with their easings and grips, and a diamond for each keyframe.
pub fn summary(painter: &Painter, look: &Look<'_>, drag: Option<&Drag>) {
    let Target { layout, scale, columns, .. } = look.target;
    let tokens = look.tokens;
    let y = layout.summary.center().y;
    let painter = painter.with_clip_rect(layout.summary.intersect(painter.clip_rect()));
    let (first, last) = columns.ends();
    if columns.len() > 1 {
        painter.hline(scale.x_of(first)..=scale.x_of(last), y, Stroke::new(1.0, tokens.strong_line));
    }
    if let Some((from, to)) = played_x(look) {
        painter.hline(from..=to, y, Stroke::new(2.0, tokens.strong_line));
    }
    intervals(&painter, look, drag);
    let most = radius(look, RADIUS);
    for (x, group) in groups(look) {
        let colour = colour(&group, tokens);
        let radius = if group.is_current { most + 1.5 } else { most };
        let is_filled = !group.steers || group.is_selected;
        let fill = if is_filled { colour } else { tokens.window };
        diamond(&painter, pos2(x, y), radius, fill, Stroke::new(1.5, colour));
        if group.is_selected {
            diamond(&painter, pos2(x, y), radius + 2.5, Color32::TRANSPARENT, Stroke::new(1.5, tokens.selected));
        }
    }
}

fn colour(group: &Group, tokens: &Tokens) -> Color32 {
    if group.is_current {
        tokens.accent
    } else if group.is_selected {
        tokens.selected
    } else if group.is_hot {
        tokens.text
    } else {
        tokens.dim
    }
}

/// Easings and grips of the intervals that are long enough to show them.
fn intervals(painter: &Painter, look: &Look<'_>, drag: Option<&Drag>) {
    let Target { layout, scale, columns, .. } = look.target;
    let (tokens, keyframes) = (look.tokens, keyframes(look));
    let y = layout.summary.center().y;
    let seen = columns.within(&scale.in_sight(0.0));
    // Where hundreds are in sight, none has room.
    if seen.len() > 200 {
        return;
    }
    let dragged = match drag {
        Some(Drag::Retime(retime)) => Some(retime.index),
        _ => None,
    };
    let before = seen.start.saturating_sub(1);
    for (index, keyframe) in keyframes.iter().enumerate().take(seen.end).skip(before) {
        let Some(grip) = look.target.grip_x(index) else { continue };
        let is_hot = look.hovered == Some(Hit::Grip(index)) || dragged == Some(index);
        let colour = if is_hot { tokens.accent } else { tokens.strong_line };
        let bar = Rect::from_center_size(pos2(grip, y), if is_hot { vec2(3.0, 12.0) } else { vec2(2.0, 8.0) });
        painter.rect_filled(bar, 1.0, colour);
        let (from, to) = (scale.x_of(columns.time(index)), scale.x_of(columns.time(index + 1)));
        let easing = keyframe.easing;
        if easing != Easing::Linear && to - from >= LEAST_FOR_EASING {
            let middle = Rect::from_center_size(pos2(f32::midpoint(from, to), y), vec2(26.0, 14.0));
            painter.rect_filled(middle, CORNER, tokens.raised);
            curve(painter, middle.shrink(3.0), easing, Stroke::new(1.2, tokens.information));
        }
    }
}

/// A picture of an easing: its value over the interval.
pub fn curve(painter: &Painter, area: Rect, easing: Easing, stroke: Stroke) {
    const STEPS: u8 = 24;
    if easing == Easing::Hold {
        painter.line(vec![area.left_bottom(), area.right_bottom(), area.right_top()], stroke);
        return;
    }
    let points = (0..=STEPS).map(|step| {
        let fraction = f64::from(step) / f64::from(STEPS);
        #[expect(clippy::cast_possible_truncation, reason = "it is for points on a screen")]
        let (along, value) = (fraction as f32, easing.value(fraction) as f32);
        pos2(area.left() + along * area.width(), area.bottom() - value * area.height())
    });
    painter.line(points.collect(), stroke);
}

/// The rows of nodes: filled where a node stands as it did not before, hollow where it stands still.
pub fn nodes(painter: &Painter, look: &Look<'_>, rows: &[Row]) {
    let tokens = look.tokens;
    let keyframes = keyframes(look);
    let painter = painter.with_clip_rect(look.target.layout.nodes.intersect(painter.clip_rect()));
    let most = radius(look, SMALL_RADIUS);
    let in_sight = look.target.rows_in_sight();
    let groups: Vec<(f32, Group)> = groups(look).collect();
    for row in in_sight {
        let y = look.target.row_middle(row);
        let Subject::Rbt { rbts, .. } = &rows[row].subject else { continue };
        for (x, group) in &groups {
            let moves = (group.start..group.end.min(group.start + LOOKED_AT))
                .any(|index| index == 0 || differs(&keyframes[index].pose, &keyframes[index - 1].pose, rbts));
            let colour = match (moves, colour(group, tokens)) {
                (false, colour) if colour == tokens.dim => tokens.strong_line,
                (_, colour) => colour,
            };
            let centre = pos2(*x, y);
            if moves {
                diamond(
                    &painter,
                    centre,
                    most,
                    if group.steers { tokens.window } else { colour },
                    Stroke::new(1.2, colour),
                );
            } else {
                diamond(&painter, centre, most - 0.8, Color32::TRANSPARENT, Stroke::new(1.0, colour));
            }
        }
    }
}

/// The playhead, from the ruler down.
pub fn playhead(painter: &Painter, look: &Look<'_>) {
    let Some(key_time) = look.editor.playhead() else { return };
    let layout = look.target.layout;
    let x = look.target.scale.x_of(look.target.columns.time_of_key(key_time));
    let colour = look.tokens.accent;
    let top = layout.ruler.top();
    // The line leaves out the number of a keyframe that it stands at.
    painter.vline(x, top + 27.0..=layout.tracks.bottom(), Stroke::new(1.5, colour));
    let at = |dx: f32, dy: f32| pos2(x + dx, top + dy);
    let corners = vec![at(-5.5, 0.0), at(5.5, 0.0), at(5.5, 6.0), at(0.0, 12.0), at(-5.5, 6.0)];
    painter.add(Shape::convex_polygon(corners, colour, Stroke::NONE));
}
