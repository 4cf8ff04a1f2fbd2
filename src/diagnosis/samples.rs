//! Samples of a student program's playback, as CSV.

mod decimals;

use glam::DVec3;
use thiserror::Error;

pub use decimals::{Printed, Tolerances};

use decimals::Decimals;

use super::rules::INTEGER_TICK_PACE;
use super::sequence::WHOLE;
use crate::pose::RbtIndex;
use crate::text::str_without_byte_order_mark;

/// The largest file of samples that is read: 64 MiB.
pub const LARGEST_SAMPLES_BYTES: u64 = 64 << 20;

const COLUMNS: [&str; 9] = ["key_time", "rbt_ind", "tx", "ty", "tz", "rw", "rx", "ry", "rz"];
const MS: &str = "ms";

/// One node at one key time.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The key time at which it should have been shown, at least 0.
    pub key_time: f64,
    /// How far the key time may be off: half a unit of its last decimal, or 0 where key times go in equal steps.
    pub key_time_error: f64,
    /// The node's index in poses.
    pub node: RbtIndex,
    /// Its translation in its parent's space, in scene units; may be NaN.
    pub translation: DVec3,
    /// The components of its rotation as printed: w, x, y, z; may be NaN or not of unit length.
    pub rotation_wxyz: [f64; 4],
}

/// Samples in the order of the file; at least one.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    /// The rows in file order.
    pub rows: Vec<Row>,
    /// How precisely their numbers are printed.
    pub printed: Printed,
}

/// The largest rounding of a key time with which motion is diagnosed: with fewer than three decimals, almost any motion would agree.
const LARGEST_KEY_TIME_ERROR: f64 = 1e-3;

impl Row {
    /// How far from its key time the diagnosis looks; 0 if the key time is taken as it stands.
    pub(super) fn searched(&self) -> f64 {
        let is_searched = self.key_time_error > WHOLE && self.key_time_error < LARGEST_KEY_TIME_ERROR;
        if is_searched { self.key_time_error } else { 0.0 }
    }
}

impl Samples {
    /// Whether any row is at or beyond a key time.
    #[must_use]
    pub fn reaches(&self, key_time: f64) -> bool {
        self.rows.iter().any(|row| row.key_time > key_time - WHOLE)
    }

    /// The last key time of the rows that is before `key_time`; 0 if there is none.
    #[must_use]
    pub fn last_before(&self, key_time: f64) -> f64 {
        self.rows.iter().map(|row| row.key_time).filter(|before| *before <= key_time - WHOLE).fold(0.0, f64::max)
    }
}

/// Why a text is not valid samples, with the location.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SamplesError {
    /// The bytes are not UTF-8.
    #[error("not UTF-8 at byte {byte}")]
    NotUtf8 {
        /// The number of valid bytes.
        byte: usize,
    },
    /// There is no header.
    #[error("the file is empty: expected the header {}", COLUMNS.join(","))]
    Empty,
    /// There are no rows after the header.
    #[error("there are no rows after the header")]
    NoRows,
    /// The header lacks a column.
    #[error("line {line}: the header has no column {column:?}: expected {}, and perhaps {MS}", COLUMNS.join(","))]
    MissingColumn {
        /// The line, from 1.
        line: usize,
        /// The column's name.
        column: &'static str,
    },
    /// The header has an unknown column, or one column twice.
    #[error("line {line}: column {column:?} of the header stands twice or is unknown: expected {}, and perhaps {MS}", COLUMNS.join(","))]
    ExtraColumn {
        /// The line, from 1.
        line: usize,
        /// The text in the file.
        column: String,
    },
    /// A row is longer or shorter than the header.
    #[error("line {line}: {found} fields, expected {expected} as in the header")]
    Fields {
        /// The line, from 1.
        line: usize,
        /// The number of fields in the row.
        found: usize,
        /// The number of fields in the header.
        expected: usize,
    },
    /// A field is not a number.
    #[error("line {line}, column {column}: {found:?} is not a number{}", hint(found))]
    Number {
        /// The line, from 1.
        line: usize,
        /// The column's name.
        column: &'static str,
        /// The text in the file.
        found: String,
    },
    /// A key time or a time is negative or not finite.
    #[error("line {line}, column {column}: {found:?} is not a finite number of at least 0")]
    Time {
        /// The line, from 1.
        line: usize,
        /// The column's name.
        column: &'static str,
        /// The text in the file.
        found: String,
    },
    /// The scene has no such node.
    #[error("line {line}: rbt_ind {found:?} is not a node of the scene, whose nodes are 0 to {last}")]
    Node {
        /// The line, from 1.
        line: usize,
        /// The text in the file.
        found: String,
        /// The index of the last node.
        last: usize,
    },
}

/// What may help with a field that is not a number.
fn hint(found: &str) -> &'static str {
    if found.contains(',') { ": write decimals with a point, not with a comma" } else { "" }
}

/// Reads samples of keyframes that are `ms_between_keyframes` milliseconds apart: [`SampleRows::from_csv`] and [`SampleRows::samples`].
///
/// # Errors
/// [`SamplesError`], the first.
pub fn samples_from_csv(bytes: &[u8], nodes: usize, ms_between_keyframes: u32) -> Result<Samples, SamplesError> {
    Ok(SampleRows::from_csv(bytes, nodes)?.samples(ms_between_keyframes))
}

/// The rows of a file of samples, read but not yet scaled to a keyframe file: the same rows may be samples of several keyframe files.
#[derive(Clone, Debug)]
pub struct SampleRows {
    rows: Vec<Row>,
    /// The column `ms`; empty without it.
    times_ms: Vec<f64>,
    printed: Printed,
}

impl SampleRows {
    /// Reads samples for a scene of `nodes` RBT nodes. Fields are parted by commas, semicolons or tabs, whichever the header has. Columns may come in any order; `nan`, `-nan(ind)`, `1.#QNAN` and their like are read
    /// as NaN. A byte order mark, either line ending and blank lines are skipped.
    ///
    /// # Errors
    /// [`SamplesError`], the first.
    pub fn from_csv(bytes: &[u8], nodes: usize) -> Result<Self, SamplesError> {
        let text = std::str::from_utf8(bytes).map_err(|error| SamplesError::NotUtf8 { byte: error.valid_up_to() })?;
        let text = str_without_byte_order_mark(text);
        let mut lines =
            text.lines().enumerate().map(|(index, line)| (index + 1, line.trim())).filter(|(_, l)| !l.is_empty());
        let (line, header) = lines.next().ok_or(SamplesError::Empty)?;
        let header = Header::read(line, header)?;
        let mut rows = Vec::new();
        let mut times_ms = Vec::new();
        let mut shown = Decimals::default();
        for (line, text) in lines {
            let (row, ms) = header.row(line, text, nodes, &mut shown)?;
            rows.push(row);
            times_ms.extend(ms);
        }
        if rows.is_empty() {
            return Err(SamplesError::NoRows);
        }
        shown.mark_key_times(&mut rows);
        Ok(Self { rows, times_ms, printed: shown.printed() })
    }

    /// The samples of keyframes that are `ms_between_keyframes` milliseconds apart. It shows whether key times were counted by a clock of
    /// 16 whole milliseconds a tick; they are then corrected by the column `ms`.
    #[must_use]
    pub fn samples(&self, ms_between_keyframes: u32) -> Samples {
        let mut rows = self.rows.clone();
        correct_key_times(&mut rows, &self.times_ms, f64::from(ms_between_keyframes));
        Samples { rows, printed: self.printed }
    }
}

/// If the key times are slower than the milliseconds by the factor 16/(1000/60), corrects them.
fn correct_key_times(rows: &mut [Row], times_ms: &[f64], ms_between_keyframes: f64) {
    let products: f64 = rows.iter().zip(times_ms).map(|(row, ms)| row.key_time * ms).sum();
    let squares: f64 = times_ms.iter().map(|ms| ms * ms).sum();
    let pace = products * ms_between_keyframes / squares;
    if (pace - INTEGER_TICK_PACE).abs() < 0.005 {
        for row in rows {
            row.key_time /= INTEGER_TICK_PACE;
        }
    }
}

/// The index of each column.
struct Header {
    columns: [usize; COLUMNS.len()],
    ms: Option<usize>,
    fields: usize,
    separator: char,
}

fn fields(line: &str, separator: char) -> impl Iterator<Item = &str> {
    line.strip_suffix(separator).unwrap_or(line).split(separator).map(|field| field.trim().trim_matches('"'))
}

impl Header {
    fn read(line: usize, text: &str) -> Result<Self, SamplesError> {
        let separator = [';', '\t'].into_iter().find(|separator| text.contains(*separator)).unwrap_or(',');
        let names: Vec<String> = fields(text, separator).map(str::to_ascii_lowercase).collect();
        let find = |column: &str| names.iter().position(|name| name == column);
        let mut columns = [0; COLUMNS.len()];
        for (index, column) in columns.iter_mut().zip(COLUMNS) {
            *index = find(column).ok_or(SamplesError::MissingColumn { line, column })?;
        }
        let ms = find(MS);
        let extra = (0..names.len()).find(|index| !columns.contains(index) && ms != Some(*index));
        if let Some(index) = extra {
            return Err(SamplesError::ExtraColumn { line, column: names[index].clone() });
        }
        Ok(Self { columns, ms, fields: names.len(), separator })
    }

    fn row(
        &self,
        line: usize,
        text: &str,
        nodes: usize,
        shown: &mut Decimals,
    ) -> Result<(Row, Option<f64>), SamplesError> {
        let found: Vec<&str> = fields(text, self.separator).collect();
        if found.len() != self.fields {
            return Err(SamplesError::Fields { line, found: found.len(), expected: self.fields });
        }
        let number = |index: usize, column: &'static str| {
            number(found[index]).ok_or_else(|| SamplesError::Number { line, column, found: found[index].to_owned() })
        };
        let time = |index: usize, column: &'static str| {
            let time = number(index, column)?;
            let is_time = time.is_finite() && time >= 0.0;
            is_time.then_some(time).ok_or_else(|| SamplesError::Time { line, column, found: found[index].to_owned() })
        };
        let mut values = [0.0; 7];
        for (at, value) in values.iter_mut().enumerate() {
            *value = number(self.columns[at + 2], COLUMNS[at + 2])?;
        }
        let [x, y, z, rotation_wxyz @ ..] = values;
        let node = found[self.columns[1]];
        let node = node.parse().ok().filter(|node| *node < nodes).ok_or_else(|| SamplesError::Node {
            line,
            found: node.to_owned(),
            last: nodes.saturating_sub(1),
        })?;
        let ms = self.ms.map(|index| time(index, MS)).transpose()?;
        let key_time = time(self.columns[0], COLUMNS[0])?;
        let numbers = std::array::from_fn(|at| found[self.columns[at + 2]]);
        shown.see((found[self.columns[0]], key_time), numbers);
        let (node, translation) = (RbtIndex::new(node), DVec3::new(x, y, z));
        Ok((Row { key_time, key_time_error: 0.0, node, translation, rotation_wxyz }, ms))
    }
}

/// A number as C++ programs print it, for any C++ library. All forms of NaN and infinity become NaN.
fn number(field: &str) -> Option<f64> {
    if let Ok(number) = field.parse() {
        return Some(number);
    }
    let unsigned = field.trim_start_matches(['+', '-']).to_ascii_lowercase();
    let is_none =
        unsigned.starts_with("nan(") || unsigned.starts_with("1.#") || ["nan", "inf"].contains(&unsigned.as_str());
    is_none.then_some(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_programs_print_for_no_number() {
        for none in ["nan", "NaN", "-nan", "-nan(ind)", "nan(snan)", "1.#QNAN", "1.#QNAN0", "-1.#IND00", "1.#INF"] {
            assert!(number(none).is_some_and(|number| !number.is_finite()), "{none}");
        }
        assert_eq!(number("-8.70831e-016"), Some(-8.70831e-16));
        for bad in ["", "x", "1,5", "1.2.3", "nano", "--1"] {
            assert_eq!(number(bad), None, "{bad}");
        }
    }

    fn problem(text: &str) -> String {
        samples_from_csv(text.as_bytes(), 22, 2000).expect_err("it is bad").to_string()
    }

    #[test]
    fn errors_name_line_and_column() {
        let header = "key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n";
        let with = |row: &str| problem(&format!("{header}{row}\n"));
        assert_eq!(with(""), "there are no rows after the header");
        assert_eq!(with("0,0,1,2,3,1,0,0"), "line 2: 8 fields, expected 9 as in the header");
        assert_eq!(with("0,0,1,2,3,1,0,0,x"), "line 2, column rz: \"x\" is not a number");
        assert_eq!(with("-1,0,1,2,3,1,0,0,0"), "line 2, column key_time: \"-1\" is not a finite number of at least 0");
        assert_eq!(
            with("0,22,1,2,3,1,0,0,0"),
            "line 2: rbt_ind \"22\" is not a node of the scene, whose nodes are 0 to 21"
        );
        assert!(problem("").starts_with("the file is empty: expected the header key_time,rbt_ind,"));
        assert!(problem("a,b\n1,2").starts_with("line 1: the header has no column \"key_time\""));
        assert!(
            problem("tx,key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz").contains("column \"tx\" of the header stands twice")
        );
    }

    #[test]
    fn a_mark_either_line_ending_and_any_order_are_read() {
        let text = "\u{feff}MS,key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz\r\n\r\n500,0.25,3,1,2,3,nan,0,0,0\r\n";
        let samples = samples_from_csv(text.as_bytes(), 22, 2000).expect("it is good");
        assert!(samples.rows[0].rotation_wxyz[0].is_nan());
        assert_eq!((samples.rows[0].key_time, samples.rows[0].node.get()), (0.25, 3));
        assert_eq!(samples.rows[0].translation, DVec3::new(1.0, 2.0, 3.0));
    }
}
