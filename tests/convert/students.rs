//! Two files that students' programs wrote.

use inbetween::text_layouts::{KeyframeText, Layout};

use super::{numbers, read};

const ONE_LINE: &str = include_str!("../data/student-files/n-m-header-one-rbt-per-line.txt");
const TWO_LINES: &str = include_str!("../data/student-files/n-m-header-two-lines-per-rbt.txt");

#[test]
fn a_row_a_line() {
    let (found, report) = read(ONE_LINE);
    assert_eq!(report.summary.to_string(), "6 keyframes of 22 nodes, layout header");
    assert!(!report.has_warnings(), "{report}");
    assert_eq!(numbers(&found[1], "sky")[..3], [0.0, 0.25, 7.12]);
    assert_eq!(numbers(&found[2], "robot1")[3..], [0.790_878, 0.036_712_1, 0.609_253, 0.044_439_3]);
    assert_eq!(numbers(&found[2], "robot1/left_hip")[2], 8.951_17e-16);
    let back = KeyframeText { keyframes: &found, nodes: 22, layout: Layout::Header, is_exact: false }.to_string();
    // Newer C++ libraries print two digits of an exponent where older ones print three.
    assert_eq!(back, ONE_LINE.replace("e-0", "e-"));
}

#[test]
fn two_lines_a_row_with_two_lights_and_other_joints() {
    let (found, report) = read(TWO_LINES);
    assert_eq!(report.summary.to_string(), "12 keyframes of 24 nodes, layout header-two-lines");
    assert!(!report.has_warnings(), "{report}");
    for robot in ["robot1", "robot2"] {
        for (joint, x, y) in [
            ("right_shoulder", 0.5, 0.75),
            ("right_shoulder/right_elbow", 0.75, 0.0),
            ("left_shoulder", -0.5, 0.75),
            ("left_shoulder/left_elbow", -0.75, 0.0),
            ("right_hip", 0.5, -0.75),
            ("right_hip/right_knee", 0.0, -0.75),
            ("left_hip", -0.5, -0.75),
            ("left_hip/left_knee", 0.0, -0.75),
            ("head", 0.0, 0.75),
        ] {
            assert_eq!(numbers(&found[0], &format!("{robot}/{joint}"))[..3], [x, y, 0.0], "{robot}/{joint}");
        }
    }
    // Row 7 of the file's sixth keyframe is a head that was moved.
    assert_eq!(numbers(&found[5], "robot1/head")[..3], [0.383_683, 1.484_58, 0.044_319_2]);
    let report = report.to_string();
    assert!(report.contains("not 22 and 23 (two lights)"), "{report}");
    assert!(report.contains("left_elbow, head, right_hip"), "{report}");
    for layout in Layout::WRITTEN {
        for is_exact in [false, true] {
            let text = KeyframeText { keyframes: &found, nodes: 22, layout, is_exact }.to_string();
            assert_eq!(read(&text).0, found, "{}", layout.name());
        }
    }
}
