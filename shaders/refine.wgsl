// The mean of sub-frames.

@group(1) @binding(0) var sum: texture_2d<f32>;

struct Place {
    @builtin(position) in_clip: vec4f,
    // From the top left corner of the sum, which may be a part of the target.
    @location(0) in_pixels: vec2f,
}

@vertex
fn whole_vertex(@builtin(vertex_index) index: u32) -> Place {
    let across = vec2f(f32(index & 1u) * 2.0, 1.0 - f32(index >> 1u) * 2.0);
    var out: Place;
    out.in_clip = vec4f(across.x * 2.0 - 1.0, 1.0 - across.y * 2.0, 0.0, 1.0);
    out.in_pixels = across * vec2f(textureDimensions(sum));
    return out;
}

// Colours are multiplied by their opacity until they are shown.
@fragment
fn mean_fragment(place: Place) -> @location(0) vec4f {
    let mean = textureLoad(sum, vec2i(place.in_pixels), 0) * globals.weights.z;
    if mean.a <= 0.0 {
        return vec4f(0.0);
    }
    return finished(toned(mean.rgb / mean.a), mean.a);
}
