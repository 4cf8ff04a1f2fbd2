//! The text of a scene file whose control node has the keys of a group.

use super::keys::{Keys, Value};
use crate::json::{push_f32, push_f32s};

/// The text of a scene file with a box that the keys move.
pub(super) fn scene_text(keys: &Keys) -> String {
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
