//! What a text leaves open: the order of fields, the number of nodes, which row is which joint.

use inbetween::text_layouts::{FieldOrder, JointList, Options};

use super::samples::{Row, keyframes, lines, scene, texts};
use super::{numbers, read, read_with, refusal, refusal_with};

fn header_text(keyframes: &[Vec<Row>]) -> String {
    texts(keyframes, false).remove(0).text
}

/// The rows of each keyframe in another order: row k is what was in place `order[k]`.
fn reordered(keyframes: &[Vec<Row>], order: &[usize]) -> Vec<Vec<Row>> {
    keyframes.iter().map(|rows| order.iter().map(|&place| rows[place].clone()).collect()).collect()
}

/// The same order of joints in both robots.
fn both(joints: [usize; 9]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..22).collect();
    for (row, joint) in joints.into_iter().enumerate() {
        order[3 + row] = 3 + joint;
        order[13 + row] = 13 + joint;
    }
    order
}

/// Every coordinate could be either: tx ty tz of length 0 beside qw = 1, and all rotations the identity.
fn tie() -> Vec<Vec<Row>> {
    let row = ["1", "0", "0", "0", "1", "0", "0"].map(str::to_owned);
    vec![vec![row; 22]; 2]
}

#[test]
fn a_tie_goes_to_translation_first_with_a_warning() {
    let text = header_text(&tie());
    let (found, report) = read(&text);
    assert!(report.to_string().contains("warning: order: either four numbers are unit in all 44 rows"), "{report}");
    assert_eq!(numbers(&found[0], "sky"), [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    let options = Options { order: Some(FieldOrder::QuaternionFirst), ..Options::default() };
    let (found, report) = read_with(&text, &options);
    assert_eq!(numbers(&found[0], "sky"), [1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    assert!(!report.to_string().contains("either four"), "{report}");
}

#[test]
fn in_csv_the_header_breaks_a_tie() {
    let csv = |swap| texts(&tie(), swap).into_iter().find(|sample| sample.layout == "csv").unwrap().text;
    let (found, _) = read(csv(false));
    assert_eq!(numbers(&found[0], "sky"), [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    assert_eq!(read(csv(true)).0, found);
}

#[test]
fn three_decimals_are_unit_enough() {
    let mut rows = keyframes(4);
    rows[1][2][3..].clone_from_slice(&["0.574", "0.574", "0.574", "0.1"].map(str::to_owned));
    let (found, _) = read(header_text(&rows));
    let rotation = found[1].pose.to_vec()[2].rotation;
    assert!((rotation.length() - 1.0).abs() < 1e-6);
    rows[1][2][3] = "0.59".to_owned();
    let sentence = refusal(header_text(&rows));
    assert!(
        sentence.starts_with("line 26 column 1: keyframe 1, row 2: the last four numbers have length 1.00"),
        "{sentence}"
    );
    let options = Options { order: Some(FieldOrder::TranslationFirst), ..Options::default() };
    read_with(header_text(&rows), &options);
    let options = Options { order: Some(FieldOrder::QuaternionFirst), ..Options::default() };
    assert!(
        refusal_with(header_text(&rows), &options).starts_with("line 2 column 1: keyframe 0, row 0: the first four")
    );
}

#[test]
fn later_assignments_have_more_nodes() {
    for (more, note) in [
        (2, "the first 22 are used, not 22 and 23 (two lights)"),
        (3, "not 22 and 23 (two lights) and 24 (a mesh or a bunny)"),
        (4, "not 22 and 23 (two lights), 24 and 25 (a mesh and a bunny)"),
    ] {
        let own = keyframes(5);
        let mut rows = own.clone();
        for keyframe in &mut rows {
            for place in 0..more {
                keyframe.push(["4", "3", if place == 0 { "3" } else { "-3" }, "1", "0", "0", "0"].map(str::to_owned));
            }
        }
        let (expected, _) = read(header_text(&own));
        for sample in texts(&rows, false).into_iter().chain(texts(&rows, true)) {
            let (found, report) = read(&sample.text);
            assert_eq!(found, expected, "{}", sample.what);
            assert!(report.to_string().contains(note), "{}: {report}", sample.what);
        }
    }
    for nodes in [21, 23, 27] {
        let rows: Vec<Vec<Row>> =
            keyframes(4).iter().map(|rows| rows.iter().cycle().take(nodes).cloned().collect()).collect();
        let sentence = refusal(header_text(&rows));
        assert_eq!(sentence, format!("line 1 column 1: a keyframe has {nodes} nodes, expected 22, 24, 25 or 26"));
    }
}

#[test]
fn joints_in_another_order_are_matched_by_their_offsets() {
    let (expected, _) = read(header_text(&keyframes(4)));
    for joints in [
        [8, 0, 1, 2, 3, 4, 5, 6, 7],
        [6, 7, 4, 5, 2, 3, 0, 1, 8],
        [2, 3, 0, 1, 8, 6, 7, 4, 5],
        // All that hangs on the robot itself first.
        [0, 2, 4, 6, 8, 1, 3, 5, 7],
        [8, 6, 4, 0, 2, 7, 5, 3, 1],
    ] {
        let text = header_text(&reordered(&keyframes(4), &both(joints)));
        let (found, report) = read(&text);
        if joints[4] == 8 && joints[0] == 0 || joints == [8, 6, 4, 0, 2, 7, 5, 3, 1] {
            assert!(report.to_string().contains("likely: joints"), "{report}");
        } else {
            assert!(report.to_string().contains("sure: joints of robot1, robot2: matched"), "{report}");
        }
        assert_eq!(found, expected, "{report}");
    }
}

#[test]
fn where_nothing_matches_the_order_is_the_scenes() {
    let mut rows = keyframes(4);
    for row in &mut rows[0][3..12] {
        row[..3].clone_from_slice(&["0", "0", "0"].map(str::to_owned));
    }
    let (found, report) = read(header_text(&rows));
    assert!(
        report.to_string().contains(
            "warning: joints of robot1: the offsets of keyframe 0 match no order: taken in the scene's order"
        )
    );
    assert_eq!(numbers(&found[1], "robot1/head")[..3], [0.0, 0.75, 0.0]);
    // The other robot was built by the same code.
    let order = both([8, 0, 1, 2, 3, 4, 5, 6, 7]);
    let mut rows = reordered(&keyframes(4), &order);
    rows[0][13][0] = "-0.9".to_owned();
    let (found, report) = read(header_text(&rows));
    assert!(
        report
            .to_string()
            .contains("warning: joints of robot2: the offsets of keyframe 0 match no order: taken as those of robot1")
    );
    assert_eq!(numbers(&found[0], "robot2/head")[0], -0.9);
}

#[test]
fn a_list_of_joints_decides() {
    let scene = scene();
    let order: Vec<usize> = (0..22).rev().collect();
    let paths: Vec<&str> = scene.rbt_paths().collect();
    let list =
        "# from the last to the first\r\n".to_owned() + &lines(order.iter().map(|&place| paths[place].to_owned()));
    let joints = JointList::from_text(list.as_bytes(), &scene).unwrap();
    let options = Options { joints: Some(joints), ..Options::default() };
    let text = header_text(&reordered(&keyframes(4), &order));
    let (expected, _) = read(header_text(&keyframes(4)));
    assert_eq!(read_with(&text, &options).0, expected);
    for (list, sentence) in [
        (
            list.clone() + "robot1/tail\n",
            "line 24 column 1: found \"robot1/tail\", expected a path that `inbetween nodes` prints, or -",
        ),
        (list.clone() + "sky\n", "line 24 column 1: found \"sky\" for the second time, expected each path once"),
        (list.replace("ground\n", "-\n"), "line 24 column 1: found the end of the list, expected \"ground\" in it"),
    ] {
        assert_eq!(JointList::from_text(list.as_bytes(), &scene).unwrap_err().to_string(), sentence);
    }
    // A row that is not used, which makes 23 of them.
    let list = "-\n".to_owned() + &list;
    let options =
        Options { joints: Some(JointList::from_text(list.as_bytes(), &scene).unwrap()), ..Options::default() };
    let with_more: Vec<Vec<Row>> = reordered(&keyframes(4), &order)
        .into_iter()
        .map(|rows| [vec![["0", "0", "0", "1", "0", "0", "0"].map(str::to_owned)], rows].concat())
        .collect();
    assert_eq!(read_with(header_text(&with_more), &options).0, expected);
}
