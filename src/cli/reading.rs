//! Keyframes out of what others wrote: the one door through which `diff`, `diagnose` and `grade` read them.

use crate::keyframe::{KeyframeFile, keyframes_from_json};
use crate::scene::SceneGraph;

/// Reads keyframes for a scene.
///
/// # Errors
/// What is wrong: a sentence a problem; never empty.
pub fn keyframes(bytes: &[u8], scene: &SceneGraph) -> Result<KeyframeFile, Vec<String>> {
    keyframes_from_json(bytes, scene).map_err(|problems| problems.iter().map(ToString::to_string).collect())
}
