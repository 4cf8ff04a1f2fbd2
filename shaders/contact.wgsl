// The shade on the ground under a shape that stands on it or is near.

struct Contact {
    @location(0) centre_in_world: vec3f,
    // Half sides of the shape's footprint, along the ground.
    @location(1) across_in_world: vec3f,
    @location(2) deep_in_world: vec3f,
    // How far the shade reaches beyond the footprint, in scene units, and its opacity at the footprint.
    @location(3) reach_and_opacity: vec2f,
}

struct ContactPixel {
    @builtin(position) in_clip: vec4f,
    // From the centre along both sides, in scene units.
    @location(0) on_ground: vec2f,
    @location(1) @interpolate(flat) half_sides: vec2f,
    @location(2) @interpolate(flat) reach_and_opacity: vec2f,
}

@vertex
fn contact_vertex(@builtin(vertex_index) index: u32, contact: Contact) -> ContactPixel {
    let signs = vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0 - 1.0;
    let half_sides = vec2f(length(contact.across_in_world), length(contact.deep_in_world));
    let grown = (half_sides + contact.reach_and_opacity.x) / half_sides;
    let in_world = contact.centre_in_world + contact.across_in_world * (signs.x * grown.x) + contact.deep_in_world * (signs.y * grown.y);
    var out: ContactPixel;
    out.in_clip = globals.clip_from_world * vec4f(in_world, 1.0);
    // Slightly nearer than the ground (depth is reversed).
    out.in_clip.z *= 1.0001;
    out.on_ground = signs * (half_sides + contact.reach_and_opacity.x);
    out.half_sides = half_sides;
    out.reach_and_opacity = contact.reach_and_opacity;
    return out;
}

@fragment
fn contact_fragment(pixel: ContactPixel) -> @location(0) vec4f {
    let outside = max(abs(pixel.on_ground) - pixel.half_sides, vec2f(0.0));
    let left = saturate(1.0 - length(outside) / pixel.reach_and_opacity.x);
    var opacity = pixel.reach_and_opacity.y * left * left;
    // A target that does not encode blends numbers that are encoded already.
    if ENCODE_SRGB {
        opacity = 1.0 - pow(1.0 - opacity, 1.0 / 2.4);
    }
    return vec4f(0.0, 0.0, 0.0, opacity);
}
