// Where shapes are, and nothing else of them.

@vertex
fn shadow_vertex(corner: Corner) -> @builtin(position) vec4f {
    return globals.map_from_world * vec4f(world_position(corner), 1.0);
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
