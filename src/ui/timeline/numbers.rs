//! Numbers and names of keyframes on the ruler. None runs into another, however many digits they have.

use std::sync::Arc;

use egui::text::{LayoutJob, TextWrapping};
use egui::{FontFamily, FontId, Galley, Painter, Rangef, pos2};

use super::hit::{Hit, Target};
use super::paint::{Look, keyframes, ruler_font};
use crate::keyframe::KeyframeIndex;
use crate::words::texts;

/// Room between two numbers, in points.
const APART: f32 = 6.0;
/// Room between a number and the name beside it.
const BESIDE: f32 = 4.0;
/// A name with less room than this is left out, in points.
const LEAST_FOR_NAME: f32 = 12.0;

/// A number, with the name beside it if there is one: each part with its left end, and where all of it stands.
struct Label {
    parts: Vec<(Arc<Galley>, f32)>,
    x: Rangef,
}

/// Shows the numbers. The current one always shows; the others where there is room, in round steps.
pub fn show(painter: &Painter, look: &Look<'_>) {
    let Target { scale, columns, .. } = *look.target;
    let current = look.editor.document().keyframes.current().map(KeyframeIndex::get);
    let current = current.map(|index| (index, label(painter, look, index, f32::INFINITY)));
    let kept_free = current.as_ref().map(|(_, label)| Rangef::new(label.x.min - APART, label.x.max + APART));
    let digits = columns.len().saturating_sub(1).to_string().len();
    let widest = painter.layout_no_wrap("0".repeat(digits), ruler_font(), look.tokens.dim).size().x;
    let step = stride(f64::from(widest + APART), scale.view.points_per_unit);
    let mut free_from = f32::NEG_INFINITY;
    for group in columns.groups(scale.in_sight(120.0), scale.units(widest + APART)) {
        let index = group.start.next_multiple_of(step);
        if index >= group.end || current.as_ref().is_some_and(|(current, _)| *current == index) {
            continue;
        }
        let x = scale.x_of(columns.time(index));
        let until = kept_free.filter(|kept| kept.max > x).map_or(f32::INFINITY, |kept| kept.min);
        let label = label(painter, look, index, until);
        let is_free = label.x.min >= free_from && !kept_free.is_some_and(|kept| kept.intersects(label.x));
        if is_free {
            free_from = label.x.max + APART;
            draw(painter, look, label);
        }
    }
    if let Some((_, label)) = current {
        draw(painter, look, label);
    }
}

/// How many keyframes apart the numbers stand: 1, 2, 5, 10 and so on, the least that leaves each as much room as it needs, in points.
fn stride(needed: f64, points_per_unit: f64) -> usize {
    let mut decade = 1_usize;
    loop {
        for factor in [1, 2, 5] {
            #[expect(clippy::cast_precision_loss, reason = "it is for points on a screen")]
            let room = (decade * factor) as f64 * points_per_unit;
            if room >= needed || decade > 1_000_000 {
                return decade * factor;
            }
        }
        decade *= 10;
    }
}

/// The label of a keyframe. Its name ends before `until`, and before the next keyframe.
fn label(painter: &Painter, look: &Look<'_>, index: usize, until: f32) -> Label {
    let Target { scale, columns, .. } = *look.target;
    let tokens = look.tokens;
    let is_current = look.editor.document().keyframes.current() == Some(KeyframeIndex::new(index));
    let colour = match (is_current, look.hovered == Some(Hit::Diamond(index))) {
        (true, _) => tokens.accent_text,
        (false, true) => tokens.text,
        (false, false) => tokens.dim,
    };
    let number = painter.layout_no_wrap(index.to_string(), ruler_font(), colour);
    let x = scale.x_of(columns.time(index));
    let half = number.size().x / 2.0;
    let (left, right) = (x - half, x + half);
    let next = if index + 1 < columns.len() { scale.x_of(columns.time(index + 1)) - 12.0 } else { f32::INFINITY };
    let font = FontId::new(11.0, FontFamily::Proportional);
    if let Some(name) = keyframes(look).get(index).and_then(|keyframe| keyframe.name.as_deref()) {
        let room = next.max(x + 48.0).min(until) - right - BESIDE;
        if room > LEAST_FOR_NAME {
            let text = if is_current { tokens.accent_text } else { tokens.text };
            let mut job = LayoutJob::simple_singleline(name.to_owned(), font, text);
            job.wrap = TextWrapping::truncate_at_width(room);
            return with_name((number, left), painter.layout_job(job), right + BESIDE);
        }
    } else if look.target.range.is_some() && (index == 0 || index + 1 == columns.len()) {
        // It stands beside the keyframe that never plays, where people wonder why it does not.
        let text = look.words.say(texts::ONLY_STEERS).to_owned();
        let name = painter.layout_no_wrap(text, font, colour);
        let width = name.size().x + BESIDE;
        // Before the last keyframe there is more room than after it.
        let previous = index.checked_sub(1).map(|before| scale.x_of(columns.time(before)) + 16.0);
        match previous {
            Some(previous) if left - width >= previous => return with_name((number, left), name, left - width),
            None if right + width <= next.min(until) => return with_name((number, left), name, right + BESIDE),
            _ => {}
        }
    }
    Label { parts: vec![(number, left)], x: Rangef::new(left, right) }
}

/// A number and the name that begins at `from`.
fn with_name((number, left): (Arc<Galley>, f32), name: Arc<Galley>, from: f32) -> Label {
    let x = Rangef::new(left.min(from), (left + number.size().x).max(from + name.size().x));
    Label { parts: vec![(number, left), (name, from)], x }
}

fn draw(painter: &Painter, look: &Look<'_>, label: Label) {
    let y = look.target.layout.ruler.top() + 20.0;
    for (galley, left) in label.parts {
        // The colours are the galleys' own.
        let at = pos2(left, y - galley.size().y / 2.0);
        painter.galley(at, galley, look.tokens.text);
    }
}
