//! What students' own programs wrote: keyframes as text, in a dozen layouts, told apart by content; and the way back.
//!
//! Bytes in, keyframes with a report of what was inferred out; keyframes in, text out. This room knows no files and no windows. A text is
//! gone through several times and never copied: apart from the keyframes themselves, what reading takes does not grow with it, and counts
//! in a header are compared with what follows before anything is made of them.

mod csv;
mod error;
mod joints;
mod layout;
mod lexer;
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
use crate::scene::SceneGraph;
use crate::text::without_byte_order_mark;
use crate::words::texts;

/// What decides where a text leaves it open, or is wrong.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Which of a row's numbers come first; found by which are unit where it is not said.
    pub order: Option<FieldOrder>,
    /// Which node each row is; found by the offsets of keyframe 0 where it is not said.
    pub joints: Option<JointList>,
    /// Whether the whole keyframes of a broken text are taken.
    pub salvage: bool,
}

/// What an import gave.
#[derive(Clone, Debug)]
pub enum Imported {
    /// A keyframe file of this program's own format.
    KeyframeFile(KeyframeFile),
    /// Keyframes out of a text, and what was inferred.
    Text(KeyframeFile, Report),
    /// A control node's keys: the text of a scene file that has them, and what was inferred.
    Scene(String, Report),
}

/// Why nothing was imported.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ImportError {
    /// It looks like this program's own format and is wrong: a sentence for each problem, never empty.
    #[error("{}", .0.first().map(ToString::to_string).unwrap_or_default())]
    KeyframeFile(Vec<KeyframeFileError>),
    /// It is a text that cannot be read.
    #[error(transparent)]
    Text(#[from] TextError),
}

impl ImportError {
    /// A sentence for each problem.
    #[must_use]
    pub fn sentences(&self) -> Vec<String> {
        match self {
            Self::KeyframeFile(problems) => problems.iter().map(ToString::to_string).collect(),
            Self::Text(error) => vec![error.to_string()],
        }
    }
}

/// Reads keyframes for a scene: this program's own format, or any layout of text; the content decides which. A byte order mark is passed
/// over.
///
/// # Errors
/// [`ImportError`]: what is wrong, with its place.
pub fn import(bytes: &[u8], scene: &SceneGraph, options: &Options) -> Result<Imported, ImportError> {
    let marked = without_byte_order_mark(bytes);
    let blank = marked.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
    let (text, at) = (&marked[blank..], bytes.len() - marked.len() + blank);
    if python::is_python(text) {
        let (scene, report) = python::scene_from_keys(bytes, at)?;
        return Ok(Imported::Scene(scene, report));
    }
    if text.starts_with(b"{") {
        return keyframes_from_json(bytes, scene).map(Imported::KeyframeFile).map_err(ImportError::KeyframeFile);
    }
    if text.is_empty() {
        return Err(TextError::new(bytes, at, TextProblem::Empty).into());
    }
    if text.starts_with(b"\xff\xfe") || text.starts_with(b"\xfe\xff") {
        return Err(TextError::new(bytes, at, TextProblem::Utf16).into());
    }
    let (mut plan, named_order) = if csv::is_csv(text) {
        let (plan, order) = csv::plan(bytes, at, scene, options)?;
        (plan, Some(order))
    } else {
        (plan::plan(bytes, scene, options)?, None)
    };
    if options.salvage && plan.keyframes == 0 {
        return Err(TextError::new(bytes, at, TextProblem::NothingToSalvage).into());
    }
    let keyframes = rows::keyframes(bytes, &mut plan, named_order, scene, options)?;
    let summary = texts::file_text_summary(
        texts::count_keyframes(keyframes.len()),
        texts::count_nodes(plan.nodes),
        plan.layout.name(),
    );
    let file = KeyframeFile { interpolation: None, ms_between_keyframes: None, keyframes };
    Ok(Imported::Text(file, Report { summary, findings: plan.findings }))
}
