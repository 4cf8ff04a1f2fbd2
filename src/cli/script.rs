//! `inbetween script`: hotkeys and gestures out of a text file.

use std::io::{self, BufWriter, StdoutLock, Write as _};
use std::path::Path;

use super::arguments::ScriptArguments;
use super::places::Places;
use super::{CliError, Common, Ended, misuse, output};
use crate::editor::{Command, Editor, FileCommand};
use crate::export::Painter;
use crate::files::{self, FileError, scene};
use crate::journal::{self, Journaled, Writer};
use crate::scene::SceneGraph;
use crate::script::{self, Action, Disk, Line, Runner, Step, TraceLine, state_json};
use crate::storage::{self, Log};
use crate::words::texts;

/// The largest script that is read: 16 MiB.
const LARGEST_SCRIPT_BYTES: u64 = 16 << 20;

/// The most lines without sense that are shown. A file that is no script has nothing else.
const MOST_PROBLEMS: usize = 5;

/// Reads a script whole, then runs it.
///
/// # Errors
/// [`CliError`]: bad lines before anything has run, a missing GPU adapter if the script needs one, a file that cannot be written.
pub fn run(arguments: &ScriptArguments, common: Common<'_>) -> Result<Ended, CliError> {
    let named_scene = common.scene;
    if arguments.journal.as_deref().is_some_and(storage::is_standard) {
        return Err(misuse(&texts::places_needs_a_file("--journal").to_string()));
    }
    places(arguments, named_scene, &[]).check()?;
    let scene = scene::load(named_scene)?;
    let location = storage::input_name(&arguments.file);
    let bytes = storage::read(&arguments.file, limit(&arguments.file));
    let bytes = bytes.map_err(|error| FileError::storage(&location, error))?;
    let is_journal = journal::is_journal(&bytes);
    let lines = if is_journal { Vec::new() } else { parsed(&location, &bytes, &scene)? };
    places(arguments, named_scene, &lines).check()?;
    let takes_pictures = lines.iter().any(Line::takes_screenshot);
    let painter = takes_pictures.then(|| Painter::headless(arguments.size, None)).transpose()?;
    let editor = scene::editor_of(scene, named_scene, arguments.keyframes.clone());
    let kept = arguments.journal.as_deref().map(|path| begin_journal(path, &editor)).transpose()?;
    let disk = Disk::new(editor, painter).overwriting(arguments.overwrite);
    let host = Journaled::new(disk, kept).panicking_at(arguments.panic_at);
    let mut observer = Observer::new(arguments, &location);
    let mut damage = None;
    let ended = if is_journal {
        let mut runner = Runner::new(host);
        let played = journal::play(&bytes, &mut runner, |line, step, runner| {
            let Step { message, is_refusal, .. } = step;
            observer.line(&TraceLine { line, message, is_refusal, state: runner.state() })
        });
        played.map(|played| {
            damage = played.damage;
            runner.into_host()
        })
    } else {
        Runner::new(host).run(&lines, |line| observer.line(line))
    };
    // Also where the script stopped, its trace is printed up to there.
    let traced = observer.trace.finish();
    let host = ended?;
    let journal = arguments.journal.as_deref().unwrap_or(Path::new(""));
    let (editor, refused) = host.finish().map_err(|error| CliError::unwritten(journal, error))?.finish();
    traced?;
    if let Some(path) = &arguments.state {
        files::write(path, state_json(&editor).as_bytes())?;
    }
    // Without a trace each was said at its line.
    let unsaid = if arguments.trace { refused.as_slice() } else { &[] };
    let mut sentences: Vec<String> = unsaid.iter().map(ToString::to_string).collect();
    if let Some((number, problem)) = damage {
        sentences.push(format!("{location}: line {number}: {problem}; what comes after it is lost"));
    }
    if !sentences.is_empty() {
        return Err(CliError::bad_inputs(sentences));
    }
    Ok(if refused.is_empty() { Ended::Well } else { Ended::Beyond })
}

fn parsed(location: &str, bytes: &[u8], scene: &SceneGraph) -> Result<Vec<Line>, CliError> {
    script::parse(bytes, scene).map_err(|problems| {
        let more = problems.len().saturating_sub(MOST_PROBLEMS);
        let shown = problems.iter().take(MOST_PROBLEMS).map(|problem| format!("{location}: {problem}"));
        let rest = (more > 0).then(|| format!("{location}: {}", texts::script_more_problems(more)));
        CliError::bad_inputs(shown.chain(rest).collect())
    })
}

fn begin_journal(path: &Path, editor: &Editor) -> Result<Writer, CliError> {
    let log = Log::create(path, journal::is_journal).map_err(|error| CliError::unwritten(path, error))?;
    Ok(Writer::begin(log, editor))
}

/// As many bytes are read: of a journal as many as one may have.
fn limit(file: &Path) -> u64 {
    if !storage::is_standard(file) && storage::begins_with(file, journal::is_journal) {
        journal::LARGEST_READ_BYTES
    } else {
        LARGEST_SCRIPT_BYTES
    }
}

/// Where a script reads and writes. What a line reads and writes again is no conflict: it is done in order.
fn places(arguments: &ScriptArguments, scene: Option<&Path>, lines: &[Line]) -> Places {
    const KEYFRAMES: &str = "--keyframes";
    const SCENE: &str = "--scene";
    let mut places = Places::with_scene(scene).reads("FILE", &arguments.file);
    let outputs = [("--state", &arguments.state), ("--journal", &arguments.journal)];
    for (name, path) in outputs.into_iter().filter_map(|(name, path)| Some((name, path.as_deref()?))) {
        places = places.writes(name, path);
    }
    if arguments.trace {
        places = places.prints("--trace");
    }
    let mut keyframes = arguments.keyframes.as_path();
    if !storage::is_standard(keyframes) {
        places = places.writes(KEYFRAMES, keyframes);
    } else if arguments.state.as_deref().is_some_and(storage::is_standard) {
        // Also where no line writes it: what is meant is not known.
        return places.writes(KEYFRAMES, keyframes);
    }
    for line in lines {
        let Action::Apply(Command::File(command)) = &line.action else { continue };
        let name = || format!("line {} ({})", line.number, line.text);
        places = match command {
            FileCommand::Import => places.reads_as(name(), KEYFRAMES, keyframes),
            FileCommand::Open(path) => {
                keyframes = path;
                places.reads_as(name(), KEYFRAMES, path)
            }
            FileCommand::Write => places.writes_as(name(), KEYFRAMES, keyframes),
            FileCommand::SaveAs(path) => {
                keyframes = path;
                places.writes_as(name(), KEYFRAMES, path)
            }
            FileCommand::SaveSceneAs(path) => places.writes_as(name(), SCENE, path),
            FileCommand::Screenshot { path: Some(path), .. } => places.writes_as(name(), "screenshot", path),
            _ => places,
        };
    }
    places
}

/// Hears of each line that was done.
struct Observer<'a> {
    trace: Trace,
    /// The script's name.
    location: &'a str,
    has_trace: bool,
    is_strict: bool,
}

impl<'a> Observer<'a> {
    fn new(arguments: &ScriptArguments, location: &'a str) -> Self {
        let ScriptArguments { trace, strict, .. } = *arguments;
        Self { trace: Trace::new(trace), location, has_trace: trace, is_strict: strict }
    }

    /// Prints the line's trace. A refusal is an error in strict mode; elsewhere, the trace or standard error has it.
    fn line(&mut self, line: &TraceLine<'_>) -> Result<(), CliError> {
        self.trace.line(line)?;
        if line.is_refusal {
            let location = format!("{}: line {}", self.location, line.line.number);
            if self.is_strict {
                return Err(CliError::bad_input(location, &line.message));
            }
            if !self.has_trace {
                output::complain(&format!("{location}: {}", line.message));
            }
        }
        Ok(())
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
