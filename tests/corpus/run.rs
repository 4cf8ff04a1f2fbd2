//! Runs cases, and puts what they left into text.
//!
//! A case's section holds for each run `$ ARGUMENTS`, `! STATUS`, the lines of standard output after `| ` and those of standard error
//! after `> `. Then come the files that were written, with the beginning of their SHA-256; short CSV files with their text.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::os::unix::fs::OpenOptionsExt as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use sha2::{Digest as _, Sha256};

use crate::cases::Case;
use crate::{bases, library, trace};

/// What is longer is cut and told by its SHA-256.
const LONGEST: usize = 900;

/// A folder for all cases, and in `shared` the files that several of them read.
pub struct Shared(tempfile::TempDir);

impl Shared {
    pub fn new() -> Self {
        let shared = Self(tempfile::tempdir().unwrap());
        let folder = shared.0.path().join("shared");
        std::fs::create_dir(&folder).unwrap();
        for (name, base) in bases::SHARED {
            std::fs::write(folder.join(name), bases::base(base)).unwrap();
        }
        shared
    }
}

/// The sections of all cases, in their order.
pub fn all(cases: &[Case], shared: &Shared) -> Vec<(String, String)> {
    let next = AtomicUsize::new(0);
    let sections: Mutex<BTreeMap<usize, String>> = Mutex::default();
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(2, usize::from) {
            scope.spawn(|| {
                loop {
                    let place = next.fetch_add(1, Ordering::Relaxed);
                    let Some(case) = cases.get(place) else { break };
                    let section = section(case, shared.0.path());
                    sections.lock().unwrap().insert(place, section);
                }
            });
        }
    });
    let sections = sections.into_inner().unwrap();
    sections.into_iter().map(|(place, section)| (cases[place].name.clone(), section)).collect()
}

fn binary() -> PathBuf {
    std::env::var_os("CORPUS_BINARY").map_or_else(|| env!("CARGO_BIN_EXE_inbetween").into(), PathBuf::from)
}

/// Writes a file and the folders above it. What lies in `bin` can be run.
fn write(folder: &Path, name: &str, bytes: &[u8]) {
    let path = folder.join(name);
    std::fs::create_dir_all(path.parent().expect("it is in the folder")).unwrap();
    let mut options = std::fs::OpenOptions::new();
    options.write(true).create(true).truncate(true).mode(if name.starts_with("bin/") { 0o755 } else { 0o644 });
    std::io::Write::write_all(&mut options.open(path).unwrap(), bytes).unwrap();
}

fn section(case: &Case, root: &Path) -> String {
    let folder = root.join(&case.name);
    std::fs::create_dir(&folder).unwrap();
    write(&folder, &case.file, &case.bytes);
    for (name, bytes) in &case.with {
        write(&folder, name, bytes);
    }
    for (name, target) in &case.links {
        std::os::unix::fs::symlink(target, folder.join(name)).unwrap();
    }
    let mut text = String::new();
    for run in &case.runs {
        let arguments: Vec<String> =
            run.split_whitespace().map(|argument| argument.replace("{}", &case.file)).collect();
        if run != crate::cases::RUN_SCRIPT {
            let _ = writeln!(text, "$ {}", arguments.join(" "));
        }
        if arguments[0] == "settings" {
            text += &library::settings(&case.bytes);
            continue;
        }
        let output = Command::new(binary())
            .current_dir(&folder)
            .args(&arguments)
            .stdin(Stdio::null())
            .env_remove("DISPLAY")
            .env_remove("WAYLAND_DISPLAY")
            // The user's own settings and journals must not show.
            .env("XDG_CONFIG_HOME", root.join("config"))
            .env("XDG_STATE_HOME", root.join("state"))
            .env_remove("GITHUB_ACTIONS")
            .env_remove("GITHUB_STEP_SUMMARY")
            .envs(case.environment.iter().map(|(name, value)| (name, value)))
            .output()
            .unwrap();
        let status = output.status.code().unwrap_or_else(|| panic!("{} was killed: {output:?}", case.name));
        let _ = writeln!(text, "! {status}");
        let stdout = String::from_utf8(output.stdout).unwrap();
        if arguments.iter().any(|argument| argument == "--trace") {
            text += &trace::compact(&stdout, &String::from_utf8_lossy(&case.bytes));
        } else {
            text += &shown(&stdout, "| ");
        }
        text += &shown(&String::from_utf8(output.stderr).unwrap(), "> ");
    }
    text + &written(case, &folder)
}

/// The files of a folder that were not there before, or are not as they were.
fn written(case: &Case, folder: &Path) -> String {
    let mut files = Vec::new();
    list(folder, folder, &mut files);
    let mut text = String::new();
    for (name, bytes) in files {
        let was_given = (name == case.file).then_some(&case.bytes);
        let was_given =
            was_given.or_else(|| case.with.iter().find(|(given, _)| *given == name).map(|(_, bytes)| bytes));
        if was_given == Some(&bytes) {
            continue;
        }
        if is_picture(&name) || name.ends_with("index.html") {
            // The bytes of a picture depend on the graphics driver; the page that shows pictures has tests of its own.
            let _ = writeln!(text, "# {name}");
            continue;
        }
        let is_report = name.ends_with("report.html");
        let bytes = if is_report { without_pictures(&bytes) } else { bytes };
        let _ = writeln!(text, "# {name} {}", hash(&bytes));
        let name = Path::new(&name);
        if name.file_name().is_some_and(|name| name == "grades.csv") {
            text += &marked(&String::from_utf8_lossy(&bytes), "= ");
        } else if name.file_name().is_some_and(|name| name == "grades.json") {
            text += &marked(&reasons(&bytes), "= ");
        } else if is_report {
            let report = String::from_utf8_lossy(&bytes);
            text += &report
                .lines()
                .filter(|line| ["<p class=\"note\"", "<p class=\"quiet\""].iter().any(|start| line.starts_with(start)))
                .map(|note| format!("= {note}\n"))
                .collect::<String>();
        } else if name.extension().is_some_and(|ending| ending == "csv") && bytes.len() <= LONGEST {
            text += &shown(&String::from_utf8_lossy(&bytes), "= ");
        }
    }
    text
}

/// A page without the bytes of its pictures.
fn without_pictures(page: &[u8]) -> Vec<u8> {
    let page = String::from_utf8_lossy(page);
    let mut parts = page.split("base64,");
    let first = parts.next().unwrap_or_default().to_owned();
    let rest = parts.map(|part| part.find(['"', ')']).map_or(part, |end| &part[end..]));
    rest.fold(first, |text, part| text + "base64," + part).into_bytes()
}

fn is_picture(name: &str) -> bool {
    let ending = Path::new(name).extension().and_then(|ending| ending.to_str());
    matches!(ending, Some("png" | "gif" | "apng" | "y4m" | "mp4" | "webp"))
}

fn list(root: &Path, folder: &Path, files: &mut Vec<(String, Vec<u8>)>) {
    let mut entries: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        // What is kept between runs, and what is merged, is of this build of the program alone.
        let is_of_build = path.file_name().is_some_and(|name| name == ".cache" || name == "shard.json");
        if path.is_symlink() || is_of_build {
            continue;
        }
        if path.is_dir() {
            list(root, &path, files);
        } else {
            let name = path.strip_prefix(root).unwrap().to_string_lossy().into_owned();
            files.push((name, std::fs::read(&path).unwrap()));
        }
    }
}

fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().take(6).map(|byte| format!("{byte:02x}")).collect()
}

/// The reasons for points of `grades.json`, each once.
fn reasons(grades: &[u8]) -> String {
    let grades: serde_json::Value = serde_json::from_slice(grades).unwrap();
    let submissions = grades["submissions"].as_array().unwrap();
    let items = submissions.iter().flat_map(|submission| submission["items"].as_array().unwrap());
    let reasons: BTreeSet<&str> = items.map(|item| item["reason"].as_str().unwrap()).collect();
    reasons.into_iter().map(|reason| format!("{reason}\n")).collect()
}

/// The lines of a text with a mark before each.
fn marked(text: &str, mark: &str) -> String {
    text.lines().map(|line| format!("{mark}{line}\n")).collect()
}

/// The lines of a text with a mark before each; of a long one the first lines, the last three and its SHA-256.
fn shown(text: &str, mark: &str) -> String {
    let mut shown = String::new();
    for line in text.split_inclusive('\n') {
        if shown.len() + line.len() > LONGEST {
            let lines: Vec<&str> = text.lines().collect();
            for last in &lines[lines.len().saturating_sub(3)..] {
                let short: String = last.chars().take(200).collect();
                let _ = writeln!(shown, "{mark}… {short}");
            }
            return shown + &format!("{mark}({} bytes in all, {})\n", text.len(), hash(text.as_bytes()));
        }
        let end = if line.ends_with('\n') { "" } else { "\\\n" };
        let _ = write!(shown, "{mark}{line}{end}");
    }
    shown
}
