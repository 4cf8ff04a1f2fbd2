//! Films and folders of frames: drawn on one thread, encoded and written on another.

use std::io::Write;
use std::path::Path;

use super::ExportError;
use super::ffmpeg::{Ffmpeg, FfmpegError};
use super::pipeline::Drawing;
use crate::film::{Film, FilmError, FilmFormat, Plan, StartStill};
use crate::render::Image;
use crate::storage::{self, Draft, Foreign, StorageError};

/// Receives the path and the bytes of each written picture.
pub type Written<'a> = dyn FnMut(&Path, &[u8]) + Send + 'a;

/// The name of a numbered picture.
fn frame_name(index: usize, ending: &str) -> String {
    format!("frame-{index:05}.{ending}")
}

/// The index of a numbered picture; `None` where a name is not of that form.
fn frame_index(name: &str, ending: &str) -> Option<usize> {
    let index = name.strip_prefix("frame-")?.strip_suffix(ending)?.strip_suffix('.')?.parse().ok()?;
    (frame_name(index, ending) == name).then_some(index)
}

/// Whether a numbered picture of a folder can have this name.
#[must_use]
pub fn is_frame_name(name: &str, ending: &str) -> bool {
    frame_index(name, ending).is_some()
}

/// Sees to it that a folder will hold no picture of an earlier, longer film beside the `count` of this one: an encoder would take them
/// for its end. Other files stay.
///
/// # Errors
/// [`ExportError::Stale`] where there are such pictures and they are not to be removed; [`ExportError::Unwritten`].
pub fn clear_folder(folder: &Path, ending: &str, count: usize, removes: bool) -> Result<(), ExportError> {
    if !storage::is_folder(folder) {
        return Ok(());
    }
    let (entries, _) = storage::list(folder, usize::MAX / 8).map_err(|cause| unwritten(folder, cause))?;
    let is_stale = |name: &str| frame_index(name, ending).is_some_and(|index| index >= count);
    let stale: Vec<_> = entries.into_iter().filter(|entry| is_stale(&entry.name)).collect();
    let (Some(first), Some(last)) = (stale.first(), stale.last()) else { return Ok(()) };
    if !removes {
        let [first, last] = [first, last].map(|entry| entry.name.clone());
        return Err(ExportError::Stale { folder: folder.to_owned(), count: stale.len(), first, last });
    }
    stale.iter().try_for_each(|entry| storage::remove(&entry.path).map_err(|cause| unwritten(&entry.path, cause)))
}

/// Writes `frame-00000` and so on with an ending into a folder, which is created if it is missing. Calls `written` for each.
///
/// # Errors
/// [`ExportError`]; the frames written so far stay; each is complete.
pub fn write_folder(
    folder: &Path,
    ending: &str,
    start: StartStill,
    drawing: &mut Drawing<'_>,
    written: &mut Written<'_>,
) -> Result<(), ExportError> {
    storage::create_folder(folder).map_err(|cause| unwritten(folder, cause))?;
    let mut encoder = start(None);
    drawing.draw(|index, drawn| {
        let path = folder.join(frame_name(index, ending));
        encoder.encode(&drawn.rows())?;
        drop(drawn);
        storage::write_unsynced(&path, encoder.bytes()).map_err(|cause| unwritten(&path, cause))?;
        written(&path, encoder.bytes());
        Ok(())
    })
}

/// Writes a film into a draft and replaces the destination when it is complete.
///
/// # Errors
/// [`ExportError`]; the destination is then unchanged.
pub fn write_film(path: &Path, format: FilmFormat, plan: Plan, drawing: &mut Drawing<'_>) -> Result<(), ExportError> {
    let mut draft = Draft::new(path).map_err(|cause| unwritten(path, cause))?;
    encode(path, format, plan, drawing, &mut draft)?;
    draft.commit().map_err(|cause| unwritten(path, cause))
}

/// Like [`write_film`], through the user's ffmpeg.
///
/// # Errors
/// [`ExportError`]; the destination is then unchanged.
pub fn write_through_ffmpeg(
    path: &Path,
    format: FilmFormat,
    plan: Plan,
    drawing: &mut Drawing<'_>,
) -> Result<(), ExportError> {
    let failed = |cause| match cause {
        FfmpegError::Cancelled => ExportError::Cancelled,
        cause => ExportError::Ffmpeg { path: path.to_owned(), cause },
    };
    let foreign = Foreign::new(path).map_err(|cause| unwritten(path, cause))?;
    let mut ffmpeg = Ffmpeg::start(foreign.path()).map_err(failed)?;
    let Drawing { stage, moments, painter, watch } = drawing;
    let kill = ffmpeg.killer();
    let count = moments.all.len();
    // The thread that feeds ffmpeg may wait for it.
    let mut watch = |done: usize, count: usize| {
        let goes_on = watch(done, count);
        if !goes_on {
            kill();
        }
        goes_on
    };
    let mut drawing = Drawing { stage, moments, painter, watch: &mut watch };
    let encoded = encode(path, format, plan, &mut drawing, &mut ffmpeg);
    let goes_on = || watch(count, count);
    match encoded {
        Ok(()) => ffmpeg.finish(goes_on).map_err(failed)?,
        // If ffmpeg exited, its error is more useful than the broken pipe.
        Err(ExportError::Film { .. }) => return Err(failed(ffmpeg.stopped_reading(goes_on))),
        Err(error) => return Err(error),
    }
    drop(ffmpeg);
    foreign.commit().map_err(|cause| unwritten(path, cause))
}

fn encode(
    path: &Path,
    format: FilmFormat,
    plan: Plan,
    drawing: &mut Drawing<'_>,
    output: &mut (dyn Write + Send),
) -> Result<(), ExportError> {
    let failed = |cause: FilmError| ExportError::Film { path: path.to_owned(), cause };
    let samples = samples(drawing, format.sample_frames)?;
    let mut film = Film::new(format, plan, &samples, output).map_err(failed)?;
    drop(samples);
    let start_ms = |index: usize| index as f64 * 1000.0 / f64::from(plan.frames_per_second);
    drawing.draw(|index, drawn| {
        let image = drawn.rows().to_image();
        film.push(&image, start_ms(index), start_ms(index + 1)).map_err(failed)
    })?;
    film.finish().map_err(failed)
}

/// A few frames, evenly spread over the film, and the last one; none if `count` is 0.
fn samples(drawing: &mut Drawing<'_>, count: usize) -> Result<Vec<Image>, ExportError> {
    if count == 0 {
        return Ok(Vec::new());
    }
    let Drawing { stage, moments, painter, .. } = drawing;
    let step = moments.all.len().div_ceil(count).max(1);
    let spread = moments.all.iter().skip(step / 2).step_by(step).chain(moments.all.last());
    spread.map(|moment| Ok(painter.image(&stage.frame(moment)?)?)).collect()
}

pub(super) fn unwritten(path: &Path, cause: StorageError) -> ExportError {
    ExportError::Unwritten { path: path.to_owned(), cause }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_names_of_the_form_are_frames() {
        assert_eq!(frame_index(&frame_name(7, "png"), "png"), Some(7));
        assert_eq!(frame_index(&frame_name(123_456, "webp"), "webp"), Some(123_456));
        for other in
            ["frame-7.png", "frame-00007.webp", "frame-00007png", "frame-.png", "my-frame-00007.png", "frame-+0007.png"]
        {
            assert_eq!(frame_index(other, "png"), None, "{other}");
        }
    }
}
