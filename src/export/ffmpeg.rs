//! MP4 through the user's ffmpeg.

use std::io::{self, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, ExitStatus, Stdio};

use thiserror::Error;

use crate::film::written_endings;
use crate::text::system_words;
use crate::words::{Message, display_by_message, one_of, texts};

/// Why ffmpeg made no film.
#[derive(Debug, Error)]
pub enum FfmpegError {
    /// It is not installed.
    Missing,
    /// It does not start.
    Start(#[source] io::Error),
    /// It exited with an error, which it printed on standard error.
    Ended(ExitStatus),
    /// Waiting for it failed.
    Wait(#[source] io::Error),
}

display_by_message!(FfmpegError);

impl FfmpegError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Missing => {
                let [_, films, _] = written_endings();
                let films: Vec<String> = films.iter().map(|ending| format!(".{ending}")).collect();
                texts::export_no_ffmpeg(one_of(&films))
            }
            Self::Start(error) => texts::export_ffmpeg_not_started(system_words(error)),
            Self::Ended(status) => texts::export_ffmpeg_ended(status.to_string()),
            Self::Wait(error) => texts::export_ffmpeg_lost(system_words(error)),
        }
    }
}

/// Checks that ffmpeg is installed.
///
/// # Errors
/// [`FfmpegError::Missing`] if it is not.
pub fn find_ffmpeg() -> Result<(), FfmpegError> {
    let found = Command::new("ffmpeg")
        .arg("-version")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success());
    if found { Ok(()) } else { Err(FfmpegError::Missing) }
}

/// The user's ffmpeg, which takes a Y4M on its standard input.
pub struct Ffmpeg {
    child: Child,
    input: Option<ChildStdin>,
}

impl Ffmpeg {
    /// Starts ffmpeg, which writes to `output`.
    ///
    /// # Errors
    /// [`FfmpegError::Start`]
    pub fn start(output: &Path) -> Result<Self, FfmpegError> {
        let mut child = Command::new("ffmpeg")
            .args(["-v", "error", "-y", "-f", "yuv4mpegpipe", "-i", "-", "-an", "-c:v", "libx264", "-crf", "18"])
            .args(["-pix_fmt", "yuv420p", "-colorspace", "smpte170m", "-color_primaries", "bt709"])
            .args(["-color_trc", "iec61966-2-1", "-color_range", "tv", "-movflags", "+faststart", "-f", "mp4"])
            .arg(output)
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .spawn()
            .map_err(FfmpegError::Start)?;
        let input = child.stdin.take();
        Ok(Self { child, input })
    }

    /// Kills ffmpeg.
    pub fn stop(&mut self) {
        self.input = None;
        // It may have exited already.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }

    /// Waits for ffmpeg to exit. Its errors are on standard error.
    ///
    /// # Errors
    /// [`FfmpegError::Ended`], [`FfmpegError::Wait`]
    pub fn finish(&mut self) -> Result<(), FfmpegError> {
        self.input = None;
        match self.child.wait() {
            Ok(status) if status.success() => Ok(()),
            Ok(status) => Err(FfmpegError::Ended(status)),
            Err(error) => Err(FfmpegError::Wait(error)),
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
