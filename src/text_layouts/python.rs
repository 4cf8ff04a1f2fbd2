//! Converts Python dictionaries of timed keys, such as `{0: vec(0, 0, 0), 2: vec(1, 1, 0)}`, to a scene file with a control node.

mod functions;
mod parser;

use super::error::{TextError, TextProblem};
use super::report::{Certainty, Report};
use crate::json::{push_f32, push_f32s};
use crate::words::texts;
use parser::{Keys, Parser, Value};

/// Whether a text that does not begin with a blank is Python: a dictionary of keys, an assignment, an import or a comment.
pub(super) fn is_python(text: &[u8]) -> bool {
    let mut text = text;
    // No other layout has comments.
    while text.starts_with(b"#") {
        let line = text.iter().position(|&byte| byte == b'\n').unwrap_or(text.len());
        text = text[line..].trim_ascii_start();
    }
    if let Some(inside) = text.strip_prefix(b"{") {
        let number = inside.trim_ascii_start();
        let digits =
            number.iter().take_while(|byte| matches!(byte, b'0'..=b'9' | b'+' | b'-' | b'.' | b'e' | b'E')).count();
        return digits > 0 && number[digits..].trim_ascii_start().starts_with(b":");
    }
    let name = text.iter().take_while(|byte| byte.is_ascii_alphanumeric() || **byte == b'_').count();
    let after = text[name..].trim_ascii_start();
    let is_name = name > 0 && !text[0].is_ascii_digit();
    is_name && (after.starts_with(b"=") || matches!(&text[..name], b"import" | b"from"))
}

/// The text of a scene file whose control node has the keys of a Python text. `at` is the byte offset of the text's start.
///
/// # Errors
/// The first error, with its location.
pub(super) fn scene_from_keys(bytes: &[u8], at: usize) -> Result<(String, Report), TextError> {
    let mut parser = Parser::new(bytes, at);
    let keys = parser.keys()?;
    if keys.translations.is_empty() && keys.rotations.is_empty() && keys.scales.is_empty() {
        let (found, expected) = (texts::TEXT_FOUND_END_OF_FILE.into(), texts::TEXT_EXPECTED_SOME_KEYS.into());
        let problem = TextProblem::Unexpected { found, expected };
        return Err(TextError::new(bytes, bytes.len(), problem));
    }
    let mut report = Report::new(texts::file_keys_summary(
        texts::count_translations(keys.translations.len()),
        texts::count_rotations(keys.rotations.len()),
        texts::count_scales(keys.scales.len()),
    ));
    report.add(Certainty::Sure, "layout: Python dictionaries of keys; times in seconds");
    if keys.has_quaternions {
        report.add(
            Certainty::Likely,
            "quaternion(x, y, z, w): the components in this order, as the course's module has it",
        );
    }
    if keys.has_euler_angles {
        report.add(
            Certainty::Sure,
            "quaternion_from_euler(yaw, pitch, roll): degrees about z, y and x, as in scene files",
        );
    }
    report.add(Certainty::Note, "the scene has a box to be moved, a ground and a camera of its own");
    Ok((scene_text(&keys), report))
}

fn scene_text(keys: &Keys) -> String {
    let mut text = String::from(
        "{\n  \"format\": \"inbetween.scene\",\n  \"version\": 1,\n  \"name\": \"imported-keys\",\n  \"eyes\": [\"sky\"],\n  \
         \"nodes\": [\n    { \"name\": \"sky\", \"translation\": [0, 0.25, 8] },\n    {\n      \"name\": \"ground\",\n      \
         \"children\": [\n        { \"name\": \"plane\", \"shape\": { \"plane\": { \"size\": [400, 400] } }, \"colour\": \"#7d8791\", \
         \"translation\": [0, -2, 0] }\n      ]\n    },\n    {\n      \"name\": \"keyed\",\n      \"control\": {",
    );
    let fields = [("translation", &keys.translations), ("rotation", &keys.rotations), ("scale", &keys.scales)];
    let given = fields.into_iter().filter(|(_, keys)| !keys.is_empty());
    for (index, (field, keys)) in given.enumerate() {
        text.push_str(if index == 0 { "\n" } else { ",\n" });
        text.push_str("        \"");
        text.push_str(field);
        text.push_str("\": [");
        for (index, (seconds, value)) in keys.iter().enumerate() {
            text.push_str(if index == 0 { "\n          [" } else { ",\n          [" });
            text.push_str(&seconds.to_string());
            text.push_str(", ");
            match value {
                Value::Number(number) => push_f32(&mut text, *number),
                Value::Vector(vector) => push_f32s(&mut text, &vector.to_array()),
                Value::Rotation(rotation) => push_f32s(&mut text, &rotation.to_array()),
            }
            text.push(']');
        }
        text.push_str("\n        ]");
    }
    text.push_str(
        "\n      },\n      \"children\": [\n        { \"name\": \"box\", \"shape\": { \"box\": { \"size\": [1, 1, 1], \"bevel\": 0.05 } }, \
         \"colour\": \"#e07b39\" }\n      ]\n    }\n  ]\n}\n",
    );
    text
}
