//! Reaching with hands and feet: by script lines, and by drags of the balls at the limbs' ends.

mod common;

use std::path::PathBuf;
use std::sync::Arc;

use common::{apply, editor, editor_with, press};
use glam::{Quat, Vec2, Vec3};
use inbetween::camera::Camera;
use inbetween::editor::{Command, Editor, Eye, GestureCommand, ViewCommand};
use inbetween::keyframe::keyframes_to_json;
use inbetween::pose::{Pose, RbtIndex};
use inbetween::scene::scene_from_json;
use inbetween::script::script_commands;
use inbetween::view::{add_limb_balls, frame_of_editor, mark_limb_ball};
use inbetween::window::limb_drag::{LimbDrag, REACH};
use inbetween::words::Phrase;

const ELBOW: &str = "robot1/right_shoulder/right_elbow";
const KNEES: [&str; 2] = ["robot1/right_hip/right_knee", "robot1/left_hip/left_knee"];
const SIZE: Vec2 = Vec2::new(1020.0, 580.0);

fn run(editor: &mut Editor, script: &str) {
    let commands = script_commands(script.as_bytes(), editor.scene()).unwrap_or_else(|problems| panic!("{problems:?}"));
    for command in commands {
        apply(editor, command);
    }
}

fn node(editor: &Editor, path: &str) -> RbtIndex {
    editor.scene().find_rbt(path).unwrap_or_else(|| panic!("{path}"))
}

/// Where the end of a limb is, in world space.
fn end(editor: &Editor, path: &str) -> Vec3 {
    editor.limb_ball(node(editor, path)).expect("it has an end").end_in_world
}

fn pose(editor: &Editor) -> Pose {
    editor.document().live_pose.clone()
}

/// The rotation of a node in world space.
fn world_rotation(editor: &Editor, path: &str) -> Quat {
    editor.scene().world_from_rbt(&pose(editor), 0.0, node(editor, path)).rotation
}

/// The angle of a joint about its axis in degrees, by its node's rotation in the robots' rest pose, which is the identity.
fn bend(editor: &Editor, path: &str, axis: Vec3) -> f32 {
    let turned = pose(editor).get(node(editor, path)).rotation;
    let across = turned.xyz() - axis * turned.xyz().dot(axis);
    assert!(across.length() < 1e-5, "{path} leaves its hinge: {turned}");
    (2.0 * turned.xyz().dot(axis).atan2(turned.w)).to_degrees()
}

#[test]
fn a_hand_goes_where_it_is_sent_and_its_elbow_does_not_bend_backwards() {
    let mut editor = editor();
    assert!(
        end(&editor, ELBOW).distance(Vec3::new(-0.08, 1.75, 0.0)) < 1e-6,
        "the hand is the arm's length from the shoulder"
    );
    for target in [Vec3::new(-1.0, 2.2, 0.6), Vec3::new(-1.8, 1.2, -0.5), Vec3::new(-0.5, 1.1, 0.3)] {
        run(&mut editor, &format!("reach {} {} {} {ELBOW}", target.x, target.y, target.z));
        assert!(end(&editor, ELBOW).distance(target) < 1e-4, "{target}: {}", end(&editor, ELBOW));
        assert!((0.0..=150.0).contains(&bend(&editor, ELBOW, Vec3::NEG_Y)));
        assert_eq!(editor.message_text(), "");
    }
    let at = end(&editor, ELBOW);
    run(&mut editor, &format!("reach-by 0.1 -0.05 0 {ELBOW}"));
    assert!(end(&editor, ELBOW).distance(at + Vec3::new(0.1, -0.05, 0.0)) < 1e-4);
    assert_eq!(editor.undo_label().map(Phrase::english), Some("reach"));
}

#[test]
fn what_is_out_of_reach_is_said_outside_of_drags() {
    let mut editor = editor();
    run(&mut editor, &format!("reach 3 1.75 0 {ELBOW}"));
    assert_eq!(
        editor.message_text(),
        "robot1/right_shoulder/right_elbow: its end stops 3.080 units before the target, where bones or limits end."
    );
    // A joint without limits would fold further than 150 degrees.
    run(&mut editor, &format!("reach -1.5 1.75 0 {ELBOW}"));
    assert!((bend(&editor, ELBOW, Vec3::NEG_Y) - 150.0).abs() < 1e-3);
    assert!(editor.message_text().contains("where bones or limits end"));
    run(&mut editor, &format!("drag begin\nreach 3 1.75 0 {ELBOW}\nreach 3 3 0 {ELBOW}"));
    assert_eq!(editor.message_text(), "");
    run(&mut editor, "drag end\nundo\nundo\nundo");
    assert_eq!(pose(&editor), *editor.scene().rest_pose());
}

#[test]
fn limits_bind_reaching_alone() {
    let mut editor = editor();
    run(&mut editor, &format!("select {ELBOW}\nrotate y 60\nrotate x 30"));
    let turned = pose(&editor).get(node(&editor, ELBOW)).rotation;
    assert!(
        turned.angle_between(Quat::from_rotation_y(60_f32.to_radians()) * Quat::from_rotation_x(30_f32.to_radians()))
            < 1e-3
    );
    // What the hinge does not turn stays as the user left it.
    run(&mut editor, &format!("reach -1 2 0.5 {ELBOW}"));
    let reached = pose(&editor).get(node(&editor, ELBOW)).rotation;
    let hinge = reached * turned.inverse();
    assert!(hinge.x.abs() < 1e-5 && hinge.z.abs() < 1e-5, "it turns about y alone: {hinge}");
}

#[test]
fn a_pole_turn_moves_the_elbow_and_not_the_hand() {
    let mut editor = editor();
    run(&mut editor, &format!("reach -1 2 0.5 {ELBOW}"));
    let (hand, elbow) = (end(&editor, ELBOW), editor.scene().world_from_rbt(&pose(&editor), 0.0, node(&editor, ELBOW)));
    run(&mut editor, &format!("pole 90 {ELBOW}"));
    let turned = editor.scene().world_from_rbt(&pose(&editor), 0.0, node(&editor, ELBOW));
    assert!(end(&editor, ELBOW).distance(hand) < 1e-5);
    assert!(turned.translation.distance(elbow.translation) > 0.1);
    run(&mut editor, &format!("pole 270 {ELBOW}"));
    let back = editor.scene().world_from_rbt(&pose(&editor), 0.0, node(&editor, ELBOW));
    assert!(back.translation.distance(elbow.translation) < 1e-5);
}

/// The soles of robot 1, each with its foot's rotation.
fn soles(editor: &Editor) -> [(Vec3, Quat); 2] {
    KNEES.map(|knee| (end(editor, knee), world_rotation(editor, knee)))
}

#[test]
fn feet_stay_while_the_body_moves_in_every_way() {
    for moves in [
        "select robot1\ntranslate 0.1 -0.3 0.2",
        "select robot1\nrotate y 15",
        "set-translation -2.1 0.8 0 robot1",
        "select robot1\nwheel 0.2\nwheel 0.1",
        "select robot1\ndrag begin\ndrag move 0.1 -0.2 0\ndrag turn y 10\ndrag move 0 -0.1 0\ndrag end",
    ] {
        let mut editor = editor();
        run(&mut editor, "keep-feet on\nselect robot1\ntranslate 0 -0.1 0");
        let before = soles(&editor);
        run(&mut editor, moves);
        for ((at, turned), (was_at, was_turned)) in soles(&editor).into_iter().zip(before) {
            assert!(at.distance(was_at) < 1e-4, "{moves}: {at}, not {was_at}");
            // Two bones hold the place. Of the rotation they hold where the foot points, while the shin leans.
            let facing = |turned: Quat| turned * Vec3::X;
            let off = facing(turned).angle_between(facing(was_turned));
            assert!(off < 0.1, "{moves}: the foot turned by {off}");
        }
        for knee in KNEES {
            assert!((0.0..=150.0).contains(&bend(&editor, knee, Vec3::X)), "{moves}");
        }
    }
}

#[test]
fn feet_that_leave_the_ground_in_a_drag_come_back_to_it() {
    let mut editor = editor();
    run(&mut editor, "keep-feet on\nselect robot1\ntranslate 0 -0.2 0");
    let before = (soles(&editor), pose(&editor));
    run(&mut editor, "drag begin\ndrag move 0 1.5 0");
    assert!(soles(&editor)[0].0.y > before.0[0].0.y + 1.0, "the legs are too short");
    run(&mut editor, "drag move 0 -1.5 0");
    assert!(soles(&editor)[0].0.distance(before.0[0].0) < 1e-4);
    run(&mut editor, "drag end\nundo");
    assert_eq!(pose(&editor), before.1, "one step");
    run(&mut editor, "keep-feet off\ntranslate 0 0.5 0");
    assert!((soles(&editor)[0].0.y - before.0[0].0.y - 0.5).abs() < 1e-5);
}

/// A journal keeps where a drag has led the chosen nodes, and leaves the rest to the editor.
#[test]
fn where_a_drag_led_the_chosen_nodes_says_where_the_feet_are() {
    for chosen in
        ["select robot1", "select robot1/right_hip\nselect-also robot1", "select robot1\nselect-also robot1/head"]
    {
        let mut moved = editor();
        run(&mut moved, &format!("keep-feet on\n{chosen}\ndrag begin"));
        let mut placed = moved.clone();
        run(&mut moved, "drag move 0.1 -0.3 0\ndrag turn y 20\ndrag move 0 0.1 0.1");
        let led = moved.drag_so_far().expect("it has moved");
        apply(&mut placed, Command::Gesture(led));
        assert_eq!(pose(&placed), pose(&moved), "{chosen}");
    }
}

#[test]
fn a_leg_that_is_posed_itself_is_not_kept() {
    let mut editor = editor();
    run(&mut editor, "keep-feet on\nselect robot1/right_hip\nrotate x -40");
    let foot = end(&editor, KNEES[0]);
    assert!(foot.z > 0.5, "{foot}");
}

#[test]
fn refusals_say_why() {
    let scene = r#"{"format": "inbetween.scene", "version": 3, "name": "n", "eyes": ["sky"], "nodes": [
        {"name": "sky"},
        {"name": "squeezed", "control": {"scale": [[0, [1, 2, 1]]]}, "children": [
            {"name": "arm", "children": [{"name": "hand", "translation": [1, 0, 0], "reach": [1, 0, 0]}]}]},
        {"name": "grown", "control": {"scale": [[0, 2]]}, "children": [
            {"name": "arm", "children": [{"name": "hand", "translation": [1, 0, 0], "reach": [1, 0, 0]}]}]},
        {"name": "point", "reach": [0, 0, 0]},
        {"name": "rod", "children": [{"name": "shape", "shape": {"cylinder": {"radius": 0.1, "height": 2}}, "translation": [0, 1, 0]}]},
        {"name": "lid", "reach": [1, 0, 0], "limits": {"hinge": {"axis": [0, 0, 1], "degrees": [0, 90]}}}]}"#;
    let mut editor = Editor::new(Arc::new(scene_from_json(scene).unwrap()), PathBuf::from("animation.json"));
    for (line, expected) in [
        ("reach 0 1 0 sky", "\"sky\" has no end to reach with: neither a reach in the scene file nor a shape."),
        (
            "reach 0 1 0 squeezed/arm/hand",
            "\"squeezed/arm/hand\" cannot reach: a control node scales it differently along its axes.",
        ),
        (
            "pole 90 point",
            "\"point\" has no line to turn about: its end is at the root of the limb, or a hinge holds it.",
        ),
        ("pole 90 lid", "\"lid\" has no line to turn about: its end is at the root of the limb, or a hinge holds it."),
        ("reach 2e6 0 0 point", "That is too far away: coordinates are between -1e6 and 1e6. Nothing was changed."),
        ("reach 1 0 0 point", "point: its end stops 1.000 units before the target, where bones or limits end."),
    ] {
        let before = pose(&editor);
        run(&mut editor, line);
        assert_eq!(editor.message_text(), expected, "{line}");
        assert_eq!(pose(&editor), before, "{line}");
    }
    // Scales that are even do no harm, and neither does a limb of one bone.
    for (path, target) in [("grown/arm/hand", Vec3::new(1.0, 2.0, 1.0)), ("lid", Vec3::Y)] {
        run(&mut editor, &format!("reach {} {} {} {path}", target.x, target.y, target.z));
        assert!(end(&editor, path).distance(target) < 1e-4, "{path}: {}", end(&editor, path));
    }
    run(&mut editor, "reach -1 -0.1 0 lid");
    assert!(end(&editor, "lid").distance(Vec3::Y) < 1e-5, "the lid opens no further");
    // Without `reach` the end is the far end of the shape.
    run(&mut editor, "reach 2 0 0 rod");
    assert_eq!(editor.message_text(), "");
    let rod = editor.scene().world_from_rbt(&pose(&editor), 0.0, node(&editor, "rod"));
    assert!(rod.transform_point(Vec3::Y * 2.0).distance(Vec3::X * 2.0) < 1e-4);
}

#[test]
fn playing_refuses_and_goes_on() {
    let mut editor = editor_with(5);
    press(&mut editor, "y");
    for line in [&format!("reach 0 1 0 {ELBOW}"), &format!("reach-by 0 1 0 {ELBOW}"), &format!("pole 5 {ELBOW}")] {
        run(&mut editor, line);
        assert!(editor.message_text().starts_with("Cannot reach while playing."), "{}", editor.message_text());
        assert!(editor.is_playing());
    }
    assert!(editor.limb_balls(Some(node(&editor, ELBOW))).is_empty());
    assert_eq!(editor.limb_ball_at(&editor.camera(SIZE), Vec2::ZERO, 1e6), None);
}

fn seen(editor: &Editor, camera: &Camera, path: &str) -> Vec2 {
    camera.project(end(editor, path)).expect("it is in front of the eye").0
}

#[test]
fn a_dragged_ball_stays_under_the_pointer_in_one_step_of_undo() {
    for eye in [Eye::Work, Eye::Recorded(0), Eye::Recorded(1), Eye::Recorded(2)] {
        let mut editor = editor_with(1);
        // The robot that is looked at stands before the other ones.
        let robot = if eye == Eye::Recorded(2) { "robot1" } else { "robot2" };
        run(&mut editor, &format!("set-translation 0 0 -5 {robot}"));
        apply(&mut editor, Command::View(ViewCommand::SetEye(eye)));
        let (elbow, before) = (format!("{robot}/left_shoulder/left_elbow"), pose(&editor));
        let elbow = elbow.as_str();
        let camera = editor.camera(SIZE);
        let from_px = seen(&editor, &camera, elbow);
        let mut drag =
            LimbDrag::at(&editor, &camera, from_px + Vec2::new(2.0, -3.0), REACH).expect("the press takes the ball");
        assert_eq!(drag.ball().last, node(&editor, elbow));
        for step in 1..=20 {
            let at_px = from_px + Vec2::new(2.0, -3.0) + Vec2::new(1.5, -1.0) * step as f32;
            for command in drag.move_to(&editor, &camera, at_px, false) {
                apply(&mut editor, command);
            }
        }
        let off = seen(&editor, &camera, elbow).distance(from_px + Vec2::new(30.0, -20.0));
        assert!(off < 0.1, "{eye:?}: {off} pixels off");
        let depth = |point: Vec3| camera.project(point).unwrap().1;
        let (hand, was) = (
            end(&editor, elbow),
            editor.scene().world_from_node(&before, 0.0, editor.scene().rbt_node(node(&editor, elbow))),
        );
        let was = was.transform_point3(Vec3::new(-0.72, 0.0, 0.0));
        assert!((depth(hand) - depth(was)).abs() < 1e-3, "in the view's plane");
        // Along the view, and the wheel turns the elbow about the line to the hand.
        for command in drag.move_to(&editor, &camera, from_px + Vec2::new(32.0, -63.0), true) {
            apply(&mut editor, command);
        }
        assert!(depth(end(&editor, elbow)) > depth(was) + 0.05, "up is away");
        let (hand, turned) = (end(&editor, elbow), pose(&editor));
        for command in drag.wheel(&editor, 4.0) {
            apply(&mut editor, command);
        }
        assert!(end(&editor, elbow).distance(hand) < 1e-4 && pose(&editor) != turned);
        let end_of_drag = drag.release(&editor).expect("it has moved");
        apply(&mut editor, end_of_drag);
        run(&mut editor, "undo");
        assert_eq!(pose(&editor), before, "{eye:?}: one step");
    }
}

#[test]
fn a_click_on_a_ball_does_nothing_and_a_cancelled_drag_is_over() {
    let mut editor = editor();
    let camera = editor.camera(SIZE);
    let at_px = seen(&editor, &camera, ELBOW);
    let mut drag = LimbDrag::at(&editor, &camera, at_px, REACH).unwrap();
    assert_eq!(drag.move_to(&editor, &camera, at_px, false), []);
    assert!(!drag.has_begun() && drag.release(&editor).is_none());
    for command in drag.move_to(&editor, &camera, at_px + 5.0, false) {
        apply(&mut editor, command);
    }
    press(&mut editor, "Esc");
    assert_eq!(pose(&editor), *editor.scene().rest_pose());
    assert_eq!(drag.move_to(&editor, &camera, at_px + 9.0, false), []);
    assert_eq!(drag.wheel(&editor, 1.0), []);
    assert!(drag.release(&editor).is_none());
    assert_eq!(LimbDrag::at(&editor, &camera, at_px + 15.0, REACH), None, "not near enough");
}

#[test]
fn a_drag_through_the_straight_arm_is_continuous_and_bends_the_same_way_again() {
    let mut editor = editor();
    run(&mut editor, &format!("reach -0.6 1.75 0.3 {ELBOW}"));
    let before = pose(&editor);
    apply(&mut editor, Command::Gesture(GestureCommand::Begin));
    let mut last = pose(&editor);
    for step in 0..=200 {
        let part = f64::from(step) / 200.0;
        let out = (part * std::f64::consts::PI).sin() * 2.0;
        run(&mut editor, &format!("reach {} 1.75 {} {ELBOW}", -0.6 + out, 0.3 + 0.3 * out));
        for rbt in editor.scene().rbt_indices() {
            let turned = last.get(rbt).rotation.angle_between(pose(&editor).get(rbt).rotation);
            assert!(turned < 0.35, "step {step}: a jump by {turned}");
        }
        last = pose(&editor);
    }
    for rbt in editor.scene().rbt_indices() {
        let off = before.get(rbt).rotation.angle_between(last.get(rbt).rotation);
        assert!(off < 0.01, "it comes back {off} off");
    }
}

#[test]
fn balls_show_for_the_robot_that_is_chosen_or_under_the_pointer() {
    let mut editor = editor();
    assert!(editor.limb_balls(None).is_empty());
    let head = node(&editor, "robot2/head");
    let paths = |editor: &Editor, hovered| {
        let balls = editor.limb_balls(hovered);
        balls.iter().map(|ball| editor.scene().rbt_path(ball.last).to_owned()).collect::<Vec<_>>()
    };
    let of = |robot: &str| {
        ["right_shoulder/right_elbow", "left_shoulder/left_elbow", "right_hip/right_knee", "left_hip/left_knee"]
            .map(|limb| format!("{robot}/{limb}"))
    };
    assert_eq!(paths(&editor, Some(head)), of("robot2"));
    run(&mut editor, "select robot1/head");
    assert_eq!(paths(&editor, None), of("robot1"));
    assert_eq!(paths(&editor, Some(head)), [of("robot1"), of("robot2")].concat());
    let mut frame = frame_of_editor(&editor, SIZE);
    let before = frame.dots.len();
    add_limb_balls(&mut frame, &editor, None);
    let drawn = frame.dots.len();
    assert!(drawn > before);
    mark_limb_ball(&mut frame, editor.limb_ball(node(&editor, ELBOW)).unwrap());
    assert!(frame.dots.len() > drawn);
}

#[test]
fn reaching_is_captured_by_keyframes_as_ordinary_rotations() {
    let mut editor = editor();
    run(&mut editor, &format!("reach -1 2 0.5 {ELBOW}\nkey n"));
    let document = editor.document();
    let text =
        keyframes_to_json(editor.scene(), &document.keyframes, document.interpolation, document.ms_between_keyframes);
    assert!(text.contains("\"version\": 1"), "{text}");
    assert_eq!(document.keyframes.as_slice()[0].pose, document.live_pose);
}
