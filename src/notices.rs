//! The licences and notices of all that others made and that is in the program. `.ci/notices` writes them; packages bring the file along.

use std::sync::LazyLock;

use miniz_oxide::inflate::decompress_to_vec;

/// The text, in lines of which most have at most 80 characters. The first call unpacks it.
#[must_use]
pub fn text() -> &'static str {
    static TEXT: LazyLock<String> = LazyLock::new(|| {
        let packed = include_bytes!(concat!(env!("OUT_DIR"), "/notices.deflate"));
        let bytes = decompress_to_vec(packed).expect("the build script packed it");
        String::from_utf8(bytes).expect("the build script read text")
    });
    &TEXT
}

/// The lines of the text.
#[must_use]
pub fn lines() -> &'static [&'static str] {
    static LINES: LazyLock<Vec<&'static str>> = LazyLock::new(|| text().lines().collect());
    &LINES
}
