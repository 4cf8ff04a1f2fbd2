//! What this program knows of the files that it reads and writes, to notice what other programs did to them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::{Place, Stamp, fs};

/// What another program did to a file that this one knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutsideChange {
    /// There was no file when this program started.
    Appeared,
    /// The file has other content.
    Changed,
}

/// Files by their paths without links, and what they were when this program last looked.
#[derive(Clone, Debug, Default)]
pub struct KnownFiles {
    /// `None`: there was no file.
    states: BTreeMap<PathBuf, Option<Stamp>>,
    /// What was read last, until it is known whether anybody took it in: a file, and what was read with it.
    read: Vec<(PathBuf, Stamp)>,
}

impl KnownFiles {
    /// The state of a file at the start, before anything of it was read.
    pub fn begin(&mut self, path: &Path) {
        self.set(path, Stamp::unread);
    }

    /// The state of a file at the start whose content was taken in already.
    pub fn begin_with_content(&mut self, path: &Path) {
        self.set(path, Stamp::of_file);
    }

    /// A file was read. It counts as known once its content is [taken in](Self::took_in).
    pub fn read(&mut self, path: &Path, bytes: &[u8]) {
        self.read.clear();
        self.read_with_it(path, bytes);
    }

    /// A file was read that is part of the one before it.
    pub fn read_with_it(&mut self, path: &Path, bytes: &[u8]) {
        self.read.extend(place(path).map(|place| (place, Stamp::of(path, bytes))));
    }

    /// The content that was read last was taken in.
    pub fn took_in(&mut self) {
        self.states.extend(self.read.drain(..).map(|(path, stamp)| (path, Some(stamp))));
    }

    /// A file was written.
    pub fn wrote(&mut self, path: &Path, stamp: Stamp) {
        self.set(path, |_| Some(stamp));
    }

    fn set(&mut self, path: &Path, state: impl FnOnce(&Path) -> Option<Stamp>) {
        if let Some(place) = place(path) {
            self.states.insert(place, state(path));
        }
    }

    /// Whether a file's content was read or written.
    #[must_use]
    pub fn knows(&self, path: &Path) -> bool {
        place(path).is_some_and(|place| matches!(self.states.get(&place), Some(Some(_))))
    }

    /// A file's content is what it was, whatever its time says.
    pub fn is_still(&mut self, path: &Path) {
        if let Some(Some(stamp)) = place(path).and_then(|place| self.states.get_mut(&place)) {
            *stamp = stamp.placed_at(path);
        }
    }

    /// Forgets everything: what a document was made of is not known any more.
    pub fn forget_all(&mut self) {
        *self = Self::default();
    }

    /// What another program did to a file. The content decides, where it was ever read. A file that is gone, a device or a pipe has
    /// nothing that could be lost.
    #[must_use]
    pub fn change(&self, path: &Path) -> Option<OutsideChange> {
        let known = self.states.get(&place(path)?)?;
        if !fs::metadata(path).is_ok_and(|metadata| metadata.is_file()) {
            return None;
        }
        match known {
            None => Some(OutsideChange::Appeared),
            Some(stamp) => (!stamp.is_same(path)).then_some(OutsideChange::Changed),
        }
    }

    /// The present state of a file that may have changed; `None` where its length and time say that it did not, or where there is
    /// nothing to read. Cheap: the content is not read.
    #[must_use]
    pub fn suspect(&self, path: &Path) -> Option<Stamp> {
        let known = self.states.get(&place(path)?)?;
        if known.as_ref().is_some_and(|stamp| stamp.looks_same(path)) {
            return None;
        }
        Stamp::unread(path)
    }
}

/// What stands for a file however it is named; `None` for a device or a pipe, which hold nothing.
fn place(path: &Path) -> Option<PathBuf> {
    match Place::of_output(path) {
        Place::File(path) => Some(path),
        Place::Standard | Place::Stream => None,
    }
}
