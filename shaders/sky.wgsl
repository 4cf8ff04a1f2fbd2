// The sky, where nothing else is: a gradient from the horizon up, its ray interpolated between three corners.

struct SkyPixel {
    @builtin(position) in_pixels: vec4f,
    @location(0) @interpolate(linear) ray_in_world: vec3f,
}

@vertex
fn sky_vertex(@builtin(vertex_index) index: u32) -> SkyPixel {
    let in_clip = vec2f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0);
    var out: SkyPixel;
    out.in_pixels = vec4f(in_clip, 0.0, 1.0);
    out.ray_in_world = globals.ray_ahead_in_world.xyz + in_clip.x * globals.ray_right_in_world.xyz + in_clip.y * globals.ray_up_in_world.xyz;
    return out;
}

@fragment
fn sky_fragment(pixel: SkyPixel) -> @location(0) vec4f {
    let ray = pixel.ray_in_world;
    let height = max(ray.y * inverseSqrt(dot(ray, ray)), 0.0);
    let climb = height * (1.9 - 0.9 * height);
    // Half a step of fixed noise, so that no band has a sharp edge.
    let place = floor(pixel.in_pixels.xy);
    let noise = fract(52.9829189 * fract(dot(place, vec2f(0.06711056, 0.00583715)))) - 0.5;
    return finished(mix(globals.horizon.xyz, globals.zenith.xyz, climb) + noise * 0.0035, 1.0);
}
