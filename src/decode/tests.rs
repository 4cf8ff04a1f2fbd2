//! Each wording of the libraries, and what is said instead.

use serde::Deserialize;

use super::*;
use crate::scene::scene_from_json;
use crate::words::Language;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "only whether it is read matters")]
struct Text {
    name: String,
    count: u16,
    place: [f32; 3],
    flag: Option<bool>,
    #[serde(default)]
    pairs: Vec<(f64, String)>,
}

const GOOD: &str = r#"{"name": "é", "count": 1, "place": [0, 1, 2]}"#;

#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(json::<Text>(text.as_bytes()).expect_err(text).to_string(), expected, "{text}");
}

#[test]
fn every_wording_of_the_json_reader_has_a_sentence() {
    assert!(json::<Text>(format!("\u{feff}{GOOD}\n").as_bytes()).is_ok());
    check("", "line 1 column 1: the file ends where a value is missing");
    check("{\n  \"name\": \"a\",\n", "line 3 column 1: the file ends where a value is missing");
    check(r#"{"name": "a"#, "line 1 column 11: the file ends in the middle of a text: \" is missing");
    check("{\n  \"name\": \"a\"\n", "line 3 column 1: the file ends in the middle of an object: } or , is missing");
    check(r#"{"place": [1"#, "line 1 column 12: the file ends in the middle of a list: ] or , is missing");
    check(r#"{"name" 1"#, "line 1 column 9: : is missing");
    check(r#"{"place": [1 2"#, "line 1 column 14: , or ] is missing");
    check(r#"{"name": "a" 1"#, "line 1 column 14: , or } is missing");
    check(r#"{"flag": tru}"#, "line 1 column 13: only true, false and null have no quotes");
    check(r#"{"name": }"#, "line 1 column 10: a value is missing");
    check(r#"{"name": NaN}"#, "line 1 column 10: no value is written like this");
    check("{name: 1}", "line 1 column 2: a name in double quotes is missing");
    check(r#"{"name": "\q"}"#, r#"line 1 column 12: after \ comes ", \, /, b, f, n, r, t, or u with four digits"#);
    check(r#"{"count": 01}"#, "line 1 column 12: the number is not written as one");
    check(r#"{"place": [1e999]}"#, "line 1 column 16: the number is too large");
    check(
        "{\"name\": \"a\n\"}",
        "line 2 column 1: a text has no line end and no other control character in it: they are written as \\n or \\u001b",
    );
    check(r#"{"name": "a",}"#, "line 1 column 14: nothing follows after this comma");
    check(r#"{"place": [1, 2, 3, 4]}"#, "line 1 column 21: the list is longer than expected");
    check(&format!("{GOOD} {{"), "line 1 column 47: there is more after the end");
}

#[test]
fn every_wording_of_serde_has_a_sentence() {
    check(r#"{"name": "é", "count": 1}"#, "line 1 column 25: place is missing");
    check(r#"{"name": "é", "name": 1}"#, "line 1 column 20: name is given twice");
    check(
        r#"{"é`, expected `\u001b": 1}"#,
        r#"line 1 column 23: unknown field "é`, expected `\u{1b}", expected name, count, place, flag or pairs"#,
    );
    check(r#"{"name": 1}"#, "line 1 column 10: found 1, expected a text in double quotes");
    check(r#"{"name": null}"#, "line 1 column 13: found null, expected a text in double quotes");
    check(r#"{"name": {}}"#, "line 1 column 9: found an object, expected a text in double quotes");
    check(r#"{"count": -1}"#, "line 1 column 12: found -1, expected a whole number from 0 to 65535");
    check(r#"{"count": 1.5}"#, "line 1 column 13: found 1.5, expected a whole number");
    check(
        r#"{"count": "a, expected b"}"#,
        "line 1 column 25: found the text \"a, expected b\", expected a whole number",
    );
    check(r#"{"place": [1]}"#, "line 1 column 13: found a list of 1 value, expected a list of 3 values");
    check(r#"{"place": [1, true]}"#, "line 1 column 18: found true, expected a number");
    check(r#"{"flag": []}"#, "line 1 column 9: found a list, expected true or false");
    check(r#"{"pairs": [[1]]}"#, "line 1 column 14: found a list of 1 value, expected a list of 2 values");
    check("7", "line 1 column 1: found 7, expected an object");
    let long = format!(r#"{{"{}": 1}}"#, "x".repeat(1000));
    assert!(json::<Text>(long.as_bytes()).unwrap_err().to_string().chars().count() < 200);
}

#[test]
fn what_is_not_known_shows_no_wording() {
    for words in
        ["", "struct Text", "invalid type: ", "unknown field `x", "invalid length x, expected y", "usize", "foreign"]
    {
        assert_eq!(wordings::toml(words), texts::DECODE_NOT_TOML.into(), "{words}");
    }
}

#[test]
fn shapes_and_values_of_scenes_are_named() {
    let refused = |node: &str, expected: &str| {
        let text = format!(
            r#"{{"format": "inbetween.scene", "version": 1, "name": "a", "eyes": ["e"], "nodes": [{{"name": "e", {node}}}]}}"#
        );
        let sentence = scene_from_json(&text).unwrap_err().to_string();
        assert!(sentence.contains(expected), "{sentence}");
    };
    let shape = r#"expected a shape: { "box": … }, or sphere, cylinder, cone, capsule, plane or mesh in place of box"#;
    refused(r#""shape": 5"#, &format!("found 5, {shape}"));
    refused(r#""shape": "sphere""#, &format!("found the text \"sphere\", {shape}"));
    refused(r#""shape": {}"#, shape);
    refused(
        r#""shape": {"ball": {}}"#,
        r#"unknown field "ball", expected box, sphere, cylinder, cone, capsule, plane or mesh"#,
    );
    refused(r#""shape": {"sphere": {"radius": 1}, "box": {}}"#, "expected one shape");
    refused(r#""shape": {"sphere": 1}"#, "found 1, expected an object");
    refused(r#""rotation": 5"#, "expected a rotation: [x, y, z, w], or {");
    refused(r#""scale": "5""#, "expected a scale: one number, or [x, y, z]");
    refused(r#""colour": "red""#, "found the text \"red\", expected a colour: \"#rrggbb\"");
    refused(r#""colour": 5"#, "found 5, expected a colour: \"#rrggbb\"");
}

#[test]
fn toml_has_the_same_sentences() {
    let refused = |text: &str, expected: &str| {
        assert_eq!(toml::<Text>(text.as_bytes()).unwrap_err().to_string(), expected, "{text}");
    };
    refused("name = \"a\"\n", "line 2 column 1: count is missing");
    refused("name = 1\n", "line 1 column 8: found 1, expected a text in double quotes");
    refused("name = a\n", "line 1 column 8: a text needs double quotes");
    refused("name == \"a\"\n", "line 1 column 7: the text is not TOML from here on");
    refused("name = \"a\"\nname = \"b\"\n", "line 2 column 1: this name is there twice");
    refused("other = 1\n", "line 1 column 1: unknown field \"other\", expected name, count, place, flag or pairs");
}

#[test]
fn the_sentences_exist_in_every_language() {
    let error = json::<Text>(br#"{"count": "a"}"#).unwrap_err();
    let korean = Language::of_locale("ko").catalogue().say(&error.message());
    assert_eq!(korean, "1행 13열: 글 \"a\" 있음, 필요한 것: 정수");
}
