//! The command list: typing filters it, arrows move in it, Enter runs a command. It finds commands by their names in the window's language
//! and in English and by their synonyms, choices with a value, and the scene's nodes.

use egui::{Align2, Key, Layout, Modifiers, Response, Role, ScrollArea, Sense, TextEdit, Ui, WidgetInfo, vec2};

use super::PanelInput;
use super::access;
use super::choices::choices;
use super::theme::{CORNER, GRID, Tokens, dialog_width, number_font, small_font, text_font};
use super::words::Words;
use crate::editor::{Command, ViewCommand};
use crate::words::texts;

/// Width of the list, in points.
const WIDTH: f32 = 520.0;
/// Height of a row, in points.
const LINE: f32 = 26.0;
/// How many rows show at once, where the window is high enough.
const ROWS: f32 = 12.0;
/// What of the window's height the rows leave to the field, the margins and the room around the list, in points.
const AROUND: f32 = 136.0;

/// The typed text and the current row.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Palette {
    typed: String,
    at: usize,
    has_begun: bool,
}

/// One row.
struct Entry {
    name: String,
    /// What else it is found by: the English name, and synonyms in both languages.
    others: Vec<String>,
    keys: String,
    group: String,
    command: Command,
    is_enabled: bool,
}

impl Palette {
    /// Shows the field and the list. Says whether it is over.
    pub fn show(&mut self, ui: &mut Ui, shown: PanelInput<'_>, commands: &mut Vec<Command>) -> bool {
        let width = dialog_width(ui, WIDTH);
        ui.set_width(width);
        let words = Words::of(ui);
        let entries = entries(shown, words, !self.typed.trim().is_empty());
        // The arrows and Enter are the list's, wherever the keyboard is.
        let (up, down, enter) = ui.input_mut(|input| {
            let mut pressed = |key| input.consume_key(Modifiers::NONE, key);
            (pressed(Key::ArrowUp), pressed(Key::ArrowDown), pressed(Key::Enter))
        });
        let hint = words.say(texts::TYPE_A_PART_OF_A_COMMANDS_NAME);
        let field = ui.add(TextEdit::singleline(&mut self.typed).desired_width(f32::INFINITY).hint_text(hint));
        field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, words.say(texts::COMMANDS)));
        if !std::mem::replace(&mut self.has_begun, true) {
            field.request_focus();
        }
        let has_moved = up || down || field.changed();
        if field.changed() {
            self.at = 0;
        }
        let found = found(&entries, &self.typed);
        let last = found.len().saturating_sub(1);
        self.at = match (up, down) {
            (true, false) => self.at.checked_sub(1).unwrap_or(last),
            (false, true) if self.at >= last => 0,
            (false, true) => self.at + 1,
            _ => self.at.min(last),
        };
        ui.add_space(GRID);
        let mut chosen = if enter { found.get(self.at).copied() } else { None };
        // As high whatever is found: nothing moves, and a long list never has to scroll in the room of a short one.
        let height = (ui.ctx().content_rect().height() - AROUND).clamp(3.0 * LINE, ROWS * LINE);
        ui.allocate_ui_with_layout(vec2(width, height), Layout::default(), |ui| {
            ui.set_min_height(height);
            if found.is_empty() {
                let text = words.message(texts::no_command_named(&self.typed));
                ui.label(egui::RichText::new(text).color(Tokens::of(ui).dim));
            }
            let rows = ScrollArea::vertical().min_scrolled_height(height).max_height(height).auto_shrink([false, true]);
            rows.show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 0.0;
                for (index, entry) in found.iter().enumerate() {
                    let response = row(ui, entry, index == self.at);
                    if has_moved && index == self.at {
                        response.scroll_to_me_animation(None, egui::style::ScrollAnimation::none());
                    }
                    if response.clicked() {
                        chosen = Some(entry);
                    }
                }
            });
        });
        let Some(chosen) = chosen.filter(|entry| entry.is_enabled) else { return false };
        commands.push(chosen.command.clone());
        true
    }
}

fn row(ui: &mut Ui, entry: &Entry, is_at: bool) -> Response {
    let tokens = Tokens::of(ui);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), LINE), Sense::click());
    access::item(&response, Role::ListBoxOption, entry.is_enabled, is_at, &entry.name);
    if !ui.is_rect_visible(rect) {
        return response;
    }
    if is_at {
        ui.painter().rect_filled(rect, CORNER, tokens.accent_fill);
    } else if response.hovered() {
        ui.painter().rect_filled(rect, CORNER, tokens.raised);
    }
    if response.has_focus() {
        ui.painter().rect_stroke(rect, CORNER, egui::Stroke::new(1.0, tokens.accent), egui::StrokeKind::Inside);
    }
    let fade = if entry.is_enabled { 1.0 } else { 0.5 };
    let name = rect.left_center() + vec2(8.0, 0.0);
    let drawn =
        ui.painter().text(name, Align2::LEFT_CENTER, &entry.name, text_font(), tokens.text.gamma_multiply(fade));
    let keys = rect.right_center() - vec2(8.0, 0.0);
    let keys =
        ui.painter().text(keys, Align2::RIGHT_CENTER, &entry.keys, number_font(), tokens.text.gamma_multiply(fade));
    let group = keys.left_center() - vec2(if entry.keys.is_empty() { 0.0 } else { 12.0 }, 0.0);
    let room = group.x - drawn.right() - 16.0;
    let galley = ui.painter().layout_no_wrap(entry.group.clone(), small_font(), tokens.dim.gamma_multiply(fade));
    if galley.size().x < room {
        ui.painter().galley(group - vec2(galley.size().x, galley.size().y / 2.0), galley, tokens.dim);
    }
    response
}

fn entries(shown: PanelInput<'_>, words: Words, has_typed: bool) -> Vec<Entry> {
    let PanelInput { editor, keymap, settings, .. } = shown;
    let rows = keymap.bindings().iter().map(|binding| {
        let synonyms = binding.synonyms().into_iter();
        let synonyms = synonyms.flat_map(|also| [words.say(also), also.english()]).flat_map(|also| also.split(','));
        Entry {
            name: words.say(binding.title()).to_owned(),
            others: std::iter::once(binding.title().english()).chain(synonyms).map(str::to_owned).collect(),
            keys: binding.menu_key(),
            group: words.say(binding.group.heading()).to_owned(),
            command: binding.command.clone(),
            is_enabled: editor.can(&binding.command),
        }
    });
    let english = choices(editor, settings, Words::default());
    let chosen = choices(editor, settings, words).into_iter().zip(english).map(|(choice, english)| Entry {
        name: format!("{}: {}", choice.topic.name(words), choice.label),
        others: vec![format!("{}: {}", english.topic.name(Words::default()), english.label)],
        keys: String::new(),
        group: String::new(),
        is_enabled: editor.can(&choice.command),
        command: choice.command,
    });
    let scene = editor.scene();
    let nodes = scene.rbt_indices().filter(|_| has_typed).map(|rbt| {
        let path = scene.rbt_path(rbt);
        let command = Command::View(ViewCommand::Choose(Some(rbt)));
        Entry {
            name: path.to_owned(),
            // As one says it: the last name first.
            others: vec![path.rsplit('/').collect::<Vec<_>>().join(" ")],
            keys: String::new(),
            group: words.say(texts::CHOOSE_THIS_NODE).to_owned(),
            is_enabled: editor.can(&command),
            command,
        }
    });
    rows.chain(chosen).chain(nodes).collect()
}

/// The entries that match the typed text, best match first; equal matches in the table's order. Synonyms come after names.
fn found<'a>(entries: &'a [Entry], typed: &str) -> Vec<&'a Entry> {
    let mut found: Vec<(u32, &Entry)> = entries
        .iter()
        .filter_map(|entry| {
            let others = entry.others.iter().filter_map(|other| Some(2 * misfit(other, typed)? + 1));
            let fits = misfit(&entry.name, typed).map(|misfit| 2 * misfit).into_iter().chain(others).min();
            Some((fits?, entry))
        })
        .collect();
    found.sort_by_key(|(misfit, _)| *misfit);
    found.into_iter().map(|(_, entry)| entry).collect()
}

/// The penalty of a match, 0 for the best; `None` for no match. The typed letters must occur in this order and without many gaps; spaces
/// are ignored, and what joins words in the names of nodes is a space.
fn misfit(name: &str, typed: &str) -> Option<u32> {
    let plain = |text: &str| text.trim().to_lowercase().replace(['_', '/'], " ");
    let (name, typed) = (plain(name), plain(typed));
    if typed.is_empty() || name == typed {
        return Some(0);
    }
    if let Some(at) = name.find(&typed) {
        let begins_word = name[..at].chars().next_back().is_none_or(|before| !before.is_alphanumeric());
        return Some(if at == 0 { 1 } else { 3 - u32::from(begins_word) });
    }
    let mut letters = name.chars();
    let (mut gaps, mut count) = (0, 0);
    for wanted in typed.chars().filter(|letter| !letter.is_whitespace()) {
        let skipped = letters.by_ref().position(|letter| letter == wanted)?;
        gaps += u32::from(skipped > 0);
        count += 1;
    }
    // With more gaps than that nearly every name has the letters.
    (2 * gaps <= count + 1).then_some(4 + gaps)
}

#[cfg(test)]
mod tests {
    use super::misfit;

    #[test]
    fn the_beginning_fits_best() {
        let fits = |name| misfit(name, "key");
        assert_eq!(fits("Key"), Some(0));
        assert_eq!(fits("Keys…"), Some(1));
        assert_eq!(fits("New keyframe"), Some(2));
        assert_eq!(fits("Monkey"), Some(3));
        assert!(fits("Kite every year") > Some(3));
        assert_eq!(fits("Save"), None);
    }

    #[test]
    fn letters_in_order_fit() {
        assert!(misfit("New keyframe", "nkf").is_some());
        assert!(misfit("New keyframe", "fkn").is_none());
        assert!(misfit("새 키프레임", "키프").is_some());
        assert!(misfit("Save As…", "save a").is_some());
        assert_eq!(misfit("robot1/right_shoulder/right_elbow", "right elbow"), Some(2));
        assert_eq!(misfit("Quit", "  "), Some(0));
        assert_eq!(misfit("Go to previous keyframe and", "grid"), None);
    }
}
