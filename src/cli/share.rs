//! `inbetween share`: the page with an animation in it.

use std::path::{Path, PathBuf};

use serde_json::json;

use super::arguments::ShareArguments;
use super::places::Places;
use super::told::{Report, write_keyframes};
use super::{CliError, Common, misuse, reading, scene};
use crate::files;
use crate::keyframe::Animation;
use crate::scene::{DEFAULT_SCENE, SceneGraph, scene_to_json};
use crate::storage::{self, EntryKind, input_name, output_name};
use crate::words::texts;

/// The page's first file.
const INDEX: &str = "index.html";
/// The compiled program: what tells the page's folder.
const PROGRAM: &str = "inbetween_bg.wasm";
/// Where the index takes in what to show.
const MARK: &str = "<!-- shown -->";
/// The largest file of the page.
const LARGEST_BYTES: u64 = 256 << 20;
/// The most files of one folder of the page.
const MOST_FILES: usize = 1000;

/// Writes the page's folder, and prints the report.
///
/// # Errors
/// [`CliError`]: bad keyframes, no page, an output with other files in it or that cannot be written.
pub fn run(arguments: &ShareArguments, common: Common<'_>) -> Result<(), CliError> {
    let ShareArguments { file, output, compare, page, json } = arguments;
    if storage::is_standard(output) {
        return Err(misuse(&texts::places_no_folder("--output").to_string()));
    }
    let places = Places::with_scene(common.scene).reads("FILE", file);
    compare.iter().fold(places, |places, file| places.reads("--compare", file)).check()?;
    let graph = scene::load(common.scene)?;
    let animation = animation(file, &graph, common)?;
    let reference = compare.as_ref().map(|file| self::animation(file, &graph, common)).transpose()?;
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
    copy(&folder, output)?;
    let mut shown = json!({"file": "animation.json"});
    write_keyframes(&output.join("animation.json"), &graph, animation)?;
    if let Some(reference) = reference {
        shown["compare"] = json!("reference.json");
        write_keyframes(&output.join("reference.json"), &graph, reference)?;
    }
    if scene::file_of(common.scene).is_some() || graph.name() != DEFAULT_SCENE {
        shown["scene"] = json!("scene.json");
        files::write(&output.join("scene.json"), scene_to_json(&graph).as_bytes())?;
    }
    let index = output.join(INDEX);
    let text = storage::read(&index, LARGEST_BYTES).map_err(|reason| CliError::unwritten(&index, reason))?;
    // JSON in a script: "</" would end it, and the names are ours.
    let text = String::from_utf8_lossy(&text).replace(MARK, &format!("<script>shown = {shown};</script>"));
    files::write(&index, text.as_bytes())?;
    let notes = vec![texts::share_written(output_name(output))];
    let fields = json!({"output": output_name(output), "files": shown});
    Report { name: input_name(file), notes, fields, is_json: *json, data: Vec::new() }.tell(common)
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
