//! Commands of the window itself: lists, dialogs and settings.

use super::dialogs::Dialog;
use super::export::ExportDialog;
use super::hotkeys::HotkeysDialog;
use super::palette::Palette;
use super::statistics::Statistics;
use super::timeline::Ask;
use super::words::Words;
use super::{PanelSize, Panels};
use crate::editor::WindowCommand;
use crate::editor::keymap::{Chord, Keymap, KeymapError, chords_of_table};
use crate::settings::{Settings, ThemeChoice};
use crate::words::{Argument, Message, texts};

/// The number of frames after a drag until a panel's size is final.
const SETTLED: u8 = 2;

impl Panels {
    /// Applies settings. Returns what is wrong with the hotkeys in them.
    pub fn adopt(&mut self, settings: &Settings) -> Vec<KeymapError> {
        let mut errors = Vec::new();
        if self.settings.keys != settings.keys {
            (self.keymap, errors) = Keymap::with_changes(&settings.keys);
        }
        self.settings = settings.clone();
        errors
    }

    /// The current keymap.
    #[must_use]
    pub const fn keymap(&self) -> &Keymap {
        &self.keymap
    }

    /// Performs a command of the window: shows a dialog or list, or changes the settings and applies them.
    /// Returns a message if the result cannot be seen.
    ///
    /// # Errors
    /// Why hotkeys were not changed.
    pub fn perform(
        &mut self,
        command: &WindowCommand,
        settings: &mut Settings,
    ) -> Result<Option<Message>, KeymapError> {
        let mut said = None;
        match command {
            WindowCommand::ShowCommands => self.dialog = Some(Dialog::Commands(Palette::default())),
            WindowCommand::ShowHotkeys => self.dialog = Some(Dialog::Hotkeys(HotkeysDialog::default())),
            WindowCommand::ShowManual => self.manual.open(),
            WindowCommand::ShowExport => {
                self.dialog = Some(Dialog::Export(Box::new(ExportDialog::new(self.exported.clone()))));
            }
            WindowCommand::ToggleMessages => self.log.toggle(),
            WindowCommand::ToggleStatistics => {
                self.statistics = if self.statistics.is_some() { None } else { Some(Statistics::default()) };
            }
            WindowCommand::ToggleReload => settings.reload = !settings.reload,
            WindowCommand::ToggleJournal => settings.journal = !settings.journal,
            WindowCommand::Larger => settings.scale_percent = settings.next_scale(true),
            WindowCommand::Smaller => settings.scale_percent = settings.next_scale(false),
            WindowCommand::SetScale(percent) => settings.scale_percent = *percent,
            WindowCommand::SetTheme(theme) => settings.theme = *theme,
            WindowCommand::SetLanguage(language) => settings.language = *language,
            WindowCommand::SetHotkeys(id, chords) => said = Some(self.set_keys(id, chords.clone(), settings)?),
            WindowCommand::ResetHotkeys(id) => said = Some(self.set_keys(id, chords_of_table(id), settings)?),
            WindowCommand::ResetAllHotkeys => {
                settings.keys.clear();
                said = Some(texts::HOTKEYS_RESET.into());
            }
            WindowCommand::RenameCurrent => self.timeline.ask(Ask::Rename),
            WindowCommand::FitTimeline => self.timeline.ask(Ask::FitAll),
            WindowCommand::FitSelection => self.timeline.ask(Ask::FitSelection),
            WindowCommand::ForgetRecent => settings.recent.clear(),
        }
        self.adopt(settings);
        Ok(said)
    }

    fn set_keys(&self, id: &str, chords: Vec<Chord>, settings: &mut Settings) -> Result<Message, KeymapError> {
        let mut keymap = self.keymap.clone();
        keymap.set(id, chords)?;
        match keymap.changes().remove(id) {
            Some(chords) => settings.keys.insert(id.to_owned(), chords),
            None => settings.keys.remove(id),
        };
        let Some(binding) = keymap.get(id) else { return Err(KeymapError::NoSuchBinding { name: id.to_owned() }) };
        let keys = binding.chords.iter().map(|chord| Argument::from(chord.label()));
        Ok(match keys.reduce(|first, second| texts::key_or_key(first, second).into()) {
            Some(keys) => texts::hotkeys_changed(binding.title(), keys),
            None => texts::hotkeys_removed(binding.title()),
        })
    }

    /// Applies the settings that egui's context holds: language, theme and scale.
    pub(super) fn apply_settings_to(&self, context: &egui::Context) {
        let words = Words::new(self.settings.language);
        let theme = match self.settings.theme {
            ThemeChoice::System => egui::ThemePreference::System,
            ThemeChoice::Light => egui::ThemePreference::Light,
            ThemeChoice::Dark => egui::ThemePreference::Dark,
        };
        if Words::of_context(context) != words {
            words.install(context);
        }
        if context.options(|options| options.theme_preference) != theme {
            context.set_theme(theme);
            context.request_repaint();
        }
        context.set_zoom_factor(f32::from(self.settings.scale_percent) / 100.0);
    }

    /// The size of a panel that it is shown in at first.
    pub(super) fn panel_size(&self, name: &str, usual: f32) -> f32 {
        self.settings.panels.get(name).copied().unwrap_or(usual)
    }

    /// Notes the size of a panel, which is news when a drag of its edge is over.
    pub(super) fn watch_panel(&mut self, ui: &egui::Ui, name: &'static str, size: f32) {
        let is_held = ui.input(|input| input.pointer.any_down());
        let watched = self.watched.entry(name).or_insert(PanelSize { size, is_dragged: false, rests: 0 });
        watched.is_dragged |= is_held && (watched.size - size).abs() >= 1.0;
        watched.size = size;
        watched.rests = if is_held { 0 } else { watched.rests.saturating_add(1) };
        if watched.is_dragged && !is_held {
            ui.ctx().request_repaint();
        }
    }

    /// The sizes of panels whose edges were dragged, once each.
    pub(super) fn dragged_panels(&mut self, ui: &egui::Ui) -> Vec<(&'static str, f32)> {
        if ui.input(|input| input.pointer.any_down()) {
            return Vec::new();
        }
        self.watched
            .iter_mut()
            .filter(|(_, watched)| watched.rests > SETTLED)
            .filter_map(|(name, watched)| std::mem::take(&mut watched.is_dragged).then_some((*name, watched.size)))
            .collect()
    }
}
