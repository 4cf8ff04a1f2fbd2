//! Which rows are the scene's nodes: lights anywhere, robots without heads, guesses that fail together.

use inbetween::text_layouts::{JointList, Options};

use super::samples::{Row, keyframes, lines, scene, texts};
use super::{read, read_with, refusal};

const LIGHT: [&str; 7] = ["2", "3", "14", "1", "0", "0", "0"];
/// The rows of the heads.
const HEADS: [usize; 2] = [11, 21];

fn without_heads(count: usize) -> Vec<Vec<Row>> {
    let keep =
        |rows: Vec<Row>| rows.into_iter().enumerate().filter(|(row, _)| !HEADS.contains(row)).map(|(_, row)| row);
    keyframes(count).into_iter().map(|rows| keep(rows).collect()).collect()
}

/// The keyframes with a light at each of these rows, counted in the result.
fn with_lights(keyframes: Vec<Vec<Row>>, at: &[usize]) -> Vec<Vec<Row>> {
    let add = |mut rows: Vec<Row>| {
        for &row in at {
            rows.insert(row, LIGHT.map(str::to_owned));
        }
        rows
    };
    keyframes.into_iter().map(add).collect()
}

#[test]
fn lights_may_stand_anywhere_before_after_and_between_robots() {
    let expected = read(&texts(&keyframes(4), false)[0].text).0;
    for (at, named) in [
        (&[2, 3][..], "rows 2 and 3 are not used"),
        (&[12, 13], "rows 12 and 13 are not used"),
        (&[2, 13], "rows 2 and 13 are not used"),
        (&[12, 23], "rows 12 and 23 are not used"),
        (&[0, 1], "rows 0 and 1 are not used"),
        (&[2, 3, 24], "rows 2, 3 and 24 are not used"),
        (&[2, 3, 14, 15], "rows 2, 3, 14 and 15 are not used"),
    ] {
        for sample in texts(&with_lights(keyframes(4), at), false) {
            let (found, report) = read(&sample.text);
            assert_eq!(found, expected, "{at:?}, {}: {report}", sample.what);
            assert!(report.to_string().contains(named), "{at:?}, {}: {report}", sample.what);
            assert!(!report.has_warnings(), "{at:?}, {}: {report}", sample.what);
        }
    }
}

#[test]
fn where_no_offset_shows_the_lights_the_note_names_no_rows() {
    let mut rows = with_lights(keyframes(4), &[2, 3]);
    for row in &mut rows[0] {
        row[..3].clone_from_slice(&["0", "0", "0"].map(str::to_owned));
    }
    let (_, report) = read(&texts(&rows, false)[0].text);
    let report = report.to_string();
    assert!(
        report.contains("warning: nodes: 2 more than the scene has, and the offsets of keyframe 0 do not show which"),
        "{report}"
    );
    assert!(!report.contains("22 and 23"), "{report}");
}

#[test]
fn robots_without_heads_are_read() {
    let all = read(&texts(&keyframes(5), false)[0].text).0;
    let scene = scene();
    for sample in texts(&without_heads(5), false).into_iter().chain(texts(&without_heads(5), true)) {
        let (found, report) = read(&sample.text);
        assert_eq!(found.len(), 5, "{}: {report}", sample.what);
        assert!(
            report
                .to_string()
                .contains("note: nodes: there are no rows of robot1/head and robot2/head, which keep the rest pose"),
            "{}: {report}",
            sample.what
        );
        for (found, all) in found.iter().zip(&all) {
            for (row, (found, all)) in found.pose.iter().zip(all.pose.iter()).enumerate() {
                let rest = scene.rest_pose().to_vec()[row];
                assert_eq!(found, if HEADS.contains(&row) { rest } else { all }, "{}, row {row}", sample.what);
            }
        }
    }
    // With two lights they have as many rows as the scene.
    let (found, report) = read(&texts(&with_lights(without_heads(5), &[2, 3]), false)[0].text);
    assert!(report.to_string().contains("rows 2 and 3 are not used"), "{report}");
    assert_eq!(found, read(&texts(&without_heads(5), false)[0].text).0);
}

#[test]
fn twenty_rows_that_are_no_robots_are_refused() {
    let mut rows = without_heads(5);
    for keyframe in &mut rows {
        keyframe.reverse();
    }
    let samples = texts(&rows, false);
    let header = samples.iter().find(|sample| sample.what == "a row a line").unwrap();
    assert_eq!(
        refusal(&header.text),
        "line 2 column 1: a keyframe has 20 nodes, expected 22, 24, 25 or 26".replacen("2 ", "1 ", 1)
    );
    // 100 rows would be 4 keyframes of 25 nodes.
    let alone = samples.iter().find(|sample| sample.what == "no header").unwrap();
    assert_eq!(
        refusal(&alone.text),
        "line 1 column 1: there is no header, and the rows make whole keyframes only with 25 nodes, which the offsets of the joints \
         contradict. Expected 22, 24, 25 or 26 nodes in each keyframe, or a first line \"N M\""
    );
}

#[test]
fn a_guess_without_header_follows_the_offsets() {
    // 110 rows: 5 keyframes of 22 nodes; 220 rows: 11 of 20, or 10 of 22.
    let (found, report) = read(lines(without_heads(11).iter().flatten().map(|row| row.join(" "))));
    assert_eq!(found.len(), 11, "{report}");
    // 264 rows: 12 keyframes of 22 nodes, or 11 of 24.
    let rows = with_lights(keyframes(11), &[2, 3]);
    let (found, report) = read(lines(rows.iter().flatten().map(|row| row.join(" "))));
    assert_eq!(found.len(), 11, "{report}");
    let (found, _) = read(lines(keyframes(12).iter().flatten().map(|row| row.join(" "))));
    assert_eq!(found.len(), 12);
}

#[test]
fn a_text_that_is_cut_off_is_not_one_of_more_nodes() {
    // 100 of 110 rows: as many as 4 keyframes of 25 nodes.
    let rows = lines(keyframes(5).iter().flatten().take(100).map(|row| row.join(" ")));
    let sentence = refusal(&rows);
    assert!(
        sentence.contains("4 whole keyframes and 84 numbers")
            && sentence.ends_with("--salvage takes the whole keyframes"),
        "{sentence}"
    );
    let (found, _) = read_with(&rows, &Options { salvage: true, ..Options::default() });
    assert_eq!(found, read(&texts(&keyframes(4), false)[0].text).0);
}

#[test]
fn a_list_of_joints_names_the_rows_that_it_leaves_out() {
    let scene = scene();
    let mut paths: Vec<&str> = scene.rbt_paths().collect();
    paths.insert(2, "-");
    paths.insert(3, "-");
    let joints = JointList::from_text(paths.join("\n").as_bytes(), &scene).unwrap();
    let options = Options { joints: Some(joints), ..Options::default() };
    let (found, report) = read_with(&texts(&with_lights(keyframes(4), &[2, 3]), false)[0].text, &options);
    assert_eq!(found, read(&texts(&keyframes(4), false)[0].text).0);
    let report = report.to_string();
    assert!(report.contains("note: nodes: rows 2 and 3 are not used, as the list says"), "{report}");
    assert!(!report.contains("22"), "{}", report.replacen("24 nodes", "", 1));
}

#[test]
fn salvaging_is_advised_where_it_works() {
    let good = &texts(&keyframes(4), false)[0].text;
    let cut: String = good.lines().take(80).map(|line| line.to_owned() + "\n").collect();
    assert!(refusal(&cut).ends_with("; --salvage takes the whole keyframes"));
    for text in [
        good.lines().take(10).map(|line| line.to_owned() + "\n").collect(),
        cut.replacen("-0.657306 4.09635 13.213 1", "-0.657306 4.09635 13.213 2", 1),
        good.replacen("4 22", "4 23", 1),
    ] {
        assert!(!refusal(&text).contains("--salvage"), "{}", refusal(&text));
    }
}
