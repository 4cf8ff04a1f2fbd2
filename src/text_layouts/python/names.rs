//! Names in programs: with dots, of functions, and what the name of a dictionary says about its keys.

use ruff_python_ast::Expr;

use super::keys::Channel;

/// A name, with the names before its dots: `self.height`. `None` for other expressions.
pub(super) fn dotted_name(expression: &Expr) -> Option<String> {
    let mut parts = Vec::new();
    let mut expression = expression;
    loop {
        match expression {
            Expr::Name(name) => {
                parts.push(name.id.as_str());
                parts.reverse();
                return Some(parts.join("."));
            }
            Expr::Attribute(attribute) => {
                parts.push(attribute.attr.as_str());
                expression = &attribute.value;
            }
            _ => return None,
        }
    }
}

/// The last part of a name with dots, whatever is before it.
pub(super) fn last_name(expression: &Expr) -> Option<&str> {
    match expression {
        Expr::Name(name) => Some(name.id.as_str()),
        Expr::Attribute(attribute) => Some(attribute.attr.as_str()),
        _ => None,
    }
}

/// What a name says about a dictionary.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Hint {
    /// The channel, if the name speaks of one.
    pub(super) channel: Option<Channel>,
    /// Whether it is a name of the course's, which is always true.
    pub(super) is_exact: bool,
    /// Whether it speaks of keys.
    pub(super) is_of_keys: bool,
    /// The rest of a name that speaks of a channel: `sun` in `translate_keys_sun`. Dictionaries of one node have the same.
    pub(super) rest: String,
}

impl Hint {
    /// The hint of a name; of the last part if it has dots.
    pub(super) fn new(name: &str) -> Self {
        let name = name.rsplit('.').next().unwrap_or_default();
        let exact = Channel::ALL.into_iter().find(|channel| channel.exact_name() == name);
        if exact.is_some() {
            return Self { channel: exact, is_exact: true, is_of_keys: true, rest: String::new() };
        }
        let small = name.to_lowercase();
        let words: Vec<&str> = small.split('_').filter(|word| !word.is_empty()).collect();
        let channel = words.iter().find_map(|word| Channel::of_word(word));
        let is_key = |word: &&str| ["key", "keys", "keyframe", "keyframes"].contains(word) || word.ends_with("keys");
        let is_rest = |word: &&&str| Channel::of_word(word).is_none() && !is_key(word);
        let rest = if channel.is_none() { String::new() } else { words.iter().filter(is_rest).copied().collect() };
        Self { channel, is_exact: false, is_of_keys: words.iter().any(is_key), rest }
    }
}
