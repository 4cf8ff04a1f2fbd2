//! A dialog for a path, where the system has none: a field, the folder that it names, and places. Typing narrows the list, Tab completes,
//! arrows move in the list, Enter opens what is marked.

use std::path::{Component, MAIN_SEPARATOR, Path, PathBuf};

use egui::{
    Align, Align2, Key, Layout, Modifiers, Response, RichText, Role, ScrollArea, Sense, Stroke, TextEdit, Ui,
    WidgetInfo, vec2,
};

use super::access;
use super::dialogs::{Dialog, default_button};
use super::export::ExportDialog;
use super::icons::{self, Icon};
use super::theme::{CORNER, GRID, ROW, Tokens, dialog_width, text_font};
use super::words::Words;
use super::{PathPurpose, UiOutput};
use crate::settings::Settings;
use crate::words::{Message, texts};

/// Width of the dialog, in points.
const WIDTH: f32 = 560.0;
/// Width of the list of places, in points.
const PLACES: f32 = 148.0;
/// How many rows of the folder show at once, where the window is high enough.
const ROWS: f32 = 10.0;
/// What of the window's height the list leaves to the rest of the dialog, in points.
const AROUND: f32 = 220.0;
/// How many folders of recent files are places.
const MOST_RECENT: usize = 5;

/// What is in a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FolderEntry {
    /// Its name.
    pub name: String,
    /// Whether it is a folder.
    pub is_folder: bool,
}

/// A folder as it was read, or why it cannot be.
#[derive(Clone, Debug, PartialEq)]
pub struct Listing {
    /// The folder, as it was asked for.
    pub folder: PathBuf,
    /// What is in it, in any order.
    pub entries: Result<Vec<FolderEntry>, Message>,
    /// The user's own folder, if there is one.
    pub home: Option<PathBuf>,
}

/// The dialog.
#[derive(Clone, Debug, PartialEq)]
pub struct PathDialog {
    purpose: PathPurpose,
    /// The dialog that the path is for, which comes back afterwards.
    export: Option<Box<ExportDialog>>,
    /// What is in the field.
    typed: String,
    /// The row that the arrows have marked.
    at: Option<usize>,
    /// Whether it was marked since the last picture.
    has_moved: bool,
    listing: Option<Listing>,
    /// Whether the field still has to be given the keyboard.
    is_new: bool,
    /// Whether the text cursor is to stand at the field's end.
    to_end: bool,
}

impl PathDialog {
    /// Asks for a path, and proposes one.
    pub fn new(purpose: PathPurpose, proposed: &Path) -> Self {
        let typed = proposed.to_string_lossy().into_owned();
        Self { purpose, export: None, typed, at: None, has_moved: false, listing: None, is_new: true, to_end: false }
    }

    /// The same question, asked by the export dialog.
    pub fn for_export(self, export: Box<ExportDialog>) -> Self {
        Self { export: Some(export), ..self }
    }

    /// The dialog that comes back when this one is over.
    pub fn after(self) -> Option<Dialog> {
        self.export.map(Dialog::Export)
    }

    /// The folder whose contents are shown, if it has to be read.
    pub fn wanted_folder(&self) -> Option<PathBuf> {
        let folder = self.folder();
        self.listing.as_ref().is_none_or(|listing| listing.folder != folder).then_some(folder)
    }

    /// Takes in what is in a folder: folders first, both by name.
    pub fn put(&mut self, mut listing: Listing) {
        if let Ok(entries) = &mut listing.entries {
            entries.sort_by_cached_key(|entry| (!entry.is_folder, entry.name.to_lowercase()));
        }
        self.listing = Some(listing);
    }

    /// The folder part of what is typed; `.` where that is a name alone.
    fn folder(&self) -> PathBuf {
        let folder = &self.typed[..self.name_begins()];
        PathBuf::from(if folder.is_empty() { "." } else { folder })
    }

    /// Where the last name of what is typed begins.
    fn name_begins(&self) -> usize {
        self.typed.rfind(['/', MAIN_SEPARATOR]).map_or(0, |at| at + 1)
    }

    fn name(&self) -> &str {
        &self.typed[self.name_begins()..]
    }

    /// What of the folder is shown: folders, and files that the purpose can read. The typed name narrows it when a file is to be opened;
    /// names that begin with a point are shown where one is typed.
    fn shown(&self) -> Vec<FolderEntry> {
        let Some(Listing { entries: Ok(entries), .. }) = &self.listing else { return Vec::new() };
        let name = self.name().to_lowercase();
        let is_whole = entries.iter().any(|entry| entry.name == self.name());
        let is_saving = self.purpose.is_saving();
        let fits = |entry: &&FolderEntry| {
            let lower = entry.name.to_lowercase();
            let is_hidden = lower.starts_with('.') && !name.starts_with('.');
            let is_wanted = is_saving || is_whole || lower.starts_with(&name);
            !is_hidden && is_wanted && (entry.is_folder || self.purpose.fits(&entry.name))
        };
        entries.iter().filter(fits).cloned().collect()
    }

    /// What Tab makes of the typed name: as much as all entries that begin so have in common; after a folder, its separator.
    fn completed(&self) -> Option<String> {
        let Some(Listing { entries: Ok(entries), .. }) = &self.listing else { return None };
        let fitting = |entry: &&FolderEntry| {
            entry.name.starts_with(self.name()) && (entry.is_folder || self.purpose.fits(&entry.name))
        };
        let mut fitting = entries.iter().filter(fitting);
        let first = fitting.next()?;
        let (mut common, mut is_one) = (first.name.as_str(), true);
        for other in fitting {
            let same = common.char_indices().zip(other.name.chars()).take_while(|((_, one), other)| one == other);
            let end = same.last().map_or(0, |((at, letter), _)| at + letter.len_utf8());
            (common, is_one) = (&common[..end], false);
        }
        let end = if is_one && first.is_folder { "/" } else { "" };
        let completed = format!("{}{common}{end}", &self.typed[..self.name_begins()]);
        (completed.len() > self.typed.len()).then_some(completed)
    }

    /// Goes to an entry: into a folder, or to a file's name.
    fn take(&mut self, entry: &FolderEntry) {
        let end = if entry.is_folder { "/" } else { "" };
        self.set(format!("{}{}{end}", &self.typed[..self.name_begins()], entry.name));
    }

    fn set(&mut self, typed: String) {
        self.typed = typed;
        self.at = None;
        self.to_end = true;
    }

    /// Goes to a folder. A name that is to be saved stays.
    fn go_to(&mut self, folder: &Path) {
        let name = if self.purpose.is_saving() { self.name().to_owned() } else { String::new() };
        let folder = folder.to_string_lossy();
        let end = if folder.ends_with(['/', MAIN_SEPARATOR]) { "" } else { "/" };
        self.set(format!("{folder}{end}{name}"));
    }

    /// Shows it. Says whether it is over.
    pub(super) fn show(&mut self, ui: &mut Ui, settings: &Settings, output: &mut UiOutput) -> bool {
        ui.set_width(dialog_width(ui, WIDTH));
        let words = Words::of(ui);
        let (heading, verb) = self.purpose.words();
        ui.heading(words.say(heading));
        ui.add_space(2.0 * GRID);
        let shown = self.shown();
        let goes_in = self.take_keys(ui, &shown);
        self.field(ui);
        ui.add_space(GRID);
        let height = (ui.ctx().content_rect().height() - AROUND).clamp(3.0 * ROW, ROWS * ROW);
        let mut is_confirmed = false;
        let whole = vec2(ui.available_width(), height);
        ui.allocate_ui_with_layout(whole, Layout::left_to_right(Align::Min), |ui| {
            ui.allocate_ui_with_layout(vec2(PLACES, height), Layout::top_down_justified(Align::Min), |ui| {
                self.places(ui, settings, height);
            });
            ui.separator();
            let size = vec2(ui.available_width(), height);
            ui.allocate_ui_with_layout(size, Layout::top_down(Align::Min), |ui| {
                is_confirmed = self.list(ui, &shown, height);
            });
        });
        ui.add_space(3.0 * GRID);
        let needed = if self.purpose.is_folder() { &self.typed } else { self.name() };
        let can = !needed.trim().is_empty();
        let mut is_cancelled = false;
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let is_pressed = default_button(ui, words.say(verb), can);
            is_confirmed |= is_pressed && !goes_in;
            is_cancelled = ui.button(words.say(texts::CANCEL)).clicked();
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                ui.label(RichText::new(words.say(texts::TAB_COMPLETES)).small().color(Tokens::of(ui).dim));
            });
        });
        if is_confirmed {
            let path = PathBuf::from(self.typed.trim());
            if let Some(export) = &mut self.export {
                export.choose(&path);
            }
            output.commands.extend(self.purpose.command(path));
        }
        is_confirmed || is_cancelled
    }

    /// Arrows, Tab and Enter. Says whether Enter leads into a folder, so that it answers nothing yet.
    fn take_keys(&mut self, ui: &Ui, shown: &[FolderEntry]) -> bool {
        let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        let last = shown.len().checked_sub(1);
        let (down, up) = (pressed(Key::ArrowDown), pressed(Key::ArrowUp));
        self.has_moved = down || up;
        if down {
            self.at = last.map(|last| self.at.map_or(0, |at| (at + 1).min(last)));
        }
        if up {
            self.at = self.at.and_then(|at| at.checked_sub(1));
        }
        if self.completed().is_some()
            && pressed(Key::Tab)
            && let Some(completed) = self.completed()
        {
            self.set(completed);
        }
        if !ui.input(|input| input.key_pressed(Key::Enter)) {
            return false;
        }
        let marked = self.at.and_then(|at| shown.get(at)).cloned();
        let named = || shown.iter().find(|entry| entry.is_folder && entry.name == self.name()).cloned();
        let Some(entry) = marked.or_else(named) else { return false };
        self.take(&entry);
        self.is_new |= entry.is_folder;
        entry.is_folder
    }

    fn field(&mut self, ui: &mut Ui) {
        let hint = self.purpose.hint();
        let says = Words::of(ui).say(texts::PATH_OF_THE_FILE);
        let can_complete = self.completed().is_some();
        let edit = TextEdit::singleline(&mut self.typed).desired_width(f32::INFINITY).hint_text(hint);
        let mut shown = edit.lock_focus(can_complete).show(ui);
        let field = &shown.response.response;
        field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, says));
        if field.changed() {
            self.at = None;
        }
        if std::mem::take(&mut self.is_new) {
            field.request_focus();
            self.to_end = true;
        }
        if std::mem::take(&mut self.to_end) {
            let end = egui::text::CCursor::new(self.typed.chars().count());
            shown.state.cursor.set_char_range(Some(egui::text::CCursorRange::one(end)));
            shown.state.store(ui.ctx(), field.id);
        }
    }

    /// The folder above, the user's own, and those of recent files.
    fn places(&mut self, ui: &mut Ui, settings: &Settings, height: f32) {
        let words = Words::of(ui);
        let mut places = vec![(Icon::FolderAbove, words.say(texts::FOLDER_ABOVE).to_owned(), above(&self.folder()))];
        if let Some(home) = self.listing.as_ref().and_then(|listing| listing.home.clone()) {
            places.push((Icon::Home, words.say(texts::HOME_FOLDER).to_owned(), home));
        }
        for folder in settings.recent.iter().filter_map(|file| file.parent()) {
            if places.len() < MOST_RECENT + 2 && places.iter().all(|(_, _, place)| place != folder) {
                let name = folder.file_name().unwrap_or(folder.as_os_str()).to_string_lossy().into_owned();
                places.push((Icon::Folder, name, folder.to_owned()));
            }
        }
        ScrollArea::vertical().id_salt("places").max_height(height).min_scrolled_height(height).show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            for (icon, name, place) in places {
                let response = row(ui, icon, &name, false).on_hover_text(place.display().to_string());
                if response.clicked() {
                    self.go_to(&place);
                }
            }
        });
    }

    /// The folder's contents. Says whether a file was double clicked.
    fn list(&mut self, ui: &mut Ui, shown: &[FolderEntry], height: f32) -> bool {
        let words = Words::of(ui);
        let said = match &self.listing {
            Some(Listing { entries: Err(reason), .. }) => Some(words.message(reason.clone())),
            Some(_) if shown.is_empty() => Some(words.say(texts::NOTHING_TO_OPEN_HERE).to_owned()),
            _ => None,
        };
        if let Some(said) = said {
            ui.label(RichText::new(said).color(Tokens::of(ui).dim));
        }
        let mut is_confirmed = false;
        ScrollArea::vertical()
            .id_salt("folder")
            .max_height(height)
            .min_scrolled_height(height)
            .auto_shrink(false)
            .show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 0.0;
                for (index, entry) in shown.iter().enumerate() {
                    let icon = if entry.is_folder { Icon::Folder } else { Icon::File };
                    let end = if entry.is_folder { "/" } else { "" };
                    let is_at = self.at == Some(index);
                    let response = row(ui, icon, &format!("{}{end}", entry.name), is_at);
                    if is_at && self.has_moved {
                        response.scroll_to_me_animation(None, egui::style::ScrollAnimation::none());
                    }
                    // The first of the two clicks has named it; it may have been one into this folder.
                    is_confirmed |= response.double_clicked() && !entry.is_folder && entry.name == self.name();
                    if response.clicked() {
                        self.take(entry);
                    }
                }
            });
        is_confirmed
    }
}

/// The folder above one, also where it is relative.
fn above(folder: &Path) -> PathBuf {
    match folder.components().next_back() {
        Some(Component::Normal(_)) => {
            folder.parent().filter(|above| *above != Path::new("")).unwrap_or(Path::new(".")).to_owned()
        }
        Some(Component::RootDir | Component::Prefix(_)) => folder.to_owned(),
        Some(Component::CurDir) | None => PathBuf::from(".."),
        Some(Component::ParentDir) => folder.join(".."),
    }
}

fn row(ui: &mut Ui, icon: Icon, name: &str, is_at: bool) -> Response {
    let tokens = Tokens::of(ui);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::click());
    access::item(&response, Role::ListBoxOption, true, is_at, name);
    if is_at || response.hovered() {
        ui.painter().rect_filled(rect, CORNER, if is_at { tokens.accent_fill } else { tokens.raised });
    }
    if response.has_focus() {
        let stroke = Stroke::new(1.0, tokens.accent);
        ui.painter().rect_stroke(rect, CORNER, stroke, egui::StrokeKind::Inside);
    }
    icons::paint(ui.painter(), icon, rect.left_center() + vec2(12.0, 0.0), tokens.dim);
    let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
    painter.text(rect.left_center() + vec2(26.0, 0.0), Align2::LEFT_CENTER, name, text_font(), tokens.text);
    response
}

#[cfg(test)]
mod tests;
