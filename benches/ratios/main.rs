//! How fast the animator is beside the plain way of doing the same: `cargo bench --bench ratios`.
//!
//! Both sides run in turn, so that whatever else the machine does weighs on both; a ratio is one of undisturbed times. Exits with 1
//! where a goal is missed. `cargo bench --bench ratios -- 1 3` measures some of the goals.

mod drawing;
mod files;
mod films;
mod poses;
mod report;
mod start;

use std::process::ExitCode;

use report::Report;

/// A goal's number, and what measures it.
type Goal = (usize, fn(&mut Report));

fn main() -> ExitCode {
    if let Some(path) = std::env::args().skip_while(|argument| argument != start::BARE).nth(1) {
        start::be_bare(&path);
        return ExitCode::SUCCESS;
    }
    let goals: [Goal; 7] = [
        (1, poses::linear),
        (2, poses::catmull_rom),
        (3, poses::worlds),
        (4, drawing::boxes),
        (5, start::process),
        (6, files::keyframe_files),
        (7, films::frames),
    ];
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
