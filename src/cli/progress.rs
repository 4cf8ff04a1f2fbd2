//! A progress line, on a terminal only.

use std::io::{self, IsTerminal as _, Write as _};

/// Progress in steps. The line is erased when this is dropped.
pub struct Progress {
    what: &'static str,
    steps: usize,
    done: usize,
    is_shown: bool,
}

impl Progress {
    /// Nothing done yet of `steps` steps; `what` names one of them.
    pub fn new(what: &'static str, steps: usize) -> Self {
        Self { what, steps, done: 0, is_shown: io::stderr().is_terminal() }
    }

    /// One more step is done. The line changes a thousand times at most.
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
        if self.is_shown && thousandth(self.done) != thousandth(before) {
            let percent = self.done * 100 / self.steps;
            let _ = write!(io::stderr(), "\r{} {} of {} ({percent} %)", self.what, self.done, self.steps);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.is_shown && self.done > 0 {
            let _ = write!(io::stderr(), "\r\u{1b}[K");
        }
    }
}
