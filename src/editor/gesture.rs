//! Drags, each one undo step, and the undo and redo commands.

use super::apply::CommandResult;
use super::gizmo::Hold;
use super::placing::{move_label, turn_label};
use super::{CommandError, Document, Editor, GestureCommand, Snapshot, WorkEye};
use crate::keyframe::{Keyframe, KeyframeList};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::words::{Message, Phrase, texts};

/// A drag that goes on.
#[derive(Clone, Debug)]
pub(super) struct Gesture {
    /// The document before it.
    pub(super) before: Document,
    /// The work eye before it.
    work_eye: WorkEye,
    /// The pose on screen before it, from which pulls count: a sample where the playhead was dragged.
    pub(super) start: Pose,
    /// What undo calls it.
    pub(super) label: Phrase,
    /// The handle that is held, if one is.
    pub(super) hold: Option<Hold>,
}

impl Editor {
    pub(super) fn gesture(&mut self, command: GestureCommand) -> CommandResult {
        match command {
            // While playing only the work eye can be dragged, which changes no document and is no step.
            GestureCommand::Begin if self.is_playing() => {}
            GestureCommand::Begin => self.begin_gesture(),
            GestureCommand::Grab(handle) => return self.grab(handle),
            GestureCommand::Pull(pull) => return self.pull(pull),
            GestureCommand::Lock(axis) => return self.lock(axis),
            GestureCommand::Type(character) => return self.type_in_drag(character),
            GestureCommand::Erase => return self.erase_in_drag(),
            GestureCommand::Move(motion) => {
                if !self.takes_motions() {
                    return Err(CommandError::NoDrag);
                }
                if self.dragged_node().is_none() {
                    return self.set_work_eye(self.session.work_eye.moved(motion));
                }
                self.drag_to(self.moved(motion), motion.translation == glam::Vec3::ZERO)?;
            }
            GestureCommand::MoveTo { placed, is_turn } => {
                if self.gesture.is_none() {
                    return Err(CommandError::NoDrag);
                }
                let dragged = self.dragged_nodes();
                if dragged.len() != placed.len() {
                    return Err(CommandError::NotAValue { what: texts::VALUE_PLACES });
                }
                self.drag_to(dragged.into_iter().zip(placed).collect(), is_turn)?;
            }
            GestureCommand::Commit => {
                self.commit_gesture();
            }
            GestureCommand::Abort => {
                return Ok(self.take_drag_back());
            }
        }
        Ok(None)
    }

    /// Whether motions of a drag count: during a drag, and those of the work eye while playing too.
    #[must_use]
    pub fn takes_motions(&self) -> bool {
        self.gesture.is_some() || self.is_playing() && self.dragged_node().is_none()
    }

    /// Ends a drag as if it had not been.
    fn take_drag_back(&mut self) -> Option<Message> {
        let gesture = self.gesture.take()?;
        self.document = gesture.before;
        self.session.work_eye = gesture.work_eye;
        Some(texts::DRAG_TAKEN_BACK.into())
    }

    pub(super) fn begin_gesture(&mut self) {
        self.commit_gesture();
        self.history.end_run();
        // A scrubbed pose stays on screen until the drag moves a node.
        let (before, start) = (self.document.clone(), self.edited_pose());
        self.gesture =
            Some(Gesture { before, work_eye: self.session.work_eye, start, label: texts::ACT_DRAG, hold: None });
    }

    fn drag_to(&mut self, placed: Vec<(RbtIndex, Rbt)>, is_turn: bool) -> CommandResult {
        let label = match self.session.chosen.len() {
            0 => texts::ACT_MOVE_THE_EYE,
            count if is_turn => turn_label(count),
            count => move_label(count),
        };
        self.change_nodes(placed, label, None)
    }

    /// The pose in which the drag that goes on began.
    pub(super) fn pose_before_drag(&self) -> Option<Pose> {
        self.gesture.as_ref().map(|gesture| gesture.start.clone())
    }

    /// One motion that leads where the drag has led so far; `None` without a drag, or if it has changed nothing yet.
    #[must_use]
    pub fn drag_so_far(&self) -> Option<GestureCommand> {
        let label = self.gesture.as_ref()?.label;
        let dragged = self.dragged_nodes();
        let is_turn = label == turn_label(dragged.len());
        let is_work_eye = dragged.is_empty();
        let placed = dragged.into_iter().map(|rbt| self.document.live_pose.get(rbt)).collect();
        (label != texts::ACT_DRAG && !is_work_eye).then_some(GestureCommand::MoveTo { placed, is_turn })
    }

    /// Ends a drag, as one step of undo.
    pub(super) fn commit_gesture(&mut self) {
        let Some(Gesture { before, label, .. }) = self.gesture.take() else { return };
        let has_moved = !before.live_pose.same_as(&self.document.live_pose);
        if self.session.auto_keys
            && has_moved
            && let Some(index) = self.document.keyframes.current()
            && let Some(keyframe) = self.document.keyframes.current_keyframe()
        {
            let mut updated = self.document.clone();
            updated.keyframes.replace(index, keyframe.with_pose(self.document.live_pose.clone()));
            if let Some(error) = updated.too_large_after(&self.document) {
                self.say_error(&error);
            } else {
                self.document = updated;
                self.say(self.with_position(texts::KEYFRAME_UPDATED_BY_AUTO_KEY));
            }
        }
        self.history.record(before, &self.document, label, None);
    }

    pub(super) fn undo(&mut self) -> CommandResult {
        if self.gesture.is_some() {
            return Err(CommandError::DuringDrag);
        }
        self.end_scrub();
        let before = self.document.keyframes.clone();
        let label = self.history.undo(&mut self.document).ok_or(CommandError::NothingToUndo)?;
        self.drop_stale_selection(&before);
        Ok(Some(texts::undone(label)))
    }

    pub(super) fn redo(&mut self) -> CommandResult {
        if self.gesture.is_some() {
            return Err(CommandError::DuringDrag);
        }
        self.end_scrub();
        let before = self.document.keyframes.clone();
        let label = self.history.redo(&mut self.document).ok_or(CommandError::NothingToRedo)?;
        self.drop_stale_selection(&before);
        Ok(Some(texts::redone(label)))
    }

    /// Puts a document in place as undo does, where the steps that lead to it are not known.
    pub fn jump_to(&mut self, document: &Snapshot) {
        self.end_scrub();
        let before = std::mem::replace(&mut self.document, Self::of_snapshot(document).document).keyframes;
        self.history.forget();
        self.drop_stale_selection(&before);
    }

    /// Clears the selection if the list changed, because its indices may now be other keyframes.
    fn drop_stale_selection(&mut self, before: &KeyframeList) {
        let after = &self.document.keyframes;
        let is_same_pose = |(a, b): (&Keyframe, &Keyframe)| a.pose.same_as(&b.pose);
        if before.len() != after.len() || !before.as_slice().iter().zip(after.as_slice()).all(is_same_pose) {
            self.session.selected.clear();
        }
    }

    /// Ends one thing: the help, the drag, the pick mode, or the choice.
    pub(super) fn cancel(&mut self) -> Option<Message> {
        if std::mem::take(&mut self.session.shows_help) {
            return None;
        }
        if let Some(said) = self.take_drag_back() {
            return Some(said);
        }
        if std::mem::take(&mut self.session.is_picking) {
            return Some(texts::VIEW_NOTHING_PICKED.into());
        }
        let chosen = std::mem::take(&mut self.session.chosen);
        (!chosen.is_empty()).then(|| texts::VIEW_NOTHING_CHOSEN.into())
    }
}
