// Vertices of meshes with a skin, transformed by their joints. Stands in place of `corner.wgsl`. As `src/blend/skin.rs` computes them.

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
    @location(12) joints: vec4u,
    @location(13) weights: vec4f,
}

// For each joint three texels: the rows of shape space in the bind pose to world space. 256 joints a row.
@group(3) @binding(0) var joint_rows: texture_2d<f32>;

fn blended_row(corner: Corner, row: u32) -> vec4f {
    let first = u32(corner.first_joint_and_scale.x);
    var sum = vec4f(0.0);
    for (var influence = 0u; influence < 4u; influence++) {
        let joint = first + corner.joints[influence];
        sum += corner.weights[influence] * textureLoad(joint_rows, vec2u((joint % 256u) * 3u + row, joint / 256u), 0);
    }
    return sum;
}

fn world_position(corner: Corner) -> vec3f {
    let in_shape = vec4f(corner.position, 1.0);
    return vec3f(
        dot(blended_row(corner, 0u), in_shape),
        dot(blended_row(corner, 1u), in_shape),
        dot(blended_row(corner, 2u), in_shape),
    );
}

fn world_normal(corner: Corner) -> vec3f {
    return normal_by(blended_row(corner, 0u).xyz, blended_row(corner, 1u).xyz, blended_row(corner, 2u).xyz, corner.normal);
}
