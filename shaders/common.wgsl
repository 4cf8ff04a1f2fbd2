// Shared by every shader: the globals of a picture, and the last step of every fragment. Colours are linear light until `finished`; those of surfaces
// and of the sky are light before the tone curve until `finished_light`. No
// shader uses derivatives, so that a picture has the same bytes each time. The renderer prepends two constants. ENCODE_SRGB: whether the
// shader must encode sRGB because the target does not. IS_SUB_FRAME: whether the target takes the sum of light before the tone curve,
// of which the mean is shown.

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
    towards_sun_in_world: vec4f,
    // Unit direction to the light of the shadow map; w: a shadow texel's side in scene units.
    towards_light_in_world: vec4f,
    // In a sub-frame: how much its shadow map counts for the sun, and for the sky; z: one over the number of sub-frames so far.
    weights: vec4f,
    // Light before the tone curve. w: the outline's width in pixels.
    horizon: vec4f,
    // The same. w: the height of the ground.
    zenith: vec4f,
    // The light of the sun on surfaces that face it, of the whole sky, and from below, exposure included. The last one's w: the exposure.
    sun: vec4f,
    sky: vec4f,
    ground: vec4f,
    accent: vec4f,
    // In a sub-frame: the light behind everything, and its opacity.
    backdrop: vec4f,
}

@group(0) @binding(0) var<uniform> globals: Globals;

// Tone curve: keeps the brightest faces below white and the darkest above black.
fn toned(colour: vec3f) -> vec3f {
    let bounded = min(colour, vec3f(1.9));
    return max(bounded * (1.0 - 0.235 * bounded), vec3f(0.003));
}

// The light that the tone curve brings to a colour.
fn untoned(colour: vec3f) -> vec3f {
    return (1.0 - sqrt(max(1.0 - 0.94 * colour, vec3f(0.0)))) / 0.47;
}

// A colour that is light before the tone curve, at a place in the target.
fn finished_light(light: vec3f, opacity: f32, in_pixels: vec4f) -> vec4f {
    if IS_SUB_FRAME {
        return added(vec4f(light, opacity), in_pixels);
    }
    return finished(toned(light), opacity);
}

fn finished(colour: vec3f, opacity: f32) -> vec4f {
    if ENCODE_SRGB {
        let low = colour * 12.92;
        let high = 1.055 * pow(max(colour, vec3f(0.0)), vec3f(1.0 / 2.4)) - 0.055;
        return vec4f(select(high, low, colour <= vec3f(0.0031308)), opacity);
    }
    return vec4f(colour, opacity);
}
