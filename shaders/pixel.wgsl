// The interface between vertex and fragment shaders. Shapes, planes, the sky and the shadow map use the same components, so that a software
// driver compiles the code between the two stages once; it does so in every process.
struct Pixel {
    @invariant @builtin(position) in_clip: vec4f,
    // Shapes: the normal in world space, and the fraction of ambient light that the ground does not block. Planes: in scene units along the
    // plane's own x and z, then both from -1 to 1. Sky: in pixels from the top left corner, then the noise's coefficients.
    @location(0) surface: vec4f,
    // Shapes: to the eye in world space. Planes: from the eye, along the plane's x, normal and z. Sky: from the eye.
    @location(1) along_view: vec3f,
    // The position in the shadow map. Sky: coefficients of the gradient from horizon to zenith, and the noise's factor.
    @location(2) map_position: vec3f,
    // Shapes: colour and metalness; of ghosts opacity. Planes: colour in the sun; density of the haze, as one over a distance squared. Sky: colour at the
    // zenith, and the noise's height.
    @location(3) @interpolate(flat) colour: vec4f,
    // Shapes: the rest of the finish. Planes: colour in the shade. Sky: colour at the horizon.
    @location(4) @interpolate(flat) shaded: vec3f,
}
