//! Standard output and standard error.

use std::io::{self, BufWriter, Write};

use super::CliError;

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

/// Writes lines to standard error. A closed one is ignored.
pub fn complain(lines: &str) {
    let _ = writeln!(io::stderr().lock(), "{lines}");
}
