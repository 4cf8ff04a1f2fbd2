// Adds sub-frames, and shows their mean.

@group(1) @binding(0) var before: texture_2d<f32>;
@group(1) @binding(1) var added: texture_2d<f32>;

@vertex
fn whole_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn sum_fragment(@builtin(position) in_pixels: vec4f) -> @location(0) vec4f {
    let here = vec2i(in_pixels.xy);
    return textureLoad(before, here, 0) + textureLoad(added, here, 0);
}

// Colours are multiplied by their opacity until they are shown.
@fragment
fn mean_fragment(@builtin(position) in_pixels: vec4f) -> @location(0) vec4f {
    let sum = textureLoad(before, vec2i(in_pixels.xy), 0) * globals.weights.z;
    if sum.a <= 0.0 {
        return vec4f(0.0);
    }
    return finished(toned(sum.rgb / sum.a), sum.a);
}
