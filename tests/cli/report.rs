//! The report as a page: what it tells once, what it links to, and what is yellow.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::grade::{course, text_of};
use crate::sandbox::Sandbox;
use crate::student::{Placed, Student};

/// A hand-in of right keyframes, with samples of linear playback.
pub fn hand_in(sandbox: &Sandbox, name: &str, made: &[Vec<Placed>], mistake: &str) {
    let student = Student { mistake, plays_splines: false, keyframes: made };
    std::fs::create_dir(sandbox.path(&format!("all/{name}"))).unwrap();
    sandbox.write(&format!("all/{name}/keys.json"), text_of(made, "linear"));
    sandbox.write(&format!("all/{name}/linear.csv"), student.samples(6.0, 2000.0, false, 6));
}

pub fn report(sandbox: &Sandbox, arguments: &[&str]) -> String {
    let all = [&["grade", "rubric.json", "all", "-o", "out"], arguments].concat();
    sandbox.run(&all).succeeds();
    sandbox.read("out/report.html")
}

/// What stands between two marks, each time.
pub fn between<'a>(text: &'a str, from: &str, to: &str) -> Vec<&'a str> {
    text.split(from).skip(1).map(|rest| rest.split(to).next().unwrap()).collect()
}

#[test]
fn a_known_mistake_has_one_section_to_which_its_students_link() {
    let (sandbox, made) = course();
    hand_in(&sandbox, "ada", &made, "nan-when-equal");
    hand_in(&sandbox, "bob", &made, "nan-when-equal + one-keyframe-early");
    hand_in(&sandbox, "cy", &made, "correct");
    let html = report(&sandbox, &["--no-images"]);
    assert!(!html.contains("<figure"), "no film without pictures");

    let ids = between(&html, " id=\"", "\"");
    let unique: BTreeSet<&str> = ids.iter().copied().collect();
    assert_eq!(ids, ["top", "s0", "s1", "s2", "nan-when-equal", "one-keyframe-early"]);
    for link in between(&html, "href=\"#", "\"") {
        assert!(unique.contains(link), "{link}");
    }
    let links = |id: &str| {
        let section = between(&html, &format!("id=\"{id}\""), "</section>")[0];
        between(section, "href=\"#", "\"")
    };
    assert_eq!(links("s0"), ["nan-when-equal", "top", "s1"]);
    assert_eq!(links("s1"), ["nan-when-equal", "one-keyframe-early", "s0", "top", "s2"]);
    assert_eq!(links("s2"), ["s1", "top"]);
    assert_eq!(links("nan-when-equal"), ["s0", "s1", "top"]);
    assert_eq!(links("one-keyframe-early"), ["s1", "top"]);

    let section = between(&html, "id=\"nan-when-equal\"", "</section>")[0];
    let page = inbetween::diagnosis::markdown();
    let page = between(&page, "## nan-when-equal\n\n", "\n## ")[0];
    for fact in between(page, "* ", "\n") {
        let (title, fact) = fact.split_once(": ").unwrap();
        let fact = match fact.strip_prefix('`') {
            Some(code) => format!("<code>{}</code>", code.trim_end_matches('`')),
            None => fact.to_owned(),
        };
        assert!(section.contains(&format!("<dt>{title}</dt><dd>{fact}</dd>")), "{title}: {fact}: {section}");
    }
}

#[test]
fn a_known_mistake_has_a_film_of_the_reference_or_of_the_first_who_shows_it() {
    let (sandbox, made) = course();
    hand_in(&sandbox, "ada", &made, "nan-when-equal");
    let film = |html: &str| {
        let section = between(html, "id=\"nan-when-equal\"", "</section>")[0].to_owned();
        let alts = between(&section, " aria-label=\"", "\"");
        assert_eq!(alts.len(), 1, "{alts:?}");
        alts[0].to_owned()
    };
    let html = report(&sandbox, &[]);
    let alt = film(&html);
    assert!(alt.starts_with("Film of 16 pictures. Linear playback of the reference, key time "), "{alt}");
    assert!(alt.ends_with(": right on the left, nan-when-equal on the right"), "{alt}");
    for alt in between(&html, " aria-label=\"", "\"") {
        assert!(alt.len() > 20, "{alt}");
    }

    // A reference in which everything turns all the time does not show it.
    let mut turning = made.clone();
    let still = [1, 2];
    for (index, pose) in turning.iter_mut().enumerate() {
        for node in still {
            pose[node].1 = made[index][5].1;
        }
    }
    sandbox.write("reference.json", text_of(&turning, "linear"));
    let alt = film(&report(&sandbox, &[]));
    assert!(
        alt.starts_with("Film of 16 pictures. Linear playback of the first submission that shows it, key time "),
        "{alt}"
    );
}

#[test]
fn what_cannot_be_read_is_said_once() {
    let (sandbox, _) = course();
    sandbox.write("all/broken.json", "{\"format\": ");
    let html = report(&sandbox, &["--no-images"]);
    let sentence = "The keyframes cannot be read.";
    assert_eq!(html.matches(sentence).count(), 1);
    let row = "<td>keyframe count, keyframes 0 to 7, linear playback, Catmull-Rom playback, range and end, script</td>";
    assert!(html.contains(row), "{html}");
    assert_eq!(sandbox.read("out/grades.csv").matches(sentence).count(), 1);
}

#[test]
fn only_what_a_person_should_look_at_is_yellow() {
    let (sandbox, _) = course();
    // Robots whose joints have their right offsets.
    let json = include_str!("../../assets/grading/reference.json");
    let reference: Value = serde_json::from_str(json).unwrap();
    let poses = reference["keyframes"].as_array().unwrap();
    let row = |rbt: &Value| {
        let [t, r] = ["translation", "rotation"].map(|part| &rbt[part]);
        format!("{} {} {} {} {} {} {}\n", t[0], t[1], t[2], r[3], r[0], r[1], r[2])
    };
    let rows: Vec<String> = poses.iter().flat_map(|keyframe| keyframe["pose"].as_array().unwrap()).map(row).collect();
    std::fs::create_dir(sandbox.path("all/ada")).unwrap();
    sandbox.write("all/ada/animation.txt", format!("{} 22\n{}", poses.len(), rows.concat()));
    sandbox.write("all/ada/main.cpp", "int main() {}\n");
    std::fs::create_dir(sandbox.path("all/bob")).unwrap();
    sandbox.write("all/bob/animation.txt", rows.concat());
    sandbox.write("all/bob/old.json", json);
    sandbox.write("all/bob/linear.csv", "time,node\n0,1\n");
    let html = report(&sandbox, &["--no-images"]);
    let notes = |id: &str, class: &str| {
        let section = between(&html, &format!("id=\"{id}\""), "</section>")[0];
        between(section, &format!("<p class=\"{class}\">"), "</p>")
    };
    assert_eq!(notes("s0", "note"), [""; 0]);
    let quiet = notes("s0", "quiet");
    assert!(
        quiet[0].starts_with(&format!("animation.txt: {} keyframes of 22 nodes", poses.len()))
            && quiet[0].contains("sure: "),
        "{quiet:?}"
    );
    assert_eq!(quiet[1..], ["Skipped: 1 source (main.cpp)."]);
    let yellow = notes("s1", "note");
    assert!(yellow[0].contains("likely: no header"), "{yellow:?}");
    assert_eq!(
        yellow[1..],
        [
            &format!("The keyframes are those of animation.txt; also found: old.json ({} keyframes).", poses.len()),
            "Neither keyframes, samples, trace nor script: linear.csv."
        ]
    );
    assert_eq!(notes("s1", "quiet"), [""; 0]);
}
