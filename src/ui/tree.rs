//! The tree of RBT nodes: a click chooses, a triangle folds, an eye looks from there.

use std::collections::HashSet;

use egui::{Align2, Color32, Pos2, Rect, Response, RichText, Role, Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2};

use super::icons::{Icon, paint, was_pressed};
use super::theme::{CORNER, ROW, Tokens, text_font};
use super::words::Words;
use super::{key_of, node_menu, tip};
use crate::editor::keymap::Keymap;
use crate::editor::{Command, Editor, Eye, ViewCommand};
use crate::pose::RbtIndex;
use crate::scene::{NodeId, NodeKind, SceneGraph};
use crate::words::texts;

/// Which nodes are folded.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    folded: HashSet<RbtIndex>,
}

/// One row, as it is drawn.
struct Row<'a> {
    rbt: RbtIndex,
    name: &'a str,
    depth: usize,
    has_children: bool,
    eye: Option<usize>,
}

impl Tree {
    /// Shows the tree.
    pub fn show(&mut self, ui: &mut Ui, editor: &Editor, keymap: &Keymap, commands: &mut Vec<Command>) {
        let tokens = Tokens::of(ui);
        ui.horizontal(|ui| {
            ui.add_space(8.0);
            ui.label(RichText::new(Words::of(ui).say(texts::SCENE)).small().color(tokens.dim));
        });
        ui.spacing_mut().item_spacing.y = 0.0;
        let scene = editor.scene();
        let mut folded_until = 0;
        let eye_key = key_of(keymap, &Command::View(ViewCommand::NextEye));
        for rbt in scene.rbt_indices() {
            let id = scene.rbt_node(rbt);
            if id.get() < folded_until {
                continue;
            }
            let below = scene.subtree(id);
            if self.folded.contains(&rbt) {
                folded_until = below.end;
            }
            let row = Row {
                rbt,
                name: &scene.node(id).name,
                depth: depth(scene, id),
                has_children: below.skip(1).any(|index| matches!(scene.nodes()[index].kind, NodeKind::Rbt(_))),
                eye: scene.eyes().iter().position(|&eye| eye == rbt),
            };
            self.row(ui, editor, &row, &eye_key, keymap, commands);
        }
        // What is left of the panel chooses nothing.
        let rest = ui.available_rect_before_wrap();
        if rest.is_positive() && ui.interact(rest, ui.scope_id().with("rest"), Sense::CLICK).clicked() {
            commands.push(Command::View(ViewCommand::Choose(None)));
        }
    }

    fn row(
        &mut self,
        ui: &mut Ui,
        editor: &Editor,
        row: &Row<'_>,
        eye_key: &str,
        keymap: &Keymap,
        commands: &mut Vec<Command>,
    ) {
        let tokens = Tokens::of(ui);
        let words = Words::of(ui);
        let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::click());
        let is_chosen = editor.session().chosen.contains(&row.rbt);
        response.widget_info(|| {
            WidgetInfo::selected(Role::ListBoxOption, true, is_chosen, editor.scene().rbt_path(row.rbt))
        });
        highlight(ui, rect, &response, is_chosen);
        let left = rect.left() + 6.0 + 14.0 * points(row.depth);
        let middle = rect.center().y;
        if row.has_children {
            self.triangle(ui, row.rbt, row.name, pos2(left + 5.0, middle));
        }
        let icon = match (row.eye, row.has_children, row.name) {
            (Some(0), ..) => Icon::Camera,
            (_, _, "ground") => Icon::Ground,
            (_, _, _) if row.depth == 0 => Icon::Body,
            _ => Icon::Joint,
        };
        paint(ui.painter(), icon, pos2(left + 21.0, middle), if is_chosen { tokens.accent } else { tokens.dim });
        let text = pos2(left + 34.0, middle);
        ui.painter().text(text, Align2::LEFT_CENTER, row.name, text_font(), tokens.text);
        if let Some(eye) = row.eye {
            self.eye(ui, editor, (eye, row.name, eye_key), rect, commands);
        }
        let response = response.on_hover_text(if is_chosen {
            words.say(texts::A_CLICK_CHOOSES_NOTHING)
        } else {
            words.say(texts::CHOOSE_IT_DRAGS_MOVE_IT)
        });
        node_menu::show(&response, editor, keymap.bindings(), row.rbt, commands);
        if was_pressed(&response) {
            commands.push(choice_by_click(ui, editor, row.rbt));
        }
    }

    fn triangle(&mut self, ui: &Ui, rbt: RbtIndex, name: &str, centre: Pos2) {
        let tokens = Tokens::of(ui);
        let is_folded = self.folded.contains(&rbt);
        let area = Rect::from_center_size(centre, vec2(16.0, ROW));
        let response = ui.interact(area, ui.scope_id().with(("fold", rbt)), Sense::click());
        let words = Words::of(ui);
        let says = words.message(if is_folded { texts::unfold_node(name) } else { texts::fold_node(name) });
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &says));
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_expanded(!is_folded));
        ring(ui, area, &response);
        let at = |x: f32, y: f32| centre + vec2(x, y);
        let corners = if is_folded {
            vec![at(-2.0, -4.0), at(3.0, 0.0), at(-2.0, 4.0)]
        } else {
            vec![at(-4.0, -2.0), at(4.0, -2.0), at(0.0, 3.0)]
        };
        let colour = if response.hovered() || response.has_focus() { tokens.text } else { tokens.dim };
        ui.painter().add(Shape::convex_polygon(corners, colour, Stroke::NONE));
        if was_pressed(&response) && !self.folded.remove(&rbt) {
            self.folded.insert(rbt);
        }
    }

    #[expect(clippy::unused_self, reason = "it is a part of the tree")]
    fn eye(
        &self,
        ui: &Ui,
        editor: &Editor,
        (eye, name, key): (usize, &str, &str),
        row: Rect,
        commands: &mut Vec<Command>,
    ) {
        let tokens = Tokens::of(ui);
        let centre = pos2(row.right() - 14.0, row.center().y);
        let area = Rect::from_center_size(centre, vec2(24.0, ROW));
        let response = ui.interact(area, ui.scope_id().with(("eye", eye)), Sense::click());
        let words = Words::of(ui);
        let says = words.message(texts::look_from_eye(name));
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &says));
        let is_eye = editor.session().eye == Eye::Recorded(eye);
        let colour = match (is_eye, response.hovered()) {
            (true, _) => tokens.accent,
            (false, true) => tokens.text,
            (false, false) => tokens.strong_line,
        };
        paint(ui.painter(), Icon::Eye, centre, colour);
        ring(ui, area, &response);
        let text = if is_eye { words.message(texts::is_the_eye(name)) } else { says };
        if was_pressed(&response.on_hover_text(tip(&text, key))) {
            commands.push(Command::View(ViewCommand::SetEye(Eye::Recorded(eye))));
        }
    }
}

/// What a click on a node's name chooses: with Ctrl or Shift this node as well, or no longer; without, this node alone, or none if it
/// was chosen alone.
pub(super) fn choice_by_click(ui: &Ui, editor: &Editor, rbt: RbtIndex) -> Command {
    let adds = ui.input(|input| input.modifiers.command || input.modifiers.shift);
    let is_alone = *editor.session().chosen == [rbt];
    Command::View(if adds { ViewCommand::ChooseAlso(rbt) } else { ViewCommand::Choose((!is_alone).then_some(rbt)) })
}

fn highlight(ui: &Ui, rect: Rect, response: &Response, is_chosen: bool) {
    let tokens = Tokens::of(ui);
    let fill = match (is_chosen, response.hovered()) {
        (true, _) => tokens.accent_fill,
        (false, true) => tokens.raised,
        (false, false) => Color32::TRANSPARENT,
    };
    if fill != Color32::TRANSPARENT {
        ui.painter().rect_filled(rect, CORNER, fill);
    }
    ring(ui, rect, response);
}

/// Shows that the keyboard is here.
pub(super) fn ring(ui: &Ui, rect: Rect, response: &Response) {
    if response.has_focus() {
        let stroke = Stroke::new(1.0, Tokens::of(ui).accent);
        ui.painter().rect_stroke(rect, CORNER, stroke, egui::StrokeKind::Inside);
    }
}

/// How many RBT nodes stand above one.
fn depth(scene: &SceneGraph, id: NodeId) -> usize {
    std::iter::successors(scene.node(id).parent, |&above| scene.node(above).parent)
        .filter(|&above| matches!(scene.node(above).kind, NodeKind::Rbt(_)))
        .count()
}

#[expect(clippy::cast_precision_loss, reason = "trees are not that deep")]
const fn points(depth: usize) -> f32 {
    depth as f32
}
