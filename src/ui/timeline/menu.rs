//! The context menu of the timeline, with little pictures of the easings.

use egui::{
    Button, DragValue, Popup, PopupCloseBehavior, Response, RichText, Role, Sense, Stroke, Ui, WidgetInfo, vec2,
};

use super::drag_of_number;
use super::hit::{Hit, Target};
use super::paint::curve;
use super::tips::{CURVES, easing_text};
use super::{Tab, Timeline};
use crate::editor::keymap::Binding;
use crate::editor::{
    ClipboardCommand, Command, Edit, Editor, PlaybackCommand, SelectionCommand, TimelineEdit, WindowCommand,
};
use crate::keyframe::{DURATION_RANGE, Easing, KeyframeIndex};
use crate::ui::binding_of;
use crate::ui::icons::was_pressed;
use crate::ui::theme::{CORNER, GRID, ROW, Tokens};
use crate::ui::words::Words;
use crate::words::texts;

/// Size of a picture of an easing, in points.
const PICTURE: egui::Vec2 = vec2(40.0, 28.0);

impl Timeline {
    /// Shows the context menu where the pointer asked for it.
    pub(super) fn menu(
        &mut self,
        ui: &Ui,
        response: &Response,
        target: &Target<'_>,
        editor: &Editor,
        bindings: &[Binding],
        commands: &mut Vec<Command>,
    ) {
        if response.secondary_clicked()
            && let Some(at) = response.interact_pointer_pos()
        {
            self.menu_for = match target.at(at) {
                Hit::Diamond(index) if self.tab == Tab::Keyframes => Some(index),
                _ => None,
            };
            if let Some(index) = self.menu_for
                && editor.session().selected.binary_search(&KeyframeIndex::new(index)).is_err()
            {
                self.pick(index, editor, egui::Modifiers::NONE, commands);
            }
        }
        let menu_for = self.menu_for.filter(|&index| index < target.columns.len());
        let popup = Popup::context_menu(response).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        popup.show(|ui| {
            ui.set_min_width(216.0);
            ui.spacing_mut().item_spacing.y = 0.0;
            match menu_for {
                Some(index) => self.of_keyframe(ui, index, editor, bindings, commands),
                None => of_nothing(ui, target, editor, bindings, commands),
            }
        });
        let _ = ui;
    }

    fn of_keyframe(
        &mut self,
        ui: &mut Ui,
        index: usize,
        editor: &Editor,
        bindings: &[Binding],
        commands: &mut Vec<Command>,
    ) {
        let keyframe_index = KeyframeIndex::new(index);
        let Some(keyframe) = editor.document().keyframes.get(keyframe_index) else { return };
        let edited = editor.edited_keyframes().len();
        let words = Words::of(ui);
        let heading = if edited > 1 {
            words.message(texts::count_keyframes(edited))
        } else {
            words.message(texts::keyframe_number(index.to_string()))
        };
        caption(ui, &heading);
        let rename = binding_of(bindings, &Command::Window(WindowCommand::RenameCurrent));
        let (name, key) = rename.map(|binding| (words.say(binding.title()), binding.menu_key())).unwrap_or_default();
        if row(ui, name, &key, !editor.is_playing()) {
            self.start_renaming(editor, Some(keyframe_index));
            ui.close();
        }
        duration(ui, keyframe_index, keyframe.duration, editor, commands);
        ui.add_enabled_ui(!editor.is_playing(), |ui| {
            ui.menu_button(words.say(texts::EASING), |ui| {
                if let Some(easing) = easings(ui, keyframe.easing) {
                    commands.push(Command::Edit(Edit::Timeline(TimelineEdit::SetEasing(easing))));
                    Popup::close_all(ui.ctx());
                }
            });
        });
        ui.separator();
        for edit in [
            Command::Edit(Edit::Timeline(TimelineEdit::DuplicateKeyframes)),
            Command::Clipboard(ClipboardCommand::CopyKeyframes),
            Command::Edit(Edit::Timeline(TimelineEdit::CutKeyframes)),
            Command::Edit(Edit::Timeline(TimelineEdit::PasteKeyframes)),
            Command::Edit(Edit::Timeline(TimelineEdit::ReverseKeyframes)),
        ] {
            item(ui, editor, bindings, edit, commands);
        }
        ui.separator();
        let delete = Command::Edit(Edit::Timeline(TimelineEdit::DeleteKeyframes));
        let label = words.message(texts::delete_what(texts::count_keyframes(edited)));
        named_item(ui, editor, bindings, &label, delete, commands);
    }
}

fn of_nothing(ui: &mut Ui, target: &Target<'_>, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let count = target.columns.len();
    if row(ui, words.say(texts::SELECT_ALL_KEYFRAMES), "", count > 0) {
        let all = (0..count).map(KeyframeIndex::new).collect();
        commands.push(Command::Selection(SelectionCommand::Keyframes(all)));
        ui.close();
    }
    item(ui, editor, bindings, Command::Edit(Edit::Timeline(TimelineEdit::PasteKeyframes)), commands);
    item(ui, editor, bindings, Command::Edit(Edit::Timeline(TimelineEdit::ReverseKeyframes)), commands);
    ui.separator();
    if row(ui, words.say(texts::PLAY_ALL_KEYFRAMES), "", editor.session().play_range.is_some()) {
        commands.push(Command::Playback(PlaybackCommand::SetRange(None)));
        ui.close();
    }
    item(ui, editor, bindings, Command::Window(WindowCommand::FitTimeline), commands);
    item(ui, editor, bindings, Command::Window(WindowCommand::FitSelection), commands);
}

fn caption(ui: &mut Ui, text: &str) {
    ui.horizontal(|ui| {
        ui.add_space(2.0);
        ui.label(RichText::new(text).small().color(Tokens::of(ui).dim));
    });
}

fn row(ui: &mut Ui, label: &str, key: &str, is_enabled: bool) -> bool {
    let mut button = Button::new(label).min_size(vec2(0.0, ROW));
    if !key.is_empty() {
        button = button.shortcut_text(RichText::new(key).monospace());
    }
    was_pressed(&ui.add_enabled(is_enabled, button))
}

/// A row of the table of bindings.
fn item(ui: &mut Ui, editor: &Editor, bindings: &[Binding], command: Command, commands: &mut Vec<Command>) {
    let binding = binding_of(bindings, &command);
    let label = binding.map_or("", |binding| Words::of(ui).say(binding.title()));
    named_item(ui, editor, bindings, label, command, commands);
}

/// The same with another name.
fn named_item(
    ui: &mut Ui,
    editor: &Editor,
    bindings: &[Binding],
    label: &str,
    command: Command,
    commands: &mut Vec<Command>,
) {
    let key = binding_of(bindings, &command).map(Binding::menu_key).unwrap_or_default();
    if row(ui, label, &key, editor.can(&command)) {
        commands.push(command);
        ui.close();
    }
}

fn duration(ui: &mut Ui, keyframe: KeyframeIndex, duration: f64, editor: &Editor, commands: &mut Vec<Command>) {
    let is_last = editor.document().keyframes.last() == Some(keyframe);
    ui.add_enabled_ui(!editor.is_playing() && !is_last, |ui| {
        ui.horizontal(|ui| {
            ui.add_space(2.0);
            let words = Words::of(ui);
            ui.label(words.say(texts::DURATION));
            ui.add_space(2.0 * GRID);
            // A field is a little sunken.
            let tokens = Tokens::of(ui);
            let inactive = &mut ui.visuals_mut().widgets.inactive;
            inactive.weak_bg_fill = tokens.window;
            inactive.bg_stroke.color = tokens.line;
            let mut steps = duration;
            let number = DragValue::new(&mut steps)
                .range(DURATION_RANGE)
                .speed(0.01)
                .max_decimals(3)
                .suffix(format!(" {}", words.say(texts::STEPS)))
                .update_while_editing(false);
            let response = ui.add_sized(vec2(92.0, ROW), number);
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, words.say(texts::DURATION_IN_STEPS)));
            let edit = TimelineEdit::SetDuration { keyframe, duration: steps, ripple_free: false };
            drag_of_number(&response, Command::Edit(Edit::Timeline(edit)), commands);
            let seconds = duration * f64::from(editor.document().ms_between_keyframes) / 1000.0;
            let seconds = Words::of(ui).message(texts::seconds(format!("{seconds:.2}")));
            ui.label(RichText::new(seconds).small().color(Tokens::of(ui).dim));
        });
    });
}

/// Shows a picture of each easing. `Some`: the one that was pressed.
pub fn easings(ui: &mut Ui, current: Easing) -> Option<Easing> {
    let mut pressed = None;
    let mut picture = |ui: &mut Ui, easing: Easing| {
        if easing_button(ui, easing, easing == current) {
            pressed = Some(easing);
        }
    };
    let all: Vec<Easing> = Easing::all().collect();
    let (plain, curves) = all.split_at(2);
    ui.spacing_mut().item_spacing = vec2(GRID, GRID);
    ui.add_space(GRID);
    egui::Grid::new("easings").spacing(vec2(GRID, GRID)).min_col_width(PICTURE.x).show(ui, |ui| {
        let words = Words::of(ui);
        let ends = ["", words.say(texts::IN), words.say(texts::OUT), words.say(texts::IN_OUT)];
        for (index, heading) in ends.into_iter().enumerate() {
            if index == 0 {
                ui.label("");
            } else {
                ui.vertical_centered(|ui| ui.label(RichText::new(heading).size(10.0).color(Tokens::of(ui).dim)));
            }
        }
        ui.end_row();
        for (three, (_, name)) in curves.chunks(3).zip(CURVES) {
            ui.label(RichText::new(words.say(name)).small());
            for &easing in three {
                picture(ui, easing);
            }
            ui.end_row();
        }
        for (&easing, name) in plain.iter().zip([words.say(texts::LINEAR), words.say(texts::HOLD)]) {
            ui.label(RichText::new(name).small());
            picture(ui, easing);
            if easing == Easing::Linear {
                ui.end_row();
            }
        }
    });
    pressed
}

fn easing_button(ui: &mut Ui, easing: Easing, is_current: bool) -> bool {
    let tokens = Tokens::of(ui);
    let (rect, response) = ui.allocate_exact_size(PICTURE, Sense::click());
    let words = Words::of(ui);
    let name = easing_text(easing, words);
    response.widget_info(|| {
        WidgetInfo::selected(Role::RadioButton, true, is_current, words.message(texts::easing_named(&name)))
    });
    let fill = if response.hovered() || response.has_focus() { tokens.hovered } else { tokens.raised };
    ui.painter().rect_filled(rect, CORNER, if is_current { tokens.accent_fill } else { fill });
    if is_current || response.has_focus() {
        ui.painter().rect_stroke(rect, CORNER, Stroke::new(1.0, tokens.accent), egui::StrokeKind::Inside);
    }
    let colour = if is_current { tokens.accent_text } else { tokens.text };
    // Back and elastic leave the square.
    curve(ui.painter(), rect.shrink2(vec2(8.0, 8.0)), easing, Stroke::new(1.5, colour));
    was_pressed(&response.on_hover_text(name))
}
