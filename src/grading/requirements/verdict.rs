//! Verdicts on requirements.

use glam::{Affine3A, Vec3};

use super::playing::{Moment, Playing};
use super::{Requirement, Requirements};
use crate::animation_diff::{Played, Tolerances, distances};
use crate::grading::item::{Evidence, Verdict};
use crate::grading::parsed::{Parsed, ParsedKeyframes};
use crate::grading::rubric::Rubric;
use crate::grading::samples::SampleDiagnosis;
use crate::grading::submission::shortly;
use crate::interpolation::Interpolation;
use crate::keyframe::{Keyframe, PlayRange};
use crate::pose::RbtIndex;
use crate::rbt::Rbt;
use crate::scene::{NodeId, NodeKind, SceneGraph};
use crate::text::counted;

/// How far a coordinate may be off by rounding, in scene units.
const ROUNDING: f64 = 1e-5;

/// What was handed in, as far as requirements look at it.
pub struct Work<'a> {
    /// The rubric.
    pub rubric: &'a Rubric,
    /// The scene.
    pub scene: &'a SceneGraph,
    /// The submission.
    pub parsed: &'a Parsed,
    /// What its samples show.
    pub samples: &'a [SampleDiagnosis],
}

impl Work<'_> {
    /// The verdict on a requirement.
    #[must_use]
    pub fn verdict(&self, requirement: Requirement) -> Verdict {
        let numbers = &self.rubric.requirements;
        let read = || self.parsed.keyframes.as_ref().map_err(|_| "The keyframes cannot be read.".to_owned());
        let verdict = match requirement {
            Requirement::MinimumKeyframes => read().map(|read| self.keyframes(read)),
            Requirement::MinimumNodesMoved => read().map(|read| self.nodes_moved(read)),
            Requirement::UsesCatmullRom => read().map(|read| self.catmull_rom(read)),
            Requirement::AboveGround => {
                read().and_then(|read| self.played(read, |playing| above_ground(playing, numbers.lowest_y)))
            }
            Requirement::NoJumps => read().and_then(|read| self.played(read, |playing| no_jumps(playing, numbers))),
            Requirement::ScriptRuns => Ok(self.script_runs()),
        };
        verdict.unwrap_or_else(Verdict::unmet)
    }

    /// A verdict on how keyframes play, or why they do not.
    fn played(&self, read: &ParsedKeyframes, look: impl FnOnce(&Playing) -> Verdict) -> Result<Verdict, String> {
        let range = PlayRange::new(&read.list).map_err(|error| format!("{error}."))?;
        let (interpolation, ms_between_keyframes) = read.pace(self.rubric);
        let played = Played { range: &range, interpolation, ms_between_keyframes };
        Ok(look(&Playing { scene: self.scene, played }))
    }

    fn keyframes(&self, read: &ParsedKeyframes) -> Verdict {
        let (found, least) = (read.list.len(), self.rubric.requirements.minimum_keyframes);
        let count = counted(found, "keyframe");
        if found as u64 >= least {
            Verdict::met(format!("{count}."))
        } else {
            Verdict::unmet(format!("{count}, expected at least {least}."))
        }
    }

    /// Of the played keyframes, since the others are never shown.
    fn nodes_moved(&self, read: &ParsedKeyframes) -> Verdict {
        let (first, rest) = match read.list.as_slice() {
            [_, first, rest @ .., _] => (Some(first), rest),
            _ => (None, &[][..]),
        };
        let Tolerances { translation, rotation_degrees } = self.rubric.tolerances;
        let is_moved = |rbt: &RbtIndex| {
            let Some(begin) = first.map(|keyframe: &Keyframe| keyframe.pose.get(*rbt)) else { return false };
            rest.iter().any(|keyframe| {
                let (units, degrees) = distances(begin, keyframe.pose.get(*rbt));
                units > translation || degrees > rotation_degrees
            })
        };
        let moved = self.scene.rbt_indices().filter(is_moved);
        let moved: Vec<&str> = moved.map(|rbt| self.scene.rbt_path(rbt)).collect();
        let least = self.rubric.requirements.minimum_nodes_moved;
        let verb = if moved.len() == 1 { "moves" } else { "move" };
        let found = match moved.len() {
            0 => "No node moves".to_owned(),
            count => format!("{} {verb}: {}", counted(count, "node"), shortly(&moved)),
        };
        if moved.len() as u64 >= least {
            Verdict::met(format!("{found}."))
        } else {
            Verdict::unmet(format!("{found}. Expected at least {least}."))
        }
    }

    /// What the keyframe file says; where it says nothing, what samples, a trace or a script show.
    fn catmull_rom(&self, read: &ParsedKeyframes) -> Verdict {
        const WANTED: Interpolation = Interpolation::CatmullRom;
        let file = &read.file;
        match read.held.0 {
            Some(WANTED) => return Verdict::met(format!("{file} is played by Catmull-Rom splines.")),
            Some(other) => return Verdict::unmet(format!("{file} is played by {} interpolation.", other.name())),
            None => {}
        }
        let shows = |samples: &&SampleDiagnosis| {
            let explained = samples.diagnosis.as_ref().ok().filter(|diagnosis| diagnosis.is_explained());
            explained.is_some_and(|diagnosis| diagnosis.best().interpolation() == WANTED)
        };
        if let Some(samples) = self.samples.iter().find(shows) {
            let reason = format!("{} shows playback by Catmull-Rom splines.", samples.file);
            return Verdict::met(reason).by(Evidence::Samples);
        }
        if let Some((name, evidence)) = self.traced_with(WANTED) {
            return Verdict::met(format!("{name} uses Catmull-Rom splines.")).by(evidence);
        }
        Verdict::unmet(format!(
            "{file} does not say how it is played, as no text can, and neither samples, a trace nor a script show Catmull-Rom splines."
        ))
    }

    /// The trace, or the script that is run, in which something plays by an interpolation.
    fn traced_with(&self, wanted: Interpolation) -> Option<(&str, Evidence)> {
        if let Some(trace) = &self.parsed.trace
            && let Ok(objects) = &trace.content
            && objects.iter().any(|object| object["playing"] == true && object["interpolation"] == wanted.name())
        {
            return Some((&trace.name, Evidence::Trace));
        }
        let script = self.parsed.script.as_ref()?;
        let ran = self.parsed.ran(self.rubric, self.scene)?.ok()?;
        let plays = ran.trace.iter().any(|step| step.state.is_playing && step.state.interpolation == wanted);
        plays.then_some((script.name.as_str(), Evidence::Script))
    }

    fn script_runs(&self) -> Verdict {
        let (Some(script), Some(ran)) = (&self.parsed.script, self.parsed.ran(self.rubric, self.scene)) else {
            return Verdict::unmet("No script was handed in.");
        };
        let name = &script.name;
        let verdict = match ran {
            Err(problem) => Verdict::unmet(format!("{name}: {problem}.")),
            Ok(ran) => match ran.trace.iter().find_map(|step| Some((step, step.refusal.as_ref()?))) {
                Some((step, refusal)) => {
                    Verdict::unmet(format!("{name}: line {} ({}): {refusal}", step.line, step.command))
                }
                None => Verdict::met(format!("{name}: {} run.", counted(ran.trace.len(), "command"))),
            },
        };
        verdict.by(Evidence::Script)
    }
}

/// The shapes that may be below the ground: grounds, and what the first eye, the sky's, carries.
fn is_free(scene: &SceneGraph, id: NodeId) -> bool {
    let sky = scene.eyes().first().map(|eye| scene.subtree(scene.rbt_node(*eye)));
    let ground = scene.find("ground").map(|ground| scene.subtree(ground));
    [sky, ground].into_iter().flatten().any(|subtree| subtree.contains(&id.get()))
}

fn above_ground(playing: &Playing, lowest_y: f64) -> Verdict {
    let scene = playing.scene;
    let shapes = scene.nodes_with_ids().filter_map(|(id, node)| match &node.kind {
        NodeKind::Shape(placed) if !placed.shape.is_ground() && !is_free(scene, id) => Some((id, &placed.shape)),
        _ => None,
    });
    let shapes: Vec<_> = shapes.collect();
    let mut lowest: Option<(f64, f64, NodeId)> = None;
    let mut first_below = None;
    let look = |moment: &Moment, _: &Moment| {
        for (id, shape) in &shapes {
            let world_from_node = |id: NodeId| moment.world_from_node[id.get()].get();
            let world_from_shape: Affine3A = world_from_node(*id);
            let axes = world_from_shape.matrix3;
            let down_in_shape = -Vec3::new(axes.x_axis.y, axes.y_axis.y, axes.z_axis.y);
            let y = match scene.skin(*id) {
                Some(skin) => {
                    let world_from_bind: Vec<Affine3A> = skin.world_from_bind(world_from_node).collect();
                    let heights = skin.skinned(&world_from_bind);
                    f64::from(heights.iter().map(|vertex| vertex.position[1]).fold(f32::INFINITY, f32::min))
                }
                None => f64::from(world_from_shape.translation.y - shape.reach(down_in_shape)),
            };
            if lowest.is_none_or(|(lowest, ..)| y < lowest) {
                lowest = Some((y, moment.key_time, *id));
            }
            if y < lowest_y - ROUNDING && first_below.is_none() {
                first_below = Some(moment.key_time);
            }
        }
    };
    let (count, are_all) = playing.each_step(look);
    let looked_at = looked_at(count, are_all);
    match (lowest, first_below) {
        (Some((y, at, id)), Some(first)) => Verdict::unmet(format!(
            "{} reaches y = {y:.3} at key time {at:.3}, {:.3} below {lowest_y}; something is below it from key time {first:.3} on.",
            scene.node(id).path,
            lowest_y - y
        )),
        (Some((y, at, id)), None) => Verdict::met(format!(
            "Nothing is below y = {lowest_y}{looked_at}. The lowest is {}: y = {y:.3} at key time {at:.3}.",
            scene.node(id).path
        )),
        (None, _) => Verdict::met("Nothing can be below the ground."),
    }
}

/// A step of a node in 1/60 s.
#[derive(Clone, Copy)]
struct Stride {
    /// How much larger than allowed it is.
    excess: f64,
    units: f64,
    degrees: f64,
    key_time: f64,
    node: usize,
}

fn no_jumps(playing: &Playing, requirements: &Requirements) -> Verdict {
    let Requirements { largest_step, largest_step_degrees, .. } = *requirements;
    let scene = playing.scene;
    let ids: Vec<NodeId> = scene.rbt_indices().map(|rbt| scene.rbt_node(rbt)).collect();
    let mut largest: Option<Stride> = None;
    let look = |now: &Moment, next: &Moment| {
        for (node, id) in ids.iter().enumerate() {
            let [from, to] = [now, next].map(|moment| Rbt::from_affine(&moment.world_from_node[id.get()].get()));
            let (units, degrees) = distances(from, to);
            let excess = (units - largest_step - ROUNDING).max((degrees - largest_step_degrees - 0.01) / 60.0);
            if largest.is_none_or(|largest| excess > largest.excess) {
                largest = Some(Stride { excess, units, degrees, key_time: now.key_time, node });
            }
        }
    };
    let (count, are_all) = playing.each_step(look);
    let Some(Stride { excess, units, degrees, key_time, node }) = largest else {
        return Verdict::met("Nothing can jump.");
    };
    let path = scene.node(ids[node]).path.as_str();
    let step =
        format!("{path} moves {units:.3} units and turns {degrees:.2} degrees in 1/60 s at key time {key_time:.3}");
    let allowed = format!("{largest_step} units and {largest_step_degrees} degrees");
    if excess > 0.0 {
        Verdict::unmet(format!("{step}; at most {allowed} are allowed."))
    } else {
        Verdict::met(format!("Nothing jumps{}: {step}, which is within {allowed}.", looked_at(count, are_all)))
    }
}

/// How many moments were looked at, where these are not all.
fn looked_at(count: usize, are_all: bool) -> String {
    if are_all { String::new() } else { format!(" at the {count} moments that were looked at") }
}
