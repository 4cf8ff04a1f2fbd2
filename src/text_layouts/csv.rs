//! CSV: `frame_num,rbt_ind,tx,ty,tz,rw,rx,ry,rz`, a row for each node of each keyframe.

use super::Options;
use super::error::{TextError, TextProblem, quoted};
use super::layout::{FieldOrder, Layout};
use super::lexer::{Lexer, Token, not_a_number};
use super::plan::{Plan, in_words, node_counts};
use super::report::Certainty;
use crate::scene::SceneGraph;
use crate::words::{Argument, texts};

/// The header, as it is written.
pub(super) const HEADER: &str = "frame_num,rbt_ind,tx,ty,tz,rw,rx,ry,rz";
const QUATERNION_FIRST_HEADER: &str = "frame_num,rbt_ind,rw,rx,ry,rz,tx,ty,tz";
const COLUMNS: usize = 9;

/// Whether a text begins with the start of the header.
pub(super) fn is_csv(text: &[u8]) -> bool {
    text.len() >= 9 && text[..9].eq_ignore_ascii_case(b"frame_num")
}

/// The plan of the rows, with the order that the header names. `at` is the byte at which the header begins.
///
/// # Errors
/// The first error; when salvaging, only if no keyframe is complete.
pub(super) fn plan(
    bytes: &[u8],
    at: usize,
    scene: &SceneGraph,
    options: &Options,
) -> Result<(Plan, FieldOrder), TextError> {
    let mut lexer = Lexer::new(bytes, at);
    let order = header(bytes, at, lexer.rest_of_line())?;
    let from = bytes.len() - lexer.rest().len();
    let mut counter = Counter { counts: node_counts(scene, options), ..Counter::default() };
    let mut row = Row::default();
    let mut end = bytes.len();
    let mut outcome = Ok(());
    for piece in lexer {
        outcome = match piece.token {
            Token::Number(value) if value.is_finite() => row.push(bytes, piece.at, value),
            Token::Separator(_) if row.columns > 0 => Ok(()),
            Token::LineEnd => row.finish(bytes, piece.at, &mut counter),
            _ => Err(not_a_number(bytes, piece, texts::TEXT_EXPECTED_NUMBER)),
        };
        if outcome.is_err() {
            end = piece.at;
            break;
        }
    }
    if outcome.is_ok() {
        outcome = row.finish(bytes, bytes.len(), &mut counter).and_then(|()| counter.finish(bytes));
    }
    let (nodes, keyframes) = (counter.nodes.unwrap_or(counter.counts[0]), counter.whole_keyframes());
    let mut plan =
        Plan { layout: Layout::Csv, from, end, skip: 0, lead: COLUMNS - 7, nodes, keyframes, findings: Vec::new() };
    plan.find(Certainty::Sure, format!("layout: CSV by its header; rbt_ind counts {nodes} nodes"));
    match outcome {
        Err(problem) if !options.salvage || keyframes == 0 => Err(problem),
        Err(problem) => {
            plan.find(Certainty::Warning, format!("salvaged: the rest is not read from here: {problem}"));
            Ok((plan, order))
        }
        Ok(()) => Ok((plan, order)),
    }
}

fn header(bytes: &[u8], at: usize, line: &[u8]) -> Result<FieldOrder, TextError> {
    let text: String = String::from_utf8_lossy(line).chars().filter(|letter| !letter.is_whitespace()).collect();
    let names = text.trim_end_matches([',', ';']).replace(';', ",").to_lowercase();
    match names.as_str() {
        HEADER => Ok(FieldOrder::TranslationFirst),
        QUATERNION_FIRST_HEADER => Ok(FieldOrder::QuaternionFirst),
        _ => {
            let problem = TextProblem::Unexpected {
                found: quoted(line.trim_ascii_end()).into(),
                expected: texts::text_expected_header(HEADER).into(),
            };
            Err(TextError::new(bytes, at, problem))
        }
    }
}

/// A row as far as it was read.
#[derive(Default)]
struct Row {
    at: usize,
    columns: usize,
    index: [f32; 2],
    index_at: [usize; 2],
}

impl Row {
    fn push(&mut self, bytes: &[u8], at: usize, value: f32) -> Result<(), TextError> {
        if self.columns == 0 {
            self.at = at;
        }
        if self.columns == COLUMNS {
            let (found, expected) = (value.into(), texts::text_found_end_of_line(COLUMNS).into());
            return Err(TextError::new(bytes, at, TextProblem::Unexpected { found, expected }));
        }
        if let Some(index) = self.index.get_mut(self.columns) {
            (*index, self.index_at[self.columns]) = (value, at);
        }
        self.columns += 1;
        Ok(())
    }

    fn finish(&mut self, bytes: &[u8], at: usize, counter: &mut Counter) -> Result<(), TextError> {
        let row = std::mem::take(self);
        match row.columns {
            0 => Ok(()),
            COLUMNS => counter.row(bytes, &row),
            found => {
                let found = texts::text_found_end_of_line(found).into();
                let expected = texts::text_expected_numbers(COLUMNS).into();
                let problem = TextProblem::Unexpected { found, expected };
                Err(TextError::new(bytes, at, problem))
            }
        }
    }
}

/// Counts keyframes and nodes by the first two columns.
#[derive(Default)]
struct Counter {
    counts: Vec<usize>,
    nodes: Option<usize>,
    keyframes: usize,
    in_keyframe: usize,
    frame_number: f32,
    row_at: usize,
}

impl Counter {
    fn row(&mut self, bytes: &[u8], row: &Row) -> Result<(), TextError> {
        let [frame_number, node] = row.index;
        let unexpected = |column: usize, expected: Argument| {
            let name = ["frame_num", "rbt_ind"][column];
            let problem = TextProblem::Unexpected { found: format!("{name} {}", row.index[column]).into(), expected };
            TextError::new(bytes, row.index_at[column], problem)
        };
        let is_first = self.keyframes == 0 && self.in_keyframe == 0;
        #[expect(clippy::cast_precision_loss, reason = "a frame has far fewer than 2^24 nodes")]
        let next_node = self.in_keyframe as f32;
        if is_first {
            if frame_number.fract() != 0.0 {
                return Err(unexpected(0, texts::TEXT_EXPECTED_WHOLE_NUMBER.into()));
            }
            self.frame_number = frame_number;
        } else if frame_number != self.frame_number {
            let nodes = self.in_keyframe;
            if nodes != self.nodes.unwrap_or(nodes) {
                return Err(unexpected(0, texts::text_expected_row(nodes, self.frame_number).into()));
            }
            self.whole(bytes)?;
            if frame_number != self.frame_number + 1.0 {
                return Err(unexpected(0, (self.frame_number + 1.0).into()));
            }
            (self.frame_number, self.in_keyframe) = (frame_number, 0);
            return self.node(node, 0.0, row, &unexpected);
        }
        self.node(node, next_node, row, &unexpected)
    }

    fn node(
        &mut self,
        node: f32,
        next: f32,
        row: &Row,
        unexpected: &dyn Fn(usize, Argument) -> TextError,
    ) -> Result<(), TextError> {
        if node != next || self.nodes == Some(self.in_keyframe) {
            return Err(unexpected(1, next.into()).or_next_frame(self.nodes == Some(self.in_keyframe)));
        }
        self.in_keyframe += 1;
        self.row_at = row.at;
        Ok(())
    }

    /// The first keyframe defines the number of nodes.
    fn whole(&mut self, bytes: &[u8]) -> Result<(), TextError> {
        let found = self.in_keyframe;
        if !self.counts.contains(&found) {
            let expected = in_words(&self.counts);
            return Err(TextError::new(bytes, self.row_at, TextProblem::NodeCount { found, expected }));
        }
        self.nodes = Some(found);
        self.keyframes += 1;
        Ok(())
    }

    fn finish(&mut self, bytes: &[u8]) -> Result<(), TextError> {
        if self.in_keyframe == 0 {
            return Ok(());
        }
        match self.nodes {
            Some(nodes) if nodes != self.in_keyframe => {
                let found = (self.keyframes * nodes + self.in_keyframe) * 7;
                let problem = TextProblem::Incomplete { found, nodes, width: 7, hint: None };
                Err(TextError::new(bytes, bytes.len(), problem))
            }
            _ => self.whole(bytes).inspect(|()| self.in_keyframe = 0),
        }
    }

    /// The number of complete keyframes, including the one being read if it is complete.
    fn whole_keyframes(&self) -> usize {
        self.keyframes + usize::from(self.nodes.is_some_and(|nodes| nodes == self.in_keyframe))
    }
}

impl TextError {
    /// After a complete frame the next one is expected.
    fn or_next_frame(mut self, is_full: bool) -> Self {
        if let (TextProblem::Unexpected { expected, .. }, true) = (&mut self.problem, is_full) {
            *expected = texts::TEXT_EXPECTED_NEXT_FRAME.into();
        }
        self
    }
}
