//! Drawing of the timed key rows: names, diamonds, the playhead of their clock.

use egui::{Align2, Color32, Painter, Rect, Response, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};

use super::dragging::label;
use super::hit::SMALL_RADIUS;
use super::keyboard::Keyboard;
use super::labels::depth;
use super::paint::Look;
use super::rows::{Row, Subject, has_key_rows};
use super::timed_key_view::{KeyHit, KeyView, playhead};
use super::timed_keys::{Keys, add, pick, scene};
use super::tips::tip;
use crate::editor::{Command, KeyAt, SceneEdit, SelectionCommand};
use crate::scene::{Channel, KeyValue};
use crate::ui::access;
use crate::ui::angles::degrees_from_rotation;
use crate::ui::icons::{Icon, button_id, button_sensing, diamond, was_pressed};
use crate::ui::theme::{CORNER, ROW, Tokens, small_font, text_font};
use crate::ui::words::Words;
use crate::words::texts;

/// Diamonds of keys nearer together than this, in points, are drawn as one.
const LEAST_GAP: f32 = 3.0;

/// What people call a channel.
pub(super) fn channel_name(words: Words, channel: Channel) -> &'static str {
    match channel {
        Channel::Translation => words.say(texts::TRANSLATION),
        Channel::Rotation => words.say(texts::ROTATION),
        Channel::Scale => words.say(texts::SCALE),
        Channel::Colour => words.say(texts::COLOUR),
    }
}

/// A value as people read it.
pub(super) fn value_text(value: KeyValue) -> String {
    let three = |[x, y, z]: [f32; 3]| format!("{x:.2}  {y:.2}  {z:.2}");
    match value {
        KeyValue::Translation(value) | KeyValue::Scale(value) => three(value.to_array().map(|number| number + 0.0)),
        KeyValue::Rotation(value) => {
            let [yaw, pitch, roll] = degrees_from_rotation(value);
            format!("{yaw:.1}°  {pitch:.1}°  {roll:.1}°")
        }
        KeyValue::Colour(value) => value.to_hex(),
    }
}

/// The times in sight, those that are drawn as one only once.
fn seen(times: &[f64], view: &KeyView<'_>) -> Vec<f64> {
    let scale = view.target.scale;
    let (from, to) = (view.seconds_at(scale.left - 8.0), view.seconds_at(scale.right + 8.0));
    let gap = view.seconds(LEAST_GAP);
    let mut seen = Vec::new();
    let mut next = from;
    loop {
        let index = times.partition_point(|&at| at < next);
        let Some(&at) = times.get(index).filter(|&&at| at <= to) else { return seen };
        seen.push(at);
        next = at + gap;
    }
}

/// A row's name in the left column.
#[derive(Clone, Copy)]
pub struct RowPlace<'a> {
    /// The row.
    pub row: &'a Row,
    /// Its index, counted from the row of all, which is 0.
    pub index: usize,
    /// Where it is.
    pub rect: Rect,
    /// What of that is in sight.
    pub seen: Rect,
}

impl Keys {
    /// Draws the diamonds, the playhead, and what a drag would do.
    pub fn paint(&self, painter: &Painter, look: &Look<'_>, rows: &[Row]) {
        if !has_key_rows(look.editor.scene()) {
            return;
        }
        let view = KeyView { editor: look.editor, target: look.target, rows };
        let tokens = look.tokens;
        let nodes = painter.with_clip_rect(look.target.layout.nodes.intersect(painter.clip_rect()));
        for row in look.target.rows_in_sight().filter(|&row| rows[row].has_keys()) {
            self.paint_row(&nodes, &view, tokens, row);
        }
        clock(painter, &view, tokens);
        let Some(at) = painter.ctx().input(|input| input.pointer.latest_pos()) else { return };
        if let Some(rect) = self.surrounded(&view, at) {
            painter.rect_filled(rect, 2.0, tokens.selected.gamma_multiply(0.12));
            painter.rect_stroke(rect, 2.0, Stroke::new(1.0, tokens.selected), egui::StrokeKind::Inside);
        }
        if let Some((seconds, by)) = self.dragged() {
            let label_at = pos2(view.x_of(seconds), (at.y - 22.0).max(look.target.layout.tracks.top() + 10.0));
            label(painter, look, label_at, &format!("{seconds:.3} s  ({by:+.3})"));
        }
    }

    fn paint_row(&self, painter: &Painter, view: &KeyView<'_>, tokens: &Tokens, row: usize) {
        let y = view.target.row_middle(row);
        let is_summary = matches!(view.rows[row].subject, Subject::Control);
        if !is_summary {
            for times in view.times(row) {
                if let [first, .., last] = times {
                    painter.hline(view.x_of(*first)..=view.x_of(*last), y, Stroke::new(1.0, tokens.strong_line));
                }
            }
        }
        let selected = &view.editor.session().selected_keys;
        let tracks = view.tracks(row);
        // Those selected are drawn last, so that none hides them.
        let mut marks: Vec<(bool, f64)> = Vec::new();
        for (track, times) in tracks.iter().zip(view.times(row)) {
            let of_track = selected.iter().filter(|key| key.track == *track).map(|key| (true, key.seconds));
            marks.extend(seen(times, view).into_iter().map(|at| (false, at)));
            marks.extend(of_track);
        }
        marks.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        marks.dedup();
        for (is_selected, seconds) in marks {
            let is_hot = self.hovered == Some(KeyHit { row, key: Some(seconds) });
            let colour = match (is_selected, is_hot) {
                (true, _) => tokens.selected,
                (false, true) => tokens.text,
                (false, false) => tokens.dim,
            };
            let radius = if is_summary { SMALL_RADIUS - 0.7 } else { SMALL_RADIUS };
            let fill = if is_summary && !is_selected { Color32::TRANSPARENT } else { colour };
            diamond(painter, pos2(view.x_of(seconds), y), radius, fill, Stroke::new(1.2, colour));
            if is_selected {
                diamond(
                    painter,
                    pos2(view.x_of(seconds), y),
                    radius + 2.5,
                    Color32::TRANSPARENT,
                    Stroke::new(1.2, colour),
                );
            }
        }
    }

    /// Makes the diamonds of the rows in sight known to the keyboard and to screen readers: Space selects one, Enter opens its numbers.
    pub fn diamonds(
        &mut self,
        ui: &Ui,
        view: &KeyView<'_>,
        tokens: &Tokens,
        keyboard: &mut Keyboard,
        commands: &mut Vec<Command>,
    ) {
        let words = Words::of(ui);
        let scene = view.editor.scene();
        self.open_selected(ui, view);
        for row in view.target.rows_in_sight().filter(|&row| view.rows[row].has_keys()) {
            if matches!(view.rows[row].subject, Subject::Control) {
                continue;
            }
            let path = &scene.node(view.rows[row].node).path;
            for (track, times) in view.tracks(row).iter().zip(view.times(row)) {
                for seconds in seen(times, view) {
                    let centre = pos2(view.x_of(seconds), view.target.row_middle(row));
                    let area = Rect::from_center_size(centre, vec2(2.0 * SMALL_RADIUS, ROW - 4.0));
                    let area = area.intersect(view.target.layout.nodes);
                    let id = ui.scope_id().with(("key", track, seconds.to_bits()));
                    let sense = keyboard.item(ui, id, row + 1, centre.x, Sense::empty());
                    let response = ui.interact(area, id, sense);
                    let key = KeyAt { track: track.clone(), seconds };
                    let is_selected = view.editor.session().selected_keys.contains(&key);
                    let channel = channel_name(words, track.channel);
                    let says = words.message(texts::channel_of_at(channel, path, seconds.to_string()));
                    access::item(&response, Role::ListBoxOption, true, is_selected, &says);
                    if !response.has_focus() {
                        continue;
                    }
                    let stroke = Stroke::new(1.0, tokens.accent);
                    ui.painter().rect_stroke(area, 3.0, stroke, egui::StrokeKind::Outside);
                    let (space, enter, modifiers) = ui.input(|input| {
                        (input.key_pressed(egui::Key::Space), input.key_pressed(egui::Key::Enter), input.modifiers)
                    });
                    let hit = KeyHit { row, key: Some(seconds) };
                    if space || enter {
                        pick(view, hit, modifiers, commands);
                    }
                    if enter {
                        self.open_menu(view, hit, area.center_bottom());
                    }
                }
            }
        }
    }

    /// Enter opens the numbers of the first selected key in sight, unless the keyboard is somewhere else.
    fn open_selected(&mut self, ui: &Ui, view: &KeyView<'_>) {
        let is_elsewhere = ui.memory(|memory| memory.focused().is_some() || memory.top_modal_layer().is_some());
        if is_elsewhere || self.menu.is_some() || view.editor.is_dragging() {
            return;
        }
        let selected = &view.editor.session().selected_keys;
        if selected.is_empty() || !ui.input(|input| input.key_pressed(egui::Key::Enter)) {
            return;
        }
        // The row of one channel says more than that of all channels of its node, which shows where it is folded.
        let rows = view.target.rows_in_sight().filter(|&row| view.rows[row].has_keys());
        let found = rows.filter_map(|row| {
            let tracks = view.tracks(row);
            let key = selected.iter().find(|key| tracks.contains(&key.track))?;
            Some((tracks.len(), row, key.seconds))
        });
        if let Some((_, row, seconds)) = found.min_by_key(|&(channels, row, _)| (channels, row)) {
            let at = pos2(view.x_of(seconds), view.target.row_rect(row).bottom());
            self.open_menu(view, KeyHit { row, key: Some(seconds) }, at);
        }
    }

    /// Shows the name of a row of keys: a click selects all its keys, the button adds one at the playhead.
    pub fn label(
        &mut self,
        ui: &Ui,
        painter: &Painter,
        look: &Look<'_>,
        place: RowPlace<'_>,
        keyboard: &mut Keyboard,
        commands: &mut Vec<Command>,
    ) {
        let RowPlace { row, index, rect, seen } = place;
        let words = Words::of(ui);
        let scene = look.editor.scene();
        let node = scene.node(row.node);
        let rows = std::slice::from_ref(row);
        let view = KeyView { editor: look.editor, target: look.target, rows };
        let (name, says) = match row.subject {
            Subject::Channel(channel) => {
                let name = channel_name(words, channel);
                (name.to_owned(), words.message(texts::keys_of_channel(name, &node.path)))
            }
            Subject::Shape => {
                let name = words.say(texts::COLOUR);
                (format!("{} · {name}", node.name), words.message(texts::keys_of_channel(name, &node.path)))
            }
            _ => (node.name.clone(), words.message(texts::control_node(&node.path))),
        };
        let id = ui.scope_id().with(("keys", &says));
        let sense = keyboard.item(ui, id, index, rect.left(), Sense::click());
        let response = ui.interact(seen.shrink2(vec2(1.0, 0.0)), id, sense);
        let is_channel = matches!(row.subject, Subject::Channel(_));
        response.widget_info(|| WidgetInfo::labeled(Role::ListBoxOption, true, &says));
        self.paint_label(painter, look, row, rect, &name, &response);
        let add_area = Rect::from_center_size(pos2(rect.right() - 14.0, rect.center().y), vec2(22.0, ROW - 2.0));
        let about = if is_channel || matches!(row.subject, Subject::Shape) { says.clone() } else { node.path.clone() };
        let add_name = words.message(texts::add_key_at_playhead(&about));
        let is_inside = seen.contains(add_area.center());
        let can_add = is_inside && !look.editor.is_playing();
        let sense = if can_add {
            keyboard.item(ui, button_id(ui, &add_name), index, add_area.center().x, Sense::click())
        } else {
            Sense::hover()
        };
        if is_inside && button_sensing(ui, add_area, Icon::NewKeyframe, &add_name, "", sense, false) {
            add(&view, 0, playhead(look.editor), commands);
        }
        let text = if matches!(row.subject, Subject::Control) {
            words.say(texts::A_CONTROL_NODE_ITS_KEYS_STAND_AT)
        } else {
            words.say(texts::A_CLICK_SELECTS_ALL_KEYS_OF_THE)
        };
        let response = response.on_hover_text(text);
        if response.secondary_clicked()
            && let Some(at) = response.interact_pointer_pos()
        {
            self.open_menu(&view, KeyHit { row: 0, key: None }, at);
        }
        if was_pressed(&response) {
            let tracks = view.tracks(0).into_iter().zip(view.times(0));
            let keys = tracks.flat_map(|(track, times)| {
                times.iter().map(move |&seconds| KeyAt { track: track.clone(), seconds }).collect::<Vec<_>>()
            });
            commands.push(Command::Selection(SelectionCommand::TimedKeys(keys.collect())));
        }
    }

    #[expect(clippy::unused_self, reason = "it is a part of the rows")]
    fn paint_label(&self, painter: &Painter, look: &Look<'_>, row: &Row, rect: Rect, name: &str, response: &Response) {
        let tokens = look.tokens;
        let inside = rect.shrink2(vec2(3.0, 0.5));
        if response.hovered() {
            painter.rect_filled(inside, CORNER, tokens.raised);
        }
        if response.has_focus() {
            painter.rect_stroke(inside, CORNER, Stroke::new(1.0, tokens.accent), egui::StrokeKind::Inside);
        }
        let is_control = matches!(row.subject, Subject::Control);
        let text = pos2(rect.left() + 22.0 + 12.0 * depth(row), rect.center().y);
        let colour = if is_control { tokens.information } else { tokens.dim };
        let font = if row.depth == 0 { text_font() } else { small_font() };
        let room = painter.with_clip_rect(rect.with_max_x(rect.right() - 28.0).intersect(painter.clip_rect()));
        room.text(text, Align2::LEFT_CENTER, name, font, colour);
    }

    /// Says what the key under the pointer holds. Says whether there is one.
    pub fn tip(&self, response: &Response, look: &Look<'_>, rows: &[Row]) -> bool {
        let Some(KeyHit { row, key: Some(seconds) }) = self.hovered.filter(|hit| hit.row < rows.len()) else {
            return false;
        };
        let scene = look.editor.scene();
        let node = rows[row].node;
        response.clone().on_hover_ui_at_pointer(|ui| {
            let words = Words::of(ui);
            let channels = rows[row].channels(scene).iter();
            let here = channels.filter(|&&channel| scene.key_seconds(node, channel).contains(&seconds));
            let lines: Vec<String> = here
                .filter_map(|&channel| {
                    let value = scene.key_value_at(node, channel, seconds)?;
                    Some(format!("{}  {}", channel_name(words, channel), value_text(value)))
                })
                .collect();
            tip(ui, &format!("{seconds} s"), &lines.join("\n"), look);
        });
        true
    }
}

/// The playhead of the keys' clock: from the ruler's lower edge down.
fn clock(painter: &Painter, view: &KeyView<'_>, tokens: &Tokens) {
    let layout = view.target.layout;
    let x = view.x_of(view.editor.seconds());
    let top = layout.ruler.bottom() - 8.0;
    painter.vline(x, top..=layout.tracks.bottom(), Stroke::new(1.0, tokens.information));
    let corners = vec![pos2(x - 4.5, top - 4.0), pos2(x + 4.5, top - 4.0), pos2(x, top + 3.0)];
    painter.add(egui::Shape::convex_polygon(corners, tokens.information, Stroke::NONE));
}

/// Puts a control node above a node.
pub fn put_control_above(path: &str) -> Command {
    scene(SceneEdit::PutControlAbove(path.into()))
}
