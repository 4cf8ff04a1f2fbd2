//! Journals: what is written reads back to the same document, whatever was done and wherever the text ends.

mod common;

use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};

use common::{any_node_edit, any_rbt_index, editor, editor_with, press};
use glam::{Quat, Vec3};
use inbetween::editor::{
    ClipboardCommand, Command, Edit, Editor, Eye, FileAccess, FileCommand, GestureCommand, KeyAt, Pivot,
    PlaybackCommand, SceneEdit, SelectionCommand, TimelineEdit, ViewCommand, WorkEye, Written,
};
use inbetween::journal::{self, Ending, Writer, play_alone, survey};
use inbetween::keyframe::{Easing, KeyframeIndex, keyframes_to_json};
use inbetween::pose::RbtIndex;
use inbetween::pose_file::shipped_poses;
use inbetween::rbt::Rbt;
use inbetween::scene::{Channel, KeyValue};
use inbetween::script;
use inbetween::storage::{LeftLog, Log};
use proptest::prelude::*;
use proptest::strategy::ValueTree as _;
use proptest::test_runner::TestRunner;

/// An editor that keeps a journal, as the window does it.
struct Kept {
    editor: Editor,
    journal: Writer,
}

impl Kept {
    fn new(editor: Editor, path: &Path) -> Self {
        let journal = Writer::begin(Log::create(path, |_| true).unwrap(), &editor);
        Self { editor, journal }
    }

    fn apply(&mut self, command: Command) {
        self.journal.command(&self.editor, &command);
        let _ = self.editor.apply(command);
    }

    fn tick(&mut self, ticks: u64) {
        let was_playing = self.editor.is_playing();
        self.editor.tick(ticks);
        self.journal.ticked(was_playing, &self.editor, ticks);
    }

    fn import(&mut self, bytes: &[u8]) {
        self.journal.command(&self.editor, &Command::File(FileCommand::Import));
        if self.editor.apply(Command::File(FileCommand::Import)).is_ok() {
            self.journal.read(FileAccess::KeyframesRead, Path::new("other.json"), bytes);
            let _ = self.editor.keyframes_read(Path::new("other.json"), Ok(bytes.to_vec()));
        }
    }
}

fn text_of(editor: &Editor) -> String {
    let document = editor.document();
    keyframes_to_json(editor.scene(), &document.keyframes, document.interpolation, document.ms_between_keyframes)
}

#[track_caller]
fn assert_same(a: &Editor, b: &Editor) {
    let [of_a, of_b] = [a, b].map(Editor::document);
    assert!(of_a.same_scene_as(of_b), "the scenes differ");
    assert!(of_a.same_file_as(of_b), "the keyframes differ");
    assert_eq!(of_a.keyframes.current(), of_b.keyframes.current());
    assert_eq!(of_a.live_pose, of_b.live_pose);
    assert!(of_a == of_b);
    assert_eq!(format!("{:?}", a.document().live_pose), format!("{:?}", b.document().live_pose), "bits of the pose");
    assert_eq!(a.session(), b.session());
    assert_eq!((a.undo_label(), a.redo_label()), (b.undo_label(), b.redo_label()));
    assert_eq!(a.seconds(), b.seconds());
    assert_eq!((a.is_playing(), a.is_paused(), a.key_time()), (b.is_playing(), b.is_paused(), b.key_time()));
}

fn any_rbt() -> impl Strategy<Value = Rbt> {
    (prop::array::uniform3(-3.0f32..3.0), prop::array::uniform3(-2.0f32..2.0))
        .prop_map(|(t, r)| Rbt::new(Vec3::from(t), Quat::from_scaled_axis(Vec3::from(r))))
}

/// What imports read.
static OTHERS: LazyLock<Vec<Vec<u8>>> = LazyLock::new(common::other_files);

#[derive(Clone, Debug)]
enum Step {
    Command(Command),
    Tick(u64),
    /// Reads one of [`OTHERS`].
    Import(usize),
    ReloadScene(usize),
    NewScene,
}

/// Degrees or units, some of them further than coordinates go.
fn amount() -> BoxedStrategy<f64> {
    prop_oneof![6 => -400.0f64..400.0, 1 => prop::sample::select(&[0.0, 180.0, 1e6, -1e300])].boxed()
}

fn any_step() -> impl Strategy<Value = Step> {
    let place = || (0usize..8).prop_map(KeyframeIndex::new);
    let edit = prop_oneof![
        4 => Just(Edit::CreateKeyframe),
        2 => Just(Edit::UpdateCurrent),
        1 => Just(Edit::DeleteCurrent),
        1 => Just(Edit::GoToNext),
        1 => place().prop_map(Edit::GoTo),
        1 => Just(Edit::ResetPose),
        1 => Just(Edit::NextInterpolation),
        1 => (0u32..20_000).prop_map(Edit::SetMsBetweenKeyframes),
        2 => any_rbt().prop_map(|by| Edit::TranslateChosen(by.translation)),
        2 => (-9.0f64..9.0).prop_map(|radians| Edit::RotateChosen { axis_in_node: Vec3::Y, radians }),
        2 => any_rbt().prop_map(Edit::Wheel),
        2 => (0usize..24, any_rbt()).prop_map(|(rbt, to)| Edit::Reach(RbtIndex::new(rbt), to.translation)),
        1 => (0usize..24, -400.0f64..400.0).prop_map(|(rbt, by)| Edit::TurnPole(RbtIndex::new(rbt), by)),
        2 => common::any_pull(amount()).prop_map(Edit::PullChosen),
        2 => (0usize..24, any_rbt()).prop_map(|(rbt, to)| Edit::SetRotation(RbtIndex::new(rbt), to.rotation)),
        1 => prop::sample::select(&[f32::NAN, 1e6, -1e6, 1.1e6, 3e38])
            .prop_map(|x| Edit::SetTranslation(RbtIndex::new(2), Vec3::X * x)),
        1 => (place(), 0.1f64..3.0, any::<bool>()).prop_map(|(keyframe, duration, ripple_free)| {
            Edit::Timeline(TimelineEdit::SetDuration { keyframe, duration, ripple_free })
        }),
        1 => (place(), "[a-z #\"\u{1}가]{0,6}").prop_map(|(at, name)| Edit::Timeline(TimelineEdit::RenameKeyframe(at, name))),
        1 => Just(Edit::Timeline(TimelineEdit::CutKeyframes)),
        2 => Just(Edit::Timeline(TimelineEdit::PasteKeyframes)),
        1 => Just(Edit::Timeline(TimelineEdit::DuplicateKeyframes)),
        1 => prop::sample::select(shipped_poses()).prop_map(|pose| Edit::Pose(Arc::new(pose))),
        2 => (any_node_edit(), prop::option::of(any_rbt_index())).prop_map(|(edit, node)| Edit::Nodes(edit, node)),
        1 => Just(Edit::Timeline(TimelineEdit::ReverseKeyframes)),
        1 => (0usize..9).prop_map(|to| Edit::Timeline(TimelineEdit::MoveKeyframes(to))),
        1 => Just(Edit::Timeline(TimelineEdit::SetEasing(Easing::Hold))),
        2 => Just(Edit::Scene(SceneEdit::PutControlAbove("robot1".into()))),
        1 => Just(Edit::Scene(SceneEdit::RemoveControl("robot1_control".into()))),
        1 => Just(Edit::Scene(SceneEdit::RenameControl("robot1_control".into(), "spin".to_owned()))),
        2 => (0u8..8, any_rbt()).prop_map(|(at, rbt)| Edit::Scene(SceneEdit::SetKey {
            node: "robot1_control".into(),
            seconds: f64::from(at) * 0.5,
            value: KeyValue::Translation(rbt.translation),
        })),
        1 => (0u8..8).prop_map(|at| {
            Edit::Scene(SceneEdit::AddKeys(vec![KeyAt::new("robot1_control", Channel::Translation, f64::from(at))]))
        }),
    ];
    let view = prop_oneof![
        2 => prop::option::of(0usize..24).prop_map(|rbt| Command::View(ViewCommand::Choose(rbt.map(RbtIndex::new)))),
        1 => prop::sample::select(&[Pivot::Own, Pivot::Common]).prop_map(|pivot| Command::View(ViewCommand::SetPivot(pivot))),
        2 => (0usize..24).prop_map(|rbt| Command::View(ViewCommand::ChooseAlso(RbtIndex::new(rbt)))),
        1 => Just(Command::View(ViewCommand::NextEye)),
        1 => Just(Command::View(ViewCommand::SetEye(Eye::Work))),
        1 => (-200f32..200.0).prop_map(|yaw_degrees| {
            Command::View(ViewCommand::SetWorkEye(WorkEye { yaw_degrees, ..WorkEye::default() }))
        }),
        1 => Just(Command::View(ViewCommand::ToggleAutoKeys)),
        1 => Just(Command::View(ViewCommand::ToggleKeepFeet)),
        1 => Just(Command::View(ViewCommand::ToggleSkyMode)),
        2 => prop::collection::btree_set(0usize..8, 0..4).prop_map(|indices| {
            Command::Selection(SelectionCommand::Keyframes(indices.into_iter().map(KeyframeIndex::new).collect()))
        }),
        1 => Just(Command::Clipboard(ClipboardCommand::CopyKeyframes)),
        1 => prop::option::of(any_rbt_index()).prop_map(|node| Command::Clipboard(ClipboardCommand::CopyPose(node))),
        1 => (0.0f64..5.0).prop_map(|seconds| Command::View(ViewCommand::ScrubSeconds(seconds))),
        1 => Just(Command::View(ViewCommand::HoldTimedKeys)),
    ];
    let playback = prop_oneof![
        2 => Just(PlaybackCommand::PlayOrStop),
        1 => Just(PlaybackCommand::PauseOrResume),
        1 => (0.0f64..6.0).prop_map(PlaybackCommand::Scrub),
        1 => Just(PlaybackCommand::NextMode),
        1 => (10u32..1000).prop_map(PlaybackCommand::SetSpeedPercent),
    ];
    let gesture = prop_oneof![
        2 => Just(GestureCommand::Begin),
        5 => any_rbt().prop_map(GestureCommand::Move),
        1 => prop::sample::select(&[9e5_f32, 3e38]).prop_map(|x| GestureCommand::Move(Rbt::from_translation(Vec3::X * x))),
        4 => common::any_hold(amount()),
        2 => Just(GestureCommand::Commit),
        1 => Just(GestureCommand::Abort),
    ];
    let command = prop_oneof![
        12 => edit.prop_map(Command::Edit),
        5 => view,
        2 => playback.prop_map(Command::Playback),
        5 => gesture.prop_map(Command::Gesture),
        4 => Just(Command::Undo),
        2 => Just(Command::Redo),
        1 => Just(Command::Cancel),
    ];
    prop_oneof![
        60 => command.prop_map(Step::Command),
        6 => (0u64..200).prop_map(Step::Tick),
        2 => (0..OTHERS.len()).prop_map(Step::Import),
        1 => (0usize..24).prop_map(Step::ReloadScene),
        1 => Just(Step::NewScene),
    ]
}

fn run(kept: &mut Kept, step: Step) {
    match step {
        Step::Command(command) => kept.apply(command),
        Step::Tick(ticks) => kept.tick(ticks),
        Step::ReloadScene(rbt) => {
            let scene = kept.editor.scene();
            let Ok((other, _)) = scene.with_control_above(scene.rbt_node(RbtIndex::new(rbt % scene.rbt_count())))
            else {
                return;
            };
            let bytes = inbetween::scene::scene_to_json(&other).into_bytes();
            kept.journal.command(&kept.editor, &Command::File(FileCommand::ReloadScene));
            let _ = kept.editor.apply(Command::File(FileCommand::ReloadScene));
            kept.journal.read(FileAccess::SceneRead, Path::new("scene.json"), &bytes);
            let _ = kept.editor.scene_read(Path::new("scene.json"), Ok(bytes));
        }
        Step::Import(index) => kept.import(&OTHERS[index]),
        Step::NewScene => {
            let scene = inbetween::scene::built_in_scene("orbits").unwrap();
            let other = inbetween::scene::built_in_scene(inbetween::scene::DEFAULT_SCENE).unwrap();
            let scene = if kept.editor.scene().name() == scene.name() { other } else { scene };
            let line = script::Restore::Scene { scene: scene.into(), path: None };
            kept.journal.flush(&kept.editor);
            kept.journal.restored(&line);
            line.apply(&mut kept.editor);
        }
    }
}

#[test]
fn random_commands_read_back_to_the_same_document() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("random.journal");
    let mut runner = TestRunner::deterministic();
    let strategy = any_step();
    let mut done = 0;
    let commands = common::random_commands();
    while done < commands {
        let mut kept = Kept::new(editor(), &path);
        for _ in 0..500.min(commands - done) {
            let step = strategy.new_tree(&mut runner).unwrap().current();
            let shown = format!("{step:?}");
            run(&mut kept, step);
            common::assert_invariants(&kept.editor, &shown);
            done += 1;
        }
        common::assert_reads_back(&kept.editor);
        kept.journal.flush(&kept.editor);
        let text = std::fs::read(&path).unwrap();
        let (again, played) = play_alone(&text);
        assert_eq!((played.damage, played.passed_over, played.is_cut), (None, 0, false));
        assert_same(&again, &kept.editor);
        // From a snapshot everything is the same, also where a step from before it is undone.
        if kept.editor.is_at_rest() {
            let other = folder.path().join("snapshot.journal");
            let mut continued = Kept::new(kept.editor, &other);
            for _ in 0..50 {
                let step = strategy.new_tree(&mut runner).unwrap().current();
                run(&mut continued, step);
            }
            continued.journal.flush(&continued.editor);
            let (again, played) = play_alone(&std::fs::read(&other).unwrap());
            assert_eq!(played.damage, None);
            assert!(again.document() == continued.editor.document());
            assert_eq!(again.session(), continued.editor.session());
        }
    }
}

/// A journal of four commands.
fn small(path: &Path) -> (Vec<u8>, Editor) {
    let mut kept = Kept::new(editor(), path);
    for _ in 0..2 {
        kept.apply(Command::Edit(Edit::CreateKeyframe));
    }
    kept.apply(Command::View(ViewCommand::Choose(Some(RbtIndex::new(2)))));
    kept.apply(Command::Edit(Edit::TranslateChosen(Vec3::X)));
    (std::fs::read(path).unwrap(), kept.editor)
}

#[test]
fn a_journal_that_is_cut_off_is_read_as_far_as_it_is_whole() {
    let folder = tempfile::tempdir().unwrap();
    let (text, _) = small(&folder.path().join("a.journal"));
    for end in 0..text.len() {
        let (_, played) = play_alone(&text[..end]);
        let whole =
            text[..end].split(|&byte| byte == b'\n').rev().skip(1).filter(|line| !line.starts_with(b"#")).count();
        assert_eq!((played.lines, played.damage), (whole, None), "cut at {end}");
        assert_eq!(played.is_cut, end > 0 && text[end - 1] != b'\n');
    }
}

#[test]
fn a_damaged_line_ends_the_reading_and_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let (mut text, _) = small(&folder.path().join("a.journal"));
    let at = text.windows(6).rposition(|bytes| bytes == b"select").unwrap();
    text[at] = 0xff;
    let (editor, played) = play_alone(&text);
    let number = text[..at].split(|&byte| byte == b'\n').count();
    assert_eq!(played.damage, Some((number, "not UTF-8".to_owned())));
    assert_eq!(editor.document().keyframes.len(), 2);
}

#[test]
fn undo_ends_where_the_program_had_started() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.journal");
    let mut kept = Kept::new(editor(), &path);
    kept.import(text_of(&editor_with(3)).as_bytes());
    kept.journal.restored(&script::Restore::Ground);
    kept.editor.begin_history();
    kept.apply(Command::Edit(Edit::CreateKeyframe));
    let (mut again, _) = play_alone(&std::fs::read(&path).unwrap());
    assert_same(&again, &kept.editor);
    press(&mut again, "ctrl+z");
    press(&mut again, "ctrl+z");
    assert_eq!(again.document().keyframes.len(), 3);
}

#[test]
fn marked_lines_are_passed_over() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.journal");
    let mut kept = Kept::new(editor(), &path);
    kept.apply(Command::Edit(Edit::CreateKeyframe));
    kept.journal.command(&kept.editor, &Command::Edit(Edit::CreateKeyframe));
    kept.journal.panicked();
    kept.apply(Command::Edit(Edit::CreateKeyframe));
    kept.journal.command(&kept.editor, &Command::Edit(Edit::ResetPose));
    kept.journal.end(&kept.editor, Ending::Fault);
    let (again, played) = play_alone(&std::fs::read(&path).unwrap());
    assert_eq!(played.passed_over, 2);
    assert_same(&again, &kept.editor);
}

#[test]
fn going_back_before_a_command_takes_nothing_from_undo() {
    let mut editor = editor_with(3);
    let choose = Command::View(ViewCommand::Choose(Some(RbtIndex::new(2))));
    for command in [choose, Command::Edit(Edit::TranslateChosen(Vec3::X)), Command::Undo] {
        editor.apply(command).unwrap();
    }
    for command in [
        Command::Undo,
        Command::Redo,
        Command::Edit(Edit::CreateKeyframe),
        Command::Edit(Edit::Wheel(Rbt::from_translation(Vec3::Y))),
        Command::Gesture(GestureCommand::Begin),
    ] {
        let (before, whole) = (editor.before(), editor.clone());
        editor.apply(command).unwrap();
        editor.go_back(before);
        assert_same(&editor, &whole);
        let [mut ours, mut theirs] = [editor.clone(), whole];
        for step in [Command::Redo, Command::Undo, Command::Undo, Command::Undo] {
            assert_eq!(ours.apply(step.clone()).is_ok(), theirs.apply(step).is_ok());
            assert_same(&ours, &theirs);
        }
    }
}

#[test]
fn as_many_steps_can_be_undone_as_are_promised() {
    use inbetween::editor::MOST_STEPS;
    let mut editor = editor();
    editor.apply(Command::View(ViewCommand::Choose(Some(RbtIndex::new(2))))).unwrap();
    // So many that the older ones were forgotten in between.
    for _ in 0..3 * MOST_STEPS {
        editor.apply(Command::Edit(Edit::TranslateChosen(Vec3::X))).unwrap();
    }
    let undone = (0..).take_while(|_| editor.apply(Command::Undo).is_ok()).count();
    let redone = (0..).take_while(|_| editor.apply(Command::Redo).is_ok()).count();
    assert_eq!((undone, redone), (MOST_STEPS, MOST_STEPS));
}

#[test]
fn undo_of_what_came_before_a_snapshot_is_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.journal");
    let mut kept = Kept::new(editor_with(4), &path);
    let steps = |kept: &mut Kept, commands: &[Command]| {
        for command in commands {
            kept.apply(command.clone());
            let text = std::fs::read(&path).unwrap();
            let (again, played) = play_alone(&text);
            assert_eq!((played.damage, played.passed_over), (None, 0));
            assert!(again.document() == kept.editor.document(), "after {command:?}");
            assert_eq!(again.session(), kept.editor.session());
        }
    };
    let new = Command::Edit(Edit::CreateKeyframe);
    steps(&mut kept, &[Command::Undo, Command::Undo, Command::Redo, Command::Redo, Command::Redo]);
    steps(&mut kept, &[new.clone(), Command::Undo, Command::Undo, Command::Redo, Command::Redo, new.clone()]);
    steps(&mut kept, &vec![Command::Undo; 7]);
    steps(&mut kept, &vec![Command::Redo; 8]);
    // What was done after it is undone step by step.
    steps(&mut kept, &[new.clone(), new, Command::Undo]);
    assert_eq!(play_alone(&std::fs::read(&path).unwrap()).0.undo_label(), kept.editor.undo_label());
}

#[test]
fn the_ground_of_undo_is_the_same_when_a_journal_is_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.journal");
    let mut kept = Kept::new(editor(), &path);
    kept.import(text_of(&editor_with(3)).as_bytes());
    kept.journal.restored(&script::Restore::Ground);
    kept.editor.begin_history();
    kept.apply(Command::Undo);
    kept.apply(Command::Edit(Edit::CreateKeyframe));
    assert_same(&play_alone(&std::fs::read(&path).unwrap()).0, &kept.editor);
    kept.apply(Command::Undo);
    kept.apply(Command::Undo);
    assert_same(&play_alone(&std::fs::read(&path).unwrap()).0, &kept.editor);
    assert_eq!(kept.editor.document().keyframes.len(), 3);
}

#[test]
fn a_last_line_that_ends_the_recovery_is_passed_over_the_next_time() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.journal");
    let (text, _) = small(&path);
    // Whoever began to recover it did not come to the end.
    std::fs::write(&path, [&text[..], b"# recovering\n"].concat()).unwrap();
    let log = LeftLog::open(&path).unwrap().unwrap();
    let (_, played, _) = journal::recover(&log).unwrap();
    assert_eq!((played.passed_over, played.lines), (1, 5));
}

#[test]
fn a_drag_is_written_when_it_ends_and_playing_as_whole_ticks() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.journal");
    let mut kept = Kept::new(editor(), &path);
    let lines = || {
        let text = std::fs::read_to_string(&path).unwrap();
        text.split_once("# commands\n").unwrap().1.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    kept.apply(Command::View(ViewCommand::Choose(Some(RbtIndex::new(2)))));
    kept.apply(Command::Gesture(GestureCommand::Begin));
    for _ in 0..1000 {
        kept.apply(Command::Gesture(GestureCommand::Move(Rbt::from_translation(Vec3::X))));
    }
    assert_eq!(lines().len(), 1);
    kept.apply(Command::Gesture(GestureCommand::Commit));
    let written = lines();
    assert_eq!(written[1], "drag begin");
    assert!(written[2].starts_with("drag-to move "), "{written:?}");
    assert_eq!(written[3..], ["drag end"]);
    for _ in 0..5 {
        kept.apply(Command::Edit(Edit::CreateKeyframe));
    }
    kept.apply(Command::Playback(PlaybackCommand::PlayOrStop));
    for _ in 0..37 {
        kept.tick(1);
    }
    kept.apply(Command::Playback(PlaybackCommand::PauseOrResume));
    assert_eq!(lines()[lines().len() - 2], "wait 37t");
    assert_same(&play_alone(&std::fs::read(&path).unwrap()).0, &kept.editor);
}

#[test]
fn a_survey_says_what_is_not_saved() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.journal");
    let survey = || survey(&std::fs::read(&path).unwrap()).unwrap();
    let mut kept = Kept::new(editor(), &path);
    assert_eq!((survey().commands, survey().unsaved, survey().is_over), (0, 0, false));
    kept.import(text_of(&editor_with(3)).as_bytes());
    kept.apply(Command::View(ViewCommand::Choose(None)));
    assert_eq!((survey().commands, survey().unsaved), (2, 0), "what was only loaded is saved");
    kept.apply(Command::Edit(Edit::CreateKeyframe));
    assert_eq!((survey().commands, survey().unsaved), (3, 1));
    kept.journal.wrote(FileAccess::KeyframesWritten, Path::new("/tmp/walk #1.json"));
    assert_eq!((survey().unsaved, survey().keyframes), (0, PathBuf::from("/tmp/walk #1.json")));
    let _ = kept.editor.keyframes_written(Path::new("/tmp/walk #1.json"), Ok(Written::default()));
    kept.journal.flush(&kept.editor);
    let again = play_alone(&std::fs::read(&path).unwrap()).0;
    assert_eq!(again.keyframe_file(), Path::new("/tmp/walk #1.json"));
    assert!(!again.has_unsaved_keyframes());
    kept.journal.end(&kept.editor, Ending::Quit);
    assert!(survey().is_over);
}

#[test]
fn going_on_from_another_journal_keeps_the_steps_of_undo() {
    let folder = tempfile::tempdir().unwrap();
    let (old, editor) = small(&folder.path().join("a.journal"));
    let path = folder.path().join("b.journal");
    let journal = Writer::continuing(Log::create(&path, |_| true).unwrap(), &old, &editor);
    let mut kept = Kept { editor, journal };
    kept.apply(Command::Edit(Edit::CreateKeyframe));
    let (mut again, _) = play_alone(&std::fs::read(&path).unwrap());
    assert_same(&again, &kept.editor);
    for _ in 0..4 {
        press(&mut again, "ctrl+z");
    }
    assert!(again.document().keyframes.is_empty());
}

#[test]
fn a_journal_is_private_and_held_by_one() {
    let folder = tempfile::tempdir().unwrap();
    let within = folder.path().join("state/inbetween");
    let log = Log::create_in(&within, journal::ENDING).unwrap();
    let path = log.path().to_owned();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        let mode = |path: &Path| std::fs::metadata(path).unwrap().permissions().mode() & 0o777;
        assert_eq!((mode(&within), mode(&path)), (0o700, 0o600));
    }
    let mut kept = Kept { journal: Writer::begin(log, &editor()), editor: editor() };
    kept.apply(Command::Edit(Edit::CreateKeyframe));
    assert!(journal::left(&within).is_empty(), "a journal in use is not offered");
    assert!(LeftLog::open(&path).unwrap().is_none());
    drop(kept);
    let left = journal::left(&within);
    assert_eq!(left.len(), 1);
    assert!(journal::left(&within).is_empty(), "who looks at it holds it");
    left.into_iter().for_each(journal::Left::take_over);
    assert!(journal::left(&within).is_empty());
    assert!(path.is_file(), "what was taken over stays");
}

#[test]
fn printing_swiftly_is_printing() {
    let mut runner = TestRunner::deterministic();
    let strategy = any_step();
    let editor = editor_with(5);
    for _ in 0..5_000 {
        if let Step::Command(command) = strategy.new_tree(&mut runner).unwrap().current() {
            assert_eq!(script::print_swiftly(&command, editor.scene()), script::print(&command, editor.scene()));
        }
    }
}

#[test]
fn restoring_lines_read_back() {
    let editor = editor_with(3);
    let scene = std::sync::Arc::clone(editor.scene());
    let timed = scene.with_control_above(scene.rbt_node(RbtIndex::new(3))).unwrap().0;
    for restore in [
        script::Restore::Scene { scene: scene.clone(), path: None },
        script::Restore::Scene { scene: timed.into(), path: Some("a # \"b\".json".into()) },
        script::Restore::KeyframeFile("a # b\u{7}.json".into()),
        script::Restore::Imported { path: "x y".into(), bytes: b"# \"quoted\"\r\n\x01".as_slice().into() },
        script::Restore::Imported { path: "x".into(), bytes: b"\xff\x00#".as_slice().into() },
        script::Restore::ImportedScene { path: "x y".into(), bytes: b"{\"#\": \"\n\"}".as_slice().into() },
        script::Restore::ImportedScene { path: "x".into(), bytes: b"\xff".as_slice().into() },
        script::Restore::Snapshot(Box::new(editor.snapshot())),
        script::Restore::Document(Box::new(editor.snapshot())),
        script::Restore::Ground,
    ] {
        let line = restore.line().unwrap();
        let read = script::parse_line(1, format!("  {line}  # more\r").as_bytes(), &scene).unwrap().unwrap();
        assert_eq!(read.action, script::Action::Restore(restore));
        assert_eq!(read.text, line);
    }
}
