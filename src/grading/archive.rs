//! Archives: zip, tar, and either of what gzip packs. The content tells the kind; nothing is unpacked to the disk.

mod zip_names;

use std::collections::BTreeMap;
use std::fmt;
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::sync::Arc;

use tar::EntryType;
use zip::result::ZipError;

use crate::storage::Opened;

/// How many bytes of a file tell its kind.
pub const HEAD_BYTES: usize = 512;
/// The most entries of an archive.
const MOST_ENTRIES: usize = 200_000;

/// What the first bytes of a file say that it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArchiveKind {
    /// A zip.
    Zip,
    /// A tar.
    Tar,
    /// What gzip packed: a tar or one file.
    Gzip,
    /// An archive that is not opened, by its name.
    Other(&'static str),
}

/// First bytes of archives that are not opened.
const OTHERS: [(&[u8], &str); 8] = [
    (b"Rar!\x1a\x07", "RAR"),
    (b"7z\xbc\xaf\x27\x1c", "7z"),
    (b"\xfd7zXZ\0", "xz"),
    (b"BZh", "bzip2"),
    (b"\x28\xb5\x2f\xfd", "Zstandard"),
    (b"MSCF", "CAB"),
    (b"LZIP", "lzip"),
    (b"xar!", "xar"),
];

impl ArchiveKind {
    /// The kind of archive that a file with these first bytes is, if it is one.
    #[must_use]
    pub fn of(head: &[u8]) -> Option<Self> {
        if head.starts_with(b"PK\x03\x04") || head.starts_with(b"PK\x05\x06") {
            return Some(Self::Zip);
        }
        if head.starts_with(b"\x1f\x8b\x08") {
            return Some(Self::Gzip);
        }
        if let Some((_, name)) = OTHERS.iter().find(|(first, _)| head.starts_with(first)) {
            return Some(Self::Other(name));
        }
        is_tar(head).then_some(Self::Tar)
    }

    /// Its name in sentences, with its article.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Zip => "a zip".to_owned(),
            Self::Tar => "a tar".to_owned(),
            Self::Gzip => "a gzip file".to_owned(),
            Self::Other(name) => {
                let article = if name == "RAR" || !name.starts_with(['x']) { "a" } else { "an" };
                format!("{article} {name} archive")
            }
        }
    }
}

/// Whether the first block is a header of a tar: its checksum is right.
fn is_tar(head: &[u8]) -> bool {
    if head.len() < HEAD_BYTES || head[0] == 0 {
        return false;
    }
    let sum: u32 = head[..148].iter().chain(&head[156..HEAD_BYTES]).map(|&byte| u32::from(byte)).sum();
    let digits = std::str::from_utf8(&head[148..156]).unwrap_or_default();
    let written = u32::from_str_radix(digits.trim_matches([' ', '\0']), 8);
    written == Ok(sum + 8 * u32::from(b' '))
}

/// The bytes of an archive. A clone has a position of its own.
#[derive(Clone, Debug)]
pub enum Source {
    /// A file on the disk.
    Disk(Opened),
    /// In memory.
    Memory(Cursor<Arc<[u8]>>),
}

impl Read for Source {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match self {
            Self::Disk(file) => file.read(buffer),
            Self::Memory(bytes) => bytes.read(buffer),
        }
    }
}

impl Seek for Source {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        match self {
            Self::Disk(file) => file.seek(to),
            Self::Memory(bytes) => bytes.seek(to),
        }
    }
}

/// What is kept of a tar, which can be read only from its beginning to its end.
pub struct Keep<'a> {
    /// The largest file of this name that is kept, in bytes; `None` where none is.
    pub largest: &'a dyn Fn(&str) -> Option<u64>,
    /// The most bytes that are kept.
    pub most: u64,
    /// The most bytes that are looked through.
    pub through: u64,
}

/// Why a file was not read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unread {
    /// It is larger than the limit.
    Large,
    /// A sentence without the file's name.
    Problem(String),
}

/// One entry.
#[derive(Clone, Debug)]
pub enum Item {
    /// A folder.
    Folder,
    /// A file of a zip: its place in the directory.
    Packed(usize),
    /// A file that was kept.
    Kept(Arc<[u8]>),
    /// A file of which only the name was kept, and why.
    Left(Unread),
    /// A link to this path in the archive, or out of it.
    Link(Option<String>),
    /// Neither a file nor a folder.
    Special,
}

/// An archive that was opened: its entries by their paths.
pub struct Archive {
    /// Its own name, for sentences.
    pub name: String,
    items: BTreeMap<String, Item>,
    zip: Option<zip::ZipArchive<Source>>,
}

impl fmt::Debug for Archive {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Archive").field("name", &self.name).finish_non_exhaustive()
    }
}

impl Archive {
    /// Lists an archive of a kind.
    ///
    /// # Errors
    /// Why it cannot be opened: a sentence without its name.
    pub fn open(name: &str, kind: ArchiveKind, source: Source, keep: &Keep) -> Result<Self, String> {
        let mut archive = Self { name: name.to_owned(), items: BTreeMap::new(), zip: None };
        match kind {
            ArchiveKind::Zip => archive.list_zip(source)?,
            ArchiveKind::Tar => archive.list_tar(source, keep)?,
            ArchiveKind::Gzip => archive.list_gzip(source, keep)?,
            ArchiveKind::Other(_) => {
                return Err(format!("it is {}, and only zip, tar and tar.gz are opened", kind.name()));
            }
        }
        Ok(archive)
    }

    fn add(&mut self, path: &str, item: Item) -> Result<(), String> {
        // Names are labels: what leads out of the archive is inside it all the same.
        let Some(path) = normalized("", path) else { return Ok(()) };
        for (end, _) in path.match_indices('/') {
            self.items.entry(path[..end].to_owned()).or_insert(Item::Folder);
        }
        self.items.insert(path, item);
        if self.items.len() > MOST_ENTRIES {
            return Err(format!("it has more than {MOST_ENTRIES} entries"));
        }
        Ok(())
    }

    fn list_zip(&mut self, source: Source) -> Result<(), String> {
        let mut zip = zip::ZipArchive::new(source).map_err(|error| zip_sentence(&error))?;
        if zip.len() > MOST_ENTRIES {
            return Err(format!("it has {} entries, and at most {MOST_ENTRIES} are looked at", zip.len()));
        }
        let metadata = zip.metadata();
        let names = (0..metadata.len()).filter_map(|index| metadata.entry(index).ok());
        let are_korean = zip_names::are_korean(names.map(|entry| entry.name_raw().to_vec()));
        for index in 0..metadata.len() {
            let entry = metadata.entry(index).map_err(|error| zip_sentence(&error))?;
            let path = match zip_names::decoded(entry.name_raw(), are_korean) {
                Some(path) => path.into_owned(),
                None => entry.name().map_err(|error| zip_sentence(&error))?.into_owned(),
            };
            let path = path.replace('\\', "/");
            let item = if entry.is_dir() || path.ends_with('/') {
                Item::Folder
            } else if entry.is_symlink() {
                let target = packed(&mut zip, index, 4096).ok().and_then(|bytes| String::from_utf8(bytes).ok());
                Item::Link(target.and_then(|target| linked(&path, &target)))
            } else {
                Item::Packed(index)
            };
            self.add(&path, item)?;
        }
        self.zip = Some(zip);
        Ok(())
    }

    fn list_gzip(&mut self, source: Source, keep: &Keep) -> Result<(), String> {
        let broken = |error: io::Error| format!("what gzip packed is broken or cut off: {error}");
        let mut unpacked = flate2::read::MultiGzDecoder::new(io::BufReader::new(source));
        let mut head = Vec::new();
        unpacked.by_ref().take(HEAD_BYTES as u64).read_to_end(&mut head).map_err(broken)?;
        let is_archive = is_tar(&head) || (head.len() == HEAD_BYTES && head.iter().all(|&byte| byte == 0));
        let mut whole = Cursor::new(head).chain(unpacked);
        if is_archive {
            return self.list_tar(whole, keep);
        }
        let file = self.name.rsplit('/').next().unwrap_or_default();
        let stem = file.len().saturating_sub(3);
        let is_named = file.get(stem..).is_some_and(|ending| ending.eq_ignore_ascii_case(".gz"));
        let path = if is_named && stem > 0 { file[..stem].to_owned() } else { file.to_owned() };
        let largest = (keep.largest)(&path).unwrap_or_default();
        let mut bytes = Vec::new();
        whole.by_ref().take(largest + 1).read_to_end(&mut bytes).map_err(broken)?;
        let is_large = bytes.len() as u64 > largest;
        self.add(&path, if is_large { Item::Left(Unread::Large) } else { Item::Kept(bytes.into()) })
    }

    fn list_tar(&mut self, source: impl Read, keep: &Keep) -> Result<(), String> {
        let broken = |error: io::Error| format!("the tar is broken or cut off: {error}");
        let mut kept = 0;
        let mut left = Counted { source, left: keep.through };
        let mut tar = tar::Archive::new(&mut left);
        for entry in tar.entries().map_err(broken)? {
            let mut entry = match entry {
                Ok(entry) => entry,
                Err(error) if error.to_string().contains(TOO_LONG) => {
                    return Err(format!("it unpacks to more than {} MiB", keep.through >> 20));
                }
                Err(error) => return Err(broken(error)),
            };
            let path = String::from_utf8_lossy(&entry.path_bytes()).into_owned();
            // `tar -c .` puts `./` before every name, which would be a hidden folder.
            let path = normalized("", &path).unwrap_or_default();
            let kind = entry.header().entry_type();
            let target = entry.link_name_bytes().map(|target| String::from_utf8_lossy(&target).into_owned());
            let item = if kind.is_dir() {
                Item::Folder
            } else if kind.is_symlink() {
                Item::Link(target.and_then(|target| linked(&path, &target)))
            } else if kind.is_hard_link() {
                Item::Link(target.and_then(|target| normalized("", &target)))
            } else if !matches!(kind, EntryType::Regular | EntryType::Continuous | EntryType::GNUSparse) {
                // Headers of a whole archive have no entry of their own.
                if kind.is_pax_global_extensions() {
                    continue;
                }
                Item::Special
            } else if (keep.largest)(&path).is_none_or(|largest| entry.size() > largest) {
                Item::Left(Unread::Large)
            } else if kept + entry.size() > keep.most {
                let most = keep.most >> 20;
                Item::Left(Unread::Problem(format!("{most} MiB of {} were read before it", self.name)))
            } else {
                let mut bytes = Vec::new();
                entry.read_to_end(&mut bytes).map_err(broken)?;
                kept += bytes.len() as u64;
                Item::Kept(bytes.into())
            };
            self.add(&path, item)?;
        }
        Ok(())
    }

    /// What is at a path; the archive's own folder at an empty one.
    #[must_use]
    pub fn item(&self, path: &str) -> Option<&Item> {
        if path.is_empty() { Some(&Item::Folder) } else { self.items.get(path) }
    }

    /// The names in a folder, in their order.
    #[must_use]
    pub fn names(&self, folder: &str) -> Vec<&str> {
        let before = if folder.is_empty() { String::new() } else { format!("{folder}/") };
        let below = self.items.range(before.clone()..).map(|(path, _)| path.as_str());
        let names = below.map_while(|path| path.strip_prefix(&before)).filter(|rest| !rest.contains('/'));
        names.collect()
    }

    /// Reads at most `most` bytes of the file at a path, from its beginning.
    ///
    /// # Errors
    /// Why not.
    pub fn read(&self, path: &str, most: u64) -> Result<Vec<u8>, Unread> {
        match self.item(path) {
            Some(Item::Kept(bytes)) => Ok(bytes[..bytes.len().min(most as usize)].to_vec()),
            Some(Item::Left(unread)) => Err(unread.clone()),
            Some(Item::Packed(index)) => {
                let mut zip = self.zip.clone().ok_or_else(|| Unread::Problem("it is not there".to_owned()))?;
                packed(&mut zip, *index, most).map_err(Unread::Problem)
            }
            _ => Err(Unread::Problem("it is no file".to_owned())),
        }
    }
}

fn packed(zip: &mut zip::ZipArchive<Source>, index: usize, most: u64) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let entry = zip.by_index(index).map_err(|error| zip_sentence(&error))?;
    entry.take(most).read_to_end(&mut bytes).map_err(|error| {
        // What is not supported may come to light only here.
        let inner = error.get_ref().and_then(|inner| inner.downcast_ref::<ZipError>());
        inner.map_or_else(|| format!("it is broken: {error}"), zip_sentence)
    })?;
    Ok(bytes)
}

/// What keeps a zip, or a file in it, from being read.
fn zip_sentence(error: &ZipError) -> String {
    match error {
        ZipError::UnsupportedArchive(ZipError::PASSWORD_REQUIRED) => "it needs a password".to_owned(),
        ZipError::CompressionMethodNotSupported(method) => {
            let name = match method {
                6 => "imploded",
                9 => "packed with Deflate64",
                12 => "packed with bzip2",
                14 => "packed with LZMA",
                93 => "packed with Zstandard",
                95 => "packed with xz",
                98 => "packed with PPMd",
                99 => "encrypted with AES",
                _ => return format!("it is packed by method {method}, and only Deflate is unpacked"),
            };
            format!("it is {name}, and only Deflate is unpacked")
        }
        ZipError::UnsupportedArchive(what) => format!("the zip is of a kind that is not read: {what}"),
        _ => "the zip is broken or cut off".to_owned(),
    }
}

/// A path with `.` and `..` taken out, from a folder; `None` where it leads out of the archive or to its own folder.
fn normalized(folder: &str, path: &str) -> Option<String> {
    let mut parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
    for part in path.split('/') {
        match part {
            "" | "." => {}
            ".." => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    (!parts.is_empty()).then(|| parts.join("/"))
}

/// Where a symbolic link at a path leads in the archive; `None` where it leads out.
fn linked(path: &str, target: &str) -> Option<String> {
    let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
    let depth = folder.split('/').filter(|part| !part.is_empty()).count();
    let mut level = depth as i64;
    for part in target.split('/') {
        level += match part {
            "" | "." => 0,
            ".." => -1,
            _ => 1,
        };
        if level < 0 {
            return None;
        }
    }
    if target.starts_with('/') { None } else { normalized(folder, target) }
}

const TOO_LONG: &str = "more than is looked through";

/// A stream that ends with an error after so many bytes.
struct Counted<R> {
    source: R,
    left: u64,
}

impl<R: Read> Read for Counted<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.source.read(buffer)?;
        self.left = self.left.checked_sub(read as u64).ok_or_else(|| io::Error::other(TOO_LONG))?;
        Ok(read)
    }
}

#[cfg(test)]
mod tests;
