// Adds sub-frames, and shows their mean.

@group(1) @binding(0) var before: texture_2d<f32>;
@group(1) @binding(1) var added: texture_2d<f32>;

struct Place {
    @builtin(position) in_clip: vec4f,
    // From the top left corner of the sum, which may be a part of the target.
    @location(0) @interpolate(linear) in_pixels: vec2f,
}

@vertex
fn whole_vertex(@builtin(vertex_index) index: u32) -> Place {
    let across = vec2f(f32(index & 1u) * 2.0, 1.0 - f32(index >> 1u) * 2.0);
    var out: Place;
    out.in_clip = vec4f(across.x * 2.0 - 1.0, 1.0 - across.y * 2.0, 0.0, 1.0);
    out.in_pixels = across * vec2f(textureDimensions(before));
    return out;
}

@fragment
fn sum_fragment(place: Place) -> @location(0) vec4f {
    let here = vec2i(place.in_pixels);
    return textureLoad(before, here, 0) + textureLoad(added, here, 0);
}

// Colours are multiplied by their opacity until they are shown.
@fragment
fn mean_fragment(place: Place) -> @location(0) vec4f {
    let sum = textureLoad(before, vec2i(place.in_pixels), 0) * globals.weights.z;
    if sum.a <= 0.0 {
        return vec4f(0.0);
    }
    return finished(toned(sum.rgb / sum.a), sum.a);
}
