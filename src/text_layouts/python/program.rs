//! A program as a text: parsed, with what students' texts need to be forgiven, and with the places of its problems.

use std::borrow::Cow;

use ruff_python_ast::token::TokenKind;
use ruff_python_ast::{Mod, Stmt};
use ruff_python_parser::{LexicalErrorType, Mode, ParseError, ParseErrorType, ParseOptions, parse_unchecked};

use super::depth::check_depth;
use super::fault::Fault;
use super::groups::{Group, groups};
use crate::parallel::with_stack;
use crate::text::line_and_column;
use crate::text_layouts::error::{TextError, TextProblem, quoted};
use crate::words::texts;

/// The largest program that is read, in MiB. Its tree takes some fifty times the memory.
const LARGEST_MIB: usize = 4;
/// The stack for parsing and walking. What `depth` lets through needs less, also without optimisation.
const STACK_BYTES: usize = 128 << 20;

/// What makes dictionaries that were copied from between the arguments of a call a program again.
const CALL: [&str; 2] = ["keys(", "\n)"];

/// A program that is read.
pub(super) struct Program<'a> {
    bytes: &'a [u8],
    /// The offset of the source in the bytes.
    from: usize,
}

impl<'a> Program<'a> {
    /// The program that begins at a byte.
    pub(super) fn new(bytes: &'a [u8], from: usize) -> Self {
        Self { bytes, from }
    }

    /// Its groups of keys.
    ///
    /// # Errors
    /// A text that is no Python, or too large.
    pub(super) fn groups(&self) -> Result<Vec<Group>, TextError> {
        if self.bytes.len() - self.from > LARGEST_MIB << 20 {
            return Err(self.error_at(0, TextProblem::TooLarge { limit: LARGEST_MIB }));
        }
        let source = self.source();
        with_stack(STACK_BYTES, || groups_of(&source)).map_err(|fault| self.error(&fault))
    }

    /// The text. In one that is not UTF-8, as older editors write accents, each such byte is taken as a letter: places stay the same.
    fn source(&self) -> Cow<'a, str> {
        let bytes = &self.bytes[self.from..];
        match std::str::from_utf8(bytes) {
            Ok(source) => source.into(),
            Err(_) => bytes
                .iter()
                .map(|&byte| if byte.is_ascii() { char::from(byte) } else { 'x' })
                .collect::<String>()
                .into(),
        }
    }

    /// A problem as an error with its location.
    pub(super) fn error(&self, fault: &Fault) -> TextError {
        self.error_at(fault.at, fault.problem.clone())
    }

    /// A problem at an offset of the source.
    pub(super) fn error_at(&self, at: usize, problem: TextProblem) -> TextError {
        TextError::new(self.bytes, self.from + at, problem)
    }

    /// The line of an offset of the source.
    pub(super) fn line(&self, at: usize) -> usize {
        line_and_column(self.bytes, self.from + at).0
    }
}

fn groups_of(source: &str) -> Result<Vec<Group>, Fault> {
    check_depth(source)?;
    let module = match parsed(source) {
        Ok(module) => module,
        Err(fault) => return groups_of_arguments(source).ok_or(fault),
    };
    Ok(groups(source, &module))
}

/// The groups of dictionaries that were copied from between the arguments of a call: `translate_keys={…}, rotate_keys={…}`.
fn groups_of_arguments(source: &str) -> Option<Vec<Group>> {
    let mut start = 0;
    for line in source.split_inclusive('\n') {
        let text = line.trim_start();
        if !(text.is_empty() || ["#", "import ", "from "].iter().any(|word| text.starts_with(word))) {
            break;
        }
        start += line.len();
    }
    let (before, arguments) = source.split_at(start);
    let called = [before, CALL[0], arguments, CALL[1]].concat();
    let module = parsed(&called).ok()?;
    let mut groups = groups(&called, &module);
    let shifted = |at: usize| if at < start + CALL[0].len() { at.min(start) } else { at - CALL[0].len() };
    for group in &mut groups {
        group.at = shifted(group.at);
        if let Err(fault) = &mut group.keys {
            fault.at = shifted(fault.at);
        }
    }
    Some(groups)
}

/// The statements of a module.
///
/// # Errors
/// The first error that is not forgiven.
fn parsed(source: &str) -> Result<Vec<Stmt>, Fault> {
    let parsed = parse_unchecked(source, ParseOptions::from(Mode::Module));
    let is_indented = parsed.errors().iter().any(is_of_indentation);
    let is_forgiven = |error: &&ParseError| {
        is_of_indentation(error)
            || error.error == ParseErrorType::SimpleStatementsOnSameLine
            || (is_indented && follows_from_indentation(error))
    };
    let errors = parsed.errors().iter().filter(|error| !is_forgiven(error));
    if let Some(error) = errors.min_by_key(|error| error.location.start()) {
        return Err(syntax_fault(source, error));
    }
    match parsed.into_syntax() {
        Mod::Module(module) => Ok(module.body),
        Mod::Expression(_) => Ok(Vec::new()),
    }
}

/// Whether an error does not keep from reading: lines that were cut out of a program keep their indentation.
fn is_of_indentation(error: &ParseError) -> bool {
    matches!(
        error.error,
        ParseErrorType::UnexpectedIndentation | ParseErrorType::Lexical(LexicalErrorType::IndentationError)
    )
}

/// Whether an error is what the parser says at the end of such lines.
fn follows_from_indentation(error: &ParseError) -> bool {
    match &error.error {
        ParseErrorType::ExpectedToken { expected, .. } => *expected == TokenKind::Dedent,
        ParseErrorType::OtherError(_) => error.location.is_empty(),
        _ => false,
    }
}

/// What was found where the parser expected something else.
fn syntax_fault(source: &str, error: &ParseError) -> Fault {
    let at = error.location.start().to_usize();
    let line = source[at..].lines().next().unwrap_or_default().trim_end();
    let found = match line {
        "" if source[at..].trim_ascii().is_empty() => texts::TEXT_FOUND_END_OF_FILE.into(),
        "" => texts::TEXT_FOUND_LINE_END.into(),
        line => quoted(line.as_bytes()).into(),
    };
    let expected = match &error.error {
        ParseErrorType::ExpectedToken { expected, .. } => match expected.to_string().trim_matches('`') {
            sign if sign.chars().all(|letter| letter.is_ascii_punctuation()) => format!("{sign:?}").into(),
            _ => texts::TEXT_EXPECTED_PYTHON.into(),
        },
        ParseErrorType::ExpectedExpression => texts::TEXT_EXPECTED_EXPRESSION.into(),
        ParseErrorType::Lexical(LexicalErrorType::Eof) => texts::TEXT_EXPECTED_CLOSING_BRACKET.into(),
        ParseErrorType::Lexical(LexicalErrorType::UnclosedStringError) => texts::TEXT_EXPECTED_CLOSING_QUOTE.into(),
        _ => texts::TEXT_EXPECTED_PYTHON.into(),
    };
    Fault { at, problem: TextProblem::Unexpected { found, expected } }
}
