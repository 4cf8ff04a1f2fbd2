//! Numbers that JSON can hold and a pose cannot, such as 1e39. They are found in a second reading, so that the error names keyframe and
//! node.

use serde::Deserialize;

use super::problems::{KeyframeFileError, Problems};
use crate::rbt::LARGEST_COORDINATE;

#[derive(Deserialize)]
struct FileText {
    nodes: Vec<String>,
    keyframes: Vec<KeyframeText>,
}

#[derive(Deserialize)]
struct KeyframeText {
    pose: Vec<RbtText>,
}

#[derive(Deserialize)]
struct RbtText {
    translation: [f64; 3],
    rotation: [f64; 4],
}

/// The errors for translations and rotations beyond single precision; empty if the file has none or is not valid JSON.
pub fn numbers_too_large(bytes: &[u8]) -> Vec<KeyframeFileError> {
    let Ok(text) = serde_json::from_slice::<FileText>(bytes) else { return Vec::new() };
    let mut problems = Problems::default();
    for (keyframe, KeyframeText { pose }) in text.keyframes.iter().enumerate() {
        for (RbtText { translation, rotation }, path) in pose.iter().zip(&text.nodes) {
            if translation.iter().any(|number| number.abs() > f64::from(LARGEST_COORDINATE)) {
                problems.push(KeyframeFileError::TooFar { keyframe, path: path.clone() });
            }
            if rotation.iter().any(|&number| is_too_large(number)) {
                problems.push(KeyframeFileError::NotFinite { keyframe, path: path.clone() });
            }
        }
    }
    problems.into_result(()).err().unwrap_or_default()
}

#[expect(clippy::cast_possible_truncation, reason = "whether it is too large for that is the question")]
fn is_too_large(number: f64) -> bool {
    (number as f32).is_infinite()
}
