//! Standard output and standard error.

use std::io::{self, BufWriter, IsTerminal as _, Write};
use std::path::Path;

use super::CliError;
use crate::storage::Place;
use crate::text::visible;

/// Standard output with a buffer that is large enough for it to keep up.
pub fn standard_output() -> BufWriter<io::StdoutLock<'static>> {
    BufWriter::with_capacity(1 << 16, io::stdout().lock())
}

/// Writes to standard output. A reader that has seen enough and closed it is no error.
///
/// # Errors
/// [`CliError`]: it does not take them.
pub fn print(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), CliError> {
    let mut output = standard_output();
    match write(&mut output).and_then(|()| output.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(CliError::standard_output(error)),
        _ => Ok(()),
    }
}

/// Writes sentences to standard output. They may quote files: what they quote does nothing to a terminal.
///
/// # Errors
/// [`CliError`]: it does not take them.
pub fn say(sentences: &str) -> Result<(), CliError> {
    print(|output| output.write_all(visible(sentences).as_bytes()))
}

/// Like [`say`]; where `data` names standard output, which has the command's data then, to standard error.
///
/// # Errors
/// [`CliError`]: it does not take them.
pub fn say_beside(data: Option<&Path>, sentences: &str) -> Result<(), CliError> {
    if data.is_some_and(|path| Place::of_output(path) == Place::Standard) {
        complain(sentences.trim_end());
        return Ok(());
    }
    say(sentences)
}

/// Writes data to standard output: as it is into a file or a pipe, as [`say`] does to a terminal.
///
/// # Errors
/// [`CliError`]: it does not take them.
pub fn list(lines: &str) -> Result<(), CliError> {
    if io::stdout().is_terminal() { say(lines) } else { print(|output| output.write_all(lines.as_bytes())) }
}

/// Writes lines to standard error; where that is closed, there is no one to tell. What they quote does nothing to a terminal.
pub fn complain(lines: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", visible(lines));
}

/// The longest line that shows what is done now, in characters: one that is wrapped could not be erased.
const LONGEST_STATUS: usize = 78;

/// Shows on standard error, if that is a terminal, what is done now, in place of what was shown so. Whether anything is shown.
pub fn show_status(text: &str) -> bool {
    let mut error = io::stderr().lock();
    let is_shown = error.is_terminal();
    if is_shown {
        let text: String = visible(text).chars().take(LONGEST_STATUS).collect();
        let _ = write!(error, "\r\u{1b}[K{text}");
    }
    is_shown
}

/// Erases what [`show_status`] shows.
pub fn clear_status() {
    let _ = write!(io::stderr().lock(), "\r\u{1b}[K");
}
