//! Files of other programs in and out, whole: what `export` writes is what `import` and `retarget` read.

use inbetween::keyframe::keyframes_from_json;
use inbetween::scene::{SceneGraph, built_in_scene, scene_from_json};
use serde_json::Value;

use crate::sandbox::{Sandbox, keyframe_file};

fn animated() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(6).to_string());
    sandbox.run(&["export", "a.json", "-o", "a.bvh", "--fps", "30"]).succeeds();
    sandbox
}

fn keyframes(sandbox: &Sandbox, name: &str, scene: &SceneGraph) -> usize {
    keyframes_from_json(sandbox.read(name).as_bytes(), scene).unwrap().keyframes.len()
}

#[test]
fn an_exported_animation_is_imported() {
    let sandbox = animated();
    let said = sandbox.run(&["import", "a.bvh", "-o", "scene.json", "--keyframes", "keyframes.json"]).succeeds();
    let lines: Vec<&str> = said.lines().collect();
    assert!(lines[0].starts_with("a.bvh: 22 joints, ") && lines[0].ends_with(" frames at 30 a second"), "{said}");
    assert_eq!(lines[lines.len() - 1], "a.bvh: the keyframes are in keyframes.json");
    let scene = scene_from_json(&sandbox.read("scene.json")).unwrap();
    assert_eq!(scene.name(), "a");
    // An eye and a ground of its own come before those of the file.
    let paths: Vec<&str> = scene.rbt_paths().take(4).collect();
    assert_eq!(paths, ["sky", "ground", "sky_2", "ground_2"]);
    assert!(scene.find_rbt("robot1/left_hip/left_knee").is_some());
    let few = keyframes(&sandbox, "keyframes.json", &scene);
    sandbox.run(&["import", "a.bvh", "-o", "scene.json", "--keyframes", "keyframes.json", "--every", "30"]).succeeds();
    let all = keyframes(&sandbox, "keyframes.json", &scene);
    assert!(few < all, "{few} of {all}");
    sandbox.run(&["check", "keyframes.json", "--scene", "scene.json"]).succeeds();
}

#[test]
fn a_motion_goes_onto_a_robot_by_a_map_that_can_be_edited() {
    let sandbox = animated();
    let line = ["retarget", "a.bvh", "--onto", "two-robots:robot2", "-o", "b.json"];
    sandbox.run(&[&line[..], &["--write-map", "map.json"]].concat()).succeeds();
    let map: Value = serde_json::from_str(&sandbox.read("map.json")).unwrap();
    assert_eq!(map["nodes"]["robot2/left_hip"], "robot1/left_hip");
    assert_eq!(map["feet"]["robot2/right_hip/right_knee"], "robot1/right_hip/right_knee");
    let scene = built_in_scene("two-robots").unwrap();
    assert!(keyframes(&sandbox, "b.json", &scene) >= 4);
    sandbox.write("map.json", map.to_string().replace("robot1", "robot2"));
    let said = sandbox.run(&[&line[..], &["--map", "map.json", "--json"]].concat()).succeeds();
    let said: Value = serde_json::from_str(&said).unwrap();
    assert_eq!((&said["output"], said["feet"].as_array().unwrap().len()), (&Value::from("b.json"), 2));
    assert!(said["feet"][0]["slide"].as_f64().unwrap() < 0.01, "{said}");
}

#[test]
fn a_gltf_model_is_imported_with_its_meshes_beside_the_scene() {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(6).to_string());
    sandbox.run(&["export", "a.json", "-o", "a.glb", "--tolerance", "1,0.1"]).succeeds();
    let said = sandbox.run(&["import", "a.glb", "-o", "scene.json", "--keyframes", "keyframes.json"]).succeeds();
    assert!(said.lines().next().is_some_and(|line| line.starts_with("a.glb: 119 nodes, 0 meshes")), "{said}");
    let scene = scene_from_json(&sandbox.read("scene.json")).unwrap();
    assert_eq!(keyframes(&sandbox, "keyframes.json", &scene), 6);
    // Without what this program says in it, the shapes are meshes.
    let text = sandbox.run(&["export", "a.json", "-o", "-", "--format", "gltf", "--tolerance", "1,0.1"]).stdout;
    sandbox.write("b.gltf", text.replace("\"inbetween\"", "\"other\""));
    let before = sandbox.names();
    sandbox.run(&["import", "b.gltf", "-o", "b.json"]).succeeds();
    let made: Vec<String> = sandbox.names().into_iter().filter(|name| !before.contains(name)).collect();
    assert_eq!(made, ["b.glb", "b.json"]);
    assert!(sandbox.read("b.json").contains("\"meshes\": \"b.glb\""));
    sandbox.run(&["nodes", "--scene", "b.json"]).succeeds();
    let whole = sandbox.run(&["import", "b.gltf", "-o", "-", "--quiet"]).succeeds();
    assert!(whole.contains("\"meshes\": \"data:model/gltf-binary;base64,"));
    // A file of another program that was there is kept.
    sandbox.write("c.glb", "mine");
    sandbox.run(&["import", "b.gltf", "-o", "c.json"]).succeeds();
    assert_eq!(sandbox.read("c.glb.bak"), "mine");
}

#[test]
fn files_outside_of_the_folder_of_a_model_are_not_read() {
    let sandbox = Sandbox::new();
    let model = |uri: &str| {
        format!(
            r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{}}], "buffers": [{{"byteLength": 4, "uri": "{uri}"}}]}}"#
        )
    };
    sandbox.write("beside.bin", "1234");
    sandbox.write("a.gltf", model("beside.bin"));
    sandbox.run(&["import", "a.gltf", "-o", "a.json"]).succeeds();
    for (uri, sentence) in [
        ("../secret.bin", "is no file in the folder of the glTF file or below it"),
        ("absent.bin", "a.gltf: /buffers/0: “absent.bin”: "),
    ] {
        sandbox.write("a.gltf", model(uri));
        let outcome = sandbox.run(&["import", "a.gltf", "-o", "b.json"]);
        assert_eq!(outcome.status, 1);
        assert!(outcome.stderr.contains(sentence), "{}", outcome.stderr);
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("/etc/hostname", sandbox.path("link.bin")).unwrap();
        sandbox.write("a.gltf", model("link.bin"));
        let outcome = sandbox.run(&["import", "a.gltf", "-o", "b.json"]);
        assert!(outcome.stderr.contains("“link.bin” is a link out of the folder of the model"), "{}", outcome.stderr);
    }
}
