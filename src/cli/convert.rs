//! `inbetween convert`: keyframes from any layout of text to a keyframe file, and from either to a layout of text.

use std::fmt::Display;
use std::path::Path;
use std::sync::Arc;

use super::arguments::ConvertArguments;
use super::places::Places;
use super::{CliError, output, scene};
use crate::files::{self, FileError};
use crate::keyframe::{Keyframe, KeyframeFile, KeyframesText, LARGEST_FILE_BYTES};
use crate::scene::SceneGraph;
use crate::storage;
use crate::text_layouts::{
    Certainty, Finding, GroupChoice, Imported, JointList, KeyframeText, Layout, Options, Report, import,
};
use crate::words::texts;

/// The largest list of joints that is read: 16 MiB.
const LARGEST_LIST_BYTES: u64 = 16 << 20;

/// Reads IN, writes the output, and prints what was inferred: a line of what was read and one for each finding.
///
/// # Errors
/// [`CliError`]: bad input, with nothing written; an output that cannot be written.
pub fn run(arguments: &ConvertArguments, scene: Option<&Path>) -> Result<(), CliError> {
    places(arguments, scene).check()?;
    let scene = &scene::load(scene)?;
    let input = storage::input_name(&arguments.input);
    let joints = arguments.joints.as_deref().map(|file| joint_list(file, scene)).transpose()?;
    let options = Options {
        order: arguments.order,
        joints,
        salvage: arguments.salvage,
        group: arguments.group.map_or(GroupChoice::Only, GroupChoice::Number),
        file_name: input.clone(),
    };
    let imported = {
        let bytes = files::read(&arguments.input, LARGEST_FILE_BYTES)?;
        import(&bytes, scene, &options).map_err(|error| FileError::all(&input, error.sentences()))?
    };
    let report = match imported {
        Imported::KeyframeFile(file) => {
            let report = keyframe_file_report(&file, scene, &options, arguments.to);
            write_keyframes(arguments, scene, file)?;
            report
        }
        Imported::Text(file, mut report) => {
            if options.group != GroupChoice::Only {
                let text = "a text has no groups: --group is for programs in Python".to_owned();
                report.findings.push(Finding { certainty: Certainty::Note, text });
            }
            write_keyframes(arguments, scene, file)?;
            report
        }
        Imported::Scene(text, report) => {
            if let Some(layout) = arguments.to {
                let problem =
                    format!("keys of a control node, which the layout {} cannot hold: leave out --to", layout.name());
                return Err(CliError::bad_input(&input, problem));
            }
            write(&arguments.output, &text)?;
            report
        }
    };
    output::say_beside(Some(&arguments.output), &format!("{input}: {report}\n"))
}

fn places(arguments: &ConvertArguments, scene: Option<&Path>) -> Places {
    let kind = if arguments.overwrite { "IN" } else { "--output" };
    let places = Places::with_scene(scene).reads("IN", &arguments.input);
    let places = arguments.joints.iter().fold(places, |places, joints| places.reads("--joints", joints));
    places.writes_as("--output".to_owned(), kind, &arguments.output)
}

fn joint_list(file: &Path, scene: &SceneGraph) -> Result<JointList, FileError> {
    let bytes = files::read(file, LARGEST_LIST_BYTES)?;
    JointList::from_text(&bytes, scene).map_err(|error| FileError::new(storage::input_name(file), error))
}

fn keyframe_file_report(file: &KeyframeFile, scene: &SceneGraph, options: &Options, to: Option<Layout>) -> Report {
    let (keyframes, nodes) = (file.keyframes.len(), scene.rbt_count());
    let mut findings = Vec::new();
    if options.order.is_some() || options.joints.is_some() || options.salvage || options.group != GroupChoice::Only {
        let text = "a keyframe file names its nodes and fields: --order, --joints, --salvage and --group are for texts"
            .to_owned();
        findings.push(Finding { certainty: Certainty::Note, text });
    }
    let has_settings = file.interpolation.is_some() || file.ms_between_keyframes.is_some();
    if to.is_some() && (has_settings || file.keyframes.iter().any(Keyframe::has_extras)) {
        let text = "a text has poses alone: interpolation, times, names and easings are left out".to_owned();
        findings.push(Finding { certainty: Certainty::Note, text });
    }
    Report { summary: texts::file_own_summary(texts::count_keyframes(keyframes), nodes), findings }
}

fn write_keyframes(arguments: &ConvertArguments, scene: &SceneGraph, file: KeyframeFile) -> Result<(), CliError> {
    let Some(layout) = arguments.to else {
        let (keyframes, interpolation, ms_between_keyframes) = file.into_parts();
        let scene = Arc::new(scene.clone());
        let text = KeyframesText { scene, keyframes, interpolation, ms_between_keyframes };
        if !text.can_be_read() {
            let problem =
                format!("{} MiB, the most that is read, would not hold the keyframes", LARGEST_FILE_BYTES >> 20);
            return Err(CliError::bad_input(arguments.output.display(), problem));
        }
        return write(&arguments.output, &text);
    };
    if file.keyframes.is_empty() && !layout.can_be_empty() {
        let names: Vec<&str> =
            Layout::WRITTEN.into_iter().filter(|layout| layout.can_be_empty()).map(Layout::name).collect();
        let problem = format!("there are no keyframes, and only {} can say so", names.join(", "));
        return Err(CliError::bad_input(storage::input_name(&arguments.input), problem));
    }
    let text = KeyframeText { keyframes: &file.keyframes, nodes: scene.rbt_count(), layout, is_exact: arguments.exact };
    write(&arguments.output, &text)
}

/// Writes what is displayed as it is made, so that no text of the output's size is held.
fn write(path: &Path, text: &impl Display) -> Result<(), CliError> {
    storage::write_with(path, |file| write!(file, "{text}")).map_err(|reason| CliError::unwritten(path, reason))
}
