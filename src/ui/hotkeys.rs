//! The dialog that lists and changes hotkeys.

use egui::{Align, Button, Event, Layout, RichText, ScrollArea, Ui, vec2};

use super::PanelInput;
use super::icons::{Icon, paint, was_pressed};
use super::theme::{GRID, ROW, Tokens, dialog_width, text_font};
use super::words::Words;
use crate::editor::keymap::{Binding, Chord, Group, Key, Modifiers, NAMED_KEYS, can_change, chords_of_table};
use crate::editor::{Command, WindowCommand};
use crate::words::texts;

/// Width of the dialog, in points.
const WIDTH: f32 = 560.0;
/// Width of the names, in points.
const NAMES: f32 = 220.0;

/// The state of the dialog.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct HotkeysDialog {
    /// The id of the binding and the index of its hotkey that wait for a press.
    waiting: Option<(&'static str, usize)>,
    /// Why the last press was refused.
    refused: Option<String>,
}

/// Whether the dialog stays open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DialogState {
    /// It stays.
    Stays,
    /// It stays open: Escape ended the wait for a press.
    TookEscape,
    /// It is over.
    IsOver,
}

impl HotkeysDialog {
    /// Shows it.
    pub fn show(&mut self, ui: &mut Ui, shown: PanelInput<'_>, commands: &mut Vec<Command>) -> DialogState {
        let words = Words::of(ui);
        ui.set_width(dialog_width(ui, WIDTH));
        let mut outcome = DialogState::Stays;
        if let Some((id, index)) = self.waiting {
            match press(ui) {
                Some(Pressed::Nothing) => {
                    self.waiting = None;
                    outcome = DialogState::TookEscape;
                }
                Some(Pressed::Removes) => self.change(shown, id, index, None, words, commands),
                Some(Pressed::Chord(chord)) => self.change(shown, id, index, Some(chord), words, commands),
                None => {}
            }
        }
        ui.heading(words.say(texts::KEYS));
        ui.add_space(2.0);
        let hint = words.say(texts::CLICK_A_KEY_THEN_PRESS_ANOTHER_ESC);
        ui.label(RichText::new(hint).small().color(Tokens::of(ui).dim));
        ui.add_space(2.0 * GRID);
        let room = (ui.ctx().content_rect().height() - 260.0).clamp(120.0, 420.0);
        ScrollArea::vertical().max_height(room).auto_shrink(false).show(ui, |ui| {
            for group in Group::ALL {
                ui.add_space(GRID);
                ui.label(RichText::new(words.say(group.heading())).strong().color(Tokens::of(ui).accent_text));
                for binding in shown.keymap.bindings().iter().filter(|binding| binding.group == group) {
                    self.row(ui, binding, words, commands);
                }
            }
        });
        ui.add_space(2.0 * GRID);
        // Reserve the space for the message, so that nothing moves when it appears.
        let refused = self.refused.clone().unwrap_or_default();
        ui.add_sized(
            vec2(dialog_width(ui, WIDTH), ROW),
            egui::Label::new(RichText::new(refused).color(Tokens::of(ui).error)).halign(Align::Min).truncate(),
        );
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui.button(words.say(texts::CLOSE)).clicked() {
                outcome = DialogState::IsOver;
            }
            let is_changed = !shown.keymap.changes().is_empty();
            if ui.add_enabled(is_changed, Button::new(words.say(texts::RESET_ALL))).clicked() {
                self.begin(None);
                commands.push(Command::Window(WindowCommand::ResetAllHotkeys));
            }
        });
        outcome
    }

    fn row(&mut self, ui: &mut Ui, binding: &Binding, words: Words, commands: &mut Vec<Command>) {
        let name = words.say(binding.title());
        let room = NAMES.min(dialog_width(ui, WIDTH) / 2.0);
        ui.horizontal(|ui| {
            ui.set_height(ROW + 2.0);
            let (rect, label) = ui.allocate_exact_size(vec2(room, ROW), egui::Sense::hover());
            label.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, name));
            let at = rect.left_center() + vec2(8.0, 0.0);
            ui.painter().with_clip_rect(rect.intersect(ui.clip_rect())).text(
                at,
                egui::Align2::LEFT_CENTER,
                name,
                text_font(),
                Tokens::of(ui).text,
            );
            label.on_hover_text(words.say(binding.explanation()));
            let is_fixed = !can_change(binding);
            for (index, chord) in binding.chords.iter().enumerate() {
                self.cap(ui, binding, index, &chord.label(), is_fixed, words);
            }
            let next = binding.chords.len();
            if !is_fixed {
                self.cap(ui, binding, next, "", false, words);
            }
            if !is_fixed && binding.chords != chords_of_table(binding.id) {
                let reset = ui.button(RichText::new(words.say(texts::RESET)).small());
                let says = words.message(texts::reset_keys_of(name));
                reset.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &says));
                if was_pressed(&reset) {
                    self.begin(None);
                    commands.push(Command::Window(WindowCommand::ResetHotkeys(binding.id)));
                }
            }
        });
    }

    /// Draws one hotkey as a key cap, or the cap that adds one.
    fn cap(&mut self, ui: &mut Ui, binding: &Binding, index: usize, label: &str, is_fixed: bool, words: Words) {
        let tokens = Tokens::of(ui);
        let is_waiting = self.waiting == Some((binding.id, index));
        let text = if is_waiting {
            RichText::new(words.say(texts::PRESS_A_KEY)).color(tokens.accent_text)
        } else {
            RichText::new(label).monospace()
        };
        let is_more = index == binding.chords.len();
        let mut button = Button::new(text).min_size(vec2(ROW, ROW)).frame_when_inactive(!is_more);
        if is_waiting {
            button = button.stroke(egui::Stroke::new(1.0, tokens.accent));
        }
        let response = ui.add_enabled(!is_fixed, button);
        if is_more && !is_waiting {
            paint(ui.painter(), Icon::More, response.rect.center(), tokens.dim);
        }
        let name = words.say(binding.title());
        let says = if is_more {
            words.message(texts::one_more_key_of(name))
        } else {
            words.message(texts::change_key_of(name, label))
        };
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, !is_fixed, &says));
        if response.clicked() {
            // The next press is not for the button.
            response.surrender_focus();
            self.begin(Some((binding.id, index)));
        }
    }

    fn begin(&mut self, waiting: Option<(&'static str, usize)>) {
        self.waiting = waiting;
        self.refused = None;
    }

    fn change(
        &mut self,
        shown: PanelInput<'_>,
        id: &'static str,
        index: usize,
        chord: Option<Chord>,
        words: Words,
        commands: &mut Vec<Command>,
    ) {
        self.begin(None);
        let mut chords = shown.keymap.get(id).map(|binding| binding.chords.clone()).unwrap_or_default();
        if index < chords.len() {
            chords.remove(index);
        }
        if let Some(chord) = chord.filter(|chord| !chords.contains(chord)) {
            chords.insert(index.min(chords.len()), chord);
        }
        match shown.keymap.clash(id, &chords) {
            Some(error) => self.refused = Some(words.message(error.message())),
            None => commands.push(Command::Window(WindowCommand::SetHotkeys(id, chords))),
        }
    }
}

/// What a press does to the hotkey that waits for it.
enum Pressed {
    /// Leave it as it is.
    Nothing,
    /// Take it away.
    Removes,
    /// Make it this.
    Chord(Chord),
}

/// Takes the keyboard's events and says what they mean.
fn press(ui: &Ui) -> Option<Pressed> {
    let events = ui.input_mut(|input| {
        let (keyboard, others): (Vec<Event>, Vec<Event>) = std::mem::take(&mut input.events)
            .into_iter()
            .partition(|event| matches!(event, Event::Key { .. } | Event::Text(_)));
        input.events = others;
        keyboard
    });
    // Signs are matched by the character that the layout types.
    let typed = events.iter().find_map(|event| match event {
        Event::Text(text) => text.chars().next().filter(|sign| !sign.is_alphanumeric() && !sign.is_whitespace()),
        _ => None,
    });
    events.iter().find_map(|event| match event {
        Event::Key { key: egui::Key::Escape, pressed: true, .. } => Some(Pressed::Nothing),
        Event::Key { key: egui::Key::Backspace, pressed: true, .. } => Some(Pressed::Removes),
        Event::Key { key, pressed: true, modifiers, .. } => {
            let modifiers =
                Modifiers { shift: modifiers.shift, ctrl: modifiers.ctrl || modifiers.command, alt: modifiers.alt };
            chord(*key, typed, modifiers).map(Pressed::Chord)
        }
        _ => None,
    })
}

fn chord(key: egui::Key, typed: Option<char>, modifiers: Modifiers) -> Option<Chord> {
    if let Some(sign) = typed.filter(|_| !modifiers.ctrl && !modifiers.alt) {
        return Some(Chord { key: Key::Character(sign), modifiers: Modifiers { shift: false, ..modifiers } });
    }
    let named = NAMED_KEYS.iter().find(|(_, name)| name.eq_ignore_ascii_case(key.name())).map(|(key, _)| *key);
    let one = |name: &str| {
        let mut characters = name.chars();
        characters.next().filter(|_| characters.next().is_none()).map(Key::typing)
    };
    // Show the sign that is printed on the key.
    let minus = (key == egui::Key::Minus).then_some(Key::Character('-'));
    let key = named.or(minus).or_else(|| one(key.name())).or_else(|| one(key.symbol_or_name()))?;
    Some(Chord { key, modifiers })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(key: egui::Key, typed: Option<char>, held: &str, expected: Option<&str>) {
        let modifiers = Chord::parse(&format!("{held}x")).unwrap().modifiers;
        assert_eq!(chord(key, typed, modifiers).map(|chord| chord.label()).as_deref(), expected, "{key:?}");
    }

    #[test]
    fn presses_are_chords() {
        check(egui::Key::N, None, "", Some("n"));
        check(egui::Key::N, None, "Ctrl+Shift+", Some("Ctrl+Shift+N"));
        check(egui::Key::Comma, Some('<'), "Shift+", Some("<"));
        check(egui::Key::Plus, None, "Ctrl+", Some("Ctrl++"));
        check(egui::Key::Minus, None, "Ctrl+", Some("Ctrl+-"));
        check(egui::Key::Num0, None, "Alt+", Some("Alt+0"));
        check(egui::Key::F5, None, "", Some("F5"));
        check(egui::Key::ArrowLeft, None, "Alt+", Some("Alt+Left"));
        check(egui::Key::PageUp, None, "", Some("PageUp"));
        check(egui::Key::Tab, None, "", None);
    }
}
