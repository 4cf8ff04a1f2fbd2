//! The files of scenes with meshes.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use inbetween::editor::{Editor, FileAccess};
use inbetween::files::scene::{editor_of, load, load_file, save};
use inbetween::files::{known_at_start, read_known};
use inbetween::journal::play_alone;
use inbetween::model::{MeshLibrary, TriangleMesh};
use inbetween::scene::{SceneGraph, scene_from_json, scene_to_json, scene_to_json_beside};
use inbetween::script::{Disk, DiskStop, Restore, Runner, imported_line, parse};
use inbetween::storage::{KnownFiles, OutsideChange};

use super::models::{ball, bar, bent, coloured, cube, glb, scene, squares, text, text_within};

const ONE_CUBE: &str = r#"[{"name": "sky"}, {"name": "cube", "shape": {"mesh": {"name": "cube"}}}]"#;

fn models() -> Vec<TriangleMesh> {
    let mut textured = cube("cube");
    textured.material.texture = Some(squares());
    vec![textured, coloured(ball("ball", 6)), bar("bar", 4, 6)]
}

fn all() -> SceneGraph {
    let nodes = format!(
        r##"[{{"name": "sky"}}, {}, {{"name": "b", "shape": {{"mesh": {{"name": "ball"}}}}, "scale": 2, "colour_keys": [[0, "#102030"]]}},
        {{"name": "c", "shape": {{"mesh": {{"name": "cube"}}}}}}]"##,
        bent("arm", 0.0, 30.0)
    );
    scene(&models(), &nodes)
}

#[test]
fn a_scene_reads_back_with_its_meshes() {
    let scene = all();
    let text = scene_to_json(&scene);
    assert!(text.contains("\"version\": 3,") && text.contains("data:model/gltf-binary;base64,"));
    assert!(text.len() as u64 <= scene.file_bytes_at_most());
    let again = scene_from_json(&text).unwrap();
    assert!(again == scene && scene_to_json(&again) == text);
    let library = MeshLibrary::from_glb(glb(&models())).unwrap();
    assert_eq!(again.meshes().map(|meshes| &meshes.meshes), Some(&library.meshes));
}

#[test]
fn meshes_stand_beside_a_saved_scene() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let scene = all();
    assert_eq!(save(&scene, &at("house.json")).unwrap(), [] as [&Path; 0]);
    assert_eq!(fs::read_to_string(at("house.json")).unwrap(), scene_to_json_beside(&scene, "house.glb"));
    assert!(load_file(&at("house.json")).unwrap() == scene);
    let before = fs::metadata(at("house.glb")).unwrap().modified().unwrap();
    assert!(save(&scene, &at("house.json")).unwrap().is_empty());
    assert_eq!(fs::metadata(at("house.glb")).unwrap().modified().unwrap(), before, "what is the same is not written");
    // Another's file is not lost.
    fs::write(at("tower.glb"), "mine").unwrap();
    assert_eq!(save(&scene, &at("tower.json")).unwrap(), [at("tower.glb.bak")]);
    assert_eq!(fs::read_to_string(at("tower.glb.bak")).unwrap(), "mine");
    assert!(load_file(&at("tower.json")).unwrap() == scene);
    // A scene that would be its own file of meshes has them within.
    save(&scene, &at("all.glb")).unwrap();
    assert!(load_file(&at("all.glb")).unwrap() == scene);
}

#[test]
fn what_is_wrong_with_meshes_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let of_file = |name: &str| {
        fs::write(at("scene.json"), text(name, ONE_CUBE)).unwrap();
        load(Some(&at("scene.json"))).map(|_| ()).unwrap_err().to_string()
    };
    assert!(
        of_file("lost.glb").ends_with(r#"scene.json: meshes: "lost.glb": there is no such file or folder"#),
        "{}",
        of_file("lost.glb")
    );
    fs::write(at("broken.glb"), &glb(&models())[..40]).unwrap();
    assert!(of_file("broken.glb").contains("meshes: \"broken.glb\": "));
    for outside in ["../a.glb", "/a.glb", "b/a.glb", "C:a.glb", "", ".."] {
        let said = of_file(outside);
        assert!(said.contains("expected the name of a file in the folder of the scene"), "{said}");
    }
    #[cfg(unix)]
    {
        let elsewhere = tempfile::tempdir().unwrap();
        fs::write(elsewhere.path().join("a.glb"), glb(&models())).unwrap();
        std::os::unix::fs::symlink(elsewhere.path().join("a.glb"), at("link.glb")).unwrap();
        assert!(of_file("link.glb").ends_with("a link out of the scene's folder"), "{}", of_file("link.glb"));
    }
    let refused = |text: &str| scene_from_json(text).map(|_| ()).unwrap_err().to_string();
    let within = |nodes: &str| refused(&text_within(&models(), nodes));
    let no_mesh = within(&ONE_CUBE.replace(r#""name": "cube"}}"#, r#""name": "nothing"}}"#));
    assert_eq!(no_mesh, r#"node "cube": no mesh of the scene is called "nothing""#);
    let arm = format!(r#"[{{"name": "sky"}}, {}]"#, bent("arm", 0.0, 30.0));
    let wrong_joint = within(&arm.replace(r#""arm/upper"]"#, r#""arm/skin"]"#));
    assert_eq!(
        wrong_joint,
        r#"node "arm/skin": joint "arm/skin" is the path of neither an RBT node nor a control node"#
    );
    let too_few = within(&arm.replace(r#", "arm/upper"]"#, "]"));
    assert_eq!(too_few, r#"node "arm/skin": joints: 1, and the skin of its mesh has 2"#);
    let old = refused(&text_within(&models(), ONE_CUBE).replace("\"version\": 3", "\"version\": 2"));
    assert_eq!(old, "meshes needs version 3, and the file says an older one");
    let apart = refused(&text("house.glb", ONE_CUBE));
    assert!(apart.contains("another file"), "{apart}");
    assert!(refused(&text("data:model/gltf-binary;base64,****", ONE_CUBE)).starts_with("meshes: "));
}

#[test]
fn control_nodes_come_and_go_under_a_skin() {
    let scene = all();
    let skin = |scene: &SceneGraph| {
        let (_, skin) = scene.nodes_with_ids().find_map(|(id, _)| Some((id, scene.skin(id)?))).unwrap();
        skin.joints().iter().map(|&joint| scene.node(joint).path.clone()).collect::<Vec<_>>()
    };
    let (with, path) = scene.with_control_above(scene.find("arm").unwrap()).unwrap();
    assert_eq!(skin(&with), ["arm", "arm/upper"]);
    assert!(with.meshes().is_some());
    let without = with.without_control(with.find(&path).unwrap()).unwrap();
    assert!(without == scene && skin(&without) == ["arm", "arm/upper"]);
    let control = r#"[{"name": "sky"}, {"name": "arm", "control": {}, "children": [{"name": "upper"},
        {"name": "skin", "shape": {"mesh": {"name": "bar", "joints": ["arm", "arm/upper"]}}}]}]"#;
    let moved = super::models::scene(&models(), control);
    let refused = moved.without_control(moved.find("arm").unwrap()).unwrap_err().to_string();
    assert_eq!(refused, r#"node "arm" moves the skin of "arm/skin", so it stays"#);
}

/// Runs a script on a scene that was read from a file.
#[track_caller]
fn run(file: &Path, script: &str) -> Editor {
    let scene = load(Some(file)).unwrap();
    let lines = parse(script.as_bytes(), &scene).unwrap();
    let editor = editor_of(scene, Some(file), file.with_file_name("animation.json"));
    let disk = Runner::new(Disk::new(editor, None)).run(&lines, |_| Ok::<_, DiskStop>(())).unwrap();
    let (editor, refused) = disk.finish();
    assert!(refused.is_empty(), "{refused:?}");
    editor
}

#[test]
fn a_scene_that_is_saved_elsewhere_brings_its_meshes() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let scene = all();
    save(&scene, &at("house.json")).unwrap();
    fs::create_dir(at("other")).unwrap();
    fs::write(at("other/tower.glb"), "mine").unwrap();
    let tower = at("other/tower.json");
    let said = run(&at("house.json"), &format!("save-scene {}\n", tower.display())).message_text();
    assert!(said.contains("tower.json") && said.contains("tower.glb.bak"), "{said}");
    assert!(load_file(&tower).unwrap() == scene);
    assert_eq!(fs::read(at("other/tower.glb")).unwrap(), fs::read(at("house.glb")).unwrap());
    assert_eq!(fs::read_to_string(at("other/tower.glb.bak")).unwrap(), "mine");
    // Again to where it is now: the meshes are its own.
    let editor = run(&at("house.json"), &format!("save-scene {}\n", at("house.json").display()));
    assert!(**editor.scene() == scene && !at("house.glb.bak").exists());
}

#[test]
fn a_file_of_meshes_is_known_as_long_as_it_holds_those_of_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let (house, meshes) = (at("house.json"), at("house.glb"));
    save(&all(), &house).unwrap();
    let begin = |file: &Path| known_at_start(&editor_of(load(Some(file)).unwrap(), Some(file), at("a.json")));
    let mut known = begin(&house);
    assert!(known.knows(&meshes) && known.change(&meshes).is_none() && known.suspect(&meshes).is_none());
    // Another program changes it, and the scene is read again.
    let other = [cube("cube"), coloured(ball("ball", 5)), bar("bar", 4, 6)];
    fs::write(&meshes, MeshLibrary::to_glb(&other)).unwrap();
    assert_eq!(known.change(&meshes), Some(OutsideChange::Changed));
    read_known(&mut known, FileAccess::SceneRead, &house).unwrap();
    assert_eq!(known.change(&meshes), Some(OutsideChange::Changed), "nobody took it in");
    read_known(&mut known, FileAccess::SceneRead, &house).unwrap();
    known.took_in();
    assert!(known.change(&meshes).is_none());
    // A file of that name which is not the scene's is not known, so that it is copied before it is written over.
    fs::rename(&meshes, at("other.glb")).unwrap();
    fs::write(&house, fs::read_to_string(&house).unwrap().replace("house.glb", "other.glb")).unwrap();
    fs::write(&meshes, "mine").unwrap();
    assert!(!begin(&house).knows(&meshes));
    run(&house, &format!("save-scene {}\n", house.display()));
    assert_eq!(fs::read_to_string(at("house.glb.bak")).unwrap(), "mine");
}

#[test]
fn journals_hold_the_meshes_of_their_scene() {
    let folder = tempfile::tempdir().unwrap();
    let house = folder.path().join("house.json");
    let scene = Arc::new(all());
    save(&scene, &house).unwrap();
    let begun = Restore::Scene { scene: Arc::clone(&scene), path: Some(house.clone()) }.line().unwrap();
    let (editor, played) = play_alone(format!("{begun}\n").as_bytes());
    assert!(played.damage.is_none() && **editor.scene() == *scene);
    assert!(!editor.has_unsaved_scene());
    // What is read again is written down whole.
    let bytes = read_known(&mut KnownFiles::default(), FileAccess::SceneRead, &house).unwrap();
    let read = imported_line(true, &house, &bytes).unwrap();
    fs::remove_file(folder.path().join("house.glb")).unwrap();
    let (editor, played) = play_alone(format!("{begun}\n{read}\n").as_bytes());
    assert!(played.damage.is_none() && **editor.scene() == *scene, "{}", editor.message_text());
    let snapshot = Restore::Snapshot(Box::new(editor.snapshot())).line().unwrap();
    let (editor, played) = play_alone(format!("{snapshot}\n").as_bytes());
    assert!(played.damage.is_none() && **editor.scene() == *scene);
}
