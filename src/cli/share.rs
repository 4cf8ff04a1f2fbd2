//! `inbetween share`: the page with an animation in it, and perhaps its own report.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde_json::json;

use super::arguments::ShareArguments;
use super::grade::{PublicReport, public_report};
use super::places::Places;
use super::told::{Report, write_keyframes};
use super::{CliError, Common, misuse, reading, scene};
use crate::files;
use crate::grading::Points;
use crate::interpolation::Interpolation;
use crate::keyframe::{Animation, DEFAULT_MS_BETWEEN_KEYFRAMES, KeyframeList};
use crate::scene::{DEFAULT_SCENE, SceneGraph, scene_to_json};
use crate::storage::{self, EntryKind, input_name, output_name};
use crate::words::texts;

/// The page's first file.
const INDEX: &str = "index.html";
/// The compiled program: what tells the page's folder.
const PROGRAM: &str = "inbetween_bg.wasm";
/// Where the index takes in what to show.
const MARK: &str = "<!-- shown -->";
/// What is written beside the page's files.
const ANIMATION: &str = "animation.json";
const REFERENCE: &str = "reference.json";
const SCENE: &str = "scene.json";
const REPORT: &str = "report.html";
/// The largest file of the page.
const LARGEST_BYTES: u64 = 256 << 20;
/// The most files of one folder of the page.
const MOST_FILES: usize = 1000;

/// Writes the page's folder, and prints the report.
///
/// # Errors
/// [`CliError`]: bad keyframes, no page, an output with other files in it or that cannot be written.
pub fn run(arguments: &ShareArguments, common: Common<'_>) -> Result<(), CliError> {
    let ShareArguments { file, output, compare, report, with_marks, page, json } = arguments;
    if storage::is_standard(output) {
        return Err(misuse(&texts::places_no_folder("--output").to_string()));
    }
    let places = Places::with_scene(common.scene).reads("FILE", file);
    let places = report.iter().fold(places, |places, file| places.reads("--report", file));
    let places = compare.iter().fold(places, |places, file| places.reads("--compare", file));
    // Also what is removed: nothing that is read may be lost.
    let written = [INDEX, ANIMATION, REFERENCE, SCENE, REPORT].map(|name| output.join(name));
    written.iter().fold(places, |places, path| places.writes_once(output_name(path), path)).check()?;
    let folder = match page {
        Some(folder) => folder.clone(),
        None => usual_page(),
    };
    if !storage::exists(&folder.join(PROGRAM)) {
        return Err(CliError::bad_input(folder.display(), texts::SHARE_NO_PAGE));
    }
    if !is_free(output)? {
        return Err(CliError::bad_input(output_name(output), texts::SHARE_NOT_EMPTY));
    }
    let graph = scene::load(common.scene)?;
    let points = if *with_marks { Points::Shown } else { Points::Hidden };
    let report = report.as_ref().map(|rubric| public_report(rubric, file, points, common)).transpose()?;
    let (animation, report) = match report {
        Some(PublicReport { html, keyframes }) => (submitted(file, keyframes, &graph)?, Some(html)),
        None => (animation(file, &graph, common)?, None),
    };
    let reference = compare.as_ref().map(|file| self::animation(file, &graph, common)).transpose()?;
    let has_scene = scene::file_of(common.scene).is_some() || graph.name() != DEFAULT_SCENE;
    copy(&folder, output)?;
    let mut shown = json!({"file": ANIMATION});
    write_keyframes(&output.join(ANIMATION), &graph, animation)?;
    if let Some(reference) = reference {
        shown["compare"] = json!(REFERENCE);
        write_keyframes(&output.join(REFERENCE), &graph, reference)?;
    }
    if has_scene {
        shown["scene"] = json!(SCENE);
        files::write(&output.join(SCENE), scene_to_json(&graph).as_bytes())?;
    }
    let mut head = format!("<script>shown = {shown};</script>");
    if let Some(html) = report {
        shown["report"] = json!(REPORT);
        files::write(&output.join(REPORT), html.as_bytes())?;
        let _ = write!(head, "\n<nav><a href=\"{REPORT}\" target=\"_blank\">{}</a></nav>", texts::SHARE_REPORT);
    }
    // What was shared before, and is not any more, would stay published.
    for (key, file) in [("compare", REFERENCE), ("scene", SCENE), ("report", REPORT)] {
        let path = output.join(file);
        if shown.get(key).is_none() && storage::exists(&path) {
            storage::remove(&path).map_err(|reason| CliError::unwritten(&path, reason))?;
        }
    }
    let index = output.join(INDEX);
    let text = storage::read(&index, LARGEST_BYTES).map_err(|reason| CliError::unwritten(&index, reason))?;
    // JSON in a script: "</" would end it, and the names are ours.
    let text = String::from_utf8_lossy(&text).replace(MARK, &head);
    files::write(&index, text.as_bytes())?;
    let notes = vec![texts::share_written(output_name(output))];
    let fields = json!({"output": output_name(output), "files": shown});
    Report { name: input_name(file), notes, fields, is_json: *json, data: Vec::new() }.tell(common)
}

/// The keyframes of a submission. A keyframe file says how it plays; of a folder or an archive only the keyframes are known.
fn submitted(file: &Path, keyframes: KeyframeList, scene: &SceneGraph) -> Result<Animation, CliError> {
    let animation = Animation::load(file, scene, None).unwrap_or_else(|_| Animation {
        keyframes,
        interpolation: Interpolation::default(),
        ms_between_keyframes: DEFAULT_MS_BETWEEN_KEYFRAMES,
    });
    animation.play_range(file)?;
    Ok(animation)
}

fn animation(file: &Path, scene: &SceneGraph, common: Common<'_>) -> Result<Animation, CliError> {
    let animation = Animation::of(reading::keyframes(file, scene, common)?.file, None);
    animation.play_range(file)?;
    Ok(animation)
}

/// Beside the folder of the program, as packages have it; in a checkout, in the target folder.
fn usual_page() -> PathBuf {
    let program = std::env::current_exe().unwrap_or_default();
    let above = program.parent().and_then(Path::parent).unwrap_or(Path::new(""));
    let packaged = above.join("share/inbetween/web");
    let built = above.join("web");
    if !storage::exists(&packaged) && storage::exists(&built.join(PROGRAM)) { built } else { packaged }
}

/// Whether nothing is in a folder but a page that was shared before.
fn is_free(folder: &Path) -> Result<bool, CliError> {
    if !storage::exists(folder) {
        return Ok(true);
    }
    let listed = storage::list(folder, MOST_FILES).map_err(|reason| CliError::unwritten(folder, reason))?;
    Ok(listed.0.is_empty() || storage::exists(&folder.join(PROGRAM)))
}

fn copy(from: &Path, to: &Path) -> Result<(), CliError> {
    storage::create_folder(to).map_err(|reason| CliError::unwritten(to, reason))?;
    let (entries, _) =
        storage::list(from, MOST_FILES).map_err(|reason| CliError::bad_input(from.display(), reason.message()))?;
    for entry in entries {
        let target = to.join(&entry.name);
        if entry.kind == EntryKind::Folder {
            copy(&entry.path, &target)?;
        } else {
            let bytes = storage::read(&entry.path, LARGEST_BYTES);
            let bytes = bytes.map_err(|reason| CliError::bad_input(entry.path.display(), reason.message()))?;
            files::write(&target, &bytes)?;
        }
    }
    Ok(())
}
