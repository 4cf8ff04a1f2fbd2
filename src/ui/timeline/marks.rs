//! Thumbnails of keyframes and half turn warnings on the timeline.

use egui::{Painter, Rect, Shape, Stroke, StrokeKind, pos2, vec2};

use super::half_turn::has_half_turn;
use super::hit::{Hit, Target};
use super::paint::Look;
use super::rows::{Row, Subject};
use crate::keyframe::KeyframeIndex;
use crate::ui::icons::{Icon, paint};
use crate::ui::theme::CORNER;
use crate::ui::thumbnails::Thumbnails;

/// Draws the strip of small pictures; those that are not there yet are asked for.
pub fn strip(painter: &Painter, look: &Look<'_>, thumbnails: &mut Thumbnails) {
    let Target { layout, columns, .. } = look.target;
    let (tokens, editor) = (look.tokens, look.editor);
    let painter = painter.with_clip_rect(layout.strip.intersect(painter.clip_rect()));
    let current = editor.document().keyframes.current();
    for (index, rect) in look.target.thumbnails() {
        let keyframe_index = KeyframeIndex::new(index);
        let Some(keyframe) = columns.keyframes().get(index) else { continue };
        thumbnails.paint(&painter, rect, (index, &keyframe.pose), tokens);
        let is_selected = editor.session().selected.binary_search(&keyframe_index).is_ok();
        let border = if current == Some(keyframe_index) {
            Stroke::new(2.0, tokens.accent)
        } else if is_selected {
            Stroke::new(2.0, tokens.selected)
        } else if look.hovered == Some(Hit::Diamond(index)) {
            Stroke::new(1.0, tokens.text)
        } else {
            Stroke::new(1.0, tokens.strong_line)
        };
        painter.rect_stroke(rect, CORNER, border, StrokeKind::Inside);
        if is_selected && current == Some(keyframe_index) {
            painter.rect_stroke(rect.expand(1.5), CORNER, Stroke::new(1.5, tokens.selected), StrokeKind::Inside);
        }
    }
}

/// Marks intervals in which a node turns by nearly half a turn: on the row of all, and on the rows of those nodes.
pub fn half_turns(painter: &Painter, look: &Look<'_>, rows: &[Row]) {
    let Target { layout, columns, .. } = look.target;
    let intervals: Vec<(usize, f32)> = look.target.half_turn_warnings().collect();
    let summary = painter.with_clip_rect(layout.summary.intersect(painter.clip_rect()));
    for &(index, x) in &intervals {
        let centre = pos2(x, layout.summary.center().y);
        let colour =
            if look.hovered == Some(Hit::HalfTurnWarning(index)) { look.tokens.text } else { look.tokens.error };
        let behind = [centre + vec2(0.0, -9.0), centre + vec2(9.5, 7.5), centre + vec2(-9.5, 7.5)];
        summary.add(Shape::convex_polygon(behind.to_vec(), look.tokens.panel, Stroke::NONE));
        paint(&summary, Icon::Warning, centre, colour);
    }
    let nodes = painter.with_clip_rect(layout.nodes.intersect(painter.clip_rect()));
    for row in look.target.rows_in_sight() {
        let Subject::Rbt { rbts, .. } = &rows[row].subject else { continue };
        for &(index, x) in &intervals {
            if has_half_turn(columns.keyframes(), index, rbts.clone()) {
                let line = Rect::from_center_size(pos2(x, look.target.row_middle(row)), vec2(14.0, 2.0));
                nodes.rect_filled(line, 1.0, look.tokens.error);
            }
        }
    }
}
