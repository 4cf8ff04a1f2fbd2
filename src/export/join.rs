//! A film from the numbered pictures of a folder.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::folder::{frame_name, frames_in, read_frame};
use super::pictures::{Pictures, Take};
use super::write::{write_film, write_through_ffmpeg};
use super::{ExportError, Size, Watch, check_format};
use crate::film::{Encoder, Format, FormatProblem, FrameNumbers, Plan, StillFormat, stills};
use crate::parallel::map_in_order;
use crate::picture::Image;

/// A film to be made from pictures of a folder.
#[derive(Clone, Copy)]
pub struct JoinRequest<'a> {
    /// The folder, as [`write_folder`](super::write_folder) fills it.
    pub folder: &'a Path,
    /// The format of the pictures; by default that of those in the folder.
    pub still: Option<&'static Format>,
    /// The pictures of the film; by default all, from number 0 to the last that is there.
    pub frames: Option<&'a FrameNumbers>,
    /// The film's format.
    pub format: &'static Format,
    /// Frames per second.
    pub fps: u32,
    /// The film's file.
    pub output: &'a Path,
}

impl JoinRequest<'_> {
    /// Reads the pictures and writes the film: the bytes that a [`RenderRequest`](super::RenderRequest) for this film writes. Every picture
    /// is read twice, so that nothing is written unless all are whole and of one size.
    ///
    /// The film is opaque if all pictures are. A render with a transparent background of which no pixel is visible makes another APNG or
    /// GIF of the same pictures.
    ///
    /// # Errors
    /// [`ExportError`]: pictures are missing, not whole or of different sizes; the format cannot hold the film; the file cannot be written.
    pub fn write(&self, watch: &mut Watch<'_>) -> Result<(), ExportError> {
        let Self { format, fps, output, .. } = *self;
        if format.is_still() {
            return Err(FormatProblem::NoFilm.into());
        }
        let (mut frames, size, is_opaque) = self.open()?;
        check_format(format, size, Some(fps), is_opaque, output)?;
        let plan =
            Plan::new([size.width, size.height], frames.count(), fps, is_opaque).ok_or(ExportError::TooManyFrames)?;
        match format.encoder {
            Encoder::Film(film) => write_film(output, film, plan, &mut frames, watch),
            Encoder::Ffmpeg(film) => write_through_ffmpeg(output, film, plan, &mut frames, watch),
            Encoder::Still(_) => Err(FormatProblem::NoFilm.into()),
        }
    }

    /// The pictures, their size, and whether all are opaque.
    fn open(&self) -> Result<(Frames, Size, bool), ExportError> {
        let folder = self.folder;
        let (ending, still, there) = self.found()?;
        let count = there.last().map_or(0, |last| last + 1);
        let all = FrameNumbers::first(count);
        let frames = self.frames.unwrap_or(&all);
        let lacking = |(count, first, last)| {
            let [first, last] = [first, last].map(|number| frame_name(number, ending));
            ExportError::MissingFrames { folder: folder.to_owned(), count, first, last }
        };
        if let Some(absent) = frames.absent(&there) {
            return Err(lacking(absent));
        }
        let numbers = frames.of_film(count).unwrap_or_default();
        let paths: Vec<PathBuf> = numbers.iter().map(|&number| folder.join(frame_name(number, ending))).collect();
        let seen = map_in_order(&paths, |path| {
            let image = read_frame(path, still)?;
            let is_opaque = image.rgba.chunks_exact(4).all(|pixel| pixel[3] == u8::MAX);
            Some((Size { width: image.width, height: image.height }, is_opaque))
        });
        let torn: Vec<usize> = numbers.iter().zip(&seen).filter(|(_, seen)| seen.is_none()).map(|(&n, _)| n).collect();
        if let (Some(&first), Some(&last)) = (torn.first(), torn.last()) {
            return Err(lacking((torn.len(), first, last)));
        }
        let seen: Vec<(Size, bool)> = seen.into_iter().flatten().collect();
        let size = seen[0].0;
        if let Some(other) = seen.iter().position(|&(other, _)| other != size) {
            return Err(ExportError::UnequalFrames {
                path: paths[other].clone(),
                size: seen[other].0,
                first: frame_name(numbers[0], ending),
                first_size: size,
            });
        }
        let is_opaque = seen.iter().all(|&(_, is_opaque)| is_opaque);
        Ok((Frames { paths, still }, size, is_opaque))
    }

    /// The ending of the folder's pictures, their format, and which are there.
    fn found(&self) -> Result<(&'static str, StillFormat, BTreeSet<usize>), ExportError> {
        let mut found = Vec::new();
        for format in stills().filter(|format| self.still.is_none_or(|still| still == *format)) {
            if let Encoder::Still(still) = format.encoder {
                let there = frames_in(self.folder, format.ending)?;
                if !there.is_empty() {
                    found.push((format.ending, still, there.into_iter().map(|(number, _)| number).collect()));
                }
            }
        }
        let folder = || self.folder.to_owned();
        match found.len() {
            0 => Err(ExportError::NoFrames { folder: folder() }),
            1 => Ok(found.remove(0)),
            _ => {
                let endings = found.iter().map(|(ending, ..)| *ending).collect();
                Err(ExportError::SeveralFormats { folder: folder(), endings })
            }
        }
    }
}

/// Pictures in files.
struct Frames {
    paths: Vec<PathBuf>,
    still: StillFormat,
}

impl Frames {
    fn read(&self, place: usize) -> Result<Image, ExportError> {
        let path = &self.paths[place];
        // It was whole when it was looked at.
        read_frame(path, self.still).ok_or_else(|| ExportError::FrameGone { path: path.clone() })
    }
}

impl Pictures for Frames {
    fn count(&self) -> usize {
        self.paths.len()
    }

    fn ahead(&mut self, places: &[usize]) -> Result<Vec<Image>, ExportError> {
        places.iter().map(|&place| self.read(place)).collect()
    }

    fn each(&mut self, watch: &mut Watch<'_>, take: &mut Take<'_>) -> Result<(), ExportError> {
        let count = self.count();
        let mut goes_on = |done| if watch(done, count) { Ok(()) } else { Err(ExportError::Cancelled) };
        for place in 0..count {
            goes_on(place)?;
            take(place, self.read(place)?)?;
        }
        goes_on(count)
    }
}
