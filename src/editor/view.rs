//! View commands: changes of the session, which undo leaves alone.

use super::apply::CommandResult;
use super::{Choice, Command, CommandError, Editor, Eye, Message, Pivot, SkyMode, ViewCommand};
use crate::frame::MOST_GHOSTS;
use crate::pose::RbtIndex;
use crate::words::texts;

/// Ghosts on each side after which [`ViewCommand::NextGhosts`] goes back to none. It is no limit: [`ViewCommand::SetGhosts`] shows up to
/// [`MOST_GHOSTS`].
const GHOST_STEPS: u8 = 3;

impl Editor {
    pub(super) fn view(&mut self, command: ViewCommand) -> CommandResult {
        match command {
            ViewCommand::NextEye => self.set_eye(self.next_eye()),
            ViewCommand::SetEye(eye) => self.set_eye(eye),
            ViewCommand::SetWorkEye(eye) => self.set_work_eye(eye),
            ViewCommand::LookFrom(side) => self.look_from_side(side),
            ViewCommand::LookFromNode(node) => self.look_from_node(node),
            ViewCommand::LevelEye => self.level(),
            ViewCommand::ShowAll => self.show_all(),
            ViewCommand::ShowChosen => self.show_chosen(),
            ViewCommand::ResetWorkEye => self.reset_work_eye(),
            ViewCommand::ToggleSkyMode => {
                if self.session.eye != Eye::Recorded(0) || !self.session.chosen.is_empty() {
                    return Err(CommandError::NoSkyMode);
                }
                self.commit_gesture();
                let (mode, said) = match self.session.sky_mode {
                    SkyMode::WorldCentre => (SkyMode::Eye, texts::VIEW_SKY_ABOUT_ITSELF),
                    SkyMode::Eye => (SkyMode::WorldCentre, texts::VIEW_SKY_ABOUT_WORLD),
                };
                self.session.sky_mode = mode;
                Ok(Some(said.into()))
            }
            ViewCommand::StartPicking => {
                self.session.is_picking = true;
                Ok(Some(texts::VIEW_PICKING.into()))
            }
            ViewCommand::Choose(rbt) => self.choose(rbt, |_| Choice::from(rbt)),
            ViewCommand::ChooseAlso(rbt) => self.choose(Some(rbt), |chosen| {
                let mut chosen = chosen.clone();
                chosen.toggle(rbt);
                chosen
            }),
            ViewCommand::ToggleAutoKeys => self.view(ViewCommand::SetAutoKeys(!self.session.auto_keys)),
            ViewCommand::SetAutoKeys(is_on) => {
                self.session.auto_keys = is_on;
                let said = if is_on { texts::VIEW_AUTO_KEY_ON } else { texts::VIEW_AUTO_KEY_OFF };
                Ok(Some(said.into()))
            }
            ViewCommand::ToggleKeepFeet => self.view(ViewCommand::SetKeepFeet(!self.session.keeps_feet)),
            ViewCommand::SetKeepFeet(is_on) => {
                self.session.keeps_feet = is_on;
                let said = if is_on { texts::VIEW_KEEP_FEET_ON } else { texts::VIEW_KEEP_FEET_OFF };
                Ok(Some(said.into()))
            }
            ViewCommand::NextGhosts => {
                let ghosts = if self.session.ghosts < GHOST_STEPS { self.session.ghosts + 1 } else { 0 };
                self.view(ViewCommand::SetGhosts(ghosts))
            }
            ViewCommand::SetGhosts(ghosts) => {
                self.session.ghosts = ghosts.min(MOST_GHOSTS);
                Ok(Some(match self.session.ghosts {
                    0 => texts::VIEW_NO_GHOSTS.into(),
                    ghosts => texts::view_ghosts(usize::from(ghosts)),
                }))
            }
            ViewCommand::RestartTimedKeys => Ok(Some(self.restart_timed_keys())),
            ViewCommand::PlayTimedKeys => self.play_timed_keys(),
            ViewCommand::HoldTimedKeys => Ok(Some(self.hold_timed_keys())),
            ViewCommand::ScrubSeconds(seconds) => self.scrub_timed_keys(seconds),
            ViewCommand::ToggleMotionPath => {
                self.session.shows_motion_path = !self.session.shows_motion_path;
                let said =
                    if self.session.shows_motion_path { texts::VIEW_PATH_SHOWN } else { texts::VIEW_PATH_HIDDEN };
                Ok(Some(said.into()))
            }
            ViewCommand::ToggleInset => self.view(ViewCommand::SetInset(!self.session.shows_inset)),
            ViewCommand::SetInset(is_on) => {
                self.session.shows_inset = is_on;
                let said = if is_on { texts::VIEW_INSET_SHOWN } else { texts::VIEW_INSET_HIDDEN };
                Ok(Some(said.into()))
            }
            ViewCommand::SetPivot(pivot) => Ok(Some(self.set_pivot(pivot))),
            ViewCommand::ToggleComparison => Ok(Some(self.toggle_comparison())),
            ViewCommand::CompareBlends(blends) => Ok(Some(self.compare_blends(&blends))),
            ViewCommand::EndCompareWith => Ok(Some(self.end_compare_with())),
            ViewCommand::ToggleGhostsOfChosen => Ok(Some(self.set_ghosts_of_chosen(!self.session.ghosts_of_chosen))),
            ViewCommand::SetGhostsOfChosen(is_on) => Ok(Some(self.set_ghosts_of_chosen(is_on))),
            ViewCommand::ToggleArcball => {
                self.session.shows_arcball = !self.session.shows_arcball;
                Ok(None)
            }
            ViewCommand::ToggleGizmo => Ok(Some(self.toggle_gizmo())),
            ViewCommand::NextGizmoAxes => Ok(Some(self.set_gizmo_axes(self.session.gizmo_axes.next()))),
            ViewCommand::SetGizmoAxes(axes) => Ok(Some(self.set_gizmo_axes(axes))),
            ViewCommand::SetSnapSteps(steps) => Ok(Some(self.set_snap_steps(steps))),
            ViewCommand::ToggleHelp => {
                self.session.shows_help = !self.session.shows_help;
                Ok(None)
            }
            ViewCommand::TogglePanels => {
                self.session.shows_panels = !self.session.shows_panels;
                let hidden = !self.session.shows_panels;
                let key = self.key_of(&Command::View(ViewCommand::TogglePanels));
                Ok(hidden.then(|| texts::view_panels_hidden(key)))
            }
        }
    }

    fn set_pivot(&mut self, pivot: Pivot) -> Message {
        self.commit_gesture();
        self.session.pivot = pivot;
        match pivot {
            Pivot::Own => texts::VIEW_PIVOT_OWN.into(),
            Pivot::Common => texts::VIEW_PIVOT_COMMON.into(),
        }
    }

    fn choose(&mut self, rbt: Option<RbtIndex>, change: impl FnOnce(&Choice) -> Choice) -> CommandResult {
        if rbt.is_some_and(|rbt| rbt.get() >= self.document.scene.rbt_count()) {
            return Err(CommandError::NotInScene { what: texts::VALUE_NODE });
        }
        self.commit_gesture();
        self.session.chosen = change(&self.session.chosen);
        self.session.is_picking = false;
        Ok(Some(match *self.session.chosen {
            [] => texts::VIEW_NOTHING_CHOSEN.into(),
            [rbt] => texts::view_chosen(self.document.scene.rbt_path(rbt)),
            [.., primary] => {
                texts::view_chosen_several(self.session.chosen.len(), self.document.scene.rbt_path(primary))
            }
        }))
    }

    /// The eye and how a drag moves, in short: `sky view · world-sky`.
    #[must_use]
    pub fn view_sentence(&self) -> Message {
        let scene = &self.document.scene;
        let moves: Message = match (&*self.session.chosen, self.session.eye, self.session.sky_mode) {
            ([], Eye::Work, _) => return texts::WORK_VIEW.into(),
            ([], Eye::Recorded(0), SkyMode::WorldCentre) => texts::WORLD_SKY.into(),
            ([], Eye::Recorded(0), SkyMode::Eye) => texts::SKY_SKY.into(),
            ([], Eye::Recorded(_), _) => texts::MOVES_ITSELF.into(),
            ([chosen], ..) => texts::moves_node(scene.rbt_path(*chosen)),
            (chosen, ..) => texts::moves_nodes(chosen.len()),
        };
        match self.eye() {
            Some(eye) => texts::view_of(scene.node(scene.rbt_node(eye)).name.as_str(), moves),
            None => texts::work_view_of(moves),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;
    use std::sync::Arc;

    use super::*;

    #[test]
    fn the_view_is_named() {
        let scene = crate::scene::built_in_scene(crate::scene::DEFAULT_SCENE).unwrap();
        let mut editor = Editor::new(Arc::new(scene), PathBuf::from("animation.json"));
        assert_eq!(editor.view_sentence().to_string(), "sky view · world-sky");
        editor.apply(Command::View(ViewCommand::ToggleSkyMode)).unwrap();
        assert_eq!(editor.view_sentence().to_string(), "sky view · sky-sky");
        editor.apply(Command::View(ViewCommand::NextEye)).unwrap();
        assert_eq!(editor.view_sentence().to_string(), "robot1 view · moves itself");
        editor.apply(Command::View(ViewCommand::SetEye(Eye::Work))).unwrap();
        assert_eq!(editor.view_sentence().to_string(), "work view · not recorded");
        editor.apply(Command::View(ViewCommand::Choose(editor.scene().find_rbt("robot2")))).unwrap();
        assert_eq!(editor.view_sentence().to_string(), "work view · moves robot2");
    }
}
