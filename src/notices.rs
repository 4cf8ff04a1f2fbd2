//! The licences and notices of all that others made and that is in the program. `.ci/notices` writes them; packages bring the file along.

use std::sync::LazyLock;

/// The text, in lines of which most have at most 80 characters.
#[must_use]
pub const fn text() -> &'static str {
    include_str!("../assets/licences/THIRD-PARTY.txt")
}

/// The lines of the text.
#[must_use]
pub fn lines() -> &'static [&'static str] {
    static LINES: LazyLock<Vec<&'static str>> = LazyLock::new(|| text().lines().collect());
    &LINES
}
