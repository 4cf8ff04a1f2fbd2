//! Scripts of submissions, run in a folder of their own that is in memory: nothing is read from the disk or written to it.
//!
//! Only plain names are in that folder: a path that leads elsewhere ends the script. No picture is drawn. Work is bounded by counts, so
//! that the outcome is the same on every machine.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use crate::clock::TICKS_PER_SECOND;
use crate::editor::{CommandError, Editor, FileAccess, FileOutcome, Host, Severity, WindowHost, Writing, Written};
use crate::keyframe::keyframes_to_json;
use crate::scene::{SceneGraph, with_meshes_within};
use crate::script::{self, Action, Line, NoWindow, Runner, State, Windowless};
use crate::text_layouts::{ImportError, Imported, Options, import};
use crate::words::{Message, texts};

/// The most lines of a script that is run while grading.
pub const MOST_LINES: usize = 2_000;
/// The longest that a script may wait, all in all.
const LONGEST_WAIT: Duration = Duration::from_hours(1);
/// The most keyframes at a time.
const MOST_KEYFRAMES: usize = 2_000;
/// The most bytes that a script may write, all in all.
const MOST_WRITTEN_BYTES: usize = 32 << 20;
/// The most bytes that a script may read, all in all.
const MOST_READ_BYTES: usize = 64 << 20;
/// The script's keyframe file, as where `script` is not told another.
const KEYFRAME_FILE: &str = "animation.json";
/// Where a screenshot without a name goes. It is not drawn, so that the name stays free.
const SCREENSHOT_FILE: &str = "inbetween-0001.png";

/// Reads a script.
///
/// # Errors
/// The first line that cannot be parsed, or the limit that is exceeded.
pub fn read_script(bytes: &[u8], scene: &SceneGraph) -> Result<Vec<Line>, String> {
    let lines = script::parse(bytes, scene)
        .map_err(|problems| problems.first().map(ToString::to_string).unwrap_or_default())?;
    if lines.len() > MOST_LINES {
        return Err(format!("{} commands, and at most {MOST_LINES} are run", lines.len()));
    }
    Ok(lines)
}

/// A command that was run, and the state after it.
#[derive(Clone, Debug, PartialEq)]
pub struct Traced {
    /// The command, as the script has it.
    pub command: String,
    /// The state after it.
    pub state: State,
    /// The number of its line.
    pub line: usize,
    /// Why it was refused, if it was.
    pub refusal: Option<String>,
}

/// The result of a script.
pub struct Ran {
    /// Each command that was run.
    pub trace: Vec<Traced>,
    editor: Editor,
}

impl Ran {
    /// The keyframes at the end, as a keyframe file.
    pub fn keyframe_file(&self) -> Vec<u8> {
        let document = self.editor.document();
        let (interpolation, ms_between_keyframes) = (document.interpolation, document.ms_between_keyframes);
        keyframes_to_json(self.editor.scene(), &document.keyframes, interpolation, ms_between_keyframes).into_bytes()
    }
}

/// Runs a script with `keyframes` as the keyframe file, if there is one.
///
/// # Errors
/// The script used a path outside of the folder, or exceeded a limit: a sentence with the line.
pub fn run(lines: &[Line], scene: &SceneGraph, keyframes: Option<&[u8]>) -> Result<Ran, String> {
    let editor = Editor::new(Arc::new(scene.clone()), PathBuf::from(KEYFRAME_FILE));
    let files = keyframes.map(|bytes| (KEYFRAME_FILE.to_owned(), bytes.to_owned())).into_iter().collect();
    let folder = Folder { editor, files, parsed: None, read: 0, written: 0, no_window: NoWindow::default() };
    let mut runner = Runner::new(folder);
    let mut waited = Duration::ZERO;
    let mut trace = Vec::with_capacity(lines.len());
    for line in lines {
        let located = |problem: String| format!("line {}: {problem}", line.number);
        let wait = match &line.action {
            Action::Apply(_) => Duration::ZERO,
            Action::Wait(duration) => *duration,
            Action::Ticks(ticks) => Duration::from_secs(ticks / u64::from(TICKS_PER_SECOND) + 1),
            Action::Restore(_) => return Err(located("it is a line of a journal, which is not graded".to_owned())),
        };
        if wait > Duration::ZERO {
            waited = waited.saturating_add(wait);
            if waited > LONGEST_WAIT {
                return Err(located(format!("it waits for more than {} s", LONGEST_WAIT.as_secs())));
            }
        }
        let step = runner.step(line).map_err(located)?;
        let state = runner.state();
        if state.keyframes > MOST_KEYFRAMES {
            return Err(located(format!("more than {MOST_KEYFRAMES} keyframes")));
        }
        let said = runner.host().editor.message().filter(|_| matches!(line.action, Action::Apply(_)));
        let refusal = said.filter(|said| said.severity() == Severity::Error).map(ToString::to_string);
        trace.push(Traced { command: line.text.clone(), state, line: line.number, refusal });
        if step.is_last {
            break;
        }
    }
    Ok(Ran { trace, editor: runner.into_host().editor })
}

/// The host of a script that is graded: a folder in memory.
struct Folder {
    editor: Editor,
    files: BTreeMap<String, Vec<u8>>,
    /// The file of keyframes that was parsed last, unless it was written since.
    parsed: Option<LastParsed>,
    /// Bytes that were read, all in all.
    read: usize,
    /// Bytes that were written, all in all.
    written: usize,
    no_window: NoWindow,
}

/// A file of keyframes that was parsed.
struct LastParsed {
    name: String,
    scene: Arc<SceneGraph>,
    content: Result<Imported, ImportError>,
}

impl Folder {
    /// Counts bytes that are read.
    fn count_read(&mut self, bytes: usize) -> Result<(), String> {
        self.read += bytes;
        if self.read > MOST_READ_BYTES {
            return Err(format!("it reads more than {MOST_READ_BYTES} bytes"));
        }
        Ok(())
    }
}

impl Windowless for Folder {
    fn no_window(&mut self) -> &mut NoWindow {
        &mut self.no_window
    }
}

impl Host for Folder {
    type Stop = String;

    fn editor(&mut self) -> &mut Editor {
        &mut self.editor
    }

    fn read(&mut self, access: FileAccess, path: &Path) -> Result<FileOutcome<Vec<u8>>, String> {
        let bytes = self.files.get(&plain_name(path)?).cloned();
        self.count_read(bytes.as_ref().map_or(0, Vec::len))?;
        let beside = |name: &str| self.files.get(name).cloned().ok_or_else(|| texts::STORAGE_NOT_FOUND.into());
        let bytes: FileOutcome<Vec<u8>> = bytes.ok_or_else(|| texts::STORAGE_NOT_FOUND.into());
        Ok(match access {
            FileAccess::SceneRead => bytes.and_then(|bytes| with_meshes_within(bytes, beside)),
            _ => bytes,
        })
    }

    fn read_keyframes(&mut self, path: &Path) -> Result<Result<(), CommandError>, String> {
        let name = plain_name(path)?;
        let Some(length) = self.files.get(&name).map(Vec::len) else {
            return Ok(self.editor.keyframes_read(path, Err(texts::STORAGE_NOT_FOUND.into())));
        };
        self.count_read(length)?;
        let scene = &self.editor.document().scene;
        // A script may import one file at every line.
        let is_known = |parsed: &&LastParsed| parsed.name == name && Arc::ptr_eq(&parsed.scene, scene);
        let content = match self.parsed.as_ref().filter(is_known) {
            Some(parsed) => parsed.content.clone(),
            None => import(&self.files[&name], scene, &Options::of_keyframes()),
        };
        let scene = Arc::clone(scene);
        self.parsed = Some(LastParsed { name, scene, content: content.clone() });
        Ok(self.editor.keyframes_parsed(path, Ok(content)))
    }

    fn write(&mut self, writing: Writing<'_>) -> Result<Option<FileOutcome<Written>>, String> {
        let name = plain_name(writing.path)?;
        let bytes = writing.text.to_string().into_bytes();
        let meshes = writing
            .meshes
            .map(|meshes| Ok::<_, String>((plain_name(&meshes.path)?, meshes.glb.to_vec())))
            .transpose()?;
        self.written += bytes.len() + meshes.as_ref().map_or(0, |(_, glb)| glb.len());
        if self.written > MOST_WRITTEN_BYTES {
            return Err(format!("it writes more than {MOST_WRITTEN_BYTES} bytes"));
        }
        self.parsed = self.parsed.take().filter(|parsed| parsed.name != name);
        self.files.extend(meshes);
        self.files.insert(name, bytes);
        Ok(Some(Ok(Written::default())))
    }

    fn take_screenshot(
        &mut self,
        path: Option<PathBuf>,
        _has_overlays: bool,
    ) -> Result<Option<(PathBuf, FileOutcome<()>)>, String> {
        let path = path.unwrap_or_else(|| PathBuf::from(SCREENSHOT_FILE));
        plain_name(&path)?;
        Ok(Some((path, Ok(()))))
    }

    fn read_pose(&mut self, name: &str) -> Result<FileOutcome<Vec<u8>>, String> {
        // A name is that of a file in the script's own folder here.
        self.read(FileAccess::KeyframesRead, Path::new(&pose_file(name)))
    }

    fn write_pose(&mut self, name: &str, text: &str) -> Result<FileOutcome<(PathBuf, Written)>, String> {
        let path = PathBuf::from(pose_file(name));
        let writing =
            Writing { access: FileAccess::PoseWritten, path: &path, text: &text, meshes: None, is_known: true };
        let written = self.write(writing)?.unwrap_or_else(|| Ok(Written::default()));
        Ok(written.map(|written| (path, written)))
    }

    /// Nothing is written: no rubric asks for a model.
    fn write_model(&mut self, path: &Path) -> Result<FileOutcome<Vec<Message>>, String> {
        plain_name(path)?;
        Ok(Ok(vec![texts::file_model_not_written(path.display())]))
    }

    fn told(&mut self, _access: FileAccess, _path: &Path, _told: Result<(), CommandError>) -> Result<(), String> {
        // What is wrong with a file is the editor's message, and the script goes on.
        Ok(())
    }

    fn window(&mut self) -> &mut dyn WindowHost {
        &mut self.no_window
    }
}

fn pose_file(name: &str) -> String {
    if Path::new(name).extension().is_some_and(|ending| ending == "json") {
        name.to_owned()
    } else {
        format!("{name}.json")
    }
}

/// The name of a file in the script's own folder.
fn plain_name(path: &Path) -> Result<String, String> {
    let refused = || format!("{}: a script that is graded reads and writes only in its own folder", path.display());
    let mut parts = path.components().filter(|part| *part != Component::CurDir);
    match (parts.next(), parts.next()) {
        (Some(Component::Normal(name)), None) => name.to_str().map(str::to_owned).ok_or_else(refused),
        _ => Err(refused()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{DEFAULT_SCENE, built_in_scene};

    #[test]
    fn only_plain_names_are_in_the_folder() {
        assert_eq!(plain_name(Path::new("a.png")), Ok("a.png".to_owned()));
        assert_eq!(plain_name(Path::new("./a.png")), Ok("a.png".to_owned()));
        for out in ["/etc/passwd", "../a.png", "a/../../b", "a/b.png", "", "..", "/"] {
            assert!(plain_name(Path::new(out)).is_err(), "{out}");
        }
    }

    #[test]
    fn a_scene_is_saved_in_memory() {
        let scene = built_in_scene(DEFAULT_SCENE).expect("it is built in");
        let run = |script: &str| {
            let lines = read_script(script.as_bytes(), &scene).expect("it is a script");
            run(&lines, &scene, None)
        };
        let ran = run("key n\nsave-scene here.json\n").expect("it is within the bounds");
        assert_eq!(ran.editor.message_text(), "Wrote the scene to here.json.");
        let refused = run("key n\nsave-scene ../out.json\n").err().expect("it leads out");
        assert!(refused.starts_with("line 2: ../out.json: a script that is graded"), "{refused}");
    }

    #[test]
    fn keyframes_that_a_script_wrote_are_read_anew() {
        let scene = built_in_scene(DEFAULT_SCENE).expect("it is built in");
        let run = |script: &str, keyframes: Option<&[u8]>| {
            let lines = read_script(script.as_bytes(), &scene).expect("it is a script");
            run(&lines, &scene, keyframes).expect("it is within the bounds")
        };
        let two = run("key n\nkey n\n", None).keyframe_file();
        let ran = run("key i\nkey i\nkey n\nkey n\nkey w\nkey d\nkey d\nkey i\nopen none.json\nkey i\n", Some(&two));
        let counts: Vec<usize> = ran.trace.iter().map(|traced| traced.state.keyframes).collect();
        assert_eq!(counts, [2, 2, 3, 4, 4, 3, 2, 4, 4, 4]);
        assert_eq!(ran.editor.document().keyframes.len(), 4);
    }

    #[test]
    fn a_script_ends_where_it_quits() {
        let scene = built_in_scene(DEFAULT_SCENE).expect("it is built in");
        let lines = read_script(b"key n\nkey ctrl+q\nkey n\n", &scene).expect("it is a script");
        let ran = run(&lines, &scene, None).expect("it is within the bounds");
        assert_eq!((ran.trace.len(), ran.trace[1].state.keyframes), (2, 1));
    }
}
