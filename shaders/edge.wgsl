// Edges of shapes, a pixel wide, outside the shape: full at the edge and nothing a pixel away. Follows `shape.wgsl`.

struct EdgeLine {
    @location(0) from_in_world: vec3f,
    @location(1) to_in_world: vec3f,
    @location(2) from_normal: vec3f,
    @location(3) to_normal: vec3f,
    @location(4) colour: vec3f,
    // As of a corner.
    @location(5) finish: vec4f,
}

struct EdgePixel {
    @builtin(position) in_clip: vec4f,
    // The colour in the shade and in the sun.
    @location(0) dark: vec3f,
    @location(1) lit: vec3f,
    @location(2) map_position: vec3f,
    @location(3) @interpolate(linear) opacity: f32,
}

@vertex
fn edge_vertex(@builtin(vertex_index) index: u32, edge: EdgeLine) -> EdgePixel {
    let pixel = pixel_of(edge, index);
    return EdgePixel(pixel.in_clip, shape_light(pixel, 0.0), shape_light(pixel, 1.0), pixel.map_position, opacity_of(index));
}

@vertex
fn ghost_edge_vertex(@builtin(vertex_index) index: u32, edge: EdgeLine) -> EdgePixel {
    let pixel = pixel_of(edge, index);
    let ghost = ghost_colour(pixel);
    return EdgePixel(pixel.in_clip, ghost.rgb, ghost.rgb, pixel.map_position, ghost.a * opacity_of(index));
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

@fragment
fn edge_fragment(edge: EdgePixel) -> @location(0) vec4f {
    return finished_light(mix(edge.dark, edge.lit, sun_arriving(edge.map_position)), edge.opacity, edge.in_clip);
}

@fragment
fn ghost_edge_fragment(edge: EdgePixel) -> @location(0) vec4f {
    return vec4f(edge.lit, edge.opacity);
}
