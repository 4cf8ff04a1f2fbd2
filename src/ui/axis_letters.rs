//! The world's axes as letters in a corner of the scene. A click on one looks along it.

use egui::{Align2, Area, Color32, Id, Order, Pos2, Rect, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};
use glam::{Quat, Vec2, Vec3};

use super::icons::was_pressed;
use super::theme::{GRID, Tokens, small_font};
use super::words::Words;
use crate::editor::keymap::{Binding, Keymap};
use crate::editor::{Command, Editor, Side, ViewCommand};

/// Side of the square, in points.
const SIDE: f32 = 84.0;
/// How far a letter is from the middle, in points.
const REACH: f32 = 30.0;
/// Radii of a letter's disc, and of that without a letter on the other side of the axis, in points.
const RADIUS: f32 = 9.0;
const SMALL_RADIUS: f32 = 6.0;
/// How much of its colour a disc has behind the middle.
const BEHIND: f32 = 0.55;

/// The ends of the axes: their direction, the side that one looks from there, their index, and their letter, where they have one.
const ENDS: [(Vec3, Side, usize, &str); 6] = [
    (Vec3::X, Side::Right, 0, "X"),
    (Vec3::Y, Side::Top, 1, "Y"),
    (Vec3::Z, Side::Front, 2, "Z"),
    (Vec3::NEG_X, Side::Left, 0, ""),
    (Vec3::NEG_Y, Side::Bottom, 1, ""),
    (Vec3::NEG_Z, Side::Back, 2, ""),
];

/// The width that the letters take at the top right of the 3D view, in points; 0 where there is no room for them.
pub fn width(viewport: Rect) -> f32 {
    if viewport.width() < 4.0 * SIDE || viewport.height() < 2.5 * SIDE { 0.0 } else { SIDE + GRID }
}

/// Shows the letters where there is room for them. `rotation` is that of the eye that is drawn with, if not the editor's.
pub fn show(
    ui: &Ui,
    viewport: Rect,
    editor: &Editor,
    rotation: Option<Quat>,
    keymap: &Keymap,
    commands: &mut Vec<Command>,
) {
    if width(viewport) == 0.0 {
        return;
    }
    let eye_from_world = rotation.unwrap_or_else(|| editor.camera(Vec2::ONE).world_from_eye.rotation).inverse();
    let mut ends = ENDS.map(|(direction, side, axis, letter)| (eye_from_world * direction, side, axis, letter));
    // The farthest first, so that what is before it is painted over it and takes the click.
    ends.sort_by(|a, b| a.0.z.total_cmp(&b.0.z));
    let place = Rect::from_min_size(viewport.right_top() + vec2(-width(viewport), GRID), vec2(SIDE, SIDE));
    Area::new(Id::unique("axis letters")).order(Order::Middle).fixed_pos(place.min).fade_in(false).show(
        ui.ctx(),
        |ui| {
            ui.allocate_rect(place, Sense::hover());
            let centre = place.center();
            for (direction, side, axis, letter) in ends {
                let at = centre + vec2(direction.x, -direction.y) * REACH;
                end(ui, [centre, at], direction.z, (side, axis, letter), keymap, commands);
            }
        },
    );
}

/// An end of an axis, whose direction points towards the eye by `towards`.
fn end(
    ui: &Ui,
    [centre, at]: [Pos2; 2],
    towards: f32,
    (side, axis, letter): (Side, usize, &str),
    keymap: &Keymap,
    commands: &mut Vec<Command>,
) {
    let tokens = Tokens::of(ui);
    let words = Words::of(ui);
    let has_letter = !letter.is_empty();
    let radius = if has_letter { RADIUS } else { SMALL_RADIUS };
    let area = Rect::from_center_size(at, vec2(2.0, 2.0) * radius);
    let command = Command::View(ViewCommand::LookFrom(side));
    let title = keymap.bindings().iter().find(|binding| binding.command == command).map(Binding::title);
    let title = title.map(|title| words.say(title)).unwrap_or_default();
    let response = ui.interact(area, ui.scope_id().with(("axis", title)), Sense::CLICK);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, title));
    let strength = if towards < -0.01 { BEHIND } else { 1.0 };
    let colour = tokens.axes[axis].gamma_multiply(strength);
    let painter = ui.painter();
    if has_letter {
        painter.line_segment([pos2(centre.x, centre.y), at], Stroke::new(2.0, colour));
        painter.circle_filled(at, radius, colour);
        painter.text(at, Align2::CENTER_CENTER, letter, small_font(), Color32::BLACK);
    } else {
        painter.circle(at, radius - 1.0, tokens.over_scene, Stroke::new(1.5, colour));
    }
    if response.hovered() {
        painter.circle_stroke(at, radius + 1.5, Stroke::new(1.5, tokens.text));
    }
    let key = super::key_of(keymap, &command);
    if was_pressed(&response.on_hover_text(super::tip(title, &key))) {
        commands.push(command);
    }
}
