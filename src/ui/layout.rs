//! How the window is divided: menu bar and status line over its whole width, the right panel between them, transport and timeline under
//! the scene. In a narrow window the right panel lies over the scene, while it is asked for. Three edges can be dragged. What the user
//! wants is kept as it is; what is shown keeps room for everything else.

use egui::accesskit::Action;
use egui::{
    Area, CentralPanel, CursorIcon, Frame, Id, Margin, Order, Panel, Pos2, Rect, Role, ScrollArea, Sense, Stroke, Ui,
    UiBuilder, Vec2, WidgetInfo, pos2,
};

use super::theme::{self, ROW, Tokens};
use super::words::Words;
use super::{PanelInput, Panels, inspector, menu, status, transport};
use crate::editor::commands::WindowState;
use crate::editor::{Command, Editor};
use crate::words::{Phrase, texts};

/// The least that is left of the scene, in points, where the window has that much.
const SCENE: [f32; 2] = [240.0, 96.0];
/// The least height of a half of the right panel, in points: its heading and four rows.
const HALF: f32 = 5.0 * ROW;
/// In a narrower window, in points, the right panel lies over the scene, and only while it is asked for.
const NARROW: f32 = 560.0;
/// What is left of the scene beside the panel that lies over it, in points.
const BESIDE: f32 = 64.0;
/// How far from an edge a press takes it, in points.
const GRAB: f32 = 3.0;

/// An edge that can be dragged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Edge {
    /// Above transport and timeline.
    Timeline,
    /// Left of the right panel.
    Side,
    /// Between tree and inspector.
    Inspector,
}

impl Edge {
    const ALL: [Self; 3] = [Self::Timeline, Self::Side, Self::Inspector];

    /// The name in the settings of the panel whose size it sets.
    const fn panel(self) -> &'static str {
        match self {
            Self::Timeline => "timeline",
            Self::Side => "side",
            Self::Inspector => "inspector",
        }
    }

    /// What screen readers call it.
    const fn name(self) -> Phrase {
        match self {
            Self::Timeline => texts::EDGE_OF_THE_TIMELINE,
            Self::Side => texts::EDGE_OF_THE_RIGHT_PANEL,
            Self::Inspector => texts::EDGE_OF_THE_INSPECTOR,
        }
    }

    fn id(self) -> Id {
        Id::unique(("edge", self.panel()))
    }

    /// The size in points at which the edge is under the pointer. Every panel lies right of or below its edge, and ends at `end`.
    fn size_at(self, pointer: Pos2, end: Pos2) -> f32 {
        match self {
            Self::Timeline => end.y - pointer.y - theme::TRANSPORT,
            Self::Side => end.x - pointer.x,
            Self::Inspector => end.y - pointer.y,
        }
    }
}

/// What the rooms between the edges depend on beside the settings.
#[derive(Clone, Copy, Debug, Default)]
pub struct Rooms {
    /// The height of all that the inspector shows, in points.
    inspector: f32,
    /// Whether the right panel is asked for in a narrow window.
    is_side_asked_for: bool,
}

/// The height of the timeline without the transport: the wanted one as far as there is room in `height`, all in points.
fn timeline_height(wanted: f32, height: f32) -> f32 {
    let room = height - theme::TRANSPORT;
    wanted.min(room - SCENE[1]).max(96.0_f32.min(room / 2.0)).max(0.0)
}

/// The width of the right panel: the wanted one as far as there is room in `width`, all in points.
fn side_width(wanted: f32, width: f32) -> f32 {
    wanted.clamp(200.0, 480.0).min((width - SCENE[0]).max(width / 2.0))
}

/// The height of the inspector: the wanted one as far as both halves keep some rows of `height`, all in points.
fn inspector_height(wanted: f32, height: f32) -> f32 {
    if height < 2.0 * HALF { height / 2.0 } else { wanted.clamp(HALF, height - HALF) }
}

impl Panels {
    /// Shows all panels around the scene.
    pub(super) fn show_panels(&mut self, ui: &mut Ui, editor: &Editor, commands: &mut Vec<Command>) {
        let tokens = Tokens::of(ui);
        let plain = |fill, x, y| Frame::new().fill(fill).inner_margin(Margin::symmetric(x, y));
        let is_exporting = self.exporting.is_some();
        let shown = PanelInput {
            editor,
            keymap: &self.keymap,
            settings: &self.settings,
            is_exporting,
            facts: &self.facts,
            view: Vec2::ZERO,
        };
        let state = WindowState {
            messages: self.log.is_shown(),
            poses: self.poses.is_shown(),
            statistics: self.statistics.is_some(),
            journal: self.settings.journal,
            reload: self.settings.reload,
            tour: self.tour.is_shown(),
            recorded_eye: self.settings.recorded_eye,
            reduce_motion: self.settings.reduce_motion,
            inset_while_playing: self.settings.inset_while_playing,
            refine_at_rest: self.settings.refine_at_rest,
        };
        Panel::top("menu bar").exact_size(theme::MENU_BAR).frame(plain(tokens.panel, 4, 1)).show(ui, |ui| {
            menu::show(ui, shown, state, commands);
        });
        Panel::bottom("status").exact_size(theme::STATUS).frame(plain(tokens.panel, 8, 2)).show(ui, |ui| {
            status::show(ui, editor, self.statistics.as_ref());
        });
        let all = ui.available_rect_before_wrap();
        let is_narrow = all.width() < NARROW;
        self.drag_edges(ui, all);
        let side = if is_narrow { 0.0 } else { self.shown_size(Edge::Side, all) };
        if !is_narrow {
            Panel::right("side").exact_size(side).resizable(false).frame(plain(tokens.panel, 0, 0)).show(ui, |ui| {
                self.show_side(ui, editor, commands);
            });
        }
        let height = self.shown_size(Edge::Timeline, all);
        Panel::bottom("timeline").exact_size(height).resizable(false).frame(Frame::new()).show(ui, |ui| {
            self.timeline.show(ui, editor, self.keymap.bindings(), &mut self.thumbnails, commands);
        });
        Panel::bottom("transport")
            .show_separator_line(false)
            .exact_size(theme::TRANSPORT)
            .resizable(false)
            .frame(plain(tokens.panel, 8, 4))
            .show(ui, |ui| {
                let asked_for = is_narrow.then_some(&mut self.rooms.is_side_asked_for);
                transport::show(ui, editor, self.keymap.bindings(), asked_for, commands);
            });
        if is_narrow && self.rooms.is_side_asked_for {
            let bottom = all.bottom() - height - theme::TRANSPORT;
            let width = theme::SIDE.min(all.width() - BESIDE);
            let place = Rect::from_min_max(pos2(all.right() - width, all.top()), pos2(all.right(), bottom));
            self.show_side_over_scene(ui, place, editor, commands);
        }
        let left = all.right() - side;
        let at = |edge: Edge| match edge {
            Edge::Timeline => {
                let y = all.bottom() - height - theme::TRANSPORT;
                Rect::from_min_max(pos2(all.left(), y), pos2(left, y))
            }
            Edge::Side => Rect::from_min_max(pos2(left, all.top()), pos2(left, all.bottom())),
            Edge::Inspector => {
                let y = all.bottom() - self.shown_size(Edge::Inspector, all);
                Rect::from_min_max(pos2(left, y), pos2(all.right(), y))
            }
        };
        for edge in Edge::ALL {
            if edge == Edge::Timeline || !is_narrow {
                show_edge(ui, edge, at(edge));
            }
        }
    }

    /// Shows the right panel in a place over the scene.
    fn show_side_over_scene(&mut self, ui: &Ui, place: Rect, editor: &Editor, commands: &mut Vec<Command>) {
        let tokens = Tokens::of(ui);
        let area = Area::new(Id::unique("side over scene")).order(Order::Middle).fixed_pos(place.min).fade_in(false);
        area.show(ui.ctx(), |ui| {
            ui.allocate_rect(place, Sense::CLICK | Sense::DRAG);
            ui.painter().rect_filled(place, 0.0, tokens.panel);
            ui.painter().vline(place.left(), place.y_range(), Stroke::new(1.0, tokens.line));
            ui.scope_builder(UiBuilder::new().max_rect(place), |ui| {
                ui.shrink_clip_rect(place);
                self.show_side(ui, editor, commands);
            });
        });
    }

    fn show_side(&mut self, ui: &mut Ui, editor: &Editor, commands: &mut Vec<Command>) {
        ui.spacing_mut().scroll = egui::style::ScrollStyle::thin();
        let height = self.shown_size(Edge::Inspector, ui.available_rect_before_wrap());
        let frame = Frame::new().inner_margin(Margin::symmetric(0, 4));
        Panel::bottom("inspector").exact_size(height).resizable(false).frame(frame).show(ui, |ui| {
            let scrolled = ScrollArea::vertical().id_salt("inspector").auto_shrink(false).show(ui, |ui| {
                Frame::new().inner_margin(Margin::symmetric(12, 8)).show(ui, |ui| {
                    inspector::show(ui, editor, &mut self.angles, &self.keymap, commands);
                });
            });
            let wanted = (scrolled.content_size.y + 9.0).round();
            if (wanted - self.rooms.inspector).abs() >= 1.0 {
                self.rooms.inspector = wanted;
                ui.ctx().request_discard("the inspector's contents have another height");
            }
        });
        CentralPanel::no_frame().show(ui, |ui| {
            ScrollArea::vertical().id_salt("tree").auto_shrink(false).show(ui, |ui| {
                Frame::new().inner_margin(Margin { left: 4, right: 4, top: 8, bottom: 8 }).show(ui, |ui| {
                    self.tree.show(ui, editor, &self.keymap, commands);
                });
            });
        });
    }

    /// The size in points in which a panel is shown, of `all` between menu bar and status line: the one that the user wants, or the usual
    /// one, as far as there is room.
    fn shown_size(&self, edge: Edge, all: Rect) -> f32 {
        let wanted = self.settings.panels.get(edge.panel()).copied();
        match edge {
            Edge::Timeline => timeline_height(wanted.unwrap_or(theme::TIMELINE), all.height()),
            Edge::Side => side_width(wanted.unwrap_or(theme::SIDE), all.width()),
            Edge::Inspector => {
                let usual = self.rooms.inspector.min(all.height() * 0.6);
                inspector_height(wanted.unwrap_or(usual), all.height())
            }
        }
    }

    /// Moves the edge that is dragged, before anything is laid out: it follows the pointer in the same picture. A double click gives the
    /// panel its usual size.
    fn drag_edges(&mut self, ui: &Ui, all: Rect) {
        for edge in Edge::ALL {
            let Some(response) = ui.ctx().read_response(edge.id()) else { continue };
            let pointer = response.interact_pointer_pos().filter(|_| response.dragged());
            let steps = steps_asked_for(ui, response.id);
            let stepped = (steps != 0.0).then(|| self.shown_size(edge, all) + steps * ROW);
            if let Some(wanted) = pointer.map(|pointer| edge.size_at(pointer, all.max)).or(stepped) {
                let size = match edge {
                    Edge::Timeline => timeline_height(wanted, all.height()),
                    Edge::Side => side_width(wanted, all.width()),
                    Edge::Inspector => inspector_height(wanted, all.height()),
                };
                self.settings.panels.insert(edge.panel().to_owned(), size);
                self.resized.extend(stepped.map(|_| (edge.panel(), Some(size))));
            }
            if response.double_clicked() {
                self.settings.panels.remove(edge.panel());
                self.resized.push((edge.panel(), None));
            } else if response.drag_stopped()
                && let Some(size) = self.settings.panels.get(edge.panel())
            {
                self.resized.push((edge.panel(), Some(*size)));
            }
        }
    }
}

/// By how many steps a screen reader asks to make a panel larger.
fn steps_asked_for(ui: &Ui, edge: Id) -> f32 {
    ui.input(|input| {
        let larger = input.accesskit_action_requests(edge, Action::Increment).count();
        let smaller = input.accesskit_action_requests(edge, Action::Decrement).count();
        f32::from(u8::from(larger > 0)) - f32::from(u8::from(smaller > 0))
    })
}

/// The line of an edge, over the panels beside it, which a drag takes.
fn show_edge(ui: &Ui, edge: Edge, line: Rect) {
    let response = ui.interact(line.expand(GRAB), edge.id(), Sense::CLICK | Sense::DRAG);
    let name = Words::of(ui).say(edge.name());
    response.widget_info(|| WidgetInfo::labeled(Role::Splitter, true, name));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.add_action(Action::Increment);
        node.add_action(Action::Decrement);
    });
    let is_held = response.dragged() || response.is_pointer_button_down_on();
    let tokens = Tokens::of(ui);
    let colour = match (is_held, response.hovered()) {
        (true, _) => tokens.accent,
        (false, true) => tokens.strong_line,
        (false, false) => tokens.line,
    };
    ui.painter().line_segment([line.min, line.max], Stroke::new(1.0, colour));
    if is_held || response.hovered() {
        let cursor = if edge == Edge::Side { CursorIcon::ResizeHorizontal } else { CursorIcon::ResizeVertical };
        ui.ctx().set_cursor_icon(cursor);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whatever_is_wanted_leaves_room_for_the_rest() {
        // From the smallest window at 200 % to a large one.
        for size in [[360.0, 194.0], [720.0, 434.0], [1366.0, 722.0], [2560.0, 1394.0]] {
            let [width, height] = size;
            for wanted in [0.0, 40.0, 200.0, 560.0, 4000.0] {
                let timeline = timeline_height(wanted, height);
                let scene = height - theme::TRANSPORT - timeline;
                assert!(timeline >= 80.0_f32.min(height / 3.0) && scene >= 80.0, "{timeline} of {height}");
                let side = side_width(wanted, width);
                assert!(side >= 180.0 && width - side >= 180.0, "{side} of {width}");
                let inspector = inspector_height(wanted, height);
                assert!(inspector.min(height - inspector) >= HALF.min(height / 2.0), "{inspector} of {height}");
            }
            assert_eq!((timeline_height(120.0, 434.0), side_width(260.0, 720.0)), (120.0, 260.0));
        }
    }

    #[test]
    fn an_edge_is_where_the_pointer_is() {
        let end = pos2(1000.0, 700.0);
        assert_eq!(Edge::Timeline.size_at(pos2(10.0, 500.0), end), 200.0 - theme::TRANSPORT);
        assert_eq!(Edge::Side.size_at(pos2(700.0, 10.0), end), 300.0);
        assert_eq!(Edge::Inspector.size_at(pos2(900.0, 400.0), end), 300.0);
    }
}
