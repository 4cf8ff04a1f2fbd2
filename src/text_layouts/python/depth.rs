//! A bound on the nesting of a Python text. The parser and what reads its tree recurse, so it is checked before parsing.

use ruff_python_ast::token::TokenKind;
use ruff_python_parser::Mode;
use ruff_python_parser::lexer::lex;

use super::fault::Fault;
use crate::text_layouts::error::TextProblem;

/// The most brackets that are open at one place: as many as Python itself allows.
const MOST_BRACKETS: usize = 200;
/// The most levels of indentation: as many as Python itself allows.
const MOST_INDENTATIONS: usize = 100;
/// The most tokens of the expressions that are unfinished at one place. Each may be a level of the tree, as in `a + b + c`.
const MOST_TOKENS: usize = 1500;

/// Checks that a text nests no deeper than the stack allows.
///
/// # Errors
/// The place from which on it is too deep.
pub(super) fn check_depth(source: &str) -> Result<(), Fault> {
    if is_flat(source) {
        return Ok(());
    }
    // The lexer does not tell places: the longest start that is flat ends at the place.
    let (mut flat, mut deep) = (0, source.len());
    while deep - flat > 1 {
        let middle = source.floor_char_boundary(flat.midpoint(deep));
        if middle <= flat {
            break;
        }
        *(if is_flat(&source[..middle]) { &mut flat } else { &mut deep }) = middle;
    }
    Err(Fault::new(flat..deep, TextProblem::TooDeep))
}

fn is_flat(source: &str) -> bool {
    let mut lexer = lex(source, Mode::Module);
    let mut indentations = 0_usize;
    // The tokens of the unfinished expression in each bracket that is open.
    let mut unfinished = vec![Unfinished::default()];
    let mut tokens = 0_usize;
    loop {
        match lexer.next_token() {
            TokenKind::EndOfFile => return true,
            TokenKind::Comment | TokenKind::NonLogicalNewline => {}
            // They stand side by side in the tree.
            TokenKind::String | TokenKind::FStringMiddle | TokenKind::TStringMiddle => {}
            TokenKind::Newline => {
                unfinished = vec![Unfinished::default()];
                tokens = 0;
            }
            TokenKind::Indent => indentations += 1,
            TokenKind::Dedent => indentations = indentations.saturating_sub(1),
            TokenKind::Lpar | TokenKind::Lsqb | TokenKind::Lbrace => {
                count(&mut unfinished, &mut tokens);
                unfinished.push(Unfinished::default());
            }
            TokenKind::Rpar | TokenKind::Rsqb | TokenKind::Rbrace => {
                if unfinished.len() > 1
                    && let Some(closed) = unfinished.pop()
                {
                    tokens -= closed.tokens;
                }
            }
            kind @ (TokenKind::Comma | TokenKind::Semi) => {
                // What follows `lambda a,` and `yield a,` is still a part of it.
                if let Some(last) = unfinished.last_mut()
                    && (kind == TokenKind::Semi || !last.is_kept)
                {
                    tokens -= last.tokens;
                    *last = Unfinished::default();
                }
            }
            kind => {
                count(&mut unfinished, &mut tokens);
                if let Some(last) = unfinished.last_mut() {
                    last.is_kept |= matches!(kind, TokenKind::Lambda | TokenKind::Yield);
                }
            }
        }
        if unfinished.len() > MOST_BRACKETS || indentations > MOST_INDENTATIONS || tokens > MOST_TOKENS {
            return false;
        }
    }
}

/// The tokens of an unfinished expression.
#[derive(Default)]
struct Unfinished {
    tokens: usize,
    /// Whether they count on after a comma.
    is_kept: bool,
}

fn count(unfinished: &mut [Unfinished], tokens: &mut usize) {
    if let Some(last) = unfinished.last_mut() {
        last.tokens += 1;
        *tokens += 1;
    }
}
