//! Which node follows which: a file that people edit, and what it means for two scenes.

use std::collections::BTreeMap;

use glam::Vec3;
use serde::Deserialize;
use thiserror::Error;

use crate::decode::{self, DecodeError};
use crate::interchange::figure::{Extremity, Figure};
use crate::pose::RbtIndex;
use crate::scene::SceneGraph;
use crate::words::{Message, display_by_message, quoted, texts};

/// The largest map that is read: 16 MiB.
pub const LARGEST_MAP_BYTES: u64 = 16 << 20;

const FORMAT: &str = "inbetween.retarget";

/// Which node of the target follows which node of the source, by path.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RetargetMap {
    /// The turn about y from the way that the source faces to the way that the target faces, in degrees.
    pub turn_degrees: f64,
    /// From a node of the target to the node of the source that it follows.
    pub nodes: BTreeMap<String, String>,
    /// From a node of the target that ends a leg to the node of the source that its end follows.
    pub feet: BTreeMap<String, String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MapText {
    format: String,
    version: u32,
    #[serde(default)]
    turn_degrees: f64,
    nodes: BTreeMap<String, String>,
    #[serde(default)]
    feet: BTreeMap<String, String>,
}

/// Why a text is no map.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum MapError {
    /// It is not JSON of the right shape.
    Json(DecodeError),
    /// Its format or its version is another one.
    Form {
        /// The format in the file.
        format: String,
        /// The version in the file.
        version: u32,
    },
    /// The turn is out of its range.
    Turn {
        /// The value in the file.
        degrees: f64,
    },
}

display_by_message!(MapError);

impl MapError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Json(error) => error.message(),
            Self::Form { format, version } => texts::retarget_map_form(quoted(format), *version, FORMAT),
            Self::Turn { degrees } => texts::retarget_map_turn(*degrees),
        }
    }
}

impl RetargetMap {
    /// Reads a map.
    ///
    /// # Errors
    /// [`MapError`]
    pub fn from_json(bytes: &[u8]) -> Result<Self, MapError> {
        let MapText { format, version, turn_degrees, nodes, feet } = decode::json(bytes).map_err(MapError::Json)?;
        if format != FORMAT || version != 1 {
            return Err(MapError::Form { format, version });
        }
        if !(-360.0..=360.0).contains(&turn_degrees) {
            return Err(MapError::Turn { degrees: turn_degrees });
        }
        Ok(Self { turn_degrees, nodes, feet })
    }

    /// The text of a map's file.
    #[must_use]
    pub fn to_json(&self) -> String {
        let quoted = |text: &str| serde_json::Value::from(text).to_string();
        let object = |pairs: &BTreeMap<String, String>| {
            let lines: Vec<String> =
                pairs.iter().map(|(onto, from)| format!("    {}: {}", quoted(onto), quoted(from))).collect();
            if lines.is_empty() { "{}".to_owned() } else { format!("{{\n{}\n  }}", lines.join(",\n")) }
        };
        format!(
            "{{\n  \"format\": \"{FORMAT}\",\n  \"version\": 1,\n  \"turn_degrees\": {},\n  \"nodes\": {},\n  \"feet\": {}\n}}\n",
            self.turn_degrees,
            object(&self.nodes),
            object(&self.feet),
        )
    }

    /// The map of two figures, told by their rest poses. `onto`: the target's figure is made of this node and those below it; without it
    /// the first figure of the scene is taken.
    ///
    /// # Errors
    /// One of the two has no two legs, as a sentence.
    pub fn guessed(source: &SceneGraph, target: &SceneGraph, onto: Option<RbtIndex>) -> Result<Self, Message> {
        let from = Figure::of(source).ok_or_else(|| texts::retarget_no_legs(source.name()))?;
        let figure = onto.map_or_else(|| Figure::of(target), |onto| Figure::below(target, onto));
        let name = || onto.map_or(target.name(), |onto| target.rbt_path(onto)).to_owned();
        let figure = figure.ok_or_else(|| texts::retarget_no_legs(name()))?;
        let heading = |forward: Vec3| f64::from(forward.x.atan2(forward.z)).to_degrees();
        let mut guess = Guess { source, target, map: Self::default() };
        guess.map.turn_degrees = (heading(figure.forward) - heading(from.forward)).round() + 0.0;
        guess.pair(figure.hips, from.hips);
        for (leg, of) in figure.legs.iter().zip(&from.legs) {
            guess.limb(leg, of);
            let ankle = of.after.first().copied().unwrap_or(of.lower);
            let path = |scene: &SceneGraph, rbt| scene.rbt_path(rbt).to_owned();
            guess.map.feet.insert(path(target, leg.lower), path(source, ankle));
        }
        let chests = figure.arms.as_ref().zip(from.arms.as_ref());
        if let Some(((chest, arms), (of_chest, of_arms))) = chests {
            guess.chain(figure.hips, *chest, from.hips, *of_chest);
            for (arm, of) in arms.iter().zip(of_arms) {
                guess.limb(arm, of);
            }
        }
        if let (Some(head), Some(of_head)) = (figure.head, from.head) {
            let neck = |figure: &Figure| figure.arms.as_ref().map_or(figure.hips, |(chest, _)| *chest);
            guess.chain(neck(&figure), head, neck(&from), of_head);
        }
        Ok(guess.map)
    }
}

/// A map in the making.
struct Guess<'a> {
    source: &'a SceneGraph,
    target: &'a SceneGraph,
    map: RetargetMap,
}

impl Guess<'_> {
    fn pair(&mut self, onto: RbtIndex, from: RbtIndex) {
        let (onto, from) = (self.target.rbt_path(onto).to_owned(), self.source.rbt_path(from).to_owned());
        self.map.nodes.insert(onto, from);
    }

    /// Spreads nodes over nodes of the other skeleton: the last one follows the last one.
    fn spread(&mut self, onto: &[RbtIndex], from: &[RbtIndex]) {
        if from.is_empty() {
            return;
        }
        for (index, &node) in onto.iter().enumerate() {
            self.pair(node, from[((index + 1) * from.len()).div_ceil(onto.len()) - 1]);
        }
    }

    /// Spreads the nodes from one node, without it, down to another one.
    fn chain(&mut self, top: RbtIndex, last: RbtIndex, from_top: RbtIndex, from_last: RbtIndex) {
        let between = |scene: &SceneGraph, top, last| {
            let above = std::iter::successors(Some(last), |&rbt| scene.limb_nodes(rbt).upper);
            let mut chain: Vec<RbtIndex> = above.take_while(|&rbt| rbt != top).collect();
            chain.reverse();
            chain
        };
        let (onto, from) = (between(self.target, top, last), between(self.source, from_top, from_last));
        self.spread(&onto, &from);
    }

    fn limb(&mut self, onto: &Extremity, from: &Extremity) {
        self.spread(&onto.before, &from.before);
        self.pair(onto.upper, from.upper);
        self.pair(onto.lower, from.lower);
        for (&onto, &from) in onto.after.iter().zip(&from.after) {
            self.pair(onto, from);
        }
    }
}

/// A node of the target that follows a node of the source.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub onto: RbtIndex,
    pub from: RbtIndex,
}

/// A leg of the target, and the leg of the source that it follows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot {
    pub upper: RbtIndex,
    pub lower: RbtIndex,
    /// The leg's end in the lower node's space.
    pub end: Vec3,
    /// The length of both bones, in scene units.
    pub length: f64,
    pub from_upper: RbtIndex,
    /// The node that carries the source's end, and the end in its space.
    pub from_end: (RbtIndex, Vec3),
    pub from_length: f64,
}

/// A map that fits two scenes.
#[derive(Clone, Debug)]
pub(super) struct Pairs {
    /// In the order of the target's poses; never empty.
    pub nodes: Vec<Pair>,
    pub feet: Vec<Foot>,
    /// In radians.
    pub turn: f64,
}

impl Pairs {
    pub fn of(map: &RetargetMap, source: &SceneGraph, target: &SceneGraph) -> Result<Self, Message> {
        let find = |scene: &SceneGraph, field: &'static str, path: &str| {
            scene.find_rbt(path).ok_or_else(|| texts::retarget_map_node(field, quoted(path), scene.name()))
        };
        let mut nodes = Vec::with_capacity(map.nodes.len());
        for (onto, from) in &map.nodes {
            nodes.push(Pair { onto: find(target, "nodes", onto)?, from: find(source, "nodes", from)? });
        }
        nodes.sort_by_key(|pair| pair.onto);
        if nodes.is_empty() {
            return Err(texts::RETARGET_MAP_EMPTY.into());
        }
        let from = |onto| nodes.iter().find(|pair| pair.onto == onto).map(|pair| pair.from);
        let mut feet = Vec::with_capacity(map.feet.len());
        for (onto, end) in &map.feet {
            let (lower, end) = (find(target, "feet", onto)?, find(source, "feet", end)?);
            let upper = target.limb_nodes(lower).upper;
            let foot = upper.and_then(|upper| {
                let legs = [(target, upper, lower), (source, from(upper)?, from(lower)?)];
                let tip = if Some(end) == from(lower) { source.limb_end(end, 0.0)? } else { Vec3::ZERO };
                let own = target.limb_end(lower, 0.0)?;
                let [length, from_length] = [length(legs[0], (lower, own)), length(legs[1], (end, tip))];
                let from_end = (end, tip);
                Some(Foot { upper, lower, end: own, length, from_upper: legs[1].1, from_end, from_length })
            });
            let foot = foot.filter(|foot| foot.length > 0.0 && foot.from_length > 0.0);
            feet.push(foot.ok_or_else(|| texts::retarget_map_foot(quoted(onto)))?);
        }
        Ok(Self { nodes, feet, turn: map.turn_degrees.to_radians() })
    }
}

/// The length of the two bones of a leg at rest, to a point of a node.
fn length((scene, upper, lower): (&SceneGraph, RbtIndex, RbtIndex), (end, tip): (RbtIndex, Vec3)) -> f64 {
    let place = |rbt, point| scene.world_from_rbt(scene.rest_pose(), 0.0, rbt).transform_point(point);
    let (root, knee) = (place(upper, Vec3::ZERO), place(lower, Vec3::ZERO));
    (root.distance(knee) + knee.distance(place(end, tip))).into()
}
