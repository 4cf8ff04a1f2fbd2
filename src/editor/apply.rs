//! What each command does.

use glam::Quat;

use super::commands::{Row, row_of};
use super::history::Run;
use super::keymap::Keymap;
use super::playback::Playback;
use super::{Command, CommandError, Document, Edit, Editor, Effect, Message, PlaybackCommand, Severity, ViewCommand};
use crate::keyframe::{Keyframe, KeyframeIndex, KeyframeList, MS_BETWEEN_KEYFRAMES_RANGE};
use crate::pose::RbtIndex;
use crate::rbt::Rbt;
use crate::rotation_rules::unit;

/// How much `+` and `-` change the ms between keyframes.
const MS_STEP: u32 = 100;

pub(super) type Outcome = Result<String, CommandError>;

impl Editor {
    /// Does a command, and returns what is to be done outside for it. What it says is the message afterwards, in either outcome.
    ///
    /// # Errors
    /// Why the command was refused; nothing has changed then.
    pub fn apply(&mut self, command: Command) -> Result<Option<Effect>, CommandError> {
        let outcome = self.dispatch(command);
        self.fit_session_to_list();
        match &outcome {
            Ok((text, _)) => self.say(text.clone()),
            Err(error) => self.say_error(error),
        }
        outcome.map(|(_, effect)| effect)
    }

    /// Says something as the editor would, for the log and the status line.
    pub fn say_of(&mut self, severity: Severity, text: String) {
        if !text.is_empty() {
            self.said.push(Message { text: text.clone(), severity });
        }
        self.message = Message { text, severity };
    }

    pub(super) fn say(&mut self, text: String) {
        self.say_of(Severity::Information, text);
    }

    pub(super) fn say_error(&mut self, error: &CommandError) {
        self.say_of(Severity::Error, error.to_string());
    }

    fn dispatch(&mut self, command: Command) -> Result<(String, Option<Effect>), CommandError> {
        let silent = |outcome: Outcome| outcome.map(|text| (text, None));
        let row = row_of(&command);
        if let Some(what) = row.refused_while_playing {
            self.refuse_while_playing(what)?;
        }
        match command {
            Command::Edit(edit) => silent(self.edit(edit, row)),
            Command::Playback(playback) => silent(self.play(playback)),
            Command::View(view) => silent(self.view(view)),
            Command::File(file) => Ok((String::new(), Some(self.file(file)))),
            Command::Gesture(gesture) => silent(self.gesture(gesture)),
            Command::Undo => silent(self.undo()),
            Command::Redo => silent(self.redo()),
            Command::Cancel => silent(Ok(self.cancel())),
            Command::Window(command) => Ok((String::new(), Some(Effect::Window(command)))),
        }
    }

    /// Puts other keys in force: what is said names those.
    pub fn set_keymap(&mut self, keymap: Keymap) {
        self.keymap = keymap;
    }

    /// The key of a command as a sentence names it; where it has none, its name.
    pub(super) fn key_of(&self, command: &Command) -> String {
        let binding = self.keymap.bindings().iter().find(|binding| binding.command == *command);
        binding
            .map(|binding| if binding.chords.is_empty() { format!("“{}”", binding.name) } else { binding.menu_key() })
            .unwrap_or_default()
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

    pub(super) fn refuse_while_playing(&self, what: &'static str) -> Result<(), CommandError> {
        if !self.is_playing() {
            return Ok(());
        }
        let stop = self.key_of(&Command::Playback(PlaybackCommand::PlayOrStop));
        let pause = self.key_of(&Command::Playback(PlaybackCommand::PauseOrResume));
        Err(CommandError::WhilePlaying { what, stop, pause })
    }

    fn edit(&mut self, edit: Edit, row: &Row) -> Outcome {
        if !row.is_continuous {
            self.commit_gesture();
        }
        match edit {
            Edit::Timeline(edit) => self.edit_timeline(edit, row),
            Edit::Scene(edit) => self.edit_scene(edit),
            Edit::DisplayCurrent => self.display_current(),
            Edit::UpdateCurrent => Ok(self.update_current()),
            Edit::CreateKeyframe => Ok(self.create_keyframe()),
            Edit::GoToNext => self.step(1),
            Edit::GoToPrevious => self.step(-1),
            Edit::GoToFirst => self.go_to_end(true),
            Edit::GoToLast => self.go_to_end(false),
            Edit::GoTo(index) => self.go_to(index),
            Edit::DeleteCurrent => self.delete_current(),
            Edit::ResetPose => {
                self.end_scrub();
                let rest = self.document.scene.rest_pose().clone();
                self.record("return to the rest pose", None, |document| document.live_pose = rest);
                Ok("The scene is back in its rest pose.".to_owned())
            }
            Edit::NextInterpolation => Ok(self.set_interpolation(self.document.interpolation.next())),
            Edit::SetInterpolation(interpolation) => Ok(self.set_interpolation(interpolation)),
            Edit::Faster => Ok(self.set_ms(self.document.ms_between_keyframes.saturating_sub(MS_STEP))),
            Edit::Slower => Ok(self.set_ms(self.document.ms_between_keyframes.saturating_add(MS_STEP))),
            Edit::SetMsBetweenKeyframes(ms) => Ok(self.set_ms(ms)),
            Edit::SetTranslation(rbt, translation) => {
                self.place(rbt, |parent_from_node| Rbt { translation, ..parent_from_node }, "move a node", None)
            }
            Edit::SetRotation(rbt, rotation) => {
                let rotation = unit(rotation).ok_or(CommandError::NotAValue { what: "rotation" })?;
                self.place(rbt, |parent_from_node| Rbt { rotation, ..parent_from_node }, "turn a node", None)
            }
            Edit::RotateChosen { axis_in_node, radians } => {
                let chosen = self.session.chosen.ok_or_else(|| self.nothing_chosen())?;
                let turn = unit(Quat::from_axis_angle(axis_in_node, radians))
                    .ok_or(CommandError::NotAValue { what: "rotation" })?;
                let turned = |from: Rbt| Rbt { rotation: from.rotation * turn, ..from }.renormalized();
                self.place(chosen, turned, "turn a node", None)
            }
            Edit::TranslateChosen(by) => {
                let chosen = self.session.chosen.ok_or_else(|| self.nothing_chosen())?;
                self.place(chosen, |from| Rbt { translation: from.translation + by, ..from }, "move a node", None)
            }
            Edit::Wheel(motion) => {
                let moved = self.moved(motion);
                self.place(self.node_at_hand(), |_| moved, "move along the view", Some(Run::Wheel))
            }
        }
    }

    /// Changes the document as one step of undo. During a drag the drag is the step.
    pub(super) fn record(&mut self, label: &'static str, run: Option<Run>, change: impl FnOnce(&mut Document)) {
        let before = self.document.clone();
        change(&mut self.document);
        match &mut self.gesture {
            None => self.history.record(before, &self.document, label, run),
            Some(gesture) => gesture.label = label,
        }
    }

    /// Copies a keyframe's pose to the scene, which is a step of undo only where it discards unsaved posing.
    pub(super) fn show_keyframe(&mut self, label: &'static str, index: KeyframeIndex) {
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
    pub fn where_we_are(&self) -> String {
        match (self.document.keyframes.current(), self.document.keyframes.last()) {
            (Some(current), Some(last)) => format!("Keyframe {} (0 to {})", current.get(), last.get()),
            _ => "No keyframes".to_owned(),
        }
    }

    fn display_current(&mut self) -> Outcome {
        let current = self.document.keyframes.current().ok_or_else(|| self.no_keyframe())?;
        self.show_keyframe("display of a keyframe", current);
        Ok(format!("{}: copied to the scene.", self.where_we_are()))
    }

    fn update_current(&mut self) -> String {
        let Some(current) = self.document.keyframes.current_keyframe().cloned() else { return self.create_keyframe() };
        let scrubbed = self.end_scrub();
        self.record("update of a keyframe", None, |document| {
            if let Some(pose) = scrubbed {
                document.live_pose = pose;
            }
            if let Some(index) = document.keyframes.current() {
                document.keyframes.replace(index, current.with_pose(document.live_pose.clone()));
            }
        });
        format!("{}: updated from the scene.", self.where_we_are())
    }

    fn create_keyframe(&mut self) -> String {
        let left = self.playhead().filter(|_| self.is_scrubbed()).map(|key_time| key_time as usize + 1);
        let after = left.map(KeyframeIndex::new).or(self.document.keyframes.current());
        let scrubbed = self.end_scrub();
        self.record("new keyframe", None, |document| {
            if let (Some(pose), Some(after)) = (scrubbed, after) {
                document.live_pose = pose;
                document.keyframes.set_current(after);
            }
            let pose = document.live_pose.clone();
            document.keyframes.insert_after_current(Keyframe::new(pose));
        });
        self.session.selected.clear();
        match after {
            Some(after) => format!("{}: created after keyframe {}.", self.where_we_are(), after.get()),
            None => format!("{}: created the first keyframe.", self.where_we_are()),
        }
    }

    fn step(&mut self, by: isize) -> Outcome {
        let Some(current) = self.document.keyframes.current() else {
            return Ok("No keyframes: nothing to go to.".to_owned());
        };
        let target = current.get().checked_add_signed(by).filter(|&place| place < self.document.keyframes.len());
        match target {
            Some(place) => self.go_to(KeyframeIndex::new(place)),
            None if by > 0 => Ok(format!("Keyframe {} is the last one.", current.get())),
            None => Ok(format!("Keyframe {} is the first one.", current.get())),
        }
    }

    fn go_to_end(&mut self, is_first: bool) -> Outcome {
        let last = self.document.keyframes.last().ok_or_else(|| self.no_keyframe())?;
        self.go_to(if is_first { KeyframeIndex::new(0) } else { last })
    }

    fn go_to(&mut self, index: KeyframeIndex) -> Outcome {
        let count = self.document.keyframes.len();
        if index.get() >= count {
            return Err(CommandError::NoSuchKeyframe { index: index.get(), count });
        }
        self.show_keyframe("step to another keyframe", index);
        // A selection is what the next edit is for: one that was left behind would surprise.
        if !self.session.selected.contains(&index) {
            self.session.selected.clear();
        }
        Ok(format!("{}: copied to the scene.", self.where_we_are()))
    }

    fn delete_current(&mut self) -> Outcome {
        self.end_scrub();
        let deleted = self.document.keyframes.current().ok_or(CommandError::NothingToDelete)?;
        self.session.selected.clear();
        self.record("deletion of a keyframe", None, |document| {
            document.keyframes.delete_current();
            if let Some(keyframe) = document.keyframes.current_keyframe() {
                document.live_pose = keyframe.pose.clone();
            }
        });
        Ok(format!("Deleted keyframe {}. {}.", deleted.get(), self.where_we_are()))
    }

    fn set_interpolation(&mut self, interpolation: crate::interpolation::Interpolation) -> String {
        self.record("change of interpolation", None, |document| document.interpolation = interpolation);
        format!("Interpolation: {}.", interpolation.label())
    }

    fn set_ms(&mut self, ms: u32) -> String {
        let ms = ms.clamp(*MS_BETWEEN_KEYFRAMES_RANGE.start(), *MS_BETWEEN_KEYFRAMES_RANGE.end());
        let was = self.document.ms_between_keyframes;
        self.record("change of pace", Some(Run::MsBetweenKeyframes), |document| document.ms_between_keyframes = ms);
        self.refit_pace();
        match ms {
            100 if was == ms => "100 ms between keyframes: as fast as it goes.".to_owned(),
            10_000 if was == ms => "10000 ms between keyframes: as slow as it goes.".to_owned(),
            _ => format!("{ms} ms between keyframes."),
        }
    }

    pub(super) fn place(
        &mut self,
        rbt: RbtIndex,
        change: impl FnOnce(Rbt) -> Rbt,
        label: &'static str,
        run: Option<Run>,
    ) -> Outcome {
        if rbt.get() >= self.document.scene.rbt_count() {
            return Err(CommandError::NotInScene { what: "node" });
        }
        let placed = change(self.pose_at_hand().get(rbt));
        if !placed.is_finite() {
            return Err(CommandError::NotAValue { what: "position" });
        }
        let scrubbed = self.end_scrub();
        self.record(label, run, |document| {
            if let Some(pose) = scrubbed {
                document.live_pose = pose;
            }
            document.live_pose.set(rbt, placed);
        });
        Ok(String::new())
    }

    pub(super) fn replace_keyframes(&mut self, label: &'static str, change: impl FnOnce(&mut Document)) {
        self.record(label, None, change);
        self.playback = Playback::Stopped;
    }

    pub(super) fn list_with_first_current(document: &mut Document, keyframes: KeyframeList) {
        document.keyframes = keyframes;
        if let Some(keyframe) = document.keyframes.current_keyframe() {
            document.live_pose = keyframe.pose.clone();
        }
    }
}
