//! The tree of nodes: a click chooses, a triangle folds, an eye looks from there, a field filters by name.

use std::collections::HashSet;
use std::sync::Arc;

use egui::{
    Align2, Color32, Pos2, Rect, Response, RichText, Role, Sense, Shape, Stroke, TextEdit, Ui, WidgetInfo, pos2, vec2,
};

use super::access;
use super::icons::{Icon, button_at, paint, was_pressed};
use super::theme::{CORNER, ROW, Tokens, text_font};
use super::words::Words;
use super::{key_of, node_menu, tip};
use crate::editor::keymap::Keymap;
use crate::editor::{Command, Editor, Eye, ViewCommand};
use crate::pose::RbtIndex;
use crate::scene::{Node, NodeId, NodeKind, SceneGraph};
use crate::words::texts;

/// Which nodes are folded, and the filter.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    folded: HashSet<Arc<str>>,
    filter: String,
    /// Whether shapes that a node carries have rows. What no node carries always has one.
    shows_shapes: bool,
}

/// One row, as it is drawn.
struct Row<'a> {
    id: NodeId,
    node: &'a Node,
    /// The node that a click chooses: itself, or the one that carries the shape or control node. `None`: a click chooses nothing.
    rbt: Option<RbtIndex>,
    depth: usize,
    has_children: bool,
    eye: Option<usize>,
}

impl Row<'_> {
    /// Whether it is a node that poses record.
    const fn is_rbt(&self) -> bool {
        matches!(self.node.kind, NodeKind::Rbt(_))
    }
}

impl Tree {
    /// Shows the tree.
    pub fn show(&mut self, ui: &mut Ui, editor: &Editor, keymap: &Keymap, commands: &mut Vec<Command>) {
        self.head(ui);
        ui.spacing_mut().item_spacing.y = 0.0;
        let scene = editor.scene();
        let shown = self.shown(scene);
        let eye_key = key_of(keymap, &Command::View(ViewCommand::NextEye));
        for &id in &shown {
            let node = scene.node(id);
            let row = Row {
                id,
                node,
                rbt: scene.carrying_rbt(id),
                depth: node.depth,
                has_children: scene
                    .subtree(id)
                    .skip(1)
                    .any(|below| self.shows_shapes || !matches!(scene.nodes()[below].kind, NodeKind::Shape(_))),
                eye: scene.eyes().iter().position(|&eye| scene.rbt_node(eye) == id),
            };
            self.row(ui, editor, &row, &eye_key, keymap, commands);
        }
        if shown.is_empty() {
            ui.label(RichText::new(Words::of(ui).say(texts::NO_NODE_IS_CALLED_THAT)).small().color(Tokens::of(ui).dim));
        }
        // What is left of the panel chooses nothing.
        let rest = ui.available_rect_before_wrap();
        if rest.is_positive() && ui.interact(rest, ui.scope_id().with("rest"), Sense::CLICK).clicked() {
            commands.push(Command::View(ViewCommand::Choose(None)));
        }
    }

    /// The title and the field of the filter.
    fn head(&mut self, ui: &mut Ui) {
        let tokens = Tokens::of(ui);
        let words = Words::of(ui);
        ui.horizontal(|ui| {
            ui.add_space(8.0);
            ui.label(RichText::new(words.say(texts::SCENE)).small().color(tokens.dim));
            let hint = words.say(texts::FILTER_NODES);
            let width = ui.available_width() - 32.0;
            let field = TextEdit::singleline(&mut self.filter).hint_text(hint).desired_width(width);
            let response = ui.add(field);
            response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, hint));
            if response.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Escape)) {
                self.filter.clear();
            }
            let (area, _) = ui.allocate_exact_size(vec2(22.0, ROW), Sense::hover());
            if button_at(ui, area, Icon::Shape, words.say(texts::SHAPES_IN_THE_TREE), "", true, self.shows_shapes) {
                self.shows_shapes = !self.shows_shapes;
            }
        });
    }

    /// The nodes that have rows: those that are not folded away or, with a filter, those whose names have it and all above them.
    fn shown(&self, scene: &SceneGraph) -> Vec<NodeId> {
        let filter = self.filter.trim().to_lowercase();
        if !filter.is_empty() {
            let mut is_shown = vec![false; scene.nodes().len()];
            for (id, node) in scene.nodes_with_ids() {
                let mut next = Some(id).filter(|_| node.name.to_lowercase().contains(&filter));
                while let Some(id) = next.filter(|id| !is_shown[id.get()]) {
                    is_shown[id.get()] = true;
                    next = scene.node(id).parent;
                }
            }
            return scene.nodes_with_ids().map(|(id, _)| id).filter(|id| is_shown[id.get()]).collect();
        }
        let mut folded_until = 0;
        let has_row = |id, node: &Node| {
            self.shows_shapes || !matches!(node.kind, NodeKind::Shape(_)) || scene.carrying_rbt(id).is_none()
        };
        let is_shown = |(id, node): &(NodeId, &Node)| {
            if id.get() < folded_until || !has_row(*id, node) {
                return false;
            }
            if self.folded.contains(node.path.as_str()) {
                folded_until = scene.subtree(*id).end;
            }
            true
        };
        scene.nodes_with_ids().filter(is_shown).map(|(id, _)| id).collect()
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
        let is_chosen = row.is_rbt() && row.rbt.is_some_and(|rbt| editor.session().chosen.contains(&rbt));
        access::item(&response, Role::ListBoxOption, true, is_chosen, &row.node.path);
        highlight(ui, rect, &response, is_chosen);
        let left = rect.left() + 6.0 + 14.0 * points(row.depth);
        let middle = rect.center().y;
        if row.has_children && self.filter.trim().is_empty() {
            self.triangle(ui, row, pos2(left + 5.0, middle));
        }
        paint(ui.painter(), icon(row), pos2(left + 21.0, middle), if is_chosen { tokens.accent } else { tokens.dim });
        let text = pos2(left + 34.0, middle);
        let colour = if row.is_rbt() { tokens.text } else { tokens.dim };
        ui.painter().text(text, Align2::LEFT_CENTER, &row.node.name, text_font(), colour);
        if let Some(eye) = row.eye {
            look_from(ui, editor, (eye, &row.node.name, eye_key), rect, commands);
        }
        let Some(rbt) = row.rbt else {
            let response = response.on_hover_text(words.say(texts::KEYS_MOVE_IT));
            if was_pressed(&response) {
                commands.push(editor.selecting_keys_of(row.id));
            }
            return;
        };
        let response = response.on_hover_text(if *editor.session().chosen == [rbt] {
            words.say(texts::A_CLICK_CHOOSES_NOTHING)
        } else {
            words.say(texts::CHOOSE_IT_DRAGS_MOVE_IT)
        });
        node_menu::show(&response, editor, keymap.bindings(), rbt, commands);
        if was_pressed(&response) {
            commands.push(choice_by_click(ui, editor, rbt));
        }
    }

    fn triangle(&mut self, ui: &Ui, row: &Row<'_>, centre: Pos2) {
        let tokens = Tokens::of(ui);
        let path: Arc<str> = row.node.path.as_str().into();
        let is_folded = self.folded.contains(&path);
        let area = Rect::from_center_size(centre, vec2(16.0, ROW));
        let response = ui.interact(area, ui.scope_id().with(("fold", &path)), Sense::click());
        let words = Words::of(ui);
        let says = words.message(if is_folded {
            texts::unfold_node(row.node.name.as_str())
        } else {
            texts::fold_node(row.node.name.as_str())
        });
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
        if was_pressed(&response) && !self.folded.remove(&path) {
            self.folded.insert(path);
        }
    }
}

fn icon(row: &Row<'_>) -> Icon {
    match (&row.node.kind, row.eye) {
        (NodeKind::Rbt(_), Some(0)) => Icon::Camera,
        (NodeKind::Rbt(_), _) if row.node.name == "ground" => Icon::Ground,
        (NodeKind::Rbt(_), _) if row.depth == 0 => Icon::Body,
        (NodeKind::Rbt(_), _) => Icon::Joint,
        (NodeKind::Shape(_), _) => Icon::Shape,
        (NodeKind::Control(_), _) => Icon::Control,
    }
}

/// The button that looks from an eye.
fn look_from(ui: &Ui, editor: &Editor, (eye, name, key): (usize, &str, &str), row: Rect, commands: &mut Vec<Command>) {
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

/// What a click on a node's name chooses: with Ctrl or Shift this node as well, or no longer; without, this node alone, or none if it
/// was chosen alone.
pub(super) fn choice_by_click(ui: &Ui, editor: &Editor, rbt: RbtIndex) -> Command {
    let adds = ui.input(|input| input.modifiers.command || input.modifiers.shift);
    let is_alone = *editor.session().chosen == [rbt];
    Command::View(if adds { ViewCommand::ChooseAlso(rbt) } else { ViewCommand::Choose((!is_alone).then_some(rbt)) })
}

/// A chosen row is filled and has a bar at its left; the row under the pointer is only filled.
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
    if is_chosen {
        ui.painter().rect_filled(rect.with_max_x(rect.left() + 3.0), 1, tokens.accent);
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

#[expect(clippy::cast_precision_loss, reason = "trees are not that deep")]
const fn points(depth: usize) -> f32 {
    depth as f32
}
