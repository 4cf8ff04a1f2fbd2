//! Texts that are wrong: the place, what was expected, and what can be salvaged.

use inbetween::text_layouts::Options;

use super::samples::{Row, keyframes, matrices, scene, texts};
use super::{read, read_with, refusal, refusal_with};

fn text(layout: &str) -> String {
    texts(&keyframes(4), false).into_iter().find(|sample| sample.layout == layout).unwrap().text
}

fn salvage() -> Options {
    Options { salvage: true, ..Options::default() }
}

#[test]
fn numbers_that_are_none_have_their_place() {
    for word in ["nan", "-nan", "-nan(ind)", "NaN", "1.#QNAN", "-1.#IND", "1.#INF", "inf", "-inf", "1e39", "-1e999"] {
        let broken = text("header").replacen("13.213", word, 1);
        assert_eq!(refusal(broken), format!("line 2 column 19: {word:?} is not finite, expected a number"));
        let broken = text("csv").replacen("13.213", word, 1);
        assert_eq!(refusal(broken), format!("line 2 column 23: {word:?} is not finite, expected a number"));
        let broken = text("pairs").replacen("13.213", word, 1);
        assert_eq!(refusal(broken), format!("line 1 column 19: {word:?} is not finite, expected a number"));
    }
}

#[test]
fn a_header_that_disagrees_says_both_counts() {
    let good = text("header");
    let cut: String = good.lines().take(80).map(|line| line.to_owned() + "\n").collect();
    let (expected, _) = read(&good);
    assert_eq!(
        refusal(&cut),
        "line 1 column 1: the header says 4 keyframes of 22 nodes, expected 88 rows (616 numbers) after it, found 79 rows \
         (553 numbers); --salvage takes the whole keyframes"
    );
    let (found, report) = read_with(&cut, &salvage());
    assert_eq!(found, expected[..3]);
    assert!(report.has_warnings());
    for header in ["5 22", "3 22", "4 24", "4\n22", "0 22"] {
        let text = good.replacen("4 22", header, 1);
        let text = if header == "4\n22" { text + "1 2 3 4 5 6 7\n" } else { text };
        assert!(refusal(&text).contains(", expected "), "{header}");
        assert!(refusal(&text).ends_with("; --salvage takes the whole keyframes"), "{header}");
    }
    assert_eq!(read_with(good.replacen("4 22", "9 22", 1), &salvage()).0, expected);
    // A number is missing in a line.
    let without = good.replacen("-2 1 0 1 0 0 0", "-2 1 0 1 0 0", 1);
    assert!(refusal(&without).contains("found 87 rows and 6 numbers (615 in all)"), "{}", refusal(&without));
    let without = good.replacen("-1.700000 ", "", 1);
    assert!(refusal(&without).contains(" (615 in all) (line 26 has 6 numbers, those before it 7); --salvage"));
    // In one line as well.
    let one_line = good.replace('\n', " ") + "1";
    assert!(refusal(&one_line).contains("the header says 4 keyframes of 22 nodes"));
}

#[test]
fn rows_that_end_within_a_keyframe() {
    let good = text("rows");
    let (expected, _) = read(&good);
    let cut: String = good.lines().take(80).map(|line| line.to_owned() + "\n").collect();
    assert_eq!(
        refusal(&cut),
        "line 81 column 1: found 560 numbers, 3 whole keyframes and 98 numbers, expected whole keyframes of 22 nodes with 7 numbers each; \
         --salvage takes the whole keyframes"
    );
    assert_eq!(read_with(&cut, &salvage()).0, expected[..3]);
    let without = good.replacen("0 0 0 1 0 0 0\n", "0 0 0 1 0 0\n", 1);
    assert!(refusal(without).contains("expected whole keyframes of 22 nodes"));
    let broken_line = good.replacen("-1.700000", "1 -1.700000", 1);
    assert!(refusal(broken_line).starts_with("line 25 column 1: "));
}

#[test]
fn what_is_cut_keeps_its_number_of_nodes() {
    let heads = ["robot1/head", "robot2/head"].map(|path| scene().find_rbt(path).expect("it has one").get());
    let without_heads = |rows: Vec<Row>| -> Vec<Row> {
        rows.into_iter().enumerate().filter(|(node, _)| !heads.contains(node)).map(|(_, row)| row).collect()
    };
    let with_lights = |rows: Vec<Row>| {
        let light = ["4", "3", "-3", "1", "0", "0", "0"].map(str::to_owned);
        [rows, vec![light.clone(), light]].concat()
    };
    let changed = |change: &dyn Fn(Vec<Row>) -> Vec<Row>| keyframes(6).into_iter().map(change).collect::<Vec<_>>();
    for (rows, nodes) in [(changed(&without_heads), 20), (changed(&with_lights), 24)] {
        for sample in texts(&rows, false).into_iter().filter(|sample| !sample.what.contains("CSV")) {
            let (expected, _) = read(&sample.text);
            for part in [0.9, 0.6, 0.4] {
                let cut = &sample.text[..(sample.text.len() as f64 * part) as usize];
                let (found, report) = read_with(cut, &salvage());
                assert!(report.to_string().contains(&format!("of {nodes} nodes")), "{}: {report}", sample.what);
                assert!(
                    !found.is_empty() && found[..] == expected[..found.len()],
                    "{} to {part}: {report}",
                    sample.what
                );
            }
        }
    }
    let cut: String = texts(&changed(&without_heads), false)
        .into_iter()
        .find(|sample| sample.what == "no header, a keyframe a line")
        .map(|sample| sample.text[..sample.text.len() - 20].to_owned())
        .unwrap();
    let sentence = refusal(cut);
    assert!(sentence.contains("whole keyframes of 20 nodes with 7 numbers each (line 6 has "), "{sentence}");
}

#[test]
fn keyframes_between_marks_are_of_one_length() {
    for layout in ["frames", "end"] {
        let good = text(layout);
        let (expected, _) = read(&good);
        let broken = good.replacen("-1.700000", "", 1);
        let sentence = refusal(&broken);
        assert!(sentence.contains("keyframe 1 has 153 numbers, expected 154; --salvage"), "{sentence}");
        assert_eq!(read_with(&broken, &salvage()).0, expected[..1]);
        let cut = &good[..good.len() - 100];
        assert_eq!(read_with(cut, &salvage()).0, expected[..3]);
    }
    let (_, report) = read(text("frames").replacen("frame [1]", "frame [7]", 1));
    assert!(report.to_string().contains("warning: a line says frame 7 where frame 1 was expected"));
}

#[test]
fn csv_rows_are_counted() {
    let good = text("csv");
    let (expected, _) = read(&good);
    for (from, to, sentence) in [
        ("\n1,0,", "\n2,0,", "line 24 column 1: found frame_num 2, expected 1"),
        ("\n1,5,", "\n1,6,", "line 29 column 3: found rbt_ind 6, expected 5"),
        ("\n1,0,", "\n0,22,", "line 25 column 1: found frame_num 1, expected rbt_ind 22"),
        ("\n1,1,0,", "\n1,1,", "line 25 column 16: found the end of the line after 8 numbers, expected 9 numbers"),
        ("\n1,1,0,", "\n1,1,0,0,", "line 25 column 19: found 0, expected the end of the line after 9 numbers"),
        ("\n1,1,0,", "\n1,1,zero,", "line 25 column 5: found \"zero\", expected a number"),
    ] {
        let broken = good.replacen(from, to, 1);
        let found = refusal(&broken);
        assert!(
            found == sentence || sentence.contains("rbt_ind 22") && found.contains("23 nodes"),
            "{found}\n{sentence}"
        );
        if from.starts_with("\n1,1") {
            assert_eq!(read_with(&broken, &salvage()).0, expected[..1]);
        }
    }
    let cut: String = good.lines().take(80).map(|line| line.to_owned() + "\n").collect();
    assert!(refusal(&cut).contains("3 whole keyframes and 91 numbers"), "{}", refusal(&cut));
    assert_eq!(read_with(&cut, &salvage()).0, expected[..3]);
}

#[test]
fn matrices_are_rigid_and_whole() {
    let good = matrices(&keyframes(4));
    let scaled = good.replacen("-2.000000,1.000000,0.000000,1.000000,\n", "", 1);
    assert!(read(&scaled).0.len() == 4);
    let second = good.lines().nth(1).unwrap().len();
    let at = good.find('\n').unwrap() + 1;
    let mut broken = good.clone();
    broken.replace_range(at..at + 8, "2.000000");
    assert_eq!(second, good.lines().nth(1).unwrap().len());
    assert_eq!(
        refusal(&broken),
        "line 2 column 1: keyframe 1, node 0: the matrix is not rigid, expected a rotation and a translation in column order"
    );
    assert_eq!(read_with(&broken, &salvage()).0.len(), 1);
    assert!(
        refusal(&good[..good.len() - 12])
            .contains("3 whole keyframes and 351 numbers, expected whole keyframes of 22 nodes with 16 numbers each")
    );
}

#[test]
fn other_files_say_what_was_expected() {
    for (bytes, sentence) in [
        (&b""[..], "line 1 column 1: the file is empty, expected keyframes"),
        (b"\xef\xbb\xbf \n", "line 2 column 1: the file is empty, expected keyframes"),
        (b"\xff\xfe1\x00", "line 1 column 1: the file is UTF-16, expected UTF-8: save it so"),
        (b"{", "line 1 column 1: the file ends in the middle of an object: } or , is missing"),
        (b"{hello: 1}", "line 1 column 2: a name in double quotes is missing"),
        (b"{}", "line 1 column 2: format is missing"),
    ] {
        assert_eq!(refusal(bytes), sentence);
    }
    for model in
        [&b"glTF\x02\x00\x00\x00"[..], b"\xef\xbb\xbfHIERARCHY\nROOT hips", b"{\"asset\": {\"version\": \"2.0\"}}"]
    {
        let sentence = refusal(model);
        assert!(sentence.contains("of another program (glTF, BVH): `inbetween import`"), "{sentence}");
    }
    for bytes in [&b"hello"[..], b"\x89PNG\r\n\x1a\n", b"<html>", b"[1, 2]", b"\x00\x01"] {
        let sentence = refusal(bytes);
        assert!(
            sentence.starts_with("line 1 column 1: found ") && sentence.contains("expected keyframes: numbers"),
            "{sentence}"
        );
    }
    // A list in prose begins with a number, and is no row.
    let prose = refusal("# Title\n\nSome words, and 1.0.\n\n1. `inbetween mine.json` opens the window.\n");
    assert!(prose.starts_with("line 3 column 1: found \"Some\", expected keyframes: numbers"), "{prose}");
    assert_eq!(refusal("tx,ty,tz\n1 x 2 3"), "line 2 column 3: found \"x\", expected a number");
    assert_eq!(refusal("6 22\n0 0,,0"), "line 2 column 5: found \",\", expected a number");
    assert_eq!(refusal("6 22\n0 \u{e9}t\u{e9}"), "line 2 column 3: found \"\u{e9}t\u{e9}\", expected a number");
}

#[test]
fn nothing_whole_is_nothing_to_salvage() {
    for text in ["6 22\n1 2 3", "1 2 3", "frame [0]\n1 2 3\n"] {
        refusal_with(text, &salvage());
    }
}
