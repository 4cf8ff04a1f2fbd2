//! How a command tells its progress.

use clap::ValueEnum;

/// How progress is told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum ProgressKind {
    /// A line on standard error that changes, if that is a terminal.
    #[default]
    Terminal,
    /// Lines on standard output in the words of Open Job Description: openjd_progress, openjd_status, and openjd_fail for an error.
    Openjd,
    /// Not at all.
    None,
}
