//! The transport: step, play, stop, pause, loop; auto-key; the key time; the pace; the interpolation; ghosts; the current keyframe.
//! Where there are too few keyframes to play, its buttons play the timed keys.

use egui::{Align, Button, ComboBox, DragValue, Layout, RichText, Role, Sense, Ui, WidgetInfo, vec2};

use super::binding_of;
use super::icons::{Icon, button, was_pressed};
use super::theme::{GRID, ROW, Tokens};
use super::words::Words;
use crate::editor::keymap::Binding;
use crate::editor::{Command, Edit, Editor, PlayMode, PlaybackCommand, SPEED_PERCENT_RANGE, Transport, ViewCommand};
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeIndex, MS_BETWEEN_KEYFRAMES_RANGE, PlayRange};
use crate::words::texts;

/// What is shown in the row; the rest is in its menu.
#[derive(Clone, Copy)]
struct Fits {
    keyframes: bool,
    speed_and_ghosts: bool,
    interpolation: bool,
    pace: bool,
    readout: bool,
}

impl Fits {
    /// What fits a width, in points.
    const fn of(width: f32) -> Self {
        Self {
            keyframes: width >= 964.0,
            speed_and_ghosts: width >= 812.0,
            interpolation: width >= 664.0,
            pace: width >= 500.0,
            readout: width >= 400.0,
        }
    }
}

/// Shows the row. `side`: whether the right panel is asked for, where a button is to change that.
pub fn show(ui: &mut Ui, editor: &Editor, bindings: &[Binding], side: Option<&mut bool>, commands: &mut Vec<Command>) {
    let fits = Fits::of(ui.available_width());
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        playing(ui, editor, bindings, commands);
        if fits.readout {
            divider(ui);
        }
        if fits.keyframes {
            keyframes(ui, editor, bindings, commands);
            divider(ui);
        }
        if fits.readout {
            readout(ui, editor);
        }
        if fits.pace {
            divider(ui);
            pace(ui, editor, bindings, commands);
        }
        if fits.speed_and_ghosts {
            speed(ui, editor, commands);
        }
        if fits.interpolation {
            ui.add_space(GRID);
            interpolation(ui, editor, bindings, commands);
        }
        if fits.speed_and_ghosts {
            divider(ui);
            ghosts(ui, editor, bindings, commands);
        }
        if !fits.keyframes {
            more(ui, fits, editor, bindings, commands);
        }
        if let Some(is_asked_for) = side {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| side_button(ui, is_asked_for));
        }
    });
}

/// The button that shows the right panel over the scene, and hides it.
fn side_button(ui: &mut Ui, is_asked_for: &mut bool) {
    let name = if *is_asked_for { texts::HIDE_NODES_AND_INSPECTOR } else { texts::SHOW_NODES_AND_INSPECTOR };
    if button(ui, Icon::Side, Words::of(ui).say(name), "", true, *is_asked_for) {
        *is_asked_for = !*is_asked_for;
    }
}

/// The menu of what has no room in the row.
fn more(ui: &mut Ui, fits: Fits, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let menu = ui.menu_button(RichText::new("…").color(Tokens::of(ui).text), |ui| {
        ui.set_min_width(200.0);
        ui.spacing_mut().item_spacing.y = 0.0;
        for edit in [Edit::CreateKeyframe, Edit::UpdateCurrent, Edit::DisplayCurrent, Edit::DeleteCurrent] {
            item(ui, editor, bindings, Command::Edit(edit), commands);
        }
        if !fits.pace {
            ui.separator();
            labelled(ui, words.say(texts::MILLISECONDS_BETWEEN_KEYFRAMES), |ui| pace(ui, editor, bindings, commands));
        }
        if !fits.speed_and_ghosts {
            ui.separator();
            labelled(ui, words.say(texts::SPEED_IN_PERCENT), |ui| speed(ui, editor, commands));
        }
        if !fits.interpolation {
            ui.separator();
            let current = editor.document().interpolation;
            for interpolation in Interpolation::ALL {
                let label = Button::selectable(current == interpolation, words.say(interpolation.title()));
                if was_pressed(&ui.add(label.min_size(vec2(0.0, ROW)))) {
                    commands.push(Command::Edit(Edit::SetInterpolation(interpolation)));
                    ui.close();
                }
            }
        }
        if !fits.speed_and_ghosts {
            ui.separator();
            item(ui, editor, bindings, Command::View(ViewCommand::NextGhosts), commands);
        }
    });
    menu.response.widget_info(|| WidgetInfo::labeled(Role::Button, true, words.say(texts::MORE_OF_THE_TRANSPORT)));
    menu.response.on_hover_text(words.say(texts::MORE_OF_THE_TRANSPORT));
}

fn item(ui: &mut Ui, editor: &Editor, bindings: &[Binding], command: Command, commands: &mut Vec<Command>) {
    let Some(binding) = binding_of(bindings, &command) else { return };
    let words = Words::of(ui);
    let key = RichText::new(binding.menu_key()).monospace();
    let button = Button::new(words.say(binding.title())).shortcut_text(key).min_size(vec2(0.0, ROW));
    let response = ui.add_enabled(editor.can(&command), button).on_hover_text(words.say(binding.explanation()));
    if was_pressed(&response) {
        commands.push(command);
        ui.close();
    }
}

fn labelled(ui: &mut Ui, label: &str, field: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        ui.add_space(2.0);
        ui.label(label);
        ui.add_space(2.0 * GRID);
        field(ui);
    });
}

#[expect(clippy::too_many_arguments, reason = "it is a button with all that it shows")]
fn press(
    ui: &mut Ui,
    editor: &Editor,
    bindings: &[Binding],
    icon: Icon,
    command: Command,
    name: Option<&str>,
    is_lit: bool,
    commands: &mut Vec<Command>,
) {
    let binding = binding_of(bindings, &command);
    let name = name.or_else(|| binding.map(|binding| Words::of(ui).say(binding.title()))).unwrap_or_default();
    let key = binding.map(Binding::keys).unwrap_or_default();
    if button(ui, icon, name, &key, editor.can(&command), is_lit) {
        commands.push(command);
    }
}

fn playing(ui: &mut Ui, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    match editor.transport() {
        Transport::Keyframes => playing_keyframes(ui, editor, bindings, commands),
        Transport::TimedKeys => playing_timed_keys(ui, editor, bindings, commands),
    }
    let mut press = |ui: &mut Ui, icon, command, name: &str, is_lit| {
        press(ui, editor, bindings, icon, command, Some(name), is_lit, commands);
    };
    let words = Words::of(ui);
    let mode = editor.session().play_mode;
    let (icon, name) = match mode {
        PlayMode::Once => (Icon::Once, words.say(texts::PLAYS_ONCE)),
        PlayMode::Loop => (Icon::Loop, words.say(texts::PLAYS_IN_A_LOOP)),
        PlayMode::PingPong => (Icon::PingPong, words.say(texts::PLAYS_FORWARDS_AND_BACKWARDS)),
    };
    press(ui, icon, Command::Playback(PlaybackCommand::NextMode), name, mode != PlayMode::Once);
    let is_on = editor.session().auto_keys;
    let name = if is_on { words.say(texts::AUTO_KEY_IS_ON) } else { words.say(texts::AUTO_KEY_IS_OFF) };
    press(ui, Icon::AutoKey, Command::View(ViewCommand::ToggleAutoKeys), name, is_on);
}

fn playing_keyframes(ui: &mut Ui, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    let is_playing = editor.is_playing();
    let mut press = |ui: &mut Ui, icon, command, name: Option<&str>, is_lit| {
        press(ui, editor, bindings, icon, command, name, is_lit, commands);
    };
    let playback = Command::Playback;
    let words = Words::of(ui);
    press(ui, Icon::Previous, Command::Edit(Edit::GoToPrevious), None, false);
    let (icon, name) =
        if is_playing { (Icon::Stop, words.say(texts::STOP)) } else { (Icon::Play, words.say(texts::PLAY)) };
    press(ui, icon, playback(PlaybackCommand::PlayOrStop), Some(name), is_playing);
    let name = if editor.is_paused() { words.say(texts::GO_ON) } else { words.say(texts::PAUSE) };
    press(ui, Icon::Pause, playback(PlaybackCommand::PauseOrResume), Some(name), editor.is_paused());
    press(ui, Icon::Next, Command::Edit(Edit::GoToNext), None, false);
    press(ui, Icon::PlayFromPlayhead, playback(PlaybackCommand::PlayFromPlayhead), None, false);
}

/// The same buttons for the clock of timed keys.
fn playing_timed_keys(ui: &mut Ui, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let (runs, is_held) = (editor.timed_keys_run(), editor.holds_timed_keys());
    step(ui, editor, Icon::Previous, words.say(texts::PREVIOUS_KEY), false, commands);
    let (icon, name) = if runs { (Icon::Stop, words.say(texts::STOP)) } else { (Icon::Play, words.say(texts::PLAY)) };
    press(ui, editor, bindings, icon, Command::View(ViewCommand::PlayTimedKeys), Some(name), runs, commands);
    let hold = Command::View(ViewCommand::HoldTimedKeys);
    let name = if is_held { words.say(texts::GO_ON) } else { words.say(texts::PAUSE) };
    let key = binding_of(bindings, &hold).map(Binding::keys).unwrap_or_default();
    if button(ui, Icon::Pause, name, &key, runs || is_held, is_held) {
        commands.push(hold);
    }
    step(ui, editor, Icon::Next, words.say(texts::NEXT_KEY), true, commands);
}

/// A button that shows the time of the next timed key, or of the one before.
fn step(ui: &mut Ui, editor: &Editor, icon: Icon, name: &str, is_after: bool, commands: &mut Vec<Command>) {
    let beside = editor.timed_key_beside(is_after);
    if button(ui, icon, name, "", beside.is_some(), false)
        && let Some(seconds) = beside
    {
        commands.push(Command::View(ViewCommand::ScrubSeconds(seconds)));
    }
}

fn keyframes(ui: &mut Ui, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    let current = editor.document().keyframes.current();
    let delete = current.map(|current| Words::of(ui).message(texts::delete_keyframe_number(current.get())));
    for (icon, edit, name) in [
        (Icon::NewKeyframe, Edit::CreateKeyframe, None),
        (Icon::UpdateKeyframe, Edit::UpdateCurrent, None),
        (Icon::DisplayKeyframe, Edit::DisplayCurrent, None),
        (Icon::DeleteKeyframe, Edit::DeleteCurrent, delete.as_deref()),
    ] {
        press(ui, editor, bindings, icon, Command::Edit(edit), name, false, commands);
    }
}

fn divider(ui: &mut Ui) {
    let (rect, _) = ui.allocate_exact_size(vec2(3.0 * GRID + 1.0, ROW), Sense::hover());
    let stroke = egui::Stroke::new(1.0, Tokens::of(ui).line);
    ui.painter().vline(rect.center().x, rect.y_range(), stroke);
}

/// The key time shown and the last one: `key 1.85 / 3`.
#[must_use]
pub fn key_time_text(editor: &Editor, words: Words) -> String {
    if let (Transport::TimedKeys, Some(last)) = (editor.transport(), editor.scene().last_second()) {
        let (shown, last) = (format!("{:.2}", editor.seconds().min(last)), format!("{last:.2}"));
        return words.message(texts::seconds_of_last(shown, last));
    }
    let keyframes = &editor.document().keyframes;
    let Ok(range) = PlayRange::new(keyframes) else { return words.message(texts::current_of_last("–", "–")) };
    let last = range.last_key_time().to_string();
    let shown = |key_time: &str| words.message(texts::current_of_last(key_time, &last));
    if let Some(key_time) = editor.key_time() {
        return shown(&format!("{key_time:.2}"));
    }
    match keyframes.current().map(KeyframeIndex::get) {
        Some(current) if (1..=range.last_key_time() + 1).contains(&current) => {
            shown(&format!("{:.2}", current_key_time(current)))
        }
        Some(current) => words.message(texts::index_only_steers(current)),
        None => shown("–.––"),
    }
}

#[expect(clippy::cast_precision_loss, reason = "no list has 2^52 keyframes")]
fn current_key_time(current: usize) -> f64 {
    (current - 1) as f64
}

fn readout(ui: &mut Ui, editor: &Editor) {
    let tokens = Tokens::of(ui);
    let text = key_time_text(editor, Words::of(ui));
    let timed = editor.transport() == Transport::TimedKeys && editor.timed_keys_run();
    let colour = if timed || editor.is_playing() || editor.is_scrubbed() { tokens.accent_text } else { tokens.text };
    let (rect, response) = ui.allocate_exact_size(vec2(112.0, ROW), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &text));
    ui.painter().text(rect.left_center(), egui::Align2::LEFT_CENTER, text, super::theme::number_font(), colour);
    let steers = editor.key_time().is_none()
        && editor.document().keyframes.current().is_some_and(|current| {
            let range = PlayRange::new(&editor.document().keyframes);
            range.is_ok_and(|range| !(1..=range.last_key_time() + 1).contains(&current.get()))
        });
    let tip = match editor.transport() {
        Transport::Keyframes if steers => texts::IT_ONLY_STEERS_THE_SPLINE_IT_IS,
        Transport::Keyframes => texts::KEY_TIME_AND_THE_LAST_ONE_KEY,
        Transport::TimedKeys => texts::TIME_AND_THE_LAST_TIMED_KEY,
    };
    response.on_hover_text(Words::of(ui).say(tip));
}

fn pace(ui: &mut Ui, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    let mut ms = editor.document().ms_between_keyframes;
    let number =
        DragValue::new(&mut ms).range(MS_BETWEEN_KEYFRAMES_RANGE).speed(10.0).suffix(" ms").update_while_editing(false);
    let response = ui.add_sized(vec2(80.0, ROW), number);
    let words = Words::of(ui);
    response
        .widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, words.say(texts::MILLISECONDS_BETWEEN_KEYFRAMES)));
    let keys =
        [Edit::Faster, Edit::Slower].map(|edit| binding_of(bindings, &Command::Edit(edit)).map(Binding::menu_key));
    let keys: Vec<String> = keys.into_iter().flatten().filter(|key| !key.is_empty()).collect();
    let tip = super::tip(words.say(texts::MILLISECONDS_BETWEEN_KEYFRAMES), &keys.join("  "));
    if response.on_hover_text(tip).changed() {
        commands.push(Command::Edit(Edit::SetMsBetweenKeyframes(ms)));
    }
    ui.add_space(GRID);
}

fn speed(ui: &mut Ui, editor: &Editor, commands: &mut Vec<Command>) {
    let mut percent = editor.session().speed_percent;
    let number =
        DragValue::new(&mut percent).range(SPEED_PERCENT_RANGE).speed(1.0).suffix(" %").update_while_editing(false);
    let response = ui.add_sized(vec2(60.0, ROW), number);
    let words = Words::of(ui);
    response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, words.say(texts::SPEED_IN_PERCENT)));
    if response.on_hover_text(words.say(texts::SPEED_OF_PLAYING_THE_FILE_KEEPS_ITS)).changed() {
        commands.push(Command::Playback(PlaybackCommand::SetSpeedPercent(percent)));
    }
}

fn interpolation(ui: &mut Ui, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    let current = editor.document().interpolation;
    let words = Words::of(ui);
    let response = ComboBox::from_id_salt("interpolation")
        .selected_text(RichText::new(words.say(current.title())))
        .width(112.0)
        .show_ui(ui, |ui| {
            for interpolation in Interpolation::ALL {
                if ui.selectable_label(current == interpolation, words.say(interpolation.title())).clicked() {
                    commands.push(Command::Edit(Edit::SetInterpolation(interpolation)));
                }
            }
        })
        .response;
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, words.say(texts::INTERPOLATION)));
    let key = binding_of(bindings, &Command::Edit(Edit::NextInterpolation)).map(Binding::menu_key).unwrap_or_default();
    let response = response.on_hover_text(super::tip(words.say(texts::INTERPOLATION), &key));
    let _ = was_pressed(&response);
}

fn ghosts(ui: &mut Ui, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    let count = editor.session().ghosts;
    let words = Words::of(ui);
    let tip = match count {
        0 => words.say(texts::GHOSTS_NONE_A_CLICK_SHOWS_ONE_MORE).to_owned(),
        count => words.message(texts::ghosts_each_side(count.to_string())),
    };
    let command = Command::View(ViewCommand::NextGhosts);
    let key = binding_of(bindings, &command).map(Binding::menu_key).unwrap_or_default();
    if button(ui, Icon::Ghosts, &tip, &key, true, count > 0) {
        commands.push(command);
    }
    let (rect, _) = ui.allocate_exact_size(vec2(14.0, ROW), Sense::hover());
    let tokens = Tokens::of(ui);
    let colour = if count > 0 { tokens.accent_text } else { tokens.dim };
    let font = super::theme::number_font();
    ui.painter().text(rect.left_center(), egui::Align2::LEFT_CENTER, count, font, colour);
}
