//! The keyboard on the timeline: Tab stops at it once, and arrows move within it.

use egui::accesskit::Action;
use egui::{EventFilter, Id, Key, Sense, Ui, Vec2, vec2};

/// Something that can have the focus.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Item {
    id: Id,
    /// Counted from the row of all, which is 0.
    row: usize,
    x: f32,
}

/// Where the focus is, and what can have it.
#[derive(Clone, Debug, Default)]
pub struct Keyboard {
    items: Vec<Item>,
    /// The one item that Tab stops at.
    stop: Option<Id>,
    /// A move to what was out of sight when the arrow was pressed.
    awaited: Option<Vec2>,
}

impl Keyboard {
    /// Begins a frame.
    pub fn begin(&mut self) {
        self.items.clear();
    }

    /// Whether the focus is on the timeline, so that arrows belong to it.
    #[must_use]
    pub fn has_focus(&self, context: &egui::Context) -> bool {
        let focused = context.memory(egui::Memory::focused);
        focused.is_some_and(|focused| self.items.iter().any(|item| item.id == focused))
    }

    /// The row whose name, its first item, has the focus.
    #[must_use]
    pub fn focused_row(&self, ui: &Ui) -> Option<usize> {
        let focused = ui.memory(egui::Memory::focused)?;
        let item = self.items.iter().find(|item| item.id == focused)?;
        let is_first = self.items.iter().all(|other| other.row != item.row || other.x >= item.x);
        is_first.then_some(item.row)
    }

    /// Takes in an item at a horizontal position, and gives its sense: `sense`, with focus if Tab stops at it.
    pub fn item(&mut self, ui: &Ui, id: Id, row: usize, x: f32, sense: Sense) -> Sense {
        self.items.push(Item { id, row, x });
        // Screen readers can put the focus on any of them; egui would only let them do so where Tab stops.
        ui.ctx().accesskit_node_builder(id, |node| node.add_action(Action::Focus));
        if ui.input(|input| input.has_accesskit_action_request(id, Action::Focus)) {
            ui.memory_mut(|memory| memory.request_focus(id));
        }
        let is_stop = self.stop == Some(id) || ui.memory(|memory| memory.has_focus(id));
        if is_stop { sense | Sense::FOCUSABLE } else { sense - Sense::FOCUSABLE }
    }

    /// Ends a frame: moves the focus where an arrow asks for it. `entry` is where Tab stops while the focus is elsewhere; `sideways` says
    /// whether Left and Right are the focused item's own. Returns the direction of what is out of sight.
    pub fn end(&mut self, ui: &Ui, entry: Option<Id>, sideways: bool) -> Option<Vec2> {
        let focused = ui.memory(egui::Memory::focused);
        let Some(&from) = self.items.iter().find(|item| Some(item.id) == focused) else {
            self.stop = entry.or_else(|| self.items.first().map(|item| item.id));
            self.awaited = None;
            return None;
        };
        self.stop = Some(from.id);
        let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(from.id, filter));
        let awaited = self.awaited.take();
        let to = pressed(ui, sideways).or(awaited)?;
        if let Some(next) = self.beside(from, to) {
            self.stop = Some(next.id);
            ui.memory_mut(|memory| memory.request_focus(next.id));
            ui.ctx().request_repaint();
            return None;
        }
        if awaited.is_some() {
            return None;
        }
        self.awaited = Some(to);
        ui.ctx().request_repaint();
        Some(to)
    }

    fn beside(&self, from: Item, to: Vec2) -> Option<Item> {
        if to.x != 0.0 {
            let ahead = |item: &&Item| item.row == from.row && (item.x - from.x) * to.x > 0.0;
            let distance = |item: &&Item| (item.x - from.x).abs();
            return self.items.iter().filter(ahead).min_by(|a, b| distance(a).total_cmp(&distance(b))).copied();
        }
        let rows = self.items.iter().map(|item| item.row);
        let row = if to.y > 0.0 {
            rows.filter(|&row| row > from.row).min()
        } else {
            rows.filter(|&row| row < from.row).max()
        };
        let distance = |item: &&Item| (item.x - from.x).abs();
        let in_row = self.items.iter().filter(|item| Some(item.row) == row);
        in_row.min_by(|a, b| distance(a).total_cmp(&distance(b))).copied()
    }
}

/// The direction of an arrow that was pressed.
fn pressed(ui: &Ui, sideways: bool) -> Option<Vec2> {
    let arrows = [
        (Key::ArrowLeft, vec2(-1.0, 0.0)),
        (Key::ArrowRight, vec2(1.0, 0.0)),
        (Key::ArrowUp, vec2(0.0, -1.0)),
        (Key::ArrowDown, vec2(0.0, 1.0)),
    ];
    let taken = arrows.into_iter().filter(|(_, to)| to.x == 0.0 || !sideways);
    ui.input(|input| taken.clone().find(|(key, _)| input.key_pressed(*key)).map(|(_, to)| to))
}
