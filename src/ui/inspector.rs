//! The inspector: the numbers of the dragged node, which can be typed and dragged. A drag of a number is one step of undo.

use egui::{
    Align2, CollapsingHeader, Color32, DragValue, Label, PointerButton, Response, RichText, Sense, Stroke, Ui,
    UiBuilder, pos2, vec2,
};
use glam::Vec3;

use super::angles::{ShownAngles, degrees_from_rotation, say_of_angles, with_component};
use super::key_of;
use super::theme::{CORNER, GRID, ROW, Tokens, small_font};
use super::words::Words;
use crate::editor::keymap::Keymap;
use crate::editor::{Command, Edit, Editor, GestureCommand, PlaybackCommand};
use crate::rotation_rules::rotation_from_euler_degrees;
use crate::words::texts;

/// Scene units for each point that a number is dragged.
const UNITS_PER_POINT: f32 = 0.01;
/// Width of a field's label, in points.
const LABEL: f32 = 15.0;
/// Degrees for each point that an angle is dragged.
const DEGREES_PER_POINT: f32 = 0.5;

/// Shows the numbers of the dragged node.
pub fn show(ui: &mut Ui, editor: &Editor, angles: &mut ShownAngles, keymap: &Keymap, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let tokens = Tokens::of(ui);
    let scene = editor.scene();
    let Some(rbt) = editor.dragged_node() else {
        ui.label(RichText::new(words.say(texts::WORK_EYE)).strong().size(14.0));
        ui.label(RichText::new(words.say(texts::CLICK_A_PART_TO_CHOOSE_IT)).small().color(tokens.dim));
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

        let rest = scene.rest_pose().get(rbt);

        label(ui, words.say(texts::TRANSLATION));
        let row =
            Numbers { what: words.say(texts::TRANSLATION), fields: [X, Y, Z], per_point: UNITS_PER_POINT, decimals: 3 };
        let mut translation = parent_from_node.translation.to_array();
        if let Some(changed) = row.show(ui, &mut translation, rest.translation.to_array(), commands) {
            finish(&changed, Command::Edit(Edit::SetTranslation(rbt, Vec3::from(translation))), commands);
        }

        label(ui, words.say(texts::ROTATION_DEGREES));
        let mut degrees = angles.of(rbt, parent_from_node.rotation);
        let about = |field: Field, name| Field { name: words.say(name), ..field };
        let fields = [about(Z, texts::ABOUT_Z), about(Y, texts::ABOUT_Y), about(X, texts::ABOUT_X)];
        let row = Numbers { what: words.say(texts::ROTATION), fields, per_point: DEGREES_PER_POINT, decimals: 1 };
        if let Some(changed) = row.show(ui, &mut degrees, degrees_from_rotation(rest.rotation), commands) {
            angles.set(rbt, degrees);
            let rotation = rotation_from_euler_degrees(degrees);
            finish(&changed, Command::Edit(Edit::SetRotation(rbt, rotation)), commands);
        }
        say_of_angles(ui, degrees);

        ui.add_space(GRID);
        let title = RichText::new(words.say(texts::QUATERNION)).small().color(tokens.dim);
        CollapsingHeader::new(title).id_salt("quaternion").show_unindented(ui, |ui| {
            let before = parent_from_node.rotation.to_array();
            let mut parts = before;
            let what = words.say(texts::QUATERNION);
            let row = Numbers { what, fields: [X, Y, Z, W], per_point: UNITS_PER_POINT, decimals: 3 };
            if let Some(changed) = row.show(ui, &mut parts, rest.rotation.to_array(), commands) {
                let component = (0..4).find(|&index| parts[index].to_bits() != before[index].to_bits());
                let rotation = component.map_or(parent_from_node.rotation, |index| {
                    with_component(parent_from_node.rotation, index, parts[index])
                });
                finish(&changed, Command::Edit(Edit::SetRotation(rbt, rotation)), commands);
            }
        });
    });
    let hint = if editor.is_playing() {
        let key = |command| key_of(keymap, &Command::Playback(command));
        let (stop, pause) = (key(PlaybackCommand::PlayOrStop), key(PlaybackCommand::PauseOrResume));
        words.message(texts::stop_or_pause_to_change(&stop, &pause))
    } else if editor.session().chosen.is_empty() {
        words.say(texts::CLICK_A_PART_TO_CHOOSE_IT).to_owned()
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

/// A field of a row: its label, which stands inside it in the colour of its axis, and the name that screen readers say.
#[derive(Clone, Copy)]
struct Field {
    label: &'static str,
    name: &'static str,
    axis: Option<usize>,
}

const X: Field = Field { label: "x", name: "x", axis: Some(0) };
const Y: Field = Field { label: "y", name: "y", axis: Some(1) };
const Z: Field = Field { label: "z", name: "z", axis: Some(2) };
const W: Field = Field { label: "w", name: "w", axis: None };

/// A row of numbers.
struct Numbers<'a, const N: usize> {
    what: &'a str,
    fields: [Field; N],
    /// How much a number changes for each point that it is dragged.
    per_point: f32,
    decimals: usize,
}

impl<const N: usize> Numbers<'_, N> {
    /// Shows the row. `Some` where a number changed or a drag of one ended; the beginning of a drag is pushed here. A double click
    /// returns a number to rest.
    fn show(&self, ui: &mut Ui, values: &mut [f32; N], rest: [f32; N], commands: &mut Vec<Command>) -> Option<Changed> {
        let mut changed = Changed { has_value: false, drag_ended: false };
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = GRID;
            #[expect(clippy::cast_precision_loss, reason = "there are at most four")]
            let count = N as f32;
            let width = (ui.available_width() - (count - 1.0) * GRID) / count;
            for ((value, rest), field) in values.iter_mut().zip(rest).zip(self.fields) {
                let response = self.number(ui, field, value, width);
                if response.drag_started() {
                    commands.push(Command::Gesture(GestureCommand::Begin));
                }
                changed.has_value |= response.changed();
                changed.drag_ended |= response.drag_stopped();
                if is_double_clicked(ui, &response) {
                    response.surrender_focus();
                    *value = rest;
                    changed.has_value = true;
                }
            }
        });
        (changed.has_value || changed.drag_ended).then_some(changed)
    }

    fn number(&self, ui: &mut Ui, field: Field, value: &mut f32, width: f32) -> Response {
        let tokens = Tokens::of(ui);
        let (rect, _) = ui.allocate_exact_size(vec2(width, ROW), Sense::hover());
        // A field is a little sunken, and its label is a part of it.
        let border = Stroke::new(1.0, tokens.line);
        ui.painter().rect(rect, CORNER, tokens.window, border, egui::StrokeKind::Inside);
        let colour = field.axis.map_or(tokens.dim, |axis| tokens.axes[axis]);
        let at = pos2(rect.left() + 8.0, rect.center().y);
        ui.painter().text(at, Align2::CENTER_CENTER, field.label, small_font(), colour);
        let name = format!("{} {}", self.what, field.name);
        let inside = rect.with_min_x(rect.left() + LABEL);
        let decimals = self.decimals;
        let number = DragValue::new(value)
            .speed(self.per_point)
            .custom_formatter(|value, _| text_of(value, decimals))
            .update_while_editing(false);
        // A child of its own: the row has taken the field's place already.
        let mut ui = ui.new_child(UiBuilder::new().max_rect(inside));
        ui.spacing_mut().button_padding = vec2(1.0, 2.0);
        ui.spacing_mut().interact_size = inside.size();
        let inactive = &mut ui.visuals_mut().widgets.inactive;
        inactive.weak_bg_fill = Color32::TRANSPARENT;
        inactive.bg_stroke = Stroke::NONE;
        let response = ui.put(inside, number);
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, ui.is_enabled(), &name));
        response.on_hover_text(Words::of(&ui).message(texts::drag_or_type(name)))
    }
}

/// The first click of two makes the number a text field, which the second one hits.
fn is_double_clicked(ui: &Ui, response: &Response) -> bool {
    let is_here = |at: egui::Pos2| response.rect.contains(at);
    ui.is_enabled()
        && ui.input(|input| {
            input.pointer.button_double_clicked(PointerButton::Primary)
                && input.pointer.interact_pos().is_some_and(is_here)
        })
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
