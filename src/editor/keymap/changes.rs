//! The table of bindings with a user's changes: no two bindings share a key.

use std::collections::BTreeMap;

use thiserror::Error;

use super::{Binding, Chord, bindings};
use crate::editor::Command;
use crate::words::{Message, Phrase, Severity, display_by_message, texts};

/// Why a change of keys is not made.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum KeymapError {
    /// Another binding has the key.
    Clash {
        /// The key, for people.
        chord: String,
        /// Whose it is.
        other: Phrase,
    },
    /// There is no such binding.
    NoSuchBinding {
        /// What was asked for.
        name: String,
    },
    /// A text is no key.
    NoKey {
        /// The text.
        chord: String,
        /// The binding's name.
        name: Phrase,
    },
}

display_by_message!(KeymapError);

impl KeymapError {
    /// Why, as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        let message = match self {
            Self::Clash { chord, other } => texts::hotkeys_clash(chord, *other),
            Self::NoSuchBinding { name } => texts::hotkeys_no_such_command(name),
            Self::NoKey { chord, name } => texts::hotkeys_no_key(chord, *name),
        };
        message.with_severity(Severity::Error)
    }
}

/// The bindings in force.
#[derive(Clone, Debug)]
pub struct Keymap(Vec<Binding>);

impl Default for Keymap {
    fn default() -> Self {
        Self(bindings())
    }
}

impl Keymap {
    /// The table with the keys of some bindings changed, and what of that could not be done: those keep the table's keys.
    #[must_use]
    pub fn with_changes(changes: &BTreeMap<String, Vec<String>>) -> (Self, Vec<KeymapError>) {
        let mut keymap = Self::default();
        let mut errors = Vec::new();
        for (name, chords) in changes {
            if let Err(error) = keymap.take_in(name, chords) {
                errors.push(error);
            }
        }
        // Changes may trade keys with each other, so that clashes are looked for when all are made.
        while let Some((name, error)) = keymap.clash_of(changes.keys()) {
            errors.push(error);
            keymap.put(name, chords_of_table(name));
        }
        (keymap, errors)
    }

    fn take_in(&mut self, name: &str, chords: &[String]) -> Result<(), KeymapError> {
        let binding = self.get(name).filter(|binding| can_change(binding));
        let binding = binding.ok_or_else(|| KeymapError::NoSuchBinding { name: name.to_owned() })?;
        let (name, title) = (binding.name, binding.title());
        let chords = chords
            .iter()
            .map(|chord| Chord::parse(chord).ok_or_else(|| KeymapError::NoKey { chord: chord.clone(), name: title }))
            .collect::<Result<Vec<Chord>, _>>()?;
        self.put(name, chords);
        Ok(())
    }

    /// A binding that does not have the table's keys and shares one with another.
    fn clash_of<'a>(&self, mut names: impl Iterator<Item = &'a String>) -> Option<(&'static str, KeymapError)> {
        names.find_map(|name| {
            let binding = self.get(name).filter(|binding| binding.chords != chords_of_table(binding.name))?;
            self.clash(binding.name, &binding.chords).map(|error| (binding.name, error))
        })
    }

    /// Why a binding cannot have these keys: another has one of them.
    #[must_use]
    pub fn clash(&self, name: &str, chords: &[Chord]) -> Option<KeymapError> {
        chords.iter().find_map(|chord| {
            let others = self.0.iter().filter(|other| other.name != name);
            let mut holders = others.filter(|other| other.chords.iter().any(|held| held.meets(*chord)));
            holders.next().map(|other| KeymapError::Clash { chord: chord.label(), other: other.title() })
        })
    }

    /// Gives a binding other keys.
    ///
    /// # Errors
    /// [`KeymapError`]; nothing has changed then.
    pub fn set(&mut self, name: &str, chords: Vec<Chord>) -> Result<(), KeymapError> {
        let binding = self.get(name).filter(|binding| can_change(binding));
        let name = binding.ok_or_else(|| KeymapError::NoSuchBinding { name: name.to_owned() })?.name;
        if let Some(error) = self.clash(name, &chords) {
            return Err(error);
        }
        self.put(name, chords);
        Ok(())
    }

    fn put(&mut self, name: &str, chords: Vec<Chord>) {
        if let Some(binding) = self.0.iter_mut().find(|binding| binding.name == name) {
            binding.chords = chords;
        }
    }

    /// What differs from the table, as the settings keep it.
    #[must_use]
    pub fn changes(&self) -> BTreeMap<String, Vec<String>> {
        self.0
            .iter()
            .filter(|binding| binding.chords != chords_of_table(binding.name))
            .map(|binding| (binding.name.to_owned(), binding.chords.iter().map(Chord::label).collect()))
            .collect()
    }

    /// The rows, in the table's order.
    #[must_use]
    pub fn bindings(&self) -> &[Binding] {
        &self.0
    }

    /// The row of a name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Binding> {
        self.0.iter().find(|binding| binding.name == name)
    }
}

/// Whether a binding may have other keys: Escape always leaves what is at hand.
#[must_use]
pub fn can_change(binding: &Binding) -> bool {
    binding.command != Command::Cancel
}

/// The keys that the table gives a binding.
#[must_use]
pub fn chords_of_table(name: &str) -> Vec<Chord> {
    bindings().into_iter().find(|binding| binding.name == name).map(|binding| binding.chords).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chord(text: &str) -> Chord {
        Chord::parse(text).unwrap()
    }

    fn changes(rows: &[(&str, &[&str])]) -> BTreeMap<String, Vec<String>> {
        let text = |chords: &[&str]| chords.iter().map(|&chord| chord.to_owned()).collect();
        rows.iter().map(|&(name, chords)| (name.to_owned(), text(chords))).collect()
    }

    #[test]
    fn no_two_rows_of_the_table_share_a_key() {
        let keymap = Keymap::default();
        for binding in keymap.bindings() {
            assert_eq!(keymap.clash(binding.name, &binding.chords), None, "{}", binding.name);
        }
    }

    #[test]
    fn names_are_one_row_each() {
        let mut names: Vec<&str> = bindings().iter().map(|binding| binding.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), bindings().len());
    }

    #[test]
    fn every_label_is_understood() {
        for binding in bindings() {
            for chord in binding.chords {
                assert_eq!(Chord::parse(&chord.label()), Some(chord), "{}", chord.label());
            }
        }
        for (key, name) in super::super::NAMED_KEYS {
            assert_eq!(Chord::parse(&format!("Alt+{name}")).map(|chord| chord.key), Some(key));
        }
        assert_eq!(Chord::parse("Hyper+x"), None);
        assert_eq!(Chord::parse("nothing"), None);
        assert_eq!(chord("Ctrl++").key, super::super::Key::Character('+'));
    }

    #[test]
    fn a_changed_key_works_and_is_kept() {
        let mut keymap = Keymap::default();
        assert_eq!(keymap.changes(), BTreeMap::new());
        keymap.set("New keyframe", vec![chord("Ctrl+k"), chord("F5")]).unwrap();
        let kept = keymap.changes();
        assert_eq!(kept, changes(&[("New keyframe", &["Ctrl+K", "F5"])]));
        let (again, errors) = Keymap::with_changes(&kept);
        assert_eq!((again.get("New keyframe").unwrap().keys(), errors), ("Ctrl+K or F5".to_owned(), vec![]));
    }

    #[test]
    fn a_clash_is_refused_and_named() {
        let mut keymap = Keymap::default();
        let error = keymap.set("New keyframe", vec![chord("y")]).unwrap_err();
        assert_eq!(error.to_string(), "y is the key of \"Play or stop\": give that another key first.");
        assert_eq!(keymap.changes(), BTreeMap::new());
        // Shift does not matter for signs.
        assert!(keymap.set("New keyframe", vec![chord("Shift+,")]).is_err());
        assert!(keymap.set("New keyframe", vec![chord("Shift+n")]).is_ok());
        assert!(keymap.set("Cancel", vec![chord("x")]).is_err());
    }

    #[test]
    fn kept_changes_may_trade_keys_but_not_share_them() {
        let traded = changes(&[("New keyframe", &["d"]), ("Delete keyframe", &["n"])]);
        let (keymap, errors) = Keymap::with_changes(&traded);
        assert_eq!((keymap.changes(), errors), (traded, vec![]));
        let wrong = changes(&[("New keyframe", &["y"]), ("Arcball", &["Hyper+q"]), ("Fly", &["f"])]);
        let (keymap, errors) = Keymap::with_changes(&wrong);
        assert_eq!((keymap.changes(), errors.len()), (BTreeMap::new(), 3));
    }
}
