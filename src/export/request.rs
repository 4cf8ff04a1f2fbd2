//! A request for a picture or film, shared by the Export dialog and `inbetween render`.

use std::path::Path;

use super::compared::PlannedComparison;
use super::ffmpeg::find_ffmpeg;
use super::folder::{clear_folder, missing_frames};
use super::write::{Written, unwritten, write_film, write_folder, write_through_ffmpeg};
use super::{
    Comparison, Drawing, ExportError, Exposed, Exposure, Moment, Moments, Painter, Scenery, Size, Source, Span, Stage,
    Viewpoint, Watch,
};
use crate::film::{Cell, Encoder, Format, FormatProblem, FrameNumbers, Grid, Plan, StartStill, contact_sheet};
use crate::frame::Frame;
use crate::storage;

/// The kind of output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Subject {
    /// One picture at a key time or of a keyframe of the list; by default at the playing range's start.
    Picture {
        /// The key time.
        at: Option<f64>,
        /// The keyframe's index.
        keyframe: Option<i64>,
    },
    /// One picture of this number of moments, at least 2: the last as it is, those before it translucent.
    Strobe(u32),
    /// A contact sheet.
    Sheet(Grid),
    /// A film, or a folder of numbered pictures if the format is for single pictures.
    Film {
        /// Frames per second.
        fps: u32,
    },
}

/// All inputs of an export.
#[derive(Clone, Copy)]
pub struct RenderRequest<'a> {
    /// The scene and its animation.
    pub source: Source<'a>,
    /// The kind of output.
    pub subject: Subject,
    /// The part of the animation, for films and contact sheets. Its seconds apply to single pictures too.
    pub span: Span,
    /// The frames of the film that are drawn; `None`: all.
    pub frames: Option<&'a FrameNumbers>,
    /// Whether a folder gets only the frames that are missing in it, not whole, or of another size.
    pub only_missing: bool,
    /// An eye of the scene by its path, or `turntable`; `None`: the scene's first eye.
    pub camera: Option<&'a str>,
    /// Neighbouring keyframes on each side that are shown as ghosts.
    pub ghosts: u8,
    /// The interpolations that each picture compares, instead of showing the animation's. The painter's pictures have the size of a view.
    pub comparison: Option<&'a Comparison<'a>>,
    /// How refined pictures are taken.
    pub exposure: Exposure<'a>,
    /// Whether the background is opaque.
    pub is_opaque: bool,
    /// The format of the file or, of single pictures, of the folder's files.
    pub format: &'static Format,
    /// The file or folder.
    pub output: &'a Path,
    /// Whether pictures of an earlier film are removed from a folder that this film does not replace; otherwise they are an error.
    pub removes_stale: bool,
}

/// A request whose moments are computed: the animation has no more errors.
pub struct PlannedRender<'a> {
    request: RenderRequest<'a>,
    viewpoint: Viewpoint,
    /// What is drawn.
    pub(super) moments: Moments,
    /// What a strobe shows besides, the earliest first.
    earlier: Vec<Moment>,
    /// What pictures compare.
    comparison: Option<PlannedComparison<'a>>,
    /// Frames of the whole film.
    film_frames: usize,
}

/// Checks, before any file is read, that a format supports a request and that its encoder is installed.
///
/// # Errors
/// [`ExportError::Format`], [`ExportError::Ffmpeg`]
pub fn check_format(
    format: &Format,
    size: Size,
    fps: Option<u32>,
    is_opaque: bool,
    output: &Path,
) -> Result<(), ExportError> {
    if let Some(problem) = format.problem([size.width, size.height], fps, !is_opaque) {
        return Err(problem.into());
    }
    match format.encoder {
        Encoder::Ffmpeg(_) => find_ffmpeg().map_err(|cause| ExportError::Ffmpeg { path: output.to_owned(), cause }),
        Encoder::Still(_) | Encoder::Film(_) => Ok(()),
    }
}

/// The frames a second that the shutter of single pictures is counted by.
const STILLS_A_SECOND: u32 = 30;

/// The most pixels of a contact sheet: all of them are in memory at once, twice.
const MOST_SHEET_PIXELS: u64 = 1 << 26;

/// Finds out, before any memory is taken, whether a contact sheet of pictures of a size can be made.
///
/// # Errors
/// [`ExportError::SheetTooLarge`]
pub fn check_sheet(grid: Grid, size: Size) -> Result<(), ExportError> {
    let width = u64::from(grid.columns) * u64::from(size.width);
    let height = u64::from(grid.rows) * u64::from(size.height);
    if width.saturating_mul(height) > MOST_SHEET_PIXELS {
        return Err(ExportError::SheetTooLarge { width, height, limit: MOST_SHEET_PIXELS });
    }
    Ok(())
}

impl<'a> RenderRequest<'a> {
    /// Computes the moments.
    ///
    /// # Errors
    /// [`ExportError`]: an eye, a key time, a keyframe or a frame that does not exist, or nothing that moves.
    pub fn plan(self) -> Result<PlannedRender<'a>, ExportError> {
        let viewpoint = Viewpoint::named(self.camera, self.source.scene)?;
        let whole = match self.subject {
            Subject::Picture { at, keyframe } => {
                Moments::of_picture(self.source.shown(at, keyframe)?, self.span.seconds)
            }
            Subject::Sheet(grid) => Moments::of_sheet(self.span, self.source, grid)?,
            Subject::Strobe(columns) => Moments::of_sheet(self.span, self.source, Grid { columns, rows: 1 })?,
            Subject::Film { fps } => Moments::of_film(self.span, self.source, viewpoint, fps)?,
        };
        let film_frames = whole.all.len();
        let moments = match (self.subject, self.frames) {
            (Subject::Film { fps }, Some(frames)) => {
                let outside = |frame| ExportError::NoFrame {
                    source_name: self.source.name(),
                    frame,
                    last: film_frames.saturating_sub(1),
                    fps,
                };
                whole.with_numbers(&frames.of_film(film_frames).map_err(outside)?)
            }
            _ => whole,
        };
        let (mut moments, mut earlier) = (moments, Vec::new());
        if matches!(self.subject, Subject::Strobe(_)) {
            let last = moments.all.split_off(moments.all.len().saturating_sub(1));
            earlier = std::mem::replace(&mut moments.all, last);
        }
        let plan = |comparison| PlannedComparison::new(comparison, self.source, self.span, self.subject);
        let comparison = self.comparison.map(plan).transpose()?;
        Ok(PlannedRender { request: self, viewpoint, moments, earlier, comparison, film_frames })
    }
}

impl PlannedRender<'_> {
    /// Frames that are drawn, before those are left out that are there.
    #[must_use]
    pub fn frame_count(&self) -> usize {
        self.moments.all.len()
    }

    /// The size of the pictures that a painter's are, or are arranged in.
    #[must_use]
    pub fn size(&self, painter: &Painter) -> Size {
        self.comparison.as_ref().map_or_else(|| painter.size(), PlannedComparison::size)
    }

    /// The first frame, at the size of the painter's pictures.
    ///
    /// # Errors
    /// [`ExportError`]
    pub fn first_frame(&self, painter: &Painter) -> Result<Frame, ExportError> {
        self.stage(painter)?.frame(&self.moments.all[0])
    }

    /// Draws and writes everything. `watch` is called for each frame of a film or contact sheet and may cancel; `written` is called for
    /// each single picture, including the frames of a folder.
    ///
    /// # Errors
    /// [`ExportError`]
    pub fn write(
        &self,
        painter: &mut Painter,
        watch: &mut Watch<'_>,
        written: &mut Written<'_>,
    ) -> Result<(), ExportError> {
        let RenderRequest { subject, format, output, is_opaque, .. } = self.request;
        let size = self.size(painter);
        let (stage, compared);
        let scenery = if let Some(comparison) = &self.comparison {
            compared = comparison.compared(|| self.stage(painter))?;
            Scenery::Compared(&compared)
        } else {
            stage = self.stage(painter)?;
            Scenery::Stage(&stage)
        };
        let mut drawing = Drawing { scenery, moments: &self.moments, painter };
        match (subject, &format.encoder) {
            (Subject::Film { .. }, Encoder::Still(still)) => {
                clear_folder(output, format.ending, self.film_frames, self.request.removes_stale)?;
                let missing;
                if self.request.only_missing {
                    let numbers: Vec<usize> = self.moments.all.iter().map(|moment| moment.number).collect();
                    missing = self.moments.with_numbers(&missing_frames(output, format.ending, *still, size, &numbers));
                    drawing.moments = &missing;
                }
                write_folder(output, format.ending, still.start, &mut drawing, watch, written)
            }
            (Subject::Film { fps }, Encoder::Film(film)) => {
                write_film(output, *film, self.moments.plan(size, fps, is_opaque)?, &mut drawing, watch)
            }
            (Subject::Film { fps }, Encoder::Ffmpeg(film)) => {
                write_through_ffmpeg(output, *film, self.moments.plan(size, fps, is_opaque)?, &mut drawing, watch)
            }
            (Subject::Sheet(grid), Encoder::Still(still)) => {
                let bytes = sheet(grid, still.start, &mut drawing, watch)?;
                write_picture(output, &bytes, written)
            }
            (Subject::Picture { .. } | Subject::Strobe(_), Encoder::Still(still)) => {
                let (moment, start) = (&self.moments.all[0], |size| (still.start)(Some(size)));
                let bytes = match scenery {
                    Scenery::Stage(stage) => drawing.painter.encoded(&Exposed::of_stage(stage, moment)?, start)?,
                    Scenery::Compared(_) => {
                        let mut encoder = start([size.width, size.height]);
                        encoder.encode(&scenery.image(drawing.painter, moment)?.rows())?;
                        encoder.into_bytes()
                    }
                };
                write_picture(output, &bytes, written)
            }
            (
                Subject::Picture { .. } | Subject::Strobe(_) | Subject::Sheet(_),
                Encoder::Film(_) | Encoder::Ffmpeg(_),
            ) => Err(FormatProblem::NoPicture.into()),
        }
    }

    /// What the encoder of its film is told.
    ///
    /// # Errors
    /// [`ExportError`]
    pub(super) fn film_plan(&self, painter: &Painter) -> Result<Plan, ExportError> {
        let fps = if let Subject::Film { fps } = self.request.subject { fps } else { STILLS_A_SECOND };
        self.moments.plan(self.size(painter), fps, self.request.is_opaque)
    }

    pub(super) fn stage(&self, painter: &Painter) -> Result<Stage<'_>, ExportError> {
        let RenderRequest { source, ghosts, exposure, subject, .. } = &self.request;
        let mut stage = Stage::new(*source, self.viewpoint, *ghosts, painter.size_px());
        let fps = if let Subject::Film { fps } = subject { *fps } else { STILLS_A_SECOND };
        stage.expose(exposure, fps, self.film_frames)?;
        stage.strobe(&self.earlier);
        Ok(stage)
    }
}

/// Writes one picture to its file.
///
/// # Errors
/// [`ExportError::Unwritten`]
pub fn write_picture(path: &Path, bytes: &[u8], written: &mut Written<'_>) -> Result<(), ExportError> {
    storage::write_unsynced(path, bytes).map_err(|cause| unwritten(path, cause))?;
    written(path, bytes);
    Ok(())
}

fn sheet(
    grid: Grid,
    start: StartStill,
    drawing: &mut Drawing<'_>,
    watch: &mut Watch<'_>,
) -> Result<Vec<u8>, ExportError> {
    let mut cells = Vec::new();
    let moments = drawing.moments;
    drawing.draw(watch, |index, drawn| {
        cells.push(Cell { picture: drawn.rows().to_image(), caption: moments.all[index].caption() });
        Ok(())
    })?;
    let mut encoder = start(None);
    encoder.encode(&contact_sheet(grid, &cells).rows())?;
    Ok(encoder.into_bytes())
}
