//! How surfaces give back light. Without a GPU adapter these tests fail; Mesa's software one will do.

mod support;

use glam::{Affine3A, Vec2, Vec3};
use inbetween::camera::Camera;
use inbetween::frame::{DrawItem, Frame};
use inbetween::lighting::Lighting;
use inbetween::render::{Background, Gpu, Image, Offscreen, Refinement, Refiner, Renderer};
use inbetween::scene::{Shape, scene_from_json, shapes::Sphere};
use inbetween::view::frame_of_scene;
use support::{item, view};

/// The exposure of shapes.
const EXPOSURE: f64 = 1.22;
const SIZE: [u32; 2] = [320, 240];
const ROUGHNESSES: [f32; 3] = [0.5, 0.75, 1.0];
const METALNESSES: [f32; 3] = [0.0, 0.5, 1.0];

struct Studio {
    gpu: Gpu,
    renderer: Renderer,
    offscreen: Offscreen,
}

impl Studio {
    fn new(size: [u32; 2]) -> Self {
        let gpu = Gpu::headless().expect("a GPU adapter");
        let renderer = Renderer::new(&gpu, Offscreen::FORMAT, 1);
        let offscreen = Offscreen::new(&gpu, size[0], size[1]).expect("a target");
        Self { gpu, renderer, offscreen }
    }

    fn plain(&mut self, frame: &Frame) -> Image {
        self.offscreen.render(&self.gpu, &mut self.renderer, frame).expect("a picture")
    }

    fn refined(&mut self, frame: &Frame) -> Image {
        let mut refiner = Refiner::new(&self.gpu, Offscreen::FORMAT, Refinement::of(64));
        refiner.set_background(Background::Sky);
        self.offscreen.render_refined(&self.gpu, &mut refiner, frame).expect("a picture")
    }
}

fn linear(byte: u8) -> f64 {
    let byte = f64::from(byte) / 255.0;
    if byte <= 0.04045 { byte / 12.92 } else { ((byte + 0.055) / 1.055).powf(2.4) }
}

/// The light that a surface gives back, from a channel of a pixel: before the tone curve and the exposure.
fn light(image: &Image, [x, y]: [u32; 2]) -> f64 {
    let shown = linear(image.pixel(x, y).expect("inside")[1]);
    (1.0 - (1.0 - 0.94 * shown).sqrt()) / 0.47 / EXPOSURE
}

/// `OKLab` of an sRGB colour (Ottosson, 2020).
fn oklab(rgb: [u8; 3]) -> [f64; 3] {
    let [r, g, b] = rgb.map(linear);
    let l = (0.412_221_47 * r + 0.536_332_54 * g + 0.051_445_99 * b).cbrt();
    let m = (0.211_903_5 * r + 0.680_699_55 * g + 0.107_396_96 * b).cbrt();
    let s = (0.088_302_46 * r + 0.281_718_85 * g + 0.629_978_7 * b).cbrt();
    [
        0.210_454_26 * l + 0.793_617_79 * m - 0.004_072_05 * s,
        1.977_998_5 * l - 2.428_592_2 * m + 0.450_593_7 * s,
        0.025_904_04 * l + 0.782_771_77 * m - 0.808_675_77 * s,
    ]
}

/// The distance of two colours in `OKLab`, times 100: about as large as CIEDE2000.
fn difference(one: [u8; 3], other: [u8; 3]) -> f64 {
    let squares = oklab(one).into_iter().zip(oklab(other)).map(|(one, other)| (one - other).powi(2));
    100.0 * squares.sum::<f64>().sqrt()
}

/// Three boxes above the ground.
const BOXES: &str = r##"{"format": "inbetween.scene", "version": 1, "name": "boxes", "eyes": ["sky"], "nodes": [
    {"name": "sky", "translation": [4.5, 2.5, 6], "rotation": {"euler_degrees": [0, 35, 0]}},
    {"name": "set", "children": [
        {"name": "ground", "shape": {"plane": {"size": [400, 400]}}, "colour": "#7d8791"},
        {"name": "a", "shape": {"box": {"size": [1, 1, 1]}}, "translation": [-2, 1.5, 0], "colour": "#c8553d"},
        {"name": "b", "shape": {"box": {"size": [1, 1, 1]}}, "translation": [0, 1.5, 0], "colour": "#3b7ea1"},
        {"name": "c", "shape": {"box": {"size": [1, 1, 1]}}, "translation": [2, 1.5, 0], "colour": "#8b919c"}]}]}"##;

#[test]
fn the_palette_is_that_of_the_first_version() {
    let scene = scene_from_json(BOXES).unwrap();
    let eye = scene.eyes()[0];
    let world_from_eye = scene.world_from_rbt(scene.rest_pose(), 0.0, eye);
    let camera = Camera { world_from_eye, vertical_fov: scene.vertical_fov(), size_px: Vec2::new(640.0, 480.0) };
    let image = Studio::new([640, 480]).plain(&frame_of_scene(&scene, scene.rest_pose(), 0.0, &camera, Some(eye)));
    for (what, [x, y], before) in [
        ("red, lit", [214, 292], [178, 78, 55]),
        ("red, shaded", [246, 290], [117, 50, 38]),
        ("blue, lit", [290, 300], [56, 114, 140]),
        ("blue, shaded", [328, 300], [36, 78, 104]),
        ("grey, lit", [394, 310], [128, 130, 135]),
        ("grey, shaded", [440, 310], [89, 96, 108]),
        ("ground, lit", [80, 440], [125, 136, 146]),
        ("ground, shaded", [490, 400], [83, 96, 111]),
    ] {
        let [r, g, b, _] = image.pixel(x, y).expect("inside");
        let found = difference([r, g, b], before);
        assert!(found <= 3.0, "{what}: {found:.2} from {before:?} to {:?}", [r, g, b]);
    }
}

/// White balls, more metal to the right and rougher upwards.
fn balls(colour: &str, lighting: Lighting) -> Frame {
    let ball = |(column, row): (usize, usize)| DrawItem {
        roughness: ROUGHNESSES[row],
        metalness: METALNESSES[column],
        ..item(Shape::Sphere(Sphere { radius: 1.4 }), colour, Affine3A::from_translation(place(column, row)))
    };
    let items = (0..9).map(|number| ball((number % 3, number / 3))).collect();
    let world_from_eye = Affine3A::from_translation(Vec3::Z * 12.0);
    Frame { items, lighting, ..Frame::empty(view(world_from_eye, SIZE[0] as f32 / SIZE[1] as f32)) }
}

fn place(column: usize, row: usize) -> Vec3 {
    Vec3::new((column as f32 - 1.0) * 3.6, (row as f32 - 1.0) * 3.6, 0.0)
}

/// Pixels of a ball: all but those at its border.
fn pixels_of(frame: &Frame, column: usize, row: usize) -> Vec<[u32; 2]> {
    let middle =
        frame.view.clip_from_eye.project_point3(frame.view.eye_from_world.transform_point3(place(column, row)));
    let [x, y] = [(0.5 + 0.5 * middle.x) * SIZE[0] as f32, (0.5 - 0.5 * middle.y) * SIZE[1] as f32];
    let radius = 0.92 * 1.4 / 12.0 / 30.0_f32.to_radians().tan() * SIZE[1] as f32 / 2.0;
    let all = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| [x, y]));
    all.filter(|pixel| (pixel[0] as f32 + 0.5 - x).hypot(pixel[1] as f32 + 0.5 - y) < radius).collect()
}

/// Light from the sky and from below that is the same everywhere, without a sun.
fn furnace(white: f32) -> Lighting {
    let shown = white * EXPOSURE as f32;
    let shown = Vec3::splat(shown * (1.0 - 0.235 * shown));
    let white = Vec3::splat(white);
    Lighting { sun: Vec3::ZERO, sky: white, ground: white, horizon: shown, zenith: shown, ..Lighting::default() }
}

#[test]
fn in_a_uniform_light_white_surfaces_give_back_what_they_get() {
    let mut studio = Studio::new(SIZE);
    let frame = balls("#ffffff", furnace(0.5));
    // In refined pictures balls hide the sky from each other.
    for (image, least) in [(studio.plain(&frame), 0.85), (studio.refined(&frame), 0.0)] {
        for (column, row) in (0..9).map(|number| (number % 3, number / 3)) {
            for pixel in pixels_of(&frame, column, row) {
                let part = light(&image, pixel) / 0.5;
                assert!((least..=1.02).contains(&part), "ball {column} {row}, pixel {pixel:?}: {part}");
            }
        }
    }
}

#[test]
fn suns_in_all_directions_give_no_surface_more_than_there_is() {
    let mut studio = Studio::new(SIZE);
    let nothing = Lighting { sky: Vec3::ZERO, ground: Vec3::ZERO, ..furnace(0.0) };
    let strength = 0.3;
    let count = 225_u16;
    let mut sums = vec![0.0; (SIZE[0] * SIZE[1]) as usize];
    for number in 0..count {
        // A Fibonacci lattice on the sphere.
        let height = 1.0 - (2.0 * f32::from(number) + 1.0) / f32::from(count);
        let (sin, cos) = (f32::from(number) * 2.399_963_2).sin_cos();
        let out = (1.0 - height * height).sqrt();
        let towards_sun_in_world = Vec3::new(out * cos, height, out * sin);
        let lighting = Lighting { towards_sun_in_world, sun: Vec3::splat(strength), ..nothing };
        let image = studio.plain(&balls("#ffffff", lighting));
        for (sum, place) in sums.iter_mut().zip(0..) {
            let light = light(&image, [place % SIZE[0], place / SIZE[0]]);
            // No picture is quite black.
            *sum += if light < 0.003 { 0.0 } else { light };
        }
    }
    let frame = balls("#ffffff", nothing);
    for (column, row) in (0..9).map(|number| (number % 3, number / 3)) {
        let places = pixels_of(&frame, column, row);
        // The mean of a surface's cosines over all directions is a quarter.
        let part = |[x, y]: [u32; 2]| 4.0 * sums[(y * SIZE[0] + x) as usize] / f64::from(count) / f64::from(strength);
        let most = places.iter().map(|&pixel| part(pixel)).fold(0.0, f64::max);
        let mean = places.iter().map(|&pixel| part(pixel)).sum::<f64>() / places.len() as f64;
        assert!(most <= 1.02 && mean >= 0.75, "ball {column} {row}: at most {most}, {mean} in the mean");
    }
}

#[test]
fn refined_balls_are_as_bright_as_plain_ones() {
    let mut studio = Studio::new(SIZE);
    let all = balls("#b08050", Lighting::default());
    for (column, row) in (0..9).map(|number| (number % 3, number / 3)) {
        // Alone, so that nothing hides the sky.
        let frame = Frame { items: vec![all.items[column + 3 * row]], ..all.clone() };
        let places = pixels_of(&frame, column, row);
        let [one, other] = [studio.plain(&frame), studio.refined(&frame)]
            .map(|image| places.iter().map(|&place| light(&image, place)).sum::<f64>());
        assert!((other / one - 1.0).abs() <= 0.01, "ball {column} {row}: {one} and {other}");
    }
}

#[test]
fn metals_mirror_in_their_own_colour_and_smooth_surfaces_have_small_highlights() {
    let mut studio = Studio::new(SIZE);
    let day = Lighting::default();
    // A weak sun, so that its highlights are not white by brightness.
    let mut frame = balls("#c04020", Lighting { sun: Vec3::splat(0.2), ..day });
    for item in &mut frame.items {
        item.roughness = if item.roughness == ROUGHNESSES[0] { 0.3 } else { 0.5 };
    }
    let image = studio.plain(&frame);
    let brightest = |column: usize, row: usize| {
        let places = pixels_of(&frame, column, row);
        let colours = places.iter().map(|&[x, y]| image.pixel(x, y).expect("inside"));
        colours.max_by_key(|colour| u32::from(colour[1])).expect("pixels")
    };
    let [of_plastic, of_metal] = [brightest(0, 0), brightest(2, 0)];
    let whiteness = |[r, _, b, _]: [u8; 4]| f64::from(b) / f64::from(r);
    assert!(whiteness(of_plastic) > 0.6 && whiteness(of_metal) < 0.6, "{of_plastic:?} and {of_metal:?}");
    let lit = |row: usize| {
        let [_, most, ..] = brightest(0, row);
        let places = pixels_of(&frame, 0, row);
        (most, places.iter().filter(|&&[x, y]| image.pixel(x, y).expect("inside")[1] > most - most / 4).count())
    };
    let [(most, count), (rough_most, rough_count)] = [lit(0), lit(1)];
    assert!(most > rough_most && count < rough_count, "{most} {count} and {rough_most} {rough_count}");
}
