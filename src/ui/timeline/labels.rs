//! The left column of the timeline: tabs and buttons, and the names of rows.

use egui::{Align2, Painter, Pos2, Rect, Role, Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2};

use super::hit::Layout;
use super::paint::Look;
use super::rows::{Row, Subject};
use super::timed_key_rows::RowPlace;
use super::{Ask, Tab, Timeline};
use crate::editor::keymap::Binding;
use crate::editor::{Command, WindowCommand};
use crate::pose::RbtIndex;
use crate::ui::access;
use crate::ui::binding_of;
use crate::ui::icons::{Icon, button_at, was_pressed};
use crate::ui::node_menu;
use crate::ui::theme::{CORNER, ROW, Tokens, small_font, text_font};
use crate::ui::tree::choice_by_click;
use crate::ui::words::Words;
use crate::words::texts;

/// Shows tabs and buttons.
pub fn header(timeline: &mut Timeline, ui: &Ui, layout: &Layout, bindings: &[Binding]) {
    let tokens = Tokens::of(ui);
    let middle = layout.header.center().y;
    let mut left = layout.header.left() + 8.0;
    let words = Words::of(ui);
    for (tab, name) in [(Tab::Keyframes, words.say(texts::KEYFRAMES)), (Tab::Graphs, words.say(texts::GRAPHS))] {
        let is_shown = timeline.tab == tab;
        let galley = ui.painter().layout_no_wrap(name.to_owned(), small_font(), tokens.text);
        let area = Rect::from_min_size(pos2(left, middle - ROW / 2.0), vec2(galley.size().x + 12.0, ROW));
        left = area.right() + 2.0;
        let response = ui.interact(area, ui.scope_id().with(tab), Sense::click());
        access::item(&response, Role::Tab, true, is_shown, name);
        let colour = if is_shown || response.hovered() { tokens.text } else { tokens.dim };
        if response.has_focus() {
            ui.painter().rect_stroke(area, CORNER, Stroke::new(1.0, tokens.accent), egui::StrokeKind::Inside);
        }
        ui.painter().galley_with_override_text_color(area.center() - galley.size() / 2.0, galley, colour);
        if is_shown {
            let under = area.shrink2(vec2(6.0, 0.0)).x_range();
            ui.painter().hline(under, area.bottom() - 1.0, Stroke::new(2.0, tokens.accent));
        }
        if was_pressed(&response) {
            timeline.tab = tab;
        }
    }
    let at =
        |slot: f32| Rect::from_center_size(pos2(layout.header.right() - 16.0 - 24.0 * slot, middle), vec2(24.0, ROW));
    for (slot, icon, command, ask) in [
        (1.0, Icon::FitAll, WindowCommand::FitTimeline, Ask::FitAll),
        (0.0, Icon::FitSelection, WindowCommand::FitSelection, Ask::FitSelection),
    ] {
        let binding = binding_of(bindings, &Command::Window(command));
        let (name, key) = binding.map(|binding| (words.say(binding.title()), binding.menu_key())).unwrap_or_default();
        if button_at(ui, at(slot), icon, name, &key, true, false) {
            timeline.ask(ask);
            ui.ctx().request_repaint();
        }
    }
}

/// Shows the names of rows: a click chooses a node, a triangle unfolds what is below it.
pub fn rows(
    timeline: &mut Timeline,
    ui: &Ui,
    look: &Look<'_>,
    rows: &[Row],
    bindings: &[Binding],
    commands: &mut Vec<Command>,
) {
    let layout = look.target.layout;
    let tokens = look.tokens;
    let column = layout.labels;
    let summary = column.with_max_y(layout.summary.bottom());
    let text = pos2(column.left() + 22.0, layout.summary.center().y);
    ui.painter().text(text, Align2::LEFT_CENTER, look.words.say(texts::ALL), text_font(), tokens.text);
    ui.painter().hline(column.x_range(), summary.bottom() - 0.5, Stroke::new(1.0, tokens.line));
    let area = column.with_min_y(summary.bottom());
    let painter = ui.painter().with_clip_rect(area.intersect(ui.clip_rect()));
    for index in look.target.rows_in_sight() {
        let row = &rows[index];
        let rect = Rect::from_x_y_ranges(column.x_range(), look.target.row_rect(index).y_range());
        let seen = rect.intersect(area);
        if let Subject::Rbt { rbt, .. } = row.subject {
            let id = ui.scope_id().with(("row", rbt));
            let sense = timeline.keyboard.item(ui, id, index + 1, rect.left(), Sense::click());
            name(ui, &painter, look, (row, rbt), (rect, seen, id, sense), bindings, commands);
        } else {
            let place = RowPlace { row, index: index + 1, rect, seen };
            timeline.keys.label(ui, &painter, look, place, &mut timeline.keyboard, commands);
        }
        let left = column.left() + 12.0 + 12.0 * depth(row);
        if row.has_children {
            fold_by_keyboard(timeline, ui, look, row, index + 1);
            triangle(timeline, ui, &painter, look, row, pos2(left, rect.center().y));
        }
    }
}

fn name(
    ui: &Ui,
    painter: &Painter,
    look: &Look<'_>,
    (row, rbt): (&Row, RbtIndex),
    (rect, seen, id, sense): (Rect, Rect, egui::Id, Sense),
    bindings: &[Binding],
    commands: &mut Vec<Command>,
) {
    let tokens = look.tokens;
    let scene = look.editor.scene();
    let is_chosen = look.editor.session().chosen.contains(&rbt);
    let response = ui.interact(seen.shrink2(vec2(1.0, 0.0)), id, sense);
    let path = scene.rbt_path(rbt);
    access::item(&response, Role::ListBoxOption, true, is_chosen, look.words.message(texts::row_of(path)));
    let fill = if is_chosen {
        Some(tokens.accent_fill)
    } else if response.hovered() {
        Some(tokens.raised)
    } else {
        None
    };
    let inside = rect.shrink2(vec2(3.0, 0.5));
    if let Some(fill) = fill {
        painter.rect_filled(inside, CORNER, fill);
    }
    if response.has_focus() {
        painter.rect_stroke(inside, CORNER, Stroke::new(1.0, tokens.accent), egui::StrokeKind::Inside);
    }
    let text = pos2(rect.left() + 22.0 + 12.0 * depth(row), rect.center().y);
    let name = &scene.node(row.node).name;
    let font = if row.depth == 0 { text_font() } else { small_font() };
    painter.text(text, Align2::LEFT_CENTER, name, font, if is_chosen { tokens.accent_text } else { tokens.text });
    let tip = if is_chosen {
        look.words.say(texts::A_CLICK_CHOOSES_NOTHING)
    } else {
        look.words.say(texts::CHOOSE_IT_DRAGS_MOVE_IT_AND_THE)
    };
    let response = response.on_hover_text(tip);
    node_menu::show(&response, look.editor, bindings, rbt, commands);
    if was_pressed(&response) {
        commands.push(choice_by_click(ui, look.editor, rbt));
    }
}

/// Right unfolds a row whose name has the focus, Left folds it.
fn fold_by_keyboard(timeline: &mut Timeline, ui: &Ui, look: &Look<'_>, row: &Row, place: usize) {
    if timeline.keyboard.focused_row(ui) != Some(place) {
        return;
    }
    let key = if row.is_unfolded { egui::Key::ArrowLeft } else { egui::Key::ArrowRight };
    if ui.input(|input| input.key_pressed(key)) {
        timeline.folds_focused = true;
        timeline.rows.toggle(look.editor.scene().node(row.node).path.as_str());
    }
}

fn triangle(timeline: &mut Timeline, ui: &Ui, painter: &Painter, look: &Look<'_>, row: &Row, centre: Pos2) {
    let tokens = look.tokens;
    let area = Rect::from_center_size(centre, vec2(18.0, ROW)).intersect(painter.clip_rect());
    let response = ui.interact(area, ui.scope_id().with(("fold row", row.node)), Sense::CLICK);
    let path = look.editor.scene().node(row.node).path.as_str();
    response.widget_info(|| {
        let name = if row.is_unfolded {
            look.words.message(texts::fold_row(path))
        } else {
            look.words.message(texts::unfold_row(path))
        };
        WidgetInfo::labeled(Role::Button, true, name)
    });
    let at = |x: f32, y: f32| centre + vec2(x, y);
    let corners = if row.is_unfolded {
        vec![at(-4.0, -2.0), at(4.0, -2.0), at(0.0, 3.0)]
    } else {
        vec![at(-2.0, -4.0), at(3.0, 0.0), at(-2.0, 4.0)]
    };
    let colour = if response.hovered() || response.has_focus() { tokens.text } else { tokens.dim };
    painter.add(Shape::convex_polygon(corners, colour, Stroke::NONE));
    if was_pressed(&response) {
        timeline.rows.toggle(path);
    }
}

#[expect(clippy::cast_precision_loss, reason = "trees are not that deep")]
pub(super) const fn depth(row: &Row) -> f32 {
    row.depth as f32
}
