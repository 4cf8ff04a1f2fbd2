//! Traces in few bytes, without loss.
//!
//! A line of a trace becomes `LINE STATE<tab>MESSAGE`; the state is left out where it is that of the line before. The command is left
//! out too: it is the script's line. Each line is put together again and compared with the original, so that nothing can be lost.
//!
//! `drag begin`, `drag move`, `drag turn`, `drag end` and `drag cancel` used to say the last sentence again. Such repeated sentences
//! are marked with `~`. [`repeats`] decides which they are, and `main.rs` counts them as nothing said.

use serde_json::Value;
use std::fmt::Write as _;

/// A trace in few bytes.
pub fn compact(trace: &str, script: &str) -> String {
    let lines: Vec<&str> = script.lines().collect();
    let mut state = String::new();
    let mut text = String::new();
    for line in trace.lines() {
        let value: Value = serde_json::from_str(line).expect("a trace is JSON");
        let number = value["line"].as_u64().expect("lines have numbers");
        let command = value["command"].as_str().expect("lines have commands");
        let message = value["message"].as_str().expect("lines have messages");
        let (head, rest) = line.split_once("\"keyframes\": ").expect("lines have states");
        assert_eq!(
            head,
            format!("{{\"line\": {number}, \"command\": {}, \"message\": {}, ", quoted(command), quoted(message))
        );
        let written = lines[usize::try_from(number).expect("scripts are short") - 1].trim();
        assert!(written.starts_with(command), "line {number} is {written:?}, and the trace says {command:?}");
        let shown = shortened(rest);
        assert!(!message.contains(['\n', '\t', '~']));
        let mark = if repeats(command, message) { "~" } else { "" };
        let said = if shown == state { String::new() } else { format!(" {shown}") };
        let _ = writeln!(text, "{number}{said}\t{mark}{message}");
        state = shown;
    }
    text
}

fn quoted(text: &str) -> String {
    Value::from(text).to_string()
}

/// The state without its field names: the values in their order.
fn shortened(rest: &str) -> String {
    let names =
        ["\"current\": ", "\"playing\": ", "\"key_time\": ", "\"ms_between_keyframes\": ", "\"interpolation\": "];
    let mut shown = rest.strip_suffix('}').expect("an object ends").to_owned();
    for name in names {
        let with_comma = format!(", {name}");
        assert_eq!(shown.matches(&with_comma).count(), 1);
        shown = shown.replacen(&with_comma, " ", 1);
    }
    shown
}

/// Whether a line of a drag says what another line said before it: all but its own sentences.
fn repeats(command: &str, message: &str) -> bool {
    let Some(rest) = command.strip_prefix("drag ") else { return false };
    let own: &[&str] = match rest.split_whitespace().next() {
        Some("begin") => &["Cannot "],
        Some("move" | "turn") => &["There is no drag to go on with.", "That is not a position"],
        Some("end") => &["updated by auto-key."],
        _ => &["Drag taken back."],
    };
    !message.is_empty() && !own.iter().any(|own| message.contains(own))
}
