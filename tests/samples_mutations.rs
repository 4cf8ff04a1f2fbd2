//! Broken samples: none makes reading or diagnosing them panic, and what is read is as it says.

use inbetween::diagnosis::{Listing, Sequence, diagnose, samples_from_csv};
use inbetween::keyframe::Keyframe;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use proptest::prelude::*;

const NODES: usize = 22;
const ORIGINAL: &str = include_str!("data/diagnosis/correct.csv");

fn mutated() -> impl Strategy<Value = Vec<u8>> {
    let byte = prop_oneof![any::<u8>(), prop::sample::select(b"0123456789 \n\r,;.+-eE\"".to_vec())];
    let words =
        ["nan", "-nan(ind)", "1.#QNAN", "inf", "1e999", "1e308", "-1", "99999999999999999999", "key_time", "\u{feff}"];
    let change = (0.0..1.0_f64, 0..6_usize, byte, prop::sample::select(words.to_vec()), 1..80_usize);
    (60..3000_usize, prop::collection::vec(change, 1..5)).prop_map(|(length, changes)| {
        let mut text = ORIGINAL.as_bytes()[..length].to_vec();
        for (at, kind, byte, word, count) in changes {
            let at = (at * text.len() as f64) as usize;
            let end = (at + count).min(text.len());
            match kind {
                0 => drop(text.splice(at..(at + 1).min(text.len()), [byte])),
                1 => text.insert(at, byte),
                2 => drop(text.splice(at..at, word.bytes())),
                3 => drop(text.drain(at..end)),
                4 => {
                    let again = text[at..end].to_vec();
                    drop(text.splice(at..at, again));
                }
                _ => {
                    // A whole field.
                    let end =
                        text[at..].iter().position(|byte| b",\n".contains(byte)).map_or(text.len(), |field| at + field);
                    drop(text.splice(at..end, word.bytes()));
                }
            }
        }
        text
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn broken_samples_do_no_harm(text in mutated()) {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        match samples_from_csv(&text, NODES, 2000) {
            Err(error) => prop_assert!(!error.to_string().is_empty()),
            Ok(samples) => {
                prop_assert!(!samples.rows.is_empty());
                prop_assert!(samples.rows.iter().all(|row| row.node.get() < NODES && row.key_time.is_finite() && row.key_time >= 0.0));
                let keyframes = vec![Keyframe::new(scene.rest_pose().clone()); 5];
                let diagnosis = diagnose(&Sequence::new(&keyframes).unwrap(), &samples, Listing::All);
                let residuals: Vec<f64> = diagnosis.candidates.iter().map(|candidate| candidate.residual).collect();
                prop_assert!(residuals.iter().all(|residual| *residual >= 0.0), "{residuals:?}");
                prop_assert!(!diagnosis.best().name.is_empty());
            }
        }
    }
}
