//! Tooltips of the timeline.

use egui::{Response, RichText, Ui};

use super::half_turn;
use super::hit::Hit;
use super::paint::Look;
use super::{Tab, Timeline};
use crate::keyframe::{Easing, KeyframeIndex};
use crate::ui::thumbnails::Thumbnails;
use crate::ui::words::Words;
use crate::words::{Phrase, texts};

/// The curves' names, in the order of the menu.
pub const CURVES: [(&str, Phrase); 6] = [
    ("sine", texts::EASING_SINE),
    ("quad", texts::EASING_QUAD),
    ("cubic", texts::EASING_CUBIC),
    ("back", texts::EASING_BACK),
    ("bounce", texts::EASING_BOUNCE),
    ("elastic", texts::EASING_ELASTIC),
];

impl Timeline {
    /// Shows the tooltip of what the pointer is over.
    pub(super) fn tips(&self, response: &Response, look: &Look<'_>, thumbnails: &mut Thumbnails) {
        if self.tab == Tab::Graphs && self.graphs.tip(response, look) {
            return;
        }
        let Some(hit) = self.hovered else { return };
        let words = look.words;
        let (heading, body) = match hit {
            Hit::Diamond(index) => {
                let (heading, body) = keyframe(look, index);
                let pose = look.editor.document().keyframes.get(KeyframeIndex::new(index)).map(|it| &it.pose);
                response.clone().on_hover_ui_at_pointer(|ui| {
                    if let Some(pose) = pose {
                        thumbnails.show_large(ui, (index, pose));
                    }
                    tip(ui, &heading, &body, look);
                });
                return;
            }
            Hit::Grip(index) => (
                words.message(texts::interval_after(index.to_string(), length(look, index))),
                words.say(texts::DRAG_TO_RETIME_IT_WITH_SHIFT_THE).to_owned(),
            ),
            Hit::StretchEdge(_) => (
                words.message(texts::selected_together(look.editor.session().selected.len())),
                words.say(texts::DRAG_TO_SCALE_THEM_IN_TIME).to_owned(),
            ),
            Hit::HalfTurnWarning(index) => half_turn_tip(look, index),
            Hit::RangeStart => (
                words.say(texts::PLAYING_BEGINS_HERE).to_owned(),
                words.say(texts::DRAG_TO_ANOTHER_KEYFRAME).to_owned(),
            ),
            Hit::RangeEnd => {
                (words.say(texts::PLAYING_ENDS_HERE).to_owned(), words.say(texts::DRAG_TO_ANOTHER_KEYFRAME).to_owned())
            }
            Hit::Ruler | Hit::Empty => return,
        };
        response.clone().on_hover_ui_at_pointer(|ui| tip(ui, &heading, &body, look));
    }
}

pub(super) fn tip(ui: &mut Ui, heading: &str, body: &str, look: &Look<'_>) {
    ui.set_max_width(300.0);
    ui.label(heading);
    if !body.is_empty() {
        ui.label(RichText::new(body).small().color(look.tokens.dim));
    }
}

/// Which nodes turn by nearly half a turn in an interval.
fn half_turn_tip(look: &Look<'_>, index: usize) -> (String, String) {
    let (from, to) = (index.to_string(), (index + 1).to_string());
    let heading = look.words.message(texts::keyframe_half_turn(&from, &to));
    let scene = look.editor.scene();
    let nodes = half_turn::nodes(look.editor.document().keyframes.as_slice(), index, scene.rbt_indices());
    let mut lines: Vec<String> =
        nodes.iter().take(3).map(|&(rbt, degrees)| format!("{} {degrees:.1}°", scene.rbt_path(rbt))).collect();
    if nodes.len() > 3 {
        lines.push(look.words.message(texts::and_more((nodes.len() - 3).to_string())));
    }
    lines.push(look.words.say(texts::HALF_TURN_ADVICE).to_owned());
    (heading, lines.join("\n"))
}

/// The easing in words: `Sine, in and out`.
pub(super) fn easing_text(easing: Easing, words: Words) -> String {
    let (name, ends) = easing.name().split_once('-').unwrap_or((easing.name(), ""));
    let curve = CURVES.into_iter().find(|(own, _)| *own == name);
    let curve = match easing {
        Easing::Linear => words.say(texts::LINEAR),
        Easing::Hold => words.say(texts::HOLD),
        Easing::Curve(..) => curve.map_or(name, |(_, title)| words.say(title)),
    };
    match ends {
        "in" => words.message(texts::easing_in(curve)),
        "out" => words.message(texts::easing_out(curve)),
        "in-out" => words.message(texts::easing_in_out(curve)),
        _ => curve.to_owned(),
    }
}

fn length(look: &Look<'_>, index: usize) -> String {
    let keyframe = look.editor.document().keyframes.get(KeyframeIndex::new(index));
    let duration = keyframe.map_or(1.0, |keyframe| keyframe.duration);
    let seconds = duration * f64::from(look.editor.document().ms_between_keyframes) / 1000.0;
    look.words.message(texts::steps_and_seconds(format!("{duration:.2}"), format!("{seconds:.2}")))
}

fn keyframe(look: &Look<'_>, index: usize) -> (String, String) {
    let words = look.words;
    let keyframes = &look.editor.document().keyframes;
    let keyframe = keyframes.get(KeyframeIndex::new(index));
    let name = keyframe.and_then(|keyframe| keyframe.name.as_deref());
    let heading = words.message(texts::keyframe_number(index.to_string()));
    let heading = match name {
        Some(name) => format!("{heading} · {name}"),
        None => heading,
    };
    let count = keyframes.len();
    let steers = count >= 4 && (index == 0 || index + 1 == count);
    let mut lines = Vec::new();
    if steers {
        lines.push(words.say(texts::IT_ONLY_STEERS_THE_SPLINE_IT_IS).to_owned());
    } else if count >= 4 {
        let seconds = look.target.columns.time(index) * f64::from(look.editor.document().ms_between_keyframes) / 1000.0;
        lines.push(words.message(texts::key_time_and_seconds((index - 1).to_string(), format!("{seconds:.2}"))));
    }
    if index + 1 < count {
        let easing = keyframe.map_or(Easing::Linear, |keyframe| keyframe.easing);
        lines.push(words.message(texts::then_interval(length(look, index), easing_text(easing, words))));
    }
    (heading, lines.join("\n"))
}
