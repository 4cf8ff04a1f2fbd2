//! The panels: menus, node tree, inspector, transport, timeline, status, help and dialogs.
//!
//! Widgets read a shared [`Editor`] and push [`Command`]s; nothing here changes it. Only zoom, scroll, folding and text that is being
//! typed live in [`Panels`]. Nothing here knows the window, the GPU, files or the clock.

mod about;
mod access;
pub mod angles;
mod axis_letters;
mod bar;
mod changed;
mod choices;
mod dialogs;
mod export;
mod export_shape;
mod fonts;
mod gestures;
mod help;
mod hotkeys;
mod icons;
mod inset;
mod inspector;
mod layout;
mod legend;
mod log;
mod manual;
mod menu;
mod model_question;
mod node_menu;
mod overlay;
mod overwrite;
mod palette;
mod path_dialog;
mod path_purpose;
mod pointed;
mod poses;
mod program;
mod readout;
mod recovery;
mod statistics;
mod status;
pub mod theme;
mod thumbnails;
mod timeline;
mod tour;
mod transport;
mod tree;
pub mod words;

use std::path::{Path, PathBuf};

use egui::{CentralPanel, Rect, TextureId};

use crate::editor::keymap::{Binding, Keymap};
use crate::editor::{Command, Editor, FileCommand, WorkEye};
use crate::film::ExportOptions;
use crate::interchange::gltf_in::Contents;
use crate::pose::{Pose, RbtIndex};
use crate::pose_file::PoseFile;
use crate::settings::Settings;
use crate::words::{Message, texts};
pub use changed::{ChangeAnswer, ChangeOffer};
use dialogs::Dialog;
pub use export::Exporting;
use model_question::ModelQuestion;
pub use overwrite::{OverwriteAnswer, OverwriteQuestion, OverwriteReason};
use path_dialog::PathDialog;
pub use path_dialog::{FolderEntry, Listing};
pub use path_purpose::PathPurpose;
pub use recovery::{RecoveryAnswer, RecoveryOffer};
pub use statistics::Statistics;
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

/// What came of showing the panels once.
#[derive(Clone, Debug, PartialEq)]
pub struct UiOutput {
    /// What the user asked for, in order.
    pub commands: Vec<Command>,
    /// Where the 3D view is, in points from the window's top left.
    pub viewport: Rect,
    /// The answer to [`Panels::ask_before_quitting`], once.
    pub quit_answer: Option<QuitAnswer>,
    /// Panels whose edges were dragged, and their new sizes in points, once; `None`: the usual size.
    pub panels: Vec<(&'static str, Option<f32>)>,
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
    /// What a report of a fault says.
    facts: &'a str,
    /// The size of the 3D view, in points.
    view: egui::Vec2,
}

/// The panels and their own state.
#[derive(Debug, Default)]
pub struct Panels {
    keymap: Keymap,
    settings: Settings,
    log: log::Log,
    manual: manual::Manual,
    help: help::Help,
    tour: tour::Tour,
    rooms: layout::Rooms,
    /// Panels whose edges were dragged since that was last reported.
    resized: Vec<(&'static str, Option<f32>)>,
    tree: tree::Tree,
    angles: angles::ShownAngles,
    timeline: timeline::Timeline,
    thumbnails: thumbnails::Thumbnails,
    poses: poses::Poses,
    /// The node that the menu over the scene is for.
    scene_menu: Option<RbtIndex>,
    dialog: Option<Dialog>,
    /// What was exported last, and of which keyframe file.
    exported: Option<(PathBuf, ExportOptions)>,
    /// The running export.
    pub exporting: Option<Exporting>,
    /// The film that was exported last, until its notice is closed.
    pub made: Option<PathBuf>,
    /// What is offered that was not saved.
    pub recovery: Option<RecoveryOffer>,
    /// The file that another program has changed.
    pub changed: Option<ChangeOffer>,
    /// What a report of a fault says of the program and of the system, a line a fact.
    pub facts: String,
    /// How fast the window is, where that is shown.
    pub statistics: Option<Statistics>,
    /// The name of what the pointer is over in the scene, where it can be chosen or dragged.
    pub pointed: Option<Message>,
    /// Where the scene is looked at from while the picture is on its way there; `None`: from the editor's eye.
    pub drawn_eye: Option<WorkEye>,
    /// The picture of what the recorded camera sees, once there is one.
    pub inset: Option<TextureId>,
    /// Its size in pixels, where it shows.
    inset_px: Option<[u32; 2]>,
}

impl Panels {
    /// Panels as they are at first.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Asks for a path in a dialog of our own, for want of a system's. The answer is a command, or goes into the export dialog, which
    /// comes back: where that is closed, it is not asked any more.
    pub fn ask_for_path(&mut self, purpose: PathPurpose, proposed: &Path) {
        let asks = PathDialog::new(purpose, proposed);
        self.dialog = match (self.dialog.take(), purpose) {
            (Some(Dialog::Export(export)), PathPurpose::Film | PathPurpose::FilmFolder) => {
                Some(Dialog::Path(Box::new(asks.for_export(export))))
            }
            (other, PathPurpose::Film | PathPurpose::FilmFolder) => other,
            _ => Some(Dialog::Path(Box::new(asks))),
        };
    }

    /// A folder whose contents the dialog for a path shows, where they have to be read: hand them to [`Panels::put_folder`].
    #[must_use]
    pub fn wanted_folder(&self) -> Option<PathBuf> {
        let Some(Dialog::Path(path)) = &self.dialog else { return None };
        path.wanted_folder()
    }

    /// Takes in what is in a folder that was wanted.
    pub fn put_folder(&mut self, listing: Listing) {
        if let Some(Dialog::Path(path)) = &mut self.dialog {
            path.put(listing);
        }
    }

    /// Asks what to do with unsaved work before quitting. The answer is [`UiOutput::quit_answer`]; there is none where the user cancels.
    pub fn ask_before_quitting(&mut self) {
        self.dialog = Some(Dialog::Unsaved { is_quitting: true });
    }

    /// Asks what to do with unsaved work before another document is shown, and answers as [`Self::ask_before_quitting`].
    pub fn ask_before_going_on(&mut self) {
        self.dialog = Some(Dialog::Unsaved { is_quitting: false });
    }

    /// Asks which scene and which animation of a model are opened. The answer is a command.
    pub fn ask_what_of_model(&mut self, path: PathBuf, contents: Contents) {
        self.dialog = Some(Dialog::Model(ModelQuestion::new(path, contents)));
    }

    /// Forgets what belongs to a document that is no longer shown: what is folded, chosen and zoomed.
    pub fn begin_anew(&mut self) {
        self.tree = tree::Tree::default();
        self.angles = angles::ShownAngles::default();
        self.timeline = timeline::Timeline::default();
        self.thumbnails = thumbnails::Thumbnails::default();
        self.exported = None;
    }

    /// Forgets pictures that were on a device which is gone. They are wanted again where they are in sight.
    pub fn forget_textures(&mut self) {
        self.thumbnails = thumbnails::Thumbnails::default();
        self.inset = None;
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

    /// Takes in a path that the system's dialog was answered with. One for an export goes into its dialog, if that is still open; any
    /// other is a command.
    pub fn path_chosen(&mut self, purpose: PathPurpose, path: PathBuf) -> Option<Command> {
        match (&mut self.dialog, purpose) {
            (Some(Dialog::Export(export)), PathPurpose::Film | PathPurpose::FilmFolder) => export.choose(&path),
            _ => return purpose.command(path),
        }
        None
    }

    /// Whether a dialog waits for an answer: no hotkey fires then, and the scene takes no drags.
    #[must_use]
    pub const fn has_dialog(&self) -> bool {
        self.dialog.is_some() || self.manual.is_open()
    }

    /// Whether a text field, a dialog or a menu has the keyboard, so that no hotkey may fire.
    #[must_use]
    pub fn has_keyboard(&self, context: &egui::Context) -> bool {
        self.has_dialog() || context.text_edit_focused() || egui::Popup::is_any_open(context)
    }

    /// Whether Escape is for something of the panels: a field, a dialog, a drag on the timeline, or an open menu.
    #[must_use]
    pub fn takes_escape(&self, context: &egui::Context) -> bool {
        self.has_keyboard(context) || self.timeline.takes_escape()
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

    /// The size in pixels of the picture of what the recorded camera sees, where that shows: [`Panels::inset`].
    #[must_use]
    pub const fn wanted_inset(&self) -> Option<[u32; 2]> {
        self.inset_px
    }

    /// Takes in the user's own poses.
    pub fn put_own_poses(&mut self, poses: Vec<PoseFile>) {
        self.poses.put_own(poses);
    }

    /// Shows the panels in the whole window's `ui`.
    pub fn show(&mut self, ui: &mut egui::Ui, editor: &Editor) -> UiOutput {
        self.apply_settings_to(ui.ctx());
        self.thumbnails.begin();
        self.log.take_in(editor.said(), ui.input(|input| input.time));
        let mut output = UiOutput::default();
        if self.has_dialog() || editor.session().shows_help {
            hide_tooltips(ui);
        }
        if editor.session().shows_panels {
            self.show_panels(ui, editor, &mut output.commands);
        }
        output.recovery = self.recovery.as_ref().and_then(|offer| recovery::show(ui, offer));
        output.change = self.changed.as_ref().and_then(|offer| changed::show(ui, offer));
        output.viewport = CentralPanel::no_frame().show(ui, |ui| ui.max_rect()).inner;
        say_of_frame(ui, editor, output.viewport);
        let bindings = self.keymap.bindings();
        node_menu::show_over_scene(ui, output.viewport, editor, bindings, &mut self.scene_menu, &mut output.commands);
        overlay::show(ui, output.viewport, editor, &self.keymap, &self.log, self.statistics.as_ref());
        let below_legend = legend::show(ui, output.viewport, editor, &mut output.commands);
        self.tour.take_in(editor, self.settings.tour);
        let is_moving = editor.wants_ticks() && !self.settings.inset_while_playing;
        let has_inset = editor.session().shows_inset && editor.is_work_eye() && !is_moving;
        self.inset_px = if has_inset {
            let is_busy_above = self.tour.is_shown() || legend::is_shown(editor);
            inset::show(ui, output.viewport, editor, self.inset, is_busy_above, &mut output.commands)
        } else {
            None
        };
        let rotation = self.drawn_eye.map(|eye| eye.rotation());
        axis_letters::show(ui, output.viewport, editor, rotation, &self.keymap, &mut output.commands);
        self.tour.show(ui, below_legend, &self.keymap, &mut output.commands);
        if let Some(name) = &self.pointed {
            pointed::show(ui, output.viewport, name);
        }
        readout::show(ui, output.viewport, editor);
        if editor.session().shows_help {
            self.help.show(ui, self.keymap.bindings(), &mut output.commands);
        }
        self.poses.show(ui.ctx(), output.viewport, editor, &mut self.thumbnails, &mut output.commands);
        self.log.show_list(ui.ctx(), output.viewport, &mut output.commands);
        self.log.show_toasts(ui, output.viewport);
        if let Some(exporting) = &self.exporting {
            export::show_progress(ui, output.viewport, exporting, &mut output.commands);
        } else if let Some(made) = &self.made
            && export::show_made(ui, output.viewport, made, &mut output.commands)
        {
            self.made = None;
        }
        let is_exporting = self.exporting.is_some();
        let view = output.viewport.size();
        let facts = &self.facts;
        let shown = PanelInput { editor, keymap: &self.keymap, settings: &self.settings, is_exporting, facts, view };
        dialogs::show(ui, &mut self.dialog, shown, &mut output);
        self.manual.show(ui);
        if let Some(Command::File(FileCommand::Export(options))) = output.commands.last() {
            self.exported = Some((editor.keyframe_file().to_owned(), options.as_ref().clone()));
        }
        output.panels = std::mem::take(&mut self.resized);
        output
    }
}

/// What screen readers say of the window itself and of the 3D view, which are no widgets.
fn say_of_frame(ui: &egui::Ui, editor: &Editor, viewport: Rect) {
    let words = words::Words::of(ui);
    ui.ctx().accesskit_node_builder(egui::accesskit_root_id(), |node| {
        node.set_label(format!("{} • {}", editor.keyframe_file().display(), words.say(texts::WINDOW_OF_INBETWEEN)));
    });
    let looks = words.message(editor.view_sentence());
    let [min, max] = [viewport.min, viewport.max].map(|at| at * ui.pixels_per_point());
    ui.ctx().accesskit_node_builder(egui::Id::unique("3D view"), |node| {
        node.set_role(egui::accesskit::Role::Canvas);
        node.set_label(words.say(texts::THE_3D_VIEW));
        node.set_value(looks);
        let (x0, y0, x1, y1) = (min.x.into(), min.y.into(), max.x.into(), max.y.into());
        node.set_bounds(egui::accesskit::Rect { x0, y0, x1, y1 });
    });
}

/// Hides tooltips of what lies under a dialog: one that is open would stay over it as long as the pointer rests. Tooltips give way to
/// open popups of their layer; this is one without a place, which shows nothing.
fn hide_tooltips(ui: &egui::Ui) {
    let id = egui::Id::unique("no tooltips");
    let nowhere = egui::PopupAnchor::PointerFixed;
    let popup = egui::Popup::new(id, ui.ctx().clone(), nowhere, ui.layer_id());
    let _ = popup.open(true).show(|_| ());
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
