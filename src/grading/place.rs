//! Where files of submissions are: on the disk or in an archive.

use std::io::{Cursor, Read as _};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use super::archive::{Archive, ArchiveKind, HEAD_BYTES, Item, Keep, Source, Unread};
use crate::storage::{self, EntryKind, StorageError};

/// The largest archive inside another one, packed: 128 MiB. Archives on the disk may have any size.
const LARGEST_INNER_BYTES: u64 = 128 << 20;

/// A file or folder on the disk, in memory or in an archive.
#[derive(Clone, Debug)]
pub enum Place {
    /// On the disk.
    Disk(PathBuf),
    /// In memory, as what came from standard input.
    Memory(Arc<[u8]>),
    /// In an archive, at a path; the archive's own folder at an empty one.
    Packed(Arc<Archive>, String),
}

/// What stands in a folder.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Its own name.
    pub name: String,
    /// What it is; links are not followed.
    pub kind: EntryKind,
    /// Where it is.
    pub place: Place,
}

/// A storage error as the reason why a file was not read.
fn unread(error: StorageError) -> Unread {
    match error {
        StorageError::TooLarge { .. } => Unread::Large,
        error => Unread::Problem(error.to_string()),
    }
}

impl Place {
    /// The path, if it is on the disk.
    #[must_use]
    pub fn path(&self) -> Option<&Path> {
        if let Self::Disk(path) = self { Some(path) } else { None }
    }

    /// The first `most` entries, in the order of their names, and a lower bound of their number.
    ///
    /// # Errors
    /// Why the folder cannot be read: a sentence.
    pub fn list(&self, most: usize) -> Result<(Vec<Entry>, usize), String> {
        match self {
            Self::Disk(path) => {
                let (entries, count) = storage::list(path, most).map_err(|error| error.to_string())?;
                let entry =
                    |entry: storage::Entry| Entry { name: entry.name, kind: entry.kind, place: Self::Disk(entry.path) };
                Ok((entries.into_iter().map(entry).collect(), count))
            }
            Self::Memory(_) => Ok((Vec::new(), 0)),
            Self::Packed(archive, folder) => {
                let mut names = archive.names(folder);
                names.sort_unstable();
                let count = names.len();
                let entry = |name: &str| {
                    let path = if folder.is_empty() { name.to_owned() } else { format!("{folder}/{name}") };
                    let kind = match archive.item(&path) {
                        Some(Item::Folder) => EntryKind::Folder,
                        Some(Item::Link(_)) => EntryKind::Link,
                        Some(Item::Special) | None => EntryKind::Other,
                        Some(Item::Packed(_) | Item::Kept(_) | Item::Left(_)) => EntryKind::File,
                    };
                    Entry { name: name.to_owned(), kind, place: Self::Packed(archive.clone(), path) }
                };
                Ok((names.into_iter().take(most).map(entry).collect(), count))
            }
        }
    }

    /// Reads a file of at most `limit` bytes.
    ///
    /// # Errors
    /// Why not.
    pub fn read(&self, limit: u64) -> Result<Vec<u8>, Unread> {
        match self {
            Self::Disk(path) => storage::read(path, limit).map_err(unread),
            Self::Memory(bytes) if bytes.len() as u64 > limit => Err(Unread::Large),
            Self::Memory(bytes) => Ok(bytes.to_vec()),
            Self::Packed(archive, path) => {
                let bytes = archive.read(path, limit + 1)?;
                if bytes.len() as u64 > limit { Err(Unread::Large) } else { Ok(bytes) }
            }
        }
    }

    /// The first bytes of a file, at most `most`.
    ///
    /// # Errors
    /// Why they cannot be read.
    pub fn start(&self, most: u64) -> Result<Vec<u8>, Unread> {
        match self {
            Self::Disk(path) => {
                let mut start = Vec::new();
                let file = storage::open(path).map_err(unread)?;
                file.take(most).read_to_end(&mut start).map_err(|error| unread(error.into()))?;
                Ok(start)
            }
            Self::Memory(bytes) => Ok(bytes[..bytes.len().min(usize::try_from(most).unwrap_or(usize::MAX))].to_vec()),
            Self::Packed(archive, path) => archive.read(path, most),
        }
    }

    /// Opens the archive that stands here, as which it is called `name`; `None` if it is no archive.
    ///
    /// # Errors
    /// Why it cannot be opened.
    pub fn archive(&self, name: &str, keep: &Keep) -> Result<Option<Arc<Archive>>, Unread> {
        let Some(kind) = ArchiveKind::of(&self.start(HEAD_BYTES as u64)?) else { return Ok(None) };
        let source = match self {
            _ if matches!(kind, ArchiveKind::Other(_)) => Source::Memory(Cursor::new([].into())),
            Self::Disk(path) => Source::Disk(storage::open(path).map_err(unread)?),
            Self::Memory(bytes) => Source::Memory(Cursor::new(bytes.clone())),
            Self::Packed(..) => match self.read(LARGEST_INNER_BYTES) {
                Ok(bytes) => Source::Memory(Cursor::new(bytes.into())),
                Err(Unread::Large) => {
                    let limit = LARGEST_INNER_BYTES >> 20;
                    return Err(Unread::Problem(format!("an archive in an archive is opened up to {limit} MiB")));
                }
                Err(problem) => return Err(problem),
            },
        };
        Archive::open(name, kind, source, keep).map(|archive| Some(Arc::new(archive))).map_err(Unread::Problem)
    }

    /// The file that a link leads to, if that is a file inside the folder `root`.
    #[must_use]
    pub fn followed(&self, root: &Self) -> Option<Self> {
        match (self, root) {
            (Self::Disk(path), Self::Disk(root)) => {
                let path = storage::inside(path, root)?;
                (storage::kind(&path).ok()? == EntryKind::File).then_some(Self::Disk(path))
            }
            (Self::Packed(archive, path), Self::Packed(_, root)) => {
                let Some(Item::Link(Some(target))) = archive.item(path) else { return None };
                let is_inside = root.is_empty() || target.strip_prefix(root).is_some_and(|rest| rest.starts_with('/'));
                let is_file = matches!(archive.item(target)?, Item::Packed(_) | Item::Kept(_));
                (is_inside && is_file).then(|| Self::Packed(archive.clone(), target.clone()))
            }
            _ => None,
        }
    }

    /// The names of the folders and archives that it stands in, the nearest first.
    #[must_use]
    pub fn folders(&self) -> Vec<String> {
        let of_disk = |path: &Path| {
            let path = storage::resolved(path);
            let parts = path.components().rev().skip(1).filter_map(|part| match part {
                Component::Normal(name) => Some(name.to_string_lossy().into_owned()),
                _ => None,
            });
            parts.collect::<Vec<_>>()
        };
        match self {
            Self::Disk(path) => of_disk(path),
            Self::Memory(_) => Vec::new(),
            Self::Packed(archive, path) => {
                let inside = path.rsplit('/').skip(1).map(str::to_owned);
                inside.chain([archive.name.clone()]).collect()
            }
        }
    }
}
