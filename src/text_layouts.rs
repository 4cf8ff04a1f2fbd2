//! Import and export of keyframes as text in the layouts of students' own programs. The content tells the layout: numbers decide, and
//! what stands between them is checked.
//!
//! Bytes in, keyframes and a report of inferences out; keyframes in, text out. This module does not know files or windows. A text is read
//! in several passes and never copied: apart from the keyframes, memory does not grow with the text. Counts in a header are checked against
//! the text before memory is allocated for them.

mod columns;
mod counts;
mod error;
mod header;
mod joints;
mod layout;
mod lexer;
mod marked;
mod marks;
mod places;
mod plan;
mod python;
mod reading;
mod report;
mod rows;
mod structure;
mod write;

pub use error::{TextError, TextProblem};
pub use joints::JointList;
pub use layout::{FieldOrder, Layout};
pub use reading::{Reading, read_keyframes};
pub use report::{Certainty, Finding, Report};
pub use write::KeyframeText;

use thiserror::Error;

use crate::keyframe::{KeyframeFile, KeyframeFileError, keyframes_from_json};
use crate::model::ModelFormat;
use crate::scene::SceneGraph;
use crate::text::without_byte_order_mark;
use crate::words::{Message, texts};

/// Options for texts that are ambiguous or broken.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The order of a row's numbers; by default inferred from which four have unit length.
    pub order: Option<FieldOrder>,
    /// The node of each row; by default inferred from the offsets of keyframe 0.
    pub joints: Option<JointList>,
    /// Whether the complete keyframes of a broken text are imported.
    pub salvage: bool,
    /// Which group of keys of a Python program is imported.
    pub group: GroupChoice,
    /// The file's name, for the report; may be empty.
    pub file_name: String,
}

/// Which of the groups of keys of a Python program is imported, each of which belongs to a control node.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum GroupChoice {
    /// The only one that can be read; an error if there are several.
    #[default]
    Only,
    /// The first that can be read: for those who ask whether there are keys.
    First,
    /// The one of this number, from 1, in the order of the text.
    Number(usize),
}

impl Options {
    /// For those who take keyframes and nothing else, so that a program needs no choice of a group.
    #[must_use]
    pub fn of_keyframes() -> Self {
        Self { group: GroupChoice::First, ..Self::default() }
    }
}

/// The result of an import.
#[derive(Clone, Debug)]
pub enum Imported {
    /// A keyframe file of this program's own format.
    KeyframeFile(KeyframeFile),
    /// Keyframes from a text, and the inferences.
    Text(KeyframeFile, Report),
    /// Timed keys: the text of a scene file with a control node that has them, and the inferences.
    Scene(String, Report),
}

/// Why nothing was imported.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ImportError {
    /// It looks like this program's own format and has errors; never empty.
    #[error("{}", .0.first().map(ToString::to_string).unwrap_or_default())]
    KeyframeFile(Vec<KeyframeFileError>),
    /// A text has an error.
    #[error(transparent)]
    Text(#[from] TextError),
}

impl ImportError {
    /// The first error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::KeyframeFile(problems) => {
                problems.first().map_or_else(|| texts::foreign(""), KeyframeFileError::message)
            }
            Self::Text(error) => error.message(),
        }
    }

    /// A message for each error.
    #[must_use]
    pub fn sentences(&self) -> Vec<String> {
        match self {
            Self::KeyframeFile(problems) => problems.iter().map(ToString::to_string).collect(),
            Self::Text(error) => vec![error.to_string()],
        }
    }
}

/// Reads keyframes for a scene: this program's own format, or any layout of text; the content decides which. A byte order mark is skipped.
///
/// # Errors
/// [`ImportError`], with the location of each error.
pub fn import(bytes: &[u8], scene: &SceneGraph, options: &Options) -> Result<Imported, ImportError> {
    let marked = without_byte_order_mark(bytes);
    let blank = marked.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
    let (text, at) = (&marked[blank..], bytes.len() - marked.len() + blank);
    if python::is_python(text) {
        return match python::scene_from_keys(bytes, at, options) {
            Ok((scene, report)) => Ok(Imported::Scene(scene, report)),
            // Rows of numbers may stand below a line such as `N = 6`, which Python has too.
            Err(error) => import_text(bytes, at, scene, &Options { salvage: false, ..options.clone() })
                .map(|(file, report)| Imported::Text(file, report))
                .map_err(|_| error.into()),
        };
    }
    if is_object(text) {
        return keyframes_from_json(bytes, scene).map(Imported::KeyframeFile).map_err(|errors| {
            of_other_program(bytes, at).map_or(ImportError::KeyframeFile(errors), ImportError::Text)
        });
    }
    if text.is_empty() {
        return Err(TextError::new(bytes, at, TextProblem::Empty).into());
    }
    let is_zero = |index: usize| text.get(index) == Some(&0);
    let is_utf_16_of_digits = is_zero(1) && is_zero(3) || is_zero(0) && is_zero(2);
    if text.starts_with(b"\xff\xfe") || text.starts_with(b"\xfe\xff") || is_utf_16_of_digits {
        return Err(TextError::new(bytes, at, TextProblem::Utf16).into());
    }
    if let Some(error) = of_other_program(bytes, at) {
        return Err(error.into());
    }
    let read = import_text(bytes, at, scene, options).map_err(|error| TextError {
        can_be_salvaged: error.problem.is_of_counts() && !options.salvage && can_be_salvaged(bytes, at, scene, options),
        ..error
    });
    let (file, report) = read?;
    Ok(Imported::Text(file, report))
}

/// The error of a file that is a model or a motion of another program.
fn of_other_program(bytes: &[u8], at: usize) -> Option<TextError> {
    ModelFormat::of(bytes).map(|_| TextError::new(bytes, at, TextProblem::OtherProgram))
}

/// Whether a text begins as an object of JSON does: a brace, and then no row of numbers.
fn is_object(text: &[u8]) -> bool {
    let Some(inside) = text.strip_prefix(b"{") else { return false };
    let first = inside.trim_ascii_start().first();
    !first.is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.' | b'{'))
}

/// Whether a text that cannot be read has whole keyframes that can be.
fn can_be_salvaged(bytes: &[u8], at: usize, scene: &SceneGraph, options: &Options) -> bool {
    let options = Options { salvage: true, ..options.clone() };
    import_text(bytes, at, scene, &options).is_ok_and(|(file, _)| !file.keyframes.is_empty())
}

/// Reads a text of rows. `at` is the byte at which it begins.
fn import_text(
    bytes: &[u8],
    at: usize,
    scene: &SceneGraph,
    options: &Options,
) -> Result<(KeyframeFile, Report), TextError> {
    let mut plan = plan::plan(bytes, scene, options)?;
    if options.salvage && plan.keyframes == 0 {
        return Err(TextError::new(bytes, at, TextProblem::NothingToSalvage));
    }
    places::check(bytes, &mut plan)?;
    let keyframes = rows::keyframes(bytes, &mut plan, scene, options)?;
    let summary = texts::file_text_summary(
        texts::count_keyframes(keyframes.len()),
        texts::count_nodes(plan.nodes),
        plan.layout.name(),
    );
    let file = KeyframeFile { interpolation: None, ms_between_keyframes: None, keyframes };
    Ok((file, Report { summary, findings: plan.findings }))
}
