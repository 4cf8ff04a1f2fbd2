//! Graphs of the chosen node over time: the current interpolation strong, the other faint. Dots of the translation can be dragged.

use egui::{
    Align2, Color32, CursorIcon, FontFamily, FontId, Key, Painter, PointerButton, Pos2, Rect, Response, Role, Sense,
    Shape, Stroke, Ui, WidgetInfo, pos2, vec2,
};
use glam::Vec3;

use super::curves::{Movement, Quantity, room};
use super::half_turn;
use super::hit::{LEAST_GAP, Target};
use super::paint::Look;
use super::tips::tip;
use crate::editor::{Command, Edit, Editor, GestureCommand, TimelineEdit};
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeIndex, PlayRange};
use crate::pose::RbtIndex;
use crate::ui::icons::{Icon, paint, was_pressed};
use crate::ui::theme::{CORNER, ROW, small_font};
use crate::words::texts;

/// Points from one sample of a curve to the next.
const STEP: f32 = 3.0;
/// How near the pointer must be to a dot.
const REACH: f32 = 7.0;
/// Half a dot.
const DOT: f32 = 3.5;
/// Height of the line above a graph that says what it shows.
const HEADING: f32 = 16.0;
const AXES: [&str; 3] = ["x", "y", "z"];

/// A graph as it was last drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Lane {
    quantity: Quantity,
    area: Rect,
    low: f32,
    high: f32,
}

impl Lane {
    fn y_of(&self, value: f32) -> f32 {
        let fraction = ((value - self.low) / (self.high - self.low)).clamp(-4.0, 5.0);
        self.area.bottom() - fraction * self.area.height()
    }
}

/// A value at a keyframe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Dot {
    index: usize,
    axis: usize,
}

/// A drag of a dot: along its graph as that was when the drag began.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Dragged {
    dot: Dot,
    rbt: RbtIndex,
    from_y: f32,
    before: Vec3,
    lane: Lane,
}

/// Which graphs are shown.
#[derive(Clone, Debug)]
pub struct Graphs {
    shown: [bool; 4],
    lanes: Vec<Lane>,
    hovered: Option<Dot>,
    dragged: Option<Dragged>,
}

impl Default for Graphs {
    fn default() -> Self {
        Self { shown: [true, false, true, false], lanes: Vec::new(), hovered: None, dragged: None }
    }
}

impl Graphs {
    /// Whether a dot is being dragged.
    pub const fn is_dragging(&self) -> bool {
        self.dragged.is_some()
    }

    /// Handles the pointer over dots. Returns whether it was used.
    pub fn pointer(
        &mut self,
        ui: &Ui,
        response: &Response,
        target: &Target<'_>,
        editor: &Editor,
        commands: &mut Vec<Command>,
    ) -> bool {
        let Some(at) = ui.input(|input| input.pointer.latest_pos()) else { return false };
        if let Some(dragged) = self.dragged {
            self.follow(ui, &dragged, editor, at, commands);
            return true;
        }
        let Some(rbt) = editor.session().chosen.primary() else { return false };
        let origin = ui.input(|input| input.pointer.press_origin());
        let found = self.dot_at(origin.unwrap_or(at), target, editor, rbt);
        self.hovered = found.filter(|_| response.hovered() && !editor.is_playing());
        let Some(dot) = self.hovered else { return false };
        ui.ctx().set_cursor_icon(CursorIcon::ResizeVertical);
        if response.drag_started_by(PointerButton::Primary)
            && let Some(lane) = self.lanes.iter().find(|lane| lane.quantity == Quantity::Translation)
            && let Some(keyframe) = editor.document().keyframes.get(KeyframeIndex::new(dot.index))
        {
            let before = keyframe.pose.get(rbt).translation;
            commands.push(Command::Gesture(GestureCommand::Begin));
            self.dragged = Some(Dragged { dot, rbt, from_y: origin.unwrap_or(at).y, before, lane: *lane });
        }
        true
    }

    fn follow(&mut self, ui: &Ui, dragged: &Dragged, editor: &Editor, at: Pos2, commands: &mut Vec<Command>) {
        ui.ctx().set_cursor_icon(CursorIcon::ResizeVertical);
        if ui.input(|input| input.key_pressed(Key::Escape)) {
            self.dragged = None;
            commands.push(Command::Gesture(GestureCommand::Abort));
            return;
        }
        let Lane { area, low, high, .. } = dragged.lane;
        let by = (dragged.from_y - at.y) * (high - low) / area.height().max(1.0);
        let mut translation = dragged.before;
        // A thousandth is as fine as the inspector shows.
        translation[dragged.dot.axis] = ((dragged.before[dragged.dot.axis] + by) * 1000.0).round() / 1000.0;
        let keyframe_index = KeyframeIndex::new(dragged.dot.index);
        let is_there = editor
            .document()
            .keyframes
            .get(keyframe_index)
            .is_none_or(|it| it.pose.get(dragged.rbt).translation == translation);
        if !is_there && at.y != dragged.from_y {
            let edit = TimelineEdit::SetTranslationInKeyframe(keyframe_index, dragged.rbt, translation);
            commands.push(Command::Edit(Edit::Timeline(edit)));
        }
        if !ui.input(|input| input.pointer.any_down()) {
            self.dragged = None;
            commands.push(Command::Gesture(GestureCommand::Commit));
        }
    }

    fn dot_at(&self, at: Pos2, target: &Target<'_>, editor: &Editor, rbt: RbtIndex) -> Option<Dot> {
        let lane = self.lanes.iter().find(|lane| lane.quantity == Quantity::Translation)?;
        if !lane.area.expand(REACH).contains(at) {
            return None;
        }
        let index = target.columns.nearest(target.scale.time_at(at.x))?;
        let x = target.scale.x_of(target.columns.time(index));
        let value = editor.document().keyframes.get(KeyframeIndex::new(index))?.pose.get(rbt).translation;
        (0..3)
            .map(|axis| (axis, pos2(x, lane.y_of(value[axis])).distance(at)))
            .filter(|&(_, distance)| distance <= REACH)
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(axis, _)| Dot { index, axis })
    }

    /// Shows a tooltip for the dot or warning under the pointer. Returns whether there is one.
    pub fn tip(&self, response: &Response, look: &Look<'_>) -> bool {
        let Some(at) = response.hover_pos() else { return false };
        let Some(rbt) = look.editor.session().chosen.primary() else { return false };
        if let Some(dot) = self.hovered {
            let keyframe = look.editor.document().keyframes.get(KeyframeIndex::new(dot.index));
            let value = keyframe.map_or(0.0, |keyframe| keyframe.pose.get(rbt).translation[dot.axis]);
            let heading = look.words.message(texts::keyframe_quantity(
                dot.index.to_string(),
                AXES[dot.axis],
                format!("{value:.3}"),
            ));
            let body = look.words.say(texts::DRAG_IT_UP_OR_DOWN_TO_CHANGE);
            response.clone().on_hover_ui_at_pointer(|ui| tip(ui, &heading, body, look));
            return true;
        }
        let warned = warnings(look, rbt).into_iter().find(|&(x, ..)| warning_place(look, x).distance(at) <= 9.0);
        let Some((_, index, degrees)) = warned else { return false };
        let (from, to) = (index.to_string(), (index + 1).to_string());
        let heading = look.words.message(texts::keyframe_turns(&from, &to, format!("{degrees:.1}")));
        let body = look.words.say(texts::HALF_TURN_ADVICE);
        response.clone().on_hover_ui_at_pointer(|ui| tip(ui, &heading, body, look));
        true
    }

    /// Shows the legend, whose entries show and hide graphs.
    pub fn legend(&mut self, ui: &Ui, look: &Look<'_>) {
        let (column, tokens) = (look.target.layout.labels, look.tokens);
        let painter = ui.painter().with_clip_rect(column.intersect(ui.clip_rect()));
        let scene = look.editor.scene();
        let chosen = look.editor.session().chosen.primary();
        let node =
            chosen.map_or(look.words.say(texts::NOTHING_CHOSEN), |rbt| scene.node(scene.rbt_node(rbt)).name.as_str());
        let colour = if chosen.is_some() { tokens.accent } else { tokens.dim };
        let at = pos2(column.left() + 12.0, column.top() + ROW / 2.0);
        painter.text(at, Align2::LEFT_CENTER, node, small_font(), colour);
        for (index, quantity) in Quantity::ALL.into_iter().enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "there are four")]
            let top = column.top() + ROW * (index as f32 + 1.0);
            let row = Rect::from_x_y_ranges(column.left() + 4.0..=column.right() - 4.0, top..=top + ROW);
            let seen = row.intersect(column);
            let name = look.words.say(quantity.name());
            let response = ui.interact(seen, ui.scope_id().with(("graph", index)), Sense::click());
            let is_on = self.shown[index];
            response.widget_info(|| {
                WidgetInfo::selected(Role::CheckBox, true, is_on, look.words.message(texts::graph_of(name)))
            });
            if response.hovered() {
                painter.rect_filled(row, CORNER, tokens.raised);
            }
            if response.has_focus() {
                painter.rect_stroke(row, CORNER, Stroke::new(1.0, tokens.accent), egui::StrokeKind::Inside);
            }
            let square = Rect::from_center_size(pos2(row.left() + 14.0, row.center().y), vec2(13.0, 13.0));
            painter.rect_stroke(square, 3.0, Stroke::new(1.0, tokens.strong_line), egui::StrokeKind::Inside);
            if is_on {
                paint(&painter, Icon::Tick, square.center(), tokens.accent);
            }
            let text = pos2(row.left() + 28.0, row.center().y);
            painter.text(text, Align2::LEFT_CENTER, name, small_font(), if is_on { tokens.text } else { tokens.dim });
            if quantity == Quantity::Translation {
                for (axis, name) in AXES.into_iter().enumerate() {
                    #[expect(clippy::cast_precision_loss, reason = "there are three")]
                    let at = pos2(row.right() - 44.0 + 14.0 * axis as f32, row.center().y);
                    painter.text(at, Align2::LEFT_CENTER, name, small_font(), tokens.axes[axis]);
                }
            }
            if was_pressed(&response) {
                self.shown[index] = !is_on;
            }
        }
    }

    /// Draws the graphs.
    pub fn paint(&mut self, painter: &Painter, look: &Look<'_>) {
        let tracks = look.target.layout.tracks;
        let whole = painter;
        let painter = painter.with_clip_rect(tracks.intersect(painter.clip_rect()));
        self.lanes.clear();
        let (Some(rbt), Ok(range)) =
            (look.editor.session().chosen.primary(), PlayRange::new(&look.editor.document().keyframes))
        else {
            let text = if look.target.range.is_none() {
                look.words.say(texts::FOUR_KEYFRAMES_MAKE_AN_ANIMATION_AND_AN)
            } else {
                look.words.say(texts::CHOOSE_A_NODE_TO_SEE_ITS_GRAPHS)
            };
            painter.text(tracks.center(), Align2::CENTER_CENTER, text, FontId::proportional(12.0), look.tokens.dim);
            return;
        };
        curves_legend(whole, look);
        let shown: Vec<Quantity> = Quantity::ALL
            .into_iter()
            .zip(self.shown)
            .filter(|&(_, is_on)| is_on)
            .map(|(quantity, _)| quantity)
            .collect();
        #[expect(clippy::cast_precision_loss, reason = "there are at most four")]
        let height = tracks.height() / shown.len().max(1) as f32;
        for (index, quantity) in shown.into_iter().enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "there are at most four")]
            let top = tracks.top() + height * index as f32;
            let area = Rect::from_x_y_ranges(tracks.x_range(), top..=top + height);
            if index > 0 {
                painter.hline(area.x_range(), top + 0.5, Stroke::new(1.0, look.tokens.line));
            }
            let lane = self.lane(
                &painter,
                look,
                &range,
                rbt,
                quantity,
                area.with_min_y(top + HEADING).with_max_y(area.bottom() - DOT - 1.0),
            );
            self.lanes.push(lane);
        }
        for (x, ..) in warnings(look, rbt) {
            paint_warning(&painter, look, x);
        }
    }

    fn lane(
        &self,
        painter: &Painter,
        look: &Look<'_>,
        range: &PlayRange<'_>,
        rbt: RbtIndex,
        quantity: Quantity,
        area: Rect,
    ) -> Lane {
        let document = look.editor.document();
        let (scale, columns) = (look.target.scale, look.target.columns);
        let axes = if quantity == Quantity::Translation { 3 } else { 1 };
        let in_force = document.interpolation;
        let mut curves = Vec::new();
        // The current interpolation is drawn last, over the others.
        let others = Interpolation::ALL.into_iter().filter(|&other| other != in_force);
        for interpolation in others.chain([in_force]) {
            let movement =
                Movement::new(&document.keyframes, range, columns, interpolation, rbt, document.ms_between_keyframes);
            let times = movement.times(&scale.in_sight(STEP), scale.units(STEP));
            let values: Vec<[f32; 3]> = times.iter().map(|&time| movement.values(quantity, time)).collect();
            curves.push((interpolation == in_force, times, values));
        }
        let in_sight = columns.within(&scale.in_sight(0.0));
        let dots = if axes == 3 && in_sight.len() < 400 { in_sight } else { 0..0 };
        let own =
            dots.clone().flat_map(|index| document.keyframes.as_slice()[index].pose.get(rbt).translation.to_array());
        let all = curves.iter().flat_map(|(_, _, values)| values.iter().flat_map(|value| value[..axes].to_vec()));
        let least = if matches!(quantity, Quantity::Translation | Quantity::Speed) { 0.1 } else { 2.0 };
        let (low, high) = room(all.chain(own), least);
        let low = if quantity == Quantity::Translation { low } else { low.max(0.0).min(high - least) };
        let mut lane = Lane { quantity, area, low, high };
        if let Some(dragged) = self.dragged.filter(|dragged| dragged.lane.quantity == quantity) {
            lane = Lane { area, ..dragged.lane };
        }
        for (is_in_force, times, values) in &curves {
            for axis in 0..axes {
                let colour = colour_of(look, quantity, axis);
                let colour = if *is_in_force { colour } else { colour.gamma_multiply(0.35) };
                let points =
                    times.iter().zip(values).map(|(&time, value)| pos2(scale.x_of(time), lane.y_of(value[axis])));
                painter.line(points.collect(), Stroke::new(if *is_in_force { 1.6 } else { 1.0 }, colour));
            }
        }
        #[expect(clippy::cast_possible_truncation, reason = "it is for points on a screen")]
        let gap = scale.view.points_per_unit as f32;
        if gap >= LEAST_GAP {
            for index in dots {
                self.dots(painter, look, &lane, rbt, index);
            }
        }
        scale_of_values(painter, look, &lane);
        lane
    }

    fn dots(&self, painter: &Painter, look: &Look<'_>, lane: &Lane, rbt: RbtIndex, index: usize) {
        let x = look.target.scale.x_of(look.target.columns.time(index));
        let value = look.editor.document().keyframes.as_slice()[index].pose.get(rbt).translation;
        for axis in 0..3 {
            let dot = Dot { index, axis };
            let is_hot = self.hovered == Some(dot) || self.dragged.is_some_and(|dragged| dragged.dot == dot);
            let colour = colour_of(look, Quantity::Translation, axis);
            let centre = pos2(x, lane.y_of(value[axis]));
            painter.circle(centre, if is_hot { DOT + 1.5 } else { DOT }, look.tokens.window, Stroke::new(1.5, colour));
            if is_hot {
                painter.circle_filled(centre, DOT - 0.5, colour);
            }
            if self.dragged.is_some_and(|dragged| dragged.dot == dot) {
                let text = format!("{} {:.3}", AXES[axis], value[axis]);
                let font = FontId::new(10.5, FontFamily::Monospace);
                let galley = painter.layout_no_wrap(text, font, look.tokens.text);
                let behind = Rect::from_min_size(centre + vec2(10.0, -9.0), galley.size() + vec2(10.0, 5.0));
                painter.rect_filled(behind, CORNER, look.tokens.raised);
                painter.galley(behind.min + vec2(5.0, 2.5), galley, look.tokens.text);
            }
        }
    }
}

fn colour_of(look: &Look<'_>, quantity: Quantity, axis: usize) -> Color32 {
    match quantity {
        Quantity::Translation => look.tokens.axes[axis],
        Quantity::Angle | Quantity::Speed => look.tokens.text,
        Quantity::AngularSpeed => look.tokens.information,
    }
}

/// Which interpolations the strong and the faint curves are of, in the ruler: the graphs below are full.
fn curves_legend(painter: &Painter, look: &Look<'_>) {
    let (ruler, tokens) = (look.target.layout.ruler, look.tokens);
    let painter = painter.with_clip_rect(ruler.intersect(painter.clip_rect()));
    let in_force = look.editor.document().interpolation;
    let others = Interpolation::ALL.into_iter().filter(|&other| other != in_force);
    let mut right = ruler.right() - 8.0;
    let y = ruler.top() + 7.0;
    let mut entries: Vec<Interpolation> = std::iter::once(in_force).chain(others).collect();
    entries.reverse();
    for interpolation in entries {
        let is_in_force = interpolation == in_force;
        let text = look.words.say(interpolation.title()).to_owned();
        let galley = painter.layout_no_wrap(text, FontId::proportional(10.0), tokens.dim);
        let left = right - galley.size().x;
        let behind = Rect::from_x_y_ranges(left - 26.0..=right + 4.0, ruler.top()..=ruler.top() + 14.0);
        painter.rect_filled(behind, 2.0, tokens.panel);
        painter.galley(pos2(left, y - galley.size().y / 2.0), galley, tokens.dim);
        let colour = if is_in_force { tokens.text } else { tokens.text.gamma_multiply(0.35) };
        painter.hline(left - 22.0..=left - 5.0, y, Stroke::new(if is_in_force { 1.6 } else { 1.0 }, colour));
        right = left - 34.0;
    }
}

/// What a graph shows, and its least and largest value, above it: within it they would run into the curves and their dots.
fn scale_of_values(painter: &Painter, look: &Look<'_>, lane: &Lane) {
    let tokens = look.tokens;
    let font = FontId::new(9.5, FontFamily::Monospace);
    let unit = lane.quantity.unit();
    let decimals = if lane.high - lane.low >= 20.0 { 0 } else { 2 };
    let (left, area) = (lane.area.left() + 5.0, lane.area);
    if lane.low < 0.0 && lane.high > 0.0 {
        let zero = Stroke::new(1.0, tokens.line);
        painter.hline(area.x_range(), lane.y_of(0.0).round() + 0.5, zero);
    }
    let (high, low) = (format!("{:.decimals$}{unit}", lane.high), format!("{:.decimals$}{unit}", lane.low));
    let at = pos2(left, area.top() - HEADING / 2.0);
    let under = painter.add(egui::Shape::Noop);
    let name = look.words.say(lane.quantity.name());
    let name = painter.text(at, Align2::LEFT_CENTER, name, FontId::proportional(10.0), tokens.dim);
    let at = pos2(name.right() + 8.0, at.y);
    let values = painter.text(at, Align2::LEFT_CENTER, format!("{low} … {high}"), font, tokens.dim);
    // The playhead goes behind the words.
    let ground = name.union(values).expand2(vec2(3.0, 0.0));
    painter.set(under, egui::Shape::rect_filled(ground, CORNER, tokens.panel));
}

/// The intervals in sight that turn by nearly half a turn: where their middles stand, where they begin, and by how many degrees.
fn warnings(look: &Look<'_>, rbt: RbtIndex) -> Vec<(f32, usize, f32)> {
    let Target { scale, columns, .. } = *look.target;
    let keyframes = look.editor.document().keyframes.as_slice();
    let seen = columns.within(&scale.in_sight(0.0));
    if seen.len() > 400 {
        return Vec::new();
    }
    let first = seen.start.saturating_sub(1).max(1);
    (first..seen.end.min(keyframes.len().saturating_sub(2)))
        .filter_map(|index| {
            let (_, degrees) = half_turn::nodes(keyframes, index, std::iter::once(rbt)).pop()?;
            let middle = f64::midpoint(columns.time(index), columns.time(index + 1));
            Some((scale.x_of(middle), index, degrees))
        })
        .collect()
}

fn warning_place(look: &Look<'_>, x: f32) -> Pos2 {
    pos2(x, look.target.layout.tracks.top() + 11.0)
}

fn paint_warning(painter: &Painter, look: &Look<'_>, x: f32) {
    let at = warning_place(look, x);
    let behind = [at + vec2(0.0, -8.0), at + vec2(8.5, 7.0), at + vec2(-8.5, 7.0)];
    painter.add(Shape::convex_polygon(behind.to_vec(), look.tokens.panel, Stroke::NONE));
    paint(painter, Icon::Warning, at, look.tokens.error);
}
