//! Which sentences occur among what was recorded.

/// Headings of `en.txt` under which stand labels, names and helps, which nothing says.
const LABELS: [&str; 5] =
    ["# Parts of the help", "# Names in the window", "# Commands by the ids", "# Texts of the window", "# The manual"];

/// The messages of `en.txt`: each id, and its text with `{}` for each argument.
pub fn of_english(text: &str) -> Vec<(&str, String)> {
    let mut are_labels = false;
    let mut messages = Vec::new();
    let lines = text.lines().skip_while(|line| !line.is_empty());
    for line in lines {
        if line.starts_with("# ") {
            are_labels = LABELS.iter().any(|heading| line.starts_with(heading));
        } else if let Some((id, text)) = line.split_once(" = ").filter(|_| !are_labels && !line.starts_with('@')) {
            messages.push((id, pattern(text)));
        }
    }
    messages
}

/// A text of `en.txt` as a pattern of [`occurs`].
fn pattern(text: &str) -> String {
    let text = text.replace("{{", "\u{1}").replace("}}", "\u{2}");
    let mut pieces = text.split('{');
    let first = pieces.next().unwrap_or_default().to_owned();
    let rest = pieces.map(|piece| piece.split_once('}').expect("each argument ends").1);
    let pattern = rest.fold(first, |text, piece| text + "{}" + piece);
    pattern.replace('\u{1}', "{").replace('\u{2}', "}")
}

/// The sentences of a list: one a line, with `{}` for what differs; headings begin with `#`.
pub fn patterns(list: &str) -> impl Iterator<Item = &str> {
    list.lines().filter(|line| !line.is_empty() && !line.starts_with('#'))
}

/// The lines of an expectation file that hold what the program said.
pub fn said(expected: &str) -> Vec<String> {
    expected.lines().filter(|line| !line.starts_with("===")).map(str::to_owned).collect()
}

/// Whether a line holds a sentence: the pieces between the `{}`, in order, somewhere in the line.
pub fn occurs(pattern: &str, line: &str) -> bool {
    let mut rest = line;
    pattern.split("{}").all(|piece| {
        let found = rest.find(piece);
        rest = found.map_or("", |at| &rest[at + piece.len()..]);
        found.is_some()
    })
}

#[test]
fn pieces_occur_in_order() {
    assert!(occurs("Keyframe {} is {}.", "3\tKeyframe 2 is the last."));
    assert!(!occurs("Keyframe {} is {}!", "3\tKeyframe 2 is the last."));
    assert!(!occurs("is {} Keyframe", "Keyframe 2 is the last."));
}

#[test]
fn english_texts_become_patterns() {
    let text = "# Head\n@name = English\n\n# Said\na.b = x {y} of {{z}}\n# Names in the window: labels\nc = d\n";
    assert_eq!(of_english(text), [("a.b", "x {} of {z}".to_owned())]);
}
