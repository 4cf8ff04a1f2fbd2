//! Every command has the same habits: `-`, `-o -`, several files, `--json`, `--quiet`, texts. A table says what each does, and all of it
//! is tried.

use std::collections::BTreeSet;

use inbetween::cli::command_reference;
use serde_json::{Deserializer, Value, json};

use crate::places::{Ran, run, sandbox};
use crate::sandbox::Sandbox;

/// What a command does with something, as a whole command line.
enum Cell {
    /// It ends well.
    Does(&'static str),
    /// It is wrong usage.
    Refuses(&'static str),
    /// There is nothing that it could do it with.
    None,
}

use Cell::{Does, None as Nothing, Refuses};

struct Row {
    command: &'static str,
    /// Reads `-`.
    standard_input: Cell,
    /// The file that is standard input.
    input: &'static str,
    /// Writes `-o -`.
    standard_output: Cell,
    several: Cell,
    json: Cell,
    quiet: Cell,
    text: Cell,
}

const ROWS: [Row; 21] = [
    Row {
        command: "check",
        standard_input: Does("check -"),
        input: "a.json",
        standard_output: Refuses("check a.json -o -"),
        several: Does("check a.json b.json"),
        json: Does("check a.json rows.txt --json"),
        quiet: Does("check a.json rows.txt --quiet"),
        text: Does("check rows.txt"),
    },
    Row {
        command: "convert",
        standard_input: Does("convert - -o out.json"),
        input: "rows.txt",
        standard_output: Does("convert a.json -o -"),
        several: Does("convert b.json rows.txt -o made"),
        json: Does("convert b.json rows.txt -o made --json"),
        quiet: Does("convert rows.txt -o out.json --quiet"),
        text: Does("convert rows.txt -o out.json"),
    },
    Row {
        command: "info",
        standard_input: Does("info -"),
        input: "a.json",
        standard_output: Refuses("info a.json -o -"),
        several: Does("info a.json b.json"),
        json: Does("info rows.txt --json"),
        quiet: Does("info rows.txt --quiet"),
        text: Does("info rows.txt"),
    },
    Row {
        command: "nodes",
        standard_input: Does("nodes --scene -"),
        input: "scene.json",
        standard_output: Refuses("nodes -o -"),
        several: Refuses("nodes a.json b.json"),
        json: Does("nodes --json"),
        quiet: Does("nodes --quiet"),
        text: Nothing,
    },
    Row {
        command: "sample",
        standard_input: Does("sample - --fps 2"),
        input: "rows.txt",
        standard_output: Does("sample a.json -o -"),
        several: Does("sample b.json rows.txt -o made --fps 2"),
        json: Does("sample rows.txt --json"),
        quiet: Does("sample rows.txt --quiet"),
        text: Does("sample rows.txt"),
    },
    Row {
        command: "render",
        standard_input: Does("render - -o out.png --size 16x12"),
        input: "rows.txt",
        standard_output: Does("render a.json -o - --format gif --fps 2 --size 16x12"),
        several: Refuses("render a.json b.json -o out.png"),
        json: Does("render rows.txt -o out.png --size 16x12 --json"),
        quiet: Does("render rows.txt -o out.png --size 16x12 --quiet"),
        text: Does("render rows.txt -o out.png --size 16x12"),
    },
    Row {
        command: "join",
        standard_input: Refuses("join - --fps 2 -o out.gif"),
        input: "a.png",
        standard_output: Does("join frames --fps 2 -o - --format gif"),
        several: Refuses("join frames frames --fps 2 -o out.gif"),
        json: Does("join frames --fps 2 -o out.gif --json"),
        quiet: Does("join frames --fps 2 -o out.gif --quiet"),
        text: Nothing,
    },
    Row {
        command: "import",
        standard_input: Does("import - -o out.json"),
        input: "robots.bvh",
        standard_output: Does("import robots.bvh -o -"),
        several: Refuses("import robots.bvh robots.bvh -o out.json"),
        json: Does("import robots.bvh -o out.json --json"),
        quiet: Does("import robots.bvh -o out.json --quiet"),
        text: Nothing,
    },
    Row {
        command: "export",
        standard_input: Does("export - -o out.bvh"),
        input: "rows.txt",
        standard_output: Does("export a.json -o - --format bvh"),
        several: Refuses("export a.json b.json -o out.bvh"),
        json: Does("export rows.txt -o out.bvh --json"),
        quiet: Does("export rows.txt -o out.bvh --quiet"),
        text: Does("export rows.txt -o out.bvh"),
    },
    Row {
        command: "retarget",
        standard_input: Does("retarget - --onto two-robots:robot1 -o out.json"),
        input: "robots.bvh",
        standard_output: Does("retarget robots.bvh --onto two-robots -o -"),
        several: Refuses("retarget a.json b.json --onto two-robots -o out.json"),
        json: Does("retarget a.json --onto two-robots:robot2 -o out.json --json"),
        quiet: Does("retarget rows.txt --onto two-robots:robot2 -o out.json --quiet"),
        text: Does("retarget rows.txt --onto two-robots:robot2 -o out.json"),
    },
    Row {
        command: "share",
        standard_input: Does("share - --page page -o out"),
        input: "a.json",
        standard_output: Refuses("share a.json --page page -o -"),
        several: Refuses("share a.json b.json --page page -o out"),
        json: Does("share a.json --page page -o out --json"),
        quiet: Does("share rows.txt --page page -o out --quiet"),
        text: Does("share rows.txt --page page -o out"),
    },
    Row {
        command: "verify",
        standard_input: Refuses("verify -"),
        input: "a.png",
        standard_output: Refuses("verify references -o -"),
        several: Refuses("verify references references"),
        json: Does("verify references --json"),
        quiet: Does("verify references --quiet"),
        text: Does("verify references"),
    },
    Row {
        command: "compare",
        standard_input: Does("compare - a.png"),
        input: "a.png",
        standard_output: Does("compare a.png a.png -o -"),
        several: Does("compare a.png a.png same.png -o made"),
        json: Does("compare a.png a.png same.png --json"),
        quiet: Does("compare a.png same.png --quiet"),
        text: Nothing,
    },
    Row {
        command: "script",
        standard_input: Does("script - --keyframes a.json"),
        input: "script.txt",
        standard_output: Does("script script.txt --keyframes a.json --state -"),
        several: Refuses("script script.txt script.txt"),
        json: Does("script script.txt --keyframes a.json --json"),
        quiet: Does("script script.txt --keyframes a.json --quiet"),
        text: Does("script script.txt --keyframes rows.txt"),
    },
    Row {
        command: "recover",
        standard_input: Refuses("recover -"),
        input: "a.journal",
        standard_output: Does("recover a.journal -o -"),
        several: Refuses("recover a.journal a.journal"),
        json: Does("recover a.journal -o out.json --json"),
        quiet: Does("recover a.journal -o out.json --quiet"),
        text: Nothing,
    },
    Row {
        command: "diagnose",
        standard_input: Does("diagnose a.json -"),
        input: "s.csv",
        standard_output: Refuses("diagnose a.json s.csv -o -"),
        several: Refuses("diagnose a.json s.csv s.csv"),
        json: Does("diagnose rows.txt s.csv --json"),
        quiet: Does("diagnose rows.txt s.csv --quiet"),
        text: Does("diagnose rows.txt s.csv"),
    },
    Row {
        command: "diff",
        standard_input: Does("diff a.json -"),
        input: "rows.txt",
        standard_output: Refuses("diff a.json rows.txt -o -"),
        several: Does("diff a.json rows.txt a.json"),
        json: Does("diff a.json rows.txt a.json --json"),
        quiet: Does("diff a.json rows.txt a.json --quiet"),
        text: Does("diff a.json rows.txt"),
    },
    Row {
        command: "grade",
        standard_input: Does("grade rubric.json - -o graded --no-images"),
        input: "rows.txt",
        standard_output: Refuses("grade rubric.json a.json -o - --no-images"),
        several: Does("grade rubric.json b.json rows.txt -o graded --no-images"),
        json: Does("grade rubric.json b.json rows.txt -o graded --no-images --json"),
        quiet: Does("grade rubric.json b.json -o graded --no-images --quiet"),
        text: Does("grade rubric.json rows.txt -o graded --no-images"),
    },
    Row {
        command: "completions",
        standard_input: Refuses("completions -"),
        input: "a.json",
        standard_output: Refuses("completions bash -o -"),
        several: Refuses("completions bash zsh"),
        json: Nothing,
        quiet: Does("completions zsh --quiet"),
        text: Nothing,
    },
    Row {
        command: "man",
        standard_input: Refuses("man -"),
        input: "a.json",
        standard_output: Refuses("man pages -o -"),
        several: Refuses("man pages more"),
        json: Nothing,
        quiet: Does("man pages --quiet"),
        text: Nothing,
    },
    Row {
        command: "help",
        standard_input: Refuses("help -"),
        input: "a.json",
        standard_output: Refuses("help check -o -"),
        several: Refuses("help check render"),
        json: Nothing,
        quiet: Does("help grading --quiet"),
        text: Nothing,
    },
];

/// A folder with a file of every kind that is read.
fn prepared() -> Sandbox {
    let sandbox = sandbox();
    std::fs::copy(sandbox.path("a.png"), sandbox.path("same.png")).unwrap();
    std::fs::create_dir(sandbox.path("references")).unwrap();
    std::fs::copy(sandbox.path("rows.txt"), sandbox.path("references/rows.txt")).unwrap();
    std::fs::create_dir(sandbox.path("page")).unwrap();
    sandbox.write("page/index.html", "<!-- shown -->");
    sandbox.write("page/inbetween_bg.wasm", "");
    let shots = json!([{"name": "start", "file": "rows.txt", "size": [16, 12]}]);
    let list = json!({"format": "inbetween.pictures", "version": 1, "pictures": shots});
    sandbox.write("references/pictures.json", list.to_string());
    sandbox.run(&["verify", "references", "--update"]).succeeds();
    sandbox.run(&["export", "a.json", "-o", "robots.bvh", "--fps", "10"]).succeeds();
    sandbox.run(&["render", "a.json", "-o", "frames/", "--fps", "2", "--size", "16x12"]).succeeds();
    sandbox
}

fn run_line(sandbox: &Sandbox, line: &str, input: Option<&str>) -> Ran {
    run(sandbox, &line.split(' ').collect::<Vec<_>>(), input)
}

/// What the cell says is so.
#[track_caller]
fn try_cell(sandbox: &Sandbox, cell: &Cell, input: Option<&str>) -> Option<Ran> {
    match cell {
        Does(line) => {
            let ran = run_line(sandbox, line, input);
            assert_eq!(ran.status, Some(0), "{line}: {}", ran.stderr);
            Some(ran)
        }
        Refuses(line) => {
            let ran = run_line(sandbox, line, input);
            assert_eq!((ran.status, ran.stdout.is_empty()), (Some(2), true), "{line}: {}", ran.stderr);
            let usage = format!("Usage: inbetween {}", line.split(' ').next().unwrap());
            // clap shows no usage where a value is none of those that are possible.
            assert!(ran.stderr.contains(&usage) || ran.stderr.contains("invalid value"), "{line}: {}", ran.stderr);
            None
        }
        Nothing => None,
    }
}

fn lines(bytes: &[u8]) -> usize {
    String::from_utf8_lossy(bytes).lines().count()
}

#[test]
fn every_command_has_the_same_habits() {
    let reference = command_reference();
    let commands: BTreeSet<&str> = reference.lines().filter_map(|line| line.strip_prefix("### inbetween ")).collect();
    let rows: BTreeSet<&str> = ROWS.iter().map(|row| row.command).collect();
    assert_eq!(rows, commands, "a row for each command");
    let sandbox = prepared();
    for row in &ROWS {
        try_cell(&sandbox, &row.standard_input, Some(row.input));
        if let Some(ran) = try_cell(&sandbox, &row.standard_output, None) {
            assert!(!ran.stdout.is_empty(), "{}: nothing on standard output", row.command);
        }
        try_cell(&sandbox, &row.several, None);
        if let Some(ran) = try_cell(&sandbox, &row.json, None) {
            let values: Vec<Value> =
                Deserializer::from_slice(&ran.stdout).into_iter().collect::<Result<_, _>>().unwrap();
            assert!(!values.is_empty(), "{}: no JSON", row.command);
        }
        if let Some(quiet) = try_cell(&sandbox, &row.quiet, None) {
            let Does(line) = row.quiet else { unreachable!() };
            let loud = run_line(&sandbox, &line.replace(" --quiet", ""), None);
            assert_eq!(quiet.stderr, "", "{line}");
            assert!(lines(&quiet.stdout) <= lines(&loud.stdout), "{line}");
        }
        if let Some(ran) = try_cell(&sandbox, &row.text, None) {
            let Does(line) = row.text else { unreachable!() };
            let says = String::from_utf8_lossy(&ran.stdout).into_owned() + &ran.stderr;
            // Those that grade or draw many files have it in their results.
            let is_told = says.contains("layout rows") || matches!(row.command, "grade" | "verify" | "script");
            assert!(is_told, "{line}: {says}");
        }
    }
}
