//! Endings of the real window that no user asked for: what was done is in the journal, and comes back.
//!
//! It needs `Xvfb` and `xdotool`; without them it fails and says so.

mod display;

use std::io::{BufRead as _, BufReader, Read as _};
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use display::{Running, display, focused_window, inbetween, wait_for, xdotool};
use inbetween::journal::play_alone;
use inbetween::storage::logs;
use rustix::process::{Pid, Signal};

/// A window that prints how many lines its journal has.
struct Window {
    process: Running,
    counts: Receiver<usize>,
    folder: tempfile::TempDir,
}

impl Window {
    fn open(display: &str, more: &[&str]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        Self::open_in(folder, display, more)
    }

    fn open_in(folder: tempfile::TempDir, display: &str, more: &[&str]) -> Self {
        let mut command = inbetween(display, folder.path());
        command.arg("--print-lines").args(more).arg(folder.path().join("walk.json"));
        let child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut process = Running(child);
        let output = BufReader::new(process.0.stdout.take().unwrap());
        let (sender, counts) = channel();
        std::thread::spawn(move || {
            for line in output.lines().map_while(Result::ok) {
                let Some(count) = line.parse().ok() else { continue };
                if sender.send(count).is_err() {
                    return;
                }
            }
        });
        focused_window(display, &mut process);
        Self { process, counts, folder }
    }

    /// The last number that was printed until now.
    fn printed(&self, last: &mut usize) {
        while let Ok(count) = self.counts.try_recv() {
            *last = count;
        }
    }

    /// Waits until the journal has so many lines.
    fn wait_for_lines(&self, lines: usize) {
        let mut last = 0;
        let is_there = wait_for(|| {
            self.printed(&mut last);
            last >= lines
        });
        assert!(is_there, "the journal has {last} lines, expected {lines}");
    }

    /// The exit status and what was said on standard error.
    fn end(&mut self) -> (Option<i32>, String) {
        let is_over = wait_for(|| self.process.0.try_wait().is_ok_and(|end| end.is_some()));
        assert!(is_over, "the window does not end");
        let mut said = String::new();
        self.process.0.stderr.take().unwrap().read_to_string(&mut said).unwrap();
        (self.process.0.wait().unwrap().code(), said)
    }

    fn journal(&self) -> PathBuf {
        logs(&self.folder.path().join("state/inbetween"), ".journal").into_iter().next().expect("there is a journal")
    }

    /// How many keyframes `inbetween recover` writes.
    fn recovered(&self) -> usize {
        let out = self.folder.path().join("out.json");
        let mut command = inbetween(":none", self.folder.path());
        let output = command.args(["recover", "-o"]).arg(&out).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let json: serde_json::Value = serde_json::from_slice(&std::fs::read(out).unwrap()).unwrap();
        json["keyframes"].as_array().unwrap().len()
    }
}

fn type_keys(display: &str, keys: &[&str]) {
    xdotool(display, &[&["key", "--delay", "5"], keys].concat()).expect("the keys are typed");
}

fn kill(window: &Window, signal: Signal) {
    rustix::process::kill_process(Pid::from_child(&window.process.0), signal).unwrap();
}

#[track_caller]
fn check_sentence(said: &str, journal: &Path) {
    let sentence = format!("what was not saved is in {}: `inbetween recover` gets it back", journal.display());
    assert!(said.lines().any(|line| line.contains(&sentence)), "{said}");
}

#[test]
fn each_signal_ends_the_window_with_everything_in_the_journal() {
    let (_server, display) = display(&[]);
    for (signal, number) in [(Signal::TERM, 15), (Signal::HUP, 1), (Signal::INT, 2)] {
        let mut window = Window::open(&display, &[]);
        type_keys(&display, &["n", "n", "n"]);
        window.wait_for_lines(3);
        kill(&window, signal);
        let (status, said) = window.end();
        assert_eq!(status, Some(128 + number), "{said}");
        check_sentence(&said, &window.journal());
        assert_eq!(window.recovered(), 3);
    }
}

#[test]
fn a_window_with_nothing_unsaved_leaves_nothing_to_recover() {
    let (_server, display) = display(&[]);
    let mut window = Window::open(&display, &[]);
    kill(&window, Signal::TERM);
    let (status, said) = window.end();
    assert_eq!((status, said.as_str()), (Some(143), "ended by signal 15\n"));
}

#[test]
fn a_display_that_goes_away_leaves_everything_in_the_journal() {
    let (mut server, display) = display(&[]);
    let mut window = Window::open(&display, &[]);
    type_keys(&display, &["n", "n"]);
    window.wait_for_lines(2);
    server.0.kill().unwrap();
    let (status, said) = window.end();
    assert_eq!(status, Some(1), "{said}");
    assert!(said.contains("`inbetween recover` gets it back"), "{said}");
    assert_eq!(window.recovered(), 2);
}

#[test]
fn a_panic_in_a_command_is_said_and_the_window_goes_on() {
    let (_server, display) = display(&[]);
    let mut window = Window::open(&display, &["--window-panic-at", "3"]);
    type_keys(&display, &["n", "n", "n", "n"]);
    window.wait_for_lines(4);
    kill(&window, Signal::TERM);
    let (status, said) = window.end();
    assert_eq!(status, Some(143), "{said}");
    let text = std::fs::read_to_string(window.journal()).unwrap();
    assert!(text.contains("do keyframe-new\n# panicked\ndo keyframe-new\n"), "{text}");
    assert_eq!(window.recovered(), 3);
}

#[test]
fn a_panic_elsewhere_ends_the_window_with_101_and_its_command_is_passed_over() {
    let (_server, display) = display(&[]);
    let mut window = Window::open(&display, &["--drawing-panic-at", "3"]);
    type_keys(&display, &["n", "n", "n"]);
    let (status, said) = window.end();
    assert_eq!(status, Some(101), "{said}");
    check_sentence(&said, &window.journal());
    assert_eq!(window.recovered(), 2);
}

/// How often a window is killed; more by hand: `WINDOW_KILLS=200 cargo test --test endings kills`.
fn kills() -> u64 {
    std::env::var("WINDOW_KILLS").ok().and_then(|count| count.parse().ok()).unwrap_or(20)
}

#[test]
fn kills_at_random_moments_lose_nothing_that_was_done() {
    const KEYS: [&str; 12] = ["n", "u", "greater", "less", "d", "ctrl+z", "plus", "v", "w", "i", "ctrl+y", "ctrl+c"];
    let (_server, display) = display(&[]);
    let mut random = 0x2545_f491_4f6c_dd1d_u64;
    let mut next = move |below: u64| {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        random % below
    };
    for round in 0..kills() {
        let mut window = Window::open(&display, &[]);
        let keys: Vec<&str> = (0..200).map(|_| KEYS[usize::try_from(next(12)).unwrap()]).collect();
        let mut typing = std::process::Command::new("xdotool")
            .env("DISPLAY", &display)
            .args(["key", "--delay", "4"])
            .args(&keys)
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(next(900)));
        window.process.0.kill().unwrap();
        window.process.0.wait().unwrap();
        let _ = typing.kill();
        let _ = typing.wait();
        // What was printed before is in the pipe, or was received.
        let mut printed = 0;
        while let Ok(count) = window.counts.recv_timeout(Duration::from_secs(5)) {
            printed = count;
        }
        let text = std::fs::read(window.journal()).unwrap();
        let (_, played) = play_alone(&text);
        assert_eq!((played.damage, played.is_cut), (None, false), "round {round}");
        // The first two lines restore what was at first.
        let commands = played.lines - 2;
        assert!(commands >= printed, "round {round}: {commands} commands are recovered, {printed} were done");
    }
}

#[test]
fn what_was_not_saved_is_offered_at_the_next_start_and_restored() {
    let (_server, display) = display(&[]);
    let mut window = Window::open(&display, &[]);
    type_keys(&display, &["n", "n", "n"]);
    window.wait_for_lines(3);
    window.process.0.kill().unwrap();
    window.process.0.wait().unwrap();
    let old = window.journal();
    let mut window = Window::open_in(window.folder, &display, &[]);
    // Hotkeys work beside the bar.
    type_keys(&display, &["n"]);
    window.wait_for_lines(1);
    assert!(old.is_file());
    // The buttons are at the right end of the bar: restore, later, discard.
    let is_restored = wait_for(|| {
        xdotool(&display, &["mousemove", "864", "41", "click", "1"]).expect("the pointer moves");
        std::thread::sleep(Duration::from_millis(500));
        !old.is_file()
    });
    assert!(is_restored, "the click on Restore does nothing");
    kill(&window, Signal::TERM);
    assert_eq!(window.end().0, Some(143));
    assert_eq!(window.recovered(), 3, "the newest journal goes on from the restored one");
    assert_eq!(window.recovered(), 1, "what was unsaved at that time is in a journal of its own");
}
