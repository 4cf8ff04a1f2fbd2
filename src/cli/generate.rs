//! `inbetween completions` and `inbetween man`: what shells and `man` know of the command line.

use clap::Command;
use clap_complete::aot;
use clap_mangen::Man;

use super::arguments::{CompletionsArguments, ManArguments, command};
use super::{CliError, Common, misuse, output};
use crate::files;
use crate::storage;
use crate::words::texts;

/// Prints the shell's script of completions.
///
/// # Errors
/// [`CliError`]: standard output does not take it.
pub fn completions(arguments: &CompletionsArguments) -> Result<(), CliError> {
    let mut script = Vec::new();
    aot::generate(arguments.shell, &mut shown(&command()), "inbetween", &mut script);
    output::print(|output| output.write_all(&script))
}

/// A command without its hidden options, which some shells would propose.
fn shown(command: &Command) -> Command {
    let shown_command = Command::new(command.get_name().to_owned())
        .disable_help_subcommand(true)
        .disable_version_flag(true)
        .args(command.get_arguments().filter(|argument| !argument.is_hide_set()))
        .subcommands(command.get_subcommands().map(shown));
    match command.get_about() {
        Some(about) => shown_command.about(about.clone()),
        None => shown_command,
    }
}

/// Writes a page for the program and one for each command.
///
/// # Errors
/// [`CliError`]: the folder is standard output, or a page cannot be written.
pub fn man(arguments: &ManArguments, common: Common<'_>) -> Result<(), CliError> {
    let folder = &arguments.folder;
    if storage::is_standard(folder) {
        return Err(misuse(&texts::places_no_folder("DIR").to_string()));
    }
    let mut program = command();
    program.build();
    files::create_folder(folder)?;
    let commands: Vec<Command> = program.get_subcommands().cloned().collect();
    let count = commands.len() + 1;
    for command in std::iter::once(program).chain(commands) {
        // After `build`, a command's display name is `inbetween-render`.
        let name = command.get_display_name().unwrap_or("inbetween").to_owned();
        let mut page = Vec::new();
        Man::new(command.name(name.clone())).render(&mut page).map_err(CliError::standard_output)?;
        files::write(&folder.join(format!("{name}.1")), &page)?;
    }
    if common.is_quiet { Ok(()) } else { output::say(&format!("{}\n", texts::man_written(count, folder.display()))) }
}
