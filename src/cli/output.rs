//! What goes to standard output and standard error, and the JSON that several commands print.

use std::io::{self, BufWriter, Write};

use super::CliError;
use crate::json::push_f32s;
use crate::pose::Pose;

/// Standard output with a buffer that is large enough for it to keep up.
pub fn standard_output() -> BufWriter<io::StdoutLock<'static>> {
    BufWriter::with_capacity(1 << 16, io::stdout().lock())
}

/// Writes to standard output. A reader that has seen enough and closed it is no error.
///
/// # Errors
/// [`CliError::StandardOutput`]
pub fn print(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), CliError> {
    let mut output = standard_output();
    match write(&mut output).and_then(|()| output.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(CliError::StandardOutput(error)),
        _ => Ok(()),
    }
}

/// Writes lines to standard error; where that is closed, there is no one to tell.
pub fn complain(lines: &str) {
    let _ = writeln!(io::stderr().lock(), "{lines}");
}

/// Appends a text as JSON.
pub fn push_quoted(text: &mut String, unquoted: &str) {
    text.push_str(&serde_json::Value::from(unquoted).to_string());
}

/// Appends paths of nodes as a JSON array.
pub fn push_paths<'a>(text: &mut String, paths: impl Iterator<Item = &'a str>) {
    text.push('[');
    for (place, path) in paths.enumerate() {
        if place > 0 {
            text.push_str(", ");
        }
        push_quoted(text, path);
    }
    text.push(']');
}

/// Appends a pose as a JSON array, in the scene's order: `[{"translation": [x, y, z], "rotation": [x, y, z, w]}, …]`.
pub fn push_pose(text: &mut String, pose: &Pose) {
    text.push('[');
    for (place, rbt) in pose.iter().enumerate() {
        text.push_str(if place == 0 { "{\"translation\": " } else { ", {\"translation\": " });
        push_f32s(text, &rbt.translation.to_array());
        text.push_str(", \"rotation\": ");
        push_f32s(text, &rbt.rotation.to_array());
        text.push('}');
    }
    text.push(']');
}
