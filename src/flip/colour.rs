//! The colour spaces of FLIP: sRGB, linear light, CIE XYZ, YCxCz (linear, in which the eye's blur is applied) and CIELAB
//! with the Hunt effect (uniform, in which colours are compared). Matrices and the white D65 as in FLIP's published sources.

use crate::colour::linear_from_srgb;

/// XYZ of linear light (1, 1, 1).
const WHITE: [f32; 3] = [0.950_428_55, 1.0, 1.088_900_4];

const XYZ_FROM_LINEAR: [[f32; 3]; 3] = [
    [0.412_386_57, 0.357_591_47, 0.180_450_49],
    [0.212_636_82, 0.715_182_96, 0.072_180_2],
    [0.019_330_62, 0.119_197_17, 0.950_372_6],
];

const LINEAR_FROM_XYZ: [[f32; 3]; 3] = [
    [3.241_003_3, -1.537_399, -0.498_615_9],
    [-0.969_224_3, 1.875_93, 0.041_554_226],
    [0.055_639_423, -0.204_011_2, 1.057_149],
];

fn times(matrix: &[[f32; 3]; 3], [x, y, z]: [f32; 3]) -> [f32; 3] {
    matrix.map(|row| row[0] * x + row[1] * y + row[2] * z)
}

/// Linear light of each 8-bit sRGB level (IEC 61966-2-1).
pub fn linear_from_srgb_levels() -> [f32; 256] {
    std::array::from_fn(|level| {
        #[expect(clippy::cast_precision_loss, reason = "levels are below 256")]
        let channel = level as f32 / 255.0;
        linear_from_srgb(channel)
    })
}

/// YCxCz: luminance from −16 to 100, and the red-green and blue-yellow opponents.
pub fn ycxcz_from_linear(linear: [f32; 3]) -> [f32; 3] {
    let xyz = times(&XYZ_FROM_LINEAR, linear);
    let [x, y, z] = [xyz[0] / WHITE[0], xyz[1] / WHITE[1], xyz[2] / WHITE[2]];
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// The inverse of [`ycxcz_from_linear`], clamped to the range of a screen.
pub fn linear_from_ycxcz([luminance, cx, cz]: [f32; 3]) -> [f32; 3] {
    let y = (luminance + 16.0) / 116.0;
    let (x, z) = (y + cx / 500.0, y - cz / 200.0);
    times(&LINEAR_FROM_XYZ, [x * WHITE[0], y * WHITE[1], z * WHITE[2]]).map(|channel| channel.clamp(0.0, 1.0))
}

/// CIELAB with the Hunt effect: dark colours appear less colourful.
pub fn hunt_lab_from_linear(linear: [f32; 3]) -> [f32; 3] {
    const DELTA: f32 = 6.0 / 29.0;
    let bent = |t: f32| if t > DELTA * DELTA * DELTA { t.cbrt() } else { t / (3.0 * DELTA * DELTA) + 4.0 / 29.0 };
    let xyz = times(&XYZ_FROM_LINEAR, linear);
    let [x, y, z] = [bent(xyz[0] / WHITE[0]), bent(xyz[1] / WHITE[1]), bent(xyz[2] / WHITE[2])];
    let lightness = 116.0 * y - 16.0;
    [lightness, 0.01 * lightness * 500.0 * (x - y), 0.01 * lightness * 200.0 * (y - z)]
}

/// The HyAB distance: the absolute difference of lightness plus the Euclidean distance of a and b.
pub fn hyab(from: [f32; 3], to: [f32; 3]) -> f32 {
    (from[0] - to[0]).abs() + (from[1] - to[1]).hypot(from[2] - to[2])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check_near(found: [f32; 3], expected: [f32; 3], slack: f32) {
        let is_near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= slack);
        assert!(is_near, "{found:?}, expected {expected:?}");
    }

    #[test]
    fn white_grey_and_black_have_no_colour() {
        check_near(ycxcz_from_linear([1.0; 3]), [100.0, 0.0, 0.0], 1e-3);
        check_near(hunt_lab_from_linear([1.0; 3]), [100.0, 0.0, 0.0], 1e-3);
        check_near(hunt_lab_from_linear([0.0; 3]), [0.0; 3], 1e-4);
        check_near(hunt_lab_from_linear([0.184_187; 3]), [50.0, 0.0, 0.0], 1e-2);
    }

    #[test]
    fn there_and_back() {
        for linear in [[0.2, 0.5, 0.9], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.01, 0.02, 0.03]] {
            check_near(linear_from_ycxcz(ycxcz_from_linear(linear)), linear, 1e-5);
        }
    }

    #[test]
    fn the_primaries_in_cielab() {
        // sRGB green is L 87.73, a −86.18, b 83.18; blue L 32.30, a 79.19, b −107.86.
        check_near(hunt_lab_from_linear([0.0, 1.0, 0.0]), [87.73, -0.8773 * 86.18, 0.8773 * 83.18], 0.05);
        check_near(hunt_lab_from_linear([0.0, 0.0, 1.0]), [32.30, 0.3230 * 79.19, -0.3230 * 107.86], 0.05);
    }
}
