// How much of the sun arrives, 0 to 1, where the CPU draws: two taps across a diagonal, so that the steps of slanting borders run
// into each other. Follows `lit.wgsl`.
fn sun_arriving(place: vec3f) -> f32 {
    let depth = min(place.z, 1.0);
    let half = 0.55 / vec2f(textureDimensions(sun_map));
    return 0.5 * (textureSampleCompareLevel(sun_map, sun_map_sampler, place.xy + half, depth)
        + textureSampleCompareLevel(sun_map, sun_map_sampler, place.xy - half, depth));
}
