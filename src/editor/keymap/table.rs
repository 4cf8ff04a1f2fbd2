//! The bindings themselves.

use super::{Binding, Chord, Group, Key, Modifiers};
use crate::editor::{Command, Edit, FileCommand, PlaybackCommand, TimelineEdit, ViewCommand, WindowCommand};

/// The table of bindings. The order is the help's.
#[must_use]
#[expect(clippy::too_many_lines, reason = "it is one table")]
pub fn bindings() -> Vec<Binding> {
    let plain = Modifiers::default();
    let shift = Modifiers { shift: true, ..plain };
    let ctrl = Modifiers { ctrl: true, ..plain };
    let ctrl_shift = Modifiers { ctrl: true, shift: true, ..plain };
    let key = |key| Chord { key, modifiers: plain };
    let typed = |character| key(Key::Character(character));
    let held = |modifiers, character| Chord { key: Key::Character(character), modifiers };
    let row =
        |group, chords: Vec<Chord>, command, name, help| Binding { chords, command, name, help, group, repeats: false };
    let repeating =
        |group, chords, command, name, help| Binding { repeats: true, ..row(group, chords, command, name, help) };
    let edit = Command::Edit;
    let view = Command::View;
    vec![
        row(
            Group::Keyframes,
            vec![key(Key::Space), typed('c')],
            edit(Edit::DisplayCurrent),
            "Display keyframe",
            "Copy the current keyframe to the scene",
        ),
        row(
            Group::Keyframes,
            vec![typed('u')],
            edit(Edit::UpdateCurrent),
            "Update keyframe",
            "Update the current keyframe from the scene",
        ),
        repeating(
            Group::Keyframes,
            vec![typed('>'), typed('.')],
            edit(Edit::GoToNext),
            "Next keyframe",
            "Go to the next keyframe and copy it to the scene",
        ),
        repeating(
            Group::Keyframes,
            vec![typed('<'), typed(',')],
            edit(Edit::GoToPrevious),
            "Previous keyframe",
            "Go to the previous keyframe and copy it to the scene",
        ),
        row(
            Group::Keyframes,
            vec![typed('d')],
            edit(Edit::DeleteCurrent),
            "Delete keyframe",
            "Delete the current keyframe",
        ),
        row(
            Group::Keyframes,
            vec![typed('n')],
            edit(Edit::CreateKeyframe),
            "New keyframe",
            "New keyframe from the scene, after the current one",
        ),
        row(
            Group::Keyframes,
            vec![typed('r')],
            edit(Edit::ResetPose),
            "Rest pose",
            "Return the scene to its rest pose",
        ),
        row(
            Group::Timeline,
            vec![held(ctrl, 'c')],
            view(ViewCommand::CopyKeyframes),
            "Copy keyframes",
            "Copy the selected keyframes, or the current one",
        ),
        row(
            Group::Timeline,
            vec![held(ctrl, 'x')],
            edit(Edit::Timeline(TimelineEdit::CutKeyframes)),
            "Cut keyframes",
            "Cut the selected keyframes, or the current one",
        ),
        row(
            Group::Timeline,
            vec![held(ctrl, 'v')],
            edit(Edit::Timeline(TimelineEdit::PasteKeyframes)),
            "Paste keyframes",
            "Paste the copied keyframes after the selected ones",
        ),
        row(
            Group::Timeline,
            vec![held(ctrl, 'd')],
            edit(Edit::Timeline(TimelineEdit::DuplicateKeyframes)),
            "Duplicate keyframes",
            "Duplicate the selected keyframes, or the current one",
        ),
        row(
            Group::Timeline,
            vec![key(Key::Delete)],
            edit(Edit::Timeline(TimelineEdit::DeleteKeyframes)),
            "Delete keyframes",
            "Delete the selected keyframes, or the current one",
        ),
        row(
            Group::Timeline,
            vec![],
            edit(Edit::Timeline(TimelineEdit::ReverseKeyframes)),
            "Reverse keyframes",
            "Reverse the order of the selected keyframes, or of all",
        ),
        row(
            Group::Timeline,
            vec![key(Key::F2)],
            Command::Window(WindowCommand::RenameCurrent),
            "Rename keyframe…",
            "Give the current keyframe a name",
        ),
        row(
            Group::Timeline,
            vec![typed('f')],
            Command::Window(WindowCommand::FitTimeline),
            "Fit all",
            "Bring all keyframes into sight in the timeline",
        ),
        row(
            Group::Timeline,
            vec![held(shift, 'f')],
            Command::Window(WindowCommand::FitSelection),
            "Fit selection",
            "Bring the selected keyframes into sight in the timeline",
        ),
        row(
            Group::Timeline,
            vec![held(ctrl_shift, 'c')],
            view(ViewCommand::CopyPose),
            "Copy pose",
            "Copy the pose of the chosen node and all below it",
        ),
        row(
            Group::Timeline,
            vec![held(ctrl_shift, 'v')],
            edit(Edit::Timeline(TimelineEdit::PastePose)),
            "Paste pose",
            "Paste the copied pose to the chosen node: the other robot, say",
        ),
        row(
            Group::Playing,
            vec![typed('y')],
            Command::Playback(PlaybackCommand::PlayOrStop),
            "Play or stop",
            "Play from the first playable keyframe, or stop",
        ),
        row(
            Group::Playing,
            vec![held(shift, 'p')],
            Command::Playback(PlaybackCommand::PauseOrResume),
            "Pause or go on",
            "Pause: freeze the pose on screen into the scene; or go on from there",
        ),
        repeating(
            Group::Playing,
            vec![typed('+'), typed('=')],
            edit(Edit::Faster),
            "Faster",
            "100 ms less between keyframes",
        ),
        repeating(Group::Playing, vec![typed('-')], edit(Edit::Slower), "Slower", "100 ms more between keyframes"),
        row(
            Group::Playing,
            vec![typed('t')],
            edit(Edit::NextInterpolation),
            "Next interpolation",
            "Next interpolation: linear, Catmull-Rom",
        ),
        row(
            Group::Playing,
            vec![held(shift, 'y')],
            Command::Playback(PlaybackCommand::PlayFromPlayhead),
            "Play from playhead",
            "Play from the playhead, or stop",
        ),
        repeating(
            Group::Playing,
            vec![key(Key::Right)],
            Command::Playback(PlaybackCommand::Step(1)),
            "Step forward",
            "Move the playhead one tick forward",
        ),
        repeating(
            Group::Playing,
            vec![key(Key::Left)],
            Command::Playback(PlaybackCommand::Step(-1)),
            "Step back",
            "Move the playhead one tick back",
        ),
        row(
            Group::Playing,
            vec![held(shift, 'l')],
            Command::Playback(PlaybackCommand::NextMode),
            "Loop",
            "Play once, in a loop, or forwards and backwards",
        ),
        row(
            Group::Playing,
            vec![held(shift, 'a')],
            view(ViewCommand::ToggleAutoKeys),
            "Auto-key",
            "The end of each drag updates the current keyframe",
        ),
        row(
            Group::Playing,
            vec![key(Key::Home)],
            view(ViewCommand::RestartSeconds),
            "Restart timed keys",
            "Set the clock of keys at their own times to zero (some lessons use the space bar for it)",
        ),
        row(
            Group::Playing,
            vec![Chord { key: Key::Home, modifiers: shift }],
            view(ViewCommand::HoldSeconds),
            "Hold timed keys",
            "Hold the clock of keys at their own times, or let it go on",
        ),
        row(
            Group::View,
            vec![typed('v')],
            view(ViewCommand::NextEye),
            "Next eye",
            "Look from the next eye: the sky, robot 1, robot 2",
        ),
        row(
            Group::View,
            vec![typed('p')],
            view(ViewCommand::StartPicking),
            "Pick a node",
            "Pick: the next click chooses the node to move; the ground chooses none",
        ),
        row(
            Group::View,
            vec![typed('m')],
            view(ViewCommand::ToggleSkyMode),
            "Sky camera's centre",
            "Move the sky camera about the world's centre, or about itself",
        ),
        row(Group::View, vec![typed('a')], view(ViewCommand::ToggleArcball), "Arcball", "Show or hide the arcball"),
        row(
            Group::View,
            vec![Chord { key: Key::Character('p'), modifiers: Modifiers { alt: true, ..plain } }],
            view(ViewCommand::TogglePath),
            "Motion path",
            "Show or hide the path that the chosen node takes",
        ),
        repeating(
            Group::View,
            vec![held(shift, 'g')],
            view(ViewCommand::NextGhosts),
            "Ghosts",
            "Show one more of the neighbouring keyframes on each side as ghosts, up to 3, then none",
        ),
        row(
            Group::View,
            vec![],
            view(ViewCommand::ToggleComparison),
            "Compare interpolations",
            "While playing, show the chosen robot under the other interpolations",
        ),
        row(Group::View, vec![typed('h')], view(ViewCommand::ToggleHelp), "Help", "Show or hide this help"),
        row(Group::View, vec![key(Key::F11)], view(ViewCommand::TogglePanels), "Panels", "Hide or show all panels"),
        row(Group::View, vec![key(Key::Escape)], Command::Cancel, "Cancel", "Leave the mode, drag or dialog at hand"),
        row(
            Group::File,
            vec![typed('i')],
            Command::File(FileCommand::Import),
            "Import",
            "Import the keyframe file; its first keyframe is shown",
        ),
        row(Group::File, vec![typed('w')], Command::File(FileCommand::Write), "Save", "Write the keyframe file"),
        row(
            Group::File,
            vec![held(ctrl, 'o')],
            Command::File(FileCommand::ChooseOpen),
            "Open…",
            "Open another keyframe file",
        ),
        row(
            Group::File,
            vec![held(ctrl_shift, 's')],
            Command::File(FileCommand::ChooseSaveAs),
            "Save As…",
            "Write to another keyframe file",
        ),
        row(
            Group::File,
            vec![typed('s')],
            Command::File(FileCommand::Screenshot(None)),
            "Screenshot",
            "Write a screenshot beside the keyframe file",
        ),
        repeating(Group::File, vec![held(ctrl, 'z')], Command::Undo, "Undo", "Undo"),
        repeating(Group::File, vec![held(ctrl_shift, 'z'), held(ctrl, 'y')], Command::Redo, "Redo", "Redo"),
        row(
            Group::File,
            vec![held(ctrl, 'q')],
            Command::File(FileCommand::Quit),
            "Quit",
            "Quit; asks where something is unsaved",
        ),
        row(
            Group::Window,
            vec![held(ctrl_shift, 'p')],
            Command::Window(WindowCommand::ShowCommands),
            "Commands…",
            "List all commands, and run one by typing a part of its name",
        ),
        row(Group::Window, vec![], Command::Window(WindowCommand::ShowKeys), "Keys…", "Show the keys, and change them"),
        row(
            Group::Window,
            vec![],
            Command::Window(WindowCommand::ToggleMessages),
            "Messages",
            "Show or hide all that was said since the start",
        ),
        repeating(
            Group::Window,
            vec![held(ctrl, '+'), held(ctrl, '=')],
            Command::Window(WindowCommand::Larger),
            "Larger",
            "Show the panels larger",
        ),
        repeating(
            Group::Window,
            vec![held(ctrl, '-')],
            Command::Window(WindowCommand::Smaller),
            "Smaller",
            "Show the panels smaller",
        ),
        row(
            Group::Window,
            vec![held(ctrl, '0')],
            Command::Window(WindowCommand::SetScale(100)),
            "Usual size",
            "Show the panels in the system's size",
        ),
    ]
}
