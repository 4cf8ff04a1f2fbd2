//! The class that `grade` writes results of: graded now, kept by earlier runs, or merged of shards.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::studio::LazyStudio;
use super::{kept, own_places};
use crate::cli::arguments::GradeArguments;
use crate::cli::{CliError, Common, output};
use crate::decode;
use crate::files::{self, FileError, scene};
use crate::grading::{
    self, Basis, Found, GradedClass, Images, LARGEST_OVERRIDES_BYTES, Marks, Naming, Overrides, Rubric, Shard,
    ShardNumber, Submission, USUAL_OVERRIDES,
};
use crate::storage;
use crate::words::texts;

/// The name of the file that a shard is.
pub const SHARD: &str = "shard.json";
/// The largest shard: 1 GiB.
const LARGEST_SHARD_BYTES: u64 = 1 << 30;
/// The largest table of earlier results that is looked at: 512 MiB.
const LARGEST_GRADES_BYTES: u64 = 512 << 20;

/// A class with what belongs to this run.
pub struct Class {
    /// The class.
    pub graded: GradedClass,
    /// The names of all its submissions, graded or not.
    pub names: Vec<String>,
    /// The names of submissions that are not in the results, as the arguments ask for others alone.
    pub left_out: Vec<String>,
    /// Draws pictures.
    pub studio: LazyStudio,
    /// Where results are kept for the next run; `None` if nowhere.
    pub kept: Option<PathBuf>,
}

/// Finds and grades the submissions, or takes what earlier runs have kept.
///
/// # Errors
/// [`CliError`]: a bad rubric, a submission that is not there, no GPU adapter for the pictures.
pub fn graded(
    arguments: &GradeArguments,
    rubric_path: &Path,
    folder: &Path,
    common: Common<'_>,
) -> Result<Class, CliError> {
    let scene = scene::load(common.scene)?;
    let rubric = Rubric::load(rubric_path, &scene)?;
    let overrides = read_overrides(overrides(arguments, rubric_path), &rubric)?;
    let naming = match (arguments.one, arguments.classes) {
        (true, _) => Naming::One,
        (_, true) => Naming::Classes,
        _ => Naming::Guessed,
    };
    let Found { submissions, passed_over } = grading::find(&arguments.submissions, naming, &rubric.keyframe_file)?;
    let places = rubric.files.iter().fold(own_places(arguments, folder, common.scene), |places, file| {
        places.reads_as(storage::input_name(file), "a file of the rubric", file)
    });
    // Standard input is among the arguments.
    let named = submissions.iter().flat_map(|one| one.paths().map(|path| (one.name.clone(), path)));
    named.fold(places, |places, (name, path)| places.reads_as(name, "SUBMISSION", path)).check()?;
    let (wide, high) = (arguments.image_size.width, arguments.image_size.height);
    let images = (!arguments.no_images).then_some(Images { most: arguments.images, size: (wide, high) });
    let file = kept::file(arguments, folder);
    let needs_program = file.is_some() || arguments.shard.is_some();
    let program = if needs_program { kept::program() } else { None };
    // What is kept of a program that cannot be told from others would serve these too.
    let file = file.filter(|_| program.is_some());
    let basis = Basis::new(program.unwrap_or_else(kept::version), &rubric, &scene, images);
    let cache = kept::read(file.as_deref(), &basis);
    let mut studio = LazyStudio::default();
    // A machine without a GPU adapter is told before anything is graded.
    if let Some(images) = images.filter(|_| cache.is_empty()) {
        studio.get(images, &rubric, &scene)?;
    }
    let names: Vec<String> = submissions.iter().map(|one| one.name.clone()).collect();
    let submissions = match arguments.shard {
        Some(shard) => {
            let numbered = submissions.into_iter().enumerate();
            numbered.filter(|(index, _)| shard.has(*index)).map(|(_, one)| one).collect()
        }
        None => submissions,
    };
    let (marks, left_out) = marked(arguments, &submissions, folder, |is_wanted| {
        grading::mark_all(&submissions, is_wanted, &rubric, &scene, &cache)
    })?;
    let mut graded = GradedClass { basis, scene, rubric, overrides, marks, passed_over, cache };
    studio.draw(&mut graded, common)?;
    Ok(Class { graded, names, left_out, studio, kept: file })
}

/// The marks of submissions, and the names of those that are neither asked for nor known.
fn marked(
    arguments: &GradeArguments,
    submissions: &[Submission],
    folder: &Path,
    mark: impl FnOnce(&(dyn Fn(&Submission) -> bool + Sync)) -> Vec<Option<Marks>>,
) -> Result<(Vec<Marks>, Vec<String>), CliError> {
    let is_called = |one: &Submission, name: &String| {
        one.name == *name || one.student.as_ref() == Some(name) || one.id.as_ref() == Some(name)
    };
    if let Some(name) = arguments.only.iter().find(|name| !submissions.iter().any(|one| is_called(one, name))) {
        return Err(CliError::bad_input("--only", texts::grade_only_nobody(name)));
    }
    let all = mark(&|one| arguments.only.is_empty() || arguments.only.iter().any(|name| is_called(one, name)));
    let left_out = submissions.iter().zip(&all).filter(|(_, marks)| marks.is_none()).map(|(one, _)| one.name.clone());
    let left_out: Vec<String> = left_out.collect();
    if !left_out.is_empty() {
        let [_, grades, _] = super::results(folder);
        let had = names_in(&grades);
        let lost: Vec<&str> = left_out.iter().map(String::as_str).filter(|name| had.contains(*name)).collect();
        if !lost.is_empty() {
            return Err(CliError::bad_input("--only", texts::grade_would_lose(grades.display(), lost.join(", "))));
        }
    }
    Ok((all.into_iter().flatten().collect(), left_out))
}

/// The names of the submissions in a table that an earlier run wrote.
fn names_in(grades: &Path) -> HashSet<String> {
    #[derive(Deserialize)]
    struct Grades {
        submissions: Vec<Named>,
    }
    #[derive(Deserialize)]
    struct Named {
        name: String,
    }
    let text = storage::read(grades, LARGEST_GRADES_BYTES).unwrap_or_default();
    let grades = decode::json::<Grades>(&text).map_or(Vec::new(), |grades| grades.submissions);
    grades.into_iter().map(|one| one.name).collect()
}

/// The class of the shards in folders, with overrides of a file instead of those that the shards hold.
///
/// # Errors
/// [`CliError`]: shards that cannot be read, or that do not go together.
pub fn merged(folders: &[PathBuf], overrides: Option<PathBuf>) -> Result<Class, CliError> {
    let read = |folder: &PathBuf| {
        let path = folder.join(SHARD);
        let name = path.display().to_string();
        let shard = Shard::read(&name, &files::read(&path, LARGEST_SHARD_BYTES)?)?;
        Ok((name, shard))
    };
    let parts: Vec<(String, Shard)> = folders.iter().map(read).collect::<Result<_, FileError>>()?;
    let mut graded = Shard::merged(&parts, &kept::program().unwrap_or_else(kept::version))?;
    if overrides.is_some() {
        graded.overrides = read_overrides(overrides, &graded.rubric)?;
    }
    Ok(Class { graded, names: Vec::new(), left_out: Vec::new(), studio: LazyStudio::default(), kept: None })
}

/// Writes a class as a shard, and says so.
///
/// # Errors
/// [`CliError`]: a film that cannot be drawn, a folder that cannot be written to.
pub fn write_shard(mut class: Class, shard: ShardNumber, folder: &Path, common: Common<'_>) -> Result<(), CliError> {
    class.studio.films(&mut class.graded)?;
    files::create_folder(folder)?;
    let path = folder.join(SHARD);
    files::write(&path, Shard::written(shard, &class.names, &class.graded).as_bytes())?;
    kept::write(class.kept.as_deref(), &class.graded.cache)?;
    if common.is_quiet {
        return Ok(());
    }
    let graded = class.graded.marks.len();
    output::say(&format!("{}\n", texts::grade_shard_written(shard.number, shard.of, graded, path.display())))
}

/// The file of overrides: the one that is named, or the usual one beside the rubric if it is there.
pub fn overrides(arguments: &GradeArguments, rubric: &Path) -> Option<PathBuf> {
    let usual = (!storage::is_standard(rubric)).then(|| rubric.with_file_name(USUAL_OVERRIDES));
    arguments.overrides.clone().or_else(|| usual.filter(|path| storage::exists(path)))
}

/// The overrides in a file, where there is one.
///
/// # Errors
/// [`FileError`]: it is bad.
pub fn read_overrides(path: Option<PathBuf>, rubric: &Rubric) -> Result<Option<Overrides>, FileError> {
    let read = |path: PathBuf| Overrides::read(&path, &files::read(&path, LARGEST_OVERRIDES_BYTES)?, rubric);
    path.map(read).transpose()
}
