//! Several chosen nodes: what turns and moves with which, and that one step of undo takes it back.

mod common;

use common::{apply, editor};
use glam::{Quat, Vec2, Vec3};
use inbetween::editor::{Command, DragKind, Edit, Editor, GestureCommand};
use inbetween::pose::{Pose, RbtIndex};
use inbetween::rbt::Rbt;
use inbetween::script::{print, script_commands};
use inbetween::words::Phrase;

const SIZE_PX: Vec2 = Vec2::new(640.0, 480.0);
const ARM: &str = "select robot1/right_shoulder\nselect-also robot1/right_shoulder/right_elbow\n";
const SHOULDERS: &str = "select robot1/right_shoulder\nselect-also robot1/left_shoulder\n";

fn run(editor: &mut Editor, script: &str) {
    for command in script_commands(script.as_bytes(), editor.scene()).unwrap() {
        apply(editor, command);
    }
}

fn node(editor: &Editor, path: &str) -> RbtIndex {
    editor.scene().find_rbt(path).unwrap()
}

fn live(editor: &Editor, path: &str) -> Rbt {
    editor.document().live_pose.get(node(editor, path))
}

fn world(editor: &Editor, path: &str) -> Rbt {
    editor.scene().world_from_rbt(&editor.document().live_pose, 0.0, node(editor, path))
}

/// The paths of the nodes whose places differ from those at rest.
fn changed(editor: &Editor) -> Vec<&str> {
    let scene = editor.scene();
    let differs = |&rbt: &RbtIndex| editor.document().live_pose.get(rbt) != scene.rest_pose().get(rbt);
    scene.rbt_indices().filter(differs).map(|rbt| scene.rbt_path(rbt)).collect()
}

/// Runs lines from the rest pose: these nodes change, this is what undo calls it, and it takes all of it back.
#[track_caller]
fn check(script: &str, nodes: &[&str], label: &str) -> Editor {
    let mut after = editor();
    run(&mut after, script);
    assert_eq!(changed(&after), nodes, "{script}");
    assert_eq!(after.undo_label().map(Phrase::english), Some(label), "{script}");
    let chosen = after.session().chosen.clone();
    let mut undone = after.clone();
    apply(&mut undone, Command::Undo);
    assert_eq!(changed(&undone), [""; 0], "{script}");
    assert_eq!(undone.session().chosen, chosen, "undo leaves the choice alone");
    after
}

#[test]
fn a_turn_turns_each_about_its_own_origin() {
    let arm = ["robot1/right_shoulder", "robot1/right_shoulder/right_elbow"];
    let after = check(&format!("{ARM}rotate z 30"), &arm, "turn nodes");
    let thirty = Quat::from_rotation_z(30f32.to_radians());
    for path in arm {
        assert!(live(&after, path).rotation.dot(thirty) > 1.0 - 1e-6, "{path}");
    }
    // Both turned: the chain curls.
    assert!(world(&after, arm[1]).rotation.dot(thirty * thirty) > 1.0 - 1e-6);
}

#[test]
fn about_the_common_centre_the_topmost_of_a_chain_turns() {
    let arm = ["robot1/right_shoulder"];
    let after = check(&format!("pivot common\n{ARM}rotate z 30"), &arm, "turn a node");
    let alone = check("select robot1/right_shoulder\nrotate z 30", &arm, "turn a node");
    assert_eq!(after.document().live_pose, alone.document().live_pose);
}

#[test]
fn several_turn_about_their_common_centre_as_one_body() {
    let shoulders = ["robot1/right_shoulder", "robot1/left_shoulder"];
    let after = check(&format!("pivot common\n{SHOULDERS}rotate z 90"), &shoulders, "turn nodes");
    // They stand half a unit right and left of the centre, and then above and below it.
    assert!(live(&after, shoulders[0]).translation.distance(Vec3::new(0.0, 1.25, 0.0)) < 1e-5);
    assert!(live(&after, shoulders[1]).translation.distance(Vec3::new(0.0, 0.25, 0.0)) < 1e-5);
}

#[test]
fn a_move_moves_the_topmost_of_a_chain_alone() {
    check(&format!("{ARM}translate 0 0.5 0"), &["robot1/right_shoulder"], "move a node");
    check(&format!("{SHOULDERS}translate 0 0.5 0"), &["robot1/right_shoulder", "robot1/left_shoulder"], "move nodes");
    check("select robot1/head\nselect-also robot1\nwheel 1", &["robot1"], "move along the view");
}

/// A drag with the pointer, in so many parts.
fn drag(editor: &mut Editor, kind: DragKind, by_px: Vec2) {
    let from_px = SIZE_PX / 2.0;
    for part in 0..4u8 {
        let at = |part: u8| from_px + by_px * (f32::from(part) / 4.0);
        let motion = editor.manipulation(&editor.camera(SIZE_PX)).motion(kind, at(part), at(part + 1));
        apply(editor, Command::Gesture(GestureCommand::Move(motion)));
    }
}

/// Where a drag has led is written as one line, which leads there again to the bit.
#[track_caller]
fn check_line(script: &str, kinds: &[DragKind]) -> Editor {
    let mut dragged = editor();
    run(&mut dragged, script);
    apply(&mut dragged, Command::Gesture(GestureCommand::Begin));
    let mut again = dragged.clone();
    for &kind in kinds {
        drag(&mut dragged, kind, Vec2::new(60.0, -40.0));
    }
    let line = print(&Command::Gesture(dragged.drag_so_far().unwrap()), dragged.scene()).unwrap();
    run(&mut again, &line);
    for editor in [&mut dragged, &mut again] {
        apply(editor, Command::Gesture(GestureCommand::Commit));
    }
    let bits = |pose: &Pose| -> Vec<u32> {
        let numbers = |rbt: Rbt| [rbt.translation.to_array().to_vec(), rbt.rotation.to_array().to_vec()].concat();
        pose.iter().flat_map(numbers).map(f32::to_bits).collect()
    };
    assert_eq!(bits(&again.document().live_pose), bits(&dragged.document().live_pose), "{script}");
    assert_eq!(again.undo_label(), dragged.undo_label(), "{script}");
    dragged
}

#[test]
fn a_drag_moves_all_and_is_one_line_of_a_journal() {
    check_line("select none", &[DragKind::Rotate]);
    check_line("select robot1/head", &[DragKind::Rotate]);
    let turned = check_line(SHOULDERS, &[DragKind::Rotate]);
    assert_eq!(changed(&turned), ["robot1/right_shoulder", "robot1/left_shoulder"]);
    // What a turn did to the elbow stays in the line when the move after it moves the shoulder alone.
    let both = check_line(ARM, &[DragKind::Rotate, DragKind::Translate]);
    assert_eq!(changed(&both), ["robot1/right_shoulder", "robot1/right_shoulder/right_elbow"]);
    check_line(&format!("pivot common\n{SHOULDERS}"), &[DragKind::Rotate, DragKind::Dolly]);
}

#[test]
fn the_arcball_lies_about_the_common_centre() {
    let mut editor = editor();
    run(&mut editor, SHOULDERS);
    let centre = |editor: &Editor| editor.manipulation(&editor.camera(SIZE_PX)).arcball_in_world.unwrap().0;
    assert_eq!(centre(&editor), world(&editor, "robot1/left_shoulder").translation);
    run(&mut editor, "pivot common");
    assert!(centre(&editor).distance(Vec3::new(-2.0, 1.75, 0.0)) < 1e-6);
}

#[test]
fn places_for_another_number_of_nodes_are_refused() {
    let mut editor = editor();
    run(&mut editor, SHOULDERS);
    apply(&mut editor, Command::Gesture(GestureCommand::Begin));
    let placed = vec![Rbt::IDENTITY];
    let refused = editor.apply(Command::Gesture(GestureCommand::MoveTo { placed, is_turn: true })).unwrap_err();
    assert_eq!(refused.message().to_string(), "That is not a place for each chosen node: nothing was changed.");
    assert!(editor.apply(Command::Edit(Edit::TranslateChosen(Vec3::X * 2e6))).is_err());
    assert_eq!(changed(&editor), [""; 0], "one that cannot move keeps all where they are");
}
