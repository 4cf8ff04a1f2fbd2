//! What the report says of the class as a whole.

use std::collections::BTreeSet;

use crate::grade::{course, text_of};
use crate::report::{between, hand_in, report};

#[test]
fn the_report_begins_with_the_class() {
    let (sandbox, made) = course();
    hand_in(&sandbox, "ada", &made, "correct");
    hand_in(&sandbox, "bob", &made, "nan-when-equal");
    let mut own = made.clone();
    own[1][5].0[0] += 0.5;
    hand_in(&sandbox, "cy", &own, "correct");
    own[1][5].0[0] += 0.000_05;
    hand_in(&sandbox, "dan", &own, "correct");
    sandbox.write("all/eve.json", "{\"format\": ");
    let html = report(&sandbox, &["--no-images"]);

    let table = sandbox.read("out/grades.csv");
    let points: Vec<f64> = table.lines().skip(1).map(|line| line.split(',').nth(4).unwrap().parse().unwrap()).collect();
    let mut sorted = points.clone();
    sorted.sort_by(f64::total_cmp);
    let rounded = |value: f64| format!("{value:.2}").trim_end_matches('0').trim_end_matches('.').to_owned();
    let (mean, median) = (rounded(points.iter().sum::<f64>() / 5.0), rounded(sorted[2]));
    let head = between(&html, "<p class=\"sum\">", "</p>")[0];
    assert!(head.starts_with(&format!("5 submissions, 4 read; {mean} points on average out of ")), "{head}");
    assert!(head.ends_with(&format!(", median {median}.")), "{head}");
    assert!(html.contains("The keyframes cannot be read of <a href=\"#s4\">eve.json</a>."), "{html}");

    // The bars count every submission once.
    let bars = between(between(&html, "<svg class=\"histogram\"", "</svg>")[0], "points: ", "</title>");
    assert_eq!(bars.iter().map(|count| count.parse::<usize>().unwrap()).sum::<usize>(), 5);

    // All keyframes are one column, and each row has all columns.
    let overview = between(&html, "<table class=\"overview\">", "</table>")[0];
    let headings = between(overview, "<th>", "</th>");
    assert_eq!(headings[..3], ["submission", "points", "look at"]);
    assert_eq!(headings.iter().filter(|heading| heading.starts_with("keyframe")).count(), 2, "{headings:?}");
    for row in between(overview, "<tr><td>", "</tr>") {
        assert_eq!(1 + row.matches("<td").count(), headings.len(), "{row}");
    }
    let looks = between(overview, "<td class=\"look\">", "</td>");
    assert_eq!(looks, ["unreadable"]);

    let mistakes = between(&html, "<table class=\"shared\">", "</table>")[0];
    assert!(mistakes.contains("#nan-when-equal") && mistakes.contains("<a href=\"#s1\">bob</a>"), "{mistakes}");
    // Right keyframes are alike; those two are not the reference's.
    let alike = between(&html, "<li class=\"note\">", "</li>");
    assert_eq!(alike, ["<a href=\"#s2\">cy</a>, <a href=\"#s3\">dan</a>"]);
}

#[test]
fn the_page_runs_its_own_script_and_no_other() {
    let (sandbox, made) = course();
    hand_in(&sandbox, "<script>alert(1)<", &made, "correct");
    let html = report(&sandbox, &["--no-images"]);
    let [script] = between(&html, "<script>", "</script>")[..] else { panic!("one script: {html}") };
    let policy = between(&html, "http-equiv=\"Content-Security-Policy\" content=\"", "\"")[0];
    let hash = inbetween::markup::policy_hash(script);
    assert_eq!(policy, format!("default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src {hash}"));
}

#[test]
fn each_distinct_picture_is_in_the_page_once() {
    let (sandbox, made) = course();
    for name in ["ada", "bob"] {
        hand_in(&sandbox, name, &made, "nan-when-equal");
    }
    let html = report(&sandbox, &["--images", "5", "--image-size", "40x30"]);
    let pictures = between(&html, "url(data:image/png;base64,", ")");
    let distinct: BTreeSet<&str> = pictures.iter().copied().collect();
    assert_eq!(pictures.len(), distinct.len());
    let shown = |id: &str| between(between(&html, &format!("id=\"{id}\""), "</section>")[0], "<figure class=\"", "\"");
    assert_eq!(shown("s0"), shown("s1"));
    // Two films, and one moment of the playback that lost points by samples.
    assert!((4..=5).contains(&shown("s0").len()), "{:?}", shown("s0"));
    for class in between(&html, "<figure class=\"", "\"") {
        assert_eq!(html.matches(&format!(".{class}{{--w:")).count(), 1, "{class}");
    }
    assert!(html.contains("{--w:40px;--r:40/30}"), "{html}");

    let html = report(&sandbox, &["--images", "1", "--image-size", "40x30"]);
    for id in ["s0", "s1"] {
        let section = between(&html, &format!("id=\"{id}\""), "</section>")[0];
        assert_eq!(section.matches("<figure").count(), 1);
    }
}

#[test]
fn without_submissions_that_can_be_read_the_page_is_whole() {
    let (sandbox, made) = course();
    sandbox.write("all/broken.json", &text_of(&made, "linear")[..40]);
    let html = report(&sandbox, &["--no-images"]);
    assert!(html.contains("1 submission, 0 read; 0 points on average out of "), "{html}");
    assert!(html.ends_with("</body></html>\n"));
}
