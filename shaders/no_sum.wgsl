// No sub-frame: nothing is added.
fn added(light: vec4f, in_pixels: vec4f) -> vec4f {
    return light;
}
