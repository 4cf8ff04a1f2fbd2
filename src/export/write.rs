//! Films and folders of frames: drawn on one thread, encoded and written on another.

use std::io::Write;
use std::path::Path;

use super::ffmpeg::{Ffmpeg, FfmpegError};
use super::folder::frame_name;
use super::{Drawing, ExportError, Pictures, Watch};
use crate::film::{Film, FilmError, FilmFormat, Plan, StartStill};
use crate::storage::{self, Draft, Foreign, StorageError};

/// Receives the path and the bytes of each written picture.
pub type Written<'a> = dyn FnMut(&Path, &[u8]) + Send + 'a;

/// Writes a picture for each moment into a folder, which is created if it is missing: `frame-00000` and so on, with an ending. The names
/// have the moments' numbers in the film. Calls `written` for each.
///
/// # Errors
/// [`ExportError`]; the frames written so far stay; each is complete.
pub fn write_folder(
    folder: &Path,
    ending: &str,
    start: StartStill,
    drawing: &mut Drawing<'_>,
    watch: &mut Watch<'_>,
    written: &mut Written<'_>,
) -> Result<(), ExportError> {
    storage::create_folder(folder).map_err(|cause| unwritten(folder, cause))?;
    let mut encoder = start(None);
    let moments = drawing.moments;
    drawing.draw(watch, |place, drawn| {
        let path = folder.join(frame_name(moments.all[place].number, ending));
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
pub fn write_film(
    path: &Path,
    format: FilmFormat,
    plan: Plan,
    pictures: &mut dyn Pictures,
    watch: &mut Watch<'_>,
) -> Result<(), ExportError> {
    let mut draft = Draft::new(path).map_err(|cause| unwritten(path, cause))?;
    encode(path, format, plan, pictures, watch, &mut draft)?;
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
    pictures: &mut dyn Pictures,
    watch: &mut Watch<'_>,
) -> Result<(), ExportError> {
    let failed = |cause| match cause {
        FfmpegError::Cancelled => ExportError::Cancelled,
        cause => ExportError::Ffmpeg { path: path.to_owned(), cause },
    };
    let foreign = Foreign::new(path).map_err(|cause| unwritten(path, cause))?;
    let mut ffmpeg = Ffmpeg::start(foreign.path()).map_err(failed)?;
    let kill = ffmpeg.killer();
    let count = pictures.count();
    // The thread that feeds ffmpeg may wait for it.
    let mut watching = |done: usize, count: usize| {
        let goes_on = watch(done, count);
        if !goes_on {
            kill();
        }
        goes_on
    };
    let encoded = encode(path, format, plan, pictures, &mut watching, &mut ffmpeg);
    let goes_on = || watching(count, count);
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
    pictures: &mut dyn Pictures,
    watch: &mut Watch<'_>,
    output: &mut (dyn Write + Send),
) -> Result<(), ExportError> {
    let failed = |cause: FilmError| ExportError::Film { path: path.to_owned(), cause };
    let samples = pictures.ahead(&samples(pictures.count(), format.sample_frames))?;
    let mut film = Film::new(format, plan, &samples, output).map_err(failed)?;
    drop(samples);
    let start_ms = |index: usize| index as f64 * 1000.0 / f64::from(plan.frames_per_second);
    pictures
        .each(watch, &mut |index, image| film.push(&image, start_ms(index), start_ms(index + 1)).map_err(failed))?;
    film.finish().map_err(failed)
}

/// The places of a few of `frames` pictures, evenly spread, and of the last one; none if `count` is 0.
fn samples(frames: usize, count: usize) -> Vec<usize> {
    if count == 0 {
        return Vec::new();
    }
    let step = frames.div_ceil(count).max(1);
    (step / 2..frames).step_by(step).chain(frames.checked_sub(1)).collect()
}

pub(super) fn unwritten(path: &Path, cause: StorageError) -> ExportError {
    ExportError::Unwritten { path: path.to_owned(), cause }
}
