//! What stands between numbers: marks, other headers, index columns, comments. The numbers decide, and the places are checked.

use super::samples::{Row, keyframes, lines};
use super::{read, read_with, refusal};
use inbetween::keyframe::Keyframe;
use inbetween::text_layouts::Options;

fn row(row: &Row) -> String {
    row.join(" ")
}

/// The rows with a text before each keyframe and each row, and after each.
fn text(keyframes: &[Vec<Row>], before: &dyn Fn(usize) -> String, each: &dyn Fn(usize, &Row) -> String) -> String {
    let text = |(index, rows): (usize, &Vec<Row>)| {
        before(index) + &lines(rows.iter().enumerate().map(|(node, row)| each(node, row)))
    };
    keyframes.iter().enumerate().map(text).collect()
}

fn plain(keyframes: &[Vec<Row>]) -> String {
    text(keyframes, &|_| String::new(), &|_, numbers| row(numbers))
}

fn expected() -> Vec<Keyframe> {
    read("4 22\n".to_owned() + &plain(&keyframes(4))).0
}

/// Lines that may stand between keyframes.
const MARKS: [&str; 10] =
    ["****", "-----", "|", "*", "frame", "Frame 0", "=== next ===", "next pose:", "키프레임", "<keyframe>"];

#[test]
fn any_line_without_a_row_may_stand_between_keyframes() {
    let (rows, expected) = (keyframes(4), expected());
    for mark in MARKS {
        let every = text(&rows, &|_| format!("{mark}\n"), &|_, numbers| row(numbers));
        let between = every.strip_prefix(&format!("{mark}\n")).unwrap().to_owned();
        let around = every.clone() + mark + "\n";
        let with_header = "4 22\n".to_owned() + &every;
        let after_header = format!("4 22\n{between}");
        // A numbered mark promises a keyframe after it.
        let around = if mark == "Frame 0" { every.clone() } else { around };
        for text in [every, between, around, with_header, after_header] {
            let (found, report) = read(&text);
            assert_eq!(found, expected, "{mark}\n{report}");
            assert!(report.to_string().contains(&format!("{mark:?}")), "{mark}: {report}");
        }
    }
}

#[test]
fn numbered_marks_are_counted() {
    let rows = keyframes(4);
    for name in ["Frame ", "frame", "Keyframe #", "keyframe: ", "FRAME [", "key frame "] {
        let numbered =
            |first: usize| text(&rows, &|index| format!("{name}{}\n", index + first), &|_, numbers| row(numbers));
        for first in [0, 1] {
            let (found, report) = read(numbered(first));
            assert_eq!(found, expected(), "{name}");
            assert!(!report.has_warnings(), "{name}: {report}");
        }
        let swapped = numbered(0).replacen(&format!("{name}2\n"), &format!("{name}9\n"), 1);
        let (_, report) = read(swapped);
        assert!(report.to_string().contains("warning: a line says frame 9 where frame 2 was expected"), "{report}");
    }
}

#[test]
fn signs_may_stand_between_rows() {
    let rows = keyframes(4);
    let a_line = |rows: &[Row], between: &str| rows.iter().map(|row| row.join(", ")).collect::<Vec<_>>().join(between);
    for between in ["|", " | ", "/", ":", " ** ", "&"] {
        let joined = lines(rows.iter().map(|rows| a_line(rows, between)));
        let ended = lines(rows.iter().map(|rows| a_line(rows, between) + between));
        for text in [joined.clone(), ended.clone(), "4 22\n".to_owned() + &joined, joined.replace('\n', between)] {
            let (found, report) = read(&text);
            assert_eq!(found, expected(), "{between}");
            assert!(report.to_string().contains("note: what stands between numbers is not used: "), "{report}");
        }
    }
    for [open, close] in [["[", "]"], ["(", ")"], ["{ ", " }"], ["[ [", "] ]"]] {
        let bracketed = text(&rows, &|_| String::new(), &|_, row| format!("{open}{}{close},", row.join(", ")));
        assert_eq!(read(&bracketed).0, expected(), "{open}");
        assert_eq!(read("4 22\n".to_owned() + &bracketed).0, expected(), "{open}");
    }
    let two = text(&rows, &|_| String::new(), &|_, row| format!("[{}] ({})", row[..3].join(", "), row[3..].join(", ")));
    assert_eq!(read(&two).0, expected());
}

#[test]
fn a_first_line_may_be_what_python_has_too() {
    let rows = keyframes(4);
    let text = text(&rows, &|_| String::new(), &|_, numbers| row(numbers));
    for first in ["N = 4", "t=0.5", "sep=;"] {
        assert_eq!(read(format!("{first}\n{text}")).0, expected(), "{first}");
    }
}

#[test]
fn the_places_of_marks_are_checked() {
    let rows = keyframes(4);
    let stars = text(&rows, &|_| "****\n".to_owned(), &|_, numbers| row(numbers));
    let line = |text: &str, line: usize, with: &str| {
        let mut lines: Vec<&str> = text.lines().collect();
        if with.is_empty() {
            lines.remove(line);
        } else {
            lines.insert(line, with);
        }
        lines.join("\n")
    };
    // One too many, and one that is missing.
    assert_eq!(
        refusal(line(&stars, 30, "****")),
        "line 25 column 1: keyframe 1 has 42 numbers, expected 154; --salvage takes the whole keyframes"
    );
    assert!(refusal(line(&stars, 23, "")).contains("keyframe 0 has 308 numbers, expected 154"));
    // Among bars, one that moved by a number.
    let bars = text(&rows, &|_| String::new(), &|_, numbers| row(numbers) + " |");
    assert_eq!(read(&bars).0, expected());
    let moved = line(&line(&bars, 30, ""), 30, "-0.5 0.75 0 1 0 0 | 0");
    assert_eq!(
        refusal(moved),
        "line 31 column 19: found \"|\", expected a number: keyframe 0 has no mark at this place"
    );
    let missing = line(&line(&bars, 30, ""), 30, "-0.5 0.75 0 1 0 0 0");
    assert_eq!(refusal(missing), "line 32 column 1: found a number, expected a mark as between the numbers before");
    // A line in the middle is a mistake, not a mark.
    let lonely = line(&plain(&rows), 30, "hello");
    assert_eq!(
        refusal(&lonely),
        "line 31 column 1: found \"hello\", expected a number: keyframe 0 has no mark at this place"
    );
    // The numbers of a keyframe that is not whole.
    let short = line(&stars, 30, "");
    assert_eq!(
        refusal(&short),
        "line 25 column 1: keyframe 1 has 147 numbers, expected 154; --salvage takes the whole keyframes"
    );
    assert_eq!(read_with(&short, &Options { salvage: true, ..Options::default() }).0, expected()[..1]);
}

#[test]
fn a_mark_that_stands_alone_is_a_mistake() {
    let rows = plain(&keyframes(4));
    for (from, to, sentence) in [
        ("\n-1.700000 1", "\n- 1", "line 26 column 1: found \"-\", expected a number"),
        ("\n-1.700000 1", "\nnull 1", "line 26 column 1: found \"null\", expected a number"),
        ("\n-1.700000 1", "\n[] 1", "line 26 column 1: found \"[]\", expected a number"),
        ("\n-1.700000 ", "\n-1.700000\nzero\n", "line 27 column 1: found \"zero\", expected a number"),
        ("\n-1.700000 1 ", "\n-1.700000 / ", "line 26 column 11: found \"/\", expected a number"),
    ] {
        for header in ["4 22\n", "\n"] {
            assert_eq!(refusal(header.to_owned() + &rows.replacen(from, to, 1)), sentence);
        }
    }
    let samples = "key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n0,0,0,0,0,1,0,0,0\n";
    assert!(refusal(samples).starts_with("line 1 column 1: found \"key_time,rbt_ind"), "{}", refusal(samples));
}

#[test]
fn headers_may_have_more_or_fewer_numbers() {
    let rows = plain(&keyframes(4));
    for (header, finding) in [
        ("4;22;60;176\n", "note: header: 60 and 176 are not used"),
        ("4 22 60\n", "note: header: 60 is not used"),
        ("4,22,59.94\n", "note: header: 59.94 is not used"),
        ("22 4\n", "sure: header: 4 keyframes of 22 nodes"),
        ("4\n", "likely: header: 4 keyframes; the numbers that follow make 22 nodes each"),
        ("22\n", "likely: header: 22 nodes; the numbers that follow make 4 keyframes"),
        ("4;\n", "likely: header: 4 keyframes"),
        ("4 60 176\n", "note: header: 60 and 176 are not used"),
        ("4\n22\n60\n", "note: header: 60 is not used"),
        ("# written by my program\n4 22 // keyframes, nodes\n", "sure: header: 4 keyframes of 22 nodes"),
        ("keyframes nodes\n4 22\n", "sure: header: 4 keyframes of 22 nodes"),
    ] {
        for mark in ["", "frame\n", "****\n"] {
            let marked = text(&keyframes(4), &|_| mark.to_owned(), &|_, numbers| row(numbers));
            let (found, report) = read(header.to_owned() + if mark.is_empty() { &rows } else { &marked });
            assert_eq!(found, expected(), "{header}");
            // Marks say how many keyframes there are, so nothing is inferred from the header then.
            let is_said = mark.is_empty() || finding.starts_with("note");
            assert!(!is_said || report.to_string().contains(finding), "{header}: {report}");
        }
    }
    for header in ["5;22;60;176\n", "5 22 60\n", "5 60 176\n", "3\n", "21\n", "5 60\n"] {
        refusal(header.to_owned() + &rows);
    }
    assert_eq!(
        refusal("5;22;60;176\n".to_owned() + &rows),
        "line 1 column 1: the header says 5 keyframes of 22 nodes, expected 110 rows (770 numbers) after it, found 88 rows (616 \
         numbers); --salvage takes the whole keyframes"
    );
    let salvaged = read_with("5;22;60;176\n".to_owned() + &rows, &Options { salvage: true, ..Options::default() });
    assert_eq!(salvaged.0, expected());
}

#[test]
fn columns_may_have_other_names_or_none() {
    let rows = keyframes(4);
    let table = |lead: &dyn Fn(usize, usize) -> String| -> String {
        rows.iter()
            .enumerate()
            .flat_map(|(k, rows)| rows.iter().enumerate().map(move |(node, row)| (k, node, row.join(","))))
            .map(|(k, node, row)| lead(k, node) + &row + "\n")
            .collect()
    };
    let frame_and_row = table(&|k, node| format!("{k},{node},"));
    for (names, lead) in [
        ("frame,node,x,y,z,qw,qx,qy,qz\n", frame_and_row.clone()),
        ("\"Frame\";\"Joint\";\"px\";\"py\";\"pz\";\"w\";\"x\";\"y\";\"z\"\n", frame_and_row.clone()),
        ("keyframe\trbt\ttx\tty\ttz\trw\trx\try\trz\n", frame_and_row.replace(',', "\t")),
        ("", frame_and_row.clone()),
        ("4 22\n", frame_and_row.clone()),
        ("", table(&|k, node| format!("{},{},", k + 1, node + 1))),
        ("", table(&|k, node| format!("{node},{k},"))),
        ("", table(&|_, node| format!("{node},"))),
        ("", table(&|k, _| format!("{k},"))),
        ("", table(&|k, node| format!("{},", k * 22 + node))),
        ("", table(&|k, node| format!("{}: ", k * 22 + node + 1))),
        ("time,node,tx,ty,tz,rw,rx,ry,rz\n", table(&|k, node| format!("{},{node},", 0.25 * k as f32))),
        (",frame_num,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n", table(&|k, node| format!("{},{k},{node},", k * 22 + node))),
        ("tx,ty,tz,rw,rx,ry,rz\n", table(&|_, _| String::new())),
    ] {
        let (found, report) = read(names.to_owned() + &lead);
        assert_eq!(found, expected(), "{names}\n{report}");
        assert!(!report.has_warnings(), "{names}\n{report}");
    }
    let broken = frame_and_row.replacen("\n1,5,", "\n1,6,", 1);
    assert_eq!(refusal(&broken), "line 28 column 3: found row number 6, expected 5");
    let broken = "frame,node,x,y,z,qw,qx,qy,qz\n".to_owned() + &frame_and_row.replacen("\n1,5,", "\n0,5,", 1);
    assert_eq!(refusal(&broken), "line 29 column 1: found frame 0, expected node 5 of keyframe 1 before it");
}

#[test]
fn rows_may_have_labels() {
    let rows = keyframes(4);
    let names: Vec<String> = super::samples::scene().rbt_paths().map(|path| path.replace('/', "_")).collect();
    let labelled =
        |label: &dyn Fn(usize, &Row) -> String| text(&rows, &|_| String::new(), &|node, row| label(node, row));
    for labelled in [
        labelled(&|node, numbers| format!("node{node}: {}", row(numbers))),
        labelled(&|node, numbers| format!("{} {}", names[node], row(numbers))),
        labelled(&|node, numbers| format!("{}\n{}", names[node], row(numbers))),
        labelled(&|node, numbers| format!("{},{}", numbers.join(","), names[node])),
        labelled(&|_, row| format!("t {}\nr {}", row[..3].join(" "), row[3..].join(" "))),
        labelled(&|_, row| format!("Rbt(Cvec3({}), Quat({}))", row[..3].join(", "), row[3..].join(", "))),
        "| k | n | tx | ty | tz | rw | rx | ry | rz |\n|---|---|---|---|---|---|---|---|---|\n".to_owned()
            + &rows
                .iter()
                .enumerate()
                .flat_map(|(k, rows)| {
                    rows.iter().enumerate().map(move |(node, row)| format!("|{k}|{node}|{}|\n", row.join("|")))
                })
                .collect::<String>(),
    ] {
        let (found, report) = read(&labelled);
        assert_eq!(found, expected(), "{report}");
        assert!(!report.has_warnings(), "{report}");
    }
    let six = text(&rows, &|_| String::new(), &|_, row| row[..6].join(" "));
    assert!(refusal("4 22\n".to_owned() + &six).contains("(each line has 6 numbers, and a row has 7)"));
}

#[test]
fn names_tell_where_w_stands() {
    let rows = keyframes(4);
    let last = |row: &Row| [0, 1, 2, 4, 5, 6, 3].map(|place: usize| row[place].clone());
    let w_last = text(&rows, &|_| String::new(), &|_, numbers| last(numbers).join(","));
    let (found, report) = read("tx,ty,tz,qx,qy,qz,qw\n".to_owned() + &w_last);
    assert_eq!(found, expected(), "{report}");
    assert!(!report.has_warnings(), "{report}");
    // Without names, most nodes of keyframe 0 are not rotated.
    let (found, report) = read(&w_last);
    assert_eq!(found, expected());
    assert!(
        report.to_string().contains("warning: order: the last number of the quaternion is 1 in 22 of 22 rows"),
        "{report}"
    );
}

#[test]
fn comments_and_blank_lines_are_passed_over() {
    let text = text(&keyframes(4), &|index| format!("\n# keyframe {index} of 4\n//////\n"), &|node, numbers| {
        format!("{} {} node {node}, 1.5", row(numbers), if node % 2 == 0 { "#" } else { "//" })
    });
    assert_eq!(read(&text).0, expected());
    assert_eq!(read("# mine\n4 22\n".to_owned() + &text).0, expected());
    let in_c = plain(&keyframes(4)).replace("0.75", "0.75f");
    assert_eq!(read(&in_c).0, expected());
}

#[test]
fn decimal_commas_are_named() {
    let with_commas = plain(&keyframes(4)).replace('.', ",");
    for header in ["4 22\n", "4;22\n", "", "****\n"] {
        let line = 1 + usize::from(!header.is_empty());
        let sentence =
            format!("line {line} column 1: \"-0,657306\" has a decimal comma, expected a decimal point: -0.657306");
        assert_eq!(refusal(header.to_owned() + &with_commas), sentence);
        let semicolons = with_commas.replace(' ', ";");
        assert_eq!(refusal(header.to_owned() + &semicolons), sentence);
        assert_eq!(refusal(header.to_owned() + &with_commas.replace(' ', "\t")), sentence);
        assert_eq!(refusal(header.to_owned() + &with_commas.replace('\n', " ")), sentence);
    }
    let table = "frame;node;tx;ty;tz;rw;rx;ry;rz\n".to_owned()
        + &text(&keyframes(4), &|_| String::new(), &|node, row| {
            format!("0;{node};{}", row.join(";").replace('.', ","))
        });
    assert!(refusal(&table).contains("\"-0,657306\" has a decimal comma"), "{}", refusal(&table));
    // Whole numbers between commas are no decimals.
    let whole = "4,22\n".to_owned() + &"0,0,0,1,0,0,0\n".repeat(88);
    assert_eq!(read(&whole).0.len(), 4);
    let whole = "4,22\n".to_owned() + &"0 0 0 1 0 0 0\n".repeat(88);
    assert_eq!(read(&whole).0.len(), 4);
}

#[test]
fn numbers_of_c_end_in_f() {
    let plain = format!("4 22\n{}", lines(keyframes(4).iter().flatten().map(|row| row.join(" "))));
    let (expected, _) = read(&plain);
    let with_f = |separator: &str| {
        let row = |row: &Row| row.clone().map(|number| format!("{number}f")).join(separator);
        format!("4 22\n{}", lines(keyframes(4).iter().flatten().map(row)))
    };
    for separator in [" ", ", ", ",", "; "] {
        assert_eq!(read(with_f(separator)).0, expected, "{separator:?}");
    }
    let last_row = plain.trim_end().rsplit_once('\n').unwrap().1;
    let late =
        plain.replace(last_row, &last_row.split(' ').map(|number| format!("{number}f")).collect::<Vec<_>>().join(" "));
    assert_eq!(read(late).0, expected);
}
