//! Traces of scripts: reading them, and comparing them with what should be there.

use serde_json::Value;

use super::Verdict;
use super::folder::{self, Traced};
use crate::decode;
use crate::text::str_without_byte_order_mark;

/// Reads a trace: an object of JSON on each line, as `script --trace` prints them. At most one line more than can be right is read.
///
/// # Errors
/// A sentence with the line.
pub fn objects(bytes: &[u8]) -> Result<Vec<Value>, String> {
    let text = std::str::from_utf8(bytes).map_err(|error| format!("not UTF-8 at byte {}", error.valid_up_to()))?;
    let lines = (1..).zip(str_without_byte_order_mark(text).lines()).filter(|(_, line)| !line.trim().is_empty());
    let values = lines
        .take(folder::MOST_LINES + 1)
        .map(|(number, line)| decode::json(line.as_bytes()).map_err(|error| error.in_line(number).to_string()));
    values.collect()
}

/// The result of a run in the form of a trace.
pub fn objects_of(run: &[Traced]) -> Vec<Value> {
    let object =
        |traced: &Traced| traced.state.fields().into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
    run.iter().map(|traced| Value::Object(object(traced))).collect()
}

/// Whether the states after each command are the expected ones; `what` says where the found ones are from.
pub fn compared(what: &str, found: &[Value], expected: &[Traced]) -> Verdict {
    let total = expected.len();
    for (step, Traced { command, state, .. }) in expected.iter().enumerate() {
        let Some(found) = found.get(step) else {
            return Verdict::unmet(format!("{what}: the trace ends after {step} of {total} commands."));
        };
        for (field, expected) in state.fields() {
            let found = found.get(field).unwrap_or(&Value::Null);
            if !is_same(found, &expected) {
                let number = step + 1;
                return Verdict::unmet(format!(
                    "{what}: after command {number} ({command}), {field} is {found}, expected {expected}."
                ));
            }
        }
    }
    if found.len() > total {
        return Verdict::unmet(format!("{what}: {} commands, expected {total}.", found.len()));
    }
    Verdict::met(format!("{what}: all {total} commands match."))
}

/// Numbers are the same where they agree to a millionth.
fn is_same(found: &Value, expected: &Value) -> bool {
    match (found.as_f64(), expected.as_f64()) {
        (Some(found), Some(expected)) => (found - expected).abs() <= 1e-6,
        _ => found == expected,
    }
}
