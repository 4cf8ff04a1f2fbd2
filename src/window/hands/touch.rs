//! Fingers on a touch screen over the scene: one does what the left button does, two pan and zoom.

use std::time::Duration;

use glam::Vec2;
use web_time::Instant;
use winit::event::{ElementState, MouseButton, TouchPhase};

use super::{Desk, Hands};
use crate::editor::{Command, GestureCommand, ViewCommand};

/// A finger must move so far for a touch to be a drag, in points: it is broader than a pointer.
const SLACK: f32 = 6.0;
/// What the first finger did within this time before the second came down is taken back: both were meant together.
const MOMENT: Duration = Duration::from_millis(400);
/// Fingers are never nearer to each other than this, in pixels.
const LEAST_APART_PX: f32 = 1.0;
/// Where the pointer is while no finger is down: over nothing.
const NOWHERE: Vec2 = Vec2::splat(-1.0);

/// A finger, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Finger {
    id: u64,
    at_px: Vec2,
}

/// The first finger, since it came down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct First {
    finger: Finger,
    from_px: Vec2,
    since: Instant,
    has_moved: bool,
}

/// The fingers that came down over the scene. A third one does nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Fingers {
    /// None is down.
    #[default]
    None,
    /// One is down, and does what the left button does.
    One(First),
    /// Two are down, and move the work eye.
    Two([Finger; 2]),
    /// One of two is up. The other does nothing alone, so that nothing is posed by lifting both.
    Other(Finger),
}

impl Hands {
    /// A finger comes down, moves, or goes up at a pixel of the window, at a time. A drag that the system cancels is taken back.
    pub fn touch(&mut self, desk: &mut dyn Desk, phase: TouchPhase, id: u64, at_px: Vec2, at: Instant) {
        let finger = Finger { id, at_px };
        self.fingers = match (phase, self.fingers) {
            (TouchPhase::Started, fingers) if !desk.is_over_scene(at_px) => fingers,
            (TouchPhase::Started, Fingers::None) => self.first_down(desk, finger, at),
            (TouchPhase::Started, Fingers::One(first)) => {
                self.end_first(desk, at.duration_since(first.since) < MOMENT);
                Fingers::Two([first.finger, finger])
            }
            (TouchPhase::Started, Fingers::Other(other)) => Fingers::Two([other, finger]),
            (TouchPhase::Moved, Fingers::One(first)) if first.finger.id == id => self.first_moved(desk, first, finger),
            (TouchPhase::Moved, Fingers::Two(before)) => {
                let after = before.map(|one| if one.id == id { finger } else { one });
                move_eye(desk, before, after);
                Fingers::Two(after)
            }
            (TouchPhase::Moved, Fingers::Other(other)) if other.id == id => Fingers::Other(finger),
            (TouchPhase::Ended, Fingers::One(first)) if first.finger.id == id => {
                self.button(desk, ElementState::Released, MouseButton::Left);
                self.moved(desk, NOWHERE);
                Fingers::None
            }
            (TouchPhase::Cancelled, Fingers::One(first)) if first.finger.id == id => {
                self.end_first(desk, true);
                Fingers::None
            }
            (TouchPhase::Ended | TouchPhase::Cancelled, Fingers::Two([one, other])) if one.id == id => {
                Fingers::Other(other)
            }
            (TouchPhase::Ended | TouchPhase::Cancelled, Fingers::Two([one, other])) if other.id == id => {
                Fingers::Other(one)
            }
            (TouchPhase::Ended | TouchPhase::Cancelled, Fingers::Other(other)) if other.id == id => Fingers::None,
            (_, fingers) => fingers,
        };
        desk.request_redraw();
    }

    /// Whether two fingers are down over the scene.
    #[must_use]
    pub const fn has_two_fingers(&self) -> bool {
        matches!(self.fingers, Fingers::Two(_))
    }

    fn first_down(&mut self, desk: &mut dyn Desk, finger: Finger, at: Instant) -> Fingers {
        if self.is_held_by_keyboard(desk.editor()) {
            // It is not where the pointer was: what is held stays where it is.
            desk.apply(Command::Gesture(GestureCommand::Commit));
            return Fingers::Other(finger);
        }
        self.moved(desk, finger.at_px);
        self.button(desk, ElementState::Pressed, MouseButton::Left);
        Fingers::One(First { finger, from_px: finger.at_px, since: at, has_moved: false })
    }

    fn first_moved(&mut self, desk: &mut dyn Desk, first: First, finger: Finger) -> Fingers {
        let slack_px = SLACK * desk.view().map_or(1.0, |view| view.pixels_per_point);
        let has_moved = first.has_moved || first.from_px.distance(finger.at_px) >= slack_px;
        if has_moved {
            self.moved(desk, finger.at_px);
        }
        Fingers::One(First { finger, has_moved, ..first })
    }

    /// Ends what the first finger does: it counts, or is taken back. A click it is in no case.
    fn end_first(&mut self, desk: &mut dyn Desk, is_taken_back: bool) {
        if is_taken_back && desk.editor().is_dragging() {
            desk.apply(Command::Cancel);
        }
        self.pressed_handle = None;
        self.let_go_of_drags(desk);
        self.moved(desk, NOWHERE);
    }
}

/// Two fingers moved: the work eye pans with their middle, and zooms as they move apart. An eye of the scene stays, since keyframes record it.
fn move_eye(desk: &mut dyn Desk, before: [Finger; 2], after: [Finger; 2]) {
    let Some(view) = desk.view().filter(|_| desk.editor().is_work_eye()) else { return };
    let middle_px = |[one, other]: [Finger; 2]| view.inside(one.at_px.midpoint(other.at_px));
    let apart_px = |[one, other]: [Finger; 2]| one.at_px.distance(other.at_px).max(LEAST_APART_PX);
    let camera = view.camera(desk.editor());
    let eye = desk.editor().session().work_eye.panned(middle_px(after) - middle_px(before), &camera);
    let eye = eye.zoomed_by(apart_px(after) / apart_px(before), middle_px(after), &camera);
    desk.apply(Command::View(ViewCommand::SetWorkEye(eye)));
}
