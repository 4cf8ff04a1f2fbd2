//! The catalogue of words: what fits what, and that its letters can be drawn.

use std::collections::HashSet;

use super::*;
use crate::ui::theme;

const KOREAN: Words = Words::new(Language::Korean);

#[test]
fn sentences_are_filled() {
    assert_eq!(fill("{} of {}", &["a", "b"]), "a of b");
    assert_eq!(fill("{1} of {0}", &["a", "b"]), "b of a");
    assert_eq!(holes("Keyframe {} ({} to {})", "Keyframe 3 (0 to 5)"), Some(vec!["3", "0", "5"]));
    assert_eq!(holes("Keyframe {}", "Keyframe "), None);
    assert_eq!(holes("Keyframe", "Keyframe"), None);
}

#[test]
fn english_is_itself() {
    assert_eq!(Words::default().say("New keyframe"), "New keyframe");
    assert_eq!(
        Words::default().message("Keyframe 3 (0 to 5): updated from the scene."),
        "Keyframe 3 (0 to 5): updated from the scene."
    );
}

#[test]
fn what_the_editor_says_is_said_in_korean() {
    assert_eq!(KOREAN.message("Keyframe 3 (0 to 5)"), "키프레임 3 (0–5)");
    assert_eq!(
        KOREAN.message("Keyframe 3 (0 to 5): created after keyframe 2."),
        "키프레임 3 (0–5): 키프레임 2 다음에 만들었습니다."
    );
    assert_eq!(KOREAN.message("Deleted keyframe 2. No keyframes."), "키프레임 2 삭제. 키프레임 없음.");
}

#[test]
fn holes_are_as_many_in_both_languages() {
    let mut seen = HashSet::new();
    for (english, korean) in KOREAN.table() {
        assert!(seen.insert(english), "{english} stands twice");
        assert_eq!(english.matches('{').count(), korean.matches('{').count(), "{english}: {korean}");
        assert!(!korean.is_empty());
    }
}

#[test]
fn every_korean_letter_is_in_the_fonts() {
    let context = Context::default();
    theme::install(&context);
    let mut output = context.run_ui(egui::RawInput::default(), |_| {});
    output.textures_delta.clear();
    let text: String =
        KOREAN.table().flat_map(|(_, korean)| korean.chars()).chain(Language::Korean.name().chars()).collect();
    for font in [theme::text_font(), theme::number_font()] {
        for letter in text.chars() {
            let has = context.fonts_mut(|fonts| fonts.has_glyph(&font, letter));
            assert!(has, "no font has {letter}");
        }
        // The most frequent syllables, which file names are made of, and letters on their own.
        for letter in "가각힘힝글ㄱㅎㅏㅣ".chars() {
            let has = context.fonts_mut(|fonts| fonts.has_glyph(&font, letter));
            assert!(has, "no font has {letter}");
        }
    }
}
