//! JUnit XML: a suite for each submission, a case for each item.

use super::{Format, Given, ResultFile};
use crate::grading::cells::number;
use crate::grading::item::{Evidence, Item};
use crate::grading::marks::Marks;
use crate::grading::rubric::Rubric;
use crate::junit::{Case, Outcome, Suite, xml};

pub const FORMAT: Format = Format {
    name: "junit",
    about: "junit.xml for CI services and CodeGrade, with points as properties",
    variables: &[],
    problem: |_| None,
    files,
};

fn files(marks: &[Marks], _: &Rubric, _: &Given) -> Vec<ResultFile> {
    let suites: Vec<Suite> = marks.iter().map(suite).collect();
    vec![ResultFile { path: "junit.xml".to_owned(), text: xml(&suites) }]
}

fn suite(marks: &Marks) -> Suite {
    let case = |item: &Item| {
        let outcome = match (item.has_lost(), marks.unread.is_some()) {
            (false, _) => Outcome::Passed,
            (true, false) => Outcome::Failed(item.reason.clone()),
            (true, true) => Outcome::Errored(item.reason.clone()),
        };
        let evidence = item.evidence.map(|evidence| ("evidence".to_owned(), Evidence::id(evidence).to_owned()));
        let points = [("points", item.points), ("out_of", item.out_of)];
        let points = points.map(|(name, points)| (name.to_owned(), number(points)));
        Case {
            name: item.kind.title(),
            class_name: marks.name.clone(),
            file: marks.keyframe_file.clone(),
            outcome,
            properties: points.into_iter().chain(evidence).collect(),
        }
    };
    let mut cases: Vec<Case> = marks.items.iter().map(case).collect();
    if marks.late_points > 0.0 {
        cases.push(Case {
            name: "late".to_owned(),
            class_name: marks.name.clone(),
            file: None,
            outcome: Outcome::Failed(format!("Lateness costs {} points.", number(marks.late_points))),
            properties: vec![("points".to_owned(), number(-marks.late_points))],
        });
    }
    Suite { name: marks.name.clone(), cases }
}
