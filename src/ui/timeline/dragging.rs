//! What a drag on the timeline shows: how far it went, what it surrounds, where keyframes would go.

use egui::{Painter, Pos2, Rect, Shape, Stroke, pos2, vec2};

use super::columns::Columns;
use super::drag::Drag;
use super::hit::{Hit, RADIUS, Target};
use super::paint::{Look, keyframes, ruler_font};
use super::retime::Moving;
use crate::keyframe::StretchEnd;
use crate::ui::icons::diamond;
use crate::ui::theme::CORNER;
use crate::words::texts;

/// The preview of the current drag.
pub fn show(painter: &Painter, look: &Look<'_>, drag: &Drag, surrounded: Option<Rect>, at: Pos2) {
    let Target { layout, scale, columns, .. } = look.target;
    let tokens = look.tokens;
    match drag {
        Drag::Box { .. } => {
            if let Some(rect) = surrounded {
                painter.rect_filled(rect, 2.0, tokens.selected.gamma_multiply(0.12));
                painter.rect_stroke(rect, 2.0, Stroke::new(1.0, tokens.selected), egui::StrokeKind::Inside);
            }
        }
        Drag::Move(moving) => moved(painter, look, moving, at),
        Drag::Retime(retime) => {
            let Some(keyframe) = keyframes(look).get(retime.index) else { return };
            let seconds = keyframe.duration * f64::from(look.editor.document().ms_between_keyframes) / 1000.0;
            let (steps, seconds) = (format!("{:.2}", keyframe.duration), format!("{seconds:.2}"));
            let text = if retime.last_ripple_free {
                look.words.message(texts::steps_and_seconds_rippling(&steps, &seconds))
            } else {
                look.words.message(texts::steps_and_seconds(&steps, &seconds))
            };
            let from = scale.x_of(columns.time(retime.index));
            let to = scale.x_of(columns.time_after(retime.index));
            let y = layout.summary.bottom() + 6.0;
            let span = Stroke::new(1.5, tokens.accent);
            painter.hline(from..=to, y, span);
            painter.vline(from, y - 3.0..=y + 3.0, span);
            painter.vline(to, y - 3.0..=y + 3.0, span);
            label(painter, look, pos2(f32::midpoint(from, to), y + 14.0), &text);
        }
        Drag::Scrub => {
            if let Some(key_time) = look.editor.key_time() {
                let time = columns.time_of_key(key_time);
                let seconds = time * f64::from(look.editor.document().ms_between_keyframes) / 1000.0;
                let at = pos2(scale.x_of(time), layout.ruler.bottom() + 10.0);
                label(painter, look, at + vec2(52.0, 0.0), &format!("{key_time:.2} · {seconds:.2} s"));
            }
        }
        Drag::PlayRange { .. } | Drag::Pan => {}
    }
}

/// A drag of keyframes: how far it went, or between which keyframes they would go.
fn moved(painter: &Painter, look: &Look<'_>, moving: &Moving, at: Pos2) {
    let words = look.words;
    let seconds = format!("{:+.2}", f64::from(moving.by_ms) / 1000.0);
    let text = if let Some(place) = moving.place {
        insertion(painter, look, moving, place, at);
        let place = place - moving.indices.iter().filter(|&&index| index < place).count();
        words.message(texts::moved_to_another_place(place))
    } else if let (Some(_), Some((first, last))) = (moving.end, look.target.stretch) {
        let span = |columns: &Columns| columns.time(last) - columns.time(first);
        let percent = 100.0 * span(look.target.columns) / span(&moving.before);
        words.message(texts::scaled_by_seconds(seconds, format!("{percent:.0}")))
    } else if moving.ripples() {
        words.message(texts::moved_by_seconds_rippling(seconds))
    } else if let Some((fixed, moved)) = moving.anchored() {
        let steps = (look.target.columns.time(moved) - look.target.columns.time(fixed)).abs();
        words.message(texts::moved_by_seconds_and_steps(seconds, format!("{steps:.2}")))
    } else {
        words.message(texts::moved_by_seconds(seconds))
    };
    label(painter, look, pos2(at.x, look.target.layout.summary.bottom() + 20.0), &text);
}

/// Where dragged keyframes would go in the list.
fn insertion(painter: &Painter, look: &Look<'_>, moving: &Moving, to: usize, at: Pos2) {
    let Target { layout, scale, .. } = look.target;
    let (tokens, columns) = (look.tokens, &moving.before);
    let (first, last) = columns.ends();
    let (before, after) = (to.checked_sub(1), (to < columns.len()).then_some(to));
    let x = match (before, after) {
        (Some(before), Some(after)) => f32::midpoint(scale.x_of(columns.time(before)), scale.x_of(columns.time(after))),
        (None, _) => scale.x_of(first) - 14.0,
        (_, None) => scale.x_of(last) + 14.0,
    };
    painter.vline(x, layout.ruler.bottom() - 2.0..=layout.tracks.bottom(), Stroke::new(2.0, tokens.selected));
    let tip = |dx: f32, dy: f32| pos2(x + dx, layout.ruler.bottom() - 4.0 + dy);
    let corners = vec![tip(-5.0, -4.0), tip(5.0, -4.0), tip(0.0, 4.0)];
    painter.add(Shape::convex_polygon(corners, tokens.selected, Stroke::NONE));
    let grabbed = columns.time(moving.grabbed);
    let colour = tokens.selected.gamma_multiply(0.6);
    for &index in moving.indices.iter().take(100) {
        let x = scale.x_of(moving.time(at.x) + columns.time(index) - grabbed);
        if layout.tracks.x_range().contains(x) {
            diamond(painter, pos2(x, layout.summary.center().y), RADIUS, colour, Stroke::NONE);
        }
    }
}

/// The box around the selected keyframes, whose edges scale them in time.
pub fn stretch_box(painter: &Painter, look: &Look<'_>, drag: Option<&Drag>) {
    let Some(edges) = look.target.stretch_box() else { return };
    let colour = look.tokens.selected;
    painter.rect_filled(edges, 0.0, colour.gamma_multiply(0.08));
    for (x, end) in [(edges.left(), StretchEnd::Start), (edges.right(), StretchEnd::End)] {
        let is_hot = match drag {
            Some(Drag::Move(moving)) => moving.end == Some(end),
            Some(_) => false,
            None => look.hovered == Some(Hit::StretchEdge(end)),
        };
        let stroke =
            Stroke::new(if is_hot { 3.0 } else { 1.0 }, if is_hot { colour } else { colour.gamma_multiply(0.6) });
        painter.vline(x, edges.y_range(), stroke);
    }
}

/// A label over the tracks, kept within them.
pub(super) fn label(painter: &Painter, look: &Look<'_>, centre: Pos2, text: &str) {
    let tokens = look.tokens;
    let galley = painter.layout_no_wrap(text.to_owned(), ruler_font(), tokens.text);
    let size = galley.size() + vec2(12.0, 6.0);
    let tracks = look.target.layout.tracks;
    let least = tracks.left() + size.x / 2.0 + 2.0;
    let x = centre.x.min(tracks.right() - size.x / 2.0 - 2.0).max(least);
    let rect = Rect::from_center_size(pos2(x, centre.y), size);
    painter.rect_filled(rect, CORNER, tokens.raised);
    painter.rect_stroke(rect, CORNER, Stroke::new(1.0, tokens.strong_line), egui::StrokeKind::Inside);
    painter.galley(rect.min + vec2(6.0, 3.0), galley, tokens.text);
}
