//! File commands: the effects they need, and the handling of their results.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::apply::CommandResult;
use super::playback::Playback;
use super::{CommandError, Document, Editor, Effect, FileCommand, Message, Severity, Written};
use crate::keyframe::{KeyframeList, KeyframesText, LARGEST_FILE_BYTES};
use crate::scene::{SceneFiles, scene_from_bytes};
use crate::text_layouts::{ImportError, Imported, Options, import};
use crate::words::texts;

/// The name of a new animation's keyframe file.
pub const NEW_FILE: &str = "animation.json";
/// The endings of models and motions of other formats, which are read and written.
pub const MODEL_ENDINGS: [&str; 3] = ["glb", "gltf", "bvh"];

impl Editor {
    /// Begins a new animation of the scene. Undo brings the old one back; the file stays the new one's.
    pub(super) fn begin_anew(&mut self) -> CommandResult {
        let new = Document::new(Arc::clone(&self.document.scene));
        self.record(texts::ACT_NEW_ANIMATION, None, |document| *document = new)?;
        self.playback = Playback::Stopped;
        self.is_now_saved_in(self.keyframe_file.with_file_name(NEW_FILE));
        self.is_file_known = false;
        self.fit_session_to_list();
        Ok(Some(texts::FILE_NEW.into()))
    }

    pub(super) fn file(&mut self, command: FileCommand) -> Result<Effect, CommandError> {
        Ok(match command {
            FileCommand::Import => {
                self.commit_gesture();
                Effect::ReadKeyframes { path: self.keyframe_file.clone() }
            }
            FileCommand::Open(path) => {
                self.commit_gesture();
                Effect::ReadKeyframes { path }
            }
            FileCommand::ChooseCompare => Effect::ChooseCompare,
            FileCommand::CompareWith(path) => Effect::ReadCompared { path },
            FileCommand::Write => self.write_effect(self.keyframe_file.clone()),
            FileCommand::SaveAs(path) => self.write_effect(path),
            FileCommand::ChooseOpen => Effect::ChooseOpen,
            FileCommand::ChooseSaveAs => Effect::ChooseSaveAs,
            FileCommand::WriteScene => match self.scene_path.clone() {
                Some(path) => self.write_scene_effect(path),
                None => Effect::ChooseSaveSceneAs,
            },
            FileCommand::ReloadScene => {
                self.commit_gesture();
                Effect::ReadScene { path: self.scene_path.clone().ok_or(CommandError::NoSceneFile)? }
            }
            FileCommand::ChooseSaveSceneAs => Effect::ChooseSaveSceneAs,
            FileCommand::SaveSceneAs(path) => self.write_scene_effect(path),
            FileCommand::ChooseExportModel => Effect::ChooseExportModel,
            FileCommand::ExportModel(path) => {
                self.commit_gesture();
                Effect::WriteModel { path }
            }
            FileCommand::ApplyPose(name) => Effect::ReadPose(name),
            FileCommand::SavePose(name) => self.save_pose(name)?,
            FileCommand::Screenshot { path, has_overlays } => Effect::Screenshot { path, has_overlays },
            FileCommand::Export(options) => Effect::Export(options),
            FileCommand::CancelExport => Effect::CancelExport,
            FileCommand::ChooseExport { proposed, is_folder } => Effect::ChooseExport { proposed, is_folder },
            FileCommand::Quit => Effect::Quit,
        })
    }

    fn write_effect(&mut self, path: PathBuf) -> Effect {
        self.commit_gesture();
        let is_known = self.is_file_known && path == self.keyframe_file;
        Effect::WriteKeyframes { is_known, path, text: self.keyframes_text() }
    }

    fn keyframes_text(&self) -> KeyframesText {
        let document = &self.document;
        KeyframesText {
            scene: Arc::clone(&document.scene),
            keyframes: document.keyframes.clone(),
            interpolation: document.interpolation,
            ms_between_keyframes: document.ms_between_keyframes,
        }
    }

    fn write_scene_effect(&mut self, path: PathBuf) -> Effect {
        self.commit_gesture();
        let is_known = self.scene_path.as_ref() == Some(&path);
        Effect::WriteScene { files: SceneFiles::new(&self.document.scene, &path), path, is_known }
    }

    /// The default path for saving the scene: its own file, or a file named after the scene beside the keyframe file.
    #[must_use]
    pub fn proposed_scene_path(&self) -> PathBuf {
        self.scene_path
            .clone()
            .unwrap_or_else(|| self.keyframe_file.with_file_name(format!("{}.json", self.scene().name())))
    }

    /// Takes in that the scene's file was written, or why it could not be. It becomes the scene's own.
    ///
    /// # Errors
    /// Why the file is as it was.
    pub fn scene_written(&mut self, path: &Path, outcome: Result<Written, Message>) -> Result<(), CommandError> {
        match outcome {
            Ok(Written { kept, other_links, kept_meshes }) => {
                let said = match kept {
                    Some(kept) => texts::file_scene_written_over(path.display(), kept.display()),
                    None => texts::file_scene_written(path.display()),
                };
                let said = with_other_links(said, other_links);
                self.say_outcome(match kept_meshes {
                    Some(kept) => texts::file_meshes_kept(said, kept.display()),
                    None => said,
                });
                self.scene_path = Some(path.to_owned());
                self.saved_scene = Arc::clone(&self.document.scene);
                Ok(())
            }
            Err(reason) => self.not_written(path, reason),
        }
    }

    fn not_written(&mut self, path: &Path, reason: Message) -> Result<(), CommandError> {
        let error = CommandError::Write { path: path.to_owned(), reason };
        self.say_error(&error);
        Err(error)
    }

    /// Takes in a scene file that was read, or why it could not be. Poses and keyframes stay as they are.
    ///
    /// # Errors
    /// Why the scene is as it was: the file cannot be read, or its scene has other RBT nodes or eyes.
    pub fn scene_read(&mut self, path: &Path, bytes: Result<Vec<u8>, Message>) -> Result<(), CommandError> {
        let outcome = self.reload_scene(path, bytes);
        match &outcome {
            Ok(()) => self.say_outcome(texts::file_scene_read(path.display())),
            Err(error) => self.say_error(error),
        }
        outcome
    }

    fn reload_scene(&mut self, path: &Path, bytes: Result<Vec<u8>, Message>) -> Result<(), CommandError> {
        self.refuse_while_playing(texts::ACT_RELOAD_THE_SCENE)?;
        let path = path.to_owned();
        let unread = |reason| CommandError::Read { path: path.clone(), reason };
        let bytes = bytes.map_err(unread)?;
        let scene = scene_from_bytes(&bytes).map_err(|error| unread(error.message()))?;
        if !scene.has_rbts_of(&self.document.scene) || scene.eyes() != self.document.scene.eyes() {
            return Err(CommandError::OtherScene { path });
        }
        self.record(texts::ACT_RELOADING_OF_THE_SCENE, None, |document| document.scene = Arc::new(scene))?;
        self.saved_scene = Arc::clone(&self.document.scene);
        self.scene_path = Some(path);
        self.fit_session_to_list();
        Ok(())
    }

    /// Takes in a keyframe file that was read, or why it could not be. It becomes the file that is written.
    ///
    /// # Errors
    /// Why nothing was imported; the list is as it was then.
    pub fn keyframes_read(&mut self, path: &Path, bytes: Result<Vec<u8>, Message>) -> Result<(), CommandError> {
        let read = bytes.map(|bytes| import(&bytes, &self.document.scene, &Options::of_keyframes()));
        self.keyframes_parsed(path, read)
    }

    /// Like [`Self::keyframes_read`], of a file that was already parsed for this scene with the usual options.
    ///
    /// # Errors
    /// Why nothing was imported; the list is as it was then.
    pub fn keyframes_parsed(
        &mut self,
        path: &Path,
        read: Result<Result<Imported, ImportError>, Message>,
    ) -> Result<(), CommandError> {
        let outcome = self.import(path, read);
        match &outcome {
            Ok(message) => self.say_outcome(message.clone()),
            Err(error) => self.say_error(error),
        }
        outcome.map(|_| ())
    }

    fn import(
        &mut self,
        path: &Path,
        read: Result<Result<Imported, ImportError>, Message>,
    ) -> Result<Message, CommandError> {
        self.refuse_while_playing(texts::ACT_IMPORT)?;
        let path = path.to_owned();
        let imported = read.map_err(|reason| CommandError::Read { path: path.clone(), reason })?;
        let (file, report) = match imported {
            Ok(Imported::KeyframeFile(file)) => (file, None),
            Ok(Imported::Text(file, report)) => (file, Some(report)),
            Ok(Imported::Scene(..)) => return Err(CommandError::HoldsScene { path }),
            Err(ImportError::KeyframeFile(problems)) => return Err(CommandError::File { path, problems }),
            Err(ImportError::Text(problem)) => return Err(CommandError::Text { path, problem }),
        };
        let what = texts::count_keyframes(file.keyframes.len());
        let before = self.document.clone();
        let document = &mut self.document;
        document.interpolation = file.interpolation.unwrap_or(document.interpolation);
        document.ms_between_keyframes = file.ms_between_keyframes.unwrap_or(document.ms_between_keyframes);
        document.install_list(KeyframeList::new(file.keyframes));
        // A file of short numbers may be longer by the bound than it is: reading it took as long as counting.
        if !self.keyframes_text().can_be_read() {
            self.document = before;
            return Err(CommandError::KeyframesTooLarge { limit: LARGEST_FILE_BYTES });
        }
        self.record_since(before, texts::ACT_IMPORT, None);
        self.playback = Playback::Stopped;
        // A file that was imported from another layout is copied before it is overwritten.
        let is_known = report.is_none();
        let said = match report {
            None => texts::file_imported(what, path.display()),
            Some(report) if report.has_warnings() => {
                texts::file_imported_text_with_warnings(what, path.display(), report.summary)
            }
            Some(report) => texts::file_imported_text(what, path.display(), report.summary),
        };
        self.is_now_saved_in(path);
        self.is_file_known = is_known;
        self.fit_session_to_list();
        Ok(said)
    }

    /// Takes in that the keyframe file was written, or why it could not be. It becomes the file that is written.
    ///
    /// # Errors
    /// Why the file is as it was.
    pub fn keyframes_written(&mut self, path: &Path, outcome: Result<Written, Message>) -> Result<(), CommandError> {
        match outcome {
            Ok(Written { kept, other_links, .. }) => {
                let what = texts::count_keyframes(self.document.keyframes.len());
                let said = match kept {
                    Some(kept) => texts::file_written_over(what, path.display(), kept.display()),
                    None => texts::file_written(what, path.display()),
                };
                self.say_outcome(with_other_links(said, other_links));
                self.is_now_saved_in(path.to_owned());
                Ok(())
            }
            Err(reason) => self.not_written(path, reason),
        }
    }

    /// Takes in where the screenshot was written, or why it could not be.
    ///
    /// # Errors
    /// Why there is no picture.
    pub fn screenshot_taken(&mut self, path: &Path, outcome: Result<(), Message>) -> Result<(), CommandError> {
        match outcome {
            Ok(()) => {
                self.say_outcome(texts::file_screenshot(path.display()));
                Ok(())
            }
            Err(reason) => self.not_written(path, reason),
        }
    }

    /// Takes in what was written as a model of another format, or why nothing was.
    ///
    /// # Errors
    /// Why the file is as it was.
    pub fn model_written(&mut self, path: &Path, outcome: Result<Vec<Message>, Message>) -> Result<(), CommandError> {
        match outcome {
            Ok(said) => {
                for said in said {
                    self.say_outcome(said);
                }
                Ok(())
            }
            Err(reason) => self.not_written(path, reason),
        }
    }

    /// Says what became of something outside.
    pub(super) fn say_outcome(&mut self, message: impl Into<Message>) {
        self.say(message.into().with_severity(Severity::Outcome));
    }

    fn is_now_saved_in(&mut self, path: PathBuf) {
        self.keyframe_file = path;
        self.saved = self.document.clone();
        self.is_file_known = true;
    }
}

/// Says of a file that was replaced that it has other names, which do not lead to the new content.
fn with_other_links(said: Message, other_links: u64) -> Message {
    match usize::try_from(other_links).unwrap_or(usize::MAX) {
        0 => said,
        count => texts::file_other_links(said, count),
    }
}
