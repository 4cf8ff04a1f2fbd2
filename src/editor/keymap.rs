//! Hotkeys: one table of bindings, from which the help, the menus and the README's block are made.

use super::{Command, Edit, FileCommand, PlaybackCommand, ViewCommand};

/// A key as it is named, apart from its modifiers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Key {
    /// A key that types this character; letters in lower case.
    Character(char),
    /// The space bar.
    Space,
    /// Escape.
    Escape,
    /// F11.
    F11,
    /// Home.
    Home,
}

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
    /// What is held with it. For a sign, such as `>`, Shift does not matter: boards differ in what types it.
    pub modifiers: Modifiers,
}

/// A press of a key, as the window or a script gives it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KeyPress {
    /// What the layout in force makes of it, whatever Ctrl and Alt do.
    pub typed: Option<Key>,
    /// What a US board has in the same place, Shift taken into account.
    pub placed: Option<Key>,
    /// What is held with it.
    pub modifiers: Modifiers,
    /// Whether it comes from holding the key down.
    pub is_repeat: bool,
}

/// Which part of the help a binding stands in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// The keyframe list.
    Keyframes,
    /// Playing.
    Playing,
    /// Looking and handling.
    View,
    /// Files and undo.
    File,
}

impl Group {
    /// Its heading.
    #[must_use]
    pub const fn heading(self) -> &'static str {
        match self {
            Self::Keyframes => "Keyframes",
            Self::Playing => "Playing",
            Self::View => "Looking and handling",
            Self::File => "Files and undo",
        }
    }
}

/// One row of the table.
#[derive(Clone, Debug)]
pub struct Binding {
    /// The keys, the first of them the one that menus show; empty for what only menus do.
    pub chords: Vec<Chord>,
    /// What it does.
    pub command: Command,
    /// Its name in menus and lists, as in "New keyframe".
    pub name: &'static str,
    /// What it does, in a sentence for the help.
    pub help: &'static str,
    /// Where it stands in the help.
    pub group: Group,
    /// Whether holding the key repeats it.
    pub repeats: bool,
}

impl Binding {
    /// Its keys for people: `c or Space`.
    #[must_use]
    pub fn keys(&self) -> String {
        self.chords.iter().map(Chord::label).collect::<Vec<_>>().join(" or ")
    }

    /// The key that a menu shows.
    #[must_use]
    pub fn menu_key(&self) -> String {
        self.chords.first().map(Chord::label).unwrap_or_default()
    }
}

impl Chord {
    /// The chord for people: `Ctrl+Shift+Z`, `>`, `n`.
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
            Key::Space => label.push_str("Space"),
            Key::Escape => label.push_str("Esc"),
            Key::F11 => label.push_str("F11"),
            Key::Home => label.push_str("Home"),
        }
        label
    }

    fn matches(&self, key: Key, modifiers: Modifiers) -> bool {
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

/// The table of bindings. The order is the help's.
#[must_use]
pub fn bindings() -> Vec<Binding> {
    let plain = Modifiers::default();
    let shift = Modifiers { shift: true, ..plain };
    let ctrl = Modifiers { ctrl: true, ..plain };
    let ctrl_shift = Modifiers { ctrl: true, shift: true, ..plain };
    let key = |key| Chord { key, modifiers: plain };
    let typed = |character| key(Key::Character(character));
    let held = |modifiers, character| Chord { key: Key::Character(character), modifiers };
    let row =
        |group, chords: Vec<Chord>, command, name, help| Binding { chords, command, name, help, group, repeats: false };
    let repeating =
        |group, chords, command, name, help| Binding { repeats: true, ..row(group, chords, command, name, help) };
    let edit = Command::Edit;
    let view = Command::View;
    vec![
        row(
            Group::Keyframes,
            vec![key(Key::Space), typed('c')],
            edit(Edit::DisplayCurrent),
            "Display keyframe",
            "Copy the current keyframe to the scene",
        ),
        row(
            Group::Keyframes,
            vec![typed('u')],
            edit(Edit::UpdateCurrent),
            "Update keyframe",
            "Update the current keyframe from the scene",
        ),
        repeating(
            Group::Keyframes,
            vec![typed('>'), typed('.')],
            edit(Edit::GoToNext),
            "Next keyframe",
            "Go to the next keyframe and copy it to the scene",
        ),
        repeating(
            Group::Keyframes,
            vec![typed('<'), typed(',')],
            edit(Edit::GoToPrevious),
            "Previous keyframe",
            "Go to the previous keyframe and copy it to the scene",
        ),
        row(
            Group::Keyframes,
            vec![typed('d')],
            edit(Edit::DeleteCurrent),
            "Delete keyframe",
            "Delete the current keyframe",
        ),
        row(
            Group::Keyframes,
            vec![typed('n')],
            edit(Edit::CreateKeyframe),
            "New keyframe",
            "New keyframe from the scene, after the current one",
        ),
        row(
            Group::Keyframes,
            vec![typed('r')],
            edit(Edit::ResetPose),
            "Rest pose",
            "Return the scene to its rest pose",
        ),
        row(
            Group::Playing,
            vec![typed('y')],
            Command::Playback(PlaybackCommand::PlayOrStop),
            "Play or stop",
            "Play from the first playable keyframe, or stop",
        ),
        row(
            Group::Playing,
            vec![held(shift, 'p')],
            Command::Playback(PlaybackCommand::PauseOrResume),
            "Pause or go on",
            "Pause: freeze the pose on screen into the scene; or go on from there",
        ),
        repeating(
            Group::Playing,
            vec![typed('+'), typed('=')],
            edit(Edit::Faster),
            "Faster",
            "100 ms less between keyframes",
        ),
        repeating(Group::Playing, vec![typed('-')], edit(Edit::Slower), "Slower", "100 ms more between keyframes"),
        row(
            Group::Playing,
            vec![typed('t')],
            edit(Edit::NextInterpolation),
            "Next interpolation",
            "Next interpolation: linear, Catmull-Rom",
        ),
        row(
            Group::Playing,
            vec![key(Key::Home)],
            view(ViewCommand::RestartSeconds),
            "Restart timed keys",
            "Set the clock of keys at their own times to zero (some lessons use the space bar for it)",
        ),
        row(
            Group::Playing,
            vec![Chord { key: Key::Home, modifiers: shift }],
            view(ViewCommand::HoldSeconds),
            "Hold timed keys",
            "Hold the clock of keys at their own times, or let it go on",
        ),
        row(
            Group::View,
            vec![typed('v')],
            view(ViewCommand::NextEye),
            "Next eye",
            "Look from the next eye: the sky, robot 1, robot 2",
        ),
        row(
            Group::View,
            vec![typed('p')],
            view(ViewCommand::StartPicking),
            "Pick a node",
            "Pick: the next click chooses the node to move; the ground chooses none",
        ),
        row(
            Group::View,
            vec![typed('m')],
            view(ViewCommand::ToggleSkyMode),
            "Sky camera's centre",
            "Move the sky camera about the world's centre, or about itself",
        ),
        row(Group::View, vec![typed('a')], view(ViewCommand::ToggleArcball), "Arcball", "Show or hide the arcball"),
        row(
            Group::View,
            vec![Chord { key: Key::Character('p'), modifiers: Modifiers { alt: true, ..plain } }],
            view(ViewCommand::TogglePath),
            "Motion path",
            "Show or hide the path that the chosen node takes",
        ),
        row(
            Group::View,
            vec![],
            view(ViewCommand::ToggleComparison),
            "Compare interpolations",
            "While playing, show the chosen robot under the other interpolations",
        ),
        row(Group::View, vec![typed('h')], view(ViewCommand::ToggleHelp), "Help", "Show or hide this help"),
        row(Group::View, vec![key(Key::F11)], view(ViewCommand::TogglePanels), "Panels", "Hide or show all panels"),
        row(Group::View, vec![key(Key::Escape)], Command::Cancel, "Cancel", "Leave the mode, drag or dialog at hand"),
        row(
            Group::File,
            vec![typed('i')],
            Command::File(FileCommand::Import),
            "Import",
            "Import the keyframe file; its first keyframe is shown",
        ),
        row(Group::File, vec![typed('w')], Command::File(FileCommand::Write), "Save", "Write the keyframe file"),
        row(
            Group::File,
            vec![held(ctrl, 'o')],
            Command::File(FileCommand::ChooseOpen),
            "Open…",
            "Open another keyframe file",
        ),
        row(
            Group::File,
            vec![held(ctrl_shift, 's')],
            Command::File(FileCommand::ChooseSaveAs),
            "Save As…",
            "Write to another keyframe file",
        ),
        row(
            Group::File,
            vec![typed('s')],
            Command::File(FileCommand::Screenshot(None)),
            "Screenshot",
            "Write a screenshot beside the keyframe file",
        ),
        repeating(Group::File, vec![held(ctrl, 'z')], Command::Undo, "Undo", "Undo"),
        repeating(Group::File, vec![held(ctrl_shift, 'z'), held(ctrl, 'y')], Command::Redo, "Redo", "Redo"),
        row(
            Group::File,
            vec![held(ctrl, 'q')],
            Command::File(FileCommand::Quit),
            "Quit",
            "Quit; asks where something is unsaved",
        ),
    ]
}

/// The binding that a press means: by what it types first, then by its place on the board.
///
/// A repeated press means only what repeats.
#[must_use]
pub fn binding_for(table: &[Binding], press: KeyPress) -> Option<&Binding> {
    [press.typed, press.placed]
        .into_iter()
        .flatten()
        .find_map(|key| {
            table.iter().find(|binding| binding.chords.iter().any(|chord| chord.matches(key, press.modifiers)))
        })
        .filter(|binding| binding.repeats || !press.is_repeat)
}

/// The press that a script's word means: a character itself, or `space`, `escape`, `f11`, `home`, with `shift+`, `ctrl+`, `alt+` before it.
#[must_use]
pub fn press_from_word(word: &str) -> Option<KeyPress> {
    let mut modifiers = Modifiers::default();
    let mut rest = word;
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
        _ => match rest.to_lowercase().as_str() {
            "space" => Key::Space,
            "escape" | "esc" => Key::Escape,
            "f11" => Key::F11,
            "home" => Key::Home,
            _ => return None,
        },
    };
    Some(KeyPress { typed: Some(key), placed: None, modifiers, is_repeat: false })
}

/// The table as Markdown, for the README.
#[must_use]
pub fn markdown() -> String {
    let mut text = String::from("| key | does |\n|---|---|\n");
    for binding in bindings() {
        if binding.chords.is_empty() {
            continue;
        }
        let keys: Vec<String> = binding.chords.iter().map(|chord| format!("`{}`", chord.label())).collect();
        text.push_str(&format!("| {} | {} |\n", keys.join(", "), binding.help));
    }
    text
}
