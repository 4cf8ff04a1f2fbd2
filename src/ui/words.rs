//! The words of the window: the texts of the current language, which every widget reads.

use std::borrow::Borrow;

use egui::{Context, Id, Ui};

use crate::words::{Catalogue, Language, Message, Phrase};

/// The texts of the current language.
#[derive(Clone, Copy, Debug)]
pub struct Words(&'static Catalogue);

impl Default for Words {
    /// English.
    fn default() -> Self {
        Self::new(Language::default())
    }
}

impl PartialEq for Words {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.0, other.0)
    }
}

impl Words {
    /// The words of a language.
    #[must_use]
    pub fn new(language: Language) -> Self {
        Self(language.catalogue())
    }

    /// The current ones.
    #[must_use]
    pub fn of(ui: &Ui) -> Self {
        Self::of_context(ui.ctx())
    }

    /// The current ones.
    #[must_use]
    pub fn of_context(context: &Context) -> Self {
        context.data(|data| data.get_temp(id())).unwrap_or_default()
    }

    /// Makes them the current ones.
    pub fn install(self, context: &Context) {
        context.data_mut(|data| data.insert_temp(id(), self));
    }

    /// A phrase in the current language.
    #[must_use]
    pub fn say(self, phrase: Phrase) -> &'static str {
        self.0.phrase(phrase)
    }

    /// A message in the current language.
    #[must_use]
    pub fn message(self, message: impl Borrow<Message>) -> String {
        self.0.say(message.borrow())
    }
}

fn id() -> Id {
    Id::unique("words")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::theme;

    #[test]
    fn every_letter_of_every_language_is_in_the_fonts() {
        let context = Context::default();
        theme::install(&context);
        let mut output = context.run_ui(egui::RawInput::default(), |_| {});
        output.textures_delta.clear();
        // The most frequent Korean syllables, which file names are made of, and letters on their own.
        let in_file_names = "가각힘힝글ㄱㅎㅏㅣ";
        let letters: Vec<char> =
            Language::all().flat_map(|language| language.catalogue().letters()).chain(in_file_names.chars()).collect();
        for font in [theme::text_font(), theme::number_font()] {
            for &letter in &letters {
                let has = context.fonts_mut(|fonts| fonts.has_glyph(&font, letter));
                assert!(has, "no font has {letter}");
            }
        }
    }
}
