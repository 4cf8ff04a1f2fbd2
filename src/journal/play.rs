//! Doing again what a journal says.

use std::convert::Infallible;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Arc;

use super::mark::{self, whole_lines};
use super::nowhere::Nowhere;
use crate::editor::{Editor, FileAccess, Host as _, Session, WorkEye, Written};
use crate::keyframe::keyframes_to_json;
use crate::scene::{DEFAULT_SCENE, built_in_scene, scene_to_json};
use crate::script::{Line, Runner, Step, Windowless, parse_line};
use crate::storage::{LeftLog, StorageError};

/// What became of playing a journal.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Played {
    /// How many lines were done.
    pub lines: usize,
    /// How many lines were passed over because they had panicked, or did so now.
    pub passed_over: usize,
    /// Where it is not whole: the number of the first line that cannot be read, and why. What comes after it is lost.
    pub damage: Option<(usize, String)>,
    /// Whether its last line is cut off.
    pub is_cut: bool,
}

/// The lines that a journal which goes on from this one begins with: all but the head, and but what a mark takes back.
pub(super) fn lines_that_count(bytes: &[u8]) -> Vec<&str> {
    const HEAD: [&str; 5] = [mark::FORMAT, mark::PROGRAM, mark::BEGAN, mark::KEYFRAMES, mark::SCENE];
    let lines = kept(bytes).0.into_iter().map_while(|(_, line)| std::str::from_utf8(line).ok());
    lines.filter(|line| !HEAD.iter().any(|head| line.starts_with(head))).collect()
}

/// The lines that count with their numbers from 1, and how many were taken back.
fn kept(bytes: &[u8]) -> (Vec<(usize, &[u8])>, usize) {
    let mut kept: Vec<(usize, &[u8])> = Vec::new();
    let mut taken_back = 0;
    let mut take_back = |kept: &mut Vec<(usize, &[u8])>| {
        if let Some(place) = kept.iter().rposition(|(_, line)| !line.starts_with(b"#")) {
            kept.remove(place);
            taken_back += 1;
        }
    };
    let mut is_recovering = false;
    for (number, line) in (1..).zip(whole_lines(bytes)) {
        let is = |mark: &str| line == mark.as_bytes();
        if is(mark::PANICKED) || is(mark::ENDED) {
            take_back(&mut kept);
        } else if is(mark::RECOVERING) {
            // Whoever began before did not come to the end.
            if std::mem::replace(&mut is_recovering, true) {
                take_back(&mut kept);
            }
        } else if is(mark::RECOVERED) {
            is_recovering = false;
        } else if !line.is_empty() {
            kept.push((number, line));
        }
    }
    (kept, taken_back)
}

/// Does what a journal says, as far as it is whole. `observe` gets each line after it was done, and what was said.
///
/// # Errors
/// Why the host or the observer stopped.
pub fn play<H: Windowless, E: From<H::Stop>>(
    bytes: &[u8],
    runner: &mut Runner<H>,
    mut observe: impl FnMut(&Line, Step, &mut Runner<H>) -> Result<(), E>,
) -> Result<Played, E> {
    play_each(bytes, runner, |done, runner| match done {
        Some((line, step)) => observe(line, step, runner),
        None => Ok(()),
    })
}

/// The same; `observe` also gets each comment that says what was written, as `None`.
fn play_each<H: Windowless, E: From<H::Stop>>(
    bytes: &[u8],
    runner: &mut Runner<H>,
    mut observe: impl FnMut(Option<(&Line, Step)>, &mut Runner<H>) -> Result<(), E>,
) -> Result<Played, E> {
    let (lines, passed_over) = kept(bytes);
    let is_cut = !bytes.ends_with(b"\n") && !bytes.is_empty();
    let mut played = Played { passed_over, is_cut, ..Played::default() };
    for (number, text) in lines {
        if let Some((access, path)) = written(text) {
            let editor = runner.host().editor();
            let _ = match access {
                FileAccess::SceneWritten => editor.scene_written(&path, Ok(Written::default())),
                _ => editor.keyframes_written(&path, Ok(Written::default())),
            };
            observe(None, runner)?;
            continue;
        }
        let scene = Arc::clone(runner.host().editor().scene());
        let line = match parse_line(number, text, &scene) {
            Ok(None) => continue,
            Ok(Some(line)) => line,
            Err(error) => {
                played.damage = Some((number, error.problem.to_string()));
                break;
            }
        };
        let before = runner.host().editor().before();
        if let Ok(step) = catch_unwind(AssertUnwindSafe(|| runner.step(&line))) {
            played.lines += 1;
            observe(Some((&line, step?)), runner)?;
        } else {
            runner.host().editor().go_back(before);
            played.passed_over += 1;
        }
    }
    Ok(played)
}

/// What a comment says that was written, where that matters to the editor.
fn written(line: &[u8]) -> Option<(FileAccess, PathBuf)> {
    let line = std::str::from_utf8(line).ok().filter(|line| !line.starts_with(mark::WROTE_PICTURE))?;
    let scene = line.strip_prefix(mark::WROTE_SCENE).map(|path| (FileAccess::SceneWritten, path));
    let (access, path) = scene.or_else(|| Some((FileAccess::KeyframesWritten, line.strip_prefix(mark::WROTE)?)))?;
    Some((access, mark::unquoted(path)?))
}

/// What a recovery leaves that a signal ended: [`mark::RECOVERED`] as a line.
const INTERRUPTED: &[u8] = b"# played to the end\n";

/// Plays a journal that a program left: the editor that it leads to, and what the journal held. A line that ends this program as well
/// is passed over the next time.
///
/// # Errors
/// [`StorageError`]: the journal cannot be read.
pub fn recover(log: &LeftLog) -> Result<(Editor, Played, Vec<u8>), StorageError> {
    let bytes = log.read(super::LARGEST_READ_BYTES)?;
    let is_whole = bytes.ends_with(b"\n");
    // What is cut off stays a line of its own. Where the disk takes no mark, recovery is as good but once.
    let is_marked = is_whole && log.append(format!("{}\n", mark::RECOVERING).as_bytes()).is_ok();
    let bytes = if is_marked { log.read(super::LARGEST_READ_BYTES)? } else { bytes };
    // A signal is not the fault of the last line.
    let interrupted = if is_marked { log.append_when_ended(INTERRUPTED) } else { None };
    let (editor, played) = play_alone(&bytes);
    drop(interrupted);
    if is_marked {
        let _ = log.append(format!("{}\n", mark::RECOVERED).as_bytes());
    }
    Ok((editor, played, bytes))
}

/// Plays a journal with no files and no window.
#[must_use]
pub fn play_alone(bytes: &[u8]) -> (Editor, Played) {
    play_alone_observed(bytes, |_| {})
}

/// The same; `observe` gets the editor after each line, and after each comment that says what was written.
pub fn play_alone_observed(bytes: &[u8], mut observe: impl FnMut(&Editor)) -> (Editor, Played) {
    let scene = Arc::new(built_in_scene(DEFAULT_SCENE).expect("it is built in"));
    let mut runner = Runner::new(Nowhere::new(Editor::new(scene, PathBuf::new())));
    let Ok(played) = play_each::<_, Infallible>(bytes, &mut runner, |_, runner| {
        observe(runner.host().editor());
        Ok(())
    });
    (runner.into_host().into_editor(), played)
}

/// A hash of what a journal must bring back: the document, what its files lack, what is chosen and from which eye it is
/// seen, and what can be undone.
#[must_use]
pub fn fingerprint(editor: &Editor) -> String {
    use sha2::Digest as _;
    let document = editor.document();
    // A drag of the work eye is one line, written at its end.
    let session = Session { work_eye: WorkEye::default(), ..editor.session().clone() };
    let (interpolation, ms) = (document.interpolation, document.ms_between_keyframes);
    let keyframes = keyframes_to_json(editor.scene(), &document.keyframes, interpolation, ms);
    let rest = format!(
        "{:?}",
        (
            &document.live_pose,
            document.keyframes.current(),
            session,
            (editor.undo_label(), editor.redo_label()),
            (editor.has_unsaved_keyframes(), editor.has_unsaved_scene()),
            editor.keyframe_file(),
        )
    );
    let hash = sha2::Sha256::digest([keyframes, scene_to_json(editor.scene()), rest].join("\n"));
    hash.iter().take(8).fold(String::new(), |text, byte| text + &format!("{byte:02x}"))
}
