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

    /// What the eye is and how a drag moves, in a few words: `sky view · world-sky`.
    #[must_use]
    pub fn view_sentence(&self) -> String {
        let eye = self.document.scene.node(self.document.scene.rbt_node(self.eye())).name.as_str();
        let handled = match (self.session.chosen, self.session.eye, self.session.sky_mode) {
            (Some(chosen), ..) => format!("moves {}", self.document.scene.rbt_path(chosen)),
            (None, 0, SkyMode::WorldCentre) => "world-sky".to_owned(),
            (None, 0, SkyMode::Eye) => "sky-sky".to_owned(),
            (None, ..) => "moves itself".to_owned(),
        };
        format!("{eye} view · {handled}")
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
        assert_eq!(editor.view_sentence(), "sky view · world-sky");
        editor.apply(Command::View(ViewCommand::ToggleSkyMode)).unwrap();
        assert_eq!(editor.view_sentence(), "sky view · sky-sky");
        editor.apply(Command::View(ViewCommand::NextEye)).unwrap();
        assert_eq!(editor.view_sentence(), "robot1 view · moves itself");
    }
}
