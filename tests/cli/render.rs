use serde_json::json;

use crate::sandbox::{Outcome, Sandbox, keyframe_file};

/// Standard error may hold words of the drivers, so only the status and standard output count.
#[track_caller]
fn done(outcome: &Outcome) {
    assert_eq!((outcome.status, outcome.stdout.as_str()), (0, ""), "{}", outcome.stderr);
}

fn bytes(sandbox: &Sandbox, name: &str) -> Vec<u8> {
    std::fs::read(sandbox.path(name)).unwrap()
}

#[test]
fn an_image_has_the_size_asked_for_and_the_same_bytes_each_time() {
    let sandbox = Sandbox::new();
    done(&sandbox.run(&["render", "-o", "a.png"]));
    done(&sandbox.run(&["render", "-o", "b.png", "--size", "640x480"]));
    assert_eq!(bytes(&sandbox, "a.png"), bytes(&sandbox, "b.png"));
    let image = image::load_from_memory(&bytes(&sandbox, "a.png")).unwrap().to_rgb8();
    assert_eq!(image.dimensions(), (640, 480));
    assert!(image.pixels().any(|pixel| pixel != image.get_pixel(0, 0)), "something is drawn");
    // The header of a PNG: bit depth 8 and no interlacing.
    assert_eq!((bytes(&sandbox, "a.png")[24], bytes(&sandbox, "a.png")[28]), (8, 0));
    done(&sandbox.run(&["render", "-o", "c.png", "--size", "33x21", "--samples", "4"]));
    assert_eq!(image::load_from_memory(&bytes(&sandbox, "c.png")).unwrap().to_rgb8().dimensions(), (33, 21));
}

#[test]
fn keyframes_and_key_times_are_the_same_pictures() {
    let sandbox = Sandbox::new();
    let mut file = keyframe_file(5);
    file["ms_between_keyframes"] = json!(1000);
    sandbox.write("a.json", file.to_string());
    let render = |name: &str, arguments: &[&str]| {
        done(&sandbox.run(&[&["render", "a.json", "--size", "64x48", "-o", name], arguments].concat()));
        bytes(&sandbox, name)
    };
    let start = render("start.png", &[]);
    assert_eq!(start, render("0.png", &["--at", "0"]));
    assert_eq!(start, render("k1.png", &["--keyframe", "1"]));
    let end = render("2.png", &["--at", "2"]);
    assert_eq!(end, render("k3.png", &["--keyframe", "3"]));
    assert_ne!(start, end);
    done(&sandbox.run(&["render", "a.json", "--size", "64x48", "--fps", "2", "-o", "deep/frames"]));
    let names = |number: usize| format!("deep/frames/frame-{number:05}.png");
    assert_eq!(bytes(&sandbox, &names(0)), start);
    assert_eq!(bytes(&sandbox, &names(4)), end);
    assert!(!sandbox.path(&names(5)).exists());
}

#[test]
fn what_cannot_be_rendered_is_bad_input_and_nothing_is_written() {
    let sandbox = Sandbox::new();
    sandbox.write("short.json", keyframe_file(3).to_string());
    sandbox.write("a.json", keyframe_file(4).to_string());
    for (arguments, sentence) in [
        (&["none.json"][..], "none.json: there is no such file or folder"),
        (&["short.json"], "short.json: 3 keyframes cannot be played"),
        (&["short.json", "--keyframe", "3"], "short.json: there is no keyframe 3: they are 0 to 2"),
        (&["short.json", "--keyframe", "-1"], "short.json: there is no keyframe -1: they are 0 to 2"),
        (&["a.json", "--at", "-0.1"], "a.json: key time -0.1 is outside 0 to 1"),
        (&["a.json", "--at", "1.5"], "a.json: key time 1.5 is outside 0 to 1"),
        (&["--scene", "x"], "x: neither a built-in scene (two-robots, cylinder, orbits) nor a file that can be read"),
    ] {
        let outcome = sandbox.run(&[&["render", "-o", "x.png"], arguments].concat());
        assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""));
        assert!(outcome.stderr.contains(sentence), "{}", outcome.stderr);
    }
    assert_eq!(sandbox.run(&["render", "-o", "no/such/x.png"]).status, 1);
    assert_eq!(sandbox.run(&["render", "-o", "."]).status, 1);
    assert_eq!(sandbox.names(), ["a.json", "short.json"]);
    done(&sandbox.run(&["render", "short.json", "--keyframe", "2", "-o", "x.png", "--size", "8x8"]));
}

#[test]
fn without_an_adapter_it_is_status_3_before_anything_else() {
    let sandbox = Sandbox::new();
    sandbox.write("shot.txt", "key n\nkey w\nscreenshot x.png\n");
    sandbox.write("hotkey.txt", "key n\nkey w\nkey s\n");
    sandbox.write("plain.txt", "key n\n");
    let run = |arguments: &[&str]| {
        let mut command = sandbox.command(arguments);
        command.env("VK_ICD_FILENAMES", "/nonexistent").env("VK_DRIVER_FILES", "/nonexistent");
        Sandbox::outcome(command)
    };
    for arguments in
        [&["render", "none.json", "-o", "x.png"][..], &["script", "shot.txt", "--trace"], &["script", "hotkey.txt"]]
    {
        let outcome = run(arguments);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (3, ""), "{}", outcome.stderr);
        assert!(outcome.stderr.contains("install"), "{}", outcome.stderr);
    }
    assert_eq!(run(&["script", "plain.txt"]).status, 0);
    assert_eq!(sandbox.names(), ["hotkey.txt", "plain.txt", "shot.txt"]);
}

#[test]
fn a_script_takes_screenshots_of_what_is_displayed() {
    let sandbox = Sandbox::new();
    sandbox.write("sub.txt", "key a\nscreenshot named.png\nkey s\nselect robot1\ntranslate 0 1 0\nkey s\n");
    std::fs::create_dir(sandbox.path("out")).unwrap();
    let arguments = ["script", "sub.txt", "--trace", "--size", "64x48", "--keyframes", "out/a.json"];
    let outcome = sandbox.run(&arguments);
    assert_eq!(outcome.status, 0, "{}", outcome.stderr);
    assert!(outcome.stdout.contains("\"message\": \"Screenshot: out/inbetween-0002.png.\""), "{}", outcome.stdout);
    let first = bytes(&sandbox, "out/inbetween-0001.png");
    assert_eq!(bytes(&sandbox, "named.png"), first);
    assert_ne!(bytes(&sandbox, "out/inbetween-0002.png"), first);
    done(&sandbox.run(&["render", "-o", "rest.png", "--size", "64x48"]));
    assert_eq!(bytes(&sandbox, "rest.png"), first);
}

#[test]
fn a_screenshot_shows_the_scene_alone_unless_it_is_asked_for_overlays() {
    let sandbox = Sandbox::new();
    let script = "select robot1\nghosts 3\nkey n\ntranslate 0 1 0\nkey n\nscreenshot alone.png\nscreenshot --overlays all.png\n\
                  select none\nkey a\nghosts 0\nscreenshot --overlays bare.png\n";
    sandbox.write("s.txt", script);
    done(&sandbox.run(&["script", "s.txt", "--size", "64x48"]));
    assert_ne!(bytes(&sandbox, "all.png"), bytes(&sandbox, "alone.png"));
    assert_eq!(bytes(&sandbox, "bare.png"), bytes(&sandbox, "alone.png"));
}

#[test]
fn a_screenshot_that_cannot_be_written_ends_the_script() {
    let sandbox = Sandbox::new();
    sandbox.write("a.txt", "screenshot no/such/x.png\nkey w\n");
    let outcome = sandbox.run(&["script", "a.txt", "--size", "8x8"]);
    assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""));
    assert!(outcome.stderr.contains("no/such/x.png: there is no such file or folder"), "{}", outcome.stderr);
    assert_eq!(sandbox.names(), ["a.txt"]);
}

#[test]
fn without_a_driver_the_variables_that_choose_it_are_named() {
    let sandbox = Sandbox::new();
    let mut command = sandbox.command(&["render", "-o", "x.png"]);
    command.env("VK_DRIVER_FILES", "/nonexistent.json").env("VK_ICD_FILENAMES", "old.json");
    let outcome = Sandbox::outcome(command);
    assert_eq!(outcome.status, 3);
    let variables = "these environment variables choose the driver: VK_DRIVER_FILES is \"/nonexistent.json\", \
                     VK_ICD_FILENAMES is \"old.json\"\n";
    assert!(outcome.stderr.starts_with("no GPU adapter was found"), "{}", outcome.stderr);
    assert!(outcome.stderr.ends_with(variables), "{}", outcome.stderr);
}

#[cfg(unix)]
mod with_a_driver_that_does_not_open {
    use std::os::unix::fs::PermissionsExt as _;
    use std::os::unix::process::CommandExt as _;

    use super::*;

    #[test]
    fn a_driver_that_hangs_is_given_up() {
        let sandbox = Sandbox::new();
        // Nobody writes to the pipe, and the loader waits for what describes the driver.
        assert!(std::process::Command::new("mkfifo").arg(sandbox.path("driver.json")).status().unwrap().success());
        let mut command = sandbox.command(&["render", "-o", "x.png"]);
        command.env("VK_DRIVER_FILES", "driver.json");
        let outcome = Sandbox::outcome(command);
        assert_eq!(outcome.status, 3);
        assert!(outcome.stderr.starts_with("the graphics driver does not answer"), "{}", outcome.stderr);
        assert!(outcome.stderr.ends_with("VK_DRIVER_FILES is \"driver.json\"\n"), "{}", outcome.stderr);
        assert_eq!(sandbox.names(), ["driver.json"]);
    }

    #[test]
    fn a_limit_of_threads_is_named() {
        /// Nobody who has other processes. The superuser has no such limit.
        const NOBODY: u32 = 4_123_456;
        let sandbox = Sandbox::new();
        std::fs::set_permissions(sandbox.path(""), std::fs::Permissions::from_mode(0o777)).unwrap();
        // The folder of the binary may be closed to others.
        std::fs::copy(env!("CARGO_BIN_EXE_inbetween"), sandbox.path("inbetween")).unwrap();
        let mut command = std::process::Command::new("bash");
        command.current_dir(sandbox.path("")).args(["-c", "ulimit -u 1; exec ./inbetween render -o x.png"]);
        if rustix::process::getuid().is_root() {
            command.uid(NOBODY).gid(NOBODY);
        }
        let output = command.output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(3), "{said}");
        assert!(said.starts_with("no thread can be started that drawing needs"), "{said}");
        assert_eq!(sandbox.names(), ["inbetween"]);
    }
}
