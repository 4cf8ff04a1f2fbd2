//! `inbetween render`: images and films with no window.

mod identities;
mod manifest;
mod output;

use std::mem;
use std::path::Path;

use super::arguments::RenderArguments;
use super::places::Places;
use super::progress::{telling, watched};
use super::{CliError, Common, reading, scene};
use crate::export::{
    Animation, Comparison, Painter, RenderRequest, Size, Source, Subject, check_format, check_sheet, is_frame_name,
    write_picture,
};
use crate::render::Background;
use crate::storage::output_name;
use manifest::Manifest;
use output::Output;

/// The size of images and films where none is named.
pub const DEFAULT_SIZE: Size = Size { width: 640, height: 480 };
/// The size of a contact sheet's images where none is named.
const SHEET_SIZE: Size = Size { width: 320, height: 240 };

/// Renders what the arguments say. The GPU adapter is acquired before any file is read.
///
/// # Errors
/// [`CliError`]
pub fn run(arguments: &RenderArguments, common: Common<'_>) -> Result<(), CliError> {
    telling(arguments.progress, || render(arguments, common))
}

fn render(arguments: &RenderArguments, common: Common<'_>) -> Result<(), CliError> {
    let output = Output::of(arguments)?;
    places(arguments, common, output).check()?;
    let is_opaque = arguments.background != Background::Transparent;
    let layout = arguments.comparing.layout(arguments.size, arguments.sheet.is_some())?;
    let usual_size = if arguments.sheet.is_some() { SHEET_SIZE } else { DEFAULT_SIZE };
    let size = layout.map_or(arguments.size.unwrap_or(usual_size), |layout| Size::of(layout.size()));
    check_format(output.format, size, arguments.fps, is_opaque, &arguments.output)?;
    if let Some(grid) = arguments.sheet {
        check_sheet(grid, size)?;
    }
    let view = layout.map_or(size, |layout| Size::of(layout.view()));
    let mut painter = Painter::headless(view, arguments.samples)?;
    painter.refine(arguments.refining.refinement());
    painter.set_background(arguments.background);
    let comparison = arguments.comparing.comparison(layout);
    let done = draw(arguments, common, output, comparison.as_ref(), &mut painter);
    if done.is_ok() {
        // Skip the driver's clean-up, which takes milliseconds, because the process ends after this. After an error
        // the driver may still be busy, and must be waited for.
        mem::forget(painter);
    }
    done
}

fn draw(
    arguments: &RenderArguments,
    common: Common<'_>,
    output: Output,
    comparison: Option<&Comparison<'_>>,
    painter: &mut Painter,
) -> Result<(), CliError> {
    let scene = scene::load(common.scene)?;
    let scene = arguments.lighting.map(|lighting| scene.with_lighting(lighting.into())).unwrap_or(scene);
    let read = |file| -> Result<_, CliError> {
        Ok(Animation::of(reading::keyframes(file, &scene, common)?.file, arguments.interpolation))
    };
    let animation = arguments.file.as_deref().map(read).transpose()?;
    let subject = match (arguments.sheet, arguments.strobe) {
        (Some(grid), _) => Subject::Sheet(grid),
        (None, Some(count)) => Subject::Strobe(count),
        (None, None) if output.is_one_image => Subject::Picture { at: arguments.at, keyframe: arguments.keyframe },
        (None, None) => Subject::Film { fps: arguments.fps.unwrap_or(output.format.usual_frames_per_second) },
    };
    let request = RenderRequest {
        source: Source { scene: &scene, animation: animation.as_ref(), file: arguments.file.as_deref() },
        subject,
        span: arguments.span(),
        frames: arguments.frames.as_ref(),
        only_missing: arguments.missing,
        camera: arguments.camera.as_deref(),
        ghosts: arguments.ghosts.unwrap_or(0),
        comparison,
        exposure: arguments.refining.exposure(matches!(subject, Subject::Film { .. })),
        is_opaque: arguments.background != Background::Transparent,
        format: output.format,
        output: &arguments.output,
        removes_stale: arguments.clean,
    };
    let planned = request.plan()?;
    // Hashing is slow: only do it for a manifest.
    let mut manifest = arguments.manifest().is_some().then(|| Manifest::new(painter, planned.size(painter)));
    let mut written = |path: &Path, bytes: &[u8]| {
        if let Some(manifest) = &mut manifest {
            manifest.add(path, bytes);
        }
    };
    if arguments.id {
        let png = identities::png(painter, &planned.first_frame(painter)?)?;
        write_picture(&arguments.output, &png, &mut written)?;
    } else if matches!(subject, Subject::Picture { .. } | Subject::Strobe(_)) {
        planned.write(painter, &mut |_, _| true, &mut written)?;
    } else {
        planned.write(
            painter,
            &mut watched(common.progress(arguments.progress), output_name(&arguments.output)),
            &mut written,
        )?;
    }
    if let (Some(path), Some(mut manifest)) = (arguments.manifest(), manifest) {
        if !output.format.is_still() {
            manifest.add_file(&arguments.output)?;
        }
        manifest.write(path)?;
    }
    Ok(())
}

/// Where it reads and writes. Of the pictures in a folder, those are of interest that a manifest could be.
fn places(arguments: &RenderArguments, common: Common<'_>, output: Output) -> Places {
    let places = Places::with_scene(common.scene);
    let places = arguments.file.iter().fold(places, |places, file| places.reads("FILE", file));
    let is_folder = !output.is_one_image && output.format.is_still();
    let places = if is_folder { places } else { places.writes("--output", &arguments.output) };
    let places = places.tells(arguments.progress);
    let Some(manifest) = arguments.manifest() else { return places };
    let frame = manifest
        .file_name()
        .and_then(|name| name.to_str())
        .filter(|name| is_folder && is_frame_name(name, output.format.ending));
    let places = match frame {
        Some(name) => places.writes("--output", &arguments.output.join(name)),
        None => places,
    };
    places.writes(if arguments.json { "--json" } else { "--manifest" }, manifest)
}
