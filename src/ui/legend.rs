//! The legend over the scene: which ghosts are what, and how far they are from what is shown.

use egui::{Align2, Area, Color32, Frame, Id, Margin, Order, Rect, RichText, Role, Sense, Ui, WidgetInfo, vec2};

use super::icons::was_pressed;
use super::theme::{CORNER, GRID, ROW, Tokens, number_font, small_font};
use super::words::Words;
use crate::colour::Colour;
use crate::editor::{Command, Editor, ViewCommand};
use crate::keyframe::Blend;
use crate::pose::RbtIndex;
use crate::view::{BLEND_COLOURS, blend_off, compared_off};
use crate::words::texts;

/// Width of the legend, in points.
const WIDTH: f32 = 264.0;
/// Side of a patch of colour, in points.
const PATCH: f32 = 10.0;

/// Whether something is compared, so that there is a legend.
pub fn is_shown(editor: &Editor) -> bool {
    !editor.session().compared_blends.is_empty() || editor.compared().is_some()
}

/// Shows the legend at the top left, where something is compared. Returns what is left of the view below it.
pub fn show(ui: &Ui, viewport: Rect, editor: &Editor, commands: &mut Vec<Command>) -> Rect {
    if !is_shown(editor) {
        return viewport;
    }
    let compares = !editor.session().compared_blends.is_empty();
    let tokens = Tokens::of(ui);
    let shown = Area::new(Id::unique("legend"))
        .order(Order::Middle)
        .fixed_pos(viewport.left_top() + vec2(2.0 * GRID, 2.0 * GRID))
        .fade_in(false)
        .show(ui.ctx(), |ui| {
            let frame =
                Frame::new().fill(tokens.over_scene).corner_radius(CORNER).inner_margin(Margin::symmetric(8, 6));
            frame.show(ui, |ui| {
                ui.set_width(WIDTH.min(viewport.width() - 8.0 * GRID));
                ui.spacing_mut().item_spacing.y = 0.0;
                if compares {
                    blends(ui, editor, commands);
                }
                if editor.compared().is_some() {
                    other_file(ui, editor, commands);
                }
            });
        });
    viewport.with_min_y(shown.response.rect.bottom())
}

fn blends(ui: &mut Ui, editor: &Editor, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let playing = editor.document().interpolation;
    let has_sample = editor.key_time().is_some();
    let heading = match editor.session().chosen.primary() {
        _ if !has_sample => words.say(texts::PLAY_OR_SCRUB_TO_COMPARE).to_owned(),
        Some(chosen) => words.message(texts::off_from_at(words.say(playing.title()), editor.scene().rbt_path(chosen))),
        None => words.message(texts::off_from_at_most(words.say(playing.title()))),
    };
    ui.add(egui::Label::new(RichText::new(heading).small().color(Tokens::of(ui).dim)).truncate());
    for (blend, colour) in Blend::others(playing).into_iter().zip(BLEND_COLOURS) {
        let compared = &editor.session().compared_blends;
        let is_on = compared.contains(&blend);
        let off = if is_on { blend_off(editor, blend) } else { None };
        let text = off.map(|(degrees, rbt)| {
            let node = if editor.session().chosen.is_empty() { node_name(editor, rbt) } else { "" };
            degrees_at(degrees, node)
        });
        if row(ui, words.say(blend.title()), colour, is_on, &text.unwrap_or_default()) {
            let blends = Blend::ALL.into_iter().filter(|one| (*one == blend) != compared.contains(one)).collect();
            commands.push(Command::View(ViewCommand::CompareBlends(blends)));
        }
    }
}

/// The name alone: a path would not fit, and the tooltip of a row has room for it.
fn node_name(editor: &Editor, rbt: RbtIndex) -> &str {
    editor.scene().node(editor.scene().rbt_node(rbt)).name.as_str()
}

fn degrees_at(degrees: f64, node: &str) -> String {
    if node.is_empty() { format!("{degrees:.1}°") } else { format!("{node}  {degrees:.1}°") }
}

/// A row that a click switches on and off.
fn row(ui: &mut Ui, name: &str, colour: Colour, is_on: bool, off: &str) -> bool {
    let tokens = Tokens::of(ui);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, is_on, name));
    if response.hovered() || response.has_focus() {
        ui.painter().rect_filled(rect.expand2(vec2(4.0, 0.0)), CORNER, tokens.hovered);
    }
    patch(ui, rect, colour, is_on);
    let text = if is_on { tokens.text } else { tokens.dim };
    let at = rect.left_center() + vec2(PATCH + 8.0, 0.0);
    ui.painter().text(at, Align2::LEFT_CENTER, name, small_font(), text);
    ui.painter().text(rect.right_center(), Align2::RIGHT_CENTER, off, number_font(), text);
    let tip = if is_on { texts::A_CLICK_HIDES_IT } else { texts::A_CLICK_SHOWS_IT };
    was_pressed(&response.on_hover_text(Words::of(ui).say(tip)))
}

fn patch(ui: &Ui, row: Rect, colour: Colour, is_on: bool) {
    let [red, green, blue] = colour.to_bytes();
    let colour = Color32::from_rgb(red, green, blue);
    let area = Rect::from_center_size(row.left_center() + vec2(PATCH / 2.0, 0.0), egui::Vec2::splat(PATCH));
    let fill = if is_on { colour } else { Color32::TRANSPARENT };
    let stroke = egui::Stroke::new(1.0, colour);
    ui.painter().rect(area, 2.0, fill, stroke, egui::StrokeKind::Inside);
}

/// The other file, and the largest differences from it under the playhead.
fn other_file(ui: &mut Ui, editor: &Editor, commands: &mut Vec<Command>) {
    let (tokens, words) = (Tokens::of(ui), Words::of(ui));
    let Some(compared) = editor.compared() else { return };
    let name = compared.path.file_name().unwrap_or(compared.path.as_os_str()).to_string_lossy();
    ui.horizontal(|ui| {
        ui.set_min_height(ROW);
        let (rect, _) = ui.allocate_exact_size(vec2(PATCH + 4.0, ROW), Sense::hover());
        patch(ui, rect, Colour::OTHER_FILE, true);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let end = ui.small_button("×");
            end.widget_info(|| WidgetInfo::labeled(Role::Button, true, words.say(texts::COMMAND_COMPARE_END)));
            if was_pressed(&end.on_hover_text(words.say(texts::COMMAND_COMPARE_END))) {
                commands.push(Command::View(ViewCommand::EndCompareWith));
            }
            ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                let label = egui::Label::new(RichText::new(&*name).size(12.0).color(tokens.text)).truncate();
                ui.add(label).on_hover_text(compared.path.display().to_string());
            });
        });
    });
    let Some(off) = compared_off(editor) else { return };
    let path = |rbt| editor.scene().rbt_path(rbt);
    let line = |ui: &mut Ui, text: String| {
        ui.add(egui::Label::new(RichText::new(text).small().color(tokens.text)).truncate());
    };
    line(ui, words.message(texts::most_turned(format!("{:.1}", off.degrees), path(off.turned))));
    line(ui, words.message(texts::most_moved(format!("{:.3}", off.units), path(off.moved))));
}
