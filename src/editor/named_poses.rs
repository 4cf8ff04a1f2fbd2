//! Poses with names, given to nodes and taken of them.

use std::path::PathBuf;
use std::sync::Arc;

use super::apply::CommandResult;
use super::{Command, CommandError, Edit, Editor, Effect, Written};
use crate::pose::RbtIndex;
use crate::pose_file::{PoseFile, is_pose_name, shipped_pose};
use crate::words::{Message, quoted, texts};

/// The name of the pose that is written to a file, or under a name.
fn name_of(name: &str) -> &str {
    let file = name.rsplit(['/', '\\']).next().unwrap_or(name);
    file.strip_suffix(".json").unwrap_or(file)
}

impl Editor {
    /// Gives a pose to each chosen node, or to the nearest node above it that has nodes of the pose below it; with none chosen to the
    /// node that it was taken of, or to the scene.
    pub(super) fn apply_pose(&mut self, pose: &PoseFile) -> CommandResult {
        let scene = Arc::clone(&self.document.scene);
        let live = self.edited_pose();
        let name = || pose.name.clone();
        let mut roots: Vec<Option<RbtIndex>> = Vec::new();
        if pose.root.is_none() {
            roots.push(None);
        } else {
            let chosen = self.session.chosen.iter().copied().map(Some);
            let none = self.session.chosen.is_empty().then_some(None);
            for chosen in chosen.chain(none) {
                let root =
                    pose.root_in(&scene, chosen).ok_or_else(|| CommandError::PoseFitsNowhere { name: name() })?;
                if !roots.contains(&Some(root)) {
                    roots.push(Some(root));
                }
            }
        }
        let fits: Vec<_> = roots.iter().map(|&root| pose.fit(&scene, &live, root)).collect();
        if fits.iter().all(|fit| fit.placed.is_empty()) {
            return Err(CommandError::PoseFitsNowhere { name: name() });
        }
        let missing: Vec<&String> = fits.iter().flat_map(|fit| &fit.missing).collect();
        let said = match (missing.first(), &*roots) {
            (Some(first), _) => {
                texts::pose_applied_in_part(name(), quoted(first.as_str()), texts::count_nodes(missing.len()))
            }
            (None, [None]) => texts::pose_applied_whole(name()),
            (None, [Some(root)]) => texts::pose_applied(name(), scene.rbt_path(*root)),
            (None, roots) => texts::pose_applied_several(name(), roots.len()),
        };
        let placed = fits.into_iter().flat_map(|fit| fit.placed).collect();
        self.change_nodes(placed, texts::ACT_POSE_FROM_THE_LIBRARY, None)?;
        Ok(Some(said))
    }

    /// What writes the displayed pose of the primary chosen node and all below it, or of the whole scene.
    pub(super) fn save_pose(&self, name: String) -> Result<Effect, CommandError> {
        let own = name_of(&name).to_owned();
        if !is_pose_name(&own) || own.contains([':', '*', '?', '"', '<', '>', '|']) {
            return Err(CommandError::NotAPoseName { name: own });
        }
        if own == name && shipped_pose(&name).is_some() {
            return Err(CommandError::PoseIsShipped { name });
        }
        let pose = self.displayed_pose().in_bounds();
        let text = PoseFile::of(&self.document.scene, &pose, self.session.chosen.primary(), own).to_json();
        Ok(Effect::WritePose { name, text })
    }

    /// Takes in the file of a pose that was read, or why it could not be: the command that gives the pose.
    ///
    /// # Errors
    /// Why there is none; it is said.
    pub fn pose_read(&mut self, name: &str, bytes: Result<Vec<u8>, Message>) -> Result<Command, CommandError> {
        let unread = |reason| CommandError::Read { path: PathBuf::from(name), reason };
        let pose = bytes
            .map_err(unread)
            .and_then(|bytes| PoseFile::from_json(&bytes).map_err(|error| unread(error.message())));
        match pose {
            Ok(pose) => Ok(Command::Edit(Edit::Pose(Arc::new(PoseFile { name: name_of(name).to_owned(), ..pose })))),
            Err(error) => {
                self.say_error(&error);
                Err(error)
            }
        }
    }

    /// Takes in that a pose was written, or why it could not be.
    ///
    /// # Errors
    /// Why the file is as it was.
    pub fn pose_written(
        &mut self,
        name: &str,
        outcome: Result<(PathBuf, Written), Message>,
    ) -> Result<(), CommandError> {
        match outcome {
            Ok((path, Written { kept: Some(kept), .. })) => {
                self.say(texts::pose_saved_over(name_of(name), path.display(), kept.display()));
                Ok(())
            }
            Ok((path, _)) => {
                self.say(texts::pose_saved(name_of(name), path.display()));
                Ok(())
            }
            Err(reason) => {
                let error = CommandError::Write { path: PathBuf::from(name), reason };
                self.say_error(&error);
                Err(error)
            }
        }
    }
}
