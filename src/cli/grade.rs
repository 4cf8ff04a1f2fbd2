//! `inbetween grade`: a folder of submissions, marked by a rubric.
//!
//! Submissions are marked on all cores, each apart from the others; the results stand in the order in which the submissions were
//! named, and nothing in them depends on time. Nothing in a submission is trusted.

mod gather;
mod hotkeys;
mod marks;
mod pictures;
mod report;
mod rubric;
mod shown;
mod tables;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::arguments::GradeArguments;
use super::{CliError, output, scene};
use crate::export::Painter;
use crate::scene::SceneGraph;
use crate::storage;
use gather::Submission;
use marks::Marks;
use rubric::Rubric;

/// Grades, and writes `grades.csv`, `grades.json` and `report.html`.
///
/// # Errors
/// [`CliError`]: a bad rubric, a submission that is not there, no GPU adapter for the pictures, a result that cannot be written. What
/// is wrong with a submission is no error but its marks.
pub fn run(arguments: &GradeArguments, scene: Option<&Path>) -> Result<(), CliError> {
    let painter = if arguments.no_images { None } else { Some(Painter::headless(pictures::SIZE, None)?) };
    let scene = scene::load(scene)?;
    let rubric = rubric::load(&arguments.rubric, &scene)?;
    let submissions = gather::find(&arguments.submissions)?;
    let marks = mark_all(&submissions, &rubric, &scene);
    let pictures = match painter {
        None => marks.iter().map(|_| None).collect(),
        Some(mut painter) => pictures::of_all(&marks, &rubric, &scene, &mut painter)?,
    };
    let folder = &arguments.output;
    storage::create_folder(folder).map_err(|reason| CliError::unwritten(folder, reason))?;
    let files = [
        ("grades.csv", tables::csv(&marks)),
        ("grades.json", tables::json(&marks, &rubric)),
        ("report.html", report::html(&marks, &rubric, &pictures)),
    ];
    for (name, text) in files {
        let path = folder.join(name);
        storage::write(&path, text.as_bytes()).map_err(|reason| CliError::unwritten(&path, reason))?;
    }
    let count = marks.len();
    let submissions = if count == 1 { "submission" } else { "submissions" };
    output::print(|output| writeln!(output, "{count} {submissions} graded: {}", folder.join("report.html").display()))
}

/// Marks all submissions, on all cores, in their order.
fn mark_all(submissions: &[Submission], rubric: &Rubric, scene: &SceneGraph) -> Vec<Marks> {
    let places: Vec<OnceLock<Marks>> = submissions.iter().map(|_| OnceLock::new()).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        loop {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some(submission) = submissions.get(place) else { break };
            let _ = places[place].set(mark_one(submission, rubric, scene));
        }
    };
    let workers = std::thread::available_parallelism().map_or(1, std::num::NonZero::get).min(submissions.len().max(1));
    std::thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(work);
        }
    });
    places.into_iter().map(|place| place.into_inner().expect("every submission was marked")).collect()
}

/// Marks one submission. Nothing in it should make this program panic; if something does, it costs this submission only.
fn mark_one(submission: &Submission, rubric: &Rubric, scene: &SceneGraph) -> Marks {
    let name = &submission.name;
    catch_unwind(AssertUnwindSafe(|| marks::mark(name, submission.read(), rubric, scene))).unwrap_or_else(|_| {
        marks::mark(name, Err("this program failed on it: please report the submission".to_owned()), rubric, scene)
    })
}
