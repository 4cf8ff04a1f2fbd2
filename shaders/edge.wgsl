// Edges of shapes, a pixel wide, outside the shape: full at the edge and nothing a pixel away. Follows `shape.wgsl`. Shades on the ground
// under what stands there are drawn by the same functions.

struct EdgeLine {
    @location(0) from_in_world: vec3f,
    @location(1) to_in_world: vec3f,
    @location(2) from_normal: vec3f,
    @location(3) to_normal: vec3f,
    @location(4) colour: vec3f,
    // As of a corner. Of shades x is negative, and w is the opacity at the footprint.
    @location(5) finish: vec4f,
}

@vertex
fn edge_vertex(@builtin(vertex_index) index: u32, edge: EdgeLine) -> Pixel {
    if edge.finish.x < 0.0 {
        return shade_of(edge, index);
    }
    let pixel = pixel_of(edge, index);
    let normal = pixel.surface.xyz;
    let arriving = light_arriving(normal, dot(normal, towards_sun()), 1.0);
    let light = shape_given_back(pixel, normal, arriving.y);
    return edge_pixel(pixel, light.ambient, light.ambient + light.sun * arriving.x, opacity_of(index));
}

@vertex
fn ghost_edge_vertex(@builtin(vertex_index) index: u32, edge: EdgeLine) -> Pixel {
    let pixel = pixel_of(edge, index);
    let ghost = ghost_colour(pixel);
    return edge_pixel(pixel, ghost.rgb, ghost.rgb, ghost.a * opacity_of(index));
}

// A corner of what is drawn. `surface`: the colour in the shade, and the opacity times w, which the fragment divides by w, since it changes
// evenly from pixel to pixel. `along_view`: the colour in the sun.
fn edge_pixel(corner: Pixel, dark: vec3f, lit: vec3f, opacity: f32) -> Pixel {
    return Pixel(corner.in_clip, vec4f(dark, opacity * corner.in_clip.w), lit, corner.map_position, vec4f(0.0), vec3f(0.0));
}

// Two corners lie on the edge, the others a pixel outside.
fn is_outer(index: u32) -> bool {
    return index > 1u;
}

fn opacity_of(index: u32) -> f32 {
    return select(1.0, 0.0, is_outer(index));
}

// A corner of the line as if it were a pixel of the shape.
fn pixel_of(edge: EdgeLine, index: u32) -> Pixel {
    let is_to = (index & 1u) == 1u;
    let from_in_clip = globals.clip_from_world * vec4f(edge.from_in_world, 1.0);
    let to_in_clip = globals.clip_from_world * vec4f(edge.to_in_world, 1.0);
    let in_world = select(edge.from_in_world, edge.to_in_world, is_to);
    let along_view = globals.eye_in_world.xyz - in_world;
    let half_size = 0.5 * vec2f(globals.ray_right_in_world.w, globals.ray_down_in_world.w);
    var out: Pixel;
    out.in_clip = select(from_in_clip, to_in_clip, is_to);
    // Edges that reach behind the eye are left out.
    if min(from_in_clip.w, to_in_clip.w) < 0.001 {
        out.in_clip = vec4f(0.0, 0.0, 2.0, 1.0);
    } else {
        let along = (to_in_clip.xy / to_in_clip.w - from_in_clip.xy / from_in_clip.w) * half_size;
        let outwards = vec2f(along.y, -along.x) * inverseSqrt(max(dot(along, along), 1e-12));
        out.in_clip += vec4f(select(vec2f(0.0), outwards, is_outer(index)) / half_size * out.in_clip.w, 0.0, 0.0);
        // Slightly nearer (depth is reversed), so that an edge between two faces is seen on the second.
        out.in_clip.z *= 1.0005;
    }
    // The colour is that of the shape a little inside, where it faces the eye more.
    let to_eye = normalize(along_view);
    let edge_normal = select(edge.from_normal, edge.to_normal, is_to);
    let normal = normalize(edge_normal + to_eye * max(0.5 - dot(edge_normal, to_eye), 0.0));
    out.surface = vec4f(normal, ambient_arriving(in_world.y, normal.y));
    out.along_view = along_view;
    out.map_position = map_position(in_world, normal);
    out.colour = vec4f(edge.colour, edge.finish.w);
    out.shaded = edge.finish.xyz;
    return out;
}

// A corner of a shade: of a rectangle on the ground around the centre `from_in_world`. `to_in_world` and `from_normal` are half sides of the
// footprint along the ground; x of `to_normal` is how far the shade reaches beyond it, in scene units. Of the result, `surface` is from the
// centre along both sides in scene units, and `colour` the half sides, the reach and the opacity.
fn shade_of(edge: EdgeLine, index: u32) -> Pixel {
    let signs = vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0 - 1.0;
    let half_sides = vec2f(length(edge.to_in_world), length(edge.from_normal));
    let reach = edge.to_normal.x;
    let grown = (half_sides + reach) / half_sides;
    let in_world = edge.from_in_world + edge.to_in_world * (signs.x * grown.x) + edge.from_normal * (signs.y * grown.y);
    var out: Pixel;
    out.in_clip = globals.clip_from_world * vec4f(in_world, 1.0);
    // Slightly nearer than the ground (depth is reversed).
    out.in_clip.z *= 1.0001;
    out.surface = vec4f(signs * (half_sides + reach), 0.0, 0.0);
    out.along_view = vec3f(0.0);
    out.map_position = vec3f(0.0);
    out.colour = vec4f(half_sides, reach, edge.finish.w);
    out.shaded = vec3f(0.0);
    return out;
}

@fragment
fn edge_fragment(edge: Pixel) -> @location(0) vec4f {
    if edge.colour.w > 0.0 {
        return vec4f(0.0, 0.0, 0.0, shade_opacity(edge));
    }
    let light = mix(edge.surface.rgb, edge.along_view, sun_arriving(edge.map_position));
    return finished_light(light, edge.surface.w * edge.in_clip.w, edge.in_clip);
}

fn shade_opacity(shade: Pixel) -> f32 {
    let outside = max(abs(shade.surface.xy) - shade.colour.xy, vec2f(0.0));
    let left = saturate(1.0 - length(outside) / shade.colour.z);
    let opacity = shade.colour.w * left * left;
    // A target that does not encode blends numbers that are encoded already.
    if ENCODE_SRGB {
        return 1.0 - pow(1.0 - opacity, 1.0 / 2.4);
    }
    return opacity;
}

@fragment
fn ghost_edge_fragment(edge: Pixel) -> @location(0) vec4f {
    return vec4f(edge.along_view, edge.surface.w * edge.in_clip.w);
}
