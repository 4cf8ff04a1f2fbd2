//! Translates key events of the window system to [`KeyPress`]es of the keymap.

use winit::event::{ElementState, KeyEvent};
use winit::keyboard::{Key as LogicalKey, KeyCode, ModifiersState, NamedKey, PhysicalKey};

use crate::editor::keymap::{Key, KeyPress, Modifiers};

/// The relevant part of a key event, as plain data.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyInput {
    /// The position of the key on the keyboard.
    pub physical: Option<KeyCode>,
    /// The key by the current keyboard layout.
    pub logical: LogicalKey,
    /// Whether it went down, not up.
    pub is_pressed: bool,
    /// Whether it repeats because the key is held down.
    pub is_repeat: bool,
    /// Whether the window system made it up because the focus changed while the key was down.
    pub is_synthetic: bool,
    /// The modifiers that are held.
    pub modifiers: Modifiers,
}

impl KeyInput {
    /// From a window system's event.
    #[must_use]
    pub fn new(event: &KeyEvent, is_synthetic: bool, modifiers: ModifiersState) -> Self {
        Self {
            physical: match event.physical_key {
                PhysicalKey::Code(code) => Some(code),
                PhysicalKey::Unidentified(_) => None,
            },
            logical: event.logical_key.clone(),
            is_pressed: event.state == ElementState::Pressed,
            is_repeat: event.repeat,
            is_synthetic,
            modifiers: Modifiers {
                shift: modifiers.shift_key(),
                ctrl: modifiers.control_key() || modifiers.super_key(),
                alt: modifiers.alt_key(),
            },
        }
    }

    /// Whether it is the space bar.
    #[must_use]
    pub fn is_space(&self) -> bool {
        typed(&self.logical) == Some(Key::Space)
    }

    /// The press that it is, whether the key goes down or up; `None` if it is synthetic.
    #[must_use]
    pub fn press(&self) -> Option<KeyPress> {
        (!self.is_synthetic).then(|| KeyPress {
            typed: typed(&self.logical),
            on_us_layout: self.physical.and_then(|physical| on_us_layout(physical, self.modifiers.shift)),
            modifiers: self.modifiers,
            is_repeat: self.is_repeat,
        })
    }
}

fn typed(logical: &LogicalKey) -> Option<Key> {
    match logical {
        LogicalKey::Character(text) => {
            let mut characters = text.chars();
            let first = characters.next()?;
            characters.next().is_none().then(|| Key::typing(first))
        }
        LogicalKey::Named(named) => without_character(*named),
        _ => None,
    }
}

const fn without_character(named: NamedKey) -> Option<Key> {
    Some(match named {
        NamedKey::Space => Key::Space,
        NamedKey::Escape => Key::Escape,
        NamedKey::F1 => Key::F1,
        NamedKey::F2 => Key::F2,
        NamedKey::F3 => Key::F3,
        NamedKey::F4 => Key::F4,
        NamedKey::F5 => Key::F5,
        NamedKey::F6 => Key::F6,
        NamedKey::F7 => Key::F7,
        NamedKey::F8 => Key::F8,
        NamedKey::F9 => Key::F9,
        NamedKey::F10 => Key::F10,
        NamedKey::F11 => Key::F11,
        NamedKey::F12 => Key::F12,
        NamedKey::Home => Key::Home,
        NamedKey::End => Key::End,
        NamedKey::PageUp => Key::PageUp,
        NamedKey::PageDown => Key::PageDown,
        NamedKey::Insert => Key::Insert,
        NamedKey::Delete => Key::Delete,
        NamedKey::Enter => Key::Enter,
        NamedKey::Backspace => Key::Backspace,
        NamedKey::ArrowLeft => Key::Left,
        NamedKey::ArrowRight => Key::Right,
        NamedKey::ArrowUp => Key::Up,
        NamedKey::ArrowDown => Key::Down,
        _ => return None,
    })
}

/// The key at a position of a US keyboard.
fn on_us_layout(physical: KeyCode, shift: bool) -> Option<Key> {
    let with_shift = |plain, shifted| if shift { shifted } else { plain };
    Some(Key::Character(match physical {
        KeyCode::KeyA => 'a',
        KeyCode::KeyB => 'b',
        KeyCode::KeyC => 'c',
        KeyCode::KeyD => 'd',
        KeyCode::KeyE => 'e',
        KeyCode::KeyF => 'f',
        KeyCode::KeyG => 'g',
        KeyCode::KeyH => 'h',
        KeyCode::KeyI => 'i',
        KeyCode::KeyJ => 'j',
        KeyCode::KeyK => 'k',
        KeyCode::KeyL => 'l',
        KeyCode::KeyM => 'm',
        KeyCode::KeyN => 'n',
        KeyCode::KeyO => 'o',
        KeyCode::KeyP => 'p',
        KeyCode::KeyQ => 'q',
        KeyCode::KeyR => 'r',
        KeyCode::KeyS => 's',
        KeyCode::KeyT => 't',
        KeyCode::KeyU => 'u',
        KeyCode::KeyV => 'v',
        KeyCode::KeyW => 'w',
        KeyCode::KeyX => 'x',
        KeyCode::KeyY => 'y',
        KeyCode::KeyZ => 'z',
        KeyCode::Digit0 if !shift => '0',
        KeyCode::Digit1 if !shift => '1',
        KeyCode::Digit2 if !shift => '2',
        KeyCode::Digit3 if !shift => '3',
        KeyCode::Digit4 if !shift => '4',
        KeyCode::Digit5 if !shift => '5',
        KeyCode::Digit6 if !shift => '6',
        KeyCode::Digit7 if !shift => '7',
        KeyCode::Digit8 if !shift => '8',
        KeyCode::Digit9 if !shift => '9',
        KeyCode::Numpad0 => '0',
        KeyCode::Numpad1 => '1',
        KeyCode::Numpad2 => '2',
        KeyCode::Numpad3 => '3',
        KeyCode::Numpad4 => '4',
        KeyCode::Numpad5 => '5',
        KeyCode::Numpad6 => '6',
        KeyCode::Numpad7 => '7',
        KeyCode::Numpad8 => '8',
        KeyCode::Numpad9 => '9',
        KeyCode::Comma => with_shift(',', '<'),
        KeyCode::Period => with_shift('.', '>'),
        KeyCode::Equal => with_shift('=', '+'),
        KeyCode::Minus => with_shift('-', '_'),
        KeyCode::NumpadAdd => '+',
        KeyCode::NumpadSubtract => '-',
        KeyCode::Space => return Some(Key::Space),
        KeyCode::Escape => return Some(Key::Escape),
        KeyCode::F11 => return Some(Key::F11),
        KeyCode::Home => return Some(Key::Home),
        KeyCode::Delete => return Some(Key::Delete),
        KeyCode::ArrowLeft => return Some(Key::Left),
        KeyCode::ArrowRight => return Some(Key::Right),
        _ => return None,
    }))
}

/// The space bar: it acts when it is let go, and only where no drag used it meanwhile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpaceBar {
    /// It is up.
    #[default]
    Up,
    /// It is held, and nothing used it.
    Held,
    /// It is held, and a drag used it, or it went to a field or button.
    Used,
}

impl SpaceBar {
    /// Whether it is held over the scene.
    #[must_use]
    pub const fn is_held(self) -> bool {
        !matches!(self, Self::Up)
    }

    /// It goes down. `is_taken`: the keyboard is with a field or button.
    pub const fn press(&mut self, is_taken: bool) {
        if matches!(self, Self::Up) {
            *self = if is_taken { Self::Used } else { Self::Held };
        }
    }

    /// A drag begins.
    pub const fn drag(&mut self) {
        if matches!(self, Self::Held) {
            *self = Self::Used;
        }
    }

    /// It goes up. Says whether it acts now.
    pub const fn release(&mut self) -> bool {
        let acts = matches!(self, Self::Held);
        *self = Self::Up;
        acts
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::editor::keymap::{binding_for, bindings};

    const PLAIN: Modifiers = Modifiers { shift: false, ctrl: false, alt: false };
    const SHIFT: Modifiers = Modifiers { shift: true, ..PLAIN };
    const CTRL: Modifiers = Modifiers { ctrl: true, ..PLAIN };
    const CTRL_SHIFT: Modifiers = Modifiers { shift: true, ..CTRL };

    fn input(logical: &str, physical: KeyCode, modifiers: Modifiers) -> KeyInput {
        KeyInput {
            physical: Some(physical),
            logical: LogicalKey::Character(logical.into()),
            is_pressed: true,
            is_repeat: false,
            is_synthetic: false,
            modifiers,
        }
    }

    fn name(input: &KeyInput) -> Option<&'static str> {
        binding_for(&bindings(), input.press()?).map(|binding| binding.title().english())
    }

    #[track_caller]
    fn check(logical: &str, physical: KeyCode, modifiers: Modifiers, expected: Option<&str>) {
        assert_eq!(
            name(&input(logical, physical, modifiers)),
            expected,
            "{logical} on {physical:?} with {modifiers:?}"
        );
    }

    #[test]
    fn a_us_board() {
        check("n", KeyCode::KeyN, PLAIN, Some("New keyframe"));
        check("<", KeyCode::Comma, SHIFT, Some("Previous keyframe"));
        check(",", KeyCode::Comma, PLAIN, Some("Previous keyframe"));
        check(">", KeyCode::Period, SHIFT, Some("Next keyframe"));
        check("=", KeyCode::Equal, PLAIN, Some("Faster"));
        check("+", KeyCode::Equal, SHIFT, Some("Faster"));
        check("-", KeyCode::Minus, PLAIN, Some("Slower"));
        check("1", KeyCode::Digit1, PLAIN, Some("Look from the front"));
        check("1", KeyCode::Numpad1, PLAIN, Some("Look from the front"));
        check("3", KeyCode::Numpad3, CTRL, Some("Look from -X"));
        check("7", KeyCode::Numpad7, PLAIN, Some("Look from above"));
        check("0", KeyCode::Numpad0, PLAIN, Some("Recorded camera"));
        check("+", KeyCode::NumpadAdd, PLAIN, Some("Faster"));
        check("-", KeyCode::NumpadSubtract, PLAIN, Some("Slower"));
        check("p", KeyCode::KeyP, PLAIN, Some("Pick a node"));
        check("P", KeyCode::KeyP, SHIFT, Some("Pause or go on"));
        check("z", KeyCode::KeyZ, CTRL, Some("Undo"));
        check("Z", KeyCode::KeyZ, CTRL_SHIFT, Some("Redo"));
        check("y", KeyCode::KeyY, CTRL, Some("Redo"));
        check("+", KeyCode::Equal, CTRL_SHIFT, Some("Larger"));
        check("=", KeyCode::Equal, CTRL, Some("Larger"));
        check("-", KeyCode::Minus, CTRL, Some("Smaller"));
        check("0", KeyCode::Digit0, CTRL, Some("Usual size"));
        check("P", KeyCode::KeyP, CTRL_SHIFT, Some("Commands…"));
        check("x", KeyCode::KeyX, PLAIN, None);
        check("_", KeyCode::Minus, SHIFT, None);
    }

    #[test]
    fn caps_lock_does_not_matter() {
        check("A", KeyCode::KeyA, PLAIN, Some("Arcball"));
        check("P", KeyCode::KeyP, PLAIN, Some("Pick a node"));
        check("p", KeyCode::KeyP, SHIFT, Some("Pause or go on"));
        check("Z", KeyCode::KeyZ, CTRL, Some("Undo"));
    }

    #[test]
    fn a_korean_layout() {
        check("ㅜ", KeyCode::KeyN, PLAIN, Some("New keyframe"));
        check("ㅔ", KeyCode::KeyP, PLAIN, Some("Pick a node"));
        check("ㅖ", KeyCode::KeyP, SHIFT, Some("Pause or go on"));
        check("ㅋ", KeyCode::KeyZ, CTRL, Some("Undo"));
    }

    #[test]
    fn a_german_layout() {
        check("<", KeyCode::IntlBackslash, PLAIN, Some("Previous keyframe"));
        check(">", KeyCode::IntlBackslash, SHIFT, Some("Next keyframe"));
        check("+", KeyCode::BracketRight, PLAIN, Some("Faster"));
        check("-", KeyCode::Slash, PLAIN, Some("Slower"));
        check("y", KeyCode::KeyZ, PLAIN, Some("Play or stop"));
        check("z", KeyCode::KeyY, CTRL, Some("Undo"));
        check(";", KeyCode::Comma, SHIFT, Some("Previous keyframe"));
    }

    #[test]
    fn named_keys() {
        let named = |key, physical| KeyInput { logical: LogicalKey::Named(key), ..input("", physical, PLAIN) };
        assert_eq!(name(&named(NamedKey::Escape, KeyCode::Escape)), Some("Cancel"));
        assert_eq!(name(&named(NamedKey::F11, KeyCode::F11)), Some("Panels"));
        assert_eq!(name(&named(NamedKey::Space, KeyCode::Space)), Some("Display keyframe"));
        assert_eq!(name(&named(NamedKey::Home, KeyCode::Home)), Some("Restart timed keys"));
        // Without the lock of numbers.
        assert_eq!(name(&named(NamedKey::PageDown, KeyCode::Numpad3)), Some("Look from +X"));
        assert_eq!(name(&named(NamedKey::Tab, KeyCode::Tab)), None);
        assert!(named(NamedKey::Space, KeyCode::Space).is_space());
    }

    #[test]
    fn what_no_finger_did_is_ignored() {
        assert_eq!(name(&KeyInput { is_synthetic: true, ..input("n", KeyCode::KeyN, PLAIN) }), None);
    }

    #[test]
    fn holding_repeats_only_what_repeats() {
        assert_eq!(name(&KeyInput { is_repeat: true, ..input("n", KeyCode::KeyN, PLAIN) }), None);
        assert_eq!(name(&KeyInput { is_repeat: true, ..input(">", KeyCode::Period, SHIFT) }), Some("Next keyframe"));
    }

    #[test]
    fn the_space_bar_acts_when_let_go() {
        let mut space = SpaceBar::default();
        space.press(false);
        space.press(false);
        assert!(space.release());
        assert!(!space.release());
        space.press(false);
        space.drag();
        space.press(false);
        assert!(!space.release());
        space.press(true);
        assert!(!space.release());
    }
}
