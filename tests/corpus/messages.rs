//! Which sentences occur among what was recorded.

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
