//! What a rubric can find out: which of the known mistakes its reference reveals, and which keyframes would make it reveal the others.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::item::ItemKind;
use super::rubric::{Reference, Rubric};
use crate::animation_diff::{Played, Tolerances, frame_times_ms};
use crate::diagnosis::{ChangeKind, Hidden, Judged, KeyframeChange, Mistake, Sequence, change_that_reveals, revealing};
use crate::interpolation::Interpolation;
use crate::scene::SceneGraph;
use crate::text::{counted, listed};

/// The most moments that are looked at. A longer animation is looked at in as many, evenly spread.
const MOST_MOMENTS: usize = 2_000;

/// Which known mistakes a reference reveals where playback gets points.
#[derive(Clone, Debug, Default)]
pub struct Revealed {
    /// The playbacks that get points.
    pub playbacks: Vec<Interpolation>,
    /// The mistakes that are revealed, in the catalogue's order.
    pub revealed: Vec<&'static Mistake>,
    /// Those that are not.
    pub hidden: Vec<Hidden>,
    key_times: Vec<f64>,
}

impl Revealed {
    /// What a rubric's reference reveals; nothing without one.
    pub(super) fn by(rubric: &Rubric) -> Self {
        let Some(reference) = &rubric.reference else { return Self::default() };
        let Ok(sequence) = Sequence::new(reference.list.as_slice()) else { return Self::default() };
        let (playbacks, key_times) = (playbacks_of(rubric), key_times(reference, rubric));
        let (revealed, hidden) = revealing(&judged(&sequence, &playbacks, &key_times, rubric.tolerances));
        Self { playbacks, revealed, hidden, key_times }
    }

    /// A sentence about what is not revealed, where something is not.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let names: Vec<String> = self.hidden.iter().map(|hidden| named(hidden, &self.playbacks)).collect();
        (!names.is_empty()).then(|| {
            format!(
                "The reference does not reveal {}: a program with such a mistake can get full points for playback. \
                 inbetween grade --check says which keyframes would reveal it.",
                listed(&names, "and")
            )
        })
    }

    /// What is not revealed, as JSON: with the playbacks and what would reveal it.
    #[must_use]
    pub fn not_revealed(&self) -> Vec<Value> {
        self.hidden.iter().map(of_hidden).collect()
    }
}

/// A mistake that is not revealed, as JSON.
fn of_hidden(hidden: &Hidden) -> Value {
    let playbacks: Vec<&str> = hidden.playbacks.iter().map(|playback| playback.name()).collect();
    json!({"mistake": hidden.mistake.name, "playbacks": playbacks, "revealed_by": hidden.mistake.revealed_by})
}

/// The name of a mistake, with the playback where it is hidden in only one of those that count.
fn named(hidden: &Hidden, playbacks: &[Interpolation]) -> String {
    match hidden.playbacks.as_slice() {
        [one] if playbacks.len() > 1 => format!("{} ({})", hidden.mistake.name, one.title()),
        _ => hidden.mistake.name.to_owned(),
    }
}

fn judged<'a>(
    sequence: &'a Sequence,
    playbacks: &'a [Interpolation],
    key_times: &'a [f64],
    tolerances: Tolerances,
) -> Judged<'a> {
    let Tolerances { translation, rotation_degrees } = tolerances;
    Judged { sequence, playbacks, key_times, units: translation, degrees: rotation_degrees }
}

/// The key times at which playback is judged: of the fewest samples that cover it or, where it is assumed, of the frames that are played.
fn key_times(reference: &Reference, rubric: &Rubric) -> Vec<f64> {
    let range = reference.range();
    let evenly = |count: usize| {
        let end = range.last_key_time() as f64;
        (0..=count).map(|moment| end * moment as f64 / count as f64).collect()
    };
    let samples = rubric.samples_per_interval * range.last_key_time();
    if !rubric.assumes_playback && samples > 0 {
        return evenly(samples.min(MOST_MOMENTS));
    }
    let Reference { interpolation, ms_between_keyframes, .. } = *reference;
    let played = Played { range: &range, interpolation, ms_between_keyframes };
    match frame_times_ms(&played.length_ms(), rubric.fps, MOST_MOMENTS) {
        Some(times) => times.iter().map(|ms| played.key_time_at(ms)).collect(),
        None => evenly(MOST_MOMENTS),
    }
}

/// The playbacks that get points.
fn playbacks_of(rubric: &Rubric) -> Vec<Interpolation> {
    let playback = |(kind, _)| if let ItemKind::Playback(playback) = kind { Some(playback) } else { None };
    rubric.items().filter_map(playback).collect()
}

/// What `grade --check` says about a rubric.
#[must_use]
pub struct RubricCheck<'a> {
    rubric: &'a Rubric,
    /// For each hidden mistake a change of keyframes that reveals it, where there is one.
    changes: Vec<Option<String>>,
}

impl<'a> RubricCheck<'a> {
    /// Looks for what would reveal the mistakes that are not revealed.
    pub fn of(rubric: &'a Rubric, scene: &SceneGraph) -> Self {
        let revealed = &rubric.revealed;
        let sequence = rubric.reference.as_ref().and_then(|reference| Sequence::new(reference.list.as_slice()).ok());
        let change = |hidden: &Hidden| {
            let sequence = sequence.as_ref()?;
            let judged = judged(sequence, &revealed.playbacks, &revealed.key_times, rubric.tolerances);
            change_that_reveals(&judged, hidden).map(|change| sentence(&change, scene))
        };
        Self { rubric, changes: revealed.hidden.iter().map(change).collect() }
    }

    /// The check as sentences.
    #[must_use]
    pub fn sentences(&self) -> String {
        let Revealed { playbacks, revealed, hidden, key_times } = &self.rubric.revealed;
        let Some(reference) = &self.rubric.reference else {
            return "The rubric has no reference: it reveals no mistake of playback.\n".to_owned();
        };
        if playbacks.is_empty() {
            return "The rubric gives no points for playback: no mistake of playback costs points.\n".to_owned();
        }
        let titles: Vec<String> = playbacks.iter().map(|playback| playback.title().to_string()).collect();
        let Tolerances { translation, rotation_degrees } = self.rubric.tolerances;
        let mut text = format!(
            "The reference has {}. Playback that gets points: {}. It is judged at {}, within {translation} units and \
             {rotation_degrees} degrees.\n",
            counted(reference.list.len(), "keyframe"),
            listed(&titles, "and"),
            counted(key_times.len(), "moment"),
        );
        let all = revealed.len() + hidden.len();
        let names: Vec<&str> = revealed.iter().map(|mistake| mistake.name).collect();
        let _ = match (names.as_slice(), hidden.as_slice()) {
            (_, []) => writeln!(text, "It reveals all {all} known mistakes: {}.", names.join(", ")),
            ([], _) => writeln!(text, "It reveals none of the {all} known mistakes."),
            _ => writeln!(text, "It reveals {} of {all} known mistakes: {}.", names.len(), names.join(", ")),
        };
        for (hidden, change) in hidden.iter().zip(&self.changes) {
            let _ = writeln!(text, "\nNot revealed: {}. {}", named(hidden, playbacks), hidden.mistake.what);
            let _ = writeln!(text, "What reveals it: {}", hidden.mistake.revealed_by);
            if let Some(change) = change {
                let _ = writeln!(text, "For example: {change}");
            }
        }
        text
    }

    /// The check as one line of JSON.
    #[must_use]
    pub fn json(&self) -> String {
        let Revealed { playbacks, revealed, hidden, .. } = &self.rubric.revealed;
        let hidden = hidden.iter().zip(&self.changes).map(|(hidden, change)| {
            let mut value = of_hidden(hidden);
            value["example"] = json!(change);
            value
        });
        let value = json!({
            "playbacks": playbacks.iter().map(|playback| playback.name()).collect::<Vec<_>>(),
            "revealed": revealed.iter().map(|mistake| mistake.name).collect::<Vec<_>>(),
            "not_revealed": hidden.collect::<Vec<_>>(),
        });
        format!("{value}\n")
    }
}

/// A change of keyframes as a sentence.
fn sentence(change: &KeyframeChange, scene: &SceneGraph) -> String {
    const REVERSED: &str = "with all four signs reversed: it is the same rotation";
    let KeyframeChange { node, first, last, kind } = *change;
    let path = scene.rbt_path(node);
    let place = if first == last { format!("keyframe {first}") } else { format!("keyframes {first} and {last}") };
    match kind {
        ChangeKind::OppositeSign => format!("write the rotation of {path} in {place} {REVERSED}."),
        ChangeKind::Turn(axis, degrees) => {
            format!("turn {path} in {place} by {degrees} degrees about its {axis} axis.")
        }
        ChangeKind::TurnAndOppositeSign(axis, degrees) => {
            format!(
                "turn {path} in {place} by {degrees} degrees about its {axis} axis, and write its rotation {REVERSED}."
            )
        }
        ChangeKind::TurnAboutTwoAxes(degrees) => format!(
            "turn {path} by {degrees} degrees about its x axis in keyframe {first} and about its y axis in keyframe {last}."
        ),
        ChangeKind::TurnAndMove(degrees) => {
            format!("turn {path} in {place} by {degrees} degrees about its x axis, and move it by 1 unit along x.")
        }
        ChangeKind::Move(tenths) => {
            format!("move {path} in {place} by {} units along x.", f64::from(tenths) / 10.0)
        }
    }
}
