// Meshes of triangles with their materials, in the light of `shape.wgsl`. A surface of the default material looks as other shapes do.

struct MeshPixel {
    @invariant @builtin(position) in_clip: vec4f,
    @location(0) normal: vec3f,
    @location(1) in_world: vec3f,
    // Texture coordinates, then texels for each unit of the world.
    @location(2) place: vec3f,
    @location(3) colour: vec4f,
    @location(4) @interpolate(flat) finish: vec4f,
}

@vertex
fn mesh_vertex(corner: Corner, surface: Surface) -> MeshPixel {
    let in_world = world_position(corner);
    var out: MeshPixel;
    out.in_clip = globals.clip_from_world * vec4f(in_world, 1.0);
    out.normal = world_normal(corner);
    out.in_world = in_world;
    out.place = vec3f(surface.coordinates, surface.texels * corner.first_joint_and_scale.y);
    out.finish = corner.finish;
    out.colour = vec4f(corner.colour * surface.colour.rgb, surface.colour.a);
    return out;
}

@fragment
fn mesh_fragment(pixel: MeshPixel, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    return shaded(pixel, is_front, base_of(pixel));
}

@fragment
fn masked_mesh_fragment(pixel: MeshPixel, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let base = base_of(pixel);
    if base.a < material.cutoff {
        discard;
    }
    return shaded(pixel, is_front, base);
}

fn base_of(pixel: MeshPixel) -> vec4f {
    let level = mip_level(pixel.place.z, pixel.in_world - globals.eye_in_world.xyz, pixel.normal);
    return base_colour(pixel.place.xy, level) * pixel.colour;
}

fn shaded(pixel: MeshPixel, is_front: bool, base: vec4f) -> vec4f {
    if material.emissive.w > 0.5 {
        return finished_light(untoned(base.rgb), 1.0, pixel.in_clip);
    }
    let turned = pixel.normal * select(-1.0, 1.0, is_front);
    let normal = turned * inverseSqrt(max(dot(turned, turned), 1e-30));
    let to_eye = normalize(globals.eye_in_world.xyz - pixel.in_world);
    let arriving = light_arriving(normal, dot(normal, towards_sun()), sun_arriving(map_position(pixel.in_world, normal)));
    let ambient = ambient_arriving(pixel.in_world.y, normal.y);
    let light = given_back(base.rgb, pixel.finish, normal, to_eye, arriving.y, ambient);
    let lit = light.ambient + light.sun * arriving.x;
    return finished_light(lit + material.emissive.rgb * globals.ground.w, 1.0, pixel.in_clip);
}
