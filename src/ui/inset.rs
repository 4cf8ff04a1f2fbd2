//! What the recorded camera sees, in a corner of the scene while the work eye is in force.

use egui::{Align2, Area, Color32, Id, Order, Rect, Role, Sense, Stroke, StrokeKind, TextureId, Ui, WidgetInfo, vec2};

use super::theme::{CORNER, GRID, Tokens, small_font};
use super::words::Words;
use crate::editor::{Command, Editor, Eye, ViewCommand};
use crate::words::texts;

/// The largest part of the scene's width and height that it takes.
const PART: f32 = 0.22;
/// The smallest and the largest width, in points: where there is less room it does not show.
const WIDTHS: [f32; 2] = [112.0, 360.0];
/// Room below it for the line that names the view, in points.
const BELOW: f32 = 40.0;
/// How far from it the pointer of a drag is kept clear, in points: the readout beside the pointer is about as large.
const CLEAR: egui::Vec2 = vec2(200.0, 48.0);
/// Room that the card of first steps or a legend takes above it, in points.
const ABOVE: f32 = 220.0;

/// Where it is in a view, in points: above the line that names the view. It has the view's shape. `None` where there is no room.
fn place(viewport: Rect, is_busy_above: bool) -> Option<Rect> {
    let width = (viewport.width() * PART).min(WIDTHS[1]).floor();
    let height = (width * viewport.height() / viewport.width()).floor();
    let room = viewport.height() - BELOW - if is_busy_above { ABOVE } else { 2.0 * GRID };
    if width < WIDTHS[0] || height > room {
        return None;
    }
    let low = viewport.left_bottom() + vec2(2.0 * GRID, -BELOW);
    Some(Rect::from_min_size(low - vec2(0.0, height), vec2(width, height)))
}

/// Shows it where it is wanted, and says how large its picture is to be, in pixels. `is_busy_above`: something stands in the corner above.
pub fn show(
    ui: &Ui,
    viewport: Rect,
    editor: &Editor,
    picture: Option<TextureId>,
    is_busy_above: bool,
    commands: &mut Vec<Command>,
) -> Option<[u32; 2]> {
    let place = place(viewport, is_busy_above)?;
    let pointer = ui.ctx().pointer_latest_pos().filter(|_| editor.is_dragging());
    if pointer.is_some_and(|pointer| place.expand2(CLEAR).contains(pointer)) {
        return None;
    }
    let (index, eye) = editor.recorded_eye();
    let scene = editor.scene();
    let name = &scene.node(scene.rbt_node(eye)).name;
    let (tokens, words) = (Tokens::of(ui), Words::of(ui));
    Area::new(Id::unique("inset")).order(Order::Middle).fixed_pos(place.min).fade_in(false).show(ui.ctx(), |ui| {
        let response = ui.allocate_rect(place, Sense::CLICK);
        let label = words.message(texts::inset_of(name));
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &label));
        let painter = ui.painter();
        match picture {
            Some(texture) => {
                let whole = Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(1.0, 1.0));
                painter.image(texture, place, whole, Color32::WHITE);
            }
            None => drop(painter.rect_filled(place, 0.0, tokens.over_scene)),
        }
        let colour = match (editor.session().chosen.contains(&eye), response.hovered()) {
            (true, _) => tokens.accent,
            (false, true) => tokens.text,
            (false, false) => tokens.strong_line,
        };
        painter.rect_stroke(place, 0.0, Stroke::new(1.0, colour), StrokeKind::Inside);
        let galley = painter.layout_no_wrap(name.clone(), small_font(), tokens.text);
        let tag = Align2::LEFT_TOP.anchor_size(place.min + vec2(GRID, GRID), galley.size() + vec2(8.0, 4.0));
        if tag.max.x < place.max.x && tag.max.y < place.max.y {
            painter.rect_filled(tag, CORNER, tokens.over_scene);
            painter.galley(tag.min + vec2(4.0, 2.0), galley, tokens.text);
        }
        if response.double_clicked() {
            commands.push(Command::View(ViewCommand::SetEye(Eye::Recorded(index))));
        } else if super::icons::was_pressed(&response) {
            commands.push(Command::View(ViewCommand::Choose(Some(eye))));
        }
        response.on_hover_text(words.message(texts::inset_tip(name)));
    });
    let size = (place.size() * ui.pixels_per_point()).round();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is whole, small and positive")]
    Some([size.x as u32, size.y as u32])
}

#[cfg(test)]
mod tests {
    use egui::pos2;

    use super::*;

    #[test]
    fn it_has_the_shape_of_the_view_and_is_small_or_not_there() {
        for [width, height] in [[1106.0, 514.0], [620.0, 300.0], [2300.0, 1186.0], [900.0, 1200.0]] {
            let viewport = Rect::from_min_size(pos2(3.0, 24.0), vec2(width, height));
            let place = place(viewport, false).unwrap();
            assert!(viewport.shrink(GRID).contains_rect(place) && place.bottom() <= viewport.bottom() - BELOW);
            assert!(place.area() < 0.05 * viewport.area(), "{place}");
            assert!((place.aspect_ratio() - viewport.aspect_ratio()).abs() < 0.05 * viewport.aspect_ratio());
        }
        // A window of 720 by 480 points leaves this to the scene.
        assert_eq!(place(Rect::from_min_size(pos2(0.0, 24.0), vec2(460.0, 242.0)), false), None);
        let high = Rect::from_min_size(pos2(0.0, 24.0), vec2(1106.0, 300.0));
        assert!(place(high, false).is_some() && place(high, true).is_none());
    }
}
