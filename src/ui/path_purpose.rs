//! What a path is asked for, and what follows from that: the words of the question, the files that fit, the command of the answer.

use std::path::PathBuf;

use crate::editor::{Beginning, Command, FileCommand, MODEL_ENDINGS, NEW_FILE, PathQuestion, WindowCommand};
use crate::film::FORMATS;
use crate::words::{Phrase, texts};

/// What a path is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PathPurpose {
    /// To open it.
    Open,
    /// To show its animation beside the document's.
    Compare,
    /// To write to it.
    SaveAs,
    /// To write the scene to it.
    SaveSceneAs,
    /// To begin with the scene in it.
    OpenScene,
    /// To write a model of another format to it.
    ExportModel,
    /// To write a film to it.
    Film,
    /// To write the frames of a film into it: a folder.
    FilmFolder,
}

impl PathPurpose {
    /// What the editor asks for.
    #[must_use]
    pub const fn of(question: &PathQuestion) -> Self {
        match question {
            PathQuestion::Open => Self::Open,
            PathQuestion::Compare => Self::Compare,
            PathQuestion::SaveAs => Self::SaveAs,
            PathQuestion::SaveSceneAs => Self::SaveSceneAs,
            PathQuestion::ExportModel => Self::ExportModel,
            PathQuestion::Export { is_folder: false, .. } => Self::Film,
            PathQuestion::Export { is_folder: true, .. } => Self::FilmFolder,
        }
    }

    /// The command that a path answers with; `None` where it answers a field of the export dialog.
    #[must_use]
    pub fn command(self, path: PathBuf) -> Option<Command> {
        let is_model = ends_with_one_of(&path.to_string_lossy(), &MODEL_ENDINGS);
        Some(match self {
            Self::Open | Self::OpenScene if is_model => {
                Command::Window(WindowCommand::Begin(Beginning::Model { path, choice: None }))
            }
            Self::ExportModel => Command::File(FileCommand::ExportModel(path)),
            Self::Open => Command::File(FileCommand::Open(path)),
            Self::Compare => Command::File(FileCommand::CompareWith(path)),
            Self::SaveAs => Command::File(FileCommand::SaveAs(path)),
            Self::SaveSceneAs => Command::File(FileCommand::SaveSceneAs(path)),
            Self::OpenScene => Command::Window(WindowCommand::Begin(Beginning::SceneFile(path))),
            Self::Film | Self::FilmFolder => return None,
        })
    }

    /// Whether the path may be of a file that is not there yet.
    #[must_use]
    pub const fn is_saving(self) -> bool {
        matches!(self, Self::SaveAs | Self::SaveSceneAs | Self::ExportModel | Self::Film)
    }

    /// Whether the path is of a folder.
    #[must_use]
    pub const fn is_folder(self) -> bool {
        matches!(self, Self::FilmFolder)
    }

    /// Whether a file of this name fits, by its ending.
    pub(super) fn fits(self, name: &str) -> bool {
        let ends_with = |endings: &[&str]| ends_with_one_of(name, endings);
        match self {
            Self::Open => ends_with(&["json", "txt", "csv"]) || ends_with(&MODEL_ENDINGS),
            Self::Compare => ends_with(&["json", "txt", "csv"]),
            Self::OpenScene => ends_with(&["json"]) || ends_with(&MODEL_ENDINGS),
            Self::SaveAs | Self::SaveSceneAs => ends_with(&["json"]),
            Self::ExportModel => ends_with(&MODEL_ENDINGS),
            Self::Film => FORMATS.iter().filter(|format| !format.is_still()).any(|format| ends_with(&[format.ending])),
            Self::FilmFolder => false,
        }
    }

    /// What the empty field shows as an example.
    pub(super) const fn hint(self) -> &'static str {
        match self {
            Self::Open | Self::Compare | Self::SaveAs => NEW_FILE,
            Self::SaveSceneAs | Self::OpenScene => "scene.json",
            Self::ExportModel => "animation.glb",
            Self::Film => "animation.gif",
            Self::FilmFolder => "frames/",
        }
    }

    /// The question, and the word of the button that answers it.
    pub(super) const fn words(self) -> (Phrase, Phrase) {
        match self {
            Self::Open => (texts::OPEN_A_KEYFRAME_FILE, texts::OPEN),
            Self::Compare => (texts::COMPARE_WITH_A_FILE, texts::COMPARE),
            Self::SaveAs => (texts::SAVE_THE_KEYFRAMES_AS, texts::SAVE),
            Self::SaveSceneAs => (texts::SAVE_THE_SCENE_AS, texts::SAVE),
            Self::OpenScene => (texts::OPEN_A_SCENE_FILE, texts::OPEN),
            Self::ExportModel => (texts::EXPORT_A_MODEL, texts::EXPORT),
            Self::Film => (texts::EXPORT_TO_A_FILE, texts::CHOOSE),
            Self::FilmFolder => (texts::EXPORT_INTO_A_FOLDER, texts::CHOOSE),
        }
    }
}

/// Whether a name ends in one of these after a point, in capitals or not.
fn ends_with_one_of(name: &str, endings: &[&str]) -> bool {
    let name = name.to_lowercase();
    endings.iter().any(|ending| name.strip_suffix(ending).is_some_and(|stem| stem.ends_with('.')))
}
