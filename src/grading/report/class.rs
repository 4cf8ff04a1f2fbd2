//! What the report says of the class as a whole: how many were read, how their points are spread, and what many share.

use std::fmt::Write as _;

use super::super::cells::number;
use super::super::gather::PassedOver;
use super::super::marks::Marks;
use super::super::rubric::Rubric;
use super::alike;
use super::mistakes::{self, ShownMistake};
use crate::markup::escaped;
use crate::text::counted;

/// The bars of the histogram.
const BARS: usize = 10;

/// How many were read, mean and median, and a histogram.
pub fn summary(all: &[Marks], rubric: &Rubric) -> String {
    let of = |is_wanted: fn(&Marks) -> bool| -> Vec<usize> {
        (0..all.len()).filter(|index| is_wanted(&all[*index])).collect()
    };
    let missing = of(|marks| marks.is_missing);
    let unread = of(|marks| !marks.is_missing && marks.keyframes.is_none());
    let handed_in = all.len() - missing.len();
    let mut points: Vec<f64> = all.iter().filter(|marks| !marks.is_missing).map(Marks::points).collect();
    points.sort_by(f64::total_cmp);
    let mean = points.iter().sum::<f64>() / points.len().max(1) as f64;
    let middle = points.len() / 2;
    let median = match points.len() {
        0 => 0.0,
        count if count % 2 == 0 => f64::midpoint(points[middle - 1], points[middle]),
        _ => points[middle],
    };
    let out_of: f64 = rubric.items().map(|(_, points)| points).sum();
    let rounded = |value: f64| number((value * 100.0).round() / 100.0);
    let mut text = format!(
        "<p class=\"sum\">{}, {} read; {} points on average out of {}, median {}.</p>\n",
        counted(handed_in, "submission"),
        handed_in - unread.len(),
        rounded(mean),
        number(out_of),
        rounded(median)
    );
    if !unread.is_empty() {
        let _ = writeln!(text, "<p class=\"note\">The keyframes cannot be read of {}.</p>", links(all, &unread));
    }
    if !missing.is_empty() {
        let _ = writeln!(text, "<p class=\"note\">Nothing was handed in by {}.</p>", links(all, &missing));
    }
    text.push_str(&histogram(&points, out_of));
    text
}

/// Links to the sections of submissions.
pub fn links(all: &[Marks], indices: &[usize]) -> String {
    let link = |index: &usize| format!("<a href=\"#s{index}\">{}</a>", escaped(&all[*index].name));
    indices.iter().map(link).collect::<Vec<_>>().join(", ")
}

/// How many have how many points.
fn histogram(points: &[f64], out_of: f64) -> String {
    if points.is_empty() || out_of <= 0.0 {
        return String::new();
    }
    let mut counts = [0_usize; BARS];
    for points in points {
        // All points are in the last bar. Rounding of sums must not move a submission to the bar below.
        let bar = (points / out_of * BARS as f64 + 1e-9).clamp(0.0, (BARS - 1) as f64);
        counts[bar as usize] += 1;
    }
    let most = counts.iter().copied().max().unwrap_or(1).max(1);
    let bound = |bar: usize| number((out_of * bar as f64 / BARS as f64 * 100.0).round() / 100.0);
    let mut bars = String::new();
    let mut said = Vec::new();
    for (bar, &count) in counts.iter().enumerate() {
        let (x, height) = (bar * 40, (90 * count) as f64 / most as f64);
        let (from, to) = (bound(bar), bound(bar + 1));
        if count > 0 {
            said.push(format!("{from} to {to}: {count}"));
            let _ = write!(
                bars,
                "<rect x=\"{}\" y=\"{:.1}\" width=\"36\" height=\"{height:.1}\"><title>{from} to {to} points: {count}</title></rect>\
                 <text x=\"{}\" y=\"{:.1}\">{count}</text>",
                x + 2,
                106.0 - height,
                x + 20,
                102.0 - height
            );
        }
        let _ = write!(bars, "<text x=\"{x}\" y=\"121\">{from}</text>");
    }
    format!(
        "<svg class=\"histogram\" viewBox=\"-12 0 424 126\" role=\"img\" aria-label=\"Submissions by points. {}\">{bars}\
         <path d=\"M0 106H400\"/><text x=\"400\" y=\"121\">{}</text></svg>\n",
        said.join("; "),
        bound(BARS)
    )
}

/// The common mistakes with those who made them, submissions that are alike, and what was passed over.
pub fn hints(all: &[Marks], found: &[ShownMistake], passed_over: &[PassedOver], rubric: &Rubric) -> String {
    let mut text = String::new();
    if !found.is_empty() {
        text.push_str("<section><h2>Known mistakes that samples show</h2>\n<table class=\"shared\">\n");
        for ShownMistake { mistake, shown_by, .. } in found {
            let (link, by) = (mistakes::link(mistake), links(all, shown_by));
            let _ = writeln!(text, "<tr><td>{link}</td><td class=\"n\">{}</td><td>{by}</td></tr>", shown_by.len());
        }
        text.push_str("</table></section>\n");
    }
    let groups = alike::groups(all, rubric);
    if !groups.is_empty() {
        let those = if rubric.reference.is_some() { ", and not the reference's" } else { "" };
        let _ = writeln!(
            text,
            "<section><h2>The same keyframes</h2>\n\
             <p class=\"sum\">Equal within rounding{those}. This is a hint: a class may share a template.</p>\n<ul>"
        );
        for group in &groups {
            let _ = writeln!(text, "<li class=\"note\">{}</li>", links(all, group));
        }
        text.push_str("</ul></section>\n");
    }
    if !passed_over.is_empty() {
        let passed = passed_over.iter().map(|passed| format!("{} ({})", passed.name, passed.reason));
        let passed = passed.collect::<Vec<_>>().join(", ");
        let _ = writeln!(text, "<p class=\"sum\">Passed over: {}.</p>", escaped(&passed));
    }
    text
}
