//! The name of what is under the pointer over the scene, beside it.

use egui::{Rect, Ui, Vec2, vec2};

use super::theme::{CORNER, GRID, Tokens, small_font};
use super::words::Words;
use crate::words::Message;

/// Where the name stands, from the pointer, in points.
const BESIDE: Vec2 = vec2(16.0, 16.0);

/// Draws the name in the 3D view.
pub fn show(ui: &Ui, viewport: Rect, name: &Message) {
    let Some(pointer) = ui.ctx().pointer_latest_pos().filter(|at| viewport.contains(*at)) else { return };
    let tokens = Tokens::of(ui);
    let text = ui.painter().layout_no_wrap(Words::of(ui).message(name), small_font(), tokens.text);
    let size = text.size() + vec2(12.0, 8.0);
    // Within the view, wherever the pointer is.
    let room = viewport.shrink(GRID);
    let last = (room.max - size).max(room.min);
    let rect = Rect::from_min_size((pointer + BESIDE).clamp(room.min, last), size);
    ui.painter().rect_filled(rect, CORNER, tokens.over_scene);
    ui.painter().galley(rect.min + vec2(6.0, 4.0), text, tokens.text);
}
