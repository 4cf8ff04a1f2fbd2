//! Icons, drawn: one set, one stroke, on a square of 16 points.

use egui::{Color32, Painter, Pos2, Rect, Response, Role, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, pos2, vec2};

use super::theme::{CORNER, ROW, Tokens};

/// The set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Icon {
    /// To the previous keyframe.
    Previous,
    /// Play.
    Play,
    /// Stop.
    Stop,
    /// Pause.
    Pause,
    /// To the next keyframe.
    Next,
    /// A keyframe more.
    NewKeyframe,
    /// The keyframe takes the scene's pose.
    UpdateKeyframe,
    /// The scene takes the keyframe's pose.
    DisplayKeyframe,
    /// A keyframe less.
    DeleteKeyframe,
    /// A camera.
    Camera,
    /// The ground.
    Ground,
    /// A node with others below it.
    Body,
    /// A joint.
    Joint,
    /// A shape.
    Shape,
    /// A node that is moved by keys.
    Control,
    /// An eye: look from here.
    Eye,
    /// It is on.
    Tick,
    /// One more.
    More,
    /// Play from the playhead.
    PlayFromPlayhead,
    /// Play once.
    Once,
    /// Play in a loop.
    Loop,
    /// Play forwards and backwards.
    PingPong,
    /// Drags record.
    AutoKey,
    /// The poses of neighbouring keyframes.
    Ghosts,
    /// All of it in sight.
    FitAll,
    /// What is selected in sight.
    FitSelection,
    /// Something may go wrong.
    Warning,
    /// A folder.
    Folder,
    /// The folder above.
    FolderAbove,
    /// The user's own folder.
    Home,
    /// A file.
    File,
    /// The panel at the right.
    Side,
}

/// Draws an icon about a centre.
#[expect(clippy::too_many_lines, reason = "it is one set")]
pub fn paint(painter: &Painter, icon: Icon, centre: Pos2, colour: Color32) {
    let at = |x: f32, y: f32| centre + vec2(x, y);
    let stroke = Stroke::new(1.5, colour);
    let fill = |points: Vec<Pos2>| {
        painter.add(Shape::convex_polygon(points, colour, Stroke::NONE));
    };
    let bar = |x: f32, y: f32, width: f32, height: f32| {
        painter.rect_filled(Rect::from_min_size(at(x, y), vec2(width, height)), 0.5, colour);
    };
    let line = |from: Pos2, to: Pos2| {
        painter.line_segment([from, to], stroke);
    };
    match icon {
        Icon::Previous => {
            bar(-5.5, -5.0, 2.0, 10.0);
            fill(vec![at(5.0, -5.0), at(5.0, 5.0), at(-2.5, 0.0)]);
        }
        Icon::Next => {
            bar(3.5, -5.0, 2.0, 10.0);
            fill(vec![at(-5.0, -5.0), at(2.5, 0.0), at(-5.0, 5.0)]);
        }
        Icon::Play => fill(vec![at(-4.0, -6.0), at(6.0, 0.0), at(-4.0, 6.0)]),
        Icon::Stop => bar(-5.0, -5.0, 10.0, 10.0),
        Icon::Pause => {
            bar(-4.5, -5.5, 3.0, 11.0);
            bar(1.5, -5.5, 3.0, 11.0);
        }
        Icon::NewKeyframe => {
            diamond(painter, at(-2.0, 0.0), 5.5, Color32::TRANSPARENT, stroke);
            line(at(5.5, -6.5), at(5.5, -0.5));
            line(at(2.5, -3.5), at(8.5, -3.5));
        }
        Icon::DeleteKeyframe => {
            diamond(painter, at(-2.0, 0.0), 5.5, Color32::TRANSPARENT, stroke);
            line(at(2.5, -5.0), at(8.5, -5.0));
        }
        Icon::UpdateKeyframe => {
            diamond(painter, at(0.0, 3.0), 4.5, colour, Stroke::NONE);
            line(at(0.0, -8.0), at(0.0, -3.5));
            line(at(-2.5, -5.5), at(0.0, -3.0));
            line(at(2.5, -5.5), at(0.0, -3.0));
        }
        Icon::DisplayKeyframe => {
            diamond(painter, at(0.0, 3.0), 4.5, colour, Stroke::NONE);
            line(at(0.0, -7.5), at(0.0, -3.0));
            line(at(-2.5, -5.0), at(0.0, -7.5));
            line(at(2.5, -5.0), at(0.0, -7.5));
        }
        Icon::Camera => {
            let body = Rect::from_min_max(at(-6.0, -3.5), at(2.0, 4.0));
            painter.rect_stroke(body, 1.5, stroke, egui::StrokeKind::Middle);
            fill(vec![at(3.0, 0.0), at(6.5, -3.0), at(6.5, 3.5)]);
        }
        Icon::Ground => {
            let corners = [at(-3.0, -3.0), at(3.0, -3.0), at(6.5, 3.5), at(-6.5, 3.5)];
            painter.add(Shape::closed_line(corners.to_vec(), stroke));
            line(at(-4.75, 0.25), at(4.75, 0.25));
        }
        Icon::Body => {
            painter.circle_stroke(at(0.0, -4.0), 2.2, stroke);
            let torso = Rect::from_min_max(at(-3.5, -0.5), at(3.5, 6.0));
            painter.rect_stroke(torso, 1.5, stroke, egui::StrokeKind::Middle);
        }
        Icon::Joint => {
            painter.circle_stroke(at(-2.5, 2.5), 2.2, stroke);
            line(at(-0.9, 0.9), at(4.5, -4.5));
        }
        Icon::Shape => {
            let top = |x: f32, y: f32| at(x, y - 1.0);
            for (from, to) in [
                ((-4.5, -1.5), (0.0, -4.0)),
                ((0.0, -4.0), (4.5, -1.5)),
                ((-4.5, -1.5), (0.0, 1.0)),
                ((0.0, 1.0), (4.5, -1.5)),
            ] {
                line(top(from.0, from.1), top(to.0, to.1));
            }
            for x in [-4.5, 0.0, 4.5] {
                let y = if x == 0.0 { 1.0 } else { -1.5 };
                line(top(x, y), top(x, y + 4.5));
            }
            line(top(-4.5, 3.0), top(0.0, 5.5));
            line(top(0.0, 5.5), top(4.5, 3.0));
        }
        Icon::Control => {
            painter.add(Shape::closed_line(vec![at(0.0, -5.0), at(5.0, 0.0), at(0.0, 5.0), at(-5.0, 0.0)], stroke));
        }
        Icon::PlayFromPlayhead => {
            bar(-6.0, -6.0, 1.8, 12.0);
            fill(vec![at(-2.0, -5.0), at(6.0, 0.0), at(-2.0, 5.0)]);
        }
        Icon::Once => {
            line(at(-6.5, 0.0), at(3.5, 0.0));
            line(at(0.0, -3.5), at(3.5, 0.0));
            line(at(0.0, 3.5), at(3.5, 0.0));
            line(at(6.0, -5.0), at(6.0, 5.0));
        }
        Icon::Loop => {
            let arc = |from: f32, to: f32| {
                (0..=12u8).map(move |step| {
                    let angle = (from + (to - from) * f32::from(step) / 12.0).to_radians();
                    at(5.5 * angle.cos(), 5.5 * angle.sin())
                })
            };
            painter.line(arc(-60.0, 230.0).collect(), stroke);
            fill(vec![at(-5.5, -7.0), at(0.5, -5.5), at(-3.8, -1.6)]);
        }
        Icon::PingPong => {
            line(at(-6.0, 0.0), at(6.0, 0.0));
            for side in [-1.0, 1.0] {
                line(at(side * 2.8, -3.2), at(side * 6.3, 0.0));
                line(at(side * 2.8, 3.2), at(side * 6.3, 0.0));
            }
        }
        Icon::AutoKey => {
            painter.circle_stroke(centre, 6.0, stroke);
            painter.circle_filled(centre, 3.2, colour);
        }
        Icon::Ghosts => {
            diamond(painter, at(-3.5, 0.0), 4.0, Color32::TRANSPARENT, Stroke::new(1.0, colour.gamma_multiply(0.6)));
            diamond(painter, at(3.5, 0.0), 4.0, Color32::TRANSPARENT, Stroke::new(1.0, colour.gamma_multiply(0.6)));
            diamond(painter, centre, 4.5, colour, Stroke::NONE);
        }
        Icon::FitAll => {
            for side in [-1.0, 1.0] {
                line(at(side * 7.0, -5.0), at(side * 7.0, 5.0));
                line(at(side * 1.0, 0.0), at(side * 5.0, 0.0));
                line(at(side * 2.6, -2.6), at(side * 5.2, 0.0));
                line(at(side * 2.6, 2.6), at(side * 5.2, 0.0));
            }
        }
        Icon::FitSelection => {
            for side in [-1.0, 1.0] {
                line(at(side * 7.0, -5.0), at(side * 7.0, 5.0));
                line(at(side * 7.0, -5.0), at(side * 4.5, -5.0));
                line(at(side * 7.0, 5.0), at(side * 4.5, 5.0));
            }
            diamond(painter, centre, 3.6, colour, Stroke::NONE);
        }
        Icon::Warning => {
            let corners = [at(0.0, -5.5), at(6.0, 5.0), at(-6.0, 5.0)];
            painter.add(Shape::closed_line(corners.to_vec(), stroke));
            line(at(0.0, -1.8), at(0.0, 1.4));
            painter.circle_filled(at(0.0, 3.3), 0.9, colour);
        }
        Icon::Folder => folder(painter, centre, stroke),
        Icon::FolderAbove => {
            folder(painter, centre, stroke);
            line(at(0.0, 3.5), at(0.0, -1.0));
            line(at(-2.3, 0.8), at(0.0, -1.5));
            line(at(2.3, 0.8), at(0.0, -1.5));
        }
        Icon::Home => {
            let walls = [at(-4.5, -0.5), at(-4.5, 5.5), at(4.5, 5.5), at(4.5, -0.5)];
            painter.line(walls.to_vec(), stroke);
            painter.line(vec![at(-6.5, 0.5), at(0.0, -5.5), at(6.5, 0.5)], stroke);
            bar(-1.2, 2.0, 2.4, 3.5);
        }
        Icon::File => {
            let sheet = [at(1.0, -6.0), at(-4.5, -6.0), at(-4.5, 6.0), at(4.5, 6.0), at(4.5, -2.5)];
            painter.add(Shape::closed_line(sheet.to_vec(), stroke));
            painter.line(vec![at(1.0, -6.0), at(1.0, -2.5), at(4.5, -2.5)], stroke);
        }
        Icon::Side => {
            let window = Rect::from_min_max(at(-6.5, -5.5), at(6.5, 5.5));
            painter.rect_stroke(window, 1.5, stroke, egui::StrokeKind::Middle);
            line(at(1.5, -5.5), at(1.5, 5.5));
            line(at(3.5, -2.0), at(4.5, -2.0));
            line(at(3.5, 1.0), at(4.5, 1.0));
        }
        Icon::Tick => {
            line(at(-3.5, 0.0), at(-1.0, 3.0));
            line(at(-1.0, 3.0), at(4.0, -3.5));
        }
        Icon::More => {
            line(at(-4.0, 0.0), at(4.0, 0.0));
            line(at(0.0, -4.0), at(0.0, 4.0));
        }
        Icon::Eye => {
            let lid = |side: f32| {
                (0..=8u8).map(move |step| {
                    let along = f32::from(step) / 4.0 - 1.0;
                    at(along * 6.5, side * 4.0 * (1.0 - along * along))
                })
            };
            painter.line(lid(-1.0).collect(), stroke);
            painter.line(lid(1.0).collect(), stroke);
            painter.circle_filled(centre, 1.8, colour);
        }
    }
}

fn folder(painter: &Painter, centre: Pos2, stroke: Stroke) {
    let corners = [(-6.0, -4.5), (-1.5, -4.5), (0.0, -2.5), (6.0, -2.5), (6.0, 5.0), (-6.0, 5.0)];
    painter.add(Shape::closed_line(corners.map(|(x, y)| centre + vec2(x, y)).to_vec(), stroke));
}

/// Draws a keyframe's diamond.
pub fn diamond(painter: &Painter, centre: Pos2, radius: f32, fill: Color32, stroke: Stroke) {
    let corners = vec![
        pos2(centre.x, centre.y - radius),
        pos2(centre.x + radius, centre.y),
        pos2(centre.x, centre.y + radius),
        pos2(centre.x - radius, centre.y),
    ];
    painter.add(Shape::convex_polygon(corners, fill, stroke));
}

/// A button that shows an icon. `name` is what it does, `key` its hotkey; both stand in the tooltip, the name is what screen readers say.
pub fn button(ui: &mut Ui, icon: Icon, name: &str, key: &str, is_enabled: bool, is_lit: bool) -> bool {
    let (_, rect) = ui.allocate_space(Vec2::new(ROW + 6.0, ROW + 2.0));
    button_at(ui, rect, icon, name, key, is_enabled, is_lit)
}

/// Like [`button`], in a place of its own.
pub fn button_at(ui: &Ui, rect: Rect, icon: Icon, name: &str, key: &str, is_enabled: bool, is_lit: bool) -> bool {
    let sense = if is_enabled { Sense::click() } else { Sense::hover() };
    button_sensing(ui, rect, icon, name, key, sense, is_lit)
}

/// The identity of a button with this name.
pub fn button_id(ui: &Ui, name: &str) -> egui::Id {
    ui.scope_id().with(("button", name))
}

/// Like [`button_at`], with a sense of its own. One that senses no clicks is not enabled.
pub fn button_sensing(ui: &Ui, rect: Rect, icon: Icon, name: &str, key: &str, sense: Sense, is_lit: bool) -> bool {
    let is_enabled = sense.senses_click();
    let response = ui.interact(rect, button_id(ui, name), sense);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, is_enabled, name));
    let tokens = Tokens::of(ui);
    if is_enabled && (response.hovered() || response.has_focus()) {
        let fill = if response.is_pointer_button_down_on() { tokens.line } else { tokens.hovered };
        ui.painter().rect_filled(rect, CORNER, fill);
    }
    if response.has_focus() {
        ui.painter().rect_stroke(rect, CORNER, Stroke::new(1.0, tokens.accent), egui::StrokeKind::Inside);
    }
    let colour = match (is_enabled, is_lit) {
        (false, _) => tokens.dim.gamma_multiply(0.5),
        (true, true) => tokens.accent,
        (true, false) => tokens.text,
    };
    paint(ui.painter(), icon, rect.center(), colour);
    let tip = if key.is_empty() { name.to_owned() } else { format!("{name}  ·  {key}") };
    let response = response.on_hover_text(tip);
    was_pressed(&response)
}

/// Whether a button was pressed. One that was clicked gives the keyboard back, so that it does not take the space bar afterwards.
#[must_use]
pub fn was_pressed(response: &Response) -> bool {
    let pressed = response.clicked();
    if pressed && response.ctx.input(|input| input.pointer.any_released()) {
        response.surrender_focus();
    }
    pressed
}
