//! Files that are written, read back by nothing but their JSON and their bytes.

use std::sync::Arc;

use glam::{Affine3A, Quat, Vec2, Vec3, Vec4};
use serde_json::{Value, json};

use super::*;
use crate::gltf::Container;
use crate::model::{Material, MeshLibrary, Skin, Texture, TriangleMesh, Wrap};

/// A square of two triangles with everything that a mesh can have.
fn full(name: &str) -> TriangleMesh {
    let corners = [[-1.0, -2.0], [1.0, -2.0], [1.0, 2.0], [-1.0, 2.0]];
    let picture = image::RgbaImage::from_pixel(2, 2, image::Rgba([200, 100, 50, 255]));
    let mut file = std::io::Cursor::new(Vec::new());
    picture.write_to(&mut file, image::ImageFormat::Png).unwrap();
    TriangleMesh {
        name: name.to_owned(),
        positions: corners.map(|[x, y]| Vec3::new(x, y, 0.0)).to_vec(),
        normals: vec![Vec3::Z; 4],
        colours: vec![Vec4::new(1.0, 0.5, 0.25, 1.0); 4],
        texture_coordinates: corners.map(|[x, y]| Vec2::new(x, y)).to_vec(),
        indices: vec![0, 1, 2, 0, 2, 3],
        material: Material {
            texture: Some(Arc::new(Texture {
                file: file.into_inner().into(),
                media_type: "image/png",
                size_px: [2, 2],
                pixels: picture.into_raw().into(),
                wrap: [Wrap::Mirror, Wrap::Clamp],
                is_pixelated: true,
            })),
            metallic: 0.25,
            emissive: Vec3::new(0.5, 4.0, 0.0),
            opacity: 0.75,
            alpha_cutoff: Some(0.5),
            is_double_sided: true,
            ..Material::default()
        },
        skin: Some(Skin {
            joints: vec![[0, 1, 0, 0], [1, 1, 0, 0], [1, 0, 0, 0], [3, 1, 0, 0]],
            weights: vec![[0.5, 0.5, 0.0, 0.0], [0.25, 0.75, 0.0, 0.0], [0.9, 0.3, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]],
            joint_from_shape: vec![
                Affine3A::IDENTITY,
                Affine3A::from_rotation_translation(Quat::from_rotation_x(0.5), Vec3::new(1.0, 2.0, 3.0)),
                Affine3A::from_scale(Vec3::new(1.0, 2.0, 0.0)),
            ],
        }),
    }
}

fn plain(name: &str) -> TriangleMesh {
    TriangleMesh {
        name: name.to_owned(),
        colours: Vec::new(),
        texture_coordinates: Vec::new(),
        material: Material { is_unlit: true, emissive: Vec3::ONE, ..Material::default() },
        skin: None,
        ..full(name)
    }
}

fn parts(file: &[u8]) -> (Value, Vec<u8>) {
    let container = Container::of(file).unwrap();
    (serde_json::from_slice(container.json).unwrap(), container.binary.unwrap_or_default().to_vec())
}

/// The floats of an accessor.
fn floats(json: &Value, binary: &[u8], accessor: &Value) -> Vec<f32> {
    let accessor = &json["accessors"][accessor.as_u64().unwrap() as usize];
    assert_eq!(accessor["componentType"], 5126);
    let parts = match accessor["type"].as_str().unwrap() {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        "VEC4" => 4,
        _ => 16,
    };
    let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
    let number = |value: &Value| value.as_u64().unwrap_or(0) as usize;
    let start = number(&view["byteOffset"]) + number(&accessor["byteOffset"]);
    let length = 4 * parts * number(&accessor["count"]);
    assert!(number(&accessor["byteOffset"]) + length <= number(&view["byteLength"]));
    binary[start..start + length].chunks_exact(4).map(|float| f32::from_le_bytes(float.try_into().unwrap())).collect()
}

#[test]
fn a_library_has_a_node_at_the_root_for_each_mesh() {
    let meshes = [full("a"), plain("b")];
    let file = MeshLibrary::to_glb(&meshes);
    assert_eq!(file, MeshLibrary::to_glb(&meshes.map(Arc::new)), "equal meshes make equal bytes");
    let (json, binary) = parts(&file);
    let roots = json["scenes"][0]["nodes"].as_array().unwrap();
    let names: Vec<_> = roots.iter().map(|root| &json["nodes"][root.as_u64().unwrap() as usize]["name"]).collect();
    assert_eq!(names, ["a", "b"]);
    assert_eq!(json["extensionsUsed"], json!(["KHR_materials_emissive_strength", "KHR_materials_unlit"]));
    assert_eq!(json["skins"][0]["joints"].as_array().unwrap().len(), 3);
    let (a, b) = (&json["meshes"][0]["primitives"][0], &json["meshes"][1]["primitives"][0]);
    assert_eq!(a["attributes"]["POSITION"], b["attributes"]["POSITION"], "equal data are stored once");
    assert_ne!(a["material"], b["material"]);
    let positions = &json["accessors"][a["attributes"]["POSITION"].as_u64().unwrap() as usize];
    assert_eq!((&positions["min"], &positions["max"]), (&json!([-1.0, -2.0, 0.0]), &json!([1.0, 2.0, 0.0])));
    assert_eq!(floats(&json, &binary, &a["attributes"]["POSITION"])[..3], [-1.0, -2.0, 0.0]);
    let matrices = floats(&json, &binary, &json["skins"][0]["inverseBindMatrices"]);
    assert_eq!(matrices[16 + 12..32], [1.0, 2.0, 3.0, 1.0]);
}

#[test]
fn a_material_is_written_whole() {
    let (json, binary) = parts(&MeshLibrary::to_glb(&[full("a"), plain("b")]));
    let material = &json["materials"][0];
    assert_eq!(material["pbrMetallicRoughness"]["baseColorFactor"], json!([1.0, 1.0, 1.0, 0.75]));
    assert_eq!(material["emissiveFactor"], json!([0.125, 1.0, 0.0]), "no factor is above 1");
    assert_eq!(material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 4.0);
    assert_eq!((&material["alphaMode"], &material["doubleSided"]), (&json!("MASK"), &json!(true)));
    assert_eq!(json["samplers"][0], json!({ "magFilter": 9728, "minFilter": 9728, "wrapS": 33648, "wrapT": 33071 }));
    let view = &json["bufferViews"][json["images"][0]["bufferView"].as_u64().unwrap() as usize];
    let unlit = &json["materials"][1];
    assert_eq!((&unlit["extensions"], unlit.get("emissiveFactor")), (&json!({ "KHR_materials_unlit": {} }), None));
    assert!(binary[view["byteOffset"].as_u64().unwrap() as usize..].starts_with(b"\x89PNG"));
}

#[test]
fn the_weights_of_a_vertex_are_as_the_specification_wants_them() {
    let (json, binary) = parts(&MeshLibrary::to_glb(&[full("a")]));
    let attributes = &json["meshes"][0]["primitives"][0]["attributes"];
    let weights = floats(&json, &binary, &attributes["WEIGHTS_0"]);
    assert_eq!(weights[4..8], [1.0, 0.0, 0.0, 0.0], "a joint that comes twice is one");
    for vertex in weights.chunks_exact(4) {
        assert!((vertex.iter().sum::<f32>() - 1.0).abs() < 2e-7, "{vertex:?}");
    }
    let view = json["accessors"][attributes["JOINTS_0"].as_u64().unwrap() as usize]["bufferView"].as_u64().unwrap();
    let start = json["bufferViews"][view as usize]["byteOffset"].as_u64().unwrap() as usize;
    assert_eq!(binary[start..start + 16], [0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0]);
}

#[test]
fn large_meshes_have_large_indices() {
    let last = |count: u32| {
        let mut writer = Writer::new();
        let accessor = writer.indices(&[0, 1, count - 1]);
        writer.root.accessors[accessor].component_type
    };
    assert_eq!((last(65_535), last(65_536)), (UNSIGNED_SHORT, UNSIGNED_INT));
}

#[test]
fn animations_share_a_view_and_equal_lists() {
    let mut writer = Writer::new();
    let times = writer.times(&[0.0, 0.5, 2.0]);
    let values = writer.animated_vectors(&[Vec3::X, Vec3::Y, Vec3::Z]);
    let again = writer.times(&[0.0, 0.5, 2.0]);
    assert_eq!(times, again);
    writer.positions(&[Vec3::ONE]);
    let text = writer.into_gltf();
    let json: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["accessors"][times]["max"], json!([2.0]));
    assert_eq!(json["accessors"][times]["bufferView"], json["accessors"][values]["bufferView"]);
    let binary = crate::gltf::decoded_data_uri(json["buffers"][0]["uri"].as_str().unwrap()).unwrap().unwrap();
    assert_eq!(floats(&json, &binary, &json!(times)), [0.0, 0.5, 2.0]);
    assert_eq!(floats(&json, &binary, &json!(values))[3..6], [0.0, 1.0, 0.0]);
}

#[test]
fn an_empty_library_is_a_file_without_a_scene() {
    let (json, binary) = parts(&MeshLibrary::to_glb::<TriangleMesh>(&[]));
    assert_eq!(json, json!({ "asset": { "version": "2.0", "generator": "Inbetween" } }));
    assert!(binary.is_empty());
}
