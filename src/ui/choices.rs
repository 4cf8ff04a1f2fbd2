//! Choices with a value: recent files, eyes, interpolations, colours, languages, sizes, steps that
//! drags snap to. Menus and the command list show the same.

use super::PathPurpose;
use super::words::Words;
use crate::editor::gizmo::SnapSteps;
use crate::editor::{Beginning, Command, Edit, Editor, Eye, ViewCommand, WindowCommand};
use crate::interpolation::Interpolation;
use crate::scene::{BUILT_IN_ANIMATIONS, built_in_scene_names};
use crate::settings::{SCALES, Settings, ThemeChoice};
use crate::words::{Language, texts};

/// What a choice is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topic {
    /// A keyframe file that was used lately.
    Recent,
    /// An example that is part of the program.
    Example,
    /// Where to look from.
    Eye,
    /// How keyframes are joined.
    Interpolation,
    /// Which colours show.
    Theme,
    /// Which words show.
    Language,
    /// How large the panels are.
    Scale,
    /// The steps of turns that snap.
    SnapTurns,
    /// The steps of moves that snap.
    SnapMoves,
}

impl Topic {
    /// Its name.
    pub fn name(self, words: Words) -> &'static str {
        match self {
            Self::Recent => words.say(texts::OPEN_RECENT),
            Self::Example => words.say(texts::EXAMPLES),
            Self::Eye => words.say(texts::LOOK_FROM),
            Self::Interpolation => words.say(texts::INTERPOLATION),
            Self::Theme => words.say(texts::THEME),
            Self::Language => words.say(texts::LANGUAGE),
            Self::Scale => words.say(texts::SCALE),
            Self::SnapTurns => words.say(texts::SNAP_TURNS),
            Self::SnapMoves => words.say(texts::SNAP_MOVES),
        }
    }
}

/// One of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// What it is of.
    pub topic: Topic,
    /// Its words.
    pub label: String,
    /// What choosing it asks for.
    pub command: Command,
    /// Whether it is chosen.
    pub is_on: bool,
}

/// All of them.
pub fn choices(editor: &Editor, settings: &Settings, words: Words) -> Vec<Choice> {
    let mut all = Vec::new();
    let mut add = |topic, label: String, command, is_on| all.push(Choice { topic, label, command, is_on });
    for path in &settings.recent {
        let Some(command) = PathPurpose::Open.command(path.clone()) else { continue };
        add(Topic::Recent, path.display().to_string(), command, false);
    }
    for example in BUILT_IN_ANIMATIONS {
        let label = words.message(texts::example_animation(example.name, example.scene));
        let command = Command::Window(WindowCommand::Begin(Beginning::Animation(example.name)));
        add(Topic::Example, label, command, false);
    }
    for name in built_in_scene_names() {
        let command = Command::Window(WindowCommand::Begin(Beginning::Scene(name)));
        add(Topic::Example, words.message(texts::example_scene(name)), command, false);
    }
    let mut look_from = |label: String, eye: Eye| {
        add(Topic::Eye, label, Command::View(ViewCommand::SetEye(eye)), eye == editor.session().eye);
    };
    look_from(words.say(texts::WORK_EYE).to_owned(), Eye::Work);
    for (index, &rbt) in editor.scene().eyes().iter().enumerate() {
        look_from(editor.scene().rbt_path(rbt).to_owned(), Eye::Recorded(index));
    }
    for interpolation in Interpolation::ALL {
        let is_on = editor.document().interpolation == interpolation;
        let command = Command::Edit(Edit::SetInterpolation(interpolation));
        add(Topic::Interpolation, words.say(interpolation.title()).to_owned(), command, is_on);
    }
    for theme in ThemeChoice::ALL {
        let label = match theme {
            ThemeChoice::System => words.say(texts::AS_THE_SYSTEM),
            ThemeChoice::Light => words.say(texts::LIGHT),
            ThemeChoice::Dark => words.say(texts::DARK),
        };
        let command = Command::Window(WindowCommand::SetTheme(theme));
        add(Topic::Theme, label.to_owned(), command, settings.theme == theme);
    }
    for language in Language::all() {
        let command = Command::Window(WindowCommand::SetLanguage(language));
        add(Topic::Language, language.name().to_owned(), command, settings.language == language);
    }
    for scale in SCALES {
        let command = Command::Window(WindowCommand::SetScale(scale));
        add(Topic::Scale, format!("{scale} %"), command, settings.scale_percent == scale);
    }
    let snap = editor.session().snap;
    let mut snaps = |topic, label, steps| {
        add(topic, label, Command::View(ViewCommand::SetSnapSteps(steps)), steps == snap);
    };
    for degrees in with(&SnapSteps::OFFERED_DEGREES, snap.degrees) {
        snaps(Topic::SnapTurns, format!("{degrees}°"), SnapSteps { degrees, ..snap });
    }
    for units in with(&SnapSteps::OFFERED_UNITS, snap.units) {
        snaps(Topic::SnapMoves, units.to_string(), SnapSteps { units, ..snap });
    }
    all
}

/// The steps that are offered, and the one in force wherever it belongs among them.
fn with(offered: &[f64], in_force: f64) -> Vec<f64> {
    let mut steps: Vec<f64> = offered.iter().copied().filter(|&step| step != in_force).chain([in_force]).collect();
    steps.sort_by(f64::total_cmp);
    steps
}
