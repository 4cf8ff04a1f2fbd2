//! Endings of the real window that no user asked for: what was done is in the journal, and comes back.
//!
//! It needs `Xvfb` and `xdotool`; without them it fails and says so.

mod display;

use std::io::{BufRead as _, BufReader, Read as _};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use display::{Running, display, focused_window, inbetween, wait_for, xdotool};
use inbetween::journal::{LARGEST_JOURNAL_BYTES, fingerprint, play_alone_observed};
use inbetween::storage::logs;
use rustix::process::{Pid, Signal};

/// What a window has printed: how many lines its journal has and what it must bring back, or what it says of the journal.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Printed {
    Done(usize, String),
    Said(String),
}

/// A window that prints what it has done.
struct Window {
    process: Running,
    printed: Receiver<Printed>,
    folder: tempfile::TempDir,
}

impl Window {
    fn open(display: &str, more: &[&str]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        Self::open_in(folder, display, more)
    }

    fn open_in(folder: tempfile::TempDir, display: &str, more: &[&str]) -> Self {
        let command = inbetween(display, folder.path());
        Self::start(command, folder, display, more)
    }

    fn start(mut command: Command, folder: tempfile::TempDir, display: &str, more: &[&str]) -> Self {
        command.arg("--print-lines").args(more).arg(folder.path().join("walk.json"));
        let child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut process = Running(child);
        let output = BufReader::new(process.0.stdout.take().unwrap());
        let (sender, printed) = channel();
        std::thread::spawn(move || {
            for line in output.lines().map_while(Result::ok) {
                let done = line.split_once(' ').and_then(|(count, hash)| Some((count.parse().ok()?, hash.to_owned())));
                let printed = done.map_or(Printed::Said(line), |(count, hash)| Printed::Done(count, hash));
                if sender.send(printed).is_err() {
                    return;
                }
            }
        });
        focused_window(display, &mut process);
        Self { process, printed, folder }
    }

    /// Waits for what is printed and meant.
    #[track_caller]
    fn wait_for(&self, what: &str, mut is_meant: impl FnMut(&Printed) -> bool) {
        let mut last = None;
        let is_there = wait_for(|| {
            while let Ok(printed) = self.printed.try_recv() {
                if is_meant(&printed) {
                    return true;
                }
                last = Some(printed);
            }
            false
        });
        assert!(is_there, "{what} does not come; the last that was printed: {last:?}");
    }

    /// Waits until so many commands are in the journal that the window began. Its first line is the choice of the window's eye.
    #[track_caller]
    fn wait_for_commands(&self, commands: usize) {
        self.wait_for_lines(commands + 1);
    }

    /// Waits until the journal has so many lines.
    #[track_caller]
    fn wait_for_lines(&self, lines: usize) {
        self.wait_for(
            &format!("line {lines}"),
            |printed| matches!(printed, Printed::Done(count, _) if *count >= lines),
        );
    }

    /// Kills it, and gives all that it printed and was not taken yet.
    fn kill(&mut self) -> Vec<Printed> {
        self.process.0.kill().unwrap();
        self.process.0.wait().unwrap();
        self.printed.iter().collect()
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
        window.wait_for_commands(3);
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
    // Xlib and the window notice it at the same time: whoever comes first, the end is the same.
    for _ in 0..5 {
        let (mut server, display) = display(&[]);
        let mut window = Window::open(&display, &[]);
        type_keys(&display, &["n", "n"]);
        window.wait_for_commands(2);
        server.0.kill().unwrap();
        let (status, said) = window.end();
        assert_eq!(status, Some(1), "{said}");
        let sentence = format!(
            "the display has gone; what was not saved is in {}: `inbetween recover` gets it back",
            window.journal().display()
        );
        assert_eq!(said.lines().filter(|line| *line == sentence).count(), 1, "{said}");
        assert_eq!(window.recovered(), 2);
    }
}

#[test]
fn a_device_that_is_lost_for_good_leaves_everything_in_the_journal() {
    let (_server, display) = display(&[]);
    let mut window = Window::open(&display, &["--device-lost-at", "3"]);
    type_keys(&display, &["n", "n", "n"]);
    let (status, said) = window.end();
    assert_eq!(status, Some(3), "{said}");
    check_sentence(&said, &window.journal());
    assert_eq!(window.recovered(), 3);
}

#[test]
fn the_second_signal_ends_a_window_at_once() {
    let (_server, display) = display(&[]);
    let mut window = Window::open(&display, &[]);
    type_keys(&display, &["n"]);
    window.wait_for_commands(1);
    kill(&window, Signal::INT);
    kill(&window, Signal::TERM);
    let (status, said) = window.end();
    // Signals that come together are heard in any order.
    assert!(matches!(status, Some(130 | 143)), "{status:?} {said}");
    check_sentence(&said, &window.journal());
    assert_eq!(window.recovered(), 1);
}

#[test]
fn without_a_place_for_the_journal_the_window_says_so_once_and_goes_on() {
    let (_server, display) = display(&[]);
    let folder = tempfile::tempdir().unwrap();
    let mut command = inbetween(&display, folder.path());
    command.env("XDG_STATE_HOME", "/dev/null/nowhere");
    let mut window = Window::start(command, folder, &display, &[]);
    type_keys(&display, &["n", "n", "w"]);
    let file = window.folder.path().join("walk.json");
    assert!(wait_for(|| file.is_file()), "the window does not go on");
    kill(&window, Signal::TERM);
    assert_eq!(window.end(), (Some(143), "ended by signal 15\n".to_owned()));
    let said = window
        .printed
        .iter()
        .filter(|printed| matches!(printed, Printed::Said(said) if said.starts_with("No journal can be kept")));
    assert_eq!(said.count(), 1);
}

/// A keyframe file of so many bytes, or a few more.
fn large_file(bytes: usize) -> String {
    let scene = inbetween::scene::built_in_scene(inbetween::scene::DEFAULT_SCENE).unwrap();
    let pose: Vec<_> = scene
        .rest_pose()
        .iter()
        .map(|rbt| serde_json::json!({"translation": rbt.translation.to_array(), "rotation": rbt.rotation.to_array()}))
        .collect();
    let keyframe = serde_json::json!({"pose": pose});
    let count = bytes / keyframe.to_string().len() + 1;
    serde_json::json!({
        "format": "inbetween.keyframes", "version": 1, "scene": "two-robots",
        "nodes": scene.rbt_paths().collect::<Vec<_>>(), "keyframes": vec![keyframe; count],
    })
    .to_string()
}

#[test]
fn a_full_disk_is_said_once_and_the_journal_is_read_as_far_as_it_is_whole() {
    let (_server, display) = display(&[]);
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("walk.json"), large_file(5 << 20)).unwrap();
    let program = inbetween(&display, folder.path());
    // No file may grow beyond 8 MiB.
    let mut command = Command::new("sh");
    command.args(["-c", "trap '' XFSZ; ulimit -f 16384; exec \"$0\" \"$@\""]).arg(program.get_program());
    for (name, value) in program.get_envs() {
        match value {
            Some(value) => command.env(name, value),
            None => command.env_remove(name),
        };
    }
    let mut window = Window::start(command, folder, &display, &[]);
    type_keys(&display, &["n", "i", "n"]);
    window.wait_for(
        "what is said",
        |printed| matches!(printed, Printed::Said(said) if said.starts_with("No journal can be kept")),
    );
    // The command after that is done as well.
    window.wait_for("the next command", |printed| matches!(printed, Printed::Done(..)));
    window.kill();
    let text = std::fs::read(window.journal()).unwrap();
    assert_eq!(text.len(), 8 << 20);
    let (editor, played) = play_alone_observed(&text, |_| {});
    assert!(played.is_cut && played.damage.is_none());
    let whole = serde_json::from_str::<serde_json::Value>(&large_file(5 << 20)).unwrap();
    assert_eq!(editor.document().keyframes.len(), whole["keyframes"].as_array().unwrap().len() + 1);
}

#[test]
fn at_its_bound_a_journal_goes_on_in_a_new_one_with_a_snapshot() {
    let (_server, display) = display(&[]);
    let folder = tempfile::tempdir().unwrap();
    let count = {
        let text = large_file(6 << 20);
        std::fs::write(folder.path().join("walk.json"), &text).unwrap();
        serde_json::from_str::<serde_json::Value>(&text).unwrap()["keyframes"].as_array().unwrap().len()
    };
    let mut window = Window::open_in(folder, &display, &[]);
    let first = window.journal();
    // The file was read at the start already.
    for _ in 0..2 {
        type_keys(&display, &["i"]);
    }
    assert!(wait_for(|| !first.is_file()), "the first journal goes on");
    type_keys(&display, &["n", "n"]);
    window.wait_for("a new journal", |printed| matches!(printed, Printed::Done(0, _)));
    window.wait_for_lines(2);
    window.kill();
    let journals = logs(&window.folder.path().join("state/inbetween"), ".journal");
    assert_eq!(journals.len(), 1, "{journals:?}");
    let text = std::fs::read(&journals[0]).unwrap();
    assert!((text.len() as u64) < LARGEST_JOURNAL_BYTES, "{}", text.len());
    assert_eq!(window.recovered(), count + 2);
}

#[test]
fn two_windows_have_a_journal_each_and_one_in_use_is_not_offered() {
    let (_server, display) = display(&[]);
    let mut first = Window::open(&display, &[]);
    type_keys(&display, &["n", "n"]);
    first.wait_for_commands(2);
    let of_first = first.journal();
    let mut command = inbetween(&display, first.folder.path());
    command.env("XDG_CONFIG_HOME", first.folder.path().join("other"));
    let list = || {
        let mut command = inbetween(":none", first.folder.path());
        String::from_utf8(command.args(["recover", "--list"]).output().unwrap().stdout).unwrap()
    };
    assert_eq!(list(), "", "a journal in use is listed");
    let second = Window::start(command, tempfile::tempdir().unwrap(), &display, &[]);
    let is_begun = wait_for(|| logs(&first.folder.path().join("state/inbetween"), ".journal").len() == 2);
    assert!(is_begun, "the second window keeps no journal of its own");
    first.process.0.kill().unwrap();
    first.process.0.wait().unwrap();
    let listed = list();
    assert_eq!(listed.lines().count(), 1, "{listed}");
    assert!(listed.starts_with(of_first.to_str().unwrap()), "{listed}");
    drop(second);
}

#[test]
fn a_panic_in_a_command_is_said_and_the_window_goes_on() {
    let (_server, display) = display(&[]);
    let mut window = Window::open(&display, &["--window-panic-at", "3"]);
    type_keys(&display, &["n", "n", "n", "n"]);
    window.wait_for_commands(4);
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

/// What xdotool does in a round: keys, saving, importing, and drags that pose.
fn handling(mut next: impl FnMut(u64) -> u64) -> Vec<String> {
    const KEYS: [&str; 14] =
        ["n", "u", "greater", "less", "d", "ctrl+z", "plus", "v", "ctrl+y", "ctrl+c", "ctrl+v", "p", "Escape", "y"];
    let mut handled = Vec::new();
    let mut add = |words: &str| handled.extend(words.split_whitespace().map(str::to_owned));
    for _ in 0..60 {
        match next(10) {
            0 => add("key w"),
            1 => add("key i"),
            2..5 => {
                let [x, y, button] = [300 + next(500), 150 + next(350), 1 + next(3)];
                add(&format!("mousemove {x} {y} mousedown {button}"));
                for _ in 0..4 {
                    let [x, y] = [next(60), next(60)];
                    add(&format!("mousemove_relative -- {x} {y} sleep 0.01"));
                }
                add(&format!("mouseup {button}"));
            }
            _ => add(&format!("key --delay 2 {}", KEYS[usize::try_from(next(14)).unwrap()])),
        }
        add("sleep 0.005");
    }
    handled
}

#[test]
fn kills_at_random_moments_lose_nothing_that_was_done() {
    let (_server, display) = display(&[]);
    let mut random = 0x2545_f491_4f6c_dd1d_u64;
    let mut next = move |below: u64| {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        random % below
    };
    let mut all = 0;
    for round in 0..kills() {
        let mut window = Window::open(&display, &[]);
        let mut handler = Command::new("xdotool").env("DISPLAY", &display).args(handling(&mut next)).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(next(1500)));
        // What was printed before is in the pipe, or was received.
        let printed = window.kill();
        let _ = handler.kill();
        let _ = handler.wait();
        xdotool(&display, &["mouseup", "1", "mouseup", "2", "mouseup", "3"]);
        // After each line of the journal: how many commands were done until then, and what the window must have been.
        let text = std::fs::read(window.journal()).unwrap();
        let start = text.windows(11).position(|part| part == b"# commands\n").expect("it has a head");
        let is_line = |line: &&[u8]| !line.is_empty() && !line.starts_with(b"#");
        let lines =
            text[start..].split_inclusive(|&byte| byte == b'\n').filter(|line| line.ends_with(b"\n") && is_line(line));
        let commands = lines.count();
        let mut states = Vec::new();
        let (_, played) = play_alone_observed(&text, |editor| states.push(fingerprint(editor)));
        assert_eq!((played.damage, played.passed_over, played.is_cut), (None, 0, false), "round {round}");
        let mut last = 0;
        let mut from = 0;
        for printed in printed.into_iter().filter(|printed| *printed != Printed::Said("picture".to_owned())) {
            let Printed::Done(count, state) = printed else { panic!("round {round}: {printed:?}") };
            assert!(count <= commands, "round {round}: {commands} commands are recovered, {count} were done");
            // The states come in the same order: the window's is the next one, or the same again.
            let found = states[from..].iter().position(|known| *known == state);
            from += found.unwrap_or_else(|| {
                panic!("round {round}: what the window was after {count} commands is not recovered")
            });
            last = count;
        }
        all += last;
    }
    println!("{} kills, {all} commands were done and are recovered", kills());
}

/// The buttons at the right end of the bar, in pixels.
const RESTORE: &str = "736";
const LATER: &str = "793";
const DISCARD: &str = "850";

#[test]
fn what_was_not_saved_is_offered_at_the_next_start_and_restored() {
    let (_server, display) = display(&[]);
    let mut window = Window::open(&display, &[]);
    type_keys(&display, &["n", "n", "n"]);
    window.wait_for_commands(3);
    window.process.0.kill().unwrap();
    window.process.0.wait().unwrap();
    let old = window.journal();
    let mut window = Window::open_in(window.folder, &display, &[]);
    // Hotkeys work beside the bar.
    type_keys(&display, &["n"]);
    window.wait_for_commands(1);
    assert!(old.is_file());
    // The buttons are at the right end of the bar: restore, later, discard.
    let is_restored = wait_for(|| {
        xdotool(&display, &["mousemove", RESTORE, "41", "click", "1"]).expect("the pointer moves");
        std::thread::sleep(Duration::from_millis(500));
        !old.is_file()
    });
    assert!(is_restored, "the click on Restore does nothing");
    kill(&window, Signal::TERM);
    assert_eq!(window.end().0, Some(143));
    assert_eq!(window.recovered(), 3, "the newest journal goes on from the restored one");
    assert_eq!(window.recovered(), 1, "what was unsaved at that time is in a journal of its own");
}

#[test]
fn later_leaves_a_journal_for_the_next_start_and_discard_removes_it() {
    let (_server, display) = display(&[]);
    let mut window = Window::open(&display, &[]);
    type_keys(&display, &["n", "n"]);
    window.wait_for_commands(2);
    window.kill();
    let old = window.journal();
    let listed = |folder: &Path| {
        let output = inbetween(":none", folder).args(["recover", "--list"]).output().unwrap();
        String::from_utf8(output.stdout).unwrap().contains(old.to_str().unwrap())
    };
    let mut window = Window::open_in(window.folder, &display, &[]);
    assert!(!listed(window.folder.path()), "a journal that a window offers is listed");
    let is_put_off = wait_for(|| {
        xdotool(&display, &["mousemove", LATER, "41", "click", "1"]).expect("the pointer moves");
        std::thread::sleep(Duration::from_millis(500));
        listed(window.folder.path())
    });
    assert!(is_put_off && old.is_file(), "the click on Later does nothing");
    window.kill();
    let window = Window::open_in(window.folder, &display, &[]);
    let is_discarded = wait_for(|| {
        xdotool(&display, &["mousemove", DISCARD, "41", "click", "1"]).expect("the pointer moves");
        std::thread::sleep(Duration::from_millis(500));
        !old.is_file()
    });
    assert!(is_discarded, "the click on Discard does nothing");
    assert!(!listed(window.folder.path()));
}
