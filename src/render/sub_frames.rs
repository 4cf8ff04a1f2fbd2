//! The sub-frames of a refined picture: for each its place in the pixel, on the lens, in the shutter's time, and its light.
//!
//! Every sub-frame takes one point of a set that covers all of these evenly: four dimensions of an Owen-scrambled Sobol sequence and one for
//! the time, and lattices for the points of the sun's disc and of the sky. A point depends on the sub-frame's number alone, so that a
//! picture has the same bytes each time, and what stands still in a film stands still in its pixels.
//!
//! Accumulation: Haeberli and Akeley, "The Accumulation Buffer", 1990. Scrambling: Burley, "Practical Hash-based Owen Scrambling", 2020.

use std::f32::consts::{FRAC_PI_4, TAU};

use glam::{Affine3A, Vec2, Vec3};

use crate::film::Quality;
use crate::frame::{GOLDEN, Lens, View};
use crate::lighting::Lighting;
use crate::render::light::Light;

/// Width and height of the pixel filter, a Blackman-Harris window, in pixels.
const FILTER_PX: f64 = 1.5;
/// Of so many sub-frames one has a shadow map of the sun, the others of the sky.
const SUN_EVERY: u32 = 2;

/// How a picture is refined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refinement {
    /// The number of sub-frames, at least 2.
    pub sub_frames: u32,
    /// The diameter of the sun as one sees it, in degrees, 0 to 90. 0 is a point, whose shadows are sharp. `None`: the frame's lighting
    /// says it.
    pub sun_degrees: Option<f32>,
    /// Whether shapes hide the sky from each other and from the ground.
    pub sky_light: bool,
}

impl Refinement {
    /// A refinement with this number of sub-frames, the sun of the frame and light of the sky.
    #[must_use]
    pub const fn of(sub_frames: u32) -> Self {
        Self { sub_frames, sun_degrees: None, sky_light: true }
    }

    /// The refinement of a quality; `None` for the plain picture.
    #[must_use]
    pub fn of_quality(quality: Quality) -> Option<Self> {
        quality.is_refined().then(|| Self::of(quality.sub_frames()))
    }

    /// The sub-frames with the sun's shadow map.
    const fn of_sun(&self) -> u32 {
        if self.sky_light { self.sub_frames.div_ceil(SUN_EVERY) } else { self.sub_frames }
    }

    /// The sub-frame of a number below [`Self::sub_frames`].
    #[must_use]
    pub fn sub_frame(&self, number: u32) -> SubFrame {
        let of_sun = self.of_sun();
        let every = if self.sky_light { SUN_EVERY } else { 1 };
        let is_of_sun = number.is_multiple_of(every);
        // Those of the sun come first in the sequence, so that both kinds are whole pieces of it.
        let of_kind = if is_of_sun { number / every } else { number - number / every - 1 };
        let index = if is_of_sun { of_kind } else { of_sun + of_kind };
        let [x, y, u, v, time] = [0, 1, 2, 3, 4].map(|dimension| sobol(index, dimension));
        let count = if is_of_sun { of_sun } else { self.sub_frames - of_sun };
        SubFrame {
            from_pixel_px: Vec2::new(filtered(x), filtered(y)),
            on_lens: on_disc(u as f32, v as f32),
            shutter: time,
            number,
            of_light: lattice(of_kind, count),
            ratio: self.sub_frames as f32 / count as f32,
            is_of_sun,
        }
    }
}

/// One of the pictures whose mean is a refined picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SubFrame {
    /// From the pixel's middle, in pixels: right and down.
    from_pixel_px: Vec2,
    /// The point of the lens, which is the unit disc.
    on_lens: Vec2,
    /// The part of the shutter's time that has passed, 0 to 1.
    pub shutter: f64,
    number: u32,
    /// The place on the sun's disc or in the sky: both coordinates 0 to 1.
    of_light: [f64; 2],
    /// Sub-frames for each with a light of its kind.
    ratio: f32,
    /// Whether its shadow map is of the sun; else it is of the sky.
    is_of_sun: bool,
}

impl SubFrame {
    /// The light of its shadow map.
    pub(super) fn light(&self, lighting: &Lighting) -> Light {
        let [along, around] = self.of_light;
        let (towards_in_world, [of_sun, of_sky]) = if self.is_of_sun {
            let half_angle = lighting.sun_degrees.to_radians() * 0.5;
            (point_of_sun(lighting.towards_sun_in_world, half_angle, along, around), [self.ratio, 0.0])
        } else {
            (point_of_sky(along, around), [0.0, 2.0 * self.ratio])
        };
        Light {
            towards_in_world,
            turn: Some((f64::from(self.number) * GOLDEN).fract() as f32 * TAU),
            of_sun,
            of_sky,
            of_mean: 1.0 / (self.number + 1) as f32,
            ..Light::plain(lighting)
        }
    }

    /// A view moved to this sub-frame's place in the pixel, and on the lens if there is one. `size_px`: the picture's.
    #[must_use]
    pub fn view(&self, view: &View, lens: Option<Lens>, size_px: [u32; 2]) -> View {
        let mut view = *view;
        let size = Vec2::new(size_px[0] as f32, size_px[1] as f32);
        let mut to_right_and_up = self.from_pixel_px * Vec2::new(-2.0, 2.0) / size;
        if let Some(lens) = lens {
            let from_middle = self.on_lens * lens.radius;
            // What is in focus stays where it is.
            let slopes = Vec2::new(view.clip_from_eye.x_axis.x, view.clip_from_eye.y_axis.y);
            to_right_and_up += slopes * from_middle / lens.focus_distance;
            view.world_from_eye *= Affine3A::from_translation(from_middle.extend(0.0));
            view.eye_from_world = Affine3A::from_translation(-from_middle.extend(0.0)) * view.eye_from_world;
        }
        view.clip_from_eye.z_axis.x -= to_right_and_up.x;
        view.clip_from_eye.z_axis.y -= to_right_and_up.y;
        view
    }
}

/// A direction to a point of the sun's disc, whose middle is the sun: `along` is the part of the disc's area that is nearer the middle.
fn point_of_sun(middle: Vec3, half_angle: f32, along: f64, around: f64) -> Vec3 {
    let (x, y) = middle.any_orthonormal_pair();
    let (sin, cos) = (around as f32 * TAU).sin_cos();
    let out = half_angle.tan() * (along as f32).sqrt();
    (middle + (x * cos + y * sin) * out).normalize()
}

/// A direction to a point of the upper half of the sky, all equally likely.
fn point_of_sky(along: f64, around: f64) -> Vec3 {
    let height = along as f32;
    let (sin, cos) = (around as f32 * TAU).sin_cos();
    let out = (1.0 - height * height).sqrt();
    Vec3::new(out * cos, height, out * sin)
}

/// Point `index` of `count` that cover the unit square evenly: a Fibonacci lattice, in an order in which the first ones are far apart.
fn lattice(index: u32, count: u32) -> [f64; 2] {
    let place = u64::from(index) * u64::from(stride(count)) % u64::from(count);
    let place = place as f64;
    [(place + 0.5) / f64::from(count), ((place + 0.5) * GOLDEN).fract()]
}

/// A step of about the golden part of `count` that reaches every place.
fn stride(count: u32) -> u32 {
    let golden = (f64::from(count) * GOLDEN).round() as u32;
    (golden.max(1)..=count).find(|&step| divisor(step, count) == 1).unwrap_or(1)
}

/// The greatest common divisor.
const fn divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { divisor(b, a % b) }
}

/// A point of the unit disc, by the area-keeping map of Shirley and Chiu (1997).
fn on_disc(u: f32, v: f32) -> Vec2 {
    let [x, y] = [2.0 * u - 1.0, 2.0 * v - 1.0];
    if x == 0.0 && y == 0.0 {
        return Vec2::ZERO;
    }
    let (radius, angle) =
        if x.abs() > y.abs() { (x, FRAC_PI_4 * y / x) } else { (y, 2.0 * FRAC_PI_4 - FRAC_PI_4 * x / y) };
    Vec2::from_angle(angle) * radius
}

/// The distance in pixels from the middle of the filter, before which the part `u` of the filter lies.
fn filtered(u: f64) -> f32 {
    let [mut least, mut most] = [0.0, 1.0];
    for _ in 0..40 {
        let middle = f64::midpoint(least, most);
        if filter_before(middle) < u { least = middle } else { most = middle }
    }
    ((f64::midpoint(least, most) - 0.5) * FILTER_PX) as f32
}

/// The part of a Blackman-Harris window before a place in it, 0 to 1 (Harris 1978, four terms).
fn filter_before(place: f64) -> f64 {
    const TERMS: [f64; 4] = [0.358_75, -0.488_29, 0.141_28, -0.011_68];
    let waves = (1..4_i32).map(|wave| {
        let around = std::f64::consts::TAU * f64::from(wave);
        TERMS[wave as usize] * (around * place).sin() / around
    });
    place + waves.sum::<f64>() / TERMS[0]
}

/// Coordinate `dimension`, 0 to 4, of point `index` of a Sobol sequence, scrambled: at least 0, below 1.
fn sobol(index: u32, dimension: usize) -> f64 {
    /// Degree, inner coefficients, and first direction numbers of the primitive polynomials of dimensions 2 to 5 (Joe and Kuo, 2008).
    const POLYNOMIALS: [(usize, u32, [u32; 3]); 4] =
        [(1, 0, [1, 0, 0]), (2, 1, [1, 3, 0]), (3, 1, [1, 3, 1]), (3, 2, [1, 1, 1])];
    let bits = if dimension == 0 {
        index.reverse_bits()
    } else {
        let (degree, inner, first) = POLYNOMIALS[dimension - 1];
        let mut directions = [0_u32; 32];
        for bit in 0..32 {
            directions[bit] = if bit < degree {
                first[bit] << (31 - bit)
            } else {
                let mut direction = directions[bit - degree] ^ directions[bit - degree] >> degree;
                for term in 1..degree {
                    if inner >> (degree - 1 - term) & 1 == 1 {
                        direction ^= directions[bit - term];
                    }
                }
                direction
            };
        }
        (0..32).filter(|bit| index >> bit & 1 == 1).fold(0, |sum, bit| sum ^ directions[bit as usize])
    };
    f64::from(scrambled(bits, dimension as u32)) / f64::from(u32::MAX).next_up()
}

/// Owen scrambling by a hash of the reversed bits (Laine and Karras 2011, with the constants of Vegdahl 2021).
const fn scrambled(bits: u32, dimension: u32) -> u32 {
    let seed = (dimension + 1).wrapping_mul(0x9e37_79b9);
    let mut x = bits.reverse_bits();
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul((seed >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^= x.wrapping_mul(0x53a2_2864);
    x.reverse_bits()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_coordinate_has_one_point_in_each_part() {
        for dimension in 0..5 {
            for block in [0, 64, 192] {
                let mut taken = [false; 64];
                for index in block..block + 64 {
                    let part = (sobol(index, dimension) * 64.0) as usize;
                    assert!(!taken[part], "dimension {dimension}, point {index}");
                    taken[part] = true;
                }
            }
        }
    }

    #[test]
    fn pixels_and_lenses_are_covered_in_both_directions() {
        for pair in [[0, 1], [2, 3]] {
            for [across, up] in [[16, 4], [8, 8], [4, 16]] {
                let mut taken = vec![0; 64];
                for index in 0..64 {
                    let [x, y] = pair.map(|dimension| sobol(index, dimension));
                    taken[(x * f64::from(across)) as usize * up as usize + (y * f64::from(up)) as usize] += 1;
                }
                let most = taken.iter().max().unwrap();
                assert!(*most <= if pair == [0, 1] { 1 } else { 3 }, "{pair:?} {across} by {up}: {most}");
            }
        }
    }

    #[test]
    fn the_filter_is_as_wide_as_it_says_and_even() {
        let last = 1.0_f64.next_down();
        assert!((filtered(0.0) + 0.75).abs() < 1e-3 && (filtered(last) - 0.75).abs() < 1e-3);
        assert!(filtered(0.5).abs() < 1e-6);
        // The integral of the window from 0.25 to 0.75: 0.5 + (0.48829 - 0.01168 / 3) / (0.35875 pi).
        let within = filter_before(0.75) - filter_before(0.25);
        assert!((within - 0.92979).abs() < 1e-4, "{within}");
    }

    #[test]
    fn light_comes_from_the_sun_and_the_upper_half_alone() {
        let lighting = Lighting { sun_degrees: 5.0, ..Lighting::default() };
        let refinement = Refinement::of(64);
        let (mut of_sun, mut of_sky) = (0.0, 0.0);
        let mut cosines = 0.0;
        for number in 0..64 {
            let light = refinement.sub_frame(number).light(&lighting);
            assert!((light.towards_in_world.length() - 1.0).abs() < 1e-6);
            if light.of_sun > 0.0 {
                let away = light.towards_in_world.angle_between(lighting.towards_sun_in_world).to_degrees();
                assert!(away <= 2.5 + 1e-3, "{away}");
            } else {
                assert!(light.towards_in_world.y > 0.0);
                cosines += light.of_sky * light.towards_in_world.y;
            }
            of_sun += light.of_sun;
            of_sky += light.of_sky;
        }
        assert_eq!((of_sun, of_sky), (64.0, 128.0), "each light counts once in the mean");
        assert!((cosines / 64.0 - 1.0).abs() < 1e-5, "level ground sees all of the sky: {}", cosines / 64.0);
    }

    #[test]
    fn every_number_has_a_sub_frame_of_its_own() {
        for sub_frames in [2, 3, 5, 16, 100] {
            for sky_light in [true, false] {
                let refinement = Refinement { sky_light, ..Refinement::of(sub_frames) };
                let all: Vec<SubFrame> = (0..sub_frames).map(|number| refinement.sub_frame(number)).collect();
                let sum: f32 = all.iter().map(|one| one.light(&Lighting::default()).of_sun).sum();
                assert!((sum - sub_frames as f32).abs() < 1e-3);
                for (place, one) in all.iter().enumerate() {
                    assert!(all[..place].iter().all(|other| other.from_pixel_px != one.from_pixel_px));
                }
            }
        }
    }

    #[test]
    fn the_disc_is_covered_evenly() {
        let count = 1 << 12;
        let within = (0..count).filter(|&index| on_disc(sobol(index, 2) as f32, sobol(index, 3) as f32).length() < 0.5);
        let part = within.count() as f32 / count as f32;
        assert!((part - 0.25).abs() < 0.01, "{part}");
    }
}
