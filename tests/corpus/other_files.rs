//! What is said of files that other programs change.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use inbetween::animation_diff::{Version, keyframe_differences, scene_differences};
use inbetween::editor::{Command, Edit, Editor, FileCommand, PlaybackCommand, Written};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{Easing, Keyframe, KeyframeList};
use inbetween::pose::RbtIndex;
use inbetween::rbt::Rbt;
use inbetween::scene::{DEFAULT_SCENE, SceneGraph, built_in_scene, scene_to_json};
use inbetween::words::{Message, texts};

/// All of it, a sentence a line.
pub fn said() -> String {
    let mut text = editor();
    let mut line = |name: &str, messages: &[Message]| {
        for message in messages {
            let _ = writeln!(text, "{name}\t{message}");
        }
    };
    let scene = built_in_scene(DEFAULT_SCENE).expect("it is built in");
    let (ours, theirs) = (list(&scene, 6, 0.0), list(&scene, 12, 0.5));
    line(
        "lists",
        &differences(&scene, (&theirs, Interpolation::CatmullRom, 500), (&ours, Interpolation::Linear, 2000)),
    );
    line(
        "long lists",
        &differences(
            &scene,
            (&theirs, Interpolation::Linear, 500),
            (&list(&scene, 12, 0.0), Interpolation::Linear, 500),
        ),
    );
    line("same lists", &differences(&scene, (&ours, Interpolation::Linear, 500), (&ours, Interpolation::Linear, 500)));
    let eased = ours.as_slice().iter().map(|keyframe| Keyframe { easing: Easing::Hold, ..keyframe.clone() });
    let eased = KeyframeList::new(eased.collect());
    line(
        "eased lists",
        &differences(&scene, (&eased, Interpolation::Linear, 500), (&ours, Interpolation::Linear, 500)),
    );
    let with_control = scene.with_control_above(scene.rbt_node(RbtIndex::new(2))).expect("there is room").0;
    line("scenes", &scene_differences(&with_control, &scene));
    line("scenes", &scene_differences(&scene, &with_control));
    let control = with_control.find("robot1_control").expect("it was put there");
    let key = inbetween::scene::KeyValue::Translation(glam::Vec3::X);
    let with_key = with_control.with_key(control, 1.0, key).expect("it can have one");
    line("scenes", &scene_differences(&with_key, &with_control));
    let narrow = scene_to_json(&scene).replace("\"vertical_fov_degrees\": ", "\"vertical_fov_degrees\": 1");
    let narrow = inbetween::scene::scene_from_json(&narrow).expect("it is a scene");
    line("scenes", &scene_differences(&narrow, &scene));
    let file = || "walk.json";
    line(
        "window and script",
        &[
            texts::FILE_CHANGED_REFUSED.into(),
            texts::FILE_APPEARED_REFUSED.into(),
            texts::changed_offer(file()),
            texts::changed_offer_unsaved(file()),
            texts::CHANGED_RELOAD.into(),
            texts::CHANGED_COMPARE.into(),
            texts::CHANGED_LATER.into(),
            texts::overwrite_changed(file()),
            texts::overwrite_appeared(file()),
            texts::overwrite_holds_keyframes(file(), texts::count_keyframes(2)),
            texts::OVERWRITE_EXPLAINED.into(),
            texts::OVERWRITE_SAVE_AS.into(),
            texts::OVERWRITE_OVERWRITE.into(),
            texts::differs_unreadable(texts::DIFFERS_HOLDS_KEYS),
        ],
    );
    text
}

/// What the editor says of files that were written and scenes that were read again.
fn editor() -> String {
    let scene = built_in_scene(DEFAULT_SCENE).expect("it is built in");
    let other = scene_to_json(&built_in_scene("orbits").expect("it is built in"));
    let same = scene_to_json(&scene);
    let mut editor = Editor::new(Arc::new(scene), PathBuf::from("walk.json"));
    let mut text = String::new();
    let _ = editor.apply(Command::Edit(Edit::CreateKeyframe));
    for other_links in [1, 2] {
        let _ = editor.keyframes_written(Path::new("walk.json"), Ok(Written { other_links, ..Written::default() }));
        let _ = writeln!(text, "{other_links} links\t{}", editor.message_text());
    }
    let _ = editor.apply(Command::File(FileCommand::ReloadScene));
    let _ = writeln!(text, "reload\t{}", editor.message_text());
    for bytes in
        [Ok(same.into_bytes()), Ok(other.into_bytes()), Ok(b"{\xff".to_vec()), Err(texts::STORAGE_NOT_FOUND.into())]
    {
        let _ = editor.scene_read(Path::new("scene.json"), bytes);
        let _ = writeln!(text, "scene\t{}", editor.message_text());
    }
    let with_control =
        editor.scene().with_control_above(editor.scene().rbt_node(RbtIndex::new(2))).expect("there is room").0;
    let _ = editor.scene_read(Path::new("scene.json"), Ok(scene_to_json(&with_control).into_bytes()));
    let keyframes = std::iter::repeat_n(Command::Edit(Edit::CreateKeyframe), 4);
    let play = [Command::Playback(PlaybackCommand::PlayOrStop), Command::File(FileCommand::ReloadScene)];
    for command in std::iter::once(Command::Undo).chain(keyframes).chain(play) {
        let _ = editor.apply(command);
        let _ = writeln!(text, "then\t{}", editor.message_text());
    }
    text
}

/// Keyframes in which a node is so far from its rest.
fn list(scene: &SceneGraph, count: usize, by: f32) -> KeyframeList {
    let mut pose = scene.rest_pose().clone();
    let rest = pose.get(RbtIndex::new(2));
    pose.set(RbtIndex::new(2), Rbt { translation: rest.translation + glam::Vec3::X * by, ..rest });
    KeyframeList::new(vec![Keyframe::new(pose); count])
}

type Timed<'a> = (&'a KeyframeList, Interpolation, u32);

fn differences(scene: &SceneGraph, theirs: Timed<'_>, ours: Timed<'_>) -> Vec<Message> {
    let [theirs, ours] = [theirs, ours].map(|(keyframes, interpolation, ms_between_keyframes)| Version {
        keyframes,
        interpolation,
        ms_between_keyframes,
    });
    keyframe_differences(scene, theirs, ours)
}
