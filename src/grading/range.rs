//! Whether samples begin and end where playback should.

use std::collections::{BTreeMap, BTreeSet};

use super::off::Printed;
use super::right::{Right, SAME_TIME};
use super::rubric::Credit;
use crate::diagnosis::{Row, Samples, Tolerances as Rounding};
use crate::interpolation::Interpolation;
use crate::text::counted;

/// Where samples begin and end.
#[derive(Clone, Debug, PartialEq)]
pub struct Ends {
    /// The share of the nodes that are shown at both ends; 0 if an end is wrong.
    pub share: f64,
    /// What is wrong, or what is right: a clause without a full stop.
    pub clause: String,
}

impl Ends {
    fn wrong(clause: String) -> Self {
        Self { share: 0.0, clause }
    }

    /// Looks at the first and the last samples. Of what is shown there, only counts which keyframe it is: an error in it is playback's.
    #[must_use]
    pub fn of(samples: &Samples, right: &Right<'_>, interpolation: Interpolation, credit: &Credit) -> Self {
        let end = right.end();
        let error = |row: &Row| row.key_time_error.max(SAME_TIME);
        let starts = one_of_each_node(samples, |row| row.key_time <= error(row));
        let ends = one_of_each_node(samples, |row| (row.key_time - end).abs() <= error(row));
        let times = || samples.rows.iter().map(|row| row.key_time);
        let last = times().fold(0.0, f64::max);
        if starts.is_empty() {
            let first = times().fold(f64::INFINITY, f64::min);
            return Self::wrong(format!("the samples begin {} after the start", shortest(first)));
        }
        if samples.rows.iter().any(|row| row.key_time > end + error(row)) {
            return Self::wrong(format!(
                "the samples go on to key time {}, and playback ends at {end}",
                shortest(last)
            ));
        }
        if ends.is_empty() {
            return Self::wrong(format!("the samples end {} before the end", shortest(end - last)));
        }
        let last_keyframe = right.list.len() - 2;
        let rounding = samples.printed.rounding();
        for (rows, expected, time) in [(&starts, 1, 0.0), (&ends, last_keyframe, end)] {
            let shown = keyframe_shown(rows, expected, &rounding, right, interpolation, credit);
            if shown != Some(expected) {
                let shown = shown.map_or("no keyframe".to_owned(), |keyframe| format!("keyframe {keyframe}"));
                return Self::wrong(format!(
                    "at key time {time} the samples show {shown}, expected keyframe {expected}"
                ));
            }
        }
        let nodes = right.list.as_slice()[0].pose.len();
        let at_end: BTreeSet<usize> = ends.iter().map(|row| row.node.get()).collect();
        let both = starts.iter().filter(|row| at_end.contains(&row.node.get())).count();
        let plays = format!("the samples begin with keyframe 1 and end with keyframe {last_keyframe}");
        let clause =
            if both < nodes { format!("{plays}, but show {both} of {} there", counted(nodes, "node")) } else { plays };
        Self { share: both as f64 / nodes as f64, clause }
    }
}

/// The first row of each node that is wanted.
fn one_of_each_node(samples: &Samples, is_wanted: impl Fn(&Row) -> bool) -> Vec<&Row> {
    let mut of_nodes: BTreeMap<usize, &Row> = BTreeMap::new();
    for row in samples.rows.iter().filter(|row| is_wanted(row)) {
        of_nodes.entry(row.node.get()).or_insert(row);
    }
    of_nodes.into_values().collect()
}

/// The keyframe that rows show: the expected one, unless another fits at least twice as many of the translations and rotations by which
/// the two differ. `None` if nothing fits any keyframe.
fn keyframe_shown(
    rows: &[&Row],
    expected: usize,
    rounding: &Rounding,
    right: &Right<'_>,
    interpolation: Interpolation,
    credit: &Credit,
) -> Option<usize> {
    let fits = |keyframe: usize| -> Vec<bool> {
        let parts = rows.iter().flat_map(|row| {
            let printed = Printed { row, rounding };
            let off = if keyframe == expected {
                // The key time may be a little off.
                right.off(printed, interpolation, credit)
            } else {
                right.off_keyframe(printed, keyframe)
            };
            off.parts_within(credit)
        });
        parts.collect()
    };
    let of_expected = fits(expected);
    let mut shown = of_expected.contains(&true).then_some(expected);
    let mut most = 0;
    for keyframe in (0..right.list.len()).filter(|keyframe| *keyframe != expected) {
        let both = fits(keyframe).into_iter().zip(&of_expected);
        let (mut only, mut only_expected) = (0, 0);
        for (fits, fits_expected) in both {
            only += usize::from(fits && !fits_expected);
            only_expected += usize::from(*fits_expected && !fits);
        }
        if only > most && only >= 2 * only_expected {
            (shown, most) = (Some(keyframe), only);
        }
    }
    shown
}

/// A difference of key times, to a millionth.
fn shortest(number: f64) -> String {
    let text = format!("{number:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
