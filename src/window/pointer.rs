//! From buttons and movements over the scene to drags and clicks. Pixels are physical, from the 3D view's top left.

use glam::Vec2;

use crate::editor::DragKind;

/// A button of the mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// The left one.
    Left,
    /// The middle one.
    Middle,
    /// The right one.
    Right,
}

/// What a press or movement does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    /// Choose the node under the pointer.
    Pick(Vec2),
    /// The first movement of a drag, from where it was pressed: begin, then move.
    Begin(Vec2),
    /// The drag goes on.
    Move {
        /// What it does.
        kind: DragKind,
        /// Where the pointer was.
        from_px: Vec2,
        /// Where it is.
        to_px: Vec2,
    },
    /// The drag ends and counts.
    Commit,
}

/// Which buttons went down over the scene, and where the pointer is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pointer {
    left: bool,
    middle: bool,
    right: bool,
    is_dragging: bool,
    at_px: Vec2,
}

impl Pointer {
    /// Whether a button that went down over the scene is held.
    #[must_use]
    pub const fn is_held(&self) -> bool {
        self.left || self.middle || self.right
    }

    /// A button goes down over the scene. `picks`: a left click there chooses instead.
    pub fn press(&mut self, button: Button, at_px: Vec2, picks: bool) -> Option<Action> {
        self.at_px = at_px;
        if picks && button == Button::Left && !self.is_held() {
            return Some(Action::Pick(at_px));
        }
        *self.button(button) = true;
        None
    }

    /// A button goes up, anywhere.
    pub fn release(&mut self, button: Button) -> Option<Action> {
        *self.button(button) = false;
        (!self.is_held() && std::mem::take(&mut self.is_dragging)).then_some(Action::Commit)
    }

    /// The pointer moves, anywhere. `space`: the space bar is held.
    pub fn move_to(&mut self, at_px: Vec2, space: bool) -> Vec<Action> {
        let from_px = std::mem::replace(&mut self.at_px, at_px);
        let Some(kind) = self.kind(space).filter(|_| from_px != at_px) else { return Vec::new() };
        let mut actions = Vec::new();
        if !std::mem::replace(&mut self.is_dragging, true) {
            actions.push(Action::Begin(from_px));
        }
        actions.push(Action::Move { kind, from_px, to_px: at_px });
        actions
    }

    /// Releases all buttons, as when the window loses the focus.
    pub fn let_go(&mut self) -> Option<Action> {
        let was_dragging = self.is_dragging;
        *self = Self { at_px: self.at_px, ..Self::default() };
        was_dragging.then_some(Action::Commit)
    }

    /// What the drag that goes on does; `None` where there is none.
    #[must_use]
    pub const fn dragging(&self, space: bool) -> Option<DragKind> {
        if self.is_dragging { self.kind(space) } else { None }
    }

    const fn kind(&self, space: bool) -> Option<DragKind> {
        match (self.left, self.middle, self.right) {
            (_, true, _) | (true, _, true) => Some(DragKind::Dolly),
            (true, false, false) if space => Some(DragKind::Dolly),
            (true, false, false) => Some(DragKind::Rotate),
            (false, false, true) => Some(DragKind::Translate),
            (false, false, false) => None,
        }
    }

    const fn button(&mut self, button: Button) -> &mut bool {
        match button {
            Button::Left => &mut self.left,
            Button::Middle => &mut self.middle,
            Button::Right => &mut self.right,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(buttons: &[Button], space: bool, expected: DragKind) {
        let mut pointer = Pointer::default();
        let (from_px, to_px) = (Vec2::new(10.0, 20.0), Vec2::new(12.0, 20.0));
        for &button in buttons {
            assert_eq!(pointer.press(button, from_px, false), None);
        }
        let moved = Action::Move { kind: expected, from_px, to_px };
        assert_eq!(pointer.move_to(to_px, space), [Action::Begin(from_px), moved], "{buttons:?}, space {space}");
        let mut ends: Vec<_> = buttons.iter().map(|&button| pointer.release(button)).collect();
        assert_eq!(ends.pop(), Some(Some(Action::Commit)));
        assert!(ends.iter().all(Option::is_none));
        assert_eq!(pointer.move_to(from_px, space), []);
    }

    #[test]
    fn buttons_mean_kinds_of_drags() {
        check(&[Button::Left], false, DragKind::Rotate);
        check(&[Button::Right], false, DragKind::Translate);
        check(&[Button::Middle], false, DragKind::Dolly);
        check(&[Button::Left, Button::Right], false, DragKind::Dolly);
        check(&[Button::Right, Button::Left], false, DragKind::Dolly);
        check(&[Button::Left], true, DragKind::Dolly);
        check(&[Button::Right], true, DragKind::Translate);
    }

    #[test]
    fn a_click_is_no_drag() {
        let mut pointer = Pointer::default();
        assert_eq!(pointer.press(Button::Left, Vec2::ONE, false), None);
        assert_eq!(pointer.move_to(Vec2::ONE, false), []);
        assert_eq!(pointer.release(Button::Left), None);
    }

    #[test]
    fn a_picking_click_does_not_drag() {
        let mut pointer = Pointer::default();
        assert_eq!(pointer.press(Button::Left, Vec2::ONE, true), Some(Action::Pick(Vec2::ONE)));
        assert_eq!(pointer.move_to(Vec2::ZERO, false), []);
        assert_eq!(pointer.release(Button::Left), None);
    }

    #[test]
    fn losing_the_focus_ends_a_drag() {
        let mut pointer = Pointer::default();
        pointer.press(Button::Right, Vec2::ZERO, false);
        pointer.move_to(Vec2::ONE, false);
        assert_eq!(pointer.let_go(), Some(Action::Commit));
        assert_eq!(pointer.let_go(), None);
    }
}
