//! The table of commands: one row a command, which holds all that is known of it but its handler.
//!
//! Everything that lists or judges commands is derived from the rows: [`Editor::can`], what playing refuses, hotkeys, menus, the
//! help, the lines of scripts and their help. Adding a command takes a variant of [`Command`], a row, a handler and the words.

mod comparing;
mod file;
mod gizmo;
mod keyframes;
mod lighting;
mod line;
mod nodes;
mod playing;
mod poses;
mod reaching;
mod row;
mod timed_keys;
mod timeline;
mod values;
mod view;
mod window;

use std::sync::LazyLock;

pub use line::{ArgumentError, Arguments, Ending, Line};
pub use row::{Binding, Changes, Group, Menu, Row, Submenu, WindowState};
#[cfg(test)]
pub(crate) use values::radians;
pub(crate) use values::{quoted_prefix, split_option, tokens};

use super::{Command, Editor};

static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| {
    [
        keyframes::rows(),
        timeline::rows(),
        nodes::rows(),
        reaching::rows(),
        poses::rows(),
        gizmo::rows(),
        timed_keys::rows(),
        playing::rows(),
        view::rows(),
        lighting::rows(),
        comparing::rows(),
        file::rows(),
        window::rows(),
    ]
    .concat()
});

/// All rows, in the order in which lists show them.
#[must_use]
pub fn rows() -> &'static [Row] {
    &ROWS
}

/// The row of a command.
///
/// # Panics
/// Where a command has no row, which a test excludes.
#[must_use]
pub fn row_of(command: &Command) -> &'static Row {
    rows().iter().find(|row| row.owns(command)).expect("every command has a row")
}

/// The script lines of all rows, each once.
pub fn lines() -> impl Iterator<Item = &'static Line> {
    let all = rows().iter().flat_map(|row| &row.lines);
    // A line that several commands share stands in the rows of each, one after the other.
    let mut last = "";
    all.filter(move |line| std::mem::replace(&mut last, line.name) != line.name)
}

impl Editor {
    /// Whether a command can do what it is for. Applying one that cannot is harmless: it is refused with a message, or changes nothing.
    #[must_use]
    pub fn can(&self, command: &Command) -> bool {
        let row = row_of(command);
        (row.refused_while_playing.is_none() || !self.is_playing()) && (row.can)(self, command)
    }
}

#[cfg(test)]
mod tests;
