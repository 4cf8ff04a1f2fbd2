//! Commands of the window itself: lists, dialogs and settings.

use super::Panels;
use super::about::About;
use super::dialogs::Dialog;
use super::export::ExportDialog;
use super::hotkeys::HotkeysDialog;
use super::palette::Palette;
use super::statistics::Statistics;
use super::timeline::Ask;
use super::words::Words;
use crate::editor::WindowCommand;
use crate::editor::keymap::{Chord, Keymap, KeymapError, chords_of_table};
use crate::settings::{Settings, ThemeChoice};
use crate::words::{Argument, Message, texts};

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
            WindowCommand::TogglePoses => self.poses.toggle(),
            WindowCommand::ToggleMessages => self.log.toggle(),
            WindowCommand::ToggleStatistics => {
                self.statistics = if self.statistics.is_some() { None } else { Some(Statistics::default()) };
            }
            WindowCommand::ToggleReload => settings.reload = !settings.reload,
            WindowCommand::ToggleRecordedEye => settings.recorded_eye = !settings.recorded_eye,
            WindowCommand::ToggleInsetWhilePlaying => settings.inset_while_playing = !settings.inset_while_playing,
            WindowCommand::ToggleRefineAtRest => settings.refine_at_rest = !settings.refine_at_rest,
            WindowCommand::ToggleReduceMotion => settings.reduce_motion = !settings.reduce_motion,
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
            WindowCommand::ShowAbout => self.dialog = Some(Dialog::About(About::default())),
            WindowCommand::ShowTour => settings.tour = self.tour.toggle(),
            WindowCommand::CloseTour => {
                self.tour.close();
                settings.tour = false;
            }
            // The window does these by itself.
            WindowCommand::ChooseOpenScene | WindowCommand::Begin(_) | WindowCommand::ShowFolder(_) => {}
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
}
