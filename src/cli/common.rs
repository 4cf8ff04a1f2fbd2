//! What the options of all commands say.

use std::path::Path;

use super::arguments::ProgressKind;

/// The options that every command has.
#[derive(Clone, Copy, Debug)]
pub struct Common<'a> {
    /// The scene's name or file; `None` for the default one.
    pub scene: Option<&'a Path>,
    /// Whether only results and problems are said.
    pub is_quiet: bool,
}

impl Common<'_> {
    /// How progress is told: where a person watches and wants quiet, not at all.
    pub fn progress(self, kind: ProgressKind) -> ProgressKind {
        if self.is_quiet && kind == ProgressKind::Terminal { ProgressKind::None } else { kind }
    }
}
