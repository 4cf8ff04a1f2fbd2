//! Lists of names within a sentence.

use super::{Argument, Message, texts};

/// `a, b or c`.
#[must_use]
pub fn one_of(names: &[impl AsRef<str>]) -> Argument {
    joined(names, texts::list_or)
}

/// `a, b and c`.
#[must_use]
pub fn all_of(names: &[impl AsRef<str>]) -> Argument {
    joined(names, texts::list_and)
}

fn joined(names: &[impl AsRef<str>], join: fn(String, String) -> Message) -> Argument {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    match names.as_slice() {
        [all @ .., last] if !all.is_empty() => join(all.join(", "), (*last).to_owned()).into(),
        _ => names.concat().into(),
    }
}
