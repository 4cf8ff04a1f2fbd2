//! `inbetween render`: images and films with no window.

mod film;
mod identities;
mod manifest;
mod moments;
mod pipeline;
mod stage;
mod target;

use std::mem::ManuallyDrop;
use std::path::Path;

use super::animation::Animation;
use super::arguments::{RenderArguments, Size};
use super::interrupt::Interrupt;
use super::picture::Painter;
use super::{CliError, misuse, scene};
use crate::film::{Grid, contact_sheet};
use crate::render::{Background, Image};
use crate::storage;
use manifest::Manifest;
use moments::Moments;
use target::Target;

pub use moments::{Moment, Source};
pub use stage::{Stage, View};

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
    if is_seen_through && matches!(target, Target::Mp4 | Target::Film(crate::film::Format::Y4m)) {
        return Err(misuse("these films have no opacity: --background transparent is for PNG, GIF and APNG"));
    }
    let size = arguments.size.unwrap_or(if arguments.sheet.is_some() { SHEET_SIZE } else { DEFAULT_SIZE });
    if target == Target::Mp4 {
        if size.width % 2 == 1 || size.height % 2 == 1 {
            return Err(misuse("an MP4 needs an even width and height"));
        }
        film::find_ffmpeg(&arguments.output)?;
    }
    // The system takes back in no time what a driver takes milliseconds to give back, and the process ends after this.
    let mut painter = ManuallyDrop::new(Painter::new(size, arguments.samples)?);
    painter.set_background(arguments.background);
    let scene = scene::load(scene)?;
    let animation =
        arguments.file.as_deref().map(|file| Animation::load(file, &scene, arguments.interpolation)).transpose()?;
    let view = View::named(arguments.camera.as_deref(), &scene)?;
    let source = Source { scene: &scene, animation: animation.as_ref(), file: arguments.file.as_deref() };
    let stage = Stage::new(source, view, arguments.ghosts.unwrap_or(0), painter.size_px());
    let mut manifest = Manifest::new(&painter);
    let output = &arguments.output;
    match (target, arguments.sheet) {
        (Target::Image, Some(grid)) => {
            let png = sheet(arguments, grid, source, &stage, &mut painter)?.to_png()?;
            write(output, &png, &mut manifest)?;
        }
        (Target::Image, None) => {
            let frame = stage.frame(&source.still(arguments)?)?;
            let png = if arguments.id { identities::png(&painter, &frame)? } else { painter.png(&frame)? };
            write(output, &png, &mut manifest)?;
        }
        (Target::Folder, _) => {
            let moments =
                Moments::of_film(arguments, source, view, arguments.fps.unwrap_or(target::FRAMES_PER_SECOND))?;
            // Hashing costs time.
            let listed = arguments.manifest.is_some().then_some(&mut manifest);
            film::write_folder(output, &stage, &moments, &mut painter, listed)?;
        }
        (Target::Film(_) | Target::Mp4, _) => {
            let fps = arguments.fps.unwrap_or(target.usual_frames_per_second());
            let moments = Moments::of_film(arguments, source, view, fps)?;
            let plan = moments.plan(size, fps, !is_seen_through)?;
            film::write_film(output, target, plan, &stage, &moments, &mut painter)?;
            if arguments.manifest.is_some() {
                manifest.add_file(output)?;
            }
        }
    }
    arguments.manifest.as_deref().map_or(Ok(()), |path| manifest.write(path))
}

fn sheet(
    arguments: &RenderArguments,
    grid: Grid,
    source: Source<'_>,
    stage: &Stage<'_>,
    painter: &mut Painter,
) -> Result<Image, CliError> {
    let moments = Moments::of_sheet(arguments, source, grid)?;
    let mut pictures = Vec::new();
    pipeline::draw(&moments, stage, painter, &Interrupt::listen(), |_, image| {
        pictures.push(image);
        Ok(())
    })?;
    Ok(contact_sheet(grid, &pictures))
}

fn write(path: &Path, png: &[u8], manifest: &mut Manifest) -> Result<(), CliError> {
    storage::write_unsynced(path, png).map_err(|reason| CliError::unwritten(path, reason))?;
    manifest.add(path, png);
    Ok(())
}
