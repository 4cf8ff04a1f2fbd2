//! Text over the scene: the eye, how a drag moves, and the hotkey of the help.

use egui::{Align2, Painter, Pos2, Rect, Ui, vec2};

use super::key_of;
use super::log::Log;
use super::statistics::Statistics;
use super::theme::{CORNER, GRID, Tokens, small_font};
use super::words::Words;
use crate::editor::keymap::Keymap;
use crate::editor::{Command, Editor, PlaybackCommand, Severity, ViewCommand};
use crate::words::texts;

/// Draws the texts into the corners of the 3D view.
pub fn show(ui: &Ui, viewport: Rect, editor: &Editor, keymap: &Keymap, log: &Log, statistics: Option<&Statistics>) {
    let tokens = Tokens::of(ui);
    let words = Words::of(ui);
    // In a small view a text may be longer than it.
    let painter = &ui.painter().with_clip_rect(viewport);
    let margin = vec2(2.0 * GRID, -2.0 * GRID);
    let left = viewport.left_bottom() + margin;
    let mut after =
        tag(painter, left, Align2::LEFT_BOTTOM, &words.message(editor.view_sentence()), tokens.text, tokens);
    let mut add = |text: &str, colour| after = tag(painter, next_to(after), Align2::LEFT_BOTTOM, text, colour, tokens);
    if editor.session().is_picking {
        add(words.say(texts::CLICK_WHAT_TO_MOVE_ESC_LEAVES), tokens.accent_text);
    }
    if editor.is_playing() {
        let key = key_of(keymap, &Command::Playback(PlaybackCommand::PlayOrStop));
        add(&words.message(texts::playing_stops(&key)), tokens.accent_text);
    } else if editor.is_paused() {
        let key = key_of(keymap, &Command::Playback(PlaybackCommand::PauseOrResume));
        add(&words.message(texts::paused_goes_on(&key)), tokens.accent_text);
    }
    let status = editor.status().filter(|message| !editor.session().shows_panels && !log.shows(message));
    if let Some(message) = status {
        // Without panels there is no status line.
        let colour = if message.severity() == Severity::Error { tokens.error } else { tokens.text };
        add(&words.message(message), colour);
    }
    if let Some(statistics) = statistics.filter(|_| !editor.session().shows_panels) {
        add(&statistics.sentence(words), tokens.text);
    }
    let key = key_of(keymap, &Command::View(ViewCommand::ToggleHelp));
    if !key.is_empty() {
        let right = viewport.right_bottom() + vec2(-margin.x, margin.y);
        let text = words.message(texts::key_for_help(&key));
        let width = painter.layout_no_wrap(text.clone(), small_font(), tokens.text).size().x + 12.0;
        if next_to(after).x + width <= right.x {
            tag(painter, right, Align2::RIGHT_BOTTOM, &text, tokens.text, tokens);
        }
    }
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
