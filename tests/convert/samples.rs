//! A small animation, and its text in every layout, made by code of its own.
#![allow(dead_code, reason = "each test uses a part")]

use inbetween::scene::{DEFAULT_SCENE, SceneGraph, built_in_scene};

/// tx ty tz qw qx qy qz, as printed.
pub type Row = [String; 7];

pub fn scene() -> SceneGraph {
    built_in_scene(DEFAULT_SCENE).expect("it is built in")
}

/// So many keyframes in the scene's order: at rest, but for a robot that walks and turns. Two quaternions have a negative w.
pub fn keyframes(count: usize) -> Vec<Vec<Row>> {
    let scene = scene();
    let row = |keyframe: usize, node: usize, [x, y, z]: [f32; 3]| {
        let mut row: Row = [x, y, z, 1.0, 0.0, 0.0, 0.0].map(|number| number.to_string());
        match node {
            0 => row[..3].clone_from_slice(&["-0.657306", "4.09635", "13.213"].map(str::to_owned)),
            2 if keyframe > 0 => {
                let angle = 0.3 * keyframe as f64;
                row[0] = format!("{:.6}", angle - 2.0);
                "-8.70831e-016".clone_into(&mut row[2]);
                row[3] = format!("{:.6}", angle.cos());
                row[5] = format!("{:.6}", angle.sin());
            }
            11 if keyframe > 1 => row[3..].clone_from_slice(&["-0.6", "0", "0.8", "-0"].map(str::to_owned)),
            16 => "-1".clone_into(&mut row[3]),
            _ => {}
        }
        row
    };
    let rest: Vec<[f32; 3]> = scene.rest_pose().iter().map(|rbt| rbt.translation.to_array()).collect();
    (0..count)
        .map(|keyframe| rest.iter().enumerate().map(|(node, &offset)| row(keyframe, node, offset)).collect())
        .collect()
}

/// Lines that end so.
pub fn lines(lines: impl IntoIterator<Item = String>) -> String {
    lines.into_iter().map(|line| line + "\n").collect()
}

/// The row with the quaternion first.
pub fn quaternion_first(row: &Row) -> Row {
    [3, 4, 5, 6, 0, 1, 2].map(|place: usize| row[place].clone())
}

/// A layout with one of its names in the report, and its text.
pub struct Sample {
    pub what: &'static str,
    pub layout: &'static str,
    pub text: String,
}

fn matrix(row: &Row) -> String {
    let [tx, ty, tz, w, x, y, z] = row.clone().map(|number| number.parse::<f64>().unwrap());
    let columns = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y), 0.0],
        [2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x), 0.0],
        [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y), 0.0],
        [tx, ty, tz, 1.0],
    ];
    columns.iter().flatten().fold(String::new(), |text, number| text + &format!("{number:.6},"))
}

pub fn matrices(keyframes: &[Vec<Row>]) -> String {
    lines(keyframes.iter().map(|rows| rows.iter().map(matrix).collect()))
}

/// The layouts 1 to 8 of an animation; `swap` puts the quaternion first.
pub fn texts(keyframes: &[Vec<Row>], swap: bool) -> Vec<Sample> {
    let keyframes: Vec<Vec<Row>> = keyframes
        .iter()
        .map(|rows| rows.iter().map(|row| if swap { quaternion_first(row) } else { row.clone() }).collect())
        .collect();
    let first = if swap { 4 } else { 3 };
    let all = || keyframes.iter().flatten();
    let (n, m) = (keyframes.len(), keyframes[0].len());
    let header = || format!("{n} {m}\n");
    let marked = |before: &dyn Fn(usize) -> String, after: &str| -> String {
        let blocks = keyframes.iter().enumerate();
        blocks.map(|(k, rows)| before(k) + &lines(rows.iter().map(|row| row.join(" "))) + after).collect()
    };
    let csv_header =
        if swap { "frame_num,rbt_ind,rw,rx,ry,rz,tx,ty,tz\n" } else { "frame_num,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n" };
    let csv = keyframes
        .iter()
        .enumerate()
        .flat_map(|(k, rows)| rows.iter().enumerate().map(move |(node, row)| format!("{k},{node},{}", row.join(","))));
    let in_two = |row: &Row, between: &str| row[..first].join(",") + between + &row[first..].join(",");
    let two_lines = || all().map(|row| format!("{} \n{} ", row[..first].join(" "), row[first..].join(" ")));
    let a_line =
        || lines(keyframes.iter().map(|rows| rows.iter().map(|row| row.join(" ")).collect::<Vec<_>>().join(" ")));
    let rows = || lines(all().map(|row| row.join(" ")));
    let stream = || all().map(|row| row.join(" ")).collect::<Vec<_>>().join(" ");
    let named = if swap { "header-quaternion-first" } else { "header" };
    let samples = [
        ("a row a line", named, header() + &rows()),
        ("a keyframe a line", "header-keyframe-a-line", header() + &a_line()),
        ("two lines a row", "header-two-lines", header() + &lines(two_lines())),
        ("N and M on lines of their own", named, format!("{n}\n{m}\n") + &rows()),
        ("one line", named, format!("{n} {m} {}", stream())),
        ("a number a line", named, format!("{n} {m} {}", stream()).replace(' ', "\n")),
        ("no header", "rows", rows()),
        ("no header, a keyframe a line", "rows", a_line()),
        ("frames", "frames", marked(&|k| format!("frame [{k}]\n"), "")),
        ("frames after a header", "frames", header() + &marked(&|k| format!("frame [{k}]\n"), "")),
        ("frames and ends", "frames", marked(&|k| format!("frame [{k}]\n"), "end\n")),
        ("ends", "end", marked(&|_| String::new(), "end\n")),
        ("ends after a header", "end", header() + &marked(&|_| String::new(), "end\n")),
        ("one end", "end", rows() + "end\n"),
        ("one end after a header", "end", header() + &rows() + "end\n"),
        ("CSV", "csv", csv_header.to_owned() + &lines(csv)),
        (
            "pairs",
            "pairs",
            lines(keyframes.iter().map(|rows| rows.iter().map(|row| in_two(row, ";")).collect::<Vec<_>>().join(" "))),
        ),
        ("endless", "endless", all().map(|row| row.join(",") + ";").collect()),
    ];
    samples.into_iter().map(|(what, layout, text)| Sample { what, layout, text }).collect()
}

/// Texts that are read too: other marks between keyframes and rows, other headers, columns before the seven, comments.
pub fn variants(keyframes: &[Vec<Row>]) -> Vec<String> {
    let (n, m) = (keyframes.len(), keyframes[0].len());
    let rows = |before: &str, between: &str, after: &str| -> String {
        keyframes
            .iter()
            .map(|rows| before.to_owned() + &lines(rows.iter().map(|row| row.join(between) + after)))
            .collect()
    };
    let indexed = keyframes
        .iter()
        .enumerate()
        .flat_map(|(k, rows)| rows.iter().enumerate().map(move |(node, row)| format!("{k};{node};{}", row.join(";"))));
    let indexed = lines(indexed);
    vec![
        rows("****\n", " ", ""),
        rows("frame\n", ",", ""),
        rows("Keyframe 7:\n", " ", " // a row"),
        rows("", ", ", " |"),
        rows("", ", ", "],").replace('\n', "\n["),
        format!("{n};{m};60;176\n") + &rows("", " ", ""),
        format!("{n}\n") + &rows("# next\n", "\t", ""),
        indexed.clone(),
        "frame;joint;px;py;pz;qx;qy;qz;qw\n".to_owned() + &indexed,
        rows("", " ", "").replace('.', ","),
    ]
}

/// Keys of a control node.
pub const PYTHON: &str = "\
from transform import vec, quaternion, quaternion_from_euler  # the course's module
translate_keys = {0: vec(0, 0, 0), 2: vec(1, 1, 0), 4.5: vec((0, -8.5e-1, 0))}
rotate_keys = {0: quaternion(), 2: quaternion_from_euler(180, 45, 90),
               3: quaternion_from_axis_angle(vec(0, 1, 0), degrees=90), 4: quaternion(0, 0, 0.6, 0.8)}
scale_keys = {4: 1, 0: 1, 2: vec(0.5, 1, 2)}
";
