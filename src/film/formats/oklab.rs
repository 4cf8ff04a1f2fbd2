//! Colours by how far apart they look: OKLab (Björn Ottosson, 2020), lightness and two opponent colours.

use crate::colour::{linear_from_srgb, srgb_from_linear};

/// Lightness from 0 to 1, green to red, blue to yellow.
pub type Lab = [f32; 3];

/// The OKLab colour of red, green and blue in sRGB, each from 0 to 255.
pub fn from_levels(levels: [f32; 3]) -> Lab {
    let linear = levels.map(|level| linear_from_srgb(level / 255.0));
    let cones = times(
        [
            [0.412_221_46, 0.536_332_55, 0.051_445_995],
            [0.211_903_5, 0.680_699_5, 0.107_396_96],
            [0.088_302_46, 0.281_718_85, 0.629_978_7],
        ],
        linear,
    );
    times(
        [
            [0.210_454_26, 0.793_617_8, -0.004_072_047],
            [1.977_998_5, -2.428_592_2, 0.450_593_7],
            [0.025_904_037, 0.782_771_77, -0.808_675_77],
        ],
        // In double precision, so that all systems round to the same value.
        cones.map(|cone| f64::from(cone).cbrt() as f32),
    )
}

/// Red, green and blue in sRGB of an OKLab colour, the nearest that there are.
pub fn to_levels(lab: Lab) -> [u8; 3] {
    let cones = times(
        [[1.0, 0.396_337_78, 0.215_803_76], [1.0, -0.105_561_346, -0.063_854_17], [1.0, -0.089_484_18, -1.291_485_5]],
        lab,
    );
    let linear = times(
        [
            [4.076_741_7, -3.307_711_6, 0.230_969_94],
            [-1.268_438, 2.609_757_4, -0.341_319_38],
            [-0.004_196_086_3, -0.703_418_6, 1.707_614_7],
        ],
        cones.map(|cone| cone * cone * cone),
    );
    linear.map(|channel| (255.0 * srgb_from_linear(channel.clamp(0.0, 1.0))).round() as u8)
}

/// The square of the distance of two colours.
pub fn distance_squared(a: Lab, b: Lab) -> f32 {
    (0..3).map(|part| (a[part] - b[part]) * (a[part] - b[part])).sum()
}

fn times(matrix: [[f32; 3]; 3], vector: [f32; 3]) -> [f32; 3] {
    matrix.map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_is_light_and_without_colour_and_levels_come_back() {
        let [lightness, a, b] = from_levels([255.0; 3]);
        assert!((lightness - 1.0).abs() < 1e-4 && a.abs() < 1e-4 && b.abs() < 1e-4);
        // A value of the reference implementation: red.
        let red = from_levels([255.0, 0.0, 0.0]);
        assert!(distance_squared(red, [0.627_955, 0.224_863, 0.125_846]) < 1e-7, "{red:?}");
        for levels in [[0, 0, 0], [255, 0, 0], [12, 200, 77], [3, 2, 1], [90, 120, 250]] {
            assert_eq!(to_levels(from_levels(levels.map(f32::from))), levels);
        }
    }
}
