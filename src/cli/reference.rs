//! The commands and their arguments as Markdown, for the manual.

use std::fmt::Write as _;

use clap::{Arg, Command};

use super::arguments;

/// Every command with its help, usage and arguments, as Markdown for the manual's page on the command line.
#[must_use]
pub fn command_reference() -> String {
    let mut program = arguments::command();
    program.build();
    let mut text = String::new();
    section(&mut text, "inbetween", &program);
    for command in program.get_subcommands() {
        section(&mut text, &format!("inbetween {}", command.get_name()), command);
    }
    text.truncate(text.trim_end().len());
    text.push('\n');
    text
}

fn section(text: &mut String, title: &str, command: &Command) {
    let _ = writeln!(text, "### {title}\n");
    let about = command.get_long_about().or_else(|| command.get_about()).map(ToString::to_string).unwrap_or_default();
    for paragraph in about.split("\n\n") {
        let is_listing = paragraph.lines().any(|line| line.starts_with("  "));
        let _ = if is_listing {
            writeln!(text, "```text\n{paragraph}\n```\n")
        } else {
            let stop = if paragraph.ends_with('.') { "" } else { "." };
            writeln!(text, "{}{stop}\n", escaped(paragraph))
        };
    }
    let usage = command.clone().render_usage().to_string();
    let _ = writeln!(text, "```text\n{}\n```\n", usage.trim_start_matches("Usage: ").trim_end());
    let arguments: Vec<&Arg> = command.get_arguments().filter(|argument| is_own(argument, title)).collect();
    let below = command.get_after_help().map(ToString::to_string).unwrap_or_default();
    let examples: Vec<&str> = below.lines().filter_map(|line| line.strip_prefix("  ")).collect();
    let _ = writeln!(text, "```text\n{}\n```\n", examples.join("\n"));
    text.push_str("| argument | meaning |\n|---|---|\n");
    for argument in arguments {
        let _ = writeln!(text, "| `{}` | {} |", written(argument).replace('|', "\\|"), meaning(argument));
    }
    text.push('\n');
}

/// Options of all commands are listed once, for the program.
fn is_own(argument: &Arg, title: &str) -> bool {
    let is_common = argument.is_global_set() || matches!(argument.get_id().as_str(), "help" | "version");
    !argument.is_hide_set() && (title == "inbetween" || !is_common)
}

/// An argument as one types it: `-o, --output OUT`.
fn written(argument: &Arg) -> String {
    let values = argument.get_value_names().unwrap_or_default().join(" ");
    let more = if argument.get_num_args().is_some_and(|range| range.max_values() > 1) { "…" } else { "" };
    let takes_value = argument.get_action().takes_values();
    let value = if takes_value { format!("{values}{more}") } else { String::new() };
    let short = argument.get_short().map(|short| format!("-{short}"));
    let long = argument.get_long().map(|long| format!("--{long}"));
    let aliases = argument.get_visible_aliases().unwrap_or_default().into_iter().map(|alias| format!("--{alias}"));
    let names: Vec<String> = short.into_iter().chain(long).chain(aliases).collect();
    format!("{} {value}", names.join(", ")).trim().to_owned()
}

fn meaning(argument: &Arg) -> String {
    let help = argument.get_long_help().or_else(|| argument.get_help()).map(ToString::to_string).unwrap_or_default();
    let mut text = escaped(&help.replace("\n\n", " ").replace('\n', " "));
    // Clap takes the full stop of a single sentence away.
    if !text.ends_with('.') {
        text.push('.');
    }
    if !argument.get_action().takes_values() {
        return text;
    }
    let possible = argument.get_possible_values();
    if !possible.is_empty() {
        let names: Vec<String> = possible.iter().map(|value| format!("`{}`", value.get_name())).collect();
        let _ = write!(text, " One of {}.", names.join(", "));
    }
    let defaults: Vec<String> =
        argument.get_default_values().iter().map(|value| format!("`{}`", value.to_string_lossy())).collect();
    if !defaults.is_empty() {
        let _ = write!(text, " By default {}.", defaults.join(", "));
    }
    text
}

/// Plain text as Markdown: nothing in it is markup.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        if matches!(letter, '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|' | '#') {
            escaped.push('\\');
        }
        escaped.push(letter);
    }
    escaped
}
