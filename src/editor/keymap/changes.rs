//! The keymap: the table of bindings with the user's changes. No two bindings share a hotkey.

use std::collections::BTreeMap;

use thiserror::Error;

use super::{Binding, Chord, bindings};
use crate::editor::{Command, commands};
use crate::words::{Message, Phrase, Severity, display_by_message, texts};

/// Why a change of hotkeys is refused.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum KeymapError {
    /// Another binding has the hotkey.
    Clash {
        /// The hotkey as text.
        chord: String,
        /// The name of that binding.
        other: Phrase,
    },
    /// There is no such binding.
    NoSuchBinding {
        /// The id that was given.
        name: String,
    },
    /// A text is not a hotkey.
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

/// The current bindings.
#[derive(Clone, Debug)]
pub struct Keymap(Vec<Binding>);

impl Default for Keymap {
    fn default() -> Self {
        Self(bindings())
    }
}

impl Keymap {
    /// The table with some hotkeys changed, and the changes that were refused. Their bindings keep the default hotkeys.
    ///
    /// Bindings are named by their ids; English names, as older settings have them, are understood too.
    #[must_use]
    pub fn with_changes(changes: &BTreeMap<String, Vec<String>>) -> (Self, Vec<KeymapError>) {
        let mut keymap = Self::default();
        let mut errors = Vec::new();
        let changes = by_id(changes);
        for (id, chords) in &changes {
            if let Err(error) = keymap.take_in(id, chords) {
                errors.push(error);
            }
        }
        // Changes may swap hotkeys, so check for clashes after all of them are applied.
        while let Some((id, error)) = keymap.clash_of(changes.keys()) {
            errors.push(error);
            keymap.put(id, chords_of_table(id));
        }
        (keymap, errors)
    }

    fn take_in(&mut self, id: &str, chords: &[String]) -> Result<(), KeymapError> {
        let binding = self.changeable(id)?;
        let (id, title) = (binding.id, binding.title());
        let chords = chords
            .iter()
            .map(|chord| Chord::parse(chord).ok_or_else(|| KeymapError::NoKey { chord: chord.clone(), name: title }))
            .collect::<Result<Vec<Chord>, _>>()?;
        self.put(id, chords);
        Ok(())
    }

    /// The binding of an id, if its hotkeys can be changed.
    fn changeable(&self, id: &str) -> Result<&Binding, KeymapError> {
        let binding = self.get(id).filter(|binding| can_change(binding));
        binding.ok_or_else(|| KeymapError::NoSuchBinding { name: name_of(id).to_owned() })
    }

    /// A changed binding that shares a hotkey with another one.
    fn clash_of<'a>(&self, mut ids: impl Iterator<Item = &'a String>) -> Option<(&'static str, KeymapError)> {
        ids.find_map(|id| {
            let binding = self.get(id).filter(|binding| binding.chords != chords_of_table(binding.id))?;
            self.clash(binding.id, &binding.chords).map(|error| (binding.id, error))
        })
    }

    /// Why the binding of an id cannot have these hotkeys: another binding has one of them.
    #[must_use]
    pub fn clash(&self, id: &str, chords: &[Chord]) -> Option<KeymapError> {
        chords.iter().find_map(|chord| {
            let others = self.0.iter().filter(|other| other.id != id);
            let mut holders = others.filter(|other| other.chords.iter().any(|held| held.meets(*chord)));
            holders.next().map(|other| KeymapError::Clash { chord: chord.label(), other: other.title() })
        })
    }

    /// Sets the hotkeys of the binding with this id.
    ///
    /// # Errors
    /// [`KeymapError`]; nothing has changed then.
    pub fn set(&mut self, id: &str, chords: Vec<Chord>) -> Result<(), KeymapError> {
        let id = self.changeable(id)?.id;
        if let Some(error) = self.clash(id, &chords) {
            return Err(error);
        }
        self.put(id, chords);
        Ok(())
    }

    fn put(&mut self, id: &str, chords: Vec<Chord>) {
        if let Some(binding) = self.0.iter_mut().find(|binding| binding.id == id) {
            binding.chords = chords;
        }
    }

    /// The differences from the table, as settings store them: hotkeys by the ids of bindings.
    #[must_use]
    pub fn changes(&self) -> BTreeMap<String, Vec<String>> {
        self.0
            .iter()
            .filter(|binding| binding.chords != chords_of_table(binding.id))
            .map(|binding| (binding.id.to_owned(), binding.chords.iter().map(Chord::label).collect()))
            .collect()
    }

    /// The bindings, in the order of the help.
    #[must_use]
    pub fn bindings(&self) -> &[Binding] {
        &self.0
    }

    /// The binding of an id.
    #[must_use]
    pub fn get(&self, id: &str) -> Option<&Binding> {
        self.0.iter().find(|binding| binding.id == id)
    }
}

/// Replaces English names, which older settings have, by ids; so does a name that differs from an id in case alone. If a map has both, the id wins. A name without a
/// binding is kept as it is.
#[must_use]
pub fn by_id(changes: &BTreeMap<String, Vec<String>>) -> BTreeMap<String, Vec<String>> {
    let is_meant = |id: &str, name: &str| id != name && id.eq_ignore_ascii_case(name);
    let named = |binding: &Binding, name: &str| binding.title().english() == name || is_meant(binding.id, name);
    let id_of = |name: &str| table().find(|binding| named(binding, name)).map(|binding| binding.id);
    let mut renamed = BTreeMap::new();
    for (name, chords) in changes {
        if let Some(id) = id_of(name) {
            renamed.insert(id.to_owned(), chords.clone());
        }
    }
    let others = changes.iter().filter(|(name, _)| id_of(name).is_none());
    renamed.extend(others.map(|(name, chords)| (name.clone(), chords.clone())));
    renamed
}

/// Whether the hotkeys of a binding can be changed: Escape always cancels.
#[must_use]
pub fn can_change(binding: &Binding) -> bool {
    binding.command != Command::Cancel
}

/// The default hotkeys of the binding with this id.
#[must_use]
pub fn chords_of_table(id: &str) -> Vec<Chord> {
    table().find(|binding| binding.id == id).map(|binding| binding.chords.clone()).unwrap_or_default()
}

/// The English name of the binding of an id; the text itself where there is none.
fn name_of(id: &str) -> &str {
    table().find(|binding| binding.id == id).map_or(id, |binding| binding.title().english())
}

fn table() -> impl Iterator<Item = &'static Binding> {
    commands::rows().iter().flat_map(|row| &row.bindings)
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
            assert_eq!(keymap.clash(binding.id, &binding.chords), None, "{}", binding.id);
        }
    }

    #[test]
    fn a_name_or_an_id_means_one_binding_in_any_case() {
        let mut meant: Vec<(String, &str)> = bindings()
            .iter()
            .flat_map(|binding| {
                [(binding.title().english().to_lowercase(), binding.id), (binding.id.to_owned(), binding.id)]
            })
            .collect();
        meant.sort_unstable();
        meant.dedup();
        for pair in meant.windows(2) {
            assert_ne!(pair[0].0, pair[1].0, "{} and {} share it", pair[0].1, pair[1].1);
        }
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
        keymap.set("keyframe-new", vec![chord("Ctrl+k"), chord("F5")]).unwrap();
        let kept = keymap.changes();
        assert_eq!(kept, changes(&[("keyframe-new", &["Ctrl+K", "F5"])]));
        let (again, errors) = Keymap::with_changes(&kept);
        assert_eq!((again.get("keyframe-new").unwrap().keys(), errors), ("Ctrl+K or F5".to_owned(), vec![]));
    }

    #[test]
    fn a_clash_is_refused_and_named() {
        let mut keymap = Keymap::default();
        let error = keymap.set("keyframe-new", vec![chord("y")]).unwrap_err();
        assert_eq!(error.to_string(), "y is the key of \"Play or stop\": give that another key first.");
        assert_eq!(keymap.changes(), BTreeMap::new());
        // Shift does not matter for signs.
        assert!(keymap.set("keyframe-new", vec![chord("Shift+,")]).is_err());
        assert!(keymap.set("keyframe-new", vec![chord("Shift+n")]).is_ok());
        assert!(keymap.set("cancel", vec![chord("x")]).is_err());
    }

    #[test]
    fn kept_changes_may_trade_keys_but_not_share_them() {
        let traded = changes(&[("keyframe-new", &["d"]), ("keyframe-delete", &["n"])]);
        let (keymap, errors) = Keymap::with_changes(&traded);
        assert_eq!((keymap.changes(), errors), (traded, vec![]));
        let wrong = changes(&[("keyframe-new", &["y"]), ("arcball", &["Hyper+q"]), ("Fly", &["f"])]);
        let (keymap, errors) = Keymap::with_changes(&wrong);
        assert_eq!((keymap.changes(), errors.len()), (BTreeMap::new(), 3));
    }

    #[test]
    fn english_names_are_understood_and_kept_as_ids() {
        let old = changes(&[("New keyframe", &["F5"]), ("Arcball", &["F6"]), ("arcball", &["F7"]), ("Fly", &["x"])]);
        let expected = changes(&[("keyframe-new", &["F5"]), ("arcball", &["F7"]), ("Fly", &["x"])]);
        assert_eq!(by_id(&old), expected);
        let (keymap, errors) = Keymap::with_changes(&old);
        assert_eq!(keymap.changes(), changes(&[("keyframe-new", &["F5"]), ("arcball", &["F7"])]));
        let sentences: Vec<String> = errors.iter().map(ToString::to_string).collect();
        assert_eq!(sentences, ["There is no command \"Fly\" whose keys could be changed."]);
    }
}
