//! Formats of other programs.

use crate::text::without_byte_order_mark;

/// What a file of another program is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelFormat {
    /// glTF 2.0, binary or text.
    Gltf,
    /// A motion capture.
    Bvh,
}

impl ModelFormat {
    /// The format that bytes are meant to be in. Binary glTF and BVH are told by how they begin; a text of glTF is JSON that says something
    /// of an `asset`, as every one must, and nothing of a format of this program.
    #[must_use]
    pub fn of(bytes: &[u8]) -> Option<Self> {
        const HIERARCHY: &[u8] = b"HIERARCHY";
        let text = without_byte_order_mark(bytes).trim_ascii_start();
        let has = |word: &[u8]| text.windows(word.len()).any(|window| window == word);
        if text.get(..HIERARCHY.len()).is_some_and(|word| word.eq_ignore_ascii_case(HIERARCHY)) {
            Some(Self::Bvh)
        } else if bytes.starts_with(b"glTF") || (text.starts_with(b"{") && has(b"\"asset\"") && !has(b"\"inbetween.")) {
            Some(Self::Gltf)
        } else {
            None
        }
    }
}
