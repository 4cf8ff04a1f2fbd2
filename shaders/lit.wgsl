// The shadow map, and places in it.

@group(1) @binding(0) var sun_map: texture_depth_2d;
@group(1) @binding(1) var sun_map_sampler: sampler_comparison;

// The position of a point in the shadow map: texture coordinates and depth. The point is moved off its surface, more at grazing sun, so
// that the surface does not shadow itself.
fn map_position(in_world: vec3f, normal_in_world: vec3f) -> vec3f {
    let facing = dot(normal_in_world, globals.towards_light_in_world.xyz);
    let lift = globals.towards_light_in_world.w * (0.6 + 1.6 * saturate(1.0 - facing));
    let in_map = globals.map_from_world * vec4f(in_world + normal_in_world * lift, 1.0);
    return vec3f(in_map.xy * vec2f(0.5, -0.5) + 0.5, in_map.z);
}
