//! The real window and the files of other programs: what they change is asked about, offered, or read; and a window at rest rests.
//!
//! It needs `Xvfb` and `xdotool`; without them it fails and says so.

mod display;

use std::collections::BTreeMap;
use std::io::{BufRead as _, BufReader};
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, SystemTime};

use display::{Running, display, focused_window, inbetween, wait_for, xdotool};
use glam::Vec3;
use inbetween::keyframe::{Keyframe, KeyframeList, keyframes_to_json};
use inbetween::model::{MeshLibrary, TriangleMesh};
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use inbetween::storage::logs;

/// So long nothing is drawn where nothing more is to come.
const QUIET: Duration = Duration::from_millis(600);

struct Window {
    process: Running,
    _server: Running,
    display: String,
    handle: String,
    pictures: Arc<AtomicUsize>,
    folder: tempfile::TempDir,
}

/// A keyframe file of so many keyframes, all at rest.
fn keyframes(count: usize) -> String {
    let scene = built_in_scene(DEFAULT_SCENE).unwrap();
    let list = KeyframeList::new(vec![Keyframe::new(scene.rest_pose().clone()); count]);
    keyframes_to_json(&scene, &list, inbetween::interpolation::Interpolation::Linear, 2000)
}

impl Window {
    /// A window on a file of four keyframes.
    fn open(settings: &str) -> Self {
        Self::open_on(settings, |folder| {
            let file = folder.join("a.json");
            std::fs::write(&file, keyframes(4)).unwrap();
            vec![file]
        })
    }

    /// A window on files that are made in its folder, by its arguments.
    fn open_on(settings: &str, make: impl FnOnce(&Path) -> Vec<PathBuf>) -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("inbetween")).unwrap();
        let settings = format!("{{\"format\": \"inbetween.settings\", \"version\": 1{settings}}}");
        std::fs::write(folder.path().join("inbetween/settings.json"), settings).unwrap();
        let arguments = make(folder.path());
        let (server, display) = display(&[]);
        let mut command = inbetween(&display, folder.path());
        command.arg("--print-lines").args(&arguments).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut process = Running(command.spawn().unwrap());
        let output = BufReader::new(process.0.stdout.take().unwrap());
        let pictures = Arc::new(AtomicUsize::new(0));
        let counted = Arc::clone(&pictures);
        std::thread::spawn(move || {
            for line in output.lines().map_while(Result::ok) {
                counted.fetch_add(usize::from(line == "picture"), Ordering::Relaxed);
            }
        });
        let handle = focused_window(&display, &mut process);
        let window = Self { process, _server: server, display, handle, pictures, folder };
        window.settle();
        window
    }

    fn pictures(&self) -> usize {
        self.pictures.load(Ordering::Relaxed)
    }

    /// Waits until all that was asked for is drawn.
    fn settle(&self) {
        let is_quiet = wait_for(|| {
            let before = self.pictures();
            std::thread::sleep(QUIET);
            before > 0 && self.pictures() == before
        });
        assert!(is_quiet, "the window does not come to rest");
    }

    /// Presses keys one after the other, each when what the one before led to is drawn.
    fn press(&self, keys: &[&str]) {
        for key in keys {
            xdotool(&self.display, &["key", key]).expect("the key is typed");
            self.settle();
        }
    }

    fn file(&self) -> PathBuf {
        self.folder.path().join("a.json")
    }

    /// Another program writes the file.
    fn change(&self, count: usize) {
        std::fs::write(self.file(), keyframes(count)).unwrap();
    }

    #[track_caller]
    fn check(&self, name: &str, count: usize) {
        let path = self.folder.path().join(name);
        let count_in_file = || {
            let json: serde_json::Value = serde_json::from_slice(&std::fs::read(&path).ok()?).ok()?;
            json["keyframes"].as_array().map(Vec::len)
        };
        assert!(wait_for(|| count_in_file() == Some(count)), "{name} has {:?} keyframes", count_in_file());
    }

    fn is_kept(&self) -> bool {
        self.folder.path().join("a.json.bak").exists()
    }

    fn journal(&self) -> String {
        let path = logs(&self.folder.path().join("state/inbetween"), ".journal").into_iter().next().unwrap();
        std::fs::read_to_string(path).unwrap()
    }

    fn imports(&self) -> usize {
        self.journal().lines().filter(|line| line.starts_with("imported ")).count()
    }

    /// The window goes to the back and comes to the front again.
    fn come_back(&self) {
        xdotool(&self.display, &["windowunmap", "--sync", &self.handle]).unwrap();
        xdotool(&self.display, &["windowmap", "--sync", &self.handle]).unwrap();
        xdotool(&self.display, &["windowfocus", "--sync", &self.handle]).unwrap();
        self.settle();
    }

    /// Clicks where a button is until it has done what it does.
    #[track_caller]
    fn click_until(&self, [x, y]: [&str; 2], is_done: impl Fn() -> bool) {
        let is_done = wait_for(|| {
            xdotool(&self.display, &["mousemove", x, y, "sleep", "0.2", "click", "1"]).expect("the pointer moves");
            std::thread::sleep(QUIET);
            is_done()
        });
        assert!(is_done, "the click at {x}, {y} does nothing");
    }
}

#[test]
fn a_changed_file_is_asked_about_and_kept_where_it_is_overwritten() {
    let window = Window::open("");
    window.change(7);
    window.press(&["n", "w"]);
    window.check("a.json", 7);
    // The question has the keyboard: nothing else happens.
    window.press(&["n", "Escape"]);
    window.check("a.json", 7);
    assert!(!window.is_kept());
    // The default is to save as; the next button overwrites.
    window.press(&["w", "Tab", "Return"]);
    window.check("a.json", 5);
    window.check("a.json.bak", 7);
    // What this window wrote is known to it.
    window.press(&["n", "w"]);
    window.check("a.json", 6);
    assert!(!window.folder.path().join("a.json.bak2").exists());
}

#[test]
fn a_changed_file_can_be_read_instead() {
    let window = Window::open("");
    window.change(7);
    window.press(&["n", "w", "Tab", "Tab", "Return"]);
    assert_eq!(window.imports(), 2);
    window.check("a.json", 7);
    window.press(&["n", "w"]);
    window.check("a.json", 8);
    assert!(!window.is_kept());
    // Reading it again can be undone.
    window.press(&["ctrl+z", "ctrl+z", "w"]);
    window.check("a.json", 5);
}

#[test]
fn what_differs_is_shown_and_the_question_stays() {
    let window = Window::open("");
    window.change(7);
    window.press(&["n", "w", "Tab", "Tab", "Tab", "Return"]);
    window.check("a.json", 7);
    window.press(&["Escape", "w", "Tab", "Return"]);
    window.check("a.json", 5);
}

#[test]
fn an_empty_list_is_not_written_over_keyframes_without_a_question() {
    let window = Window::open("");
    window.press(&["d", "d", "d", "d", "w", "Escape"]);
    window.check("a.json", 4);
    window.press(&["w", "Tab", "Return"]);
    window.check("a.json", 0);
    window.check("a.json.bak", 4);
}

#[test]
fn a_window_that_is_to_close_closes_after_the_answer() {
    let mut window = Window::open("");
    window.press(&["n"]);
    window.change(7);
    // Return saves, and then the question is asked.
    window.press(&["ctrl+q", "Return"]);
    assert!(window.process.0.try_wait().unwrap().is_none());
    xdotool(&window.display, &["key", "Tab"]).unwrap();
    window.settle();
    xdotool(&window.display, &["key", "Return"]).unwrap();
    assert!(wait_for(|| window.process.0.try_wait().is_ok_and(|end| end.is_some())), "the window does not close");
    window.check("a.json", 5);
    window.check("a.json.bak", 7);
}

#[test]
fn undo_ends_where_the_program_was_started() {
    let window = Window::open("");
    window.press(&["n", "ctrl+z", "ctrl+z", "ctrl+z", "n", "w"]);
    window.check("a.json", 5);
}

#[test]
fn a_window_that_comes_to_the_front_offers_to_read_what_was_changed() {
    let window = Window::open("");
    window.change(7);
    window.come_back();
    // Hotkeys work beside the bar.
    window.press(&["greater"]);
    assert!(window.journal().contains("do keyframe-next"));
    assert_eq!(window.imports(), 1);
    // The buttons are at the right end of the bar: reload, what differs, later.
    window.click_until(["709", "41"], || window.imports() == 2);
    window.settle();
    assert!(window.journal().ends_with("go 1\n"), "the same keyframe stays current");
    window.press(&["n", "w"]);
    window.check("a.json", 8);
}

#[test]
fn a_file_is_read_when_it_changes_where_that_is_ticked() {
    let window = Window::open(", \"reload\": true");
    window.change(7);
    assert!(wait_for(|| window.imports() == 2), "the changed file is not read");
    window.settle();
    // What is not saved is not replaced.
    window.press(&["n"]);
    window.change(9);
    std::thread::sleep(Duration::from_secs(2));
    assert_eq!(window.imports(), 2);
    window.press(&["ctrl+z"]);
    assert!(wait_for(|| window.imports() == 3), "the changed file is not read when nothing is unsaved any more");
    // What cannot be read is said once, and the list stays.
    std::fs::write(window.file(), "{").unwrap();
    assert!(wait_for(|| window.imports() == 4));
    std::thread::sleep(Duration::from_secs(2));
    assert_eq!(window.imports(), 4);
    window.change(10);
    assert!(wait_for(|| window.imports() == 5), "what can be read again is not read");
}

/// A file of meshes with one triangle of a size.
fn plate(size: f32) -> Vec<u8> {
    let mut mesh = TriangleMesh::empty("plate");
    mesh.positions = [Vec3::ZERO, Vec3::X, Vec3::Y].map(|corner| corner * size).to_vec();
    mesh.normals = vec![Vec3::Z; 3];
    mesh.indices = vec![0, 1, 2];
    MeshLibrary::to_glb(&[mesh])
}

#[test]
fn meshes_that_another_program_changes_are_read_with_their_scene() {
    let window = Window::open_on(", \"reload\": true", |folder| {
        let house = folder.join("house.json");
        let text = r#"{"format": "inbetween.scene", "version": 3, "name": "house", "eyes": ["sky"], "meshes": "house.glb",
            "nodes": [{"name": "sky"}, {"name": "plate", "shape": {"mesh": {"name": "plate"}}}]}"#;
        std::fs::write(&house, text).unwrap();
        std::fs::write(folder.join("house.glb"), plate(1.0)).unwrap();
        vec!["--scene".into(), house]
    });
    let read = || window.journal().lines().filter(|line| line.starts_with("imported-scene ")).count();
    assert_eq!(read(), 0);
    std::fs::write(window.folder.path().join("house.glb"), plate(0.5)).unwrap();
    assert!(wait_for(|| read() == 1), "the changed meshes are not read");
    std::thread::sleep(Duration::from_secs(2));
    assert_eq!(read(), 1, "what was read is known");
}

/// What the files of a folder hold, and when they were written.
fn files(folder: &Path) -> BTreeMap<PathBuf, (SystemTime, Vec<u8>)> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap().map(Result::unwrap) {
        if entry.path().is_dir() {
            found.extend(files(&entry.path()));
        } else {
            found.insert(
                entry.path(),
                (entry.metadata().unwrap().modified().unwrap(), std::fs::read(entry.path()).unwrap()),
            );
        }
    }
    found
}

/// How often the program asked the system to write anything, to a file or to the display.
#[cfg(target_os = "linux")]
fn writes(window: &Window) -> u64 {
    let text = std::fs::read_to_string(format!("/proc/{}/io", window.process.0.id())).unwrap();
    text.lines().find_map(|line| line.strip_prefix("syscw: ")).unwrap().parse().unwrap()
}

#[cfg(not(target_os = "linux"))]
fn writes(_: &Window) -> u64 {
    0
}

#[test]
fn an_idle_window_draws_nothing_and_writes_nothing() {
    for settings in ["", ", \"reload\": true"] {
        let window = Window::open(settings);
        window.press(&["n", "w", "n", "7"]);
        // What was said fades, and is drawn until it is gone.
        std::thread::sleep(Duration::from_secs(9));
        window.settle();
        let before = (window.pictures(), writes(&window), files(window.folder.path()));
        std::thread::sleep(Duration::from_secs(4));
        let after = (window.pictures(), writes(&window), files(window.folder.path()));
        assert!(before.2.keys().any(|path| path.extension().is_some_and(|ending| ending == "journal")));
        assert_eq!((before.0, before.1), (after.0, after.1), "pictures and writes with {settings:?}");
        assert!(before.2 == after.2, "a file was written with {settings:?}");
    }
}

#[test]
fn a_change_of_the_view_takes_several_pictures_unless_motion_is_reduced() {
    let pictures = [", \"reduce_motion\": true", ""].map(|settings| {
        let window = Window::open(settings);
        window.press(&["1"]);
        let before = window.pictures();
        window.press(&["3", "7", "1", "3"]);
        assert!(window.journal().contains("look right"));
        window.pictures() - before
    });
    let [at_once, eased] = pictures;
    assert!(at_once >= 1 && eased > at_once, "{pictures:?} pictures");
}
