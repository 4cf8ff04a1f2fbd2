//! Small glTF files, made number by number.

use inbetween::gltf::{data_uri, glb};
use serde_json::{Value, json};

/// A channel of an animation: node, path, times, values, interpolation.
pub type Channel<'a> = (usize, &'a str, &'a [f32], &'a [f32], &'a str);

/// A glTF file in the making: its JSON, and the bytes of its one buffer.
#[derive(Clone)]
pub struct Model {
    pub json: Value,
    pub bytes: Vec<u8>,
}

impl Model {
    /// A file with nothing in it.
    pub fn new() -> Self {
        Self { json: json!({ "asset": { "version": "2.0" } }), bytes: Vec::new() }
    }

    /// Adds to a list of the file, and says at which index.
    pub fn push(&mut self, list: &str, value: Value) -> usize {
        if self.json.get(list).is_none() {
            self.json[list] = json!([]);
        }
        let list = self.json[list].as_array_mut().expect("it is a list");
        list.push(value);
        list.len() - 1
    }

    /// Adds a node to the file and, where it is one of the top, to the first scene.
    pub fn root(&mut self, node: Value) -> usize {
        let node = self.push("nodes", node);
        if self.json.get("scenes").is_none() {
            self.json["scenes"] = json!([{ "nodes": [] }]);
        }
        self.json["scenes"][0]["nodes"].as_array_mut().expect("it is a list").push(json!(node));
        node
    }

    /// Adds bytes as a view.
    pub fn view(&mut self, bytes: &[u8]) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let view = json!({ "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len() });
        self.bytes.extend_from_slice(bytes);
        self.push("bufferViews", view)
    }

    /// Adds an accessor of numbers of a type, such as VEC3.
    pub fn floats(&mut self, kind: &str, numbers: &[f32]) -> usize {
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        let view = self.view(&bytes);
        let count = numbers.len() / components(kind);
        self.push("accessors", json!({ "bufferView": view, "componentType": 5126, "count": count, "type": kind }))
    }

    /// Adds an accessor of 16-bit integers.
    pub fn shorts(&mut self, kind: &str, numbers: &[u16]) -> usize {
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        let view = self.view(&bytes);
        let count = numbers.len() / components(kind);
        self.push("accessors", json!({ "bufferView": view, "componentType": 5123, "count": count, "type": kind }))
    }

    /// Adds a box of a size with its corner faces, and says which mesh it is.
    pub fn block(&mut self, name: &str, [x, y, z]: [f32; 3]) -> usize {
        let corner = |corner: usize| {
            let sign = |bit: usize| if corner & bit == 0 { -0.5 } else { 0.5 };
            [x * sign(1), y * sign(2), z * sign(4)]
        };
        let positions: Vec<f32> = (0..8).flat_map(corner).collect();
        let indices = [
            0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6,
        ];
        let positions = self.floats("VEC3", &positions);
        let indices = self.shorts("SCALAR", &indices);
        self.push(
            "meshes",
            json!({ "name": name, "primitives": [{ "attributes": { "POSITION": positions }, "indices": indices }] }),
        )
    }

    /// Adds an animation of channels.
    pub fn animation(&mut self, name: &str, channels: &[Channel<'_>]) -> usize {
        let mut animation = json!({ "name": name, "channels": [], "samplers": [] });
        for (number, (node, path, times, values, interpolation)) in channels.iter().enumerate() {
            let input = self.floats("SCALAR", times);
            let output = self.floats(if *path == "rotation" { "VEC4" } else { "VEC3" }, values);
            let sampler = json!({ "input": input, "output": output, "interpolation": interpolation });
            animation["samplers"].as_array_mut().expect("it is a list").push(sampler);
            let channel = json!({ "sampler": number, "target": { "node": node, "path": path } });
            animation["channels"].as_array_mut().expect("it is a list").push(channel);
        }
        self.push("animations", animation)
    }

    /// The whole as a binary file.
    pub fn glb(&self) -> Vec<u8> {
        let mut json = self.json.clone();
        if !self.bytes.is_empty() {
            json["buffers"] = json!([{ "byteLength": self.bytes.len() }]);
        }
        glb(&json.to_string(), &self.bytes)
    }

    /// The whole as a text with its buffer in it.
    pub fn text(&self) -> Vec<u8> {
        let mut json = self.json.clone();
        let uri = data_uri("application/octet-stream", &self.bytes);
        json["buffers"] = json!([{ "byteLength": self.bytes.len(), "uri": uri }]);
        json.to_string().into_bytes()
    }
}

fn components(kind: &str) -> usize {
    match kind {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        "VEC4" => 4,
        "MAT4" => 16,
        _ => unreachable!("no other is made"),
    }
}

/// A PNG of 2 by 2 pixels.
pub fn png(pixels: [[u8; 4]; 4]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 2, 2);
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header().and_then(|mut writer| writer.write_image_data(pixels.as_flattened())).expect("it is whole");
    bytes
}

/// Two blocks, the upper on the lower's joint, in one mesh that a skin of two joints moves. `weights` are those of the upper block.
pub fn skinned(weights: [f32; 4]) -> Model {
    let mut model = Model::new();
    let mut positions = Vec::new();
    let mut joints = Vec::new();
    let mut strengths = Vec::new();
    let mut indices: Vec<u16> = Vec::new();
    let faces =
        [0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6];
    for block in 0..2_u16 {
        for corner in 0..8_usize {
            let sign = |bit: usize| if corner & bit == 0 { -0.2 } else { 0.2 };
            positions.extend([sign(1), f32::from(block) + 0.5 + 2.0 * sign(2), sign(4)]);
            joints.extend(if block == 0 { [0, 0, 0, 0] } else { [1, 0, 0, 0] });
            strengths.extend(if block == 0 { [1.0, 0.0, 0.0, 0.0] } else { weights });
        }
        indices.extend(faces.map(|corner| corner + 8 * block));
    }
    let attributes = json!({
        "POSITION": model.floats("VEC3", &positions),
        "JOINTS_0": model.shorts("VEC4", &joints),
        "WEIGHTS_0": model.floats("VEC4", &strengths),
    });
    let indices = model.shorts("SCALAR", &indices);
    model.push("meshes", json!({ "name": "arm", "primitives": [{ "attributes": attributes, "indices": indices }] }));
    let mut matrices = [0.0; 32];
    for diagonal in [0, 5, 10, 15] {
        matrices[diagonal] = 1.0;
        matrices[16 + diagonal] = 1.0;
    }
    matrices[16 + 13] = -1.0;
    let matrices = model.floats("MAT4", &matrices);
    model.root(json!({ "name": "body", "mesh": 0, "skin": 0 }));
    model.root(json!({ "name": "lower", "children": [2] }));
    model.push("nodes", json!({ "name": "upper", "translation": [0, 1, 0] }));
    model.push("skins", json!({ "joints": [1, 2], "inverseBindMatrices": matrices }));
    model
}
