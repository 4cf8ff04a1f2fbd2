//! What each command does.

use glam::Quat;

use super::history::Run;
use super::playback::{Playback, Position};
use super::{
    Command, CommandError, Document, Edit, Editor, Effect, GestureCommand, Message, PlaybackCommand, Severity, SkyMode,
    ViewCommand,
};
use crate::keyframe::{Blend, Keyframe, KeyframeIndex, KeyframeList, MS_BETWEEN_KEYFRAMES_RANGE, PlayRange};
use crate::pose::RbtIndex;
use crate::rbt::Rbt;

/// How much `+` and `-` change the ms between keyframes.
const MS_STEP: u32 = 100;

type Outcome = Result<String, CommandError>;

impl Editor {
    /// Does a command. What it says is the message afterwards, in either outcome.
    ///
    /// # Errors
    /// Why the command was refused; nothing has changed then.
    pub fn apply(&mut self, command: Command) -> Result<Vec<Effect>, CommandError> {
        let outcome = self.dispatch(command);
        match &outcome {
            Ok((text, _)) => self.say(text.clone()),
            Err(error) => self.say_error(error),
        }
        outcome.map(|(_, effects)| effects)
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

    fn dispatch(&mut self, command: Command) -> Result<(String, Vec<Effect>), CommandError> {
        let silent = |outcome: Outcome| outcome.map(|text| (text, Vec::new()));
        match command {
            Command::Edit(edit) => silent(self.edit(edit)),
            Command::Playback(playback) => silent(self.play(playback)),
            Command::View(view) => silent(self.view(view)),
            Command::File(file) => self.file(file),
            Command::Gesture(gesture) => silent(self.gesture(gesture)),
            Command::Undo => silent(self.undo()),
            Command::Redo => silent(self.redo()),
            Command::Cancel => silent(Ok(self.cancel())),
            Command::Window(command) => Ok((String::new(), vec![Effect::Window(command)])),
        }
    }

    pub(super) fn refuse_while_playing(&self, what: &'static str) -> Result<(), CommandError> {
        if self.is_playing() { Err(CommandError::WhilePlaying { what }) } else { Ok(()) }
    }

    fn edit(&mut self, edit: Edit) -> Outcome {
        if let Some(what) = what_playing_refuses(&edit) {
            self.refuse_while_playing(what)?;
        }
        if !is_pose_edit(&edit) {
            self.commit_gesture();
        }
        match edit {
            Edit::DisplayCurrent => self.display_current(),
            Edit::UpdateCurrent => Ok(self.update_current()),
            Edit::CreateKeyframe => Ok(self.create_keyframe()),
            Edit::GoToNext => self.step(1),
            Edit::GoToPrevious => self.step(-1),
            Edit::GoTo(index) => self.go_to(index),
            Edit::DeleteCurrent => self.delete_current(),
            Edit::ResetPose => {
                let rest = self.scene.rest_pose().clone();
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
                let chosen = self.session.chosen.ok_or(CommandError::NothingChosen)?;
                let turn = unit(Quat::from_axis_angle(axis_in_node, radians))
                    .ok_or(CommandError::NotAValue { what: "rotation" })?;
                let turned = |from: Rbt| Rbt { rotation: from.rotation * turn, ..from }.renormalized();
                self.place(chosen, turned, "turn a node", None)
            }
            Edit::TranslateChosen(by) => {
                let chosen = self.session.chosen.ok_or(CommandError::NothingChosen)?;
                self.place(chosen, |from| Rbt { translation: from.translation + by, ..from }, "move a node", None)
            }
            Edit::Wheel(motion) => {
                let moved = self.moved(motion);
                self.place(self.node_at_hand(), |_| moved, "move along the view", Some(Run::Wheel))
            }
        }
    }

    /// Changes the document as one step of undo. During a drag the drag is the step.
    fn record(&mut self, label: &'static str, run: Option<Run>, change: impl FnOnce(&mut Document)) {
        let before = self.document.clone();
        change(&mut self.document);
        if self.gesture.is_none() {
            self.history.record(before, &self.document, label, run);
        }
    }

    /// Copies a keyframe's pose to the scene, which is a step of undo only where it discards unsaved posing.
    fn show_keyframe(&mut self, label: &'static str, index: KeyframeIndex) {
        let discards = self.document.has_unsaved_posing(self.scene.rest_pose());
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
        let current = self.document.keyframes.current().ok_or(CommandError::NoKeyframe)?;
        self.show_keyframe("display of a keyframe", current);
        Ok(format!("{}: copied to the scene.", self.where_we_are()))
    }

    fn update_current(&mut self) -> String {
        let Some(current) = self.document.keyframes.current() else { return self.create_keyframe() };
        self.record("update of a keyframe", None, |document| {
            let pose = document.live_pose.clone();
            document.keyframes.replace(current, Keyframe::new(pose));
        });
        format!("{}: updated from the scene.", self.where_we_are())
    }

    fn create_keyframe(&mut self) -> String {
        let after = self.document.keyframes.current();
        self.record("new keyframe", None, |document| {
            let pose = document.live_pose.clone();
            document.keyframes.insert_after_current(Keyframe::new(pose));
        });
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

    fn go_to(&mut self, index: KeyframeIndex) -> Outcome {
        let count = self.document.keyframes.len();
        if index.get() >= count {
            return Err(CommandError::NoSuchKeyframe { index: index.get(), count });
        }
        self.show_keyframe("step to another keyframe", index);
        Ok(format!("{}: copied to the scene.", self.where_we_are()))
    }

    fn delete_current(&mut self) -> Outcome {
        let deleted = self.document.keyframes.current().ok_or(CommandError::NothingToDelete)?;
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
        if let Playback::Playing(position) = &mut self.playback {
            position.set_ms_between_keyframes(ms);
        }
        match ms {
            100 if was == ms => "100 ms between keyframes: as fast as it goes.".to_owned(),
            10_000 if was == ms => "10000 ms between keyframes: as slow as it goes.".to_owned(),
            _ => format!("{ms} ms between keyframes."),
        }
    }

    fn place(
        &mut self,
        rbt: RbtIndex,
        change: impl FnOnce(Rbt) -> Rbt,
        label: &'static str,
        run: Option<Run>,
    ) -> Outcome {
        if rbt.get() >= self.scene.rbt_count() {
            return Err(CommandError::NotInScene { what: "node" });
        }
        let placed = change(self.document.live_pose.get(rbt));
        if !placed.is_finite() {
            return Err(CommandError::NotAValue { what: "position" });
        }
        self.record(label, run, |document| document.live_pose.set(rbt, placed));
        Ok(String::new())
    }

    fn play(&mut self, command: PlaybackCommand) -> Outcome {
        self.commit_gesture();
        match (command, std::mem::take(&mut self.playback)) {
            (PlaybackCommand::PlayOrStop, Playback::Playing(position)) => {
                self.playback = Playback::Playing(position);
                self.end_playback();
                Ok(format!("Stopped. {}.", self.where_we_are()))
            }
            (PlaybackCommand::PlayOrStop, was) => {
                if PlayRange::new(&self.document.keyframes).is_err() {
                    self.playback = was;
                    return Err(CommandError::TooFewToPlay);
                }
                self.playback = Playback::Playing(Position::start(self.document.ms_between_keyframes));
                Ok(format!("Playing {} keyframes.", self.document.keyframes.len() - 2))
            }
            (PlaybackCommand::PauseOrResume, Playback::Playing(position)) => {
                self.playback = Playback::Playing(position.clone());
                let pose = self.displayed_pose();
                self.playback = Playback::Paused(position);
                let discards = self.document.has_unsaved_posing(self.scene.rest_pose());
                let before = self.document.clone();
                self.document.live_pose = pose;
                if discards {
                    self.history.record(before, &self.document, "pause", None);
                }
                Ok("Paused: n or u captures this pose, Shift+P goes on.".to_owned())
            }
            (PlaybackCommand::PauseOrResume, Playback::Paused(mut position)) => {
                if PlayRange::new(&self.document.keyframes).is_err() {
                    return Err(CommandError::TooFewToPlay);
                }
                position.set_ms_between_keyframes(self.document.ms_between_keyframes);
                self.playback = Playback::Playing(position);
                Ok("Playing on.".to_owned())
            }
            (PlaybackCommand::PauseOrResume, Playback::Stopped) => Err(CommandError::NothingPlaying),
        }
    }

    /// Ends the playback at the last played keyframe, which becomes current and is copied to the scene.
    pub(super) fn end_playback(&mut self) {
        self.playback = Playback::Stopped;
        let last = PlayRange::new(&self.document.keyframes).ok().map(|range| range.last_keyframe());
        if let Some(last) = last {
            self.show_keyframe("playing", last);
        }
    }

    fn view(&mut self, command: ViewCommand) -> Outcome {
        match command {
            ViewCommand::NextEye => self.set_eye((self.session.eye + 1) % self.scene.eyes().len()),
            ViewCommand::SetEye(eye) => self.set_eye(eye),
            ViewCommand::ToggleSkyMode => {
                if self.session.eye != 0 || self.session.chosen.is_some() {
                    return Err(CommandError::NoSkyMode);
                }
                self.commit_gesture();
                let (mode, text) = match self.session.sky_mode {
                    SkyMode::WorldCentre => (SkyMode::Eye, "The sky camera moves about itself."),
                    SkyMode::Eye => (SkyMode::WorldCentre, "The sky camera moves about the world's centre."),
                };
                self.session.sky_mode = mode;
                Ok(text.to_owned())
            }
            ViewCommand::StartPicking => {
                self.session.is_picking = true;
                Ok("Click a node to choose it, or the ground to choose none.".to_owned())
            }
            ViewCommand::Choose(rbt) => self.choose(rbt),
            ViewCommand::RestartSeconds => {
                self.seconds_clock.ticks = 0;
                Ok("Keys at their own times start again.".to_owned())
            }
            ViewCommand::HoldSeconds => {
                self.seconds_clock.is_held = !self.seconds_clock.is_held;
                let state = if self.seconds_clock.is_held { "are held" } else { "go on" };
                Ok(format!("Keys at their own times {state} at {:.2} s.", self.seconds()))
            }
            ViewCommand::TogglePath => {
                self.session.shows_path = !self.session.shows_path;
                let state = if self.session.shows_path { "shown" } else { "hidden" };
                Ok(format!("The path of the chosen node is {state}."))
            }
            ViewCommand::ToggleComparison => {
                self.session.compares = !self.session.compares;
                if !self.session.compares {
                    return Ok("The comparison is off.".to_owned());
                }
                let [other, nlerp, matrices] = Blend::others(self.document.interpolation).map(Blend::label);
                Ok(format!("Comparing the chosen robot while playing: {other} is blue, {nlerp} green, {matrices} red."))
            }
            ViewCommand::ToggleArcball => {
                self.session.shows_arcball = !self.session.shows_arcball;
                Ok(String::new())
            }
            ViewCommand::ToggleHelp => {
                self.session.shows_help = !self.session.shows_help;
                Ok(String::new())
            }
            ViewCommand::TogglePanels => {
                self.session.shows_panels = !self.session.shows_panels;
                let hidden = !self.session.shows_panels;
                Ok(if hidden { "Panels hidden: F11 shows them again.".to_owned() } else { String::new() })
            }
        }
    }

    fn set_eye(&mut self, eye: usize) -> Outcome {
        let Some(&rbt) = self.scene.eyes().get(eye) else { return Err(CommandError::NotInScene { what: "eye" }) };
        self.commit_gesture();
        self.session.eye = eye;
        Ok(format!("Looking from {}.", self.scene.rbt_path(rbt)))
    }

    fn choose(&mut self, rbt: Option<RbtIndex>) -> Outcome {
        if rbt.is_some_and(|rbt| rbt.get() >= self.scene.rbt_count()) {
            return Err(CommandError::NotInScene { what: "node" });
        }
        self.commit_gesture();
        self.session.chosen = rbt;
        self.session.is_picking = false;
        Ok(match rbt {
            Some(rbt) => format!("Chosen: {}.", self.scene.rbt_path(rbt)),
            None => "Nothing chosen: a drag moves the eye.".to_owned(),
        })
    }

    fn gesture(&mut self, command: GestureCommand) -> Outcome {
        match command {
            GestureCommand::Begin => {
                self.refuse_while_playing("move a node")?;
                self.commit_gesture();
                self.history.end_run();
                self.gesture = Some(self.document.clone());
            }
            GestureCommand::Move(motion) => {
                if self.gesture.is_none() {
                    return Err(CommandError::NoDrag);
                }
                let moved = self.moved(motion);
                self.place(self.node_at_hand(), |_| moved, "drag", None)?;
            }
            GestureCommand::Commit => self.commit_gesture(),
            GestureCommand::Abort => {
                if let Some(before) = self.gesture.take() {
                    self.document = before;
                    return Ok("Drag taken back.".to_owned());
                }
            }
        }
        Ok(self.message.text.clone())
    }

    /// Ends a drag, as one step of undo.
    pub(super) fn commit_gesture(&mut self) {
        if let Some(before) = self.gesture.take() {
            self.history.record(before, &self.document, "drag", None);
        }
    }

    fn undo(&mut self) -> Outcome {
        self.refuse_while_playing("undo")?;
        if self.gesture.is_some() {
            return Err(CommandError::DuringDrag);
        }
        let label = self.history.undo(&mut self.document).ok_or(CommandError::NothingToUndo)?;
        Ok(format!("Undone: {label}."))
    }

    fn redo(&mut self) -> Outcome {
        self.refuse_while_playing("redo")?;
        if self.gesture.is_some() {
            return Err(CommandError::DuringDrag);
        }
        let label = self.history.redo(&mut self.document).ok_or(CommandError::NothingToRedo)?;
        Ok(format!("Redone: {label}."))
    }

    fn cancel(&mut self) -> String {
        if let Some(before) = self.gesture.take() {
            self.document = before;
            return "Drag taken back.".to_owned();
        }
        if self.session.is_picking {
            self.session.is_picking = false;
            return "Nothing picked.".to_owned();
        }
        self.session.shows_help = false;
        String::new()
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

/// A rotation of unit length, if this one has a direction.
fn unit(rotation: Quat) -> Option<Quat> {
    let length = rotation.length();
    (rotation.is_finite() && length > 1e-6 && length.is_finite()).then(|| rotation / length)
}

/// Edits of the live pose: during a drag they are part of it.
const fn is_pose_edit(edit: &Edit) -> bool {
    matches!(
        edit,
        Edit::SetTranslation(..)
            | Edit::SetRotation(..)
            | Edit::RotateChosen { .. }
            | Edit::TranslateChosen(_)
            | Edit::Wheel(_)
    )
}

/// What an edit is called where playing refuses it; `None` where it does not.
const fn what_playing_refuses(edit: &Edit) -> Option<&'static str> {
    Some(match edit {
        Edit::DisplayCurrent => "display a keyframe",
        Edit::UpdateCurrent => "update a keyframe",
        Edit::CreateKeyframe => "create a keyframe",
        Edit::GoToNext | Edit::GoToPrevious | Edit::GoTo(_) => "go to another keyframe",
        Edit::DeleteCurrent => "delete a keyframe",
        Edit::ResetPose => "return to the rest pose",
        Edit::SetTranslation(..) | Edit::TranslateChosen(_) | Edit::Wheel(_) => "move a node",
        Edit::SetRotation(..) | Edit::RotateChosen { .. } => "turn a node",
        Edit::NextInterpolation
        | Edit::SetInterpolation(_)
        | Edit::Faster
        | Edit::Slower
        | Edit::SetMsBetweenKeyframes(_) => return None,
    })
}
