//! A folder of its own for each test, the binary run in it, and keyframe files to start from.

use std::path::PathBuf;

use assert_cmd::Command;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use serde_json::{Value, json};

/// A folder that cannot be, in place of the user's folders.
const NOWHERE: &str = "/dev/null/nowhere";

/// A temporary folder in which the binary runs.
pub struct Sandbox(tempfile::TempDir);

/// What a run of the binary left.
#[derive(Debug)]
pub struct Outcome {
    pub status: i32,
    pub stdout: String,
    pub stderr: String,
}

impl Sandbox {
    pub fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        let path = self.path(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    pub fn json(&self, name: &str) -> Value {
        serde_json::from_str(&self.read(name)).unwrap()
    }

    /// What stands in the folder, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_inbetween"));
        command.current_dir(self.0.path()).args(arguments);
        // These tests may themselves run there.
        command.env_remove("GITHUB_ACTIONS").env_remove("GITHUB_STEP_SUMMARY");
        // The user's own settings and journals must not show, and these tests leave none.
        command.env("XDG_CONFIG_HOME", NOWHERE).env("XDG_STATE_HOME", NOWHERE);
        command
    }

    pub fn run(&self, arguments: &[&str]) -> Outcome {
        Self::outcome(self.command(arguments))
    }

    pub fn outcome(mut command: Command) -> Outcome {
        let output = command.output().unwrap();
        Outcome {
            status: output.status.code().expect("it ends by itself"),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// Runs a script with the trace on and gives its lines.
    #[track_caller]
    pub fn trace(&self, script: &str) -> Vec<Value> {
        let mut command = self.command(&["script", "-", "--trace", "--state", "state.json"]);
        command.write_stdin(script);
        let outcome = Self::outcome(command);
        assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
        outcome.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    }
}

impl Outcome {
    #[track_caller]
    pub fn succeeds(self) -> String {
        assert_eq!((self.status, self.stderr.as_str()), (0, ""));
        self.stdout
    }

    /// Ends with the status 1, says exactly this on standard error and nothing on standard output.
    #[track_caller]
    pub fn refuses(self, sentences: &str) {
        assert_eq!((self.status, self.stdout.as_str(), self.stderr.trim_end()), (1, "", sentences));
    }

    /// Ends with the status 2, says something on standard error and nothing on standard output.
    #[track_caller]
    pub fn misuses(self) {
        assert_eq!((self.status, self.stdout.as_str()), (2, ""), "{}", self.stderr);
        assert!(!self.stderr.is_empty());
    }
}

/// A keyframe file of so many keyframes, in which the head of robot 1 is at x = 0, 1, 2, …
pub fn keyframe_file(keyframes: usize) -> Value {
    let scene = built_in_scene(DEFAULT_SCENE).unwrap();
    let head = scene.find_rbt("robot1/head").unwrap();
    let poses: Vec<Value> = (0..keyframes)
        .map(|keyframe| {
            let pose: Vec<Value> = scene
                .rbt_indices()
                .map(|rbt| {
                    let [x, y, z] = scene.rest_pose().get(rbt).translation.to_array();
                    let translation = if rbt == head { json!([keyframe, y, z]) } else { json!([x, y, z]) };
                    json!({"translation": translation, "rotation": [0, 0, 0, 1]})
                })
                .collect();
            json!({"pose": pose})
        })
        .collect();
    json!({
        "format": "inbetween.keyframes", "version": 1, "scene": "two-robots",
        "nodes": scene.rbt_paths().collect::<Vec<_>>(), "keyframes": poses,
    })
}

/// The place of the head of robot 1 in poses.
pub const HEAD: usize = 11;
