//! What `grade` says of its results, and how it ends.

use std::fmt::Write as _;
use std::path::Path;

use crate::cli::arguments::GradeArguments;
use crate::cli::error::Ended;
use crate::grading::{GradedClass, Marks, Matched, PassedOver, evidence_counts, number};
use crate::text::counted;
use crate::words::texts;

/// What there is to say of results.
pub struct Summary<'a> {
    /// The results.
    pub class: &'a GradedClass,
    /// What of the roster does not go together.
    pub matched: &'a Matched,
    /// Overrides for nobody.
    pub unmatched: &'a [String],
    /// Submissions that are not in the results.
    pub left_out: &'a [String],
}

impl Summary<'_> {
    /// A line for each thing to know: the counts, who could not be read, who is below the limit, what was passed over.
    pub fn lines(&self, report: &Path, arguments: &GradeArguments) -> String {
        let Self { class: GradedClass { marks, rubric, passed_over, .. }, matched, unmatched, left_out } = *self;
        let missing: Vec<&Marks> = marks.iter().filter(|marks| marks.is_missing).collect();
        let handed_in = marks.len() - missing.len();
        let mut text = format!("{} graded: {}\n", counted(handed_in, "submission"), report.display());
        if let Some(counts) = evidence_counts(marks) {
            let _ = writeln!(text, "{counts}");
        }
        text.push_str(&unread(marks));
        for marks in missing {
            let _ = writeln!(text, "{}", texts::grade_missing(&marks.name));
        }
        for name in &matched.unknown {
            let _ = writeln!(text, "{}", texts::grade_not_on_roster(name));
        }
        for (name, submissions) in &matched.repeated {
            let _ = writeln!(text, "{}", texts::grade_repeated(name, submissions.join(", ")));
        }
        if !left_out.is_empty() {
            let _ = writeln!(text, "{}", texts::grade_left_out(left_out.join(", ")));
        }
        for student in unmatched {
            let _ = writeln!(text, "{}", texts::grade_nobody(student));
        }
        text.push_str(&told_below(marks, arguments));
        for PassedOver { name, reason } in passed_over {
            let _ = writeln!(text, "passed over: {name} ({reason})");
        }
        if let Some(warning) = rubric.revealed.warning() {
            let _ = writeln!(text, "{warning}");
        }
        text
    }
}

/// Who could not be read: the count, and a line each.
fn unread(marks: &[Marks]) -> String {
    let unread: Vec<(&Marks, &String)> =
        marks.iter().filter_map(|marks| Some((marks, marks.unread.as_ref()?))).collect();
    if unread.is_empty() {
        return String::new();
    }
    let handed_in = marks.iter().filter(|marks| !marks.is_missing).count();
    let mut text = format!("{}\n", texts::grade_unread_count(unread.len(), handed_in));
    for (marks, reason) in unread {
        let _ = writeln!(text, "{}", texts::grade_unread(&marks.name, reason));
    }
    text
}

/// Who is below the limit, a line each; nothing without a limit.
fn told_below(marks: &[Marks], arguments: &GradeArguments) -> String {
    let Some(percent) = arguments.fail_under else { return String::new() };
    let line = |marks: &Marks| {
        let points = [marks.points(), marks.out_of()].map(number);
        format!("{}\n", texts::grade_below(percent, &marks.name, &points[0], &points[1]))
    };
    below(marks, percent).map(line).collect()
}

/// Why the command ends as it does, which also a quiet one says; empty where all is well.
pub fn failures(marks: &[Marks], arguments: &GradeArguments) -> String {
    let unread = if arguments.strict { unread(marks) } else { String::new() };
    unread + &told_below(marks, arguments)
}

/// How the command ends where all is written.
pub fn ending(marks: &[Marks], arguments: &GradeArguments) -> Ended {
    let has_unread = arguments.strict && marks.iter().any(|marks| marks.unread.is_some());
    let has_below = arguments.fail_under.is_some_and(|percent| below(marks, percent).next().is_some());
    if has_unread || has_below { Ended::Beyond } else { Ended::Well }
}

/// Those with less than this percentage of the points. Errors of rounding do not count.
fn below(marks: &[Marks], percent: f64) -> impl Iterator<Item = &Marks> {
    marks.iter().filter(move |marks| marks.points() < percent / 100.0 * marks.out_of() - 1e-9)
}
