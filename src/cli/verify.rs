//! `inbetween verify`: compares pictures with the references in a folder.

mod github;
mod results;

use std::path::Path;

use super::arguments::VerifyArguments;
use super::places::Places;
use super::progress::Progress;
use super::{CliError, Common, Ended, misuse, output};
use crate::export::Painter;
use crate::files;
use crate::junit;
use crate::references::{self, Accepted, LIST_NAME, PAGE_NAME, References, Row, Shot, read_list};
use crate::storage;
use crate::words::{Message, texts};

/// Renders what the folder's list says and compares it with the references beside it, or takes it as them.
///
/// # Errors
/// [`CliError`]: no GPU adapter, a bad list, a folder or a result that cannot be written.
pub fn run(arguments: &VerifyArguments, common: Common<'_>) -> Result<Ended, CliError> {
    let scene = common.scene;
    let folder = &arguments.folder;
    let folders = [("DIR", Some(folder)), ("--output", arguments.output.as_ref())];
    if let Some((name, _)) = folders.iter().find(|(_, folder)| folder.is_some_and(|path| storage::is_standard(path))) {
        return Err(misuse(&texts::places_no_folder(*name).to_string()));
    }
    let list = folder.join(LIST_NAME);
    let all = read_list(&list)?;
    let actual = arguments.output.clone().unwrap_or_else(|| folder.join("actual"));
    places(arguments, &all, scene, &actual).check()?;
    let shots = chosen(arguments, &all, &list)?;
    let painter = Painter::headless(super::render::DEFAULT_SIZE, Some(1))?;
    let mut references = References::new(folder, scene, painter);
    if arguments.update {
        return update(&shots, &mut references, common);
    }
    let is_new = !storage::exists(&actual);
    files::create_folder(&actual)?;
    let rows = each(&shots, common, |shot| Ok(Row { shot, verdict: references.verify(shot, &actual)? }))?;
    let unused = references::unused(folder, &all);
    let bad = rows.iter().filter(|row| !row.verdict.is_good()).count();
    let page = actual.join(PAGE_NAME);
    let summary = if bad == 0 {
        texts::references_all_good(rows.len())
    } else {
        texts::references_some_bad(bad.to_string(), rows.len())
    };
    files::write(&page, references::page(&rows, &summary.to_string(), folder).as_bytes())?;
    if let Some(path) = &arguments.junit {
        let suite = results::suite(&rows, folder, &actual);
        files::write(path, junit::xml(&[suite]).as_bytes())?;
    }
    let say = |line: &str| output::say_beside(arguments.junit.as_deref(), &format!("{line}\n"));
    for row in &rows {
        let line = |mark: &str| format!("{mark} {}: {}", row.shot.name, row.verdict);
        if !row.verdict.is_good() {
            output::complain(&line("FAIL"));
        } else if !common.is_quiet && !arguments.json {
            say(&line("ok  "))?;
        }
    }
    github::tell(&rows, &list, &summary.to_string())?;
    if arguments.json {
        output::list(&results::json(&rows, &unused, &actual))?;
    } else {
        if !common.is_quiet {
            for path in &unused {
                say(&texts::references_unused(path.display()).to_string())?;
            }
            if is_new && !github::is_there() {
                say(&ignore_hint(arguments, &actual).to_string())?;
            }
        }
        let said = if bad == 0 { summary } else { texts::references_see(summary, page.display()) };
        say(&said.to_string())?;
    }
    Ok(if bad == 0 { Ended::Well } else { Ended::Beyond })
}

/// Takes what is drawn now as the references.
fn update(shots: &[Shot], references: &mut References<'_>, common: Common<'_>) -> Result<Ended, CliError> {
    let mut counts = [0_usize; 4];
    let rows = each(shots, common, |shot| Ok((shot, references.accept(shot)?)))?;
    for (shot, accepted) in rows {
        let (place, word) = match accepted {
            Accepted::New => (0, "new"),
            Accepted::Updated => (1, "updated"),
            Accepted::Unchanged => (2, "unchanged"),
            Accepted::Undrawn(reason) => {
                counts[3] += 1;
                output::complain(&format!("FAIL {}: {reason}", shot.name));
                continue;
            }
        };
        counts[place] += 1;
        if !common.is_quiet {
            output::say(&format!("{}: {word}\n", shot.name))?;
        }
    }
    let [new, updated, unchanged, failed] = counts.map(|count| count.to_string());
    output::say(&format!("{}\n", texts::references_updated(new, updated, unchanged, failed)))?;
    Ok(if counts[3] == 0 { Ended::Well } else { Ended::Beyond })
}

/// The pictures that the arguments ask for.
fn chosen(arguments: &VerifyArguments, all: &[Shot], list: &Path) -> Result<Vec<Shot>, CliError> {
    for pattern in &arguments.only {
        if !all.iter().any(|shot| pattern.matches(&shot.name)) {
            let pattern = format!("{:?}", pattern.as_str());
            return Err(CliError::bad_input(list.display(), texts::references_no_match(pattern)));
        }
    }
    let is_chosen =
        |shot: &&Shot| arguments.only.is_empty() || arguments.only.iter().any(|pattern| pattern.matches(&shot.name));
    let with_tolerance = |shot: Shot| Shot { tolerance: arguments.tolerance.unwrap_or(shot.tolerance), ..shot };
    Ok(all.iter().filter(is_chosen).cloned().map(with_tolerance).collect())
}

/// What to put where, so that what is drawn is not committed.
fn ignore_hint(arguments: &VerifyArguments, actual: &Path) -> Message {
    let name = actual.file_name().unwrap_or_default().to_string_lossy();
    let beside = if arguments.output.is_some() { actual.parent().unwrap_or(Path::new("")) } else { &arguments.folder };
    texts::references_ignore(actual.display(), format!("{name}/"), beside.join(".gitignore").display())
}

/// Where it reads and writes. `actual` is the folder for what is drawn.
fn places(arguments: &VerifyArguments, shots: &[Shot], scene: Option<&Path>, actual: &Path) -> Places {
    let folder = &arguments.folder;
    let mut places = Places::with_scene(scene).reads("the list", &folder.join(LIST_NAME));
    if let Some(path) = &arguments.junit {
        places = places.writes("--junit", path);
    }
    if arguments.json {
        places = places.prints("--json");
    }
    if !arguments.update {
        places = places.writes_once("the page".to_owned(), &actual.join(PAGE_NAME));
    }
    for shot in shots {
        let name = |what: &str| format!("{what} of \"{}\"", shot.name);
        let [animation, scene] = [&shot.file, &shot.scene].map(|file| file.as_ref().map(|file| folder.join(file)));
        if let Some(animation) = animation {
            places = places.reads_as(name("the file"), "the file", &animation);
        }
        if let Some(scene) = scene {
            places = places.reads_as(name("the scene"), "the scene", &scene);
        }
        let reference = folder.join(&shot.reference);
        if arguments.update {
            places = places.writes_once(name("the reference"), &reference);
        } else {
            places = places.reads_as(name("the reference"), "the reference", &reference);
            for (what, file) in ["the picture", "the difference", "the copy"].iter().zip(shot.written_names()) {
                places = places.writes_once(name(what), &actual.join(file));
            }
        }
    }
    places
}

/// Calls a function for each picture and shows the progress.
fn each<'a, T>(
    shots: &'a [Shot],
    common: Common<'_>,
    mut row: impl FnMut(&'a Shot) -> Result<T, CliError>,
) -> Result<Vec<T>, CliError> {
    let mut progress = Progress::of_items("picture", shots.len(), common);
    let mut rows = Vec::with_capacity(shots.len());
    for shot in shots {
        progress.begin(&shot.name);
        rows.push(row(shot)?);
        progress.step();
    }
    Ok(rows)
}
