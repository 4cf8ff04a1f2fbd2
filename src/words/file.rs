//! The text of a language: one message a line. The build script reads it with the same code.

/// A language's text as it stands in its file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LanguageFile<'a> {
    /// The language's name in itself.
    pub name: &'a str,
    /// The locale codes that ask for it, such as `ko`.
    pub locales: Vec<&'a str>,
    /// Ids and texts, in the file's order.
    pub texts: Vec<(&'a str, &'a str)>,
}

/// A piece of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Piece<'a> {
    /// Words as they stand.
    Words(&'a str),
    /// The place of an argument, by its name.
    Argument(&'a str),
}

impl<'a> LanguageFile<'a> {
    /// Reads a language's text.
    ///
    /// # Errors
    /// The line and what is wrong with it: no `id = text`, an id that stands twice, a brace without its other, or no name at the head.
    pub fn parse(text: &'a str) -> Result<Self, String> {
        let mut file = Self::default();
        for (index, line) in text.lines().enumerate() {
            let line = line.trim();
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let at = |problem: &str| format!("line {}: {problem}", index + 1);
            let (id, text) = line.split_once('=').ok_or_else(|| at("expected `id = text`"))?;
            let (id, text) = (id.trim(), text.trim());
            match id {
                "@name" => file.name = text,
                "@locale" => file.locales.push(text),
                _ if !is_id(id) => return Err(at("an id has small letters, digits, dots and hyphens")),
                _ if text.is_empty() => return Err(at("there is no text")),
                _ => {
                    pieces(text).map_err(|problem| at(&problem))?;
                    file.texts.push((id, text));
                }
            }
        }
        let mut ids: Vec<&str> = file.texts.iter().map(|(id, _)| *id).collect();
        ids.sort_unstable();
        if let Some([twice, _]) = ids.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(format!("{twice} stands twice"));
        }
        if file.name.is_empty() {
            return Err("there is no line `@name = NAME` at the head".to_owned());
        }
        Ok(file)
    }
}

fn is_id(id: &str) -> bool {
    let is_part = |byte: u8| byte.is_ascii_lowercase() || byte.is_ascii_digit() || matches!(byte, b'-' | b'.');
    id.starts_with(|first: char| first.is_ascii_lowercase()) && id.bytes().all(is_part)
}

/// A text's pieces. `{{` and `}}` are braces; `{}` is nothing.
///
/// # Errors
/// A brace without its other.
pub fn pieces(text: &str) -> Result<Vec<Piece<'_>>, String> {
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find(['{', '}']) {
        pieces.push(Piece::Words(&rest[..at]));
        let (brace, after) = rest[at..].split_at(1);
        if after.starts_with(brace) {
            pieces.push(Piece::Words(brace));
            rest = &after[1..];
        } else {
            let name = after.split_once('}').filter(|_| brace == "{");
            let (name, after) = name.ok_or_else(|| format!("a brace has no other: {text}"))?;
            if !name.is_empty() {
                pieces.push(Piece::Argument(name));
            }
            rest = after;
        }
    }
    pieces.push(Piece::Words(rest));
    pieces.retain(|piece| *piece != Piece::Words(""));
    Ok(pieces)
}

/// The id whose form a line is for the count 1, as `count.keys` for `count.keys.one`.
#[must_use]
pub fn singular_of(id: &str) -> Option<&str> {
    id.strip_suffix(".one")
}
