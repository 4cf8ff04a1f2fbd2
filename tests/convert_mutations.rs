//! 100,000 broken texts: none makes the import panic or hang, or takes more than three times its size plus 16 MiB.
//!
//! This is a test of its own because memory is counted over the whole process.

#[path = "convert/samples.rs"]
mod samples;

use inbetween::text_layouts::{FieldOrder, Imported, Options, import};
use peak_alloc::PeakAlloc;
use proptest::prelude::*;
use proptest::test_runner::{Config, FileFailurePersistence, TestRunner};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

const CASES: u32 = 100_000;
const FIXED_BYTES: usize = 16 << 20;

/// A change at a place, given as a fraction of the text.
#[derive(Clone, Debug)]
enum Mutation {
    Replace(f64, u8),
    Insert(f64, u8),
    InsertWord(f64, &'static str),
    Delete(f64, usize),
    Repeat(f64, usize),
    Truncate(f64),
}

fn any_mutation() -> impl Strategy<Value = Mutation> {
    let place = 0.0..1.0;
    let byte = prop_oneof![any::<u8>(), prop::sample::select(b"0123456789 \t\n\r,;.+-eE[](){}:=#".to_vec())];
    let words = vec![
        "nan",
        "-nan(ind)",
        "1.#QNAN",
        "1e39",
        "99999999999",
        "frame [0]",
        "frame [",
        "\nend\n",
        "{",
        "vec(",
        "\u{feff}",
        "\u{e9}",
    ];
    prop_oneof![
        (place.clone(), byte.clone()).prop_map(|(at, byte)| Mutation::Replace(at, byte)),
        (place.clone(), byte).prop_map(|(at, byte)| Mutation::Insert(at, byte)),
        (place.clone(), prop::sample::select(words)).prop_map(|(at, word)| Mutation::InsertWord(at, word)),
        (place.clone(), 1..200_usize).prop_map(|(at, length)| Mutation::Delete(at, length)),
        (place.clone(), 1..200_usize).prop_map(|(at, length)| Mutation::Repeat(at, length)),
        place.prop_map(Mutation::Truncate),
    ]
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a fraction of a length is a place in it")]
fn mutate(text: &mut Vec<u8>, mutation: &Mutation) {
    let place = |at: f64| (at * text.len() as f64) as usize;
    match *mutation {
        Mutation::Replace(at, byte) => {
            let place = place(at);
            if let Some(old) = text.get_mut(place) {
                *old = byte;
            }
        }
        Mutation::Insert(at, byte) => text.insert(place(at), byte),
        Mutation::InsertWord(at, word) => {
            let place = place(at);
            drop(text.splice(place..place, word.bytes()));
        }
        Mutation::Delete(at, length) => {
            let place = place(at);
            drop(text.drain(place..(place + length).min(text.len())));
        }
        Mutation::Repeat(at, length) => {
            let place = place(at);
            let again = text[place..(place + length).min(text.len())].to_vec();
            drop(text.splice(place..place, again));
        }
        Mutation::Truncate(at) => text.truncate(place(at)),
    }
}

fn originals() -> Vec<Vec<u8>> {
    let keyframes = samples::keyframes(2);
    let texts = samples::texts(&keyframes, false).into_iter().chain(samples::texts(&keyframes, true));
    let mut originals: Vec<Vec<u8>> = texts.map(|sample| sample.text.into_bytes()).collect();
    originals.push(samples::matrices(&keyframes[..1]).into_bytes());
    for _ in 0..4 {
        originals.push(samples::PYTHON.as_bytes().to_vec());
    }
    originals
}

#[test]
fn broken_texts_do_no_harm() {
    let scene = samples::scene();
    let originals = originals();
    let failure_persistence = Some(Box::new(FileFailurePersistence::Direct("tests/data/mutations.regressions")) as _);
    let config = Config { cases: CASES, failure_persistence, ..Config::default() };
    let order = prop::sample::select(vec![None, None, Some(FieldOrder::QuaternionFirst)]);
    let strategy = (0..originals.len(), prop::collection::vec(any_mutation(), 1..4), any::<bool>(), order);
    let outcome = TestRunner::new(config).run(&strategy, |(which, mutations, salvage, order)| {
        let mut text = originals[which].clone();
        for mutation in &mutations {
            mutate(&mut text, mutation);
        }
        let options = Options { order, joints: None, salvage };
        let before = MEMORY.current_usage();
        MEMORY.reset_peak_usage();
        let imported = import(&text, &scene, &options);
        let taken = MEMORY.peak_usage().saturating_sub(before) + text.len();
        prop_assert!(taken <= 3 * text.len() + FIXED_BYTES, "{taken} bytes for {}", text.len());
        match imported {
            Ok(Imported::KeyframeFile(file) | Imported::Text(file, _)) => {
                for rbt in file.keyframes.iter().flat_map(|keyframe| keyframe.pose.iter()) {
                    prop_assert!(rbt.is_finite() && (rbt.rotation.length() - 1.0).abs() < 2e-6, "{rbt:?}");
                }
            }
            Ok(Imported::Scene(text, _)) => {
                let scene = inbetween::scene::scene_from_json(&text);
                prop_assert!(scene.is_ok(), "{scene:?}");
            }
            Err(error) => prop_assert!(!error.sentences().is_empty()),
        }
        Ok(())
    });
    if let Err(error) = outcome {
        panic!("{error}");
    }
}

#[test]
fn counts_in_a_header_take_no_memory() {
    let scene = samples::scene();
    for text in [
        "999999999 22\n1 2 3",
        "99999999 999999999 0",
        "4000000000 22",
        "frame [18446744073709551615]\n1",
        "{0: 1, 1e308: 1",
    ] {
        assert!(import(text.as_bytes(), &scene, &Options::default()).is_err(), "{text}");
    }
}
