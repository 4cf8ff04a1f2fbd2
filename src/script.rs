//! Scripts: hotkeys and gestures as text, through the same commands as the window's.
//!
//! [`parse`] reads a whole script before any of it runs; [`Runner`] runs its lines against an editor without a window; [`TraceLine`]
//! says what a line did.

mod disk;
pub mod parse;
mod run;
mod trace;

pub use disk::{Disk, DiskStop};
pub use parse::{Action, Line, markdown as script_lines};
pub use run::{NoWindow, Runner, Step, Windowless};
pub use trace::{State, TraceLine, state_json};

use crate::editor::Command;
use crate::scene::SceneGraph;

/// What a script's lines ask of the editor, in order; times that they wait are left out.
///
/// # Errors
/// What is wrong with each line that cannot be understood: `line 3: "jump" is not a command; …`.
pub fn script_commands(bytes: &[u8], scene: &SceneGraph) -> Result<Vec<Command>, Vec<String>> {
    let lines =
        parse::parse(bytes, scene).map_err(|problems| problems.iter().map(ToString::to_string).collect::<Vec<_>>())?;
    let commands = lines.into_iter().filter_map(|line| match line.action {
        Action::Apply(command) => Some(command),
        Action::Wait(_) => None,
    });
    Ok(commands.collect())
}
