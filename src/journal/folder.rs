//! The folder of journals: those that programs left, and which of them go.

use std::path::Path;

use super::mark::{self, Survey, survey};
use crate::storage::{self, LeftLog};

/// How the names of journals end.
pub const ENDING: &str = ".journal";
/// As much of a journal is read: it may hold the snapshot of the largest document.
pub const LARGEST_READ_BYTES: u64 = 4 << 30;
/// So many journals of programs that ended well are kept.
const MOST_FINISHED: usize = 10;

/// A journal that a program left, held so that nobody else takes it.
#[derive(Debug)]
pub struct Left {
    /// Its file.
    pub log: LeftLog,
    /// What it says of itself.
    pub survey: Survey,
}

impl Left {
    /// Takes hold of a journal; `None` where a program uses it, or it is none.
    #[must_use]
    pub fn open(path: &Path) -> Option<Self> {
        let log = LeftLog::open(path).ok()??;
        let survey = survey(&log.read(LARGEST_READ_BYTES).ok()?)?;
        Some(Self { log, survey })
    }

    /// Marks that what it holds is safe elsewhere, so that it is not offered again.
    pub fn take_over(self) {
        let _ = self.log.append(format!("{}\n", mark::TAKEN).as_bytes());
    }
}

/// The journals in a folder that hold what was not saved, the newest first; none that is in use.
#[must_use]
pub fn left(folder: &Path) -> Vec<Left> {
    let journals = storage::logs(folder, ENDING).into_iter().filter_map(|path| Left::open(&path));
    journals.filter(|left| !left.survey.is_over && left.survey.unsaved > 0).collect()
}

/// Removes journals of programs that ended well, but for the newest ones. Journals that hold what was not saved are never removed.
pub fn tidy_up(folder: &Path) {
    let journals = storage::logs(folder, ENDING).into_iter().filter_map(|path| Left::open(&path));
    let finished = journals.filter(|left| left.survey.is_over || left.survey.unsaved == 0);
    for left in finished.skip(MOST_FINISHED) {
        // What cannot be removed does no harm.
        let _ = left.log.remove();
    }
}
