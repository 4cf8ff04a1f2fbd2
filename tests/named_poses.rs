//! Poses with names: given and saved by script lines, and by clicks on their pictures.

mod common;

use std::sync::Arc;

use common::{apply, editor};
use inbetween::editor::{Command, Edit, Editor, Effect, FileCommand};
use inbetween::pose_file::{PoseFile, shipped_pose};
use inbetween::scene::{built_in_scene, scene_from_json, scene_to_json};
use inbetween::script::{print, script_commands};
use inbetween::words::Phrase;

fn run(editor: &mut Editor, script: &str) -> (String, Vec<Effect>) {
    let mut effects = Vec::new();
    for command in script_commands(script.as_bytes(), editor.scene()).unwrap() {
        effects = apply(editor, command);
    }
    (editor.message_text(), effects)
}

/// The robots that do not stand at rest.
fn posed(editor: &Editor) -> Vec<&str> {
    let scene = editor.scene();
    let differs = |robot: &&str| {
        let elbow = scene.find_rbt(&format!("{robot}/left_shoulder/left_elbow")).unwrap();
        editor.document().live_pose.get(elbow) != scene.rest_pose().get(elbow)
    };
    ["robot1", "robot2"].into_iter().filter(differs).collect()
}

#[track_caller]
fn check(chosen: &str, said: &str, robots: &[&str]) {
    let mut editor = editor();
    assert_eq!(run(&mut editor, &format!("{chosen}\npose apply wave")).0, said);
    assert_eq!(posed(&editor), robots);
    assert_eq!(editor.undo_label().map(Phrase::english), Some("pose from the library"));
    apply(&mut editor, Command::Undo);
    assert_eq!(posed(&editor), [""; 0]);
}

#[test]
fn a_pose_goes_to_the_body_of_what_is_chosen() {
    check("select none", "Gave wave to robot1.", &["robot1"]);
    check("select robot2", "Gave wave to robot2.", &["robot2"]);
    check("select robot2/left_hip/left_knee", "Gave wave to robot2.", &["robot2"]);
    check("select robot2/head\nselect-also robot2", "Gave wave to robot2.", &["robot2"]);
    check("select robot2/head\nselect-also robot1", "Gave wave to 2 nodes.", &["robot1", "robot2"]);
}

#[test]
fn what_does_not_fit_is_said() {
    let mut editor = editor();
    let nowhere = "The scene has no node of the pose \"wave\": choose the node that it is for.";
    assert_eq!(run(&mut editor, "select ground\npose apply wave").0, nowhere);
    // A robot without a left hand.
    let text = scene_to_json(editor.scene()).replace("\"name\": \"left_elbow\"", "\"name\": \"hook\"");
    let mut other = Editor::new(Arc::new(scene_from_json(&text).unwrap()), "animation.json".into());
    let said = "Gave wave in part: the scene has no node \"left_shoulder/left_elbow\" (1 node left out).";
    assert_eq!(run(&mut other, "pose apply wave").0, said);
    let mut without = Editor::new(Arc::new(built_in_scene("cylinder").unwrap()), "animation.json".into());
    assert_eq!(run(&mut without, "pose apply wave").0, nowhere);
}

#[test]
fn a_saved_pose_is_that_of_the_chosen_node_and_comes_back() {
    let mut editor = editor();
    let (_, effects) = run(&mut editor, "select robot1/left_shoulder\nrotate z 40\npose save my arm");
    let [Effect::WritePose { name, text }] = effects.as_slice() else { panic!("{effects:?}") };
    assert_eq!(name, "my arm");
    let pose = PoseFile::from_json(text.as_bytes()).unwrap();
    assert_eq!((pose.root.as_deref(), pose.nodes.len()), (Some("robot1/left_shoulder"), 2));

    // What is read is given by a command, which a journal writes with all that the file held.
    let command = editor.pose_read("my arm", Ok(text.clone().into_bytes())).unwrap();
    let line = print(&command, editor.scene()).unwrap();
    assert!(line.starts_with("pose-of "), "{line}");
    run(&mut editor, &format!("key r\n{line}"));
    let shoulder = editor.scene().find_rbt("robot1/left_shoulder").unwrap();
    assert!(editor.document().live_pose.get(shoulder).rotation.z > 0.3);

    // Of the whole scene, but for its camera.
    let (_, effects) = run(&mut editor, "select none\npose save folder/all.json");
    let [Effect::WritePose { text, .. }] = effects.as_slice() else { panic!("{effects:?}") };
    let all = PoseFile::from_json(text.as_bytes()).unwrap();
    assert_eq!((all.name.as_str(), all.root.as_deref(), all.nodes.len()), ("all", None, 21));
}

#[test]
fn names_are_checked_and_shipped_ones_are_kept() {
    let mut editor = editor();
    for (line, said) in [
        ("pose save wave", "A pose \"wave\" comes with the program: choose another name."),
        ("pose save Step Left", "A pose \"Step Left\" comes with the program: choose another name."),
        ("pose save a:b", "\"a:b\" is no name of a pose"),
    ] {
        let (message, effects) = run(&mut editor, line);
        assert!(message.starts_with(said) && effects.is_empty(), "{message}");
    }
    let wave = Command::Edit(Edit::Pose(Arc::new(shipped_pose("WAVE").unwrap().clone())));
    assert_eq!(print(&wave, editor.scene()).as_deref(), Some("pose apply wave"));
    let own = Command::File(FileCommand::ApplyPose("a # b".to_owned()));
    assert_eq!(print(&own, editor.scene()).as_deref(), Some("pose apply \"a # b\""));
    let broken = editor.pose_read("mine", Ok(b"{".to_vec())).unwrap_err().message().to_string();
    assert!(broken.starts_with("mine: line 1 column 1"), "{broken}");
}
