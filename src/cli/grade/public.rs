//! The report of one submission, as anybody may see it.

use std::path::Path;

use super::kept;
use super::studio::LazyStudio;
use crate::cli::{CliError, Common};
use crate::files::scene;
use crate::grading::{self, Basis, Cache, Found, GradedClass, Images, Marks, Naming, PICTURE_SIZE, Points, Rubric};
use crate::keyframe::KeyframeList;
use crate::storage::input_name;

/// The most pictures of a report.
const MOST_PICTURES: u8 = 8;

/// A submission that is put where anybody may see it.
pub struct PublicReport {
    /// The report: one page that needs no other file.
    pub html: String,
    /// The keyframes of the submission.
    pub keyframes: KeyframeList,
}

/// Grades one submission by a rubric and nothing else, and takes out what tells whose it is.
///
/// # Errors
/// [`CliError`]: a bad rubric, a submission without keyframes that can be read, no GPU adapter for the pictures.
pub fn report(
    rubric_path: &Path,
    submission: &Path,
    points: Points,
    common: Common<'_>,
) -> Result<PublicReport, CliError> {
    let scene = scene::load(common.scene)?;
    let rubric = Rubric::load(rubric_path, &scene)?;
    let Found { submissions, .. } = grading::find(&[submission.to_owned()], Naming::One, &rubric.keyframe_file)?;
    let cache = Cache::default();
    let marks = grading::mark_all(&submissions, |_| true, &rubric, &scene, &cache);
    let images = Images { most: MOST_PICTURES, size: (PICTURE_SIZE.width, PICTURE_SIZE.height) };
    let basis = Basis::new(kept::version(), &rubric, &scene, Some(images));
    let marks: Vec<Marks> = marks.into_iter().flatten().collect();
    // A submission that cannot be shown needs no pictures.
    let [Marks { keyframes, unread, .. }] = &marks[..] else { unreachable!("one submission has one row of marks") };
    let Some(keyframes) = keyframes.clone() else {
        return Err(CliError::bad_input(input_name(submission), unread.clone().unwrap_or_default()));
    };
    let mut class = GradedClass { basis, scene, rubric, overrides: None, marks, passed_over: Vec::new(), cache };
    let mut studio = LazyStudio::default();
    studio.draw(&mut class, common)?;
    let films = studio.films(&mut class)?;
    let GradedClass { mut marks, rubric, .. } = class;
    marks.iter_mut().for_each(grading::make_public);
    Ok(PublicReport { html: grading::public_page(&marks[0], points, &rubric, &films), keyframes })
}
