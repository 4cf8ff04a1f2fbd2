//! The first lines of a journal: what the editor was when it began.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::editor::gizmo::{GizmoAxes, SnapSteps};
use crate::editor::{Command, Editor, Eye, Pivot, PlayMode, PlaybackCommand, SelectionCommand, SkyMode, ViewCommand};
use crate::script::{Restore, print_swiftly};
use crate::storage;

/// A path that can be written, and means the same wherever the journal is read.
pub(super) fn plain(path: &Path) -> PathBuf {
    PathBuf::from(storage::absolute(path).to_string_lossy().as_ref())
}

/// The lines that restore what an editor is now, but for what can be undone where it is not as new.
pub(super) fn lines(editor: &Editor) -> Vec<String> {
    if editor.is_fresh() {
        let scene = Restore::Scene { scene: Arc::clone(editor.scene()), path: editor.scene_path().map(plain) };
        let file = Restore::KeyframeFile(plain(editor.keyframe_file()));
        return [scene, file].iter().filter_map(Restore::line).collect();
    }
    let mut snapshot = editor.snapshot();
    snapshot.path = plain(&snapshot.path);
    snapshot.scene_path = snapshot.scene_path.as_deref().map(plain);
    let snapshot = Restore::Snapshot(Box::new(snapshot)).line();
    let session = session(editor);
    snapshot.into_iter().chain(session.iter().filter_map(|command| print_swiftly(command, editor.scene()))).collect()
}

/// The commands that make the session of a new editor into that of another.
fn session(editor: &Editor) -> Vec<Command> {
    let session = editor.session();
    let view = Command::View;
    let toggled = |is_other: bool, command: ViewCommand| is_other.then(|| view(command));
    let mut commands = Vec::new();
    // Only the sky camera, which a new editor has as its eye, can change what it moves about.
    commands.extend(toggled(session.sky_mode != SkyMode::default(), ViewCommand::ToggleSkyMode));
    commands.extend(session.has_used_work_eye.then(|| view(ViewCommand::SetEye(Eye::Work))));
    commands.push(view(ViewCommand::SetEye(session.eye)));
    commands.push(view(ViewCommand::SetWorkEye(session.work_eye)));
    let mut chosen = session.chosen.iter().copied();
    commands.push(view(ViewCommand::Choose(chosen.next())));
    commands.extend(chosen.map(|rbt| view(ViewCommand::ChooseAlso(rbt))));
    let pivot = (session.pivot != Pivot::default()).then_some(ViewCommand::SetPivot(session.pivot));
    commands.extend(pivot.map(view));
    commands.extend(toggled(session.is_picking, ViewCommand::StartPicking));
    commands.extend(toggled(!session.shows_arcball, ViewCommand::ToggleArcball));
    commands.extend(toggled(!session.shows_gizmo, ViewCommand::ToggleGizmo));
    let axes = (session.gizmo_axes != GizmoAxes::default()).then_some(ViewCommand::SetGizmoAxes(session.gizmo_axes));
    let snap = (session.snap != SnapSteps::default()).then_some(ViewCommand::SetSnapSteps(session.snap));
    commands.extend(axes.into_iter().chain(snap).map(view));
    commands.extend(toggled(!session.shows_motion_path, ViewCommand::ToggleMotionPath));
    commands.push(view(ViewCommand::CompareBlends(session.compared_blends.clone())));
    commands.push(view(ViewCommand::SetGhostsOfChosen(session.ghosts_of_chosen)));
    commands.extend(toggled(session.shows_help, ViewCommand::ToggleHelp));
    commands.extend(toggled(!session.shows_panels, ViewCommand::TogglePanels));
    commands.push(view(ViewCommand::SetAutoKeys(session.auto_keys)));
    commands.push(view(ViewCommand::SetKeepFeet(session.keeps_feet)));
    commands.push(view(ViewCommand::SetGhosts(session.ghosts)));
    let mode = (session.play_mode != PlayMode::default()).then_some(PlaybackCommand::SetMode(session.play_mode));
    let range = session.play_range.map(|range| PlaybackCommand::SetRange(Some(range)));
    let speed = PlaybackCommand::SetSpeedPercent(session.speed_percent);
    commands.extend(mode.into_iter().chain(range).chain([speed]).map(Command::Playback));
    commands.push(if session.selected_keys.is_empty() {
        Command::Selection(SelectionCommand::Keyframes(session.selected.clone()))
    } else {
        Command::Selection(SelectionCommand::TimedKeys(session.selected_keys.clone()))
    });
    commands
}
