// The index of the node that each pixel shows, plus one; 0 is none. Follows `corner.wgsl`.

struct IdentityPixel {
    @invariant @builtin(position) in_clip: vec4f,
    @location(0) @interpolate(flat) node: u32,
}

@vertex
fn identity_vertex(corner: Corner) -> IdentityPixel {
    var out: IdentityPixel;
    out.in_clip = globals.clip_from_world * vec4f(world_position(corner), 1.0);
    out.node = corner.node + 1u;
    return out;
}

@fragment
fn identity_fragment(pixel: IdentityPixel) -> @location(0) u32 {
    return pixel.node;
}
