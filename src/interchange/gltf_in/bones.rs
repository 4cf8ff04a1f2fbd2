//! Bones: capsules that show joints without a mesh.

use glam::{DQuat, DVec3};
use serde_json::{Value, json};

use super::scene::{rotation, vector};

/// The colour of bones.
const COLOUR: &str = "#d9b98a";
/// Their radius, in parts of the model's size and of their own length at most.
const RADIUS: (f64, f64) = (0.012, 0.2);

/// Shapes from a joint to the joints below it; a ball for one with none below it.
pub(super) fn of(ends: impl ExactSizeIterator<Item = DVec3>, names: &[String], size: f64) -> Vec<Value> {
    let is_end = ends.len() == 0;
    let ball = |name: &String| json!({ "name": name, "shape": { "sphere": { "radius": (size * RADIUS.0) as f32 } }, "colour": COLOUR });
    if is_end {
        return names.iter().map(ball).collect();
    }
    let bone = |(end, name): (DVec3, &String)| {
        let length = end.length();
        if length < 1e-6 * size {
            return ball(name);
        }
        let radius = (size * RADIUS.0).min(length * RADIUS.1);
        let turn = DQuat::from_rotation_arc(DVec3::Y, end / length);
        let capsule = json!({ "radius": radius as f32, "height": length as f32 });
        json!({
            "name": name,
            "shape": { "capsule": capsule },
            "colour": COLOUR,
            "translation": vector(end / 2.0),
            "rotation": rotation(turn),
        })
    };
    ends.zip(names).map(bone).collect()
}
