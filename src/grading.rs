//! Grading: submissions in, marks by a rubric out, and tables, a report and pictures of the marks.
//!
//! ```text
//! paths ─ gather ─► submissions ─ read ─► members ─ parsed ─► Parsed ─ Marks::of(rubric) ─► Marks ─┬─ tables ─► grades.csv, grades.json
//!                                                                                └─ pictures, film ─ report ─► report.html
//! ```
//!
//! `gather` uses `place` and `archive` (files on the disk and in archives); `parsed` uses `content` (what a file is) and `names` (which
//! of several files is meant). `Marks::of` uses `item` and `verdicts` (graded items), `alignment` (keyframes with keyframes), `samples`,
//! `folder` (runs scripts in memory) and `trace`.
//!
//! `samples` diagnoses samples and judges them by `shown_playback`: `right` is what they should show, `off` how far a row is from that,
//! `judgement` sums up the rows, `coverage` counts them, and `range` looks at both ends. `shown` chooses the poses of pictures.
//! `formats` writes results as course systems read them, `person` says how these know a student, and `roster`
//! whose each submission is. `overrides` and `late` change points afterwards.
//! `cache` has marks and pictures of earlier runs, as `kept` writes them; `finding` is what remains of samples.
//! Tables and report share `rows` (items as people read them), `note` and `cells`. `hash` says which files results are of.
//! `anonymous` takes the names out of marks before any is written.
//!
//! `shard` is a class that was graded, and a part of one as a file.
//!
//! `check` says what a rubric's reference reveals, `requirements` judges animations without a reference, and `example` is what a rubric
//! begins with.
//!
//! A submission is gathered, sorted and parsed once. Submissions are marked on all cores, each apart from the others; results are in the
//! order in which the submissions were named, and nothing in them depends on time. Nothing in a submission is trusted: work is bounded
//! by counts, not by a clock, so that results are the same on every machine.

mod alignment;
mod anonymous;
mod archive;
mod cache;
mod cells;
mod check;
mod content;
mod coverage;
mod example;
mod film;
mod finding;
mod folder;
mod formats;
mod gather;
mod hash;
mod item;
mod judgement;
mod kept;
mod late;
mod marks;
mod names;
mod note;
mod off;
mod overrides;
mod parsed;
mod person;
mod pictures;
mod place;
mod range;
mod report;
mod requirements;
mod right;
mod roster;
mod rows;
mod rubric;
mod samples;
mod shard;
mod shown;
mod shown_playback;
mod studio;
mod submission;
mod tables;
mod trace;
mod verdicts;

use std::panic::{AssertUnwindSafe, catch_unwind};

pub use anonymous::{make_anonymous, make_public};
pub use cache::{Basis, Cache, Images, Key, MOST_KEPT_BYTES, hash};
pub use cells::number;
pub use check::{Revealed, RubricCheck};
pub use example::example;
pub use film::{MistakeFilm, film_of};
pub use finding::{Answer, Finding, SampleFinding};
pub use formats::{FORMATS, Format, Given, ResultFile, format_named};
pub use gather::{Found, Naming, PassedOver, System, find};
pub use hash::Hashed;
pub use item::{Evidence, Item, ItemKind, Verdict};
pub use late::Late;
pub use marks::{Marks, PlaybackEvidence, evidence_counts};
pub use note::Note;
pub use overrides::{LARGEST_BYTES as LARGEST_OVERRIDES_BYTES, Overrides, USUAL_NAME as USUAL_OVERRIDES};
pub use parsed::Parsed;
pub use person::Person;
pub use pictures::pictures_of;
pub use report::{Feedback, Points, ShownMistake, feedback, html, mistakes_shown, public_page};
pub use requirements::{Requirement, Requirements};
pub use roster::{Matched, Roster};
pub use rubric::{Band, Credit, Reference, Rubric};
pub use shard::{GradedClass, MOST_SHARDS, Shard, ShardNumber};
pub use studio::{ReportPicture, SIZE as PICTURE_SIZE, Studio};
pub use submission::Submission;
pub use tables::{csv, json};

use kept::Kept;
use submission::Contents;

use crate::parallel::map_in_order;
use crate::scene::SceneGraph;

/// Marks submissions, on all cores, in their order. What the cache knows by the contents of a submission is taken from it, with pictures.
/// `None` for those that it does not know and that are not wanted.
#[must_use]
pub fn mark_all(
    submissions: &[Submission],
    is_wanted: impl Fn(&Submission) -> bool + Sync,
    rubric: &Rubric,
    scene: &SceneGraph,
    cache: &Cache,
) -> Vec<Option<Marks>> {
    map_in_order(submissions, |submission| mark_one(submission, is_wanted(submission), rubric, scene, cache))
}

/// Marks one submission. Nothing in it should make this program panic; if something does, it costs this submission only.
fn mark_one(
    submission: &Submission,
    is_wanted: bool,
    rubric: &Rubric,
    scene: &SceneGraph,
    cache: &Cache,
) -> Option<Marks> {
    let mark = |contents: Contents| {
        let hashed = contents.members.iter().map(|member| Hashed::new(&*member.name, &member.bytes));
        let mut files: Vec<Hashed> = hashed.collect();
        let key = cache.key_of(&contents, &files);
        files.sort();
        let kept = cache.get::<Kept>(&key).and_then(|kept| kept.restored(submission, rubric));
        let new = || {
            let parsed = Parsed::new(contents, &rubric.keyframe_file, scene);
            Marks::of(submission, &parsed, rubric, scene)
        };
        let marks = kept.or_else(|| is_wanted.then(new))?;
        Some(Marks { files, key, ..marks })
    };
    catch_unwind(AssertUnwindSafe(|| mark(submission.read(&rubric.keyframe_file)))).unwrap_or_else(|_| {
        let problem = Some("this program failed on it: please report the submission".to_owned());
        mark(Contents { problem, ..Contents::default() })
    })
}

impl Cache {
    /// Keeps the marks and pictures of a submission for the next run.
    pub fn keep_marks(&mut self, marks: &Marks) {
        self.keep(marks.key.clone(), &Kept::of(marks));
    }
}
