//! Changes of the work eye's view by command, eased: the command counts at once, the picture follows.

use std::time::Duration;

use web_time::Instant;

use super::now;
use super::shell::Shell;
use crate::editor::{Command, ViewCommand, WorkEye};

/// How long the picture takes.
const DURATION: Duration = Duration::from_millis(120);

/// A picture on its way from where the work eye was to where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Easing {
    from: WorkEye,
    to: WorkEye,
    began: Instant,
}

impl Easing {
    /// Where the picture is looked at from; `None` once it has arrived.
    fn eye(&self, at: Instant) -> Option<WorkEye> {
        let part = at.saturating_duration_since(self.began).as_secs_f32() / DURATION.as_secs_f32();
        // Fast at first, so that a key is answered at once.
        (part < 1.0).then(|| self.from.towards(self.to, 1.0 - (1.0 - part).powi(3)))
    }
}

/// Whether a command leads the work eye somewhere else in one step. Drags and the wheel lead it there themselves.
const fn is_eased(command: &Command) -> bool {
    matches!(
        command,
        Command::View(
            ViewCommand::LookFrom(_)
                | ViewCommand::LookFromNode(_)
                | ViewCommand::LevelEye
                | ViewCommand::ShowAll
                | ViewCommand::ShowChosen
                | ViewCommand::ResetWorkEye
        )
    )
}

impl Shell {
    /// Where the work eye is drawn from before a command that leads it elsewhere; `None` where the picture does not follow slowly.
    pub(super) fn eased_from(&self, command: &Command) -> Option<WorkEye> {
        let is_wanted = is_eased(command) && !self.settings_file.settings.reduce_motion && self.editor.is_work_eye();
        is_wanted
            .then(|| self.easing.and_then(|easing| easing.eye(now())).unwrap_or_else(|| self.editor.session().work_eye))
    }

    /// A command is done before which the picture was looked at from here.
    pub(super) fn ease(&mut self, from: Option<WorkEye>) {
        let to = self.editor.session().work_eye;
        if let Some(from) = from.filter(|from| *from != to) {
            self.easing = Some(Easing { from, to, began: now() });
        } else if self.easing.is_some_and(|easing| easing.to != to) || !self.editor.is_work_eye() {
            self.easing = None;
        }
    }

    /// Where the picture is looked at from, if not from where the editor's eye is.
    pub(super) fn drawn_eye(&mut self) -> Option<WorkEye> {
        let eye = self.easing.and_then(|easing| easing.eye(now()));
        if eye.is_none() {
            self.easing = None;
        }
        eye
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    #[test]
    fn a_picture_goes_the_shorter_way_and_arrives() {
        let from = WorkEye { yaw_degrees: 170.0, pitch_degrees: 10.0, distance: 2.0, target_in_world: Vec3::ZERO };
        let to = WorkEye { yaw_degrees: -170.0, pitch_degrees: -10.0, distance: 8.0, target_in_world: Vec3::X };
        let began = now();
        let easing = Easing { from, to, began };
        let at = |ms| easing.eye(began + Duration::from_millis(ms));
        assert_eq!(at(0), Some(from));
        let eyes: Vec<WorkEye> = (0..120).filter_map(at).collect();
        assert_eq!(eyes.len(), 120);
        let ahead = |eye: &WorkEye| (eye.yaw_degrees - 170.0).rem_euclid(360.0);
        for pair in eyes.windows(2) {
            // Near the end, steps are too small for the numbers.
            assert!(ahead(&pair[0]) <= ahead(&pair[1]) && ahead(&pair[1]) < 20.001, "{pair:?}");
            assert!(pair[0].distance <= pair[1].distance && pair[1].distance < 8.001, "{pair:?}");
        }
        assert!(ahead(&eyes[60]) > 10.0, "it is past the middle at half of the time");
        assert_eq!(at(120), None);
    }

    #[test]
    fn drags_and_recorded_eyes_are_not_eased() {
        use crate::editor::{Eye, Side};
        assert!(is_eased(&Command::View(ViewCommand::LookFrom(Side::Top))));
        assert!(!is_eased(&Command::View(ViewCommand::SetWorkEye(WorkEye::default()))));
        assert!(!is_eased(&Command::View(ViewCommand::SetEye(Eye::Work))));
    }
}
