//! The command line: arguments in, text, files and an exit status out. One file a command.
//!
//! Exit statuses: 0 done, 1 bad input, 2 wrong usage, 3 no display or no GPU adapter. Where the status is 1, what is wrong stands on
//! standard error, a sentence a line, and nothing on standard output. Commands that compare end with 0 within the tolerance, 1 beyond,
//! 2 where they cannot tell.

mod animation;
mod arguments;
mod check;
mod compare;
mod convert;
mod diagnose;
mod diff;
mod error;
mod grade;
mod help;
mod interrupt;
mod nodes;
mod output;
mod picture;
mod progress;
mod quiet;
mod reading;
mod reference;
mod render;
mod sample;
mod scene;
mod script;
mod verify;
mod window;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{CommandFactory as _, Parser as _};

pub use reference::command_reference;
pub use script::{script_commands, script_lines};

use arguments::{Arguments, Subcommand};
use error::CliError;

/// Does what the arguments say, of which the first is the program's name. The result is the process's exit status.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let log_level = env_logger::Env::default().default_filter_or("inbetween=error");
    // A logger that is there already, in a test, serves as well.
    let _ = env_logger::Builder::from_env(log_level).try_init();
    match dispatch(arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(CliError::Usage(error)) => {
            // Help goes to standard output, and a closed one is no mishap.
            let _ = error.print();
            ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2))
        }
        // What is beyond is said on standard output already.
        Err(CliError::Beyond) => ExitCode::from(1),
        Err(error) => {
            output::complain(&error.to_string());
            ExitCode::from(error.exit_status())
        }
    }
}

fn dispatch(arguments: impl IntoIterator<Item = OsString>) -> Result<(), CliError> {
    let Arguments { scene, file, command } = Arguments::try_parse_from(arguments)?;
    let scene = scene.as_deref();
    match command {
        None => window::run(scene, file),
        Some(_) if file.is_some() => Err(misuse("a FILE to open in the window and a command cannot go together")),
        Some(Subcommand::Help(arguments)) => help::run(&arguments),
        Some(Subcommand::Check(arguments)) => check::run(&arguments, &scene::load(scene)?),
        Some(Subcommand::Convert(arguments)) => convert::run(&arguments, &scene::load(scene)?),
        Some(Subcommand::Nodes) => nodes::run(&scene::load(scene)?),
        Some(Subcommand::Sample(arguments)) => sample::run(&arguments, &scene::load(scene)?),
        Some(Subcommand::Render(arguments)) => render::run(&arguments, scene),
        Some(Subcommand::Diagnose(arguments)) => diagnose::run(&arguments, &scene::load(scene)?),
        Some(Subcommand::Diff(arguments)) => diff::run(&arguments, scene::load(scene)),
        Some(Subcommand::Grade(arguments)) => grade::run(&arguments, scene),
        Some(Subcommand::Verify(arguments)) => verify::run(&arguments, scene),
        Some(Subcommand::Compare(arguments)) => compare::run(&arguments),
        Some(Subcommand::Script(arguments)) => script::run(&arguments, scene),
    }
}

/// Wrong usage that no single argument shows.
fn misuse(sentence: &str) -> CliError {
    CliError::Usage(Arguments::command().error(ErrorKind::ArgumentConflict, sentence))
}
