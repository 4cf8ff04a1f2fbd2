//! Displays of their own for windows, and keys that are typed into them.

#![allow(dead_code, reason = "each test file uses its part")]

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// How long a slow machine may take to open the window, or to write the file.
pub const PATIENCE: Duration = Duration::from_secs(30);

/// A process that ends with the test.
pub struct Running(pub Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

pub fn start(what: &str, command: &mut Command) -> Running {
    let child = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
    Running(child.unwrap_or_else(|error| panic!("{what} does not start ({error}): run .ci/setup, which installs it")))
}

/// A virtual display that was free, and its name. `more` is what Xvfb is told beside that.
pub fn display(more: &[&str]) -> (Running, String) {
    // Tests run side by side: none tries a number that another has tried.
    static TRIED: AtomicU32 = AtomicU32::new(0);
    let first = 90 + std::process::id() % 1000;
    for number in std::iter::repeat_with(|| first + TRIED.fetch_add(1, Ordering::Relaxed)).take(1000) {
        let name = format!(":{number}");
        let socket = format!("/tmp/.X11-unix/X{number}");
        if is_taken(number, &socket) {
            continue;
        }
        // A server that was killed leaves its socket.
        let _ = std::fs::remove_file(&socket);
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

/// Whether a server has a display. Its lock holds its process, which may be gone.
fn is_taken(number: u32, socket: &str) -> bool {
    match std::fs::read_to_string(format!("/tmp/.X{number}-lock")) {
        Ok(process) => Path::new("/proc").join(process.trim()).exists(),
        Err(_) => Path::new(socket).exists(),
    }
}

pub fn wait_for(mut condition: impl FnMut() -> bool) -> bool {
    let start = Instant::now();
    while start.elapsed() < PATIENCE {
        if condition() {
            return true;
        }
        sleep(Duration::from_millis(20));
    }
    false
}

pub fn xdotool(display: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new("xdotool").env("DISPLAY", display).args(arguments).output();
    let output =
        output.unwrap_or_else(|error| panic!("xdotool does not start ({error}): run .ci/setup, which installs it"));
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// The program on a display, with settings of its own in a folder.
pub fn inbetween(display: &str, folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_inbetween"));
    command
        .env("DISPLAY", display)
        .env("XDG_CONFIG_HOME", folder)
        .env("XDG_STATE_HOME", folder.join("state"))
        .env("LC_ALL", "C.UTF-8")
        // No desktop says how the window is to look.
        .env("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nonexistent")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET");
    command
}

/// The window of the program on a display, once it is there, with the keyboard's focus.
pub fn focused_window(display: &str, inbetween: &mut Running) -> String {
    let mut window = String::new();
    let is_open = wait_for(|| {
        window = xdotool(display, &["search", "--name", "Inbetween"]).unwrap_or_default();
        !window.is_empty()
    });
    assert!(is_open, "no window opens; the program: {:?}", inbetween.0.try_wait());
    let window = window.lines().next().unwrap_or_default().to_owned();
    xdotool(display, &["windowfocus", "--sync", &window]).expect("the window takes the focus");
    window
}
