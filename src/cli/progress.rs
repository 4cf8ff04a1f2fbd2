//! Progress: a line on a terminal, or lines for a program that runs jobs.

use std::io::{self, IsTerminal as _, Write as _};

use super::arguments::ProgressKind;
use super::{CliError, output};

/// Progress in steps. A terminal's line is erased when this is dropped.
pub struct Progress {
    what: &'static str,
    steps: usize,
    done: usize,
    /// `None` where nobody is told.
    told: Option<ProgressKind>,
}

impl Progress {
    /// Nothing done yet of `steps` steps, told on a terminal; `what` names one of them.
    pub fn new(what: &'static str, steps: usize) -> Self {
        Self::told(ProgressKind::Terminal, what, steps)
    }

    fn told(kind: ProgressKind, what: &'static str, steps: usize) -> Self {
        let is_told = kind == ProgressKind::Openjd || io::stderr().is_terminal();
        Self { what, steps, done: 0, told: is_told.then_some(kind) }
    }

    /// One more step is done. A thousand lines are told at most.
    pub fn step(&mut self) {
        self.reach(self.done + 1);
    }

    /// `done` steps are done.
    pub fn reach(&mut self, done: usize) {
        if done == self.done {
            return;
        }
        let before = std::mem::replace(&mut self.done, done);
        let thousandth = |done: usize| done * 1000 / self.steps;
        if thousandth(self.done) != thousandth(before) {
            self.tell();
        }
    }

    fn tell(&self) {
        let Self { what, steps, done, told } = self;
        match told {
            None => {}
            Some(ProgressKind::Terminal) => {
                let _ = write!(io::stderr(), "\r{what} {done} of {steps} ({} %)", done * 100 / steps);
            }
            Some(ProgressKind::Openjd) => {
                let percent = *done as f64 * 100.0 / *steps as f64;
                // A reader that is gone is no reason to stop the work.
                let _ = output::print(|output| {
                    writeln!(output, "openjd_progress: {percent:.1}\nopenjd_status: {what} {done} of {steps}")
                });
            }
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.told == Some(ProgressKind::Terminal) && self.done > 0 {
            let _ = write!(io::stderr(), "\r\u{1b}[K");
        }
    }
}

/// A watcher of an export that tells its progress.
pub fn watched(kind: ProgressKind) -> impl FnMut(usize, usize) -> bool {
    let mut progress = None;
    move |done, count| {
        progress.get_or_insert_with(|| Progress::told(kind, "frame", count)).reach(done);
        true
    }
}

/// Does the work. Where it fails and a program that runs jobs listens, tells that why.
///
/// # Errors
/// Those of the work.
pub fn telling(kind: ProgressKind, work: impl FnOnce() -> Result<(), CliError>) -> Result<(), CliError> {
    let done = work();
    if let (ProgressKind::Openjd, Err(CliError::Failed { sentences, .. })) = (kind, &done) {
        output::say(&format!("openjd_fail: {}\n", sentences.join("; ")))?;
    }
    done
}
