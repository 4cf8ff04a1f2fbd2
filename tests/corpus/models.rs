//! A glTF file with a bit of everything, a line for each thing that cases change.

use inbetween::gltf::data_uri;

/// The file as text.
pub fn gltf() -> String {
    let mut bytes: Vec<u8> = Vec::new();
    let mut views = Vec::new();
    let mut view = |part: Vec<u8>| {
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        views.push(format!(r#"{{"buffer": 0, "byteOffset": {}, "byteLength": {}}}"#, bytes.len(), part.len()));
        bytes.extend(part);
    };
    let floats = |numbers: &[f32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>();
    let identity: Vec<f32> = (0..16).map(|entry| if entry % 5 == 0 { 1.0 } else { 0.0 }).collect();
    view(floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]));
    view(vec![0, 0, 1, 0, 2, 0]);
    view(floats(&[0.5, 1.5]));
    view(floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.6, 0.8]));
    view(vec![0; 12]);
    view(floats(&[0.1; 12]));
    view(floats(&identity));
    view(floats(&[1.0, 1.0, 1.0, 2.0, 1.0, 1.0, -1.0, 1.0, 1.0, -2.0, 1.0, 1.0]));
    view(floats(&[f32::INFINITY]));
    view(b"\x89PNG\r\n\x1a\n".to_vec());
    let uri = data_uri("application/octet-stream", &bytes);
    let (length, views) = (bytes.len(), views.join(",\n  "));
    format!(
        r#"{{
"asset": {{"version": "2.0"}},
"extensionsUsed": ["KHR_lights_punctual"],
"scenes": [{{"name": "first", "nodes": [0, 2]}}, {{"name": "second", "nodes": [2]}}],
"nodes": [
  {{"name": "arm", "children": [1], "camera": 0}},
  {{"name": "hand", "translation": [0, 1, 0], "mesh": 0, "camera": 1}},
  {{"name": "skin", "mesh": 1, "skin": 0, "camera": 2}}
],
"cameras": [
  {{"type": "perspective", "perspective": {{"yfov": 0.8, "znear": 0.1}}}},
  {{"type": "perspective", "perspective": {{"yfov": 0.9, "znear": 0.1}}}},
  {{"type": "orthographic", "orthographic": {{}}}}
],
"meshes": [
  {{"name": "plate", "primitives": [
    {{"attributes": {{"POSITION": 0, "COLOR_1": 0}}, "indices": 1, "material": 0, "targets": [{{}}]}},
    {{"attributes": {{"POSITION": 0}}, "mode": 1}}
  ]}},
  {{"name": "bent", "primitives": [{{"attributes": {{
    "POSITION": 0, "JOINTS_0": 4, "WEIGHTS_0": 5, "JOINTS_1": 4, "WEIGHTS_1": 5
  }}}}]}}
],
"skins": [{{"joints": [0], "inverseBindMatrices": 6}}],
"materials": [{{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0}}}}, "normalTexture": {{"index": 0}}, "alphaMode": "BLEND"}}],
"textures": [{{"source": 0}}],
"images": [{{"bufferView": 0}}],
"animations": [
  {{"name": "wave", "channels": [{{"sampler": 0, "target": {{"node": 0, "path": "rotation"}}}}],
    "samplers": [{{"input": 2, "output": 3, "interpolation": "LINEAR"}}]}},
  {{"name": "odd", "channels": [
    {{"sampler": 0, "target": {{"node": 0, "path": "scale"}}}},
    {{"sampler": 0, "target": {{"node": 0, "path": "weights"}}}},
    {{"sampler": 0, "target": {{"node": 0, "path": "colour"}}}},
    {{"sampler": 0, "target": {{"path": "pointer"}}}}
  ], "samplers": [{{"input": 2, "output": 7}}]}},
  {{"name": "mirror", "channels": [{{"sampler": 0, "target": {{"node": 0, "path": "scale"}}}}],
    "samplers": [{{"input": 2, "output": 8}}]}}
],
"accessors": [
  {{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}},
  {{"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}},
  {{"bufferView": 2, "componentType": 5126, "count": 2, "type": "SCALAR"}},
  {{"bufferView": 3, "componentType": 5126, "count": 2, "type": "VEC4"}},
  {{"bufferView": 4, "componentType": 5121, "count": 3, "type": "VEC4"}},
  {{"bufferView": 5, "componentType": 5126, "count": 3, "type": "VEC4"}},
  {{"bufferView": 6, "componentType": 5126, "count": 1, "type": "MAT4"}},
  {{"bufferView": 7, "componentType": 5126, "count": 2, "type": "VEC3"}},
  {{"bufferView": 7, "byteOffset": 12, "componentType": 5126, "count": 2, "type": "VEC3"}},
  {{"bufferView": 8, "componentType": 5126, "count": 1, "type": "SCALAR"}},
  {{"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"}},
  {{"bufferView": 3, "byteOffset": 14, "componentType": 5121, "count": 3, "type": "VEC4"}},
  {{"componentType": 5126, "count": 3, "type": "VEC4"}},
  {{"componentType": 5126, "count": 1, "type": "MAT4"}},
  {{"componentType": 5126, "count": 2, "type": "SCALAR"}},
  {{"componentType": 5126, "count": 2, "type": "VEC4"}},
  {{"bufferView": 1, "componentType": 5123, "count": 0, "type": "SCALAR"}}
],
"bufferViews": [
  {views}
],
"buffers": [{{"byteLength": {length}, "uri": "{uri}"}}]
}}
"#
    )
}
