//! What glTF files hold: accessors, meshes, materials, skins, samplers.

use glam::{DQuat, DVec3, Vec2, Vec3, Vec4};
use inbetween::gltf::{Document, GltfError, MOST_ZEROS, MeshReader, PrimitiveMesh};
use inbetween::model::{MeshLibrary, Wrap};
use inbetween::words::Message;
use serde_json::json;

use super::make::{Model, png, skinned};

fn no_files(_: &str) -> Result<Vec<u8>, Message> {
    panic!("no file is named")
}

/// The first primitive of the first mesh, with the first skin where there is one, and the notes.
fn primitive(model: &Model) -> Result<(Option<PrimitiveMesh>, Vec<String>), GltfError> {
    let file = model.glb();
    let document = Document::read(&file, &mut no_files)?;
    let mut no_files = no_files;
    let mut reader = MeshReader::new(&document, &mut no_files);
    let read = reader.primitive(0, 0, model.json.get("skins").map(|_| 0), "mesh")?;
    Ok((read, reader.notes.iter().map(ToString::to_string).collect()))
}

#[track_caller]
fn refused(model: &Model, sentence: &str) {
    assert_eq!(primitive(model).expect_err(sentence).to_string(), sentence);
}

/// A file with one triangle.
fn triangle() -> Model {
    let mut model = Model::new();
    let positions = model.floats("VEC3", &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    model.push("meshes", json!({ "primitives": [{ "attributes": { "POSITION": positions } }] }));
    model
}

/// A file with an accessor of its own making, read as numbers.
fn numbers<const N: usize>(model: &Model, accessor: usize) -> Result<Vec<[f32; N]>, String> {
    let file = model.glb();
    let document = Document::read(&file, &mut no_files).map_err(|error| error.to_string())?;
    document.floats(accessor).map_err(|error| error.to_string())
}

#[test]
fn an_accessor_has_strides_and_normalised_integers() {
    let mut model = Model::new();
    let view = model.view(&[0, 255, 9, 9, 128, 127, 9, 9]);
    model.json["bufferViews"][view]["byteStride"] = json!(4);
    let accessor = |kind: u32, normalized: bool| json!({ "bufferView": view, "componentType": kind, "normalized": normalized, "count": 2, "type": "VEC2" });
    let accessors =
        [(5121, true), (5120, true), (5121, false)].map(|(kind, is)| model.push("accessors", accessor(kind, is)));
    assert_eq!(numbers(&model, accessors[0]).unwrap(), [[0.0, 1.0], [128.0 / 255.0, 127.0 / 255.0]]);
    assert_eq!(numbers(&model, accessors[1]).unwrap(), [[0.0, -1.0 / 127.0], [-1.0, 1.0]]);
    assert_eq!(numbers(&model, accessors[2]).unwrap(), [[0.0, 255.0], [128.0, 127.0]]);
}

#[test]
fn sparse_elements_replace_those_of_a_view_or_zeros() {
    let mut model = Model::new();
    let base = model.floats("SCALAR", &[1.0, 2.0, 3.0]);
    let (indices, values) = (model.view(&[2, 0]), model.view(&7.0_f32.to_le_bytes()));
    let sparse = json!({
        "count": 1,
        "indices": { "bufferView": indices, "componentType": 5121 },
        "values": { "bufferView": values },
    });
    model.json["accessors"][base]["sparse"] = sparse.clone();
    let zeros =
        model.push("accessors", json!({ "componentType": 5126, "count": 4, "type": "SCALAR", "sparse": sparse }));
    assert_eq!(numbers(&model, base).unwrap(), [[1.0], [2.0], [7.0]]);
    assert_eq!(numbers(&model, zeros).unwrap(), [[0.0], [0.0], [7.0], [0.0]]);
    model.json["accessors"][zeros]["count"] = json!(2);
    assert_eq!(numbers::<1>(&model, zeros).unwrap_err(), "/accessors/1: element 2 is replaced, and there are 2",);
    model.json["accessors"][zeros]["count"] = json!(MOST_ZEROS + 1);
    assert_eq!(numbers::<1>(&model, zeros).unwrap_err(), "/accessors/1: more than 1048576 elements without bytes");
}

#[test]
fn an_accessor_out_of_bounds_is_refused_with_its_place() {
    let mut model = Model::new();
    let accessor = model.floats("VEC3", &[1.0; 6]);
    let mut change = |field: &str, value: serde_json::Value, sentence: &str| {
        let before = model.json["accessors"][0].clone();
        model.json["accessors"][0][field] = value;
        assert_eq!(numbers::<3>(&model, accessor).unwrap_err(), sentence);
        model.json["accessors"][0] = before;
    };
    change("count", json!(3), "/accessors/0: 36 bytes are needed, and 24 are there");
    change("count", json!(usize::MAX / 2), "/accessors/0: 18446744073709551615 bytes are needed, and 24 are there");
    change("byteOffset", json!(1), "/accessors/0: 25 bytes are needed, and 24 are there");
    change("bufferView", json!(7), "/bufferViews: names /bufferViews/7, which the file does not have");
    change("componentType", json!(5124), "/accessors/0: component type 5124 does not fit here");
    change("type", json!("VEC2"), "/accessors/0: elements are of type VEC2, expected 3 components");
    model.json["bufferViews"][0]["byteLength"] = json!(100);
    assert_eq!(numbers::<3>(&model, accessor).unwrap_err(), "/bufferViews/0: 100 bytes are needed, and 24 are there");
    let infinite = model.floats("SCALAR", &[0.0, f32::INFINITY]);
    model.json["bufferViews"][0]["byteLength"] = json!(24);
    let sentence = "/accessors/1: element 1 has a number that is infinite or none";
    assert_eq!(numbers::<1>(&model, infinite).unwrap_err(), sentence);
}

#[test]
fn triangles_strips_and_fans_are_triangles() {
    let mut model = Model::new();
    let positions: Vec<f32> = (0..5).flat_map(|at| [at as f32, (at % 2) as f32, 0.0]).collect();
    let positions = model.floats("VEC3", &positions);
    let normals = model.floats("VEC3", &[0.0, 0.0, 2.0].repeat(5));
    let attributes = json!({ "POSITION": positions, "NORMAL": normals });
    model.push("meshes", json!({ "primitives": [{ "attributes": attributes }] }));
    let mut indices = |mode: u32| {
        model.json["meshes"][0]["primitives"][0]["mode"] = json!(mode);
        let mesh = primitive(&model).unwrap().0.expect("it has triangles").mesh;
        assert!(mesh.normals.iter().all(|normal| *normal == Vec3::Z));
        mesh.indices
    };
    assert_eq!(indices(4), [0, 1, 2]);
    assert_eq!(indices(5), [0, 1, 2, 1, 3, 2, 2, 3, 4]);
    assert_eq!(indices(6), [1, 2, 0, 2, 3, 0, 3, 4, 0]);
    model.json["meshes"][0]["primitives"][0]["mode"] = json!(1);
    let (none, notes) = primitive(&model).unwrap();
    assert!(none.is_none());
    assert_eq!(notes, ["/meshes/0/primitives/0: points and lines are left out"]);
}

#[test]
fn a_mesh_without_normals_is_flat() {
    let (read, notes) = primitive(&triangle()).unwrap();
    assert_eq!(read.unwrap().mesh.normals, [Vec3::Z; 3]);
    assert_eq!(notes, ["/meshes/0/primitives/0: without normals; its triangles are shaded flat"]);
    let mut block = Model::new();
    block.block("block", [1.0, 2.0, 3.0]);
    let mesh = primitive(&block).unwrap().0.unwrap().mesh;
    assert_eq!((mesh.positions.len(), mesh.half_extents()), (36, Vec3::new(0.5, 1.0, 1.5)));
    // Each face looks away from the middle.
    assert!(mesh.positions.iter().zip(&mesh.normals).all(|(position, normal)| position.dot(*normal) > 0.0));
}

#[test]
fn what_contradicts_itself_is_refused_with_its_place() {
    let mut model = triangle();
    let indices = model.shorts("SCALAR", &[0, 1, 3]);
    model.json["meshes"][0]["primitives"][0]["indices"] = json!(indices);
    refused(&model, "/meshes/0/primitives/0: index 3 in a primitive of 3 vertices");
    let mut model = triangle();
    let normals = model.floats("VEC3", &[0.0, 1.0, 0.0]);
    model.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = json!(normals);
    refused(&model, "/meshes/0/primitives/0: NORMAL has 1 elements, and POSITION has 3");
    let mut model = triangle();
    model.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = json!(9);
    refused(&model, "/accessors: names /accessors/9, which the file does not have");
    let mut model = triangle();
    model.json["meshes"][0]["primitives"][0]["mode"] = json!(7);
    refused(&model, "/meshes/0/primitives/0: mode 7 is none of 0 to 6");
    let mut model = triangle();
    model.json["meshes"][0]["primitives"][0]["material"] = json!(2);
    refused(&model, "/materials: names /materials/2, which the file does not have");
}

#[test]
fn what_a_file_needs_is_known_or_named() {
    let needs = |name: &str| {
        let mut model = triangle();
        model.json["extensionsRequired"] = json!([name]);
        primitive(&model).map(|_| ()).map_err(|error| error.to_string())
    };
    assert_eq!(needs("KHR_materials_unlit"), Ok(()));
    assert_eq!(
        needs("KHR_draco_mesh_compression").unwrap_err(),
        "/extensionsRequired: the file is compressed with KHR_draco_mesh_compression, which this program does not read: run \
         “gltf-transform copy IN.glb OUT.glb” (npm @gltf-transform/cli) and import OUT.glb",
    );
    assert_eq!(
        needs("X_unheard_of").unwrap_err(),
        "/extensionsRequired: the file cannot be read without the extension X_unheard_of, which this program does not know",
    );
    let mut old = triangle();
    old.json["asset"]["version"] = json!("1.0");
    refused(&old, "/asset/version: glTF 1.0, and this program reads glTF 2.0");
    let mut new = triangle();
    new.json["asset"]["minVersion"] = json!("2.1");
    refused(&new, "/asset/minVersion: glTF 2.1, and this program reads glTF 2.0");
}

#[test]
fn materials_and_their_pictures_are_read() {
    let mut model = triangle();
    let red = png([[255, 0, 0, 255]; 4]);
    let view = model.view(&red);
    let coordinates = model.floats("VEC2", &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let colours = model.floats("VEC3", &[1.0, 0.5, 0.25].repeat(3));
    model.push("images", json!({ "bufferView": view, "mimeType": "image/png" }));
    model.push("samplers", json!({ "magFilter": 9728, "wrapS": 33071, "wrapT": 33648 }));
    model.push("textures", json!({ "source": 0, "sampler": 0 }));
    let transform = json!({ "offset": [0.5, 0.25], "scale": [2, 3], "rotation": std::f32::consts::FRAC_PI_2 });
    let texture = json!({ "index": 0, "extensions": { "KHR_texture_transform": transform } });
    model.push(
        "materials",
        json!({
            "pbrMetallicRoughness": {
                "baseColorFactor": [0.5, 0.25, 1, 0.75], "metallicFactor": 0.5, "roughnessFactor": 0.25,
                "baseColorTexture": texture, "metallicRoughnessTexture": { "index": 0 },
            },
            "emissiveFactor": [0.5, 0, 0], "alphaMode": "BLEND", "doubleSided": true,
            "extensions": { "KHR_materials_unlit": {}, "KHR_materials_ior": {},
                "KHR_materials_emissive_strength": { "emissiveStrength": 4 } },
        }),
    );
    let first = &mut model.json["meshes"][0]["primitives"][0];
    first["material"] = json!(0);
    first["attributes"]["TEXCOORD_0"] = json!(coordinates);
    first["attributes"]["COLOR_0"] = json!(colours);
    first["attributes"]["COLOR_1"] = json!(colours);
    first["targets"] = json!([{}]);
    let (read, notes) = primitive(&model).unwrap();
    let PrimitiveMesh { mesh, colour, .. } = read.unwrap();
    assert_eq!(colour, Vec3::new(0.5, 0.25, 1.0));
    assert_eq!(mesh.colours, [Vec4::new(1.0, 0.5, 0.25, 1.0); 3]);
    // A quarter turn against the clock, with y down, of (2, 0) is (0, -2), and of (0, 3) it is (3, 0).
    let expected = [Vec2::new(0.5, 0.25), Vec2::new(0.5, -1.75), Vec2::new(3.5, 0.25)];
    assert!(mesh.texture_coordinates.iter().zip(expected).all(|(found, expected)| found.distance(expected) < 1e-5));
    let material = &mesh.material;
    assert_eq!((material.metallic, material.roughness, material.opacity), (0.5, 0.25, 0.75));
    assert_eq!((material.emissive, material.alpha_cutoff), (Vec3::new(2.0, 0.0, 0.0), Some(0.5)));
    assert!(material.is_double_sided && material.is_unlit);
    let texture = material.texture.as_ref().expect("the picture can be read");
    assert_eq!((texture.size_px, texture.wrap, texture.is_pixelated), ([2, 2], [Wrap::Clamp, Wrap::Mirror], true));
    assert_eq!((&*texture.file, &*texture.pixels), (&*red, [255, 0, 0, 255].repeat(4).as_slice()));
    assert_eq!(
        notes,
        [
            "/materials/0: blending becomes a mask: what is less than half opaque is not drawn",
            "/materials/0: left out of the material: metallicRoughnessTexture and KHR_materials_ior",
            "/meshes/0/primitives/0: morph targets are left out",
            "/meshes/0/primitives/0: left out: COLOR_1",
            "/meshes/0/primitives/0: without normals; its triangles are shaded flat",
        ],
    );
}

#[test]
fn a_picture_that_is_none_is_a_note() {
    let mut model = triangle();
    let coordinates = model.floats("VEC2", &[0.0; 6]);
    model.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = json!(coordinates);
    model.json["meshes"][0]["primitives"][0]["material"] = json!(0);
    model.push("materials", json!({ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 } } }));
    model.push("textures", json!({ "source": 0 }));
    let mut damaged = png([[0; 4]; 4]);
    damaged.truncate(50);
    let mut large = png([[0; 4]; 4]);
    large[16..20].copy_from_slice(&9000_u32.to_be_bytes());
    // The checksum of the header no longer fits, so that it is refused before its size is believed, or after.
    for (bytes, reason) in [(b"GIF89a".to_vec(), "neither PNG nor JPEG"), (damaged, "damaged"), (large, "")] {
        let view = model.view(&bytes);
        model.json["images"] = json!([{ "bufferView": view }]);
        let (read, notes) = primitive(&model).unwrap();
        assert!(read.unwrap().mesh.material.texture.is_none());
        assert!(notes[0].starts_with("/images/0: left out: the picture ") && notes[0].contains(reason), "{notes:?}");
    }
    model.json["images"] = json!([{ "uri": "../secret.png" }]);
    let (_, notes) = primitive(&model).unwrap();
    let sentence = "/images/0: left out: \"../secret.png\" is no file in the folder of the glTF file or below it";
    assert_eq!(notes[0], sentence);
}

#[test]
fn weights_add_up_to_one() {
    let read = |weights: [f32; 4]| primitive(&skinned(weights)).map_err(|error| error.to_string());
    let (mesh, notes) = read([1.0, 0.0, 0.0, 0.0]).unwrap();
    let skin = mesh.unwrap().mesh.skin.expect("it has weights");
    assert_eq!((skin.joint_from_shape.len(), notes.len()), (2, 1));
    let (mesh, notes) = read([0.25, 0.25, 0.0, 0.0]).unwrap();
    let skin = mesh.unwrap().mesh.skin.expect("it has weights");
    assert!(skin.weights.iter().all(|weights| (weights.iter().sum::<f32>() - 1.0).abs() < 1e-6));
    assert_eq!(notes[0], "/meshes/0/primitives/0: the weights of 8 vertices did not add up to 1 and were normalised");
    for weights in [[-1.0, 2.0, 0.0, 0.0], [0.0; 4]] {
        let sentence = read(weights).unwrap_err();
        assert!(sentence.starts_with("/meshes/0/primitives/0: the weights of vertex 8 are "), "{sentence}");
    }
    let mut model = skinned([1.0, 0.0, 0.0, 0.0]);
    model.json["skins"][0]["joints"] = json!([1]);
    refused(&model, "/meshes/0/primitives/0: vertex 8 is moved by joint 1, and the skin has 1");
    let mut model = skinned([1.0, 0.0, 0.0, 0.0]);
    model.json["skins"][0]["joints"] = json!([1, 2, 2]);
    refused(&model, "/skins/0: 2 inverse bind matrices for 3 joints");
}

#[test]
fn more_than_four_joints_become_the_four_strongest() {
    let mut model = triangle();
    let joints = [model.shorts("VEC4", &[0, 1, 2, 3].repeat(3)), model.shorts("VEC4", &[4, 5, 0, 0].repeat(3))];
    let weights = [
        model.floats("VEC4", &[0.1, 0.2, 0.15, 0.05].repeat(3)),
        model.floats("VEC4", &[0.3, 0.2, 0.0, 0.0].repeat(3)),
    ];
    for set in 0..2 {
        let attributes = &mut model.json["meshes"][0]["primitives"][0]["attributes"];
        attributes[format!("JOINTS_{set}")] = json!(joints[set]);
        attributes[format!("WEIGHTS_{set}")] = json!(weights[set]);
    }
    for joint in 0..6 {
        model.push("nodes", json!({ "name": joint.to_string() }));
    }
    model.push("skins", json!({ "joints": [0, 1, 2, 3, 4, 5] }));
    let (read, notes) = primitive(&model).unwrap();
    let skin = read.unwrap().mesh.skin.expect("it has weights");
    assert_eq!(skin.joints[0], [4, 1, 5, 2]);
    let expected = [0.3, 0.2, 0.2, 0.15].map(|weight| weight / 0.85);
    assert!(skin.weights[0].iter().zip(expected).all(|(found, expected): (&f32, f32)| (found - expected).abs() < 1e-6));
    assert!(notes[0].contains("the four strongest are kept"), "{notes:?}");
}

#[test]
fn a_skin_of_many_joints_keeps_those_that_move_something() {
    let mut model = skinned([1.0, 0.0, 0.0, 0.0]);
    let joints: Vec<usize> = std::iter::repeat_n(1, 299).chain([2]).collect();
    model.json["skins"][0] = json!({ "joints": joints });
    let far: Vec<u16> = (0..16).flat_map(|vertex| [if vertex < 8 { 0 } else { 299 }, 0, 0, 0]).collect();
    let far = model.shorts("VEC4", &far);
    model.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = json!(far);
    let read = primitive(&model).unwrap().0.unwrap();
    assert_eq!(read.joints, [0, 299]);
    assert_eq!(read.mesh.skin.expect("it has weights").joint_from_shape.len(), 2);
}

#[test]
fn samplers_go_as_the_specification_says() {
    let mut model = Model::new();
    model.root(json!({ "name": "a" }));
    let times = [1.0, 2.0];
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let line = [0.0, 0.0, 0.0, 2.0, 4.0, 6.0];
    let cubic = [[0.0; 3], [0.0; 3], [4.0, 0.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0], [0.0; 3]];
    model.animation(
        "all",
        &[
            (0, "translation", &times, &line, "LINEAR"),
            (0, "translation", &times, &line, "STEP"),
            (0, "translation", &times, cubic.as_flattened(), "CUBICSPLINE"),
            (0, "rotation", &times, &[0.0, 0.0, 0.0, 1.0, 0.0, -half, 0.0, -half], "LINEAR"),
        ],
    );
    let file = model.glb();
    let document = Document::read(&file, &mut no_files).unwrap();
    let vector = |sampler: usize, at: f64| document.vectors_over_time(0, sampler).unwrap().value_at(at);
    for (at, expected) in [(0.0, [0.0; 3]), (1.25, [0.5, 1.0, 1.5]), (2.0, [2.0, 4.0, 6.0]), (9.0, [2.0, 4.0, 6.0])] {
        assert_eq!(vector(0, at), DVec3::from(expected), "{at}");
    }
    assert_eq!([vector(1, 1.999), vector(1, 2.0)], [DVec3::ZERO, DVec3::new(2.0, 4.0, 6.0)]);
    // Half way: half of the end, and an eighth of the tangent at the start.
    assert_eq!(vector(2, 1.5), DVec3::new(0.5 + 4.0 / 8.0, 0.0, 0.0));
    let turned = document.rotations_over_time(0, 3).unwrap().value_at(1.5);
    assert!((turned - DQuat::from_rotation_y(std::f64::consts::FRAC_PI_4)).length() < 1e-7, "the short way: {turned}");
}

#[test]
fn samplers_that_are_none_are_refused() {
    let refused = |times: &[f32], values: &[f32], interpolation: &str, sentence: &str| {
        let mut model = Model::new();
        model.root(json!({}));
        model.animation("bad", &[(0, "rotation", times, values, interpolation)]);
        let file = model.glb();
        let document = Document::read(&file, &mut no_files).unwrap();
        assert_eq!(document.rotations_over_time(0, 0).unwrap_err().to_string(), sentence);
    };
    let at = "/animations/0/samplers/0";
    let one = [0.0, 0.0, 0.0, 1.0];
    refused(&[0.0], &one, "BEZIER", &format!("{at}: interpolation BEZIER is none of LINEAR, STEP and CUBICSPLINE"));
    refused(&[0.0, 0.0], &one.repeat(2), "LINEAR", &format!("{at}: times do not ascend"));
    refused(&[0.0], &one, "CUBICSPLINE", &format!("{at}: 1 values, expected 3"));
    refused(&[0.0], &[0.0; 4], "LINEAR", &format!("{at}: rotation 0 is no rotation: its length is 0"));
}

#[test]
fn a_library_reads_back_as_it_was_written() {
    let mut model = skinned([0.5, 0.5, 0.0, 0.0]);
    model.block("arm", [1.0, 1.0, 1.0]);
    model.block("", [2.0, 1.0, 1.0]);
    let first = MeshLibrary::from_glb(model.glb()).unwrap();
    let names: Vec<&str> = first.meshes.iter().map(|mesh| mesh.name.as_str()).collect();
    assert_eq!(names, ["arm", "arm_2", "mesh"]);
    assert!(first.find("arm").is_some_and(|mesh| mesh.skin.is_some()));
    let written = MeshLibrary::to_glb(&first.meshes.iter().map(|mesh| (**mesh).clone()).collect::<Vec<_>>());
    let second = MeshLibrary::from_glb(written.clone()).unwrap();
    assert_eq!(first.meshes, second.meshes);
    let again = MeshLibrary::to_glb(&second.meshes.iter().map(|mesh| (**mesh).clone()).collect::<Vec<_>>());
    assert_eq!(written, again, "the bytes are the same again");
}
