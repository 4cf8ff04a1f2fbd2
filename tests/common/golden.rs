//! Golden pictures: what was drawn and looked at once.

use std::fs;
use std::path::{Path, PathBuf};

use inbetween::flip::{DEFAULT_TOLERANCE, compare};
use inbetween::render::Image;

fn golden_path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/goldens").join(format!("{name}.png"))
}

/// Compares a picture with its golden, or makes the golden with `UPDATE_GOLDENS=1`.
#[track_caller]
pub fn check_golden(name: &str, drawn: &Image) {
    let path = golden_path(name);
    if std::env::var_os("UPDATE_GOLDENS").is_some_and(|value| value == "1") {
        fs::create_dir_all(path.parent().expect("it is in a folder")).expect("a folder");
        fs::write(&path, drawn.to_png().expect("a PNG")).expect("a golden");
        return;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("../goldens");
    fs::create_dir_all(&folder).expect("a folder");
    let actual = folder.join(format!("{name}-actual.png"));
    let keep = |path: &Path, image: &Image| fs::write(path, image.to_png().expect("a PNG")).expect("a file");
    let Ok(golden) = fs::read(&path) else {
        keep(&actual, drawn);
        panic!("the golden {} is missing; {} was drawn", path.display(), actual.display());
    };
    let golden = Image::from_png(&golden).expect("a golden is a PNG");
    let found = compare(&golden, drawn).expect("a golden has the picture's size");
    if !found.scores().is_within(DEFAULT_TOLERANCE) {
        let difference = folder.join(format!("{name}-difference.png"));
        keep(&actual, drawn);
        keep(&difference, &found.difference());
        panic!("{name} scores {}: see {} and {}", found.scores().score, actual.display(), difference.display());
    }
}
