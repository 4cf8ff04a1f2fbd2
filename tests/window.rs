//! The real window, on a display of its own: hotkeys are typed into it, and the file that it writes is read.
//!
//! It needs `Xvfb` and `xdotool`; without them it fails and says so.

use std::collections::HashSet;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// How long a slow machine may take to open the window, or to write the file.
const PATIENCE: Duration = Duration::from_secs(30);

/// A process that ends with the test.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn start(what: &str, command: &mut Command) -> Running {
    let child = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
    Running(child.unwrap_or_else(|error| panic!("{what} does not start ({error}): run .ci/setup, which installs it")))
}

/// A virtual display that was free, and its name. `more` is what Xvfb is told beside that.
fn display(more: &[&str]) -> (Running, String) {
    // Tests run side by side: none tries a number that another has tried.
    static TRIED: AtomicU32 = AtomicU32::new(0);
    let first = 90 + std::process::id() % 1000;
    for number in std::iter::repeat_with(|| first + TRIED.fetch_add(1, Ordering::Relaxed)).take(1000) {
        let name = format!(":{number}");
        let socket = format!("/tmp/.X11-unix/X{number}");
        if Path::new(&socket).exists() || Path::new(&format!("/tmp/.X{number}-lock")).exists() {
            continue;
        }
        let mut xvfb = Command::new("Xvfb");
        let mut server = start("Xvfb", xvfb.args([&name, "-screen", "0", "1280x800x24", "-noreset"]).args(more));
        let is_up = wait_for(|| server.0.try_wait().is_ok_and(|end| end.is_some()) || Path::new(&socket).exists());
        assert!(is_up, "Xvfb does not open the display {name}");
        if server.0.try_wait().is_ok_and(|end| end.is_none()) {
            return (server, name);
        }
    }
    panic!("no display is free");
}

fn wait_for(mut condition: impl FnMut() -> bool) -> bool {
    let start = Instant::now();
    while start.elapsed() < PATIENCE {
        if condition() {
            return true;
        }
        sleep(Duration::from_millis(20));
    }
    false
}

fn xdotool(display: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new("xdotool").env("DISPLAY", display).args(arguments).output();
    let output =
        output.unwrap_or_else(|error| panic!("xdotool does not start ({error}): run .ci/setup, which installs it"));
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// The program on a display, with settings of its own in a folder.
fn inbetween(display: &str, folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_inbetween"));
    command
        .env("DISPLAY", display)
        .env("XDG_CONFIG_HOME", folder)
        .env("LC_ALL", "C.UTF-8")
        // No desktop says how the window is to look.
        .env("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nonexistent")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET");
    command
}

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
