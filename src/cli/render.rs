//! `inbetween render`: images and films with no window.

mod identities;
mod manifest;
mod target;

use std::mem;
use std::path::Path;

use super::arguments::RenderArguments;
use super::interrupt::Interrupt;
use super::progress::Progress;
use super::{CliError, misuse, scene};
use crate::editor::ExportFormat;
use crate::export::{
    Animation, Drawing, Moment, Moments, Painter, Size, Source, Stage, Target, View, find_ffmpeg, write_film,
    write_folder,
};
use crate::film::{Cell, Grid, contact_sheet};
use crate::render::{Background, Image};
use crate::storage;
use manifest::Manifest;

/// The size of images and films where none is named.
pub const DEFAULT_SIZE: Size = Size { width: 640, height: 480 };
/// The size of a contact sheet's images where none is named.
const SHEET_SIZE: Size = Size { width: 320, height: 240 };

/// Renders what the arguments say. The GPU adapter is acquired before any file is read.
///
/// # Errors
/// [`CliError`]
pub fn run(arguments: &RenderArguments, scene: Option<&Path>) -> Result<(), CliError> {
    let target = Target::of(arguments)?;
    let is_seen_through = arguments.background == Background::Transparent;
    let size = arguments.size.unwrap_or(if arguments.sheet.is_some() { SHEET_SIZE } else { DEFAULT_SIZE });
    let problem = |format: ExportFormat| format.problem([size.width, size.height], arguments.fps, is_seen_through);
    if let Some(problem) = target.format().and_then(problem) {
        return Err(misuse(problem.english()));
    }
    if target == Target::Mp4 {
        find_ffmpeg(&arguments.output)?;
    }
    let mut painter = Painter::headless(size, arguments.samples)?;
    painter.set_background(arguments.background);
    let done = draw(arguments, scene, target, &mut painter);
    if done.is_ok() {
        // The system takes back in no time what a driver takes milliseconds to give back, and the process ends after this. Where
        // something went wrong the driver may be at work still, and must be waited for.
        mem::forget(painter);
    }
    done
}

fn draw(
    arguments: &RenderArguments,
    scene: Option<&Path>,
    target: Target,
    painter: &mut Painter,
) -> Result<(), CliError> {
    let size = painter.size();
    let is_seen_through = arguments.background == Background::Transparent;
    let scene = scene::load(scene)?;
    let animation =
        arguments.file.as_deref().map(|file| Animation::load(file, &scene, arguments.interpolation)).transpose()?;
    let view = View::named(arguments.camera.as_deref(), &scene)?;
    let source = Source { scene: &scene, animation: animation.as_ref(), file: arguments.file.as_deref() };
    let stage = Stage::new(source, view, arguments.ghosts.unwrap_or(0), painter.size_px());
    // Hashing costs time.
    let mut manifest = arguments.manifest.is_some().then(|| Manifest::new(painter));
    let output = &arguments.output;
    match (target, arguments.sheet) {
        (Target::Image, Some(grid)) => {
            let png = sheet(arguments, grid, source, &stage, painter)?.to_png()?;
            write(output, &png, manifest.as_mut())?;
        }
        (Target::Image, None) => {
            let shown = source.shown(arguments.at, arguments.keyframe)?;
            let frame = stage.frame(&Moment { shown, seconds: arguments.seconds, start_ms: 0.0, turn: 0.0 })?;
            let png = if arguments.id { identities::png(painter, &frame)? } else { painter.png(&frame)? };
            write(output, &png, manifest.as_mut())?;
        }
        (Target::Folder, _) => {
            let fps = arguments.fps.unwrap_or(target.usual_frames_per_second());
            let moments = Moments::of_film(arguments.span(), source, view, fps)?;
            let mut watch = watched(&moments);
            let mut drawing = Drawing { stage: &stage, moments: &moments, painter, watch: &mut watch };
            write_folder(output, &mut drawing, &mut |path, png| {
                if let Some(manifest) = &mut manifest {
                    manifest.add(path, png);
                }
            })?;
        }
        (Target::Film(_) | Target::Mp4, _) => {
            let fps = arguments.fps.unwrap_or(target.usual_frames_per_second());
            let moments = Moments::of_film(arguments.span(), source, view, fps)?;
            let plan = moments.plan(size, fps, !is_seen_through)?;
            let mut watch = watched(&moments);
            let mut drawing = Drawing { stage: &stage, moments: &moments, painter, watch: &mut watch };
            write_film(output, target, plan, &mut drawing)?;
            if let Some(manifest) = &mut manifest {
                manifest.add_file(output)?;
            }
        }
    }
    match (&arguments.manifest, manifest) {
        (Some(path), Some(manifest)) => manifest.write(path),
        _ => Ok(()),
    }
}

/// A line that says how far it is, and an ear for Ctrl+C.
fn watched(moments: &Moments) -> impl FnMut(usize, usize) -> bool {
    let mut progress = Progress::new("frame", moments.all.len());
    let interrupt = Interrupt::listen();
    move |done, _| {
        progress.reach(done);
        !interrupt.is_asked()
    }
}

fn sheet(
    arguments: &RenderArguments,
    grid: Grid,
    source: Source<'_>,
    stage: &Stage<'_>,
    painter: &mut Painter,
) -> Result<Image, CliError> {
    let moments = Moments::of_sheet(arguments.span(), source, grid)?;
    let mut cells = Vec::new();
    let mut watch = watched(&moments);
    Drawing { stage, moments: &moments, painter, watch: &mut watch }.draw(|place, drawn| {
        cells.push(Cell { picture: drawn.rows().to_image(), caption: moments.all[place].caption() });
        Ok(())
    })?;
    Ok(contact_sheet(grid, &cells))
}

fn write(path: &Path, png: &[u8], manifest: Option<&mut Manifest>) -> Result<(), CliError> {
    storage::write_unsynced(path, png).map_err(|reason| CliError::unwritten(path, reason))?;
    if let Some(manifest) = manifest {
        manifest.add(path, png);
    }
    Ok(())
}
