//! Random commands: the editor's invariants hold after each, and undo leads back.

mod common;

use std::path::Path;
use std::sync::{Arc, LazyLock};

use common::{any_node_edit, any_rbt_index, apply, editor, press};
use glam::{Quat, Vec3};
use inbetween::editor::{
    ClipboardCommand, Command, Edit, Editor, Eye, GestureCommand, KeyAt, Pivot, PlaybackCommand, SceneEdit,
    SelectionCommand, TimelineEdit, ViewCommand, WorkEye, Written,
};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{Easing, KeyframeIndex, Retiming, StretchEnd, keyframes_to_json};
use inbetween::lighting::BuiltInLighting;
use inbetween::pose::RbtIndex;
use inbetween::pose_file::shipped_poses;
use inbetween::rbt::Rbt;
use inbetween::scene::{Channel, KeyValue, scene_to_json};
use proptest::prelude::*;

/// What imports read.
static OTHERS: LazyLock<Vec<Vec<u8>>> = LazyLock::new(common::other_files);

#[derive(Clone, Debug)]
enum Step {
    Command(Command),
    Tick(u64),
    /// Reads one of [`OTHERS`].
    Import(usize),
    Save,
    Write,
}

fn any_rbt() -> impl Strategy<Value = Rbt> {
    (prop::array::uniform3(-3.0f32..3.0), prop::array::uniform3(-2.0f32..2.0))
        .prop_map(|(t, r)| Rbt::new(Vec3::from(t), Quat::from_scaled_axis(Vec3::from(r))))
}

fn any_edit() -> impl Strategy<Value = Command> {
    prop_oneof![
        Just(Edit::DisplayCurrent),
        Just(Edit::UpdateCurrent),
        Just(Edit::CreateKeyframe),
        Just(Edit::CreateKeyframe),
        Just(Edit::GoToNext),
        Just(Edit::GoToPrevious),
        (0usize..8).prop_map(|place| Edit::GoTo(KeyframeIndex::new(place))),
        Just(Edit::DeleteCurrent),
        Just(Edit::ResetPose),
        Just(Edit::BeginAnew),
        Just(Edit::NextInterpolation),
        Just(Edit::SetInterpolation(Interpolation::Linear)),
        Just(Edit::Faster),
        Just(Edit::Slower),
        (0u32..20_000).prop_map(Edit::SetMsBetweenKeyframes),
        (0usize..24, any_rbt()).prop_map(|(rbt, to)| Edit::SetTranslation(RbtIndex::new(rbt), to.translation)),
        (0usize..24, any_rbt()).prop_map(|(rbt, to)| Edit::SetRotation(RbtIndex::new(rbt), to.rotation)),
        Just(Edit::SetTranslation(RbtIndex::new(2), Vec3::NAN)),
        prop::sample::select(&[1e6_f32, -1e6, 1.1e6, 3e38])
            .prop_map(|x| Edit::SetTranslation(RbtIndex::new(2), Vec3::X * x)),
        prop::sample::select(&[2e6_f32, 3e38]).prop_map(|x| Edit::TranslateChosen(Vec3::Y * x)),
        Just(Edit::SetRotation(RbtIndex::new(2), Quat::from_xyzw(0.0, 0.0, 0.0, 0.0))),
        any_rbt().prop_map(|by| Edit::TranslateChosen(by.translation)),
        (-9.0f64..9.0).prop_map(|radians| Edit::RotateChosen { axis_in_node: Vec3::Y, radians }),
        any_rbt().prop_map(Edit::Wheel),
        common::any_pull(amount()).prop_map(Edit::PullChosen),
    ]
    .prop_map(Command::Edit)
}

/// Degrees or units, some of them further than coordinates go.
fn amount() -> BoxedStrategy<f64> {
    prop_oneof![6 => -400.0f64..400.0, 1 => prop::sample::select(&[0.0, 180.0, 1e6, -1e300])].boxed()
}

/// Edits of the list by its selection or by indices, which it has or not.
fn any_timeline_edit() -> impl Strategy<Value = Command> {
    let place = || (0usize..8).prop_map(KeyframeIndex::new);
    prop_oneof![
        1 => Just(TimelineEdit::CutKeyframes),
        2 => Just(TimelineEdit::PasteKeyframes),
        2 => Just(TimelineEdit::DuplicateKeyframes),
        1 => Just(TimelineEdit::DeleteKeyframes),
        1 => Just(TimelineEdit::ReverseKeyframes),
        1 => (0usize..9).prop_map(TimelineEdit::MoveKeyframes),
        1 => prop::sample::select(&["linear", "hold", "sine-in"])
            .prop_map(|name| TimelineEdit::SetEasing(Easing::from_name(name).unwrap())),
        2 => (-5000i32..5000, 0u8..3, any::<bool>()).prop_map(|(by_ms, end, ripples)| {
            let end = [None, Some(StretchEnd::Start), Some(StretchEnd::End)][usize::from(end)];
            TimelineEdit::RetimeKeyframes(Retiming { by_ms, end, ripples })
        }),
        1 => (place(), "[a-z #\"\u{1}가]{0,6}").prop_map(|(at, name)| TimelineEdit::RenameKeyframe(at, name)),
        1 => (place(), 0.0f64..1100.0, any::<bool>()).prop_map(|(keyframe, duration, ripple_free)| {
            TimelineEdit::SetDuration { keyframe, duration, ripple_free }
        }),
        1 => (place(), 0usize..24, any_rbt())
            .prop_map(|(at, rbt, to)| TimelineEdit::SetTranslationInKeyframe(at, RbtIndex::new(rbt), to.translation)),
    ]
    .prop_map(|edit| Command::Edit(Edit::Timeline(edit)))
}

fn key(place: u8) -> KeyAt {
    KeyAt::new("robot1_control", Channel::Translation, f64::from(place) * 0.5)
}

/// Edits of a control node above robot 1, which is there or not.
fn any_scene_edit() -> impl Strategy<Value = Command> {
    prop_oneof![
        3 => Just(SceneEdit::PutControlAbove("robot1".into())),
        1 => Just(SceneEdit::PutControlAboveChosen),
        1 => Just(SceneEdit::RemoveControl("robot1_control".into())),
        1 => Just(SceneEdit::RenameControl("robot1_control2".into(), "spin".to_owned())),
        4 => (0u8..8).prop_map(|place| SceneEdit::AddKeys(vec![key(place)])),
        4 => (0u8..8, any_rbt()).prop_map(|(place, rbt)| SceneEdit::SetKey {
            node: "robot1_control".into(),
            seconds: f64::from(place) * 0.5,
            value: KeyValue::Translation(rbt.translation),
        }),
        3 => (0u8..8, -3i8..4).prop_map(|(place, by)| {
            SceneEdit::MoveKeys { keys: vec![key(place)], by: f64::from(by) * 0.5 }
        }),
        1 => (0u8..8).prop_map(|place| SceneEdit::DeleteKeys(vec![key(place)])),
        1 => Just(SceneEdit::SetLighting(BuiltInLighting::Evening)),
    ]
    .prop_map(|edit| Command::Edit(Edit::Scene(edit)))
}

fn any_step() -> impl Strategy<Value = Step> {
    let command = prop_oneof![
        12 => any_edit(),
        5 => any_scene_edit(),
        5 => any_timeline_edit(),
        3 => prop::collection::btree_set(0usize..8, 0..4).prop_map(|indices| {
            Command::Selection(SelectionCommand::Keyframes(indices.into_iter().map(KeyframeIndex::new).collect()))
        }),
        1 => (0u8..8).prop_map(|place| Command::Selection(SelectionCommand::TimedKeys(vec![key(place)]))),
        2 => Just(Command::Clipboard(ClipboardCommand::CopyKeyframes)),
        1 => prop::option::of(any_rbt_index()).prop_map(|node| Command::Clipboard(ClipboardCommand::CopyPose(node))),
        1 => prop::sample::select(shipped_poses()).prop_map(|pose| Command::Edit(Edit::Pose(Arc::new(pose)))),
        2 => (any_node_edit(), prop::option::of(any_rbt_index())).prop_map(|(edit, node)| Command::Edit(Edit::Nodes(edit, node))),
        1 => (0usize..6, 0usize..8).prop_map(|range| Command::Playback(PlaybackCommand::SetRange(Some(range)))),
        1 => (0.0f64..6.0).prop_map(|key_time| Command::Playback(PlaybackCommand::Scrub(key_time))),
        1 => (0.0f64..5.0).prop_map(|seconds| Command::View(ViewCommand::ScrubSeconds(seconds))),
        2 => Just(Command::Playback(PlaybackCommand::PlayOrStop)),
        1 => Just(Command::Playback(PlaybackCommand::PauseOrResume)),
        1 => Just(Command::View(ViewCommand::NextEye)),
        1 => Just(Command::View(ViewCommand::SetEye(Eye::Work))),
        1 => (-200f32..200.0).prop_map(|yaw_degrees| {
            Command::View(ViewCommand::SetWorkEye(WorkEye { yaw_degrees, ..WorkEye::default() }))
        }),
        1 => Just(Command::View(ViewCommand::ToggleSkyMode)),
        1 => Just(Command::View(ViewCommand::StartPicking)),
        2 => prop::option::of(0usize..24).prop_map(|rbt| Command::View(ViewCommand::Choose(rbt.map(RbtIndex::new)))),
        1 => prop::sample::select(&[Pivot::Own, Pivot::Common]).prop_map(|pivot| Command::View(ViewCommand::SetPivot(pivot))),
        2 => (0usize..24).prop_map(|rbt| Command::View(ViewCommand::ChooseAlso(RbtIndex::new(rbt)))),
        2 => Just(Command::Gesture(GestureCommand::Begin)),
        3 => any_rbt().prop_map(|motion| Command::Gesture(GestureCommand::Move(motion))),
        4 => common::any_hold(amount()).prop_map(Command::Gesture),
        1 => Just(Command::Gesture(GestureCommand::Commit)),
        1 => Just(Command::Gesture(GestureCommand::Abort)),
        4 => Just(Command::Undo),
        2 => Just(Command::Redo),
        1 => Just(Command::Cancel),
    ];
    prop_oneof![
        30 => command.prop_map(Step::Command),
        4 => (0u64..400).prop_map(Step::Tick),
        2 => (0..OTHERS.len()).prop_map(Step::Import),
        1 => Just(Step::Save),
        1 => Just(Step::Write),
    ]
}

fn run(editor: &mut Editor, step: Step) {
    match step {
        Step::Command(command) => drop(apply(editor, command)),
        Step::Tick(ticks) => {
            editor.tick(ticks);
            common::assert_invariants(editor, "ticks");
        }
        Step::Import(count) => {
            let _ = editor.keyframes_read(Path::new("other.json"), Ok(OTHERS[count].clone()));
            common::assert_invariants(editor, "import");
        }
        Step::Save => common::assert_reads_back(editor),
        Step::Write => {
            let _ = editor.keyframes_written(Path::new("other.json"), Ok(Written::default()));
        }
    }
}

fn text_of(editor: &Editor) -> String {
    let document = editor.document();
    keyframes_to_json(editor.scene(), &document.keyframes, document.interpolation, document.ms_between_keyframes)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: (common::random_commands() / 200) as u32, max_shrink_iters: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    /// Runs of 200 commands. At the end everything is undone, which leaves an empty list, and redone.
    #[test]
    fn random_commands_keep_invariants_and_undo_leads_back(steps in prop::collection::vec(any_step(), 200)) {
        let mut editor = editor();
        for step in steps {
            run(&mut editor, step);
        }
        apply(&mut editor, Command::Gesture(GestureCommand::Commit));
        if editor.is_playing() {
            press(&mut editor, "y");
        }
        while editor.redo_label().is_some() {
            press(&mut editor, "ctrl+shift+z");
        }
        let end = text_of(&editor);
        let end_scene = scene_to_json(editor.scene());
        let mut undone = 0;
        while editor.undo_label().is_some() {
            press(&mut editor, "ctrl+z");
            undone += 1;
            prop_assert!(undone <= 2000);
        }
        prop_assert!(editor.document().keyframes.is_empty());
        prop_assert!(!editor.has_unsaved_scene(), "undoing all leads back to the scene");
        prop_assert_eq!(editor.document().ms_between_keyframes, 2000);
        while editor.redo_label().is_some() {
            press(&mut editor, "ctrl+shift+z");
        }
        prop_assert!(text_of(&editor) == end, "redoing all does not lead back to the end");
        prop_assert!(scene_to_json(editor.scene()) == end_scene);
    }
}

#[test]
fn at_least_a_thousand_steps_can_be_undone() {
    let mut editor = editor();
    for place in 0..1500 {
        common::pose(&mut editor, place as f32);
    }
    for _ in 0..1500 {
        press(&mut editor, "ctrl+z");
    }
    assert_eq!(common::shown(&editor), " | -2");
}
