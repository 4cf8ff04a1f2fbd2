//! The settings file: read at the start, written when a setting changes.

use std::path::{Path, PathBuf};

use crate::editor::keymap::by_id;
use crate::settings::{LARGEST_SETTINGS_BYTES, Settings};
use crate::storage;
use crate::words::{Language, Message, texts};

/// The settings and their file.
#[derive(Debug)]
pub struct SettingsFile {
    /// The settings.
    pub settings: Settings,
    /// The settings as this window last read or wrote them.
    base: Settings,
    /// The file's path; `None` if the system has no folder for settings.
    path: Option<PathBuf>,
}

impl SettingsFile {
    /// Reads the settings. If they cannot be read, returns the defaults and a message.
    pub fn read() -> (Self, Option<Message>) {
        let usual = Settings { language: system_language(), ..Settings::default() };
        Self::read_from(storage::settings_path(), usual)
    }

    fn read_from(path: Option<PathBuf>, usual: Settings) -> (Self, Option<Message>) {
        let (settings, said) = match path.as_deref().and_then(in_file) {
            None => (usual, None),
            Some(Ok(settings)) => (settings, None),
            Some(Err(said)) => (usual, Some(said)),
        };
        (Self { base: settings.clone(), settings, path }, said)
    }

    /// Writes the settings that were changed here; the others are those that another window has written meanwhile. Returns a message
    /// with the copy's path if the file was not understood and was copied.
    pub fn write(&mut self) -> Result<Option<Message>, Message> {
        let Some(path) = &self.path else { return Ok(None) };
        let failed = |error: storage::StorageError| {
            texts::settings_not_kept(texts::refused_file(path.display(), error.message()))
        };
        let mut said = None;
        match in_file(path) {
            None => {}
            Some(Ok(file)) => self.settings = self.settings.merged(&self.base, file),
            Some(Err(_)) => {
                let copy = storage::keep_copy(path).map_err(failed)?;
                said = copy.map(|copy| texts::settings_copied(copy.display()));
            }
        }
        if let Some(folder) = path.parent() {
            storage::create_folder(folder).map_err(failed)?;
        }
        storage::write(path, self.settings.to_json().as_bytes()).map_err(failed)?;
        self.base = self.settings.clone();
        Ok(said)
    }
}

/// The settings in a file, or what is wrong with it; `None` if there is none.
fn in_file(path: &Path) -> Option<Result<Settings, Message>> {
    if !storage::exists(path) {
        return None;
    }
    let bytes = storage::read(path, LARGEST_SETTINGS_BYTES).map_err(|error| error.message());
    let settings = bytes.and_then(|bytes| Settings::from_json(&bytes).map_err(|error| error.message()));
    // Older settings name bindings in English; the next time they are written, it is by ids.
    let by_ids = |settings: Settings| Settings { keys: by_id(&settings.keys), ..settings };
    Some(settings.map(by_ids).map_err(|reason| texts::settings_not_understood(path.display(), reason)))
}

/// The language that the system's locale asks for.
#[cfg(target_arch = "wasm32")]
fn system_language() -> Language {
    Language::of_locale(&super::page::language())
}

/// The language of the system.
#[cfg(not(target_arch = "wasm32"))]
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
    fn two_windows_do_not_undo_each_others_settings() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("settings.json");
        let open = || SettingsFile::read_from(Some(path.clone()), Settings::default()).0;
        let (mut one, mut other) = (open(), open());
        one.settings.scale_percent = 150;
        assert_eq!(one.write(), Ok(None));
        other.settings.reload = true;
        other.settings.used(Path::new("walk.json"));
        assert_eq!(other.write(), Ok(None));
        assert_eq!(other.settings.scale_percent, 150);
        // What was set here and then by the other is the other's, until it is set here again.
        other.settings.scale_percent = 90;
        assert_eq!(other.write(), Ok(None));
        one.settings.journal = false;
        assert_eq!(one.write(), Ok(None));
        let expected = Settings {
            scale_percent: 90,
            journal: false,
            reload: true,
            recent: vec!["walk.json".into()],
            ..Settings::default()
        };
        assert_eq!((open().settings, one.settings), (expected.clone(), expected));
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
