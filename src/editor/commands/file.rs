//! Commands of files, pictures and films, and undo.

use super::line::{Ending, Line};
use super::row::{Binding, Changes, Group, Menu, Row};
use super::values::{file, file_text};
use crate::editor::{Command, FileCommand, WindowCommand};

fn binding(id: &'static str, command: Command, name: &'static str, help: &'static str) -> Binding {
    Binding::new(Group::File, id, command, name, help)
}

pub(super) fn rows() -> Vec<Row> {
    [keyframes(), scene(), pictures(), exports(), program()].concat()
}

fn keyframes() -> Vec<Row> {
    let import = binding(
        "import",
        Command::File(FileCommand::Import),
        "Import",
        "Import the keyframe file; its first keyframe is shown",
    );
    let save = binding("save", Command::File(FileCommand::Write), "Save", "Write the keyframe file");
    let open = binding("open", Command::File(FileCommand::ChooseOpen), "Open…", "Open another keyframe file");
    let save_as =
        binding("save-as", Command::File(FileCommand::ChooseSaveAs), "Save As…", "Write to another keyframe file");
    vec![
        Row::listed(Changes::Document, import.hotkeys(&["i"])).refused("import"),
        Row::listed(Changes::Files, save.hotkeys(&["w"])),
        Row::listed(Changes::Files, open.hotkeys(&["Ctrl+O"]).section(0)).refused("open a file"),
        Row::of(Changes::Document, "open-file", |command| matches!(command, Command::File(FileCommand::Open(_))))
            .refused("open a file")
            .line(
                Line::new(
                    "open FILE",
                    "imports another keyframe file, which is the one that is written from now on",
                    |arguments| Ok(file(arguments).map(|path| Command::File(FileCommand::Open(path)))),
                    |command, _| {
                        let Command::File(FileCommand::Open(path)) = command else { return None };
                        file_text(path)
                    },
                )
                .ending(Ending::FilePath),
            ),
        Row::listed(Changes::Files, save_as.hotkeys(&["Ctrl+Shift+S"])),
        Row::of(Changes::Files, "save-as-file", |command| matches!(command, Command::File(FileCommand::SaveAs(_))))
            .line(
                Line::new(
                    "save-as FILE",
                    "writes the keyframes to another file, which is the one that is written from now on",
                    |arguments| Ok(file(arguments).map(|path| Command::File(FileCommand::SaveAs(path)))),
                    |command, _| {
                        let Command::File(FileCommand::SaveAs(path)) = command else { return None };
                        file_text(path)
                    },
                )
                .ending(Ending::FilePath),
            ),
    ]
}

fn scene() -> Vec<Row> {
    let save = binding(
        "scene-save",
        Command::File(FileCommand::WriteScene),
        "Save scene",
        "Write the scene, with its control nodes and keys, to its file",
    );
    let save_as = binding(
        "scene-save-as",
        Command::File(FileCommand::ChooseSaveSceneAs),
        "Save scene as…",
        "Write the scene to another file",
    );
    vec![
        Row::listed(Changes::Files, save),
        Row::listed(Changes::Files, save_as),
        Row::of(Changes::Files, "save-scene", |command| matches!(command, Command::File(FileCommand::SaveSceneAs(_))))
            .line(
                Line::new(
                    "save-scene FILE",
                    "writes the scene with its control nodes and keys",
                    |arguments| Ok(file(arguments).map(|path| Command::File(FileCommand::SaveSceneAs(path)))),
                    |command, _| {
                        let Command::File(FileCommand::SaveSceneAs(path)) = command else { return None };
                        file_text(path)
                    },
                )
                .ending(Ending::FilePath),
            ),
    ]
}

fn pictures() -> Vec<Row> {
    let beside = binding(
        "screenshot",
        Command::File(FileCommand::Screenshot(None)),
        "Screenshot",
        "Write a screenshot beside the keyframe file",
    );
    vec![
        Row::of(Changes::Files, "screenshot", |command| matches!(command, Command::File(FileCommand::Screenshot(_))))
            .binding(beside.hotkeys(&["s"]).section(7))
            .line(
                Line::new(
                    "screenshot PATH",
                    "writes a picture of the scene",
                    |arguments| Ok(file(arguments).map(|path| Command::File(FileCommand::Screenshot(Some(path))))),
                    |command, _| {
                        let Command::File(FileCommand::Screenshot(Some(path))) = command else { return None };
                        file_text(path)
                    },
                )
                .ending(Ending::FilePath),
            ),
    ]
}

/// Films. What they are to be has no line of its own: scripts make none, and `inbetween render` says it all.
fn exports() -> Vec<Row> {
    let show = binding(
        "export",
        Command::Window(WindowCommand::ShowExport),
        "Export…",
        "Make a film of what plays: GIF, APNG, MP4, Y4M or numbered frames",
    );
    vec![
        Row::listed(Changes::Window, show.hotkeys(&["Ctrl+E"]).section(7)),
        Row::of(Changes::Files, "export-film", |command| matches!(command, Command::File(FileCommand::Export(_)))),
        Row::of(Changes::Files, "export-cancel", |command| matches!(command, Command::File(FileCommand::CancelExport))),
        Row::of(Changes::Files, "export-choose", |command| {
            matches!(command, Command::File(FileCommand::ChooseExport { .. }))
        }),
    ]
}

fn program() -> Vec<Row> {
    let edit = |id, command, name, help, keys: &[&str]| {
        binding(id, command, name, help).repeating_hotkeys(keys).menu(Menu::Edit).section(0)
    };
    let undo = edit("undo", Command::Undo, "Undo", "Undo", &["Ctrl+Z"]);
    let redo = edit("redo", Command::Redo, "Redo", "Redo", &["Ctrl+Shift+Z", "Ctrl+Y"]);
    let quit = binding("quit", Command::File(FileCommand::Quit), "Quit", "Quit; asks where something is unsaved");
    vec![
        Row::listed(Changes::Document, undo)
            .refused("undo")
            .can(|editor, _| editor.gesture.is_none() && editor.undo_label().is_some())
            .word("undo", "takes back the last edit"),
        Row::listed(Changes::Document, redo)
            .refused("redo")
            .can(|editor, _| editor.gesture.is_none() && editor.redo_label().is_some())
            .word("redo", "brings it again"),
        Row::listed(Changes::Files, quit.hotkeys(&["Ctrl+Q"]).section(9)),
    ]
}
