//! What is unfinished while the program runs, and what clears it away if the program ends before: drafts that would stay, programs
//! that would go on.
//!
//! A signal ends the program in the middle of anything, so the list belongs to the process.

use std::collections::BTreeMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Clears something away.
type Clear = Box<dyn FnOnce() + Send>;

static ALL: Mutex<List> = Mutex::new(List { next: 0, clears: BTreeMap::new() });

struct List {
    next: u64,
    clears: BTreeMap<u64, Clear>,
}

/// Something unfinished. It is finished, well or not, when this is dropped.
#[derive(Debug)]
pub struct Unfinished(u64);

/// Holds up [`clear_all`], so that what is made and its entry in the list are one step.
pub struct Hold(MutexGuard<'static, List>);

/// Holds up [`clear_all`]. To be released before an [`Unfinished`] is dropped.
#[must_use]
pub fn hold() -> Hold {
    Hold(ALL.lock().unwrap_or_else(PoisonError::into_inner))
}

impl Hold {
    /// Lists something that `clear` clears away if the program ends before it is finished.
    #[must_use]
    pub fn begin(mut self, clear: impl FnOnce() + Send + 'static) -> Unfinished {
        let List { next, clears } = &mut *self.0;
        *next += 1;
        clears.insert(*next, Box::new(clear));
        Unfinished(*next)
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        let cleared = hold().0.clears.remove(&self.0);
        drop(cleared);
    }
}

/// Clears everything away. The program must end after it: whoever begins or finishes something waits forever.
pub fn clear_all() {
    let mut all = hold();
    for clear in std::mem::take(&mut all.0.clears).into_values() {
        clear();
    }
    std::mem::forget(all);
}
