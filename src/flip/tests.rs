//! Properties of the score, and values compared with NVIDIA's own program.

use super::*;

fn picture(width: u32, height: u32, at: impl Fn(u32, u32) -> [u8; 4]) -> Image {
    let rgba = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).flat_map(|(x, y)| at(x, y)).collect();
    Image { width, height, rgba }
}

fn plain(colour: [u8; 3]) -> Image {
    picture(40, 30, |_, _| [colour[0], colour[1], colour[2], 255])
}

/// A slanted gradient with a disc on it, the disc moved by some pixels and everything brighter by some levels.
fn scene(moved: i32, brighter: u8) -> Image {
    picture(64, 48, |x, y| {
        let (dx, dy) = (x.cast_signed() - 30 - moved, y.cast_signed() - 24);
        let [r, g, b] = if dx * dx + dy * dy < 144 {
            [200, 60, 40]
        } else {
            [90 + x.to_le_bytes()[0], 110 + y.to_le_bytes()[0], 150]
        };
        [r + brighter, g + brighter, b + brighter, 255]
    })
}

fn check(first: &Image, second: &Image) -> Comparison {
    let found = compare(first, second).unwrap();
    let back = compare(second, first).unwrap();
    assert_eq!(found, back, "the order does not matter");
    assert!(found.errors().iter().all(|error| (0.0..=1.0).contains(error)));
    assert!(found.scores().mean <= found.scores().score && found.scores().score <= found.scores().largest);
    found
}

#[test]
fn a_picture_does_not_differ_from_itself() {
    let found = check(&scene(0, 0), &scene(0, 0));
    assert_eq!((found.scores().score, found.scores().mean, found.scores().largest), (0.0, 0.0, 0.0));
    assert!(found.scores().is_within(0.0));
}

#[test]
fn green_and_blue_differ_most_and_black_and_white_nearly_so() {
    assert!(check(&plain([0, 255, 0]), &plain([0, 0, 255])).scores().mean > 0.9999);
    let mean = check(&plain([0; 3]), &plain([255; 3])).scores().mean;
    assert!((mean - 0.9672).abs() < 1e-3, "{mean}");
}

#[test]
fn what_moves_is_seen_and_a_level_more_is_not() {
    let brighter = check(&scene(0, 0), &scene(0, 1));
    let moved = check(&scene(0, 0), &scene(1, 0));
    assert!(brighter.scores().is_within(DEFAULT_TOLERANCE), "{}", brighter.scores().score);
    assert!(!moved.scores().is_within(3.0 * DEFAULT_TOLERANCE), "{}", moved.scores().score);
    assert!(check(&scene(0, 0), &scene(3, 0)).scores().mean > moved.scores().mean);
}

#[test]
fn the_share_of_striking_pixels_is_counted() {
    assert_eq!(check(&scene(0, 0), &scene(0, 0)).striking(), 0.0);
    assert_eq!(check(&plain([0; 3]), &plain([255; 3])).striking(), 1.0);
    let moved = check(&scene(0, 0), &scene(3, 0));
    let count = moved.errors().iter().filter(|&&error| error > 0.3).count();
    assert!(count > 0, "the disc's edges differ strikingly");
    assert!((f64::from(moved.striking()) - count as f64 / (64.0 * 48.0)).abs() < 1e-7);
}

#[test]
fn errors_are_where_the_pictures_differ() {
    let found = check(&scene(0, 0), &scene(2, 0));
    let at = |x: usize, y: usize| found.errors()[y * 64 + x];
    assert!(at(42, 24) > 0.3 && at(2, 2) < 1e-3);
    let difference = found.difference();
    assert_eq!((difference.width, difference.height), (64, 48));
    assert_eq!(difference.pixel(2, 2), Some([0, 0, 4, 255]));
    assert!(difference.pixel(42, 24).unwrap()[0] > 100);
}

#[test]
fn opacity_is_a_difference_too() {
    let black = picture(20, 20, |_, _| [0, 0, 0, 255]);
    let nothing = picture(20, 20, |_, _| [0, 0, 0, 0]);
    assert!(check(&black, &nothing).scores().mean > 0.9);
    let hidden = picture(20, 20, |_, _| [255, 0, 0, 0]);
    assert!(check(&hidden, &nothing).scores().is_within(0.0));
}

#[test]
fn small_pictures_and_none() {
    let dot = |level| picture(1, 1, |_, _| [level, level, level, 255]);
    assert!(check(&dot(0), &dot(255)).scores().mean > 0.9);
    assert_eq!(
        compare(&dot(0), &plain([0; 3])).unwrap_err().to_string(),
        "the pictures have different sizes: 1x1 and 40x30"
    );
    let none = Image { width: 0, height: 3, rgba: Vec::new() };
    assert_eq!(compare(&none, &none), Err(CompareError::Empty));
}

/// Values that FLIP's authors' own program (flip-evaluator 1.7) gives for the same pictures: its mean, its largest, and three pixels.
#[test]
fn the_values_are_those_of_the_authors_program() {
    let check = |second: Image, mean: f32, largest: f32, pixels: [f32; 3]| {
        let found = check(&scene(0, 0), &second);
        let at = |x: usize, y: usize| found.errors()[y * 64 + x];
        let all = [found.scores().mean, found.scores().largest, at(42, 24), at(20, 30), at(0, 0)];
        let [first, second, third] = pixels;
        for (found, expected) in all.into_iter().zip([mean, largest, first, second, third]) {
            assert!((found - expected).abs() < 5e-4, "{all:?}, expected {mean} {largest} {pixels:?}");
        }
    };
    check(scene(1, 0), 0.032_739, 0.390_990, [0.353_864, 0.360_589, 0.0]);
    check(scene(0, 1), 0.034_252, 0.039_993, [0.035_626, 0.036_059, 0.035_259]);
    check(scene(3, 20), 0.318_791, 0.796_649, [0.566_843, 0.685_423, 0.289_414]);
}
