//! `inbetween verify`: whether what is drawn today looks like the references in a folder.

mod list;

use std::path::{Path, PathBuf};

use super::arguments::VerifyArguments;
use super::progress::Progress;
use super::{CliError, compare, output, scene};
use crate::compare::compare as compare_pictures;
use crate::export::{Animation, Moment, Painter, Size, Source, Stage, Viewpoint};
use crate::render::Image;
use crate::storage;
use list::{LIST_NAME, Picture};

/// What came of one picture.
struct Verdict {
    line: String,
    is_good: bool,
}

/// Renders what the folder's list says and compares it with the references beside it, or takes it as them.
///
/// # Errors
/// [`CliError::Beyond`] where a picture differs or its reference is missing; [`CliError::BadInput`] where the list is bad.
pub fn run(arguments: &VerifyArguments, scene: Option<&Path>) -> Result<(), CliError> {
    let mut painter = Painter::headless(super::render::DEFAULT_SIZE, Some(1))?;
    let folder = &arguments.folder;
    let pictures = list::read(&folder.join(LIST_NAME))?;
    let actual = arguments.output.clone().unwrap_or_else(|| folder.join("actual"));
    if !arguments.update {
        storage::create_folder(&actual).map_err(|reason| CliError::unwritten(&actual, reason))?;
    }
    let mut progress = Progress::new("picture", pictures.len());
    let mut verdicts = Vec::with_capacity(pictures.len());
    for picture in &pictures {
        let drawn = draw(picture, folder, scene, &mut painter)?;
        verdicts.push(if arguments.update {
            accept(picture, folder, &drawn)?
        } else {
            verify(picture, folder, &actual, &drawn)?
        });
        progress.step();
    }
    drop(progress);
    let bad = verdicts.iter().filter(|verdict| !verdict.is_good).count();
    output::print(|output| {
        verdicts.iter().try_for_each(|verdict| writeln!(output, "{}", verdict.line))?;
        match (arguments.update, bad) {
            (true, _) => Ok(()),
            (false, 0) => writeln!(output, "all {} as they should be", pictures.len()),
            (false, _) => {
                writeln!(output, "{bad} of {} not as they should be: see {}", pictures.len(), actual.display())
            }
        }
    })?;
    if bad == 0 { Ok(()) } else { Err(CliError::Beyond) }
}

fn draw(picture: &Picture, folder: &Path, scene: Option<&Path>, painter: &mut Painter) -> Result<Image, CliError> {
    let in_list = |error: CliError| match error {
        CliError::BadInput { sentences } => CliError::BadInput {
            sentences: sentences
                .into_iter()
                .map(|sentence| format!("picture \"{}\": {sentence}", picture.name))
                .collect(),
        },
        other => other,
    };
    let [width, height] = picture.size;
    let size = Size { width, height };
    if (painter.size(), painter.samples()) != (size, picture.samples) {
        *painter = Painter::headless(size, Some(picture.samples))?;
    }
    // A scene in a file lies in the folder; a built-in one's name is no file there.
    let named = picture.scene.as_ref().map(|name| {
        let beside = folder.join(name);
        if storage::exists(&beside) { beside } else { PathBuf::from(name) }
    });
    let scene = scene::load(named.as_deref().or(scene)).map_err(in_list)?;
    let file = picture.file.as_ref().map(|file| folder.join(file));
    let animation = file.as_deref().map(|file| Animation::load(file, &scene, picture.interpolation()));
    let animation = animation.transpose().map_err(in_list)?;
    let source = Source { scene: &scene, animation: animation.as_ref(), file: file.as_deref() };
    let view = Viewpoint::named(picture.camera.as_deref(), &scene).map_err(|error| in_list(error.into()))?;
    let shown = source.shown(picture.at, picture.keyframe).map_err(|error| in_list(error.into()))?;
    let moment = Moment { shown, seconds: picture.seconds, start_ms: 0.0, turn: 0.0 };
    let frame = Stage::new(source, view, 0, painter.size_px()).frame(&moment).map_err(|error| in_list(error.into()))?;
    Ok(painter.image(&frame)?)
}

fn accept(picture: &Picture, folder: &Path, drawn: &Image) -> Result<Verdict, CliError> {
    let path = folder.join(picture.reference());
    let png = drawn.to_png()?;
    let before = storage::read(&path, compare::LARGEST_IMAGE_BYTES).ok();
    let said = match before {
        Some(bytes) if bytes == png => "unchanged",
        Some(_) => "updated",
        None => "new",
    };
    if said != "unchanged" {
        storage::write(&path, &png).map_err(|reason| CliError::unwritten(&path, reason))?;
    }
    Ok(Verdict { line: format!("{}: {said}", picture.name), is_good: true })
}

fn verify(picture: &Picture, folder: &Path, actual: &Path, drawn: &Image) -> Result<Verdict, CliError> {
    let name = &picture.name;
    let write = |path: &Path, image: &Image| {
        storage::write(path, &image.to_png()?).map_err(|reason| CliError::unwritten(path, reason))
    };
    write(&actual.join(format!("{name}.png")), drawn)?;
    let difference = actual.join(format!("{name}-difference.png"));
    // What an earlier run left would tell of that run.
    storage::remove(&difference).map_err(|reason| CliError::unwritten(&difference, reason))?;
    let path = folder.join(picture.reference());
    let bad = |problem: String| Ok(Verdict { line: format!("{name}: {problem}"), is_good: false });
    if !storage::exists(&path) {
        return bad(format!("the reference {} is missing (--update accepts what is drawn now)", path.display()));
    }
    let reference = match compare::read(&path) {
        Ok(reference) => reference,
        Err(problem) => return bad(problem),
    };
    let found = match compare_pictures(&reference, drawn) {
        Ok(found) => found,
        Err(problem) => return bad(problem.to_string()),
    };
    let is_good = found.is_within(picture.tolerance);
    if !is_good {
        write(&difference, &found.difference())?;
    }
    let line = format!("{name}: {}", compare::sentence(&found, picture.tolerance));
    Ok(Verdict { line, is_good })
}
