//! The composite action `assets/ci/action.yml`: its steps are run in a made repository as GitHub's runner would run them.
//!
//! A step of its own shell is run by `bash -eo pipefail`; steps that use other actions are only named. A program in the place of `cargo`
//! writes down what it is asked for.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::os::unix::fs::PermissionsExt as _;
use std::process::Command;

use saphyr::{LoadableYamlNode as _, Yaml};
use serde_json::json;

use crate::sandbox::{Sandbox, keyframe_file};

const ACTION: &str = include_str!("../../assets/ci/action.yml");

/// What the steps of a run did: their names, with the exit statuses of those with a script.
#[derive(Debug, Default)]
struct Ran {
    steps: Vec<(String, Option<i32>)>,
    said: String,
}

impl Ran {
    fn names(&self) -> Vec<&str> {
        self.steps.iter().map(|(name, _)| name.as_str()).collect()
    }

    fn status_of(&self, name: &str) -> Option<i32> {
        self.steps.iter().find(|(step, _)| step == name).and_then(|(_, status)| *status)
    }
}

/// The values that expressions name, such as `inputs.directory`.
type Values = BTreeMap<String, String>;

/// A text with its `${{ … }}` replaced. A name without a value is empty, as for GitHub.
fn with_values(text: &str, values: &Values) -> String {
    let mut pieces = text.split("${{");
    let first = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(first, |text, piece| {
        let (name, rest) = piece.split_once("}}").expect("an expression ends");
        text + values.get(name.trim()).map_or("", String::as_str) + rest
    })
}

/// Whether a step's condition holds: comparisons with texts, and whether a step has failed, joined by `&&`.
fn holds(condition: Option<&str>, values: &Values, has_failed: bool) -> bool {
    let Some(condition) = condition else { return !has_failed };
    let value = |name: &str| values.get(name).cloned().unwrap_or_default();
    let holds = |part: &str| match part.split_once(" == ").or_else(|| part.split_once(" != ")) {
        Some((name, text)) => (value(name) == text.trim_matches('\'')) == part.contains(" == "),
        None => part == "failure()" && has_failed,
    };
    (!has_failed || condition.contains("failure()")) && condition.split(" && ").all(holds)
}

/// Runs the action's steps in a repository's folder.
fn run(sandbox: &Sandbox, inputs: &[(&str, &str)]) -> Ran {
    let documents = Yaml::load_from_str(ACTION).unwrap();
    let action = &documents[0];
    let mut values = Values::new();
    for (name, input) in action["inputs"].as_mapping().unwrap() {
        let default = input.as_mapping_get("default").and_then(|default| default.as_str()).unwrap_or_default();
        values.insert(format!("inputs.{}", name.as_str().unwrap()), default.to_owned());
    }
    for (name, value) in inputs {
        assert!(values.insert(format!("inputs.{name}"), (*value).to_owned()).is_some(), "there is no input {name}");
    }
    values.insert("runner.temp".to_owned(), sandbox.path("temp").display().to_string());
    let mut ran = Ran::default();
    for step in action["runs"]["steps"].as_sequence().unwrap() {
        let text = |name: &str| step.as_mapping_get(name).and_then(|value| value.as_str());
        let name = text("name").unwrap().to_owned();
        let has_failed = ran.steps.iter().any(|(_, status)| status.is_some_and(|status| status != 0));
        if !holds(text("if"), &values, has_failed) {
            continue;
        }
        let Some(script) = text("run") else {
            assert!(text("uses").unwrap().starts_with("actions/"), "{name}");
            ran.steps.push((name, None));
            continue;
        };
        assert_eq!(text("shell"), Some("bash"), "{name}");
        sandbox.write("output", "");
        let mut command = Command::new("bash");
        command
            .args(["--noprofile", "--norc", "-eo", "pipefail", "-c", script])
            .current_dir(sandbox.path("repository"));
        let path = format!("{}:{}", sandbox.path("bin").display(), std::env::var("PATH").unwrap());
        command.env("PATH", path).env("GITHUB_OUTPUT", sandbox.path("output")).env("GITHUB_ACTIONS", "true");
        command.env_remove("GITHUB_STEP_SUMMARY");
        for (variable, value) in step.as_mapping_get("env").and_then(|env| env.as_mapping()).into_iter().flatten() {
            command.env(variable.as_str().unwrap(), with_values(value.as_str().unwrap(), &values));
        }
        let done = command.output().unwrap();
        ran.said += &String::from_utf8_lossy(&done.stdout);
        ran.said += &String::from_utf8_lossy(&done.stderr);
        if let Some(id) = text("id") {
            for line in sandbox.read("output").lines() {
                let (name, value) = line.split_once('=').unwrap();
                values.insert(format!("steps.{id}.outputs.{name}"), value.to_owned());
            }
        }
        ran.steps.push((name, done.status.code()));
    }
    ran
}

/// A repository with references, and a program in place of `cargo` that installs the binary under test.
fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    for folder in ["bin", "temp", "repository", "repository/pictures", "repository/sources"] {
        std::fs::create_dir(sandbox.path(folder)).unwrap();
    }
    sandbox.write("repository/pictures/wave.json", keyframe_file(5).to_string());
    let list = json!({
        "format": "inbetween.pictures", "version": 1, "defaults": {"file": "wave.json", "size": [64, 48]},
        "pictures": [{"name": "wave", "at": [0, 0.5]}],
    });
    sandbox.write("repository/pictures/pictures.json", list.to_string());
    sandbox.run(&["verify", "repository/pictures", "--update"]).succeeds();
    sandbox.write("repository/sources/main.rs", "fn main() {}\n");
    let cargo = format!(
        "#!/bin/bash\necho \"$@\" >> '{}'\nwhile [ \"$1\" != --root ]; do shift; done\nmkdir -p \"$2/bin\"\nln -s '{}' \
         \"$2/bin/inbetween\"\n",
        sandbox.path("asked").display(),
        env!("CARGO_BIN_EXE_inbetween"),
    );
    sandbox.write("bin/cargo", cargo);
    std::fs::set_permissions(sandbox.path("bin/cargo"), std::fs::Permissions::from_mode(0o755)).unwrap();
    sandbox
}

const DRIVER: &str = "Install Mesa's software renderer";
const LOOK: &str = "Look for the program";
const CACHE: &str = "Take the program from the cache";
const INSTALL: &str = "Install the program";
const RENDER: &str = "Render and compare";
const KEEP: &str = "Keep the page and its pictures";

#[test]
fn a_difference_fails_the_job_and_the_page_is_kept() {
    let sandbox = sandbox();
    let program = ("inbetween", env!("CARGO_BIN_EXE_inbetween"));
    let good = run(&sandbox, &[("directory", "pictures"), program]);
    assert_eq!(good.names(), [DRIVER, LOOK, RENDER], "{}", good.said);
    assert!(good.said.ends_with("all 2 as they should be\n"), "{}", good.said);
    let mut file = keyframe_file(5);
    file["keyframes"][1]["pose"][12]["translation"] = json!([1.6, 1.0, 0.0]);
    sandbox.write("repository/pictures/wave.json", file.to_string());
    let bad = run(&sandbox, &[("directory", "pictures"), ("junit", "junit.xml"), program]);
    assert_eq!((bad.names(), bad.status_of(RENDER)), (vec![DRIVER, LOOK, RENDER, KEEP], Some(1)), "{}", bad.said);
    assert!(bad.said.contains("::error file=pictures/pictures.json,title=Picture wave-0::"), "{}", bad.said);
    assert!(sandbox.read("repository/junit.xml").contains("<failure "));
    for name in ["index.html", "wave-0.png", "wave-0-reference.png", "wave-0-difference.png"] {
        assert!(sandbox.path("repository/inbetween-actual").join(name).exists(), "{name}");
    }
}

#[test]
fn the_program_is_installed_where_it_is_not() {
    let sandbox = sandbox();
    let missing = ("inbetween", "no-such-inbetween");
    let ran = run(&sandbox, &[("directory", "pictures"), ("source", "sources"), missing]);
    assert_eq!(ran.names(), [DRIVER, LOOK, CACHE, INSTALL, RENDER], "{}", ran.said);
    let root = sandbox.path("temp/inbetween-program").display().to_string();
    assert_eq!(sandbox.read("asked"), format!("install --locked --root {root} --path sources\n"));
    let ran = run(&sandbox, &[("directory", "pictures"), missing]);
    assert_eq!((ran.names(), ran.status_of(LOOK)), (vec![DRIVER, LOOK, KEEP], Some(1)));
    assert!(ran.said.contains("the input source says where to install it from"), "{}", ran.said);
}

#[test]
fn a_repository_is_installed_at_the_commit_that_a_branch_has() {
    let sandbox = sandbox();
    let git = |arguments: &[&str]| {
        let mut command = Command::new("git");
        command.current_dir(sandbox.path("repository/sources")).args(["-c", "user.name=A", "-c", "user.email=a@b"]);
        let done = command.args(arguments).output().unwrap();
        assert!(done.status.success(), "{done:?}");
        String::from_utf8(done.stdout).unwrap().trim().to_owned()
    };
    git(&["init", "--quiet", "--initial-branch", "main"]);
    git(&["commit", "--quiet", "--allow-empty", "--message", "first"]);
    git(&["tag", "--annotate", "--message", "one", "v1"]);
    let first = git(&["rev-parse", "HEAD"]);
    git(&["commit", "--quiet", "--allow-empty", "--message", "second"]);
    let second = git(&["rev-parse", "HEAD"]);
    let address = format!("file://{}", sandbox.path("repository/sources").display());
    let missing = ("inbetween", "no-such-inbetween");
    let mut expected = String::new();
    for (reference, commit) in [("HEAD", &second), ("main", &second), ("v1", &first), (first.as_str(), &first)] {
        let _ = std::fs::remove_dir_all(sandbox.path("temp/inbetween-program"));
        let ran = run(&sandbox, &[("directory", "pictures"), ("source", &address), ("ref", reference), missing]);
        assert_eq!(ran.status_of(RENDER), Some(0), "{}", ran.said);
        let root = sandbox.path("temp/inbetween-program").display().to_string();
        let _ = writeln!(expected, "install --locked --root {root} --git {address} --rev {commit} inbetween");
    }
    assert_eq!(sandbox.read("asked"), expected);
}
