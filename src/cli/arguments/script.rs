//! Arguments of `script`.

use std::path::PathBuf;

use clap::Args;

use super::DEFAULT_KEYFRAME_FILE;
use super::values::size;
use crate::export::Size;

/// Arguments of `script`.
#[derive(Debug, Args)]
pub struct ScriptArguments {
    /// The script, of at most 16 MiB; - reads standard input.
    pub file: PathBuf,
    /// The keyframe file: what the hotkeys i and w read and write.
    #[arg(long, value_name = "FILE", default_value = DEFAULT_KEYFRAME_FILE)]
    pub keyframes: PathBuf,
    /// After each command, print a JSON object with its line, its message and the state.
    #[arg(long, visible_alias = "json")]
    pub trace: bool,
    /// End with exit status 1 at the first command that is refused. Without this the script goes on, and ends with 0; without --trace,
    /// refusals go to standard error.
    #[arg(long)]
    pub strict: bool,
    /// Write keyframes and scenes also over files that another program has changed since they were read or written, or since the
    /// start. What they held is kept in NAME.bak. Without this, such a file is left alone, and the exit status is 1.
    #[arg(long)]
    pub overwrite: bool,
    /// At the end, write the state and the pose displayed to this file, as JSON.
    #[arg(long, value_name = "FILE")]
    pub state: Option<PathBuf>,
    /// Width and height of screenshots in pixels.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "640x480", value_parser = size)]
    pub size: Size,
    /// Write each command to this journal before it is done. The file may be missing, empty, or a journal, which is replaced.
    #[arg(long, value_name = "FILE")]
    pub journal: Option<PathBuf>,
    /// For tests: the command of this number panics, counted from 1.
    #[arg(long, hide = true, value_name = "N")]
    pub panic_at: Option<u64>,
}

/// The long help.
pub fn help() -> String {
    format!(
        "\
Run a script of hotkeys and gestures with no window. One command a line; # starts a comment:

{lines}
The script is read whole first: a line that makes no sense, or an unknown node, is an error, and nothing is run. While it runs, \
what the window would refuse with a message is a message here too: in the trace, or on standard error. With --strict it ends the script with exit status 1. A file that cannot be written ends it with exit status 1, \
ctrl+q with 0.",
        lines = crate::script::help()
    )
}
