//! What a script leaves behind: a line of JSON after each command, and the state at the end.

use std::fmt::Write as _;
use std::io::{self, BufWriter, StdoutLock, Write as _};

use crate::cli::CliError;
use crate::cli::output::{push_paths, push_pose, push_quoted, standard_output};
use crate::editor::Editor;
use crate::script::Line;

/// The trace on standard output. Where its reader leaves, the script goes on without.
pub struct Trace {
    output: Option<BufWriter<StdoutLock<'static>>>,
}

impl Trace {
    /// A trace with nothing in it.
    pub fn new() -> Self {
        Self { output: Some(standard_output()) }
    }

    /// Prints what a command said and left.
    ///
    /// # Errors
    /// [`CliError::StandardOutput`]
    pub fn line(&mut self, line: &Line, message: &str, editor: &Editor) -> Result<(), CliError> {
        let text = line_json(line, message, editor);
        self.try_to(|output| output.write_all(text.as_bytes()))
    }

    /// Prints what is still in the buffer.
    ///
    /// # Errors
    /// [`CliError::StandardOutput`]
    pub fn finish(&mut self) -> Result<(), CliError> {
        self.try_to(io::Write::flush)
    }

    fn try_to(
        &mut self,
        write: impl FnOnce(&mut BufWriter<StdoutLock<'static>>) -> io::Result<()>,
    ) -> Result<(), CliError> {
        let Some(output) = &mut self.output else { return Ok(()) };
        match write(output) {
            Ok(()) => Ok(()),
            Err(error) => {
                self.output = None;
                if error.kind() == io::ErrorKind::BrokenPipe { Ok(()) } else { Err(CliError::StandardOutput(error)) }
            }
        }
    }
}

/// What a command said and left: a JSON object on a line.
pub fn line_json(line: &Line, message: &str, editor: &Editor) -> String {
    let mut text = format!("{{\"line\": {}, \"command\": ", line.number);
    push_quoted(&mut text, &line.text);
    text.push_str(", \"message\": ");
    push_quoted(&mut text, message);
    text.push_str(", ");
    push_state(&mut text, editor);
    text.push_str("}\n");
    text
}

/// The state at the end: what the trace says of it, the nodes, and the pose displayed.
pub fn state_json(editor: &Editor) -> String {
    let mut text = String::from("{");
    push_state(&mut text, editor);
    text.push_str(", \"nodes\": ");
    push_paths(&mut text, editor.scene().rbt_paths());
    text.push_str(", \"pose\": ");
    push_pose(&mut text, &editor.displayed_pose());
    text.push_str("}\n");
    text
}

/// Appends `"keyframes": …` to `"interpolation": …`, without braces.
fn push_state(text: &mut String, editor: &Editor) {
    let document = editor.document();
    let current = document.keyframes.current().map_or_else(|| "null".to_owned(), |index| index.get().to_string());
    let key_time = editor
        .key_time()
        .filter(|_| editor.is_playing())
        .map_or_else(|| "null".to_owned(), |key_time| format!("{key_time:?}"));
    let _ = write!(
        text,
        "\"keyframes\": {}, \"current\": {current}, \"playing\": {}, \"key_time\": {key_time}, \
         \"ms_between_keyframes\": {}, \"interpolation\": \"{}\"",
        document.keyframes.len(),
        editor.is_playing(),
        document.ms_between_keyframes,
        document.interpolation.name(),
    );
}
