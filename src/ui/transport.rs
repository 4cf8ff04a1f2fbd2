//! The transport: step, play, stop, pause; the key time; the pace; the interpolation; the keyframe at hand.

use egui::{ComboBox, DragValue, RichText, Role, Sense, Ui, WidgetInfo, vec2};

use super::binding_of;
use super::icons::{Icon, button};
use super::theme::{GRID, ROW, Tokens};
use super::words::Words;
use crate::editor::keymap::Binding;
use crate::editor::{Command, Edit, Editor, PlaybackCommand};
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeIndex, MS_BETWEEN_KEYFRAMES_RANGE, PlayRange};

/// Shows the row.
pub fn show(ui: &mut Ui, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        let words = Words::of(ui);
        let playing = editor.is_playing();
        let play = Command::Playback(PlaybackCommand::PlayOrStop);
        let pause = Command::Playback(PlaybackCommand::PauseOrResume);
        let mut press = |ui: &mut Ui, icon, command: Command, name: Option<&str>, is_lit: bool| {
            let binding = binding_of(bindings, &command);
            let name = name.or_else(|| binding.map(|binding| words.say(binding.name))).unwrap_or_default();
            let key = binding.map(Binding::keys).unwrap_or_default();
            if button(ui, icon, name, &key, editor.can(&command), is_lit) {
                commands.push(command);
            }
        };
        press(ui, Icon::Previous, Command::Edit(Edit::GoToPrevious), None, false);
        let (icon, name) = if playing { (Icon::Stop, words.say("Stop")) } else { (Icon::Play, words.say("Play")) };
        press(ui, icon, play, Some(name), playing);
        let go_on = if editor.is_paused() { words.say("Go on") } else { words.say("Pause") };
        press(ui, Icon::Pause, pause, Some(go_on), editor.is_paused());
        press(ui, Icon::Next, Command::Edit(Edit::GoToNext), None, false);
        divider(ui);
        press(ui, Icon::NewKeyframe, Command::Edit(Edit::CreateKeyframe), None, false);
        press(ui, Icon::UpdateKeyframe, Command::Edit(Edit::UpdateCurrent), None, false);
        press(ui, Icon::DisplayKeyframe, Command::Edit(Edit::DisplayCurrent), None, false);
        press(ui, Icon::DeleteKeyframe, Command::Edit(Edit::DeleteCurrent), None, false);
        divider(ui);
        readout(ui, editor);
        divider(ui);
        pace(ui, editor, bindings, commands);
        interpolation(ui, editor, bindings, commands);
    });
}

fn divider(ui: &mut Ui) {
    let (rect, _) = ui.allocate_exact_size(vec2(4.0 * GRID + 1.0, ROW), Sense::hover());
    let stroke = egui::Stroke::new(1.0, Tokens::of(ui).line);
    ui.painter().vline(rect.center().x, rect.y_range(), stroke);
}

/// The key time shown and the last one: `key 1.85 / 3`.
#[must_use]
pub fn key_time_text(editor: &Editor) -> String {
    let keyframes = &editor.document().keyframes;
    let Ok(range) = PlayRange::new(keyframes) else { return "key – / –".to_owned() };
    let last = range.last_key_time();
    if let Some(key_time) = editor.key_time() {
        return format!("key {key_time:.2} / {last}");
    }
    match keyframes.current().map(KeyframeIndex::get) {
        Some(current) if (1..=last + 1).contains(&current) => format!("key {:.2} / {last}", current_key_time(current)),
        _ => format!("key –.–– / {last}"),
    }
}

#[expect(clippy::cast_precision_loss, reason = "no list has 2^52 keyframes")]
fn current_key_time(current: usize) -> f64 {
    (current - 1) as f64
}

fn readout(ui: &mut Ui, editor: &Editor) {
    let tokens = Tokens::of(ui);
    let text = Words::of(ui).message(&key_time_text(editor));
    let colour = if editor.is_playing() { tokens.accent } else { tokens.text };
    let (rect, response) = ui.allocate_exact_size(vec2(104.0, ROW), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &text));
    ui.painter().text(rect.left_center(), egui::Align2::LEFT_CENTER, text, super::theme::number_font(), colour);
    response.on_hover_text(
        Words::of(ui)
            .say("Key time and the last one. Key time 0 is keyframe 1: the first and the last keyframe only steer."),
    );
}

fn pace(ui: &mut Ui, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    let key = |edit| binding_of(bindings, &Command::Edit(edit)).map(Binding::menu_key).unwrap_or_default();
    let keys = format!("{}  {}", key(Edit::Faster), key(Edit::Slower));
    let mut ms = editor.document().ms_between_keyframes;
    let number =
        DragValue::new(&mut ms).range(MS_BETWEEN_KEYFRAMES_RANGE).speed(10.0).suffix(" ms").update_while_editing(false);
    let name = Words::of(ui).say("Milliseconds between keyframes");
    let response = ui.add_sized(vec2(84.0, ROW), number);
    response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, name));
    if response.on_hover_text(format!("{name}  ·  {keys}")).changed() {
        commands.push(Command::Edit(Edit::SetMsBetweenKeyframes(ms)));
    }
    ui.add_space(2.0 * GRID);
}

fn interpolation(ui: &mut Ui, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let current = editor.document().interpolation;
    let response = ComboBox::from_id_salt("interpolation")
        .selected_text(RichText::new(words.say(current.label())))
        .width(112.0)
        .show_ui(ui, |ui| {
            for interpolation in Interpolation::ALL {
                if ui.selectable_label(current == interpolation, words.say(interpolation.label())).clicked() {
                    commands.push(Command::Edit(Edit::SetInterpolation(interpolation)));
                }
            }
        })
        .response;
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, words.say("Interpolation")));
    let key = binding_of(bindings, &Command::Edit(Edit::NextInterpolation)).map(Binding::menu_key).unwrap_or_default();
    let response = response.on_hover_text(super::tip(words.say("Interpolation"), &key));
    let _ = super::icons::was_pressed(&response);
}
