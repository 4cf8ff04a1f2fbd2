//! The timeline, driven by pointer and keyboard with no window: each operation leaves the editor as its command would, and undo
//! returns the document to the same bytes.

mod common;

use egui::{Event, Key, Modifiers, PointerButton, Pos2, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use inbetween::editor::{Command, Edit, Editor, PlayMode, PlaybackCommand, TimelineEdit, ViewCommand};
use inbetween::keyframe::{Easing, KeyframeFile, KeyframeIndex, keyframes_to_json};
use inbetween::ui::{Ui, theme};

struct App {
    editor: Editor,
    ui: Ui,
    commands: Vec<Command>,
    is_dressed: bool,
    cursor: egui::CursorIcon,
}

type Timeline = Harness<'static, App>;

fn timeline(editor: Editor) -> Timeline {
    let app =
        App { editor, ui: Ui::new(), commands: Vec::new(), is_dressed: false, cursor: egui::CursorIcon::Default };
    let mut harness = Harness::builder().with_size(vec2(1280.0, 800.0)).build_ui_state(
        |ui, app: &mut App| {
            if !std::mem::replace(&mut app.is_dressed, true) {
                theme::install(ui.ctx());
            }
            for command in app.ui.show(ui, &app.editor).commands {
                common::apply(&mut app.editor, command.clone());
                app.commands.push(command);
            }
            app.cursor = ui.output(|output| output.cursor_icon);
        },
        app,
    );
    harness.run();
    harness
}

fn bytes(editor: &Editor) -> String {
    let document = editor.document();
    let paths: Vec<String> = editor.scene().rbt_paths().map(str::to_owned).collect();
    keyframes_to_json(&KeyframeFile {
        keyframes: document.keyframes.as_slice().to_vec(),
        interpolation: document.interpolation,
        ms_between_keyframes: document.ms_between_keyframes,
        ..file_of(editor, paths)
    })
}

fn index(place: usize) -> KeyframeIndex {
    KeyframeIndex::new(place)
}

fn indices(places: &[usize]) -> Vec<KeyframeIndex> {
    places.iter().copied().map(index).collect()
}

fn at(harness: &Timeline, place: usize) -> Pos2 {
    harness.get_by_label(&format!("Keyframe {place}")).rect().center()
}
