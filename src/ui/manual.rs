//! The manual in the window: the list of pages at the left, a page at the right, links between pages.
//!
//! While it is open it has the keyboard: arrows up and down, Page Up and Down, Space, Home and End scroll; left and right turn pages; Esc
//! closes it.

mod blocks;

use egui::{Align, Frame, Id, Key, Layout, Margin, Modal, Modifiers, RichText, ScrollArea, Ui, vec2};

use super::icons::was_pressed;
use super::theme::{CORNER, GRID, ROW, Tokens, text_font};
use super::words::Words;
use crate::manual::{Link, Page, Part, contents, page};
use crate::words::texts;

/// Width of the list of pages, in points.
const LIST: f32 = 200.0;
/// Largest width of a page: longer lines are hard to read. In points.
const PAGE: f32 = 760.0;
/// How far an arrow key scrolls, in points.
const STEP: f32 = 48.0;

/// Where a page is to be scrolled to.
#[derive(Clone, Debug, PartialEq)]
enum Target {
    /// To this many points below its start.
    Offset(f32),
    /// To the heading with this anchor.
    Anchor(String),
}

/// The page that is shown, and how one came to it. It is kept while the manual is closed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Manual {
    is_open: bool,
    contents: Vec<Part>,
    page: Option<Page>,
    /// The pages that links led away from, and how far each was scrolled, in points.
    left: Vec<(String, f32)>,
    /// How far the page is scrolled, in points.
    offset: f32,
    /// Height of the part of the page that is seen, in points.
    seen: f32,
    /// How far the page can be scrolled, in points.
    end: f32,
    target: Option<Target>,
}

impl Manual {
    /// Whether it is shown.
    pub const fn is_open(&self) -> bool {
        self.is_open
    }

    /// Shows the page that was shown last, at first the first one.
    pub fn open(&mut self) {
        self.is_open = true;
        self.target = Some(Target::Offset(self.offset));
        if self.page.is_none() {
            self.contents = contents();
            let first = self.names().next().map(str::to_owned);
            self.page = first.and_then(|name| page(&name));
        }
    }

    fn names(&self) -> impl Iterator<Item = &str> {
        self.contents.iter().flat_map(|part| &part.pages).map(|entry| entry.name.as_str())
    }

    /// Shows it, if it is open.
    pub fn show(&mut self, ui: &Ui) {
        if !self.is_open {
            return;
        }
        self.take_keys(ui);
        let room = ui.ctx().content_rect().size() - vec2(64.0, 64.0);
        let size = vec2(room.x.min(LIST + PAGE + 48.0), room.y);
        let frame = Frame::popup(ui.style()).inner_margin(Margin::same(12)).corner_radius(2 * CORNER);
        let modal = Modal::new(Id::unique("manual")).backdrop_color(Tokens::of(ui).shade).frame(frame);
        let response = modal.show(ui.ctx(), |ui| {
            ui.set_min_size(size - vec2(24.0, 24.0));
            ui.set_max_size(size - vec2(24.0, 24.0));
            self.bar(ui);
            ui.separator();
            ui.horizontal_top(|ui| {
                ui.allocate_ui_with_layout(vec2(LIST, ui.available_height()), Layout::top_down(Align::Min), |ui| {
                    self.list(ui);
                });
                ui.separator();
                ui.vertical(|ui| self.page(ui));
            });
        });
        if response.backdrop_response.clicked() {
            self.is_open = false;
        }
    }

    fn take_keys(&mut self, ui: &Ui) {
        let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        let whole = (self.seen - STEP).max(STEP);
        let steps = [
            (Key::ArrowDown, self.offset + STEP),
            (Key::ArrowUp, self.offset - STEP),
            (Key::PageDown, self.offset + whole),
            (Key::Space, self.offset + whole),
            (Key::PageUp, self.offset - whole),
            (Key::Home, 0.0),
            (Key::End, self.end),
        ];
        for (key, offset) in steps {
            if pressed(key) {
                self.target = Some(Target::Offset(offset.clamp(0.0, self.end)));
            }
        }
        for (key, step) in [(Key::ArrowLeft, -1), (Key::ArrowRight, 1)] {
            if pressed(key) {
                self.turn(step);
            }
        }
        if pressed(Key::Backspace) {
            self.go_back();
        }
        // Not F1: egui is told of the press that opens it, too.
        if pressed(Key::Escape) {
            self.is_open = false;
        }
    }

    /// Turns `by` pages forward in the table of contents, if there is such a page.
    fn turn(&mut self, step: isize) {
        let at = self.page.as_ref().and_then(|page| self.names().position(|name| name == page.name));
        let to = at.and_then(|at| at.checked_add_signed(step)).and_then(|to| self.names().nth(to)).map(str::to_owned);
        if let Some(name) = to {
            self.go_to(&name, None);
        }
    }

    fn go_to(&mut self, name: &str, anchor: Option<String>) {
        let Some(next) = page(name) else { return };
        if let Some(page) = self.page.replace(next).filter(|page| page.name != name || anchor.is_some()) {
            self.left.push((page.name.to_owned(), self.offset));
        }
        self.target = Some(anchor.map_or(Target::Offset(0.0), Target::Anchor));
    }

    fn go_back(&mut self) {
        if let Some((name, offset)) = self.left.pop() {
            self.page = page(&name);
            self.target = Some(Target::Offset(offset));
        }
    }

    fn bar(&mut self, ui: &mut Ui) {
        let words = Words::of(ui);
        ui.horizontal(|ui| {
            ui.set_height(ROW);
            ui.heading(words.say(texts::COMMAND_MANUAL));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                if was_pressed(&ui.button(words.say(texts::CLOSE))) {
                    self.is_open = false;
                }
                let back = egui::Button::new(words.say(texts::MANUAL_BACK));
                if was_pressed(&ui.add_enabled(!self.left.is_empty(), back)) {
                    self.go_back();
                }
            });
        });
    }

    fn list(&mut self, ui: &mut Ui) {
        let mut chosen = None;
        ScrollArea::vertical().id_salt("pages").auto_shrink(false).show(ui, |ui| {
            for part in &self.contents {
                ui.add_space(GRID);
                ui.label(RichText::new(&part.title).small().color(Tokens::of(ui).dim));
                for entry in &part.pages {
                    let is_shown = self.page.as_ref().is_some_and(|page| page.name == entry.name);
                    let title = RichText::new(&entry.title).font(text_font());
                    let button = egui::Button::selectable(is_shown, title).min_size(vec2(LIST - 16.0, ROW));
                    if was_pressed(&ui.add(button)) {
                        chosen = Some(entry.name.clone());
                    }
                }
            }
        });
        if let Some(name) = chosen {
            self.go_to(&name, None);
        }
    }

    fn page(&mut self, ui: &mut Ui) {
        let Some(page) = &self.page else { return };
        let target = self.target.take();
        let mut area = ScrollArea::vertical().id_salt("page").auto_shrink(false);
        if let Some(Target::Offset(offset)) = target {
            area = area.vertical_scroll_offset(offset);
        }
        let anchor = match &target {
            Some(Target::Anchor(anchor)) => Some(anchor.as_str()),
            _ => None,
        };
        let output = area.show(ui, |ui| {
            // Room for the bar at the right.
            ui.set_width((ui.available_width() - 16.0).min(PAGE));
            blocks::show(ui, &page.blocks, anchor)
        });
        self.offset = output.state.clamped_offset().y;
        self.seen = output.inner_rect.height();
        self.end = (output.content_size.y - self.seen).max(0.0);
        if let Some(Link::Page { name, anchor }) = output.inner {
            let name = if name.is_empty() { page.name.to_owned() } else { name };
            self.go_to(&name, anchor);
        }
    }
}
