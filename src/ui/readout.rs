//! How far a handle was pulled, on a chip beside the pointer.

use egui::{FontFamily, FontId, Rect, Ui, vec2};

use super::theme::{CORNER, GRID, SMALL, Tokens, small_font};
use super::words::Words;
use crate::editor::Editor;

/// Where the chip is, from the pointer, in points.
const BESIDE: egui::Vec2 = vec2(18.0, 18.0);

/// Draws the chip in the 3D view, where a handle is held.
pub fn show(ui: &Ui, viewport: Rect, editor: &Editor) {
    let Some(readout) = editor.readout() else { return };
    let Some(pointer) = ui.ctx().pointer_latest_pos() else { return };
    let tokens = Tokens::of(ui);
    let words = Words::of(ui);
    let painter = ui.painter();
    // Figures of one width, so that nothing jitters.
    let font = FontId::new(SMALL + 1.0, FontFamily::Monospace);
    let text = painter.layout_no_wrap(words.message(readout.text), font, tokens.text);
    let axes = readout.axes.map(|axes| painter.layout_no_wrap(words.say(axes).to_owned(), small_font(), tokens.dim));
    let gap = if axes.is_some() { 2.0 * GRID } else { 0.0 };
    let axes_size = axes.as_ref().map_or(egui::Vec2::ZERO, |axes| axes.size());
    let size = vec2(text.size().x + gap + axes_size.x, text.size().y.max(axes_size.y)) + vec2(12.0, 8.0);
    // Within the view, wherever the pointer is.
    let room = viewport.shrink(GRID).size() - size;
    let corner = (pointer + BESIDE).to_vec2() - viewport.shrink(GRID).min.to_vec2();
    let min = viewport.shrink(GRID).min + corner.clamp(egui::Vec2::ZERO, room.max(egui::Vec2::ZERO));
    let rect = Rect::from_min_size(min, size);
    painter.rect_filled(rect, CORNER, tokens.over_scene);
    let text_width = text.size().x;
    painter.galley(rect.min + vec2(6.0, (size.y - text.size().y) * 0.5), text, tokens.text);
    if let Some(axes) = axes {
        painter.galley(rect.min + vec2(6.0 + text_width + gap, (size.y - axes_size.y) * 0.5), axes, tokens.dim);
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;
    use std::sync::Arc;

    use egui::{Pos2, Shape, pos2};

    use super::*;
    use crate::editor::gizmo::{Axis, DragKey, Handle};
    use crate::editor::{Command, GestureCommand, ViewCommand};
    use crate::pose::RbtIndex;
    use crate::words::Language;

    const VIEW: Rect = Rect { min: pos2(0.0, 24.0), max: pos2(600.0, 400.0) };

    /// The texts that are shown with the pointer somewhere, and where the chip is.
    fn shown(editor: &Editor, pointer: Pos2, language: &str) -> (Vec<String>, Rect) {
        let context = egui::Context::default();
        super::super::theme::install(&context);
        let language = Language::all().find(|known| known.code() == language).unwrap();
        Words::new(language).install(&context);
        let screen_rect = Some(Rect::from_min_size(Pos2::ZERO, vec2(800.0, 600.0)));
        let events = vec![egui::Event::PointerMoved(pointer)];
        let input = egui::RawInput { screen_rect, events, ..egui::RawInput::default() };
        let mut output = context.run_ui(input, |ui| show(ui, VIEW, editor));
        // Nothing is painted.
        output.textures_delta.clear();
        let (mut texts, mut chip) = (Vec::new(), Rect::NOTHING);
        for clipped in output.shapes {
            match clipped.shape {
                Shape::Text(text) => texts.push(text.galley.text().to_owned()),
                Shape::Rect(rect) => chip = rect.rect,
                _ => {}
            }
        }
        (texts, chip)
    }

    fn holding(keys: &[DragKey]) -> Editor {
        let scene = crate::scene::built_in_scene(crate::scene::DEFAULT_SCENE).unwrap();
        let mut editor = Editor::new(Arc::new(scene), PathBuf::from("animation.json"));
        editor.apply(Command::View(ViewCommand::Choose(Some(RbtIndex::new(2))))).unwrap();
        editor.apply(Command::Gesture(GestureCommand::Grab(Handle::TURN_IN_VIEW))).unwrap();
        for key in keys {
            editor.apply(key.command()).unwrap();
        }
        editor
    }

    #[test]
    fn the_chip_says_what_is_held_in_the_users_language() {
        let turned = holding(&[DragKey::Lock(Axis::Z), DragKey::Type('4')]);
        assert_eq!(shown(&turned, pos2(100.0, 100.0), "en").0, ["4|° about z", "local"]);
        assert_eq!(shown(&turned, pos2(100.0, 100.0), "ko").0, ["z축 둘레로 4|°", "로컬"]);
        assert_eq!(shown(&holding(&[]), pos2(100.0, 100.0), "en").0, ["+0.0° about the line of sight"]);
        let mut ended = holding(&[]);
        ended.apply(Command::Gesture(GestureCommand::Commit)).unwrap();
        assert!(shown(&ended, pos2(100.0, 100.0), "en").0.is_empty());
    }

    #[test]
    fn the_chip_is_beside_the_pointer_and_within_the_view() {
        let editor = holding(&[]);
        assert_eq!(shown(&editor, pos2(100.0, 100.0), "en").1.min, pos2(118.0, 118.0));
        for pointer in [pos2(599.0, 399.0), pos2(0.0, 0.0), pos2(790.0, 590.0)] {
            let (_, chip) = shown(&editor, pointer, "en");
            assert!(VIEW.contains_rect(chip), "{chip} with the pointer at {pointer}");
        }
    }
}
