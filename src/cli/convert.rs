//! `inbetween convert`: keyframes from any layout of text to a keyframe file, and from either to a layout of text.

use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde_json::json;

use super::arguments::ConvertArguments;
use super::each::{Done, Telling, each, tell};
use super::places::Places;
use super::targets::{ending_of, make_folder, targets};
use super::{CliError, Common, Ended, misuse, scene};
use crate::files::{self, FileError};
use crate::keyframe::{Keyframe, KeyframeFile, KeyframesText, LARGEST_FILE_BYTES};
use crate::scene::SceneGraph;
use crate::storage::{self, input_name};
use crate::text_layouts::{
    Certainty, Finding, GroupChoice, Imported, JointList, KeyframeText, Layout, Options, Report, import,
};
use crate::words::texts;

/// The largest list of joints that is read: 16 MiB.
const LARGEST_LIST_BYTES: u64 = 16 << 20;

/// Reads each IN, writes its output, and prints what was inferred: a line of what was read and one for each finding.
///
/// # Errors
/// [`CliError`]: bad input, with nothing written for it; an output that cannot be written.
pub fn run(arguments: &ConvertArguments, common: Common<'_>) -> Result<Ended, CliError> {
    let layout = layout_of(arguments)?;
    let inputs = &arguments.inputs;
    let ending = layout.map_or("json", |layout| if layout == Layout::Csv { "csv" } else { "txt" });
    let targets = targets(inputs, &arguments.output, ending, false)?;
    places(arguments, &targets, common).check()?;
    let scene = &scene::load(common.scene)?;
    let joints = arguments.joints.as_deref().map(|file| joint_list(file, scene)).transpose()?;
    let options = Options {
        order: arguments.order,
        joints,
        salvage: arguments.salvage,
        group: arguments.group.map_or(GroupChoice::Only, GroupChoice::Number),
        file_name: String::new(),
    };
    let jobs: Vec<(&PathBuf, &PathBuf)> = inputs.iter().zip(&targets).collect();
    let shown = |(input, _): &(&PathBuf, &PathBuf)| input_name(input);
    let named = |(input, _): &(&PathBuf, &PathBuf)| json!({"file": input_name(input)});
    let outcomes = each(&jobs, common, shown, named, |&(input, target), notes| {
        let conversion = Conversion { arguments, scene, layout, input, target };
        let report = conversion.run(&Options { file_name: input_name(input), ..options.clone() })?;
        let mut fields = report.json();
        fields["output"] = json!(storage::output_name(target));
        let name = input_name(input);
        if common.is_quiet {
            notes.warn(&name, report.warnings());
            return Ok(Done::well(String::new(), fields));
        }
        Ok(Done::well(format!("{name}: {report}\n"), fields))
    })?;
    tell(outcomes, Telling { is_json: arguments.json, data: Some(&arguments.output) })
}

/// The layout to write: that of --to, or that of the output's ending; `None` for a keyframe file.
fn layout_of(arguments: &ConvertArguments) -> Result<Option<Layout>, CliError> {
    let ending = ending_of(&arguments.output, arguments.inputs.len()).unwrap_or_default();
    let of_ending = match ending.as_str() {
        "csv" => Some(Layout::Csv),
        "txt" => Some(Layout::Header),
        _ => None,
    };
    let Some(to) = arguments.to else { return Ok(of_ending) };
    let is_contradiction = match ending.as_str() {
        "json" => true,
        "csv" => to != Layout::Csv,
        _ => false,
    };
    if is_contradiction {
        let option = format!("--to {}", to.name());
        return Err(misuse(&texts::places_ending_contradicts(ending, option).to_string()));
    }
    Ok(Some(to))
}

fn places(arguments: &ConvertArguments, targets: &[PathBuf], common: Common<'_>) -> Places {
    let kind = if arguments.overwrite { "IN" } else { "--output" };
    let places = Places::with_scene(common.scene);
    let places = arguments.inputs.iter().fold(places, |places, input| places.reads("IN", input));
    let places = arguments.joints.iter().fold(places, |places, joints| places.reads("--joints", joints));
    targets.iter().fold(places, |places, target| places.writes_as("--output".to_owned(), kind, target))
}

fn joint_list(file: &Path, scene: &SceneGraph) -> Result<JointList, FileError> {
    let bytes = files::read(file, LARGEST_LIST_BYTES)?;
    JointList::from_text(&bytes, scene).map_err(|error| FileError::new(input_name(file), error))
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

/// One input and its output.
struct Conversion<'a> {
    arguments: &'a ConvertArguments,
    scene: &'a SceneGraph,
    layout: Option<Layout>,
    input: &'a Path,
    target: &'a Path,
}

impl Conversion<'_> {
    fn run(&self, options: &Options) -> Result<Report, CliError> {
        let input = input_name(self.input);
        let imported = {
            let bytes = files::read(self.input, LARGEST_FILE_BYTES)?;
            import(&bytes, self.scene, options).map_err(|error| FileError::all(&input, error.sentences()))?
        };
        match imported {
            Imported::KeyframeFile(file) => {
                let report = keyframe_file_report(&file, self.scene, options, self.layout);
                self.write_keyframes(file)?;
                Ok(report)
            }
            Imported::Text(file, mut report) => {
                if options.group != GroupChoice::Only {
                    let text = "a text has no groups: --group is for programs in Python".to_owned();
                    report.findings.push(Finding { certainty: Certainty::Note, text });
                }
                self.write_keyframes(file)?;
                Ok(report)
            }
            Imported::Scene(text, report) => {
                if let Some(layout) = self.layout {
                    return Err(CliError::bad_input(&input, texts::convert_no_scene(layout.name())));
                }
                self.write(&text)?;
                Ok(report)
            }
        }
    }

    fn write_keyframes(&self, file: KeyframeFile) -> Result<(), CliError> {
        let Some(layout) = self.layout else {
            let (keyframes, interpolation, ms_between_keyframes) = file.into_parts();
            let scene = Arc::new(self.scene.clone());
            let text = KeyframesText { scene, keyframes, interpolation, ms_between_keyframes };
            if !text.can_be_read() {
                let problem = texts::model_too_large(LARGEST_FILE_BYTES >> 20);
                return Err(CliError::bad_input(self.target.display(), problem));
            }
            return self.write(&text);
        };
        if file.keyframes.is_empty() && !layout.can_be_empty() {
            let names: Vec<&str> =
                Layout::WRITTEN.into_iter().filter(|layout| layout.can_be_empty()).map(Layout::name).collect();
            let problem = format!("there are no keyframes, and only {} can say so", names.join(", "));
            return Err(CliError::bad_input(input_name(self.input), problem));
        }
        let nodes = self.scene.rbt_count();
        self.write(&KeyframeText { keyframes: &file.keyframes, nodes, layout, is_exact: self.arguments.exact })
    }

    /// Writes what is displayed as it is made, so that no text of the output's size is held.
    fn write(&self, text: &impl Display) -> Result<(), CliError> {
        make_folder(&self.arguments.output, self.target)?;
        storage::write_with(self.target, |file| write!(file, "{text}"))
            .map_err(|reason| CliError::unwritten(self.target, reason))
    }
}
