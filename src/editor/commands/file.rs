//! Commands of files, pictures and films, and undo.

use std::path::PathBuf;

use super::line::{Ending, Line};
use super::row::{Binding, Changes, Group, Menu, Row};
use super::values::{file, file_text, quoted, split_option};
use crate::editor::{Command, Edit, FileCommand, WindowCommand};
use crate::words::texts;

fn binding(id: &'static str, command: Command) -> Binding {
    Binding::new(Group::File, id, command)
}

pub(super) fn rows() -> Vec<Row> {
    [keyframes(), scene(), pictures(), exports(), program()].concat()
}

fn keyframes() -> Vec<Row> {
    let new = binding("new", Command::Edit(Edit::BeginAnew));
    let import = binding("import", Command::File(FileCommand::Import));
    let save = binding("save", Command::File(FileCommand::Write));
    let open = binding("open", Command::File(FileCommand::ChooseOpen));
    let save_as = binding("save-as", Command::File(FileCommand::ChooseSaveAs));
    vec![
        Row::listed(Changes::Document, new.hotkeys(&["Ctrl+N"]).section(0)).refused(texts::ACT_NEW_ANIMATION).word(
            "new",
            "begins a new animation of the scene: no keyframes, the scene at rest, `animation.json` as its file",
        ),
        Row::listed(Changes::Document, import.hotkeys(&["i"])).refused(texts::ACT_IMPORT),
        Row::listed(Changes::Files, save.hotkeys(&["w"])),
        Row::listed(Changes::Files, open.hotkeys(&["Ctrl+O"]).section(0)).refused(texts::ACT_OPEN_A_FILE),
        Row::of(Changes::Document, "open-file", |command| matches!(command, Command::File(FileCommand::Open(_))))
            .refused(texts::ACT_OPEN_A_FILE)
            .line(
                Line::new(
                    "open FILE",
                    "imports another keyframe file, which is the one that is written from now on",
                    |arguments| Ok(file(arguments.text).map(|path| Command::File(FileCommand::Open(path)))),
                    |command, _| {
                        let Command::File(FileCommand::Open(path)) = command else { return None };
                        file_text(path)
                    },
                )
                .ending(Ending::FilePath(None)),
            ),
        Row::listed(Changes::Files, save_as.hotkeys(&["Ctrl+Shift+S"])),
        Row::of(Changes::Files, "save-as-file", |command| matches!(command, Command::File(FileCommand::SaveAs(_))))
            .line(
                Line::new(
                    "save-as FILE",
                    "writes the keyframes to another file, which is the one that is written from now on",
                    |arguments| Ok(file(arguments.text).map(|path| Command::File(FileCommand::SaveAs(path)))),
                    |command, _| {
                        let Command::File(FileCommand::SaveAs(path)) = command else { return None };
                        file_text(path)
                    },
                )
                .ending(Ending::FilePath(None)),
            ),
    ]
}

fn scene() -> Vec<Row> {
    let save = binding("scene-save", Command::File(FileCommand::WriteScene));
    let save_as = binding("scene-save-as", Command::File(FileCommand::ChooseSaveSceneAs));
    let open = binding("scene-open", Command::Window(WindowCommand::ChooseOpenScene));
    let reload = binding("scene-reload", Command::File(FileCommand::ReloadScene));
    vec![
        Row::listed(Changes::Window, open.section(0)),
        Row::listed(Changes::Document, reload)
            .refused(texts::ACT_RELOAD_THE_SCENE)
            .can(|editor, _| editor.scene_path.is_some()),
        Row::listed(Changes::Files, save),
        Row::listed(Changes::Files, save_as),
        Row::of(Changes::Files, "save-scene", |command| matches!(command, Command::File(FileCommand::SaveSceneAs(_))))
            .line(
                Line::new(
                    "save-scene FILE",
                    "writes the scene with its control nodes and keys",
                    |arguments| Ok(file(arguments.text).map(|path| Command::File(FileCommand::SaveSceneAs(path)))),
                    |command, _| {
                        let Command::File(FileCommand::SaveSceneAs(path)) = command else { return None };
                        file_text(path)
                    },
                )
                .ending(Ending::FilePath(None)),
            ),
    ]
}

/// The option of `screenshot` for all that the window shows.
const OVERLAYS: &str = "--overlays";

fn screenshot(path: Option<PathBuf>, has_overlays: bool) -> Command {
    Command::File(FileCommand::Screenshot { path, has_overlays })
}

fn pictures() -> Vec<Row> {
    let beside = binding("screenshot", screenshot(None, true));
    vec![
        Row::of(Changes::Files, "screenshot", |command| matches!(command, Command::File(FileCommand::Screenshot { .. })))
            .binding(beside.hotkeys(&["s"]).section(7))
            .line(
                Line::new(
                    "screenshot [--overlays] PATH",
                    "writes a picture of the scene alone; with `--overlays` as the window shows it, with arcball, outline, ghosts and paths",
                    |arguments| {
                        let (has_overlays, path) = split_option(arguments.text, Some(OVERLAYS));
                        Ok(file(path).map(|path| screenshot(Some(path), has_overlays)))
                    },
                    |command, _| {
                        let Command::File(FileCommand::Screenshot { path: Some(path), has_overlays }) = command else {
                            return None;
                        };
                        let path = file_text(path)?;
                        if *has_overlays {
                            return Some(format!("{OVERLAYS} {path}"));
                        }
                        let is_option = split_option(&path, Some(OVERLAYS)).0;
                        Some(if is_option { quoted(&path) } else { path })
                    },
                )
                .ending(Ending::FilePath(Some(OVERLAYS))),
            ),
    ]
}

/// Films. What they are to be has no line of its own: scripts make none, and `inbetween render` says it all.
fn exports() -> Vec<Row> {
    let show = binding("export", Command::Window(WindowCommand::ShowExport));
    let model = binding("export-model", Command::File(FileCommand::ChooseExportModel));
    vec![
        Row::listed(Changes::Window, show.hotkeys(&["Ctrl+E"]).section(7)),
        Row::listed(Changes::Files, model.section(7)),
        Row::of(Changes::Files, "export-model-file", |command| {
            matches!(command, Command::File(FileCommand::ExportModel(_)))
        })
        .line(
            Line::new(
                "export-model FILE",
                "writes the scene and what the keyframes play for other programs: glTF (`.glb`, `.gltf`) or BVH (`.bvh`)",
                |arguments| Ok(file(arguments.text).map(|path| Command::File(FileCommand::ExportModel(path)))),
                |command, _| {
                    let Command::File(FileCommand::ExportModel(path)) = command else { return None };
                    file_text(path)
                },
            )
            .ending(Ending::FilePath(None)),
        ),
        Row::of(Changes::Files, "export-film", |command| matches!(command, Command::File(FileCommand::Export(_)))),
        Row::of(Changes::Files, "export-cancel", |command| matches!(command, Command::File(FileCommand::CancelExport))),
        Row::of(Changes::Files, "export-choose", |command| {
            matches!(command, Command::File(FileCommand::ChooseExport { .. }))
        }),
    ]
}

fn program() -> Vec<Row> {
    let edit = |id, command, keys: &[&str]| binding(id, command).repeating_hotkeys(keys).menu(Menu::Edit).section(0);
    let undo = edit("undo", Command::Undo, &["Ctrl+Z"]);
    let redo = edit("redo", Command::Redo, &["Ctrl+Shift+Z", "Ctrl+Y"]);
    let quit = binding("quit", Command::File(FileCommand::Quit));
    vec![
        Row::listed(Changes::Document, undo)
            .refused(texts::ACT_UNDO)
            .can(|editor, _| editor.gesture.is_none() && editor.undo_label().is_some())
            .word("undo", "takes back the last edit"),
        Row::listed(Changes::Document, redo)
            .refused(texts::ACT_REDO)
            .can(|editor, _| editor.gesture.is_none() && editor.redo_label().is_some())
            .word("redo", "brings it again"),
        Row::listed(Changes::Files, quit.hotkeys(&["Ctrl+Q"]).section(9)),
    ]
}
