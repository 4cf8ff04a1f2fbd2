// Shared by every shader: the globals of a picture, and the last step of every fragment. Colours are linear light until `finished`. No
// shader uses derivatives, so that a picture has the same bytes each time. The renderer prepends a constant, ENCODE_SRGB: whether the
// shader must encode sRGB because the target does not.

struct Globals {
    clip_from_world: mat4x4f,
    // x and y from -1 to 1, depth from 0 nearest the sun.
    map_from_world: mat4x4f,
    // w: the size of a pixel at distance 1.
    eye_in_world: vec4f,
    // The view ray at the viewport's top left corner, and its change from pixel to pixel.
    first_ray_in_world: vec4f,
    // w: the viewport's width in pixels.
    ray_right_in_world: vec4f,
    // w: the viewport's height in pixels.
    ray_down_in_world: vec4f,
    // w: a shadow texel's side in scene units.
    towards_sun_in_world: vec4f,
    // w: the outline's width in pixels.
    horizon: vec4f,
    // w: the height of the ground.
    zenith: vec4f,
    accent: vec4f,
}

@group(0) @binding(0) var<uniform> globals: Globals;

fn finished(colour: vec3f, opacity: f32) -> vec4f {
    if ENCODE_SRGB {
        let low = colour * 12.92;
        let high = 1.055 * pow(max(colour, vec3f(0.0)), vec3f(1.0 / 2.4)) - 0.055;
        return vec4f(select(high, low, colour <= vec3f(0.0031308)), opacity);
    }
    return vec4f(colour, opacity);
}
