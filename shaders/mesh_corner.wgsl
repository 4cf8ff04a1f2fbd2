// Vertices of meshes of triangles, transformed by their instances. Stands in place of `corner.wgsl`.

struct Corner {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) world_from_shape_x: vec4f,
    @location(3) world_from_shape_y: vec4f,
    @location(4) world_from_shape_z: vec4f,
    // x: the first joint's index. y: the length in the mesh of a unit of the world.
    @location(5) first_joint_and_scale: vec4f,
    @location(6) colour: vec3f,
    @location(7) node: u32,
    // What `given_back` takes. w is the opacity of ghosts.
    @location(8) finish: vec4f,
}

fn world_position(corner: Corner) -> vec3f {
    let in_shape = vec4f(corner.position, 1.0);
    return vec3f(
        dot(corner.world_from_shape_x, in_shape),
        dot(corner.world_from_shape_y, in_shape),
        dot(corner.world_from_shape_z, in_shape),
    );
}

// The cofactor matrix transforms normals for any affine that does not mirror.
fn world_normal(corner: Corner) -> vec3f {
    return normal_by(corner.world_from_shape_x.xyz, corner.world_from_shape_y.xyz, corner.world_from_shape_z.xyz, corner.normal);
}
