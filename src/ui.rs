//! The panels: menus, node tree, inspector, transport, timeline, status, help and dialogs.
//!
//! Widgets read a shared [`Editor`] and push [`Command`]s; nothing here changes it. Only zoom, scroll, folding and text that is being
//! typed live in [`Panels`]. Nothing here knows the window, the GPU, files or the clock.

pub mod angles;
mod bar;
mod changed;
mod choices;
mod dialogs;
mod export;
mod fonts;
mod help;
mod hotkeys;
mod icons;
mod inspector;
mod legend;
mod log;
mod manual;
mod menu;
mod overlay;
mod overwrite;
mod palette;
mod program;
mod recovery;
mod statistics;
mod status;
pub mod theme;
mod thumbnails;
mod timeline;
mod transport;
mod tree;
pub mod words;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use egui::{CentralPanel, Frame, Margin, Panel, Rect, ScrollArea};

use crate::editor::commands::WindowState;
use crate::editor::keymap::{Binding, Keymap};
use crate::editor::{Command, Editor, FileCommand};
use crate::film::ExportOptions;
use crate::pose::Pose;
use crate::settings::Settings;
use crate::words::Message;
pub use changed::{ChangeAnswer, ChangeOffer};
use dialogs::Dialog;
pub use export::Exporting;
pub use overwrite::{OverwriteAnswer, OverwriteQuestion, OverwriteReason};
pub use recovery::{RecoveryAnswer, RecoveryOffer};
pub use statistics::Statistics;
use theme::Tokens;
pub use thumbnails::THUMBNAIL_PX;

/// What the user answered to the question about unsaved work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuitAnswer {
    /// Make a keyframe of the pose on screen, write the file, and quit.
    KeepPoseAndSave,
    /// Write the file, and quit.
    Save,
    /// Quit.
    Discard,
}

/// What a path is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PathPurpose {
    /// To open it.
    Open,
    /// To show its animation beside the document's.
    Compare,
    /// To write to it.
    SaveAs,
    /// To write the scene to it.
    SaveSceneAs,
}

/// What came of showing the panels once.
#[derive(Clone, Debug, PartialEq)]
pub struct UiOutput {
    /// What the user asked for, in order.
    pub commands: Vec<Command>,
    /// Where the 3D view is, in points from the window's top left.
    pub viewport: Rect,
    /// The answer to [`Panels::ask_before_quitting`], once.
    pub quit_answer: Option<QuitAnswer>,
    /// Panels whose edges were dragged, and their new sizes in points, once.
    pub panels: Vec<(&'static str, f32)>,
    /// The answer to [`Panels::recovery`], once.
    pub recovery: Option<RecoveryAnswer>,
    /// The answer to [`Panels::changed`], once.
    pub change: Option<ChangeAnswer>,
    /// The answer to [`Panels::ask_before_overwriting`], once; there is none where the user cancels.
    pub overwrite: Option<OverwriteAnswer>,
}

impl Default for UiOutput {
    fn default() -> Self {
        Self {
            commands: Vec::new(),
            viewport: Rect::NOTHING,
            quit_answer: None,
            panels: Vec::new(),
            recovery: None,
            change: None,
            overwrite: None,
        }
    }
}

impl UiOutput {
    /// Adds what came of showing the panels again.
    pub fn go_on(&mut self, again: Self) {
        let Self { commands, viewport, quit_answer, panels, recovery, change, overwrite } = again;
        self.commands.extend(commands);
        self.viewport = viewport;
        self.quit_answer = self.quit_answer.or(quit_answer);
        self.panels.extend(panels);
        self.recovery = self.recovery.or(recovery);
        self.change = self.change.or(change);
        self.overwrite = self.overwrite.or(overwrite);
    }
}

/// What all panels read.
#[derive(Clone, Copy)]
struct PanelInput<'a> {
    editor: &'a Editor,
    keymap: &'a Keymap,
    settings: &'a Settings,
    /// Whether an export is under way.
    is_exporting: bool,
}

/// A panel's size when it was last shown.
#[derive(Clone, Copy, Debug)]
struct PanelSize {
    size: f32,
    is_dragged: bool,
    /// Frames since all buttons were released. The final size is only reported one frame later.
    rests: u8,
}

/// The panels and their own state.
#[derive(Debug, Default)]
pub struct Panels {
    keymap: Keymap,
    settings: Settings,
    log: log::Log,
    manual: manual::Manual,
    watched: BTreeMap<&'static str, PanelSize>,
    tree: tree::Tree,
    angles: angles::ShownAngles,
    timeline: timeline::Timeline,
    thumbnails: thumbnails::Thumbnails,
    dialog: Option<Dialog>,
    /// What was exported last, and of which keyframe file.
    exported: Option<(PathBuf, ExportOptions)>,
    /// The running export.
    pub exporting: Option<Exporting>,
    /// What is offered that was not saved.
    pub recovery: Option<RecoveryOffer>,
    /// The file that another program has changed.
    pub changed: Option<ChangeOffer>,
    /// How fast the window is, where that is shown.
    pub statistics: Option<Statistics>,
}

impl Panels {
    /// Panels as they are at first.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Asks for a path in a field of our own, for want of a system's dialog. The answer is a command.
    pub fn ask_for_path(&mut self, purpose: PathPurpose, proposed: &Path) {
        self.dialog = Some(Dialog::for_path(purpose, proposed));
    }

    /// Asks what to do with unsaved work before quitting. The answer is [`UiOutput::quit_answer`]; there is none where the user cancels.
    pub fn ask_before_quitting(&mut self) {
        self.dialog = Some(Dialog::Quit);
    }

    /// Asks before a file is replaced that holds something that the user may not know of. The answer is [`UiOutput::overwrite`].
    pub fn ask_before_overwriting(&mut self, question: OverwriteQuestion) {
        self.dialog = Some(Dialog::Overwrite(question));
    }

    /// Shows what differs, in the question before a file is replaced, if that is still asked.
    pub fn show_differences(&mut self, differences: Vec<Message>) {
        if let Some(Dialog::Overwrite(question)) = &mut self.dialog {
            question.differences = Some(differences);
        }
    }

    /// Takes in where an export is to go, as the system's dialog was answered, if that is still asked.
    pub fn choose_export_path(&mut self, path: &Path) {
        if let Some(Dialog::Export(dialog)) = &mut self.dialog {
            dialog.choose(path);
        }
    }

    /// Whether a dialog waits for an answer: no hotkey fires then, and the scene takes no drags.
    #[must_use]
    pub const fn has_dialog(&self) -> bool {
        self.dialog.is_some() || self.manual.is_open()
    }

    /// Whether a text field, or a dialog, has the keyboard, so that no hotkey may fire.
    #[must_use]
    pub fn has_keyboard(&self, context: &egui::Context) -> bool {
        self.has_dialog() || context.text_edit_focused()
    }

    /// Whether Escape is for something of the panels: a field, a dialog, a drag on the timeline, or an open menu.
    #[must_use]
    pub fn takes_escape(&self, context: &egui::Context) -> bool {
        self.has_keyboard(context) || self.timeline.takes_escape() || egui::Popup::is_any_open(context)
    }

    /// Whether arrows are for the timeline, because the focus is there.
    #[must_use]
    pub fn takes_arrows(&self, context: &egui::Context) -> bool {
        self.timeline.takes_arrows(context)
    }

    /// A keyframe's pose whose picture is wanted and not there yet: hand it to [`Panels::put_thumbnail`] when nothing else is to be done.
    #[must_use]
    pub fn wanted_thumbnail(&self) -> Option<&Pose> {
        self.thumbnails.wanted()
    }

    /// Takes in the picture of a pose: [`THUMBNAIL_PX`] pixels, four bytes each, red first, from the top left.
    pub fn put_thumbnail(&mut self, context: &egui::Context, pose: Pose, rgba: &[u8]) {
        self.thumbnails.put(context, pose, rgba);
    }

    /// Shows the panels in the whole window's `ui`.
    pub fn show(&mut self, ui: &mut egui::Ui, editor: &Editor) -> UiOutput {
        self.apply_settings_to(ui.ctx());
        self.thumbnails.begin();
        self.log.take_in(editor.said(), ui.input(|input| input.time));
        let mut output = UiOutput::default();
        if editor.session().shows_panels {
            self.show_panels(ui, editor, &mut output.commands);
        }
        output.recovery = self.recovery.as_ref().and_then(|offer| recovery::show(ui, offer));
        output.change = self.changed.as_ref().and_then(|offer| changed::show(ui, offer));
        output.viewport = CentralPanel::no_frame().show(ui, |ui| ui.max_rect()).inner;
        overlay::show(ui, output.viewport, editor, &self.keymap, &self.log, self.statistics.as_ref());
        legend::show(ui, output.viewport, editor, &mut output.commands);
        if editor.session().shows_help {
            help::show(ui, self.keymap.bindings(), &mut output.commands);
        }
        self.log.show_list(ui.ctx(), output.viewport, &mut output.commands);
        self.log.show_toasts(ui, output.viewport);
        if let Some(exporting) = &self.exporting {
            export::show_progress(ui, output.viewport, exporting, &mut output.commands);
        }
        let is_exporting = self.exporting.is_some();
        let shown = PanelInput { editor, keymap: &self.keymap, settings: &self.settings, is_exporting };
        dialogs::show(ui, &mut self.dialog, shown, &mut output);
        self.manual.show(ui);
        if let Some(Command::File(FileCommand::Export(options))) = output.commands.last() {
            self.exported = Some((editor.keyframe_file().to_owned(), options.as_ref().clone()));
        }
        output.panels = self.dragged_panels(ui);
        output
    }

    fn show_panels(&mut self, ui: &mut egui::Ui, editor: &Editor, commands: &mut Vec<Command>) {
        let tokens = Tokens::of(ui);
        let plain = |fill, x, y| Frame::new().fill(fill).inner_margin(Margin::symmetric(x, y));
        let is_exporting = self.exporting.is_some();
        let shown = PanelInput { editor, keymap: &self.keymap, settings: &self.settings, is_exporting };
        let state = WindowState {
            messages: self.log.is_shown(),
            statistics: self.statistics.is_some(),
            journal: self.settings.journal,
            reload: self.settings.reload,
        };
        Panel::top("menu bar").exact_size(theme::MENU_BAR).frame(plain(tokens.panel, 4, 1)).show(ui, |ui| {
            menu::show(ui, shown, state, commands);
        });
        Panel::bottom("status").exact_size(theme::STATUS).frame(plain(tokens.panel, 8, 2)).show(ui, |ui| {
            status::show(ui, editor, self.statistics.as_ref());
        });
        let mut timeline_height = theme::TIMELINE;
        Panel::bottom("timeline")
            .default_size(self.panel_size("timeline", theme::TIMELINE))
            .size_range(96.0..=560.0)
            .resizable(true)
            .frame(Frame::new())
            .show(ui, |ui| {
                // What is in it may be lower than the panel.
                timeline_height = ui.available_height();
                self.timeline.show(ui, editor, self.keymap.bindings(), &mut self.thumbnails, commands);
            });
        self.watch_panel(ui, "timeline", timeline_height);
        Panel::bottom("transport").exact_size(theme::TRANSPORT).frame(plain(tokens.panel, 8, 4)).show(ui, |ui| {
            transport::show(ui, editor, self.keymap.bindings(), commands);
        });
        let side = Panel::right("side")
            .default_size(self.panel_size("side", theme::SIDE))
            .size_range(200.0..=480.0)
            .frame(plain(tokens.panel, 0, 0))
            .show(ui, |ui| self.show_side(ui, editor, commands));
        self.watch_panel(ui, "side", side.response.rect.width());
    }

    fn show_side(&mut self, ui: &mut egui::Ui, editor: &Editor, commands: &mut Vec<Command>) {
        Panel::bottom("inspector").frame(Frame::new().inner_margin(Margin::same(12))).show(ui, |ui| {
            inspector::show(ui, editor, &mut self.angles, &self.keymap, commands);
        });
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            Frame::new().inner_margin(Margin { left: 4, right: 4, top: 8, bottom: 8 }).show(ui, |ui| {
                self.tree.show(ui, editor, &self.keymap, commands);
            });
        });
    }
}

/// The hotkeys of a command as text; empty if it has none.
fn key_of(keymap: &Keymap, command: &Command) -> String {
    binding_of(keymap.bindings(), command).map(Binding::menu_key).unwrap_or_default()
}

/// A tip, and the key that does the same.
fn tip(text: &str, key: &str) -> String {
    if key.is_empty() { text.to_owned() } else { format!("{text}  ·  {key}") }
}

/// The row of the table for a command.
fn binding_of<'a>(bindings: &'a [Binding], command: &Command) -> Option<&'a Binding> {
    bindings.iter().find(|binding| binding.command == *command)
}
