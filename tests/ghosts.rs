//! Ghosts: the window's and a film's are the same, the whole list counts, and the farther are the fainter.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::Vec2;
use inbetween::editor::{Command, Editor, FileCommand, ViewCommand};
use inbetween::export::{Animation, Moment, MomentPose, Source, Stage, Viewpoint};
use inbetween::frame::{Frame, MOST_GHOSTS};
use inbetween::keyframe::KeyframeIndex;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use inbetween::view::frame_of_editor;

const SIZE_PX: Vec2 = Vec2::new(64.0, 48.0);

/// An editor that displays its first keyframe.
fn editor(ghosts: u8) -> Editor {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/animations/walk.json");
    let scene = built_in_scene(DEFAULT_SCENE).expect("the default scene is built in");
    let mut editor = Editor::new(Arc::new(scene), PathBuf::from(&path));
    editor.apply(Command::File(FileCommand::Import)).unwrap();
    editor.keyframes_read(&path, Ok(std::fs::read(&path).unwrap())).unwrap();
    editor.apply(Command::View(ViewCommand::SetGhosts(ghosts))).unwrap();
    editor
}

fn film_frame(editor: &Editor, shown: MomentPose) -> Frame {
    let animation: Animation = editor.animation().expect("there are keyframes");
    let source = Source { scene: editor.scene(), animation: Some(&animation), file: None };
    let viewpoint = Viewpoint::named(None, editor.scene()).unwrap();
    let stage = Stage::new(source, viewpoint, editor.session().ghosts, SIZE_PX);
    stage.frame(&Moment { shown, seconds: 0.0, turn: 0.0, number: 0 }).unwrap()
}

#[test]
fn a_films_ghosts_are_the_windows() {
    for ghosts in [0, 1, 3, MOST_GHOSTS] {
        let editor = editor(ghosts);
        let current = editor.document().keyframes.current().unwrap();
        let window = frame_of_editor(&editor, SIZE_PX).ghosts;
        assert_eq!(film_frame(&editor, MomentPose::Keyframe(current)).ghosts, window);
        assert_eq!(window.is_empty(), ghosts == 0);
    }
}

#[test]
fn between_two_keyframes_both_are_ghosts() {
    let editor = editor(1);
    let half = film_frame(&editor, MomentPose::KeyTime(1.5));
    let at = |index: usize| film_frame(&editor, MomentPose::Keyframe(KeyframeIndex::new(index))).items;
    // Key time 1.5 lies between keyframes 2 and 3 of the list.
    for (keyframe, tint) in [(2, half.ghosts[0].item.colour), (3, half.ghosts.last().unwrap().item.colour)] {
        let items = at(keyframe);
        let of_keyframe = half.ghosts.iter().filter(|ghost| ghost.item.colour == tint);
        assert!(of_keyframe.clone().count() > 0);
        for ghost in of_keyframe {
            let item = items.iter().find(|item| item.node == ghost.item.node).unwrap();
            assert_eq!(item.world_from_shape, ghost.item.world_from_shape);
        }
    }
}

#[test]
fn the_farther_the_fainter_and_the_ends_count() {
    let editor = editor(MOST_GHOSTS);
    let last = editor.document().keyframes.last().unwrap();
    let frame = film_frame(&editor, MomentPose::Keyframe(last));
    // Only earlier ones: as many opacities as keyframes, the farthest first.
    let mut opacities: Vec<f32> = frame.ghosts.iter().map(|ghost| ghost.opacity).collect();
    opacities.dedup();
    assert!(opacities.is_sorted() && opacities.len() == last.get().min(usize::from(MOST_GHOSTS)), "{opacities:?}");
    assert!(frame.ghosts.iter().all(|ghost| !ghost.item.is_ground()));
}
