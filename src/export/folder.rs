//! Numbered pictures in a folder: their names, and which of them are there.

use std::path::{Path, PathBuf};

use super::write::unwritten;
use super::{ExportError, Size};
use crate::film::StillFormat;
use crate::parallel::map_in_order;
use crate::picture::Image;
use crate::storage;

/// The largest picture that is read: 1 GiB.
const LARGEST_BYTES: u64 = 1 << 30;

/// The name of a numbered picture.
pub fn frame_name(number: usize, ending: &str) -> String {
    format!("frame-{number:05}.{ending}")
}

/// The number of a picture; `None` where a name is not of that form.
fn frame_number(name: &str, ending: &str) -> Option<usize> {
    let number = name.strip_prefix("frame-")?.strip_suffix(ending)?.strip_suffix('.')?.parse().ok()?;
    (frame_name(number, ending) == name).then_some(number)
}

/// Whether a numbered picture of a folder can have this name.
#[must_use]
pub fn is_frame_name(name: &str, ending: &str) -> bool {
    frame_number(name, ending).is_some()
}

/// The numbered pictures in a folder, by their numbers.
///
/// # Errors
/// [`ExportError::Unread`]: the folder cannot be listed.
pub fn frames_in(folder: &Path, ending: &str) -> Result<Vec<(usize, PathBuf)>, ExportError> {
    let unread = |cause| ExportError::Unread { path: folder.to_owned(), cause };
    let (entries, _) = storage::list(folder, usize::MAX / 8).map_err(unread)?;
    let numbered = |entry: storage::Entry| Some((frame_number(&entry.name, ending)?, entry.path));
    let mut frames: Vec<_> = entries.into_iter().filter_map(numbered).collect();
    frames.sort_unstable();
    Ok(frames)
}

/// Sees to it that a folder will hold no picture of an earlier, longer film beside the `count` of this one: an encoder would take them
/// for its end. Other files stay.
///
/// # Errors
/// [`ExportError::Stale`] where there are such pictures and they are not to be removed; [`ExportError::Unread`],
/// [`ExportError::Unwritten`].
pub fn clear_folder(folder: &Path, ending: &str, count: usize, removes: bool) -> Result<(), ExportError> {
    if !storage::is_folder(folder) {
        return Ok(());
    }
    let frames = frames_in(folder, ending)?;
    let stale = &frames[frames.partition_point(|&(number, _)| number < count)..];
    let (Some(first), Some(last)) = (stale.first(), stale.last()) else { return Ok(()) };
    if !removes {
        let [first, last] = [first, last].map(|&(number, _)| frame_name(number, ending));
        return Err(ExportError::Stale { folder: folder.to_owned(), count: stale.len(), first, last });
    }
    stale.iter().try_for_each(|(_, path)| storage::remove(path).map_err(|cause| unwritten(path, cause)))
}

/// Reads a picture; `None` if it is missing, or not whole.
pub fn read_frame(path: &Path, format: StillFormat) -> Option<Image> {
    (format.decode)(&storage::read(path, LARGEST_BYTES).ok()?)
}

/// Of these numbers, those whose pictures are missing in a folder, not whole, or of another size.
pub fn missing_frames(folder: &Path, ending: &str, format: StillFormat, size: Size, numbers: &[usize]) -> Vec<usize> {
    let is_there = map_in_order(numbers, |&number| {
        read_frame(&folder.join(frame_name(number, ending)), format)
            .is_some_and(|image| (image.width, image.height) == (size.width, size.height))
    });
    numbers.iter().zip(is_there).filter(|&(_, is_there)| !is_there).map(|(&number, _)| number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_names_of_the_form_are_frames() {
        assert_eq!(frame_number(&frame_name(7, "png"), "png"), Some(7));
        assert_eq!(frame_number(&frame_name(123_456, "webp"), "webp"), Some(123_456));
        for other in
            ["frame-7.png", "frame-00007.webp", "frame-00007png", "frame-.png", "my-frame-00007.png", "frame-+0007.png"]
        {
            assert_eq!(frame_number(other, "png"), None, "{other}");
        }
    }
}
