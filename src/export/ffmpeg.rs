//! MP4 through the user's ffmpeg.

use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::Path;
use std::process::{Command, ExitStatus};
use std::time::Duration;

use thiserror::Error;

use super::child::{Running, Unended};
use crate::film::written_endings;
use crate::text::system_words;
use crate::words::{Message, display_by_message, one_of, texts};

/// How long ffmpeg may make no progress while it is waited for.
const PATIENCE: Duration = Duration::from_mins(1);

/// Why ffmpeg made no film.
#[derive(Debug, Error)]
pub enum FfmpegError {
    /// It is not installed.
    Missing,
    /// It does not start.
    Start(#[source] io::Error),
    /// It exited with an error.
    Ended {
        /// How.
        status: ExitStatus,
        /// The last line of its standard error.
        said: Option<String>,
    },
    /// It exited without an error before it had read all pictures.
    Early {
        /// The last line of its standard error.
        said: Option<String>,
    },
    /// It made no progress, and was ended.
    Hung {
        /// For so long.
        patience: Duration,
        /// The last line of its standard error.
        said: Option<String>,
    },
    /// Waiting for it failed.
    Wait(#[source] io::Error),
    /// Nobody wants the film any more.
    Cancelled,
}

display_by_message!(FfmpegError);

impl FfmpegError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        let (problem, said) = match self {
            Self::Missing => {
                let [_, films, _] = written_endings();
                let films: Vec<String> = films.iter().map(|ending| format!(".{ending}")).collect();
                (texts::export_no_ffmpeg(one_of(&films)), &None)
            }
            Self::Start(error) => (texts::export_ffmpeg_not_started(system_words(error)), &None),
            Self::Ended { status, said } => (texts::export_ffmpeg_ended(status.to_string()), said),
            Self::Early { said } => (texts::EXPORT_FFMPEG_EARLY.into(), said),
            Self::Hung { patience, said } => (texts::export_ffmpeg_hung(patience.as_secs().to_string()), said),
            Self::Wait(error) => (texts::export_ffmpeg_lost(system_words(error)), &None),
            Self::Cancelled => (texts::EXPORT_INTERRUPTED.into(), &None),
        };
        match said {
            Some(said) => texts::export_ffmpeg_said(problem, said),
            None => problem,
        }
    }
}

/// Checks that ffmpeg is installed.
///
/// # Errors
/// [`FfmpegError::Missing`] if it is not; [`FfmpegError::Hung`]
pub fn find_ffmpeg() -> Result<(), FfmpegError> {
    let mut ffmpeg = Ffmpeg::run(OsStr::new("ffmpeg"), [OsStr::new("-version")], PATIENCE);
    match ffmpeg.as_mut().map(|ffmpeg| ffmpeg.finish(|| true)) {
        Ok(Ok(())) => Ok(()),
        Ok(Err(error @ FfmpegError::Hung { .. })) => Err(error),
        _ => Err(FfmpegError::Missing),
    }
}

/// The user's ffmpeg, which takes a Y4M on its standard input. When it is dropped it is ended.
pub struct Ffmpeg {
    process: Running,
    patience: Duration,
}

impl Ffmpeg {
    /// Starts ffmpeg, which writes to `output`. The pictures are in the matrix of BT.709: the filter says so of what is read, so that no
    /// version converts it, and the options say so of what is written.
    ///
    /// # Errors
    /// [`FfmpegError::Start`]
    pub fn start(output: &Path) -> Result<Self, FfmpegError> {
        const BEFORE: &str = "-v error -nostats -progress pipe:1 -y -f yuv4mpegpipe -i - -an -c:v libx264 -crf 18 -pix_fmt yuv420p \
                              -vf setparams=range=tv:color_primaries=bt709:color_trc=bt709:colorspace=bt709 \
                              -colorspace bt709 -color_primaries bt709 -color_trc bt709 -color_range tv \
                              -movflags +faststart -f mp4";
        let arguments = BEFORE.split_whitespace().map(OsStr::new).chain([output.as_os_str()]);
        Self::run(OsStr::new("ffmpeg"), arguments, PATIENCE).map_err(FfmpegError::Start)
    }

    fn run<'a>(
        program: &OsStr,
        arguments: impl IntoIterator<Item = &'a OsStr>,
        patience: Duration,
    ) -> io::Result<Self> {
        let process = Running::start(Command::new(program).args(arguments), patience)?;
        Ok(Self { process, patience })
    }

    /// What ends it at any moment.
    pub fn killer(&self) -> impl Fn() + Send + Sync + use<> {
        self.process.killer()
    }

    /// Ends its input and waits for it to exit, as long as `goes_on`.
    ///
    /// # Errors
    /// [`FfmpegError`]
    pub fn finish(&mut self, goes_on: impl FnMut() -> bool) -> Result<(), FfmpegError> {
        self.process.close_input();
        match self.process.wait(goes_on) {
            Ok(status) if status.success() => Ok(()),
            Ok(status) => Err(FfmpegError::Ended { status, said: self.process.last_words() }),
            Err(Unended::Hung) => Err(FfmpegError::Hung { patience: self.patience, said: self.process.last_words() }),
            Err(Unended::Cancelled) => Err(FfmpegError::Cancelled),
            Err(Unended::System(error)) => Err(FfmpegError::Wait(error)),
        }
    }

    /// The same after it has stopped reading.
    ///
    /// # Errors
    /// [`FfmpegError`], always.
    pub fn stopped_reading(&mut self, goes_on: impl FnMut() -> bool) -> FfmpegError {
        match self.finish(goes_on) {
            Ok(()) => FfmpegError::Early { said: self.process.last_words() },
            Err(error) => error,
        }
    }
}

impl Write for Ffmpeg {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.process.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.process.flush()
    }
}

#[cfg(test)]
#[cfg(unix)]
mod tests {
    use super::*;

    /// A stand-in for ffmpeg that is a script of the shell.
    fn stand_in(script: &str, patience: Duration) -> Ffmpeg {
        Ffmpeg::run(OsStr::new("sh"), ["-c", script].map(OsStr::new), patience).unwrap()
    }

    const SHORT: Duration = Duration::from_millis(300);

    #[track_caller]
    fn fails(script: &str, expected: &str) {
        let mut ffmpeg = stand_in(script, SHORT);
        let mut outcome = Ok(());
        // More than a pipe holds.
        while outcome.is_ok() {
            outcome = ffmpeg.write_all(&vec![0; 1 << 16]);
        }
        assert_eq!(ffmpeg.stopped_reading(|| true).to_string(), expected);
    }

    #[test]
    fn one_that_does_not_read_is_ended_and_named() {
        fails("sleep 1000", "ffmpeg made no progress for 0 s, and was ended");
        fails(
            "echo old >&2; echo 'no more disk' >&2; sleep 1000 & sleep 1000",
            "ffmpeg made no progress for 0 s, and was ended; it said: no more disk",
        );
    }

    #[test]
    fn one_that_ends_early_is_named_with_its_last_words() {
        fails("echo bad codec >&2; exit 7", "ffmpeg ended with exit status: 7; it said: bad codec");
        fails("kill -9 $$", "ffmpeg ended with signal: 9 (SIGKILL)");
        fails("exit 0", "ffmpeg ended before it had read all pictures");
    }

    #[test]
    fn one_that_reads_slowly_or_says_how_far_it_is_does_not_hang() {
        let mut ffmpeg =
            stand_in("for i in 1 2 3 4; do sleep 0.1; head -c 65536 > /dev/null; done; cat > /dev/null", SHORT);
        for _ in 0..6 {
            ffmpeg.write_all(&vec![0; 1 << 16]).unwrap();
        }
        ffmpeg.finish(|| true).unwrap();
        let mut ffmpeg = stand_in("cat > /dev/null; for i in 1 2 3 4 5 6; do sleep 0.1; echo frame=$i; done", SHORT);
        ffmpeg.finish(|| true).unwrap();
        let mut ffmpeg = stand_in("cat > /dev/null; while sleep 0.1; do echo frame=1; done", SHORT);
        assert!(matches!(ffmpeg.finish(|| true), Err(FfmpegError::Hung { .. })));
    }

    #[test]
    fn it_is_ended_when_nobody_wants_it() {
        let mut ffmpeg = stand_in("sleep 1000", PATIENCE);
        let killer = ffmpeg.killer();
        assert!(matches!(ffmpeg.finish(|| false), Err(FfmpegError::Cancelled)));
        killer();
        assert!(matches!(ffmpeg.finish(|| true), Err(FfmpegError::Ended { .. })));
    }
}
