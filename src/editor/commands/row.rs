//! A row of the table of commands.

use super::line::Line;
use crate::editor::keymap::Chord;
use crate::editor::{Command, Editor};
use crate::words::{Phrase, texts};

/// The kind of state that a command changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Changes {
    /// The document, which undo restores.
    Document,
    /// The session: view, selection, playback. Undo leaves it alone.
    Session,
    /// Files, or what happens outside the editor: its effect is an [`crate::editor::Effect`].
    Files,
    /// The window and its settings only.
    Window,
}

/// The part of the help that a binding stands in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// The keyframe list.
    Keyframes,
    /// The timeline.
    Timeline,
    /// Playing.
    Playing,
    /// View, selection and camera.
    View,
    /// Files and undo.
    File,
    /// The window itself.
    Window,
}

impl Group {
    /// All of them, in the order of the help.
    pub const ALL: [Self; 6] = [Self::Keyframes, Self::Timeline, Self::Playing, Self::View, Self::File, Self::Window];

    /// Its heading.
    #[must_use]
    pub const fn heading(self) -> Phrase {
        match self {
            Self::Keyframes => texts::GROUP_KEYFRAMES,
            Self::Timeline => texts::GROUP_TIMELINE,
            Self::Playing => texts::GROUP_PLAYING,
            Self::View => texts::GROUP_VIEW,
            Self::File => texts::GROUP_FILE,
            Self::Window => texts::GROUP_WINDOW,
        }
    }

    /// The menu of its bindings that name no other.
    const fn menu(self) -> Menu {
        match self {
            Self::Keyframes | Self::Timeline => Menu::Edit,
            Self::Playing => Menu::Animation,
            Self::View | Self::Window => Menu::View,
            Self::File => Menu::File,
        }
    }
}

/// The menus of the menu bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Menu {
    /// Files, pictures, films.
    File,
    /// Changes of the document.
    Edit,
    /// How the scene and the window look.
    View,
    /// Playing.
    Animation,
    /// The help, and lists of commands and hotkeys.
    Help,
}

impl Menu {
    /// All of them, in the order of the menu bar.
    pub const ALL: [Self; 5] = [Self::File, Self::Edit, Self::View, Self::Animation, Self::Help];
}

/// Window state that the editor does not know but that ticks in menus depend on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WindowState {
    /// Whether the log of messages is shown.
    pub messages: bool,
    /// Whether the poses with names are shown.
    pub poses: bool,
    /// Whether the statistics are shown.
    pub statistics: bool,
    /// Whether a journal is kept.
    pub journal: bool,
    /// Whether files are read again when another program changes them.
    pub reload: bool,
    /// Whether the first steps are shown.
    pub tour: bool,
    /// Whether the window begins with the scene's first eye.
    pub recorded_eye: bool,
    /// Whether changes of the view show at once.
    pub reduce_motion: bool,
    /// Whether the corner with what the recorded camera sees stays while something plays.
    pub inset_while_playing: bool,
    /// Whether the picture is refined while nothing moves.
    pub refine_at_rest: bool,
}

/// A menu in a menu.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Submenu {
    /// Where one looks from, and what is in sight.
    Look,
    /// Whose axes handles go by.
    Axes,
    /// The light of the scene.
    Lighting,
}

impl Submenu {
    /// Its name.
    #[must_use]
    pub const fn title(self) -> Phrase {
        match self {
            Self::Look => texts::LOOK,
            Self::Axes => texts::AXES_OF_HANDLES,
            Self::Lighting => texts::LIGHTING,
        }
    }
}

/// The section of a menu that most items stand in.
const USUAL_SECTION: u8 = 5;

/// How a command appears in menus, in the command list and in the help, and its default hotkeys.
#[derive(Clone, Debug)]
pub struct Binding {
    /// Its stable id in kebab-case, as in `keyframe-new`: what settings and scripts call it.
    pub id: &'static str,
    /// The command that it stands for.
    pub command: Command,
    /// Where it stands in the help.
    pub group: Group,
    /// Its default hotkeys, the first of them the one that menus show.
    pub chords: Vec<Chord>,
    /// Whether holding the hotkey repeats it.
    pub repeats: bool,
    /// The menu that shows it.
    pub menu: Menu,
    /// Its section there: smaller ones stand first, with a separator between different ones.
    pub section: u8,
    /// The menu in that menu that it stands in, if it does. All items of one stand in one section.
    pub submenu: Option<Submenu>,
    /// Whether menus tick it.
    pub is_on: fn(&Editor, WindowState) -> bool,
}

impl Binding {
    pub(super) fn new(group: Group, id: &'static str, command: Command) -> Self {
        Self {
            id,
            command,
            group,
            chords: Vec::new(),
            repeats: false,
            menu: group.menu(),
            section: USUAL_SECTION,
            submenu: None,
            is_on: |_, _| false,
        }
    }

    /// Its name in menus and lists: the text `command.ID`.
    #[must_use]
    pub fn title(&self) -> Phrase {
        Phrase::of_id(&format!("command.{}", self.id)).expect("en.txt has the name of every row, which a test checks")
    }

    /// What it does, in a sentence for the help: the text `command.ID.help`.
    #[must_use]
    pub fn explanation(&self) -> Phrase {
        Phrase::of_id(&format!("command.{}.help", self.id))
            .expect("en.txt has the help of every row, which a test checks")
    }

    /// Other words by which the list of commands finds it, separated by commas: the text `command.ID.also`, where there is one.
    #[must_use]
    pub fn synonyms(&self) -> Option<Phrase> {
        Phrase::of_id(&format!("command.{}.also", self.id))
    }

    /// Gives it default hotkeys, as [`Chord::parse`] reads them.
    pub(super) fn hotkeys(mut self, keys: &[&str]) -> Self {
        self.chords = keys.iter().map(|key| Chord::parse(key).expect("the table's hotkeys are hotkeys")).collect();
        self
    }

    /// Gives it default hotkeys that repeat while they are held.
    pub(super) fn repeating_hotkeys(self, keys: &[&str]) -> Self {
        Self { repeats: true, ..self.hotkeys(keys) }
    }

    pub(super) fn menu(self, menu: Menu) -> Self {
        Self { menu, ..self }
    }

    pub(super) fn section(self, section: u8) -> Self {
        Self { section, ..self }
    }

    /// Puts it in a menu in its menu, in a section with the others there.
    pub(super) fn within(self, submenu: Submenu, section: u8) -> Self {
        Self { submenu: Some(submenu), section, ..self }
    }

    pub(super) fn ticked(self, is_on: fn(&Editor, WindowState) -> bool) -> Self {
        Self { is_on, ..self }
    }
}

/// One row of the table: a kind of [`Command`].
#[derive(Clone, Debug)]
pub struct Row {
    /// Its stable id in kebab-case: that of its binding, where it has one of its own.
    pub id: &'static str,
    /// What it changes.
    pub changes: Changes,
    /// Its script lines, the preferred one first; where it has none, `do` and the id of a binding.
    pub lines: Vec<Line>,
    /// Its entries in menus and lists: one for a command without parameters, and one for each offered value of a command with parameters.
    pub bindings: Vec<Binding>,
    /// Whether it is enabled, apart from the refusal while playing.
    pub can: fn(&Editor, &Command) -> bool,
    /// The action that is refused while playing, as in "delete a keyframe"; `None` if it is allowed.
    pub refused_while_playing: Option<Phrase>,
    /// Whether a drag sends it repeatedly. During a drag it is then part of the drag's undo step.
    pub is_continuous: bool,
    /// Whether it ends a scrub first.
    pub ends_scrub: bool,
    owns: Option<fn(&Command) -> bool>,
}

impl Row {
    /// The row of a command without parameters.
    pub(super) fn listed(changes: Changes, binding: Binding) -> Self {
        Self { owns: None, bindings: vec![binding.clone()], ..Self::bare(binding.id, changes) }
    }

    /// The row of a command with parameters, or of one that no list shows.
    pub(super) fn of(changes: Changes, id: &'static str, owns: fn(&Command) -> bool) -> Self {
        Self { owns: Some(owns), ..Self::bare(id, changes) }
    }

    fn bare(id: &'static str, changes: Changes) -> Self {
        Self {
            id,
            changes,
            lines: Vec::new(),
            bindings: Vec::new(),
            can: |_, _| true,
            refused_while_playing: None,
            is_continuous: false,
            ends_scrub: false,
            owns: None,
        }
    }

    /// Whether a command is of this row.
    #[must_use]
    pub fn owns(&self, command: &Command) -> bool {
        match self.owns {
            Some(owns) => owns(command),
            None => self.bindings.iter().any(|binding| binding.command == *command),
        }
    }

    pub(super) fn binding(mut self, binding: Binding) -> Self {
        self.bindings.push(binding);
        self
    }

    pub(super) fn line(mut self, line: Line) -> Self {
        self.lines.push(line);
        self
    }

    /// Gives a command without parameters a line that is one word.
    pub(super) fn word(self, name: &'static str, does: &'static str) -> Self {
        let command = self.bindings[0].command.clone();
        self.line(Line::word(name, does, command))
    }

    pub(super) fn can(self, can: fn(&Editor, &Command) -> bool) -> Self {
        Self { can, ..self }
    }

    pub(super) fn refused(self, what: Phrase) -> Self {
        Self { refused_while_playing: Some(what), ..self }
    }

    pub(super) fn continuous(self) -> Self {
        Self { is_continuous: true, ..self }
    }

    pub(super) fn ends_scrub(self) -> Self {
        Self { ends_scrub: true, ..self }
    }
}
