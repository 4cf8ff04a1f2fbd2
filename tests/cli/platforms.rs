//! The recipes of `assets/grading`, run as the course systems would run them, with the built program in the place of the installed one.

use std::io::Read as _;
use std::os::unix::fs::{PermissionsExt as _, symlink};
use std::path::Path;
use std::process::Command;

use serde_json::json;
use zip::write::SimpleFileOptions;

use crate::grade::{course, text_of, zipped};
use crate::results::cells;
use crate::sandbox::{Outcome, Sandbox};

const PROGRAM: &str = env!("CARGO_BIN_EXE_inbetween");

fn asset(name: &str) -> Vec<u8> {
    std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/grading").join(name)).unwrap()
}

/// Runs a command that succeeds.
#[track_caller]
fn succeeds(command: &mut Command) -> String {
    let output = command.output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    let (stdout, stderr) = (text(output.stdout), text(output.stderr));
    assert!(output.status.success(), "{stdout}{stderr}");
    stdout
}

/// Puts the rubric of the example with the files that it names into a folder.
fn write_rubric(sandbox: &Sandbox, folder: &str) {
    for name in ["rubric.toml", "reference.json", "hotkeys.txt"] {
        sandbox.write(&format!("{folder}/{name}"), asset(name));
    }
    symlink(PROGRAM, sandbox.path(&format!("{folder}/inbetween"))).unwrap();
}

#[test]
fn a_gradescope_autograder_writes_results() {
    let sandbox = Sandbox::new();
    // The zip as a teacher makes it; the program is too large to be packed in a test, and is put beside afterwards.
    let mut writer = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let members = ["gradescope/setup.sh", "gradescope/run_autograder", "rubric.toml", "reference.json", "hotkeys.txt"];
    for name in members {
        let plain = name.rsplit('/').next().unwrap();
        writer.start_file(plain, SimpleFileOptions::default()).unwrap();
        std::io::Write::write_all(&mut writer, &asset(name)).unwrap();
    }
    let bytes = writer.finish().unwrap().into_inner();
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(bytes)).unwrap();
    for index in 0..archive.len() {
        let mut member = archive.by_index(index).unwrap();
        let mut bytes = Vec::new();
        member.read_to_end(&mut bytes).unwrap();
        sandbox.write(&format!("autograder/source/{}", member.name().unwrap()), bytes);
    }
    std::fs::copy(PROGRAM, sandbox.path("autograder/source/inbetween")).unwrap();
    let said = succeeds(Command::new("bash").arg(sandbox.path("autograder/source/setup.sh")));
    assert!(said.starts_with("inbetween "), "{said}");

    // The platform copies run_autograder out of the source, and makes it executable.
    let runner = sandbox.path("autograder/run_autograder");
    std::fs::copy(sandbox.path("autograder/source/run_autograder"), &runner).unwrap();
    std::fs::set_permissions(&runner, std::fs::Permissions::from_mode(0o755)).unwrap();
    let run = || {
        let mut command = Command::new(&runner);
        succeeds(command.env("AUTOGRADER_ROOT", sandbox.path("autograder")).current_dir("/"));
        sandbox.json("autograder/results/results.json")
    };
    sandbox.write("autograder/submission/animation.json", asset("reference.json"));
    let right = run();
    assert_eq!((&right["score"], &right["tests"][0]["status"]), (&json!(55.0), &json!("passed")));
    sandbox.write("autograder/submission/animation.json", "{");
    let unreadable = run();
    assert_eq!((&unreadable["score"], &unreadable["tests"][0]["status"]), (&json!(0.0), &json!("failed")));
    assert_eq!(right["tests"].as_array().unwrap().len(), unreadable["tests"].as_array().unwrap().len());
}

#[test]
fn a_classroom_50_autograder_writes_its_result() {
    let sandbox = Sandbox::new();
    write_rubric(&sandbox, "autograder");
    sandbox.write("autograder/autograder.py", asset("classroom50/autograder.py"));
    sandbox.write("checkout/animation.json", asset("reference.json"));
    sandbox.write("checkout/.git/HEAD", "ref: refs/heads/main\n");
    sandbox.write("checkout/README.md", "# Assignment\n");
    let variables = [
        ("CLASSROOM", "cs-6"),
        ("ASSIGNMENT", "keyframes"),
        ("OWNER", "ann"),
        ("SUBMISSION_TAG", "submit/2026-06-01T14-32-05Z-a1b2c3d"),
        ("COMMIT_URL", "https://example.org/commit/a1"),
        ("RELEASE_URL", "https://example.org/releases/1"),
    ];
    let script = sandbox.path("autograder/autograder.py");
    let mut command = Command::new("python3");
    command.arg(&script).envs(variables).current_dir(sandbox.path("checkout"));
    for name in ["REVIEW_URL", "ASSIGNMENT_TYPE", "MODE", "GITHUB_ACTOR"] {
        command.env_remove(name);
    }
    succeeds(&mut command);
    let result = sandbox.json("checkout/result.json");
    let tests = result["tests"].as_array().unwrap().clone();
    let sum = |field: &str| tests.iter().map(|test| test[field].as_u64().expect("a whole number")).sum::<u64>();
    assert_eq!((sum("score"), sum("max-score"), tests.len()), (55, 100, 13));
    let expected = json!({
        "schema": "classroom50/result/v1", "classroom": "cs-6", "assignment": "keyframes",
        "assignment_type": "individual", "owner": "ann", "submission": "submit/2026-06-01T14-32-05Z-a1b2c3d",
        "commit": "https://example.org/commit/a1", "release": "https://example.org/releases/1",
        "review": "https://example.org/commit/a1", "datetime": "2026-06-01T14:32:05Z",
        "score": 55, "max-score": 100, "tests": tests,
    });
    assert_eq!(result, expected);
    // Without the variables of the runner there is no result, and the run fails.
    std::fs::remove_file(sandbox.path("checkout/result.json")).unwrap();
    let mut command = Command::new("python3");
    command.arg(&script).current_dir(sandbox.path("checkout")).env_remove("CLASSROOM");
    assert!(!command.output().unwrap().status.success());
    assert!(!sandbox.path("checkout/result.json").exists());
}

#[test]
fn moodle_gets_a_worksheet_that_it_imports() {
    let (sandbox, made) = course();
    let right = text_of(&made, "linear");
    let members = [
        ("Ann Kim_7_assignsubmission_file_/a.json", right.as_bytes()),
        ("Bob Lee_8_assignsubmission_file_/b.json", b"{"),
    ];
    sandbox.write("submissions.zip", zipped(&members));
    sandbox.write(
        "worksheet.csv",
        "\u{feff}Identifier,\"Full name\",\"Email address\",Status,Grade,\"Maximum Grade\",\"Last modified (grade)\",\"Feedback comments\"\n\
         \"Participant 7\",\"Ann Kim\",a@b.c,Submitted,,26,-,\n\"Participant 8\",\"Bob Lee\",b@b.c,Submitted,,26,-,\n\
         \"Participant 9\",\"Cem Roh\",c@b.c,\"No submission\",,26,-,\n",
    );
    sandbox.write("grade.sh", asset("moodle/grade.sh"));
    let mut command = Command::new("bash");
    command.arg("grade.sh").args(["rubric.json", "submissions.zip", "worksheet.csv", "out"]);
    let said = succeeds(command.env("INBETWEEN", PROGRAM).current_dir(sandbox.path("")));
    assert!(
        said.contains("nothing handed in: Cem Roh\n") && said.ends_with("out/moodle.csv as the grading worksheet.\n"),
        "{said}"
    );

    // As Moodle reads it: it looks for three columns by name, and takes the number after the word.
    let table = sandbox.read("out/moodle.csv");
    let rows = cells(table.strip_prefix('\u{feff}').unwrap());
    let column = |name: &str| rows[0].iter().position(|column| column == name).expect(name);
    let (id, grade, modified) = (column("Identifier"), column("Grade"), column("Last modified (grade)"));
    let imported: Vec<(&str, f64)> = rows[1..]
        .iter()
        .map(|row| (row[id].strip_prefix("Participant ").unwrap(), row[grade].parse().unwrap()))
        .collect();
    assert_eq!(imported, [("7", 26.0), ("8", 0.0), ("9", 0.0)]);
    assert!(rows[1..].iter().all(|row| row[modified] == "-" && !row[column("Feedback comments")].is_empty()));
    let usage = Sandbox::outcome_of(Command::new("bash").arg(sandbox.path("grade.sh")));
    assert_eq!((usage.status, usage.stderr.starts_with("usage: ")), (2, true));
}

impl Sandbox {
    /// What another program's run left.
    fn outcome_of(command: &mut Command) -> Outcome {
        let output = command.output().unwrap();
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        Outcome { status: output.status.code().unwrap(), stdout: text(output.stdout), stderr: text(output.stderr) }
    }
}
