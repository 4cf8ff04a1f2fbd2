//! How the scene is looked at and handled: session state, which is not undone.

use super::apply::Outcome;
use super::{Command, CommandError, Editor, SkyMode, ViewCommand};
use crate::frame::MOST_GHOSTS;
use crate::keyframe::Blend;
use crate::pose::RbtIndex;

/// Ghosts on each side after which [`ViewCommand::NextGhosts`] goes back to none. It is no limit: [`ViewCommand::SetGhosts`] shows up to
/// [`MOST_GHOSTS`].
const GHOST_STEPS: u8 = 3;

impl Editor {
    pub(super) fn view(&mut self, command: ViewCommand) -> Outcome {
        match command {
            ViewCommand::NextEye => self.set_eye((self.session.eye + 1) % self.document.scene.eyes().len()),
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
            ViewCommand::SelectKeyframes(selected) => self.select(selected),
            ViewCommand::CopyKeyframes => self.copy_keyframes(),
            ViewCommand::CopyPose => self.copy_pose(),
            ViewCommand::ToggleAutoKeys => self.view(ViewCommand::SetAutoKeys(!self.session.auto_keys)),
            ViewCommand::SetAutoKeys(is_on) => {
                self.session.auto_keys = is_on;
                Ok(if self.session.auto_keys {
                    "Auto-key is on: the end of each drag updates the current keyframe.".to_owned()
                } else {
                    "Auto-key is off.".to_owned()
                })
            }
            ViewCommand::NextGhosts => {
                let ghosts = if self.session.ghosts < GHOST_STEPS { self.session.ghosts + 1 } else { 0 };
                self.view(ViewCommand::SetGhosts(ghosts))
            }
            ViewCommand::SetGhosts(ghosts) => {
                self.session.ghosts = ghosts.min(MOST_GHOSTS);
                Ok(match self.session.ghosts {
                    0 => "No ghosts.".to_owned(),
                    1 => "Ghosts of 1 keyframe on each side.".to_owned(),
                    ghosts => format!("Ghosts of {ghosts} keyframes on each side."),
                })
            }
            ViewCommand::SelectKeys(keys) => self.select_keys(keys),
            ViewCommand::RestartSeconds => Ok(self.restart_seconds()),
            ViewCommand::HoldSeconds => Ok(self.hold_seconds()),
            ViewCommand::ScrubSeconds(seconds) => self.scrub_seconds(seconds),
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
                let key = self.key_of(&Command::View(ViewCommand::TogglePanels));
                Ok(if hidden { format!("Panels hidden: {key} shows them again.") } else { String::new() })
            }
        }
    }

    fn set_eye(&mut self, eye: usize) -> Outcome {
        let Some(&rbt) = self.document.scene.eyes().get(eye) else {
            return Err(CommandError::NotInScene { what: "eye" });
        };
        self.commit_gesture();
        self.session.eye = eye;
        Ok(format!("Looking from {}.", self.document.scene.rbt_path(rbt)))
    }

    fn choose(&mut self, rbt: Option<RbtIndex>) -> Outcome {
        if rbt.is_some_and(|rbt| rbt.get() >= self.document.scene.rbt_count()) {
            return Err(CommandError::NotInScene { what: "node" });
        }
        self.commit_gesture();
        self.session.chosen = rbt;
        self.session.is_picking = false;
        Ok(match rbt {
            Some(rbt) => format!("Chosen: {}.", self.document.scene.rbt_path(rbt)),
            None => "Nothing chosen: a drag moves the eye.".to_owned(),
        })
    }
}
