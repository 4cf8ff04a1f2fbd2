//! The table of students by items.

use std::fmt::Write as _;

use super::super::cells::number;
use super::super::item::{Item, ItemKind};
use super::super::marks::Marks;
use super::super::tables::diagnoses;
use super::student;
use crate::markup::escaped;

/// A row for each submission, a column for each item; all keyframes are one column. The page's script sorts and filters it.
pub fn of_class(all: &[Marks]) -> String {
    let has_students = all.iter().any(|marks| student::student(marks).is_some());
    let columns = all.first().map_or_else(Vec::new, |marks| columns(&marks.items));
    let mut text = String::from("<section class=\"wide\"><table class=\"overview\">\n<thead><tr><th>submission</th>");
    if has_students {
        text.push_str("<th>student</th>");
    }
    text.push_str("<th>points</th><th>look at</th>");
    for (title, ..) in &columns {
        let _ = write!(text, "<th>{}</th>", escaped(title));
    }
    text.push_str("<th>evidence</th><th>samples show</th></tr></thead>\n<tbody>\n");
    for (index, marks) in all.iter().enumerate() {
        let _ = write!(text, "<tr><td><a href=\"#s{index}\">{}</a></td>", escaped(&marks.name));
        if has_students {
            let _ = write!(text, "<td>{}</td>", escaped(&student::student(marks).unwrap_or_default()));
        }
        let (points, out_of) = (marks.points(), marks.out_of());
        let share = if out_of > 0.0 { 100.0 * points / out_of } else { 0.0 };
        let _ = write!(
            text,
            "<td class=\"n\" data-value=\"{points}\">{} / {}<span class=\"bar\"><i style=\"width:{share:.0}%\"></i></span></td>",
            number(points),
            number(out_of)
        );
        text.push_str(match (&marks.keyframes, marks.notes.iter().any(|note| note.wants_a_look)) {
            _ if marks.is_missing => "<td class=\"look\">missing</td>",
            (None, _) => "<td class=\"look\">unreadable</td>",
            (Some(_), true) => "<td class=\"look\">note</td>",
            (Some(_), false) => "<td></td>",
        });
        for (_, from, to) in &columns {
            let items = marks.items.get(*from..*to).unwrap_or_default();
            let points: f64 = items.iter().map(|item| item.points).sum();
            let class = if items.iter().any(Item::has_lost) { "lost" } else { "full" };
            let _ = write!(text, "<td class=\"n {class}\">{}</td>", number(points));
        }
        let mut shown = diagnoses(marks);
        shown.dedup();
        let _ = writeln!(text, "<td>{}</td><td>{}</td></tr>", escaped(&marks.evidence()), escaped(&shown.join(", ")));
    }
    text.push_str("</tbody></table></section>\n");
    text
}

/// The columns of items: title, and the range of their indices. Every submission has the same items.
fn columns(items: &[Item]) -> Vec<(String, usize, usize)> {
    let is_keyframe = |item: &Item| matches!(item.kind, ItemKind::Keyframe(_));
    let mut from = 0;
    let same = items.chunk_by(|one, other| is_keyframe(one) && is_keyframe(other));
    let column = |items: &[Item]| {
        let title = if is_keyframe(&items[0]) { "keyframes".to_owned() } else { items[0].kind.title() };
        from += items.len();
        (title, from - items.len(), from)
    };
    same.map(column).collect()
}
