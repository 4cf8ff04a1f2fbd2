// Where shapes are, and nothing else of them.

// The sun's map is depth alone. Its pixels read all that a picture's pixels do, so that a software driver compiles what is between
// corners and pixels once for both (`pixel.wgsl`); nothing takes what the fragment gives, and drivers leave its work out.
@vertex
fn shadow_vertex(corner: Corner) -> Pixel {
    let in_map = globals.map_from_world * vec4f(world_position(corner), 1.0);
    var out: Pixel;
    out.in_clip = in_map;
    out.surface = in_map;
    out.along_view = in_map.xyz;
    out.map_place = in_map.xyz;
    out.colour = in_map;
    out.shaded = in_map.xyz;
    return out;
}

@fragment
fn shadow_fragment(pixel: Pixel) -> @location(0) vec4f {
    return pixel.surface + pixel.colour + vec4f(pixel.along_view + pixel.map_place + pixel.shaded, 0.0);
}

// A hair nearer than `shape_vertex`, so that a shape does not hide itself: depth is reversed.
@vertex
fn place_vertex(corner: Corner) -> @invariant @builtin(position) vec4f {
    var in_clip = globals.clip_from_world * vec4f(world_position(corner), 1.0);
    in_clip.z *= 1.0005;
    return in_clip;
}

@fragment
fn mask_fragment() -> @location(0) vec4f {
    return vec4f(1.0);
}
