// Positions of shapes only.

// The shadow map has only depth. Its fragments read all components of a picture's fragments, so that a software driver compiles the
// interface once for both (`pixel.wgsl`). The fragment's result is unused, so drivers remove its work.
@vertex
fn shadow_vertex(corner: Corner) -> Pixel {
    let in_map = globals.map_from_world * vec4f(world_position(corner), 1.0);
    var out: Pixel;
    out.in_clip = in_map;
    out.surface = in_map;
    out.along_view = in_map.xyz;
    out.map_position = in_map.xyz;
    out.colour = in_map;
    out.shaded = in_map.xyz;
    return out;
}

@fragment
fn shadow_fragment(pixel: Pixel) -> @location(0) vec4f {
    return pixel.surface + pixel.colour + vec4f(pixel.along_view + pixel.map_position + pixel.shaded, 0.0);
}

// As `shape_vertex`.
@vertex
fn depth_vertex(corner: Corner) -> @invariant @builtin(position) vec4f {
    return globals.clip_from_world * vec4f(world_position(corner), 1.0);
}

// Slightly nearer than `shape_vertex` (depth is reversed), so that a shape does not hide itself.
@vertex
fn position_vertex(corner: Corner) -> @invariant @builtin(position) vec4f {
    var in_clip = globals.clip_from_world * vec4f(world_position(corner), 1.0);
    in_clip.z *= 1.0005;
    return in_clip;
}

@fragment
fn mask_fragment() -> @location(0) vec4f {
    return vec4f(1.0);
}
