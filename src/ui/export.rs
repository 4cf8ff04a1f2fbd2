//! The export dialog, and the progress of a running export.

use std::path::{Path, PathBuf};

use egui::{
    Align, Align2, Area, Button, ComboBox, DragValue, Frame, Grid, Id, Label, Layout, Margin, Order, ProgressBar,
    Response, RichText, Role, ScrollArea, TextEdit, Ui, WidgetInfo, vec2,
};

use super::PanelInput;
use super::axis_letters;
use super::dialogs::default_button;
use super::export_shape;
use super::icons::was_pressed;
use super::theme::{CORNER, GRID, ROW, Tokens, dialog_width};
use super::words::Words;
use crate::editor::{Command, Editor, FileCommand, WindowCommand};
use crate::film::{Encoder, ExportBackground, ExportOptions, FORMATS, Format, Quality};
use crate::frame::MOST_GHOSTS;
use crate::keyframe::{PlayRange, to_f64};
use crate::lighting::BuiltInLighting;
use crate::words::texts;

/// Width of the dialog, in points.
const WIDTH: f32 = 460.0;
/// What of the window's height the fields leave to the rest of the dialog, in points.
const AROUND: f32 = 208.0;
/// Width of the labels before the fields, in points.
const LABELS: f32 = 108.0;
/// Width of what shows how far an export is, in points.
const PROGRESS: f32 = 260.0;
/// The sizes that are proposed, in pixels.
const SIZES: [[u32; 2]; 4] = [[320, 240], [640, 480], [1280, 720], [1920, 1080]];
/// Whether films go into folders that the user can see: what a page makes is downloaded.
const HAS_FOLDERS: bool = !cfg!(target_arch = "wasm32");
/// The colour behind everything that is proposed.
const COLOUR: [u8; 3] = [0xff, 0xff, 0xff];

/// The dialog.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExportDialog {
    /// What was exported last, and of which keyframe file.
    last: Option<(PathBuf, ExportOptions)>,
    options: Option<ExportOptions>,
    /// The path as it is typed.
    typed: String,
    has_begun: bool,
}

/// The running export.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exporting {
    /// Where it goes.
    pub path: PathBuf,
    /// Frames that are drawn.
    pub done: usize,
    /// Frames in all; 0 where that is not known yet.
    pub count: usize,
    /// Whether it was told to end.
    pub is_ending: bool,
}

impl ExportDialog {
    /// A dialog that proposes what was chosen last.
    pub fn new(last: Option<(PathBuf, ExportOptions)>) -> Self {
        Self { last, ..Self::default() }
    }

    /// Puts a path in that the system's dialog was answered with.
    pub fn choose(&mut self, path: &Path) {
        self.typed = path.to_string_lossy().into_owned();
    }

    /// Shows it. Says whether it is over.
    pub fn show(&mut self, ui: &mut Ui, shown: PanelInput<'_>, is_busy: bool, commands: &mut Vec<Command>) -> bool {
        let words = Words::of(ui);
        let tokens = Tokens::of(ui);
        let Self { last, options, typed, has_begun } = self;
        let options = options.get_or_insert_with(|| proposed(last.take(), shown.editor.keyframe_file()));
        if typed.is_empty() && !*has_begun {
            *typed = options.path.to_string_lossy().into_owned();
        }
        let width = dialog_width(ui, WIDTH);
        ui.set_width(width);
        ui.heading(words.say(texts::EXPORT_A_FILM));
        ui.add_space(2.0 * GRID);
        let height = (ui.ctx().content_rect().height() - AROUND).max(3.0 * ROW);
        // The bar stands in the dialog's margin.
        ui.spacing_mut().scroll.bar_outer_margin = -3.0 * GRID;
        ScrollArea::vertical().max_height(height).min_scrolled_height(height).auto_shrink([false, true]).show(
            ui,
            |ui| {
                Grid::new("export").num_columns(2).min_col_width(LABELS).spacing(vec2(2.0 * GRID, 1.5 * GRID)).show(
                    ui,
                    |ui| {
                        row(ui, words.say(texts::FORMAT), |ui| format(ui, options, typed, words));
                        let is_folder = options.format.is_still();
                        let label = if is_folder { words.say(texts::FOLDER) } else { words.say(texts::FILE) };
                        row(ui, label, |ui| {
                            let browse = Button::new(words.say(texts::BROWSE));
                            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                                if HAS_FOLDERS && was_pressed(&ui.add(browse)) {
                                    let proposed = PathBuf::from(typed.trim());
                                    commands.push(Command::File(FileCommand::ChooseExport { proposed, is_folder }));
                                }
                                let field = ui.add(TextEdit::singleline(typed).desired_width(f32::INFINITY));
                                named(&field, Role::TextInput, words.say(texts::PATH));
                                if !std::mem::replace(has_begun, true) {
                                    field.request_focus();
                                }
                            });
                        });
                        row(ui, words.say(texts::SIZE), |ui| size(ui, options, words));
                        high_row(ui, export_shape::ROOM.y, words.say(texts::SHAPE), |ui| {
                            export_shape::show(ui, options.size, shown.view);
                        });
                        row(ui, words.say(texts::FRAMES_A_SECOND), |ui| {
                            let most = options.format.most_frames_per_second;
                            number(ui, &mut options.fps, 1..=most, words.say(texts::FRAMES_A_SECOND));
                        });
                        row(ui, words.say(texts::KEY_TIMES), |ui| range(ui, options, shown.editor, words));
                        row(ui, words.say(texts::CAMERA), |ui| camera(ui, options, shown.editor, words));
                        row(ui, words.say(texts::GHOSTS), |ui| {
                            let hint = words.say(texts::NEIGHBOURING_KEYFRAMES_ON_EACH_SIDE_TRANSLUCENT);
                            number(ui, &mut options.ghosts, 0..=MOST_GHOSTS, words.say(texts::GHOSTS))
                                .on_hover_text(hint);
                        });
                        row(ui, words.say(texts::BACKGROUND), |ui| background(ui, options, words));
                        row(ui, words.say(texts::LIGHTING), |ui| lighting(ui, options, words));
                        row(ui, words.say(texts::QUALITY), |ui| quality(ui, options, words));
                        // A sub-frame has one, and a page.
                        if !options.quality.is_refined() && !cfg!(target_arch = "wasm32") {
                            row(ui, words.say(texts::SAMPLES_A_PIXEL), |ui| samples(ui, options, words));
                        }
                    },
                );
            },
        );
        ui.add_space(2.0 * GRID);
        let problem = problem(options, shown.editor, is_busy, words);
        let said = problem.clone().unwrap_or_else(|| summary(options, shown.editor, words));
        let colour = if problem.is_some() { tokens.error } else { tokens.dim };
        // Reserve the space for the message, so that nothing moves when it appears.
        ui.allocate_ui_with_layout(vec2(width, 2.0 * ROW), Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_height(2.0 * ROW);
            ui.add(Label::new(RichText::new(said).small().color(colour)).wrap());
        });
        let (mut is_confirmed, mut is_cancelled) = (false, false);
        let can = problem.is_none() && !typed.trim().is_empty();
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            is_confirmed = default_button(ui, words.say(texts::EXPORT), can);
            is_cancelled = ui.button(words.say(texts::CANCEL)).clicked();
        });
        if is_confirmed {
            options.path = options.format.film_path(Path::new(typed.trim()));
            commands.push(Command::File(FileCommand::Export(Box::new(options.clone()))));
        }
        is_confirmed || is_cancelled
    }
}

/// What was chosen last, beside the current keyframe file.
fn proposed(last: Option<(PathBuf, ExportOptions)>, keyframe_file: &Path) -> ExportOptions {
    let beside = ExportOptions::beside(keyframe_file);
    match last {
        Some((of, options)) if of == keyframe_file => options,
        Some((_, options)) => ExportOptions { path: options.format.film_path(&beside.path), range: None, ..options },
        None => beside,
    }
}

/// A label and its fields.
fn row(ui: &mut Ui, label: &str, fields: impl FnOnce(&mut Ui)) {
    high_row(ui, ROW, label, fields);
}

/// A label and fields of this height, in points.
fn high_row(ui: &mut Ui, height: f32, label: &str, fields: impl FnOnce(&mut Ui)) {
    ui.label(RichText::new(label).color(Tokens::of(ui).dim));
    let size = vec2(dialog_width(ui, WIDTH) - LABELS - 2.0 * GRID, height);
    ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_size(size);
        fields(ui);
    });
    ui.end_row();
}

fn named(response: &Response, role: Role, name: &str) {
    response.widget_info(|| WidgetInfo::labeled(role, true, name));
}

fn number<N: egui::emath::Numeric>(
    ui: &mut Ui,
    value: &mut N,
    range: std::ops::RangeInclusive<N>,
    name: &str,
) -> Response {
    let response = ui.add_sized(vec2(72.0, ROW), DragValue::new(value).range(range).speed(0.25));
    named(&response, Role::SpinButton, name);
    response
}

fn choose<T: PartialEq + Copy>(ui: &mut Ui, name: &str, value: &mut T, all: &[(T, &str)]) -> bool {
    let shown = all.iter().find(|(one, _)| one == value).map_or("", |(_, label)| label);
    let before = *value;
    let response = ComboBox::from_id_salt(("export", name))
        .selected_text(shown)
        .width(200.0)
        .show_ui(ui, |ui| {
            for (one, label) in all {
                ui.selectable_value(value, *one, *label);
            }
        })
        .response;
    named(&response, Role::ComboBox, name);
    *value != before
}

fn format(ui: &mut Ui, options: &mut ExportOptions, typed: &mut String, words: Words) {
    let label = |format: &Format| match format.encoder {
        Encoder::Still(_) => words.message(texts::frames_in_a_folder(format.name)),
        Encoder::Film(_) => format.name.to_owned(),
        Encoder::Ffmpeg(_) => words.message(texts::through_ffmpeg(format.name)),
    };
    let before = options.format;
    let offered = FORMATS.into_iter().filter(|format| HAS_FOLDERS || !format.is_still());
    let labels: Vec<(&'static Format, String)> = offered.map(|format| (format, label(format))).collect();
    let all: Vec<(&'static Format, &str)> = labels.iter().map(|(format, label)| (*format, label.as_str())).collect();
    if choose(ui, words.say(texts::FORMAT), &mut options.format, &all) {
        *typed = options.format.film_path(Path::new(typed.trim())).to_string_lossy().into_owned();
        if options.fps == before.usual_frames_per_second {
            options.fps = options.format.usual_frames_per_second;
        }
    }
}

fn size(ui: &mut Ui, options: &mut ExportOptions, words: Words) {
    let [width, height] = &mut options.size;
    number(ui, width, 1..=ExportOptions::LONGEST_SIDE, words.say(texts::WIDTH));
    ui.label("×");
    number(ui, height, 1..=ExportOptions::LONGEST_SIDE, words.say(texts::HEIGHT));
    if dialog_width(ui, WIDTH) < WIDTH {
        // The list of sizes has no room.
        return;
    }
    let labels = SIZES.map(|[width, height]| format!("{width}×{height}"));
    let response =
        ComboBox::from_id_salt("sizes").selected_text(words.say(texts::SIZES)).width(96.0).show_ui(ui, |ui| {
            for (size, label) in SIZES.iter().zip(&labels) {
                ui.selectable_value(&mut options.size, *size, label);
            }
        });
    named(&response.response, Role::ComboBox, words.say(texts::SIZES));
}

fn range(ui: &mut Ui, options: &mut ExportOptions, editor: &Editor, words: Words) {
    let last = PlayRange::new(&editor.document().keyframes).ok().map(|range| range.last_key_time() as f64);
    let Some(last) = last else {
        options.range = None;
        ui.label("–");
        return;
    };
    let mut is_whole = options.range.is_none();
    if ui.checkbox(&mut is_whole, words.say(texts::ALL_THAT_PLAYS)).changed() {
        options.range = (!is_whole).then_some([0.0, last]);
    }
    if let Some([from, to]) = &mut options.range {
        *to = to.clamp(0.0, last);
        *from = from.clamp(0.0, *to);
        ui.label(words.say(texts::FROM));
        number(ui, from, 0.0..=*to, words.say(texts::FROM));
        ui.label(words.say(texts::TO));
        number(ui, to, *from..=last, words.say(texts::TO));
    }
}

fn camera(ui: &mut Ui, options: &mut ExportOptions, editor: &Editor, words: Words) {
    let scene = editor.scene();
    let eyes = scene.eyes().iter().map(|&eye| (Some(scene.rbt_path(eye)), scene.rbt_path(eye)));
    let all: Vec<(Option<&str>, &str)> = eyes.chain([(Some("turntable"), words.say(texts::TURNTABLE))]).collect();
    let known = all.iter().map(|(path, _)| *path).find(|path| *path == options.camera.as_deref());
    // At first as one looks now.
    let mut chosen = known.unwrap_or(all[editor.session().eye.recorded().unwrap_or_default()].0);
    if choose(ui, words.say(texts::CAMERA), &mut chosen, &all) || known.is_none() {
        options.camera = chosen.map(str::to_owned);
    }
}

fn background(ui: &mut Ui, options: &mut ExportOptions, words: Words) {
    let mut colour = match options.background {
        ExportBackground::Colour(colour) => colour,
        _ => COLOUR,
    };
    let all = [
        (ExportBackground::Sky, words.say(texts::SKY)),
        (ExportBackground::Colour(colour), words.say(texts::COLOUR)),
        (ExportBackground::Transparent, words.say(texts::TRANSPARENT)),
    ];
    choose(ui, words.say(texts::BACKGROUND), &mut options.background, &all);
    if matches!(options.background, ExportBackground::Colour(_)) && ui.color_edit_button_srgb(&mut colour).changed() {
        options.background = ExportBackground::Colour(colour);
    }
}

fn samples(ui: &mut Ui, options: &mut ExportOptions, words: Words) {
    let all = [(None, words.say(texts::AS_SUITS_THE_GRAPHICS_ADAPTER)), (Some(1), "1"), (Some(4), "4")];
    choose(ui, words.say(texts::SAMPLES_A_PIXEL), &mut options.samples, &all);
}

fn lighting(ui: &mut Ui, options: &mut ExportOptions, words: Words) {
    let of_scene = (None, words.say(texts::LIGHTING_OF_SCENE));
    let all: Vec<_> =
        std::iter::once(of_scene).chain(BuiltInLighting::ALL.map(|of| (Some(of), words.say(of.title())))).collect();
    choose(ui, words.say(texts::LIGHTING), &mut options.lighting, &all);
}

fn quality(ui: &mut Ui, options: &mut ExportOptions, words: Words) {
    let names = [texts::QUALITY_DRAFT, texts::QUALITY_GOOD, texts::QUALITY_FILM, texts::QUALITY_POSTER];
    let of = |(quality, name): (Quality, _)| (quality, format!("{} ({})", words.say(name), quality.sub_frames()));
    let labels = [Quality::DRAFT, Quality::GOOD, Quality::FILM, Quality::POSTER].into_iter().zip(names).map(of);
    let labels: Vec<(Quality, String)> = labels.collect();
    let all: Vec<(Quality, &str)> = labels.iter().map(|(quality, label)| (*quality, label.as_str())).collect();
    let hint = words.say(texts::QUALITY_HINT);
    ui.scope(|ui| choose(ui, words.say(texts::QUALITY), &mut options.quality, &all)).response.on_hover_text(hint);
}

/// Why these options cannot be exported.
fn problem(options: &ExportOptions, editor: &Editor, is_busy: bool, words: Words) -> Option<String> {
    if is_busy {
        return Some(words.say(texts::FILE_EXPORT_BEGUN_ALREADY).to_owned());
    }
    let keyframes = &editor.document().keyframes;
    if keyframes.is_empty() {
        let is_moving = editor.scene().last_second().is_some() || options.camera.as_deref() == Some("turntable");
        let sentence = words.say(texts::NOTHING_MOVES_MAKE_4_KEYFRAMES_OR_LET);
        return (!is_moving).then(|| sentence.to_owned());
    }
    if PlayRange::new(keyframes).is_err() {
        return Some(words.say(texts::FEWER_THAN_4_KEYFRAMES_THERE_IS_NOTHING).to_owned());
    }
    let is_seen_through = options.background == ExportBackground::Transparent;
    let problem = options.format.problem(options.size, Some(options.fps), is_seen_through)?;
    let said = words.message(problem.message());
    let mut letters = said.chars();
    letters.next().map(|first| format!("{}{}.", first.to_uppercase(), letters.as_str().trim_end_matches('.')))
}

/// The length and frame count of the film.
fn summary(options: &ExportOptions, editor: &Editor, words: Words) -> String {
    let document = editor.document();
    let Ok(played) = PlayRange::new(&document.keyframes) else { return String::new() };
    let whole = [0.0, played.last_key_time() as f64];
    let [from, to] = options.range.unwrap_or(whole).map(|key_time| to_f64(&played.timing().elapsed_at(key_time)));
    let seconds = (to - from).max(0.0) * f64::from(document.ms_between_keyframes) / 1000.0;
    let frames = (seconds * f64::from(options.fps) - 1e-6).ceil().max(0.0) + 1.0;
    words.message(texts::export_length(frames.to_string(), format!("{seconds:.2}")))
}

/// A notice at the top right of the 3D view, beside the axes' letters.
fn notice<R>(ui: &Ui, viewport: egui::Rect, contents: impl FnOnce(&mut Ui) -> R) -> R {
    let tokens = Tokens::of(ui);
    let area = Area::new(Id::unique("exporting"))
        .order(Order::Middle)
        .pivot(Align2::RIGHT_TOP)
        .fixed_pos(viewport.right_top() + vec2(-2.0 * GRID - axis_letters::width(viewport), 2.0 * GRID))
        .fade_in(false);
    let shown = area.show(ui.ctx(), |ui| {
        let frame = Frame::new()
            .fill(tokens.panel)
            .stroke(egui::Stroke::new(1.0, tokens.line))
            .corner_radius(CORNER)
            .inner_margin(Margin::symmetric(12, 8));
        let within = frame.show(ui, |ui| {
            ui.set_width(PROGRESS);
            contents(ui)
        });
        within.inner
    });
    shown.inner
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

/// Shows how far an export is, with a button that ends it.
pub fn show_progress(ui: &Ui, viewport: egui::Rect, exporting: &Exporting, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let tokens = Tokens::of(ui);
    notice(ui, viewport, |ui| {
        let text = RichText::new(words.message(texts::exporting(file_name(&exporting.path))));
        ui.add(Label::new(text).truncate()).on_hover_text(exporting.path.display().to_string());
        let share = exporting.done as f32 / exporting.count.max(1) as f32;
        ui.add(ProgressBar::new(share).desired_height(6.0).corner_radius(3).fill(tokens.accent));
        ui.horizontal(|ui| {
            let (done, count) = (exporting.done.to_string(), exporting.count.to_string());
            let text = match (exporting.is_ending, exporting.count) {
                (true, _) => words.say(texts::ENDING).to_owned(),
                (false, 0) => words.say(texts::BEGINNING).to_owned(),
                (false, _) => words.message(texts::export_frame(&done, &count)),
            };
            ui.label(RichText::new(text).small().color(tokens.dim));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let cancel = ui.add_enabled(!exporting.is_ending, Button::new(words.say(texts::CANCEL_EXPORT)));
                if was_pressed(&cancel) {
                    commands.push(Command::File(FileCommand::CancelExport));
                }
            });
        });
    });
}

/// Shows where an export is that is done. Says whether the notice is closed.
pub fn show_made(ui: &Ui, viewport: egui::Rect, path: &Path, commands: &mut Vec<Command>) -> bool {
    let words = Words::of(ui);
    notice(ui, viewport, |ui| {
        let whole = path.display().to_string();
        let text = RichText::new(words.message(texts::exported_here(file_name(path))));
        ui.add(Label::new(text).truncate()).on_hover_text(&whole);
        if HAS_FOLDERS {
            let folder = path.parent().unwrap_or(path).display().to_string();
            let folder = RichText::new(folder).small().color(Tokens::of(ui).dim);
            ui.add(Label::new(folder).truncate()).on_hover_text(&whole);
        }
        ui.horizontal(|ui| {
            if HAS_FOLDERS && was_pressed(&ui.button(words.say(texts::SHOW_FOLDER))) {
                commands.push(Command::Window(WindowCommand::ShowFolder(path.to_owned())));
            }
            if HAS_FOLDERS && was_pressed(&ui.button(words.say(texts::COPY_PATH))) {
                ui.copy_text(whole);
            }
            let close = |ui: &mut Ui| was_pressed(&ui.button(words.say(texts::CLOSE)));
            ui.with_layout(Layout::right_to_left(Align::Center), close).inner
        })
        .inner
    })
}
