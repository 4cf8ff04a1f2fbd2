//! Meshes, skins and materials as shapes.

use glam::Vec3;
use inbetween::interchange::gltf_in::{Options, imported};
use inbetween::scene::{NodeKind, PlacedShape, SceneGraph, Shape};
use inbetween::words::Message;
use serde_json::json;

use super::importing::{good, import_file, in_world, options};
use super::make::{Model, png, skinned};

/// A shape by its path.
fn shape<'a>(scene: &'a SceneGraph, path: &str) -> &'a PlacedShape {
    match &scene.node(scene.find(path).expect(path)).kind {
        NodeKind::Shape(placed) => placed,
        other => panic!("{path}: {other:?}"),
    }
}

/// The corners of a shape's triangles in the world, and the sum of its triangles' volumes to the middle: above 0 if they face outwards.
fn in_space(scene: &SceneGraph, path: &str) -> (Vec<Vec3>, f32) {
    let Shape::Mesh(mesh) = &shape(scene, path).shape else { panic!("{path} is no mesh") };
    let middle = in_world(scene, path, Vec3::ZERO);
    let triangles: Vec<[Vec3; 3]> =
        mesh.mesh().triangles().map(|corners| corners.map(|corner| in_world(scene, path, corner))).collect();
    let volume = triangles.iter().map(|[a, b, c]| (*a - middle).dot((*b - middle).cross(*c - middle))).sum();
    (triangles.into_flattened(), volume)
}

/// The least and the largest of each coordinate.
fn extent(points: &[Vec3]) -> [Vec3; 2] {
    [points.iter().copied().reduce(Vec3::min).unwrap(), points.iter().copied().reduce(Vec3::max).unwrap()]
}

#[test]
fn a_mesh_is_a_shape_below_its_node_about_its_own_middle() {
    let mut model = Model::new();
    let mesh = model.block("block", [1.0, 2.0, 3.0]);
    model.json["materials"] = json!([{ "pbrMetallicRoughness": { "baseColorFactor": [1, 0, 0, 1] } }]);
    model.json["meshes"][mesh]["primitives"][0]["material"] = json!(0);
    let again = model.json["meshes"][mesh]["primitives"][0].clone();
    model.json["meshes"][mesh]["primitives"].as_array_mut().unwrap().push(again);
    model.root(json!({ "name": "a", "mesh": mesh, "translation": [0, 1, 0] }));
    model.root(json!({ "name": "b", "mesh": mesh, "translation": [2, 1, 0] }));
    let scene = good(&model).scene;
    let placed = shape(&scene, "a/block");
    assert_eq!((placed.colour.to_hex().as_str(), placed.shape.half_extents()), ("#ff0000", Vec3::new(0.5, 1.0, 1.5)));
    assert_eq!(extent(&in_space(&scene, "b/block_2").0), [Vec3::new(1.5, 0.0, -1.5), Vec3::new(2.5, 2.0, 1.5)]);
    // Both nodes show the same meshes.
    let names: Vec<&str> = scene.meshes().unwrap().meshes.iter().map(|mesh| mesh.name.as_str()).collect();
    assert_eq!(names, ["block", "block_2"]);
}

#[test]
fn a_mesh_beside_its_origin_is_moved_there_and_placed() {
    let mut model = Model::new();
    let positions = model.floats("VEC3", &[10.0, 0.0, 0.0, 12.0, 0.0, 0.0, 10.0, 4.0, 0.0]);
    model.push("meshes", json!({ "primitives": [{ "attributes": { "POSITION": positions } }] }));
    model.root(json!({ "name": "a", "mesh": 0 }));
    let scene = good(&model).scene;
    let placed = shape(&scene, "a/mesh");
    assert_eq!(
        (placed.placement().translation, placed.shape.half_extents()),
        (Vec3::new(11.0, 2.0, 0.0), Vec3::new(1.0, 2.0, 0.0))
    );
    assert_eq!(in_space(&scene, "a/mesh").0[1], Vec3::new(12.0, 0.0, 0.0));
}

#[test]
fn a_mirror_turns_triangles_around() {
    for scale in [[-1.0, 1.0, 1.0], [-1.0, -2.0, 1.0], [1.0, -1.0, 1.0], [-1.0, -1.0, -1.0]] {
        let mut model = Model::new();
        let mesh = model.block("block", [1.0, 2.0, 3.0]);
        let inner = model.push("nodes", json!({ "name": "inner", "mesh": mesh, "translation": [2, 0, 0] }));
        model.root(json!({ "name": "outer", "scale": scale, "children": [inner] }));
        let scene = good(&model).scene;
        let (points, volume) = in_space(&scene, "outer/inner/block");
        assert!(volume > 0.0, "{scale:?}");
        let middle = Vec3::new(2.0 * scale[0], 0.0, 0.0);
        let half = Vec3::new(0.5, 1.0, 1.5) * Vec3::from(scale).abs();
        let [least, most] = extent(&points);
        assert!(
            least.distance(middle - half) < 1e-5 && most.distance(middle + half) < 1e-5,
            "{scale:?}: {least} {most}"
        );
    }
}

#[test]
fn a_skewed_matrix_at_a_leaf_is_in_the_mesh() {
    let mut model = Model::new();
    let mesh = model.block("block", [2.0, 2.0, 2.0]);
    // y goes along x too, and z is turned around.
    let matrix = [1.0, 0.0, 0.0, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 5.0, 1.0, 0.0, 1.0];
    model.root(json!({ "name": "a", "mesh": mesh, "matrix": matrix }));
    let scene = good(&model).scene;
    let (points, volume) = in_space(&scene, "a/block");
    assert!(volume > 0.0);
    assert_eq!(extent(&points), [Vec3::new(3.5, 0.0, -1.0), Vec3::new(6.5, 2.0, 1.0)]);
    // A scale of nothing flattens.
    model.json["nodes"][0]["matrix"] = json!([1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    let scene = good(&model).scene;
    assert_eq!(extent(&in_space(&scene, "a/block").0), [Vec3::new(-1.0, 0.0, -1.0), Vec3::new(1.0, 0.0, 1.0)]);
}

/// Where the joints of a shape put the corners of its mesh at rest.
fn moved_by_joints(scene: &SceneGraph, path: &str) -> Vec<Vec3> {
    let Shape::Mesh(mesh) = &shape(scene, path).shape else { panic!("{path} is no mesh") };
    let skin = mesh.mesh().skin.as_ref().expect("it has a skin");
    let world = scene.world_from_nodes(scene.rest_pose(), 0.0);
    let matrices: Vec<_> = mesh
        .joints()
        .iter()
        .zip(&skin.joint_from_shape)
        .map(|(joint, joint_from_shape)| world[joint.get()].get() * *joint_from_shape)
        .collect();
    let moved = mesh.mesh().positions.iter().zip(skin.joints.iter().zip(&skin.weights));
    moved
        .map(|(position, (joints, weights))| {
            let parts = joints.iter().zip(weights);
            parts.map(|(joint, weight)| matrices[usize::from(*joint)].transform_point3(*position) * *weight).sum()
        })
        .collect()
}

#[test]
fn a_skin_is_moved_by_its_joints_and_not_by_its_node() {
    let mut model = skinned([1.0, 0.0, 0.0, 0.0]);
    model.json["nodes"][0]["translation"] = json!([7, 7, 7]);
    let scene = good(&model).scene;
    let Shape::Mesh(mesh) = &shape(&scene, "body/arm").shape else { panic!("it is a mesh") };
    let joints: Vec<&str> = mesh.joints().iter().map(|&joint| scene.node(joint).path.as_str()).collect();
    assert_eq!(joints, ["lower", "lower/upper"]);
    let [least, most] = extent(&moved_by_joints(&scene, "body/arm"));
    assert!(least.distance(Vec3::new(-0.2, 0.1, -0.2)) < 1e-5 && most.distance(Vec3::new(0.2, 1.9, 0.2)) < 1e-5);
    // A joint that is scaled and mirrored scales and mirrors what it moves.
    model.json["nodes"][2]["scale"] = json!([-2, 1, 1]);
    model.json["nodes"][2]["rotation"] = json!([0, 0, 0.6, 0.8]);
    let scene = good(&model).scene;
    let Shape::Mesh(mesh) = &shape(&scene, "body/arm").shape else { panic!("it is a mesh") };
    assert_eq!(scene.node(mesh.joints()[1]).path, "lower/upper/scale");
    let turn = glam::Quat::from_xyzw(0.0, 0.0, 0.6, 0.8);
    let corner = Vec3::Y + turn * (Vec3::new(-2.0, 1.0, 1.0) * Vec3::new(0.2, 0.9, 0.2));
    let moved = moved_by_joints(&scene, "body/arm");
    assert!(moved.iter().any(|point| point.distance(corner) < 1e-5), "{corner}: {moved:?}");
}

#[test]
fn a_skin_with_joints_of_another_scene_stays() {
    let mut model = skinned([1.0, 0.0, 0.0, 0.0]);
    model.json["scenes"] = json!([{ "nodes": [0] }, { "nodes": [1] }]);
    let made = good(&model);
    let sentence = "the skin of “body” has joints outside of this scene; its mesh stays in the bind pose";
    assert!(made.report.iter().any(|line| line == sentence), "{:?}", made.report);
    assert!(in_space(&made.scene, "body/arm").0.len() >= 72);
}

#[test]
fn a_model_without_meshes_has_bones() {
    let mut model = Model::new();
    let hand = model.push("nodes", json!({ "name": "hand", "translation": [0, 1, 0] }));
    model.root(json!({ "name": "arm", "children": [hand] }));
    let scene = good(&model).scene;
    assert!(matches!(shape(&scene, "arm/bone").shape, Shape::Capsule(_)));
    assert!(matches!(shape(&scene, "arm/hand/bone").shape, Shape::Sphere(_)));
    assert_eq!(shape(&scene, "arm/bone").placement().translation, Vec3::new(0.0, 0.5, 0.0));
    assert!(good(&skinned([1.0, 0.0, 0.0, 0.0])).scene.find("lower/bone").is_none());
}

#[test]
fn files_beside_a_model_are_read_by_their_names() {
    let mut model = Model::new();
    let mesh = model.block("block", [1.0, 1.0, 1.0]);
    let coordinates = model.floats("VEC2", &[0.5; 16]);
    model.push("images", json!({ "uri": "maps/my%20map.png" }));
    model.push("textures", json!({ "source": 0 }));
    model.push("materials", json!({ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 } } }));
    let primitive = &mut model.json["meshes"][mesh]["primitives"][0];
    primitive["material"] = json!(0);
    primitive["attributes"]["TEXCOORD_0"] = json!(coordinates);
    model.root(json!({ "name": "a", "mesh": mesh }));
    let mut json = model.json.clone();
    json["buffers"] = json!([{ "byteLength": model.bytes.len(), "uri": "data.bin" }]);
    let mut asked = Vec::new();
    let mut read = |name: &str| {
        asked.push(name.to_owned());
        Ok::<_, Message>(if name == "data.bin" { model.bytes.clone() } else { png([[0, 255, 0, 255]; 4]) })
    };
    let scene = imported(json.to_string().as_bytes(), &mut read, &Options::default()).unwrap().scene;
    assert_eq!(asked, ["data.bin", "maps/my map.png"]);
    let Shape::Mesh(mesh) = &shape(&scene, "a/block").shape else { panic!("it is a mesh") };
    assert_eq!(mesh.mesh().material.texture.as_ref().expect("it was read").size_px, [2, 2]);
    for uri in ["../data.bin", "/data.bin", "file:///data.bin"] {
        json["buffers"][0]["uri"] = json!(uri);
        let refused = imported(json.to_string().as_bytes(), &mut |_| panic!("{uri}"), &Options::default());
        let sentence = format!("/buffers/0: {uri:?} is no file in the folder of the glTF file or below it");
        assert_eq!(refused.unwrap_err().to_string(), sentence);
    }
}

#[test]
fn a_text_is_read_as_a_binary_file_is() {
    let model = skinned([1.0, 0.0, 0.0, 0.0]);
    let [text, binary] = [model.text(), model.glb()].map(|file| import_file(&file, &options()).unwrap());
    assert_eq!((text.scene, text.report), (binary.scene, binary.report));
}
