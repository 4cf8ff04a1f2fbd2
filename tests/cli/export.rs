use serde_json::Value;

use crate::places::{run, sandbox};

#[test]
fn a_scene_and_its_animation_are_written_in_the_format_of_the_ending() {
    let sandbox = sandbox();
    let said = sandbox.run(&["export", "a.json", "-o", "a.glb", "--tolerance", "1,0.1"]).succeeds();
    let lines: Vec<&str> = said.lines().collect();
    assert!(lines[0].starts_with("a.json: 119 nodes, ") && lines[0].ends_with(" s"), "{said}");
    assert!(lines[1].starts_with("a.json: rotations in the world are within "), "{said}");
    assert!(lines[2].starts_with("a.json: positions in the world are within "), "{said}");
    let binary = std::fs::read(sandbox.path("a.glb")).unwrap();
    assert!(binary.starts_with(b"glTF"));
    let standard = run(&sandbox, &["export", "a.json", "-o", "-", "--format", "glb", "--tolerance", "1,0.1"], None);
    assert_eq!((standard.stdout, &*standard.stderr), (binary, &*said), "the report does not stand in the data");

    let arguments = ["export", "--scene", "scene.json", "-o", "still.GLTF", "--no-meshes", "--json"];
    let said: Value = serde_json::from_str(&sandbox.run(&arguments).succeeds()).unwrap();
    let file: Value = sandbox.json("still.GLTF");
    assert_eq!((&said["format"], &said["output"]), (&"gltf".into(), &"still.GLTF".into()));
    assert_eq!(said["nodes"], file["nodes"].as_array().unwrap().len());
    assert_eq!(said["exactness"], file["asset"]["extras"]["inbetween"]["exactness"]);
    assert_eq!(said["notes"][3], "17 shapes are left out");
    assert_eq!(file["animations"][0]["name"], "orbits");
}

#[test]
fn what_cannot_be_exported_is_not_written() {
    let sandbox = sandbox();
    sandbox.write("short.txt", "1 22\n".to_owned() + &"0 0 0 1 0 0 0\n".repeat(22));
    for (arguments, status, sentence) in [
        (&["a.json", "-o", "a.obj"][..], 2, "the ending of OUT names the format: .glb, .gltf or .bvh"),
        (&["a.json", "-o", "a.gltf", "--format", "glb"], 2, "--format glb"),
        (&["a.json", "-o", "a.glb", "--fps", "30", "--tolerance", "1,1"], 2, "--tolerance"),
        (&["a.json", "-o", "a.glb", "--tolerance", "0,1"], 2, "expected DEGREES,UNITS"),
        (&["a.json", "-o", "a.bvh", "--no-meshes"], 2, "--no-meshes is for glTF"),
        (&["a.json", "-o", "a.bvh", "--curves", "linear"], 2, "--curves is for glTF"),
        (&["a.json", "-o", "-"], 2, "the ending of OUT names the format"),
        (&["short.txt", "-o", "a.glb"], 1, "short.txt: "),
        (&["none.json", "-o", "a.glb"], 1, "none.json: "),
    ] {
        let before = sandbox.names();
        let outcome = sandbox.run(&[&["export"], arguments].concat());
        assert_eq!((outcome.status, &*outcome.stdout), (status, ""), "{arguments:?}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(sentence), "{arguments:?}: {}", outcome.stderr);
        assert_eq!(sandbox.names(), before, "{arguments:?}");
    }
}
