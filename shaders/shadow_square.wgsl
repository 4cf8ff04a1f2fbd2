// How much of the sun arrives, 0 to 1: a square of four by four taps. Follows `lit.wgsl`.
fn sun_arriving(place: vec3f) -> f32 {
    let depth = min(place.z, 1.0);
    let texel = 1.0 / vec2f(textureDimensions(sun_map));
    var sum = 0.0;
    for (var y = 0; y < 4; y++) {
        for (var x = 0; x < 4; x++) {
            let offset = (vec2f(f32(x), f32(y)) - 1.5) * texel;
            sum += textureSampleCompareLevel(sun_map, sun_map_sampler, place.xy + offset, depth);
        }
    }
    return sum / 16.0;
}
