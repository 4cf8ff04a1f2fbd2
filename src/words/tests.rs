//! The notation of a language's text, and messages said in one.

use super::file::{LanguageFile, Piece, pieces};
use super::*;

#[test]
fn a_text_has_words_and_arguments() {
    assert_eq!(pieces("a {b} c"), Ok(vec![Piece::Words("a "), Piece::Argument("b"), Piece::Words(" c")]));
    assert_eq!(pieces("{} in {{}}"), Ok(vec![Piece::Words(" in "), Piece::Words("{"), Piece::Words("}")]));
    for broken in ["a {b", "a } b", "{"] {
        assert!(pieces(broken).is_err(), "{broken}");
    }
}

#[track_caller]
fn check_refused(text: &str, expected: &str) {
    let problem = LanguageFile::parse(text).unwrap_err();
    assert!(problem.contains(expected), "{problem}");
}

#[test]
fn what_is_wrong_with_a_file_is_said() {
    check_refused("a = b", "@name");
    check_refused("@name = X\nno text", "line 2");
    check_refused("@name = X\n\nA = b", "line 3");
    check_refused("@name = X\na = ", "line 2");
    check_refused("@name = X\na = {b", "line 2");
    check_refused("@name = X\na = b\na = c", "a stands twice");
}

#[test]
fn every_language_has_every_message_with_its_arguments() {
    for language in Language::all() {
        assert_eq!(language.catalogue().problems(), Vec::<String>::new(), "{}", language.code());
        assert_eq!(Language::of_code(language.code()), Some(language));
        assert!(language.catalogue().locales().any(|locale| locale == language.code()), "{}", language.code());
    }
}

/// A language of one file, whose words come in another order.
const MADE_UP: &str = "\
# Backwards.
@name = Sdrawkcab
@locale = xx
keyframe.created = {after} retfa detaerc
at-position = {rest} ← {position}
position.no-keyframes = semarfyek on
count.keys = syek {count}
count.keys.one = yek eno
nosuch.message = nothing
keyframe.is-last = {keyframe} {other}
";

#[test]
fn another_language_is_one_text() {
    let made_up = Catalogue::parse(MADE_UP).unwrap();
    assert_eq!((made_up.name(), made_up.locales().collect::<Vec<_>>()), ("Sdrawkcab", vec!["xx"]));
    let message = texts::at_position(texts::POSITION_NO_KEYFRAMES, texts::keyframe_created(3_usize));
    assert_eq!(made_up.say(&message), "3 retfa detaerc ← semarfyek on");
    assert_eq!(message.to_string(), "No keyframes: created after keyframe 3.");
    let keys = |count: usize| made_up.say(&texts::count_keys(count));
    assert_eq!((keys(1), keys(2)), ("yek eno".to_owned(), "syek 2".to_owned()));
    // What it lacks is said in English, and known to be missing.
    assert_eq!(made_up.say(&texts::undone(texts::ACT_DRAG)), "Undone: drag.");
    let problems = made_up.problems();
    for problem in ["nosuch.message: no message", "undone: it is missing", "keyframe.is-last: its arguments"] {
        assert!(problems.iter().any(|said| said.starts_with(problem)), "{problem}: {problems:#?}");
    }
    assert!(!problems.iter().any(|said| said.starts_with("count.keys")), "{problems:#?}");
}

#[test]
fn one_of_something_has_a_form_of_its_own() {
    assert_eq!(texts::count_keyframes(1_usize).to_string(), "1 keyframe");
    assert_eq!(texts::count_keyframes(0_usize).to_string(), "0 keyframes");
    let one = texts::refused_file_and_more("a.json", "wrong", 1_usize);
    assert_eq!(one.to_string(), "a.json: wrong (and 1 more problem)");
}

#[test]
fn a_phrase_is_found_by_its_id() {
    assert_eq!(Phrase::of_id("act.drag"), Some(texts::ACT_DRAG));
    assert_eq!(Phrase::of_id("undone"), None, "it has an argument");
    assert_eq!(Phrase::of_id("nosuch"), None);
    assert_eq!(texts::undone(texts::ACT_DRAG).id(), "undone");
}
