// What corners hand to pixels. Shapes, planes, the sky and the sun's map read the same components of it, and so share what a
// software driver compiles between corners and pixels: it does so anew in every process.
struct Pixel {
    @invariant @builtin(position) in_clip: vec4f,
    // Shapes: the normal in world space, and how much of the ambient light the ground lets through.
    // Planes: in scene units along the plane's own x and z, then both from -1 to 1.
    // Sky: in pixels from the top left corner, then what the noise is made of.
    @location(0) surface: vec4f,
    // Shapes: to the eye in world space. Planes: from the eye, along the plane's x, normal and z. Sky: from the eye.
    @location(1) along_view: vec3f,
    // Where it is looked up in the sun's map. Sky: how it climbs from horizon to zenith, and the noise's factor.
    @location(2) map_place: vec3f,
    // Shapes: colour and opacity. Planes: colour in the sun; how far the haze begins to close, as one over a distance squared.
    // Sky: colour at the zenith, and the noise's height.
    @location(3) @interpolate(flat) colour: vec4f,
    // Shapes: colour under what the ground throws back. Planes: colour in the shade. Sky: colour at the horizon.
    @location(4) @interpolate(flat) shaded: vec3f,
}
