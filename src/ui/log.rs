//! Messages: toasts over the scene for results and errors, and the log of all messages.

use std::time::Duration;

use egui::{
    Align2, Area, Context, Frame, Id, Label, Margin, Order, Pos2, Rect, RichText, Role, ScrollArea, Sense, Stroke, Ui,
    WidgetInfo, vec2,
};

use super::icons::{Icon, paint, was_pressed};
use super::theme::{CORNER, GRID, Tokens};
use super::words::Words;
use crate::editor::{Command, Message, Said, Severity, WindowCommand};
use crate::words::texts;

/// How many messages are kept.
const MOST_ENTRIES: usize = 2000;
/// How many toasts show at once.
const MOST_TOASTS: usize = 4;
/// How long a result shows, in seconds.
const RESULT: f64 = 4.0;
/// How long an error shows, in seconds.
const ERROR: f64 = 10.0;
/// How long a toast takes to appear, in seconds.
const APPEARS: f64 = 0.1;
/// How long a toast takes to go, in seconds.
const GOES: f64 = 0.25;
/// Width of a toast, in points.
const WIDTH: f32 = 320.0;

/// One message.
#[derive(Clone, Debug, PartialEq)]
struct Entry {
    message: Message,
    /// When it was said, in seconds since the start.
    at: f64,
}

/// One toast.
#[derive(Clone, Debug, PartialEq)]
struct Toast {
    message: Message,
    /// Which of all toasts it is.
    number: u64,
    /// How often it was said in a row.
    count: u32,
    since: f64,
    until: f64,
    /// Whether the pointer is over it: what is being read stays, and nothing is drawn for that.
    is_read: bool,
}

/// What was said, and which of it still shows.
#[derive(Clone, Debug, Default)]
pub struct Log {
    entries: Vec<Entry>,
    toasts: Vec<Toast>,
    seen: u64,
    toasted: u64,
    /// The latest time heard of, in seconds since the start.
    latest: f64,
    /// What is added to the panels' clock, which begins anew where the window's device was lost.
    offset: f64,
    is_shown: bool,
}

impl Log {
    /// Shows or hides the list of all messages.
    pub const fn toggle(&mut self) {
        self.is_shown = !self.is_shown;
    }

    /// Whether the list of all messages shows.
    pub const fn is_shown(&self) -> bool {
        self.is_shown
    }

    /// Whether a message still shows as a toast.
    pub fn shows(&self, message: &Message) -> bool {
        self.toasts.iter().any(|toast| toast.message == *message)
    }

    /// Takes in what was said since the last time. `clock` is the panels', in seconds.
    pub fn take_in(&mut self, said: &Said, clock: f64) {
        if clock + self.offset < self.latest {
            self.offset = self.latest - clock;
        }
        self.latest = clock + self.offset;
        let now = self.latest;
        for message in said.after(self.seen) {
            self.entries.push(Entry { message: message.clone(), at: now });
            self.toast(message, now);
        }
        self.seen = said.count();
        let surplus = self.entries.len().saturating_sub(MOST_ENTRIES);
        self.entries.drain(..surplus);
    }

    fn toast(&mut self, message: &Message, now: f64) {
        let lasts = match message.severity() {
            Severity::Information => return,
            Severity::Outcome => RESULT,
            Severity::Error => ERROR,
        };
        if let Some(last) = self.toasts.last_mut().filter(|last| last.message == *message && now < last.until) {
            last.count += 1;
            last.until = now + lasts;
            return;
        }
        self.toasted += 1;
        let toast = Toast {
            message: message.clone(),
            number: self.toasted,
            count: 1,
            since: now,
            until: now + lasts,
            is_read: false,
        };
        self.toasts.push(toast);
        let surplus = self.toasts.len().saturating_sub(MOST_TOASTS);
        self.toasts.drain(..surplus);
    }

    /// Shows the toasts above the 3D view's bottom right corner.
    pub fn show_toasts(&mut self, ui: &Ui, viewport: Rect) {
        let now = self.latest;
        self.toasts.retain(|toast| toast.is_read || now < toast.until);
        let mut bottom = viewport.bottom() - 36.0;
        let mut dismissed = None;
        for toast in self.toasts.iter_mut().rev() {
            let corner = egui::pos2(viewport.right() - 8.0, bottom);
            let shown = show_toast(ui, toast, corner, now);
            if toast.is_read || shown.hovered() {
                toast.until = toast.until.max(now + 1.0);
            }
            toast.is_read = shown.hovered();
            if shown.clicked() {
                dismissed = Some(toast.number);
            }
            bottom = shown.rect.top() - 2.0 * GRID;
            if bottom < viewport.top() + 60.0 {
                break;
            }
        }
        self.toasts.retain(|toast| dismissed != Some(toast.number));
        if let Some(wait) = self.toasts.iter().filter_map(|toast| wait(toast, now)).min() {
            if wait.is_zero() {
                ui.ctx().request_repaint();
            } else {
                ui.ctx().request_repaint_after(wait);
            }
        }
    }

    /// Shows the list of all messages, where it is wanted.
    pub fn show_list(&self, context: &Context, viewport: Rect, commands: &mut Vec<Command>) {
        if !self.is_shown {
            return;
        }
        let words = Words::of_context(context);
        let mut is_open = true;
        egui::Window::new(words.say(texts::MESSAGES))
            .id(Id::unique("messages"))
            .open(&mut is_open)
            .collapsible(false)
            .fade_in(false)
            .fade_out(false)
            .default_size(vec2(480.0, 240.0))
            .default_pos(viewport.left_top() + vec2(16.0, 16.0))
            .constrain_to(viewport)
            .show(context, |ui| self.list(ui, words));
        if !is_open {
            commands.push(Command::Window(WindowCommand::ToggleMessages));
        }
    }

    fn list(&self, ui: &mut Ui, words: Words) {
        let tokens = Tokens::of(ui);
        ui.horizontal(|ui| {
            let can_copy = !self.entries.is_empty();
            if was_pressed(&ui.add_enabled(can_copy, egui::Button::new(words.say(texts::COPY_ALL)))) {
                ui.ctx().copy_text(self.text(words));
            }
            let hint = words.say(texts::MINUTES_AND_SECONDS_SINCE_THE_START);
            ui.label(RichText::new(hint).small().color(tokens.dim));
        });
        ui.separator();
        if self.entries.is_empty() {
            ui.label(RichText::new(words.say(texts::NOTHING_WAS_SAID_YET)).color(tokens.dim));
        }
        let line = 18.0;
        ScrollArea::both().auto_shrink(false).stick_to_bottom(true).show_rows(
            ui,
            line,
            self.entries.len(),
            |ui, seen| {
                for entry in &self.entries[seen] {
                    ui.horizontal(|ui| {
                        ui.set_height(line);
                        ui.label(RichText::new(time_text(entry.at)).monospace().color(tokens.dim));
                        let text = RichText::new(words.message(&entry.message))
                            .color(colour(entry.message.severity(), tokens));
                        ui.add(Label::new(text).selectable(true).extend());
                    });
                }
            },
        );
    }

    fn text(&self, words: Words) -> String {
        let line = |entry: &Entry| format!("{}  {}\n", time_text(entry.at), words.message(&entry.message));
        self.entries.iter().map(line).collect()
    }
}

/// How long a toast looks the same; `None` while it is read.
fn wait(toast: &Toast, now: f64) -> Option<Duration> {
    let goes = toast.until - GOES;
    if now < toast.since + APPEARS {
        return Some(Duration::ZERO);
    }
    let waits = if now >= goes { Duration::ZERO } else { Duration::from_secs_f64((goes - now).max(0.001)) };
    (!toast.is_read).then_some(waits)
}

fn show_toast(ui: &Ui, toast: &Toast, corner: Pos2, now: f64) -> egui::Response {
    let tokens = Tokens::of(ui);
    let words = Words::of(ui);
    let mut text = words.message(&toast.message);
    if toast.count > 1 {
        text = format!("{text} (×{})", toast.count);
    }
    let appears = ((now - toast.since) / APPEARS + 0.4).clamp(0.0, 1.0);
    let goes = ((toast.until - now) / GOES).clamp(0.0, 1.0);
    let (icon, colour) = match toast.message.severity() {
        Severity::Error => (Icon::Warning, tokens.error),
        _ => (Icon::Tick, tokens.information),
    };
    Area::new(Id::unique(("toast", toast.number)))
        .order(Order::Foreground)
        .pivot(Align2::RIGHT_BOTTOM)
        .fixed_pos(corner)
        .fade_in(false)
        .sense(Sense::click())
        .show(ui.ctx(), |ui| {
            ui.set_opacity((appears * goes) as f32);
            Frame::new()
                .fill(tokens.panel)
                .stroke(Stroke::new(1.0, tokens.line))
                .corner_radius(CORNER)
                .inner_margin(Margin { left: 10, right: 14, top: 8, bottom: 8 })
                .show(ui, |ui| {
                    ui.spacing_mut().item_spacing.x = 2.0 * GRID;
                    ui.horizontal_top(|ui| {
                        let (rect, response) = ui.allocate_exact_size(vec2(16.0, 16.0), Sense::hover());
                        response.widget_info(|| WidgetInfo::labeled(Role::Alert, true, &text));
                        paint(ui.painter(), icon, rect.center(), colour);
                        // The text is laid out first, so that the toast is as wide as it needs and no wider.
                        let font = egui::FontId::proportional(12.0);
                        let galley = ui.painter().layout(text.clone(), font, tokens.text, WIDTH);
                        let (rect, response) = ui.allocate_exact_size(galley.size(), Sense::hover());
                        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &text));
                        ui.painter().galley(rect.left_top(), galley, tokens.text);
                    });
                });
        })
        .response
}

const fn colour(severity: Severity, tokens: &Tokens) -> egui::Color32 {
    match severity {
        Severity::Information => tokens.text,
        Severity::Outcome => tokens.information,
        Severity::Error => tokens.error,
    }
}

fn time_text(seconds: f64) -> String {
    let tenths = (seconds * 10.0).floor().max(0.0) as u64;
    format!("{:>2}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_minutes_and_seconds() {
        assert_eq!(time_text(0.0), " 0:00.0");
        assert_eq!(time_text(61.29), " 1:01.2");
        assert_eq!(time_text(3600.0), "60:00.0");
    }

    #[test]
    fn a_toast_wakes_the_window_only_while_it_changes() {
        let message = texts::foreign("Wrote it.").with_severity(Severity::Outcome);
        let toast = Toast { message, number: 1, count: 1, since: 10.0, until: 14.0, is_read: false };
        assert_eq!(wait(&toast, 10.05), Some(Duration::ZERO));
        assert!((wait(&toast, 10.2).unwrap().as_secs_f64() - 3.55).abs() < 1e-9);
        assert_eq!(wait(&toast, 13.8), Some(Duration::ZERO));
        let read = Toast { is_read: true, ..toast };
        assert_eq!((wait(&read, 10.05), wait(&read, 10.2), wait(&read, 13.8)), (Some(Duration::ZERO), None, None));
    }
}
