//! The strip of numbered keyframes, with the current one, the two that only steer, and the playhead.

use egui::scroll_area::ScrollSource;
use egui::{
    Align2, Color32, FontId, Painter, Pos2, Rect, RichText, Role, ScrollArea, Sense, Shape, Stroke, Ui, WidgetInfo,
    pos2, vec2,
};

use super::icons::{diamond, was_pressed};
use super::key_of;
use super::theme::{GRID, Tokens, number_font};
use super::words::Words;
use crate::editor::keymap::Keymap;
use crate::editor::{Command, Edit, Editor, PlaybackCommand};
use crate::keyframe::{KeyframeIndex, PlayRange};

/// Points from one keyframe to the next.
const STEP: f32 = 56.0;
/// Points before the first keyframe and after the last.
const MARGIN: f32 = 32.0;
/// Half a diamond.
const RADIUS: f32 = 7.0;
/// How far down the numbers stand.
const NUMBERS: f32 = 18.0;
/// How far down the diamonds stand.
const DIAMONDS: f32 = 44.0;

/// What the strip last showed, so that it scrolls only when that changes.
#[derive(Clone, Debug, Default)]
pub struct Strip {
    shown: Option<(Option<KeyframeIndex>, usize)>,
}

/// What one keyframe is.
#[derive(Clone, Copy)]
struct Mark {
    place: usize,
    is_current: bool,
    steers: bool,
}

impl Strip {
    /// Shows the strip.
    pub fn show(&mut self, ui: &mut Ui, editor: &Editor, keymap: &Keymap, commands: &mut Vec<Command>) {
        let words = Words::of(ui);
        let count = editor.document().keyframes.len();
        if count == 0 {
            empty(ui, keymap);
            return;
        }
        let room = ui.available_size();
        let hint = missing(count, words, &key_of(keymap, &Command::Edit(Edit::CreateKeyframe)));
        let width = (points(count - 1) * STEP + 2.0 * MARGIN + if hint.is_some() { 420.0 } else { 0.0 }).max(room.x);
        let target = self.target(editor);
        ScrollArea::horizontal().auto_shrink(false).scroll_source(ScrollSource::ALL).show_viewport(ui, |ui, seen| {
            ui.set_width(width);
            ui.set_height(room.y - GRID);
            let origin = ui.max_rect().left_top();
            if let Some(target) = target {
                let x = origin.x + MARGIN + target * STEP;
                let around = Rect::from_center_size(pos2(x, origin.y), vec2(2.5 * STEP, 1.0));
                ui.scroll_to_rect_animation(around, None, egui::style::ScrollAnimation::none());
            }
            keyframes(ui, editor, origin, seen, commands);
            if let Some(hint) = hint {
                let at = pos2(origin.x + 2.0 * MARGIN + points(count - 1) * STEP, origin.y + DIAMONDS);
                ui.painter().text(at, Align2::LEFT_CENTER, hint, FontId::proportional(12.0), Tokens::of(ui).dim);
            }
        });
    }

    /// Where to scroll, in keyframes from the first: to the playhead, or to a current keyframe that is another than before.
    fn target(&mut self, editor: &Editor) -> Option<f32> {
        let keyframes = &editor.document().keyframes;
        let now = (keyframes.current(), keyframes.len());
        let is_new = self.shown.replace(now) != Some(now);
        if editor.is_playing() {
            playhead(editor)
        } else {
            now.0.filter(|_| is_new).map(|current| points(current.get()))
        }
    }
}

fn empty(ui: &mut Ui, keymap: &Keymap) {
    let tokens = Tokens::of(ui);
    let new = key_of(keymap, &Command::Edit(Edit::CreateKeyframe));
    let play = key_of(keymap, &Command::Playback(PlaybackCommand::PlayOrStop));
    let text = Words::of(ui).fill(
        "No keyframes yet: pose the robots, press {} to keep a pose. Four make an animation; {} plays it.",
        &[&new, &play],
    );
    ui.centered_and_justified(|ui| ui.label(RichText::new(text).color(tokens.dim)));
}

/// What to say while there are too few to play.
fn missing(count: usize, words: Words, key: &str) -> Option<String> {
    match count {
        1 | 2 => {
            let left = (4 - count).to_string();
            Some(words.fill("{} more keyframes make an animation: pose, then press {}.", &[&left, key]))
        }
        3 => Some(words.fill("1 more keyframe makes an animation: pose, then press {}.", &[key])),
        _ => None,
    }
}

fn keyframes(ui: &Ui, editor: &Editor, origin: Pos2, seen: Rect, commands: &mut Vec<Command>) {
    let list = &editor.document().keyframes;
    let count = list.len();
    let tokens = Tokens::of(ui);
    let x_of = |place: f32| origin.x + MARGIN + place * STEP;
    let plays = PlayRange::new(list).is_ok();
    if plays {
        let band = Rect::from_x_y_ranges(
            x_of(1.0)..=x_of(points(count - 2)),
            origin.y + DIAMONDS - 14.0..=origin.y + DIAMONDS + 14.0,
        );
        ui.painter().rect_filled(band.expand2(vec2(14.0, 0.0)), 6.0, tokens.hovered);
        ui.painter().hline(band.x_range(), origin.y + DIAMONDS, Stroke::new(2.0, tokens.strong_line));
    }
    let first = place_at(seen.left());
    let last = place_at(seen.right()).saturating_add(1).min(count - 1);
    for place in first..=last {
        let mark = Mark {
            place,
            is_current: list.current() == Some(KeyframeIndex::new(place)),
            steers: plays && (place == 0 || place == count - 1),
        };
        if keyframe(ui, mark, pos2(x_of(points(place)), origin.y)) {
            commands.push(Command::Edit(Edit::GoTo(KeyframeIndex::new(place))));
        }
    }
    if let Some(at) = playhead(editor) {
        head(ui.painter(), x_of(at), origin.y, tokens.accent);
    }
}

fn keyframe(ui: &Ui, mark: Mark, top: Pos2) -> bool {
    let tokens = Tokens::of(ui);
    let area = Rect::from_min_max(top + vec2(-STEP * 0.4, 4.0), top + vec2(STEP * 0.4, DIAMONDS + 16.0));
    let response = ui.interact(area, ui.scope_id().with(("keyframe", mark.place)), Sense::click());
    let words = Words::of(ui);
    let name = words.fill("Keyframe {}", &[&mark.place.to_string()]);
    response.widget_info(|| WidgetInfo::selected(Role::ListBoxOption, true, mark.is_current, &name));
    let centre = top + vec2(0.0, DIAMONDS);
    let is_hot = response.hovered() || response.has_focus();
    let colour = match (mark.is_current, is_hot) {
        (true, _) => tokens.accent,
        (false, true) => tokens.text,
        (false, false) => tokens.dim,
    };
    let radius = if mark.is_current { RADIUS + 1.5 } else { RADIUS };
    let stroke = Stroke::new(1.5, colour);
    diamond(ui.painter(), centre, radius, if mark.steers { tokens.window } else { colour }, stroke);
    let number = pos2(centre.x, top.y + NUMBERS);
    let text = if mark.is_current { tokens.accent } else { colour };
    ui.painter().text(number, Align2::CENTER_CENTER, mark.place, number_font(), text);
    let tip = match (mark.steers, mark.is_current) {
        (true, _) => words.fill("{} only steers the spline: it is not played", &[&name]),
        (false, true) => words.fill("{}, the current one", &[&name]),
        (false, false) => words.fill("Go to keyframe {}", &[&mark.place.to_string()]),
    };
    was_pressed(&response.on_hover_text(tip))
}

/// Where the playhead is, in keyframes from the first.
#[expect(clippy::cast_possible_truncation, reason = "it is for pixels")]
fn playhead(editor: &Editor) -> Option<f32> {
    editor.key_time().map(|key_time| key_time as f32 + 1.0)
}

fn head(painter: &Painter, x: f32, top: f32, colour: Color32) {
    painter.vline(x, top + 6.0..=top + DIAMONDS + 20.0, Stroke::new(1.5, colour));
    let corners = vec![pos2(x - 5.0, top + 1.0), pos2(x + 5.0, top + 1.0), pos2(x, top + 8.0)];
    painter.add(Shape::convex_polygon(corners, colour, Stroke::NONE));
}

#[expect(clippy::cast_precision_loss, reason = "it is for pixels")]
const fn points(place: usize) -> f32 {
    place as f32
}

/// The keyframe at or before a place on the strip.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "floats saturate, and below the first is the first"
)]
fn place_at(x: f32) -> usize {
    ((x - MARGIN) / STEP).floor().max(0.0) as usize
}
