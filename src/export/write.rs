//! Films and folders of frames: drawn on one thread, encoded and written on another.

use std::io::Write;
use std::path::Path;

use super::ffmpeg::Ffmpeg;
use super::pipeline::Drawing;
use super::{ExportError, Target};
use crate::film::{Film, FilmError, Format, Palette, Plan};
use crate::render::PngRoom;
use crate::storage::{self, Draft, Foreign};

/// Frames that stand for a film when its palette is chosen.
const PALETTE_FRAMES: usize = 6;

/// Writes frame-00000.png and on into a folder, which is made where it is missing, and tells `note` of each.
///
/// # Errors
/// [`ExportError`]; frames that are written stay, each of them whole.
pub fn write_folder(
    folder: &Path,
    drawing: &mut Drawing<'_>,
    note: &mut (dyn FnMut(&Path, &[u8]) + Send),
) -> Result<(), ExportError> {
    storage::create_folder(folder).map_err(|reason| ExportError::unwritten(folder, reason))?;
    let mut room = PngRoom::default();
    drawing.draw(|place, drawn| {
        let path = folder.join(format!("frame-{place:05}.png"));
        let png = drawn.rows().to_png_in(&mut room)?;
        drop(drawn);
        storage::write_unsynced(&path, png).map_err(|reason| ExportError::unwritten(&path, reason))?;
        note(&path, png);
        Ok(())
    })
}

/// Writes a film beside its place and puts it there when it is whole.
///
/// # Errors
/// [`ExportError`]; what stood there before is as it was.
pub fn write_film(path: &Path, target: Target, plan: Plan, drawing: &mut Drawing<'_>) -> Result<(), ExportError> {
    let unwritten = |reason| ExportError::unwritten(path, reason);
    let Target::Film(format) = target else {
        let foreign = Foreign::new(path).map_err(unwritten)?;
        let mut ffmpeg = Ffmpeg::start(path, foreign.path())?;
        let written = encode(path, Format::Y4m, plan, drawing, &mut ffmpeg);
        // Where ffmpeg has ended early, what it says matters more than that it takes no more pictures.
        if let Err(error @ (ExportError::Cancelled | ExportError::Gpu(_))) = written {
            ffmpeg.stop();
            return Err(error);
        }
        ffmpeg.finish(path)?;
        written?;
        return foreign.commit().map_err(unwritten);
    };
    let mut draft = Draft::new(path).map_err(unwritten)?;
    encode(path, format, plan, drawing, &mut draft)?;
    draft.commit().map_err(unwritten)
}

fn encode(
    path: &Path,
    format: Format,
    plan: Plan,
    drawing: &mut Drawing<'_>,
    output: &mut (dyn Write + Send),
) -> Result<(), ExportError> {
    let failed = |reason: FilmError| ExportError::Film { path: path.to_owned(), reason };
    let palette = if format == Format::Gif { palette(drawing)? } else { Palette::of(&[]) };
    let mut film = Film::new(format, plan, palette, output).map_err(failed)?;
    let moments = drawing.moments;
    drawing.draw(|place, drawn| {
        let image = drawn.rows().to_image();
        film.push(&image, moments.all[place].start_ms, moments.end_ms(place)).map_err(failed)
    })?;
    film.finish().map_err(failed)
}

/// The palette of a few frames, evenly spread over the film.
fn palette(drawing: &mut Drawing<'_>) -> Result<Palette, ExportError> {
    let Drawing { stage, moments, painter, .. } = drawing;
    let step = moments.all.len().div_ceil(PALETTE_FRAMES).max(1);
    let pictures: Result<Vec<_>, ExportError> = moments
        .all
        .iter()
        .skip(step / 2)
        .step_by(step)
        .chain(moments.all.last())
        .map(|moment| Ok(painter.image(&stage.frame(moment)?)?))
        .collect();
    Ok(Palette::of(&pictures?))
}
