//! Every line of a script as its command: what it leaves, and that undo returns the document to the same bytes.

mod common;

use std::collections::BTreeSet;
use std::path::Path;

use common::{apply, editor_with, press, shown};
use inbetween::editor::{Editor, Effect, PlayMode, Session, WorkEye};
use inbetween::keyframe::keyframes_to_json;
use inbetween::script::{markdown as script_lines, script_commands};
use inbetween::words::Phrase;

fn run(editor: &mut Editor, script: &str) {
    let commands = script_commands(script.as_bytes(), editor.scene()).unwrap_or_else(|problems| panic!("{problems:?}"));
    for command in commands {
        apply(editor, command);
    }
}

/// All that undo restores.
fn document(editor: &Editor) -> (String, String, Vec<[f32; 7]>) {
    let document = editor.document();
    let text =
        keyframes_to_json(editor.scene(), &document.keyframes, document.interpolation, document.ms_between_keyframes);
    let pose = document.live_pose.iter().map(|rbt| {
        let ([x, y, z], [a, b, c, d]) = (rbt.translation.to_array(), rbt.rotation.to_array());
        [x, y, z, a, b, c, d]
    });
    (text, shown(editor), pose.collect())
}

/// Lines that edit the document, after lines that lead there: what the list is then, and what is said.
const EDITS: &[(&str, &str, &str, &str)] = &[
    ("select robot1", "rotate z 45", "0 1 2 3 4 [5] | 5", ""),
    ("select robot1\ntranslate 1 0 0", "reset-node", "0 1 2 3 4 [5] | -2", "Returned to rest: robot1."),
    (
        "select robot1/left_shoulder\nrotate z 30",
        "mirror",
        "0 1 2 3 4 [5] | 5",
        "Mirrored robot1/left_shoulder to robot1/right_shoulder.",
    ),
    ("", "pose apply sit", "0 1 2 3 4 [5] | 5", "Gave sit to robot1."),
    (
        "",
        r#"pose-of "{\"format\": \"inbetween.pose\", \"version\": 1, \"name\": \"a\", \"nodes\": [{\"path\": \"robot2\", \"turned\": [0, 1, 0, 0]}]}""#,
        "0 1 2 3 4 [5] | 5",
        "Gave a to the scene.",
    ),
    ("select robot1", "translate 0.5 0 0", "0 1 2 3 4 [5] | 5.5", ""),
    ("", "key n", "0 1 2 3 4 5 [5] | 5", "Keyframe 6 (0 to 6): created after keyframe 5."),
    ("", "do reverse keyframes", "5 4 3 2 1 [0] | 0", "Reversed 6 keyframes."),
    ("select-keyframes 1-2", "move 6", "0 3 4 5 [1] 2 | 1", "Moved 2 keyframes to place 4."),
    ("", "new", " | -2", "A new animation: no keyframes yet."),
    ("go 2", "move 0", "[2] 0 1 3 4 5 | 2", "Moved 1 keyframe to place 0."),
    ("select-keyframes 1 3", "cut", "[0] 2 4 5 | 0", "Deleted 2 keyframes. Keyframe 0 (0 to 3)."),
    (
        "select-keyframes 1 3\ncopy\nselect-keyframes none\ngo 4",
        "paste",
        "0 1 2 3 4 [1] 3 5 | 1",
        "2 keyframes pasted: now at 5.",
    ),
    ("go 3", "duplicate", "0 1 2 3 [3] 4 5 | 3", "1 keyframe duplicated: now at 4."),
    ("select-keyframes 3 5", "delete", "0 1 [2] 4 | 2", "Deleted 2 keyframes. Keyframe 2 (0 to 3)."),
    ("select-keyframes 1-3", "reverse", "0 3 2 1 4 [5] | 5", "Reversed 3 keyframes."),
    ("select-keyframes 1-2", "easing bounce-out", "0 1 2 3 4 [5] | 5", "Easing: bounce-out."),
    ("", "rename 2 the jump", "0 1 2 3 4 [5] | 5", "Keyframe 2 is now “the jump”."),
    ("rename 2 jump", "rename 2", "0 1 2 3 4 [5] | 5", "Keyframe 2 has no name now."),
    ("", "duration 2 1.75", "0 1 2 3 4 [5] | 5", "The interval after keyframe 2 lasts 1.750 of a step."),
    ("select-keyframes 2", "retime 250", "0 1 2 3 4 [5] | 5", "Moved 1 keyframe by +0.250 s."),
    ("select-keyframes 2 3", "retime -9000 ripple", "0 1 2 3 4 [5] | 5", "Moved 2 keyframes by -1.998 s."),
    ("select-keyframes 2-4", "retime 500 end", "0 1 2 3 4 [5] | 5", "Moved 3 keyframes by +0.500 s."),
    ("select-keyframes 2-4", "retime -500 start ripple", "0 1 2 3 4 [5] | 5", "Moved 3 keyframes by -0.500 s."),
    ("", "duration 2 1.75 ripple-free", "0 1 2 3 4 [5] | 5", "The interval after keyframe 2 lasts 1.750 of a step."),
    (
        "select robot1\nrotate y 30\ncopy-pose\nselect robot2",
        "paste-pose",
        "0 1 2 3 4 [5] | 5",
        "Pasted the pose of robot1 to robot2.",
    ),
    ("", "set-translation 7 1 0 robot1", "0 1 2 3 4 [5] | 7", ""),
    ("", "set-rotation 0 3 0 4 robot1/head", "0 1 2 3 4 [5] | 5", ""),
    ("", "set-keyframe-translation 2 9 1 0 robot1", "0 1 9 3 4 [5] | 5", ""),
    ("", "set-keyframe-translation 5 9 1 0 robot1", "0 1 2 3 4 [9] | 9", ""),
    ("", "set-keyframe-rotation 2 0 1 0 0 robot2/head", "0 1 2 3 4 [5] | 5", ""),
    ("select robot1", "wheel 0.5", "0 1 2 3 4 [5] | 5", ""),
    ("", "interpolation catmull-rom", "0 1 2 3 4 [5] | 5", "Interpolation: Catmull-Rom."),
    ("", "ms 700", "0 1 2 3 4 [5] | 5", "700 ms between keyframes."),
    ("select robot1", "drag begin\ndrag move 0 1 0\ndrag turn y 20\ndrag end", "0 1 2 3 4 [5] | 5", ""),
    (
        "auto-key on\nselect robot1",
        "drag begin\ntranslate 3 0 0\ndrag end",
        "0 1 2 3 4 [8] | 8",
        "Keyframe 5 (0 to 5): updated by auto-key.",
    ),
    ("select robot1", "rotate-by 0 0 1 0.5", "0 1 2 3 4 [5] | 5", ""),
    ("select robot1", "wheel-by 1 0 0 0 0 0 1", "0 1 2 3 4 [5] | 6", ""),
    ("select robot1", "drag begin\ndrag-by 1 0 0 0 0 0 1\ndrag end", "0 1 2 3 4 [5] | 6", ""),
    ("select robot1", "drag begin\ndrag-to move 7 1 0 0 0 0 1\ndrag end", "0 1 2 3 4 [5] | 7", ""),
    ("", "reach 1 2 0.5 robot2/right_shoulder/right_elbow", "0 1 2 3 4 [5] | 5", ""),
    ("", "reach-by -0.2 0 0.1 robot2/right_hip/right_knee", "0 1 2 3 4 [5] | 5", ""),
    (
        "reach 1 2 0.5 robot2/left_shoulder/left_elbow",
        "pole 30 robot2/left_shoulder/left_elbow",
        "0 1 2 3 4 [5] | 5",
        "",
    ),
    ("keep-feet on\nselect robot1", "translate 0 -0.25 0", "0 1 2 3 4 [5] | 5", ""),
    ("select robot1", "turn y 30 world", "0 1 2 3 4 [5] | 5", ""),
    ("select robot1", "shift 2 0 0 parent", "0 1 2 3 4 [5] | 7", ""),
    (
        "select robot1",
        "drag begin\ndrag-pull move 9 0 0 world\ndrag-pull move 1 0 0 world\ndrag end",
        "0 1 2 3 4 [5] | 6",
        "",
    ),
    (
        "select robot1",
        "key ctrl+g\ndrag-lock x\ndrag-type 2\ndrag-type erase\ndrag-type 4\ndrag end",
        "0 1 2 3 4 [5] | 9",
        "",
    ),
    ("select robot1", "do turn-begin\ndrag-lock z\ndrag-type 9\ndrag-type 0\ndrag end", "0 1 2 3 4 [5] | 5", ""),
    ("select robot1", "drag-grab move z world\ndrag-pull move 0 0 3 world\ndrag end", "0 1 2 3 4 [5] | 5", ""),
    ("", "clamped ms 7", "0 1 2 3 4 [5] | 5", "100 ms between keyframes."),
    ("scrub 1.5", "key n", "0 1 2 [2.5] 3 4 5 | 2.5", "Keyframe 3 (0 to 6): created after keyframe 2."),
    ("scrub 1.5", "key u", "0 1 2 3 4 [2.5] | 2.5", "Keyframe 5 (0 to 5): updated from the scene."),
];

#[test]
fn every_edit_is_one_step_of_undo_back_to_the_same_bytes() {
    for &(before, line, expected, message) in EDITS {
        let mut editor = editor_with(6);
        run(&mut editor, before);
        let was = document(&editor);
        // Where a scrubbed pose was on screen, undo shows the document again.
        let was = if editor.is_scrubbed() { (was.0, "0 1 2 3 4 [5] | 5".to_owned(), was.2) } else { was };
        run(&mut editor, line);
        assert_eq!(shown(&editor), expected, "{line}");
        if !message.is_empty() {
            assert_eq!(editor.message_text(), message, "{line}");
        }
        let after = document(&editor);
        assert_ne!(after, was, "{line} changes nothing");
        run(&mut editor, "undo");
        assert_eq!(document(&editor), was, "undo of {line}");
        run(&mut editor, "redo");
        assert_eq!(document(&editor), after, "redo of {line}");
    }
}

#[test]
fn what_undo_takes_back_is_named_after_what_was_done() {
    for (script, label) in [
        ("select robot1\ndrag begin\ndrag move 0 1 0\ndrag end", "move a node"),
        ("select robot1\ndrag begin\ndrag turn y 20\ndrag end", "turn a node"),
        ("drag begin\ndrag turn y 20\ndrag end", "move the eye"),
        ("select robot1\ndrag-grab turn x local\ndrag-pull turn x 20 local\ndrag end", "turn a node"),
        ("select robot1\nshift 1 0 0 view", "move a node"),
        ("drag begin\nduration 2 1.5\ndrag end", "retiming of an interval"),
        ("drag begin\nselect-keyframes 2\nretime 900\nretime 20\ndrag end", "retiming of keyframes"),
        ("drag begin\nset-keyframe-translation 2 9 1 0 robot1\ndrag end", "change of a node in a keyframe"),
        ("drag begin\nms 700\ndrag end", "change of pace"),
    ] {
        let mut editor = editor_with(6);
        run(&mut editor, script);
        assert_eq!(editor.undo_label().map(Phrase::english), Some(label), "{script}");
    }
}

#[test]
fn a_cancelled_drag_is_as_if_it_had_not_been() {
    let mut editor = editor_with(6);
    let before = (document(&editor), editor.undo_label());
    run(&mut editor, "select robot1\ndrag begin\ndrag move 0 1 0\ndrag cancel");
    assert_eq!((document(&editor), editor.undo_label()), before);
    assert!(!editor.is_dragging());
}

type Look = fn(&Session) -> String;

fn work_eye(session: &Session) -> String {
    let WorkEye { yaw_degrees, pitch_degrees, distance, target_in_world } = session.work_eye;
    format!("{yaw_degrees} {pitch_degrees} {distance} {target_in_world}")
}

/// Lines that change how things are looked at and played: what they leave, which undo leaves alone.
const SESSIONS: &[(&str, &str, Look)] = &[
    ("select robot1/head", "[RbtIndex(11)]", |session| format!("{:?}", &*session.chosen)),
    ("select-also robot1/head", "[RbtIndex(11)]", |session| format!("{:?}", &*session.chosen)),
    ("select ground\nselect-also robot1/head", "[RbtIndex(1), RbtIndex(11)]", |session| {
        format!("{:?}", &*session.chosen)
    }),
    ("select sky\nselect-also ground\nselect-also sky", "[RbtIndex(1)]", |session| format!("{:?}", &*session.chosen)),
    ("select sky\nselect-also sky", "[]", |session| format!("{:?}", &*session.chosen)),
    ("select sky\nselect-also ground\nselect robot1", "[RbtIndex(2)]", |session| format!("{:?}", &*session.chosen)),
    ("pivot common", "Common", |session| format!("{:?}", session.pivot)),
    ("pivot common\ndo pivot-own", "Own", |session| format!("{:?}", session.pivot)),
    ("select none", "[]", |session| format!("{:?}", &*session.chosen)),
    ("select-keyframes 4 1-2", "1 2 4", |session| {
        session.selected.iter().map(|index| index.get().to_string()).collect::<Vec<_>>().join(" ")
    }),
    ("mode ping-pong", "ping-pong", |session| session.play_mode.name().to_owned()),
    ("mode loop", "loop", |session| session.play_mode.name().to_owned()),
    ("range 2 3", "Some((2, 3))", |session| format!("{:?}", session.play_range)),
    ("range 2 3\nrange all", "None", |session| format!("{:?}", session.play_range)),
    ("range 0 3", "None", |session| format!("{:?}", session.play_range)),
    ("speed 250", "250", |session| session.speed_percent.to_string()),
    ("auto-key on", "true", |session| session.auto_keys.to_string()),
    ("auto-key on\nauto-key off", "false", |session| session.auto_keys.to_string()),
    ("keep-feet on", "true", |session| session.keeps_feet.to_string()),
    ("do keep-feet\nkeep-feet off", "false", |session| session.keeps_feet.to_string()),
    ("gizmo-axes world", "World", |session| format!("{:?}", session.gizmo_axes)),
    ("snap 5 0.1", "5 0.1", |session| format!("{} {}", session.snap.degrees, session.snap.units)),
    ("ghosts 3", "3", |session| session.ghosts.to_string()),
    ("ghosts 3\ndo ghosts", "0", |session| session.ghosts.to_string()),
    ("inset off", "false", |session| session.shows_inset.to_string()),
    ("inset off\ndo inset", "true", |session| session.shows_inset.to_string()),
    ("ghosts-of chosen", "true", |session| session.ghosts_of_chosen.to_string()),
    ("ghosts-of chosen\nghosts-of all", "false", |session| session.ghosts_of_chosen.to_string()),
    ("compare-interpolations nlerp linear", "linear nlerp", |session| {
        session.compared_blends.iter().map(|blend| blend.name()).collect::<Vec<_>>().join(" ")
    }),
    ("eye robot2", "Recorded(2)", |session| format!("{:?}", session.eye)),
    ("key v\nkey v\nkey v", "Recorded(0)", |session| format!("{:?}", session.eye)),
    ("eye work", "Work", |session| format!("{:?}", session.eye)),
    ("eye work\nkey v", "Recorded(0)", |session| format!("{:?}", session.eye)),
    ("eye work\nkey v\nkey v\nkey v\nkey v", "Work", |session| format!("{:?}", session.eye)),
    ("work-eye 30 10 4 0 0 0\nlook right", "90 0 4 [0, 0, 0]", work_eye),
    ("work-eye 30 10 4 0 0 0\nkey ctrl+7", "0 -90 4 [0, 0, 0]", work_eye),
    ("work-eye 30 10 4 0 0 0\nlevel-eye", "30 0 4 [0, 0, 0]", work_eye),
    ("look-from robot1", "0 0 [5, 1, 0]", |session| {
        let WorkEye { yaw_degrees, pitch_degrees, .. } = session.work_eye;
        format!("{yaw_degrees} {pitch_degrees} {}", session.work_eye.world_from_eye().translation)
    }),
    ("select robot1/head\nlook-from", "Work", |session| format!("{:?}", session.eye)),
    ("look top", "Work", |session| format!("{:?}", session.eye)),
    ("eye work\nkey 0", "Recorded(0)", |session| format!("{:?}", session.eye)),
    ("work-eye 0 0 90 9 9 9\nshow-all", "true", |session| (session.work_eye.distance < 30.0).to_string()),
    ("select robot1/head\nwork-eye 0 0 90 9 9 9\nshow-chosen", "true", |session| {
        (session.work_eye.distance < 4.0).to_string()
    }),
    ("work-eye 0 0 90 9 9 9\nreset-work-eye", "20 12", |session| {
        format!("{} {}", session.work_eye.yaw_degrees, session.work_eye.pitch_degrees)
    }),
    ("work-eye 30 -5.5 4 1 2 3", "30 -5.5 4 [1, 2, 3]", work_eye),
    ("eye work\nwork-eye 30 10 4 0 0 0\nwheel 1", "30 10 3 [0, 0, 0]", work_eye),
    ("eye work\nwork-eye 0 0 4 0 0 0\ndrag begin\ndrag move 1 2 3\ndrag end", "0 0 7 [1, 2, 0]", work_eye),
    ("eye work\nwork-eye 0 0 4 0 0 0\ndrag begin\ndrag turn y 90\ndrag end", "90 0 4 [0, 0, 0]", work_eye),
    ("eye work\nwork-eye 0 0 4 0 0 0\ndrag begin\ndrag turn y 90\ndrag cancel", "0 0 4 [0, 0, 0]", work_eye),
];

#[test]
fn lines_that_change_the_session_leave_the_document_alone() {
    for &(line, expected, look) in SESSIONS {
        let mut editor = editor_with(6);
        let before = (document(&editor), editor.undo_label());
        run(&mut editor, line);
        assert_eq!(look(editor.session()), expected, "{line}");
        assert_eq!((document(&editor), editor.undo_label()), before, "{line}");
    }
}

#[test]
fn the_work_eye_moves_while_something_plays() {
    for (lines, expected) in
        [("wheel 1", "0 0 3 [0, 0, 0]"), ("drag begin\ndrag move 1 0 0\ndrag end", "0 0 4 [1, 0, 0]")]
    {
        let mut editor = editor_with(6);
        run(&mut editor, &format!("eye work\nwork-eye 0 0 4 0 0 0\nkey y\n{lines}"));
        assert_eq!(work_eye(editor.session()), expected, "{lines}");
        assert!(editor.is_playing() && editor.message().is_none(), "{lines}: {}", editor.message_text());
    }
}

#[test]
fn scrubbing_and_stepping_move_the_playhead_alone() {
    let mut editor = editor_with(6);
    let before = (document(&editor).0, editor.undo_label());
    run(&mut editor, "scrub 1.25");
    assert_eq!((editor.playhead(), shown(&editor).as_str()), (Some(1.25), "0 1 2 3 4 [5] | 2.25"));
    run(&mut editor, "step 60");
    assert_eq!(editor.playhead(), Some(1.75));
    run(&mut editor, "step -30");
    assert_eq!(editor.playhead(), Some(1.5));
    assert_eq!((document(&editor).0, editor.undo_label()), before);
}

#[test]
fn a_script_plays_a_range_in_a_loop_at_half_the_speed() {
    let mut editor = editor_with(6);
    run(&mut editor, "range 2 3\nmode loop\nspeed 50\nkey y");
    assert_eq!(editor.session().play_mode, PlayMode::Loop);
    // An interval of 2000 ms takes 240 ticks.
    editor.tick(240 + 60);
    assert_eq!(editor.key_time(), Some(1.25));
}

/// What the editor refuses while a script runs, in one sentence each.
#[test]
fn refusals_are_sentences() {
    for (script, sentence) in [
        ("go 6", "There is no keyframe 6: they are 0 to 5."),
        ("select-keyframes 2 9", "There is no keyframe 9: they are 0 to 5."),
        ("move 7", "There is no keyframe 7: they are 0 to 5."),
        ("rename 6 x", "There is no keyframe 6: they are 0 to 5."),
        ("duration 6 1", "There is no keyframe 6: they are 0 to 5."),
        ("set-keyframe-translation 6 0 0 0 robot1", "There is no keyframe 6: they are 0 to 5."),
        ("set-rotation 0 0 0 0 robot1", "That is not a rotation: nothing was changed."),
        ("paste", "Nothing is copied yet: Ctrl+C copies the selected keyframes."),
        ("select robot1\npaste-pose", "No pose is copied yet: choose a node and copy its pose first."),
        ("copy-pose", "No node is chosen. Choose one first: a click on a part, p and a click, or the list of nodes."),
        (
            "range 0 3",
            "Keyframes 0 to 3 cannot play: a range runs from keyframe 1 or later to the last but one or earlier.",
        ),
        ("drag move 0 0 0", "There is no drag to go on with."),
        ("select robot1\ndrag-type 4", "There is no drag to go on with."),
        (
            "select robot1\nkey escape\nkey ctrl+r",
            "No node is chosen. Choose one first: a click on a part, p and a click, or the list of nodes.",
        ),
        ("key ctrl+r", "No node is chosen. Choose one first: a click on a part, p and a click, or the list of nodes."),
        (
            "select robot1\nkey ctrl+r",
            "Turn: move the pointer or type degrees; x, y and z lock an axis; Enter or a click ends, Esc takes back.",
        ),
        ("gizmo-axes world", "Handles go by these axes: world."),
        ("do gizmo-axes-next", "Handles go by these axes: parent."),
        ("snap 5 0.1", "With Shift, drags of handles snap to 5 degrees and 0.1 units."),
        ("do gizmo", "The handles are hidden."),
        ("select robot1\nkey escape", "Nothing chosen: a drag moves the eye."),
        ("drag begin\nundo", "Finish the drag first, or press Escape to take it back."),
        ("key y\ncut", "Cannot edit the timeline while playing. Press y to stop or Shift+P to pause first."),
        ("key y\nstep 1", "Cannot step by ticks while playing. Press y to stop or Shift+P to pause first."),
    ] {
        let mut editor = editor_with(6);
        run(&mut editor, script);
        assert_eq!(editor.message_text(), sentence, "{script}");
    }
    let mut empty = editor_with(0);
    for (line, sentence) in [
        ("cut", "No keyframe is defined yet. Press n to create one."),
        ("duplicate", "No keyframe is defined yet. Press n to create one."),
        ("easing hold", "No keyframe is defined yet. Press n to create one."),
        ("reverse", "No keyframe is defined yet. Press n to create one."),
        ("delete", "The list is empty: there is no keyframe to delete."),
        ("scrub 1", "Fewer than 4 keyframes: nothing to play yet. Press n to add one."),
    ] {
        run(&mut empty, line);
        assert_eq!(empty.message_text(), sentence, "{line}");
    }
}

/// What is tested elsewhere: times that are waited, pictures, and undo itself.
const ELSEWHERE: [&str; 29] = [
    // `comparison.rs`.
    "compare-with",
    // `journal.rs` and `cli/journal.rs`.
    "scene",
    "keyframe-file",
    "imported",
    "imported-scene",
    "snapshot",
    "document",
    "ground",
    "wait",
    "screenshot",
    "undo",
    "redo",
    // `cli/control_nodes.rs`, and `scene_keys.rs` their commands.
    "put-control",
    "remove-control",
    "rename-control",
    "add-key",
    "set-key",
    "move-key",
    "delete-key",
    "lighting",
    "seconds",
    "save-scene",
    // `cli/script.rs`.
    "export-model",
    // Below.
    "add-keys",
    "move-keys",
    "delete-keys",
    "select-keys",
    "open",
    "save-as",
];

#[test]
fn many_keys_are_edited_by_a_line() {
    let mut editor = editor_with(0);
    let seconds =
        |editor: &Editor| -> Vec<f64> { editor.session().selected_keys.iter().map(|key| key.seconds).collect() };
    run(&mut editor, "put-control robot1\nadd-keys translation 1 robot1_control scale 2 \"robot1_control\" # two");
    assert_eq!((seconds(&editor), editor.message_text().as_str()), (vec![1.0, 2.0], "2 keys at 1.000 s."));
    run(&mut editor, "move-keys 0.5 translation 1 robot1_control scale 2 robot1_control");
    assert_eq!((seconds(&editor), editor.message_text().as_str()), (vec![1.5, 2.5], "Moved 2 keys by 0.500 s."));
    run(&mut editor, "select-keys scale 2.5 robot1_control");
    assert_eq!(seconds(&editor), [2.5]);
    run(&mut editor, "select-keys none");
    assert_eq!(seconds(&editor), [0.0; 0]);
    run(&mut editor, "delete-keys translation 1.5 robot1_control scale 2.5 robot1_control");
    assert_eq!(editor.message_text(), "Deleted 2 keys.");
    run(&mut editor, "undo\nundo\nundo\nundo");
    assert!(!editor.has_unsaved_scene());
}

#[test]
fn the_ends_of_the_list_are_a_command_away() {
    let mut editor = editor_with(4);
    for (line, expected) in [
        ("do keyframe-first", "[0] 1 2 3 | 0"),
        ("do keyframe-first", "[0] 1 2 3 | 0"),
        ("do Last keyframe", "0 1 2 [3] | 3"),
    ] {
        run(&mut editor, line);
        assert_eq!(shown(&editor), expected, "{line}");
    }
    let mut empty = editor_with(0);
    run(&mut empty, "do keyframe-last");
    assert_eq!(empty.message_text(), "No keyframe is defined yet. Press n to create one.");
}

#[test]
fn files_are_named_bare_or_in_double_quotes() {
    for (line, name) in [
        ("save-as my walk.json # note", "my walk.json"),
        ("save-as \"take #2.json\" # note", "take #2.json"),
        ("save-as say \"a#b\"", "say \"a"),
    ] {
        let mut editor = editor_with(2);
        let [command] = script_commands(line.as_bytes(), editor.scene()).unwrap().try_into().unwrap();
        let effects = apply(&mut editor, command);
        assert!(
            matches!(effects.as_slice(), [Effect::WriteKeyframes { path, .. }] if path == Path::new(name)),
            "{line}"
        );
    }
    let mut editor = editor_with(2);
    let [command] = script_commands(b"open walk.json", editor.scene()).unwrap().try_into().unwrap();
    let effects = apply(&mut editor, command);
    assert!(matches!(effects.as_slice(), [Effect::ReadKeyframes { path }] if path == Path::new("walk.json")));
}

#[test]
fn every_line_of_the_table_is_tested() {
    let tested: BTreeSet<&str> = EDITS
        .iter()
        .flat_map(|(before, line, ..)| [*before, *line])
        .chain(SESSIONS.iter().map(|(line, ..)| *line))
        .flat_map(str::lines)
        .filter_map(|line| line.split_whitespace().next())
        .chain(ELSEWHERE)
        .collect();
    let table = script_lines();
    let names: BTreeSet<&str> =
        table.lines().filter_map(|row| row.strip_prefix("| `")?.split([' ', '`']).next()).collect();
    assert!(names.len() > 30);
    // Scrubbing and steps have a test of their own, above.
    let missing: Vec<_> = names.difference(&tested).filter(|name| **name != "step").collect();
    assert!(missing.is_empty(), "{missing:?} have no test");
}

#[test]
fn sentences_name_the_keys_in_force() {
    use inbetween::editor::keymap::{Chord, Keymap};
    let mut keymap = Keymap::default();
    for (id, key) in [("keyframe-new", "k"), ("play-or-stop", "F5"), ("pause-or-resume", "F6")] {
        keymap.set(id, vec![Chord::parse(key).unwrap()]).unwrap();
    }
    keymap.set("keyframes-copy", vec![]).unwrap();
    let mut editor = editor_with(0);
    editor.set_keymap(keymap.clone());
    run(&mut editor, "scrub 1");
    assert_eq!(editor.message_text(), "Fewer than 4 keyframes: nothing to play yet. Press k to add one.");
    let mut editor = editor_with(6);
    editor.set_keymap(keymap);
    run(&mut editor, "paste");
    assert_eq!(editor.message_text(), "Nothing is copied yet: “Copy keyframes” copies the selected keyframes.");
    press(&mut editor, "y");
    run(&mut editor, "cut");
    assert_eq!(editor.message_text(), "Cannot edit the timeline while playing. Press F5 to stop or F6 to pause first.");
    press(&mut editor, "shift+p");
    assert_eq!(editor.message_text(), "Paused: k or u captures this pose, F6 goes on.");
}
