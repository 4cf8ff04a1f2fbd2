//! The comments of a journal that mean something, and what they say of it.

use std::path::{Path, PathBuf};

/// How a journal begins.
pub(super) const FORMAT: &str = "# inbetween.journal 1";
/// After it: the program's version.
pub(super) const PROGRAM: &str = "# program ";
/// After it: when the journal began, in seconds since 1970.
pub(super) const BEGAN: &str = "# began ";
/// After it: the keyframe file, in double quotes.
pub(super) const KEYFRAMES: &str = "# keyframes ";
/// After it: the scene's name, in double quotes.
pub(super) const SCENE: &str = "# scene ";
/// The end of the head and of the lines that restore what was at first.
pub(super) const START: &str = "# commands";
/// After it: the keyframe file that was written, in double quotes.
pub(super) const WROTE: &str = "# wrote ";
/// After it: the scene file that was written, in double quotes.
pub(super) const WROTE_SCENE: &str = "# wrote scene ";
/// After it: another file that was written, in double quotes.
pub(super) const WROTE_PICTURE: &str = "# wrote picture ";
/// The line before it panicked and was taken back.
pub(super) const PANICKED: &str = "# panicked";
/// The program ended because of the line before it, or soon after.
pub(super) const ENDED: &str = "# ended the program";
/// Somebody begins to recover the journal. What ends the recovery as well is the last line.
pub(super) const RECOVERING: &str = "# recovering";
/// The recovery came to the end.
pub(super) const RECOVERED: &str = "# played to the end";
/// The user wanted the end; nothing is to be recovered.
pub(super) const QUIT: &str = "# quit";
/// What the journal holds is safe elsewhere.
pub(super) const TAKEN: &str = "# taken over";

/// Whether bytes are the beginning of a journal.
#[must_use]
pub fn is_journal(bytes: &[u8]) -> bool {
    let rest = bytes.strip_prefix(FORMAT.as_bytes());
    rest.is_some_and(|rest| rest.first().is_none_or(|byte| matches!(byte, b'\n' | b'\r')))
}

/// A path in double quotes, as comments have it.
pub(super) fn quoted(path: &Path) -> String {
    serde_json::Value::from(path.to_string_lossy().as_ref()).to_string()
}

/// The path that stands in double quotes.
pub(super) fn unquoted(text: &str) -> Option<PathBuf> {
    serde_json::from_str::<String>(text.trim()).ok().map(PathBuf::from)
}

/// What a journal says of itself.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Survey {
    /// The keyframe file that was named last.
    pub keyframes: PathBuf,
    /// The scene's name.
    pub scene: String,
    /// When it began, in seconds since 1970.
    pub began: u64,
    /// How many commands it has.
    pub commands: usize,
    /// How many commands may have changed the document since a file was written, or since the start.
    pub unsaved: usize,
    /// Whether nothing is to be recovered: its user quit, or it was recovered.
    pub is_over: bool,
    /// Whether the last line is not whole.
    pub is_cut: bool,
}

/// What a journal says of itself, from its text alone; `None`: it is none.
#[must_use]
pub fn survey(bytes: &[u8]) -> Option<Survey> {
    if !is_journal(bytes) {
        return None;
    }
    let mut survey = Survey { is_cut: !bytes.ends_with(b"\n"), ..Survey::default() };
    let mut has_begun = false;
    for line in whole_lines(bytes) {
        let Ok(line) = std::str::from_utf8(line) else { break };
        if line.starts_with('#') {
            survey.comment(line);
            has_begun |= line == START;
        } else if line.starts_with("snapshot ") {
            survey.unsaved += usize::from(line.contains("\\\"has_unsaved_keyframes\\\":true"));
        } else if has_begun && !line.trim().is_empty() {
            survey.commands += 1;
            let is_load = survey.unsaved == 0 && line.starts_with("imported");
            survey.unsaved += usize::from(!is_load && !LOOKING.iter().any(|word| line.starts_with(word)));
        }
    }
    Some(survey)
}

impl Survey {
    fn comment(&mut self, line: &str) {
        if let Some(began) = line.strip_prefix(BEGAN) {
            self.began = began.trim().parse().unwrap_or_default();
        } else if let Some(path) = line.strip_prefix(KEYFRAMES) {
            self.keyframes = unquoted(path).unwrap_or_default();
        } else if let Some(name) = line.strip_prefix(SCENE) {
            self.scene = serde_json::from_str(name).unwrap_or_default();
        } else if line.starts_with(WROTE_SCENE) {
            self.unsaved = 0;
        } else if let Some(path) = line.strip_prefix(WROTE).filter(|_| !line.starts_with(WROTE_PICTURE)) {
            self.keyframes = unquoted(path).unwrap_or_default();
            self.unsaved = 0;
        } else if line == QUIT || line == TAKEN {
            self.is_over = true;
        }
    }
}

/// Beginnings of lines that change what is seen, chosen or played, and not the document.
const LOOKING: [&str; 10] =
    ["ground", "wait ", "select", "eye", "scrub", "step ", "ghosts", "seconds", "speed ", "range "];

/// The lines that end with a line feed, without it.
pub(super) fn whole_lines(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
    let end = bytes.iter().rposition(|&byte| byte == b'\n').map_or(0, |at| at + 1);
    bytes[..end].split_inclusive(|&byte| byte == b'\n').map(|line| {
        let line = line.strip_suffix(b"\n").unwrap_or(line);
        line.strip_suffix(b"\r").unwrap_or(line)
    })
}
