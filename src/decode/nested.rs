//! JSON whose brackets stand within each other more deeply than serde_json reads by default.

use std::thread;

use serde::de::DeserializeOwned;

use super::DecodeError;
use crate::text::{line_and_column, without_byte_order_mark};
use crate::words::texts;

/// Stack for reading brackets within each other: for each level several times what an unoptimised build needs, and some for a start.
const STACK_BYTES_PER_LEVEL: usize = 64 << 10;
/// Brackets within each other that need no room of their own.
const SHALLOW_LEVELS: usize = 24;

/// Reads JSON whose brackets stand within each other up to `most_levels` deep, and hands it to `then`. That has room on the stack for the
/// same depth, however small the caller's stack is.
///
/// # Errors
/// [`DecodeError`]
pub fn nested_json<T: DeserializeOwned, R: Send>(
    bytes: &[u8],
    most_levels: usize,
    then: impl FnOnce(T) -> R + Send,
) -> Result<R, DecodeError> {
    let bytes = without_byte_order_mark(bytes);
    // What is shallow has room on any stack.
    if deeper_than(bytes, SHALLOW_LEVELS).is_none() {
        return super::json(bytes).map(then);
    }
    if let Some(at) = deeper_than(bytes, most_levels) {
        let (line, column) = line_and_column(bytes, at);
        return Err(DecodeError { line, column, problem: texts::decode_too_deep(most_levels) });
    }
    let deep = || {
        let mut reader = serde_json::Deserializer::from_slice(bytes);
        reader.disable_recursion_limit();
        super::whole(bytes, &mut reader).map(then)
    };
    if cfg!(target_arch = "wasm32") {
        // A page has one thread, whose stack is large.
        return deep();
    }
    let room = thread::Builder::new().stack_size((most_levels + 64) * STACK_BYTES_PER_LEVEL);
    thread::scope(|scope| match room.spawn_scoped(scope, deep) {
        Ok(reader) => reader.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
        Err(_) => Err(DecodeError { line: 1, column: 1, problem: texts::decode_too_deep(SHALLOW_LEVELS) }),
    })
}

/// Where in a text a bracket stands within more than so many others.
fn deeper_than(text: &[u8], most_levels: usize) -> Option<usize> {
    let mut depth = 0_usize;
    let mut bytes = text.iter().enumerate();
    while let Some((at, byte)) = bytes.next() {
        match byte {
            b'"' => {
                while bytes.next().is_some_and(|(_, &byte)| byte != b'"' && (byte != b'\\' || bytes.next().is_some())) {
                }
            }
            b'[' | b'{' => {
                depth += 1;
                if depth > most_levels {
                    return Some(at);
                }
            }
            b']' | b'}' => depth = depth.saturating_sub(1),
            _ => {}
        }
    }
    None
}
