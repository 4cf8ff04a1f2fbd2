//! What a file of a submission is: its content decides, not its name.

use serde_json::Value;

use super::note::Note;
use crate::keyframe::KeyframeFile;
use crate::scene::SceneGraph;
use crate::script;
use crate::text::without_byte_order_mark;
use crate::text_layouts::{ImportError, Imported, Options, TextError, TextProblem, import};

/// How many bytes of a file tell what it is.
const START_BYTES: usize = 64 << 10;
/// How many lines of a file tell whether it is a script.
const START_LINES: usize = 40;

/// What a file is.
pub enum Content {
    /// Keyframes, with what was inferred of a text's layout.
    Keyframes(KeyframeFile, Option<Note>),
    /// It may be meant as keyframes, and cannot be read as such: a sentence for each problem.
    Unreadable(Unreadable),
    /// Samples of playback.
    Samples,
    /// A trace of a script.
    Trace,
    /// A script.
    Script,
}

/// A file that holds no keyframes.
pub struct Unreadable {
    /// Why: a sentence.
    pub problem: String,
    /// Whether it holds nothing but blanks.
    pub is_empty: bool,
    /// Whether it looks as if keyframes were meant: a JSON object with names of this program's format, or mostly numbers.
    pub is_alike: bool,
    /// Whether it is a program without keys, as others than keyframes are handed in with.
    pub is_source: bool,
}

/// Determines what a file is, and reads keyframes.
#[must_use]
pub fn content_of(bytes: &[u8], scene: &SceneGraph) -> Content {
    let start = without_byte_order_mark(&bytes[..bytes.len().min(START_BYTES)]);
    let start = String::from_utf8_lossy(start);
    let first = start.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or_default();
    if is_samples_header(first) {
        return Content::Samples;
    }
    if is_trace_line(first) {
        return Content::Trace;
    }
    if is_script(&start) {
        return Content::Script;
    }
    let (problems, is_source) = match import(bytes, scene, &Options::of_keyframes()) {
        Ok(Imported::KeyframeFile(file)) => return Content::Keyframes(file, None),
        Ok(Imported::Text(file, _)) if file.keyframes.is_empty() => {
            let is_alike = is_alike(&start, bytes);
            return Content::Unreadable(Unreadable {
                problem: "it holds no keyframes".to_owned(),
                is_empty: false,
                is_alike,
                is_source: false,
            });
        }
        Ok(Imported::Text(file, report)) => {
            let text = report.to_string().replace('\n', "; ");
            return Content::Keyframes(file, Some(Note { text, wants_a_look: !report.is_sure() }));
        }
        Ok(Imported::Scene(..)) => {
            let problem = "these are the keys of a control node, not keyframes".to_owned();
            return Content::Unreadable(Unreadable { problem, is_empty: false, is_alike: true, is_source: false });
        }
        Err(error) => {
            let is_source = matches!(&error, ImportError::Text(TextError { problem: TextProblem::NoKeys, .. }));
            (error.sentences(), is_source)
        }
    };
    let more = if problems.len() > 1 { format!(" (and {} more problems)", problems.len() - 1) } else { String::new() };
    let problem = format!("{}{more}", problems.first().map_or("", String::as_str));
    let is_alike = !is_source && is_alike(&start, bytes);
    Content::Unreadable(Unreadable { problem, is_empty: first.is_empty(), is_alike, is_source })
}

/// Whether a header has the columns of samples, whatever separates them.
fn is_samples_header(line: &str) -> bool {
    let line = line.to_ascii_lowercase();
    let columns: Vec<&str> = line.split([',', ';', '\t']).map(|column| column.trim().trim_matches('"')).collect();
    ["key_time", "rbt_ind"].iter().all(|name| columns.contains(name))
}

/// Whether a line is one of a trace, in which each is a JSON object, and not a keyframe file that stands on one line.
fn is_trace_line(line: &str) -> bool {
    let object = || serde_json::from_str::<Value>(line).ok();
    line.starts_with('{')
        && object().is_some_and(|object| {
            let is_empty = object.as_object().is_some_and(serde_json::Map::is_empty);
            let has_keyframes = object.get("keyframes").is_some_and(Value::is_array);
            !is_empty && !has_keyframes && object.get("format").is_none()
        })
}

/// Whether more than half of the first lines begin with words of scripts.
fn is_script(text: &str) -> bool {
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or_default().trim());
    let words = lines.filter_map(|line| line.split_whitespace().next()).take(START_LINES);
    let (mut of_scripts, mut all) = (0, 0);
    for word in words {
        all += 1;
        of_scripts += usize::from(script::is_first_word(word));
    }
    2 * of_scripts > all
}

/// Whether a text that cannot be read as keyframes looks as if it were meant so.
fn is_alike(start: &str, bytes: &[u8]) -> bool {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return true;
    }
    let names = ["\"format\"", "keyframe", "\"pose", "translation", "rotation"];
    if start.trim_start().starts_with('{') && names.iter().any(|name| start.contains(name)) {
        return true;
    }
    let signs = |c: char| c.is_whitespace() || ",;:|()[]{}<>=\"'".contains(c);
    let (mut numbers, mut all) = (0, 0);
    for piece in start.split(signs).filter(|piece| !piece.is_empty()).take(2000) {
        all += 1;
        let is_number =
            piece.trim_end_matches('f').parse::<f64>().is_ok() && piece.starts_with(|c: char| !c.is_alphabetic());
        numbers += usize::from(is_number);
    }
    numbers >= 7 && 2 * numbers > all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{DEFAULT_SCENE, built_in_scene};

    #[test]
    fn content_tells_what_a_file_is() {
        let scene = built_in_scene(DEFAULT_SCENE).expect("it is built in");
        let kind = |text: &str| match content_of(text.as_bytes(), &scene) {
            Content::Keyframes(..) => "keyframes",
            Content::Unreadable(Unreadable { is_empty: true, .. }) => "empty",
            Content::Unreadable(Unreadable { is_alike: true, .. }) => "alike",
            Content::Unreadable(Unreadable { is_source: true, .. }) => "source",
            Content::Unreadable(_) => "other",
            Content::Samples => "samples",
            Content::Trace => "trace",
            Content::Script => "script",
        };
        for (text, expected) in [
            ("key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n", "samples"),
            ("\u{feff}\nms;KEY_TIME;\"rbt_ind\";tx\n", "samples"),
            ("rbt_ind\tkey_time\ttx", "samples"),
            ("float key_time = 0; // of rbt_ind", "other"),
            ("time,node,x\n0,sky,1\n", "other"),
            ("time,node\n0,1\n", "other"),
            ("{\"line\": 1, \"command\": \"key n\", \"keyframes\": 1, \"playing\": false}\n", "trace"),
            ("{\"format\": \"inbetween.keyframes\", \"command\": 1}", "alike"),
            ("{\"step\": 1}\n{\"step\": 2}\n", "trace"),
            ("{}", "other"),
            ("{\"keyframes\": []}", "alike"),
            ("{\"format\": ", "alike"),
            ("{\n  \"version\": 2, \"tasks\": []\n}", "other"),
            ("# mine\nkey n\nkey >\n", "script"),
            ("key n\njump\nkey >\nwait 1s\n", "script"),
            ("These are the authors:\nA and B\n", "other"),
            ("all:\n\tg++ -o asst5 asst5.cpp\n", "other"),
            ("0 0 0 1 0 0 0\n0 0 0 1\n", "alike"),
            ("0 0 0 1 0 0 0\n", "alike"),
            (&"0 0 0 1 0 0 0\n".repeat(22), "keyframes"),
            // Keys of control nodes are meant as keyframes; a program without is one of the student's sources.
            ("from transform import vec\ndef main():\n    translate_keys = {0: vec(0, 0, 0)}\n", "alike"),
            ("translate_keys = {0: vec(0, 0, 0)}\ntranslate_keys = {0: vec(1, 0, 0)}\n", "alike"),
            ("#!/usr/bin/env python3\nimport glfw\n\nclass Viewer:\n    size = 1\n", "source"),
            (&format!("rows = [{}]\n", "1.5, ".repeat(300)), "source"),
            (" \n\n", "empty"),
            ("", "empty"),
        ] {
            assert_eq!(kind(text), expected, "{text:?}");
        }
    }
}
