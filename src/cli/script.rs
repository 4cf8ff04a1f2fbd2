//! `inbetween script`: hotkeys and gestures out of a text file.

use std::io::{self, BufWriter, StdoutLock, Write as _};
use std::path::Path;

use super::arguments::ScriptArguments;
use super::{CliError, output};
use crate::editor::Editor;
use crate::export::Painter;
use crate::files::{self, FileError, scene};
use crate::journal::{self, Journaled, Writer};
use crate::scene::SceneGraph;
use crate::script::{self, Disk, Line, Runner, TraceLine, state_json};
use crate::storage::{self, Log};

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
    let is_journal = journal::is_journal(&bytes);
    let lines = if is_journal { Vec::new() } else { parsed(&location, &bytes, &scene)? };
    let takes_pictures = lines.iter().any(Line::takes_screenshot);
    let painter = takes_pictures.then(|| Painter::headless(arguments.size, None)).transpose()?;
    let editor = scene::editor_of(scene, named_scene, arguments.keyframes.clone());
    let kept = arguments.journal.as_deref().map(|path| begin_journal(path, &editor)).transpose()?;
    let disk = Disk::new(editor, painter).overwriting(arguments.overwrite);
    let host = Journaled::new(disk, kept).panicking_at(arguments.panic_at);
    let mut trace = Trace::new(arguments.trace);
    let mut damage = None;
    let ended = if is_journal {
        let mut runner = Runner::new(host);
        let played = journal::play(&bytes, &mut runner, |line, message, runner| {
            trace.line(&TraceLine { line, message, state: runner.state() })
        });
        played.map(|played| {
            damage = played.damage;
            runner.into_host()
        })
    } else {
        Runner::new(host).run(&lines, |line| trace.line(line))
    };
    // Also where the script stopped, its trace is printed up to there.
    let traced = trace.finish();
    let host = ended?;
    let journal = arguments.journal.as_deref().unwrap_or(Path::new(""));
    let (editor, refused) = host.finish().map_err(|error| CliError::unwritten(journal, error))?.finish();
    traced?;
    if let Some(path) = &arguments.state {
        files::write(path, state_json(&editor).as_bytes())?;
    }
    let mut sentences: Vec<String> = refused.iter().map(ToString::to_string).collect();
    if let Some((number, problem)) = damage {
        sentences.push(format!("{location}: line {number}: {problem}; what comes after it is lost"));
    }
    if sentences.is_empty() { Ok(()) } else { Err(CliError::bad_inputs(sentences)) }
}

fn parsed(location: &str, bytes: &[u8], scene: &SceneGraph) -> Result<Vec<Line>, CliError> {
    Ok(script::parse(bytes, scene).map_err(|problems| FileError::all(location, problems))?)
}

fn begin_journal(path: &Path, editor: &Editor) -> Result<Writer, CliError> {
    let log = Log::create(path, journal::is_journal).map_err(|error| CliError::unwritten(path, error))?;
    Ok(Writer::begin(log, editor))
}

fn read(file: &Path) -> (String, Result<Vec<u8>, storage::StorageError>) {
    if file == Path::new("-") {
        ("standard input".to_owned(), storage::read_stream(io::stdin().lock(), LARGEST_SCRIPT_BYTES, 0))
    } else {
        let limit = if storage::begins_with(file, journal::is_journal) {
            journal::LARGEST_READ_BYTES
        } else {
            LARGEST_SCRIPT_BYTES
        };
        (file.display().to_string(), storage::read(file, limit))
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
