//! The pictures of a class: drawn where no earlier run has kept them.

use crate::cli::progress::Progress;
use crate::cli::{CliError, Common};
use crate::export::Painter;
use crate::grading::{self, GradedClass, Images, MistakeFilm, Rubric, Studio};
use crate::scene::SceneGraph;

/// A studio that is set up when the first picture is to be drawn.
#[derive(Default)]
pub struct LazyStudio {
    studio: Option<Studio>,
}

impl LazyStudio {
    /// The studio.
    ///
    /// # Errors
    /// [`CliError`]: there is no GPU adapter, or it fails.
    pub fn get(&mut self, images: Images, rubric: &Rubric, scene: &SceneGraph) -> Result<&mut Studio, CliError> {
        let studio = match self.studio.take() {
            Some(studio) => studio,
            None => Studio::new(Painter::headless(images.size(), None)?, rubric, scene)?,
        };
        Ok(self.studio.insert(studio))
    }

    /// Draws the pictures of submissions that are wanted and not known yet, and keeps all results.
    ///
    /// # Errors
    /// [`CliError`]: there is no GPU adapter, or it fails.
    pub fn draw(&mut self, class: &mut GradedClass, common: Common<'_>) -> Result<(), CliError> {
        let GradedClass { basis, scene, rubric, marks, cache, .. } = class;
        let count = if basis.images.is_some() { marks.len() } else { 0 };
        let mut progress = Progress::of_items("submission", count, common);
        for marks in marks {
            if let Some(images) = basis.images {
                progress.begin(&marks.name);
                if marks.pictures.is_none() {
                    let (studio, most) = (self.get(images, rubric, scene)?, usize::from(images.most));
                    marks.pictures = Some(grading::pictures_of(marks, rubric, scene, studio, most)?);
                }
                progress.step();
            }
            cache.keep_marks(marks);
        }
        Ok(())
    }

    /// The films of the known mistakes that a class shows, in the order of [`grading::mistakes_shown`]; none without pictures.
    ///
    /// # Errors
    /// [`CliError`]: there is no GPU adapter, or it fails.
    pub fn films(&mut self, class: &mut GradedClass) -> Result<Vec<Option<MistakeFilm>>, CliError> {
        let GradedClass { basis, scene, rubric, marks, cache, .. } = class;
        let Some(images) = basis.images else { return Ok(Vec::new()) };
        let mut films = Vec::new();
        for shown in grading::mistakes_shown(marks) {
            let of_first = shown.shown_by.first().map_or("", |first| &marks[*first].key);
            let parts = ["film", shown.mistake.name, shown.interpolation.name(), of_first];
            let key = cache.key(&parts.map(str::as_bytes));
            let film = match cache.get::<Option<MistakeFilm>>(&key) {
                Some(film) => film,
                None => grading::film_of(&shown, marks, rubric, scene, self.get(images, rubric, scene)?)?,
            };
            cache.keep(key, &film);
            films.push(film);
        }
        Ok(films)
    }
}
