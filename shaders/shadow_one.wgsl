// The fraction of sunlight, 0 to 1, if the CPU draws: one bilinear tap, which costs a sixth of a picture. The map's texels are larger than
// pixels then, so that the tap filters. Follows `lit.wgsl`.
fn sun_arriving(in_map: vec3f) -> f32 {
    return textureSampleCompareLevel(sun_map, sun_map_sampler, in_map.xy, min(in_map.z, 1.0));
}
