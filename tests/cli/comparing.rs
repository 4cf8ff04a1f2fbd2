//! `render --compare`: the same moments by several interpolations.

use std::io::Cursor;

use image::RgbImage;
use image::imageops::crop_imm;
use serde_json::{Value, json};

use crate::sandbox::{Outcome, Sandbox, keyframe_file};

/// The size of pictures with two views of 100x60 pixels.
const SIZE: &str = "212x130";
const VIEW: [u32; 2] = [100, 60];
/// Where the views are.
const CORNERS: [[u32; 2]; 2] = [[4, 4], [108, 4]];

/// Five keyframes of half a second, between which robot 1 turns about an oblique axis and goes to and fro.
fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    let mut file = keyframe_file(5);
    file["ms_between_keyframes"] = json!(500);
    let robot = file["nodes"].as_array().unwrap().iter().position(|node| node == "robot1").unwrap();
    for (keyframe, rotation) in
        [[0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.0, 1.0], [0.6, 0.0, 0.72, 0.35], [0.0, 0.6, 0.0, 0.8], [0.0, 0.0, 0.0, 1.0]]
            .into_iter()
            .enumerate()
    {
        file["keyframes"][keyframe]["pose"][robot]["rotation"] = json!(rotation);
        file["keyframes"][keyframe]["pose"][robot]["translation"] = json!([-0.5 + 0.3 * (keyframe % 2) as f64, 1, 0]);
    }
    sandbox.write("a.json", file.to_string());
    sandbox
}

fn render(sandbox: &Sandbox, arguments: &[&str]) -> Outcome {
    sandbox.run(&[&["render", "a.json"], arguments].concat())
}

#[track_caller]
fn done(outcome: &Outcome) {
    assert_eq!((outcome.status, outcome.stdout.as_str()), (0, ""), "{}", outcome.stderr);
}

fn bytes(sandbox: &Sandbox, name: &str) -> Vec<u8> {
    std::fs::read(sandbox.path(name)).unwrap()
}

fn open(sandbox: &Sandbox, name: &str) -> RgbImage {
    image::open(sandbox.path(name)).unwrap().to_rgb8()
}

fn view(picture: &RgbImage, [left, top]: [u32; 2]) -> RgbImage {
    crop_imm(picture, left, top, VIEW[0], VIEW[1]).to_image()
}

#[test]
fn each_view_is_the_picture_of_its_interpolation() {
    let sandbox = sandbox();
    for more in [&[][..], &["--quality", "3", "--shutter", "180"], &["--strobe", "3"], &["--ghosts", "1"]] {
        let at: &[&str] = if more.contains(&"--strobe") { &["--to", "1.3"] } else { &["--at", "0.7"] };
        let with = |own: &[&str]| done(&render(&sandbox, &[own, at, more].concat()));
        with(&["-o", "both.png", "--size", SIZE, "--compare", "file,catmull-rom"]);
        with(&["-o", "file.png", "--size", "100x60"]);
        with(&["-o", "catmull-rom.png", "--size", "100x60", "--interpolation", "catmull-rom"]);
        let both = open(&sandbox, "both.png");
        assert_eq!(both.dimensions(), (212, 130));
        assert_eq!(view(&both, CORNERS[0]), open(&sandbox, "file.png"), "{more:?}");
        assert_eq!(view(&both, CORNERS[1]), open(&sandbox, "catmull-rom.png"), "{more:?}");
        assert_ne!(view(&both, CORNERS[0]), view(&both, CORNERS[1]), "{more:?}");
    }
}

#[test]
fn all_four_differ_between_keyframes_and_agree_at_them() {
    let sandbox = sandbox();
    let views = |at: &str| {
        done(&render(&sandbox, &["-o", "x.png", "--compare", "linear,catmull-rom,nlerp,matrix", "--at", at]));
        let picture = open(&sandbox, "x.png");
        assert_eq!(picture.dimensions(), (652, 678));
        [[4, 4], [328, 4], [4, 330], [328, 330]].map(|[left, top]| crop_imm(&picture, left, top, 320, 240).to_image())
    };
    let between = views("0.25");
    for (index, view) in between.iter().enumerate() {
        assert!(!between[..index].contains(view), "{index}");
    }
    let at_keyframe = views("1");
    // Poses of a key are equal to the bit, matrices but for rounding.
    assert_eq!(at_keyframe[0], at_keyframe[1]);
    for view in &at_keyframe[2..] {
        let differ = at_keyframe[0].pixels().zip(view.pixels()).filter(|(a, b)| a != b).count();
        assert!(differ < 40, "{differ} pixels differ");
    }
}

#[test]
fn ghosts_are_drawn_over_the_first() {
    let sandbox = sandbox();
    let with = |name: &str, compared: &str| {
        let arguments =
            ["-o", name, "--size", "212x130", "--compare", compared, "--compare-as", "ghosts", "--at", "0.3"];
        done(&render(&sandbox, &arguments));
        open(&sandbox, name)
    };
    let (one, other) = (with("one.png", "linear,matrix"), with("other.png", "matrix,linear"));
    assert_eq!(one.dimensions(), (212, 130));
    let view = |picture: &RgbImage| crop_imm(picture, 4, 4, 204, 60).to_image();
    assert_ne!(view(&one), view(&other));
    done(&render(&sandbox, &["-o", "plain.png", "--size", "204x60", "--at", "0.3"]));
    let plain = open(&sandbox, "plain.png");
    let same = view(&one).pixels().zip(plain.pixels()).filter(|(a, b)| a == b).count();
    assert!((204 * 60 / 2..204 * 60 - 20).contains(&same), "{same} pixels are those of the first alone");
}

#[test]
fn a_film_is_the_same_in_parts_and_its_mark_moves() {
    let sandbox = sandbox();
    let film = ["--compare", "linear,nlerp", "--size", SIZE];
    let with = |more: &[&str]| done(&render(&sandbox, &[&film[..], more].concat()));
    with(&["-o", "whole/", "--fps", "8", "--manifest", "whole.json"]);
    with(&["-o", "parts/", "--fps", "8", "--frames", "5-8"]);
    with(&["-o", "parts/", "--fps", "8", "--missing"]);
    let size: Value = sandbox.json("whole.json")["size"].clone();
    assert_eq!(size, json!([212, 130]));
    let frames: Vec<Vec<u8>> = (0..9).map(|frame| bytes(&sandbox, &format!("whole/frame-{frame:05}.png"))).collect();
    for (frame, whole) in frames.iter().enumerate() {
        assert!(bytes(&sandbox, &format!("parts/frame-{frame:05}.png")) == *whole, "{frame}");
    }
    with(&["-o", "still.png", "--at", "0.75"]);
    assert!(bytes(&sandbox, "still.png") == frames[3]);
    // Of the panels only the mark moves, from the left to the right.
    let accent = |frame: usize| {
        let picture = image::load_from_memory(&frames[frame]).unwrap().to_rgb8();
        let is_mark = |x: u32, y: u32| picture.get_pixel(x, y).0 == [0xf2, 0xa3, 0x3a];
        (4..104).filter(|&x| (76..115).any(|y| is_mark(x, y))).min().unwrap()
    };
    assert!(accent(0) < accent(4) && accent(4) < accent(8));
    for name in ["a.gif", "b.gif"] {
        with(&["-o", name, "--fps", "10"]);
    }
    assert!(bytes(&sandbox, "a.gif") == bytes(&sandbox, "b.gif"));
    let gif = gif::DecodeOptions::new().read_info(Cursor::new(bytes(&sandbox, "a.gif"))).unwrap();
    assert_eq!((gif.width(), gif.height()), (212, 130));
    with(&["-o", "frames/", "--fps", "10"]);
    done(&sandbox.run(&["join", "frames", "--fps", "10", "-o", "joined.y4m"]));
    with(&["-o", "drawn.y4m", "--fps", "10"]);
    assert!(bytes(&sandbox, "joined.y4m") == bytes(&sandbox, "drawn.y4m"));
}

#[test]
fn a_contact_sheet_has_compared_pictures() {
    let sandbox = sandbox();
    let compared = ["--compare", "linear,matrix", "--size", SIZE];
    done(&render(&sandbox, &[&compared[..], &["-o", "sheet.png", "--sheet", "2x1"]].concat()));
    done(&render(&sandbox, &[&compared[..], &["-o", "first.png"]].concat()));
    let sheet = open(&sandbox, "sheet.png");
    assert_eq!(sheet.dimensions(), (2 * 216 + 4, 130 + 11 + 8));
    assert_eq!(crop_imm(&sheet, 4, 4, 212, 130).to_image(), open(&sandbox, "first.png"));
}

#[test]
fn the_plotted_node_can_be_chosen() {
    let sandbox = sandbox();
    let with = |name: &str, more: &[&str]| {
        done(&render(&sandbox, &[&["-o", name, "--compare", "linear,nlerp", "--at", "0.3"], more].concat()));
        open(&sandbox, name)
    };
    let usual = with("usual.png", &[]);
    assert_eq!(usual, with("robot.png", &["--compare-node", "robot1"]));
    let head = with("head.png", &["--compare-node", "robot1/head"]);
    let [views, plots] =
        [0, 244].map(|top| [&usual, &head].map(|picture| crop_imm(picture, 0, top, 652, 100).to_image()));
    assert!(views[0] == views[1] && plots[0] != plots[1]);
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let sandbox = sandbox();
    for arguments in [
        &["--compare", "linear"][..],
        &["--compare", "linear,cubic"],
        &["--compare", "linear,nlerp", "--size", "100x100"],
        &["--compare", "linear,nlerp", "--keyframe", "1"],
        &["--compare", "linear,nlerp", "--id"],
        &["--compare", "linear,nlerp", "--interpolation", "linear"],
        &["--compare", "linear,nlerp", "--compare-as", "stack"],
        &["--compare", "linear,nlerp", "--compare-as", "ghosts", "--strobe", "3"],
        &["--compare-as", "ghosts"],
        &["--compare-node", "robot1"],
    ] {
        println!("{arguments:?}");
        render(&sandbox, &[&["-o", "x.png"], arguments].concat()).misuses();
    }
    sandbox.run(&["render", "-o", "x.png", "--compare", "linear,nlerp"]).misuses();
    let outcome = render(&sandbox, &["-o", "x.png", "--compare", "linear,nlerp", "--compare-node", "robot9"]);
    assert_eq!(
        (outcome.status, outcome.stderr.trim_end()),
        (1, "compared node \"robot9\": the scene has no such node")
    );
    assert_eq!(sandbox.names(), ["a.json"]);
}
