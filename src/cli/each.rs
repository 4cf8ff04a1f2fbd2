//! The same work for each of several files: each by itself, and the exit status is the worst.

use std::path::Path;

use serde_json::{Map, Value, json};

use super::error::Ended;
use super::progress::Progress;
use super::reading::Notes;
use super::{CliError, Common, output};

/// What the work for one file has to say on standard output.
pub struct Done {
    /// Whole lines for people; may be empty.
    pub lines: String,
    /// The same for programs: the fields of an object.
    pub fields: Map<String, Value>,
    /// How it ended.
    pub ended: Ended,
}

impl Done {
    /// Lines and the object with their content.
    pub fn well(lines: String, fields: Value) -> Self {
        Self::ended(Ended::Well, lines, fields)
    }

    /// Lines, the object with their content, and how the work ended.
    pub fn ended(ended: Ended, lines: String, fields: Value) -> Self {
        let Value::Object(fields) = fields else { unreachable!("fields are an object") };
        Self { lines, fields, ended }
    }
}

/// How what was done is told.
#[derive(Clone, Copy)]
pub struct Telling<'a> {
    /// Whether an object is printed for each file, in a line of its own.
    pub is_json: bool,
    /// The file that the data goes to. Where it is standard output, standard error is told.
    pub data: Option<&'a Path>,
}

/// One file, and what came of it.
pub struct Outcome {
    /// The fields that name it in JSON.
    pub name: Map<String, Value>,
    /// What was inferred from it.
    pub notes: Notes,
    /// What was done, or why it was not.
    pub result: Result<Done, CliError>,
}

/// Does the work for each item, with progress where there are several. `named` gives the fields that name an item in JSON; `shown` names
/// it in the progress. What the work notes is said when all is done, so that it does not stand amid the progress.
///
/// # Errors
/// Wrong usage. What is wrong with an item is its outcome.
pub fn each<T>(
    items: &[T],
    common: Common<'_>,
    shown: impl Fn(&T) -> String,
    named: impl Fn(&T) -> Value,
    mut work: impl FnMut(&T, &mut Notes) -> Result<Done, CliError>,
) -> Result<Vec<Outcome>, CliError> {
    let mut progress = Progress::of_items("file", items.len(), common);
    let mut outcomes = Vec::with_capacity(items.len());
    for item in items {
        progress.begin(&shown(item));
        let mut notes = Notes::default();
        let result = match work(item, &mut notes) {
            Err(usage @ (CliError::Usage(_) | CliError::Misuse(_))) => return Err(usage),
            result => result,
        };
        let Value::Object(name) = named(item) else { unreachable!("names are an object") };
        outcomes.push(Outcome { name, notes, result });
        progress.step();
    }
    Ok(outcomes)
}

/// Prints what was done: lines or JSON on standard output, problems on standard error, in the order of the files.
///
/// # Errors
/// [`CliError::Said`] with the worst status; standard output does not take it.
pub fn tell(outcomes: Vec<Outcome>, telling: Telling<'_>) -> Result<Ended, CliError> {
    let mut worst = 0;
    for Outcome { name: mut object, notes, result } in outcomes {
        notes.say();
        let lines = match result {
            Ok(Done { lines, fields, ended }) => {
                worst = worst.max(ended.status());
                object.extend(fields);
                lines
            }
            Err(error) => {
                let (status, sentences) = error.into_sentences();
                worst = worst.max(status);
                output::complain(&sentences.join("\n"));
                object.extend([("problems".to_owned(), json!(sentences))]);
                String::new()
            }
        };
        let said = if telling.is_json { format!("{}\n", Value::Object(object)) } else { lines };
        if !said.is_empty() {
            output::say_beside(telling.data, &said)?;
        }
    }
    if worst == 0 { Ok(Ended::Well) } else { Err(CliError::Said { status: worst }) }
}
