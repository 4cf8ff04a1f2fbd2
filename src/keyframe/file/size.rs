//! How long the text of a keyframe file is, without making it.

use std::fmt::{self, Write as _};

use super::LARGEST_FILE_BYTES;
use super::write::{KeyframesText, MOST_NODE_BYTES};
use crate::json::quoted_bytes_at_most;
use crate::keyframe::list::KeyframeList;
use crate::scene::SceneGraph;

/// Upper bound of the text around the nodes of a keyframe: brackets, duration and easing.
const MOST_KEYFRAME_BYTES: u64 = 160;
/// Upper bound of the text around keyframes and node paths.
const MOST_HEAD_BYTES: u64 = 400;
/// Brackets, blanks and a comma around a path.
const MOST_PATH_BYTES: u64 = 8;

/// An upper bound of the length of a list's keyframe file. Takes time for each keyframe and each path, not for each node of each pose.
#[must_use]
pub fn file_bytes_at_most(scene: &SceneGraph, keyframes: &KeyframeList) -> u64 {
    let paths: u64 = scene.rbt_paths().map(|path| quoted_bytes_at_most(path) + MOST_PATH_BYTES).sum();
    let names = keyframes.as_slice().iter().filter_map(|keyframe| keyframe.name.as_deref());
    let names: u64 = names.map(quoted_bytes_at_most).sum();
    let each = (scene.rbt_count() * MOST_NODE_BYTES) as u64 + MOST_KEYFRAME_BYTES;
    MOST_HEAD_BYTES + quoted_bytes_at_most(scene.name()) + paths + names + each * keyframes.len() as u64
}

impl KeyframesText {
    /// Whether the text is short enough to be read again. Takes as long as writing it only where that is in doubt.
    #[must_use]
    pub fn can_be_read(&self) -> bool {
        /// Counts bytes instead of keeping them.
        struct Counter(u64);

        impl fmt::Write for Counter {
            fn write_str(&mut self, text: &str) -> fmt::Result {
                self.0 += text.len() as u64;
                if self.0 > LARGEST_FILE_BYTES { Err(fmt::Error) } else { Ok(()) }
            }
        }

        file_bytes_at_most(&self.scene, &self.keyframes) <= LARGEST_FILE_BYTES || write!(Counter(0), "{self}").is_ok()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{Quat, Vec3};

    use super::*;
    use crate::interpolation::Interpolation;
    use crate::keyframe::easing::Easing;
    use crate::keyframe::keyframes_to_json;
    use crate::keyframe::list::Keyframe;
    use crate::pose::Pose;
    use crate::rbt::Rbt;
    use crate::scene::built_in_scene;

    #[test]
    fn no_file_is_longer_than_its_bound() {
        // The longest texts of numbers in bounds.
        let longest = Rbt::new(
            Vec3::new(-1.234_567_8e-38, -0.000_123_456_79, -999_999.94),
            Quat::from_xyzw(-1.234_567_8e-38, -0.000_123_456_79, -0.000_999_999_9, -1.234_567_8e-10),
        );
        let easing = Easing::from_name("elastic-in-out").unwrap();
        for scene in ["two-robots", "cylinder", "orbits"].map(|name| built_in_scene(name).unwrap()) {
            let pose = Pose::new(vec![longest; scene.rbt_count()]);
            for (count, name) in [(0, ""), (1, "\u{1}\"\\가"), (7, "a name")] {
                let name = Some(Arc::from(name));
                let keyframe =
                    Keyframe { name, duration: 999.123_456_789_012_3, easing, ..Keyframe::new(pose.clone()) };
                let list = KeyframeList::new(vec![keyframe; count]);
                let text = keyframes_to_json(&scene, &list, Interpolation::CatmullRom, 10_000);
                let most = file_bytes_at_most(&scene, &list);
                assert!(text.len() as u64 <= most, "{} bytes of at most {most}", text.len());
            }
        }
    }
}
