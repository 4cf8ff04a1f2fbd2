//! `inbetween grade`: a folder of submissions, marked by a rubric.

mod beginning;
mod summary;

use std::env;
use std::path::{Path, PathBuf};

use super::arguments::GradeArguments;
use super::places::Places;
use super::progress::Progress;
use super::{CliError, Common, Ended, misuse, output};
use crate::export::Painter;
use crate::files::{self, scene};
use crate::grading::{
    self, Feedback, Found, Given, Naming, Overrides, ReportPictures, ResultFile, Roster, Rubric, Studio,
    USUAL_OVERRIDES,
};
use crate::storage;
use crate::words::texts;

/// Grades, and writes `grades.csv`, `grades.json` and `report.html`. It ends as `--strict` and `--fail-under` ask, and writes everything
/// before.
///
/// # Errors
/// [`CliError`]: a bad rubric, a submission that is not there, no GPU adapter for the pictures, a result that cannot be written. What
/// is wrong with a submission is no error but its marks.
pub fn run(arguments: &GradeArguments, common: Common<'_>) -> Result<Ended, CliError> {
    let named_scene = common.scene;
    if let Some(folder) = &arguments.example {
        return beginning::write_example(folder, common).map(|()| Ended::Well);
    }
    let Some(rubric_path) = &arguments.rubric else { return Ok(Ended::Well) };
    if arguments.check {
        return beginning::check(rubric_path, arguments.json, named_scene).map(|()| Ended::Well);
    }
    let Some(folder) = &arguments.output else { return Ok(Ended::Well) };
    let own_places = || {
        let places = places(arguments, rubric_path, folder, named_scene);
        match &arguments.key {
            Some(key) => places.writes_once(storage::output_name(key), key),
            None => places,
        }
    };
    if storage::is_standard(folder) {
        return Err(misuse(&texts::places_no_folder("--output").to_string()));
    }
    if arguments.feedback.as_deref().is_some_and(storage::is_standard) {
        return Err(misuse(&texts::places_no_folder("--feedback").to_string()));
    }
    let given = given(arguments);
    if let Some(problem) = arguments.to.iter().find_map(|format| (format.problem)(&given)) {
        return Err(misuse(&problem.to_string()));
    }
    own_places().check()?;
    let painter = if arguments.no_images { None } else { Some(Painter::headless(arguments.image_size, None)?) };
    let scene = scene::load(named_scene)?;
    let rubric = Rubric::load(rubric_path, &scene)?;
    let overrides = overrides(arguments, rubric_path).map(|path| Overrides::load(&path, &rubric)).transpose()?;
    let roster = arguments.roster.as_deref().map(Roster::load).transpose()?;
    let naming = match (arguments.one, arguments.classes) {
        (true, _) => Naming::One,
        (_, true) => Naming::Classes,
        _ => Naming::Guessed,
    };
    let Found { submissions, mut passed_over } = grading::find(&arguments.submissions, naming, &rubric.keyframe_file)?;
    let places = rubric
        .files
        .iter()
        .fold(own_places(), |places, file| places.reads_as(storage::input_name(file), "a file of the rubric", file));
    // Standard input is among the arguments.
    let named = submissions.iter().flat_map(|one| one.paths().map(|path| (one.name.clone(), path)));
    named.fold(places, |places, (name, path)| places.reads_as(name, "SUBMISSION", path)).check()?;
    let mut marks = grading::mark_all(&submissions, &rubric, &scene);
    let matched = roster.map(|roster| roster.apply(&mut marks, &rubric)).unwrap_or_default();
    let unmatched = overrides.map(|overrides| overrides.apply(&mut marks)).unwrap_or_default();
    if let Some(late) = &rubric.late {
        late.apply(&mut marks);
    }
    let key = arguments.anonymous.then(|| grading::make_anonymous(&mut marks, &mut passed_over));
    let mut pictures = ReportPictures::default();
    if let Some(painter) = painter {
        let mut studio = Studio::new(painter, &rubric, &scene)?;
        let mistakes = grading::mistakes_shown(&marks);
        let mut progress = Progress::of_items("submission", marks.len(), common);
        for marks in &marks {
            progress.begin(&marks.name);
            let most = usize::from(arguments.images);
            pictures.of_submissions.push(grading::pictures_of(marks, &rubric, &scene, &mut studio, most)?);
            progress.step();
        }
        for mistake in &mistakes {
            pictures.of_mistakes.push(grading::film_of(mistake, &marks, &rubric, &scene, &mut studio)?);
        }
    }
    files::create_folder(folder)?;
    let [table, json, report] = results(folder);
    files::write(&table, grading::csv(&marks, arguments.wide).as_bytes())?;
    let results = grading::json(&marks, &passed_over, &rubric);
    files::write(&json, results.as_bytes())?;
    files::write(&report, grading::html(&marks, &passed_over, &rubric, &pictures).as_bytes())?;
    for format in &arguments.to {
        for ResultFile { path, text } in (format.files)(&marks, &rubric, &given) {
            let path = folder.join(path);
            files::create_folder(path.parent().unwrap_or(folder))?;
            files::write(&path, text.as_bytes())?;
        }
    }
    if let Some(folder) = &arguments.feedback {
        files::create_folder(folder)?;
        for Feedback { name, html, markdown } in grading::feedback(&marks, &rubric, &pictures) {
            files::write(&folder.join(format!("{name}.html")), html.as_bytes())?;
            files::write(&folder.join(format!("{name}.md")), markdown.as_bytes())?;
        }
    }
    if let (Some(path), Some(key)) = (&arguments.key, key) {
        files::write(path, key.as_bytes())?;
    }
    if arguments.json {
        output::list(&results)?;
    } else if !common.is_quiet {
        output::say(&summary::lines(&marks, &matched, &unmatched, &passed_over, &rubric, &report, arguments))?;
    }
    Ok(summary::ending(&marks, arguments))
}

/// The file of overrides: the one that is named, or the usual one beside the rubric if it is there.
fn overrides(arguments: &GradeArguments, rubric: &Path) -> Option<PathBuf> {
    let usual = (!storage::is_standard(rubric)).then(|| rubric.with_file_name(USUAL_OVERRIDES));
    arguments.overrides.clone().or_else(|| usual.filter(|path| storage::exists(path)))
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
fn places(arguments: &GradeArguments, rubric: &Path, folder: &Path, scene: Option<&Path>) -> Places {
    let places = Places::with_scene(scene).reads("RUBRIC", rubric);
    let places = arguments.roster.iter().fold(places, |places, path| places.reads("--roster", path));
    let places = overrides(arguments, rubric).iter().fold(places, |places, path| places.reads("--overrides", path));
    let standard = arguments.submissions.iter().filter(|path| storage::is_standard(path));
    let places = standard.fold(places, |places, path| places.reads("SUBMISSION", path));
    results(folder).iter().fold(places, |places, path| places.writes_once(storage::output_name(path), path))
}
