use crate::sandbox::{Outcome, Sandbox, keyframe_file};

#[test]
fn wrong_usage_is_status_2() {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(4).to_string());
    for arguments in [
        &["check"][..],
        &["sample", "--at", "0"],
        &["sample", "--fps", "10"],
        &["sample", "a.json", "--at", "one"],
        &["sample", "a.json", "--at", "1,,2"],
        &["sample", "a.json", "--at", "0", "--fps", "10"],
        &["sample", "a.json", "--fps", "0"],
        &["sample", "a.json", "--fps", "1001"],
        &["sample", "a.json", "--fps", "2.5"],
        &["sample", "a.json", "--format", "xml"],
        &["sample", "a.json", "--interpolation", "cubic"],
        &["render"],
        &["render", "-o", "x.png", "--at", "0"],
        &["render", "-o", "x.png", "--keyframe", "0"],
        &["render", "a.json", "-o", "x.png", "--at", "0", "--keyframe", "0"],
        &["render", "a.json", "-o", "x.png", "--at", "0,1"],
        &["render", "a.json", "-o", "x.png", "--size", "640"],
        &["render", "a.json", "-o", "x.png", "--size", "0x480"],
        &["render", "a.json", "-o", "x.png", "--samples", "2"],
        &["render", "a.json", "-o", "x.png", "--sheet", "32x32", "--size", "4000x4000"],
        &["render", "a.json", "-o", "x.png", "--fps", "2"],
        &["script"],
        &["script", "-", "--size", "640x"],
        &["a.json", "nodes"],
        &["nodes", "extra"],
        &["nodes", "--unknown"],
    ] {
        println!("{arguments:?}");
        sandbox.run(arguments).misuses();
    }
    assert_eq!(sandbox.names(), ["a.json"]);
}

#[test]
fn a_mistyped_command_is_wrong_usage_with_a_suggestion() {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(4).to_string());
    let similar = "a similar subcommand exists: 'check'";
    let file = "to open the window on a new keyframe file, give its name an ending: 'nosuch.json'";
    for (arguments, suggestion) in [
        (&["chekc"][..], similar),
        (&["chekc", "a.json"], similar),
        (&["--scene", "cylinder", "chekc", "a.json"], similar),
        (&["chekc", "--fps", "10"], similar),
        (&["nosuch"], file),
        (&["nosuch", "--scene", "cylinder"], file),
    ] {
        let outcome = sandbox.run(arguments);
        assert!(outcome.stderr.contains(suggestion), "{arguments:?}: {}", outcome.stderr);
        outcome.misuses();
    }
    // Where the command is right, what is wrong is said of the rest.
    let outcome = sandbox.run(&["check", "a.json", "--ftp"]);
    assert!(outcome.stderr.contains("unexpected argument '--ftp'"), "{}", outcome.stderr);
    outcome.misuses();
}

#[test]
fn help_and_version_are_no_errors() {
    let sandbox = Sandbox::new();
    assert!(sandbox.run(&["--version"]).succeeds().starts_with("inbetween "));
    for command in [&["--help"][..], &["check", "--help"], &["sample", "--help"], &["render", "--help"]] {
        assert!(sandbox.run(command).succeeds().contains("Usage: inbetween"));
    }
    // The help of scripts has every line that a script can have.
    let help = sandbox.run(&["script", "--help"]).succeeds();
    let table = inbetween::script::markdown();
    let usages: Vec<String> = table
        .lines()
        .filter_map(|row| Some(row.strip_prefix("| `")?.split_once("` |")?.0.replace("\\|", "|")))
        .collect();
    assert!(usages.len() > 50);
    for usage in usages {
        assert!(help.lines().any(|line| line.trim() == usage), "{usage} is not in the help");
    }
}

#[test]
fn nodes_are_the_twenty_two() {
    let stdout = Sandbox::new().run(&["nodes"]).succeeds();
    let paths: Vec<&str> = stdout.lines().collect();
    assert_eq!(paths.len(), 22);
    assert_eq!(paths[..4], ["sky", "ground", "robot1", "robot1/right_shoulder"]);
    assert_eq!(paths[11..13], ["robot1/head", "robot2"]);
    assert_eq!(paths[21], "robot2/head");
}

#[cfg(target_os = "linux")]
#[test]
fn without_a_display_the_window_is_status_3() {
    let sandbox = Sandbox::new();
    for name in ["a.json", "animation"] {
        sandbox.write(name, keyframe_file(4).to_string());
    }
    for arguments in [&[][..], &["a.json"], &["none.json"], &["animation"], &["./none"], &["none/"]] {
        let mut command = sandbox.command(arguments);
        for variable in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
            command.env_remove(variable);
        }
        let outcome = Sandbox::outcome(command);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (3, ""));
        assert!(outcome.stderr.contains("apt-get install"), "{}", outcome.stderr);
    }
}

const ONE_NODE: &str =
    r#"{"format": "inbetween.scene", "version": 1, "name": "one", "eyes": ["eye"], "nodes": [{"name": "eye"}]}"#;

#[test]
fn a_scene_is_a_built_in_name_or_else_a_file() {
    let sandbox = Sandbox::new();
    sandbox.write("one.json", ONE_NODE);
    sandbox.write("two-robots", ONE_NODE);
    assert_eq!(sandbox.run(&["nodes", "--scene", "one.json"]).succeeds(), "eye\n");
    assert_eq!(sandbox.run(&["--scene", "one.json", "nodes"]).succeeds(), "eye\n");
    assert_eq!(sandbox.run(&["nodes", "--scene", "two-robots"]).succeeds().lines().count(), 22);
    assert_eq!(sandbox.run(&["nodes", "--scene", "./two-robots"]).succeeds(), "eye\n");
}

#[test]
fn a_bad_scene_is_bad_input_in_every_command() {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(4).to_string());
    sandbox.write("script.txt", "key n\n");
    sandbox.write("bad.json", ONE_NODE.replace("\"eye\"}", "\"ear\"}"));
    let commands: [&[&str]; 4] = [&["check", "a.json"], &["nodes"], &["sample"], &["script", "script.txt"]];
    for command in commands {
        let scene = |name: &'static str| [command, &["--scene", name][..]].concat();
        sandbox.run(&scene("none-such")).refuses(
            "none-such: neither a built-in scene (two-robots, cylinder, orbits) nor a file that can be read: there is no such file or folder",
        );
        sandbox.run(&scene("bad.json")).refuses("bad.json: eye \"eye\" is not the path of an RBT node");
    }
}

#[cfg(unix)]
#[test]
fn a_reader_that_leaves_is_no_error() {
    use std::process::{Command, Stdio};
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(40).to_string());
    sandbox.write("script.txt", "key n\n".repeat(2000) + "key w\n");
    let commands: [&[&str]; 3] = [
        &["nodes"],
        &["sample", "a.json", "--fps", "60"],
        &["script", "script.txt", "--trace", "--keyframes", "w.json"],
    ];
    for arguments in commands {
        let mut command = Command::new(env!("CARGO_BIN_EXE_inbetween"));
        command.args(arguments).current_dir(sandbox.path("")).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]), "{arguments:?}");
    }
    assert!(sandbox.path("w.json").exists(), "the script went on without its reader");
}

#[test]
fn what_files_and_arguments_hold_does_nothing_to_a_terminal() {
    const RED: &str = "\u{1b}[31m";
    let sandbox = Sandbox::new();
    let name = format!("a{RED}.json");
    sandbox.write(&name, keyframe_file(4).to_string());
    sandbox.write("field.json", keyframe_file(4).to_string().replacen('{', "{\"\\u001b[31m\": 1, ", 1));
    sandbox.write("script.txt", format!("jump{RED}\n"));
    std::fs::create_dir(sandbox.path("dir")).unwrap();
    let list = r#"{"format": "inbetween.pictures", "version": 1, "pictures": [{"name": "a\u001b[31m", "samples": 3}]}"#;
    sandbox.write("dir/pictures.json", list);
    let scene = r#"{"format": "inbetween.scene", "version": 1, "name": "a", "eyes": ["\u001b[31m"], "nodes": []}"#;
    sandbox.write("scene.json", scene);
    for arguments in [
        &["check", &name][..],
        &["check", "field.json"],
        &["check", &format!("missing{RED}")],
        &["script", "script.txt"],
        &["verify", "dir"],
        &["nodes", "--scene", "scene.json"],
        &["diff", "field.json", &name],
        &["compare", &name, &name],
        &["render", &name, "-o", "x.png", "--at", "99"],
        &["convert", &name, "-o", "b.json"],
        &["nodes", &format!("extra{RED}")],
        &["sample", &format!("--{RED}")],
    ] {
        let Outcome { stdout, stderr, .. } = sandbox.run(arguments);
        assert!(!format!("{stdout}{stderr}").contains('\u{1b}'), "{arguments:?}: {stdout}{stderr}");
        // What is wrong usage is quoted without its escapes.
        let is_usage = stderr.contains("Usage:");
        assert!(is_usage || format!("{stdout}{stderr}").contains("\\u{1b}"), "{arguments:?}: {stdout}{stderr}");
    }
}
