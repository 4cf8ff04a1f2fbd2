//! How precisely samples are printed.

use super::Row;

const MOST_WHOLE_DIGITS: usize = 8;

/// How precisely the numbers of samples are printed.
///
/// A column has as many decimals as the value that shows the most. One that shows none, as `%g` prints what rests at 0, and every column
/// where zeros at the end were left out, has as many as the most of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Printed {
    /// The decimals of x, y and z of translations.
    pub translation: [usize; 3],
    /// The decimals of w, x, y and z of rotations.
    pub rotation: [usize; 4],
}

impl Printed {
    /// How far each number may be off for it was rounded: of translations in scene units, and of components of rotations.
    #[must_use]
    pub fn rounding(&self) -> Tolerances {
        Tolerances { translation: self.translation.map(rounding), rotation: self.rotation.map(rounding) }
    }

    /// How far each number may be off and still agree with a mistake. A kind that shows no decimals is taken as it stands.
    #[must_use]
    pub fn tolerances(&self) -> Tolerances {
        let of = |decimals, least: f64| if decimals == 0 { least } else { rounding(decimals).max(least) };
        let translation = self.translation.map(|decimals| of(decimals, 1e-4));
        Tolerances { translation, rotation: self.rotation.map(|decimals| of(decimals, 2e-4)) }
    }
}

/// How far each number of a sample may be off and still agree: half a unit of the decimals that its column shows, or what single
/// precision leaves, whichever is larger.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances {
    /// Of x, y and z of a translation, in scene units; at least 1e-4.
    pub translation: [f64; 3],
    /// Of w, x, y and z of a rotation; at least 2e-4.
    pub rotation: [f64; 4],
}

/// The decimals that were seen.
#[derive(Default)]
pub(super) struct Decimals {
    /// The most of each column of translation and rotation.
    of_numbers: [usize; 7],
    /// Whether a column's numbers differ in them: zeros at the end were left out.
    strips_zeros: bool,
    rows: usize,
    /// The most of key times by the digits before the point: programs that print a number of significant digits leave the fewer decimals,
    /// the more digits come before.
    of_key_times: [usize; MOST_WHOLE_DIGITS + 1],
}

impl Decimals {
    /// Looks at a row's fields: the key time and its number, and the seven numbers.
    pub fn see(&mut self, (field, key_time): (&str, f64), numbers: [&str; 7]) {
        let of_key_times = &mut self.of_key_times[whole_digits(key_time)];
        *of_key_times = (*of_key_times).max(decimals(field));
        for (most, field) in self.of_numbers.iter_mut().zip(numbers) {
            // What is no number shows no decimals.
            if field.ends_with(|last: char| last.is_ascii_digit() || last == '.') {
                let decimals = decimals(field);
                self.strips_zeros |= self.rows > 0 && decimals != *most;
                *most = decimals.max(*most);
            }
        }
        self.rows += 1;
    }

    /// How precisely numbers are printed.
    pub fn printed(&self) -> Printed {
        let [x, y, z, rotation @ ..] = self.of_numbers;
        Printed { translation: self.of([x, y, z]), rotation: self.of(rotation) }
    }

    /// The decimals of the columns of one kind.
    fn of<const N: usize>(&self, columns: [usize; N]) -> [usize; N] {
        let most = columns.into_iter().max().unwrap_or_default();
        columns.map(|decimals| if self.strips_zeros || decimals == 0 { most } else { decimals })
    }

    /// Tells each row how far its key time may be off.
    pub fn mark_key_times(&self, rows: &mut [Row]) {
        if !is_regular(rows) {
            for row in rows {
                row.key_time_error = half_unit(self.of_key_times[whole_digits(row.key_time)]);
            }
        }
    }
}

/// How far a number of so many decimals may be off: a fiftieth more than half a unit, for what is rounded was computed in single precision.
fn rounding(decimals: usize) -> f64 {
    1.02 * half_unit(decimals)
}

/// Half a unit of the last of so many decimals.
fn half_unit(decimals: usize) -> f64 {
    0.5 * 0.1_f64.powi(decimals.min(300) as i32)
}

/// How many decimals a number shows: `1.50` shows 2, `1.5e-3` shows 4.
fn decimals(field: &str) -> usize {
    let (number, exponent) = field.split_once(['e', 'E']).unwrap_or((field, "0"));
    let shown = number.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    let exponent = exponent.parse::<i64>().unwrap_or_default().clamp(-1000, 1000);
    usize::try_from(shown as i64 - exponent).unwrap_or_default()
}

/// Whether key times go in equal steps, but perhaps for the last, and none but the last shows a node twice: then they are as exact as they
/// are printed.
fn is_regular(rows: &[Row]) -> bool {
    let last = rows.iter().map(|row| row.key_time).fold(0.0, f64::max);
    let before_last = rows.iter().filter(|row| row.key_time < last);
    let mut shown: Vec<(u64, usize)> = before_last.map(|row| (row.key_time.to_bits(), row.node.get())).collect();
    shown.sort_unstable();
    if shown.windows(2).any(|pair| pair[0] == pair[1]) {
        return false;
    }
    let mut key_times: Vec<f64> = rows.iter().map(|row| row.key_time).collect();
    key_times.sort_by(f64::total_cmp);
    key_times.dedup();
    let [first, second, .., _] = key_times[..] else { return true };
    let steps = key_times[..key_times.len() - 1].windows(2).map(|pair| pair[1] - pair[0]);
    steps.into_iter().all(|step| (step - (second - first)).abs() < 1e-9)
}

/// The digits before the point, 1 to [`MOST_WHOLE_DIGITS`].
fn whole_digits(number: f64) -> usize {
    (1..MOST_WHOLE_DIGITS).find(|digits| number < 10_f64.powi(*digits as i32)).unwrap_or(MOST_WHOLE_DIGITS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_those_that_are_shown() {
        for (field, shown) in [("1", 0), ("1.", 0), ("-1.50", 2), ("1.5e-3", 4), ("-8.70831e-016", 21), ("1.5e3", 0)] {
            assert_eq!(decimals(field), shown, "{field}");
        }
    }

    fn printed(rows: &[[&str; 7]]) -> Printed {
        let mut seen = Decimals::default();
        for row in rows {
            seen.see(("0.1", 0.1), *row);
        }
        seen.printed()
    }

    #[test]
    fn each_column_has_its_own_and_zeros_that_were_left_out_do_not_count() {
        let fixed = printed(&[["1.00", "0.500", "1.000000", "1.000", "nan", "0.000", "0.000"]; 2]);
        assert_eq!(fixed, Printed { translation: [2, 3, 6], rotation: [3; 4] });
        assert_eq!(fixed.tolerances().translation, [1.02 * half_unit(2), 1.02 * half_unit(3), 1e-4]);
        assert_eq!(fixed.tolerances().rotation, [1.02 * half_unit(3); 4]);
        let stripped =
            printed(&[["1", "0.5", "0.25", "1", "0", "0", "0"], ["1", "0.5", "0.333333", "1", "0", "0", "0"]]);
        assert_eq!(stripped, Printed { translation: [6; 3], rotation: [0; 4] });
        assert_eq!(stripped.tolerances().translation, [1e-4; 3]);
        assert_eq!(stripped.tolerances().rotation, [2e-4; 4]);
    }
}
