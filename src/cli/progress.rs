//! Progress: a line on a terminal, or lines for a program that runs jobs.

use super::arguments::ProgressKind;
use super::{CliError, Common, output};

/// Progress in steps. A terminal's line is erased when this is dropped.
pub struct Progress {
    what: &'static str,
    steps: usize,
    done: usize,
    /// What is worked on now; may be empty.
    name: String,
    kind: ProgressKind,
    /// Whether a terminal shows it.
    is_shown: bool,
}

impl Progress {
    /// Nothing done yet of `steps` steps; `what` names one of them.
    pub fn new(kind: ProgressKind, what: &'static str, steps: usize) -> Self {
        Self { what, steps, done: 0, name: String::new(), kind, is_shown: false }
    }

    /// Progress of items that are told on a terminal where there are several.
    pub fn of_items(what: &'static str, items: usize, common: Common<'_>) -> Self {
        let kind = if items > 1 { common.progress(ProgressKind::Terminal) } else { ProgressKind::None };
        Self::new(kind, what, items)
    }

    /// The next step is begun, which is work on something of that name.
    pub fn begin(&mut self, name: &str) {
        name.clone_into(&mut self.name);
        if self.is_due(self.done, self.done + 1) {
            self.tell();
        }
    }

    /// One more step is done. A thousand lines are told at most.
    pub fn step(&mut self) {
        self.reach(self.done + 1);
    }

    /// `done` steps are done.
    pub fn reach(&mut self, done: usize) {
        let before = std::mem::replace(&mut self.done, done);
        if self.is_due(before, done) {
            self.tell();
        }
    }

    fn is_due(&self, before: usize, done: usize) -> bool {
        // Of no steps, none is told.
        let thousandth = |done: usize| (done * 1000).checked_div(self.steps);
        thousandth(before) != thousandth(done)
    }

    fn tell(&mut self) {
        let Self { what, steps, done, name, kind, is_shown } = self;
        match kind {
            ProgressKind::None => {}
            ProgressKind::Terminal => {
                let of = if name.is_empty() { String::new() } else { format!(": {name}") };
                *is_shown = output::show_status(&format!("{what} {done} of {steps} ({} %){of}", *done * 100 / *steps));
            }
            ProgressKind::Openjd => {
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
        if self.is_shown {
            output::clear_status();
        }
    }
}

/// A watcher of an export that tells its progress; `name` is what is made.
pub fn watched(kind: ProgressKind, name: String) -> impl FnMut(usize, usize) -> bool {
    let mut progress: Option<Progress> = None;
    move |done, count| {
        let progress = progress.get_or_insert_with(|| {
            let mut progress = Progress::new(kind, "frame", count);
            name.clone_into(&mut progress.name);
            progress
        });
        progress.reach(done);
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
