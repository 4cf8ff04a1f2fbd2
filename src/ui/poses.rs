//! Poses with names, as pictures: those that are shipped and the user's own. A click gives one to the chosen nodes.

use std::sync::Arc;

use egui::{
    Align2, Button, Context, Id, Rect, RichText, Role, ScrollArea, Sense, Stroke, TextEdit, Ui, WidgetInfo, pos2, vec2,
};
use glam::{Quat, Vec3};

use super::axis_letters;
use super::icons::was_pressed;
use super::theme::{CORNER, GRID, ROW, Tokens, small_font};
use super::thumbnails::{THUMBNAIL_PX, Thumbnails};
use super::words::Words;
use crate::editor::{Command, Edit, Editor, FileCommand, WindowCommand};
use crate::pose::{Pose, RbtIndex};
use crate::pose_file::{PoseFile, shipped_poses};
use crate::rbt::Rbt;
use crate::scene::SceneGraph;
use crate::words::texts;

/// How far the camera of a picture stands from a body, as a multiple of how far its nodes lie from its root.
const DISTANCE: f32 = 2.7;

/// The poses, and their pictures.
#[derive(Debug, Default)]
pub struct Poses {
    is_shown: bool,
    own: Vec<Arc<PoseFile>>,
    /// The name that is being typed.
    name: String,
    pictured: Pictured,
}

/// The scene's pose for the picture of each named pose. They are held, so that the pictures stay.
#[derive(Debug, Default)]
struct Pictured {
    scene: Option<Arc<SceneGraph>>,
    chosen: Option<RbtIndex>,
    poses: Vec<(Arc<PoseFile>, Option<Pose>)>,
}

impl Poses {
    /// Whether the list shows.
    pub const fn is_shown(&self) -> bool {
        self.is_shown
    }

    /// Shows or hides the list.
    pub const fn toggle(&mut self) {
        self.is_shown = !self.is_shown;
    }

    /// Takes in the user's own poses.
    pub fn put_own(&mut self, own: Vec<PoseFile>) {
        self.own = own.into_iter().map(Arc::new).collect();
        self.pictured = Pictured::default();
    }

    /// Shows the list over the scene.
    pub fn show(
        &mut self,
        context: &Context,
        viewport: Rect,
        editor: &Editor,
        thumbnails: &mut Thumbnails,
        commands: &mut Vec<Command>,
    ) {
        if !self.is_shown {
            return;
        }
        let mut is_open = true;
        egui::Window::new(Words::of_context(context).say(texts::COMMAND_POSES))
            .id(Id::unique("poses"))
            .open(&mut is_open)
            .collapsible(false)
            .fade_in(false)
            .fade_out(false)
            .default_size(vec2(432.0, 340.0))
            .default_pos(viewport.right_top() + vec2(-464.0 - axis_letters::width(viewport), 16.0))
            .constrain_to(context.content_rect())
            .show(context, |ui| self.list(ui, editor, thumbnails, commands));
        if !is_open {
            commands.push(Command::Window(WindowCommand::TogglePoses));
        }
    }

    fn list(&mut self, ui: &mut Ui, editor: &Editor, thumbnails: &mut Thumbnails, commands: &mut Vec<Command>) {
        let words = Words::of(ui);
        let chosen = editor.session().chosen.primary();
        self.pictured.bring_up_to_date(editor, &self.own);
        let first = shipped_poses().first().and_then(|pose| pose.root_in(editor.scene(), chosen));
        if let Some(root) = first {
            let text = words.message(texts::poses_are_for(editor.scene().rbt_path(root)));
            ui.label(RichText::new(text).small().color(Tokens::of(ui).dim));
        }
        ui.horizontal(|ui| {
            let hint = words.say(texts::POSE_OF_YOUR_OWN);
            let field = ui.add(TextEdit::singleline(&mut self.name).hint_text(hint).desired_width(220.0));
            field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, hint));
            let is_named = !self.name.trim().is_empty();
            let is_entered = field.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Enter));
            let save = ui.add_enabled(is_named, Button::new(words.say(texts::SAVE_POSE)));
            if (was_pressed(&save) || is_entered) && is_named {
                commands.push(Command::File(FileCommand::SavePose(self.name.trim().to_owned())));
                self.name.clear();
            }
        });
        ui.separator();
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                ui.spacing_mut().item_spacing = vec2(GRID, GRID);
                for (pose, pictured) in &self.pictured.poses {
                    picture(ui, editor, pose, pictured.as_ref(), thumbnails, commands);
                }
            });
        });
    }
}

impl Pictured {
    fn bring_up_to_date(&mut self, editor: &Editor, own: &[Arc<PoseFile>]) {
        let scene = editor.scene();
        let chosen = editor.session().chosen.primary();
        if self.chosen == chosen && self.scene.as_ref().is_some_and(|held| Arc::ptr_eq(held, scene)) {
            return;
        }
        let shipped = shipped_poses().iter().cloned().map(Arc::new);
        let poses = shipped.chain(own.iter().cloned()).map(|pose| {
            let pictured = pictured(scene, &pose, chosen);
            (pose, pictured)
        });
        *self = Self { poses: poses.collect(), chosen, scene: Some(Arc::clone(scene)) };
    }
}

/// The scene at rest but for the pose, with its first eye before the body; `None` where the pose fits nowhere.
fn pictured(scene: &SceneGraph, pose: &PoseFile, chosen: Option<RbtIndex>) -> Option<Pose> {
    let root = pose.root_in(scene, chosen);
    if root.is_none() && pose.root.is_some() {
        return None;
    }
    let mut pictured = scene.rest_pose().clone();
    for (rbt, placed) in pose.fit(scene, scene.rest_pose(), root).placed {
        pictured.set(rbt, placed);
    }
    let eye = scene.eyes()[0];
    if let Some(root) = root.filter(|_| scene.node(scene.rbt_node(eye)).parent.is_none()) {
        let place = |rbt| scene.world_from_rbt(scene.rest_pose(), 0.0, rbt).translation;
        let centre = place(root);
        let below = scene.subtree(scene.rbt_node(root));
        let is_below = |rbt: &RbtIndex| below.contains(&scene.rbt_node(*rbt).get());
        let farthest = scene.rbt_indices().filter(is_below).map(|rbt| place(rbt).distance(centre)).fold(1.0, f32::max);
        pictured.set(eye, Rbt::new(centre + Vec3::new(0.0, 0.05, DISTANCE) * farthest, Quat::IDENTITY));
    }
    Some(pictured)
}

fn picture(
    ui: &mut Ui,
    editor: &Editor,
    pose: &Arc<PoseFile>,
    pictured: Option<&Pose>,
    thumbnails: &mut Thumbnails,
    commands: &mut Vec<Command>,
) {
    let tokens = Tokens::of(ui);
    #[expect(clippy::cast_precision_loss, reason = "it is a small picture")]
    let size = vec2(THUMBNAIL_PX[0] as f32, THUMBNAIL_PX[1] as f32) * 0.75;
    let is_enabled = pictured.is_some() && !editor.is_playing();
    let sense = if is_enabled { Sense::click() } else { Sense::hover() };
    let (rect, response) = ui.allocate_exact_size(size + vec2(0.0, ROW), sense);
    let says = Words::of(ui).message(texts::give_pose(pose.name.as_str()));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, is_enabled, &says));
    let image = Rect::from_min_size(rect.min, size);
    match pictured {
        Some(pictured) => thumbnails.paint_alone(ui.painter(), image, pictured, tokens),
        None => _ = ui.painter().rect_filled(image, CORNER, tokens.raised),
    }
    let is_lit = is_enabled && (response.hovered() || response.has_focus());
    let stroke = Stroke::new(if is_lit { 2.0 } else { 1.0 }, if is_lit { tokens.accent } else { tokens.line });
    ui.painter().rect_stroke(image, CORNER, stroke, egui::StrokeKind::Inside);
    let at = pos2(image.center().x, image.bottom() + ROW / 2.0);
    let colour = if is_enabled { tokens.text } else { tokens.dim };
    let clipped = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
    clipped.text(at, Align2::CENTER_CENTER, &pose.name, small_font(), colour);
    if was_pressed(&response.on_hover_text(says)) {
        commands.push(Command::Edit(Edit::Pose(Arc::clone(pose))));
    }
}
