//! Submissions: finding them, and reading the files of one, within bounds.

use std::io::{Cursor, Read as _};
use std::path::{Path, PathBuf};

use zip::result::ZipError;

use crate::files::FileError;
use crate::storage::{self, EntryKind};

/// The most submissions at a time.
const MOST_SUBMISSIONS: usize = 20_000;
/// The most files of one submission.
const MOST_FILES: usize = 200;
/// The largest file of a submission, unpacked, and the largest zip, packed: 16 MiB.
const LARGEST_FILE_BYTES: u64 = 16 << 20;
/// The most bytes of a submission, unpacked: 64 MiB.
const MOST_BYTES: u64 = 64 << 20;
/// The maximum depth of folders in a submission.
const DEEPEST: usize = 8;

/// One student's entry, not yet read.
#[derive(Clone, Debug)]
pub struct Submission {
    /// Its name in the results; no two are the same.
    pub name: String,
    path: PathBuf,
    /// The folder that the submission was found in, if one was given: its links must not lead out of that.
    root: Option<PathBuf>,
}

/// A file of a submission.
#[derive(Clone, Debug)]
pub struct Member {
    /// Its path in the submission.
    pub name: String,
    /// What it holds.
    pub bytes: Vec<u8>,
}

/// Finds the submissions: each file or zip that is named, and each entry of each folder that is named. They are in the order of the
/// arguments, entries of a folder by name; names that begin with a dot are ignored.
///
/// # Errors
/// [`FileError`]: something that is named is not there, or there are too many.
pub fn find(arguments: &[PathBuf]) -> Result<Vec<Submission>, FileError> {
    let mut found: Vec<Submission> = Vec::new();
    for path in arguments {
        let bad = |error| FileError::storage(path.display(), error);
        if storage::is_standard(path) {
            found.push(Submission { name: storage::input_name(path), path: path.clone(), root: None });
            continue;
        }
        // Follow a link that the user named.
        if storage::list(path, 0).is_err() {
            storage::kind(path).map_err(bad)?;
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            found.push(Submission { name, path: path.clone(), root: None });
            continue;
        }
        let (entries, count) = storage::list(path, MOST_SUBMISSIONS).map_err(bad)?;
        if count > entries.len() {
            return Err(FileError::new(path.display(), format!("more than {MOST_SUBMISSIONS} submissions")));
        }
        let entries = entries.into_iter().filter(|entry| !entry.name.starts_with('.'));
        found.extend(entries.map(|entry| Submission { name: entry.name, path: entry.path, root: Some(path.clone()) }));
    }
    if found.len() > MOST_SUBMISSIONS {
        return Err(FileError::new("submissions", format!("more than {MOST_SUBMISSIONS}")));
    }
    let mut names = std::collections::HashSet::new();
    for submission in &mut found {
        let name = submission.name.clone();
        for number in 2.. {
            if names.insert(submission.name.clone()) {
                break;
            }
            submission.name = format!("{name} ({number})");
        }
    }
    Ok(found)
}

/// The files of a submission that is one file: what is packed in a zip, or the file itself. In the order of their names.
///
/// # Errors
/// Why there are none: a sentence, with the bound that was hit.
pub fn unpacked(name: &str, bytes: Vec<u8>) -> Result<Vec<Member>, String> {
    let mut files = Files::default();
    files.put(name, bytes)?;
    Ok(files.sorted())
}

impl Submission {
    /// Where it is: a file, a folder, or `-` for standard input.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Reads the files, in the order of their names.
    ///
    /// # Errors
    /// Why not: a sentence, with the bound that was hit.
    pub fn read(&self) -> Result<Vec<Member>, String> {
        let mut files = Files::default();
        if storage::is_standard(&self.path) {
            let bytes = storage::read(&self.path, LARGEST_FILE_BYTES).map_err(|error| error.to_string())?;
            return unpacked(&self.name, bytes);
        }
        let path = match (storage::kind(&self.path).map_err(|error| error.to_string())?, &self.root) {
            (EntryKind::Link, Some(root)) => storage::inside(&self.path, root)
                .ok_or_else(|| "it is a link out of the folder, which is not followed".to_owned())?,
            _ => self.path.clone(),
        };
        match storage::list(&path, 0) {
            Ok(_) => files.walk(&path, "", 0)?,
            Err(_) if storage::kind(&path).is_ok_and(|kind| kind == EntryKind::Other) => {
                return Err("it is neither a file nor a folder".to_owned());
            }
            Err(_) => {
                let bytes = storage::read(&path, LARGEST_FILE_BYTES).map_err(|error| error.to_string())?;
                files.put(&self.name, bytes)?;
            }
        }
        Ok(files.sorted())
    }
}

#[derive(Default)]
struct Files {
    members: Vec<Member>,
    bytes: u64,
}

impl Files {
    /// The files in the order of their names.
    fn sorted(mut self) -> Vec<Member> {
        self.members.sort_by(|a, b| a.name.cmp(&b.name));
        self.members
    }

    /// Adds the file of a submission that is one file: what is packed in it, or itself.
    fn put(&mut self, name: &str, bytes: Vec<u8>) -> Result<(), String> {
        if bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06") {
            self.unpack(bytes)
        } else {
            self.add(name.to_owned(), bytes)
        }
    }

    fn add(&mut self, name: String, bytes: Vec<u8>) -> Result<(), String> {
        self.bytes += bytes.len() as u64;
        if self.bytes > MOST_BYTES {
            return Err(format!("more than {} MiB in all, which is the bound for a submission", MOST_BYTES >> 20));
        }
        if self.members.len() == MOST_FILES {
            return Err(format!("more than {MOST_FILES} files, which is the bound for a submission"));
        }
        self.members.push(Member { name, bytes });
        Ok(())
    }

    fn walk(&mut self, folder: &Path, above: &str, depth: usize) -> Result<(), String> {
        if depth > DEEPEST {
            return Err(format!("{above}: folders more than {DEEPEST} deep, which is the bound for a submission"));
        }
        let (entries, count) = storage::list(folder, MOST_FILES).map_err(|error| format!("{above}{error}"))?;
        if count > entries.len() {
            return Err(format!("more than {MOST_FILES} files, which is the bound for a submission"));
        }
        // Skip links: files inside the submission are read anyway, and others must not be.
        for entry in entries.into_iter().filter(|entry| !entry.name.starts_with('.')) {
            let name = format!("{above}{}", entry.name);
            match entry.kind {
                EntryKind::Folder => self.walk(&entry.path, &format!("{name}/"), depth + 1)?,
                EntryKind::File => {
                    let bytes =
                        storage::read(&entry.path, LARGEST_FILE_BYTES).map_err(|error| format!("{name}: {error}"))?;
                    self.add(name, bytes)?;
                }
                EntryKind::Link | EntryKind::Other => {}
            }
        }
        Ok(())
    }

    fn unpack(&mut self, bytes: Vec<u8>) -> Result<(), String> {
        let broken = |error: ZipError| {
            let is_locked = matches!(error, ZipError::InvalidPassword)
                || matches!(error, ZipError::UnsupportedArchive(ZipError::PASSWORD_REQUIRED));
            match error {
                _ if is_locked => "the zip needs a password".to_owned(),
                ZipError::UnsupportedArchive(_) | ZipError::CompressionMethodNotSupported(_) => {
                    "the zip is packed in a way that is not read: make it with deflate, as every program can".to_owned()
                }
                _ => "the zip is broken or cut off".to_owned(),
            }
        };
        let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).map_err(broken)?;
        if archive.len() > 4 * MOST_FILES {
            return Err(format!("the zip has {} entries, and at most {} are looked at", archive.len(), 4 * MOST_FILES));
        }
        for index in 0..archive.len() {
            let entry = archive.by_index(index).map_err(broken)?;
            let name = entry.name().map_err(broken)?.into_owned();
            let is_plain = |part: &str| !part.starts_with('.') || part == "." || part == "..";
            // Names are used as labels only: nothing is unpacked to the disk.
            let is_hidden = name.split('/').any(|part| !is_plain(part) || part == "__MACOSX");
            if entry.is_dir() || entry.is_symlink() || is_hidden {
                continue;
            }
            let left = LARGEST_FILE_BYTES.min(MOST_BYTES.saturating_sub(self.bytes));
            let mut bytes = Vec::new();
            entry.take(left + 1).read_to_end(&mut bytes).map_err(|_| format!("{name} in the zip: it is damaged"))?;
            if bytes.len() as u64 > left {
                let (file, all) = (LARGEST_FILE_BYTES >> 20, MOST_BYTES >> 20);
                return Err(format!(
                    "{name} in the zip: it unpacks to more than the bounds for a submission, {file} MiB a file and {all} MiB in all"
                ));
            }
            self.add(name, bytes)?;
        }
        Ok(())
    }
}
