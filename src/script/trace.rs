//! The output of a script: a JSON object for each line, and the state at the end.

use std::fmt::Write as _;

use serde_json::Value;

use super::parse::Line;
use crate::editor::Editor;
use crate::interpolation::Interpolation;
use crate::json::{push_quoted, push_rbts, push_strings};
use crate::keyframe::KeyframeIndex;

/// The state of the editor in a trace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// How many keyframes there are.
    pub keyframes: usize,
    /// The index of the current one.
    pub current: Option<usize>,
    /// Whether something plays.
    pub is_playing: bool,
    /// The key time that is displayed while something plays.
    pub key_time: Option<f64>,
    /// Milliseconds between keyframes.
    pub ms_between_keyframes: u32,
    /// The document's interpolation.
    pub interpolation: Interpolation,
}

impl State {
    /// The state of an editor.
    #[must_use]
    pub fn of(editor: &Editor) -> Self {
        let document = editor.document();
        Self {
            keyframes: document.keyframes.len(),
            current: document.keyframes.current().map(KeyframeIndex::get),
            is_playing: editor.is_playing(),
            key_time: editor.key_time().filter(|_| editor.is_playing()),
            ms_between_keyframes: document.ms_between_keyframes,
            interpolation: document.interpolation,
        }
    }

    /// The state as a trace has it: names and values, in their order.
    #[must_use]
    pub fn fields(&self) -> [(&'static str, Value); 6] {
        [
            ("keyframes", self.keyframes.into()),
            ("current", self.current.into()),
            ("playing", self.is_playing.into()),
            ("key_time", self.key_time.into()),
            ("ms_between_keyframes", self.ms_between_keyframes.into()),
            ("interpolation", self.interpolation.name().into()),
        ]
    }

    /// Appends `"keyframes": …` to `"interpolation": …`, without braces.
    fn push(&self, text: &mut String) {
        for (index, (name, value)) in self.fields().into_iter().enumerate() {
            let separator = if index == 0 { "" } else { ", " };
            // Key times keep their point, as in `2.0`, and large ones have no exponent until Rust's own form has.
            let _ = match value.as_f64().filter(|_| value.is_f64()) {
                Some(number) => write!(text, "{separator}\"{name}\": {number:?}"),
                None => write!(text, "{separator}\"{name}\": {value}"),
            };
        }
    }
}

/// A line of a trace.
#[derive(Clone, Debug)]
pub struct TraceLine<'a> {
    /// The line.
    pub line: &'a Line,
    /// The message in English; empty if there is none.
    pub message: String,
    /// Whether the message refuses what the line asks for. The trace does not say it.
    pub is_refusal: bool,
    /// The state after it.
    pub state: State,
}

impl TraceLine<'_> {
    /// A JSON object on a line.
    #[must_use]
    pub fn json(&self) -> String {
        let mut text = format!("{{\"line\": {}, \"command\": ", self.line.number);
        push_quoted(&mut text, &self.line.text);
        text.push_str(", \"message\": ");
        push_quoted(&mut text, &self.message);
        text.push_str(", ");
        self.state.push(&mut text);
        text.push_str("}\n");
        text
    }
}

/// The state at the end: what the trace says of it, the nodes, and the pose displayed.
#[must_use]
pub fn state_json(editor: &Editor) -> String {
    let mut text = String::from("{");
    State::of(editor).push(&mut text);
    text.push_str(", \"nodes\": ");
    push_strings(&mut text, editor.scene().rbt_paths());
    text.push_str(", \"pose\": ");
    push_rbts(&mut text, editor.displayed_pose().iter());
    text.push_str("}\n");
    text
}
