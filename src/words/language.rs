//! The languages that there are: the files of `assets/words/`.

use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::catalogue::{Catalogue, FILES};

/// What a language's file is called, without its ending: its code, as settings keep it.
static CODES: [&str; FILES.len()] = {
    let mut codes = [""; FILES.len()];
    let mut index = 0;
    while index < FILES.len() {
        codes[index] = FILES[index].0;
        index += 1;
    }
    codes
};

/// A language that the program speaks: one file of `assets/words/`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Language(usize);

impl Default for Language {
    /// English.
    fn default() -> Self {
        Self::of_code("en").expect("there is an en.txt")
    }
}

impl Language {
    /// All of them, in the order of menus.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..FILES.len()).map(Self)
    }

    /// The language with this code, such as `ko`.
    #[must_use]
    pub fn of_code(code: &str) -> Option<Self> {
        CODES.iter().position(|own| *own == code).map(Self)
    }

    /// Its code, as settings keep it.
    #[must_use]
    pub fn code(self) -> &'static str {
        CODES[self.0]
    }

    /// Its name in itself.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.catalogue().name()
    }

    /// Its texts.
    #[must_use]
    pub fn catalogue(self) -> &'static Catalogue {
        Catalogue::at(self.0)
    }

    /// The language for a system's locale, such as `ko_KR.UTF-8`; English where there is none of its own.
    #[must_use]
    pub fn of_locale(locale: &str) -> Self {
        let asked = locale.split(['_', '-', '.', '@']).next().unwrap_or_default();
        Self::all().find(|language| language.catalogue().locales().any(|own| own == asked)).unwrap_or_default()
    }
}

impl Serialize for Language {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.code())
    }
}

impl<'de> Deserialize<'de> for Language {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let code = String::deserialize(deserializer)?;
        Self::of_code(&code).ok_or_else(|| D::Error::unknown_variant(&code, &CODES))
    }
}
