// Shapes except planes, and their ghosts.

@vertex
fn shape_vertex(corner: Corner) -> Pixel {
    return shape_vertex_of(corner);
}

fn shape_vertex_of(corner: Corner) -> Pixel {
    let in_world = world_position(corner);
    let normal = world_normal(corner);
    var out: Pixel;
    out.in_clip = globals.clip_from_world * vec4f(in_world, 1.0);
    out.surface = vec4f(normal, ambient_arriving(in_world.y, normal.y));
    out.along_view = globals.eye_in_world.xyz - in_world;
    out.map_position = map_position(in_world, normal);
    out.colour = vec4f(corner.colour, corner.finish.w);
    out.shaded = corner.finish.xyz;
    return out;
}

@fragment
fn shape_fragment(pixel: Pixel) -> @location(0) vec4f {
    return finished_light(shape_light(pixel, sun_arriving(pixel.map_position)), 1.0, pixel.in_clip);
}

// The light that comes from a shape to the eye. `in_map`: of the light of the shadow map, the part that arrives.
fn shape_light(pixel: Pixel, in_map: f32) -> vec3f {
    let normal = normalize(pixel.surface.xyz);
    let arriving = light_arriving(normal, dot(normal, towards_sun()), in_map);
    let light = shape_given_back(pixel, normal, arriving.y);
    return light.ambient + light.sun * arriving.x;
}

fn shape_given_back(pixel: Pixel, normal: vec3f, sky_arriving: f32) -> GivenBack {
    let finish = vec4f(pixel.shaded, pixel.colour.w);
    return given_back(pixel.colour.rgb, finish, normal, normalize(pixel.along_view), sky_arriving, pixel.surface.w);
}

// Slightly farther (depth is reversed), so that a ghost exactly on its shape stays hidden.
@vertex
fn ghost_vertex(corner: Corner) -> Pixel {
    var out = shape_vertex_of(corner);
    out.in_clip.z *= 0.997;
    return out;
}

@fragment
fn ghost_fragment(pixel: Pixel) -> @location(0) vec4f {
    return ghost_colour(pixel);
}

fn ghost_colour(pixel: Pixel) -> vec4f {
    let normal = normalize(pixel.surface.xyz);
    let facing = max(dot(normal, normalize(pixel.along_view)), 0.0);
    let rim = pow2(pow2(1.0 - facing));
    let shade = 0.78 + 0.3 * dot(normal, globals.towards_sun_in_world.xyz);
    let colour = pixel.colour.rgb * shade + vec3f(0.35) * rim;
    return finished(min(colour, vec3f(0.93)), saturate(pixel.colour.w * (0.75 + 1.3 * rim)));
}

// Depth only, in a pass whose colour target must not change.
@fragment
fn nothing_fragment() -> @location(0) vec4f {
    return vec4f(0.0);
}
