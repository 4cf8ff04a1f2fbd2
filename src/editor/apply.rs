//! Dispatch of commands, and the handlers of pose and keyframe edits.

use super::commands::{Row, row_of};
use super::gizmo::{GizmoAxes, SnapSteps};
use super::history::Run;
use super::keymap::Keymap;
use super::{
    ClipboardCommand, Command, CommandError, Document, Edit, Editor, Effect, GestureCommand, Message, PlaybackCommand,
    SelectionCommand, ViewCommand,
};
use crate::keyframe::{Keyframe, KeyframeIndex, MS_BETWEEN_KEYFRAMES_RANGE};
use crate::rbt::Rbt;
use crate::rotation_rules::unit;
use crate::words::{Argument, Phrase, texts};

/// Change of the ms between keyframes by one `+` or `-`, in milliseconds.
const MS_STEP: u32 = 100;

/// The message of a command, if it has one, or the reason why it was refused.
pub(super) type CommandResult = Result<Option<Message>, CommandError>;

impl Editor {
    /// Runs a command, and returns the effect that the host must perform. Afterwards, [`Editor::message`] is its message or its refusal.
    /// Without a message, a drag leaves the status line unchanged once it has begun, and any other command clears it.
    ///
    /// # Errors
    /// Why the command was refused. The document is then unchanged, except that a running drag may have been committed.
    pub fn apply(&mut self, command: Command) -> Result<Option<Effect>, CommandError> {
        let is_drag = matches!(&command, Command::Gesture(gesture) if *gesture != GestureCommand::Begin);
        self.message = None;
        let outcome = self.dispatch(command);
        self.fit_session_to_list();
        match &outcome {
            Ok((Some(message), _)) => self.say(message.clone()),
            Ok((None, _)) if is_drag => {}
            Ok((None, _)) => (self.message, self.status) = (None, None),
            Err(error) => self.say_error(error),
        }
        outcome.map(|(_, effect)| effect)
    }

    /// Reports a message: it goes to the log and the status line.
    pub fn say(&mut self, message: impl Into<Message>) {
        let message = message.into();
        self.said.push(message.clone());
        self.status = Some(message.clone());
        self.message = Some(message);
    }

    pub(super) fn say_error(&mut self, error: &CommandError) {
        self.say(error.message());
    }

    fn dispatch(&mut self, command: Command) -> Result<(Option<Message>, Option<Effect>), CommandError> {
        let without_effect = |result: CommandResult| result.map(|said| (said, None));
        let row = row_of(&command);
        // What moves the work eye changes no node.
        let moves_work_eye =
            self.dragged_node().is_none() && matches!(command, Command::Gesture(_) | Command::Edit(Edit::Wheel(_)));
        if let Some(what) = row.refused_while_playing.filter(|_| !moves_work_eye) {
            self.refuse_while_playing(what)?;
        }
        match command {
            Command::Edit(edit) => without_effect(self.edit(edit, row)),
            Command::Playback(playback) => without_effect(self.play(playback)),
            Command::View(view) => without_effect(self.view(view)),
            Command::Selection(SelectionCommand::Keyframes(selected)) => without_effect(self.select(selected)),
            Command::Selection(SelectionCommand::TimedKeys(keys)) => without_effect(self.select_keys(keys)),
            Command::Clipboard(ClipboardCommand::CopyKeyframes) => without_effect(self.copy_keyframes()),
            Command::Clipboard(ClipboardCommand::CopyPose(node)) => without_effect(self.copy_pose(node)),
            Command::File(file) => Ok((None, Some(self.file(file)?))),
            Command::Gesture(gesture) => without_effect(self.gesture(gesture)),
            Command::Undo => without_effect(self.undo()),
            Command::Redo => without_effect(self.redo()),
            Command::Cancel => without_effect(Ok(self.cancel())),
            Command::Window(command) => Ok((None, Some(Effect::Window(command)))),
        }
    }

    /// Replaces the keymap. Messages name hotkeys by it.
    pub fn set_keymap(&mut self, keymap: Keymap) {
        self.keymap = keymap;
    }

    /// Sets what handles go by, as settings have it.
    pub fn set_handles(&mut self, axes: GizmoAxes, snap: SnapSteps) {
        self.session.gizmo_axes = axes;
        self.session.snap = snap.in_range_or(self.session.snap);
    }

    /// The hotkey of a command for use in a message; its name if it has no hotkey; empty if the keymap does not list the command.
    pub(super) fn key_of(&self, command: &Command) -> Argument {
        match self.keymap.bindings().iter().find(|binding| binding.command == *command) {
            Some(binding) if binding.chords.is_empty() => texts::hotkeys_command_without_key(binding.title()).into(),
            Some(binding) => binding.menu_key().into(),
            None => "".into(),
        }
    }

    pub(super) fn no_keyframe(&self) -> CommandError {
        CommandError::NoKeyframe { create: self.key_of(&Command::Edit(Edit::CreateKeyframe)) }
    }

    pub(super) fn too_few_to_play(&self) -> CommandError {
        CommandError::TooFewToPlay { create: self.key_of(&Command::Edit(Edit::CreateKeyframe)) }
    }

    pub(super) fn nothing_chosen(&self) -> CommandError {
        CommandError::NothingChosen { pick: self.key_of(&Command::View(ViewCommand::StartPicking)) }
    }

    pub(super) fn refuse_while_playing(&self, what: Phrase) -> Result<(), CommandError> {
        if !self.is_playing() {
            return Ok(());
        }
        let stop = self.key_of(&Command::Playback(PlaybackCommand::PlayOrStop));
        let pause = self.key_of(&Command::Playback(PlaybackCommand::PauseOrResume));
        Err(CommandError::WhilePlaying { what, stop, pause })
    }

    fn edit(&mut self, edit: Edit, row: &Row) -> CommandResult {
        if !row.is_continuous {
            self.commit_gesture();
        }
        match edit {
            Edit::Pose(pose) => self.apply_pose(&pose),
            Edit::Nodes(edit, node) => self.edit_nodes(edit, node),
            Edit::Timeline(edit) => self.edit_timeline(edit, row),
            Edit::Scene(edit) => self.edit_scene(edit),
            Edit::DisplayCurrent => self.display_current(),
            Edit::UpdateCurrent => self.update_current(),
            Edit::CreateKeyframe => self.create_keyframe(),
            Edit::GoToNext => self.step(1),
            Edit::GoToPrevious => self.step(-1),
            Edit::GoToFirst => self.go_to_end(true),
            Edit::GoToLast => self.go_to_end(false),
            Edit::GoTo(index) => self.go_to(index),
            Edit::DeleteCurrent => self.delete_current(),
            Edit::ResetPose => {
                self.end_scrub();
                let rest = self.document.scene.rest_pose().clone();
                self.record(texts::ACT_RETURN_TO_THE_REST_POSE, None, |document| document.live_pose = rest)?;
                Ok(Some(texts::POSE_IS_REST.into()))
            }
            Edit::BeginAnew => self.begin_anew(),
            Edit::NextInterpolation => self.set_interpolation(self.document.interpolation.next()),
            Edit::SetInterpolation(interpolation) => self.set_interpolation(interpolation),
            Edit::Faster => self.set_ms(self.document.ms_between_keyframes.saturating_sub(MS_STEP)),
            Edit::Slower => self.set_ms(self.document.ms_between_keyframes.saturating_add(MS_STEP)),
            Edit::SetMsBetweenKeyframes(ms) => self.set_ms(ms),
            Edit::SetTranslation(rbt, translation) => {
                self.change_node(rbt, |from| Rbt { translation, ..from }, texts::ACT_MOVE_A_NODE)
            }
            Edit::SetRotation(rbt, rotation) => {
                let rotation = unit(rotation).ok_or(CommandError::NotAValue { what: texts::VALUE_ROTATION })?;
                self.change_node(rbt, |from| Rbt { rotation, ..from }, texts::ACT_TURN_A_NODE)
            }
            Edit::RotateChosen { axis_in_node, radians } => self.rotate_chosen(axis_in_node, radians),
            Edit::TranslateChosen(by) => self.translate_chosen(by),
            Edit::Reach(last, target_in_world) => self.reach(last, target_in_world),
            Edit::ReachBy(last, by_in_world) => self.reach_by(last, by_in_world),
            Edit::TurnPole(last, degrees) => self.turn_pole(last, degrees),
            Edit::PullChosen(pull) => self.pull_chosen(pull),
            Edit::Wheel(motion) => {
                if self.dragged_node().is_none() {
                    return self.set_work_eye(self.session.work_eye.moved(motion));
                }
                let moved = self.moved(motion);
                self.change_nodes(moved, texts::ACT_MOVE_ALONG_THE_VIEW, Some(Run::Wheel))
            }
        }
    }

    /// Changes the document as one undo step. During a drag, changes join the drag's undo step.
    ///
    /// # Errors
    /// [`CommandError::KeyframesTooLarge`], [`CommandError::SceneTooLarge`]; the document is then unchanged.
    pub(super) fn record(
        &mut self,
        label: Phrase,
        run: Option<Run>,
        change: impl FnOnce(&mut Document),
    ) -> Result<(), CommandError> {
        let before = self.document.clone();
        change(&mut self.document);
        if let Some(error) = self.document.too_large_after(&before) {
            self.document = before;
            return Err(error);
        }
        self.record_since(before, label, run);
        Ok(())
    }

    /// Makes what changed since `before` one undo step, or a part of the drag's.
    pub(super) fn record_since(&mut self, before: Document, label: Phrase, run: Option<Run>) {
        match &mut self.gesture {
            None => self.history.record(before, &self.document, label, run),
            Some(gesture) => gesture.label = label,
        }
    }

    /// Copies a keyframe's pose to the scene. Adds an undo step only if unsaved posing is lost.
    pub(super) fn show_keyframe(&mut self, label: Phrase, index: KeyframeIndex) {
        self.end_scrub();
        let discards = self.document.has_unsaved_posing(self.document.scene.rest_pose());
        let before = self.document.clone();
        if !self.document.keyframes.set_current(index) {
            return;
        }
        if let Some(keyframe) = self.document.keyframes.current_keyframe() {
            self.document.live_pose = keyframe.pose.clone();
        }
        if discards {
            self.history.record(before, &self.document, label, None);
        }
        self.history.end_run();
    }

    /// The current keyframe and the range of the list: `Keyframe 3 (0 to 5)`.
    #[must_use]
    pub fn position_message(&self) -> Message {
        match (self.document.keyframes.current(), self.document.keyframes.last()) {
            (Some(current), Some(last)) => texts::position_keyframe(current.get(), last.get()),
            _ => texts::POSITION_NO_KEYFRAMES.into(),
        }
    }

    /// A message about the current keyframe: where it is, then what was done.
    pub(super) fn with_position(&self, what_happened: impl Into<Argument>) -> Message {
        texts::at_position(self.position_message(), what_happened)
    }

    fn display_current(&mut self) -> CommandResult {
        let current = self.document.keyframes.current().ok_or_else(|| self.no_keyframe())?;
        self.show_keyframe(texts::ACT_DISPLAY_OF_A_KEYFRAME, current);
        Ok(Some(self.with_position(texts::KEYFRAME_COPIED)))
    }

    fn update_current(&mut self) -> CommandResult {
        let Some(current) = self.document.keyframes.current_keyframe().cloned() else { return self.create_keyframe() };
        let scrubbed = self.end_scrub();
        self.record(texts::ACT_UPDATE_OF_A_KEYFRAME, None, |document| {
            if let Some(pose) = scrubbed {
                document.live_pose = pose;
            }
            if let Some(index) = document.keyframes.current() {
                document.keyframes.replace(index, current.with_pose(document.live_pose.clone()));
            }
        })?;
        Ok(Some(self.with_position(texts::KEYFRAME_UPDATED)))
    }

    fn create_keyframe(&mut self) -> CommandResult {
        // While scrubbed: insert after the keyframe at or to the left of the playhead, with the displayed pose.
        let left = self.playhead().filter(|_| self.is_scrubbed()).map(|key_time| key_time as usize + 1);
        let after = left.map(KeyframeIndex::new).or(self.document.keyframes.current());
        let scrubbed = self.end_scrub();
        self.record(texts::ACT_NEW_KEYFRAME, None, |document| {
            if let (Some(pose), Some(after)) = (scrubbed, after) {
                document.live_pose = pose;
                document.keyframes.set_current(after);
            }
            let pose = document.live_pose.clone();
            document.keyframes.insert_after_current(Keyframe::new(pose));
        })?;
        self.session.selected.clear();
        Ok(Some(match after {
            Some(after) => self.with_position(texts::keyframe_created(after.get())),
            None => self.with_position(texts::KEYFRAME_CREATED_FIRST),
        }))
    }

    fn step(&mut self, by: isize) -> CommandResult {
        let Some(current) = self.document.keyframes.current() else {
            return Ok(Some(self.with_position(texts::KEYFRAME_NOTHING_TO_GO_TO)));
        };
        let target = current.get().checked_add_signed(by).filter(|&index| index < self.document.keyframes.len());
        match target {
            Some(index) => self.go_to(KeyframeIndex::new(index)),
            None if by > 0 => Ok(Some(texts::keyframe_is_last(current.get()))),
            None => Ok(Some(texts::keyframe_is_first(current.get()))),
        }
    }

    fn go_to_end(&mut self, is_first: bool) -> CommandResult {
        let last = self.document.keyframes.last().ok_or_else(|| self.no_keyframe())?;
        self.go_to(if is_first { KeyframeIndex::new(0) } else { last })
    }

    fn go_to(&mut self, index: KeyframeIndex) -> CommandResult {
        let count = self.document.keyframes.len();
        if index.get() >= count {
            return Err(CommandError::NoSuchKeyframe { index: index.get(), count });
        }
        self.show_keyframe(texts::ACT_STEP_TO_ANOTHER_KEYFRAME, index);
        // The next edit applies to the selection. Clear it, because the user expects the new current keyframe.
        if !self.session.selected.contains(&index) {
            self.session.selected.clear();
        }
        Ok(Some(self.with_position(texts::KEYFRAME_COPIED)))
    }

    fn delete_current(&mut self) -> CommandResult {
        self.end_scrub();
        let deleted = self.document.keyframes.current().ok_or(CommandError::NothingToDelete)?;
        self.session.selected.clear();
        self.record(texts::ACT_DELETION_OF_A_KEYFRAME, None, |document| {
            document.keyframes.delete_current();
            if let Some(keyframe) = document.keyframes.current_keyframe() {
                document.live_pose = keyframe.pose.clone();
            }
        })?;
        Ok(Some(texts::keyframe_deleted(deleted.get(), self.position_message())))
    }

    fn set_interpolation(&mut self, interpolation: crate::interpolation::Interpolation) -> CommandResult {
        self.record(texts::ACT_CHANGE_OF_INTERPOLATION, None, |document| document.interpolation = interpolation)?;
        Ok(Some(texts::interpolation_is(interpolation.title())))
    }

    fn set_ms(&mut self, ms: u32) -> CommandResult {
        let (fastest, slowest) = (*MS_BETWEEN_KEYFRAMES_RANGE.start(), *MS_BETWEEN_KEYFRAMES_RANGE.end());
        let ms = ms.clamp(fastest, slowest);
        let was = self.document.ms_between_keyframes;
        self.record(texts::ACT_CHANGE_OF_PACE, Some(Run::MsBetweenKeyframes), |document| {
            document.ms_between_keyframes = ms;
        })?;
        self.refit_pace();
        Ok(Some(match ms {
            _ if was == ms && ms == fastest => texts::pace_fastest(ms),
            _ if was == ms && ms == slowest => texts::pace_slowest(ms),
            _ => texts::pace_is(ms),
        }))
    }
}
