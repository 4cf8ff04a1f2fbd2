//! The timeline: a ruler, a row for all nodes and one for each, and a diamond for every keyframe; beside it, graphs.
//!
//! Layout, hit tests and drags are computed apart from painting. Only the visible part is computed.

mod columns;
mod curves;
mod drag;
mod dragging;
mod graphs;
mod half_turn;
mod hit;
mod keyboard;
mod labels;
mod marks;
mod menu;
mod numbers;
mod paint;
mod rename;
mod retime;
mod rows;
mod scale;
mod timed_key_menu;
mod timed_key_rows;
mod timed_key_view;
mod timed_keys;
mod tips;

use egui::{FontId, Key, Rect, Response, RichText, Role, Sense, Ui, WidgetInfo, pos2, vec2};

use super::access;
use super::binding_of;
use super::theme::{ROW, Tokens};
use super::thumbnails::Thumbnails;
use super::words::Words;
use crate::editor::keymap::Binding;
use crate::editor::{Command, Edit, Editor, GestureCommand, PlaybackCommand};
use crate::keyframe::{KeyframeIndex, PlayRange};
use crate::words::texts;
use columns::Columns;
use drag::Drag;
use hit::{Hit, Layout, RADIUS, Target};
use keyboard::Keyboard;
use paint::Look;
use rename::Renaming;
use rows::{Rows, has_key_rows};
use scale::{MOST_POINTS, Scale, VisibleTime};
pub use timed_key_menu::key_colour_now;
pub use timed_key_rows::put_control_above;
use timed_key_view::KeyView;
use timed_keys::Keys;

/// The tabs of the timeline.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
enum Tab {
    /// Diamonds.
    #[default]
    Keyframes,
    /// Curves of the chosen node.
    Graphs,
}

/// A request to the timeline from a hotkey, a menu or the command list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ask {
    /// A field for the current keyframe's name.
    Rename,
    /// All keyframes in sight.
    FitAll,
    /// The selected keyframes in sight.
    FitSelection,
}

/// The timeline's own state: zoom, scroll, folded rows, and the current drag.
#[derive(Clone, Debug, Default)]
pub struct Timeline {
    tab: Tab,
    columns: Columns,
    rows: Rows,
    /// The visible part of time; `None` until the user zooms or pans.
    view: Option<VisibleTime>,
    /// The visible part of time until then. It stays the same during a drag, so that nothing moves under the pointer.
    untouched: Option<VisibleTime>,
    /// The number of keyframes and the width that this view was made for.
    fitted_to: (usize, f32),
    scroll: f32,
    drag: Option<Drag>,
    hovered: Option<Hit>,
    /// The index at which a selection with Shift begins.
    anchor: Option<usize>,
    renaming: Option<Renaming>,
    asked: Option<Ask>,
    /// What was last shown, so that the timeline scrolls only when that changes.
    shown: Option<(Option<KeyframeIndex>, usize)>,
    /// The keyframe that the context menu is for.
    menu_for: Option<usize>,
    graphs: graphs::Graphs,
    keys: Keys,
    keyboard: Keyboard,
    /// Whether Left and Right fold and unfold the row that has the focus.
    folds_focused: bool,
}

impl Timeline {
    /// Whether Escape belongs to the timeline, because it cancels a running drag.
    #[must_use]
    pub const fn takes_escape(&self) -> bool {
        self.drag.is_some() || self.graphs.is_dragging() || self.keys.is_dragging()
    }

    /// Whether arrows belong to the timeline, because the focus is on it.
    #[must_use]
    pub fn takes_arrows(&self, context: &egui::Context) -> bool {
        self.keyboard.has_focus(context)
    }

    /// Stores a request, which is carried out when the timeline is next shown.
    pub const fn ask(&mut self, ask: Ask) {
        self.asked = Some(ask);
    }

    /// Shows the timeline.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        editor: &Editor,
        bindings: &[Binding],
        thumbnails: &mut Thumbnails,
        commands: &mut Vec<Command>,
    ) {
        let whole = ui.available_rect_before_wrap();
        if editor.document().keyframes.is_empty() && !has_key_rows(editor.scene()) {
            self.asked = None;
            empty(ui, bindings);
            ui.advance_cursor_after_rect(whole);
            return;
        }
        ui.advance_cursor_after_rect(whole);
        let mut columns = std::mem::take(&mut self.columns);
        let is_replaced = columns.update(&editor.document().keyframes);
        columns.set_keys(timed_key_view::ends(editor));
        let layout = Layout::of(whole, self.tab == Tab::Keyframes);
        let response = ui.interact(layout.scaled(), ui.scope_id().with("tracks"), Sense::click_and_drag());
        let words = Words::of(ui);
        response.widget_info(|| WidgetInfo::labeled(Role::Group, true, words.say(texts::TIMELINE)));
        self.choose_view(editor, &layout, &columns, is_replaced);
        self.wheel(ui, &response, &layout, &columns);
        self.answer(editor, &layout, &columns);

        let rows = self.rows.of(editor.scene());
        let shown_rows = if self.tab == Tab::Keyframes { rows.len() } else { 0 };
        self.keep_scroll(shown_rows, &layout);
        let scale = self.scale(&layout, &columns);
        let target = Target {
            layout: &layout,
            scale: &scale,
            columns: &columns,
            range: played(editor),
            stretch: stretch(editor),
            has_rows: self.tab == Tab::Keyframes,
            rows: shown_rows,
            scroll: self.scroll,
        };
        let key_view = KeyView { editor, target: &target, rows: &rows };
        let takes_part = match self.tab {
            Tab::Graphs => self.graphs.pointer(ui, &response, &target, editor, commands),
            Tab::Keyframes => self.drag.is_none() && self.keys.pointer(ui, &response, &key_view, commands),
        };
        if takes_part {
            self.hovered = None;
        } else {
            self.pointer(ui, &response, &target, editor, commands);
        }
        let look =
            Look { editor, target: &target, tokens: Tokens::of(ui), words: Words::of(ui), hovered: self.hovered };
        self.paint(ui, &look, &rows, bindings, thumbnails);
        labels::header(self, ui, &layout, bindings);
        self.keyboard.begin();
        self.folds_focused = false;
        match self.tab {
            Tab::Keyframes => {
                labels::rows(self, ui, &look, &rows, bindings, commands);
                let entry = diamonds(self, ui, &look, commands);
                self.keys.diamonds(ui, &key_view, look.tokens, &mut self.keyboard, commands);
                self.move_focus(ui, entry, &target);
            }
            Tab::Graphs => self.graphs.legend(ui, &look),
        }
        if self.tab == Tab::Graphs || !self.keys.tip(&response, &look, &rows) {
            self.tips(&response, &look, thumbnails);
        }
        if self.tab == Tab::Graphs || !self.keys.menu(ui, &response, &key_view, commands) {
            self.menu(ui, &response, &target, editor, bindings, commands);
        }
        self.rename_field(ui, &target, editor, commands);
        self.columns = columns;
    }

    /// Moves the focus by arrows, and what is in sight where it would leave that.
    fn move_focus(&mut self, ui: &Ui, entry: Option<egui::Id>, target: &Target<'_>) {
        let Some(beyond) = self.keyboard.end(ui, entry, self.folds_focused) else { return };
        if beyond.x != 0.0 {
            self.pan(-beyond.x * target.layout.tracks.width() / 4.0, target);
        }
        self.scroll = (self.scroll + beyond.y * ROW).max(0.0);
    }

    fn paint(
        &mut self,
        ui: &Ui,
        look: &Look<'_>,
        rows: &[rows::Row],
        bindings: &[Binding],
        thumbnails: &mut Thumbnails,
    ) {
        let layout = look.target.layout;
        let painter = ui.painter().with_clip_rect(layout.scaled().intersect(ui.clip_rect()));
        let side = layout.header.union(layout.labels);
        ui.painter().rect_filled(side, 0.0, look.tokens.panel);
        paint::ground(&painter, look);
        paint::ruler(&painter, look);
        if self.tab == Tab::Keyframes {
            paint::lines(&painter, look);
            paint::nodes(&painter, look, rows);
            self.keys.paint(&painter, look, rows);
            marks::strip(&painter, look, thumbnails);
            paint::summary(&painter, look, self.drag.as_ref());
            marks::half_turns(&painter, look, rows);
            dragging::stretch_box(&painter, look, self.drag.as_ref());
            missing(ui, look, bindings);
            paint::playhead(&painter, look);
        } else {
            paint::playhead(&painter, look);
            self.graphs.paint(&painter, look);
        }
        if let (Some(drag), Some(at)) = (&self.drag, ui.input(|input| input.pointer.latest_pos())) {
            dragging::show(&painter, look, drag, self.box_at(look.target, at), at);
        }
        let line = egui::Stroke::new(1.0, look.tokens.line);
        ui.painter().vline(side.right() - 0.5, side.y_range(), line);
        ui.painter().hline(side.x_range(), layout.header.bottom() - 0.5, line);
    }

    /// The current view, moved if the current keyframe or the playhead is out of sight.
    fn choose_view(&mut self, editor: &Editor, layout: &Layout, columns: &Columns, is_replaced: bool) {
        let width = layout.tracks.width();
        let (first, last) = columns.ends();
        let is_still = self.drag.is_none() && !self.graphs.is_dragging() && !self.keys.is_dragging();
        let fitted_to = (columns.len(), width);
        if is_still && (is_replaced || self.fitted_to != fitted_to) {
            let fresh = VisibleTime::at_first(first, last, width);
            let (before, width_before) = std::mem::replace(&mut self.fitted_to, fitted_to);
            // New keyframes that no longer fit make a view that was never zoomed smaller. What is pasted (it is selected), what is deleted
            // and what is undone changes no scale: what is under the pointer stays there.
            let is_new = editor.session().selected.is_empty() && editor.redo_label().is_none();
            let outgrows = columns.len() > before && is_new;
            let fits_again = is_replaced || width != width_before || outgrows;
            let keeps = |view: &VisibleTime| {
                let is_smaller = fresh.points_per_unit < view.points_per_unit;
                !fits_again || view.points_per_unit == fresh.points_per_unit || (outgrows && !is_smaller)
            };
            self.untouched = Some(self.untouched.filter(keeps).unwrap_or(fresh));
        }
        let now = (editor.document().keyframes.current(), columns.len());
        let is_new = self.shown.replace(now) != Some(now);
        if !is_still {
            return;
        }
        let view = self.view.as_mut().or(self.untouched.as_mut());
        let Some(view) = view else { return };
        if editor.is_playing() {
            if let Some(key_time) = editor.playhead() {
                *view = view.paged(columns.time_of_key(key_time), width);
            }
        } else if let Some(current) = now.0.filter(|_| is_new) {
            *view = view.showing(columns.time(current.get()), width);
        }
        let (first, last) = columns.all();
        *view = view.kept_near(first, last, width);
    }

    fn scale(&self, layout: &Layout, columns: &Columns) -> Scale {
        let (first, last) = columns.ends();
        let view = self.view.or(self.untouched);
        Scale {
            left: layout.tracks.left(),
            right: layout.tracks.right(),
            view: view.unwrap_or_else(|| VisibleTime::at_first(first, last, layout.tracks.width())),
        }
    }

    /// Puts another part of time in sight. A view that was never zoomed stays one that fits itself.
    const fn shift_view(&mut self, to: VisibleTime) {
        if self.view.is_some() { self.view = Some(to) } else { self.untouched = Some(to) }
    }

    fn keep_scroll(&mut self, rows: usize, layout: &Layout) {
        #[expect(clippy::cast_precision_loss, reason = "trees are not that long")]
        let most = (rows as f32 * ROW - layout.nodes.height()).max(0.0);
        self.scroll = self.scroll.clamp(0.0, most);
    }

    /// Changes the visible part of time by a function.
    fn set_view(&mut self, change: impl FnOnce(VisibleTime) -> VisibleTime, width: f32, columns: &Columns) {
        let (first, last) = columns.ends();
        let view = self.view.or(self.untouched).unwrap_or_else(|| VisibleTime::at_first(first, last, width));
        let (first, last) = columns.all();
        self.view = Some(change(view).kept_near(first, last, width));
    }

    fn pan(&mut self, by: f32, target: &Target<'_>) {
        let width = target.layout.tracks.width();
        let (first, last) = target.columns.all();
        self.view = Some(target.scale.view.panned(by).kept_near(first, last, width));
    }

    fn wheel(&mut self, ui: &Ui, response: &Response, layout: &Layout, columns: &Columns) {
        let Some(at) = ui.input(|input| input.pointer.hover_pos()) else { return };
        let is_over_names = layout.labels.contains(at) && ui.ctx().layer_id_at(at) == Some(ui.layer_id());
        if !(response.hovered() || is_over_names) {
            return;
        }
        let (zoom, scrolled, modifiers) =
            ui.input(|input| (input.zoom_delta(), input.smooth_scroll_delta(), input.modifiers));
        let width = layout.tracks.width();
        if zoom != 1.0 {
            let (first, last) = columns.all();
            let least = (VisibleTime::fitting(first, last, width).points_per_unit / 2.0).min(MOST_POINTS);
            self.set_view(|view| view.zoomed(f64::from(zoom), at.x - layout.tracks.left(), least), width, columns);
        } else if scrolled != egui::Vec2::ZERO {
            if modifiers.shift || is_over_names {
                self.scroll -= scrolled.x + scrolled.y;
            } else {
                self.set_view(|view| view.panned(scrolled.x + scrolled.y), width, columns);
            }
        }
    }

    fn answer(&mut self, editor: &Editor, layout: &Layout, columns: &Columns) {
        match self.asked.take() {
            None => {}
            Some(Ask::FitAll) => self.fit_all(layout, columns),
            Some(Ask::FitSelection) => self.fit_selection(editor, layout, columns),
            Some(Ask::Rename) => self.start_renaming(editor, editor.document().keyframes.current()),
        }
    }

    /// Brings the whole list into sight.
    fn fit_all(&mut self, layout: &Layout, columns: &Columns) {
        let (first, last) = columns.all();
        self.view = Some(VisibleTime::fitting(first, last, layout.tracks.width()));
    }

    /// Scrolls the selected keyframes into sight; a single one with its neighbours.
    fn fit_selection(&mut self, editor: &Editor, layout: &Layout, columns: &Columns) {
        if let Some((first, last)) = timed_key_view::ends_of_selection(editor) {
            self.view = Some(VisibleTime::fitting(first, last.max(first + 0.1), layout.tracks.width()));
            return;
        }
        let indices = editor.edited_keyframes();
        let (Some(&first), Some(&last)) = (indices.first(), indices.last()) else { return };
        let last_place = columns.len().saturating_sub(1);
        let (first, last) =
            if first == last { (first.saturating_sub(1), (last + 1).min(last_place)) } else { (first, last) };
        self.view = Some(VisibleTime::fitting(columns.time(first), columns.time(last), layout.tracks.width()));
    }
}

/// The first and the last keyframe that play.
fn played(editor: &Editor) -> Option<(usize, usize)> {
    let keyframes = &editor.document().keyframes;
    PlayRange::new(keyframes).ok()?;
    Some(editor.session().play_range.unwrap_or((1, keyframes.len() - 2)))
}

/// The first and the last selected keyframe, if two or more are selected.
fn stretch(editor: &Editor) -> Option<(usize, usize)> {
    let [first, .., last] = editor.session().selected.as_slice() else { return None };
    Some((first.get(), last.get()))
}

fn empty(ui: &mut Ui, bindings: &[Binding]) {
    let tokens = Tokens::of(ui);
    ui.painter().rect_filled(ui.available_rect_before_wrap(), 0.0, tokens.window);
    let create = key_of(bindings, &Command::Edit(Edit::CreateKeyframe));
    let play = key_of(bindings, &Command::Playback(PlaybackCommand::PlayOrStop));
    let text = Words::of(ui).message(texts::no_keyframes_yet_long(&create, &play));
    ui.centered_and_justified(|ui| ui.label(RichText::new(text).color(tokens.dim)));
}

/// Says what to do while there are too few to play.
fn missing(ui: &Ui, look: &Look<'_>, bindings: &[Binding]) {
    let count = look.target.columns.len();
    let key = key_of(bindings, &Command::Edit(Edit::CreateKeyframe));
    let text = match count {
        0 => look.words.message(texts::no_keyframes_yet(&key)),
        1..=3 => look.words.message(texts::more_keyframes_needed(4 - count, &key)),
        _ => return,
    };
    let (_, last) = look.target.columns.ends();
    let x = if count == 0 { look.target.layout.tracks.left() - 8.0 } else { look.target.scale.x_of(last) + 12.0 };
    let summary = look.target.layout.summary;
    let painter = ui.painter().with_clip_rect(look.target.layout.tracks.intersect(ui.clip_rect()));
    // What has no room in the summary's row goes on over the rows below.
    let (left, margin) = (x + 20.0, vec2(4.0, 0.0));
    let room = (painter.clip_rect().right() - left - margin.x).max(80.0);
    let galley = painter.layout(text, FontId::proportional(12.0), look.tokens.dim, room);
    let half_row = galley.rows.first().map_or(0.0, |row| row.height() * 0.5);
    let at = pos2(left, summary.center().y - half_row);
    if galley.rows.len() > 1 {
        painter.rect_filled(Rect::from_min_size(at, galley.size()).expand2(margin), 3.0, look.tokens.window);
    }
    painter.galley(at, galley, look.tokens.dim);
}

/// Adds the diamonds of the summary row as widgets for the keyboard and screen readers. The mouse is handled by the tracks. Returns the
/// one of the current keyframe.
fn diamonds(timeline: &mut Timeline, ui: &Ui, look: &Look<'_>, commands: &mut Vec<Command>) -> Option<egui::Id> {
    let Target { layout, scale, columns, .. } = *look.target;
    let y = layout.summary.center().y;
    let editor = look.editor;
    let current = editor.document().keyframes.current().map(KeyframeIndex::get);
    let mut entry = None;
    for group in columns.groups(scale.in_sight(0.0), scale.units(2.0 * RADIUS)) {
        let is_current = current.is_some_and(|current| group.contains(&current));
        let index = current.filter(|_| is_current).unwrap_or(group.start);
        let centre = pos2(scale.x_of(columns.time(index)), y);
        let area = Rect::from_center_size(centre, vec2(2.0 * RADIUS, ROW - 2.0)).intersect(layout.summary);
        let id = ui.scope_id().with(("keyframe", index));
        entry = entry.or(is_current.then_some(id));
        let sense = timeline.keyboard.item(ui, id, 0, centre.x, Sense::empty());
        let response = ui.interact(area, id, sense);
        let name = look.words.message(texts::keyframe_number(index.to_string()));
        access::item(&response, Role::ListBoxOption, true, is_current, name);
        let is_asked = ui.input(|input| input.has_accesskit_action_request(id, egui::accesskit::Action::Click));
        if is_asked {
            timeline.pick(index, editor, egui::Modifiers::NONE, commands);
        }
        ui.ctx().accesskit_node_builder(id, |node| node.add_action(egui::accesskit::Action::Click));
        if !response.has_focus() {
            continue;
        }
        let stroke = egui::Stroke::new(1.0, look.tokens.accent);
        ui.painter().rect_stroke(area, 3.0, stroke, egui::StrokeKind::Outside);
        if ui.input(|input| input.key_pressed(Key::Enter) || input.key_pressed(Key::Space)) {
            let modifiers = ui.input(|input| input.modifiers);
            timeline.pick(index, editor, modifiers, commands);
        }
    }
    entry
}

/// The hotkey of a command, or its name if it has no hotkey.
fn key_of(bindings: &[Binding], command: &Command) -> String {
    let binding = binding_of(bindings, command);
    binding
        .map(|it| if it.chords.is_empty() { it.title().english().to_owned() } else { it.menu_key() })
        .unwrap_or_default()
}

/// A drag of a number in a menu, as one step of undo.
fn drag_of_number(response: &Response, command: Command, commands: &mut Vec<Command>) {
    if response.drag_started() {
        commands.push(Command::Gesture(GestureCommand::Begin));
    }
    if response.changed() {
        commands.push(command);
    }
    if response.drag_stopped() {
        commands.push(Command::Gesture(GestureCommand::Commit));
    }
}
