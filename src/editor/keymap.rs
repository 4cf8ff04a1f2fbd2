//! Hotkeys: keys with modifiers, and the lookup of the binding that a key press triggers.

mod changes;

use std::fmt::Write as _;

pub use super::commands::{Binding, Group};
pub use changes::{Keymap, KeymapError, by_id, can_change, chords_of_table};

use super::commands;

/// A key as it is named, apart from its modifiers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Key {
    /// A key that types this character; letters in lower case.
    Character(char),
    /// The space bar.
    Space,
    /// Escape.
    Escape,
    /// F1.
    F1,
    /// F2.
    F2,
    /// F3.
    F3,
    /// F4.
    F4,
    /// F5.
    F5,
    /// F6.
    F6,
    /// F7.
    F7,
    /// F8.
    F8,
    /// F9.
    F9,
    /// F10.
    F10,
    /// F11.
    F11,
    /// F12.
    F12,
    /// Home.
    Home,
    /// End.
    End,
    /// Page up.
    PageUp,
    /// Page down.
    PageDown,
    /// Insert.
    Insert,
    /// Delete.
    Delete,
    /// Enter or Return.
    Enter,
    /// Backspace.
    Backspace,
    /// The arrow to the left.
    Left,
    /// The arrow to the right.
    Right,
    /// The arrow up.
    Up,
    /// The arrow down.
    Down,
}

/// Keys that type no character, with their displayed names; scripts and settings accept them in any case.
pub const NAMED_KEYS: [(Key, &str); 26] = [
    (Key::Space, "Space"),
    (Key::Escape, "Esc"),
    (Key::F1, "F1"),
    (Key::F2, "F2"),
    (Key::F3, "F3"),
    (Key::F4, "F4"),
    (Key::F5, "F5"),
    (Key::F6, "F6"),
    (Key::F7, "F7"),
    (Key::F8, "F8"),
    (Key::F9, "F9"),
    (Key::F10, "F10"),
    (Key::F11, "F11"),
    (Key::F12, "F12"),
    (Key::Home, "Home"),
    (Key::End, "End"),
    (Key::PageUp, "PageUp"),
    (Key::PageDown, "PageDown"),
    (Key::Insert, "Insert"),
    (Key::Delete, "Delete"),
    (Key::Enter, "Enter"),
    (Key::Backspace, "Backspace"),
    (Key::Left, "Left"),
    (Key::Right, "Right"),
    (Key::Up, "Up"),
    (Key::Down, "Down"),
];

/// Which modifiers are held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Modifiers {
    /// Either Shift key.
    pub shift: bool,
    /// Either Ctrl key, or Command on a Mac.
    pub ctrl: bool,
    /// Either Alt key.
    pub alt: bool,
}

/// A key with its modifiers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Chord {
    /// The key.
    pub key: Key,
    /// The modifiers. Shift is ignored for signs such as `>`, because keyboards differ in how they type them.
    pub modifiers: Modifiers,
}

/// A press of a key, as the window or a script gives it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KeyPress {
    /// The key by the current keyboard layout, regardless of Ctrl and Alt.
    pub typed: Option<Key>,
    /// The key at the same position on a US keyboard, with Shift applied.
    pub on_us_layout: Option<Key>,
    /// The modifiers that are held.
    pub modifiers: Modifiers,
    /// Whether it repeats because the key is held down.
    pub is_repeat: bool,
}

/// All bindings with their default hotkeys, in the order of the help.
#[must_use]
pub fn bindings() -> Vec<Binding> {
    commands::rows().iter().flat_map(|row| &row.bindings).cloned().collect()
}

impl Binding {
    /// Its hotkeys as text: `c or Space`.
    #[must_use]
    pub fn keys(&self) -> String {
        self.chords.iter().map(Chord::label).collect::<Vec<_>>().join(" or ")
    }

    /// The hotkey that a menu shows.
    #[must_use]
    pub fn menu_key(&self) -> String {
        self.chords.first().map(Chord::label).unwrap_or_default()
    }
}

impl Chord {
    /// The chord as text: `Ctrl+Shift+Z`, `>`, `n`.
    #[must_use]
    pub fn label(&self) -> String {
        let Modifiers { shift, ctrl, alt } = self.modifiers;
        let mut label = String::new();
        for (is_held, name) in [(ctrl, "Ctrl+"), (alt, "Alt+"), (shift, "Shift+")] {
            if is_held {
                label.push_str(name);
            }
        }
        match self.key {
            Key::Character(letter) if label.is_empty() => label.push(letter),
            Key::Character(letter) => label.extend(letter.to_uppercase()),
            named => label.extend(NAMED_KEYS.iter().filter(|(key, _)| *key == named).map(|(_, name)| *name)),
        }
        label
    }

    /// The chord that a text means, as [`Chord::label`] writes it, in any case.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let mut modifiers = Modifiers::default();
        let mut rest = text;
        while rest.chars().count() > 1
            && let Some((modifier, after)) = rest.split_once('+')
            && !after.is_empty()
        {
            match modifier.to_lowercase().as_str() {
                "shift" => modifiers.shift = true,
                "ctrl" => modifiers.ctrl = true,
                "alt" => modifiers.alt = true,
                _ => return None,
            }
            rest = after;
        }
        let mut characters = rest.chars();
        let key = match (characters.next(), characters.next()) {
            (Some(character), None) => Key::typing(character),
            _ if rest.eq_ignore_ascii_case("escape") => Key::Escape,
            _ => NAMED_KEYS.iter().find(|(_, name)| rest.eq_ignore_ascii_case(name)).map(|(key, _)| *key)?,
        };
        Some(Self { key, modifiers })
    }

    /// Whether some press means both.
    #[must_use]
    pub fn meets(self, other: Self) -> bool {
        self.matches(other.key, other.modifiers)
    }

    fn matches(self, key: Key, modifiers: Modifiers) -> bool {
        let is_sign = matches!(key, Key::Character(sign) if !sign.is_alphanumeric());
        self.key == key
            && self.modifiers.ctrl == modifiers.ctrl
            && self.modifiers.alt == modifiers.alt
            && (is_sign || self.modifiers.shift == modifiers.shift)
    }
}

impl Key {
    /// The key that types a character: letters whatever their case.
    #[must_use]
    pub fn typing(character: char) -> Self {
        match character {
            ' ' => Self::Space,
            _ => Self::Character(character.to_lowercase().next().unwrap_or(character)),
        }
    }
}

/// The binding of a key press: by the typed character first, then by the key's position on a US keyboard.
///
/// A repeated press triggers only bindings that repeat.
#[must_use]
pub fn binding_for(table: &[Binding], press: KeyPress) -> Option<&Binding> {
    [press.typed, press.on_us_layout]
        .into_iter()
        .flatten()
        .find_map(|key| {
            table.iter().find(|binding| binding.chords.iter().any(|chord| chord.matches(key, press.modifiers)))
        })
        .filter(|binding| binding.repeats || !press.is_repeat)
}

/// The press that a script's word means: a character itself, or a key's name such as `space`, `escape`, `f11`, `home`, with `shift+`,
/// `ctrl+`, `alt+` before it.
#[must_use]
pub fn press_from_word(word: &str) -> Option<KeyPress> {
    let Chord { key, modifiers } = Chord::parse(word)?;
    Some(KeyPress { typed: Some(key), on_us_layout: None, modifiers, is_repeat: false })
}

/// The table of hotkeys as Markdown, for the manual.
#[must_use]
pub fn markdown() -> String {
    let mut text = String::from("| key | does |\n|---|---|\n");
    for binding in bindings() {
        if binding.chords.is_empty() {
            continue;
        }
        let keys: Vec<String> = binding.chords.iter().map(|chord| format!("`{}`", chord.label())).collect();
        let _ = writeln!(text, "| {} | {} |", keys.join(", "), binding.explanation());
    }
    text
}
