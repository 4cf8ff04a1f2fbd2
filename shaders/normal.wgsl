// A normal transformed by the rows of a matrix; 0 where the matrix makes nothing of it.
fn normal_by(x: vec3f, y: vec3f, z: vec3f, n: vec3f) -> vec3f {
    let turned = vec3f(dot(cross(y, z), n), dot(cross(z, x), n), dot(cross(x, y), n));
    return turned * inverseSqrt(max(dot(turned, turned), 1e-30));
}
