//! A user's settings: hotkeys, colours, language, scale, recent files, panel sizes. Plain data and its file format.
//!
//! This module does not know where the file is, or what the name of a key means.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::words::{Argument, Language, Message, display_by_message, texts};

/// The value of `format`.
const FORMAT: &str = "inbetween.settings";
/// The version that is written; newer ones are refused.
const VERSION: u32 = 1;
/// The largest settings file that is read, in bytes.
pub const LARGEST_SETTINGS_BYTES: u64 = 1 << 20;
/// The largest number of recent files.
pub const MOST_RECENT_FILES: usize = 10;
/// The scales in the menu, in percent.
pub const SCALES: [u16; 7] = [75, 90, 100, 125, 150, 175, 200];
/// The valid panel sizes, in points.
const PANEL_SIZES: RangeInclusive<f32> = 40.0..=4000.0;

/// The colour theme.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ThemeChoice {
    /// The system's theme; dark if it has none.
    #[default]
    System,
    /// Light panels.
    Light,
    /// Dark panels.
    Dark,
}

impl ThemeChoice {
    /// All themes, in menu order.
    pub const ALL: [Self; 3] = [Self::System, Self::Light, Self::Dark];
}

/// The settings of one user.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Hotkeys that differ from the table's: the binding's id and its chords as text. Older files have English names instead of ids.
    pub keys: BTreeMap<String, Vec<String>>,
    /// The colour theme.
    pub theme: ThemeChoice,
    /// The language of the window's words.
    pub language: Language,
    /// The scale of the panels, in percent of the system's scale.
    pub scale_percent: u16,
    /// Recently read or written keyframe files, newest first.
    pub recent: Vec<PathBuf>,
    /// Sizes of resized panels in points, by the panel's name.
    pub panels: BTreeMap<String, f32>,
    /// Whether the window keeps a journal.
    pub journal: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            keys: BTreeMap::new(),
            theme: ThemeChoice::default(),
            language: Language::default(),
            scale_percent: 100,
            recent: Vec::new(),
            panels: BTreeMap::new(),
            journal: true,
        }
    }
}

/// The JSON object of a settings file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    format: String,
    version: u32,
    #[serde(default)]
    theme: ThemeChoice,
    #[serde(default)]
    language: Language,
    #[serde(default = "whole")]
    scale_percent: u16,
    #[serde(default)]
    panels: BTreeMap<String, f32>,
    #[serde(default)]
    keys: BTreeMap<String, Vec<String>>,
    #[serde(default)]
    recent: Vec<PathBuf>,
    #[serde(default = "kept")]
    journal: bool,
}

const fn kept() -> bool {
    true
}

const fn whole() -> u16 {
    100
}

/// The fields that identify the kind and the version of a file, also if the rest is not valid.
#[derive(Deserialize)]
struct Header {
    format: String,
    version: u32,
}

/// Why a settings file cannot be read.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum SettingsError {
    /// `format` names another kind of file.
    Format {
        /// The value in the file.
        found: String,
    },
    /// `version` is newer than this program.
    Version {
        /// The version in the file.
        found: u32,
    },
    /// It is not JSON, or has unknown fields or values.
    Json {
        /// The message, with line and column.
        reason: String,
    },
    /// A number is out of range.
    Range {
        /// The field's name.
        what: Argument,
        /// The value in the file.
        found: String,
        /// The smallest allowed value.
        least: u16,
        /// The largest allowed value.
        most: u16,
    },
}

display_by_message!(SettingsError);

impl SettingsError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Format { found } => texts::settings_format(found, FORMAT),
            Self::Version { found } => texts::settings_version(*found, VERSION),
            Self::Json { reason } => texts::foreign(reason),
            Self::Range { what, found, least, most } => texts::settings_range(what.clone(), found, *least, *most),
        }
    }
}

impl From<serde_json::Error> for SettingsError {
    fn from(error: serde_json::Error) -> Self {
        Self::Json { reason: crate::json::sentence(&error) }
    }
}

impl Settings {
    /// Reads a settings file.
    ///
    /// # Errors
    /// [`SettingsError`]; a file with any error is refused as a whole.
    pub fn from_json(bytes: &[u8]) -> Result<Self, SettingsError> {
        let header: Header = serde_json::from_slice(bytes)?;
        if header.format != FORMAT {
            return Err(SettingsError::Format { found: header.format });
        }
        if header.version != VERSION {
            return Err(SettingsError::Version { found: header.version });
        }
        let file: File = serde_json::from_slice(bytes)?;
        let (least, most) = (SCALES[0], SCALES[SCALES.len() - 1]);
        if !(least..=most).contains(&file.scale_percent) {
            let found = file.scale_percent.to_string();
            return Err(SettingsError::Range { what: "scale_percent".into(), found, least, most });
        }
        if let Some((name, size)) = file.panels.iter().find(|(_, size)| !PANEL_SIZES.contains(size)) {
            let (what, found) = (texts::settings_panel_size(name).into(), size.to_string());
            return Err(SettingsError::Range { what, found, least: 40, most: 4000 });
        }
        let mut recent = file.recent;
        recent.truncate(MOST_RECENT_FILES);
        Ok(Self {
            keys: file.keys,
            theme: file.theme,
            language: file.language,
            scale_percent: file.scale_percent,
            recent,
            panels: file.panels,
            journal: file.journal,
        })
    }

    /// The text of the settings file.
    #[must_use]
    pub fn to_json(&self) -> String {
        // A path that is not UTF-8 cannot be written. It is dropped, which costs one menu entry.
        let recent = self.recent.iter().filter(|path| path.to_str().is_some()).cloned().collect();
        let file = File {
            format: FORMAT.to_owned(),
            version: VERSION,
            theme: self.theme,
            language: self.language,
            scale_percent: self.scale_percent,
            panels: self.panels.clone(),
            keys: self.keys.clone(),
            recent,
            journal: self.journal,
        };
        let mut text = serde_json::to_string_pretty(&file).expect("settings are plain text and numbers");
        text.push('\n');
        text
    }

    /// Records a keyframe file that was read or written as the most recent one.
    pub fn used(&mut self, path: &Path) {
        self.recent.retain(|recent| recent != path);
        self.recent.insert(0, path.to_owned());
        self.recent.truncate(MOST_RECENT_FILES);
    }

    /// The next larger or smaller scale of the menu; the current one at the end.
    #[must_use]
    pub fn next_scale(&self, is_larger: bool) -> u16 {
        let at = self.scale_percent;
        let next = if is_larger {
            SCALES.into_iter().find(|&scale| scale > at)
        } else {
            SCALES.into_iter().rev().find(|&scale| scale < at)
        };
        next.unwrap_or(at)
    }

    /// Records a panel's size in points. Returns whether it changed.
    pub fn resized(&mut self, panel: &str, size: f32) -> bool {
        let size = size.clamp(*PANEL_SIZES.start(), *PANEL_SIZES.end()).round();
        self.panels.insert(panel.to_owned(), size) != Some(size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read() {
        for language in Language::all() {
            let mut settings = Settings { theme: ThemeChoice::Light, language, ..Settings::default() };
            settings.keys.insert("keyframe-new".to_owned(), vec!["Ctrl+K".to_owned(), "n".to_owned()]);
            settings.scale_percent = 125;
            settings.used(Path::new("folder/걷기.json"));
            assert!(settings.resized("side", 300.2));
            assert!(!settings.resized("side", 300.4));
            let text = settings.to_json();
            assert!(text.contains(&format!("\"language\": \"{}\"", language.code())), "{text}");
            assert_eq!(Settings::from_json(text.as_bytes()), Ok(settings));
        }
    }

    #[test]
    fn what_is_missing_is_the_default() {
        let text = r#"{"format": "inbetween.settings", "version": 1}"#;
        assert_eq!(Settings::from_json(text.as_bytes()), Ok(Settings::default()));
    }

    #[track_caller]
    fn check_refused(text: &str, expected: &str) {
        let error = Settings::from_json(text.as_bytes()).unwrap_err().to_string();
        assert!(error.contains(expected), "{error}");
    }

    #[test]
    fn what_is_not_understood_is_refused() {
        check_refused("", "line 1 column 0");
        check_refused(r#"{"format": "inbetween.keyframes", "version": 1}"#, "\"inbetween.keyframes\"");
        check_refused(r#"{"format": "inbetween.settings", "version": 2, "more": 1}"#, "version is 2");
        check_refused(r#"{"format": "inbetween.settings", "version": 1, "more": 1}"#, "`more`");
        check_refused(r#"{"format": "inbetween.settings", "version": 1, "theme": "pink"}"#, "`pink`");
        check_refused(r#"{"format": "inbetween.settings", "version": 1, "language": "xx"}"#, "variant `xx`, expected");
        check_refused(r#"{"format": "inbetween.settings", "version": 1, "scale_percent": 9}"#, "is 9");
        check_refused(r#"{"format": "inbetween.settings", "version": 1, "panels": {"side": 1e9}}"#, "\"side\"");
    }

    #[test]
    fn recent_files_are_ten_and_the_last_one_is_first() {
        let mut settings = Settings::default();
        for count in 0..12 {
            settings.used(Path::new(&format!("{count}.json")));
        }
        settings.used(Path::new("5.json"));
        assert_eq!(settings.recent.len(), MOST_RECENT_FILES);
        assert_eq!(settings.recent[0], Path::new("5.json"));
        assert_eq!(settings.recent.iter().filter(|path| path.ends_with("5.json")).count(), 1);
    }

    #[test]
    fn scales_step_and_stop() {
        let at = |scale_percent| Settings { scale_percent, ..Settings::default() };
        assert_eq!((at(100).next_scale(true), at(100).next_scale(false)), (125, 90));
        assert_eq!((at(200).next_scale(true), at(75).next_scale(false)), (200, 75));
        assert_eq!(at(110).next_scale(false), 100);
    }

    #[test]
    fn a_locale_has_a_language() {
        for (locale, language) in [("ko_KR.UTF-8", "ko"), ("ko", "ko"), ("en_GB", "en"), ("C", "en"), ("", "en")] {
            assert_eq!(Language::of_locale(locale).code(), language, "{locale}");
        }
    }
}
