// The sub-frames before this one: every fragment adds its own light to their sum. The nearest fragment of a pixel is the last that is written.

@group(0) @binding(1) var sum_before: texture_2d<f32>;

fn added(light: vec4f, in_pixels: vec4f) -> vec4f {
    return light + textureLoad(sum_before, vec2i(in_pixels.xy), 0);
}
