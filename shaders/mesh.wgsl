// Meshes of triangles with their materials, in the light of `shape.wgsl`. A surface of the default material looks as other shapes do.

struct MeshPixel {
    @invariant @builtin(position) in_clip: vec4f,
    @location(0) normal: vec3f,
    @location(1) in_world: vec3f,
    // Texture coordinates, then texels for each unit of the world.
    @location(2) place: vec3f,
    @location(3) colour: vec4f,
}

@vertex
fn mesh_vertex(corner: Corner, surface: Surface) -> MeshPixel {
    let in_world = world_position(corner);
    var out: MeshPixel;
    out.in_clip = globals.clip_from_world * vec4f(in_world, 1.0);
    out.normal = world_normal(corner);
    out.in_world = in_world;
    out.place = vec3f(surface.coordinates, surface.texels * corner.first_joint_and_scale.y);
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
    if base.a < material.factors.z {
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
    let to_sun = globals.towards_sun_in_world.xyz;
    let facing_sun = dot(normal, to_sun);
    let facing_eye = max(dot(normal, to_eye), 0.0);
    let arriving = light_arriving(normal, facing_sun, sun_arriving(map_position(pixel.in_world, normal)));
    let sun = arriving.x;
    let metallic = material.factors.x;
    let roughness = material.factors.y;
    let ambient = ambient_arriving(pixel.in_world.y, normal.y);
    let diffuse = base.rgb * (1.0 - metallic) * (fill_arriving(ambient, normal.y, arriving.y) + globals.sun.xyz * sun);
    // The highlight of other shapes, the twelfth power of the squared cosine between normal and half vector, is that of roughness 0.7.
    let half_squared = pow2(max(facing_sun + dot(normal, to_eye), 0.0)) / max(2.0 + 2.0 * dot(to_sun, to_eye), 0.001);
    let sharpness = 12.0 * pow2(pow2(0.7 / max(roughness, 0.12)));
    let highlight = pow(max(half_squared, 1e-9), sharpness) * sun * min(0.16 * (0.75 + sharpness / 48.0), 6.0);
    // A metal shows its surroundings in its colour: the ground below, the sky above, the more blurred the rougher it is.
    let mirrored = reflect(-to_eye, normal).y;
    let sharp = mix(8.0, 1.5, roughness);
    let surroundings = mix(globals.ground.xyz * 1.4, mix(globals.horizon.xyz, globals.zenith.xyz, saturate(mirrored)), saturate(0.5 + 0.5 * sharp * mirrored));
    let tint = mix(vec3f(1.0), base.rgb, metallic);
    let metal = base.rgb * metallic * (ambient * surroundings + globals.sun.xyz * (0.25 * sun));
    let rim = pow2(pow2(1.0 - facing_eye)) * (1.0 - 0.7 * metallic);
    let lit = diffuse + metal + tint * globals.sun.xyz * (highlight * (1.0 + 2.0 * metallic)) + globals.sky.xyz * (rim * (0.22 + 0.2 * normal.y));
    return finished_light(lit + material.emissive.rgb * globals.ground.w, 1.0, pixel.in_clip);
}
