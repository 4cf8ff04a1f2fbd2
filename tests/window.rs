//! The real window, on a display of its own: hotkeys are typed into it, and the file that it writes is read.
//!
//! It needs `Xvfb` and `xdotool`; without them it fails and says so.

mod display;

use std::collections::HashSet;
use std::thread::sleep;
use std::time::Duration;

use display::{display, inbetween, start, wait_for, xdotool};

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
