//! An export in steps, none of which waits: for a page, which has one thread.

use std::collections::VecDeque;

use super::job::{Job, end};
use super::pictures::{Pictures, Take};
use super::write::write_film;
use super::{ExportError, Exposed, Painter, Watch};
use crate::film::{Encoder, ExportEnd, FormatProblem};
use crate::picture::Image;
use crate::render::Gpu;

/// A film that is being made: its frames are drawn one a step, and encoded in the last step.
pub struct Steps {
    job: Job,
    /// `None` while there is no adapter.
    painter: Option<Painter>,
    images: VecDeque<Image>,
    /// Whether the next frame is being drawn.
    is_drawing: bool,
    count: usize,
}

/// Where a film is after a step.
#[derive(Debug)]
pub enum Step {
    /// So many frames of so many are drawn.
    Drawn(usize, usize),
    /// The film is over.
    Ended(ExportEnd),
}

impl Steps {
    /// Prepares a film, on an adapter.
    ///
    /// # Errors
    /// How it ended before it began.
    pub fn new(job: Job, gpu: Gpu) -> Result<Self, ExportEnd> {
        let begun = Self::begun(&job, gpu);
        match begun {
            Ok((painter, count)) => {
                Ok(Self { job, painter: Some(painter), images: VecDeque::new(), is_drawing: false, count })
            }
            Err(error) => Err(end(Err(error), 0)),
        }
    }

    fn begun(job: &Job, gpu: Gpu) -> Result<(Painter, usize), ExportError> {
        if !matches!(job.format().encoder, Encoder::Film(_)) {
            return Err(FormatProblem::NoPicture.into());
        }
        let count = job.request(&job.lit())?.plan()?.frame_count();
        Ok((Self::painter(job, gpu)?, count))
    }

    fn painter(job: &Job, gpu: Gpu) -> Result<Painter, ExportError> {
        let mut painter = Painter::on(gpu, job.size(), Some(1))?;
        job.prepare(&mut painter);
        Ok(painter)
    }

    /// Waits from now on: the adapter is gone. The frame that was being drawn will be begun again.
    pub fn suspend(&mut self) {
        self.painter = None;
        self.is_drawing = false;
    }

    /// Goes on, on another adapter.
    ///
    /// # Errors
    /// How it ended.
    pub fn resume(&mut self, gpu: Gpu) -> Result<(), ExportEnd> {
        self.painter = Some(Self::painter(&self.job, gpu).map_err(|error| end(Err(error), 0))?);
        Ok(())
    }

    /// Goes on as far as that needs no waiting.
    pub fn step(&mut self) -> Step {
        match self.try_step() {
            Ok(step) => step,
            Err(error) => Step::Ended(end(Err(error), 0)),
        }
    }

    fn try_step(&mut self) -> Result<Step, ExportError> {
        let Self { job, painter, images, is_drawing, count } = self;
        let Some(painter) = painter else { return Ok(Step::Drawn(images.len(), *count)) };
        if *is_drawing {
            if let Some(image) = painter.image_if_there()? {
                images.push_back(image);
                *is_drawing = false;
            }
            return Ok(Step::Drawn(images.len(), *count));
        }
        let lit = job.lit();
        let planned = job.request(&lit)?.plan()?;
        if images.len() == *count {
            let Encoder::Film(film) = job.format().encoder else { return Err(FormatProblem::NoPicture.into()) };
            let mut drawn = InMemory { images: std::mem::take(images) };
            let plan = planned.film_plan(painter)?;
            write_film(job.path(), film, plan, &mut drawn, &mut |_, _| true)?;
            return Ok(Step::Ended(end(Ok(*count), 0)));
        }
        let stage = planned.stage(painter)?;
        painter.begin(&Exposed::of_stage(&stage, &planned.moments.all[images.len()])?)?;
        *is_drawing = true;
        Ok(Step::Drawn(images.len(), *count))
    }
}

/// Frames that are drawn.
struct InMemory {
    images: VecDeque<Image>,
}

impl Pictures for InMemory {
    fn count(&self) -> usize {
        self.images.len()
    }

    fn ahead(&mut self, places: &[usize]) -> Result<Vec<Image>, ExportError> {
        Ok(places.iter().map(|&place| self.images[place].clone()).collect())
    }

    fn each(&mut self, _: &mut Watch<'_>, take: &mut Take<'_>) -> Result<(), ExportError> {
        let images = std::mem::take(&mut self.images).into_iter().enumerate();
        { images }.try_for_each(|(place, image)| take(place, image))
    }
}
