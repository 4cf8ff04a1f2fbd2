//! The destination of an output, and whether it may be replaced.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use super::StorageError;
use super::place::is_standard;

/// The longest chain of links, as on Linux.
const MOST_LINKS: usize = 40;

/// The destination of an output.
#[derive(Debug)]
pub(super) enum Destination {
    /// A regular file that is replaced, or a free name.
    File {
        /// Its path, all links followed.
        target: PathBuf,
    },
    /// A device, a pipe or an open descriptor, opened for writing.
    Stream(File),
}

/// The destination at a path.
///
/// # Errors
/// [`StorageError`]: a folder, a read-only file, too many links, or the system refuses.
pub(super) fn destination_of(path: &Path) -> Result<Destination, StorageError> {
    if is_standard(path) {
        return Ok(Destination::Stream(standard_output()?));
    }
    let target = followed(path)?;
    if let Some(file) = own_output(&target)? {
        return Ok(Destination::Stream(file));
    }
    match fs::metadata(&target) {
        Ok(metadata) if metadata.is_dir() => Err(io::Error::from(io::ErrorKind::IsADirectory).into()),
        Ok(metadata) if !metadata.is_file() || is_in_proc(&target) => {
            Ok(Destination::Stream(fs::OpenOptions::new().write(true).open(&target)?))
        }
        Ok(metadata) if metadata.permissions().readonly() => Err(StorageError::ReadOnly),
        Ok(_) => Ok(Destination::File { target }),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Destination::File { target }),
        Err(error) => Err(error.into()),
    }
}

/// Whether a path leads to a device or a pipe, which is never replaced; also `-`.
#[must_use]
pub fn is_stream(path: &Path) -> bool {
    if is_standard(path) {
        return true;
    }
    let Ok(target) = followed(path) else { return false };
    fs::metadata(&target).is_ok_and(|metadata| (!metadata.is_file() && !metadata.is_dir()) || is_in_proc(&target))
}

/// Follows symbolic links, also to a target that does not exist. A descriptor's link under `/proc` is not followed: the open file may have
/// no name.
pub(super) fn followed(path: &Path) -> io::Result<PathBuf> {
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        if is_in_proc(&target) {
            return Ok(target);
        }
        match fs::read_link(&target) {
            Ok(link) => target = target.parent().unwrap_or_else(|| Path::new("")).join(link),
            Err(_) => return Ok(target),
        }
    }
    Err(io::Error::other("too many links behind each other"))
}

/// Whether a path is a descriptor of a process, such as `/dev/stdout` after all links.
fn is_in_proc(path: &Path) -> bool {
    (path.starts_with("/proc") || path.starts_with("/dev/fd"))
        && path.parent().is_some_and(|parent| parent.ends_with("fd"))
}

/// This process's standard output or error, if a path leads there. Writing continues at the descriptor's position.
#[cfg(unix)]
fn own_output(target: &Path) -> io::Result<Option<File>> {
    use std::os::fd::AsFd as _;
    Ok(match own_descriptor(target) {
        Some(1) => Some(standard_output()?),
        Some(2) => Some(io::stderr().as_fd().try_clone_to_owned()?.into()),
        _ => None,
    })
}

/// The number of this process's descriptor, if a path with all links followed leads to one.
pub(super) fn own_descriptor(target: &Path) -> Option<u32> {
    let own = format!("/proc/{}/fd", std::process::id());
    let folder = target.parent()?;
    let is_own = [Path::new("/proc/self/fd"), Path::new("/dev/fd"), Path::new(&own)].contains(&folder);
    target.file_name().filter(|_| is_own)?.to_str()?.parse().ok()
}

/// Standard output, written without a buffer.
#[cfg(unix)]
fn standard_output() -> io::Result<File> {
    use std::os::fd::AsFd as _;
    Ok(io::stdout().as_fd().try_clone_to_owned()?.into())
}

/// Standard output, written without a buffer.
#[cfg(windows)]
fn standard_output() -> io::Result<File> {
    use std::os::windows::io::AsHandle as _;
    Ok(io::stdout().as_handle().try_clone_to_owned()?.into())
}

/// Where standard error leads now, also once it is redirected.
#[must_use]
pub fn standard_error() -> Box<dyn io::Write + Send> {
    #[cfg(unix)]
    {
        use std::os::fd::AsFd as _;
        if let Ok(copy) = io::stderr().as_fd().try_clone_to_owned() {
            return Box::new(File::from(copy));
        }
    }
    Box::new(io::stderr())
}

#[cfg(not(unix))]
fn own_output(_: &Path) -> io::Result<Option<File>> {
    Ok(None)
}
