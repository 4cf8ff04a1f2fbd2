//! `inbetween script`: hotkeys and gestures out of a text file.

use std::io::{self, BufWriter, StdoutLock, Write as _};
use std::path::Path;

use super::arguments::ScriptArguments;
use super::{CliError, output};
use crate::export::Painter;
use crate::files::{self, FileError, scene};
use crate::script::{self, Disk, Line, Runner, TraceLine, state_json};
use crate::storage;

/// The largest script that is read: 16 MiB.
const LARGEST_SCRIPT_BYTES: u64 = 16 << 20;

/// Reads a script whole, then runs it.
///
/// # Errors
/// [`CliError`]: bad lines before anything has run, a missing GPU adapter if the script needs one, a file that cannot be written.
pub fn run(arguments: &ScriptArguments, named_scene: Option<&Path>) -> Result<(), CliError> {
    let scene = scene::load(named_scene)?;
    let (location, bytes) = read(&arguments.file);
    let bytes = bytes.map_err(|error| FileError::new(&location, error))?;
    let lines = script::parse(&bytes, &scene).map_err(|problems| FileError::all(&location, problems))?;
    let takes_pictures = lines.iter().any(Line::takes_screenshot);
    let painter = takes_pictures.then(|| Painter::headless(arguments.size, None)).transpose()?;
    let editor = scene::editor_of(scene, named_scene, arguments.keyframes.clone());
    let mut trace = Trace::new(arguments.trace);
    let ended = Runner::new(Disk::new(editor, painter)).run(&lines, |line| trace.line(line));
    // Also where the script stopped, its trace is printed up to there.
    let traced = trace.finish();
    let editor = ended?.into_editor();
    traced?;
    if let Some(path) = &arguments.state {
        files::write(path, state_json(&editor).as_bytes())?;
    }
    Ok(())
}

fn read(file: &Path) -> (String, Result<Vec<u8>, storage::StorageError>) {
    if file == Path::new("-") {
        ("standard input".to_owned(), storage::read_stream(io::stdin().lock(), LARGEST_SCRIPT_BYTES, 0))
    } else {
        (file.display().to_string(), storage::read(file, LARGEST_SCRIPT_BYTES))
    }
}

/// The trace on standard output, where one is asked for. When its reader leaves, the script goes on without.
struct Trace {
    output: Option<BufWriter<StdoutLock<'static>>>,
}

impl Trace {
    fn new(is_asked_for: bool) -> Self {
        Self { output: is_asked_for.then(output::standard_output) }
    }

    fn line(&mut self, line: &TraceLine<'_>) -> Result<(), CliError> {
        self.try_to(|output| output.write_all(line.json().as_bytes()))
    }

    fn finish(&mut self) -> Result<(), CliError> {
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
                if error.kind() == io::ErrorKind::BrokenPipe { Ok(()) } else { Err(CliError::standard_output(error)) }
            }
        }
    }
}
