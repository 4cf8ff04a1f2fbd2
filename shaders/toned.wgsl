// What shapes and meshes share: the light from below, and the tone curve.

const EXPOSURE: f32 = 1.22;

// Near the ground less light comes from the side, and least from below.
fn ambient_arriving(height_in_world: f32, upwards: f32) -> f32 {
    let above = max(height_in_world - globals.zenith.w, 0.0);
    return 1.0 - (0.34 - 0.22 * upwards) * exp2(-4.0 * above);
}

// Tone curve: keeps the brightest faces below white and the darkest above black.
fn toned(colour: vec3f) -> vec3f {
    let bounded = min(colour, vec3f(1.9));
    return max(bounded * (1.0 - 0.235 * bounded), vec3f(0.003));
}

fn pow2(x: f32) -> f32 {
    return x * x;
}
