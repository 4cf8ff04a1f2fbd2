// Shapes: placed by their instances, lit by a warm sun, a cool sky and what the ground throws back.

struct Corner {
    @location(0) core: vec3f,
    @location(1) normal: vec3f,
    @location(2) world_from_shape_x: vec4f,
    @location(3) world_from_shape_y: vec4f,
    @location(4) world_from_shape_z: vec4f,
    @location(5) half_extents_and_rounding: vec4f,
    @location(6) colour: vec3f,
    @location(7) node: u32,
    @location(8) opacity: f32,
}

const SUN: vec3f = vec3f(0.96, 0.84, 0.68);
const SKY_FILL: vec3f = vec3f(0.33, 0.39, 0.47);
const BOUNCE: vec3f = vec3f(0.20, 0.185, 0.17);
const EXPOSURE: f32 = 1.22;
// The ground is lit to its own colour, whatever the exposure.
const GROUND_SUN: vec3f = vec3f(0.84, 0.77, 0.67);

@group(1) @binding(0) var sun_map: texture_depth_2d;
@group(1) @binding(1) var sun_map_sampler: sampler_comparison;

// Taps along each side of the soft shadow's square; where the CPU draws 1, which stands for two across a diagonal.
override SHADOW_TAPS: i32 = 1;

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

// The cofactor matrix carries normals through any affine that does not mirror.
fn world_normal(corner: Corner) -> vec3f {
    let x = corner.world_from_shape_x.xyz;
    let y = corner.world_from_shape_y.xyz;
    let z = corner.world_from_shape_z.xyz;
    let n = corner.normal;
    return normalize(vec3f(dot(cross(y, z), n), dot(cross(z, x), n), dot(cross(x, y), n)));
}

// Where a point is looked up in the sun's map: texture coordinates and depth. The point is lifted off its surface, more
// where the sun grazes it, so that the surface does not shade itself.
fn map_place(in_world: vec3f, normal_in_world: vec3f) -> vec3f {
    let facing = dot(normal_in_world, globals.towards_sun_in_world.xyz);
    let lift = globals.towards_sun_in_world.w * (0.6 + 1.6 * saturate(1.0 - facing));
    let place = globals.map_from_world * vec4f(in_world + normal_in_world * lift, 1.0);
    return vec3f(place.xy * vec2f(0.5, -0.5) + 0.5, place.z);
}

// How much of the sun arrives, 0 to 1.
fn sun_arriving(place: vec3f) -> f32 {
    let depth = min(place.z, 1.0);
    let texel = 1.0 / vec2f(textureDimensions(sun_map));
    if SHADOW_TAPS == 1 {
        // Two across a diagonal: the steps of slanting borders run into each other.
        let half = 0.55 * texel;
        return 0.5 * (textureSampleCompareLevel(sun_map, sun_map_sampler, place.xy + half, depth)
            + textureSampleCompareLevel(sun_map, sun_map_sampler, place.xy - half, depth));
    }
    let first = -0.5 * f32(SHADOW_TAPS - 1);
    var sum = 0.0;
    for (var y = 0; y < SHADOW_TAPS; y++) {
        for (var x = 0; x < SHADOW_TAPS; x++) {
            let offset = (vec2f(f32(x), f32(y)) + first) * texel;
            sum += textureSampleCompareLevel(sun_map, sun_map_sampler, place.xy + offset, depth);
        }
    }
    return sum / f32(SHADOW_TAPS * SHADOW_TAPS);
}

// What shapes and planes hand to their pixels. Both read the same components of it, and so share what a software driver compiles
// between corners and pixels.
struct ShapePixel {
    @invariant @builtin(position) in_clip: vec4f,
    // Shapes: the normal in world space, and how much of the ambient light the ground lets through.
    // Planes: in scene units along the plane's own x and z, then both from -1 to 1.
    @location(0) surface: vec4f,
    // Shapes: to the eye in world space. Planes: from the eye, along the plane's x, normal and z.
    @location(1) along_view: vec3f,
    @location(2) map_place: vec3f,
    // Shapes: colour and opacity. Planes: colour in the sun; how far the haze begins to close, as one over a distance squared.
    @location(3) @interpolate(flat) colour: vec4f,
    // Shapes: colour under what the ground throws back. Planes: colour in the shade.
    @location(4) @interpolate(flat) shaded: vec3f,
}

@vertex
fn shape_vertex(corner: Corner) -> ShapePixel {
    return shape_vertex_of(corner);
}

// Near the ground less light comes from the side, and least from below.
fn ambient_arriving(height_in_world: f32, upwards: f32) -> f32 {
    let above = max(height_in_world - globals.zenith.w, 0.0);
    return 1.0 - (0.34 - 0.22 * upwards) * exp2(-4.0 * above);
}

fn shape_vertex_of(corner: Corner) -> ShapePixel {
    let in_world = world_position(corner);
    let normal = world_normal(corner);
    var out: ShapePixel;
    out.in_clip = globals.clip_from_world * vec4f(in_world, 1.0);
    out.surface = vec4f(normal, ambient_arriving(in_world.y, normal.y));
    out.along_view = globals.eye_in_world.xyz - in_world;
    out.map_place = map_place(in_world, normal);
    out.colour = vec4f(corner.colour, corner.opacity);
    out.shaded = corner.colour * BOUNCE;
    return out;
}

// A shoulder that keeps the brightest faces short of white, and a floor short of black.
fn toned(colour: vec3f) -> vec3f {
    let bounded = min(colour, vec3f(1.9));
    return max(bounded * (1.0 - 0.235 * bounded), vec3f(0.003));
}

@fragment
fn shape_fragment(pixel: ShapePixel) -> @location(0) vec4f {
    let normal = normalize(pixel.surface.xyz);
    let to_eye = normalize(pixel.along_view);
    let to_sun = globals.towards_sun_in_world.xyz;
    let arriving = sun_arriving(pixel.map_place);
    let sun = max(dot(normal, to_sun), 0.0) * arriving;
    let ambient = pixel.surface.w * (pixel.shaded + pixel.colour.rgb * ((SKY_FILL - BOUNCE) * (0.5 + 0.5 * normal.y)));
    // A gentle highlight, and the sky at grazing angles.
    let half_way = normalize(to_sun + to_eye);
    let h2 = pow2(max(dot(normal, half_way), 0.0));
    let h8 = pow2(pow2(h2));
    let highlight = pow2(h8) * h8 * sun;
    let rim = pow2(pow2(1.0 - max(dot(normal, to_eye), 0.0)));
    let lit = ambient + pixel.colour.rgb * (SUN * sun) + SUN * (0.16 * highlight) + SKY_FILL * (rim * (0.22 + 0.2 * normal.y));
    return finished(toned(lit * EXPOSURE), pixel.colour.w);
}

fn pow2(x: f32) -> f32 {
    return x * x;
}

@vertex
fn plane_vertex(corner: Corner) -> ShapePixel {
    let in_world = world_position(corner);
    let normal = world_normal(corner);
    let x_axis = vec3f(corner.world_from_shape_x.x, corner.world_from_shape_y.x, corner.world_from_shape_z.x);
    let z_axis = vec3f(corner.world_from_shape_x.z, corner.world_from_shape_y.z, corner.world_from_shape_z.z);
    let scale = vec2f(length(x_axis), length(z_axis));
    let from_eye = in_world - globals.eye_in_world.xyz;
    let half_extents = corner.half_extents_and_rounding.xz * scale;
    let sun = max(dot(normal, globals.towards_sun_in_world.xyz), 0.0);
    let fill = mix(BOUNCE, SKY_FILL, 0.5 + 0.5 * normal.y);
    let height = dot(normal, from_eye);
    let haze_distance = 30.0 + 6.0 * abs(height);
    var out: ShapePixel;
    out.in_clip = globals.clip_from_world * vec4f(in_world, 1.0);
    out.surface = vec4f(corner.core.xz * half_extents, corner.core.xz);
    out.along_view = vec3f(dot(x_axis, from_eye) / scale.x, height, dot(z_axis, from_eye) / scale.y);
    out.map_place = map_place(in_world, normal);
    out.colour = vec4f(corner.colour * (fill + GROUND_SUN * sun), 1.0 / (haze_distance * haze_distance));
    out.shaded = corner.colour * fill;
    return out;
}

// How much of a pixel lines of `width` at whole numbers cover along both axes; `footprint` is the pixel's size.
fn lines_cover(place: vec2f, width: f32, footprint: vec2f) -> f32 {
    let drawn = clamp(vec2f(width), footprint, vec2f(0.5));
    let from_line = abs(fract(place + 0.5) - 0.5);
    let cover = saturate((0.5 * drawn + 0.5 * footprint - from_line) / footprint) * min(width / drawn, vec2f(1.0));
    // Lines closer than pixels become their average.
    let blended = mix(cover, vec2f(width), saturate(footprint * 2.0 - 0.6));
    return max(blended.x, blended.y);
}

@fragment
fn plane_fragment(pixel: ShapePixel) -> @location(0) vec4f {
    let from_eye = pixel.along_view;
    let grid = pixel.surface.xy;
    let squared = dot(from_eye, from_eye);
    let size = globals.eye_in_world.w * sqrt(squared);
    let footprint = size * (1.0 + abs(from_eye.xz) / max(abs(from_eye.y), 0.001));
    let fine = lines_cover(grid, 0.014, footprint);
    let coarse = lines_cover(grid * 0.2, 0.006, footprint * 0.2);
    let ground = mix(pixel.shaded, pixel.colour.rgb, sun_arriving(pixel.map_place));
    let marked = ground * (1.0 - max(0.20 * fine, 0.36 * coarse));
    // The ground melts into the horizon with distance, and before a wide plane ends.
    let haze = 1.0 - exp2(-squared * pixel.colour.w);
    let towards_edge = max(abs(pixel.surface.z), abs(pixel.surface.w));
    let edge = saturate((towards_edge - 0.55) * 2.4) * saturate(squared * 0.0002 - 0.1);
    return finished(mix(marked, globals.horizon.xyz, max(haze, edge * edge)), 1.0);
}

@vertex
fn shadow_vertex(corner: Corner) -> @builtin(position) vec4f {
    return globals.map_from_world * vec4f(world_position(corner), 1.0);
}

// A hair nearer than `shape_vertex`, so that a shape does not hide itself: depth is reversed.
@vertex
fn place_vertex(corner: Corner) -> @invariant @builtin(position) vec4f {
    var in_clip = globals.clip_from_world * vec4f(world_position(corner), 1.0);
    in_clip.z *= 1.0005;
    return in_clip;
}

// For depth alone, where the pass has a colour target that must stay as it is.
@fragment
fn nothing_fragment() -> @location(0) vec4f {
    return vec4f(0.0);
}

@fragment
fn mask_fragment() -> @location(0) vec4f {
    return vec4f(1.0);
}

// A hair behind its place, so that a ghost exactly on its shape stays hidden: depth is reversed.
@vertex
fn ghost_vertex(corner: Corner) -> ShapePixel {
    var out = shape_vertex_of(corner);
    out.in_clip.z *= 0.997;
    return out;
}

@fragment
fn ghost_fragment(pixel: ShapePixel) -> @location(0) vec4f {
    let normal = normalize(pixel.surface.xyz);
    let facing = max(dot(normal, normalize(pixel.along_view)), 0.0);
    let rim = pow2(pow2(1.0 - facing));
    let shade = 0.78 + 0.3 * dot(normal, globals.towards_sun_in_world.xyz);
    let colour = pixel.colour.rgb * shade + vec3f(0.35) * rim;
    return finished(min(colour, vec3f(0.93)), saturate(pixel.colour.w * (0.75 + 1.3 * rim)));
}
