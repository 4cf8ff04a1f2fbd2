//! Reference pictures: draws the pictures of a folder's list and compares them with the references beside it.

mod list;
mod page;
mod shot;

use std::collections::{BTreeSet, HashSet};
use std::fmt;
use std::path::{Path, PathBuf};

pub use list::{LIST_NAME, read_list};
pub use page::{PAGE_NAME, page};
pub use shot::{Shot, When};

use crate::export::{
    Animation, ExportError, Exposed, Exposure, Moment, Moments, Painter, Shutter, Size, Source, Span, Stage, Viewpoint,
};
use crate::files::{self, FileError, LARGEST_IMAGE_BYTES, WorkError, scene};
use crate::flip::{CompareError, Comparison, Scores, check_sizes, compare};
use crate::render::{GpuError, Image, Refinement};
use crate::storage;
use crate::words::texts;

/// The most entries of a folder that are looked at for references that nothing uses.
const MOST_ENTRIES: usize = 200_000;

/// What `--update` did with a reference.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Accepted {
    /// It was created.
    New,
    /// It was replaced.
    Updated,
    /// It did not change.
    Unchanged,
    /// The picture could not be drawn or written: why.
    Undrawn(String),
}

/// The verdict on one picture.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// They were compared.
    Compared {
        /// The numbers.
        scores: Scores,
        /// The largest score that counts as the same.
        tolerance: f32,
    },
    /// There is no reference.
    Missing(PathBuf),
    /// The reference cannot be read: why.
    Unreadable(String),
    /// The two cannot be compared.
    Incomparable(CompareError),
    /// The picture could not be drawn or written: why.
    Undrawn(String),
}

impl Verdict {
    /// Whether the picture equals its reference within the tolerance.
    #[must_use]
    pub fn is_good(&self) -> bool {
        matches!(self, Self::Compared { scores, tolerance } if scores.is_within(*tolerance))
    }

    /// The verdict in a word: `ok`, `different`, `missing`, `unreadable`, `incomparable` or `undrawn`.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self {
            Self::Compared { .. } if self.is_good() => "ok",
            Self::Compared { .. } => "different",
            Self::Missing(_) => "missing",
            Self::Unreadable(_) => "unreadable",
            Self::Incomparable(_) => "incomparable",
            Self::Undrawn(_) => "undrawn",
        }
    }

    /// The numbers, where the two were compared.
    #[must_use]
    pub fn scores(&self) -> Option<Scores> {
        if let Self::Compared { scores, .. } = self { Some(*scores) } else { None }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Compared { scores, tolerance } => scores.sentence(*tolerance).fmt(formatter),
            Self::Missing(path) => texts::references_missing(path.display()).fmt(formatter),
            Self::Unreadable(reason) | Self::Undrawn(reason) => formatter.write_str(reason),
            Self::Incomparable(error) => error.fmt(formatter),
        }
    }
}

/// A picture and the verdict on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row<'a> {
    /// The picture.
    pub shot: &'a Shot,
    /// The verdict.
    pub verdict: Verdict,
}

/// A folder of references, and how its pictures are drawn.
pub struct References<'a> {
    /// The folder.
    folder: &'a Path,
    /// The scene of pictures that name none.
    scene: Option<&'a Path>,
    /// Made anew for a picture of another size or number of samples.
    painter: Painter,
    /// The frames of the film that the last of its pictures was of.
    film: Option<(Shot, Vec<Moment>)>,
}

impl<'a> References<'a> {
    /// The references of a folder. `scene` is a built-in scene's name or a scene file.
    #[must_use]
    pub fn new(folder: &'a Path, scene: Option<&'a Path>, painter: Painter) -> Self {
        Self { folder, scene, painter, film: None }
    }

    /// Draws a picture and takes it as the reference.
    ///
    /// # Errors
    /// [`GpuError`]: nothing can be drawn.
    pub fn accept(&mut self, shot: &Shot) -> Result<Accepted, GpuError> {
        let accepted = self.try_to_accept(shot);
        accepted.or_else(|error| reason(error).map(Accepted::Undrawn))
    }

    fn try_to_accept(&mut self, shot: &Shot) -> Result<Accepted, WorkError> {
        let png = self.draw(shot)?.to_png()?;
        let path = self.folder.join(&shot.reference);
        let accepted = match storage::read(&path, LARGEST_IMAGE_BYTES).ok() {
            Some(before) if before == png => return Ok(Accepted::Unchanged),
            Some(_) => Accepted::Updated,
            None => Accepted::New,
        };
        files::write(&path, &png)?;
        Ok(accepted)
    }

    /// Draws a picture, compares it with its reference, and writes the picture into the folder `actual`; if it is not as it should be,
    /// also a copy of the reference, and of two pictures that differ the difference.
    ///
    /// # Errors
    /// [`GpuError`]: nothing can be drawn.
    pub fn verify(&mut self, shot: &Shot, actual: &Path) -> Result<Verdict, GpuError> {
        let verdict = self.try_to_verify(shot, actual);
        verdict.or_else(|error| reason(error).map(Verdict::Undrawn))
    }

    fn try_to_verify(&mut self, shot: &Shot, actual: &Path) -> Result<Verdict, WorkError> {
        // Nothing of an earlier run is taken for this one's.
        for name in shot.written_names() {
            let path = actual.join(name);
            storage::remove(&path).map_err(|reason| FileError::storage(path.display(), reason))?;
        }
        let drawn = self.draw(shot)?;
        files::write(&actual.join(shot.drawn_name()), &drawn.to_png()?)?;
        let path = self.folder.join(&shot.reference);
        if !storage::exists(&path) {
            return Ok(Verdict::Missing(path));
        }
        let verdict = match compared(&path, shot, &drawn) {
            Err(error) => return Ok(Verdict::Unreadable(one_line(error.sentences()))),
            Ok(Err(error)) => Verdict::Incomparable(error),
            Ok(Ok(found)) => {
                let verdict = Verdict::Compared { scores: found.scores(), tolerance: shot.tolerance };
                if !verdict.is_good() {
                    files::write(&actual.join(shot.difference_name()), &found.difference().to_png()?)?;
                }
                verdict
            }
        };
        if !verdict.is_good() {
            let bytes = files::read(&path, LARGEST_IMAGE_BYTES)?;
            files::write(&actual.join(shot.reference_copy_name()), &bytes)?;
        }
        Ok(verdict)
    }

    fn draw(&mut self, shot: &Shot) -> Result<Image, WorkError> {
        let [width, height] = shot.size;
        let size = Size { width, height };
        if (self.painter.size(), self.painter.samples()) != (size, shot.samples) {
            self.painter = Painter::headless(size, Some(shot.samples))?;
        }
        self.painter.refine(Refinement::of_quality(shot.quality));
        // A scene in a file is in the folder; the name of a built-in one is no file there.
        let named = shot.scene.as_ref().map(|name| {
            let beside = self.folder.join(name);
            if storage::exists(&beside) { beside } else { PathBuf::from(name) }
        });
        let scene = scene::load(named.as_deref().or(self.scene))?;
        let scene = shot.lighting.map(|lighting| scene.with_lighting(lighting.into())).unwrap_or(scene);
        let file = shot.file.as_ref().map(|file| self.folder.join(file));
        let animation = file.as_deref().map(|file| Animation::load(file, &scene, shot.interpolation)).transpose()?;
        let source = Source { scene: &scene, animation: animation.as_ref(), file: file.as_deref() };
        let view = Viewpoint::named(shot.camera.as_deref(), &scene)?;
        let still = |shown| Moment { shown, seconds: shot.seconds, turn: 0.0, number: 0 };
        let moment = match shot.when {
            When::At(key_time) => still(source.shown(Some(key_time), None)?),
            When::Keyframe(index) => still(source.shown(None, Some(index))?),
            When::Frame { number, fps } => self.frame_of_film(shot, number, fps, source, view)?,
        };
        let mut stage = Stage::new(source, view, 0, self.painter.size_px());
        if let (When::Frame { fps, .. }, Some((_, moments))) = (shot.when, &self.film) {
            stage.expose(&Exposure { shutter: Shutter::OF_FILMS, focus: None }, fps, moments.len())?;
        }
        Ok(self.painter.exposed(&Exposed::of_stage(&stage, &moment)?)?)
    }

    /// A frame of a film. The next of the same film costs no second look at its times.
    fn frame_of_film(
        &mut self,
        shot: &Shot,
        number: usize,
        fps: u32,
        source: Source<'_>,
        view: Viewpoint,
    ) -> Result<Moment, WorkError> {
        // What two frames of a film have in common.
        let key = Shot {
            name: String::new(),
            reference: String::new(),
            when: When::Frame { number: 0, fps },
            ..shot.clone()
        };
        let film = match self.film.take() {
            Some((of, moments)) if of == key => moments,
            _ => {
                let span = Span { seconds: shot.seconds, ..Span::default() };
                Moments::of_film(span, source, view, fps)?.all
            }
        };
        let (_, moments) = self.film.insert((key, film));
        let last = moments.len().saturating_sub(1);
        let no_frame = || ExportError::NoFrame { source_name: source.name(), frame: number, last, fps };
        moments.get(number).copied().ok_or_else(|| no_frame().into())
    }
}

/// The comparison of a picture with its reference.
fn compared(reference: &Path, shot: &Shot, drawn: &Image) -> Result<Result<Comparison, CompareError>, FileError> {
    let size = files::image_size(reference)?.unwrap_or(shot.size);
    // A reference of another size is not decoded.
    if let Err(error) = check_sizes(size, shot.size) {
        return Ok(Err(error));
    }
    Ok(compare(&files::image(reference)?, drawn))
}

/// Why one picture failed, on one line.
///
/// # Errors
/// [`GpuError`]: the others would fail as well.
fn reason(error: WorkError) -> Result<String, GpuError> {
    match error {
        WorkError::Export(ExportError::Gpu(error)) if !matches!(error, GpuError::Size { .. }) => Err(error),
        WorkError::Export(error) => Ok(error.to_string()),
        WorkError::File(error) => Ok(one_line(error.sentences())),
    }
}

fn one_line(sentences: &[String]) -> String {
    sentences.join("; ")
}

/// Pictures in the folders of the references that none of the list has as its reference, sorted.
#[must_use]
pub fn unused(folder: &Path, shots: &[Shot]) -> Vec<PathBuf> {
    let used: HashSet<PathBuf> = shots.iter().map(|shot| folder.join(&shot.reference)).collect();
    let parents = used.iter().filter_map(|path| path.parent()).map(Path::to_path_buf);
    let folders: BTreeSet<PathBuf> = parents.chain([folder.to_path_buf()]).collect();
    let listed = folders.iter().filter_map(|folder| storage::list(folder, MOST_ENTRIES).ok());
    let paths = listed.flat_map(|(entries, _)| entries).map(|entry| entry.path);
    paths.filter(|path| path.extension().is_some_and(|ending| ending == "png") && !used.contains(path)).collect()
}
