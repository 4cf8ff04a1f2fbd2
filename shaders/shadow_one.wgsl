// How much of the sun arrives, 0 to 1, where the CPU draws: one tap between four texels, which costs a sixth of a picture. Follows
// `lit.wgsl`.
fn sun_arriving(place: vec3f) -> f32 {
    return textureSampleCompareLevel(sun_map, sun_map_sampler, place.xy, min(place.z, 1.0));
}
