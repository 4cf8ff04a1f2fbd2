//! The words of the window, in each language: one catalogue, whose keys are the English sentences.
//!
//! A widget says `Words::of(ui).say("New keyframe")`; what is missing in a language is said in English, and a test misses it.

mod ko;
mod ko_export;
mod ko_scene_keys;

use egui::{Context, Id, Ui};

use crate::settings::Language;

/// A language's words.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Words(Language);

impl Words {
    /// The words of a language.
    #[must_use]
    pub const fn new(language: Language) -> Self {
        Self(language)
    }

    /// Those in force.
    #[must_use]
    pub fn of(ui: &Ui) -> Self {
        Self::of_context(ui.ctx())
    }

    /// Those in force.
    #[must_use]
    pub fn of_context(context: &Context) -> Self {
        context.data(|data| data.get_temp(id())).unwrap_or_default()
    }

    /// Puts them in force.
    pub fn install(self, context: &Context) {
        context.data_mut(|data| data.insert_temp(id(), self));
    }

    /// A sentence or name, which is given in English.
    #[must_use]
    pub fn say(self, english: &str) -> &str {
        self.entry(english).unwrap_or(english)
    }

    /// A sentence with holes `{}`, filled in order; a language that wants them in another order writes `{1}`, counted from 0.
    #[must_use]
    pub fn fill(self, english: &str, with: &[&str]) -> String {
        fill(self.say(english), with)
    }

    /// What the editor said, which is English with names and numbers in it.
    #[must_use]
    pub fn message(self, english: &str) -> String {
        if self.0 == Language::English || english.is_empty() {
            return english.to_owned();
        }
        if let Some(said) = self.entry(english) {
            return said.to_owned();
        }
        let fitting = self.table().filter_map(|(pattern, said)| Some((pattern, said, holes(pattern, english)?)));
        // Where several fit, the one with the most words of its own is meant.
        match fitting.max_by_key(|(pattern, ..)| pattern.len()) {
            Some((_, said, found)) => {
                let found: Vec<String> = found.into_iter().map(|hole| self.message(hole)).collect();
                fill(said, &found.iter().map(String::as_str).collect::<Vec<_>>())
            }
            None => english.to_owned(),
        }
    }

    /// Whether the catalogue has a sentence or name in this language.
    #[must_use]
    pub fn knows(self, english: &str) -> bool {
        self.0 == Language::English || self.entry(english).is_some()
    }

    fn entry(self, english: &str) -> Option<&'static str> {
        self.table().find(|(key, _)| *key == english).map(|(_, said)| *said)
    }

    fn table(self) -> impl Iterator<Item = &'static (&'static str, &'static str)> {
        static KOREAN: [&[(&str, &str)]; 3] = [ko::WORDS, ko_export::WORDS, ko_scene_keys::WORDS];
        let tables = match self.0 {
            Language::English => &[][..],
            Language::Korean => &KOREAN,
        };
        tables.iter().copied().flatten()
    }
}

fn id() -> Id {
    Id::unique("words")
}

fn fill(pattern: &str, with: &[&str]) -> String {
    let mut text = String::with_capacity(pattern.len());
    let mut rest = pattern;
    let mut next = 0;
    while let Some((before, after)) = rest.split_once('{') {
        let Some((hole, after)) = after.split_once('}') else { break };
        text.push_str(before);
        let place = hole.parse().unwrap_or(next);
        next += 1;
        text.push_str(with.get(place).copied().unwrap_or_default());
        rest = after;
    }
    text.push_str(rest);
    text
}

/// What stands in the holes of a pattern, where a text fits it.
fn holes<'a>(pattern: &str, text: &'a str) -> Option<Vec<&'a str>> {
    let mut parts = pattern.split("{}");
    let mut rest = text.strip_prefix(parts.next()?)?;
    let mut parts = parts.peekable();
    parts.peek()?;
    let mut found = Vec::new();
    while let Some(part) = parts.next() {
        let at = if parts.peek().is_none() {
            rest.strip_suffix(part)?.len()
        } else if part.is_empty() {
            return None;
        } else {
            rest.find(part)?
        };
        found.push(&rest[..at]);
        rest = &rest[at + part.len()..];
    }
    // A hole is something; a pattern of holes alone would fit all.
    found.iter().all(|hole| !hole.is_empty()).then_some(found)
}

#[cfg(test)]
mod tests;
