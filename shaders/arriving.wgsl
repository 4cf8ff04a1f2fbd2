// The light that reaches a surface. Follows `lit.wgsl` and a `sun_arriving`.

// Of the sun and of the sky, as parts of what the whole of each gives to a surface that faces it.
//
// A sub-frame has one shadow map, of a point of the sun or of the sky. All light is there as without shadows, and the sub-frame adds how the
// light of that point differs, as often as there are sub-frames for each of its kind. The mean over all sub-frames is then the light with
// its shadows, and where nothing casts a shadow every sub-frame is right by itself.
fn light_arriving(normal: vec3f, facing_sun: f32, in_map: vec3f) -> vec2f {
    let arriving = sun_arriving(in_map);
    let sun = max(facing_sun, 0.0);
    let sky = 0.5 + 0.5 * normal.y;
    if IS_SUB_FRAME {
        let facing = max(dot(normal, globals.towards_light_in_world.xyz), 0.0);
        return vec2f(sun + globals.weights.x * (facing * arriving - sun), sky + globals.weights.y * facing * (arriving - 1.0));
    }
    return vec2f(sun * arriving, sky);
}
