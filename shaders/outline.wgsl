// The chosen node's outline, around the mask of all its shapes: red is the whole shape, green its visible part.

@group(1) @binding(0) var mask: texture_2d<f32>;

@vertex
fn outline_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn outline_fragment(@builtin(position) in_pixels: vec4f) -> @location(0) vec4f {
    let here = vec2i(in_pixels.xy);
    let last = vec2i(textureDimensions(mask)) - 1;
    let width = globals.horizon.w;
    var reached = vec2f(0.0);
    var rim = 0.0;
    for (var y = -4; y <= 4; y++) {
        for (var x = -4; x <= 4; x++) {
            let weight = width + 0.9 - length(vec2f(f32(x), f32(y)));
            if weight > -1.0 {
                let there = clamp(here + vec2i(x, y), vec2i(0), last);
                let covered = textureLoad(mask, there, 0).rg;
                reached = max(reached, saturate(weight) * covered);
                rim = max(rim, saturate(weight + 1.0) * covered.g);
            }
        }
    }
    let outside = 1.0 - textureLoad(mask, here, 0).r;
    let line = max(reached.g, 0.4 * reached.r);
    // A dark rim lets the line stand out on shapes of its own colour.
    let opacity = max(line, 0.55 * rim);
    return finished(globals.accent.rgb * (line / max(opacity, 1e-4)), outside * opacity);
}
