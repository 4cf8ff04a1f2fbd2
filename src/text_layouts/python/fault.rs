//! What is wrong at a place of a Python text.

use std::ops::Range;

use ruff_text_size::{Ranged, TextRange};

use crate::text_layouts::error::{TextProblem, quoted};
use crate::words::{Argument, texts};

/// A problem at a place of the text that was parsed.
#[derive(Clone, Debug)]
pub(super) struct Fault {
    /// The offset of its first byte.
    pub(super) at: usize,
    /// The problem.
    pub(super) problem: TextProblem,
}

impl Fault {
    /// A problem of a range of bytes.
    pub(super) fn new(range: Range<usize>, problem: TextProblem) -> Self {
        Self { at: range.start, problem }
    }

    /// A problem of an expression or statement.
    pub(super) fn of(node: impl Ranged, problem: TextProblem) -> Self {
        Self::new(range_of(node.range()), problem)
    }

    /// An expression that is not what is expected there.
    pub(super) fn unexpected(source: &str, node: impl Ranged, expected: impl Into<Argument>) -> Self {
        let found = quoted_node(source, node.range());
        Self::of(node, TextProblem::Unexpected { found, expected: expected.into() })
    }

    /// An expression whose value is known only when the program runs.
    pub(super) fn unknown(source: &str, node: impl Ranged) -> Self {
        let found = quoted_node(source, node.range());
        Self::of(node, TextProblem::Unknown { found })
    }

    /// A number that is not finite.
    pub(super) fn not_finite(source: &str, node: impl Ranged) -> Self {
        let found: String = source[range_of(node.range())].chars().take(40).collect();
        Self::of(node, TextProblem::NotFinite { found })
    }
}

/// The bytes of a node.
fn range_of(range: TextRange) -> Range<usize> {
    range.start().to_usize()..range.end().to_usize()
}

/// The first line of an expression, quoted.
fn quoted_node(source: &str, range: TextRange) -> Argument {
    let text = source[range_of(range)].lines().next().unwrap_or_default();
    if text.is_empty() { texts::TEXT_FOUND_END_OF_FILE.into() } else { quoted(text.as_bytes()).into() }
}
