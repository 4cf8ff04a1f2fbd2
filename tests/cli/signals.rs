//! Signals end every command at once, whatever it waits for: with 128 and the signal's number, and with nothing left behind.

use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process, test_kill_process};

use crate::sandbox::{Sandbox, keyframe_file};

/// How long a slow machine may take.
const PATIENCE: Duration = Duration::from_mins(1);

#[track_caller]
fn wait_for(what: &str, mut condition: impl FnMut() -> bool) {
    let start = Instant::now();
    while !condition() {
        assert!(start.elapsed() < PATIENCE, "{what} does not come");
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// A line of what the system says of a process.
fn status(pid: u32, field: &str) -> String {
    let text = std::fs::read_to_string(format!("/proc/{pid}/status")).unwrap_or_default();
    text.lines().find_map(|line| line.strip_prefix(field)).unwrap_or_default().trim().to_owned()
}

/// Waits until a command hears a signal, and until its main thread sleeps.
#[track_caller]
fn wait_until_it_waits(child: &Child, signal: Signal) {
    let bit = |digits: &str| u64::from_str_radix(digits, 16).unwrap_or_default() >> (signal.as_raw() - 1) & 1;
    wait_for("the command that hears signals", || {
        assert!(!status(child.id(), "State:").starts_with('Z'), "it ended before it was to");
        bit(&status(child.id(), "SigCgt:")) == 1
    });
    for _ in 0..10 {
        wait_for("the command that waits", || status(child.id(), "State:").starts_with('S'));
        std::thread::sleep(Duration::from_millis(10));
    }
}

fn sandbox() -> Sandbox {
    use std::os::unix::fs::PermissionsExt as _;
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(5).to_string());
    sandbox.write("wait.txt", "key n\n");
    for name in ["in", "out.png", "in.png", "out.mp4", "in.journal", "driver.json"] {
        let made = Command::new("mkfifo").arg(sandbox.path(name)).status().unwrap();
        assert!(made.success());
    }
    // Its child holds the pipe as well.
    let hangs = "#!/bin/sh\n[ \"$1\" = -version ] && exit 0\necho $$ > pid\n/bin/sleep 1000 &\nwait\n";
    for (folder, script) in [("hangs", hangs), ("hangs-at-once", "#!/bin/sh\necho $$ > pid\n/bin/sleep 1000 &\nwait\n")]
    {
        std::fs::create_dir(sandbox.path(folder)).unwrap();
        let path = format!("{folder}/ffmpeg");
        sandbox.write(&path, script);
        std::fs::set_permissions(sandbox.path(&path), std::fs::Permissions::from_mode(0o755)).unwrap();
    }
    sandbox
}

fn start(sandbox: &Sandbox, arguments: &str, variables: &[(&str, &str)]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_inbetween"))
        .current_dir(sandbox.path(""))
        .args(arguments.split_whitespace())
        .envs(variables.iter().copied())
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Sends a signal to a command that waits, and checks how it ends.
#[track_caller]
fn ends(arguments: &str, variables: &[(&str, &str)], signal: Signal) {
    let sandbox = sandbox();
    let before = sandbox.names();
    let mut child = start(&sandbox, arguments, variables);
    let _input = child.stdin.take();
    if arguments.ends_with("film.mp4") {
        wait_for("ffmpeg", || std::fs::read_to_string(sandbox.path("pid")).is_ok_and(|pid| pid.ends_with('\n')));
    }
    wait_until_it_waits(&child, signal);
    kill_process(Pid::from_child(&child), signal).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(128 + signal.as_raw()), "{arguments}");
    let said = match signal {
        Signal::INT => "interrupted: what was not finished is not kept\n".to_owned(),
        _ => format!("ended by signal {}: what was not finished is not kept\n", signal.as_raw()),
    };
    assert_eq!(String::from_utf8_lossy(&output.stderr), said, "{arguments}");
    let mut names = sandbox.names();
    if arguments.ends_with("film.mp4") {
        let pid = sandbox.read("pid").trim().parse().unwrap();
        wait_for("the end of ffmpeg", || test_kill_process(Pid::from_raw(pid).unwrap()).is_err());
        names.retain(|name| name != "pid");
    }
    assert_eq!(names, before, "{arguments}");
}

#[test]
fn ctrl_c_ends_whatever_is_waited_for() {
    for arguments in [
        "check in",
        "convert in -o out.json",
        "sample in",
        "render -o out.png --size 16x16",
        "render in -o out.gif --size 16x16",
        "compare in.png in.png",
        "diff in a.json",
        "diagnose a.json in",
        "grade in a.json -o grades --no-images",
        "recover in.journal",
        "script -",
        "script in",
        "script wait.txt --state out.mp4",
        "--scene in nodes",
    ] {
        ends(arguments, &[], Signal::INT);
    }
}

#[test]
fn ctrl_c_ends_ffmpeg_and_leaves_no_draft() {
    for (folder, signal) in [("hangs", Signal::INT), ("hangs", Signal::TERM), ("hangs-at-once", Signal::INT)] {
        let path = format!("{folder}:/bin:/usr/bin");
        ends("render a.json --size 640x480 --fps 60 -o film.mp4", &[("PATH", &path)], signal);
    }
}

#[test]
fn ctrl_c_ends_a_command_whose_driver_hangs() {
    ends("render -o x.png", &[("VK_DRIVER_FILES", "driver.json")], Signal::INT);
}

#[test]
fn other_signals_end_with_their_numbers() {
    ends("script -", &[], Signal::TERM);
    ends("check in", &[], Signal::HUP);
}

#[test]
fn what_is_to_be_ignored_stays_ignored() {
    let sandbox = sandbox();
    // As nohup has it.
    let mut child = Command::new("sh")
        .current_dir(sandbox.path(""))
        .args(["-c", "trap '' HUP; exec \"$0\" script -", env!("CARGO_BIN_EXE_inbetween")])
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    wait_until_it_waits(&child, Signal::INT);
    kill_process(Pid::from_child(&child), Signal::HUP).unwrap();
    std::thread::sleep(Duration::from_millis(50));
    assert!(child.try_wait().unwrap().is_none());
    child.kill().unwrap();
    child.wait().unwrap();
}

#[test]
fn a_script_in_the_middle_of_its_lines_ends_with_its_journal_whole() {
    let sandbox = sandbox();
    sandbox.write("long.txt", format!("key n\n{}", "key n\nundo\n".repeat(200_000)));
    let child = start(&sandbox, "script long.txt --journal long.journal", &[]);
    wait_for("a journal", || std::fs::metadata(sandbox.path("long.journal")).is_ok_and(|file| file.len() > 2000));
    kill_process(Pid::from_child(&child), Signal::INT).unwrap();
    assert_eq!(child.wait_with_output().unwrap().status.code(), Some(130));
    let outcome = sandbox.run(&["recover", "long.journal", "-o", "got.json"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    assert!((1..=2).contains(&sandbox.json("got.json")["keyframes"].as_array().unwrap().len()));
}

#[test]
fn ctrl_c_during_a_recovery_costs_no_line_at_the_next_one() {
    let sandbox = sandbox();
    sandbox.write("long.txt", format!("key n\n{}key n\n", "key n\nundo\n".repeat(60_000)));
    assert_eq!(sandbox.run(&["script", "long.txt", "--journal", "long.journal"]).status, 0);
    sandbox.write("long.journal", sandbox.read("long.journal").replace("# quit\n", ""));
    let child = start(&sandbox, "recover long.journal -o got.json", &[]);
    wait_for("the recovery", || sandbox.read("long.journal").ends_with("# recovering\n"));
    kill_process(Pid::from_child(&child), Signal::INT).unwrap();
    assert_eq!(child.wait_with_output().unwrap().status.code(), Some(130));
    let outcome = sandbox.run(&["recover", "long.journal", "-o", "got.json"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    assert_eq!(sandbox.json("got.json")["keyframes"].as_array().unwrap().len(), 2);
}
