//! What is said of the thing under the pointer.

use egui::{Response, RichText, Ui};

use super::hit::Hit;
use super::paint::Look;
use super::{Tab, Timeline};
use crate::keyframe::{Easing, KeyframeIndex};

impl Timeline {
    /// Shows the tooltip of what the pointer is over.
    pub(super) fn tips(&self, response: &Response, look: &Look<'_>) {
        if self.tab == Tab::Graphs && self.graphs.tip(response, look) {
            return;
        }
        let Some(hit) = self.hovered else { return };
        let (heading, body) = match hit {
            Hit::Diamond(place) => keyframe(look, place),
            Hit::Grip(place) => (
                format!("The interval after keyframe {place}: {}", length(look, place)),
                "Drag to retime it. With Shift the next one gives what this one takes.".to_owned(),
            ),
            Hit::RangeStart => ("Playing begins here".to_owned(), "Drag to another keyframe.".to_owned()),
            Hit::RangeEnd => ("Playing ends here".to_owned(), "Drag to another keyframe.".to_owned()),
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

/// The easing in words: `sine, in and out`.
pub(super) fn easing_text(easing: Easing) -> String {
    easing.name().replace("-in-out", ", in and out").replace('-', ", ")
}

fn length(look: &Look<'_>, place: usize) -> String {
    let keyframe = look.editor.document().keyframes.get(KeyframeIndex::new(place));
    let duration = keyframe.map_or(1.0, |keyframe| keyframe.duration);
    let seconds = duration * f64::from(look.editor.document().ms_between_keyframes) / 1000.0;
    format!("{duration:.2} steps = {seconds:.2} s")
}

fn keyframe(look: &Look<'_>, place: usize) -> (String, String) {
    let keyframes = &look.editor.document().keyframes;
    let keyframe = keyframes.get(KeyframeIndex::new(place));
    let name = keyframe.and_then(|keyframe| keyframe.name.as_deref());
    let heading = match name {
        Some(name) => format!("Keyframe {place} · {name}"),
        None => format!("Keyframe {place}"),
    };
    let count = keyframes.len();
    let steers = count >= 4 && (place == 0 || place + 1 == count);
    let mut lines = Vec::new();
    if steers {
        lines.push("It only steers the spline: it is not played.".to_owned());
    } else if count >= 4 {
        let seconds = look.target.columns.time(place) * f64::from(look.editor.document().ms_between_keyframes) / 1000.0;
        lines.push(format!("Key time {} · {seconds:.2} s", place - 1));
    }
    if place + 1 < count {
        let easing = keyframe.map_or(Easing::Linear, |keyframe| keyframe.easing);
        lines.push(format!("Then {} · {}", length(look, place), easing_text(easing)));
    }
    (heading, lines.join("\n"))
}
