//! The texts of a language, and messages said in it.

use std::sync::LazyLock;

use super::file::{self, LanguageFile, Piece};
use super::message::{Argument, Message, Phrase};
use super::texts::IDS;

/// The languages' files: the code, which is the file's name, and the text. Sorted by code.
pub(super) const FILES: &[(&str, &str)] = &include!(concat!(env!("OUT_DIR"), "/words.rs"));

static CATALOGUES: LazyLock<Vec<Catalogue>> = LazyLock::new(|| {
    let read = |(code, text): &(&str, &str)| match Catalogue::parse(text) {
        Ok(catalogue) => catalogue,
        Err(problem) => unreachable!("the build script has read {code}.txt: {problem}"),
    };
    FILES.iter().map(read).collect()
});

/// The texts of one language.
#[derive(Debug)]
pub struct Catalogue {
    name: String,
    locales: Vec<String>,
    /// By the index of the id; `None` where the language has no text of its own, which is said in English then.
    texts: Vec<Option<Text>>,
    /// Ids that no message has.
    unknown: Vec<String>,
}

#[derive(Debug)]
struct Text {
    usual: Form,
    /// For the count 1, where that is another text.
    one: Option<Form>,
}

/// A text in pieces.
type Form = Vec<Part>;

#[derive(Debug, PartialEq, Eq)]
enum Part {
    Words(String),
    Argument(String),
}

impl Catalogue {
    /// Reads a language's text, which has the notation of `assets/words/en.txt`.
    ///
    /// # Errors
    /// The line, and what is wrong with it.
    pub fn parse(text: &str) -> Result<Self, String> {
        let file = LanguageFile::parse(text)?;
        let mut catalogue = Self {
            name: file.name.to_owned(),
            locales: file.locales.iter().map(|&locale| locale.to_owned()).collect(),
            texts: IDS.iter().map(|_| None).collect(),
            unknown: Vec::new(),
        };
        let mut singulars = Vec::new();
        for (id, text) in file.texts {
            match (IDS.binary_search(&id), file::singular_of(id)) {
                (Ok(index), _) => catalogue.texts[index] = Some(Text { usual: form(text)?, one: None }),
                (Err(_), Some(plural)) => singulars.push((plural, form(text)?)),
                (Err(_), None) => catalogue.unknown.push(id.to_owned()),
            }
        }
        for (plural, form) in singulars {
            let index = IDS.binary_search(&plural).ok();
            match index.and_then(|index| catalogue.texts[index].as_mut()) {
                Some(text) => text.one = Some(form),
                None => catalogue.unknown.push(format!("{plural}.one")),
            }
        }
        Ok(catalogue)
    }

    /// English, which has every message.
    pub(super) fn english() -> &'static Self {
        Self::of_code("en").expect("there is an en.txt")
    }

    /// The catalogue of a language's code.
    pub(super) fn of_code(code: &str) -> Option<&'static Self> {
        FILES.iter().position(|(own, _)| *own == code).map(Self::at)
    }

    pub(super) fn at(index: usize) -> &'static Self {
        &CATALOGUES[index]
    }

    /// The language's name in itself.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The locale codes that ask for it.
    pub fn locales(&self) -> impl Iterator<Item = &str> {
        self.locales.iter().map(String::as_str)
    }

    /// A message in this language.
    #[must_use]
    pub fn say(&self, message: &Message) -> String {
        let mut said = String::new();
        self.push(&mut said, message);
        said
    }

    /// A phrase in this language.
    #[must_use]
    pub fn phrase(&self, phrase: Phrase) -> &str {
        let words = self.words_of(phrase.0).or_else(|| Self::english().words_of(phrase.0));
        words.expect("a phrase has a text without arguments in English")
    }

    /// The text of an id where it has no arguments.
    pub(super) fn words_of(&self, index: u16) -> Option<&str> {
        match self.texts[usize::from(index)].as_ref()?.usual.as_slice() {
            [Part::Words(words)] => Some(words),
            _ => None,
        }
    }

    fn push(&self, said: &mut String, message: &Message) {
        let index = usize::from(message.index);
        let Some(text) = self.texts[index].as_ref().or_else(|| Self::english().texts[index].as_ref()) else { return };
        let is_one = message.argument("count") == Some(&Argument::Count(1));
        for part in text.one.as_ref().filter(|_| is_one).unwrap_or(&text.usual) {
            match part {
                Part::Words(words) => said.push_str(words),
                Part::Argument(name) => match message.argument(name) {
                    Some(Argument::Text(text)) => said.push_str(text),
                    Some(Argument::Count(count)) => said.push_str(&count.to_string()),
                    Some(Argument::Message(inner)) => self.push(said, inner),
                    None => {}
                },
            }
        }
    }

    /// What is wrong with the language beside English: messages that are missing, that do not exist in English, or that have other arguments.
    #[must_use]
    pub fn problems(&self) -> Vec<String> {
        let unknown = self.unknown.iter().map(|id| format!("{id}: no message has this id"));
        let texts = IDS.iter().zip(&self.texts).zip(&Self::english().texts);
        let wrong = texts.filter_map(|((id, own), english)| match (own, english) {
            (None, _) => Some(format!("{id}: it is missing")),
            (Some(own), Some(english)) if arguments(&own.usual) != arguments(&english.usual) => {
                Some(format!("{id}: its arguments are not those of English"))
            }
            (Some(Text { usual, one: Some(one) }), _)
                if !arguments(one).iter().all(|name| arguments(usual).contains(name)) =>
            {
                Some(format!("{id}.one: it has other arguments than {id}"))
            }
            _ => None,
        });
        unknown.chain(wrong).collect()
    }

    /// Every letter that the language writes with.
    pub fn letters(&self) -> impl Iterator<Item = char> {
        let parts = self.texts.iter().flatten().flat_map(|text| text.usual.iter().chain(text.one.iter().flatten()));
        let words = parts.filter_map(|part| match part {
            Part::Words(words) => Some(words.as_str()),
            Part::Argument(_) => None,
        });
        words.chain([self.name.as_str()]).flat_map(str::chars)
    }
}

fn form(text: &str) -> Result<Form, String> {
    let mut form = Form::new();
    for piece in file::pieces(text)? {
        match (piece, form.last_mut()) {
            (Piece::Words(words), Some(Part::Words(before))) => before.push_str(words),
            (Piece::Words(words), _) => form.push(Part::Words(words.to_owned())),
            (Piece::Argument(name), _) => form.push(Part::Argument(name.to_owned())),
        }
    }
    Ok(form)
}

/// The names of a text's arguments, sorted, each once.
fn arguments(form: &Form) -> Vec<&str> {
    let mut names: Vec<&str> = form
        .iter()
        .filter_map(|part| match part {
            Part::Argument(name) => Some(name.as_str()),
            Part::Words(_) => None,
        })
        .collect();
    names.sort_unstable();
    names.dedup();
    names
}
