//! Comparisons: what is a ghost where a sample is shown, the legend over the scene, and the animation of another file.

mod common;

use std::fmt::Write as _;
use std::path::Path;

use common::{apply, editor, editor_with};
use egui::{Role, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use glam::{DQuat, Vec2, Vec3};
use inbetween::animation_diff::distances;
use inbetween::editor::{Command, Edit, Editor, Effect, FileCommand, PlaybackCommand, ViewCommand};
use inbetween::frame::Ghost;
use inbetween::keyframe::{Blend, KeyframeIndex, keyframes_to_json};
use inbetween::script::script_commands;
use inbetween::ui::{Panels, theme};
use inbetween::view::{blend_off, compared_off, frame_of_editor};

/// Runs lines of a script, which are commands.
fn run(editor: &mut Editor, script: &str) {
    for command in script_commands(script.as_bytes(), editor.scene()).expect("it is a script") {
        apply(editor, command);
    }
}

/// Keyframes between which robot 1's right shoulder turns by 0, 80, 160 and 0 degrees, so that blends differ.
fn turning() -> Editor {
    let mut editor = editor();
    for degrees in [0, 0, 80, 160, 0, 0] {
        run(&mut editor, &format!("key r\nselect robot1/right_shoulder\nrotate z {degrees}\nkey n"));
    }
    run(&mut editor, "select none");
    editor
}

fn ghosts(editor: &Editor) -> Vec<Ghost> {
    frame_of_editor(editor, Vec2::new(64.0, 48.0)).ghosts
}

fn tints(editor: &Editor) -> usize {
    let mut tints: Vec<[u32; 3]> =
        ghosts(editor).iter().map(|ghost| ghost.item.colour.to_array().map(f32::to_bits)).collect();
    tints.sort_unstable();
    tints.dedup();
    tints.len()
}

#[test]
fn interpolations_are_compared_wherever_a_sample_is_shown() {
    let mut editor = turning();
    run(&mut editor, "compare-interpolations all");
    assert_eq!(ghosts(&editor), [], "a keyframe is no sample");
    run(&mut editor, "scrub 1.3");
    assert_eq!(tints(&editor), 3, "scrubbed");
    run(&mut editor, "key y");
    editor.tick(150);
    assert_eq!(tints(&editor), 3, "playing");
    run(&mut editor, "key shift+p");
    assert!(editor.is_paused());
    assert_eq!(tints(&editor), 3, "paused");
    run(&mut editor, "compare-interpolations none");
    assert_eq!(ghosts(&editor), []);
}

#[test]
fn what_is_compared_can_be_chosen() {
    let mut editor = turning();
    run(&mut editor, "compare-interpolations matrix nlerp\nscrub 1.3");
    assert_eq!(editor.session().compared_blends, [Blend::Nlerp, Blend::Matrices]);
    assert_eq!(tints(&editor), 2);
    run(&mut editor, "compare-interpolations linear");
    assert_eq!(ghosts(&editor), [], "it is what plays");
    run(&mut editor, "do interpolations-compare\ndo interpolations-compare");
    assert_eq!(editor.session().compared_blends, Blend::ALL);
}

#[test]
fn only_the_chosen_robot_is_compared() {
    let mut editor = turning();
    run(&mut editor, "compare-interpolations all\nscrub 1.3\nselect robot2/head");
    assert_eq!(ghosts(&editor), [], "robot 2 stands still");
    run(&mut editor, "select robot1/head");
    assert_eq!(tints(&editor), 3);
}

#[test]
fn angles_are_those_of_the_chosen_node_or_the_largest() {
    let mut editor = turning();
    assert_eq!(blend_off(&editor, Blend::Nlerp), None);
    run(&mut editor, "scrub 1.25");
    let shoulder = editor.scene().find_rbt("robot1/right_shoulder").unwrap();
    // Between 80 and 160 degrees, a quarter of the way: 100 degrees by slerp. Nlerp: the angle of 3/4 q(80°) + 1/4 q(160°), halved.
    let (a, b) = (40_f64.to_radians(), 80_f64.to_radians());
    let half = (0.75 * a.sin() + 0.25 * b.sin()).atan2(0.75 * a.cos() + 0.25 * b.cos());
    let expected = (100.0 - 2.0 * half.to_degrees()).abs();
    let (degrees, rbt) = blend_off(&editor, Blend::Nlerp).unwrap();
    assert_eq!(rbt, shoulder);
    assert!((degrees - expected).abs() < 1e-3 && expected > 0.5, "{degrees} and {expected}");
    run(&mut editor, "select robot1/head");
    let (degrees, rbt) = blend_off(&editor, Blend::Nlerp).unwrap();
    assert!(degrees < 1e-3 && rbt != shoulder);
}

fn text(editor: &Editor) -> Vec<u8> {
    let document = editor.document();
    let text =
        keyframes_to_json(editor.scene(), &document.keyframes, document.interpolation, document.ms_between_keyframes);
    text.into_bytes()
}

/// Has the editor compare with what a file holds.
fn compare_with(editor: &mut Editor, bytes: Vec<u8>) {
    let effects = apply(editor, Command::File(FileCommand::CompareWith("teacher.json".into())));
    assert_eq!(effects, [Effect::ReadCompared { path: "teacher.json".into() }]);
    let _ = editor.compared_read(Path::new("teacher.json"), Ok(bytes));
}

#[test]
fn another_animation_is_a_ghost_with_the_largest_differences() {
    let mut editor = editor_with(6);
    let same = text(&editor);
    let head = editor.scene().find_rbt("robot2/head").unwrap();
    // The teacher's robot 1 stands half a unit higher, robot 2's head is turned; it plays at half the pace.
    let mut teacher = editor_with(6);
    let robot = teacher.scene().find_rbt("robot1").unwrap();
    let turn = glam::Quat::from_rotation_y(0.5);
    for index in 0..6 {
        let at = |edit| Command::Edit(Edit::Timeline(edit));
        let keyframe = KeyframeIndex::new(index);
        let x = index as f32;
        apply(
            &mut teacher,
            at(inbetween::editor::TimelineEdit::SetTranslationInKeyframe(keyframe, robot, Vec3::new(x, 1.5, 0.0))),
        );
        apply(&mut teacher, at(inbetween::editor::TimelineEdit::SetRotationInKeyframe(keyframe, head, turn)));
    }
    apply(&mut teacher, Command::Edit(Edit::SetMsBetweenKeyframes(4000)));
    let (before, undo) = (text(&editor), editor.undo_label());
    compare_with(&mut editor, same);
    assert_eq!(editor.message_text(), "Comparing with teacher.json: 6 keyframes.");
    run(&mut editor, "scrub 1.5");
    assert_eq!(ghosts(&editor), [], "nothing differs");
    compare_with(&mut editor, text(&teacher));
    assert_eq!((text(&editor), editor.undo_label()), (before, undo), "the document is as it was");
    assert_eq!(tints(&editor), 1);
    let off = compared_off(&editor).unwrap();
    // After 3 s this robot is at 2.5, the teacher's at 1.75.
    let (units, _) = distances(
        inbetween::rbt::Rbt { translation: Vec3::new(2.5, 1.0, 0.0), ..inbetween::rbt::Rbt::IDENTITY },
        inbetween::rbt::Rbt { translation: Vec3::new(1.75, 1.5, 0.0), ..inbetween::rbt::Rbt::IDENTITY },
    );
    assert!((off.units - units).abs() < 1e-5 && off.moved == robot, "{off:?}");
    assert!((off.degrees - DQuat::from_rotation_y(0.5).to_axis_angle().1.to_degrees()).abs() < 1e-3);
    assert_eq!(off.turned, head);
    // At a keyframe, and after the end of either, it is shown too.
    apply(&mut editor, Command::Edit(Edit::GoTo(KeyframeIndex::new(4))));
    assert!(compared_off(&editor).is_some() && tints(&editor) == 1);
    run(&mut editor, "compare-with none");
    assert_eq!((ghosts(&editor), compared_off(&editor)), (Vec::new(), None));
}

#[test]
fn what_cannot_be_compared_is_said_in_one_sentence() {
    let mut editor = editor_with(6);
    let good = text(&editor);
    compare_with(&mut editor, good);
    for (bytes, sentence) in [
        (text(&editor_with(3)), "teacher.json: 3 keyframes; it takes 4 or more to play beside these"),
        (b"{}".to_vec(), "teacher.json: line 1 column 2: format is missing"),
        (b"key 1 2 x".to_vec(), "teacher.json: "),
    ] {
        compare_with(&mut editor, bytes);
        let said = editor.message_text();
        assert!(said.starts_with(sentence), "{said}");
        assert!(!said.contains('\n'));
        assert!(editor.compared().is_some(), "what was compared before still is");
    }
    let missing = inbetween::words::texts::STORAGE_NOT_FOUND.into();
    let _ = editor.compared_read(Path::new("teacher.json"), Err(missing));
    assert!(editor.message_text().starts_with("teacher.json: "));
}

#[test]
fn texts_can_be_compared_with() {
    let mut editor = editor_with(6);
    let mut rows = String::new();
    for _ in 0..6 {
        for rbt in editor.scene().rest_pose().iter() {
            let [x, y, z] = rbt.translation.to_array();
            let _ = writeln!(rows, "{x} {y} {z} 1 0 0 0");
        }
        rows += "\n";
    }
    compare_with(&mut editor, rows.into_bytes());
    let said = editor.message_text();
    assert!(said.starts_with("Comparing with teacher.json: 6 keyframes. Read as text: "), "{said}");
}

#[test]
fn ghosts_of_the_chosen_node_are_those_below_it() {
    let mut editor = turning();
    run(&mut editor, "go 2\nghosts 1");
    let all = ghosts(&editor).len();
    run(&mut editor, "ghosts-of chosen");
    assert_eq!(ghosts(&editor).len(), all, "nothing is chosen");
    run(&mut editor, "select robot1/right_shoulder/right_elbow");
    let elbow = ghosts(&editor).len();
    assert!(elbow > 0 && elbow < all);
    run(&mut editor, "do ghosts-of-chosen");
    assert_eq!(ghosts(&editor).len(), all);
}

struct App {
    editor: Editor,
    ui: Panels,
    is_dressed: bool,
}

fn harness(editor: Editor) -> Harness<'static, App> {
    let app = App { editor, ui: Panels::new(), is_dressed: false };
    let mut harness = Harness::builder().with_size(vec2(1280.0, 800.0)).with_max_steps(60).build_ui_state(
        |ui, app: &mut App| {
            if !std::mem::replace(&mut app.is_dressed, true) {
                theme::install(ui.ctx());
            }
            for command in app.ui.show(ui, &app.editor).commands {
                let _ = app.editor.apply(command);
            }
        },
        app,
    );
    harness.run();
    harness
}

#[test]
fn the_legend_says_what_is_what_and_chooses() {
    let mut editor = turning();
    run(&mut editor, "scrub 1.3");
    let mut harness = harness(editor);
    let entries = ["Catmull-Rom", "normalised lerp", "blended matrices"];
    assert!(entries.iter().all(|name| harness.query_by_role_and_label(Role::CheckBox, name).is_none()));
    apply(&mut harness.state_mut().editor, Command::View(ViewCommand::ToggleComparison));
    harness.run();
    for name in entries {
        assert!(harness.query_by_role_and_label(Role::CheckBox, name).is_some(), "{name}");
    }
    harness.get_by_role_and_label(Role::CheckBox, entries[2]).click();
    harness.run();
    let compared = &harness.state().editor.session().compared_blends;
    assert!(!compared.contains(&Blend::Matrices) && compared.contains(&Blend::Nlerp));
    harness.get_by_role_and_label(Role::CheckBox, entries[2]).click();
    harness.run();
    assert_eq!(harness.state().editor.session().compared_blends, Blend::ALL);
}

#[test]
fn the_legend_has_the_other_file_and_ends_it() {
    let mut editor = editor_with(6);
    let teacher = text(&turning());
    compare_with(&mut editor, teacher);
    apply(&mut editor, Command::Playback(PlaybackCommand::Scrub(1.5)));
    let off = compared_off(&editor).unwrap();
    let mut harness = harness(editor);
    assert!(harness.query_by_label("teacher.json").is_some());
    assert!(harness.query_by_label(&format!("moved by {:.3} at most: robot1", off.units)).is_some());
    harness.get_by_label("Stop comparing").click();
    harness.run();
    assert!(harness.state().editor.compared().is_none());
    assert!(harness.query_by_label("teacher.json").is_none());
}
