// Vertices of shapes, transformed by their instances.

struct Corner {
    @location(0) core: vec3f,
    @location(1) normal: vec3f,
    @location(2) world_from_shape_x: vec4f,
    @location(3) world_from_shape_y: vec4f,
    @location(4) world_from_shape_z: vec4f,
    @location(5) half_extents_and_rounding: vec4f,
    @location(6) colour: vec3f,
    @location(7) node: u32,
    // What `given_back` takes. w is the opacity of ghosts.
    @location(8) finish: vec4f,
}

fn shape_position(corner: Corner) -> vec3f {
    let rounding = corner.half_extents_and_rounding.w;
    return corner.core * (corner.half_extents_and_rounding.xyz - rounding) + corner.normal * rounding;
}

fn world_position(corner: Corner) -> vec3f {
    let in_shape = vec4f(shape_position(corner), 1.0);
    return vec3f(
        dot(corner.world_from_shape_x, in_shape),
        dot(corner.world_from_shape_y, in_shape),
        dot(corner.world_from_shape_z, in_shape),
    );
}

// The cofactor matrix transforms normals for any affine that does not mirror.
fn world_normal(corner: Corner) -> vec3f {
    let x = corner.world_from_shape_x.xyz;
    let y = corner.world_from_shape_y.xyz;
    let z = corner.world_from_shape_z.xyz;
    let n = corner.normal;
    return normalize(vec3f(dot(cross(y, z), n), dot(cross(z, x), n), dot(cross(x, y), n)));
}
