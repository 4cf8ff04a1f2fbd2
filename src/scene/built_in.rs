//! The scenes that are part of the program: data files under `assets/scenes/`, parsed on request.

use super::file::scene_from_json;
use super::graph::SceneGraph;

/// The name of the default scene.
pub const DEFAULT_SCENE: &str = "two-robots";

const BUILT_IN: [(&str, &str); 3] = [
    (DEFAULT_SCENE, include_str!("../../assets/scenes/two-robots.json")),
    ("cylinder", include_str!("../../assets/scenes/cylinder.json")),
    ("orbits", include_str!("../../assets/scenes/orbits.json")),
];

/// An animation that is part of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BuiltInAnimation {
    /// Its name, which is that of its file without `.json`.
    pub name: &'static str,
    /// The name of the built-in scene that it is of.
    pub scene: &'static str,
    /// The text of its keyframe file.
    pub text: &'static str,
}

/// The animations that are part of the program: data files under `assets/animations/`.
pub const BUILT_IN_ANIMATIONS: [BuiltInAnimation; 4] = [
    BuiltInAnimation { name: "walk", scene: DEFAULT_SCENE, text: include_str!("../../assets/animations/walk.json") },
    BuiltInAnimation { name: "wave", scene: DEFAULT_SCENE, text: include_str!("../../assets/animations/wave.json") },
    BuiltInAnimation {
        name: "handshake",
        scene: DEFAULT_SCENE,
        text: include_str!("../../assets/animations/handshake.json"),
    },
    BuiltInAnimation {
        name: "orbits-tour",
        scene: "orbits",
        text: include_str!("../../assets/animations/orbits-tour.json"),
    },
];

/// The names of the built-in scenes.
pub fn built_in_scene_names() -> impl Iterator<Item = &'static str> {
    BUILT_IN.iter().map(|(name, _)| *name)
}

/// The built-in scene of this name, if there is one.
#[must_use]
pub fn built_in_scene(name: &str) -> Option<SceneGraph> {
    let (_, text) = BUILT_IN.iter().find(|(built_in, _)| *built_in == name)?;
    Some(scene_from_json(text).expect("the built-in scenes are right, as a test checks"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_built_in_scene_reads_and_carries_its_name() {
        for name in built_in_scene_names() {
            assert_eq!(built_in_scene(name).expect("it is built in").name(), name);
        }
    }

    #[test]
    fn two_robots_is_as_the_course_has_it() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let rows: Vec<(String, [f32; 3])> = scene
            .rbt_indices()
            .map(|rbt| (scene.rbt_path(rbt).to_owned(), scene.rest_pose().get(rbt).translation.to_array()))
            .collect();
        let parts = [
            ("", 0.0, 1.0),
            ("/right_shoulder", 0.5, 0.75),
            ("/right_shoulder/right_elbow", 0.7, 0.0),
            ("/left_shoulder", -0.5, 0.75),
            ("/left_shoulder/left_elbow", -0.7, 0.0),
            ("/right_hip", 0.375, -0.75),
            ("/right_hip/right_knee", 0.0, -1.0),
            ("/left_hip", -0.375, -0.75),
            ("/left_hip/left_knee", 0.0, -1.0),
            ("/head", 0.0, 0.75),
        ];
        let mut expected = vec![("sky".to_owned(), [0.0, 0.25, 4.0]), ("ground".to_owned(), [0.0; 3])];
        for (robot, x_of_robot) in [("robot1", -2.0), ("robot2", 2.0)] {
            for (part, x, y) in parts {
                let x = if part.is_empty() { x_of_robot } else { x };
                expected.push((format!("{robot}{part}"), [x, y, 0.0]));
            }
        }
        assert_eq!(rows, expected);
        assert!(scene.rest_pose().iter().all(|rbt| rbt.rotation == glam::Quat::IDENTITY));
    }
}
