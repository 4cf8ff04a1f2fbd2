//! The table of formats: one file and one row each.

mod apng;
mod blocks;
mod changes;
mod gif;
mod mapping;
mod mp4;
mod oklab;
mod palette;
mod png;
mod small_png;
mod webp;
#[cfg(not(target_arch = "wasm32"))]
mod webp_film;
mod y4m;

use std::path::Path;

use super::{Encoder, Format};
use crate::words::Phrase;

pub use apng::APNG;
pub use gif::GIF;
pub use mp4::MP4;
pub use palette::Palette;
pub use png::PNG;
pub use small_png::SmallPng;
pub use y4m::Y4M;

/// All formats, in the order of the Export dialog: films, then single pictures.
/// In a page libwebp and ffmpeg are missing.
#[cfg(target_arch = "wasm32")]
pub static FORMATS: [&Format; 5] = [&GIF, &APNG, &Y4M, &PNG, &webp::WEBP];
/// All formats, in the order of the Export dialog: films, then single pictures.
#[cfg(not(target_arch = "wasm32"))]
pub static FORMATS: [&Format; 7] = [&GIF, &APNG, &webp_film::WEBP_FILM, &MP4, &Y4M, &PNG, &webp::WEBP];

/// The highest frame rate of formats without a limit of their own.
pub const MOST_FRAMES_PER_SECOND: u32 = 1000;

/// Endings of pictures and films that other programs write, which are refused instead of being taken as part of a name.
pub const NOT_WRITTEN: [&str; 9] = ["jpg", "jpeg", "webm", "avi", "mov", "mkv", "bmp", "tif", "tiff"];

/// The format with this ending, in lower case and without the dot; of two the one of single pictures.
#[must_use]
pub fn format_of_ending(ending: &str) -> Option<&'static Format> {
    stills().chain(films()).find(|format| format.ending == ending)
}

/// The format that the ending of a file's name tells.
#[must_use]
pub fn format_of_path(path: &Path) -> Option<&'static Format> {
    format_of_ending(&path.extension()?.to_str()?.to_ascii_lowercase())
}

/// The formats of single pictures.
pub fn stills() -> impl Iterator<Item = &'static Format> {
    FORMATS.into_iter().filter(|format| format.is_still())
}

/// The formats of films.
pub fn films() -> impl Iterator<Item = &'static Format> {
    FORMATS.into_iter().filter(|format| !format.is_still())
}

/// The endings that are written, without the dot: of single pictures, of films, of films through ffmpeg.
#[must_use]
pub fn written_endings() -> [Vec<&'static str>; 3] {
    let of = |is_kind: fn(&Encoder) -> bool| {
        let kind = FORMATS.into_iter().filter(|format| is_kind(&format.encoder));
        kind.map(|format| format.ending).collect()
    };
    [
        of(|encoder| matches!(encoder, Encoder::Still(_))),
        of(|encoder| matches!(encoder, Encoder::Film(_))),
        of(|encoder| matches!(encoder, Encoder::Ffmpeg(_))),
    ]
}

/// Names of the formats of single pictures.
#[must_use]
pub fn still_names() -> Vec<&'static str> {
    stills().map(|format| format.name).collect()
}

/// Names of the formats of films.
#[must_use]
pub fn film_names() -> Vec<&'static str> {
    films().map(|format| format.name).collect()
}

/// Names of formats that keep no opacity.
#[must_use]
pub fn opaque() -> Vec<&'static str> {
    FORMATS.into_iter().filter(|format| !format.has_opacity).map(|format| format.name).collect()
}

/// Names of formats that keep opacity, those of single pictures first.
#[must_use]
pub fn translucent() -> Vec<&'static str> {
    let mut names = Vec::new();
    for format in stills().chain(films()).filter(|format| format.has_opacity) {
        if !names.contains(&format.name) {
            names.push(format.name);
        }
    }
    names
}

/// The limits of formats that have none.
const fn no_limit(_: [u32; 2], _: Option<u32>) -> Option<Phrase> {
    None
}

#[cfg(test)]
mod tests {
    use super::super::FormatProblem;
    use super::*;

    #[test]
    fn no_two_formats_of_pictures_or_of_films_share_a_name_or_an_ending() {
        for (index, format) in FORMATS.iter().enumerate() {
            for other in FORMATS[..index].iter().filter(|other| other.is_still() == format.is_still()) {
                assert!(other != format && other.name != format.name && other.ending != format.ending, "{format:?}");
            }
            let found = format_of_ending(format.ending).unwrap();
            assert_eq!(if format.is_still() { found } else { found.of_films() }, *format);
            // One name for one ending, so that a sentence can list them.
            assert_eq!(found.name, format.name);
            assert!(!NOT_WRITTEN.contains(&format.ending), "{format:?} is written");
            assert_eq!(format.ending, format.ending.to_lowercase());
        }
    }

    #[test]
    fn paths_end_as_the_format_does() {
        let path = |format: &Format, path: &str| format.film_path(Path::new(path)).to_string_lossy().into_owned();
        assert_eq!(path(&GIF, "a/walk"), "a/walk.gif");
        assert_eq!(path(&GIF, "a/walk.GIF"), "a/walk.gif");
        assert_eq!(path(&MP4, "a/walk.gif"), "a/walk.mp4");
        assert_eq!(path(&APNG, "v1.2"), "v1.2.apng");
        assert_eq!(path(&PNG, "a/walk.gif"), "a/walk");
        assert_eq!(path(format_of_ending("webp").unwrap().of_films(), "a/walk.gif"), "a/walk.webp");
    }

    #[test]
    fn what_cannot_be_is_said() {
        let problem = |format: &Format, size, fps, is_seen_through| {
            format.problem(size, Some(fps), is_seen_through).map(|problem| problem.to_string())
        };
        assert_eq!(MP4.problem([640, 480], Some(60), true), Some(FormatProblem::NoOpacity));
        assert_eq!(Y4M.problem([641, 480], Some(60), true), Some(FormatProblem::NoOpacity));
        for format in stills().chain([&APNG]) {
            assert_eq!(format.problem([641, 480], Some(1000), true), None);
        }
        assert_eq!(problem(&MP4, [641, 480], 60, false).unwrap(), "an MP4 needs an even width and height");
        assert_eq!(problem(&MP4, [640, 480], 60, false), None);
        let webp = format_of_ending("webp").unwrap().of_films();
        assert_eq!(problem(webp, [16_384, 8], 30, true).unwrap(), "a WebP film is at most 16383 pixels wide and high");
        assert_eq!(problem(webp, [16_383, 8], 91, true).unwrap(), "a WebP shows at most 90 frames a second");
        for format in FORMATS {
            assert_eq!(format.problem([640, 480], Some(format.most_frames_per_second), false), None, "{format:?}");
        }
        assert_eq!(problem(&GIF, [641, 480], 51, true).unwrap(), "a GIF shows at most 50 frames a second");
    }
}
