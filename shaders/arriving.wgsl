// The light that reaches a surface. `in_map` is what `sun_arriving` finds in the shadow map.

// Of the sun and of the sky, as parts of what the whole of each gives to a surface that faces it.
//
// A sub-frame has one shadow map, of a point of the sun or of the sky. All light is there as without shadows, and the sub-frame adds how the
// light of that point differs, as often as there are sub-frames for each of its kind. The mean over all sub-frames is then the light with
// its shadows, and where nothing casts a shadow every sub-frame is right by itself.
fn light_arriving(normal: vec3f, facing_sun: f32, in_map: f32) -> vec2f {
    let sun = max(facing_sun, 0.0);
    let sky = 0.5 + 0.5 * normal.y;
    if IS_SUB_FRAME {
        let facing = max(dot(normal, globals.towards_light_in_world.xyz), 0.0);
        return vec2f(sun + globals.weights.x * (facing * in_map - sun), sky + globals.weights.y * facing * (in_map - 1.0));
    }
    return vec2f(sun * in_map, sky);
}
