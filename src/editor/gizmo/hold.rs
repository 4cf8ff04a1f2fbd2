//! What is held in a drag, and the keys that belong to it: axes, digits, Enter.

use super::{Axis, GizmoAxes, Handle, HandleKind, Pull};
use crate::editor::apply::CommandResult;
use crate::editor::gesture::Gesture;
use crate::editor::keymap::{Key, KeyPress};
use crate::editor::{Command, CommandError, Editor, GestureCommand};
use crate::words::texts;

/// The most characters of a typed number.
const LONGEST_NUMBER: usize = 12;

/// A handle that is held, by the pointer or by the keyboard.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::editor) struct Hold {
    pub(super) handle: Handle,
    /// How far the pointer has pulled it.
    pulled: Pull,
    /// The number that is being typed, which counts instead of the pointer; empty where none is.
    pub(super) typed: String,
}

impl Hold {
    fn new(handle: Handle) -> Self {
        Self { handle, pulled: handle.pulled([0.0; 2]), typed: String::new() }
    }

    /// The pull that counts.
    pub(super) fn pull(&self) -> Pull {
        if self.typed.is_empty() {
            return self.pulled;
        }
        // A sign or a point alone is no number yet.
        self.handle.pulled([self.typed.parse().unwrap_or_default(), 0.0])
    }

    fn type_character(&mut self, character: char) {
        match character {
            '-' => match self.typed.strip_prefix('-') {
                Some(rest) => self.typed = rest.to_owned(),
                None => self.typed.insert(0, '-'),
            },
            '.' if self.typed.contains('.') => {}
            _ if self.typed.len() >= LONGEST_NUMBER => {}
            _ => self.typed.push(character),
        }
    }

    /// Holds the handle of an axis instead: of the axes that handles go by, and if that one is held already, of the world's or the node's.
    fn lock(&mut self, axis: Axis, axes: GizmoAxes) {
        let kind = if self.handle.kind == HandleKind::Turn { HandleKind::Turn } else { HandleKind::Move };
        let is_again = self.handle.axis == axis && self.handle.kind == kind && self.handle != Handle::TURN_IN_VIEW;
        let axes = match self.handle.axes {
            GizmoAxes::World if is_again => GizmoAxes::Local,
            _ if is_again => GizmoAxes::World,
            _ => axes,
        };
        self.handle = Handle { kind, axis, axes };
        self.pulled = self.handle.pulled([0.0; 2]);
    }
}

/// What a key does while a drag is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DragKey {
    /// Turns about, or moves along, this axis alone.
    Lock(Axis),
    /// Types a digit, the point or the sign of a number.
    Type(char),
    /// Takes back what was typed last.
    Erase,
    /// Ends the drag, which counts.
    End,
}

impl DragKey {
    /// What a press does; `None` where it does nothing.
    #[must_use]
    pub fn of(press: KeyPress) -> Option<Self> {
        let of = |key| match key {
            Key::Character('x') => Some(Self::Lock(Axis::X)),
            Key::Character('y') => Some(Self::Lock(Axis::Y)),
            Key::Character('z') => Some(Self::Lock(Axis::Z)),
            Key::Character(digit @ '0'..='9') => Some(Self::Type(digit)),
            Key::Character('.' | ',') => Some(Self::Type('.')),
            Key::Character('-') => Some(Self::Type('-')),
            Key::Backspace => Some(Self::Erase),
            Key::Enter => Some(Self::End),
            _ => None,
        };
        if press.modifiers.ctrl || press.modifiers.alt {
            return None;
        }
        [press.typed, press.on_us_layout].into_iter().flatten().find_map(of)
    }

    /// The command for it.
    #[must_use]
    pub const fn command(self) -> Command {
        Command::Gesture(match self {
            Self::Lock(axis) => GestureCommand::Lock(axis),
            Self::Type(character) => GestureCommand::Type(character),
            Self::Erase => GestureCommand::Erase,
            Self::End => GestureCommand::Commit,
        })
    }
}

impl Editor {
    /// The handle that is held; `None` where none is, as in a drag of the arcball before an axis is locked.
    #[must_use]
    pub fn held(&self) -> Option<Handle> {
        Some(self.gesture.as_ref()?.hold.as_ref()?.handle)
    }

    pub(in crate::editor) fn grab(&mut self, handle: Handle) -> CommandResult {
        if self.session.chosen.is_empty() {
            return Err(self.nothing_chosen());
        }
        self.begin_gesture();
        if let Some(gesture) = &mut self.gesture {
            gesture.hold = Some(Hold::new(handle));
        }
        Ok(Some(if handle.kind == HandleKind::Turn { texts::DRAG_TURNS } else { texts::DRAG_MOVES }.into()))
    }

    /// The pointer has pulled so far since the drag began.
    pub(in crate::editor) fn pull(&mut self, pull: Pull) -> CommandResult {
        let gesture = self.gesture.as_mut().ok_or(CommandError::NoDrag)?;
        if let Some(hold) = &mut gesture.hold {
            hold.pulled = pull;
            if !hold.typed.is_empty() {
                return Ok(None);
            }
        }
        let from = gesture.start.clone();
        self.pull_from(&from, pull)
    }

    pub(in crate::editor) fn lock(&mut self, axis: Axis) -> CommandResult {
        let axes = self.session.gizmo_axes;
        self.change_hold(|hold| hold.lock(axis, axes))
    }

    pub(in crate::editor) fn type_in_drag(&mut self, character: char) -> CommandResult {
        self.change_hold(|hold| hold.type_character(character))
    }

    pub(in crate::editor) fn erase_in_drag(&mut self) -> CommandResult {
        self.change_hold(|hold| {
            hold.typed.pop();
        })
    }

    /// Changes what is held. If that leads too far, what was held stays.
    fn change_hold(&mut self, change: impl FnOnce(&mut Hold)) -> CommandResult {
        if self.session.chosen.is_empty() {
            return Err(self.nothing_chosen());
        }
        let Some(Gesture { start: from, label, hold, .. }) = self.gesture.as_ref() else {
            return Err(CommandError::NoDrag);
        };
        let mut changed = hold.clone().unwrap_or_else(|| {
            // A drag of the arcball or in the view's plane goes on as a turn or a move.
            let moves = [texts::ACT_MOVE_A_NODE, texts::ACT_MOVE_NODES].contains(label);
            Hold::new(if moves { Handle::MOVE_IN_VIEW } else { Handle::TURN_IN_VIEW })
        });
        change(&mut changed);
        let (from, pull) = (from.clone(), changed.pull());
        let said = self.pull_from(&from, pull)?;
        if let Some(gesture) = &mut self.gesture {
            gesture.hold = Some(changed);
        }
        Ok(said)
    }
}
