//! `inbetween help`: the help of a command, or a page of the manual.

use std::fmt::Write as _;

use clap::builder::PossibleValuesParser;
use clap::{Arg, Command};

use super::arguments::{HelpArguments, command};
use super::{CliError, output};
use crate::{manual, notices};

/// The topic of what the program is made of.
const LICENCES: &str = "licences";
/// Width of a page, in characters.
const WIDTH: usize = 80;

/// Prints the help of a command, or a page; without a topic, the program's help and the list of pages.
///
/// # Errors
/// [`CliError::Usage`] with the help of a command, as `--help` gives it, or for an unknown topic.
pub fn run(arguments: &HelpArguments) -> Result<(), CliError> {
    let program = command();
    let Some(topic) = &arguments.topic else {
        // A closed standard output is no mishap.
        let _ = asked_for(program, &[]).print();
        return output::print(|output| output.write_all(pages().as_bytes()));
    };
    if topic == LICENCES {
        return output::print(|output| output.write_all(notices::text().as_bytes()));
    }
    if program.find_subcommand(topic).is_some() {
        return Err(CliError::Usage(asked_for(program, &[topic])));
    }
    match manual::page(topic) {
        Some(page) => output::print(|output| output.write_all(manual::text(&page, WIDTH).as_bytes())),
        None => Err(CliError::Usage(unknown(topic, &program))),
    }
}

/// The help of the program or of one of its commands, which clap gives as an error.
fn asked_for(program: Command, command: &[&str]) -> clap::Error {
    let arguments = ["inbetween"].iter().chain(command).chain(&["--help"]);
    program.try_get_matches_from(arguments).expect_err("help is asked for")
}

/// The list of pages, as the help shows it.
fn pages() -> String {
    let mut text = String::from("\nPages of the manual, for `inbetween help PAGE`:\n");
    let contents = manual::contents();
    let entries = || contents.iter().flat_map(|part| &part.pages);
    let longest = entries().map(|entry| entry.name.len()).max().unwrap_or_default();
    for entry in entries() {
        let _ = writeln!(text, "  {:longest$}  {}", entry.name, entry.title);
    }
    let _ = writeln!(text, "\n`inbetween help {LICENCES}` prints the licences of what the program is made of.");
    text
}

/// The error for a topic that is neither a command nor a page. It lists both, and suggests what is spelt alike.
fn unknown(topic: &str, program: &Command) -> clap::Error {
    let commands = program.get_subcommands().map(|command| command.get_name().to_owned());
    let topics: Vec<String> = commands.chain(manual::names()).chain([LICENCES.to_owned()]).collect();
    let topic_argument = Arg::new("TOPIC").value_parser(PossibleValuesParser::new(topics));
    // A parser that knows only this argument says what is wrong as every other argument's does.
    let parser = Command::new("inbetween help").arg(topic_argument);
    parser.try_get_matches_from(["inbetween help", topic]).expect_err("the topic is none of those")
}
