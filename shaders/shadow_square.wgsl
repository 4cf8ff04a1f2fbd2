// The fraction of sunlight, 0 to 1: four by four taps. Follows `lit.wgsl`.
fn sun_arriving(in_map: vec3f) -> f32 {
    let depth = min(in_map.z, 1.0);
    let texel = 1.0 / vec2f(textureDimensions(sun_map));
    var sum = 0.0;
    for (var y = 0; y < 4; y++) {
        for (var x = 0; x < 4; x++) {
            let offset = (vec2f(f32(x), f32(y)) - 1.5) * texel;
            sum += textureSampleCompareLevel(sun_map, sun_map_sampler, in_map.xy + offset, depth);
        }
    }
    return sum / 16.0;
}
