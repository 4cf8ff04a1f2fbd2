//! Grading: submissions in, marks by a rubric out, and tables, a report and pictures of the marks.
//!
//! ```text
//! paths ─ submission ─► members ─ parsed ─► Parsed ─ Marks::of(rubric) ─► Marks ─┬─ tables ─► grades.csv, grades.json
//!                                                                                └─ pictures ─ report ─► report.html
//! ```
//!
//! `Marks::of` uses `item` and `verdicts` (graded items), `samples` and `shown` (diagnoses), `folder` (runs scripts in memory) and `trace`.
//!
//! A submission is gathered, sorted and parsed once. Submissions are marked on all cores, each apart from the others; results are in the
//! order in which the submissions were named, and nothing in them depends on time. Nothing in a submission is trusted: work is bounded
//! by counts, not by a clock, so that results are the same on every machine.

mod folder;
mod item;
mod marks;
mod parsed;
mod pictures;
mod report;
mod rubric;
mod samples;
mod shown;
mod submission;
mod tables;
mod trace;
mod verdicts;

use std::panic::{AssertUnwindSafe, catch_unwind};

pub use item::{Item, ItemKind, Verdict};
pub use marks::Marks;
pub use parsed::Parsed;
pub use pictures::{ReportPicture, SIZE as PICTURE_SIZE, pictures_of};
pub use report::html;
pub use rubric::Rubric;
pub use samples::SampleDiagnosis;
pub use submission::{Member, Submission, find, unpacked};
pub use tables::{csv, json};

use crate::parallel::map_in_order;
use crate::scene::SceneGraph;

/// Marks all submissions, on all cores, in their order.
#[must_use]
pub fn mark_all(submissions: &[Submission], rubric: &Rubric, scene: &SceneGraph) -> Vec<Marks> {
    map_in_order(submissions, |submission| mark_one(submission, rubric, scene))
}

/// Marks one submission. Nothing in it should make this program panic; if something does, it costs this submission only.
fn mark_one(submission: &Submission, rubric: &Rubric, scene: &SceneGraph) -> Marks {
    let mark = |members| Marks::of(&submission.name, &Parsed::new(members, scene), rubric, scene);
    catch_unwind(AssertUnwindSafe(|| mark(submission.read())))
        .unwrap_or_else(|_| mark(Err("this program failed on it: please report the submission".to_owned())))
}
