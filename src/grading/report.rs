//! `report.html`: one self-contained page.

use std::fmt::Write as _;

use super::gather::PassedOver;
use super::item::{Evidence, Item, ItemKind};
use super::marks::Marks;
use super::pictures::ReportPicture;
use super::rubric::Rubric;
use super::tables::{diagnoses, number};
use crate::markup::escaped;

const STYLE: &str = "\
body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:76rem;padding:0 1rem;color:#1f2430;background:#f7f7f5}
h1{font-size:1.5rem;margin-bottom:.2rem}.sum{color:#5b6472;margin-top:0}
table{border-collapse:collapse;width:100%}
.overview td,.overview th{padding:.35rem .7rem;text-align:left;border-bottom:1px solid #dddfe4}
.overview td.n,.items td.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
section{background:#fff;border:1px solid #dddfe4;border-radius:10px;margin:1.2rem 0;padding:1rem 1.2rem}
h2{font-size:1.1rem;margin:0 0 .6rem;overflow-wrap:anywhere}h2 span{float:right;font-variant-numeric:tabular-nums}
.items td{padding:.2rem .6rem;vertical-align:top;border-bottom:1px solid #eef0f3;overflow-wrap:anywhere}
.items td:first-child{white-space:nowrap;width:10rem}.items td.n{width:4.5rem}.items td.by{width:5rem;white-space:nowrap}
.lost{color:#a3262a}.full{color:#20693c}.note{background:#fff4d6;border-radius:6px;padding:.4rem .7rem}
.pictures{display:flex;flex-wrap:wrap;gap:1rem;margin-top:.9rem}
figure{margin:0;width:200px}figcaption{font-size:.8rem;color:#5b6472}img{display:block;border-radius:6px;background:#e8eaee}
.bar{display:inline-block;width:8rem;height:.6rem;border-radius:.3rem;background:#e3e6ea;vertical-align:middle}
.bar i{display:block;height:100%;border-radius:.3rem;background:#2f7d4f}a{color:inherit}
@media(prefers-color-scheme:dark){body{background:#15181d;color:#e6e8eb}section{background:#1d2127;border-color:#333a44}
.overview td,.overview th,.items td{border-color:#333a44}.lost{color:#ff9a94}.full{color:#83d6a3}.note{background:#463a15}
.sum,figcaption{color:#a0a8b4}.bar{background:#333a44}}
@media print{body{background:#fff}section{break-inside:avoid}}";

/// The report: an overview with a row for each submission, then each with its points, reasons and pictures, which are in the order of
/// `marks`.
#[must_use]
pub fn html(marks: &[Marks], passed_over: &[PassedOver], rubric: &Rubric, pictures: &[Vec<ReportPicture>]) -> String {
    let title = if rubric.title.is_empty() { "Grades" } else { &rubric.title };
    let mut text = format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n<style>{STYLE}</style></head><body>\n\
         <h1>{0}</h1>\n",
        escaped(title)
    );
    if let Some(warning) = rubric.revealed.warning() {
        let _ = writeln!(text, "<p class=\"note\">{}</p>", escaped(&warning));
    }
    let mean = marks.iter().map(Marks::points).sum::<f64>() / (marks.len().max(1)) as f64;
    let out_of = marks.first().map_or(0.0, Marks::out_of);
    let has_students = marks.iter().any(|marks| student(marks).is_some());
    let _ = writeln!(
        text,
        "<p class=\"sum\">{} submissions, {} points on average out of {}.</p>\n<section><table class=\"overview\">\
         <tr><th>submission</th>{}<th>points</th><th></th><th>evidence</th><th>samples show</th></tr>",
        marks.len(),
        number((mean * 100.0).round() / 100.0),
        number(out_of),
        if has_students { "<th>student</th>" } else { "" }
    );
    for (index, marks) in marks.iter().enumerate() {
        let of_student = escaped(&student(marks).unwrap_or_default());
        let of_student = if has_students { format!("<td>{of_student}</td>") } else { String::new() };
        let share = if marks.out_of() > 0.0 { 100.0 * marks.points() / marks.out_of() } else { 0.0 };
        let _ = writeln!(
            text,
            "<tr><td><a href=\"#s{index}\">{}</a></td>{of_student}<td class=\"n\">{} / {}</td>\
             <td><span class=\"bar\"><i style=\"width:{share:.0}%\"></i></span></td><td>{}</td><td>{}</td></tr>",
            escaped(&marks.name),
            number(marks.points()),
            number(marks.out_of()),
            escaped(&marks.evidence()),
            escaped(&diagnoses(marks).join(", "))
        );
    }
    text.push_str("</table>\n");
    if !passed_over.is_empty() {
        let passed = passed_over.iter().map(|passed| format!("{} ({})", passed.name, passed.reason));
        let passed = passed.collect::<Vec<_>>().join(", ");
        let _ = writeln!(text, "<p class=\"sum\">Passed over: {}.</p>", escaped(&passed));
    }
    text.push_str("</section>\n");
    for (index, (marks, pictures)) in marks.iter().zip(pictures).enumerate() {
        push_submission(&mut text, index, marks, pictures);
    }
    text.push_str("</body></html>\n");
    text
}

/// A row of a submission's table.
struct Row {
    title: String,
    points: f64,
    out_of: f64,
    has_lost: bool,
    /// A word on what the verdict rests on; empty for items about keyframes alone.
    evidence: &'static str,
    reason: String,
}

/// A row for each item; consecutive keyframes with the same verdict and reason share one.
fn rows(items: &[Item]) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    // The first keyframe of the run that the last row is.
    let mut first = None;
    for item in items {
        let index = if let ItemKind::Keyframe(index) = item.kind { Some(index) } else { None };
        if let (Some(first), Some(index), Some(row)) = (first, index, rows.last_mut())
            && row.reason == item.reason
            && row.has_lost == item.has_lost()
        {
            row.title = format!("keyframes {first} to {index}");
            row.points += item.points;
            row.out_of += item.out_of;
            continue;
        }
        first = index;
        let Item { kind, points, out_of, reason, evidence } = item.clone();
        let evidence = evidence.map_or("", Evidence::id);
        rows.push(Row { title: kind.title(), points, out_of, has_lost: item.has_lost(), evidence, reason });
    }
    rows
}

/// What the course system says of the student, where it says more than the submission's name.
fn student(marks: &Marks) -> Option<String> {
    let id = marks.id.as_ref().map(|id| format!("id {id}"));
    let late = marks.is_late.then(|| "late".to_owned());
    if id.is_none() && late.is_none() {
        return None;
    }
    let parts: Vec<String> = [marks.student.clone(), id, late].into_iter().flatten().collect();
    Some(parts.join(", "))
}

fn push_submission(text: &mut String, index: usize, marks: &Marks, pictures: &[ReportPicture]) {
    let _ = writeln!(
        text,
        "<section id=\"s{index}\"><h2>{} <span>{} / {}</span></h2>",
        escaped(&marks.name),
        number(marks.points()),
        number(marks.out_of())
    );
    if let Some(student) = student(marks) {
        let _ = writeln!(text, "<p class=\"sum\">{}</p>", escaped(&student));
    }
    // Skip notes that repeat an item's reason.
    for note in marks.notes.iter().filter(|note| marks.items.iter().all(|item| item.reason != **note)) {
        let _ = writeln!(text, "<p class=\"note\">{}</p>", escaped(note));
    }
    text.push_str("<table class=\"items\">\n");
    for row in rows(&marks.items) {
        let class = if row.has_lost { "lost" } else { "full" };
        let _ = writeln!(
            text,
            "<tr><td>{}</td><td class=\"n {class}\">{} / {}</td><td class=\"by\">{}</td><td>{}</td></tr>",
            escaped(&row.title),
            number(row.points),
            number(row.out_of),
            row.evidence,
            escaped(&row.reason)
        );
    }
    text.push_str("</table>\n");
    if !pictures.is_empty() {
        text.push_str("<div class=\"pictures\">\n");
        for picture in pictures {
            if picture.starts_row {
                text.push_str("</div><div class=\"pictures\">\n");
            }
            let _ = writeln!(
                text,
                "<figure><img src=\"data:image/png;base64,{}\" width=\"{}\" height=\"{}\" alt=\"{1}x{2}\"><figcaption>{}</figcaption></figure>",
                picture.base64,
                picture.width,
                picture.height,
                escaped(&picture.caption)
            );
        }
        text.push_str("</div>\n");
    }
    text.push_str("</section>\n");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interpolation::Interpolation;

    #[test]
    fn keyframes_of_which_there_is_the_same_to_say_are_one_row() {
        let item =
            |kind, points, reason: &str| Item { kind, points, out_of: 2.0, reason: reason.to_owned(), evidence: None };
        let items = [
            item(ItemKind::KeyframeCount, 2.0, "right"),
            item(ItemKind::Keyframe(0), 2.0, "right"),
            item(ItemKind::Keyframe(1), 2.0, "right"),
            item(ItemKind::Keyframe(2), 0.0, "off"),
            item(ItemKind::Keyframe(3), 2.0, "right"),
            item(ItemKind::Playback(Interpolation::CatmullRom), 2.0, "right"),
        ];
        let rows = rows(&items);
        let titles: Vec<&str> = rows.iter().map(|row| row.title.as_str()).collect();
        assert_eq!(titles, ["keyframe count", "keyframes 0 to 1", "keyframe 2", "keyframe 3", "Catmull-Rom playback"]);
        assert_eq!((rows[1].points, rows[1].out_of), (4.0, 4.0));
    }

    #[test]
    fn what_is_markup_is_text() {
        assert_eq!(
            escaped("<img src=x onerror='a'>\"&\u{202e}\n"),
            "&lt;img src=x onerror=&#39;a&#39;&gt;&quot;&amp;  "
        );
    }
}
