//! The settings file: read at the start, written when a setting changes.

use std::path::PathBuf;

use crate::editor::keymap::by_id;
use crate::settings::{LARGEST_SETTINGS_BYTES, Settings};
use crate::storage;
use crate::words::{Language, Message, texts};

/// The settings and their file.
#[derive(Debug)]
pub struct SettingsFile {
    /// The settings.
    pub settings: Settings,
    /// The file's path; `None` if the system has no folder for settings.
    path: Option<PathBuf>,
    /// Whether the file could not be understood. It is then copied before it is overwritten.
    is_foreign: bool,
}

impl SettingsFile {
    /// Reads the settings. If they cannot be read, returns the defaults and a message.
    pub fn read() -> (Self, Option<Message>) {
        let usual = Settings { language: system_language(), ..Settings::default() };
        Self::read_from(storage::settings_path(), usual)
    }

    fn read_from(path: Option<PathBuf>, usual: Settings) -> (Self, Option<Message>) {
        let file = |settings, path, is_foreign| Self { settings, path, is_foreign };
        let Some(path) = path else { return (file(usual, None, false), None) };
        if !storage::exists(&path) {
            return (file(usual, Some(path), false), None);
        }
        let settings = storage::read(&path, LARGEST_SETTINGS_BYTES)
            .map_err(|error| error.message())
            .and_then(|bytes| Settings::from_json(&bytes).map_err(|error| error.message()));
        match settings {
            Ok(settings) => {
                // Older settings name bindings in English; the next time they are written, it is by ids.
                let keys = by_id(&settings.keys);
                (file(Settings { keys, ..settings }, Some(path), false), None)
            }
            Err(reason) => {
                let said = texts::settings_not_understood(path.display(), reason);
                (file(usual, Some(path), true), Some(said))
            }
        }
    }

    /// Writes the settings. Returns a message with the copy's path if a file that was not understood was copied.
    pub fn write(&mut self) -> Result<Option<Message>, Message> {
        let Some(path) = &self.path else { return Ok(None) };
        let failed = |error: storage::StorageError| {
            texts::settings_not_kept(texts::refused_file(path.display(), error.message()))
        };
        let mut said = None;
        if self.is_foreign {
            let copy = storage::keep_copy(path).map_err(failed)?;
            said = copy.map(|copy| texts::settings_copied(copy.display()));
        }
        if let Some(folder) = path.parent() {
            storage::create_folder(folder).map_err(failed)?;
        }
        storage::write(path, self.settings.to_json().as_bytes()).map_err(failed)?;
        self.is_foreign = false;
        Ok(said)
    }
}

/// The language that the system's locale asks for.
fn system_language() -> Language {
    let locale = ["LC_ALL", "LC_MESSAGES", "LANG"]
        .iter()
        .find_map(|name| std::env::var(name).ok().filter(|locale| !locale.is_empty()));
    locale.map_or_else(Language::default, |locale| Language::of_locale(&locale))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_kept() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("inbetween").join("settings.json");
        let (mut file, problem) = SettingsFile::read_from(Some(path.clone()), Settings::default());
        assert_eq!(problem, None);
        file.settings.scale_percent = 150;
        assert_eq!(file.write(), Ok(None));
        let (again, problem) = SettingsFile::read_from(Some(path), Settings::default());
        assert_eq!((again.settings, problem), (file.settings, None));
    }

    #[test]
    fn what_is_not_understood_is_never_lost() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("settings.json");
        storage::write(&path, b"{ \"version\": 9").unwrap();
        let (mut file, problem) = SettingsFile::read_from(Some(path.clone()), Settings::default());
        assert_eq!(file.settings, Settings::default());
        assert!(problem.unwrap().to_string().contains("line 1 column"));
        let sentence = file.write().unwrap().unwrap().to_string();
        let copy = folder.path().join("settings.json.bak");
        assert!(sentence.contains(&copy.display().to_string()), "{sentence}");
        assert_eq!(storage::read(&copy, 100).unwrap(), b"{ \"version\": 9");
        assert_eq!(file.write(), Ok(None));
        assert!(Settings::from_json(&storage::read(&path, 1000).unwrap()).is_ok());
    }

    #[test]
    fn keys_of_english_names_are_written_by_ids() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("settings.json");
        let old =
            r#"{"format": "inbetween.settings", "version": 1, "keys": {"New keyframe": ["F5"], "arcball": ["F6"]}}"#;
        std::fs::write(&path, old).unwrap();
        let (mut file, problem) = SettingsFile::read_from(Some(path.clone()), Settings::default());
        assert_eq!(problem, None);
        assert_eq!(file.write(), Ok(None));
        let text = std::fs::read_to_string(&path).unwrap();
        let json: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(json["keys"], serde_json::json!({"keyframe-new": ["F5"], "arcball": ["F6"]}));
    }
}
