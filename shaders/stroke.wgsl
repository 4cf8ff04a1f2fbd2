// Lines and dots: quads with a size in pixels, faded over one pixel at their borders.

struct Stroke {
    @location(0) from_in_world: vec3f,
    @location(1) to_in_world: vec3f,
    @location(2) colour: vec4f,
    @location(3) width_px: f32,
}

struct StrokePixel {
    @builtin(position) in_clip: vec4f,
    // Pixels from the middle.
    @location(0) across_px: vec2f,
    @location(1) @interpolate(flat) colour: vec4f,
    @location(2) @interpolate(flat) half_width_px: f32,
}

fn viewport_px() -> vec2f {
    return vec2f(globals.ray_right_in_world.w, globals.ray_down_in_world.w);
}

fn quad_corner(index: u32) -> vec2f {
    return vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0 - 1.0;
}

@vertex
fn line_vertex(@builtin(vertex_index) index: u32, stroke: Stroke) -> StrokePixel {
    return line_vertex_of(index, stroke);
}

// Hidden parts of a line keep little of its opacity.
@vertex
fn hidden_line_vertex(@builtin(vertex_index) index: u32, stroke: Stroke) -> StrokePixel {
    var out = line_vertex_of(index, stroke);
    out.colour.a *= 0.22;
    return out;
}

fn line_vertex_of(index: u32, stroke: Stroke) -> StrokePixel {
    let nearest = 0.01;
    var from_clip = globals.clip_from_world * vec4f(stroke.from_in_world, 1.0);
    var to_clip = globals.clip_from_world * vec4f(stroke.to_in_world, 1.0);
    var out: StrokePixel;
    out.colour = vec4f(stroke.colour.rgb, stroke.colour.a * min(stroke.width_px, 1.0));
    out.half_width_px = 0.5 * max(stroke.width_px, 1.0);
    if from_clip.w < nearest && to_clip.w < nearest {
        out.in_clip = vec4f(2.0, 2.0, 0.0, 1.0);
        return out;
    }
    if from_clip.w < nearest {
        from_clip = mix(from_clip, to_clip, (nearest - from_clip.w) / (to_clip.w - from_clip.w));
    } else if to_clip.w < nearest {
        to_clip = mix(to_clip, from_clip, (nearest - to_clip.w) / (from_clip.w - to_clip.w));
    }
    let from_px = from_clip.xy / from_clip.w * 0.5 * viewport_px();
    let to_px = to_clip.xy / to_clip.w * 0.5 * viewport_px();
    let along_px = to_px - from_px;
    let length_px = length(along_px);
    let along = select(vec2f(1.0, 0.0), along_px / max(length_px, 1e-6), length_px > 1e-6);
    let corner = quad_corner(index);
    let reach = out.half_width_px + 0.5;
    let side_px = vec2f(-along.y, along.x) * corner.y * reach;
    let end_clip = select(from_clip, to_clip, corner.x > 0.0);
    let position_px = select(from_px, to_px, corner.x > 0.0) + side_px;
    // Slightly nearer than the surface that it may lie on.
    out.in_clip = vec4f(position_px * 2.0 / viewport_px(), min(end_clip.z / end_clip.w * 1.0005, 1.0), 1.0);
    out.across_px = vec2f(0.0, corner.y * reach);
    return out;
}

@fragment
fn line_fragment(pixel: StrokePixel) -> @location(0) vec4f {
    let cover = saturate(pixel.half_width_px + 0.5 - abs(pixel.across_px.y));
    return finished(pixel.colour.rgb, pixel.colour.a * cover);
}

@vertex
fn dot_vertex(@builtin(vertex_index) index: u32, stroke: Stroke) -> StrokePixel {
    let centre = globals.clip_from_world * vec4f(stroke.from_in_world, 1.0);
    var out: StrokePixel;
    out.colour = stroke.colour;
    out.half_width_px = 0.5 * stroke.width_px;
    let offset_px = quad_corner(index) * (out.half_width_px + 1.0);
    out.across_px = offset_px;
    out.in_clip = select(vec4f(2.0, 2.0, 0.0, 1.0), vec4f(centre.xy / centre.w + offset_px * 2.0 / viewport_px(), 0.5, 1.0), centre.w > 0.01);
    return out;
}

// A disc with a darker border, so that it shows on light and dark.
@fragment
fn dot_fragment(pixel: StrokePixel) -> @location(0) vec4f {
    let from_centre = length(pixel.across_px);
    let cover = saturate(pixel.half_width_px + 0.5 - from_centre);
    let inside = saturate(pixel.half_width_px - 1.0 - from_centre);
    return finished(pixel.colour.rgb * mix(0.3, 1.0, inside), pixel.colour.a * cover);
}
