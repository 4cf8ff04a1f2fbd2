// The sky, where nothing else is: a gradient from the horizon up. Its ray is a function of the pixel alone.

@vertex
fn sky_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn sky_fragment(@builtin(position) in_pixels: vec4f) -> @location(0) vec4f {
    let ray = globals.first_ray_in_world.xyz + in_pixels.x * globals.ray_right_in_world.xyz + in_pixels.y * globals.ray_down_in_world.xyz;
    let height = max(ray.y * inverseSqrt(dot(ray, ray)), 0.0);
    let climb = height * (1.9 - 0.9 * height);
    // Half a step of fixed noise, so that no band has a sharp edge.
    let place = floor(in_pixels.xy);
    let noise = fract(52.9829189 * fract(dot(place, vec2f(0.06711056, 0.00583715)))) - 0.5;
    return finished(mix(globals.horizon.xyz, globals.zenith.xyz, climb) + noise * 0.0035, 1.0);
}
