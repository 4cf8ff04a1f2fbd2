//! Pictures for the report: the animation, and the moments at which it differs most from the reference, side by side.

use num_rational::BigRational;

use super::item::ItemKind;
use super::marks::Marks;
use super::rubric::{Reference, Rubric};
use super::shown::{FRAMES, MOMENTS, ShownPose, ShownPoses, farthest};
use super::studio::{ReportPicture, Studio};
use crate::animation_diff::{Played, compare, frame_times_ms};
use crate::export::ExportError;
use crate::interpolation::Interpolation;
use crate::keyframe::{DEFAULT_MS_BETWEEN_KEYFRAMES, KeyframeList, PlayRange, whole};
use crate::scene::SceneGraph;
use crate::words::Phrase;

/// The most frames among which the moments are looked for.
const MOST_FRAMES: usize = 2_000;
/// Submitted, reference, difference.
const PICTURES_OF_A_MOMENT: usize = 3;

/// Draws the pictures of a submission, at most `most`, in the order in which they are shown; none where it cannot be played. Each playback
/// gets its film before any gets its moments, and each its first moment before any gets its second.
///
/// # Errors
/// [`ExportError`]: the GPU fails.
pub fn pictures_of(
    marks: &Marks,
    rubric: &Rubric,
    scene: &SceneGraph,
    studio: &mut Studio,
    most: usize,
) -> Result<Vec<ReportPicture>, ExportError> {
    let playbacks = shown_playbacks(marks, rubric).into_iter();
    let mut playbacks: Vec<ShownPlayback> =
        playbacks.filter_map(|kind| shown(marks, kind, rubric)).take(most).collect();
    let mut left = most - playbacks.len();
    let mut moments = vec![0; playbacks.len()];
    for moment in 0..MOMENTS {
        for (count, playback) in moments.iter_mut().zip(&playbacks) {
            if playback.poses.moments.len() > moment && left >= PICTURES_OF_A_MOMENT {
                left -= PICTURES_OF_A_MOMENT;
                *count += 1;
            }
        }
    }
    let mut pictures = Vec::new();
    for (playback, moments) in playbacks.iter_mut().zip(moments) {
        playback.poses.moments.truncate(moments);
        pictures.extend(draw(playback, scene, studio)?);
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

/// A playback as pictures show it.
struct ShownPlayback {
    label: Phrase,
    caption: String,
    poses: ShownPoses,
}

/// The poses of the student's samples if there are any; otherwise the keyframes as this program plays them.
fn shown(marks: &Marks, interpolation: Interpolation, rubric: &Rubric) -> Option<ShownPlayback> {
    let label = interpolation.title();
    let of_samples = marks.samples.iter().find(|samples| samples.interpolation == interpolation);
    let of_samples = of_samples.and_then(|samples| Some((samples.shown.as_ref()?, &samples.file)));
    let (poses, caption) = if let Some((shown, file)) = of_samples {
        (shown.clone(), format!("{label}, as {file} shows it"))
    } else {
        let poses = marks.keyframes.as_ref().and_then(|list| played(list, interpolation, rubric))?;
        (poses, format!("{label}, as its keyframes play"))
    };
    (!poses.frames.is_empty()).then_some(ShownPlayback { label, caption, poses })
}

/// The film, and each moment: submitted, reference, difference.
fn draw(playback: &ShownPlayback, scene: &SceneGraph, studio: &mut Studio) -> Result<Vec<ReportPicture>, ExportError> {
    let ShownPlayback { label, caption, poses } = playback;
    let mut frames = Vec::with_capacity(FRAMES);
    for shown in &poses.frames {
        frames.push(studio.draw(scene, &shown.pose, &shown.right)?);
    }
    let mut film = studio.picture(&frames, caption.clone())?;
    film.starts_row = true;
    let mut pictures = vec![film];
    for shown in &poses.moments {
        let own = studio.draw(scene, &shown.pose, &shown.right)?;
        let right = studio.draw(scene, &shown.right, &shown.right)?;
        let at = format!("{label}, key time {:.2}", shown.key_time);
        let difference = Studio::difference(&own, &right, "difference".to_owned(), &at)?;
        let mut own = studio.picture(&[own], format!("{at}: submitted"))?;
        own.starts_row = true;
        let mut right = studio.picture(&[right], "reference".to_owned())?;
        right.alt = format!("The reference: {at}");
        pictures.extend([own, right, difference]);
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
