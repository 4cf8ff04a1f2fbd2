//! The other side: which RBT node mirrors which, and a node's place on the other side.

use glam::{Quat, Vec3};

use super::graph::SceneGraph;
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;

/// How far, in scene units, a rest position may lie from the mirror image of another and still be its other side.
const NEAR: f32 = 1e-3;

/// The words that say a side, each with its opposite. The single letters count only at the beginning or the end of a name.
const SIDES: [(&str, &str); 2] = [("left", "right"), ("l", "r")];
/// The same in Korean, where no sign stands between the side and what comes after it.
const KOREAN_SIDES: (&str, &str) = ("왼", "오른");

impl SceneGraph {
    /// For each RBT node, in the scene's order, the one on the other side; a node in the middle is its own. `None` where the other side
    /// has no such node.
    ///
    /// Names decide: `left_arm` and `right_arm`, `armL` and `armR`, `arm.l` and `arm.r`. Where they say nothing, nodes below another RBT
    /// node belong together if their rest positions mirror each other in their parent's space, at the plane x = 0.
    #[must_use]
    pub fn counterparts(&self) -> Vec<Option<RbtIndex>> {
        let mut children = vec![Vec::new(); self.rbt_count()];
        let parent_of = |rbt| self.node(self.rbt_node(rbt)).parent.and_then(|above| self.carrying_rbt(above));
        for rbt in self.rbt_indices() {
            if let Some(parent) = parent_of(rbt) {
                children[parent.get()].push(rbt);
            }
        }
        let mut counterparts: Vec<Option<RbtIndex>> = Vec::with_capacity(self.rbt_count());
        for rbt in self.rbt_indices() {
            let parent = parent_of(rbt);
            // Parents come before their children.
            let other_parent = parent.and_then(|parent| counterparts[parent.get()]);
            if parent.is_some() && other_parent.is_none() {
                counterparts.push(None);
                continue;
            }
            let by_name = self.by_name(rbt, parent, other_parent);
            let by_position = || self.by_position(rbt, &children[parent?.get()], &children[other_parent?.get()]);
            let is_in_middle = parent == other_parent;
            counterparts.push(by_name.or_else(by_position).or(is_in_middle.then_some(rbt)));
        }
        counterparts
    }

    /// The node whose path says the other side; below another parent also one of the same name.
    fn by_name(&self, rbt: RbtIndex, parent: Option<RbtIndex>, other_parent: Option<RbtIndex>) -> Option<RbtIndex> {
        let path = self.rbt_path(rbt);
        let below = parent.map_or(path, |parent| path.strip_prefix(self.rbt_path(parent)).unwrap_or(path));
        let mirrored: Vec<String> =
            below.split('/').map(|name| other_side(name).unwrap_or_else(|| name.to_owned())).collect();
        let above = other_parent.map_or("", |other| self.rbt_path(other));
        let at = |below: &str| self.find_rbt(&format!("{above}{below}"));
        let other = at(&mirrored.join("/")).or_else(|| at(below));
        other.filter(|&other| other != rbt)
    }

    /// The only one of the candidates that lies at rest where the mirror image of `rbt` does. `None` if another sibling lies where `rbt`
    /// does, or if one of the names says a side.
    fn by_position(&self, rbt: RbtIndex, siblings: &[RbtIndex], candidates: &[RbtIndex]) -> Option<RbtIndex> {
        let rest = self.rest_pose();
        let is_unnamed = |rbt: &RbtIndex| other_side(&self.node(self.rbt_node(*rbt)).name).is_none();
        let only_at = |place: Vec3, nodes: &[RbtIndex]| {
            let mut there = nodes.iter().copied().filter(|&node| rest.get(node).translation.distance(place) < NEAR);
            there.next().filter(|_| there.next().is_none()).filter(is_unnamed)
        };
        only_at(rest.get(rbt).translation, siblings)?;
        only_at(mirrored(rest.get(rbt)).translation, candidates)
    }

    /// Where `other` goes, in its parent's space, when it mirrors how `rbt` differs from its rest in `pose`.
    ///
    /// A node in the middle with no RBT node above it, such as a robot as a whole, keeps its place and its heading (its turn about y):
    /// only how it leans is mirrored.
    #[must_use]
    pub fn mirrored_place(&self, pose: &Pose, rbt: RbtIndex, other: RbtIndex) -> Rbt {
        let (rest, other_rest, placed) = (self.rest_pose().get(rbt), self.rest_pose().get(other), pose.get(rbt));
        let by = Rbt::new(placed.translation - rest.translation, placed.rotation * rest.rotation.conjugate());
        let is_whole =
            rbt == other && self.node(self.rbt_node(rbt)).parent.and_then(|above| self.carrying_rbt(above)).is_none();
        let image = if is_whole {
            let heading = Quat::from_xyzw(0.0, by.rotation.y, 0.0, by.rotation.w);
            let heading = if heading.length_squared() > 1e-12 { heading.normalize() } else { Quat::IDENTITY };
            let lean = Rbt::from_rotation(heading.conjugate() * by.rotation);
            Rbt::new(by.translation, heading * mirrored(lean).rotation)
        } else {
            mirrored(by)
        };
        Rbt::new(other_rest.translation + image.translation, image.rotation * other_rest.rotation).renormalized()
    }
}

/// The mirror image at the plane x = 0.
fn mirrored(rbt: Rbt) -> Rbt {
    let mut translation = rbt.translation;
    translation.x = -translation.x;
    let [x, y, z, w] = rbt.rotation.to_array();
    Rbt::new(translation, Quat::from_xyzw(x, -y, -z, w))
}

/// The same name for the other side; `None` where it says no side.
#[must_use]
fn other_side(name: &str) -> Option<String> {
    for (from, to) in [KOREAN_SIDES, (KOREAN_SIDES.1, KOREAN_SIDES.0)] {
        if let Some(rest) = name.strip_prefix(from) {
            return Some(format!("{to}{rest}"));
        }
    }
    let words = words(name);
    for (side, (left, right)) in SIDES.into_iter().enumerate() {
        let mut has_side = false;
        let turned: String = words
            .iter()
            .enumerate()
            .map(|(place, &word)| {
                let is_at_end = place == 0 || place + 1 == words.len();
                let lower = word.to_lowercase();
                let other = match lower.as_str() {
                    _ if side > 0 && !is_at_end => None,
                    lower if lower == left => Some(right),
                    lower if lower == right => Some(left),
                    _ => None,
                };
                has_side |= other.is_some();
                other.map_or_else(|| word.to_owned(), |other| in_case_of(word, other))
            })
            .collect();
        // A name that is the letter alone is a variable, not a side.
        if has_side && (side == 0 || words.len() > 1) {
            return Some(turned);
        }
    }
    None
}

/// The words of a name and the signs between them: `armL_2` has `arm`, `L`, `_`, `2`.
fn words(name: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut start = 0;
    let letters: Vec<(usize, char)> = name.char_indices().collect();
    for (place, pair) in letters.windows(2).enumerate() {
        let ((_, before), (at, after)) = (pair[0], pair[1]);
        let next = letters.get(place + 2).map(|&(_, next)| next);
        let is_hump = (before.is_lowercase() && after.is_uppercase())
            || (before.is_uppercase() && after.is_uppercase() && next.is_some_and(char::is_lowercase));
        if before.is_alphabetic() != after.is_alphabetic() || is_hump {
            words.push(&name[start..at]);
            start = at;
        }
    }
    words.push(&name[start..]);
    words
}

/// A word in capitals, or with a capital first, as the model has it.
fn in_case_of(model: &str, word: &str) -> String {
    if model.chars().all(char::is_uppercase) {
        word.to_uppercase()
    } else if model.starts_with(char::is_uppercase) {
        word[..1].to_uppercase() + &word[1..]
    } else {
        word.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{DEFAULT_SCENE, SceneBuilder, built_in_scene};

    #[test]
    fn names_say_sides() {
        for (left, right) in [
            ("left_shoulder", "right_shoulder"),
            ("LeftArm", "RightArm"),
            ("armLeft2", "armRight2"),
            ("ARM_LEFT", "ARM_RIGHT"),
            ("hand.L", "hand.R"),
            ("hand.l", "hand.r"),
            ("l_foot", "r_foot"),
            ("footL", "footR"),
            ("LFoot", "RFoot"),
            ("foot L", "foot R"),
            ("왼팔", "오른팔"),
            ("왼쪽 어깨", "오른쪽 어깨"),
        ] {
            assert_eq!(other_side(left).as_deref(), Some(right));
            assert_eq!(other_side(right).as_deref(), Some(left));
        }
        for none in ["head", "bright", "cleft", "L", "r", "rl", "skull", "a_l_b", ""] {
            assert_eq!(other_side(none), None, "{none}");
        }
    }

    #[test]
    fn the_robots_have_two_sides_each() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let counterparts = scene.counterparts();
        for (rbt, other) in scene.rbt_indices().zip(counterparts) {
            let path = scene.rbt_path(rbt);
            let swapped = path.replace("left", "?").replace("right", "left").replace('?', "right");
            assert_eq!(other.map(|other| scene.rbt_path(other)), Some(swapped.as_str()));
        }
    }

    /// The other side of each node of a body with these parts, each at its place.
    #[track_caller]
    fn check(parts: &[(&str, Vec3)], expected: &[(&str, Option<&str>)]) {
        let mut builder = SceneBuilder::new();
        builder.open_rbt("body", Rbt::IDENTITY).unwrap();
        for (name, place) in parts {
            builder.open_rbt(name, Rbt::from_translation(*place)).unwrap();
            builder.open_rbt("tip", Rbt::from_translation(Vec3::Y)).unwrap();
            builder.close();
            builder.close();
        }
        builder.close();
        let scene = builder.finish("test", &["body".to_owned()], 60.0).unwrap();
        let counterparts = scene.counterparts();
        for (path, other) in expected {
            let found = counterparts[scene.find_rbt(&format!("body/{path}")).unwrap().get()];
            let other = other.map(|other| format!("body/{other}"));
            assert_eq!(found.map(|other| scene.rbt_path(other)), other.as_deref(), "{path}");
        }
    }

    #[test]
    fn positions_decide_where_names_say_nothing() {
        let near = Vec3::new(1.0, 2.0, 0.5);
        let far = Vec3::new(-1.0, 2.0, 0.5);
        check(
            &[("fin", near), ("flap", far), ("tail", Vec3::Y)],
            &[("fin", Some("flap")), ("flap/tip", Some("fin/tip")), ("tail", Some("tail"))],
        );
        // Two at the same place leave it open, and nothing is guessed.
        check(&[("fin", near), ("flap", far), ("flag", far)], &[("fin", Some("fin")), ("flag", Some("flag"))]);
        // Names go before positions.
        check(
            &[("a_l", near), ("a_r", Vec3::Z), ("b", far)],
            &[("a_l", Some("a_r")), ("a_r/tip", Some("a_l/tip")), ("b", Some("b"))],
        );
    }

    #[test]
    fn mirroring_twice_changes_nothing() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let counterparts = scene.counterparts();
        let mut pose = scene.rest_pose().clone();
        for rbt in scene.rbt_indices() {
            let by = 0.1 + 0.17 * rbt.get() as f32;
            let rotation = Quat::from_euler(glam::EulerRot::YXZ, by, 0.7 * by, -0.4 * by);
            let rest = pose.get(rbt);
            pose.set(rbt, Rbt::new(rest.translation + Vec3::new(by, 0.3, -0.2), rotation));
        }
        let mirrored = |pose: &Pose| {
            let mut mirrored = pose.clone();
            for rbt in scene.rbt_indices() {
                let other = counterparts[rbt.get()].unwrap();
                mirrored.set(other, scene.mirrored_place(pose, rbt, other));
            }
            mirrored
        };
        let once = mirrored(&pose);
        for ((twice, pose), once) in mirrored(&once).iter().zip(pose.iter()).zip(once.iter()) {
            assert!(twice.translation.distance(pose.translation) < 1e-5);
            assert!(twice.rotation.dot(pose.rotation).abs() > 1.0 - 1e-5);
            assert!(once != pose);
        }
    }
}
