//! The first steps: six things to do in an empty window, each done by doing it. A card over the scene that takes no key and no focus.

use egui::{Align2, Area, Frame, Id, Label, Margin, Order, Rect, RichText, Role, Sense, Stroke, Ui, WidgetInfo, vec2};

use super::binding_of;
use super::icons::{self, Icon};
use super::theme::{CORNER, GRID, ROW, Tokens};
use super::words::Words;
use crate::editor::keymap::{Binding, Keymap};
use crate::editor::{Command, Edit, Editor, FileCommand, PlaybackCommand, WindowCommand};
use crate::words::{Message, texts};

/// How many steps there are.
const STEPS: usize = 6;
/// Width of the card, in points.
const WIDTH: f32 = 268.0;
/// The least width and height of the 3D view in which all steps are listed, in points; in a smaller one only the step at hand is.
const ROOM: egui::Vec2 = vec2(480.0, 230.0);

/// How far the user is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tour {
    /// Steps that are done; `None`: the card is hidden.
    done: Option<usize>,
    /// Whether it was seen if the window began empty.
    has_begun: bool,
}

impl Tour {
    /// Whether the card is shown.
    pub const fn is_shown(self) -> bool {
        self.done.is_some()
    }

    /// Shows the card from the first step, or hides it. Returns whether empty windows are to show it from now on.
    pub const fn toggle(&mut self) -> bool {
        self.done = if self.is_shown() { None } else { Some(0) };
        self.has_begun = true;
        self.is_shown()
    }

    /// Hides the card.
    pub const fn close(&mut self) {
        self.done = None;
    }

    /// Sees what was done since the last picture. `is_wanted`: a window that begins empty shows the card.
    pub fn take_in(&mut self, editor: &Editor, is_wanted: bool) {
        if !std::mem::replace(&mut self.has_begun, true) && is_wanted && steps_done(editor) == 0 {
            self.done = Some(0);
        }
        if let Some(done) = &mut self.done {
            *done = (*done).max(steps_done(editor).min(*done + 1));
        }
    }

    /// Shows the card at the top left of the 3D view.
    pub fn show(self, ui: &Ui, viewport: Rect, keymap: &Keymap, commands: &mut Vec<Command>) {
        let Some(done) = self.done else { return };
        let tokens = Tokens::of(ui);
        let words = Words::of(ui);
        let width = WIDTH.min(viewport.width() - 4.0 * GRID - 24.0);
        if width < 100.0 {
            return;
        }
        let steps = steps(keymap, words);
        Area::new(Id::unique("first steps"))
            .order(Order::Middle)
            .pivot(Align2::LEFT_TOP)
            .fixed_pos(viewport.left_top() + vec2(2.0, 2.0) * GRID)
            .fade_in(false)
            .show(ui.ctx(), |ui| {
                let frame =
                    Frame::new().fill(tokens.over_scene).corner_radius(CORNER).inner_margin(Margin::symmetric(12, 8));
                frame.show(ui, |ui| {
                    ui.set_width(width);
                    ui.spacing_mut().item_spacing.y = GRID;
                    let heading = ui.label(RichText::new(words.say(texts::TOUR_HEADING)).strong().color(tokens.text));
                    close(ui, heading.rect, width, commands);
                    let has_room = viewport.width() >= ROOM.x && viewport.height() >= ROOM.y;
                    for (index, text) in steps.iter().enumerate() {
                        if has_room || index == done {
                            step(ui, index, text, done);
                        }
                    }
                    if done == STEPS {
                        let key = key_or_title(keymap, &Command::File(FileCommand::Write), words);
                        ui.add(
                            Label::new(RichText::new(words.message(texts::tour_done(key))).color(tokens.text)).wrap(),
                        );
                    }
                });
            });
    }
}

/// How many steps an editor shows to be done, one after the other.
fn steps_done(editor: &Editor) -> usize {
    let document = editor.document();
    let count = document.keyframes.len();
    let is_posed = match document.keyframes.current_keyframe() {
        Some(keyframe) => !document.live_pose.same_as(&keyframe.pose),
        None => !document.live_pose.same_as(document.scene.rest_pose()),
    };
    let is_done = [
        count > 0 || is_posed,
        count > 0,
        count > 1 || (count == 1 && is_posed),
        count > 1,
        count > 3,
        count > 3 && editor.is_playing(),
    ];
    is_done.into_iter().take_while(|&is_done| is_done).count()
}

fn key_or_title(keymap: &Keymap, command: &Command, words: Words) -> String {
    let binding = binding_of(keymap.bindings(), command);
    let key = binding.map(Binding::menu_key).filter(|key| !key.is_empty());
    key.or_else(|| binding.map(|binding| words.say(binding.title()).to_owned())).unwrap_or_default()
}

fn steps(keymap: &Keymap, words: Words) -> [String; STEPS] {
    let create = key_or_title(keymap, &Command::Edit(Edit::CreateKeyframe), words);
    let play = key_or_title(keymap, &Command::Playback(PlaybackCommand::PlayOrStop), words);
    let steps: [Message; STEPS] = [
        texts::TOUR_POSE.into(),
        texts::tour_keep(&create),
        texts::TOUR_POSE_AGAIN.into(),
        texts::tour_keep_again(&create),
        texts::TOUR_TWICE_MORE.into(),
        texts::tour_play(&play),
    ];
    steps.map(|step| words.message(step))
}

fn step(ui: &mut Ui, index: usize, text: &str, done: usize) {
    let tokens = Tokens::of(ui);
    let colour = if index == done { tokens.text } else { tokens.dim };
    ui.horizontal_top(|ui| {
        let (mark, _) = ui.allocate_exact_size(vec2(16.0, 16.0), Sense::hover());
        if index < done {
            icons::paint(ui.painter(), Icon::Tick, mark.center(), tokens.accent);
        } else {
            let colour = if index == done { tokens.accent_text } else { tokens.dim };
            let font = super::theme::number_font();
            ui.painter().text(mark.center(), Align2::CENTER_CENTER, index + 1, font, colour);
        }
        let response = ui.add(Label::new(RichText::new(text).color(colour)).wrap());
        // Which step is at hand, for who does not see its colour.
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_selected(index == done));
    });
}

/// A cross that the keyboard does not come to: the menu hides the card as well.
fn close(ui: &Ui, heading: Rect, width: f32, commands: &mut Vec<Command>) {
    let tokens = Tokens::of(ui);
    let centre = egui::pos2(heading.left() + width - 6.0, heading.center().y);
    let area = Rect::from_center_size(centre, vec2(ROW, ROW));
    let response = ui.interact(area, Id::unique("close the first steps"), Sense::CLICK);
    let says = Words::of(ui).say(texts::CLOSE_THE_FIRST_STEPS);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, says));
    let stroke = Stroke::new(1.5, if response.hovered() { tokens.text } else { tokens.dim });
    for side in [1.0, -1.0] {
        let arm = vec2(4.0, 4.0 * side);
        ui.painter().line_segment([centre - arm, centre + arm], stroke);
    }
    if response.on_hover_text(says).clicked() {
        commands.push(Command::Window(WindowCommand::CloseTour));
    }
}
