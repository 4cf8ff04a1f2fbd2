//! Refined pictures against what geometry says. Without a GPU adapter these tests fail; Mesa's software one will do.

mod support;

use glam::{Affine3A, Quat, Vec3};
use inbetween::export::{Painter, Size};
use inbetween::frame::{Dot, Frame, Ghost, Lens};
use inbetween::lighting::Lighting;
use inbetween::render::{Background, Gpu, Image, Offscreen, Refinement, Refiner, Renderer, SubFrame};
use inbetween::scene::Shape;
use inbetween::scene::shapes::{Plane, RoundedBox};
use support::{frame, ground, item, sample_items, view};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 240;

const BACKGROUND: Background = Background::Colour(Vec3::splat(0.8));

struct Studio {
    gpu: Gpu,
    offscreen: Offscreen,
}

impl Studio {
    fn new() -> Self {
        let gpu = Gpu::headless().expect("a GPU adapter");
        let offscreen = Offscreen::new(&gpu, WIDTH, HEIGHT).expect("a target");
        Self { gpu, offscreen }
    }

    fn plain(&mut self, frame: &Frame) -> Image {
        let mut renderer = Renderer::new(&self.gpu, Offscreen::FORMAT, 1);
        self.offscreen.render(&self.gpu, &mut renderer, frame).expect("a picture")
    }

    fn refined(&mut self, refinement: Refinement, frame: &Frame) -> Image {
        self.moving(refinement, |_| frame.clone())
    }

    /// A picture of what moves while the shutter is open.
    fn moving(&mut self, refinement: Refinement, at: impl Fn(&SubFrame) -> Frame) -> Image {
        let mut refiner = Refiner::new(&self.gpu, Offscreen::FORMAT, refinement);
        refiner.set_background(BACKGROUND);
        let mut last = None;
        while let Some(sub_frame) = refiner.next() {
            let mut frame = at(&sub_frame);
            refiner.add(&self.gpu, &mut frame, [WIDTH, HEIGHT]);
            last = Some(frame);
        }
        self.offscreen.clear();
        self.offscreen.submit_refined(&self.gpu, &mut refiner, &last.expect("at least one"));
        self.offscreen.read(&self.gpu).expect("a picture").rows().to_image()
    }
}

/// A refinement whose light is that of plain pictures.
fn without_sky_light(sub_frames: u32) -> Refinement {
    Refinement { sky_light: false, ..Refinement::of(sub_frames) }
}

/// A channel of a pixel in linear light, 0 to 1.
fn light(image: &Image, x: u32, y: u32) -> f64 {
    let byte = f64::from(image.pixel(x, y).expect("inside")[1]) / 255.0;
    if byte <= 0.04045 { byte / 12.92 } else { ((byte + 0.055) / 1.055).powf(2.4) }
}

/// The tone curve of the shaders, back to light before it.
fn before_tones(light: f64) -> f64 {
    (1.0 - (1.0 - 0.94 * light).sqrt()) / 0.47
}

/// A wide wall that stands across the view at a depth, its upper edge at a height, turned about the view.
fn wall(colour: &str, depth: f32, top: f32, turn: f32) -> inbetween::frame::DrawItem {
    let shape = Shape::Box(RoundedBox { size: Vec3::new(40.0, 20.0, 0.02), bevel: 0.0 });
    let turned = Affine3A::from_quat(Quat::from_rotation_z(turn));
    item(shape, colour, turned * Affine3A::from_translation(Vec3::new(0.0, top - 10.0, -depth)))
}

/// A view from the origin, in which a unit at distance 1 is `HEIGHT` / (2 tan 30°) pixels.
fn from_origin() -> inbetween::frame::View {
    view(Affine3A::IDENTITY, WIDTH as f32 / HEIGHT as f32)
}

fn pixels_per_slope() -> f32 {
    HEIGHT as f32 / (2.0 * 30.0_f32.to_radians().tan())
}

#[test]
fn ground_without_anything_on_it_is_as_bright_as_in_the_plain_picture() {
    let mut studio = Studio::new();
    let frame = frame(vec![ground()]);
    let plain = studio.plain(&frame);
    for refinement in [Refinement::of(2), Refinement::of(64), without_sky_light(64)] {
        let refined = studio.refined(refinement, &frame);
        let [one, other] = [&plain, &refined].map(|image| {
            // Near the eye, lines and all.
            let pixels = (220..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)));
            pixels.map(|(x, y)| light(image, x, y)).sum::<f64>()
        });
        assert!((other / one - 1.0).abs() <= 0.01, "{refinement:?}: {one} and {other}");
    }
}

#[test]
fn the_same_picture_has_the_same_bytes() {
    let mut studio = Studio::new();
    let frame = frame(sample_items().into_iter().map(|(_, item)| item).collect());
    let [first, second] = [(), ()].map(|()| studio.refined(Refinement::of(16), &frame));
    assert!(first.rgba == second.rgba);
    // Also after another picture, and in parts of a run.
    let mut refiner = Refiner::new(&studio.gpu, Offscreen::FORMAT, Refinement::of(16));
    refiner.set_background(BACKGROUND);
    let other = frame_of_walls();
    drop(studio.offscreen.render_refined(&studio.gpu, &mut refiner, &other));
    let third = studio.offscreen.render_refined(&studio.gpu, &mut refiner, &frame).expect("a picture");
    assert!(first.rgba == third.rgba, "after another picture");
}

fn frame_of_walls() -> Frame {
    Frame { items: vec![wall("#404040", 4.0, 0.3, 0.02)], ..Frame::empty(from_origin()) }
}

/// The integral of the filter, a Blackman-Harris window 1.5 pixels wide, before a distance from its middle in pixels.
fn filter_before(px: f64) -> f64 {
    let place = (px / 1.5 + 0.5).clamp(0.0, 1.0);
    let term = |wave: f64, a: f64| a * (std::f64::consts::TAU * wave * place).sin() / (std::f64::consts::TAU * wave);
    place + (term(1.0, -0.488_29) + term(2.0, 0.141_28) + term(3.0, -0.011_68)) / 0.358_75
}

#[test]
fn an_edge_that_is_nearly_level_has_the_steps_of_the_filter() {
    let mut studio = Studio::new();
    let slope = (1.0_f32 / 16.0).atan();
    let frame = Frame { items: vec![wall("#303030", 4.0, 0.0, slope)], ..Frame::empty(from_origin()) };
    let image = studio.refined(without_sky_light(64), &frame);
    let (middle_x, middle_y) = (f64::from(WIDTH) / 2.0, f64::from(HEIGHT) / 2.0);
    let (mut checked, mut worst) = (0, 0.0_f64);
    for x in 20..WIDTH - 21 {
        // The edge's height at a pixel's middle, and light above and below it.
        let edge_y = |x: u32| middle_y - (f64::from(x) + 0.5 - middle_x) / 16.0;
        let y = edge_y(x).floor() as u32;
        let [above, below] = [light(&image, x, y - 4), light(&image, x, y + 4)].map(before_tones);
        let covered = |x: u32| (before_tones(light(&image, x, y)) - above) / (below - above);
        // The filter is round neither in x nor in y, but the edge is nearly level: along it only the vertical part matters.
        let expected = |x: u32| filter_before(f64::from(y) + 0.5 - edge_y(x));
        let step = (covered(x + 1) - covered(x)).abs();
        let expected = (expected(x + 1) - expected(x)).abs();
        worst = worst.max(step - expected);
        checked += 1;
    }
    assert!(checked > 200 && worst <= 0.06, "{worst} of the contrast more than the filter says");
}

#[test]
fn the_shadow_of_a_wide_sun_is_as_soft_as_geometry_says() {
    let mut studio = Studio::new();
    // Seen from straight above: level ground at 0, and a thin bar across the sun's way, high above it.
    let high = 1.0;
    let sun = Vec3::new(-0.5, 0.78, 0.5).normalize();
    let level = Vec3::new(sun.x, 0.0, sun.z).normalize();
    let across = Vec3::Y.cross(level);
    let axes = glam::Mat3::from_cols(level, Vec3::Y, across);
    // The board's edge that shades is 0 along the sun's way; the board reaches far towards the sun from there.
    let size = Vec3::new(3.0, 0.002, 3.0);
    let place = Vec3::Y * high + level * 1.5;
    let board =
        item(Shape::Box(RoundedBox { size, bevel: 0.0 }), "#808080", Affine3A::from_mat3_translation(axes, place));
    let floor = item(Shape::Plane(Plane { size: [40.0, 40.0] }), "#7d8791", Affine3A::IDENTITY);
    let edge = -level * (high * (sun.x.hypot(sun.z) / sun.y));
    // The eye looks from below the board, straight down at the shadow's edge, so that nothing else is in view; up is towards the sun.
    let eye = edge + Vec3::Y * 0.9;
    let world_from_eye = Affine3A::from_mat3_translation(glam::Mat3::from_cols(-across, level, Vec3::Y), eye);
    let frame = Frame { items: vec![floor, board], ..Frame::empty(view(world_from_eye, WIDTH as f32 / HEIGHT as f32)) };
    let [(wide, expected), (real, least)] = [5.0, Lighting::SUN_DEGREES].map(|degrees| {
        let refinement = Refinement { sun_degrees: Some(degrees), ..without_sky_light(256) };
        (softness_px(&studio.refined(refinement, &frame)), thrown_softness_px(high, sun, degrees))
    });
    assert!((wide / expected - 1.0).abs() <= 0.05, "{wide} pixels, expected {expected}");
    // A texel of the shadow map: it covers about 3 units with 300 of them, and the eye is 0.9 above the ground.
    let texel_px = 3.0 / 300.0 / 0.9 * f64::from(pixels_per_slope());
    assert!((real - least).abs() <= texel_px, "{real} pixels, expected {least} within {texel_px}");
}

/// The rows between the places at which a quarter and three quarters of the sun are seen, down the middle of a picture.
fn softness_px(image: &Image) -> f64 {
    // Down the middle column, a little beside the grid's line.
    let x = WIDTH / 2 + 17;
    let column: Vec<f64> = (0..HEIGHT).map(|y| before_tones(light(image, x, y))).collect();
    let (most, least) = (column.iter().copied().fold(0.0, f64::max), column.iter().copied().fold(9.0, f64::min));
    let part = |y: usize| (column[y] - least) / (most - least);
    // The places at which a quarter and three quarters of the sun are seen, between pixels.
    let at = |wanted: f64| {
        let y = (1..column.len()).find(|&y| (part(y - 1) - wanted) * (part(y) - wanted) <= 0.0).expect("a place");
        (y - 1) as f64 + (wanted - part(y - 1)) / (part(y) - part(y - 1))
    };
    (at(0.75) - at(0.25)).abs()
}

/// The same by geometry, for an edge at a height, seen from 0.9 above the ground.
fn thrown_softness_px(high: f32, sun: Vec3, degrees: f32) -> f64 {
    // A disc is cut in a quarter and three quarters at 0.404 of its radius from the middle (acos(d) - d sqrt(1 - d²) = pi / 4).
    let half = f64::from(degrees).to_radians() / 2.0 * 0.404;
    let thrown = |angle: f64| f64::from(high) / (f64::from(sun.y.asin()) + angle).tan();
    (thrown(-half) - thrown(half)) / 0.9 * f64::from(pixels_per_slope())
}

#[test]
fn what_moves_is_blurred_by_the_integral_of_its_motion() {
    let mut studio = Studio::new();
    // The upper edge of a wall rises by 60 pixels while the shutter is open.
    let depth = 4.0;
    let rise = 60.0 / pixels_per_slope() * (depth - 0.01);
    let at = |shutter: f64| {
        let top = rise * (shutter as f32 - 0.5);
        Frame { items: vec![wall("#303030", depth, top, 0.0)], ..Frame::empty(from_origin()) }
    };
    let image = studio.moving(without_sky_light(64), |sub_frame| at(sub_frame.shutter));
    let x = WIDTH / 2;
    let [above, below] = [HEIGHT / 2 - 40, HEIGHT / 2 + 40].map(|y| before_tones(light(&image, x, y)));
    for y in HEIGHT / 2 - 27..HEIGHT / 2 + 27 {
        let covered = (before_tones(light(&image, x, y)) - above) / (below - above);
        let expected = (f64::from(y) + 0.5 - (f64::from(HEIGHT) / 2.0 - 30.0)) / 60.0;
        assert!((covered - expected).abs() <= 0.02, "row {y}: {covered}, expected {expected}");
    }
}

#[test]
fn a_lens_keeps_its_focus_sharp_and_blurs_the_rest_by_its_width() {
    let mut studio = Studio::new();
    let lens = Lens { radius: 0.1, focus_distance: 4.0 };
    let width_of = |studio: &mut Studio, depth: f32| {
        let items = vec![wall("#303030", depth + 0.01, 0.0, 0.0)];
        let image =
            studio.refined(without_sky_light(256), &Frame { items, lens: Some(lens), ..Frame::empty(from_origin()) });
        let x = WIDTH / 2;
        let parts: Vec<f64> = (0..HEIGHT).map(|y| before_tones(light(&image, x, y))).collect();
        let (most, least) = (parts[10], parts[HEIGHT as usize - 10]);
        parts.iter().filter(|&&part| (0.25..0.75).contains(&((part - least) / (most - least)))).count()
    };
    assert!(width_of(&mut studio, 4.0) <= 1, "sharp at the focus");
    for depth in [2.0_f32, 12.0] {
        // The circle of confusion, of which the middle half of an edge takes 0.404 of its diameter.
        let circle_px = 2.0 * lens.radius * (depth - 4.0).abs() / 4.0 / depth * pixels_per_slope();
        let expected = 0.404 * circle_px;
        let found = width_of(&mut studio, depth) as f32;
        assert!((found - expected).abs() <= 1.5, "at {depth}: {found} rows, expected {expected}");
    }
}

#[test]
fn undersides_are_darker_and_feet_stand() {
    let mut studio = Studio::new();
    let block = item(
        Shape::Box(RoundedBox { size: Vec3::ONE, bevel: 0.02 }),
        "#b0b0b0",
        Affine3A::from_translation(Vec3::new(0.0, -1.5, 0.0)),
    );
    let [bare, stood] = [vec![ground()], vec![ground(), block]].map(|items| {
        let frame = frame(items);
        [without_sky_light(64), Refinement::of(64)].map(|refinement| studio.refined(refinement, &frame))
    });
    // On the sunny side of the block (the sun is to the left and towards the eye) just before it, and far to the left of it.
    let darker = |images: &[Image; 2], x, y| light(&images[1], x, y) / light(&images[0], x, y);
    let (near, far) = (darker(&stood, 120, 232), darker(&stood, 8, 215));
    assert!(near < 0.93, "the sky is hidden at the block's foot: {near}");
    assert!((far - 1.0).abs() < 0.03, "and not far from it: {far}");
    assert!((darker(&bare, 120, 232) - 1.0).abs() < 0.005, "nor without the block");
}

#[test]
fn what_is_no_part_of_the_scene_is_drawn_once_over_it() {
    let mut studio = Studio::new();
    let behind = Vec3::new(0.0, -1.0, 0.0);
    let mut frame = frame(sample_items().into_iter().map(|(_, item)| item).collect());
    let colour = glam::Vec4::new(1.0, 0.2, 0.0, 1.0);
    frame.dots = vec![Dot { centre_in_world: behind, colour, diameter_px: 12.0 }];
    for item in frame.items.iter_mut().filter(|item| !item.is_ground()).take(1) {
        item.outlined = true;
    }
    let plain = studio.plain(&frame);
    let refined = studio.refined(Refinement::of(16), &frame);
    let scene = Frame { dots: Vec::new(), ..frame.clone() };
    let scene = Frame {
        items: scene.items.iter().map(|item| inbetween::frame::DrawItem { outlined: false, ..*item }).collect(),
        ..scene
    };
    let without = studio.refined(Refinement::of(16), &scene);
    let (mut overlaid, mut alike) = (0, 0);
    for y in 0..HEIGHT {
        for x in 0..WIDTH {
            if refined.pixel(x, y) != without.pixel(x, y) {
                overlaid += 1;
                alike += usize::from(refined.pixel(x, y) == plain.pixel(x, y));
            }
        }
    }
    // All of them but those at borders, which cover a part of a pixel.
    assert!(overlaid > 100 && alike * 2 > overlaid, "{alike} of {overlaid}");
}

#[test]
fn a_transparent_background_stays_transparent() {
    let mut studio = Studio::new();
    let mut refiner = Refiner::new(&studio.gpu, Offscreen::FORMAT, without_sky_light(16));
    refiner.set_background(Background::Transparent);
    let frame = frame_of_walls();
    let image = studio.offscreen.render_refined(&studio.gpu, &mut refiner, &frame).expect("a picture");
    assert_eq!(image.pixel(WIDTH / 2, 5), Some([0, 0, 0, 0]));
    let [.., opacity] = image.pixel(WIDTH / 2, HEIGHT - 5).expect("inside");
    assert_eq!(opacity, 255);
    let edge: Vec<u8> = (0..HEIGHT).map(|y| image.pixel(WIDTH / 2, y).expect("inside")[3]).collect();
    assert!(edge.iter().any(|opacity| (20..235).contains(opacity)), "its edge is smooth");
    // The colour of a pixel that is covered in part is that of the shape.
    let inside = image.pixel(WIDTH / 2, HEIGHT - 5).expect("inside");
    for y in 0..HEIGHT {
        let pixel = image.pixel(WIDTH / 2, y).expect("inside");
        if (100..255).contains(&pixel[3]) {
            assert!(pixel[..3].iter().zip(&inside[..3]).all(|(one, other)| one.abs_diff(*other) < 30), "{pixel:?}");
        }
    }
}

/// A picture of a frame as exports make it.
fn exported(refinement: Refinement, frame: &Frame) -> Image {
    let mut painter = Painter::headless(Size { width: WIDTH, height: HEIGHT }, Some(1)).expect("an adapter");
    painter.refine(Some(refinement));
    painter.set_background(BACKGROUND);
    painter.image(frame).expect("a picture")
}

#[test]
fn the_edges_of_ghosts_are_smooth_in_exports() {
    let slope = (1.0_f32 / 16.0).atan();
    let ghost = Ghost { item: wall("#303030", 4.0, 0.0, slope), opacity: 0.5, moment: None };
    let frame = Frame { ghosts: vec![ghost], ..Frame::empty(from_origin()) };
    let image = exported(without_sky_light(16), &frame);
    assert!(image.rgba == exported(without_sky_light(16), &frame).rgba);
    let (middle_x, middle_y) = (f64::from(WIDTH) / 2.0, f64::from(HEIGHT) / 2.0);
    for x in 20..WIDTH - 21 {
        let edge_y = middle_y - (f64::from(x) + 0.5 - middle_x) / 16.0;
        let y = edge_y.floor() as u32;
        let [above, below] = [light(&image, x, y - 4), light(&image, x, y + 4)];
        assert!(above - below > 0.1, "there is a ghost");
        let covered = (light(&image, x, y) - above) / (below - above);
        let expected = filter_before(f64::from(y) + 0.5 - edge_y);
        // Eight places, and a margin for the last level of a byte.
        assert!((covered - expected).abs() < 1.2 / 8.0, "{covered} and {expected} at {x}");
    }
}

#[test]
fn moments_of_a_strobe_are_exposed_for_their_part_and_smooth() {
    let slope = (1.0_f32 / 16.0).atan();
    let behind = wall("#c0c0c0", 8.0, 12.0, 0.0);
    let item = wall("#303030", 4.0, 0.0, slope);
    let of = |items| Frame { items, ..Frame::empty(from_origin()) };
    let refinement = Refinement::of(64);
    let [without, with] = [of(vec![behind]), of(vec![behind, item])].map(|frame| exported(refinement, &frame));
    for (moment, opacity) in [(0, 0.25_f32), (1, 0.5), (7, 0.75)] {
        let ghosts = vec![Ghost { item, opacity, moment: Some(moment) }];
        let image = exported(refinement, &Frame { ghosts, ..of(vec![behind]) });
        for (x, y) in [(60, 200), (160, 170), (250, 230)] {
            let [off, on, found] = [&without, &with, &image].map(|image| before_tones(light(image, x, y)));
            let part = (found - off) / (on - off);
            // As a ghost that faces the eye.
            assert!((part - 0.75 * f64::from(opacity)).abs() < 0.06, "{part} for {opacity} at {x}, {y}");
        }
        // Its edge covers pixels as the filter says, but that fewer sub-frames have it.
        let worst = (20..WIDTH - 21).map(|x| {
            let edge_y = f64::from(HEIGHT) / 2.0 - (f64::from(x) + 0.5 - f64::from(WIDTH) / 2.0) / 16.0;
            let y = edge_y.floor() as u32;
            let [above, below, found] = [y - 4, y + 4, y].map(|y| before_tones(light(&image, x, y)));
            ((found - above) / (below - above) - filter_before(f64::from(y) + 0.5 - edge_y)).abs()
        });
        let worst = worst.fold(0.0, f64::max);
        assert!(worst < 0.15, "{worst} for {opacity}");
    }
}
