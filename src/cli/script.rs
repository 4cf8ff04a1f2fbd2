//! `inbetween script`: hotkeys and gestures out of a text file, through the same door as the window's.

mod run;
pub(super) mod trace;

use std::io;
use std::path::Path;

use super::CliError;
use super::arguments::ScriptArguments;
use super::scene;
use crate::editor::Command;
use crate::export::Painter;
use crate::scene::SceneGraph;
use crate::script::{self, Action, Line};
use crate::storage;

/// The largest script that is read: 16 MiB.
const LARGEST_SCRIPT_BYTES: u64 = 16 << 20;

/// The lines that a script can have, as Markdown for the README.
pub use crate::script::markdown as script_lines;

/// What a script's lines ask of the editor, in order; times that they wait are left out.
///
/// # Errors
/// What is wrong with each line that cannot be understood: `line 3: "jump" is not a command; …`.
pub fn script_commands(bytes: &[u8], scene: &SceneGraph) -> Result<Vec<Command>, Vec<String>> {
    let lines =
        script::parse(bytes, scene).map_err(|problems| problems.iter().map(ToString::to_string).collect::<Vec<_>>())?;
    let commands = lines.into_iter().filter_map(|line| match line.action {
        Action::Apply(command) => Some(command),
        Action::Wait(_) => None,
    });
    Ok(commands.collect())
}

/// Reads a script whole, then runs it.
///
/// # Errors
/// [`CliError`]: bad lines before anything has run, a missing GPU adapter if the script needs one, a file that cannot be written.
pub fn run(arguments: &ScriptArguments, named_scene: Option<&Path>) -> Result<(), CliError> {
    let scene = scene::load(named_scene)?;
    let (place, bytes) = read(&arguments.file);
    let bytes = bytes.map_err(|error| CliError::bad_input(&place, error))?;
    let lines = script::parse(&bytes, &scene).map_err(|problems| CliError::BadInput {
        sentences: problems.iter().map(|problem| format!("{place}: {problem}")).collect(),
    })?;
    let painter =
        if lines.iter().any(Line::takes_screenshot) { Some(Painter::headless(arguments.size, None)?) } else { None };
    let editor = scene::editor_of(scene, named_scene, arguments.keyframes.clone());
    let trace = arguments.trace.then(trace::Trace::new);
    let editor = run::Runner::new(editor, painter, trace).run(&lines)?;
    if let Some(path) = &arguments.state {
        storage::write(path, trace::state_json(&editor).as_bytes())
            .map_err(|reason| CliError::unwritten(path, reason))?;
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
