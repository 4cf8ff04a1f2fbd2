//! `inbetween grade`: a folder of submissions, marked by a rubric.

mod beginning;
mod class;
mod kept;
mod public;
mod studio;
mod summary;

use std::env;
use std::path::{Path, PathBuf};

pub use self::public::{PublicReport, report as public_report};

use self::class::{Class, SHARD};
use self::summary::Summary;
use super::arguments::GradeArguments;
use super::places::Places;
use super::{CliError, Common, Ended, misuse, output};
use crate::files;
use crate::grading::{self, Feedback, Given, GradedClass, ResultFile, Roster};
use crate::storage;
use crate::words::texts;

/// Grades, and writes `grades.csv`, `grades.json` and `report.html`. It ends as `--strict` and `--fail-under` ask, and writes everything
/// before.
///
/// # Errors
/// [`CliError`]: a bad rubric, a submission that is not there, no GPU adapter for the pictures, a result that cannot be written. What
/// is wrong with a submission is no error but its marks.
pub fn run(arguments: &GradeArguments, common: Common<'_>) -> Result<Ended, CliError> {
    if let Some(folder) = &arguments.example {
        return beginning::write_example(folder, common).map(|()| Ended::Well);
    }
    if let (true, Some(rubric)) = (arguments.check, &arguments.rubric) {
        return beginning::check(rubric, arguments.json, common.scene).map(|()| Ended::Well);
    }
    let Some(folder) = &arguments.output else { return Ok(Ended::Well) };
    let folders = [("--output", &arguments.output), ("--feedback", &arguments.feedback), ("--cache", &arguments.cache)];
    let merged = arguments.merge.iter().map(|folder| ("--merge", folder));
    let folders = folders.iter().filter_map(|(name, path)| Some((*name, path.as_ref()?)));
    if let Some((name, _)) = folders.chain(merged).find(|(_, path)| storage::is_standard(path)) {
        return Err(misuse(&texts::places_no_folder(name).to_string()));
    }
    let given = given(arguments);
    if let Some(problem) = arguments.to.iter().find_map(|format| (format.problem)(&given)) {
        return Err(misuse(&problem.to_string()));
    }
    own_places(arguments, folder, common.scene).check()?;
    let roster = arguments.roster.as_deref().map(Roster::load).transpose()?;
    let class = match &arguments.rubric {
        Some(rubric) => class::graded(arguments, rubric, folder, common)?,
        None => class::merged(&arguments.merge, arguments.overrides.clone())?,
    };
    match arguments.shard {
        Some(shard) => class::write_shard(class, shard, folder, common).map(|()| Ended::Well),
        None => write(class, roster.as_ref(), arguments, folder, &given, common),
    }
}

/// Writes the results of a class, and says what is to be said of them.
fn write(
    class: Class,
    roster: Option<&Roster>,
    arguments: &GradeArguments,
    folder: &Path,
    given: &Given,
    common: Common<'_>,
) -> Result<Ended, CliError> {
    let Class { mut graded, left_out, mut studio, kept, .. } = class;
    let GradedClass { marks, rubric, overrides, passed_over, .. } = &mut graded;
    let matched = roster.map(|roster| roster.apply(marks, rubric)).unwrap_or_default();
    if !left_out.is_empty() {
        // Who is left out may have handed something in.
        marks.retain(|marks| !marks.is_missing);
    }
    let unmatched = overrides.as_ref().map(|overrides| overrides.apply(marks)).unwrap_or_default();
    if let Some(late) = &rubric.late {
        late.apply(marks);
    }
    let key = arguments.anonymous.then(|| grading::make_anonymous(marks, passed_over));
    let films = studio.films(&mut graded)?;
    let GradedClass { marks, rubric, passed_over, .. } = &graded;
    files::create_folder(folder)?;
    let [table, json, report] = results(folder);
    files::write(&table, grading::csv(marks, arguments.wide).as_bytes())?;
    let results = grading::json(marks, passed_over, rubric);
    files::write(&json, results.as_bytes())?;
    files::write(&report, grading::html(marks, passed_over, rubric, &films).as_bytes())?;
    for format in &arguments.to {
        for ResultFile { path, text } in (format.files)(marks, rubric, given) {
            let path = folder.join(path);
            files::create_folder(path.parent().unwrap_or(folder))?;
            files::write(&path, text.as_bytes())?;
        }
    }
    if let Some(folder) = &arguments.feedback {
        files::create_folder(folder)?;
        for Feedback { name, html, markdown } in grading::feedback(marks, rubric, &films) {
            files::write(&folder.join(format!("{name}.html")), html.as_bytes())?;
            files::write(&folder.join(format!("{name}.md")), markdown.as_bytes())?;
        }
    }
    if let (Some(path), Some(key)) = (&arguments.key, key) {
        files::write(path, key.as_bytes())?;
    }
    kept::write(kept.as_deref(), &graded.cache)?;
    if arguments.json {
        output::list(&results)?;
    } else if common.is_quiet {
        output::say(&summary::failures(&graded.marks, arguments))?;
    } else {
        let summary = Summary { class: &graded, matched: &matched, unmatched: &unmatched, left_out: &left_out };
        output::say(&summary.lines(&report, arguments))?;
    }
    Ok(summary::ending(&graded.marks, arguments))
}

/// What the forms of results need beside the marks.
fn given(arguments: &GradeArguments) -> Given {
    let variables = arguments.to.iter().flat_map(|format| format.variables);
    let set = variables.filter_map(|name| Some((*name, env::var(name).ok().filter(|value| !value.is_empty())?)));
    Given { assignment: arguments.assignment.clone(), environment: set.collect() }
}

/// The files that are always written.
fn results(folder: &Path) -> [PathBuf; 3] {
    ["grades.csv", "grades.json", "report.html"].map(|name| folder.join(name))
}

/// Where it reads and writes, as far as the arguments say.
fn own_places(arguments: &GradeArguments, folder: &Path, scene: Option<&Path>) -> Places {
    let places = Places::with_scene(scene);
    let places = arguments.rubric.iter().fold(places, |places, path| places.reads("RUBRIC", path));
    let places = arguments.roster.iter().fold(places, |places, path| places.reads("--roster", path));
    let overrides = match &arguments.rubric {
        Some(rubric) => class::overrides(arguments, rubric),
        None => arguments.overrides.clone(),
    };
    let places = overrides.iter().fold(places, |places, path| places.reads("--overrides", path));
    let standard = arguments.submissions.iter().filter(|path| storage::is_standard(path));
    let places = standard.fold(places, |places, path| places.reads("SUBMISSION", path));
    let shards = arguments.merge.iter().map(|folder| folder.join(SHARD));
    let places = shards.fold(places, |places, path| places.reads("--merge", &path));
    let written = match arguments.shard {
        Some(_) => vec![folder.join(SHARD)],
        None => results(folder).into_iter().chain(arguments.key.clone()).collect(),
    };
    written.iter().fold(places, |places, path| places.writes_once(storage::output_name(path), path))
}
