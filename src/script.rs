//! Scripts: hotkeys, gestures and commands as text, through the same door as the window's.
//!
//! [`parse()`] reads a whole script before any of it runs, [`print()`] writes a command as a line that reads back to it, [`Runner`] runs
//! lines against an editor without a window, and [`TraceLine`] says what a line did.
//!
//! The lines of commands stand in their rows of the table of commands ([`crate::editor::commands`]). A few lines are the script's own:
//! `key`, `do`, `clamped` and `wait`.

mod disk;
mod parse;
mod print;
mod problem;
mod restore;
mod run;
mod table;
mod trace;

pub use disk::{Disk, DiskStop};
pub use parse::{Action, Line, parse, parse_line};
pub use print::{print, print_swiftly};
pub use problem::{LineProblem, ScriptError};
pub use restore::{Restore, imported_line};
pub use run::{NoWindow, Runner, Step, Windowless};
pub use table::{help, is_first_word, markdown};
pub use trace::{State, TraceLine, state_json};

use crate::editor::Command;
use crate::scene::SceneGraph;

/// What a script's lines ask of the editor, in order; times that they wait are left out.
///
/// # Errors
/// What is wrong with each line that cannot be understood: `line 3: "jump" is not a command; …`.
pub fn script_commands(bytes: &[u8], scene: &SceneGraph) -> Result<Vec<Command>, Vec<String>> {
    let lines = parse(bytes, scene).map_err(|problems| problems.iter().map(ToString::to_string).collect::<Vec<_>>())?;
    let commands = lines.into_iter().filter_map(|line| match line.action {
        Action::Apply(command) => Some(command),
        Action::Wait(_) | Action::Ticks(_) | Action::Restore(_) => None,
    });
    Ok(commands.collect())
}
