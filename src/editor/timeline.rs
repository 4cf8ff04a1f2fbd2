//! Editing the list as a timeline: selections, names, lengths, easings, copies.

use std::sync::Arc;

use super::apply::CommandResult;
use super::commands::Row;
use super::placing::placeable;
use super::{ClipboardCommand, Command, CommandError, Document, Editor, TimelineEdit};
use crate::keyframe::{DURATION_RANGE, Easing, Keyframe, KeyframeIndex, KeyframeList, Retimed, Retiming};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::rotation_rules::unit;
use crate::words::{Message, Phrase, texts};

/// The longest name of a keyframe, in characters.
const LONGEST_NAME: usize = 100;

/// The clipboard.
#[derive(Clone, Debug, Default)]
pub struct Clipboard {
    keyframes: Vec<Keyframe>,
    /// The node whose pose was copied, and the pose of everything.
    pub(super) pose: Option<(RbtIndex, Pose)>,
}

impl Clipboard {
    /// The copied keyframes.
    pub(super) fn keyframes(&self) -> &[Keyframe] {
        &self.keyframes
    }

    /// The node whose pose was copied, and the pose of everything.
    pub(super) const fn pose(&self) -> Option<&(RbtIndex, Pose)> {
        self.pose.as_ref()
    }

    pub(super) const fn new(keyframes: Vec<Keyframe>, pose: Option<(RbtIndex, Pose)>) -> Self {
        Self { keyframes, pose }
    }
}

impl Editor {
    /// The indices that a timeline edit applies to, in order: the selected keyframes, or the current one.
    #[must_use]
    pub fn edited_keyframes(&self) -> Vec<usize> {
        if self.session.selected.is_empty() {
            self.document.keyframes.current().map(KeyframeIndex::get).into_iter().collect()
        } else {
            self.session.selected.iter().map(|index| index.get()).collect()
        }
    }

    /// Whether there are keyframes to paste.
    #[must_use]
    pub fn has_copied_keyframes(&self) -> bool {
        !self.clipboard.keyframes.is_empty()
    }

    pub(super) fn edit_timeline(&mut self, edit: TimelineEdit, row: &Row) -> CommandResult {
        if edit == TimelineEdit::DeleteKeyframes && !self.session.selected_keys.is_empty() {
            return self.delete_keys(self.session.selected_keys.clone());
        }
        if row.ends_scrub {
            self.end_scrub();
        }
        match edit {
            TimelineEdit::RenameKeyframe(index, name) => self.rename(index, &name),
            TimelineEdit::SetDuration { keyframe, duration, ripple_free } => {
                self.set_duration(keyframe, duration, ripple_free)
            }
            TimelineEdit::RetimeKeyframes(retiming) => self.retime_keyframes(retiming),
            TimelineEdit::SetEasing(easing) => self.set_easing(easing),
            TimelineEdit::MoveKeyframes(to) => self.move_keyframes(to),
            TimelineEdit::DeleteKeyframes => self.delete_keyframes(texts::ACT_DELETION_OF_KEYFRAMES),
            TimelineEdit::CutKeyframes => {
                self.copy_keyframes()?;
                self.delete_keyframes(texts::ACT_CUTTING_OF_KEYFRAMES)
            }
            TimelineEdit::PasteKeyframes => {
                if self.clipboard.keyframes.is_empty() {
                    let copy = self.key_of(&Command::Clipboard(ClipboardCommand::CopyKeyframes));
                    return Err(CommandError::NothingCopied { copy });
                }
                let (count, at) =
                    self.insert_after_hand(texts::ACT_PASTING_OF_KEYFRAMES, self.clipboard.keyframes.clone())?;
                Ok(Some(texts::keyframes_pasted(count, at)))
            }
            TimelineEdit::DuplicateKeyframes => {
                let copies = self.copies_of_edited()?;
                let (count, at) = self.insert_after_hand(texts::ACT_DUPLICATION_OF_KEYFRAMES, copies)?;
                Ok(Some(texts::keyframes_duplicated(count, at)))
            }
            TimelineEdit::ReverseKeyframes => self.reverse_keyframes(),
            TimelineEdit::SetTranslationInKeyframe(keyframe, rbt, translation) => {
                self.change_node_in_keyframe(keyframe, rbt, |from| Rbt { translation, ..from })
            }
            TimelineEdit::SetRotationInKeyframe(keyframe, rbt, rotation) => {
                let rotation = unit(rotation).ok_or(CommandError::NotAValue { what: texts::VALUE_ROTATION })?;
                self.change_node_in_keyframe(keyframe, rbt, |from| Rbt { rotation, ..from })
            }
        }
    }

    fn known(&self, index: KeyframeIndex) -> Result<&Keyframe, CommandError> {
        let count = self.document.keyframes.len();
        self.document.keyframes.get(index).ok_or(CommandError::NoSuchKeyframe { index: index.get(), count })
    }

    fn copies_of_edited(&self) -> Result<Vec<Keyframe>, CommandError> {
        let indices = self.edited_keyframes();
        if indices.is_empty() {
            return Err(self.no_keyframe());
        }
        Ok(indices.iter().map(|&index| self.document.keyframes.as_slice()[index].clone()).collect())
    }

    pub(super) fn select(&mut self, mut selected: Vec<KeyframeIndex>) -> CommandResult {
        let count = self.document.keyframes.len();
        if let Some(beyond) = selected.iter().find(|index| index.get() >= count) {
            return Err(CommandError::NoSuchKeyframe { index: beyond.get(), count });
        }
        selected.sort_unstable();
        selected.dedup();
        if !selected.is_empty() {
            self.session.selected_keys.clear();
        }
        self.session.selected = selected;
        Ok(None)
    }

    /// Removes indices beyond the list from the selection and the played range.
    pub(super) fn fit_session_to_list(&mut self) {
        let count = self.document.keyframes.len();
        self.session.selected.retain(|index| index.get() < count);
        if self.session.play_range.is_some_and(|(_, last)| last + 1 >= count) {
            self.session.play_range = None;
        }
        self.fit_keys_to_scene();
        self.fit_timed_key_mode();
    }

    pub(super) fn copy_keyframes(&mut self) -> CommandResult {
        self.clipboard.keyframes = self.copies_of_edited()?;
        Ok(Some(texts::keyframes_copied(texts::count_keyframes(self.clipboard.keyframes.len()))))
    }

    fn rename(&mut self, index: KeyframeIndex, name: &str) -> CommandResult {
        let renamed = self.known(index)?.clone();
        let name: String = name.chars().filter(|character| !character.is_control()).take(LONGEST_NAME).collect();
        let name: Option<Arc<str>> = Some(name.trim()).filter(|name| !name.is_empty()).map(Arc::from);
        let said = match &name {
            Some(name) => texts::keyframe_named(index.get(), &**name),
            None => texts::keyframe_unnamed(index.get()),
        };
        self.record(texts::ACT_RENAMING_OF_A_KEYFRAME, None, |document| {
            document.keyframes.replace(index, Keyframe { name, ..renamed });
        })?;
        Ok(Some(said))
    }

    fn set_duration(&mut self, index: KeyframeIndex, duration: f64, ripple_free: bool) -> CommandResult {
        if !duration.is_finite() {
            return Err(CommandError::NotAValue { what: texts::VALUE_DURATION });
        }
        let (shortest, longest) = (*DURATION_RANGE.start(), *DURATION_RANGE.end());
        let keyframe = self.known(index)?.clone();
        let mut duration = duration.clamp(shortest, longest);
        let next = KeyframeIndex::new(index.get() + 1);
        let neighbour = self.document.keyframes.get(next).filter(|_| ripple_free).cloned();
        if let Some(neighbour) = &neighbour {
            duration = duration.min(keyframe.duration + neighbour.duration - shortest);
        }
        self.record(texts::ACT_RETIMING_OF_AN_INTERVAL, None, |document| {
            if let Some(neighbour) = neighbour {
                let given = (neighbour.duration + keyframe.duration - duration).clamp(shortest, longest);
                document.keyframes.replace(next, Keyframe { duration: given, ..neighbour });
            }
            document.keyframes.replace(index, Keyframe { duration, ..keyframe });
        })?;
        Ok(Some(texts::keyframe_retimed(index.get(), format!("{duration:.3}"))))
    }

    fn retime_keyframes(&mut self, retiming: Retiming) -> CommandResult {
        let indices = self.edited_keyframes();
        if indices.is_empty() {
            return Err(self.no_keyframe());
        }
        // A drag always starts from its first state, so that an interval that was as short as can be has its length again.
        // Where other keyframes came meanwhile, there is no such state.
        let at_first = self.gesture.as_ref().map(|gesture| &gesture.before);
        let is_of_these = |before: &&Document| before.keyframes.len() == self.document.keyframes.len();
        let before = at_first.filter(is_of_these).unwrap_or(&self.document);
        let durations: Vec<f64> = before.keyframes.as_slice().iter().map(|keyframe| keyframe.duration).collect();
        let Retimed { durations, by_ms, .. } = retiming.of(&durations, before.ms_between_keyframes, &indices);
        self.record(texts::ACT_RETIMING_OF_KEYFRAMES, None, |document| {
            let mut keyframes = document.keyframes.as_slice().to_vec();
            for (keyframe, duration) in keyframes.iter_mut().zip(durations) {
                keyframe.duration = duration;
            }
            let current = document.keyframes.current().map(KeyframeIndex::get);
            document.keyframes = KeyframeList::with_current(keyframes, current);
        })?;
        let seconds = format!("{:+.3}", f64::from(by_ms) / 1000.0);
        Ok(Some(texts::keyframes_retimed(texts::count_keyframes(indices.len()), seconds)))
    }

    fn set_easing(&mut self, easing: Easing) -> CommandResult {
        let indices = self.edited_keyframes();
        if indices.is_empty() {
            return Err(self.no_keyframe());
        }
        self.record(texts::ACT_CHANGE_OF_EASING, None, |document| {
            let mut keyframes = document.keyframes.as_slice().to_vec();
            for &index in &indices {
                keyframes[index].easing = easing;
            }
            let current = document.keyframes.current().map(KeyframeIndex::get);
            document.keyframes = KeyframeList::with_current(keyframes, current);
        })?;
        Ok(Some(texts::easing_is(easing.name())))
    }

    /// Replaces the keyframes as one undo step, with `current` copied to the scene and `selected` selected.
    fn rearrange(
        &mut self,
        label: Phrase,
        keyframes: Vec<Keyframe>,
        current: Option<usize>,
        selected: std::ops::Range<usize>,
    ) -> Result<(), CommandError> {
        self.record(label, None, |document| {
            document.keyframes = KeyframeList::with_current(keyframes, current);
            if let Some(keyframe) = document.keyframes.current_keyframe() {
                document.live_pose = keyframe.pose.clone();
            }
        })?;
        self.select(selected.map(KeyframeIndex::new).collect())?;
        Ok(())
    }

    fn move_keyframes(&mut self, to: usize) -> CommandResult {
        let count = self.document.keyframes.len();
        if to > count {
            return Err(CommandError::NoSuchKeyframe { index: to, count });
        }
        let indices = self.edited_keyframes();
        let moved = self.copies_of_edited()?;
        let mut keyframes = self.without(&indices);
        let at = to - indices.iter().filter(|&&index| index < to).count();
        let selected = at..at + moved.len();
        keyframes.splice(at..at, moved);
        self.rearrange(texts::ACT_MOVING_OF_KEYFRAMES, keyframes, Some(at), selected.clone())?;
        Ok(Some(texts::keyframes_moved(texts::count_keyframes(selected.len()), at)))
    }

    fn without(&self, indices: &[usize]) -> Vec<Keyframe> {
        let keyframes = self.document.keyframes.as_slice().iter().enumerate();
        keyframes
            .filter(|(index, _)| indices.binary_search(index).is_err())
            .map(|(_, keyframe)| keyframe.clone())
            .collect()
    }

    fn delete_keyframes(&mut self, label: Phrase) -> CommandResult {
        let indices = self.edited_keyframes();
        let Some(&first) = indices.first() else { return Err(CommandError::NothingToDelete) };
        let keyframes = self.without(&indices);
        let current = (!keyframes.is_empty()).then(|| first.saturating_sub(1));
        self.rearrange(label, keyframes, current, 0..0)?;
        Ok(Some(texts::keyframes_deleted(texts::count_keyframes(indices.len()), self.position_message())))
    }

    /// Inserts keyframes after the selected ones. Returns their number and the index of the first.
    fn insert_after_hand(&mut self, label: Phrase, inserted: Vec<Keyframe>) -> Result<(Message, usize), CommandError> {
        let at = self.edited_keyframes().last().map_or(0, |last| last + 1);
        let mut keyframes = self.document.keyframes.as_slice().to_vec();
        let selected = at..at + inserted.len();
        keyframes.splice(at..at, inserted);
        self.rearrange(label, keyframes, Some(at), selected.clone())?;
        Ok((texts::count_keyframes(selected.len()), at))
    }

    fn reverse_keyframes(&mut self) -> CommandResult {
        let count = self.document.keyframes.len();
        if count == 0 {
            return Err(self.no_keyframe());
        }
        let all = self.session.selected.len() < 2;
        let indices: Vec<usize> = if all { (0..count).collect() } else { self.edited_keyframes() };
        let mut keyframes = self.document.keyframes.as_slice().to_vec();
        for (&index, &from) in indices.iter().zip(indices.iter().rev()) {
            keyframes[index] = self.document.keyframes.as_slice()[from].clone();
        }
        let selected = self.session.selected.clone();
        let current = self.document.keyframes.current().map(KeyframeIndex::get);
        self.rearrange(texts::ACT_REVERSING_OF_KEYFRAMES, keyframes, current, 0..0)?;
        self.session.selected = selected;
        Ok(Some(texts::keyframes_reversed(texts::count_keyframes(indices.len()))))
    }

    fn change_node_in_keyframe(
        &mut self,
        index: KeyframeIndex,
        rbt: RbtIndex,
        change: impl FnOnce(Rbt) -> Rbt,
    ) -> CommandResult {
        let keyframe = self.known(index)?.clone();
        if rbt.get() >= self.document.scene.rbt_count() {
            return Err(CommandError::NotInScene { what: texts::VALUE_NODE });
        }
        let placed = placeable(change(keyframe.pose.get(rbt)))?;
        self.record(texts::ACT_CHANGE_OF_A_NODE_IN_A_KEYFRAME, None, |document| {
            let shows_it = document.keyframes.current() == Some(index) && document.live_pose.same_as(&keyframe.pose);
            let mut pose = keyframe.pose.clone();
            pose.set(rbt, placed);
            if shows_it {
                document.live_pose = pose.clone();
            }
            document.keyframes.replace(index, keyframe.with_pose(pose));
        })?;
        Ok(None)
    }
}
