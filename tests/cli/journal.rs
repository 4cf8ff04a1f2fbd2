use std::process::Stdio;

use crate::sandbox::{Sandbox, keyframe_file};

const SCRIPT: &str = "key i\nselect robot1/head\ntranslate 1 0 0\nkey n\nput-control robot1\nundo\nput-control robot2\n\
                      drag begin\ndrag move 0 1 0\ndrag end\nkey n\nwait 700ms\nrename 0 the #1\nkey w\n";

#[test]
fn a_journal_of_a_script_makes_the_same_and_writes_no_file() {
    let sandbox = Sandbox::new();
    sandbox.write("animation.json", keyframe_file(5).to_string());
    sandbox.write("a.txt", SCRIPT);
    let outcome = sandbox.run(&["script", "a.txt", "--journal", "a.journal", "--state", "a.state"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    let written = sandbox.read("animation.json");
    // The journal needs none of the files.
    std::fs::remove_file(sandbox.path("animation.json")).unwrap();
    let before = sandbox.names();
    let outcome = sandbox.run(&["--scene", "orbits", "script", "a.journal"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    assert_eq!(sandbox.names(), before);
    let outcome = sandbox.run(&["script", "a.journal", "--state", "b.state", "--journal", "b.journal"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    assert_eq!(sandbox.read("a.state"), sandbox.read("b.state"));
    // Also the journal of a journal.
    let outcome = sandbox.run(&["script", "b.journal", "--state", "c.state"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    assert_eq!(sandbox.read("a.state"), sandbox.read("c.state"));
    let recovered = sandbox.run(&["recover", "a.journal", "-o", "c.json"]);
    assert_eq!((recovered.status, recovered.stderr.as_str()), (0, ""));
    assert_eq!(sandbox.read("c.json"), written);
}

#[test]
fn a_journal_is_not_written_over_what_is_none() {
    let sandbox = Sandbox::new();
    sandbox.write("precious.json", "{}");
    sandbox.write("a.txt", "key n\n");
    let outcome = sandbox.run(&["script", "a.txt", "--journal", "precious.json"]);
    outcome.refuses("precious.json: something else stands there, and is not written over");
    assert_eq!(sandbox.read("precious.json"), "{}");
}

#[test]
fn a_damaged_journal_is_read_as_far_as_it_is_whole_and_says_so() {
    let sandbox = Sandbox::new();
    sandbox.write("a.txt", "key n\nkey n\n");
    assert_eq!(sandbox.run(&["script", "a.txt", "--journal", "a.journal"]).status, 0);
    let text = sandbox.read("a.journal").replace("# quit\n", "go x\nkey n\n");
    sandbox.write("a.journal", &text);
    let number = text.lines().count() - 1;
    let sentence =
        format!("line {number}: \"x\" is not a keyframe; expected a whole number from 0; what comes after it is lost");
    let outcome = sandbox.run(&["script", "a.journal", "--state", "a.state"]);
    assert_eq!((outcome.status, outcome.stderr.trim_end()), (1, format!("a.journal: {sentence}").as_str()));
    assert_eq!(sandbox.json("a.state")["keyframes"], 2);
    let outcome = sandbox.run(&["recover", "a.journal", "-o", "out.json"]);
    assert_eq!((outcome.status, outcome.stderr.trim_end()), (0, format!("a.journal: {sentence}").as_str()));
    assert_eq!(sandbox.json("out.json")["keyframes"].as_array().unwrap().len(), 2);
}

#[test]
fn a_panic_ends_a_script_with_101_and_its_line_is_passed_over() {
    let sandbox = Sandbox::new();
    sandbox.write("a.txt", "key n\nkey n\nkey n\n");
    let outcome = sandbox.run(&["script", "a.txt", "--journal", "a.journal", "--panic-at", "3"]);
    assert_eq!(outcome.status, 101);
    assert!(sandbox.read("a.journal").ends_with("\n# panicked\n"), "{}", sandbox.read("a.journal"));
    let outcome = sandbox.run(&["recover", "a.journal", "-o", "out.json"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, "a.journal: passed over 1 line\n"));
    assert_eq!(sandbox.json("out.json")["keyframes"].as_array().unwrap().len(), 2);
}

#[test]
fn journals_are_listed_and_recovered_once() {
    let sandbox = Sandbox::new();
    let within = |arguments: &[&str]| {
        let mut command = sandbox.command(arguments);
        command.env("XDG_STATE_HOME", sandbox.path("state"));
        Sandbox::outcome(command)
    };
    assert_eq!(within(&["recover", "--list"]).stdout, "");
    let outcome = within(&["recover"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (1, "recover: nothing is left to recover\n"));
    std::fs::create_dir_all(sandbox.path("state/inbetween")).unwrap();
    sandbox.write("a.txt", "key n\nkey n\n");
    let path = "state/inbetween/1.journal";
    assert_eq!(within(&["script", "a.txt", "--keyframes", "walk.json", "--journal", path]).status, 0);
    assert_eq!(within(&["recover", "--list"]).stdout, "", "who ended well is not listed");
    sandbox.write(path, sandbox.read(path).replace("# quit\n", ""));
    let listed = within(&["recover", "--list"]).stdout;
    assert!(listed.contains("1.journal: ") && listed.contains("walk.json, 2 commands, begun"), "{listed}");
    let outcome = within(&["recover"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    assert_eq!(sandbox.json("walk.recovered.json")["keyframes"].as_array().unwrap().len(), 2);
    assert_eq!(within(&["recover", "--list"]).stdout, "");
}

#[test]
fn what_a_killed_script_wrote_down_is_recovered() {
    use std::io::Write as _;
    let sandbox = Sandbox::new();
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_inbetween"))
        .current_dir(sandbox.path(""))
        .args(["script", "-", "--journal", "a.journal"])
        .stdin(Stdio::piped())
        .spawn()
        .unwrap();
    let mut script = String::from("key n\n");
    for _ in 0..200_000 {
        script.push_str("key n\nundo\n");
    }
    let mut input = child.stdin.take().unwrap();
    input.write_all(script.as_bytes()).unwrap();
    drop(input);
    let lines = || std::fs::read(sandbox.path("a.journal")).map_or(0, |text| text.split(|&byte| byte == b'\n').count());
    while lines() < 100 {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let outcome = sandbox.run(&["recover", "a.journal", "-o", "out.json"]);
    assert_eq!(outcome.status, 0, "{}", outcome.stderr);
    let count = sandbox.json("out.json")["keyframes"].as_array().unwrap().len();
    assert!((1..=2).contains(&count), "{count}");
}

#[test]
fn at_its_bound_a_scripts_journal_begins_anew_with_a_snapshot() {
    let sandbox = Sandbox::new();
    // Four times 5 MiB.
    let mut file = keyframe_file(5);
    let pose = file["keyframes"][1].clone();
    let count = (5 << 20) / pose.to_string().len();
    file["keyframes"] = vec![pose; count].into();
    sandbox.write("animation.json", file.to_string());
    sandbox.write("a.txt", "key i\nkey i\nkey i\nkey i\nkey n\nkey n\n");
    let outcome = sandbox.run(&["script", "a.txt", "--journal", "a.journal", "--state", "a.state"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    assert_eq!(sandbox.names(), ["a.journal", "a.state", "a.txt", "animation.json"]);
    let text = sandbox.read("a.journal");
    assert!((text.len() as u64) < inbetween::journal::LARGEST_JOURNAL_BYTES, "{}", text.len());
    assert!(text.contains("\nsnapshot "));
    let outcome = sandbox.run(&["script", "a.journal", "--state", "b.state"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    assert_eq!(sandbox.read("a.state"), sandbox.read("b.state"));
}

#[cfg(unix)]
#[test]
fn a_script_whose_journal_cannot_be_written_says_so_at_its_end() {
    let sandbox = Sandbox::new();
    sandbox.write("a.txt", format!("{}key w\n", "key n\nundo\n".repeat(2000)));
    // No file may grow beyond 8 KiB, as on a full disk.
    let outcome = std::process::Command::new("sh")
        .current_dir(sandbox.path(""))
        .args(["-c", "trap '' XFSZ; ulimit -f 16; exec \"$0\" script a.txt --journal a.journal"])
        .arg(env!("CARGO_BIN_EXE_inbetween"))
        .output()
        .unwrap();
    assert_eq!(outcome.status.code(), Some(1));
    assert_eq!(String::from_utf8_lossy(&outcome.stderr), "a.journal: File too large\n");
    // The script went on, and its journal is read as far as it is whole.
    assert!(sandbox.path("animation.json").is_file());
    assert_eq!(sandbox.read("a.journal").len(), 8 << 10);
    assert_eq!(sandbox.run(&["recover", "a.journal", "-o", "out.json"]).status, 0);
}
