//! A user's settings: hotkeys, colours, language, scale, recent files, panel sizes. Plain data and its file format.
//!
//! This module does not know where the file is, or what the name of a key means.

mod handles;
mod merge;

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use thiserror::Error;

pub use handles::{GizmoAxes, SnapSteps};

use crate::decode::{self, DecodeError};
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
/// The valid sides of the window, in points.
const WINDOW_SIZES: RangeInclusive<f32> = 40.0..=16_000.0;

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

impl WindowPlace {
    /// A place whose sides are within what a settings file can hold.
    #[must_use]
    pub fn new(size: [f32; 2], at_px: Option<[i32; 2]>) -> Self {
        let size = size.map(|side| side.round().clamp(*WINDOW_SIZES.start(), *WINDOW_SIZES.end()));
        Self { size, at_px, is_maximized: false }
    }
}

impl ThemeChoice {
    /// All themes, in menu order.
    pub const ALL: [Self; 3] = [Self::System, Self::Light, Self::Dark];
}

/// Where a window was, and how large.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WindowPlace {
    /// Width and height of its inside, in points.
    pub size: [f32; 2],
    /// Its top left corner, in pixels of the desktop; `None` if the window system does not say it.
    #[serde(default)]
    pub at_px: Option<[i32; 2]>,
    /// Whether it fills its monitor.
    #[serde(default)]
    pub is_maximized: bool,
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
    /// Whether the window reads files again when another program changes them.
    pub reload: bool,
    /// Where the window was when it was closed, and how large.
    pub window: Option<WindowPlace>,
    /// Whether an empty window shows the first steps.
    pub tour: bool,
    /// Whose axes handles go by.
    pub gizmo_axes: GizmoAxes,
    /// The steps of drags with Shift.
    pub snap: SnapSteps,
    /// Whether the window begins with the scene's first eye, which keyframes record, instead of the work eye.
    pub recorded_eye: bool,
    /// Whether changes of the view show at once instead of being eased.
    pub reduce_motion: bool,
    /// Whether the corner with what the recorded camera sees stays while something plays.
    pub inset_while_playing: bool,
    /// Whether the picture is refined while nothing moves.
    pub refine_at_rest: bool,
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
            reload: false,
            window: None,
            tour: true,
            gizmo_axes: GizmoAxes::default(),
            snap: SnapSteps::default(),
            recorded_eye: false,
            reduce_motion: false,
            inset_while_playing: false,
            refine_at_rest: true,
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
    #[serde(default)]
    reload: bool,
    #[serde(default)]
    window: Option<WindowPlace>,
    #[serde(default = "kept")]
    tour: bool,
    #[serde(default)]
    gizmo_axes: GizmoAxes,
    #[serde(default)]
    snap: SnapSteps,
    #[serde(default)]
    recorded_eye: bool,
    #[serde(default)]
    reduce_motion: bool,
    #[serde(default)]
    inset_while_playing: bool,
    #[serde(default = "kept")]
    refine_at_rest: bool,
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
    Json(#[from] DecodeError),
    /// A number is out of range.
    Range {
        /// The field's name.
        what: Argument,
        /// The value in the file.
        found: String,
        /// The smallest allowed value.
        least: Argument,
        /// The largest allowed value.
        most: Argument,
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
            Self::Json(error) => error.message(),
            Self::Range { what, found, least, most } => {
                texts::settings_range(what.clone(), found, least.clone(), most.clone())
            }
        }
    }
}

impl Settings {
    /// Reads a settings file.
    ///
    /// # Errors
    /// [`SettingsError`]; a file with any error is refused as a whole.
    pub fn from_json(bytes: &[u8]) -> Result<Self, SettingsError> {
        let header: Header = decode::json(bytes)?;
        if header.format != FORMAT {
            return Err(SettingsError::Format { found: header.format });
        }
        if header.version != VERSION {
            return Err(SettingsError::Version { found: header.version });
        }
        let file: File = decode::json(bytes)?;
        let (least, most) = (SCALES[0], SCALES[SCALES.len() - 1]);
        if !(least..=most).contains(&file.scale_percent) {
            let found = file.scale_percent.to_string();
            let (least, most) = (least.into(), most.into());
            return Err(SettingsError::Range { what: "scale_percent".into(), found, least, most });
        }
        if let Some((name, size)) = file.panels.iter().find(|(_, size)| !PANEL_SIZES.contains(size)) {
            let (what, found) = (texts::settings_panel_size(name).into(), size.to_string());
            return Err(SettingsError::Range { what, found, least: 40_u16.into(), most: 4000_u16.into() });
        }
        for (what, number, range) in
            [("snap.degrees", file.snap.degrees, SnapSteps::DEGREES), ("snap.units", file.snap.units, SnapSteps::UNITS)]
        {
            if !range.contains(&number) {
                let (least, most) = ((*range.start()).into(), (*range.end()).into());
                return Err(SettingsError::Range { what: what.into(), found: number.to_string(), least, most });
            }
        }
        if let Some(size) = file.window.iter().flat_map(|window| window.size).find(|size| !WINDOW_SIZES.contains(size))
        {
            let (what, found) = (Message::from(texts::SETTINGS_WINDOW_SIZE).into(), size.to_string());
            return Err(SettingsError::Range { what, found, least: 40_u16.into(), most: 16_000_u16.into() });
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
            reload: file.reload,
            window: file.window,
            tour: file.tour,
            gizmo_axes: file.gizmo_axes,
            snap: file.snap,
            recorded_eye: file.recorded_eye,
            reduce_motion: file.reduce_motion,
            inset_while_playing: file.inset_while_playing,
            refine_at_rest: file.refine_at_rest,
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
            reload: self.reload,
            window: self.window.clone(),
            tour: self.tour,
            gizmo_axes: self.gizmo_axes,
            snap: self.snap,
            recorded_eye: self.recorded_eye,
            reduce_motion: self.reduce_motion,
            inset_while_playing: self.inset_while_playing,
            refine_at_rest: self.refine_at_rest,
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

    /// Records a panel's size in points, `None` for its usual one. Returns whether it changed.
    pub fn resized(&mut self, panel: &str, size: Option<f32>) -> bool {
        let Some(size) = size else { return self.panels.remove(panel).is_some() };
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
            settings.gizmo_axes = GizmoAxes::World;
            settings.snap = SnapSteps { degrees: 7.5, units: 0.1 };
            settings.used(Path::new("folder/걷기.json"));
            settings.window = Some(WindowPlace { size: [900.0, 600.0], at_px: Some([-3, 4]), is_maximized: true });
            settings.tour = false;
            (settings.reduce_motion, settings.inset_while_playing, settings.refine_at_rest) = (true, true, false);
            assert!(settings.resized("side", Some(300.2)));
            assert!(!settings.resized("side", Some(300.4)));
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
        check_refused("", "line 1 column 1: the file ends");
        check_refused(r#"{"format": "inbetween.keyframes", "version": 1}"#, "\"inbetween.keyframes\"");
        check_refused(r#"{"format": "inbetween.settings", "version": 2, "more": 1}"#, "version is 2");
        check_refused(r#"{"format": "inbetween.settings", "version": 1, "more": 1}"#, "unknown field \"more\"");
        check_refused(
            r#"{"format": "inbetween.settings", "version": 1, "theme": "pink"}"#,
            "unknown value \"pink\", expected system, light or dark",
        );
        check_refused(
            r#"{"format": "inbetween.settings", "version": 1, "language": "xx"}"#,
            "unknown value \"xx\", expected en or ko",
        );
        check_refused(
            r#"{"format": "inbetween.settings", "version": 1, "gizmo_axes": "own"}"#,
            "unknown value \"own\", expected local, parent, world or view",
        );
        check_refused(
            r#"{"format": "inbetween.settings", "version": 1, "snap": {"degrees": 0, "units": 1}}"#,
            "snap.degrees is 0, and must be 0.1 to 180",
        );
        check_refused(r#"{"format": "inbetween.settings", "version": 1, "scale_percent": 9}"#, "is 9");
        check_refused(r#"{"format": "inbetween.settings", "version": 1, "panels": {"side": 1e9}}"#, "\"side\"");
        check_refused(
            r#"{"format": "inbetween.settings", "version": 1, "window": {"size": [900, 1e9]}}"#,
            "a side of the window is 1000000000",
        );
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
