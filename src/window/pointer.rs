//! From buttons and movements over the scene to drags and clicks. Pixels are physical, from the 3D view's top left.
//!
//! What a drag does is decided where it begins. With an eye of the scene, which keyframes record:
//!
//! | drag | does |
//! |---|---|
//! | left | turns the dragged node by the arcball |
//! | right | moves it in the view's plane |
//! | middle, left and right, left with space | moves it along the view |
//!
//! With the work eye:
//!
//! | drag | from | does |
//! |---|---|---|
//! | middle, Alt+left | anywhere | orbits; with Shift pans |
//! | left | nothing | orbits; with Shift pans |
//! | right | nothing | pans |
//! | left, right, both | a part | chooses it, then poses it as above |
//! | left, right, both | a handle, inside of the arcball | poses the chosen nodes as above |
//!
//! A left click chooses with every eye: [`Click`]. Parts come before the arcball, so that what lights up is what is taken.

use glam::Vec2;
use web_time::Instant;

use crate::editor::DragKind;
use crate::pose::RbtIndex;
use crate::scene::NodeId;

/// The pointer must move so far for a press to be a drag, in pixels.
const SLACK_PX: f32 = 3.0;
/// Two clicks within this time and [`DOUBLE_CLICK_PX`] are a double click.
const DOUBLE_CLICK_MS: u128 = 400;
const DOUBLE_CLICK_PX: f32 = 6.0;

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

/// What a press meets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Target {
    /// A handle of the chosen nodes. It lies over parts.
    Handle,
    /// A part of this node.
    Part(RbtIndex),
    /// The inside of the arcball.
    Arcball,
    /// A node that only keys at their own times move. Drags take it for nothing.
    Keyed(NodeId),
    /// Nothing, or the ground.
    #[default]
    Nothing,
}

/// Keys that are held with the mouse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each is a key")]
pub struct Held {
    /// Either Ctrl.
    pub ctrl: bool,
    /// Either Shift.
    pub shift: bool,
    /// Either Alt.
    pub alt: bool,
    /// The space bar.
    pub space: bool,
}

/// What a press depends on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Press {
    /// What it meets.
    pub target: Target,
    /// The keys that are held.
    pub held: Held,
    /// Whether the next left click chooses, be it the ground.
    pub picks: bool,
    /// Whether the work eye is in force.
    pub by_work_eye: bool,
}

/// What a drag moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drag {
    /// The work eye around its target.
    Orbit,
    /// The work eye in its own plane.
    Pan,
    /// The dragged nodes.
    Pose(DragKind),
}

/// What a click on the scene does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Click {
    /// Chooses a node, and no other.
    Choose(RbtIndex),
    /// Adds a node to the chosen ones, or takes it out.
    Also(RbtIndex),
    /// Goes on to what lies behind the chosen node.
    GoOn,
    /// Selects the keys of a node that no choice can move.
    SelectKeys(NodeId),
    /// Ends the choice.
    ChooseNone,
}

/// What a press or movement does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    /// Choose the node under the pointer, or none.
    Pick(Vec2),
    /// A click.
    Click(Click, Vec2),
    /// The first movement of a drag of nodes: choose a node if it is not chosen, then begin.
    Begin {
        /// The node to choose.
        chosen: Option<RbtIndex>,
        /// Where the button was pressed.
        from_px: Vec2,
    },
    /// The drag goes on.
    Move {
        /// What it moves.
        drag: Drag,
        /// Where the pointer was.
        from_px: Vec2,
        /// Where it is.
        to_px: Vec2,
    },
    /// The drag of nodes ends and counts.
    Commit,
}

/// What the buttons that are held move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Moves {
    /// The work eye.
    Eye(Drag),
    /// The dragged nodes, after this one was chosen.
    Nodes(Option<RbtIndex>),
}

/// Which buttons went down over the scene, and where the pointer is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pointer {
    left: bool,
    middle: bool,
    right: bool,
    is_dragging: bool,
    moves: Option<Moves>,
    /// What a release without a movement does.
    click: Option<(Target, Held)>,
    last_click: Option<(Instant, Vec2)>,
    at_px: Vec2,
}

impl Pointer {
    /// Whether a button that went down over the scene is held.
    #[must_use]
    pub const fn is_held(&self) -> bool {
        self.left || self.middle || self.right
    }

    /// A button goes down over the scene. Others that are held already have decided what is moved.
    pub fn press(&mut self, button: Button, at_px: Vec2, press: Press) -> Option<Action> {
        let Press { target, held, picks, by_work_eye } = press;
        if self.is_held() {
            self.click = None;
        } else {
            self.at_px = at_px;
            if picks && button == Button::Left {
                return Some(Action::Pick(at_px));
            }
            self.moves = Some(if by_work_eye { by_the_work_eye(button, target, held) } else { Moves::Nodes(None) });
            self.click = (button == Button::Left && !held.alt).then_some((target, held));
        }
        *self.button(button) = true;
        None
    }

    /// A button goes up, anywhere.
    pub fn release(&mut self, button: Button, now: Instant) -> Option<Action> {
        *self.button(button) = false;
        if self.is_held() {
            return None;
        }
        let was_dragging = std::mem::take(&mut self.is_dragging);
        let click = self.click.take();
        match self.moves.take()? {
            Moves::Nodes(_) if was_dragging => Some(Action::Commit),
            Moves::Eye(_) if was_dragging => None,
            _ => self.clicked(click?, now),
        }
    }

    fn clicked(&mut self, (target, held): (Target, Held), now: Instant) -> Option<Action> {
        let is_double = self.last_click.replace((now, self.at_px)).is_some_and(|(at, at_px)| {
            now.duration_since(at).as_millis() < DOUBLE_CLICK_MS && at_px.distance(self.at_px) < DOUBLE_CLICK_PX
        });
        let click = match target {
            Target::Part(rbt) if held.shift => Click::Also(rbt),
            Target::Part(_) if held.ctrl => Click::GoOn,
            Target::Part(rbt) => Click::Choose(rbt),
            Target::Keyed(node) => Click::SelectKeys(node),
            Target::Arcball | Target::Nothing if is_double => Click::ChooseNone,
            Target::Handle | Target::Arcball | Target::Nothing => return None,
        };
        Some(Action::Click(click, self.at_px))
    }

    /// The pointer moves, anywhere.
    pub fn move_to(&mut self, at_px: Vec2, space: bool) -> Vec<Action> {
        let Some(drag) = self.drag(space) else {
            self.at_px = at_px;
            return Vec::new();
        };
        if !self.is_dragging && self.at_px.distance(at_px) < SLACK_PX {
            return Vec::new();
        }
        let from_px = std::mem::replace(&mut self.at_px, at_px);
        let begins = !std::mem::replace(&mut self.is_dragging, true);
        let mut actions = Vec::new();
        if let (true, Some(Moves::Nodes(chosen))) = (begins, self.moves) {
            actions.push(Action::Begin { chosen, from_px });
        }
        if from_px != at_px {
            actions.push(Action::Move { drag, from_px, to_px: at_px });
        }
        actions
    }

    /// Releases all buttons, as when the window loses the focus.
    pub fn let_go(&mut self) -> Option<Action> {
        let commits = self.is_dragging && matches!(self.moves, Some(Moves::Nodes(_)));
        *self = Self { at_px: self.at_px, ..Self::default() };
        commits.then_some(Action::Commit)
    }

    /// What the drag that goes on moves; `None` where there is none.
    #[must_use]
    pub const fn dragging(&self, space: bool) -> Option<Drag> {
        if self.is_dragging { self.drag(space) } else { None }
    }

    const fn drag(&self, space: bool) -> Option<Drag> {
        match (self.moves, self.kind(space)) {
            (Some(Moves::Eye(drag)), Some(_)) => Some(drag),
            (Some(Moves::Nodes(_)), Some(kind)) => Some(Drag::Pose(kind)),
            _ => None,
        }
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

/// The second table at the top.
const fn by_the_work_eye(button: Button, target: Target, held: Held) -> Moves {
    let around = if held.shift { Drag::Pan } else { Drag::Orbit };
    match (button, target) {
        (Button::Middle, _) => Moves::Eye(around),
        (Button::Left, _) if held.alt => Moves::Eye(around),
        (Button::Left, Target::Nothing | Target::Keyed(_)) => Moves::Eye(around),
        (Button::Right, Target::Nothing | Target::Keyed(_)) => Moves::Eye(Drag::Pan),
        (Button::Left | Button::Right, Target::Part(rbt)) => Moves::Nodes(Some(rbt)),
        (Button::Left | Button::Right, Target::Handle | Target::Arcball) => Moves::Nodes(None),
    }
}

#[cfg(test)]
mod tests;
