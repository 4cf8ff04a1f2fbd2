//! MP4 through the user's ffmpeg.

use std::io::{self, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};

use super::ExportError;
use crate::words::{Message, texts};

/// Whether there is an ffmpeg to make an MP4.
///
/// # Errors
/// [`ExportError::BadInput`] with what to do.
pub fn find_ffmpeg(path: &Path) -> Result<(), ExportError> {
    let found = Command::new("ffmpeg")
        .arg("-version")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success());
    if found { Ok(()) } else { Err(ExportError::bad_input(path.display(), texts::EXPORT_NO_FFMPEG)) }
}

/// The user's ffmpeg, which takes a Y4M on its standard input.
pub struct Ffmpeg {
    child: Child,
    input: Option<ChildStdin>,
}

impl Ffmpeg {
    /// Starts it; it writes to `output`. `path` is what errors name.
    ///
    /// # Errors
    /// [`ExportError::BadInput`]
    pub fn start(path: &Path, output: &Path) -> Result<Self, ExportError> {
        let mut child = Command::new("ffmpeg")
            .args(["-v", "error", "-y", "-f", "yuv4mpegpipe", "-i", "-", "-an", "-c:v", "libx264", "-crf", "18"])
            .args(["-pix_fmt", "yuv420p", "-colorspace", "smpte170m", "-color_primaries", "bt709"])
            .args(["-color_trc", "iec61966-2-1", "-color_range", "tv", "-movflags", "+faststart", "-f", "mp4"])
            .arg(output)
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .spawn()
            .map_err(|error| {
                ExportError::bad_input(path.display(), texts::export_ffmpeg_not_started(error.to_string()))
            })?;
        let input = child.stdin.take();
        Ok(Self { child, input })
    }

    /// Ends it at once.
    pub fn stop(&mut self) {
        self.input = None;
        // It may have ended by itself.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }

    /// Waits for ffmpeg to end by itself; it says on standard error what goes wrong.
    ///
    /// # Errors
    /// [`ExportError::BadInput`]: it did not end well.
    pub fn finish(&mut self, path: &Path) -> Result<(), ExportError> {
        self.input = None;
        let failed = |problem: Message| Err(ExportError::bad_input(path.display(), problem));
        match self.child.wait() {
            Ok(status) if status.success() => Ok(()),
            Ok(status) => failed(texts::export_ffmpeg_ended(status.to_string())),
            Err(error) => failed(texts::export_ffmpeg_lost(error.to_string())),
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
