// Positions of meshes whose surfaces have holes: those parts are passed over whose opacity is below the material's cutoff.

struct MaskedPixel {
    @invariant @builtin(position) in_clip: vec4f,
    // Texture coordinates, the mip level, and the vertex's opacity.
    @location(0) place: vec4f,
    @location(1) @interpolate(flat) node: u32,
}

fn masked(corner: Corner, surface: Surface, in_world: vec3f, in_clip: vec4f) -> MaskedPixel {
    let texels = surface.texels * corner.first_joint_and_scale.y;
    var out: MaskedPixel;
    out.in_clip = in_clip;
    out.place = vec4f(
        surface.coordinates,
        mip_level(texels, in_world - globals.eye_in_world.xyz, world_normal(corner)),
        surface.colour.a,
    );
    out.node = corner.node + 1u;
    return out;
}

fn pass_over_holes(pixel: MaskedPixel) {
    if base_colour(pixel.place.xy, pixel.place.z).a * pixel.place.w < material.cutoff {
        discard;
    }
}

@vertex
fn masked_shadow_vertex(corner: Corner, surface: Surface) -> MaskedPixel {
    let in_world = world_position(corner);
    return masked(corner, surface, in_world, globals.map_from_world * vec4f(in_world, 1.0));
}

// As `position_vertex`.
@vertex
fn masked_position_vertex(corner: Corner, surface: Surface) -> MaskedPixel {
    let in_world = world_position(corner);
    var in_clip = globals.clip_from_world * vec4f(in_world, 1.0);
    in_clip.z *= 1.0005;
    return masked(corner, surface, in_world, in_clip);
}

// As `ghost_vertex`.
@vertex
fn masked_ghost_vertex(corner: Corner, surface: Surface) -> MaskedPixel {
    let in_world = world_position(corner);
    var in_clip = globals.clip_from_world * vec4f(in_world, 1.0);
    in_clip.z *= 0.997;
    return masked(corner, surface, in_world, in_clip);
}

// As `identity_vertex`.
@vertex
fn masked_identity_vertex(corner: Corner, surface: Surface) -> MaskedPixel {
    let in_world = world_position(corner);
    return masked(corner, surface, in_world, globals.clip_from_world * vec4f(in_world, 1.0));
}

@fragment
fn masked_fragment(pixel: MaskedPixel) -> @location(0) vec4f {
    pass_over_holes(pixel);
    return vec4f(1.0);
}

@fragment
fn masked_identity_fragment(pixel: MaskedPixel) -> @location(0) u32 {
    pass_over_holes(pixel);
    return pixel.node;
}
