//! The same work for each of several files: each by itself, and the exit status is the worst.

use std::path::Path;

use serde_json::{Map, Value, json};

use super::error::Ended;
use super::progress::Progress;
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

/// One file, by the fields that name it in JSON, and what came of it.
pub type Outcome = (Map<String, Value>, Result<Done, CliError>);

/// Does the work for each item, with progress where there are several. `named` gives the fields that name an item in JSON; `shown` names
/// it in the progress.
///
/// # Errors
/// Wrong usage. What is wrong with an item is its outcome.
pub fn each<T>(
    items: &[T],
    common: Common<'_>,
    shown: impl Fn(&T) -> String,
    named: impl Fn(&T) -> Value,
    mut work: impl FnMut(&T) -> Result<Done, CliError>,
) -> Result<Vec<Outcome>, CliError> {
    let mut progress = Progress::of_items("file", items.len(), common);
    let mut outcomes = Vec::with_capacity(items.len());
    for item in items {
        progress.begin(&shown(item));
        let outcome = match work(item) {
            Err(usage @ (CliError::Usage(_) | CliError::Misuse(_))) => return Err(usage),
            outcome => outcome,
        };
        let Value::Object(named) = named(item) else { unreachable!("names are an object") };
        outcomes.push((named, outcome));
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
    for (mut object, outcome) in outcomes {
        let lines = match outcome {
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
