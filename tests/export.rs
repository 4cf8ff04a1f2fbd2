//! Exports: what is asked for in the dialog is what is made, with the bytes that the command line writes; a cancelled one leaves nothing.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use egui::vec2;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use inbetween::editor::{Command, Edit, Editor, Effect, FileCommand, Severity, WindowCommand};
use inbetween::export::{Job, Step, Steps};
use inbetween::film::{APNG, ExportBackground, ExportEnd, ExportOptions, PNG, Y4M};
use inbetween::render::Gpu;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use inbetween::settings::Settings;
use inbetween::ui::{Exporting, Panels, theme};
use inbetween::words::{Language, texts};

/// Every third of a second a picture, so that it is quick.
const FPS: u32 = 3;

fn editor(path: PathBuf) -> Editor {
    let scene = built_in_scene(DEFAULT_SCENE).expect("the default scene is built in");
    let mut editor = Editor::new(Arc::new(scene), path.clone());
    editor.apply(Command::File(FileCommand::Import)).unwrap();
    let bytes = Ok(std::fs::read(&path).unwrap());
    editor.keyframes_read(&path, bytes).unwrap();
    editor
}

fn walk() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/animations/walk.json")
}

/// The bytes that the command line writes.
fn of_command_line(folder: &Path, name: &str, arguments: &[&str]) -> Vec<u8> {
    let output = folder.join(name);
    let outcome = assert_cmd::Command::cargo_bin("inbetween")
        .unwrap()
        .arg("render")
        .arg(walk())
        .arg("-o")
        .arg(&output)
        .args(["--size", "64x48", "--fps", "3"])
        .args(arguments)
        .output()
        .unwrap();
    assert!(outcome.status.success(), "{}", String::from_utf8_lossy(&outcome.stderr));
    std::fs::read(output).unwrap()
}

fn export(editor: &mut Editor, options: ExportOptions, watch: &mut dyn FnMut(usize, usize) -> bool) -> ExportEnd {
    job(editor, options).run(watch)
}

fn job(editor: &mut Editor, options: ExportOptions) -> Job {
    let effect = editor.apply(Command::File(FileCommand::Export(Box::new(options)))).unwrap();
    let Some(Effect::Export(options)) = &effect else { panic!("{effect:?}") };
    Job::new(
        Arc::clone(editor.scene()),
        editor.animation(),
        editor.keyframe_file().to_owned(),
        options.as_ref().clone(),
    )
}

/// An export a step at a time. Each frame is begun in a step, and taken in a later one.
fn in_steps(editor: &mut Editor, options: ExportOptions) -> ExportEnd {
    let mut steps = Steps::new(job(editor, options), Gpu::headless().unwrap()).unwrap_or_else(|end| panic!("{end:?}"));
    let mut last = 0;
    loop {
        match steps.step() {
            Step::Drawn(done, count) => {
                assert!(done <= count && (done == last || done == last + 1), "{last} {done}");
                last = done;
                std::thread::sleep(Duration::from_millis(1));
            }
            Step::Ended(end) => return end,
        }
    }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// A file of the command line's, its arguments, and the options that mean the same.
type Case<'a> = (&'a str, &'a [&'a str], ExportOptions);

#[test]
fn the_bytes_are_the_command_lines() {
    let folder = tempfile::tempdir().unwrap();
    let mut editor = editor(walk());
    let plain = ExportOptions {
        path: folder.path().join("own.gif"),
        size: [64, 48],
        fps: FPS,
        ..ExportOptions::beside(&walk())
    };
    let cases: [Case<'_>; 4] = [
        ("a.gif", &[], plain.clone()),
        (
            "b.gif",
            &["--ghosts", "2", "--camera", "turntable", "--background", "#10a0c0", "--samples", "4"],
            ExportOptions {
                ghosts: 2,
                camera: Some("turntable".to_owned()),
                background: ExportBackground::Colour([0x10, 0xa0, 0xc0]),
                samples: Some(4),
                ..plain.clone()
            },
        ),
        (
            "c.apng",
            &["--from", "1", "--to", "2.5", "--background", "transparent", "--camera", "robot2"],
            ExportOptions {
                format: &APNG,
                range: Some([1.0, 2.5]),
                background: ExportBackground::Transparent,
                camera: Some("robot2".to_owned()),
                ..plain.clone()
            },
        ),
        ("d.y4m", &[], ExportOptions { format: &Y4M, ..plain.clone() }),
    ];
    for (name, arguments, options) in cases {
        let expected = of_command_line(folder.path(), name, arguments);
        let own = options.path.clone();
        if options.samples.is_none() {
            // As a page makes it: a frame a step, nothing waited for.
            let end = in_steps(&mut editor, options.clone());
            assert!(
                matches!(end, ExportEnd::Written(_)) && std::fs::read(&own).unwrap() == expected,
                "{name}: {end:?}"
            );
            std::fs::remove_file(&own).unwrap();
        }
        let (mut seen, mut count) = (Vec::new(), 0);
        let end = export(&mut editor, options, &mut |done, of| {
            seen.push(done);
            count = of;
            true
        });
        assert_eq!(end, ExportEnd::Written(count), "{name}");
        // While the other thread is behind, the watcher is asked again.
        seen.dedup();
        assert_eq!(seen, (0..=count).collect::<Vec<_>>());
        assert!(std::fs::read(own).unwrap() == expected, "{name}");
    }
}

#[test]
fn frames_are_the_command_lines() {
    let folder = tempfile::tempdir().unwrap();
    let mut editor = editor(walk());
    std::fs::create_dir(folder.path().join("cli")).unwrap();
    let own = folder.path().join("own");
    let options = ExportOptions {
        path: own.clone(),
        format: &PNG,
        size: [64, 48],
        fps: FPS,
        range: Some([0.0, 3.0]),
        ..ExportOptions::beside(&walk())
    };
    assert!(matches!(export(&mut editor, options.clone(), &mut |_, _| true), ExportEnd::Written(4..)));
    let arguments = ["--from", "0", "--to", "3"];
    let output = assert_cmd::Command::cargo_bin("inbetween")
        .unwrap()
        .arg("render")
        .arg(walk())
        .arg("-o")
        .arg(folder.path().join("cli"))
        .args(["--size", "64x48", "--fps", "3"])
        .args(arguments)
        .output()
        .unwrap();
    assert!(output.status.success());
    assert_eq!(names(&own), names(&folder.path().join("cli")));
    for name in names(&own) {
        assert!(
            std::fs::read(own.join(&name)).unwrap() == std::fs::read(folder.path().join("cli").join(&name)).unwrap()
        );
    }
    // Ended early, it leaves whole frames.
    let part = folder.path().join("part");
    let end = export(&mut editor, ExportOptions { path: part.clone(), ..options }, &mut |done, _| done < 2);
    assert_eq!(end, ExportEnd::Cancelled(names(&part).len()));
    assert_eq!(names(&part).len(), 2);
    for name in names(&part) {
        assert!(image::open(part.join(name)).is_ok());
    }
}

#[test]
fn a_cancelled_or_failed_export_leaves_what_there_was() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("film.gif");
    std::fs::write(&path, "before").unwrap();
    let mut editor = editor(walk());
    let options = ExportOptions { path: path.clone(), size: [64, 48], fps: FPS, ..ExportOptions::beside(&walk()) };
    for stop in [0, 3] {
        let end = export(&mut editor, options.clone(), &mut |done, _| done < stop);
        assert_eq!(end, ExportEnd::Cancelled(0));
    }
    // All is drawn, and the end is not wanted.
    assert_eq!(export(&mut editor, options.clone(), &mut |done, of| done < of), ExportEnd::Cancelled(0));
    let failing = |change: &dyn Fn(&mut ExportOptions)| {
        let mut options = options.clone();
        change(&mut options);
        options
    };
    let cases = [
        (failing(&|options| options.range = Some([0.0, 99.0])), "key time 99 is outside 0 to"),
        (failing(&|options| options.camera = Some("ground".to_owned())), "the scene's eyes are sky, robot1, robot2"),
        (failing(&|options| options.size = [1_000_000, 48]), "cannot be drawn"),
        (failing(&|options| options.fps = 60), "a GIF shows at most 50 frames a second"),
        (failing(&|options| options.path = folder.path().join("none/film.gif")), "film.gif"),
    ];
    for (options, expected) in cases {
        let ExportEnd::Failed(reason) = export(&mut editor, options, &mut |_, _| true) else { panic!("{expected}") };
        assert!(reason.to_string().contains(expected), "{reason}");
    }
    assert_eq!(std::fs::read(&path).unwrap(), b"before");
    assert_eq!(names(folder.path()), ["film.gif"]);
}

#[test]
fn how_an_export_ended_is_said() {
    let mut editor = editor(walk());
    let path = Path::new("a/film.gif");
    for (end, text, severity) in [
        (ExportEnd::Written(30), "Exported 30 frames to a/film.gif.", Severity::Outcome),
        (ExportEnd::Written(1), "Exported 1 frame to a/film.gif.", Severity::Outcome),
        (ExportEnd::Cancelled(0), "The export was cancelled: nothing of it is kept.", Severity::Outcome),
        (ExportEnd::Cancelled(7), "The export was cancelled: its first 7 frames are in a/film.gif.", Severity::Outcome),
        (ExportEnd::Failed(texts::foreign("no room")), "Nothing was exported: no room.", Severity::Error),
    ] {
        editor.exported(path, end);
        assert_eq!((editor.message_text().as_str(), editor.message().unwrap().severity()), (text, severity));
    }
}

struct App {
    editor: Editor,
    ui: Panels,
    settings: Settings,
    commands: Vec<Command>,
    is_dressed: bool,
}

fn harness(editor: Editor, settings: Settings) -> Harness<'static, App> {
    let mut ui = Panels::new();
    assert_eq!(ui.adopt(&settings), []);
    let app = App { editor, ui, settings, commands: Vec::new(), is_dressed: false };
    let mut harness = Harness::builder().with_size(vec2(1280.0, 800.0)).build_ui_state(
        |ui, app: &mut App| {
            if !std::mem::replace(&mut app.is_dressed, true) {
                theme::install(ui.ctx());
            }
            app.commands.extend(app.ui.show(ui, &app.editor).commands);
        },
        app,
    );
    harness.run();
    harness
}

fn ask(harness: &mut Harness<'_, App>) {
    let app = harness.state_mut();
    app.ui.perform(&WindowCommand::ShowExport, &mut app.settings).unwrap();
    harness.run();
}

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by(|node| node.label().as_deref() == Some(label) && node.role() != egui::Role::Label).click();
    harness.run();
}

fn exported(harness: &mut Harness<'_, App>) -> ExportOptions {
    match std::mem::take(&mut harness.state_mut().commands).pop() {
        Some(Command::File(FileCommand::Export(options))) => *options,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_dialog_makes_the_command() {
    let mut harness = harness(editor(walk()), Settings::default());
    ask(&mut harness);
    assert!(harness.state().ui.has_dialog());
    click(&mut harness, "Export");
    assert!(!harness.state().ui.has_dialog());
    let seen_now = ExportOptions { camera: Some("sky".to_owned()), ..ExportOptions::beside(&walk()) };
    assert_eq!(exported(&mut harness), seen_now);

    ask(&mut harness);
    click(&mut harness, "Format");
    click(&mut harness, "Y4M");
    click(&mut harness, "Sizes");
    click(&mut harness, "320×240");
    click(&mut harness, "Camera");
    click(&mut harness, "Turntable");
    click(&mut harness, "All that plays");
    click(&mut harness, "Samples a pixel");
    click(&mut harness, "4");
    click(&mut harness, "Export");
    let last = harness.state().editor.document().keyframes.len() as f64 - 3.0;
    let expected = ExportOptions {
        path: walk().with_extension("y4m"),
        format: &Y4M,
        size: [320, 240],
        fps: 30,
        camera: Some("turntable".to_owned()),
        range: Some([0.0, last]),
        samples: Some(4),
        ..ExportOptions::beside(&walk())
    };
    assert_eq!(exported(&mut harness), expected);

    // What was chosen last is proposed again; what cannot be is said, and refused.
    ask(&mut harness);
    click(&mut harness, "Background");
    click(&mut harness, "Transparent");
    let text = "MP4 and Y4M have no opacity: a transparent background is for PNG, WebP, GIF and APNG.";
    assert!(harness.query_by_label(text).is_some());
    assert!(harness.get_by_label("Export").accesskit_node().is_disabled());
    click(&mut harness, "Format");
    click(&mut harness, "APNG");
    click(&mut harness, "Export");
    let expected = ExportOptions {
        path: walk().with_extension("apng"),
        format: &APNG,
        background: ExportBackground::Transparent,
        ..expected
    };
    assert_eq!(exported(&mut harness), expected);
}

#[test]
fn what_does_not_play_is_not_exported() {
    let mut editor = editor(walk());
    for _ in 0..editor.document().keyframes.len() - 3 {
        editor.apply(Command::Edit(Edit::DeleteCurrent)).unwrap();
    }
    let mut harness = harness(editor, Settings::default());
    ask(&mut harness);
    assert!(harness.query_by_label("Fewer than 4 keyframes: there is nothing to make a film of yet.").is_some());
    assert!(harness.get_by_label("Export").accesskit_node().is_disabled());
    click(&mut harness, "Cancel");
    assert!(!harness.state().ui.has_dialog() && harness.state().commands.is_empty());
}

#[test]
fn progress_shows_and_can_be_cancelled() {
    let settings = Settings { language: Language::of_code("ko").unwrap(), ..Settings::default() };
    let mut harness = harness(editor(walk()), settings);
    let exporting = Exporting { path: PathBuf::from("a/film.gif"), done: 30, count: 120, is_ending: false };
    harness.state_mut().ui.exporting = Some(exporting.clone());
    harness.run();
    assert!(harness.query_by_label("film.gif 내보내는 중").is_some());
    assert!(harness.query_by_label("120프레임 중 30번째").is_some());
    click(&mut harness, "내보내기 취소");
    assert_eq!(harness.state().commands, [Command::File(FileCommand::CancelExport)]);
    // Another waits for it, and whoever quits is asked.
    ask(&mut harness);
    assert!(harness.query_by_label("내보내기가 진행 중입니다. 끝난 뒤에 시작할 수 있습니다.").is_some());
    click(&mut harness, "취소");
    harness.state_mut().ui.ask_before_quitting();
    harness.run();
    assert!(harness.query_by_label("내보내기가 끝나기 전에 종료할까요?").is_some());
}
