//! Files of other people: what another program changes meanwhile, what is read-only, what is no file.

use std::io::{BufRead as _, BufReader, Read as _};
use std::process::Stdio;

use crate::sandbox::{Outcome, Sandbox, keyframe_file};

fn keyframes(sandbox: &Sandbox, name: &str) -> usize {
    sandbox.json(name)["keyframes"].as_array().unwrap().len()
}

/// Runs a script whose trace is longer than a pipe holds, and does something else after its first lines were run.
fn run_meanwhile(sandbox: &Sandbox, script: &str, more: &[&str], meanwhile: impl FnOnce()) -> Outcome {
    let (first, last) = script.split_once("...\n").unwrap();
    sandbox.write("s.txt", format!("{first}{}{last}", "key v\n".repeat(5_000)));
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_inbetween"))
        .current_dir(sandbox.path(""))
        .args(["script", "s.txt", "--trace", "--state", "state.json"])
        .args(more)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut trace = BufReader::new(child.stdout.take().unwrap());
    let mut stdout = String::new();
    trace.read_line(&mut stdout).unwrap();
    meanwhile();
    trace.read_to_string(&mut stdout).unwrap();
    let output = child.wait_with_output().unwrap();
    Outcome { status: output.status.code().unwrap(), stdout, stderr: String::from_utf8(output.stderr).unwrap() }
}

const CHANGED: &str = "another program has changed it since it was read or written; --overwrite replaces it";

#[test]
fn a_file_that_was_changed_on_disk_is_not_written_over() {
    let sandbox = Sandbox::new();
    let names = ["animation.json", "s.txt", "state.json"];
    for (before, said) in [
        (Some(3), format!("animation.json: {CHANGED}\n")),
        (None, "animation.json: another program has made it since the start; --overwrite replaces it\n".to_owned()),
    ] {
        if let Some(count) = before {
            sandbox.write("animation.json", keyframe_file(count).to_string());
        } else {
            std::fs::remove_file(sandbox.path("animation.json")).unwrap();
        }
        let other = keyframe_file(5).to_string();
        let change = || sandbox.write("animation.json", &other);
        let outcome = run_meanwhile(&sandbox, "key i\n...\nkey n\nkey w\nkey n\n", &[], change);
        assert_eq!((outcome.status, outcome.stderr), (1, said));
        assert_eq!(sandbox.read("animation.json"), other);
        assert_eq!(sandbox.names(), names);
        let keyframes = before.unwrap_or(0) + 2;
        assert_eq!(sandbox.json("state.json")["keyframes"], keyframes, "the script goes on");
    }
}

#[test]
fn a_file_that_was_changed_on_disk_is_kept_where_a_script_overwrites_it() {
    let sandbox = Sandbox::new();
    sandbox.write("animation.json", keyframe_file(3).to_string());
    let change = || sandbox.write("animation.json", keyframe_file(5).to_string());
    let outcome = run_meanwhile(&sandbox, "key i\n...\nkey n\nkey w\nkey w\n", &["--overwrite"], change);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    assert!(outcome.stdout.contains("Wrote 4 keyframes to animation.json. What it held before is in"));
    assert_eq!((keyframes(&sandbox, "animation.json"), keyframes(&sandbox, "animation.json.bak")), (4, 5));
    assert_eq!(sandbox.names(), ["animation.json", "animation.json.bak", "s.txt", "state.json"]);
}

#[test]
fn reading_a_changed_file_again_is_an_answer_too() {
    let sandbox = Sandbox::new();
    sandbox.write("animation.json", keyframe_file(3).to_string());
    let change = || sandbox.write("animation.json", keyframe_file(5).to_string());
    let outcome = run_meanwhile(&sandbox, "key i\n...\nkey w\nkey i\nkey n\nkey w\nkey n\nkey w\n", &[], change);
    assert_eq!((outcome.status, outcome.stderr), (1, format!("animation.json: {CHANGED}\n")));
    assert_eq!(keyframes(&sandbox, "animation.json"), 7);
}

#[test]
fn a_scene_file_that_was_changed_on_disk_is_not_written_over() {
    let sandbox = Sandbox::new();
    let saved = |script: &str| {
        let mut command = sandbox.command(&["script", "-"]);
        command.write_stdin(script);
        Sandbox::outcome(command).succeeds();
    };
    saved("put-control robot1\nsave-scene scene.json\n");
    saved("put-control robot2\nsave-scene other.json\n");
    let change = || sandbox.write("scene.json", sandbox.read("other.json"));
    let script = "key v\n...\nput-control robot2\ndo scene-save\ndo scene-reload\nput-control robot1\ndo scene-save\n";
    let outcome = run_meanwhile(&sandbox, script, &["--scene", "scene.json"], change);
    assert_eq!((outcome.status, outcome.stderr), (1, format!("scene.json: {CHANGED}\n")));
    let scene = sandbox.read("scene.json");
    assert!(scene.contains("robot1_control") && scene.contains("robot2_control"), "{scene}");
    assert!(outcome.stdout.contains("Read the scene from scene.json."));
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::{FileTypeExt as _, MetadataExt as _, PermissionsExt as _, symlink};

    use super::*;

    fn mode(sandbox: &Sandbox, name: &str) -> u32 {
        std::fs::metadata(sandbox.path(name)).unwrap().mode() & 0o777
    }

    #[test]
    fn a_read_only_file_is_refused_with_a_sentence() {
        let sandbox = Sandbox::new();
        let kept = keyframe_file(3).to_string();
        sandbox.write("kept.json", &kept);
        std::fs::set_permissions(sandbox.path("kept.json"), std::fs::Permissions::from_mode(0o444)).unwrap();
        sandbox.write("s.txt", "key n\nkey w\n");
        sandbox.run(&["script", "s.txt", "--keyframes", "kept.json"]).refuses("kept.json: it is read-only");
        sandbox
            .run(&["script", "s.txt", "--keyframes", "kept.json", "--overwrite"])
            .refuses("kept.json: it is read-only");
        assert_eq!((sandbox.read("kept.json"), mode(&sandbox, "kept.json")), (kept, 0o444));
        assert_eq!(sandbox.names(), ["kept.json", "s.txt"]);
    }

    #[test]
    fn a_hard_linked_file_is_said_to_be_one() {
        let sandbox = Sandbox::new();
        sandbox.write("animation.json", keyframe_file(3).to_string());
        std::fs::hard_link(sandbox.path("animation.json"), sandbox.path("other.json")).unwrap();
        let trace = sandbox.trace("key i\nkey n\nkey w\nkey w\n");
        let written = "Wrote 4 keyframes to animation.json.";
        assert_eq!(
            trace[2]["message"],
            format!("{written} Another name of that file (a hard link) keeps the old content.")
        );
        assert_eq!(trace[3]["message"], written, "it is a file of its own now");
        assert_eq!(keyframes(&sandbox, "other.json"), 3);
    }

    #[test]
    fn an_output_that_is_no_file_is_written_into() {
        let sandbox = Sandbox::new();
        sandbox.write("a.json", keyframe_file(4).to_string());
        let outcome = sandbox.run(&["convert", "a.json", "-o", "/dev/stdout"]);
        assert!(outcome.status == 0 && outcome.stdout.contains("\"inbetween.keyframes\""), "{outcome:?}");
        // A named pipe has its reader, and stays one.
        let pipe = sandbox.path("pipe.json");
        rustix::fs::mkfifoat(rustix::fs::CWD, &pipe, rustix::fs::Mode::from_raw_mode(0o600)).unwrap();
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || std::fs::read_to_string(pipe).unwrap()
        });
        sandbox.run(&["convert", "a.json", "-o", "pipe.json"]).succeeds();
        assert!(reader.join().unwrap().contains("\"inbetween.keyframes\""));
        assert!(std::fs::symlink_metadata(&pipe).unwrap().file_type().is_fifo());
        // A dangling link gets its target, with the mode of the umask.
        std::fs::create_dir(sandbox.path("not")).unwrap();
        symlink("not/yet.json", sandbox.path("dangling.json")).unwrap();
        sandbox.run(&["convert", "a.json", "-o", "dangling.json"]).succeeds();
        sandbox.write("plain", "");
        assert!(sandbox.path("dangling.json").is_symlink());
        assert_eq!(mode(&sandbox, "not/yet.json"), mode(&sandbox, "plain"));
        // So is what a script writes, and nobody asks what a pipe held before.
        sandbox.write("s.txt", "key n\nkey w\nkey w\n");
        sandbox.run(&["script", "s.txt", "--keyframes", "/dev/null"]).succeeds();
        assert!(std::fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    }
}
