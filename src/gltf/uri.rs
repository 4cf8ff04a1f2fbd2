//! URIs of files beside a glTF file (glTF 2.0, section 2.8).

use crate::words::{Message, quoted, texts};

/// The most characters of a URI that are repeated.
const MOST_SHOWN: usize = 60;

/// The path that a URI means: relative to the folder of the file that names it, with `/` between folders, never out of that folder.
///
/// # Errors
/// A message: the URI is of another kind, leads out of the folder, or is no text once `%20` and the like are decoded.
pub fn relative_path(uri: &str) -> Result<String, Message> {
    let refused = || texts::gltf_uri(quoted(&uri.chars().take(MOST_SHOWN).collect::<String>()));
    let path = percent_decoded(uri).ok_or_else(refused)?;
    // A backslash is a separator and a colon a drive or a stream to some systems.
    if path.contains(['\\', ':', '\0']) {
        return Err(refused());
    }
    let parts: Vec<&str> = path.split('/').filter(|part| *part != ".").collect();
    if parts.iter().any(|part| part.is_empty() || *part == "..") {
        return Err(refused());
    }
    Ok(parts.join("/"))
}

/// A text with `%20` and the like in place of bytes.
fn percent_decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        bytes.push(if byte == b'%' {
            let mut digit = || char::from(rest.next()?).to_digit(16);
            (digit()? * 16 + digit()?) as u8
        } else {
            byte
        });
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_stays_in_its_folder() {
        for (uri, path) in
            [("a.bin", "a.bin"), ("./a%20b.png", "a b.png"), ("t/%ED%95%9C.png", "t/한.png"), ("..a", "..a")]
        {
            assert_eq!(relative_path(uri).as_deref(), Ok(path));
        }
        for uri in [
            "",
            "/etc/passwd",
            "../a",
            "a/../../b",
            "a//b",
            "%2e%2e/a",
            "..%2fa",
            "a\\..\\b",
            "C:a",
            "http://a/b",
            "%ff",
            "%2",
            "a%00",
        ] {
            let words = relative_path(uri).unwrap_err().to_string();
            assert!(words.contains(uri.split('\\').next().unwrap()), "{words}");
        }
    }
}
