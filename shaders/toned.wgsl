// What shapes and meshes share: the light near the ground.

// Near the ground less light comes from the side, and least from below. In a sub-frame the sky has shadows, and only the light from below
// is lessened.
fn ambient_arriving(height_in_world: f32, upwards: f32) -> f32 {
    let above = max(height_in_world - globals.zenith.w, 0.0);
    if IS_SUB_FRAME {
        return 1.0 - 0.56 * exp2(-4.0 * above);
    }
    return 1.0 - (0.34 - 0.22 * upwards) * exp2(-4.0 * above);
}

// Light from around that reaches a surface: from the ground and from the sky.
fn fill_arriving(ambient: f32, upwards: f32, sky: f32) -> vec3f {
    if IS_SUB_FRAME {
        return globals.ground.xyz * (ambient * (0.5 - 0.5 * upwards)) + globals.sky.xyz * sky;
    }
    return ambient * (globals.ground.xyz + (globals.sky.xyz - globals.ground.xyz) * sky);
}

fn pow2(x: f32) -> f32 {
    return x * x;
}
