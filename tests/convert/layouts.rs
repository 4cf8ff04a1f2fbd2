//! Every layout, read and written.

use inbetween::keyframe::Keyframe;
use inbetween::text_layouts::{KeyframeText, Layout};

use super::samples::{Row, keyframes, matrices, texts};
use super::{numbers, read};

/// Compares with the rows, to what six digits give.
#[track_caller]
fn assert_rows(found: &[Keyframe], expected: &[Vec<Row>], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (keyframe, rows) in found.iter().zip(expected) {
        for (rbt, row) in keyframe.pose.iter().zip(rows) {
            let [tx, ty, tz, w, x, y, z] = row.clone().map(|number| number.parse::<f32>().unwrap());
            assert_eq!(rbt.translation.to_array(), [tx, ty, tz], "{what}");
            for (found, expected) in rbt.rotation.to_array().into_iter().zip([x, y, z, w]) {
                assert!((found - expected).abs() < 2e-6, "{what}: {rbt:?}, {row:?}");
            }
        }
    }
}

#[test]
fn every_layout_is_read_in_both_orders() {
    let rows = keyframes(4);
    for swap in [false, true] {
        for sample in texts(&rows, swap) {
            let (found, report) = read(&sample.text);
            assert_rows(&found, &rows, sample.what);
            assert_eq!(
                report.summary.to_string(),
                format!("4 keyframes of 22 nodes, layout {}", sample.layout),
                "{}",
                sample.what
            );
            assert!(!report.has_warnings(), "{}: {report}", sample.what);
            let order = if swap { "order: quaternion first" } else { "order: translation first" };
            assert!(report.to_string().contains(order), "{report}");
        }
    }
}

#[test]
fn one_keyframe_is_enough() {
    let rows = keyframes(1);
    for sample in texts(&rows, false) {
        assert_rows(&read(&sample.text).0, &rows, sample.what);
    }
}

#[test]
fn line_ends_marks_and_trailing_separators_do_not_matter() {
    let rows = keyframes(4);
    for sample in texts(&rows, false) {
        let text = &sample.text;
        let trailing = text.trim_end().replace('\n', " , \n") + ",";
        let changed = [
            ("CRLF", text.replace('\n', "\r\n")),
            ("a byte order mark", format!("\u{feff}{text}")),
            ("no line end at the end", text.trim_end().to_owned()),
            ("blank lines", format!("\n \n{}\n\n", text.replace('\n', "\n\t\n"))),
            ("blanks", text.replace('\n', " \t\n")),
            ("commas at the ends of lines", trailing),
        ];
        for (change, text) in changed {
            if change.starts_with("commas") && !matches!(sample.layout, "csv" | "pairs") {
                continue;
            }
            assert_rows(&read(&text).0, &rows, &format!("{}, {change}", sample.what));
        }
    }
}

#[test]
fn matrices_are_read() {
    let rows = keyframes(4);
    for text in [matrices(&rows), matrices(&rows).replace('\n', "\r\n"), matrices(&rows).replace(",\n", "\n")] {
        let (found, report) = read(&text);
        assert_eq!(report.summary.to_string(), "4 keyframes of 22 nodes, layout matrices");
        for (keyframe, expected) in found.iter().zip(&rows) {
            for (rbt, row) in keyframe.pose.iter().zip(expected) {
                let [tx, ty, tz, w, x, y, z] = row.clone().map(|number| number.parse::<f32>().unwrap());
                assert!(rbt.translation.distance([tx, ty, tz].into()) < 1e-6);
                // A matrix does not tell a quaternion's sign.
                let dot = rbt.rotation.dot(glam::Quat::from_xyzw(x, y, z, w));
                assert!((dot.abs() - 1.0).abs() < 1e-5, "{rbt:?}, {row:?}");
            }
        }
    }
}

#[test]
fn the_sign_of_a_quaternion_and_small_exponents_are_kept() {
    let (found, _) = read(&texts(&keyframes(4), false)[0].text);
    assert_eq!(numbers(&found[2], "robot1/head")[3..], [-0.6, 0.0, 0.8, 0.0]);
    assert!(numbers(&found[2], "robot1/head")[6].is_sign_negative());
    assert_eq!(numbers(&found[0], "robot2/left_shoulder/left_elbow")[3], -1.0);
    assert_eq!(numbers(&found[1], "robot1")[2], -8.708_31e-16);
}

#[test]
fn an_empty_list_is_read() {
    for text in ["0 22\n", "0\n22", "0 0", "\u{feff}0 24\r\n", "frame_num,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n"] {
        assert!(read(text).0.is_empty(), "{text:?}");
    }
}

#[test]
fn every_layout_is_written_and_read_back() {
    let (original, _) = read(&texts(&keyframes(4), false)[0].text);
    for layout in Layout::WRITTEN {
        for is_exact in [false, true] {
            let text = KeyframeText { keyframes: &original, nodes: 22, layout, is_exact }.to_string();
            let (found, report) = read(&text);
            assert_eq!(report.summary.to_string(), format!("4 keyframes of 22 nodes, layout {}", layout.name()));
            // The sample was printed with six digits, so they hold all of it.
            assert_eq!(found, original, "{}", layout.name());
            let again = KeyframeText { keyframes: &found, nodes: 22, layout, is_exact }.to_string();
            assert_eq!(again, text);
        }
        let empty = KeyframeText { keyframes: &[], nodes: 22, layout, is_exact: false }.to_string();
        if layout.can_be_empty() {
            assert!(read(&empty).0.is_empty());
        } else {
            assert_eq!(empty, "");
        }
    }
}

#[test]
fn the_layouts_look_as_they_are_described() {
    let (original, _) = read(&texts(&keyframes(2), false)[0].text);
    let first = |layout| {
        let text = KeyframeText { keyframes: &original, nodes: 22, layout, is_exact: false }.to_string();
        text.chars().take(60).collect::<String>()
    };
    for (layout, expected) in [
        (Layout::Header, "2 22\n-0.657306 4.09635 13.213 1 0 0 0\n0 0 0 1 0 0 0\n-2 1 0"),
        (Layout::HeaderTwoLines, "2 22\n-0.657306 4.09635 13.213\n1 0 0 0\n0 0 0\n1 0 0 0\n"),
        (Layout::HeaderKeyframeALine, "2 22\n-0.657306 4.09635 13.213 1 0 0 0 0 0 0 1 0 0 0 -2"),
        (Layout::HeaderQuaternionFirst, "2 22\n1 0 0 0 -0.657306 4.09635 13.213\n1 0 0 0 0 0 0\n"),
        (Layout::Rows, "-0.657306 4.09635 13.213 1 0 0 0\n0 0 0 1 0 0 0\n-2 1 0"),
        (Layout::Frames, "frame [0]\n-0.657306 4.09635 13.213 1 0 0 0\n0 0 0"),
        (Layout::End, "-0.657306 4.09635 13.213 1 0 0 0\n"),
        (Layout::Csv, "frame_num,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n0,0,-0.657306,4.09"),
        (Layout::Pairs, "-0.657306,4.09635,13.213;1,0,0,0 0,0,0;1,0,0,0 -2"),
        (Layout::Endless, "-0.657306,4.09635,13.213,1,0,0,0;0,0,0,1,0,0,0;-2"),
    ] {
        assert!(first(layout).starts_with(expected), "{}: {:?}", layout.name(), first(layout));
    }
}
