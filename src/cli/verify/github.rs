//! What GitHub Actions shows of a run: annotations on standard error, where its runner looks for them too, and a summary of the step.

use std::env;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use crate::cli::{CliError, output};
use crate::files::FileError;
use crate::references::Row;
use crate::storage;

/// GitHub shows so many annotations of a step.
const MOST_ANNOTATIONS: usize = 10;
/// So many rows stay far below the largest summary that GitHub shows, 1 MiB.
const MOST_ROWS: usize = 500;

/// Whether this runs in GitHub Actions.
pub fn is_there() -> bool {
    env::var_os("GITHUB_ACTIONS").is_some_and(|value| value == "true")
}

/// Tells GitHub of a run, if this runs there.
///
/// # Errors
/// [`CliError`]: the summary cannot be written.
pub fn tell(rows: &[Row<'_>], list: &Path, summary: &str) -> Result<(), CliError> {
    if !is_there() {
        return Ok(());
    }
    let bad: Vec<&Row<'_>> = rows.iter().filter(|row| !row.verdict.is_good()).collect();
    for row in bad.iter().take(MOST_ANNOTATIONS) {
        output::complain(&annotation(row, list));
    }
    if let Some(path) = env::var_os("GITHUB_STEP_SUMMARY").filter(|path| !path.is_empty()).map(PathBuf::from) {
        let text = markdown(&bad, list, summary);
        storage::append(&path, text.as_bytes()).map_err(|error| FileError::storage(path.display(), error))?;
    }
    Ok(())
}

/// The workflow command for a picture that is not as it should be. The place is the list, which GitHub can show.
fn annotation(row: &Row<'_>, list: &Path) -> String {
    let file = escaped_property(&list.display().to_string());
    let title = escaped_property(&format!("Picture {}", row.shot.name));
    format!("::error file={file},title={title}::{}", escaped_data(&format!("{}: {}", row.shot.name, row.verdict)))
}

fn escaped_data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

fn escaped_property(text: &str) -> String {
    escaped_data(text).replace(':', "%3A").replace(',', "%2C")
}

/// The summary of a step, with a row for each picture that is not as it should be.
fn markdown(bad: &[&Row<'_>], list: &Path, summary: &str) -> String {
    let mut text = format!("### Reference pictures of {}\n\n{}\n\n", cell(&list.display().to_string()), cell(summary));
    if !bad.is_empty() {
        text.push_str("| picture | result | score | tolerance |\n|---|---|---|---|\n");
    }
    for row in bad.iter().take(MOST_ROWS) {
        let score = row.verdict.scores().map_or_else(String::new, |scores| format!("{:.6}", scores.score));
        let result = if score.is_empty() { row.verdict.to_string() } else { row.verdict.word().to_owned() };
        let _ = writeln!(text, "| {} | {} | {score} | {} |", cell(&row.shot.name), cell(&result), row.shot.tolerance);
    }
    text
}

/// Text that Markdown shows as it is, in a cell of a table too.
fn cell(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '\n' | '\r' => shown.push(' '),
            '\\' | '|' | '`' | '*' | '_' | '<' | '>' | '[' | ']' | '&' | '#' | '~' | '@' => {
                let _ = write!(shown, "&#{};", u32::from(character));
            }
            other => shown.push(other),
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_github_reads_is_escaped() {
        assert_eq!(escaped_property("a:b,c%\r\n"), "a%3Ab%2Cc%25%0D%0A");
        assert_eq!(escaped_data("50%: a,b\nc"), "50%25: a,b%0Ac");
        assert_eq!(cell("a|b\n<i>_c_"), "a&#124;b &#60;i&#62;&#95;c&#95;");
    }
}
