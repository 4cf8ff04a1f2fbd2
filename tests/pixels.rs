//! Scene in, pixels out. Without a GPU adapter these tests fail; Mesa's software one will do.

mod support;

use glam::{Affine3A, Quat, Vec3, Vec4};
use inbetween::frame::{ArcballMark, Dot, DrawItem, Frame, Ghost, Line};
use inbetween::render::{Arrangement, Background, Gpu, Image, Offscreen, Renderer, Target, Viewport};
use inbetween::scene::Shape;
use inbetween::scene::shapes::{Capsule, Cylinder, RoundedBox, Sphere};
use support::{frame, ground, item, posed_items, sample_items};

const WIDTH: u32 = 640;
const HEIGHT: u32 = 480;

struct Studio {
    gpu: Gpu,
    renderer: Renderer,
    offscreen: Offscreen,
}

impl Studio {
    fn new(samples: u32) -> Self {
        let gpu = Gpu::headless().expect("a GPU adapter");
        assert_eq!(gpu.info.backend, wgpu::Backend::Vulkan);
        let renderer = Renderer::new(&gpu, Offscreen::FORMAT, samples);
        let offscreen = Offscreen::new(&gpu, WIDTH, HEIGHT).expect("a target");
        Self { gpu, renderer, offscreen }
    }

    fn draw(&mut self, frame: &Frame) -> Image {
        self.offscreen.render(&self.gpu, &mut self.renderer, frame).expect("a picture")
    }
}

fn draw(frame: &Frame) -> Image {
    Studio::new(1).draw(frame)
}

fn cube(colour: &str, centre: Vec3, side: f32) -> DrawItem {
    item(
        Shape::Box(RoundedBox { size: Vec3::splat(side), bevel: 0.05 * side }),
        colour,
        Affine3A::from_translation(centre),
    )
}

fn pixel(image: &Image, x: u32, y: u32) -> [i32; 3] {
    let [r, g, b, _] = image.pixel(x, y).expect("inside the picture");
    [r, g, b].map(i32::from)
}

#[track_caller]
fn check_near(image: &Image, x: u32, y: u32, expected: [i32; 3], slack: i32) {
    let found = pixel(image, x, y);
    let is_near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= slack);
    assert!(is_near, "pixel {x} {y} is {found:?}, expected {expected:?} within {slack}");
}

/// Where a point in world space is in the picture.
fn place_px(frame: &Frame, in_world: Vec3) -> (u32, u32) {
    let in_eye = frame.view.eye_from_world.transform_point3(in_world);
    let in_clip = frame.view.clip_from_eye.project_point3(in_eye);
    (((0.5 + 0.5 * in_clip.x) * WIDTH as f32) as u32, ((0.5 - 0.5 * in_clip.y) * HEIGHT as f32) as u32)
}

#[test]
fn the_sky_is_the_horizons_colour_below_and_darkens_upwards() {
    let image = draw(&frame(Vec::new()));
    check_near(&image, 320, 400, [0xae, 0xbf, 0xce], 2);
    check_near(&image, 320, 242, [0xae, 0xbf, 0xce], 2);
    let column: Vec<i32> = (0..240).map(|y| pixel(&image, 100, y)[0]).collect();
    assert!(column.windows(2).all(|pair| pair[1] >= pair[0] - 1), "the gradient goes one way");
    assert!(column[0] < column[239] - 30);
}

#[test]
fn the_far_ground_melts_into_the_horizon() {
    let image = draw(&frame(vec![ground()]));
    for x in [0, 320, 639] {
        for y in 236..244 {
            check_near(&image, x, y, [0xae, 0xbf, 0xce], 5);
        }
    }
    check_near(&image, 350, 470, [0x7d, 0x87, 0x91], 16);
}

#[test]
fn a_red_box_is_where_it_should_be() {
    let image = draw(&frame(vec![cube("#c02020", Vec3::new(0.0, 0.25, 0.0), 1.0)]));
    let [r, g, b] = pixel(&image, 320, 240);
    assert!(r > 2 * g && r > 2 * b, "{r} {g} {b}");
    // Its front is 3.5 away, half a unit each way.
    let half_px = (0.5 / 3.5 / 30.0_f32.to_radians().tan() * 240.0) as u32;
    assert!(pixel(&image, 320 + half_px - 3, 240)[0] > 2 * pixel(&image, 320 + half_px - 3, 240)[1]);
    check_near(&image, 320 + half_px + 3, 242, [0xae, 0xbf, 0xce], 8);
}

#[test]
fn a_box_darkens_the_ground_away_from_the_sun_and_nowhere_else() {
    let without = frame(vec![ground()]);
    let mut with = without.clone();
    with.items.push(cube("#808080", Vec3::new(0.0, -1.0, -1.0), 0.5));
    let (bare, shaded) = (draw(&without), draw(&with));
    // One unit down the sun's way.
    let (x, y) = place_px(&with, Vec3::new(0.0, -1.0, -1.0) + Vec3::new(0.5, -0.78, -0.5) / 0.78);
    let (lit, dark) = (pixel(&bare, x, y)[0], pixel(&shaded, x, y)[0]);
    assert!(dark < lit - 25, "{dark} beside {lit}");
    let (x, y) = place_px(&with, Vec3::new(-1.0, -2.0, -1.0));
    assert_eq!(pixel(&bare, x, y), pixel(&shaded, x, y));
}

#[test]
fn shadows_are_the_same_in_pictures_of_other_sizes() {
    let near = Vec3::new(0.0, -1.0, -1.0);
    // One that is far off towards the sun makes the map's box deep.
    let towards_sun = Vec3::new(-0.5, 0.78, 0.5).normalize();
    let scene = frame(vec![ground(), cube("#808080", near, 0.5), cube("#808080", near + 70.0 * towards_sun, 0.1)]);
    let mut studio = Studio::new(1);
    let small = studio.draw(&scene);
    // The larger ones have a map of another kind of depth; the last shows that a map that was kept is drawn anew.
    for (times, width) in [(2, 2 * WIDTH), (3, 3 * WIDTH), (1, WIDTH)] {
        let Studio { gpu, renderer, .. } = &mut studio;
        let mut offscreen = Offscreen::new(gpu, width, times * HEIGHT).expect("a target");
        let large = offscreen.render(gpu, renderer, &scene).expect("a picture");
        let middle = |place: u32| times * place + times / 2;
        let mut others = 0;
        for (x, y) in (0..HEIGHT).step_by(3).flat_map(|y| (0..WIDTH).step_by(3).map(move |x| (x, y))) {
            let [found, expected] = [pixel(&large, middle(x), middle(y)), pixel(&small, x, y)];
            others += usize::from(found.iter().zip(expected).any(|(a, b)| (a - b).abs() > 12));
        }
        // Only at borders, of the shadow and of the box.
        assert!(others < 40, "{others} of {} pixels differ at {times} times the size", WIDTH * HEIGHT / 9);
    }
}

#[test]
fn shadows_do_not_depend_on_what_was_drawn_before() {
    let near = Vec3::new(0.0, -1.0, -1.0);
    let pair = |apart: Vec3| frame(vec![ground(), cube("#808080", near, 0.5), cube("#808080", near + apart, 0.3)]);
    // Maps of many shapes and sizes: wide ones, high ones, and one of nothing.
    let mut frames: Vec<Frame> = (0..8).map(|step| pair(Vec3::X * (0.3 * step as f32))).collect();
    frames.extend((1..4).map(|step| pair(Vec3::new(0.0, 0.4, -0.6) * step as f32)));
    frames.push(frame(vec![ground()]));
    let mut studio = Studio::new(1);
    for place in (0..frames.len()).chain((0..frames.len()).rev().step_by(2)).chain([0, 5, 0]) {
        assert!(studio.draw(&frames[place]) == draw(&frames[place]), "frame {place}");
    }
}

#[test]
fn the_same_frame_gives_the_same_bytes_and_the_same_png() {
    let frame = frame(sample_items().into_iter().map(|(_, item)| item).collect());
    let mut studio = Studio::new(1);
    let first = studio.draw(&frame);
    assert!(first == studio.draw(&frame));
    let other = draw(&frame);
    assert!(first == other, "across renderers");
    assert_eq!(first.to_png().expect("a PNG"), other.to_png().expect("a PNG"));
}

#[test]
fn a_png_reads_back_as_the_picture() {
    let image = draw(&frame(vec![ground(), cube("#c02020", Vec3::ZERO, 1.0)]));
    let read = image::load_from_memory(&image.to_png().expect("a PNG")).expect("a PNG");
    assert_eq!(read.color(), image::ColorType::Rgb8);
    assert!(read.to_rgba8().into_raw() == image.rgba);
}

#[test]
fn what_is_far_out_of_view_changes_no_byte() {
    let near = frame(sample_items().into_iter().map(|(_, item)| item).collect());
    let expected = draw(&near);
    for centre in [
        Vec3::new(300.0, 1.0, -5.0),
        Vec3::new(0.0, 0.0, 60.0),
        Vec3::new(-30.0, 3.0, 0.0),
        Vec3::new(0.0, -90.0, -5.0),
    ] {
        let mut more = near.clone();
        more.items.push(cube("#ff0000", centre, 2.0));
        assert!(draw(&more) == expected, "a box at {centre}");
    }
}

#[test]
fn the_suns_map_is_drawn_again_only_when_something_moves() {
    let mut frame = frame(sample_items().into_iter().map(|(_, item)| item).collect());
    let mut studio = Studio::new(1);
    let first = studio.draw(&frame);
    studio.draw(&frame);
    assert_eq!(studio.renderer.sun_map_draws(), 1);
    frame.items[7].world_from_shape.translation.y += 0.2;
    studio.draw(&frame);
    assert_eq!(studio.renderer.sun_map_draws(), 2);
    frame.items[7].world_from_shape.translation.y -= 0.2;
    assert!(
        studio.draw(&frame) == first
            || (studio.draw(&frame).rgba.iter().zip(&first.rgba)).all(|(a, b)| a.abs_diff(*b) < 3)
    );
}

#[test]
fn four_samples_change_edges_and_nothing_else() {
    let frame = frame(vec![ground(), cube("#c02020", Vec3::new(0.0, 0.25, 0.0), 1.0)]);
    let (one, four) = (draw(&frame), Studio::new(4).draw(&frame));
    let mut changed = 0;
    for y in 1..HEIGHT - 1 {
        for x in 1..WIDTH - 1 {
            let difference = |a: [i32; 3], b: [i32; 3]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).max().unwrap_or(0);
            let here = pixel(&one, x, y);
            if difference(here, pixel(&four, x, y)) > 12 {
                changed += 1;
                let around = [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)];
                assert!(around.iter().any(|&(x, y)| difference(here, pixel(&one, x, y)) > 12), "{x} {y} is no edge");
            }
        }
    }
    assert!(changed > 50, "{changed}");
}

#[test]
fn the_chosen_nodes_outline_is_in_the_accent_colour_and_leaves_the_rest_alone() {
    let plain = frame(vec![
        ground(),
        cube("#3060a0", Vec3::new(0.0, 0.25, 0.0), 1.0),
        cube("#3060a0", Vec3::new(0.3, 0.5, 0.0), 1.0),
    ]);
    let mut chosen = plain.clone();
    for item in &mut chosen.items[1..] {
        item.outlined = true;
    }
    for samples in [1, 4] {
        let mut studio = Studio::new(samples);
        check_outline(&studio.draw(&plain), &studio.draw(&chosen));
    }
}

fn check_outline(before: &Image, after: &Image) {
    let is_accent = |p: [i32; 3]| (p[0] - 0xf2).abs() < 4 && (p[1] - 0xa3).abs() < 4 && (p[2] - 0x3a).abs() < 4;
    let accents = (0..WIDTH * HEIGHT).filter(|i| is_accent(pixel(after, i % WIDTH, i / WIDTH))).count();
    assert!((400..6000).contains(&accents), "{accents}");
    check_near(after, 320, 240, pixel(before, 320, 240), 0);
    check_near(after, 20, 20, pixel(before, 20, 20), 0);
}

#[test]
fn ghosts_blend_once_and_cast_no_shadow() {
    let plain = frame(vec![ground()]);
    let mut with = plain.clone();
    let ghost = |side| Ghost { item: cube("#2060e0", Vec3::new(0.0, 0.25, 0.0), side), opacity: 0.4, moment: None };
    with.ghosts.push(ghost(1.0));
    let (before, one) = (draw(&plain), draw(&with));
    // A second ghost inside the first is hidden by it.
    with.ghosts.push(ghost(0.5));
    let two = draw(&with);
    let (sky, blend) = (pixel(&before, 320, 235), pixel(&one, 320, 235));
    assert!(blend[0] < sky[0] - 15 && blend[0] > 0x20, "{blend:?} over {sky:?}");
    assert_eq!(blend, pixel(&two, 320, 235));
    check_near(&one, 480, 420, pixel(&before, 480, 420), 0);
}

#[test]
fn lines_are_faint_where_hidden_and_dots_are_not() {
    let mut frame = frame(vec![cube("#3060a0", Vec3::new(0.0, 0.25, 0.0), 1.0)]);
    let plain = draw(&frame);
    let red = Vec4::new(0.8, 0.02, 0.02, 1.0);
    let (from_in_world, to_in_world) = (Vec3::new(-2.0, 0.25, -1.0), Vec3::new(2.0, 0.25, -1.0));
    frame.lines.push(Line { from_in_world, to_in_world, colour: red, width_px: 4.0 });
    let lines = draw(&frame);
    let redness = |image: &Image, x| pixel(image, x, 240)[0] - pixel(image, x, 240)[1];
    assert!(redness(&lines, 180) > 150);
    assert!(redness(&lines, 320) > redness(&plain, 320) + 10 && redness(&lines, 320) < 100, "{}", redness(&lines, 320));
    frame.lines.clear();
    frame.dots.push(Dot { centre_in_world: Vec3::new(0.0, 0.25, -1.0), colour: red, diameter_px: 9.0 });
    assert!(redness(&draw(&frame), 320) > 150);
}

#[test]
fn the_arcball_is_a_circle_of_its_size() {
    let mut frame = frame(Vec::new());
    let plain = draw(&frame);
    frame.arcball = Some(ArcballMark { centre_in_world: Vec3::new(0.0, 0.25, 0.0), radius: 1.0 });
    let marked = draw(&frame);
    let angle = (1.0_f32 / 4.0).asin();
    let radius_px = angle.tan() / 30.0_f32.to_radians().tan() * 240.0;
    let diagonal = (radius_px / 2.0_f32.sqrt()).round() as u32;
    let changed = |x, y| pixel(&marked, x, y) != pixel(&plain, x, y);
    assert!((0..3).any(|d| changed(320 + diagonal - 1 + d, 240 - diagonal)));
    assert!(!changed(320 + radius_px as u32 + 4, 240));
}

#[test]
fn a_mirrored_shape_looks_like_itself() {
    let at = Affine3A::from_translation(Vec3::new(0.0, 0.25, 0.0));
    let shape = Shape::Box(RoundedBox { size: Vec3::new(1.0, 0.6, 0.8), bevel: 0.1 });
    let plain = draw(&frame(vec![item(shape.clone(), "#c0a020", at)]));
    let mirrored = draw(&frame(vec![item(shape, "#c0a020", at * Affine3A::from_scale(Vec3::new(-1.0, 1.0, 1.0)))]));
    let differing = plain.rgba.iter().zip(&mirrored.rgba).filter(|(a, b)| a.abs_diff(**b) > 3).count();
    assert!(differing < 40, "{differing}");
}

#[test]
fn nothing_is_pure_black_or_pure_white() {
    let turned =
        posed_items(&|path| if path.contains("shoulder") { Quat::from_rotation_y(0.6) } else { Quat::IDENTITY });
    let mut items: Vec<DrawItem> = turned.into_iter().map(|(_, item)| item).collect();
    items.push(cube("#ffffff", Vec3::new(-0.6, -0.5, 0.5), 0.6));
    items.push(cube("#000000", Vec3::new(0.6, -0.5, 0.5), 0.6));
    let image = draw(&frame(items));
    for pixel in image.rgba.chunks_exact(4) {
        assert!(pixel[..3] != [0; 3] && pixel[..3] != [255; 3] && pixel[3] == 255);
    }
}

#[test]
fn a_transparent_background_has_no_opacity() {
    let mut studio = Studio::new(1);
    studio.renderer.set_background(Background::Transparent);
    let image = studio.draw(&frame(vec![cube("#c02020", Vec3::new(0.0, 0.25, 0.0), 1.0)]));
    assert_eq!(image.pixel(10, 10), Some([0; 4]));
    assert_eq!(image.pixel(320, 240).map(|pixel| pixel[3]), Some(255));
}

/// Draws into a part of a target in another format, and reads the whole target back as red, green, blue, opacity.
fn draw_into(format: wgpu::TextureFormat, frame: &Frame, viewport: Viewport) -> Image {
    let gpu = Gpu::headless().expect("a GPU adapter");
    let [width, height] = viewport.target_px;
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    });
    let mut renderer = Renderer::new(&gpu, format, 1);
    let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
    renderer.render(&gpu, frame, Target { view: &view, viewport });
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: u64::from(4 * width * height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * width), rows_per_image: None };
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo { buffer: &buffer, layout },
        texture.size(),
    );
    gpu.queue.submit([encoder.finish()]);
    buffer.map_async(wgpu::MapMode::Read, .., |result| result.expect("a mapped buffer"));
    gpu.device.poll(wgpu::PollType::wait_indefinitely()).expect("the device");
    let mut rgba = buffer.get_mapped_range(..).expect("a mapped buffer").to_vec();
    if format == wgpu::TextureFormat::Bgra8Unorm {
        rgba.chunks_exact_mut(4).for_each(|pixel| pixel.swap(0, 2));
    }
    Image { width, height, rgba }
}

#[test]
fn a_target_that_does_not_encode_gets_the_same_picture() {
    let frame = frame(sample_items().into_iter().map(|(_, item)| item).collect());
    let expected = draw(&frame);
    let found = draw_into(wgpu::TextureFormat::Bgra8Unorm, &frame, Viewport::whole(WIDTH, HEIGHT));
    let apart = |a: &[u8], b: &[u8]| a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max();
    let pixels = expected.rgba.chunks_exact(4).zip(found.rgba.chunks_exact(4));
    let differing: Vec<_> = pixels.filter_map(|(a, b)| apart(a, b)).filter(|apart| *apart > 1).collect();
    // Such a target blends encoded numbers, so that smooth edges, a pixel wide, and shades on the ground are a little darker or lighter.
    let share = differing.len() as f32 / (WIDTH * HEIGHT) as f32;
    assert!(share < 0.04, "{share}");
    assert!(differing.iter().all(|apart| *apart < 48), "{:?}", differing.iter().max());
}

#[test]
fn a_viewport_holds_the_same_picture_and_leaves_its_surroundings_clear() {
    let frame = frame(sample_items().into_iter().map(|(_, item)| item).collect());
    let expected = draw(&frame);
    let viewport = Viewport { target_px: [832, 600], x: 96, y: 40, width: WIDTH, height: HEIGHT };
    let found = draw_into(wgpu::TextureFormat::Rgba8UnormSrgb, &frame, viewport);
    let mut differing = 0;
    for y in 0..600 {
        for x in 0..832 {
            if (96..96 + WIDTH).contains(&x) && (40..40 + HEIGHT).contains(&y) {
                let (a, b) = (pixel(&expected, x - 96, y - 40), pixel(&found, x, y));
                differing += u32::from(a.iter().zip(b).any(|(a, b)| (a - b).abs() > 3));
            } else {
                check_near(&found, x, y, [0x1b, 0x1d, 0x21], 1);
            }
        }
    }
    assert!(differing < 200, "{differing}");
}

#[test]
fn a_hidden_parts_outline_is_fainter_whatever_the_samples() {
    let mut scene = frame(vec![
        ground(),
        cube("#3060a0", Vec3::new(0.0, 0.25, 0.0), 1.0),
        cube("#808080", Vec3::new(0.6, 0.25, 1.0), 0.9),
    ]);
    for samples in [1, 4] {
        scene.items[1].outlined = false;
        let mut studio = Studio::new(samples);
        let before = studio.draw(&scene);
        scene.items[1].outlined = true;
        let after = studio.draw(&scene);
        let (mut strong, mut faint) = (0, 0);
        for y in 0..HEIGHT {
            for x in 0..WIDTH {
                let change = pixel(&after, x, y)[0] - pixel(&before, x, y)[0];
                let is_accent = (pixel(&after, x, y)[2] - 0x3a).abs() < 6 && (pixel(&after, x, y)[0] - 0xf2).abs() < 6;
                strong += u32::from(is_accent);
                faint += u32::from(!is_accent && change > 12);
            }
        }
        assert!(strong > 150 && faint > 60, "{samples} samples: {strong} strong, {faint} faint");
    }
}

#[test]
fn a_picture_of_no_size_is_an_error_that_says_so() {
    let gpu = Gpu::headless().expect("a GPU adapter");
    let error = Offscreen::new(&gpu, 0, 480).expect_err("no width");
    assert!(error.to_string().starts_with("a picture of 0x480 pixels cannot be drawn"), "{error}");
}

#[test]
fn pictures_that_are_kept_stay_what_they_are_while_others_are_drawn() {
    let frames: Vec<Frame> =
        [-1.0, 0.0, 1.0, 2.0].map(|x| frame(vec![ground(), cube("#c8553d", Vec3::new(x, 0.0, 0.0), 1.0)])).into();
    let mut studio = Studio::new(1);
    let alone: Vec<Image> = frames.iter().map(|frame| studio.draw(frame)).collect();
    assert!(alone.windows(2).all(|pair| pair[0] != pair[1]));
    let Studio { gpu, renderer, offscreen } = &mut studio;
    for frame in &frames {
        offscreen.submit(gpu, renderer, frame);
    }
    assert_eq!(offscreen.under_way(), 4);
    let kept: Vec<_> = frames.iter().map(|_| offscreen.read(gpu).expect("a picture")).collect();
    // More are drawn while those are kept; one of them is never read.
    offscreen.submit(gpu, renderer, &frames[3]);
    let again = offscreen.draw(gpu, renderer, &frames[0]).expect("a picture");
    assert_eq!(offscreen.under_way(), 0);
    assert!(again.rows().to_image() == alone[0]);
    for (place, (kept, alone)) in kept.iter().zip(&alone).enumerate() {
        assert!(kept.rows().to_image() == *alone, "picture {place}");
    }
    let error = offscreen.read(gpu).expect_err("nothing is under way");
    assert!(error.to_string().ends_with("nothing was drawn"), "{error}");
}

#[test]
fn what_is_cut_away_changes_no_byte_of_the_picture() {
    let mut items = vec![ground()];
    for place in 0..900_u16 {
        let (x, z) = (f32::from(place % 30) - 15.0, f32::from(place / 30) - 15.0);
        let shape = match place % 4 {
            0 => Shape::Box(RoundedBox { size: Vec3::splat(0.7), bevel: 0.035 }),
            1 => Shape::Sphere(Sphere { radius: 0.4 }),
            2 => Shape::Cylinder(Cylinder { radius: 0.3, height: 0.8 }),
            _ => Shape::Capsule(Capsule { radius: 0.25, height: 0.9 }),
        };
        let world_from_shape = Affine3A::from_translation(Vec3::new(x, -1.6 + 0.02 * x * z, z))
            * Affine3A::from_rotation_y(0.7 * f32::from(place));
        let mut item = item(shape, "#c8553d", world_from_shape);
        item.outlined = place % 97 == 0;
        items.push(item);
    }
    let gpu = Gpu::headless().expect("a GPU adapter");
    let mut renderers = [Arrangement::SortedAndCut, Arrangement::Sorted].map(|arrangement| {
        [1, 4].map(|samples| {
            let mut renderer = Renderer::new(&gpu, Offscreen::FORMAT, samples);
            renderer.set_arrangement(arrangement);
            renderer
        })
    });
    let mut offscreen = Offscreen::new(&gpu, WIDTH, HEIGHT).expect("a target");
    let mut frame = frame(items);
    let world_from_eye = frame.view.world_from_eye;
    for turns in 0..6_u8 {
        // From among the boxes, in all directions.
        let turn = Affine3A::from_rotation_y(f32::from(turns));
        frame.view.world_from_eye = turn * Affine3A::from_translation(Vec3::new(0.0, 0.5, -3.0)) * world_from_eye;
        frame.view.eye_from_world = frame.view.world_from_eye.inverse();
        let [cut, sorted] = renderers.each_mut().map(|of_samples| {
            of_samples.each_mut().map(|renderer| offscreen.render(&gpu, renderer, &frame).expect("a picture"))
        });
        assert!(cut == sorted, "direction {turns}: the cut shows");
    }
}
