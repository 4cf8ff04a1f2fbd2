// What a mesh's vertices have besides their place, and the material of its surface.

struct Surface {
    @location(9) coordinates: vec2f,
    @location(10) colour: vec4f,
    // Texels for each unit of length of the mesh, at the texture's full size.
    @location(11) texels: f32,
}

struct Material {
    // w: 1 shows the base colour in any light.
    emissive: vec4f,
    // Of opacity.
    cutoff: f32,
    opacity: f32,
}

@group(2) @binding(0) var picture: texture_2d<f32>;
@group(2) @binding(1) var picture_sampler: sampler;
@group(2) @binding(2) var<uniform> material: Material;

// The base colour at a place, in a mip level.
fn base_colour(coordinates: vec2f, level: f32) -> vec4f {
    let of_picture = textureSampleLevel(picture, picture_sampler, coordinates, level);
    return vec4f(of_picture.rgb, of_picture.a * material.opacity);
}

// The mip level whose texels are as large as pixels. Steep surfaces take the middle between their two sides.
fn mip_level(texels_in_world: f32, from_eye: vec3f, normal: vec3f) -> f32 {
    let distance = length(from_eye);
    let facing = abs(dot(normal, from_eye)) / max(distance, 1e-6);
    let pixel = globals.eye_in_world.w * distance * inverseSqrt(clamp(facing, 0.06, 1.0));
    return log2(max(texels_in_world * pixel, 1e-6));
}
