//! Writes keyframes as text in any writable layout.

use std::fmt::{self, Write as _};

use super::columns;
use super::layout::Layout;
use crate::keyframe::Keyframe;
use crate::rbt::Rbt;

/// Keyframes in a layout; its `Display` is the file's text.
#[derive(Clone, Copy, Debug)]
pub struct KeyframeText<'a> {
    /// The keyframes, all of the same number of nodes.
    pub keyframes: &'a [Keyframe],
    /// The number of nodes of each.
    pub nodes: usize,
    /// The layout; [`Layout::Matrices`] is only read, and written as [`Layout::Header`].
    pub layout: Layout,
    /// Whether numbers have all digits that are needed to read the same value back; otherwise six significant digits.
    pub is_exact: bool,
}

impl fmt::Display for KeyframeText<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.layout {
            Layout::Header
            | Layout::HeaderTwoLines
            | Layout::HeaderKeyframeALine
            | Layout::HeaderQuaternionFirst
            | Layout::Matrices => {
                writeln!(out, "{} {}", self.keyframes.len(), self.nodes)?;
            }
            Layout::Csv => writeln!(out, "{}", columns::HEADER)?,
            Layout::Rows | Layout::Frames | Layout::End | Layout::Pairs | Layout::Endless => {}
        }
        for (index, keyframe) in self.keyframes.iter().enumerate() {
            if self.layout == Layout::Frames {
                writeln!(out, "frame [{index}]")?;
            }
            for (node, rbt) in keyframe.pose.iter().enumerate() {
                self.row(out, index, node, &rbt)?;
            }
            match self.layout {
                Layout::End => out.write_str("end\n")?,
                Layout::HeaderKeyframeALine | Layout::Pairs => out.write_char('\n')?,
                _ => {}
            }
        }
        if self.layout == Layout::Endless && !self.keyframes.is_empty() {
            out.write_char('\n')?;
        }
        Ok(())
    }
}

impl KeyframeText<'_> {
    fn row(&self, out: &mut fmt::Formatter<'_>, keyframe: usize, node: usize, rbt: &Rbt) -> fmt::Result {
        let translation = rbt.translation.to_array();
        let [x, y, z, w] = rbt.rotation.to_array();
        let quaternion = [w, x, y, z];
        let is_first = node == 0;
        match self.layout {
            Layout::HeaderQuaternionFirst => {
                self.numbers(out, &quaternion, ' ')?;
                out.write_char(' ')?;
                self.numbers(out, &translation, ' ')?;
                out.write_char('\n')
            }
            Layout::HeaderTwoLines => {
                self.numbers(out, &translation, ' ')?;
                out.write_char('\n')?;
                self.numbers(out, &quaternion, ' ')?;
                out.write_char('\n')
            }
            Layout::HeaderKeyframeALine => {
                out.write_str(if is_first { "" } else { " " })?;
                self.seven(out, &translation, ' ', &quaternion, ' ')
            }
            Layout::Pairs => {
                out.write_str(if is_first { "" } else { " " })?;
                self.seven(out, &translation, ';', &quaternion, ',')
            }
            Layout::Endless => {
                self.seven(out, &translation, ',', &quaternion, ',')?;
                out.write_char(';')
            }
            Layout::Csv => {
                write!(out, "{keyframe},{node},")?;
                self.seven(out, &translation, ',', &quaternion, ',')?;
                out.write_char('\n')
            }
            Layout::Header | Layout::Rows | Layout::Frames | Layout::End | Layout::Matrices => {
                self.seven(out, &translation, ' ', &quaternion, ' ')?;
                out.write_char('\n')
            }
        }
    }

    fn seven(
        &self,
        out: &mut fmt::Formatter<'_>,
        translation: &[f32],
        between: char,
        quaternion: &[f32],
        separator: char,
    ) -> fmt::Result {
        self.numbers(out, translation, separator)?;
        out.write_char(between)?;
        self.numbers(out, quaternion, separator)
    }

    fn numbers(&self, out: &mut fmt::Formatter<'_>, numbers: &[f32], separator: char) -> fmt::Result {
        for (index, &number) in numbers.iter().enumerate() {
            if index > 0 {
                out.write_char(separator)?;
            }
            if self.is_exact { write!(out, "{}", Exact(number))? } else { write!(out, "{}", SixDigits(number))? }
        }
        Ok(())
    }
}

/// The shortest form that reads back to the same value.
struct Exact(f32);

impl fmt::Display for Exact {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = format!("{:?}", self.0);
        out.write_str(text.strip_suffix(".0").unwrap_or(&text))
    }
}

/// Six significant digits, like C's `%g` and C++ streams.
struct SixDigits(f32);

impl fmt::Display for SixDigits {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scientific = format!("{:.5e}", self.0);
        let (digits, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
        let exponent: i32 = exponent.parse().unwrap_or(0);
        let trimmed = |text: &str| text.trim_end_matches('0').trim_end_matches('.').to_owned();
        if (-4..6).contains(&exponent) {
            let decimals = usize::try_from(5 - exponent).unwrap_or(0);
            let fixed = format!("{:.decimals$}", self.0);
            out.write_str(&if decimals > 0 { trimmed(&fixed) } else { fixed })
        } else {
            let sign = if exponent < 0 { '-' } else { '+' };
            write!(out, "{}e{sign}{:02}", trimmed(digits), exponent.abs())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_digits_are_as_in_c() {
        for (number, expected) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (1.0, "1"),
            (-0.657_306, "-0.657306"),
            (0.1, "0.1"),
            (0.000_123_456_7, "0.000123457"),
            (0.000_012_345_67, "1.23457e-05"),
            (123_456.7, "123457"),
            (999_999.6, "1e+06"),
            (1_234_567.0, "1.23457e+06"),
            (8.708_31e-16, "8.70831e-16"),
            (100.0, "100"),
            (0.75, "0.75"),
        ] {
            assert_eq!(SixDigits(number).to_string(), expected);
        }
    }
}
