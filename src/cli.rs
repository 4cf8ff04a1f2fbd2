//! The command line: arguments in, text, files and an exit status out. One file for each command.
//!
//! Commands read arguments, print, show progress and turn errors into exit statuses. The rooms below do the work.
//!
//! Exit statuses: 0 done, 1 bad input, 2 wrong usage, 3 no display or no GPU adapter, 101 a fault of the program, 128 and its number a
//! signal. With status 1, standard error has the problems,
//! a sentence a line, and standard output is empty. Commands that compare end with 0 within the tolerance, 1 beyond,
//! 2 if they cannot compare.

mod arguments;
mod check;
mod common;
mod compare;
mod convert;
mod diagnose;
mod diff;
#[cfg(target_os = "linux")]
mod drivers;
mod each;
mod error;
mod export_model;
mod generate;
mod grade;
mod help;
mod import;
mod info;
mod join;
mod logging;
mod mistyped;
mod nodes;
mod output;
mod places;
mod progress;
mod reading;
mod recover;
mod reference;
mod render;
mod retarget;
mod sample;
mod script;
mod share;
mod targets;
mod told;
mod verify;
mod version;
mod window;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::FromArgMatches as _;

use crate::files::scene;
use crate::signals;
use crate::text::visible;
use crate::window::ForTests;
use crate::words::{Message, texts};

pub use reference::command_reference;

use arguments::{Arguments, Subcommand};
use common::Common;
use error::{CliError, Ended};

/// Does what the arguments say, of which the first is the program's name. The result is the process's exit status.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    // Must come first: the environment can only be changed while there is one thread.
    #[cfg(target_os = "linux")]
    drivers::leave_out_useless_ones();
    logging::start();
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    match dispatch(&arguments) {
        Ok(ended) => ExitCode::from(ended.status()),
        Err(CliError::Usage(error)) => {
            let text = error.to_string();
            if error.use_stderr() && visible(&text) != text {
                output::complain(text.trim_end());
            } else {
                // Help goes to standard output, and a closed one is no mishap.
                let _ = error.print();
            }
            ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2))
        }
        Err(CliError::Misuse(sentence)) => {
            output::complain(&sentence);
            ExitCode::from(error::MISUSE)
        }
        Err(CliError::Said { status }) => ExitCode::from(status),
        Err(CliError::Failed { status, sentences, source }) => {
            if let Some(source) = source {
                log::debug!("the command failed: {source:?}");
            }
            if status == error::NO_DRAWING {
                // A driver that hangs may hold what the usual end of a process waits for.
                signals::end(status.into(), &sentences.join("\n"));
            }
            output::complain(&sentences.join("\n"));
            ExitCode::from(status)
        }
    }
}

fn dispatch(arguments: &[OsString]) -> Result<Ended, CliError> {
    let mistyped = || mistyped::mistyped_command(arguments, &mut arguments::command());
    let matches = match arguments::command().try_get_matches_from(arguments) {
        Ok(matches) => matches,
        Err(error) if error.use_stderr() => return Err(mistyped().unwrap_or(error).into()),
        Err(help) => return Err(help.into()),
    };
    let read = Arguments::from_arg_matches(&matches)?;
    if let (None, Some(_), Some(error)) = (&read.command, &read.file, mistyped()) {
        return Err(error.into());
    }
    perform(read).map_err(|error| error.with_usage_of(matches.subcommand_name()))
}

fn perform(arguments: Arguments) -> Result<Ended, CliError> {
    if arguments.version {
        version::run(arguments.verbose)?;
        return Ok(Ended::Well);
    }
    let Arguments {
        scene, quiet, file, print_lines, window_panic_at, drawing_panic_at, device_lost_at, command, ..
    } = arguments;
    let common = Common { scene: scene.as_deref(), is_quiet: quiet };
    let Some(command) = command else {
        let tests = ForTests {
            prints: print_lines,
            panics_at: window_panic_at,
            panics_in_drawing_at: drawing_panic_at,
            loses_device_at: device_lost_at,
        };
        window::run(common.scene, file, tests)?;
        return Ok(Ended::Well);
    };
    // The window listens in its own way.
    signals::listen(|signal| Some(ended_by(signal)));
    if file.is_some() {
        return Err(misuse("a FILE to open in the window and a command cannot go together"));
    }
    match command {
        Subcommand::Check(arguments) => return check::run(&arguments, common),
        Subcommand::Convert(arguments) => return convert::run(&arguments, common),
        Subcommand::Sample(arguments) => return sample::run(&arguments, common),
        Subcommand::Diff(arguments) => return diff::run(&arguments, common),
        Subcommand::Verify(arguments) => return verify::run(&arguments, common),
        Subcommand::Compare(arguments) => return compare::run(&arguments, common),
        Subcommand::Script(arguments) => return script::run(&arguments, common),
        Subcommand::Info(arguments) => return info::run(&arguments, common),
        Subcommand::Join(arguments) => join::run(&arguments, common)?,
        Subcommand::Nodes(arguments) => nodes::run(&arguments, common)?,
        Subcommand::Render(arguments) => render::run(&arguments, common)?,
        Subcommand::Diagnose(arguments) => diagnose::run(&arguments, common)?,
        Subcommand::Grade(arguments) => return grade::run(&arguments, common),
        Subcommand::Recover(arguments) => recover::run(&arguments, common)?,
        Subcommand::Import(arguments) => import::run(&arguments, common)?,
        Subcommand::Export(arguments) => export_model::run(&arguments, common)?,
        Subcommand::Retarget(arguments) => retarget::run(&arguments, common)?,
        Subcommand::Share(arguments) => share::run(&arguments, common)?,
        Subcommand::Completions(arguments) => generate::completions(&arguments)?,
        Subcommand::Man(arguments) => generate::man(&arguments, common)?,
        Subcommand::Help(arguments) => help::run(&arguments)?,
    }
    Ok(Ended::Well)
}

/// What is said where a signal ends a command in the middle of anything, also of opening or reading a pipe.
fn ended_by(signal: i32) -> String {
    match signal {
        signals::INTERRUPT => Message::from(texts::EXPORT_INTERRUPTED),
        _ => texts::ended_by_signal(signal.to_string()),
    }
    .to_string()
}

/// Wrong usage that no single argument shows.
fn misuse(sentence: &str) -> CliError {
    CliError::Misuse(sentence.to_owned())
}
