//! Who performs what the editor asks of the outside world: a window, a script without one, or the grader.

use std::fmt::Display;
use std::path::{Path, PathBuf};

use super::{Command, CommandError, Editor, Effect, WindowCommand};
use crate::film::ExportOptions;
use crate::scene::{MeshesFile, SceneFiles};
use crate::words::Message;

/// What became of a file: a value, or a message that says why not. The editor is told of either.
pub type FileOutcome<T> = Result<T, Message>;

/// Which path a dialog asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PathQuestion {
    /// The keyframe file to open.
    Open,
    /// The file to compare with.
    Compare,
    /// Where to save the keyframes.
    SaveAs,
    /// Where to save the scene.
    SaveSceneAs,
    /// Where to write a model of another format.
    ExportModel,
    /// Where an export is written.
    Export {
        /// What the dialog begins with.
        proposed: PathBuf,
        /// Whether it is a folder.
        is_folder: bool,
    },
}

/// What was done with a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileAccess {
    /// Keyframes were read.
    KeyframesRead,
    /// An animation to compare with was read.
    ComparedRead,
    /// A scene was read.
    SceneRead,
    /// Keyframes were written.
    KeyframesWritten,
    /// The scene was written.
    SceneWritten,
    /// A picture of the scene was written.
    ScreenshotTaken,
    /// A pose with a name was written.
    PoseWritten,
    /// A model of another format was written.
    ModelWritten,
}

/// What a host is asked to write.
#[derive(Clone, Copy)]
pub struct Writing<'a> {
    /// What is written.
    pub access: FileAccess,
    /// The file.
    pub path: &'a Path,
    /// Its text, to be made as it is written.
    pub text: &'a dyn Display,
    /// The file of meshes that the text names. It is written first, so that no scene names a file that is not there.
    pub meshes: Option<&'a MeshesFile>,
    /// Whether the editor has read or written the file before. Where not, a careful host keeps what it held.
    pub is_known: bool,
}

/// What became of the file that was replaced.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// Where the host put what the file held before, if it kept that.
    pub kept: Option<PathBuf>,
    /// The number of the file's other names, its hard links. They keep the old content.
    pub other_links: u64,
    /// Where the host put what the file of the scene's meshes held before, if it was another one.
    pub kept_meshes: Option<PathBuf>,
}

/// Does what only a window can do, or says that there is none.
pub trait WindowHost {
    /// Asks the user for a path.
    fn ask_for_path(&mut self, question: PathQuestion);

    /// Begins an export of the document as it is now.
    fn begin_export(&mut self, options: ExportOptions);

    /// Ends the export that is under way.
    fn cancel_export(&mut self);

    /// Ends the program, asking first where something is unsaved.
    fn quit(&mut self);

    /// Changes the window or its settings.
    fn change_window(&mut self, command: WindowCommand);
}

/// Performs effects. A host implements one method for each thing that is done outside of the editor; what becomes of it is told to the
/// editor here, in one place.
pub trait Host {
    /// Why the host cannot go on. [`std::convert::Infallible`] where every failure is the editor's message.
    type Stop;

    /// The editor whose effects are performed.
    fn editor(&mut self) -> &mut Editor;

    /// Reads a file of keyframes or of a scene.
    ///
    /// # Errors
    /// Only where the host cannot go on; a file that cannot be read is an outcome.
    fn read(&mut self, access: FileAccess, path: &Path) -> Result<FileOutcome<Vec<u8>>, Self::Stop>;

    /// Reads a file of keyframes, and tells the editor. A host may do so without parsing what it has parsed before.
    ///
    /// # Errors
    /// Only where the host cannot go on; what the editor made of the file is the outcome.
    fn read_keyframes(&mut self, path: &Path) -> Result<Result<(), CommandError>, Self::Stop> {
        let bytes = self.read(FileAccess::KeyframesRead, path)?;
        Ok(self.editor().keyframes_read(path, bytes))
    }

    /// Writes a file. `None`: the user is asked first, and nothing is told to the editor.
    ///
    /// # Errors
    /// Only where the host cannot go on; a file that cannot be written is an outcome.
    fn write(&mut self, writing: Writing<'_>) -> Result<Option<FileOutcome<Written>>, Self::Stop>;

    /// Draws what is displayed, or without `has_overlays` the scene alone, and writes it to `path`; without one, to the first free name
    /// beside the keyframe file. Returns the path. `None`: it is being drawn, and the host tells the editor later.
    ///
    /// # Errors
    /// Only where the host cannot go on.
    fn take_screenshot(
        &mut self,
        path: Option<PathBuf>,
        has_overlays: bool,
    ) -> Result<Option<(PathBuf, FileOutcome<()>)>, Self::Stop>;

    /// Reads the pose of this name, or in this file.
    ///
    /// # Errors
    /// Only where the host cannot go on; a file that cannot be read is an outcome.
    fn read_pose(&mut self, name: &str) -> Result<FileOutcome<Vec<u8>>, Self::Stop>;

    /// Writes a pose under this name or to this file. Returns the path.
    ///
    /// # Errors
    /// Only where the host cannot go on; a file that cannot be written is an outcome.
    fn write_pose(&mut self, name: &str, text: &str) -> Result<FileOutcome<(PathBuf, Written)>, Self::Stop>;

    /// Writes the document as a model of another format, by the path's ending. Returns what to say of it.
    ///
    /// # Errors
    /// Only where the host cannot go on; a file that cannot be written is an outcome.
    fn write_model(&mut self, path: &Path) -> Result<FileOutcome<Vec<Message>>, Self::Stop>;

    /// The editor was told of a file; `told` is what it made of that.
    ///
    /// # Errors
    /// Where the host does not go on after such an error.
    fn told(&mut self, access: FileAccess, path: &Path, told: Result<(), CommandError>) -> Result<(), Self::Stop>;

    /// The window, or what answers in its place.
    fn window(&mut self) -> &mut dyn WindowHost;

    /// Performs an effect, and tells the editor what became of it.
    ///
    /// # Errors
    /// Why the host cannot go on.
    fn perform(&mut self, effect: Effect) -> Result<(), Self::Stop> {
        match effect {
            Effect::ReadKeyframes { path } => {
                let told = self.read_keyframes(&path)?;
                return self.told(FileAccess::KeyframesRead, &path, told);
            }
            Effect::ReadCompared { path } => {
                let bytes = self.read(FileAccess::ComparedRead, &path)?;
                let told = self.editor().compared_read(&path, bytes);
                return self.told(FileAccess::ComparedRead, &path, told);
            }
            Effect::ReadScene { path } => {
                let bytes = self.read(FileAccess::SceneRead, &path)?;
                let told = self.editor().scene_read(&path, bytes);
                return self.told(FileAccess::SceneRead, &path, told);
            }
            Effect::WriteKeyframes { path, text, is_known } => {
                let access = FileAccess::KeyframesWritten;
                let writing = Writing { access, path: &path, text: &text, meshes: None, is_known };
                if let Some(outcome) = self.write(writing)? {
                    let told = self.editor().keyframes_written(&path, outcome);
                    return self.told(access, &path, told);
                }
            }
            Effect::WriteScene { path, files: SceneFiles { text, meshes }, is_known } => {
                let access = FileAccess::SceneWritten;
                let writing = Writing { access, path: &path, text: &text, meshes: meshes.as_ref(), is_known };
                if let Some(outcome) = self.write(writing)? {
                    let told = self.editor().scene_written(&path, outcome);
                    return self.told(access, &path, told);
                }
            }
            Effect::Screenshot { path, has_overlays } => {
                if let Some((path, outcome)) = self.take_screenshot(path, has_overlays)? {
                    let told = self.editor().screenshot_taken(&path, outcome);
                    return self.told(FileAccess::ScreenshotTaken, &path, told);
                }
            }
            Effect::ReadPose(name) => {
                let outcome = self.read_pose(&name)?;
                // A command, so that a journal has what the file held.
                if let Ok(command) = self.editor().pose_read(&name, outcome) {
                    return self.carry_out(command);
                }
            }
            Effect::WritePose { name, text } => {
                let outcome = self.write_pose(&name, &text)?;
                let path = outcome.as_ref().map_or_else(|_| PathBuf::from(&name), |(path, _)| path.clone());
                let told = self.editor().pose_written(&name, outcome);
                return self.told(FileAccess::PoseWritten, &path, told);
            }
            Effect::WriteModel { path } => {
                let outcome = self.write_model(&path)?;
                let told = self.editor().model_written(&path, outcome);
                return self.told(FileAccess::ModelWritten, &path, told);
            }
            Effect::ChooseExportModel => self.window().ask_for_path(PathQuestion::ExportModel),
            Effect::ChooseOpen => self.window().ask_for_path(PathQuestion::Open),
            Effect::ChooseCompare => self.window().ask_for_path(PathQuestion::Compare),
            Effect::ChooseSaveAs => self.window().ask_for_path(PathQuestion::SaveAs),
            Effect::ChooseSaveSceneAs => self.window().ask_for_path(PathQuestion::SaveSceneAs),
            Effect::ChooseExport { proposed, is_folder } => {
                self.window().ask_for_path(PathQuestion::Export { proposed, is_folder });
            }
            Effect::Export(options) => self.window().begin_export(*options),
            Effect::CancelExport => self.window().cancel_export(),
            Effect::Quit => self.window().quit(),
            Effect::Window(command) => self.window().change_window(command),
        }
        Ok(())
    }

    /// Has the editor do a command and performs what it asks for. A refusal is the editor's message.
    ///
    /// # Errors
    /// Why the host cannot go on.
    fn carry_out(&mut self, command: Command) -> Result<(), Self::Stop> {
        match self.editor().apply(command) {
            Ok(Some(effect)) => self.perform(effect),
            Ok(None) | Err(_) => Ok(()),
        }
    }
}
