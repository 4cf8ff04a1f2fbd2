//! Pictures for the report: the animation, and the moments at which it differs most from the reference, side by side.

use num_rational::BigRational;

use super::item::ItemKind;
use super::marks::Marks;
use super::rubric::{Reference, Rubric};
use super::shown::{FRAMES, ShownPose, ShownPoses, farthest};
use crate::animation_diff::{Played, compare, frame_times_ms};
use crate::export::{ExportError, Painter, Size};
use crate::interpolation::Interpolation;
use crate::keyframe::{DEFAULT_MS_BETWEEN_KEYFRAMES, KeyframeList, PlayRange, whole};
use crate::markup::base64;
use crate::render::Image;
use crate::scene::SceneGraph;

/// Width and height of the pictures in pixels.
pub const SIZE: Size = Size { width: 200, height: 150 };
/// How long the animated picture takes, in milliseconds.
const LENGTH_MS: usize = 2400;
/// The most frames among which the moments are looked for.
const MOST_FRAMES: usize = 2_000;

/// One picture, ready for the page.
#[derive(Clone, Debug, PartialEq)]
pub struct ReportPicture {
    /// The PNG, or animated PNG, in base 64.
    pub base64: String,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// What it shows, for people who see it.
    pub caption: String,
    /// What it shows, for people who do not.
    pub alt: String,
    /// Whether a row begins with it.
    pub starts_row: bool,
}

impl ReportPicture {
    /// A picture that begins no row.
    pub fn new(png: &[u8], Size { width, height }: Size, caption: String, alt: String) -> Self {
        Self { base64: base64(png), width, height, caption, alt, starts_row: false }
    }
}

/// Draws the pictures of a submission, in the order in which they are shown; none where it cannot be played. The painter's pictures are
/// of [`SIZE`].
///
/// # Errors
/// [`ExportError`]: the GPU fails.
pub fn pictures_of(
    marks: &Marks,
    rubric: &Rubric,
    scene: &SceneGraph,
    painter: &mut Painter,
) -> Result<Vec<ReportPicture>, ExportError> {
    let mut pictures = Vec::new();
    for interpolation in shown_playbacks(marks, rubric) {
        pictures.extend(of_playback(marks, interpolation, rubric, scene, painter)?);
    }
    Ok(pictures)
}

/// The playbacks to draw: those that lost points, or else the last graded one.
fn shown_playbacks(marks: &Marks, rubric: &Rubric) -> Vec<Interpolation> {
    let graded = rubric.items().filter_map(|(kind, _)| match kind {
        ItemKind::Playback(interpolation) => Some(interpolation),
        _ => None,
    });
    let graded: Vec<Interpolation> = graded.collect();
    // Where nothing was shown, there is nothing to see of what was lost.
    let has_lost = |interpolation: &Interpolation| {
        let item = marks.item(ItemKind::Playback(*interpolation));
        item.is_some_and(|item| item.has_lost() && item.evidence.is_some())
    };
    let wrong: Vec<Interpolation> = graded.iter().copied().filter(has_lost).collect();
    if wrong.is_empty() { vec![graded.last().copied().unwrap_or(Interpolation::CatmullRom)] } else { wrong }
}

/// The poses of the student's samples if there are any; otherwise the keyframes as this program plays them.
fn of_playback(
    marks: &Marks,
    interpolation: Interpolation,
    rubric: &Rubric,
    scene: &SceneGraph,
    painter: &mut Painter,
) -> Result<Vec<ReportPicture>, ExportError> {
    let label = interpolation.title();
    let of_samples = marks.samples.iter().find(|samples| samples.interpolation == interpolation);
    let (poses, caption) = match of_samples.and_then(|samples| Some((samples.shown.as_ref()?, &samples.file))) {
        Some((shown, file)) => (shown.clone(), format!("{label}, as {file} shows it")),
        None => match marks.keyframes.as_ref().and_then(|list| played(list, interpolation, rubric)) {
            Some(poses) => (poses, format!("{label}, as its keyframes play")),
            None => return Ok(Vec::new()),
        },
    };
    let mut frames = Vec::with_capacity(FRAMES);
    for shown in &poses.frames {
        frames.push(painter.loose_pose(scene, &shown.pose, &shown.right)?);
    }
    if frames.is_empty() {
        return Ok(Vec::new());
    }
    let alt = format!("Film of {} pictures: {caption}", frames.len());
    let film = ReportPicture { starts_row: true, ..ReportPicture::new(&animated(&frames)?, SIZE, caption, alt) };
    let mut pictures = vec![film];
    for shown in &poses.moments {
        let own = painter.loose_pose(scene, &shown.pose, &shown.right)?;
        let right = painter.loose_pose(scene, &shown.right, &shown.right)?;
        let apart = apart(&own, &right);
        let at = format!("{label}, key time {:.2}", shown.key_time);
        let captions = [format!("{at}: submitted"), "reference".to_owned(), "difference".to_owned()];
        let alts = [
            format!("The submission: {at}"),
            format!("The reference: {at}"),
            format!("Where both differ, bright on black: {at}"),
        ];
        for ((image, caption), alt) in [own, right, apart].iter().zip(captions).zip(alts) {
            let starts_row = pictures.len() % 3 == 1;
            pictures.push(ReportPicture { starts_row, ..ReportPicture::new(&image.to_png()?, SIZE, caption, alt) });
        }
    }
    Ok(pictures)
}

/// Keyframes as this program plays them.
fn played(list: &KeyframeList, interpolation: Interpolation, rubric: &Rubric) -> Option<ShownPoses> {
    let range = PlayRange::new(list).ok()?;
    let reference = rubric.reference.as_ref();
    let right = reference.map_or_else(|| range.clone(), Reference::range);
    let ms_between_keyframes =
        reference.map_or(DEFAULT_MS_BETWEEN_KEYFRAMES, |reference| reference.ms_between_keyframes);
    let played = |range| Played { range, interpolation, ms_between_keyframes };
    let (right, own) = (played(&right), played(&range));
    let shown = |ms: &BigRational| {
        let (pose, right_pose) = (own.pose_at(ms).ok()?, right.pose_at(ms).ok()?);
        Some(ShownPose { key_time: right.key_time_at(ms), pose, right: right_pose })
    };
    let length_ms = own.length_ms();
    let frames = (0..FRAMES).filter_map(|frame| shown(&(&length_ms * whole(frame) / whole(FRAMES - 1)))).collect();
    let times = frame_times_ms(&right.length_ms(), rubric.fps, MOST_FRAMES).filter(|times| times.len() <= MOST_FRAMES);
    let moments = times.and_then(|times| {
        let difference = compare(right, own, &times, rubric.tolerances).ok()?;
        Some(farthest(&difference.off_by_frame).into_iter().filter_map(|index| shown(&times[index])).collect())
    });
    Some(ShownPoses { frames, moments: moments.unwrap_or_default() })
}

/// The absolute difference of two pictures of equal size, on black.
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
pub fn animated(frames: &[Image]) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, frames[0].width, frames[0].height);
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
