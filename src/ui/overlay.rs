//! Small text over the scene: the eye and how a drag moves, and where the help is.

use egui::{Align2, Painter, Pos2, Rect, Ui, vec2};

use super::theme::{CORNER, GRID, Tokens, small_font};
use crate::editor::{Editor, Severity};

/// Draws the texts into the corners of the 3D view.
pub fn show(ui: &Ui, viewport: Rect, editor: &Editor) {
    let tokens = Tokens::of(ui);
    let painter = ui.painter();
    let margin = vec2(2.0 * GRID, -2.0 * GRID);
    let left = viewport.left_bottom() + margin;
    let mut after = tag(painter, left, Align2::LEFT_BOTTOM, &editor.view_sentence(), tokens.text, tokens);
    if editor.session().is_picking {
        after =
            tag(painter, next_to(after), Align2::LEFT_BOTTOM, "click what to move · Esc leaves", tokens.accent, tokens);
    }
    if editor.is_playing() {
        after = tag(painter, next_to(after), Align2::LEFT_BOTTOM, "playing · y stops", tokens.accent, tokens);
    } else if editor.is_paused() {
        after = tag(painter, next_to(after), Align2::LEFT_BOTTOM, "paused · Shift+P goes on", tokens.accent, tokens);
    }
    let message = editor.message();
    if !editor.session().shows_panels && !message.text.is_empty() {
        // There is no status line to say it.
        let colour = if message.severity == Severity::Error { tokens.error } else { tokens.text };
        tag(painter, next_to(after), Align2::LEFT_BOTTOM, &message.text, colour, tokens);
    }
    let right = viewport.right_bottom() + vec2(-margin.x, margin.y);
    tag(painter, right, Align2::RIGHT_BOTTOM, "[h] help", tokens.text, tokens);
}

fn next_to(rect: Rect) -> Pos2 {
    rect.right_bottom() + vec2(GRID, 0.0)
}

fn tag(painter: &Painter, at: Pos2, anchor: Align2, text: &str, colour: egui::Color32, tokens: &Tokens) -> Rect {
    let galley = painter.layout_no_wrap(text.to_owned(), small_font(), colour);
    let rect = anchor.anchor_size(at, galley.size() + vec2(12.0, 8.0));
    painter.rect_filled(rect, CORNER, tokens.over_scene);
    painter.galley(rect.min + vec2(6.0, 4.0), galley, colour);
    rect
}
