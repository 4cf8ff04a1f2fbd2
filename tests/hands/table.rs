//! A table to work at: an editor, a view of its scene, and the hands over it.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use glam::Vec2;
use inbetween::editor::keymap::{binding_for, press_from_word};
use inbetween::editor::{CLICK_REACH, Command, Edit, Editor, Eye, ViewCommand};
use inbetween::pose::RbtIndex;
use inbetween::rbt::Rbt;
use inbetween::scene::{DEFAULT_SCENE, Part, built_in_scene};
use inbetween::script::script_commands;
use inbetween::window::hands::{Desk, Hands, View};
use inbetween::window::limb_drag;
use inbetween::words::Phrase;
use winit::event::{ElementState, MouseButton, MouseScrollDelta, TouchPhase};
use winit::keyboard::ModifiersState;

pub use winit::event::MouseButton::{Left, Middle, Right};

pub const SHOULDER: &str = "robot1/right_shoulder";
pub const KNEE: &str = "robot1/left_hip/left_knee";
pub const HEAD: &str = "robot2/head";

/// The view lies in the middle of a window with panels around it, on a screen with two pixels a point.
pub const VIEW: View = View { min_px: Vec2::new(60.0, 40.0), size_px: Vec2::new(1400.0, 900.0), pixels_per_point: 2.0 };

/// An editor, and what the pointer does.
pub struct Table {
    pub editor: Editor,
    pub hands: Hands,
}

/// What the hands see of a table.
struct Top<'a>(&'a mut Editor);

impl Desk for Top<'_> {
    fn editor(&self) -> &Editor {
        self.0
    }

    fn apply(&mut self, command: Command) {
        // A refusal is the editor's message.
        let _ = self.0.apply(command);
    }

    fn view(&self) -> Option<View> {
        Some(VIEW)
    }

    fn is_over_scene(&self, at_px: Vec2) -> bool {
        let inside = VIEW.inside(at_px);
        inside.cmpge(Vec2::ZERO).all() && inside.cmplt(VIEW.size_px).all()
    }

    fn request_redraw(&self) {}
}

impl Table {
    /// The built-in scene as the window begins with it: seen from the work eye.
    pub fn new() -> Self {
        Self::of(DEFAULT_SCENE)
    }

    pub fn of(scene: &str) -> Self {
        let mut table = Self::seen_as_by_a_script(scene);
        table.editor.apply(Command::View(ViewCommand::SetEye(Eye::Work))).unwrap();
        table
    }

    pub fn as_a_script_begins() -> Self {
        Self::seen_as_by_a_script(DEFAULT_SCENE)
    }

    fn seen_as_by_a_script(scene: &str) -> Self {
        let scene = built_in_scene(scene).expect("it is built in");
        let editor = Editor::new(Arc::new(scene), PathBuf::from("animation.json"));
        Self { editor, hands: Hands::default() }
    }

    /// After script lines.
    pub fn after(lines: &str) -> Self {
        let mut table = Self::new();
        table.run(lines);
        table
    }

    /// Runs script lines; refusals are messages.
    pub fn run(&mut self, lines: &str) {
        for command in script_commands(lines.as_bytes(), self.editor.scene()).expect("they can be read") {
            let _ = self.editor.apply(command);
        }
    }

    /// Presses hotkeys, as a script writes them: `ctrl+r x 4 5 enter`.
    pub fn press(&mut self, keys: &str) {
        for word in keys.split_whitespace() {
            let press = press_from_word(word).unwrap_or_else(|| panic!("{word} is no key"));
            let mut top = Top(&mut self.editor);
            if self.hands.key_in_drag(&mut top, press, false) {
                continue;
            }
            let bindings = inbetween::editor::keymap::bindings();
            let Some(command) = binding_for(&bindings, press).map(|binding| binding.command.clone()) else { continue };
            top.apply(command.clone());
            self.hands.began_by_keyboard(&top, &command);
        }
    }

    /// Holds keys with the mouse from now on.
    pub fn hold(&mut self, keys: ModifiersState) {
        self.hands.modifiers = keys;
    }

    pub fn hold_space(&mut self, is_held: bool) {
        if is_held { self.hands.space.press(false) } else { _ = self.hands.space.release() }
    }

    pub fn move_to(&mut self, at_px: Vec2) {
        self.hands.moved(&mut Top(&mut self.editor), at_px);
    }

    pub fn down(&mut self, button: MouseButton) {
        self.hands.button(&mut Top(&mut self.editor), ElementState::Pressed, button);
    }

    pub fn up(&mut self, button: MouseButton) {
        self.hands.button(&mut Top(&mut self.editor), ElementState::Released, button);
    }

    pub fn lose_focus(&mut self) {
        self.hands.let_go(&mut Top(&mut self.editor));
    }

    /// A finger comes down, moves or goes up at a pixel, at a time.
    pub fn touch(&mut self, phase: TouchPhase, id: u64, at_px: Vec2, at: Instant) {
        self.hands.touch(&mut Top(&mut self.editor), phase, id, at_px, at);
    }

    /// Turns the wheel by notches.
    pub fn wheel(&mut self, notches: f32) {
        self.hands.wheel(&mut Top(&mut self.editor), MouseScrollDelta::LineDelta(0.0, notches));
    }

    /// The left button goes down and up at a pixel.
    pub fn click(&mut self, at_px: Vec2) {
        self.move_to(at_px);
        self.down(Left);
        self.up(Left);
    }

    /// A button goes down at a pixel, and the pointer goes in small steps to another one.
    pub fn begin_drag(&mut self, button: MouseButton, from_px: Vec2, by_px: Vec2) {
        self.move_to(from_px);
        self.down(button);
        for step in 1..=10_u8 {
            self.move_to(from_px + by_px * f32::from(step) / 10.0);
        }
    }

    pub fn drag(&mut self, button: MouseButton, from_px: Vec2, by_px: Vec2) {
        self.begin_drag(button, from_px, by_px);
        self.up(button);
    }

    pub fn node(&self, path: &str) -> RbtIndex {
        self.editor.scene().find_rbt(path).unwrap_or_else(|| panic!("{path}"))
    }

    pub fn live(&self, path: &str) -> Rbt {
        self.editor.document().live_pose.get(self.node(path))
    }

    pub fn in_world(&self, path: &str) -> Rbt {
        self.editor.scene().world_from_rbt(&self.editor.document().live_pose, 0.0, self.node(path))
    }

    /// The paths of the chosen nodes.
    pub fn chosen(&self) -> Vec<&str> {
        self.editor.session().chosen.iter().map(|&rbt| self.editor.scene().rbt_path(rbt)).collect()
    }

    /// The paths of the nodes whose places differ from those at rest.
    pub fn changed(&self) -> Vec<&str> {
        let scene = self.editor.scene();
        let differs = |&rbt: &RbtIndex| self.live(scene.rbt_path(rbt)) != scene.rest_pose().get(rbt);
        scene.rbt_indices().filter(differs).map(|rbt| scene.rbt_path(rbt)).collect()
    }

    pub fn undo_label(&self) -> Option<&str> {
        self.editor.undo_label().map(Phrase::english)
    }

    /// The node and the name that light up under the pointer.
    pub fn lit(&mut self) -> (Option<Part>, String) {
        let top = Top(&mut self.editor);
        let part = self.hands.hovered(&top);
        let name = self.hands.name_of_lit(top.0, part);
        (part, name.map(|name| name.to_string()).unwrap_or_default())
    }

    /// The part that a ray through a pixel of the window meets, and nothing beside it.
    pub fn direct(&self, at_px: Vec2) -> Option<RbtIndex> {
        self.editor.part_near(&VIEW.camera(&self.editor), VIEW.inside(at_px), 0.0)
    }

    /// A pixel of the window where a part of a node is seen, with nothing else of that kind around it.
    pub fn on(&self, path: &str) -> Vec2 {
        let (node, camera) = (self.node(path), VIEW.camera(&self.editor));
        let origin = VIEW.min_px + camera.project(self.in_world(path).translation).expect("it is before the eye").0;
        let is_clear = |at_px: Vec2| {
            let around = [Vec2::ZERO, Vec2::X, Vec2::Y, -Vec2::X, -Vec2::Y];
            let has_ball = self.editor.limb_ball_at(&camera, VIEW.inside(at_px), 2.0 * limb_drag::REACH).is_some();
            !has_ball && around.iter().all(|by| self.direct(at_px + *by * 4.0) == Some(node))
        };
        let places = (0..20_u8).flat_map(|ring| {
            (0..16_u8).map(move |ray| {
                Vec2::from_angle(std::f32::consts::TAU * f32::from(ray) / 16.0) * (f32::from(ring) * 8.0)
            })
        });
        places.map(|by| origin + by).find(|&at_px| is_clear(at_px)).unwrap_or_else(|| panic!("{path} is not seen"))
    }

    /// The edge of the part that is seen at a pixel, in a direction: the last pixel that meets it.
    pub fn edge(&self, from_px: Vec2, direction: Vec2) -> Vec2 {
        let part = self.direct(from_px);
        let steps = (0..900_u16).map(|step| from_px + direction * f32::from(step));
        steps.take_while(|&at_px| self.direct(at_px) == part).last().unwrap_or(from_px)
    }

    /// A pixel where nothing is seen, not even the ground.
    pub fn on_nothing(&self) -> Vec2 {
        let inside_px = Vec2::splat(30.0);
        let ray = VIEW.camera(&self.editor).ray_through(inside_px);
        let picker = self.editor.scene().picker(&self.editor.displayed_pose(), 0.0, self.editor.eye());
        assert!(picker.nearest(ray).is_none(), "the sky is not seen");
        VIEW.min_px + inside_px
    }

    /// A pixel where the ground is seen, far from parts.
    pub fn on_ground(&self) -> Vec2 {
        let (camera, reach_px) = (VIEW.camera(&self.editor), 3.0 * CLICK_REACH * VIEW.pixels_per_point);
        let rows = (1..90_u8).map(|row| VIEW.size_px - Vec2::new(60.0, f32::from(row) * 10.0));
        let is_ground = |inside_px: &Vec2| {
            let picker = self.editor.scene().picker(&self.editor.displayed_pose(), 0.0, self.editor.eye());
            let is_hit = picker.nearest(camera.ray_through(*inside_px)).is_some_and(|hit| hit.rbt.is_none());
            is_hit && self.editor.part_near(&camera, *inside_px, reach_px).is_none()
        };
        VIEW.min_px + rows.into_iter().find(is_ground).expect("the ground is seen")
    }

    /// A place in the world, as it is seen in the window.
    pub fn seen_px(&self, in_world: glam::Vec3) -> Vec2 {
        VIEW.min_px + VIEW.camera(&self.editor).project(in_world).expect("it is before the eye").0
    }

    /// How far before the eye a node is.
    pub fn depth(&self, path: &str) -> f32 {
        VIEW.camera(&self.editor).project(self.in_world(path).translation).expect("it is before the eye").1
    }

    pub fn camera(&self) -> inbetween::camera::Camera {
        VIEW.camera(&self.editor)
    }

    pub fn said(&self) -> String {
        self.editor.message_text()
    }

    /// Makes four keyframes and plays them.
    pub fn play(&mut self) {
        for _ in 0..4 {
            self.editor.apply(Command::Edit(Edit::CreateKeyframe)).unwrap();
        }
        self.run("key y");
        assert!(self.editor.is_playing());
    }
}
