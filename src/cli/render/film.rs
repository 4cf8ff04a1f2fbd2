//! Films and folders of frames: drawn on one thread, encoded and written on another.

use std::io::{self, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};

use super::super::CliError;
use super::super::interrupt::Interrupt;
use super::super::picture::Painter;
use super::manifest::Manifest;
use super::moments::Moments;
use super::target::Target;
use super::{Stage, pipeline};
use crate::film::{Film, FilmError, Format, Palette, Plan};
use crate::storage::{self, Draft, Foreign};

/// Frames that stand for a film when its palette is chosen.
const PALETTE_FRAMES: usize = 6;

/// Writes frame-00000.png and on into a folder, which is made where it is missing, and lists them in the manifest if there is one.
///
/// # Errors
/// [`CliError`]; frames that are written stay, each of them whole.
pub fn write_folder(
    folder: &Path,
    stage: &Stage<'_>,
    moments: &Moments,
    painter: &mut Painter,
    mut manifest: Option<&mut Manifest>,
) -> Result<(), CliError> {
    storage::create_folder(folder).map_err(|reason| CliError::unwritten(folder, reason))?;
    pipeline::draw(moments, stage, painter, &Interrupt::listen(), |place, image| {
        let path = folder.join(format!("frame-{place:05}.png"));
        let png = image.to_png()?;
        storage::write_unsynced(&path, &png).map_err(|reason| CliError::unwritten(&path, reason))?;
        if let Some(manifest) = &mut manifest {
            manifest.add(&path, &png);
        }
        Ok(())
    })
}

/// Writes a film beside its place and puts it there when it is whole.
///
/// # Errors
/// [`CliError`]; what stood there before is as it was.
pub fn write_film(
    path: &Path,
    target: Target,
    plan: Plan,
    stage: &Stage<'_>,
    moments: &Moments,
    painter: &mut Painter,
) -> Result<(), CliError> {
    let interrupt = Interrupt::listen();
    let unwritten = |reason| CliError::unwritten(path, reason);
    let Target::Film(format) = target else {
        let foreign = Foreign::new(path).map_err(unwritten)?;
        let mut ffmpeg = Ffmpeg::start(path, foreign.path())?;
        let written = encode(path, Format::Y4m, plan, stage, moments, painter, &interrupt, &mut ffmpeg);
        // Where ffmpeg has ended early, what it says matters more than that it takes no more pictures.
        if let Err(error @ (CliError::Interrupted | CliError::Gpu(_))) = written {
            ffmpeg.stop();
            return Err(error);
        }
        ffmpeg.finish(path)?;
        written?;
        return foreign.commit().map_err(unwritten);
    };
    let mut draft = Draft::new(path).map_err(unwritten)?;
    encode(path, format, plan, stage, moments, painter, &interrupt, &mut draft)?;
    draft.commit().map_err(unwritten)
}

#[expect(clippy::too_many_arguments, reason = "each is one thing, and they meet here alone")]
fn encode(
    path: &Path,
    format: Format,
    plan: Plan,
    stage: &Stage<'_>,
    moments: &Moments,
    painter: &mut Painter,
    interrupt: &Interrupt,
    output: &mut (dyn Write + Send),
) -> Result<(), CliError> {
    let failed = |reason: FilmError| CliError::Film { path: path.to_owned(), reason };
    let palette = if format == Format::Gif { palette(stage, moments, painter)? } else { Palette::of(&[]) };
    let mut film = Film::new(format, plan, palette, output).map_err(failed)?;
    pipeline::draw(moments, stage, painter, interrupt, |place, image| {
        film.push(&image, moments.all[place].start_ms, moments.end_ms(place)).map_err(failed)
    })?;
    interrupt.check()?;
    film.finish().map_err(failed)
}

/// The palette of a few frames, evenly spread over the film.
fn palette(stage: &Stage<'_>, moments: &Moments, painter: &mut Painter) -> Result<Palette, CliError> {
    let step = moments.all.len().div_ceil(PALETTE_FRAMES).max(1);
    let pictures: Result<Vec<_>, CliError> = moments
        .all
        .iter()
        .skip(step / 2)
        .step_by(step)
        .chain(moments.all.last())
        .map(|moment| painter.image(&stage.frame(moment)?))
        .collect();
    Ok(Palette::of(&pictures?))
}

/// Whether there is an ffmpeg to make an MP4.
///
/// # Errors
/// [`CliError::BadInput`] with what to do.
pub fn find_ffmpeg(path: &Path) -> Result<(), CliError> {
    let found = Command::new("ffmpeg")
        .arg("-version")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success());
    if found { Ok(()) } else { Err(CliError::bad_input(path.display(), NO_FFMPEG)) }
}

const NO_FFMPEG: &str = "an MP4 is encoded by ffmpeg, and there is none on the PATH: install it (Debian: apt-get install ffmpeg), or write .gif, .apng or .y4m";

/// The user's ffmpeg, which takes a Y4M on its standard input.
struct Ffmpeg {
    child: Child,
    input: Option<ChildStdin>,
}

impl Ffmpeg {
    fn start(path: &Path, output: &Path) -> Result<Self, CliError> {
        let mut child = Command::new("ffmpeg")
            .args(["-v", "error", "-y", "-f", "yuv4mpegpipe", "-i", "-", "-an", "-c:v", "libx264", "-crf", "18"])
            .args(["-pix_fmt", "yuv420p", "-colorspace", "smpte170m", "-color_primaries", "bt709"])
            .args(["-color_trc", "iec61966-2-1", "-color_range", "tv", "-movflags", "+faststart", "-f", "mp4"])
            .arg(output)
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .spawn()
            .map_err(|error| CliError::bad_input(path.display(), format!("ffmpeg cannot be started: {error}")))?;
        let input = child.stdin.take();
        Ok(Self { child, input })
    }

    fn stop(&mut self) {
        self.input = None;
        // It may have ended by itself.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }

    /// Waits for ffmpeg to end by itself; it says on standard error what goes wrong.
    fn finish(&mut self, path: &Path) -> Result<(), CliError> {
        self.input = None;
        let failed = |problem: String| Err(CliError::bad_input(path.display(), problem));
        match self.child.wait() {
            Ok(status) if status.success() => Ok(()),
            Ok(status) => failed(format!("ffmpeg ended with {status}")),
            Err(error) => failed(format!("ffmpeg cannot be waited for: {error}")),
        }
    }
}

impl Write for Ffmpeg {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.input.as_mut().map_or(Ok(0), |input| input.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.input.as_mut().map_or(Ok(()), Write::flush)
    }
}
