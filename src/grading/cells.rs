//! Cells and rows of tables that spreadsheets and course systems read: CSV as in RFC 4180.
//!
//! Not written by the `csv` crate, which would leave blanks, semicolons and apostrophes unquoted: in some locales spreadsheets split
//! cells at semicolons.

/// The mark by which spreadsheets know that a file is UTF-8.
pub const UTF8_MARK: char = '\u{feff}';

/// A number with at most four decimals, without trailing zeros.
#[must_use]
pub fn number(number: f64) -> String {
    let text = format!("{number:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A line of a table.
#[must_use]
pub fn row<T: AsRef<str>>(cells: &[T]) -> String {
    let mut line = cells.iter().map(|text| cell(text.as_ref())).collect::<Vec<_>>().join(",");
    line.push_str("\r\n");
    line
}

/// A cell that no spreadsheet takes for a formula: a text that begins like one gets an apostrophe before it. Signs of full width begin
/// formulas in East Asian locales, and what is not seen before a sign does not count. A dash alone is none. Line ends and other control
/// characters become blanks.
fn cell(text: &str) -> String {
    let is_unseen =
        |c: char| c.is_whitespace() || c.is_control() || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2060}' | UTF8_MARK);
    let begins_formula = text != "-"
        && text.trim_start_matches(is_unseen).starts_with(['=', '+', '-', '@', '＝', '＋', '－', '＠'])
        || text.starts_with(['\t', '\r', '\n', UTF8_MARK]);
    let plain: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let plain = if begins_formula { format!("'{plain}") } else { plain };
    if plain.contains([',', '"', ';', ' ', '\'']) { format!("\"{}\"", plain.replace('"', "\"\"")) } else { plain }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_cell_is_a_formula() {
        for (text, expected) in [
            ("=1+1", "'=1+1"),
            ("@x", "'@x"),
            ("+1", "'+1"),
            ("-1", "'-1"),
            ("\t=1", "' =1"),
            ("\r=1", "' =1"),
            ("  =1", "'  =1"),
            ("\u{feff}=1", "'\u{feff}=1"),
            ("\u{feff}", "'\u{feff}"),
            ("\u{200b} +1", "'\u{200b} +1"),
            ("＝1", "'＝1"),
            ("＋1", "'＋1"),
            ("－1", "'－1"),
            ("　＠x", "'　＠x"),
            ("\u{0}=1", "' =1"),
        ] {
            assert_eq!(cell(text), format!("\"{expected}\""), "{text:?}");
        }
        assert_eq!(cell("a\nb,\"c\""), "\"a b,\"\"c\"\"\"");
        assert_eq!([cell("plain"), cell("-")], ["plain", "-"]);
        assert_eq!(row(&["a=1", "", "b;c"]), "a=1,,\"b;c\"\r\n");
    }

    #[test]
    fn numbers_have_no_needless_zeros() {
        assert_eq!([0.0, 0.5, 10.0, 1.0 / 3.0].map(number), ["0", "0.5", "10", "0.3333"]);
    }
}
