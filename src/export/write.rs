//! Films and folders of frames: drawn on one thread, encoded and written on another.

use std::io::Write;
use std::path::Path;

use super::ExportError;
use super::ffmpeg::Ffmpeg;
use super::pipeline::Drawing;
use crate::film::{Film, FilmError, FilmFormat, Plan, StartStill};
use crate::render::Image;
use crate::storage::{self, Draft, Foreign, StorageError};

/// Receives the path and the bytes of each written picture.
pub type Written<'a> = dyn FnMut(&Path, &[u8]) + Send + 'a;

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
        let path = folder.join(format!("frame-{index:05}.{ending}"));
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
    let failed = |cause| ExportError::Ffmpeg { path: path.to_owned(), cause };
    let foreign = Foreign::new(path).map_err(|cause| unwritten(path, cause))?;
    let mut ffmpeg = Ffmpeg::start(foreign.path()).map_err(failed)?;
    let encoded = encode(path, format, plan, drawing, &mut ffmpeg);
    // If ffmpeg exited early, its error is more useful than the broken pipe.
    if let Err(error @ (ExportError::Cancelled | ExportError::Gpu(_))) = encoded {
        ffmpeg.stop();
        return Err(error);
    }
    ffmpeg.finish().map_err(failed)?;
    encoded?;
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
    let moments = drawing.moments;
    drawing.draw(|index, drawn| {
        let image = drawn.rows().to_image();
        film.push(&image, moments.all[index].start_ms, moments.end_ms(index)).map_err(failed)
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
