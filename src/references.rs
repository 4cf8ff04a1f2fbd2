//! Reference pictures: draws the pictures of a folder's list and compares them with the references beside it.

mod list;

use std::fmt;
use std::path::{Path, PathBuf};

pub use list::{LIST_NAME, Shot, read_list};

use crate::export::{Animation, ErrorKind, Moment, Painter, Size, Source, Stage, Viewpoint};
use crate::files::{self, FileError, LARGEST_IMAGE_BYTES, WorkError, scene};
use crate::flip::{CompareError, Comparison, check_sizes, compare};
use crate::render::Image;
use crate::storage;

/// What `--update` did with a reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accepted {
    /// It was created.
    New,
    /// It was replaced.
    Updated,
    /// It did not change.
    Unchanged,
}

/// The verdict on one picture.
#[derive(Debug)]
pub enum Verdict {
    /// They were compared.
    Compared {
        /// The score.
        found: Box<Comparison>,
        /// The largest score that counts as the same.
        tolerance: f32,
    },
    /// There is no reference.
    Missing(PathBuf),
    /// The reference cannot be read.
    Unreadable(FileError),
    /// The two cannot be compared.
    Incomparable(CompareError),
}

impl Verdict {
    /// Whether the picture equals its reference within the tolerance.
    #[must_use]
    pub fn is_good(&self) -> bool {
        matches!(self, Self::Compared { found, tolerance } if found.is_within(*tolerance))
    }
}

impl fmt::Display for Accepted {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::New => "new",
            Self::Updated => "updated",
            Self::Unchanged => "unchanged",
        })
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Compared { found, tolerance } => formatter.write_str(&found.sentence(*tolerance)),
            Self::Missing(path) => {
                write!(formatter, "the reference {} is missing (--update accepts what is drawn now)", path.display())
            }
            Self::Unreadable(error) => error.fmt(formatter),
            Self::Incomparable(error) => error.fmt(formatter),
        }
    }
}

/// A folder of references, and how its pictures are drawn.
pub struct References<'a> {
    /// The folder.
    folder: &'a Path,
    /// The scene of pictures that name none.
    scene: Option<&'a Path>,
    /// Made anew for a picture of another size or number of samples.
    painter: Painter,
}

impl<'a> References<'a> {
    /// The references of a folder. `scene` is a built-in scene's name or a scene file.
    #[must_use]
    pub fn new(folder: &'a Path, scene: Option<&'a Path>, painter: Painter) -> Self {
        Self { folder, scene, painter }
    }

    /// Where the picture that is drawn goes in the folder `actual`.
    #[must_use]
    pub fn drawn_path(actual: &Path, shot: &Shot) -> PathBuf {
        actual.join(format!("{}.png", shot.name))
    }

    /// Where its difference from the reference goes in the folder `actual`.
    #[must_use]
    pub fn difference_path(actual: &Path, shot: &Shot) -> PathBuf {
        actual.join(format!("{}-difference.png", shot.name))
    }

    /// Draws a picture and takes it as the reference.
    ///
    /// # Errors
    /// [`WorkError`]: it cannot be drawn or written.
    pub fn accept(&mut self, shot: &Shot) -> Result<Accepted, WorkError> {
        let png = self.draw(shot)?.to_png()?;
        let path = self.folder.join(shot.reference());
        let accepted = match storage::read(&path, LARGEST_IMAGE_BYTES).ok() {
            Some(before) if before == png => return Ok(Accepted::Unchanged),
            Some(_) => Accepted::Updated,
            None => Accepted::New,
        };
        files::write(&path, &png)?;
        Ok(accepted)
    }

    /// Draws a picture, compares it with its reference, and writes the picture and, if they differ, the difference
    /// into the folder `actual`.
    ///
    /// # Errors
    /// [`WorkError`]: it cannot be drawn or written.
    pub fn verify(&mut self, shot: &Shot, actual: &Path) -> Result<Verdict, WorkError> {
        let drawn = self.draw(shot)?;
        files::write(&Self::drawn_path(actual, shot), &drawn.to_png()?)?;
        let difference = Self::difference_path(actual, shot);
        // Remove the difference image of an earlier run.
        storage::remove(&difference).map_err(|reason| FileError::storage(difference.display(), reason))?;
        let verdict = self.verdict(shot, &drawn);
        if let Verdict::Compared { found, .. } = &verdict
            && !verdict.is_good()
        {
            files::write(&difference, &found.difference().to_png()?)?;
        }
        Ok(verdict)
    }

    fn verdict(&self, shot: &Shot, drawn: &Image) -> Verdict {
        let path = self.folder.join(shot.reference());
        if !storage::exists(&path) {
            return Verdict::Missing(path);
        }
        let size = match files::image_size(&path) {
            Ok(size) => size.unwrap_or(shot.size),
            Err(error) => return Verdict::Unreadable(error),
        };
        // A reference of another size is not decoded.
        if let Err(error) = check_sizes(size, shot.size) {
            return Verdict::Incomparable(error);
        }
        match files::image(&path).map(|reference| compare(&reference, drawn)) {
            Ok(Ok(found)) => Verdict::Compared { found: Box::new(found), tolerance: shot.tolerance },
            Ok(Err(error)) => Verdict::Incomparable(error),
            Err(error) => Verdict::Unreadable(error),
        }
    }

    fn draw(&mut self, shot: &Shot) -> Result<Image, WorkError> {
        let [width, height] = shot.size;
        let size = Size { width, height };
        if (self.painter.size(), self.painter.samples()) != (size, shot.samples) {
            self.painter = Painter::headless(size, Some(shot.samples))?;
        }
        self.draw_at_size(shot).map_err(|error| in_list(shot, error))
    }

    fn draw_at_size(&mut self, shot: &Shot) -> Result<Image, WorkError> {
        // A scene in a file is in the folder; the name of a built-in one is no file there.
        let named = shot.scene.as_ref().map(|name| {
            let beside = self.folder.join(name);
            if storage::exists(&beside) { beside } else { PathBuf::from(name) }
        });
        let scene = scene::load(named.as_deref().or(self.scene))?;
        let file = shot.file.as_ref().map(|file| self.folder.join(file));
        let animation = file.as_deref().map(|file| Animation::load(file, &scene, shot.interpolation())).transpose()?;
        let source = Source { scene: &scene, animation: animation.as_ref(), file: file.as_deref() };
        let view = Viewpoint::named(shot.camera.as_deref(), &scene)?;
        let shown = source.shown(shot.at, shot.keyframe)?;
        let moment = Moment { shown, seconds: shot.seconds, turn: 0.0, number: 0 };
        let frame = Stage::new(source, view, 0, self.painter.size_px()).frame(&moment)?;
        Ok(self.painter.image(&frame)?)
    }
}

/// Bad input of a picture, with the picture's name.
fn in_list(shot: &Shot, error: WorkError) -> WorkError {
    let error = match error {
        WorkError::File(error) => error,
        WorkError::Export(error) if error.kind() == ErrorKind::Input => {
            FileError::of_sentences(vec![error.to_string()])
        }
        other @ WorkError::Export(_) => return other,
    };
    error.within(format_args!("picture \"{}\"", shot.name)).into()
}
