//! Meshes and skins of a scene in the file.

use glam::{Affine3A, DVec3, DVec4, Quat, Vec2, Vec3, Vec4};
use inbetween::gltf::data_uri;
use inbetween::interchange::gltf_out::Export;
use inbetween::model::{Material, MeshLibrary, Skin, TriangleMesh};
use inbetween::scene::{SceneGraph, scene_from_json};
use serde_json::json;

use crate::player::{Blend, Player};

/// A square from −1 to 1.
fn square(name: &str, skin: Option<Skin>) -> TriangleMesh {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    TriangleMesh {
        name: name.to_owned(),
        positions: corners.map(|[x, y]| Vec3::new(x, y, 0.0)).to_vec(),
        normals: vec![Vec3::Z; 4],
        colours: vec![Vec4::ONE; 4],
        texture_coordinates: corners.map(Vec2::from).to_vec(),
        indices: vec![0, 1, 2, 0, 2, 3],
        material: Material { metallic: 0.5, is_double_sided: true, ..Material::default() },
        skin,
    }
}

/// A scene with a rigid square and one between two joints. `upper` is the node above the joints, if there is one.
fn scene(upper: Option<&str>) -> SceneGraph {
    let joint_from_shape = [Vec3::Y, Vec3::NEG_Y].map(Affine3A::from_translation).to_vec();
    let weights = vec![[1.0, 0.0, 0.0, 0.0], [0.75, 0.25, 0.0, 0.0], [0.25, 0.75, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]];
    let skin = Skin { joints: vec![[0, 1, 0, 0]; 4], weights, joint_from_shape };
    let library = MeshLibrary::to_glb(&[square("rigid", None), square("bent", Some(skin))]);
    let path = |joint: &str| upper.map_or(joint.to_owned(), |upper| format!("{upper}/{joint}"));
    let turned = Quat::from_rotation_x(0.7).to_array();
    let joints = json!([
        {"name": "low", "translation": [0, -1, 2], "children": [
            {"name": "skin", "shape": {"mesh": {"name": "bent", "joints": [path("low"), path("high")]}},
                "colour": "#ff8000", "translation": [5, 5, 5]},
            {"name": "plate", "shape": {"mesh": {"name": "rigid"}}, "translation": [1, 0, 0], "scale": [2, 1, 1]}]},
        {"name": "high", "translation": [0, 1, 2], "rotation": turned},
    ]);
    let nodes = match upper {
        Some(upper) => json!([{"name": upper, "children": joints}]),
        None => joints,
    };
    let eye = upper.map_or("low".to_owned(), str::to_owned);
    let text = json!({"format": "inbetween.scene", "version": 3, "name": "bent", "eyes": [eye], "nodes": nodes,
        "meshes": data_uri("model/gltf-binary", &library)});
    scene_from_json(&text.to_string()).unwrap_or_else(|problem| panic!("{problem:?}"))
}

#[test]
fn skins_stand_at_the_root_and_bend_as_here() {
    for upper in [Some("body"), None] {
        let scene = scene(upper);
        let (file, report) = Export::of(&scene).glb();
        let player = Player::of(&file);
        let node = |name: &str| player.root.nodes.iter().position(|node| node.name.as_deref() == Some(name)).unwrap();
        let skinned = node("skin");
        assert!(player.root.scenes[0].nodes.contains(&skinned), "a skin is moved by its joints alone");
        let world = player.world(0.0, Blend::Slerp);
        assert_eq!(world[skinned], glam::DMat4::IDENTITY);
        let written = &player.root.skins[player.root.nodes[skinned].skin.unwrap()];
        assert_eq!(written.joints, [node("low"), node("high")]);
        let above = |at: usize| std::iter::successors(Some(at), |&at| player.parents[at]).last();
        assert_eq!(above(node("low")), above(node("high")), "the joints of a skin have a node above them all");
        assert_eq!(report.nodes, scene.nodes().len() + usize::from(upper.is_none()));

        let id = scene.nodes_with_ids().find(|(_, node)| node.name == "skin").unwrap().0;
        let shape = scene.skin(id).unwrap();
        let here = scene.world_from_nodes(scene.rest_pose(), 0.0);
        let expected = shape.skinned(&shape.world_from_bind(|joint| here[joint.get()].get()).collect::<Vec<_>>());
        let skin = shape.mesh().skin.as_ref().unwrap();
        let matrices = player.matrices(written.inverse_bind_matrices.unwrap());
        for (vertex, expected) in expected.iter().enumerate() {
            let position = shape.mesh().positions[vertex].as_dvec3().extend(1.0);
            let moved = |influence: usize| {
                let joint = usize::from(skin.joints[vertex][influence]);
                world[written.joints[joint]] * matrices[joint] * position * f64::from(skin.weights[vertex][influence])
            };
            let found: DVec4 = (0..4).map(moved).sum();
            assert!(found.truncate().distance(Vec3::from(expected.position).as_dvec3()) < 1e-5, "{found} {expected:?}");
        }
    }
}

#[test]
fn meshes_have_their_names_and_materials_and_the_colour_of_the_shape() {
    let player = Player::of(&Export::of(&scene(Some("body"))).glb().0);
    let node = |name: &str| player.root.nodes.iter().find(|node| node.name.as_deref() == Some(name)).unwrap();
    let mesh = |name: &str| &player.root.meshes[node(name).mesh.unwrap()];
    assert_eq!((mesh("plate").name.as_deref(), mesh("skin").name.as_deref()), (Some("rigid"), Some("bent")));
    let material = &player.root.materials[mesh("skin").primitives[0].material.unwrap()];
    let metallic = material.pbr_metallic_roughness.clone().unwrap();
    assert_eq!((metallic.metallic_factor, material.double_sided), (Some(0.5), Some(true)));
    let [red, green, blue, opacity] = metallic.base_color_factor.unwrap();
    assert_eq!((red, blue, opacity), (1.0, 0.0, 1.0));
    assert!((green - 0.2158).abs() < 1e-3, "#80 in linear light: {green}");
    assert_eq!(Vec3::from(node("plate").scale.unwrap()).as_dvec3(), DVec3::new(2.0, 1.0, 1.0));
    let extras = &node("skin").extras.as_ref().unwrap()["inbetween"];
    assert_eq!(extras["shape"], json!({"mesh": {"name": "bent", "joints": ["body/low", "body/high"]}}));
    assert_eq!(extras["path"], "body/low/skin");
}
