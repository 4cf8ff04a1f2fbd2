//! Commands as script lines: what is printed reads back to an equal command.

mod common;

use std::path::PathBuf;
use std::sync::{Arc, LazyLock};

use common::any_node_edit;
use glam::{Quat, Vec3};
use inbetween::colour::Colour;
use inbetween::editor::commands::{self, Changes};
use inbetween::editor::gizmo::{Axis, GizmoAxes, Handle, Pull, SnapSteps};
use inbetween::editor::{
    ClipboardCommand, Command, Edit, Eye, FileCommand, GestureCommand, KeyAt, Pivot, PlayMode, PlaybackCommand,
    SceneEdit, SelectionCommand, Side, TimelineEdit, ViewCommand, WorkEye,
};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{Blend, Easing, KeyframeIndex, Retiming, StretchEnd};
use inbetween::lighting::BuiltInLighting;
use inbetween::pose::RbtIndex;
use inbetween::pose_file::{PoseFile, PosedNode, shipped_pose, shipped_poses};
use inbetween::rbt::Rbt;
use inbetween::scene::{Channel, KeyValue, SceneGraph, scene_from_json};
use inbetween::script::{self, Action};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

/// How many random commands are written and read back.
const COMMANDS: u32 = 100_000;

/// A scene whose paths are as awkward as paths can be.
static SCENE: LazyLock<SceneGraph> = LazyLock::new(|| {
    let name = |name: &str| serde_json::to_string(name).unwrap();
    let nodes: Vec<String> = AWKWARD.iter().map(|text| format!(r#"{{"name": {}}}"#, name(text))).collect();
    let text = format!(
        r#"{{"format": "inbetween.scene", "version": 1, "name": "awkward", "eyes": [{}, {}], "nodes": [{}]}}"#,
        name(AWKWARD[0]),
        name(AWKWARD[4]),
        nodes.join(", ")
    );
    let mut scene = scene_from_json(&text).unwrap();
    for path in ["plain", "a b#1", "two  blanks"] {
        let id = scene.find(path).unwrap();
        scene = scene.with_control_above(id).unwrap().0;
    }
    scene
});

const AWKWARD: [&str; 16] = [
    "plain",
    "a b#1",
    "a b",
    "none",
    "# c # d",
    " outer blanks ",
    "two  blanks",
    "\"quoted\"",
    "back\\slash \"and\" quotes",
    "line\nbreak\tand tab",
    "걷기 🚶",
    "\u{feff}mark\u{2028}",
    "1",
    "all",
    "mirrored",
    "rotation of it",
];

fn any_f32() -> impl Strategy<Value = f32> {
    let edges =
        [0.0, -0.0, 1.0, -1.0, f32::MIN_POSITIVE, f32::from_bits(1), -f32::from_bits(1), f32::MAX, f32::MIN, 0.1];
    prop_oneof![
        1 => prop::sample::select(edges.to_vec()),
        1 => prop::num::f32::NORMAL | prop::num::f32::SUBNORMAL | prop::num::f32::ZERO,
        1 => -10.0f32..10.0,
    ]
}

fn any_f64() -> impl Strategy<Value = f64> {
    let edges =
        [0.0, -0.0, 1.0, 1e16, f64::MIN_POSITIVE, f64::from_bits(1), -f64::from_bits(1), f64::MAX, f64::MIN, 0.1];
    prop_oneof![
        1 => prop::sample::select(edges.to_vec()),
        1 => prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO,
        1 => -10.0f64..10.0,
    ]
}

fn any_vector() -> impl Strategy<Value = Vec3> {
    let axes = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::ZERO, -Vec3::ZERO, -Vec3::Y];
    prop_oneof![3 => prop::array::uniform3(any_f32()).prop_map(Vec3::from), 1 => prop::sample::select(axes.to_vec())]
}

fn any_rotation() -> impl Strategy<Value = Quat> {
    prop_oneof![3 => prop::array::uniform4(any_f32()).prop_map(Quat::from_array), 1 => Just(Quat::IDENTITY)]
}

fn any_rbt() -> impl Strategy<Value = Rbt> {
    (any_vector(), any_rotation()).prop_map(|(translation, rotation)| Rbt::new(translation, rotation))
}

fn any_text() -> impl Strategy<Value = String> {
    prop_oneof![
        1 => prop::sample::select(AWKWARD.to_vec()).prop_map(str::to_owned),
        1 => Just(String::new()),
        2 => ".{0,12}",
        2 => "[a-z \"#\\\\\n\r\t|\u{a0}]{0,8}",
    ]
}

fn any_file() -> impl Strategy<Value = PathBuf> {
    any_text().prop_map(PathBuf::from)
}

fn any_node() -> impl Strategy<Value = RbtIndex> {
    (0..SCENE.rbt_count()).prop_map(RbtIndex::new)
}

fn any_path() -> impl Strategy<Value = Arc<str>> {
    let paths: Vec<Arc<str>> = SCENE.nodes().iter().map(|node| node.path.as_str().into()).collect();
    prop::sample::select(paths)
}

fn any_index() -> impl Strategy<Value = usize> {
    prop_oneof![4 => 0usize..20, 1 => any::<usize>()]
}

fn any_keyframe() -> impl Strategy<Value = KeyframeIndex> {
    any_index().prop_map(KeyframeIndex::new)
}

fn any_key() -> impl Strategy<Value = KeyAt> {
    (any_path(), prop::sample::select(Channel::ALL.to_vec()), any_f64())
        .prop_map(|(path, channel, seconds)| KeyAt::new(&path, channel, seconds))
}

fn any_keys() -> impl Strategy<Value = Vec<KeyAt>> {
    prop::collection::vec(any_key(), 0..5)
}

fn any_value() -> impl Strategy<Value = KeyValue> {
    prop_oneof![
        any_vector().prop_map(KeyValue::Translation),
        any_rotation().prop_map(KeyValue::Rotation),
        any_vector().prop_map(KeyValue::Scale),
        any::<[u8; 3]>().prop_map(|bytes| KeyValue::Colour(Colour::from_bytes(bytes))),
    ]
}

fn any_edit() -> impl Strategy<Value = Command> {
    prop_oneof![
        any_keyframe().prop_map(Edit::GoTo),
        prop::sample::select(Interpolation::ALL.to_vec()).prop_map(Edit::SetInterpolation),
        any::<u32>().prop_map(Edit::SetMsBetweenKeyframes),
        (100u32..10_000).prop_map(Edit::SetMsBetweenKeyframes),
        (any_node(), any_vector()).prop_map(|(rbt, to)| Edit::SetTranslation(rbt, to)),
        (any_node(), any_rotation()).prop_map(|(rbt, to)| Edit::SetRotation(rbt, to)),
        (any_vector(), any_f64()).prop_map(|(axis_in_node, radians)| Edit::RotateChosen { axis_in_node, radians }),
        any_vector().prop_map(Edit::TranslateChosen),
        (any_node_edit(), prop::option::of(any_node())).prop_map(|(edit, node)| Edit::Nodes(edit, node)),
        any_rbt().prop_map(Edit::Wheel),
        (any_node(), any_vector()).prop_map(|(rbt, to)| Edit::Reach(rbt, to)),
        (any_node(), any_vector()).prop_map(|(rbt, by)| Edit::ReachBy(rbt, by)),
        (any_node(), any_f64()).prop_map(|(rbt, degrees)| Edit::TurnPole(rbt, degrees)),
        common::any_pull(any_f64().boxed()).prop_map(Edit::PullChosen),
    ]
    .prop_map(Command::Edit)
}

fn any_end() -> impl Strategy<Value = Option<StretchEnd>> {
    prop::sample::select(vec![None, Some(StretchEnd::Start), Some(StretchEnd::End)])
}

fn any_timeline_edit() -> impl Strategy<Value = Command> {
    prop_oneof![
        (any_keyframe(), any_text()).prop_map(|(keyframe, name)| TimelineEdit::RenameKeyframe(keyframe, name)),
        (any_keyframe(), any_f64(), any::<bool>()).prop_map(|(keyframe, duration, ripple_free)| {
            TimelineEdit::SetDuration { keyframe, duration, ripple_free }
        }),
        (any::<i32>(), any_end(), any::<bool>()).prop_map(|(by_ms, end, ripples)| {
            TimelineEdit::RetimeKeyframes(Retiming { by_ms: by_ms % 3_600_001, end, ripples })
        }),
        prop::sample::select(Easing::all().collect::<Vec<_>>()).prop_map(TimelineEdit::SetEasing),
        any_index().prop_map(TimelineEdit::MoveKeyframes),
        (any_keyframe(), any_node(), any_vector())
            .prop_map(|(keyframe, rbt, to)| TimelineEdit::SetTranslationInKeyframe(keyframe, rbt, to)),
        (any_keyframe(), any_node(), any_rotation())
            .prop_map(|(keyframe, rbt, to)| TimelineEdit::SetRotationInKeyframe(keyframe, rbt, to)),
    ]
    .prop_map(|edit| Command::Edit(Edit::Timeline(edit)))
}

fn any_scene_edit() -> impl Strategy<Value = Command> {
    prop_oneof![
        any_keys().prop_map(SceneEdit::AddKeys),
        (any_path(), any_f64(), any_value()).prop_map(|(node, seconds, value)| SceneEdit::SetKey {
            node,
            seconds,
            value
        }),
        (any_keys(), any_f64()).prop_map(|(keys, by)| SceneEdit::MoveKeys { keys, by }),
        any_keys().prop_map(SceneEdit::DeleteKeys),
        any_path().prop_map(SceneEdit::PutControlAbove),
        any_path().prop_map(SceneEdit::RemoveControl),
        (any_path(), any_text()).prop_map(|(path, name)| SceneEdit::RenameControl(path, name)),
        prop::sample::select(BuiltInLighting::ALL.to_vec()).prop_map(SceneEdit::SetLighting),
    ]
    .prop_map(|edit| Command::Edit(Edit::Scene(edit)))
}

fn any_playback() -> impl Strategy<Value = Command> {
    prop_oneof![
        any_f64().prop_map(PlaybackCommand::Scrub),
        any::<i32>().prop_map(PlaybackCommand::Step),
        (-3i32..4).prop_map(PlaybackCommand::Step),
        prop::sample::select(PlayMode::ALL.to_vec()).prop_map(PlaybackCommand::SetMode),
        prop::option::of((any_index(), any_index())).prop_map(PlaybackCommand::SetRange),
        any::<u32>().prop_map(PlaybackCommand::SetSpeedPercent),
    ]
    .prop_map(Command::Playback)
}

fn any_copy() -> impl Strategy<Value = Command> {
    prop::option::of(any_node()).prop_map(|node| Command::Clipboard(ClipboardCommand::CopyPose(node)))
}

fn any_view() -> impl Strategy<Value = Command> {
    prop_oneof![
        (0..SCENE.eyes().len()).prop_map(|eye| ViewCommand::SetEye(Eye::Recorded(eye))),
        Just(ViewCommand::SetEye(Eye::Work)),
        prop::sample::select(&Side::NAMES).prop_map(|(side, _)| ViewCommand::LookFrom(side)),
        prop::sample::select(&[
            ViewCommand::LevelEye,
            ViewCommand::ShowAll,
            ViewCommand::ShowChosen,
            ViewCommand::ResetWorkEye,
        ]),
        (-180f32..=180.0, -90f32..=90.0, 0.125f32..=1e5, prop::array::uniform3(-1e6f32..=1e6)).prop_map(
            |(yaw_degrees, pitch_degrees, distance, target)| {
                let target_in_world = Vec3::from(target);
                ViewCommand::SetWorkEye(WorkEye { yaw_degrees, pitch_degrees, distance, target_in_world })
            },
        ),
        prop::option::of(any_node()).prop_map(ViewCommand::Choose),
        prop::option::of(any_node()).prop_map(ViewCommand::LookFromNode),
        any_node().prop_map(ViewCommand::ChooseAlso),
        prop::sample::select(&[Pivot::Own, Pivot::Common]).prop_map(ViewCommand::SetPivot),
        any::<bool>().prop_map(ViewCommand::SetAutoKeys),
        any::<bool>().prop_map(ViewCommand::SetKeepFeet),
        any::<bool>().prop_map(ViewCommand::SetInset),
        any::<u8>().prop_map(ViewCommand::SetGhosts),
        any::<bool>().prop_map(ViewCommand::SetGhostsOfChosen),
        prop::sample::subsequence(Blend::ALL.to_vec(), 0..=Blend::ALL.len()).prop_map(ViewCommand::CompareBlends),
        any_f64().prop_map(ViewCommand::ScrubSeconds),
        prop::sample::select(&GizmoAxes::ALL).prop_map(ViewCommand::SetGizmoAxes),
        (any_f64(), any_f64()).prop_map(|(degrees, units)| ViewCommand::SetSnapSteps(SnapSteps { degrees, units })),
    ]
    .prop_map(Command::View)
}

fn any_selection() -> impl Strategy<Value = Command> {
    prop_oneof![
        prop::collection::vec(any_keyframe(), 0..8).prop_map(SelectionCommand::Keyframes),
        any_keys().prop_map(SelectionCommand::TimedKeys),
    ]
    .prop_map(Command::Selection)
}

fn any_file_command() -> impl Strategy<Value = Command> {
    prop_oneof![
        any_file().prop_map(FileCommand::Open),
        any_file().prop_map(FileCommand::CompareWith),
        any_file().prop_map(FileCommand::SaveAs),
        any_file().prop_map(FileCommand::SaveSceneAs),
        any_file().prop_map(FileCommand::ExportModel),
        (any_file(), any::<bool>())
            .prop_map(|(path, has_overlays)| FileCommand::Screenshot { path: Some(path), has_overlays }),
        any_text().prop_filter_map("it has no line", |name| named(name).map(FileCommand::ApplyPose)),
        any_text().prop_filter_map("it has no line", |name| named(name).map(FileCommand::SavePose)),
    ]
    .prop_map(Command::File)
}

/// A name that is neither blank nor that of a shipped pose.
fn named(name: String) -> Option<String> {
    (!name.is_empty() && shipped_pose(&name).is_none()).then_some(name)
}

fn any_pose() -> impl Strategy<Value = Command> {
    let own = (any_text(), any_rbt(), prop::option::of(any_text())).prop_filter_map("no name", |(path, rbt, root)| {
        let node = PosedNode { path, turned: rbt.rotation.normalize(), moved: rbt.translation };
        let is_read = (node.turned.length() - 1.0).abs() < 1e-6 && node.moved.abs().max_element() <= 1e6;
        is_read.then(|| PoseFile { name: "own".to_owned(), root, nodes: vec![node] })
    });
    prop_oneof![own, prop::sample::select(shipped_poses())].prop_map(|pose| Command::Edit(Edit::Pose(Arc::new(pose))))
}

fn screenshot(path: Option<&str>, has_overlays: bool) -> Command {
    Command::File(FileCommand::Screenshot { path: path.map(PathBuf::from), has_overlays })
}

fn any_gesture() -> impl Strategy<Value = Command> {
    prop_oneof![
        Just(GestureCommand::Begin),
        Just(GestureCommand::Commit),
        Just(GestureCommand::Abort),
        any_rbt().prop_map(GestureCommand::Move),
        (prop::collection::vec(any_rbt(), 1..3), any::<bool>())
            .prop_map(|(placed, is_turn)| GestureCommand::MoveTo { placed, is_turn }),
        common::any_hold(any_f64().boxed()),
    ]
    .prop_map(Command::Gesture)
}

/// Every command that can stand in a list: all without parameters, and some with.
fn any_bound() -> impl Strategy<Value = Command> {
    let bound = commands::rows().iter().flat_map(|row| &row.bindings).map(|binding| binding.command.clone());
    prop::sample::select(bound.collect::<Vec<_>>())
}

fn any_command() -> impl Strategy<Value = Command> {
    prop_oneof![
        3 => any_edit(),
        2 => any_timeline_edit(),
        3 => any_scene_edit(),
        2 => any_playback(),
        2 => any_view(),
        1 => any_copy(),
        1 => any_pose(),
        1 => any_selection(),
        1 => any_file_command(),
        1 => any_gesture(),
        1 => any_bound(),
    ]
}

#[track_caller]
fn check(command: &Command) -> String {
    let text = script::print(command, &SCENE).unwrap_or_else(|| panic!("{command:?} has no line"));
    let commented = format!("# before\n  {text}  # after it\r\n");
    let lines = script::parse(commented.as_bytes(), &SCENE).unwrap_or_else(|problems| panic!("{text}: {problems:?}"));
    let [line] = lines.as_slice() else { panic!("{text}: {lines:?}") };
    let Action::Apply(read) = &line.action else { panic!("{text}: {line:?}") };
    // What is shown of two numbers differs if their bits do.
    assert!(read == command && format!("{read:?}") == format!("{command:?}"), "{text}: {read:?} is not {command:?}");
    assert_eq!(line.text, text);
    text
}

#[test]
fn random_commands_are_written_and_read_back() {
    let config = ProptestConfig { cases: COMMANDS, failure_persistence: None, ..ProptestConfig::default() };
    let outcome = TestRunner::new(config).run(&any_command(), |command| {
        check(&command);
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn random_commands_are_of_one_row_each() {
    let config = ProptestConfig { cases: 5_000, failure_persistence: None, ..ProptestConfig::default() };
    let outcome = TestRunner::new(config).run(&any_command(), |command| {
        prop_assert_eq!(commands::rows().iter().filter(|row| row.owns(&command)).count(), 1);
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

/// So that the test above leaves out no command that changes the document or the session.
#[test]
fn random_commands_are_of_every_row_that_a_script_can_have() {
    let mut runner = TestRunner::deterministic();
    let strategy = any_command();
    let mut seen = std::collections::BTreeSet::new();
    for _ in 0..20_000 {
        let command = proptest::strategy::ValueTree::current(&strategy.new_tree(&mut runner).unwrap());
        seen.insert(commands::row_of(&command).id);
    }
    let has_line =
        |row: &&commands::Row| !row.lines.is_empty() || matches!(row.changes, Changes::Document | Changes::Session);
    for row in commands::rows().iter().filter(has_line) {
        assert!(seen.contains(row.id), "no random command is of the row {}", row.id);
    }
}

#[test]
fn lines_are_as_people_write_them_where_that_is_exact() {
    let edit = Command::Edit;
    let timeline = |change| edit(Edit::Timeline(change));
    let key = |path: &str, seconds| KeyAt::new(path, Channel::Scale, seconds);
    let turn = Pull::Turn { axis: Axis::X, degrees: 45.0, axes: GizmoAxes::Local };
    let shift = Pull::Move { by: [0.0, 0.25, -1.0], axes: GizmoAxes::World };
    for (command, line) in [
        (edit(Edit::CreateKeyframe), "do keyframe-new"),
        (timeline(TimelineEdit::CutKeyframes), "cut"),
        (Command::Undo, "undo"),
        (edit(Edit::RotateChosen { axis_in_node: Vec3::Z, radians: 45f64.to_radians() }), "rotate z 45"),
        (edit(Edit::RotateChosen { axis_in_node: Vec3::ONE, radians: 0.5 }), "rotate-by 1 1 1 0.5"),
        (edit(Edit::TranslateChosen(Vec3::new(-0.0, 1e-45, 0.1))), "translate -0 1e-45 0.1"),
        (edit(Edit::SetMsBetweenKeyframes(700)), "ms 700"),
        (edit(Edit::SetMsBetweenKeyframes(7)), "clamped ms 7"),
        (edit(Edit::Wheel(Rbt::from_translation(Vec3::new(0.0, 0.0, -0.5)))), "wheel 0.5"),
        (edit(Edit::Wheel(Rbt::from_translation(Vec3::X))), "wheel-by 1 0 0 0 0 0 1"),
        (Command::Gesture(GestureCommand::Move(Rbt::from_translation(Vec3::X))), "drag move 1 0 0"),
        (Command::Gesture(GestureCommand::Commit), "drag end"),
        (edit(Edit::PullChosen(turn)), "turn x 45 local"),
        (edit(Edit::PullChosen(shift)), "shift 0 0.25 -1 world"),
        (Command::Gesture(GestureCommand::Pull(turn)), "drag-pull turn x 45 local"),
        (Command::Gesture(GestureCommand::Grab(Handle::TURN_IN_VIEW)), "drag-grab turn z view"),
        (Command::Gesture(GestureCommand::Lock(Axis::Y)), "drag-lock y"),
        (Command::Gesture(GestureCommand::Type('.')), "drag-type ."),
        (Command::Gesture(GestureCommand::Erase), "drag-type erase"),
        (Command::View(ViewCommand::SetSnapSteps(SnapSteps { degrees: 5.0, units: 0.1 })), "snap 5 0.1"),
        (Command::View(ViewCommand::SetSnapSteps(SnapSteps { degrees: 0.0, units: 0.1 })), "clamped snap 0 0.1"),
        (Command::Playback(PlaybackCommand::Step(-1)), "step -1"),
        (Command::View(ViewCommand::Choose(None)), "select none"),
        (Command::View(ViewCommand::Choose(Some(RbtIndex::new(3)))), "select \"none\""),
        (Command::View(ViewCommand::ChooseAlso(RbtIndex::new(3))), "select-also \"none\""),
        (
            Command::Selection(SelectionCommand::Keyframes([1, 2, 3, 7, 5].map(KeyframeIndex::new).to_vec())),
            "select-keyframes 1-3 7 5",
        ),
        (timeline(TimelineEdit::RenameKeyframe(KeyframeIndex::new(2), "the #1".to_owned())), "rename 2 \"the #1\""),
        (Command::File(FileCommand::Open(PathBuf::from("my walk.json"))), "open my walk.json"),
        (Command::File(FileCommand::SaveAs(PathBuf::from("a#b"))), "save-as \"a#b\""),
        (screenshot(None, true), "do screenshot"),
        (screenshot(Some("a b.png"), false), "screenshot a b.png"),
        (screenshot(Some("a#b"), true), "screenshot --overlays \"a#b\""),
        (screenshot(Some("--overlays"), false), "screenshot \"--overlays\""),
        (screenshot(Some("--overlays a"), true), "screenshot --overlays --overlays a"),
        (Command::Selection(SelectionCommand::TimedKeys(vec![])), "select-keys none"),
        (
            Command::Selection(SelectionCommand::TimedKeys(vec![key("plain_control", 1.5), key("a b", 2.0)])),
            "select-keys scale 1.5 plain_control scale 2 \"a b\"",
        ),
        (edit(Edit::Scene(SceneEdit::AddKeys(vec![key("a b", 1.5)]))), "add-key scale 1.5 a b"),
        (
            edit(Edit::Scene(SceneEdit::MoveKeys { keys: vec![key("plain_control", 1.5)], by: -0.25 })),
            "move-keys -0.25 scale 1.5 plain_control",
        ),
    ] {
        assert_eq!(check(&command), line);
    }
}

#[test]
fn what_the_editor_always_refuses_has_no_line() {
    for command in [
        Command::Edit(Edit::SetTranslation(RbtIndex::new(2), Vec3::NAN)),
        Command::Edit(Edit::SetTranslation(RbtIndex::new(99), Vec3::ZERO)),
        Command::Edit(Edit::Wheel(Rbt::from_translation(Vec3::INFINITY))),
        Command::View(ViewCommand::Choose(Some(RbtIndex::new(usize::MAX)))),
        Command::View(ViewCommand::ChooseAlso(RbtIndex::new(usize::MAX))),
        Command::View(ViewCommand::SetEye(Eye::Recorded(9))),
        Command::View(ViewCommand::ScrubSeconds(f64::NAN)),
        Command::Edit(Edit::Scene(SceneEdit::RemoveControl("nowhere".into()))),
    ] {
        assert_eq!(script::print(&command, &SCENE), None, "{command:?}");
    }
}

#[test]
fn commands_are_done_by_id_or_by_english_name_in_any_case() {
    for row in commands::rows() {
        for binding in &row.bindings {
            for name in
                [binding.id.to_owned(), binding.title().english().to_owned(), binding.title().english().to_uppercase()]
            {
                let lines = script::parse(format!("do {name}").as_bytes(), &SCENE);
                assert_eq!(lines.unwrap()[0].action, Action::Apply(binding.command.clone()), "{name}");
            }
        }
    }
}
