//! Looking around: by pointer and keys in the real window, by the corner with the recorded camera, and what is drawn of the eye itself.
//!
//! It needs `Xvfb`, `xdotool` and a GPU adapter; without them it fails and says so.

mod display;

use std::path::PathBuf;
use std::process::Stdio;
use std::sync::Arc;
use std::thread::sleep;
use std::time::Duration;

use display::{Running, display, focused_window, inbetween, start, wait_for, xdotool};
use egui::{PointerButton, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use glam::{Vec2, Vec3};
use inbetween::editor::{Command, Editor, Eye, PlaybackCommand, ViewCommand, WorkEye};
use inbetween::render::{Gpu, Offscreen, Renderer};
use inbetween::scene::{DEFAULT_SCENE, built_in_scene, scene_from_json};
use inbetween::script::script_commands;
use inbetween::settings::Settings;
use inbetween::ui::{Panels, theme};
use inbetween::view::{frame_of_editor, picture_of_editor};

fn editor() -> Editor {
    let scene = built_in_scene(DEFAULT_SCENE).expect("it is built in");
    Editor::new(Arc::new(scene), PathBuf::from("walk.json"))
}

fn run(editor: &mut Editor, lines: &str) {
    let commands = script_commands(lines.as_bytes(), editor.scene()).expect("the lines can be read");
    for command in commands {
        editor.apply(command).expect("the command is done");
    }
}

/// The real window, whose journal says what its commands were.
struct Window {
    _process: Running,
    _server: Running,
    display: String,
    folder: tempfile::TempDir,
    seen: usize,
}

impl Window {
    fn open() -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("inbetween")).unwrap();
        let settings = r#"{"format": "inbetween.settings", "version": 1, "tour": false}"#;
        std::fs::write(folder.path().join("inbetween/settings.json"), settings).unwrap();
        let (server, display) = display(&[]);
        let mut command = inbetween(&display, folder.path());
        let mut process = start("inbetween", command.arg(folder.path().join("a.json")).stderr(Stdio::null()));
        focused_window(&display, &mut process);
        let mut window = Self { _process: process, _server: server, display, folder, seen: 0 };
        assert!(wait_for(|| window.journal().lines().any(|line| line == "eye work")), "{}", window.journal());
        // Four keyframes to play.
        for _ in 0..4 {
            window.expect(&["key", "n"], "do keyframe-new");
        }
        window
    }

    fn journal(&self) -> String {
        let logs = inbetween::storage::logs(&self.folder.path().join("state/inbetween"), ".journal");
        logs.first().and_then(|path| std::fs::read_to_string(path).ok()).unwrap_or_default()
    }

    fn act(&self, arguments: &[&str]) {
        xdotool(&self.display, arguments).unwrap_or_else(|| panic!("{arguments:?} is not done"));
    }

    /// The next line that the journal gets, but for the time that passes while it plays.
    fn next_line(&mut self, what: &[&str]) -> String {
        let mut line = None;
        let has_come = wait_for(|| {
            let journal = self.journal();
            let mut lines = journal.lines().enumerate().skip(self.seen);
            line = lines.find(|(_, line)| !line.starts_with("wait ")).map(|(at, line)| (at, line.to_owned()));
            line.is_some()
        });
        assert!(has_come, "nothing comes of {what:?}:\n{}", self.journal());
        let (at, line) = line.unwrap();
        self.seen = at + 1;
        line
    }

    /// Does something, of which a line comes.
    #[track_caller]
    fn expect(&mut self, arguments: &[&str], expected: &str) {
        self.seen = self.journal().lines().count();
        self.act(arguments);
        assert_eq!(self.next_line(arguments), expected, "{arguments:?}");
    }

    /// Where the work eye is after something with the pointer. The journal has that once something else is done.
    fn eye_after(&mut self, arguments: &[&str]) -> WorkEye {
        self.seen = self.journal().lines().count();
        self.act(arguments);
        self.act(&["sleep", "0.3", "key", "a"]);
        let line = self.next_line(arguments);
        let numbers: Vec<f32> = line
            .strip_prefix("work-eye ")
            .unwrap_or_else(|| panic!("{arguments:?} leads to {line}"))
            .split(' ')
            .map(|number| number.parse().unwrap())
            .collect();
        let [yaw_degrees, pitch_degrees, distance, x, y, z] = numbers[..] else { panic!("{line}") };
        self.next_line(&["the key"]);
        WorkEye { yaw_degrees, pitch_degrees, distance, target_in_world: Vec3::new(x, y, z) }
    }
}

/// A drag with a button from one place to another, while keys are held.
fn drag<'a>(button: &'a str, from: [&'a str; 2], to: [&'a str; 2], held: Option<&'a str>) -> Vec<&'a str> {
    let [x, y] = from;
    let mut all = vec!["mousemove", x, y, "sleep", "0.2"];
    all.extend(held.iter().flat_map(|key| ["keydown", key]));
    all.extend(["mousedown", button, "sleep", "0.1", "mousemove", to[0], to[1], "sleep", "0.2", "mouseup", button]);
    all.extend(held.iter().flat_map(|key| ["keyup", key]));
    all
}

/// Above the robots, where nothing is.
const SKY: [&str; 2] = ["300", "60"];
const BESIDE: [&str; 2] = ["340", "80"];

#[test]
fn the_pointer_and_keys_lead_the_work_eye_around() {
    let mut window = Window::open();
    for is_playing in [false, true] {
        if is_playing {
            window.expect(&["key", "shift+l"], "do play-mode-next");
            window.expect(&["key", "y"], "do play-or-stop");
        }
        window.expect(&["key", "1"], "look front");
        let mut eye = window.eye_after(&drag("2", SKY, BESIDE, None));
        assert_ne!(eye.yaw_degrees, 0.0, "middle");
        for (what, button, held, is_pan) in [
            ("middle", "2", None, false),
            ("left on nothing", "1", None, false),
            ("Alt+left", "1", Some("alt"), false),
            ("Shift+middle", "2", Some("shift"), true),
            ("Shift+left on nothing", "1", Some("shift"), true),
            ("right on nothing", "3", None, true),
        ] {
            let last = std::mem::replace(&mut eye, window.eye_after(&drag(button, SKY, BESIDE, held)));
            let has_turned = eye.yaw_degrees != last.yaw_degrees && eye.pitch_degrees != last.pitch_degrees;
            assert_eq!((has_turned, eye.target_in_world != last.target_in_world), (!is_pan, is_pan), "{what}");
            assert_eq!(eye.distance, last.distance, "{what}");
        }
        for (what, keys) in [("wheel", None), ("Ctrl+wheel", Some("ctrl"))] {
            let mut all = vec!["mousemove", "300", "60", "sleep", "0.2"];
            all.extend(keys.iter().flat_map(|key| ["keydown", key]));
            all.extend(["click", "4"]);
            all.extend(keys.iter().flat_map(|key| ["keyup", key]));
            let nearer = window.eye_after(&all);
            assert!(nearer.distance < eye.distance, "{what}: {nearer:?} after {eye:?}");
            assert_ne!(nearer.target_in_world, eye.target_in_world, "{what} zooms to the pointer");
            eye = nearer;
        }
        for (key, line) in [
            ("1", "look front"),
            ("ctrl+1", "look back"),
            ("3", "look right"),
            ("ctrl+3", "look left"),
            ("7", "look top"),
            ("ctrl+7", "look bottom"),
            ("KP_1", "look front"),
            ("KP_3", "look right"),
            ("KP_7", "look top"),
            ("shift+z", "show-all"),
            ("0", "eye sky"),
            ("v", "eye robot1"),
            ("1", "look front"),
        ] {
            window.expect(&["key", key], line);
        }
    }
    window.expect(&["key", "y"], "do play-or-stop");
    // The place of the part changes with the window's size: it is looked for.
    let is_chosen = wait_for(|| {
        let before = window.journal().lines().count();
        window.act(&["key", "shift+z", "sleep", "0.4", "mousemove", "370", "300", "sleep", "0.3", "click", "1"]);
        sleep(Duration::from_millis(300));
        window.journal().lines().skip(before).any(|line| line.starts_with("select "))
    });
    assert!(is_chosen, "no part is chosen:\n{}", window.journal());
    window.expect(&["key", "z"], "show-chosen");
}

struct App {
    editor: Editor,
    ui: Panels,
    settings: Settings,
    viewport: egui::Rect,
    commands: Vec<Command>,
}

fn harness(editor: Editor, size: egui::Vec2) -> Harness<'static, App> {
    let mut app = App {
        editor,
        ui: Panels::new(),
        settings: Settings { tour: false, ..Settings::default() },
        viewport: egui::Rect::NOTHING,
        commands: Vec::new(),
    };
    app.ui.adopt(&app.settings);
    let mut harness = Harness::builder().with_size(size).with_step_dt(0.02).with_max_steps(20).build_ui_state(
        |ui, app: &mut App| {
            theme::install(ui.ctx());
            let output = app.ui.show(ui, &app.editor);
            app.viewport = output.viewport;
            for command in output.commands {
                app.commands.push(command.clone());
                let _ = app.editor.apply(command);
            }
        },
        app,
    );
    harness.run();
    harness
}

const WINDOW: egui::Vec2 = vec2(1366.0, 768.0);

/// Whether the corner shows, and how many pixels its picture is to have.
fn corner(harness: &mut Harness<'_, App>) -> Option<[u32; 2]> {
    harness.step();
    harness.step();
    let wanted = harness.state().ui.wanted_inset();
    let is_corner = |label: &str| label.starts_with("What ") && label.ends_with(" sees");
    let shows = harness.query_by(|node| node.label().is_some_and(|label| is_corner(&label))).is_some();
    assert_eq!(shows, wanted.is_some());
    wanted
}

#[test]
fn the_corner_shows_the_recorded_camera_while_the_work_eye_is_in_force() {
    let mut harness = harness(editor(), WINDOW);
    assert_eq!(corner(&mut harness), None, "the sky is looked from");
    run(&mut harness.state_mut().editor, "eye robot2\neye work");
    let [width, height] = corner(&mut harness).expect("it shows");
    let view = harness.state().viewport;
    assert!((width as f32 / height as f32 - view.aspect_ratio()).abs() < 0.02 * view.aspect_ratio());
    assert!(harness.query_by_label("What robot2 sees").is_some(), "the eye that was in force last");
    let place = harness.get_by_label("What robot2 sees").rect();
    for other in ["Look from +X", "Look from below"] {
        assert!(!harness.get_by_label(other).rect().intersects(place), "{other} is covered");
    }
    run(&mut harness.state_mut().editor, "inset off");
    assert_eq!(corner(&mut harness), None);
    run(&mut harness.state_mut().editor, "do inset");
    assert!(corner(&mut harness).is_some());

    run(&mut harness.state_mut().editor, "key n\nkey n\nkey n\nkey n");
    harness.state_mut().editor.apply(Command::Playback(PlaybackCommand::PlayOrStop)).unwrap();
    assert_eq!(corner(&mut harness), None, "not while playing");
    let settings = Settings { inset_while_playing: true, ..harness.state().settings.clone() };
    harness.state_mut().ui.adopt(&settings);
    assert!(corner(&mut harness).is_some(), "unless that is wanted");
}

#[test]
fn a_small_window_and_one_with_first_steps_leave_the_corner_to_the_scene() {
    let mut editor = editor();
    run(&mut editor, "eye work");
    assert_eq!(corner(&mut harness(editor.clone(), vec2(720.0, 480.0))), None);
    assert!(corner(&mut harness(editor, WINDOW)).is_some());
}

#[test]
fn a_click_in_the_corner_chooses_the_camera_and_a_double_click_looks_from_it() {
    let mut editor = editor();
    run(&mut editor, "eye work");
    let mut harness = harness(editor, WINDOW);
    let at = harness.get_by_label("What sky sees").rect().center();
    let click = |harness: &mut Harness<'_, App>| {
        harness.hover_at(at);
        for pressed in [true, false] {
            let modifiers = egui::Modifiers::NONE;
            harness.event(egui::Event::PointerButton { pos: at, button: PointerButton::Primary, pressed, modifiers });
        }
        harness.step();
    };
    click(&mut harness);
    let sky = harness.state().editor.scene().find_rbt("sky");
    assert_eq!(harness.state().commands, [Command::View(ViewCommand::Choose(sky))]);
    click(&mut harness);
    let looks = Command::View(ViewCommand::SetEye(Eye::Recorded(0)));
    assert_eq!(harness.state().commands.last(), Some(&looks));
    assert_eq!(corner(&mut harness), None);
}

#[test]
fn the_menu_of_any_node_looks_from_it() {
    let mut harness = harness(editor(), WINDOW);
    for (row, item, expected) in [
        ("ground", "Look from ground", ViewCommand::LookFromNode(harness.state().editor.scene().find_rbt("ground"))),
        ("robot2", "Look from robot2", ViewCommand::SetEye(Eye::Recorded(2))),
    ] {
        let at = harness.get_by_role_and_label(egui::accesskit::Role::ListBoxOption, row).rect().center();
        harness.hover_at(at);
        for pressed in [true, false] {
            let modifiers = egui::Modifiers::NONE;
            harness.event(egui::Event::PointerButton { pos: at, button: PointerButton::Secondary, pressed, modifiers });
        }
        harness.run();
        // Eyes have a button of this name in the list too; the menu stands over it.
        let place = harness.query_all_by_label(item).last().expect("the menu has it").rect().center();
        harness.hover_at(place);
        for pressed in [true, false] {
            let modifiers = egui::Modifiers::NONE;
            let button = PointerButton::Primary;
            harness.event(egui::Event::PointerButton { pos: place, button, pressed, modifiers });
            harness.step();
        }
        harness.run();
        assert_eq!(harness.state().commands.last(), Some(&Command::View(expected)), "{item}");
    }
}

/// The wires of the recorded camera are chosen by their tip and posed like a node.
#[test]
fn the_wires_of_the_recorded_camera_are_taken_by_their_tip() {
    let mut editor = editor();
    run(&mut editor, "eye work\nlook right");
    let size_px = Vec2::new(800.0, 600.0);
    let camera = editor.camera(size_px);
    let sky = editor.scene().find_rbt("sky").unwrap();
    let tip = |editor: &Editor| {
        let world_from_sky = editor.scene().world_from_rbt(&editor.displayed_pose(), 0.0, sky);
        camera.project(world_from_sky.translation).unwrap().0
    };
    let at_px = tip(&editor);
    assert_eq!(editor.part_near(&camera, at_px + Vec2::splat(3.0), 8.0), Some(sky));
    assert_eq!(editor.part_near(&camera, at_px + Vec2::new(0.0, 40.0), 8.0), None);
    run(&mut editor, "select sky\ndrag begin\ndrag move 1 0 0\ndrag end");
    assert!(tip(&editor).x > at_px.x + 20.0, "it moves to the right");
    assert_eq!(editor.undo_label().map(inbetween::words::Phrase::english), Some("move a node"));
}

/// An eye with a ball of its own before it, and a ball of a node below beside that; the sun casts both shadows on the ground.
const SEEING: &str = r##"{
  "format": "inbetween.scene", "version": 1, "name": "seeing", "eyes": ["robot", "sky"], "vertical_fov_degrees": 60,
  "nodes": [
    { "name": "ground", "children": [
      { "name": "plane", "shape": {"plane": {"size": [400, 400]}}, "colour": "#7d8791", "translation": [0, -2, 0] }] },
    { "name": "robot", "children": [
      { "name": "chest", "shape": {"sphere": {"radius": 0.5}}, "colour": "#c8553d", "translation": [-0.7, -0.6, -4] },
      { "name": "arm", "translation": [0.7, -0.6, -4], "children": [
        { "name": "hand", "shape": {"sphere": {"radius": 0.5}}, "colour": "#4a7fd0" }] }] },
    { "name": "sky", "translation": [0, 0, 0] }
  ]
}"##;

#[test]
fn no_picture_shows_the_own_shapes_of_its_eye_and_all_show_their_shadows() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("seeing.json"), SEEING).unwrap();
    let scene = Arc::new(scene_from_json(SEEING).expect("it is a scene"));
    let mut editor = Editor::new(Arc::clone(&scene), folder.path().join("a.json"));
    run(&mut editor, "key n\nkey n\nkey n\nkey n");
    let keyframes = &editor.document().keyframes;
    let linear = inbetween::interpolation::Interpolation::Linear;
    std::fs::write(editor.keyframe_file(), inbetween::keyframe::keyframes_to_json(&scene, keyframes, linear, 100))
        .unwrap();

    let render = |arguments: &[&str]| {
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_inbetween"))
            .current_dir(folder.path())
            .args(["render", "a.json", "--scene", "seeing.json", "--size", "160x120"])
            .args(arguments)
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let (index, _) = arguments.iter().enumerate().find(|(_, argument)| **argument == "-o").unwrap();
        folder.path().join(arguments[index + 1])
    };
    let open = |path: PathBuf| image::open(path).unwrap();

    // The indices of nodes: the eye's own ball is nowhere, but the other one is.
    let nodes = open(render(&["--keyframe", "1", "-o", "id.png", "--id"])).to_luma16();
    let level = |path: &str| u16::try_from(scene.find(path).unwrap().get() + 1).unwrap();
    let count = |level: u16| nodes.pixels().filter(|pixel| pixel[0] == level).count();
    assert_eq!(count(level("robot/chest")), 0);
    assert!(count(level("robot/arm/hand")) > 200, "{}", count(level("robot/arm/hand")));
    // From the sky, which stands at the same place, both are there.
    let all = open(render(&["--keyframe", "1", "-o", "sky-id.png", "--id", "--camera", "sky"])).to_luma16();
    let chest: Vec<(u32, u32)> =
        all.enumerate_pixels().filter(|(.., pixel)| pixel[0] == level("robot/chest")).map(|(x, y, _)| (x, y)).collect();
    assert!(chest.len() > 200, "{}", chest.len());

    // In colours: where the ball would be there is none of its red, and all else is as the sky sees it, the shadow too.
    let picture = open(render(&["--keyframe", "1", "-o", "one.png"])).to_rgba8();
    let with_ball = open(render(&["--keyframe", "1", "-o", "sky.png", "--camera", "sky"])).to_rgba8();
    let is_red = |pixel: &image::Rgba<u8>| i32::from(pixel[0]) > i32::from(pixel[2]) + 30;
    assert!(chest.iter().all(|&(x, y)| !is_red(picture.get_pixel(x, y))));
    assert!(chest.iter().filter(|&&(x, y)| is_red(with_ball.get_pixel(x, y))).count() > 100);
    let without: String = SEEING.lines().filter(|line| !line.contains("chest")).collect();
    std::fs::write(folder.path().join("seeing.json"), without).unwrap();
    let without = open(render(&["--keyframe", "1", "-o", "without.png"])).to_rgba8();
    std::fs::write(folder.path().join("seeing.json"), SEEING).unwrap();
    let mut in_shadow = 0;
    for (x, y, pixel) in picture.enumerate_pixels() {
        let is_near = |(cx, cy): &(u32, u32)| cx.abs_diff(x) <= 1 && cy.abs_diff(y) <= 1;
        if !chest.iter().any(is_near) {
            assert_eq!(pixel, with_ball.get_pixel(x, y), "at {x}, {y}");
            in_shadow += usize::from(i32::from(pixel[1]) + 10 < i32::from(without.get_pixel(x, y)[1]));
        }
    }
    assert!(in_shadow > 50, "the ball that is not drawn has no shadow: {in_shadow} pixels");

    // A film, the window and its pictures show the same.
    render(&["-o", "film", "--fps", "10"]);
    let frame = open(folder.path().join("film/frame-00000.png")).to_rgba8();
    assert!(frame == picture, "a film shows something else");
    let gpu = Gpu::headless().expect("a GPU adapter");
    let mut renderer = Renderer::new(&gpu, Offscreen::FORMAT, inbetween::render::default_samples(gpu.is_software));
    let size_px = Vec2::new(160.0, 120.0);
    run(&mut editor, "go 1\neye robot");
    let frame = picture_of_editor(&editor, size_px, false);
    // The window adds lines to it, such as the wires of the other eye.
    assert_eq!(frame_of_editor(&editor, size_px).items, frame.items);
    let drawn = Offscreen::new(&gpu, 160, 120).unwrap().render(&gpu, &mut renderer, &frame).unwrap();
    let differing = drawn.rgba.iter().zip(picture.as_raw()).filter(|(a, b)| a != b).count();
    assert_eq!(differing, 0, "the window shows something else");
    // What is not drawn takes no click.
    let (x, y) = chest[chest.len() / 2];
    assert_eq!(editor.part_near(&editor.camera(size_px), Vec2::new(x as f32, y as f32), 0.5), None);
}
