//! Scripts and bad files made from seeds. The same seed gives the same bytes on every machine and in every version of this project.

use crate::bases::{NODES, base};
use crate::cases::{Case, RUN_SCRIPT};
use crate::random_numbers::Random;

const SCRIPTS: u64 = 220;
const FILES: u64 = 180;

impl Random {
    fn one_of<'a>(&mut self, all: &[&'a str]) -> &'a str {
        all[self.below(all.len())]
    }
}

/// The scripts of all seeds.
pub fn scripts() -> Vec<Case> {
    (0..SCRIPTS).map(|seed| Case::new(format!("random-{seed:03}"), script(seed).into_bytes(), RUN_SCRIPT)).collect()
}

/// The bad files of all seeds.
pub fn files() -> Vec<Case> {
    (0..FILES).map(file).collect()
}

const NUMBERS: [&str; 12] = ["0", "1", "-1", "0.5", "-0.25", "2", "3.5", "-7", "0.001", "45", "90", "180"];
const KEYS: [&str; 44] = [
    "space",
    "c",
    "u",
    ">",
    "<",
    "d",
    "n",
    "n",
    "n",
    "i",
    "w",
    "y",
    "y",
    "+",
    "-",
    "t",
    "v",
    "p",
    "m",
    "a",
    "r",
    "h",
    "shift+p",
    "ctrl+z",
    "ctrl+shift+z",
    "f11",
    "escape",
    ".",
    ",",
    "=",
    "ctrl+c",
    "ctrl+x",
    "ctrl+v",
    "ctrl+d",
    "delete",
    "ctrl+shift+c",
    "ctrl+shift+v",
    "shift+y",
    "right",
    "left",
    "shift+l",
    "shift+a",
    "home",
    "shift+g",
];
const NAMES: [&str; 16] = [
    "Display keyframe",
    "New keyframe",
    "new keyframe",
    "Reverse keyframes",
    "Put control node above",
    "Fit all",
    "Rename keyframe…",
    "Loop",
    "Hold timed keys",
    "Restart timed keys",
    "Motion path",
    "Compare interpolations",
    "Open…",
    "Save As…",
    "Export…",
    "Save scene as…",
];
const EASINGS: [&str; 8] =
    ["linear", "hold", "sine-in", "quad-out", "cubic-in-out", "back-in", "bounce-out", "elastic-in-out"];
const CHANNELS: [&str; 3] = ["translation", "rotation", "scale"];
const TIMES: [&str; 6] = ["0", "0.5", "1", "1.5s", "2", "7.25"];
/// Lines that say something whatever is going on, so that the next drag repeats that and no error of a drag.
const TALKATIVE: [&str; 3] = ["eye sky", "ghosts 2", "mode loop"];

/// A path of an RBT node.
fn path(random: &mut Random) -> &'static str {
    NODES[random.below(NODES.len())].0
}

fn script(seed: u64) -> String {
    let mut random = Random(seed);
    let mut lines: Vec<String> = vec![format!("# seed {seed}")];
    let keyframes = [0, 2, 5, 6][random.below(4)];
    for keyframe in 0..keyframes {
        lines.push(format!("set-translation {keyframe} 1 0 robot1"));
        lines.push("key n".to_owned());
    }
    let has_control = random.below(3) == 0;
    if has_control {
        lines.push("put-control robot1/head".to_owned());
        lines.push("add-key translation 0 robot1/head_control".to_owned());
        lines.push("set-key rotation 2 90,0,0 robot1/head_control".to_owned());
    }
    for _ in 0..18 {
        if random.below(12) == 0 {
            drag(&mut random, &mut lines);
        } else {
            lines.push(line(&mut random, has_control));
        }
    }
    lines.join("\n") + "\n"
}

fn drag(random: &mut Random, lines: &mut Vec<String>) {
    lines.push(random.one_of(&TALKATIVE).to_owned());
    lines.push("drag begin".to_owned());
    for _ in 0..=random.below(3) {
        let number = random.one_of(&["0.5", "-0.25", "1"]);
        lines.push(match random.below(3) {
            0 => format!("drag turn {} {number}", random.one_of(&["x", "y", "z"])),
            1 => format!("wheel {number}"),
            _ => format!("drag move {number} 0.125 0"),
        });
    }
    lines.push(random.one_of(&["drag end", "drag end", "drag cancel", "key escape"]).to_owned());
    lines.push(random.one_of(&TALKATIVE).to_owned());
}

fn line(random: &mut Random, has_control: bool) -> String {
    let [a, b, c, d] = [(); 4].map(|()| random.one_of(&NUMBERS));
    let index = random.below(8);
    let axis = random.one_of(&["x", "y", "z"]);
    let node = path(random);
    if has_control && random.below(4) == 0 {
        return scene_line(random);
    }
    match random.below(42) {
        0..=9 => format!("key {}", random.one_of(&KEYS)),
        10 => format!("do {}", random.one_of(&NAMES)),
        11 | 12 => format!("select {node}"),
        13 => "select none  # nothing".to_owned(),
        14 => format!("rotate {axis} {a}"),
        15 => format!("translate {a} {b} {c}"),
        16 | 17 => format!("wait {}", random.one_of(&["500ms", "2s", "16ms", "10s", "0.1s"])),
        18 => random.one_of(&["undo", "redo"]).to_owned(),
        19 => format!("go {index}"),
        20 => random
            .one_of(&["select-keyframes 0-2", "select-keyframes 1 3", "select-keyframes none", "select-keyframes 4"])
            .to_owned(),
        21 => format!("move {index}"),
        22 => random.one_of(&["copy", "cut", "paste", "duplicate", "delete", "reverse"]).to_owned(),
        23 => format!("easing {}", random.one_of(&EASINGS)),
        24 => format!("rename {index} {}", random.one_of(&["", "up", "\"a # b\"", "걷기", "left foot # down"])),
        25 => {
            format!("duration {index} {}", random.one_of(&["2", "0.5 ripple-free", "1000", "0.001", "3 ripple-free"]))
        }
        26 => random.one_of(&["copy-pose", "paste-pose"]).to_owned(),
        27 => format!("set-translation {a} {b} {c} {node}"),
        28 => format!("set-rotation {a} {b} {c} {d} {node}"),
        29 => format!("set-keyframe-translation {index} {a} {b} {c} {node}"),
        30 => format!("set-keyframe-rotation {index} {a} {b} {c} {d} {node}"),
        31 => format!("wheel {a}"),
        32 => format!("interpolation {}", random.one_of(&["linear", "catmull-rom"])),
        33 => format!("ms {}", random.one_of(&["100", "700", "2000", "10000"])),
        34 => format!("scrub {}", random.one_of(&["0", "0.5", "1.25", "2", "9", "-1"])),
        35 => format!("step {}", random.one_of(&["1", "-1", "30", "-600"])),
        36 => format!("mode {}", random.one_of(&["once", "loop", "ping-pong"])),
        37 => format!("range {}", random.one_of(&["all", "1 2", "2 3", "1 4", "0 3"])),
        38 => format!("speed {}", random.one_of(&["10", "50", "100", "250", "1000"])),
        39 => format!("auto-key {}", random.one_of(&["on", "off"])),
        40 => format!("ghosts {}", random.one_of(&["0", "1", "2", "3"])),
        _ => random.one_of(&["eye sky", "eye robot1", "eye robot2", "put-control robot2", "seconds 1.5"]).to_owned(),
    }
}

fn scene_line(random: &mut Random) -> String {
    let control = "robot1/head_control";
    let channel = random.one_of(&CHANNELS);
    let [at, to] = [(); 2].map(|()| random.one_of(&TIMES));
    match random.below(9) {
        0 | 1 => format!("add-key {channel} {at} {control}"),
        2 | 3 => {
            let value = match channel {
                "translation" => random.one_of(&["0,1,0", "0.5,-2,3"]),
                "rotation" => random.one_of(&["90,0,0", "0,0,0.6,0.8", "10,20,30"]),
                _ => random.one_of(&["2", "1,2,0.5", "0"]),
            };
            format!("set-key {channel} {at} {value} {control}")
        }
        4 => format!("move-key {channel} {at} {to} {control}"),
        5 => format!("delete-key {channel} {at} {control}"),
        6 => format!("seconds {at}"),
        7 => "save-scene scene.json".to_owned(),
        _ => random.one_of(&["undo", "key ctrl+z", "do Hold timed keys", "wait 1s"]).to_owned(),
    }
}

/// Kinds of files, with the arguments that read them.
const KINDS: [(&str, &str); 22] = [
    ("keyframes 2", "check {}"),
    ("keyframes 4", "sample {} --at 0.5,1 --format csv"),
    ("named 2", "check {}"),
    ("json 2", "check {}"),
    ("rows 2", "convert {} -o out.json"),
    ("header 2", "convert {} -o out.json"),
    ("header 2", "convert {} -o out.json --salvage"),
    ("quaternion-first 2", "convert {} -o out.json"),
    ("frames 2", "convert {} -o out.json"),
    ("end 2", "convert {} -o out.json --salvage"),
    ("csv 2", "convert {} -o out.json"),
    ("csv 2", "convert {} -o out.json --salvage"),
    ("pairs 2", "convert {} -o out.json"),
    ("endless 2", "convert {} -o out.json"),
    ("two-lines 2", "convert {} -o out.json"),
    ("matrices 2", "convert {} -o out.json"),
    ("python", "convert {} -o out.json"),
    ("scene 1", "nodes --scene {}"),
    ("scene 2", "nodes --scene {}"),
    ("samples", "diagnose ../shared/good.json {}"),
    ("rubric", "grade {} ../shared/six.json -o graded --no-images"),
    ("settings", "settings {}"),
];

const PIECES: [&str; 22] = [
    "nan", "1e999", "-", "x", "9", "0.5", "\"\"", "[", "}", "", ",", ";", "inf", "null", "true", "\u{e9}", "{}",
    "1e40", "\t", "-0", "frame", "\u{0}",
];

fn file(seed: u64) -> Case {
    let mut random = Random(seed ^ 0x5eed);
    let (spec, run) = KINDS[usize::try_from(seed).expect("it is small") % KINDS.len()];
    let mut text = base(spec);
    for _ in 0..=random.below(2) {
        text = mutated(&mut random, &text);
    }
    let ending = if spec.starts_with("rubric") { ".json" } else { "" };
    let name = format!("mutated-{seed:03}-{}{ending}", spec.split(' ').next().unwrap_or_default());
    let mut case = Case::new(name, text.into_bytes(), run);
    if spec.starts_with("rubric") {
        case.with.push(("reference.json".to_owned(), base("keyframes 5").into_bytes()));
        case.with.push(("hotkeys.txt".to_owned(), base("hotkeys").into_bytes()));
    }
    case
}

/// A text with one change: a word or a line that is another one, is gone or stands twice, or an end that is missing.
fn mutated(random: &mut Random, text: &str) -> String {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    if lines.is_empty() {
        return random.one_of(&PIECES).to_owned();
    }
    let at = random.below(lines.len());
    let without = |at: usize| lines[..at].concat() + &lines[at + 1..].concat();
    match random.below(8) {
        0 => without(at),
        1 => lines[..at].concat() + lines[at] + &lines[at..].concat(),
        2 => text.chars().take(random.below(text.chars().count()) + 1).collect(),
        _ => {
            // A word of the line: what stands between blanks, brackets and commas.
            let line = lines[at];
            let is_edge = |letter: char| {
                letter.is_whitespace() || matches!(letter, ',' | '[' | ']' | ':' | '{' | '}' | ';' | '"')
            };
            let words: Vec<&str> = line.split(is_edge).filter(|word| !word.is_empty()).collect();
            if words.is_empty() {
                return without(at);
            }
            let word = words[random.below(words.len())];
            let start = word.as_ptr() as usize - line.as_ptr() as usize;
            let piece = random.one_of(&PIECES);
            format!(
                "{}{}{piece}{}{}",
                lines[..at].concat(),
                &line[..start],
                &line[start + word.len()..],
                lines[at + 1..].concat()
            )
        }
    }
}
