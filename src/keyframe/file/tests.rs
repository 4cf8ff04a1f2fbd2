//! The fast and the strict reader agree, and so do the writer and a plain implementation.

use std::fmt::Write as _;
use std::sync::Arc;

use glam::{Quat, Vec3};
use proptest::prelude::*;

use super::cursor::Cursor;
use super::{KeyframesJson, fast, keyframes_to_json, strict};
use crate::interpolation::Interpolation;
use crate::keyframe::easing::Easing;
use crate::keyframe::list::{Keyframe, KeyframeList};
use crate::pose::Pose;
use crate::rbt::Rbt;
use crate::scene::{SceneGraph, built_in_scene};

/// Names that contain tokens that the fast reader looks for.
const NAMES: [Option<&str>; 6] = [
    None,
    Some("plain"),
    Some("a ] } ] } , { \"pose\": ["),
    Some("\"keyframes\": [\\"),
    Some("\u{e9}\n"),
    Some("]}]}"),
];

fn scene() -> SceneGraph {
    built_in_scene("two-robots").expect("it is built in")
}

fn list(keyframes: usize, nodes: usize, names: &[Option<&str>]) -> KeyframeList {
    let rbt = |keyframe: usize, node: usize| match node % 4 {
        0 => Rbt::IDENTITY,
        1 => Rbt::from_translation(Vec3::new(-0.0, 0.25, 1e-7)),
        _ => {
            let phase = (keyframe * 7 + node * 13) as f32;
            Rbt::new(Vec3::new(phase.sin(), phase, 1e6 * phase.cos()), Quat::from_rotation_y(phase))
        }
    };
    let keyframe = |index: usize| {
        let mut keyframe = Keyframe::new(Pose::new((0..nodes).map(|node| rbt(index, node)).collect()));
        keyframe.name = names[index % names.len()].map(Arc::from);
        if keyframe.name.is_some() {
            keyframe.duration = 0.5 * (index % 4 + 1) as f64;
            keyframe.easing = Easing::from_name(["linear", "hold", "quad-in"][index % 3]).expect("it is one");
        }
        keyframe
    };
    KeyframeList::new((0..keyframes).map(keyframe).collect())
}

/// The same files as this program writes them, with names in order of the alphabet, and with nodes in another order, each with and
/// without white space.
fn originals(scene: &SceneGraph) -> Vec<Vec<u8>> {
    let mut originals = Vec::new();
    for names in [&NAMES[..1], &NAMES[..2], &NAMES[..]] {
        let text = keyframes_to_json(scene, &list(7, scene.rbt_count(), names), Interpolation::CatmullRom, 700);
        let mut sorted: serde_json::Value = serde_json::from_str(&text).expect("it is JSON");
        originals.push(text.into_bytes());
        originals.push(serde_json::to_vec_pretty(&sorted).expect("memory takes all"));
        originals.push(serde_json::to_vec(&sorted).expect("memory takes all"));
        let turn = |list: &mut serde_json::Value| list.as_array_mut().expect("it is one").rotate_left(5);
        turn(&mut sorted["nodes"]);
        sorted["keyframes"].as_array_mut().expect("it is one").iter_mut().for_each(|it| turn(&mut it["pose"]));
        originals.push(serde_json::to_vec(&sorted).expect("memory takes all"));
    }
    originals
}

/// Whether the fast reader reads a text. The result must equal the strict reader's to the bit: `{:?}` distinguishes all numbers.
#[track_caller]
fn is_read(bytes: &[u8], scene: &SceneGraph, piece_bytes: usize) -> bool {
    let Some(quick) = fast::read_in_pieces(bytes, scene, piece_bytes) else { return false };
    let exact = strict::read(bytes, scene);
    let exact = exact.unwrap_or_else(|problems| panic!("{problems:?}\n{}", String::from_utf8_lossy(bytes)));
    assert_eq!(format!("{quick:?}"), format!("{exact:?}"), "{}", String::from_utf8_lossy(bytes));
    true
}

#[test]
fn what_programs_write_is_read_quickly() {
    let scene = scene();
    for (index, original) in originals(&scene).into_iter().enumerate() {
        for piece_bytes in [1, 1000, 10_000, 1 << 20] {
            // A name that looks like the end of a pose can be taken for one, and then the strict reader reads the file.
            let is_misleading = index >= 8 && piece_bytes < original.len();
            let text = String::from_utf8_lossy(&original);
            assert!(is_read(&original, &scene, piece_bytes) || is_misleading, "{piece_bytes}: {text}");
        }
    }
}

/// A change at an offset, given as a fraction of the text: some bytes are replaced by some text.
#[derive(Clone, Debug)]
struct Mutation(f64, usize, &'static str);

fn any_mutation() -> impl Strategy<Value = Mutation> {
    let words = vec![
        "",
        " ",
        "0",
        "1",
        "5",
        "-",
        ".",
        "e",
        ",",
        "]",
        "}",
        "[",
        "{",
        "\"",
        "\\",
        "\n",
        "\u{c}",
        "00",
        "1e39",
        "1e-46",
        "3.4028235677973366e38",
        "0.12345678901234567890123",
        "123456789012345678901234567890",
        "1e-99999",
        "NaN",
        "null",
        "] } ] }, {",
        "\"pose\": [",
        "{ \"pose\": [] }, ",
        "\"keyframes\": [],",
        "\"name\": \"x\", ",
        "\"duration\": 0.25, ",
        "/**/",
    ];
    (0.0..1.0, 0..4_usize, prop::sample::select(words)).prop_map(|(at, gone, word)| Mutation(at, gone, word))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_read_quickly_is_read_exactly(
        which in 0..12_usize,
        mutations in prop::collection::vec(any_mutation(), 1..4),
        piece_bytes in prop::sample::select(vec![1, 3000, 1 << 20]),
    ) {
        let scene = scene();
        let mut text = originals(&scene).swap_remove(which);
        for Mutation(at, gone, word) in mutations {
            let offset = (at * text.len() as f64) as usize;
            drop(text.splice(offset..(offset + gone).min(text.len()), word.bytes()));
        }
        is_read(&text, &scene, piece_bytes);
    }

    #[test]
    fn digits_are_read_as_serde_json_does(
        text in "-?(0|[1-9][0-9]{0,25}|0[0-9])(\\.[0-9]{0,25})?([eE][+-]?[0-9]{0,3})?",
    ) {
        check_number(&text);
    }

    #[test]
    fn numbers_are_read_as_serde_json_does(bits in 0..0x7f80_0000_u32, step in -2..=2_i64, digits in 1..20_usize) {
        let [below, above] = [bits, bits + 1].map(|bits| f64::from(f32::from_bits(bits)));
        if above.is_finite() {
            // Half way between two neighbours, and next to it.
            let middle = f64::midpoint(below, above);
            let near = f64::from_bits(middle.to_bits().saturating_add_signed(step));
            check_number(&format!("{near}"));
            check_number(&format!("{near:e}"));
        }
        check_number(&format!("{below:.digits$e}"));
    }
}

#[track_caller]
fn check_number(text: &str) {
    let mut cursor = Cursor::new(text.as_bytes(), 0);
    let quick = cursor.read_number().filter(|_| cursor.is_at_end());
    assert_eq!(quick.map(f32::to_bits), serde_json::from_str(text).ok().map(f32::to_bits), "{text}");
}

/// The text between the brackets of `keyframes`, by a plain implementation.
fn plain_text(keyframes: &[Keyframe]) -> String {
    let number = |number: f32| {
        let text = format!("{number:?}");
        text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
    };
    let joined = |numbers: &[f32]| numbers.iter().copied().map(number).collect::<Vec<_>>().join(", ");
    let mut text = String::new();
    for (index, keyframe) in keyframes.iter().enumerate() {
        text.push_str(if index == 0 { "\n    { \"pose\": [" } else { ",\n    { \"pose\": [" });
        for (node, rbt) in keyframe.pose.iter().enumerate() {
            let (translation, rotation) = (joined(&rbt.translation.to_array()), joined(&rbt.rotation.to_array()));
            let comma = if node == 0 { "" } else { "," };
            let _ = write!(text, "{comma}\n      {{ \"translation\": [{translation}], \"rotation\": [{rotation}] }}");
        }
        text.push_str("\n    ] }");
    }
    text
}

#[test]
fn texts_in_pieces_are_whole() {
    let scene = scene();
    for (keyframes, nodes) in
        [(0, 22), (1, 0), (1, 22), (5, 1024), (3, 1025), (2, 5000), (300, 22), (5000, 1), (2100, 0)]
    {
        let list = list(keyframes, nodes, &[None]);
        let text = keyframes_to_json(&scene, &list, Interpolation::Linear, 2000);
        let start = text.find("\"keyframes\": [").expect("it is there") + "\"keyframes\": [".len();
        let end = text.rfind(if keyframes == 0 { "]\n}\n" } else { "\n  ]\n}\n" }).expect("it is there");
        assert!(text[start..end] == plain_text(list.as_slice()), "{keyframes} keyframes of {nodes} nodes");
    }
}

#[test]
fn a_writer_that_fails_ends_it() {
    struct Full(usize);
    impl std::fmt::Write for Full {
        fn write_str(&mut self, text: &str) -> std::fmt::Result {
            self.0 = self.0.checked_sub(text.len()).ok_or(std::fmt::Error)?;
            Ok(())
        }
    }
    let (scene, keyframes) = (scene(), list(2000, 22, &[None]));
    let (interpolation, ms_between_keyframes) = (Interpolation::Linear, 2000);
    let json = KeyframesJson { scene: &scene, keyframes: &keyframes, interpolation, ms_between_keyframes };
    for room in [0, 10, 10_000, 1_000_000] {
        assert!(write!(Full(room), "{json}").is_err());
    }
}
