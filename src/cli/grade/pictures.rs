//! Pictures for the report: the animation, and the moments at which it differs most from the reference, side by side.

use super::marks::Marks;
use super::rubric::Rubric;
use crate::camera::Camera;
use crate::cli::CliError;
use crate::cli::diff::times_ms;
use crate::cli::progress::Progress;
use crate::difference::{Played, compare};
use crate::export::{Painter, Size};
use crate::frame::Frame;
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeList, PlayRange, to_f64, whole};
use crate::pose::Pose;
use crate::render::Image;
use crate::scene::SceneGraph;

/// The pictures' size in pixels.
pub const SIZE: Size = Size { width: 200, height: 150 };
/// The frames of an animated picture.
const FRAMES: usize = 16;
/// How long it takes, in milliseconds.
const LENGTH_MS: usize = 2400;
/// How many moments are shown beside the reference.
const MOMENTS: usize = 2;
/// The most frames among which the moments are looked for.
const MOST_FRAMES: usize = 2_000;

/// One picture, ready for the page.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// The PNG, or animated PNG, in base 64.
    pub base64: String,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// What it shows.
    pub caption: String,
    /// Whether a row begins with it.
    pub starts_row: bool,
}

/// The pictures of one submission.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pictures {
    /// In the order in which they are shown.
    pub pictures: Vec<Picture>,
}

/// Draws the pictures of every submission that can be played.
///
/// # Errors
/// [`CliError`]: the GPU fails.
pub fn of_all(
    marks: &[Marks],
    rubric: &Rubric,
    scene: &SceneGraph,
    painter: &mut Painter,
) -> Result<Vec<Option<Pictures>>, CliError> {
    let mut progress = Progress::new("submission", marks.len().max(1));
    let mut drawn = Vec::with_capacity(marks.len());
    for marks in marks {
        let pictures = marks.keyframes.as_ref().map(|list| of_one(list, rubric, scene, painter)).transpose()?;
        drawn.push(pictures.flatten());
        progress.step();
    }
    Ok(drawn)
}

fn of_one(
    list: &KeyframeList,
    rubric: &Rubric,
    scene: &SceneGraph,
    painter: &mut Painter,
) -> Result<Option<Pictures>, CliError> {
    let (Ok(range), Ok(reference)) = (PlayRange::new(list), PlayRange::new(&rubric.reference)) else { return Ok(None) };
    let interpolation = Interpolation::CatmullRom;
    let played = |range| Played { range, interpolation, ms_between_keyframes: rubric.ms_between_keyframes };
    let (right, own) = (played(&reference), played(&range));
    let length_ms = own.length_ms();
    let mut frames = Vec::with_capacity(FRAMES);
    for frame in 0..FRAMES {
        let ms = &length_ms * whole(frame) / whole(FRAMES - 1);
        if let Ok(pose) = own.pose_at(&ms) {
            frames.push(draw(&pose, scene, painter)?);
        }
    }
    let mut pictures = vec![picture(animated(&frames)?, "Catmull-Rom playback".to_owned(), false)];
    let Some(times) = times_ms(&right.length_ms(), rubric.fps).filter(|times| times.len() <= MOST_FRAMES) else {
        return Ok(Some(Pictures { pictures }));
    };
    let Ok(difference) = compare(right, own, &times, rubric.tolerances) else { return Ok(Some(Pictures { pictures })) };
    for place in farthest(&difference.off_by_frame) {
        let ms = &times[place];
        let (Ok(own_pose), Ok(right_pose)) = (own.pose_at(ms), right.pose_at(ms)) else { continue };
        let key_time = right.key_time_at(ms);
        let (own_image, right_image) = (draw(&own_pose, scene, painter)?, draw(&right_pose, scene, painter)?);
        let apart = apart(&own_image, &right_image);
        pictures.push(picture(
            own_image.to_png()?,
            format!("Key time {key_time:.2}, {:.0} ms: submitted", to_f64(ms)),
            true,
        ));
        pictures.push(picture(right_image.to_png()?, "reference".to_owned(), false));
        pictures.push(picture(apart.to_png()?, "difference".to_owned(), false));
    }
    Ok(Some(Pictures { pictures }))
}

/// The frames that are farthest off, in order of time: the worst, and the worst of those well away from it; none where all are right.
fn farthest(off_by_frame: &[f64]) -> Vec<usize> {
    let apart = (off_by_frame.len() / 10).max(1);
    let mut found: Vec<usize> = Vec::new();
    while found.len() < MOMENTS {
        let is_free =
            |place: &usize| found.iter().all(|other| place.abs_diff(*other) >= apart) && off_by_frame[*place] > 1.0;
        let farthest =
            (0..off_by_frame.len()).filter(is_free).max_by(|a, b| off_by_frame[*a].total_cmp(&off_by_frame[*b]));
        let Some(place) = farthest else { break };
        found.push(place);
    }
    found.sort_unstable();
    found
}

fn draw(pose: &Pose, scene: &SceneGraph, painter: &mut Painter) -> Result<Image, CliError> {
    let camera = Camera {
        world_from_eye: scene.world_from_rbt(pose, 0.0, scene.eyes()[0]),
        vertical_fov: scene.vertical_fov(),
        size_px: painter.size_px(),
    };
    Ok(painter.image(&Frame::new(scene, pose, 0.0, &camera, None))?)
}

/// Where two pictures of one size differ: the brighter the more, on black.
fn apart(a: &Image, b: &Image) -> Image {
    let pixels = a.rgba.chunks_exact(4).zip(b.rgba.chunks_exact(4));
    let rgba = pixels
        .flat_map(|(a, b)| {
            let off = (0..3).map(|channel| a[channel].abs_diff(b[channel])).max().unwrap_or(0);
            let bright = off.saturating_mul(3);
            [bright, bright / 2, bright / 4, u8::MAX]
        })
        .collect();
    Image { rgba, ..*a }
}

/// An animated PNG of pictures of one size, of which there is at least one.
fn animated(frames: &[Image]) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, SIZE.width, SIZE.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_animated(frames.len().max(1) as u32, 0)?;
    encoder.set_frame_delay((LENGTH_MS / FRAMES) as u16, 1000)?;
    let mut writer = encoder.write_header()?;
    for frame in frames {
        let rgb: Vec<u8> = frame.rgba.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        writer.write_image_data(&rgb)?;
    }
    writer.finish()?;
    Ok(bytes)
}

fn picture(png: Vec<u8>, caption: String, starts_row: bool) -> Picture {
    Picture { base64: base64(&png), width: SIZE.width, height: SIZE.height, caption, starts_row }
}

fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let bits =
            three.iter().enumerate().fold(0_u32, |bits, (place, &byte)| bits | u32::from(byte) << (16 - 8 * place));
        for letter in 0..4 {
            let is_there = letter <= three.len();
            text.push(if is_there { LETTERS[(bits >> (18 - 6 * letter)) as usize & 63] as char } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base_64() {
        for (text, expected) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")] {
            assert_eq!(base64(text.as_bytes()), expected);
        }
    }

    #[test]
    fn moments_are_apart_and_only_where_something_is_off() {
        assert_eq!(farthest(&[0.0; 20]), [0; 0]);
        let mut off = [0.5; 40];
        off[10..13].copy_from_slice(&[5.0, 9.0, 8.0]);
        off[30] = 2.0;
        assert_eq!(farthest(&off), [11, 30]);
    }
}
