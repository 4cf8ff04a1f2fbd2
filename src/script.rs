//! Scripts as text: lines to commands, and commands to lines that read back to them.
//!
//! The lines of commands stand in their rows of the table of commands ([`crate::editor::commands`]). A few lines are the script's own:
//! `key`, `do`, `clamped` and `wait`.

mod parse;
mod print;
mod problem;
mod table;

pub use parse::{Action, Line, parse};
pub use print::print;
pub use problem::{LineProblem, ScriptError};
pub use table::{help, markdown};
