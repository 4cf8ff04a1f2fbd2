//! The program: its command line, which opens the window where no other command is given.

use std::process::ExitCode;

fn main() -> ExitCode {
    inbetween::cli::run(std::env::args_os())
}
