//! The film of a known mistake: right playback beside what a program shows that makes it.

use serde::{Deserialize, Serialize};

use super::marks::Marks;
use super::report::ShownMistake;
use super::rubric::Rubric;
use super::shown::about_the_farthest;
use super::studio::{ReportPicture, Studio};
use crate::diagnosis::{Sequence, played};
use crate::export::ExportError;
use crate::film::{Cell, Grid, contact_sheet};
use crate::keyframe::{KeyframeList, PlayRange};
use crate::scene::SceneGraph;

/// The frames of a film: somewhat more than an interval.
const FRAMES: usize = 16;

/// The film of a known mistake.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct MistakeFilm {
    /// The film.
    pub picture: ReportPicture,
    /// Whether it is made of the reference, and not of the keyframes of the first submission that shows the mistake.
    pub is_of_reference: bool,
}

/// Draws the film of a mistake on the rubric's reference, if it has one, about the moment at which it shows most; where it does not show there, on the
/// keyframes of the first submission that shows it. `None` where it shows on neither.
///
/// # Errors
/// [`ExportError`]: the GPU fails.
pub fn film_of(
    shown: &ShownMistake,
    marks: &[Marks],
    rubric: &Rubric,
    scene: &SceneGraph,
    studio: &mut Studio,
) -> Result<Option<MistakeFilm>, ExportError> {
    let of_first = shown.shown_by.first().map(|index| &marks[*index]);
    let own = of_first.and_then(|marks| Some((marks.keyframes.as_ref()?, "the first submission that shows it", false)));
    let reference = rubric.reference.as_ref().map(|reference| (&reference.list, "the reference", true));
    for (list, name, is_of_reference) in reference.into_iter().chain(own) {
        if let Some(picture) = film_on(list, name, shown, rubric, scene, studio)? {
            return Ok(Some(MistakeFilm { picture, is_of_reference }));
        }
    }
    Ok(None)
}

fn film_on(
    list: &KeyframeList,
    name: &str,
    shown: &ShownMistake,
    rubric: &Rubric,
    scene: &SceneGraph,
    studio: &mut Studio,
) -> Result<Option<ReportPicture>, ExportError> {
    let (Ok(sequence), Ok(range)) = (Sequence::new(list.as_slice()), PlayRange::new(list)) else { return Ok(None) };
    let mistake = shown.mistake.name;
    let Some((interpolation, rows)) = played(&sequence, mistake, shown.interpolation) else { return Ok(None) };
    let Some(poses) = about_the_farthest(&rows, range, interpolation, rubric.tolerances, FRAMES) else {
        return Ok(None);
    };
    let mut frames = Vec::with_capacity(poses.len());
    for pose in &poses {
        let cell = |picture, caption: &str| Cell { picture, caption: vec![caption.to_owned()] };
        let cells = [
            cell(studio.draw(scene, &pose.right, &pose.right)?, "right"),
            cell(studio.draw(scene, &pose.pose, &pose.right)?, mistake),
        ];
        frames.push(contact_sheet(Grid { columns: 2, rows: 1 }, &cells));
    }
    let (first, last) = (poses[0].key_time, poses[poses.len() - 1].key_time);
    let caption = format!(
        "{} playback of {name}, key time {first:.2} to {last:.2}: right on the left, {mistake} on the right",
        interpolation.title()
    );
    Ok(Some(studio.picture(&frames, caption)?))
}
