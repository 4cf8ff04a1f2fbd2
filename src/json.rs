//! What the JSON formats share: how a parse error reads, and how numbers are written.

use std::fmt::Write as _;

use crate::rbt::Rbt;

/// A parse error as a sentence that ends with its place: `line L column C`.
#[must_use]
pub fn sentence(error: &serde_json::Error) -> String {
    let text = error.to_string();
    if text.contains(" at line ") { text } else { format!("{text} at line {} column {}", error.line(), error.column()) }
}

/// Appends a finite number in its shortest form that reads back to the same value: `0.25`, `4`, `1e-7`, `-0`.
pub fn push_f32(text: &mut String, number: f32) {
    debug_assert!(number.is_finite(), "JSON has no {number}");
    let _ = write!(text, "{number:?}");
    if text.ends_with(".0") {
        text.truncate(text.len() - 2);
    }
}

/// The same for a number of twice the precision.
pub fn push_f64(text: &mut String, number: f64) {
    debug_assert!(number.is_finite(), "JSON has no {number}");
    let _ = write!(text, "{number:?}");
    if text.ends_with(".0") {
        text.truncate(text.len() - 2);
    }
}

/// Appends numbers as an array: `[0, 0.25, 4]`.
pub fn push_f32s(text: &mut String, numbers: &[f32]) {
    text.push('[');
    for (place, &number) in numbers.iter().enumerate() {
        if place > 0 {
            text.push_str(", ");
        }
        push_f32(text, number);
    }
    text.push(']');
}

/// Appends `{ "translation": [x, y, z], "rotation": [x, y, z, w] }`.
pub fn push_rbt(text: &mut String, rbt: &Rbt) {
    text.push_str("{ \"translation\": ");
    push_f32s(text, &rbt.translation.to_array());
    text.push_str(", \"rotation\": ");
    push_f32s(text, &rbt.rotation.to_array());
    text.push_str(" }");
}
