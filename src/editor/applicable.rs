//! Whether a command would do anything: what menus and buttons show as disabled.

use super::{
    Command, Edit, Editor, FileCommand, GestureCommand, Message, PlaybackCommand, SceneEdit, SkyMode, TimelineEdit,
    ViewCommand, WindowCommand,
};
use crate::keyframe::PlayRange;
use crate::words::texts;

impl Editor {
    /// Whether a command can do what it is for. Applying one that cannot is harmless: it is refused with a message, or changes nothing.
    #[must_use]
    pub fn can(&self, command: &Command) -> bool {
        let is_still = !self.is_playing();
        match command {
            Command::Edit(edit) => self.can_edit(edit),
            Command::Playback(PlaybackCommand::PlayOrStop) => {
                self.is_playing() || PlayRange::new(&self.document.keyframes).is_ok()
            }
            Command::Playback(PlaybackCommand::Scrub(_) | PlaybackCommand::PlayFromPlayhead) => {
                PlayRange::new(&self.document.keyframes).is_ok()
            }
            Command::Playback(PlaybackCommand::Step(_)) => is_still && PlayRange::new(&self.document.keyframes).is_ok(),
            Command::Playback(
                PlaybackCommand::SetMode(_)
                | PlaybackCommand::NextMode
                | PlaybackCommand::SetRange(_)
                | PlaybackCommand::SetSpeedPercent(_),
            ) => true,
            Command::Playback(PlaybackCommand::PauseOrResume) => self.is_playing() || self.is_paused(),
            Command::View(ViewCommand::ToggleSkyMode) => self.session.eye == 0 && self.session.chosen.is_none(),
            Command::File(FileCommand::Import | FileCommand::Open(_) | FileCommand::ChooseOpen)
            | Command::Gesture(GestureCommand::Begin) => is_still,
            Command::View(ViewCommand::CopyPose) => self.session.chosen.is_some(),
            Command::View(ViewCommand::CopyKeyframes) => !self.document.keyframes.is_empty(),
            Command::Window(WindowCommand::RenameCurrent) => is_still && !self.document.keyframes.is_empty(),
            Command::Window(WindowCommand::FitTimeline | WindowCommand::FitSelection) => {
                !self.document.keyframes.is_empty()
            }
            Command::View(_) | Command::File(_) | Command::Window(_) => true,
            Command::Gesture(_) => self.gesture.is_some(),
            Command::Undo => is_still && self.gesture.is_none() && self.undo_label().is_some(),
            Command::Redo => is_still && self.gesture.is_none() && self.redo_label().is_some(),
            Command::Cancel => self.gesture.is_some() || self.session.is_picking || self.session.shows_help,
        }
    }

    fn can_edit(&self, edit: &Edit) -> bool {
        let is_still = !self.is_playing();
        let keyframes = &self.document.keyframes;
        match edit {
            Edit::NextInterpolation
            | Edit::SetInterpolation(_)
            | Edit::Faster
            | Edit::Slower
            | Edit::SetMsBetweenKeyframes(_) => true,
            Edit::DisplayCurrent | Edit::DeleteCurrent => is_still && !keyframes.is_empty(),
            Edit::GoToNext => is_still && keyframes.current() != keyframes.last(),
            Edit::GoToPrevious => is_still && keyframes.current().is_some_and(|current| current.get() > 0),
            Edit::GoTo(index) => is_still && keyframes.get(*index).is_some(),
            Edit::RotateChosen { .. } | Edit::TranslateChosen(_) => is_still && self.session.chosen.is_some(),
            Edit::Timeline(TimelineEdit::DeleteKeyframes) => {
                is_still && !(keyframes.is_empty() && self.session.selected_keys.is_empty())
            }
            Edit::Scene(SceneEdit::PutControlAboveChosen) => is_still && self.session.chosen.is_some(),
            Edit::Scene(_) => is_still,
            Edit::Timeline(TimelineEdit::PasteKeyframes) => is_still && self.has_copied_keyframes(),
            Edit::Timeline(TimelineEdit::PastePose) => {
                is_still && self.has_copied_pose() && self.session.chosen.is_some()
            }
            Edit::Timeline(_) => is_still && !keyframes.is_empty(),
            Edit::UpdateCurrent
            | Edit::CreateKeyframe
            | Edit::ResetPose
            | Edit::SetTranslation(..)
            | Edit::SetRotation(..)
            | Edit::Wheel(_) => is_still,
        }
    }

    /// What the eye is and how a drag moves, in a few words: `sky view · world-sky`.
    #[must_use]
    pub fn view_sentence(&self) -> Message {
        let eye = self.document.scene.node(self.document.scene.rbt_node(self.eye())).name.as_str();
        let moves: Message = match (self.session.chosen, self.session.eye, self.session.sky_mode) {
            (Some(chosen), ..) => texts::moves_node(self.document.scene.rbt_path(chosen)),
            (None, 0, SkyMode::WorldCentre) => texts::WORLD_SKY.into(),
            (None, 0, SkyMode::Eye) => texts::SKY_SKY.into(),
            (None, ..) => texts::MOVES_ITSELF.into(),
        };
        texts::view_of(eye, moves)
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;
    use std::sync::Arc;

    use super::*;
    use crate::editor::keymap::bindings;

    fn editor(keyframes: usize) -> Editor {
        let mut editor = Editor::new(
            Arc::new(crate::scene::built_in_scene(crate::scene::DEFAULT_SCENE).unwrap()),
            PathBuf::from("animation.json"),
        );
        for _ in 0..keyframes {
            editor.apply(Command::Edit(Edit::CreateKeyframe)).unwrap();
        }
        editor
    }

    #[test]
    fn what_is_refused_is_shown_as_disabled() {
        let mut playing = editor(4);
        playing.apply(Command::Playback(PlaybackCommand::PlayOrStop)).unwrap();
        for editor in [editor(0), editor(1), editor(4), playing] {
            for binding in bindings() {
                let is_refused = editor.clone().apply(binding.command.clone()).is_err();
                assert!(!(is_refused && editor.can(&binding.command)), "{} is refused but not disabled", binding.name);
            }
        }
    }

    #[test]
    fn the_view_is_named() {
        let mut editor = editor(0);
        assert_eq!(editor.view_sentence().to_string(), "sky view · world-sky");
        editor.apply(Command::View(ViewCommand::ToggleSkyMode)).unwrap();
        assert_eq!(editor.view_sentence().to_string(), "sky view · sky-sky");
        editor.apply(Command::View(ViewCommand::NextEye)).unwrap();
        assert_eq!(editor.view_sentence().to_string(), "robot1 view · moves itself");
    }
}
