//! The bindings themselves.

use super::{Binding, Chord, Group, Key, Modifiers};
use crate::editor::{Command, Edit, FileCommand, PlaybackCommand, SceneEdit, TimelineEdit, ViewCommand, WindowCommand};

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
    // The names and the help stand in the files of words.
    let row = |group, chords: Vec<Chord>, command, id| Binding {
        chords,
        command,
        id,
        name: Binding::title_of(id).english(),
        help: Binding::explanation_of(id).english(),
        group,
        repeats: false,
    };
    let repeating = |group, chords, command, id| Binding { repeats: true, ..row(group, chords, command, id) };
    let edit = Command::Edit;
    let view = Command::View;
    vec![
        row(Group::Keyframes, vec![key(Key::Space), typed('c')], edit(Edit::DisplayCurrent), "keyframe-display"),
        row(Group::Keyframes, vec![typed('u')], edit(Edit::UpdateCurrent), "keyframe-update"),
        repeating(Group::Keyframes, vec![typed('>'), typed('.')], edit(Edit::GoToNext), "keyframe-next"),
        repeating(Group::Keyframes, vec![typed('<'), typed(',')], edit(Edit::GoToPrevious), "keyframe-previous"),
        row(Group::Keyframes, vec![typed('d')], edit(Edit::DeleteCurrent), "keyframe-delete"),
        row(Group::Keyframes, vec![typed('n')], edit(Edit::CreateKeyframe), "keyframe-new"),
        row(Group::Keyframes, vec![typed('r')], edit(Edit::ResetPose), "pose-rest"),
        row(Group::Timeline, vec![held(ctrl, 'c')], view(ViewCommand::CopyKeyframes), "keyframes-copy"),
        row(Group::Timeline, vec![held(ctrl, 'x')], edit(Edit::Timeline(TimelineEdit::CutKeyframes)), "keyframes-cut"),
        row(
            Group::Timeline,
            vec![held(ctrl, 'v')],
            edit(Edit::Timeline(TimelineEdit::PasteKeyframes)),
            "keyframes-paste",
        ),
        row(
            Group::Timeline,
            vec![held(ctrl, 'd')],
            edit(Edit::Timeline(TimelineEdit::DuplicateKeyframes)),
            "keyframes-duplicate",
        ),
        row(
            Group::Timeline,
            vec![key(Key::Delete)],
            edit(Edit::Timeline(TimelineEdit::DeleteKeyframes)),
            "keyframes-delete",
        ),
        row(Group::Timeline, vec![], edit(Edit::Timeline(TimelineEdit::ReverseKeyframes)), "keyframes-reverse"),
        row(Group::Timeline, vec![], edit(Edit::Scene(SceneEdit::PutControlAboveChosen)), "control-node-above"),
        row(Group::Timeline, vec![key(Key::F2)], Command::Window(WindowCommand::RenameCurrent), "keyframe-rename"),
        row(Group::Timeline, vec![typed('f')], Command::Window(WindowCommand::FitTimeline), "timeline-fit-all"),
        row(
            Group::Timeline,
            vec![held(shift, 'f')],
            Command::Window(WindowCommand::FitSelection),
            "timeline-fit-selection",
        ),
        row(Group::Timeline, vec![held(ctrl_shift, 'c')], view(ViewCommand::CopyPose), "pose-copy"),
        row(Group::Timeline, vec![held(ctrl_shift, 'v')], edit(Edit::Timeline(TimelineEdit::PastePose)), "pose-paste"),
        row(Group::Playing, vec![typed('y')], Command::Playback(PlaybackCommand::PlayOrStop), "play-or-stop"),
        row(
            Group::Playing,
            vec![held(shift, 'p')],
            Command::Playback(PlaybackCommand::PauseOrResume),
            "pause-or-resume",
        ),
        repeating(Group::Playing, vec![typed('+'), typed('=')], edit(Edit::Faster), "faster"),
        repeating(Group::Playing, vec![typed('-')], edit(Edit::Slower), "slower"),
        row(Group::Playing, vec![typed('t')], edit(Edit::NextInterpolation), "interpolation-next"),
        row(
            Group::Playing,
            vec![held(shift, 'y')],
            Command::Playback(PlaybackCommand::PlayFromPlayhead),
            "play-from-playhead",
        ),
        repeating(Group::Playing, vec![key(Key::Right)], Command::Playback(PlaybackCommand::Step(1)), "step-forward"),
        repeating(Group::Playing, vec![key(Key::Left)], Command::Playback(PlaybackCommand::Step(-1)), "step-back"),
        row(Group::Playing, vec![held(shift, 'l')], Command::Playback(PlaybackCommand::NextMode), "play-mode-next"),
        row(Group::Playing, vec![held(shift, 'a')], view(ViewCommand::ToggleAutoKeys), "auto-key"),
        row(Group::Playing, vec![key(Key::Home)], view(ViewCommand::RestartSeconds), "timed-keys-restart"),
        row(
            Group::Playing,
            vec![Chord { key: Key::Home, modifiers: shift }],
            view(ViewCommand::HoldSeconds),
            "timed-keys-hold",
        ),
        row(Group::View, vec![typed('v')], view(ViewCommand::NextEye), "eye-next"),
        row(Group::View, vec![typed('p')], view(ViewCommand::StartPicking), "pick"),
        row(Group::View, vec![typed('m')], view(ViewCommand::ToggleSkyMode), "sky-mode"),
        row(Group::View, vec![typed('a')], view(ViewCommand::ToggleArcball), "arcball"),
        row(
            Group::View,
            vec![Chord { key: Key::Character('p'), modifiers: Modifiers { alt: true, ..plain } }],
            view(ViewCommand::TogglePath),
            "motion-path",
        ),
        repeating(Group::View, vec![held(shift, 'g')], view(ViewCommand::NextGhosts), "ghosts-next"),
        row(Group::View, vec![], view(ViewCommand::ToggleComparison), "interpolations-compare"),
        row(Group::View, vec![typed('h')], view(ViewCommand::ToggleHelp), "help"),
        row(Group::View, vec![key(Key::F11)], view(ViewCommand::TogglePanels), "panels"),
        row(Group::View, vec![key(Key::Escape)], Command::Cancel, "cancel"),
        row(Group::File, vec![typed('i')], Command::File(FileCommand::Import), "import"),
        row(Group::File, vec![typed('w')], Command::File(FileCommand::Write), "save"),
        row(Group::File, vec![held(ctrl, 'o')], Command::File(FileCommand::ChooseOpen), "open"),
        row(Group::File, vec![held(ctrl_shift, 's')], Command::File(FileCommand::ChooseSaveAs), "save-as"),
        row(Group::File, vec![], Command::File(FileCommand::WriteScene), "scene-save"),
        row(Group::File, vec![], Command::File(FileCommand::ChooseSaveSceneAs), "scene-save-as"),
        row(Group::File, vec![typed('s')], Command::File(FileCommand::Screenshot(None)), "screenshot"),
        row(Group::File, vec![held(ctrl, 'e')], Command::Window(WindowCommand::ShowExport), "export"),
        repeating(Group::File, vec![held(ctrl, 'z')], Command::Undo, "undo"),
        repeating(Group::File, vec![held(ctrl_shift, 'z'), held(ctrl, 'y')], Command::Redo, "redo"),
        row(Group::File, vec![held(ctrl, 'q')], Command::File(FileCommand::Quit), "quit"),
        row(Group::Window, vec![held(ctrl_shift, 'p')], Command::Window(WindowCommand::ShowCommands), "commands"),
        row(Group::Window, vec![], Command::Window(WindowCommand::ShowKeys), "hotkeys"),
        row(Group::Window, vec![], Command::Window(WindowCommand::ToggleMessages), "messages"),
        row(Group::Window, vec![], Command::Window(WindowCommand::ToggleStatistics), "statistics"),
        repeating(
            Group::Window,
            vec![held(ctrl, '+'), held(ctrl, '=')],
            Command::Window(WindowCommand::Larger),
            "scale-larger",
        ),
        repeating(Group::Window, vec![held(ctrl, '-')], Command::Window(WindowCommand::Smaller), "scale-smaller"),
        row(Group::Window, vec![held(ctrl, '0')], Command::Window(WindowCommand::SetScale(100)), "scale-usual"),
    ]
}
