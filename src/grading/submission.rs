//! Reading the files of one submission, within bounds.
//!
//! What cannot be read is skipped, with the reason, and never fatal. Bounds count what is read.

use std::path::Path;

use super::archive::{Keep, Unread};
use super::gather::System;
use super::names::{PreferredNames, is_hidden, kind_not_read};
use super::note::Note;
use super::place::{Entry, Place};
use crate::storage::EntryKind;

/// The most files that are read of one submission.
const MOST_FILES: usize = 200;
/// The most files and folders of one submission that are listed.
const MOST_LISTED: usize = 20_000;
/// The largest file of a submission that is read, unpacked: 16 MiB.
const LARGEST_FILE_BYTES: u64 = 16 << 20;
/// The most bytes that are read of a submission, unpacked: 64 MiB.
const MOST_BYTES: u64 = 64 << 20;
/// The most bytes of an archive that are looked through where it can be read only as a whole: 1 GiB.
const MOST_LOOKED_THROUGH: u64 = 1 << 30;
/// The maximum depth of folders in a submission.
const DEEPEST: usize = 8;
/// How deep archives are opened inside each other.
const DEEPEST_ARCHIVE: usize = 2;

/// One student's entry, not yet read.
#[derive(Clone, Debug)]
pub struct Submission {
    /// Its name in the results, that of its folder or file; no two are the same.
    pub name: String,
    /// The student's name, where the entry's name tells it.
    pub student: Option<String>,
    /// The student's number in the course system, where the entry's name tells it.
    pub id: Option<String>,
    /// The course system that the entry's name is of.
    pub system: Option<System>,
    /// Whether the course system says that it came late.
    pub is_late: bool,
    /// How many days late, where the course system says it.
    pub days_late: Option<u32>,
    /// Its folders and files, at least one: the entry, and its name in the submission.
    pub(super) roots: Vec<Entry>,
}

/// A file of a submission.
#[derive(Clone, Debug)]
pub struct Member {
    /// Its path in the submission.
    pub name: String,
    /// What it holds.
    pub bytes: Vec<u8>,
}

/// Why a file was skipped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Why {
    /// Its ending tells that it holds nothing to grade: the kind, in singular and plural.
    Kind(&'static str, &'static str),
    /// It is larger than [`LARGEST_FILE_BYTES`].
    Large,
    /// It is a link out of the submission.
    Link,
    /// Its folder is too deep.
    Deep,
    /// Enough files, or enough bytes, were read before it.
    Enough,
    /// It cannot be read: a sentence.
    Problem(String),
}

/// A file that was skipped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Skipped {
    /// Its path in the submission.
    pub name: String,
    /// Why.
    pub why: Why,
}

/// What was read of a submission.
#[derive(Clone, Debug, Default)]
pub struct Contents {
    /// Files, the likeliest first.
    pub members: Vec<Member>,
    /// What was not read.
    pub skipped: Vec<Skipped>,
    /// Why nothing could be read.
    pub problem: Option<String>,
}

impl Submission {
    /// A submission that is one file, or an archive, in memory.
    #[must_use]
    pub fn in_memory(name: &str, bytes: Vec<u8>) -> Self {
        let root = Entry { name: name.to_owned(), kind: EntryKind::File, place: Place::Memory(bytes.into()) };
        Self {
            name: name.to_owned(),
            student: None,
            id: None,
            system: None,
            is_late: false,
            days_late: None,
            roots: vec![root],
        }
    }

    /// The files and folders on the disk that it is, or the archive that it is in.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.roots.iter().filter_map(|root| root.place.path())
    }

    /// Reads the files.
    #[must_use]
    pub fn read(&self, preferred: &PreferredNames) -> Contents {
        let mut reading = Reading { preferred, contents: Contents::default(), bytes: 0, listed: 0 };
        let is_alone = self.roots.len() == 1;
        for root in &self.roots {
            match root.kind {
                EntryKind::Folder => reading.read_folder(&root.place, "", 0),
                EntryKind::Other => reading.contents.problem = Some("it is neither a file nor a folder".to_owned()),
                EntryKind::File | EntryKind::Link => reading.read_root(root, is_alone),
            }
        }
        let mut contents = reading.contents;
        contents.members.sort_by_cached_key(|member| preferred.rank(&member.name));
        contents.skipped.sort_by(|a, b| a.name.cmp(&b.name));
        contents
    }
}

struct Reading<'a> {
    preferred: &'a PreferredNames,
    contents: Contents,
    /// How many bytes were read.
    bytes: u64,
    /// How many entries were listed.
    listed: usize,
}

/// A file that was listed and may be read.
struct Listed {
    name: String,
    place: Place,
}

impl Reading<'_> {
    fn skip(&mut self, name: &str, why: Why) {
        self.contents.skipped.push(Skipped { name: name.to_owned(), why });
    }

    fn is_wanted(&self, name: &str) -> bool {
        self.preferred.fit(name) || kind_not_read(name).is_none()
    }

    /// A submission that is one file, or one of the student's files in an export without folders.
    fn read_root(&mut self, root: &Entry, is_alone: bool) {
        if let (false, Some((one, many))) = (self.is_wanted(&root.name), kind_not_read(&root.name)) {
            return self.skip(&root.name, Why::Kind(one, many));
        }
        match self.opened(&root.name, &root.place) {
            Ok(Some(archive)) => {
                let above = if is_alone { String::new() } else { format!("{}/", root.name) };
                self.read_folder(&archive, &above, 1);
            }
            Ok(None) => self.read_file(&root.name, &root.place),
            Err(Why::Problem(problem)) if is_alone => {
                self.contents.problem = Some(format!("{}: {problem}", root.name));
            }
            Err(why) => self.skip(&root.name, why),
        }
    }

    /// The archive at a place as a folder; `None` if there is no archive.
    fn opened(&self, name: &str, place: &Place) -> Result<Option<Place>, Why> {
        let largest = |name: &str| {
            let is_wanted = self.is_wanted(name) && !name.split('/').any(is_hidden);
            is_wanted.then_some(LARGEST_FILE_BYTES)
        };
        let keep = Keep { largest: &largest, most: MOST_BYTES, through: MOST_LOOKED_THROUGH };
        match place.archive(name, &keep) {
            Ok(archive) => Ok(archive.map(|archive| Place::Packed(archive, String::new()))),
            Err(Unread::Problem(problem)) => Err(Why::Problem(problem)),
            Err(Unread::Large) => Err(Why::Large),
        }
    }

    /// Reads a folder with all below it: first it is listed, then the likeliest files are read.
    fn read_folder(&mut self, folder: &Place, above: &str, archives: usize) {
        let mut listed = Vec::new();
        self.list(folder, folder, above, 0, &mut listed);
        listed.sort_by_cached_key(|file| self.preferred.rank(&file.name));
        for Listed { name, place } in listed {
            if self.contents.members.len() >= MOST_FILES {
                self.skip(&name, Why::Enough);
                continue;
            }
            match self.opened(&name, &place) {
                Ok(None) => self.read_file(&name, &place),
                Ok(Some(_)) if archives >= DEEPEST_ARCHIVE => {
                    let problem = "it is an archive in an archive in an archive, which is not opened".to_owned();
                    self.skip(&name, Why::Problem(problem));
                }
                Ok(Some(archive)) => self.read_folder(&archive, &format!("{name}/"), archives + 1),
                Err(why) => self.skip(&name, why),
            }
        }
    }

    fn list(&mut self, folder: &Place, root: &Place, above: &str, depth: usize, listed: &mut Vec<Listed>) {
        let left = MOST_LISTED.saturating_sub(self.listed);
        let (entries, count) = match folder.list(left) {
            Ok(found) => found,
            Err(problem) => return self.skip(above, Why::Problem(problem)),
        };
        self.listed += entries.len();
        if count > entries.len() {
            let folder = if above.is_empty() { "the rest" } else { above };
            let problem = format!("at most {MOST_LISTED} files and folders of a submission are listed");
            self.skip(folder, Why::Problem(problem));
        }
        for entry in entries.into_iter().filter(|entry| !is_hidden(&entry.name)) {
            let name = format!("{above}{}", entry.name);
            let place = match entry.kind {
                EntryKind::Folder if depth >= DEEPEST => {
                    self.skip(&name, Why::Deep);
                    continue;
                }
                EntryKind::Folder => {
                    self.list(&entry.place, root, &format!("{name}/"), depth + 1, listed);
                    continue;
                }
                EntryKind::File => entry.place,
                EntryKind::Link => {
                    if let Some(place) = entry.place.followed(root) {
                        place
                    } else {
                        self.skip(&name, Why::Link);
                        continue;
                    }
                }
                EntryKind::Other => {
                    self.skip(&name, Why::Problem("it is neither a file nor a folder".to_owned()));
                    continue;
                }
            };
            match kind_not_read(&name) {
                Some((one, many)) if !self.preferred.fit(&name) => self.skip(&name, Why::Kind(one, many)),
                _ => listed.push(Listed { name, place }),
            }
        }
    }

    fn read_file(&mut self, name: &str, place: &Place) {
        let left = MOST_BYTES.saturating_sub(self.bytes);
        match place.read(LARGEST_FILE_BYTES.min(left)) {
            Ok(bytes) => {
                self.bytes += bytes.len() as u64;
                self.contents.members.push(Member { name: name.to_owned(), bytes });
            }
            Err(Unread::Large) if left < LARGEST_FILE_BYTES => self.skip(name, Why::Enough),
            Err(Unread::Large) => self.skip(name, Why::Large),
            Err(Unread::Problem(problem)) => self.skip(name, Why::Problem(problem)),
        }
    }
}

/// Sentences that say shortly what was skipped and why; none where nothing was.
#[must_use]
pub fn skipped_notes(skipped: &[Skipped]) -> Vec<Note> {
    let mut kinds: Vec<(&str, &str, Vec<&str>)> = Vec::new();
    let mut reasons: Vec<(String, Vec<&str>)> = Vec::new();
    for Skipped { name, why } in skipped {
        let reason = match why {
            Why::Kind(one, many) => {
                match kinds.iter_mut().find(|(known, ..)| known == one) {
                    Some((.., names)) => names.push(name),
                    None => kinds.push((one, many, vec![name])),
                }
                continue;
            }
            Why::Large => format!("larger than {} MiB", LARGEST_FILE_BYTES >> 20),
            Why::Link => "a link that does not lead to a file of the submission".to_owned(),
            Why::Deep => format!("folders more than {DEEPEST} deep"),
            Why::Enough => {
                format!("at most {MOST_FILES} files and {} MiB of a submission are read", MOST_BYTES >> 20)
            }
            Why::Problem(problem) => problem.clone(),
        };
        match reasons.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, names)) => names.push(name),
            None => reasons.push((reason, vec![name])),
        }
    }
    let kinds = kinds.into_iter().map(|(one, many, names)| {
        let (count, names_shortly) = (names.len(), shortly(&names));
        format!("{count} {} ({names_shortly})", if count == 1 { one } else { many })
    });
    let kinds: Vec<String> = kinds.collect();
    let kinds = (!kinds.is_empty()).then(|| Note::quiet(format!("Skipped: {}.", kinds.join(", "))));
    let reasons =
        reasons.into_iter().map(|(reason, names)| Note::to_look_at(format!("Skipped {}: {reason}.", shortly(&names))));
    kinds.into_iter().chain(reasons).collect()
}

/// At most four names, and how many more there are.
#[must_use]
pub fn shortly<T: AsRef<str>>(names: &[T]) -> String {
    let first: Vec<&str> = names.iter().take(4).map(AsRef::as_ref).collect();
    match names.len() - first.len() {
        0 => first.join(", "),
        more => format!("{} and {more} more", first.join(", ")),
    }
}
