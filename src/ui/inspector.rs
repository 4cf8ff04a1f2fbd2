//! The inspector: the numbers of the dragged node, which can be typed and dragged. A drag of a number is one step of undo.

use egui::{DragValue, Label, Response, RichText, Ui, vec2};
use glam::Vec3;

use super::angles::{ShownAngles, say_of_angles, with_component};
use super::key_of;
use super::theme::{GRID, ROW, Tokens};
use super::words::Words;
use crate::editor::keymap::Keymap;
use crate::editor::{Command, Edit, Editor, GestureCommand, PlaybackCommand};
use crate::rotation_rules::rotation_from_euler_degrees;
use crate::words::texts;

/// Scene units for each point that a number is dragged.
const UNITS_PER_POINT: f32 = 0.01;
/// Degrees for each point that an angle is dragged.
const DEGREES_PER_POINT: f32 = 0.5;

/// Shows the numbers of the dragged node.
pub fn show(ui: &mut Ui, editor: &Editor, angles: &mut ShownAngles, keymap: &Keymap, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let tokens = Tokens::of(ui);
    let scene = editor.scene();
    let Some(rbt) = editor.dragged_node() else {
        ui.label(RichText::new(words.say(texts::WORK_EYE)).strong().size(14.0));
        ui.label(RichText::new(words.say(texts::CTRL_CLICK_A_PART_TO_CHOOSE_IT)).small().color(tokens.dim));
        return;
    };
    let node = scene.node(scene.rbt_node(rbt));
    ui.horizontal(|ui| {
        ui.label(RichText::new(&node.name).strong().size(14.0));
        let what = match (editor.session().chosen.primary(), node.path.rsplit_once('/')) {
            (None, _) => words.say(texts::THE_EYE_NOTHING_IS_CHOSEN),
            (Some(_), Some((above, _))) => above,
            (Some(_), None) => "",
        };
        ui.add(Label::new(RichText::new(what).small().color(tokens.dim)).truncate());
    });
    ui.add_space(GRID);
    ui.add_enabled_ui(!editor.is_playing(), |ui| {
        let parent_from_node = editor.displayed_pose().get(rbt);

        label(ui, words.say(texts::TRANSLATION));
        let mut translation = parent_from_node.translation.to_array();
        let names = ["x", "y", "z"];
        if let Some(changed) =
            numbers(ui, words.say(texts::TRANSLATION), &names, &mut translation, UNITS_PER_POINT, 3, commands)
        {
            finish(&changed, Command::Edit(Edit::SetTranslation(rbt, Vec3::from(translation))), commands);
        }

        label(ui, words.say(texts::ROTATION_DEGREES));
        let mut degrees = angles.of(rbt, parent_from_node.rotation);
        let names = [words.say(texts::YAW), words.say(texts::PITCH), words.say(texts::ROLL)];
        if let Some(changed) =
            numbers(ui, words.say(texts::ROTATION), &names, &mut degrees, DEGREES_PER_POINT, 1, commands)
        {
            angles.set(rbt, degrees);
            let rotation = rotation_from_euler_degrees(degrees);
            finish(&changed, Command::Edit(Edit::SetRotation(rbt, rotation)), commands);
        }
        say_of_angles(ui, degrees);

        label(ui, words.say(texts::QUATERNION));
        let before = parent_from_node.rotation.to_array();
        let mut parts = before;
        let names = ["x", "y", "z", "w"];
        if let Some(changed) =
            numbers(ui, words.say(texts::QUATERNION), &names, &mut parts, UNITS_PER_POINT, 3, commands)
        {
            let component = (0..4).find(|&index| parts[index].to_bits() != before[index].to_bits());
            let rotation = component.map_or(parent_from_node.rotation, |index| {
                with_component(parent_from_node.rotation, index, parts[index])
            });
            finish(&changed, Command::Edit(Edit::SetRotation(rbt, rotation)), commands);
        }
    });
    let hint = if editor.is_playing() {
        let key = |command| key_of(keymap, &Command::Playback(command));
        let (stop, pause) = (key(PlaybackCommand::PlayOrStop), key(PlaybackCommand::PauseOrResume));
        words.message(texts::stop_or_pause_to_change(&stop, &pause))
    } else if editor.session().chosen.is_empty() {
        words.say(texts::CTRL_CLICK_A_PART_TO_CHOOSE_IT).to_owned()
    } else {
        words.say(texts::DRAG_THE_NUMBERS_OR_CLICK_AND_TYPE).to_owned()
    };
    ui.add_space(GRID);
    ui.label(RichText::new(hint).small().color(tokens.dim));
}

fn label(ui: &mut Ui, text: &str) {
    ui.add_space(GRID);
    ui.label(RichText::new(text).small().color(Tokens::of(ui).dim));
}

/// What happened to a row of numbers.
struct Changed {
    has_value: bool,
    drag_ended: bool,
}

/// A row of numbers with their names. `Some` where one changed or a drag of one ended; the beginning of a drag is pushed here.
fn numbers(
    ui: &mut Ui,
    what: &str,
    names: &[&str],
    values: &mut [f32],
    per_point: f32,
    decimals: usize,
    commands: &mut Vec<Command>,
) -> Option<Changed> {
    let mut changed = Changed { has_value: false, drag_ended: false };
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = GRID;
        #[expect(clippy::cast_precision_loss, reason = "there are at most four")]
        let count = values.len() as f32;
        let width = (ui.available_width() - (count - 1.0) * GRID) / count;
        for (value, name) in values.iter_mut().zip(names) {
            ui.vertical(|ui| {
                ui.spacing_mut().item_spacing.y = 1.0;
                ui.set_width(width);
                let response = number(ui, &format!("{what} {name}"), value, per_point, decimals, width);
                ui.vertical_centered(|ui| ui.label(RichText::new(*name).size(10.0).color(Tokens::of(ui).dim)));
                if response.drag_started() {
                    commands.push(Command::Gesture(GestureCommand::Begin));
                }
                changed.has_value |= response.changed();
                changed.drag_ended |= response.drag_stopped();
            });
        }
    });
    (changed.has_value || changed.drag_ended).then_some(changed)
}

fn number(ui: &mut Ui, name: &str, value: &mut f32, per_point: f32, decimals: usize, width: f32) -> Response {
    let spacing = ui.spacing_mut();
    spacing.button_padding = vec2(2.0, 2.0);
    spacing.interact_size = vec2(width, ROW);
    // A field is a little sunken.
    let tokens = Tokens::of(ui);
    let inactive = &mut ui.visuals_mut().widgets.inactive;
    inactive.weak_bg_fill = tokens.window;
    inactive.bg_stroke.color = tokens.line;
    let number = DragValue::new(value)
        .speed(per_point)
        .custom_formatter(|value, _| text_of(value, decimals))
        .update_while_editing(false);
    let response = ui.add_sized(vec2(width, ROW), number);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, ui.is_enabled(), name));
    response.on_hover_text(Words::of(ui).message(texts::drag_or_type(name)))
}

fn finish(changed: &Changed, command: Command, commands: &mut Vec<Command>) {
    if changed.has_value {
        commands.push(command);
    }
    if changed.drag_ended {
        commands.push(Command::Gesture(GestureCommand::Commit));
    }
}

/// A number with a fixed number of decimals. -0 is written as 0.
fn text_of(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|digit| matches!(digit, '0' | '.')) => rest.to_owned(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::text_of;

    #[test]
    fn no_zero_has_a_sign() {
        assert_eq!(text_of(-0.000_2, 3), "0.000");
        assert_eq!(text_of(-0.000_6, 3), "-0.001");
        assert_eq!(text_of(-35.7, 1), "-35.7");
    }
}
