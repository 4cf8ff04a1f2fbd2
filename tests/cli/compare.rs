use image::{Rgb, RgbImage};
use serde_json::Value;

use crate::sandbox::Sandbox;

/// A disc so many pixels from the left on a gradient.
fn disc(sandbox: &Sandbox, name: &str, left: i32, width: u32) {
    let picture = RgbImage::from_fn(width, 48, |x, y| {
        let (dx, dy) = (x.cast_signed() - left, y.cast_signed() - 24);
        if dx * dx + dy * dy < 144 { Rgb([200, 60, 40]) } else { Rgb([120, 110 + y.to_le_bytes()[0], 150]) }
    });
    picture.save(sandbox.path(name)).unwrap();
}

#[test]
fn the_status_says_whether_images_look_the_same() {
    let sandbox = Sandbox::new();
    disc(&sandbox, "a.png", 30, 64);
    disc(&sandbox, "b.png", 31, 64);
    let same = sandbox.run(&["compare", "a.png", "a.png", "--tolerance", "0"]).succeeds();
    assert_eq!(
        same,
        "score 0.000000, within the tolerance 0; FLIP's mean 0.000000, largest 0.000000; the score is the mean of the worst thousandth of the \
         pixels\n"
    );
    let other = sandbox.run(&["compare", "a.png", "b.png", "-o", "diff.png"]);
    assert_eq!((other.status, other.stderr.as_str()), (1, ""));
    assert!(other.stdout.contains("beyond the tolerance 0.06"), "{}", other.stdout);
    let difference = image::open(sandbox.path("diff.png")).unwrap().to_rgb8();
    assert_eq!((difference.dimensions(), difference.get_pixel(1, 1)), ((64, 48), &Rgb([0, 0, 4])));
    assert!(difference.pixels().any(|pixel| pixel[0] > 80));
    assert_eq!(sandbox.run(&["compare", "a.png", "b.png", "--tolerance", "1"]).status, 0);
}

#[test]
fn the_result_is_json_too() {
    let sandbox = Sandbox::new();
    disc(&sandbox, "a.png", 30, 64);
    disc(&sandbox, "b.png", 33, 64);
    let outcome = sandbox.run(&["compare", "a.png", "b.png", "--json"]);
    let result: Value = serde_json::from_str(&outcome.stdout).unwrap();
    assert_eq!((outcome.status, &result["within"]), (1, &Value::Bool(false)));
    let number = |name: &str| result[name].as_f64().unwrap();
    assert!(0.0 < number("mean") && number("mean") < number("score") && number("score") <= number("largest"));
    assert!(0.0 < number("striking") && number("striking") < 0.5);
}

#[test]
fn trouble_is_status_2() {
    let sandbox = Sandbox::new();
    disc(&sandbox, "a.png", 30, 64);
    disc(&sandbox, "wide.png", 30, 65);
    sandbox.write("text.png", "no picture");
    for (arguments, sentence) in [
        (["a.png", "none.png"], "none.png: there is no such file or folder"),
        (["text.png", "a.png"], "text.png: it is no PNG"),
        (["a.png", "wide.png"], "a.png and wide.png: the pictures have different sizes: 64x48 and 65x48"),
    ] {
        let outcome = sandbox.run(&[&["compare", "-o", "diff.png"][..], &arguments].concat());
        assert_eq!((outcome.status, outcome.stdout.as_str()), (2, ""));
        assert!(outcome.stderr.starts_with(sentence), "{}", outcome.stderr);
    }
    assert_eq!(sandbox.run(&["compare", "a.png", "a.png", "-o", "no/such.png"]).status, 2);
    sandbox.run(&["compare", "a.png"]).misuses();
    sandbox.run(&["compare", "a.png", "a.png", "--tolerance", "-1"]).misuses();
    assert_eq!(sandbox.names(), ["a.png", "text.png", "wide.png"]);
}
