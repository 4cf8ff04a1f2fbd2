//! How fast the animator is beside the plain way of doing the same: `cargo bench --bench ratios`.
//!
//! Both sides run in turn, so that whatever else the machine does weighs on both; a ratio is one of undisturbed times. Exits with 1
//! where a goal is missed. `cargo bench --bench ratios -- 1 3` measures some of the goals.

mod files;
mod poses;
mod report;

use std::process::ExitCode;

use report::Report;

/// Measures what a goal is about.
type Measure = fn(&mut Report);

fn main() -> ExitCode {
    let goals: [(usize, Measure); 4] =
        [(1, poses::linear), (2, poses::catmull_rom), (3, poses::worlds), (6, files::keyframe_files)];
    let asked: Vec<usize> = std::env::args().filter_map(|argument| argument.parse().ok()).collect();
    let mut report = Report::default();
    for (goal, measure) in goals {
        if asked.is_empty() || asked.contains(&goal) {
            report.goal = goal;
            measure(&mut report);
        }
    }
    if report.is_met() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
