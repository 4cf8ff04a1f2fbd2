//! The real window, on a display of its own: hotkeys are typed into it, and the file that it writes is read.
//!
//! It needs `Xvfb` and `xdotool`; without them it fails and says so.

mod display;

use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::Arc;
use std::thread::sleep;
use std::time::Duration;

use display::{display, focused_window, inbetween, start, wait_for, xdotool};
use glam::Vec2;
use inbetween::editor::{Command, Editor, Eye, ViewCommand};
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};

#[test]
fn hotkeys_typed_into_the_window_end_up_in_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("typed.json");
    let (_server, display) = display(&[]);
    let mut inbetween = start("inbetween", inbetween(&display, folder.path()).arg(&file));
    let title = format!("{} • Inbetween", file.display());
    let mut window = String::new();
    let is_open = wait_for(|| {
        window = xdotool(&display, &["search", "--name", "Inbetween"]).unwrap_or_default();
        !window.is_empty()
    });
    assert!(is_open, "no window opens; the program: {:?}", inbetween.0.try_wait());
    let window = window.lines().next().unwrap_or_default().to_owned();
    assert_eq!(xdotool(&display, &["getwindowname", &window]).as_deref(), Some(title.as_str()));
    xdotool(&display, &["windowfocus", "--sync", &window]).expect("the window takes the focus");

    for _ in 0..4 {
        xdotool(&display, &["key", "n"]).expect("the key is typed");
    }
    let unsaved = format!("*{title}");
    let is_marked = wait_for(|| xdotool(&display, &["getwindowname", &window]).as_deref() == Some(unsaved.as_str()));
    assert!(is_marked, "the title does not say that the keyframes are not saved");
    xdotool(&display, &["key", "w"]).expect("the key is typed");
    assert!(wait_for(|| file.is_file()), "w writes no file");

    let text = std::fs::read_to_string(&file).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["format"], "inbetween.keyframes");
    assert_eq!(json["keyframes"].as_array().map(Vec::len), Some(4));
    let is_saved = wait_for(|| xdotool(&display, &["getwindowname", &window]).as_deref() == Some(title.as_str()));
    assert!(is_saved, "the title does not say that all is saved");
    let settings = std::fs::read_to_string(folder.path().join("inbetween/settings.json")).unwrap();
    assert!(settings.contains("typed.json"), "the file is not among the recent ones: {settings}");
    xdotool(&display, &["key", "ctrl+q"]).expect("the key is typed");
    let is_over = wait_for(|| inbetween.0.try_wait().is_ok_and(|end| end.is_some()));
    assert!(is_over, "Ctrl+Q does not quit, although all is saved");
    assert!(inbetween.0.wait().is_ok_and(|status| status.success()));
}

#[test]
fn a_part_that_is_dragged_in_the_window_is_turned_in_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("dragged.json");
    let (_server, display) = display(&[]);
    let mut inbetween = start("inbetween", inbetween(&display, folder.path()).arg(&file));
    let window = focused_window(&display, &mut inbetween);
    let tool = |words: &str| {
        let words: Vec<&str> = words.split_whitespace().collect();
        xdotool(&display, &words).unwrap_or_else(|| panic!("xdotool {words:?}"))
    };
    let geometry = tool(&format!("getwindowgeometry --shell {window}"));
    let number = |name: &str| -> f32 {
        let line = geometry.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix('='));
        line.and_then(|number| number.parse().ok()).unwrap_or_else(|| panic!("no {name} in {geometry}"))
    };
    let is_marked =
        |is_unsaved: bool| wait_for(|| tool(&format!("getwindowname {window}")).starts_with('*') == is_unsaved);
    // Without panels, the view is the window. Two keys that show in the title: meanwhile the picture without panels was drawn.
    tool("key F11");
    tool("key n");
    assert!(is_marked(true));
    tool("key ctrl+z");
    assert!(is_marked(false));
    let scene = built_in_scene(DEFAULT_SCENE).unwrap();
    let mut editor = Editor::new(Arc::new(scene), PathBuf::from("a.json"));
    editor.apply(Command::View(ViewCommand::SetEye(Eye::Work))).unwrap();
    let shoulder = editor.scene().find_rbt("robot1/left_shoulder").unwrap();
    let in_world = editor.scene().world_from_rbt(&editor.displayed_pose(), 0.0, shoulder).translation;
    let camera = editor.camera(Vec2::new(number("WIDTH"), number("HEIGHT")));
    let is_on_shoulder = |at_px: Vec2| editor.part_near(&camera, at_px, 0.0) == Some(shoulder);
    let beside = (0..100_u8).map(|by| camera.project(in_world).unwrap().0.round() - Vec2::X * f32::from(by));
    let is_well_within = |at_px: &Vec2| [-3.0, 0.0, 3.0].iter().all(|by| is_on_shoulder(*at_px + Vec2::X * *by));
    let at_px = Vec2::new(number("X"), number("Y")) + beside.into_iter().find(is_well_within).unwrap();
    let to = |by: f32| format!("mousemove {} {}", at_px.x + by, at_px.y - by);
    tool(&to(0.0));
    tool("mousedown 1");
    for step in 1..=8_u8 {
        tool(&to(f32::from(step) * 8.0));
    }
    tool("mouseup 1");
    tool("key n");
    assert!(is_marked(true));
    tool("key w");
    assert!(wait_for(|| file.is_file()));
    let json: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(&file).unwrap()).unwrap();
    let poses = json["keyframes"][0]["pose"].as_array().unwrap();
    let is_turned = |place: &usize| poses[*place]["rotation"] != serde_json::json!([0, 0, 0, 1]);
    assert_eq!((0..poses.len()).filter(is_turned).collect::<Vec<_>>(), [shoulder.get()]);
}

/// What a display shows, once the program has drawn on it and nothing changes any more: 4 bytes a pixel. And whether pictures reached it
/// through shared memory.
fn shown(more: &[&str]) -> (Vec<u8>, bool) {
    let folder = tempfile::tempdir().unwrap();
    let memory = folder.path().to_str().unwrap();
    let (_server, display) = display(&[&["-fbdir", memory], more].concat());
    let inbetween = start("inbetween", &mut inbetween(&display, folder.path()));
    let pixels = || {
        // An X window dump: its header says how long itself is, and how many colours of twelve bytes follow it.
        let dump = std::fs::read(folder.path().join("Xvfb_screen0")).unwrap_or_default();
        let word =
            |place: usize| Some(u32::from_be_bytes(dump.get(4 * place..4 * place + 4)?.try_into().ok()?) as usize);
        let start = word(0).zip(word(19)).map_or(0, |(header, colours)| header + 12 * colours);
        dump.get(start..start + 4 * 1280 * 800).map(<[u8]>::to_vec).unwrap_or_default()
    };
    let mut last = Vec::new();
    let is_still = wait_for(|| {
        sleep(Duration::from_millis(400));
        let now = pixels();
        let colours: HashSet<&[u8]> = now.chunks_exact(4).collect();
        let is_still = colours.len() > 1000 && now == last;
        last = now;
        is_still
    });
    assert!(is_still, "the window shows no picture that stays, with {more:?}");
    let maps = std::fs::read_to_string(format!("/proc/{}/maps", inbetween.0.id())).unwrap_or_default();
    (last, maps.contains("memfd:inbetween picture"))
}

#[test]
fn a_display_that_shares_no_memory_shows_the_same() {
    let ((shared, is_shared), (sent, is_sent_shared)) = (shown(&[]), shown(&["-extension", "MIT-SHM"]));
    assert_eq!((is_shared, is_sent_shared), (cfg!(target_os = "linux"), false));
    let others = shared.chunks(4).zip(sent.chunks(4)).enumerate().filter(|(_, (a, b))| a != b);
    let places: Vec<_> = others.map(|(place, _)| (place % 1280, place / 1280)).collect();
    assert!(places.is_empty(), "{} pixels differ, the first at {:?}", places.len(), places[0]);
}

#[test]
fn a_wayland_variable_of_another_session_does_not_keep_the_window_from_x11() {
    let folder = tempfile::tempdir().unwrap();
    let (_server, display) = display(&[]);
    let mut command = inbetween(&display, folder.path());
    command.env("WAYLAND_DISPLAY", "wayland-nobody").env("XDG_RUNTIME_DIR", folder.path());
    let mut inbetween_there = start("inbetween", &mut command);
    let is_open =
        wait_for(|| xdotool(&display, &["search", "--name", "Inbetween"]).is_some_and(|window| !window.is_empty()));
    assert!(is_open, "no window opens; the program: {:?}", inbetween_there.0.try_wait());
    // Where neither answers, both are named.
    let mut command = inbetween(":77777", folder.path());
    let output = command.env("WAYLAND_DISPLAY", "wayland-nobody").output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(3), "{said}");
    assert!(said.contains("WAYLAND_DISPLAY is \"wayland-nobody\", DISPLAY is \":77777\""), "{said}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_desktop_knows_the_window_by_its_class_and_shows_its_icon() {
    use x11rb::connection::Connection as _;
    use x11rb::protocol::xproto::{AtomEnum, ConnectionExt as _};

    let folder = tempfile::tempdir().unwrap();
    let (_server, display) = display(&[]);
    let mut running = start("inbetween", &mut inbetween(&display, folder.path()));
    let window: u32 = focused_window(&display, &mut running).parse().unwrap();
    let (connection, _) = x11rb::connect(Some(&display)).unwrap();
    let property = |name: &str| {
        let atom = connection.intern_atom(false, name.as_bytes()).unwrap().reply().unwrap().atom;
        connection.get_property(false, window, atom, AtomEnum::ANY, 0, 1 << 20).unwrap().reply().unwrap()
    };
    assert_eq!(connection.setup().protocol_major_version, 11);
    assert_eq!(String::from_utf8_lossy(&property("WM_CLASS").value), "inbetween\0inbetween\0");
    let icon: Vec<u32> = property("_NET_WM_ICON").value32().unwrap().collect();
    assert_eq!(icon.get(..2), Some(&[64, 64][..]));
    assert_eq!(icon.len(), 2 + 64 * 64);
    // Its corner is transparent, its keyframes are of the accent's colour.
    assert_eq!(icon[2] >> 24, 0);
    assert!(icon[2..].contains(&0xff_f2_a3_3a), "{:x?}", &icon[2 + 64 * 17..][..64]);
}

#[test]
fn a_second_start_with_a_file_opens_a_second_window() {
    let folder = tempfile::tempdir().unwrap();
    let (_server, display) = display(&[]);
    let open = |name: &str| {
        let mut running = start("inbetween", inbetween(&display, folder.path()).arg(folder.path().join(name)));
        let title = format!("{name} ");
        let is_open = wait_for(|| xdotool(&display, &["search", "--name", &title]).is_some_and(|id| !id.is_empty()));
        assert!(is_open, "no window shows {name}; the program: {:?}", running.0.try_wait());
        running
    };
    let (mut first, mut second) = (open("first.json"), open("second.json"));
    let windows = xdotool(&display, &["search", "--class", "^inbetween$"]).unwrap_or_default();
    let of_process = |window: &str| xdotool(&display, &["getwindowpid", window]);
    let mut processes: Vec<_> = windows.lines().filter_map(of_process).collect();
    processes.sort();
    processes.dedup();
    assert_eq!(processes.len(), 2, "{windows}");
    assert!(first.0.try_wait().unwrap().is_none() && second.0.try_wait().unwrap().is_none());
}

#[test]
fn a_text_is_copied_in_one_window_and_pasted_in_another() {
    let folder = tempfile::tempdir().unwrap();
    let (_server, display) = display(&[]);
    let open = |name: &str| {
        let home = folder.path().join(name);
        std::fs::create_dir_all(home.join("inbetween")).unwrap();
        let settings = r#"{"format": "inbetween.settings", "version": 1, "tour": false}"#;
        std::fs::write(home.join("inbetween/settings.json"), settings).unwrap();
        let mut running = start("inbetween", inbetween(&display, &home).arg(folder.path().join(name)));
        let title = format!("{name} ");
        let mut window = String::new();
        let is_open = wait_for(|| {
            window = xdotool(&display, &["search", "--name", &title]).unwrap_or_default();
            !window.is_empty()
        });
        assert!(is_open, "no window shows {name}; the program: {:?}", running.0.try_wait());
        (running, window.lines().next().unwrap_or_default().to_owned(), home.join("state/inbetween"))
    };
    // The window of an id types keys in the list of commands.
    let act = |window: &str, line: &str| {
        xdotool(&display, &["windowfocus", "--sync", window]).expect("the window takes the focus");
        let all: Vec<&str> = line.split(' ').collect();
        xdotool(&display, &all).unwrap_or_else(|| panic!("{line} is not done"));
        sleep(Duration::from_millis(500));
    };
    let (_first, from, _) = open("first.json");
    let (_second, to, state) = open("second.json");
    act(&from, "key ctrl+shift+p sleep 0.5 type --delay 40 linear");
    act(&from, "key ctrl+a sleep 0.2 key ctrl+c sleep 0.3");
    act(&to, "key ctrl+shift+p sleep 0.5 key ctrl+v sleep 0.5 key Return");
    let journal = || {
        let logs = inbetween::storage::logs(&state, ".journal");
        logs.first().and_then(|path| std::fs::read_to_string(path).ok()).unwrap_or_default()
    };
    assert!(wait_for(|| journal().contains("\ndo interpolation-next")), "{}", journal());
}
