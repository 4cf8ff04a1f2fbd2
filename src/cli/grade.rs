//! `inbetween grade`: a folder of submissions, marked by a rubric.

use std::fmt::Write as _;
use std::path::Path;

use super::arguments::GradeArguments;
use super::progress::Progress;
use super::{CliError, output};
use crate::export::Painter;
use crate::files::{self, scene};
use crate::grading::{self, Found, Naming, PICTURE_SIZE, PassedOver, Rubric};
use crate::text::counted;

/// Grades, and writes `grades.csv`, `grades.json` and `report.html`.
///
/// # Errors
/// [`CliError`]: a bad rubric, a submission that is not there, no GPU adapter for the pictures, a result that cannot be written. What
/// is wrong with a submission is no error but its marks.
pub fn run(arguments: &GradeArguments, scene: Option<&Path>) -> Result<(), CliError> {
    let painter = if arguments.no_images { None } else { Some(Painter::headless(PICTURE_SIZE, None)?) };
    let scene = scene::load(scene)?;
    let rubric = Rubric::load(&arguments.rubric, &scene)?;
    let naming = match (arguments.one, arguments.classes) {
        (true, _) => Naming::One,
        (_, true) => Naming::Classes,
        _ => Naming::Guessed,
    };
    let Found { submissions, passed_over } = grading::find(&arguments.submissions, naming, &rubric.keyframe_file)?;
    let marks = grading::mark_all(&submissions, &rubric, &scene);
    let mut pictures = vec![Vec::new(); marks.len()];
    if let Some(mut painter) = painter {
        let mut progress = Progress::new("submission", marks.len().max(1));
        for (marks, pictures) in marks.iter().zip(&mut pictures) {
            *pictures = grading::pictures_of(marks, &rubric, &scene, &mut painter)?;
            progress.step();
        }
    }
    let folder = &arguments.output;
    files::create_folder(folder)?;
    let report = folder.join("report.html");
    files::write(&folder.join("grades.csv"), grading::csv(&marks).as_bytes())?;
    files::write(&folder.join("grades.json"), grading::json(&marks, &passed_over, &rubric).as_bytes())?;
    files::write(&report, grading::html(&marks, &passed_over, &rubric, &pictures).as_bytes())?;
    let submissions = counted(marks.len(), "submission");
    let mut text = format!("{submissions} graded: {}\n", report.display());
    for PassedOver { name, reason } in &passed_over {
        let _ = writeln!(text, "passed over: {name} ({reason})");
    }
    output::say(&text)
}
