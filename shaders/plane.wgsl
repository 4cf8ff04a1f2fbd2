// Planes, with their grid.

// The part of the sun's light that the ground shows: it is less yellow there than on shapes.
const GROUND_OF_SUN: vec3f = vec3f(0.875, 0.9167, 0.9853);

@vertex
fn plane_vertex(corner: Corner) -> Pixel {
    let in_world = world_position(corner);
    let normal = world_normal(corner);
    let x_axis = vec3f(corner.world_from_shape_x.x, corner.world_from_shape_y.x, corner.world_from_shape_z.x);
    let z_axis = vec3f(corner.world_from_shape_x.z, corner.world_from_shape_y.z, corner.world_from_shape_z.z);
    let scale = vec2f(length(x_axis), length(z_axis));
    let from_eye = in_world - globals.eye_in_world.xyz;
    let half_extents = corner.half_extents_and_rounding.xz * scale;
    let sun = max(dot(normal, globals.towards_sun_in_world.xyz), 0.0);
    let fill = mix(globals.ground.xyz, globals.sky.xyz, 0.5 + 0.5 * normal.y);
    // The lit ground has its own colour at any exposure.
    let ground = corner.colour / globals.ground.w;
    let height = dot(normal, from_eye);
    let haze_distance = 30.0 + 6.0 * abs(height);
    // How much the sub-frame's shadow map counts where its light arrives.
    let facing_light = max(dot(normal, globals.towards_light_in_world.xyz), 0.0);
    let counts = globals.weights.x * facing_light / max(sun, 1e-3) + globals.weights.y * facing_light * (0.5 + 0.5 * normal.y);
    var out: Pixel;
    out.in_clip = globals.clip_from_world * vec4f(in_world, 1.0);
    out.surface = vec4f(corner.core.xz * half_extents, corner.core.xz);
    out.along_view = vec3f(dot(x_axis, from_eye) / scale.x, height, dot(z_axis, from_eye) / scale.y);
    out.map_position = map_position(in_world, normal);
    out.colour = vec4f(untoned(ground * (fill + globals.sun.xyz * GROUND_OF_SUN * sun)), select(1.0 / haze_distance, counts, IS_SUB_FRAME));
    out.shaded = untoned(ground * fill);
    return out;
}

// The part of a pixel that is covered by lines of `width` at whole numbers along both axes. `footprint` is the pixel's size, `pixels` one
// over that.
fn lines_cover(on_plane: vec2f, width: f32, footprint: vec2f, pixels: vec2f) -> f32 {
    // In pixels: lines are at least one wide, and at most half of the gap.
    let drawn = min(max(width * pixels, vec2f(1.0)), 0.5 * pixels);
    let from_line = abs(fract(on_plane + 0.5) - 0.5) * pixels;
    // Widened lines are fainter.
    let cover = saturate(0.5 * drawn + 0.5 - from_line) * clamp(width * pixels, vec2f(2.0 * width), vec2f(1.0));
    // Lines closer than pixels become their average.
    let blended = mix(cover, vec2f(width), saturate(footprint * 2.0 - 0.6));
    return max(blended.x, blended.y);
}

@fragment
fn plane_fragment(pixel: Pixel) -> @location(0) vec4f {
    let from_eye = pixel.along_view;
    let grid = pixel.surface.xy;
    let squared = dot(from_eye, from_eye);
    let distance = sqrt(squared);
    let size = globals.eye_in_world.w * distance;
    let footprint = size * (1.0 + abs(from_eye.xz) / max(abs(from_eye.y), 0.001));
    let pixels = 1.0 / footprint;
    let fine = lines_cover(grid, 0.014, footprint, pixels);
    let coarse = lines_cover(grid * 0.2, 0.006, footprint * 0.2, pixels * 5.0);
    let unmarked = 1.0 - max(0.20 * fine, 0.36 * coarse);
    let arriving = sun_arriving(pixel.map_position);
    // The ground fades into the horizon with distance, and before the edge of a wide plane.
    var density = pixel.colour.w;
    if IS_SUB_FRAME {
        density = 1.0 / (30.0 + 6.0 * abs(from_eye.y));
    }
    let hazes = distance * density;
    let haze = 1.0 - exp2(-hazes * sqrt(hazes));
    let towards_edge = max(abs(pixel.surface.z), abs(pixel.surface.w));
    let edge = saturate((towards_edge - 0.55) * 2.4) * saturate(squared * 0.0002 - 0.1);
    let hidden = max(haze, edge * edge);
    if IS_SUB_FRAME {
        // As `light_arriving`: the light without shadows, and how that of the shadow map's light differs.
        let is_of_sky = globals.weights.y > 0.0;
        let share = select(pixel.colour.rgb - pixel.shaded, pixel.shaded, is_of_sky);
        let where_lit = select(globals.weights.x, pixel.colour.w, is_of_sky);
        let ground = pixel.colour.rgb + share * (pixel.colour.w * arriving - where_lit);
        return added(vec4f(mix(ground * unmarked, globals.horizon.xyz, hidden), 1.0), pixel.in_clip);
    }
    let ground = mix(pixel.shaded, pixel.colour.rgb, arriving) * unmarked;
    return finished_light(mix(ground, globals.horizon.xyz, hidden), 1.0, pixel.in_clip);
}
