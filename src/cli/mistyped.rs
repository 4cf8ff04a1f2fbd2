//! A first argument that looks like a mistyped command: wrong usage, with a suggestion.
//!
//! A keyframe file need not exist yet to be opened in the window, so any word could be one. One without an ending and without a folder
//! is more likely a command that was meant.

use std::ffi::{OsStr, OsString};
use std::path::Path;

use clap::builder::StyledStr;
use clap::error::{ContextKind, ContextValue, ErrorKind};

use crate::storage;

/// How alike a word and a command are, from 0 to 1, from which on the command is suggested: as clap does it for options.
const ALIKE: f64 = 0.7;

/// The error for a first argument that is neither a command, nor a file that exists, nor the name of a file to be made.
///
/// `arguments` are those of the process, the program's name first; `command` knows all commands and options.
pub fn mistyped_command(arguments: &[OsString], command: &mut clap::Command) -> Option<clap::Error> {
    let word = first_positional(arguments, command)?;
    let path = Path::new(word);
    let is_bare = path.extension().is_none() && path.components().count() == 1 && !ends_with_separator(word);
    if !is_bare || command.find_subcommand(word).is_some() || word == "help" || storage::exists(path) {
        return None;
    }
    let word = word.to_string_lossy();
    let mut error = clap::Error::new(ErrorKind::InvalidSubcommand).with_cmd(command);
    error.insert(ContextKind::InvalidSubcommand, ContextValue::String(word.clone().into_owned()));
    let alike = alike(&word, command);
    if !alike.is_empty() {
        error.insert(ContextKind::SuggestedSubcommand, ContextValue::Strings(alike));
    }
    let mut tip = StyledStr::new();
    tip.push_str(&format!("to open the window on a new keyframe file, give its name an ending: '{word}.json'"));
    error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip]));
    let usage = command.render_usage();
    error.insert(ContextKind::Usage, ContextValue::StyledStr(usage));
    Some(error)
}

fn ends_with_separator(word: &OsStr) -> bool {
    word.to_string_lossy().ends_with(std::path::is_separator)
}

/// The first argument that is no option and no option's value.
fn first_positional<'a>(arguments: &'a [OsString], command: &clap::Command) -> Option<&'a OsString> {
    let takes_value = |argument: &str| {
        let option = command
            .get_arguments()
            .find(|option| option.get_long().is_some_and(|long| argument == format!("--{long}")));
        option.is_some_and(|option| option.get_action().takes_values())
    };
    let mut rest = arguments.iter().skip(1);
    while let Some(argument) = rest.next() {
        let text = argument.to_string_lossy();
        if text == "--" {
            return None;
        }
        if takes_value(&text) {
            rest.next();
        } else if !text.starts_with('-') {
            return Some(argument);
        }
    }
    None
}

/// The commands that are most like a word, the most alike last, as clap names them.
fn alike(word: &str, command: &clap::Command) -> Vec<String> {
    let names = command.get_subcommands().map(clap::Command::get_name);
    let mut alike: Vec<(f64, &str)> =
        names.map(|name| (strsim::jaro(word, name), name)).filter(|(confidence, _)| *confidence > ALIKE).collect();
    alike.sort_by(|a, b| a.0.total_cmp(&b.0));
    alike.into_iter().map(|(_, name)| name.to_owned()).collect()
}
