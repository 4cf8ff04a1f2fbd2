//! The menu of a row of keys: a key's time and value as numbers, and what can be done with keys and control nodes.

use std::sync::Arc;

use egui::{
    Align, DragValue, Id, Layout, Popup, PopupAnchor, PopupCloseBehavior, PopupKind, Pos2, Response, RichText, Role,
    TextEdit, Ui, WidgetInfo, vec2,
};
use glam::Vec3;

use super::drag_of_number;
use super::rows::Subject;
use super::timed_key_rows::{channel_name, put_control_above};
use super::timed_key_view::{KeyHit, KeyView, playhead};
use super::timed_keys::{Keys, add, pick, scene};
use crate::colour::Colour;
use crate::editor::{
    Command, Edit, Editor, GestureCommand, KeyAt, SceneEdit, SelectionCommand, TimelineEdit, TrackPath,
};
use crate::rotation_rules::rotation_from_euler_degrees;
use crate::scene::{Channel, KeyValue, NodeId};
use crate::ui::angles::{degrees_from_rotation, say_of_angles};
use crate::ui::node_menu::item;
use crate::ui::theme::{GRID, ROW, Tokens};
use crate::ui::words::Words;
use crate::words::texts;

/// What the menu is for, while it is open.
#[derive(Clone, Debug, PartialEq)]
pub struct Menu {
    at: Pos2,
    is_new: bool,
    /// The node of the row, by its path.
    node: Arc<str>,
    subject: Subject,
    /// The time of the key that it is for, in seconds.
    key: Option<f64>,
    /// Where the pointer was, in seconds.
    seconds: f64,
    /// The key's time when a drag of that number began.
    dragged_from: Option<f64>,
    /// The angles last shown, so that they stay as they were typed.
    angles: Option<[f32; 3]>,
    name: String,
}

impl Keys {
    /// Opens the menu of a key, or of a row.
    pub(super) fn open_menu(&mut self, view: &KeyView<'_>, hit: KeyHit, at: Pos2) {
        let row = &view.rows[hit.row];
        let node = view.editor.scene().node(row.node);
        let is_on_tracks = view.target.layout.tracks.contains(at);
        self.menu = Some(Menu {
            at,
            is_new: true,
            node: node.path.as_str().into(),
            subject: row.subject.clone(),
            key: hit.key,
            seconds: if is_on_tracks { view.tidy_at(at.x) } else { playhead(view.editor) },
            dragged_from: None,
            angles: None,
            name: node.name.clone(),
        });
    }

    /// Shows the menu where the pointer asked for it. Says whether it is there, so that no other is.
    pub fn menu(&mut self, ui: &Ui, response: &Response, view: &KeyView<'_>, commands: &mut Vec<Command>) -> bool {
        let is_asked = response.secondary_clicked();
        if is_asked {
            self.menu = None;
            if let (Some(hit), Some(at)) = (self.hovered, response.interact_pointer_pos()) {
                let is_selected = |key: &KeyAt| view.editor.session().selected_keys.contains(key);
                if let Some(seconds) = hit.key
                    && !view.keys_at(hit.row, seconds).iter().all(is_selected)
                {
                    pick(view, hit, egui::Modifiers::NONE, commands);
                }
                self.open_menu(view, hit, at);
            }
        }
        let Some(mut menu) = self.menu.take() else { return false };
        // The node may be gone, or its row folded away.
        let row = view
            .rows
            .iter()
            .position(|row| view.editor.scene().node(row.node).path == *menu.node && row.subject == menu.subject);
        let Some(row) = row else { return is_asked };
        let id = Id::unique("menu of keys");
        let open = std::mem::take(&mut menu.is_new).then_some(egui::SetOpenCommand::Bool(true));
        let popup = Popup::new(id, ui.ctx().clone(), PopupAnchor::Position(menu.at), ui.layer_id())
            .kind(PopupKind::Menu)
            .layout(Layout::top_down_justified(Align::Min))
            .style(egui::containers::menu::menu_style)
            .open_memory(open)
            .close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        popup.show(|ui| {
            ui.set_min_width(232.0);
            ui.spacing_mut().item_spacing.y = 0.0;
            match menu.key.filter(|&seconds| !view.keys_at(row, seconds).is_empty()) {
                Some(seconds) => of_key(ui, &mut menu, view, row, seconds, commands),
                None => of_row(ui, &mut menu, view, row, commands),
            }
        });
        if Popup::is_id_open(ui.ctx(), id) {
            self.menu = Some(menu);
        }
        true
    }
}

fn caption(ui: &mut Ui, text: &str) {
    ui.horizontal(|ui| {
        ui.add_space(2.0);
        ui.label(RichText::new(text).small().color(Tokens::of(ui).dim));
    });
}

fn of_key(ui: &mut Ui, menu: &mut Menu, view: &KeyView<'_>, row: usize, seconds: f64, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let editor = view.editor;
    let is_still = !editor.is_playing();
    let selected = editor.session().selected_keys.len();
    let caption_text = match (selected, menu.subject.clone()) {
        (0 | 1, Subject::Channel(channel)) => {
            words.message(texts::channel_of(channel_name(words, channel), &*menu.node))
        }
        (0 | 1, _) => menu.node.to_string(),
        (count, _) => words.message(texts::count_keys(count)),
    };
    caption(ui, &caption_text);
    ui.add_enabled_ui(is_still, |ui| {
        time(ui, menu, view.keys_at(row, seconds), seconds, commands);
        let id = view.rows[row].node;
        for key in view.keys_at(row, seconds) {
            value(ui, menu, editor, id, &key, commands);
        }
    });
    ui.separator();
    if item(ui, words.say(texts::DELETE_KEYS), "Delete", is_still) {
        commands.push(Command::Edit(Edit::Timeline(TimelineEdit::DeleteKeyframes)));
    }
}

/// A field, a little sunken.
fn field(ui: &mut Ui, width: f32, name: &str, number: DragValue<'_>) -> Response {
    let tokens = Tokens::of(ui);
    let inactive = &mut ui.visuals_mut().widgets.inactive;
    inactive.weak_bg_fill = tokens.window;
    inactive.bg_stroke.color = tokens.line;
    let response = ui.add_sized(vec2(width, ROW), number.update_while_editing(false));
    response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, ui.is_enabled(), name));
    response
}

fn time(ui: &mut Ui, menu: &mut Menu, here: Vec<KeyAt>, seconds: f64, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    ui.horizontal(|ui| {
        ui.add_space(2.0);
        ui.allocate_ui_with_layout(vec2(66.0, ROW), Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_width(66.0);
            ui.label(words.say(texts::TIME));
        });
        let mut typed = seconds;
        let number = DragValue::new(&mut typed).speed(0.01).max_decimals(3).suffix(" s");
        let response = field(ui, 144.0, words.say(texts::TIME_OF_THE_KEY_IN_SECONDS), number);
        if response.drag_started() {
            commands.push(Command::Gesture(GestureCommand::Begin));
            menu.dragged_from = Some(seconds);
        }
        if response.changed() {
            // Within a drag the keys are those of its beginning.
            let from = menu.dragged_from.unwrap_or(seconds);
            let keys = here.into_iter().map(|key| KeyAt { seconds: from, ..key }).collect();
            commands.push(scene(SceneEdit::MoveKeys { keys, by: typed - from }));
            menu.key = Some(crate::scene::moved_seconds(from, typed - from));
        }
        if response.drag_stopped() {
            commands.push(Command::Gesture(GestureCommand::Commit));
            menu.dragged_from = None;
        }
    });
}

fn value(ui: &mut Ui, menu: &mut Menu, editor: &Editor, id: NodeId, key: &KeyAt, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let Some(value) = editor.scene().key_value_at(id, key.track.channel, key.seconds) else { return };
    let (mut numbers, names, speed, decimals) = match value {
        KeyValue::Translation(value) => (value.to_array(), ["x", "y", "z"], 0.01, 3),
        KeyValue::Scale(value) => (value.to_array(), ["x", "y", "z"], 0.01, 3),
        KeyValue::Rotation(rotation) => {
            let shown =
                menu.angles.filter(|&angles| rotation_from_euler_degrees(angles).dot(rotation).abs() > 1.0 - 1e-6);
            let angles = shown.unwrap_or_else(|| degrees_from_rotation(rotation));
            menu.angles = Some(angles);
            (angles, [words.say(texts::ABOUT_Z), words.say(texts::ABOUT_Y), words.say(texts::ABOUT_X)], 0.5, 1)
        }
        KeyValue::Colour(colour) => {
            let bytes = colour.to_bytes().map(f32::from);
            (bytes, [words.say(texts::RED), words.say(texts::GREEN), words.say(texts::BLUE)], 1.0, 0)
        }
    };
    let channel = channel_name(words, key.track.channel);
    ui.add_space(GRID);
    caption(ui, channel);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = GRID;
        ui.add_space(2.0);
        for (index, name) in names.into_iter().enumerate() {
            let mut number = DragValue::new(&mut numbers[index]).speed(speed).max_decimals(decimals);
            number = match value {
                KeyValue::Colour(_) => number.range(0.0..=255.0),
                KeyValue::Scale(_) => number.range(1e-6..=1e6),
                _ => number.range(-1e6..=1e6),
            };
            let response = field(ui, 70.0, &words.message(texts::key_field(channel, name)), number);
            if response.changed() && matches!(value, KeyValue::Rotation(_)) {
                menu.angles = Some(numbers);
            }
            let set = SceneEdit::SetKey {
                node: Arc::clone(&key.track.node),
                seconds: key.seconds,
                value: value_of(value, numbers),
            };
            drag_of_number(&response, scene(set), commands);
            response.on_hover_text(name);
        }
    });
    if matches!(value, KeyValue::Rotation(_)) {
        ui.set_max_width(ui.min_rect().width());
        say_of_angles(ui, numbers);
    }
}

/// A value of the same kind with other numbers.
fn value_of(value: KeyValue, numbers: [f32; 3]) -> KeyValue {
    match value {
        KeyValue::Translation(_) => KeyValue::Translation(Vec3::from(numbers)),
        KeyValue::Scale(_) => KeyValue::Scale(Vec3::from(numbers)),
        KeyValue::Rotation(_) => KeyValue::Rotation(rotation_from_euler_degrees(numbers).normalize()),
        KeyValue::Colour(_) => KeyValue::Colour(Colour::nearest(Vec3::from(numbers) / 255.0)),
    }
}

fn of_row(ui: &mut Ui, menu: &mut Menu, view: &KeyView<'_>, row: usize, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let editor = view.editor;
    let is_still = !editor.is_playing();
    caption(ui, &menu.node);
    let at = format!("{:.3}", menu.seconds);
    if item(ui, &words.message(texts::add_key_at(&at)), "", is_still) {
        add(view, row, menu.seconds, commands);
    }
    if let Subject::Control = menu.subject {
        let tracks = view.tracks(row);
        for TrackPath { node, channel } in tracks {
            let label = words.message(texts::add_key_of(channel_name(words, channel)));
            if item(ui, &label, "", is_still) {
                let key = KeyAt::new(&node, channel, menu.seconds);
                commands.push(scene(SceneEdit::AddKeys(vec![key])));
            }
        }
    }
    let all: Vec<KeyAt> = view
        .tracks(row)
        .into_iter()
        .zip(view.times(row))
        .flat_map(|(track, times)| times.iter().map(move |&seconds| KeyAt { track: track.clone(), seconds }))
        .collect();
    let has_some = !all.is_empty();
    if item(ui, words.say(texts::SELECT_ALL_KEYS_OF_THE_ROW), "", has_some) {
        commands.push(Command::Selection(SelectionCommand::TimedKeys(all)));
    }
    if matches!(menu.subject, Subject::Channel(_)) {
        return;
    }
    ui.separator();
    if item(ui, words.say(texts::PUT_A_CONTROL_NODE_ABOVE_IT), "", is_still) {
        commands.push(put_control_above(&menu.node));
    }
    if menu.subject == Subject::Control {
        if item(ui, words.say(texts::REMOVE_THE_CONTROL_NODE), "", is_still) {
            commands.push(scene(SceneEdit::RemoveControl(Arc::clone(&menu.node))));
        }
        rename(ui, menu, is_still, commands);
    }
}

fn rename(ui: &mut Ui, menu: &mut Menu, is_enabled: bool, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    ui.add_space(GRID);
    ui.horizontal(|ui| {
        ui.add_space(2.0);
        ui.label(words.say(texts::NAME));
        let field = TextEdit::singleline(&mut menu.name).desired_width(152.0).char_limit(100);
        let response = ui.add_enabled(is_enabled, field);
        response.widget_info(|| {
            WidgetInfo::labeled(Role::TextInput, is_enabled, words.say(texts::NAME_OF_THE_CONTROL_NODE))
        });
        let is_done = response.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Enter));
        let name = menu.name.trim();
        if is_done && !name.is_empty() && menu.node.rsplit('/').next() != Some(name) {
            commands.push(scene(SceneEdit::RenameControl(Arc::clone(&menu.node), name.to_owned())));
            ui.close();
        }
    });
}

/// Adds a key of the colour of the shape with this path at the playhead.
pub fn key_colour_now(editor: &Editor, path: &str) -> Command {
    scene(SceneEdit::AddKeys(vec![KeyAt::new(path, Channel::Colour, playhead(editor))]))
}
