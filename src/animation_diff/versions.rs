//! What differs between two versions of a keyframe list or of a scene, in a few sentences: the file's and the one at hand.

use super::{Played, Tolerances, compare, distances, frame_times_ms};
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeList, PlayRange};
use crate::scene::SceneGraph;
use crate::words::{Argument, Message, texts};

/// Frames per second at which playback is compared.
const FPS: u32 = 10;
/// The longest playback that is compared, in frames.
const MOST_FRAMES: usize = 2_000;
/// The most items of a list that a sentence names.
const MOST_NAMED: usize = 8;

/// A keyframe list with what its file says of playing.
#[derive(Clone, Copy, Debug)]
pub struct Version<'a> {
    /// The list.
    pub keyframes: &'a KeyframeList,
    /// The interpolation.
    pub interpolation: Interpolation,
    /// Milliseconds between keyframes.
    pub ms_between_keyframes: u32,
}

/// What differs between a file's keyframes and those at hand, all of one scene: at least one sentence.
#[must_use]
pub fn keyframe_differences(scene: &SceneGraph, theirs: Version<'_>, ours: Version<'_>) -> Vec<Message> {
    let mut said = Vec::new();
    let (their_count, our_count) = (theirs.keyframes.len(), ours.keyframes.len());
    if their_count != our_count {
        said.push(texts::differs_counts(texts::count_keyframes(their_count), texts::count_keyframes(our_count)));
    }
    if theirs.interpolation != ours.interpolation {
        said.push(texts::differs_interpolation(theirs.interpolation.title(), ours.interpolation.title()));
    }
    if theirs.ms_between_keyframes != ours.ms_between_keyframes {
        said.push(texts::differs_ms(theirs.ms_between_keyframes, ours.ms_between_keyframes));
    }
    said.extend(keyframes(scene, theirs.keyframes, ours.keyframes));
    if said.is_empty() {
        return vec![texts::differs_same_count(texts::count_keyframes(our_count)), texts::DIFFERS_NOTHING.into()];
    }
    if their_count == our_count {
        said.insert(0, texts::differs_same_count(texts::count_keyframes(our_count)));
    }
    said.extend(playing(scene, theirs, ours));
    said
}

/// The keyframes that differ where both lists have one, and the node that differs most.
fn keyframes(scene: &SceneGraph, theirs: &KeyframeList, ours: &KeyframeList) -> Vec<Message> {
    let pairs = || theirs.as_slice().iter().zip(ours.as_slice()).enumerate();
    let differing: Vec<usize> = pairs().filter(|(_, (a, b))| !a.same_as(b)).map(|(index, _)| index).collect();
    let Some(list) = listed(differing.iter().map(usize::to_string)) else { return Vec::new() };
    let tolerances = Tolerances::default();
    let mut most: Option<(f64, Message)> = None;
    for (index, (a, b)) in pairs().filter(|(index, _)| differing.binary_search(index).is_ok()) {
        for rbt in scene.rbt_indices() {
            let (units, degrees) = distances(a.pose.get(rbt), b.pose.get(rbt));
            let off = tolerances.weight(units, degrees);
            if off > most.as_ref().map_or(0.0, |(off, _)| *off) {
                let said = texts::differs_most(scene.rbt_path(rbt), index, rounded(units), rounded(degrees));
                most = Some((off, said));
            }
        }
    }
    let most = most.map_or_else(|| texts::DIFFERS_NOT_IN_POSE.into(), |(_, said)| said);
    vec![texts::differs_keyframes(list), most]
}

/// How far they are apart while they play, where both can.
fn playing(scene: &SceneGraph, theirs: Version<'_>, ours: Version<'_>) -> Option<Message> {
    let (their_range, our_range) = (PlayRange::new(theirs.keyframes).ok()?, PlayRange::new(ours.keyframes).ok()?);
    let (a, b) = (theirs.played(&their_range), ours.played(&our_range));
    let times = frame_times_ms(&a.length_ms().max(b.length_ms()), FPS, MOST_FRAMES)?;
    let tolerances = Tolerances::default();
    let difference = compare(a, b, &times, tolerances).ok()?;
    let weights =
        difference.nodes.iter().map(|node| tolerances.weight(node.translation.largest, node.rotation.largest));
    let (node, weight) = weights.enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?;
    if weight == 0.0 {
        return None;
    }
    let found = difference.nodes[node];
    let is_translation =
        tolerances.weight(found.translation.largest, 0.0) >= tolerances.weight(0.0, found.rotation.largest);
    let at = if is_translation { found.translation.largest_at } else { found.rotation.largest_at };
    let (units, degrees) = (rounded(found.translation.largest), rounded(found.rotation.largest));
    Some(texts::differs_playing(scene.rbt_paths().nth(node)?, units, degrees, rounded(at)))
}

/// What differs between a file's scene and the one at hand: at least one sentence.
#[must_use]
pub fn scene_differences(theirs: &SceneGraph, ours: &SceneGraph) -> Vec<Message> {
    let missing = |from: &SceneGraph, of: &SceneGraph| {
        listed(from.nodes().iter().filter(|node| of.find(&node.path).is_none()).map(|node| node.path.clone()))
    };
    let differs = |path: &str| {
        theirs.find(path).zip(ours.find(path)).is_some_and(|(a, b)| theirs.node(a).kind != ours.node(b).kind)
    };
    let changed = listed(ours.nodes().iter().filter(|node| differs(&node.path)).map(|node| node.path.clone()));
    let sentences = [
        missing(theirs, ours).map(texts::differs_nodes_theirs),
        missing(ours, theirs).map(texts::differs_nodes_ours),
        changed.map(texts::differs_nodes_changed),
    ];
    let mut said: Vec<Message> = sentences.into_iter().flatten().collect();
    if said.is_empty() {
        said.push(if theirs == ours { texts::DIFFERS_NOTHING.into() } else { texts::DIFFERS_SCENE_ELSE.into() });
    }
    said
}

impl Version<'_> {
    fn played<'a>(&self, range: &'a PlayRange<'a>) -> Played<'a> {
        Played { range, interpolation: self.interpolation, ms_between_keyframes: self.ms_between_keyframes }
    }
}

/// The first items with commas between them, and how many more there are; `None` where there is none.
fn listed(items: impl Iterator<Item = String>) -> Option<Argument> {
    let items: Vec<String> = items.collect();
    let list = items[..items.len().min(MOST_NAMED)].join(", ");
    match items.len().saturating_sub(MOST_NAMED) {
        0 => (!items.is_empty()).then(|| list.into()),
        more => Some(texts::differs_and_more(list, more).into()),
    }
}

/// With as many digits as a reader wants.
fn rounded(number: f64) -> String {
    let text = format!("{number:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests;
