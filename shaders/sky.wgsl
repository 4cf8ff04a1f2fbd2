// The sky behind everything: a gradient from the horizon up.

@vertex
fn sky_vertex(@builtin(vertex_index) index: u32) -> Pixel {
    // One triangle around the viewport: its corners, counted in viewports from the top left one.
    let across = vec2f(f32(index & 1u) * 2.0, 1.0 - f32(index >> 1u) * 2.0);
    let in_pixels = across * vec2f(globals.ray_right_in_world.w, globals.ray_down_in_world.w);
    var out: Pixel;
    out.in_clip = vec4f(across.x * 2.0 - 1.0, 1.0 - across.y * 2.0, 0.0, 1.0);
    out.surface = vec4f(in_pixels, 0.06711056, 0.00583715);
    out.along_view = globals.first_ray_in_world.xyz + in_pixels.x * globals.ray_right_in_world.xyz
        + in_pixels.y * globals.ray_down_in_world.xyz;
    out.map_position = vec3f(1.9, 0.9, 52.9829189);
    out.colour = vec4f(globals.zenith.xyz, 0.0035);
    out.shaded = globals.horizon.xyz;
    return out;
}

@fragment
fn sky_fragment(pixel: Pixel) -> @location(0) vec4f {
    let ray = pixel.along_view;
    let height = max(ray.y * inverseSqrt(dot(ray, ray)), 0.0);
    let climb = height * (pixel.map_position.x - pixel.map_position.y * height);
    // Fixed noise of half a colour step, against banding. Eight pixels in a row share it: this is not visible and makes files smaller.
    // It stays in its place in all sub-frames.
    var in_pixels = pixel.surface.xy;
    if IS_SUB_FRAME {
        in_pixels = pixel.in_clip.xy;
    }
    let cell = floor(in_pixels * vec2f(0.125, 1.0));
    let noise = fract(pixel.map_position.z * fract(dot(cell, pixel.surface.zw))) - 0.5;
    return finished_light(mix(pixel.shaded, pixel.colour.rgb, climb) + noise * pixel.colour.w, 1.0, pixel.in_clip);
}

// One colour, or nothing. In a sub-frame every pixel must be drawn, so that it has the sum of those before.
@fragment
fn backdrop_fragment(pixel: Pixel) -> @location(0) vec4f {
    return added(globals.backdrop, pixel.in_clip);
}
