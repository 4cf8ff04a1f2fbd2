//! The context menu of a node, the same everywhere where the node is: in the tree, in the timeline's rows, in the scene.

use egui::{Button, Rect, Response, RichText, Sense, Ui, vec2};
use glam::Vec2;

use super::binding_of;
use super::icons::was_pressed;
use super::theme::{ROW, Tokens};
use super::timeline::{key_colour_now, put_control_above};
use super::words::Words;
use crate::editor::keymap::Binding;
use crate::editor::{CLICK_REACH, ClipboardCommand, Command, Edit, Editor, Eye, NodeEdit, NodePart, ViewCommand};
use crate::pose::RbtIndex;
use crate::scene::{Channel, NodeKind};
use crate::words::texts;

/// Opens the menu of a node at a click with the right button.
pub fn show(response: &Response, editor: &Editor, bindings: &[Binding], rbt: RbtIndex, commands: &mut Vec<Command>) {
    response.context_menu(|ui| items(ui, editor, bindings, rbt, commands));
}

/// Opens the menu of the node under the pointer at a click with the right button into the 3D view. `opened` is the node that it was
/// opened for.
pub fn show_over_scene(
    ui: &Ui,
    viewport: Rect,
    editor: &Editor,
    bindings: &[Binding],
    opened: &mut Option<RbtIndex>,
    commands: &mut Vec<Command>,
) {
    if !viewport.is_positive() {
        return;
    }
    let response = ui.interact(viewport, ui.scope_id().with("menu of the scene"), Sense::CLICK);
    if response.secondary_clicked()
        && let Some(at) = response.interact_pointer_pos()
    {
        let camera = editor.camera(Vec2::new(viewport.width(), viewport.height()));
        let at = at - viewport.min;
        *opened = editor.part_near(&camera, Vec2::new(at.x, at.y), CLICK_REACH);
    }
    if let Some(rbt) = *opened {
        show(&response, editor, bindings, rbt, commands);
    }
}

/// What the menu of a node has. Of a node that is one of several chosen ones, commands mean all of them.
pub fn items(ui: &mut Ui, editor: &Editor, bindings: &[Binding], rbt: RbtIndex, commands: &mut Vec<Command>) {
    let scene = editor.scene();
    let chosen = &editor.session().chosen;
    let is_of_several = chosen.len() > 1 && chosen.contains(&rbt);
    let node = (!is_of_several).then_some(rbt);
    ui.set_min_width(232.0);
    ui.spacing_mut().item_spacing.y = 0.0;
    let words = Words::of(ui);
    let caption =
        if is_of_several { words.message(texts::count_nodes(chosen.len())) } else { scene.rbt_path(rbt).to_owned() };
    ui.horizontal(|ui| {
        ui.add_space(2.0);
        ui.label(RichText::new(caption).small().color(Tokens::of(ui).dim));
    });
    // The names and hotkeys are those of the same commands for the chosen nodes.
    let mut listed = |ui: &mut Ui, of_chosen: Command, command: Command| {
        let binding = binding_of(bindings, &of_chosen);
        let title = binding.map_or("", |binding| Words::of(ui).say(binding.title()));
        let key = binding.map(Binding::menu_key).unwrap_or_default();
        if item(ui, title, &key, editor.can(&command)) {
            commands.push(command);
        }
    };
    let mut edit = |ui: &mut Ui, edit| {
        listed(ui, Command::Edit(Edit::Nodes(edit, None)), Command::Edit(Edit::Nodes(edit, node)));
    };
    edit(ui, NodeEdit::Mirror);
    edit(ui, NodeEdit::Reset(NodePart::Both));
    edit(ui, NodeEdit::Reset(NodePart::Rotation));
    edit(ui, NodeEdit::Reset(NodePart::Translation));
    ui.separator();
    let copy = |node| Command::Clipboard(ClipboardCommand::CopyPose(node));
    listed(ui, copy(None), copy(Some(rbt)));
    for is_mirrored in [false, true] {
        let paste = |node| Command::Edit(Edit::Nodes(NodeEdit::Paste { is_mirrored }, node));
        listed(ui, paste(None), paste(node));
    }
    ui.separator();
    let in_sight = Command::View(ViewCommand::ShowChosen);
    let binding = binding_of(bindings, &in_sight);
    let title = binding.map_or("", |binding| Words::of(ui).say(binding.title()));
    if item(ui, title, &binding.map(Binding::menu_key).unwrap_or_default(), true) {
        if !chosen.contains(&rbt) {
            commands.push(Command::View(ViewCommand::Choose(Some(rbt))));
        }
        commands.push(in_sight);
    }
    let words = Words::of(ui);
    let eye = scene.eyes().iter().position(|&eye| eye == rbt);
    if item(ui, &words.message(texts::look_from_eye(&scene.node(scene.rbt_node(rbt)).name)), "", true) {
        commands.push(Command::View(match eye {
            Some(eye) => ViewCommand::SetEye(Eye::Recorded(eye)),
            None => ViewCommand::LookFromNode(Some(rbt)),
        }));
    }
    let is_still = !editor.is_playing();
    let id = scene.rbt_node(rbt);
    if item(ui, words.say(texts::PUT_A_CONTROL_NODE_ABOVE_IT), "", is_still) {
        commands.push(put_control_above(&scene.node(id).path));
    }
    let is_without_keys =
        |kind: &NodeKind| matches!(kind, NodeKind::Shape(placed) if placed.tracks().get(Channel::Colour).is_none());
    let shapes: Vec<_> =
        scene.nodes_with_ids().filter(|(_, node)| node.parent == Some(id) && is_without_keys(&node.kind)).collect();
    if shapes.is_empty() {
        return;
    }
    ui.add_enabled_ui(is_still, |ui| {
        ui.menu_button(words.say(texts::KEY_A_COLOUR), |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            for (_, shape) in shapes {
                if item(ui, &words.message(texts::key_colour_of(&shape.name)), "", is_still) {
                    commands.push(key_colour_now(editor, &shape.path));
                }
            }
        });
    });
}

/// An item of a menu at the pointer, with its hotkey, if it has one. Says whether it was pressed; the menu is then over.
pub fn item(ui: &mut Ui, label: &str, key: &str, is_enabled: bool) -> bool {
    let mut button = Button::new(label).min_size(vec2(0.0, ROW));
    if !key.is_empty() {
        button = button.shortcut_text(RichText::new(key).monospace());
    }
    let is_pressed = was_pressed(&ui.add_enabled(is_enabled, button));
    if is_pressed {
        ui.close();
    }
    is_pressed
}
