//! The pointer over the scene: what lights up, and what buttons, movements and the wheel do there. Pixels are physical, from the window's
//! top left.
//!
//! Everything that this depends on is behind [`Desk`], so that it works without a window too.

mod buttons;
mod limbs;
mod touch;
mod turning;
mod wheel;

use egui::CursorIcon;
use glam::Vec2;
use winit::keyboard::ModifiersState;

use super::handle::HandleDrag;
use super::hotkeys::SpaceBar;
use super::motion_path::PathDrag;
use super::pointer::{Drag, Held, Pointer, Press, Target};
use crate::camera::Camera;
use crate::editor::gizmo::Handle;
use crate::editor::{CLICK_REACH, Command, DragKind, Editor};
use crate::keyframe::KeyframeIndex;
use crate::scene::Part;
use crate::words::{Message, texts};
pub use limbs::Limbs;
use touch::Fingers;

/// The 3D view in the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Its top left corner.
    pub min_px: Vec2,
    /// Its width and height.
    pub size_px: Vec2,
    /// Pixels that are as long as a point.
    pub pixels_per_point: f32,
}

impl View {
    /// What it is seen through.
    #[must_use]
    pub fn camera(&self, editor: &Editor) -> Camera {
        editor.camera(self.size_px)
    }

    /// A pixel of the window, from the view's top left.
    #[must_use]
    pub fn inside(&self, at_px: Vec2) -> Vec2 {
        at_px - self.min_px
    }
}

/// What the pointer works on.
pub trait Desk {
    /// The editor whose scene is shown.
    fn editor(&self) -> &Editor;
    /// Applies a command. Refusals are the editor's message.
    fn apply(&mut self, command: Command);
    /// The view of the scene; `None` while there is no window.
    fn view(&self) -> Option<View>;
    /// Whether what happens at a pixel of the window is the scene's: it is in the view, and nothing lies over it.
    fn is_over_scene(&self, at_px: Vec2) -> bool;
    /// Asks for another picture.
    fn request_redraw(&self);
}

/// What the pointer does, and the keys that are held with it.
#[derive(Clone, Debug, Default)]
pub struct Hands {
    /// The keys that are held.
    pub modifiers: ModifiersState,
    /// The space bar.
    pub space: SpaceBar,
    /// Where the pointer is.
    pub pointer_px: Vec2,
    /// The keyframe whose dot of the motion path the pointer is over.
    pub hovered_dot: Option<KeyframeIndex>,
    /// The handle that the pointer is over.
    pub hovered_handle: Option<Handle>,
    pointer: Pointer,
    /// The fingers on a touch screen.
    fingers: Fingers,
    /// The dot of the motion path that is held.
    path_drag: Option<PathDrag>,
    /// The balls at limbs' ends that the pointer is over or holds.
    limbs: Limbs,
    /// The drag that goes on, where it has handles.
    handle_drag: Option<HandleDrag>,
    /// The handle that the left button was pressed on, until the pointer moves.
    pressed_handle: Option<Handle>,
    /// The node that lights up under the pointer.
    hovered_part: Option<Part>,
}

impl Hands {
    /// Whether a button that went down over the scene is held.
    #[must_use]
    pub const fn is_held(&self) -> bool {
        self.pointer.is_held() || self.path_drag.is_some() || self.limbs.drag.is_some()
    }

    /// Lets go of everything that belongs to a scene which is shown no more.
    pub fn forget_scene(&mut self) {
        *self = Self {
            modifiers: self.modifiers,
            space: self.space,
            pointer_px: self.pointer_px,
            pointer: self.pointer,
            fingers: self.fingers,
            ..Self::default()
        };
    }

    /// The pointer's shape over the scene: what a drag does, or that a click chooses.
    #[must_use]
    pub fn cursor(&self, desk: &dyn Desk) -> Option<CursorIcon> {
        let editor = desk.editor();
        if self.path_drag.is_some() {
            return Some(CursorIcon::Grabbing);
        }
        if self.hovered_dot.is_some() {
            return Some(CursorIcon::Grab);
        }
        if let Some(cursor) = self.handle_cursor(editor).or_else(|| self.limb_cursor()) {
            return Some(cursor);
        }
        match self.pointer.dragging(self.space.is_held()) {
            Some(Drag::Orbit) => Some(CursorIcon::Grabbing),
            Some(Drag::Pan) => Some(CursorIcon::AllScroll),
            Some(Drag::Pose(_)) if !editor.is_dragging() => Some(CursorIcon::NotAllowed),
            Some(Drag::Pose(DragKind::Rotate)) => Some(CursorIcon::Grabbing),
            Some(Drag::Pose(DragKind::Translate)) => Some(CursorIcon::Move),
            Some(Drag::Pose(DragKind::Dolly)) => Some(CursorIcon::ResizeVertical),
            None => {
                (editor.session().is_picking && desk.is_over_scene(self.pointer_px)).then_some(CursorIcon::Crosshair)
            }
        }
    }

    /// What a click would take.
    #[must_use]
    pub fn hovered(&self, desk: &dyn Desk) -> Option<Part> {
        let editor = desk.editor();
        let is_over_handle =
            self.hovered_dot.is_some() || self.hovered_handle.is_some() || self.lit_ball(editor).is_some();
        if self.pointer.is_held() || self.path_drag.is_some() || is_over_handle || !desk.is_over_scene(self.pointer_px)
        {
            return None;
        }
        part_at(desk, self.pointer_px, CLICK_REACH)
    }

    /// The name of what lights up under the pointer: a ball, or the part that [`Self::hovered`] gives.
    #[must_use]
    pub fn name_of_lit(&self, editor: &Editor, part: Option<Part>) -> Option<Message> {
        let scene = editor.scene();
        let name = || {
            Some(texts::foreign(match part? {
                Part::Rbt(rbt) => scene.rbt_path(rbt),
                Part::Keyed(node) => scene.node(node).path.as_str(),
            }))
        };
        self.name_of_lit_ball(editor).or_else(name)
    }

    /// Whether a press passes dots and balls, which lie over parts.
    fn passes_handles(&self, editor: &Editor) -> bool {
        editor.session().is_picking || self.modifiers.control_key() || self.modifiers.alt_key()
    }

    /// What a press at a pixel meets, and what it depends on.
    fn press_at(&self, desk: &dyn Desk, at_px: Vec2) -> Press {
        let editor = desk.editor();
        let held = Held {
            ctrl: self.modifiers.control_key(),
            shift: self.modifiers.shift_key(),
            alt: self.modifiers.alt_key(),
            space: self.space.is_held(),
        };
        let is_in_arcball =
            || desk.view().is_some_and(|view| editor.is_in_arcball(&view.camera(editor), view.inside(at_px)));
        let target = match part_at(desk, at_px, CLICK_REACH) {
            _ if self.pressed_handle.is_some() => Target::Handle,
            Some(Part::Rbt(rbt)) => Target::Part(rbt),
            Some(Part::Keyed(node)) => Target::Keyed(node),
            None if is_in_arcball() => Target::Arcball,
            None => Target::Nothing,
        };
        Press { target, held, picks: editor.session().is_picking, by_work_eye: editor.is_work_eye() }
    }
}

/// What a click at a pixel takes: the nearest part, at most so many points away.
fn part_at(desk: &dyn Desk, at_px: Vec2, reach: f32) -> Option<Part> {
    let (editor, view) = (desk.editor(), desk.view()?);
    editor.taken_near(&view.camera(editor), view.inside(at_px), reach * view.pixels_per_point)
}
