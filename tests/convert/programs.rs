//! Whole programs in Python, as students hand them in.

use std::f64::consts::PI;

use glam::{DQuat, Vec3};
use inbetween::scene::{Channel, KeyValue, SceneGraph, scene_from_json};
use inbetween::text_layouts::{GroupChoice, Imported, Options, import};

use super::samples::scene;

/// The scene and the report of the only group, or of the one of this number.
#[track_caller]
fn read(text: &str, group: Option<usize>) -> (SceneGraph, String) {
    let options = Options { group: choice(group), file_name: "viewer.py".to_owned(), ..Options::default() };
    match import(text.as_bytes(), &scene(), &options) {
        Ok(Imported::Scene(text, report)) => (scene_from_json(&text).unwrap(), report.to_string()),
        other => panic!("{text}\n{other:?}"),
    }
}

fn choice(group: Option<usize>) -> GroupChoice {
    group.map_or(GroupChoice::Only, GroupChoice::Number)
}

#[track_caller]
fn refusal(text: &str, group: Option<usize>) -> String {
    let options = Options { group: choice(group), ..Options::default() };
    import(text.as_bytes(), &scene(), &options).unwrap_err().to_string()
}

#[track_caller]
fn value(scene: &SceneGraph, channel: Channel, seconds: f64) -> KeyValue {
    scene.key_value_at(scene.find("keyed").unwrap(), channel, seconds).unwrap()
}

fn count(scene: &SceneGraph, channel: Channel) -> usize {
    scene.key_seconds(scene.find("keyed").unwrap(), channel).len()
}

fn translation(x: f32, y: f32, z: f32) -> KeyValue {
    KeyValue::Translation(Vec3::new(x, y, z))
}

fn scale(scale: f32) -> KeyValue {
    KeyValue::Scale(Vec3::splat(scale))
}

/// Euler angles in degrees about z, y and x, computed here.
fn euler(yaw: f64, pitch: f64, roll: f64) -> KeyValue {
    let about = |axis, degrees: f64| DQuat::from_axis_angle(axis, degrees * PI / 180.0);
    rotation(about(glam::DVec3::Z, yaw) * about(glam::DVec3::Y, pitch) * about(glam::DVec3::X, roll))
}

fn rotation(rotation: DQuat) -> KeyValue {
    KeyValue::Rotation(rotation.as_quat())
}

fn numbers(value: KeyValue) -> Vec<f32> {
    match value {
        KeyValue::Translation(vector) | KeyValue::Scale(vector) => vector.to_array().into(),
        KeyValue::Rotation(rotation) => rotation.to_array().into(),
        KeyValue::Colour(_) => panic!("not in these files"),
    }
}

/// Asserts that a value is another to within the rounding of single precision.
#[track_caller]
fn assert_near(found: KeyValue, expected: KeyValue, why: &str) {
    let (found, expected) = (numbers(found), numbers(expected));
    let is_near = found.len() == expected.len()
        && found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 2e-7 * b.abs().max(1.0));
    assert!(is_near, "{why}: {found:?}, not {expected:?}");
}

const VIEWER: &str = "\
#!/usr/bin/env python3
\"\"\"A bird, and what else is in a viewer: {0: vec(9, 9, 9)}.\"\"\"
import glfw
from core import Shader, Viewer, Node as N
from transform import vec, quaternion, quaternion_from_euler
from animation import KeyFrameControlNode

KEYS = {glfw.KEY_W: 'fly', glfw.KEY_S: 'sit'}
COLOURS = {1: 2, 3: 4}
names = [f'bird {i:{2}}' for i in range(3)]


class Bird(N):
    '''Flies.'''

    def __init__(self, shader, *, speed=1.0, **params):
        super().__init__(**params)
        # translate_keys = {0: vec(7, 7, 7)}
        translate_keys = {0: vec(0, 0, 0), 2: vec(1, 1, 0), 4: vec(0, 0, 0)}
        rotate_keys = {0: quaternion(), 2: quaternion_from_euler(0, 45, 90), 4: quaternion()}
        scale_keys = {0: 1, 2: 0.5, 4: 1}
        node = KeyFrameControlNode(translate_keys, rotate_keys, scale_keys)
        self.add(node)


class KeyFrameControlNode(N):
    def __init__(self, trans_keys, rot_keys, scale_keys, transform=None):
        super().__init__(transform=transform)
        self.keyframes = TransformKeyFrames(trans_keys, rot_keys, scale_keys)


def main():
    viewer = Viewer(1280, 720)
    shader = Shader('a.vert', 'a.frag')
    try:
        viewer.add(Bird(shader))
    except (KeyError, ValueError) as error:
        print(f\"no: {error!r:>10}\")
    finally:
        viewer.run()


if __name__ == '__main__':
    main()
";

#[test]
fn the_dictionaries_inside_a_viewer_are_read() {
    for text in
        [VIEWER.to_owned(), VIEWER.replace('\n', "\r\n"), VIEWER.replace("    ", "\t"), format!("\u{feff}{VIEWER}")]
    {
        let (scene, report) = read(&text, None);
        assert!(report.contains("note: line 19: one group of keys was found in viewer.py"), "{report}");
        assert_eq!(Channel::ALL.map(|channel| count(&scene, channel)), [3, 3, 3, 0]);
        assert_eq!(value(&scene, Channel::Translation, 2.0), translation(1.0, 1.0, 0.0));
        assert_eq!(value(&scene, Channel::Scale, 2.0), scale(0.5));
        assert_near(value(&scene, Channel::Rotation, 2.0), euler(0.0, 45.0, 90.0), "a viewer");
    }
    // Accents of another encoding stand in comments and texts.
    let bytes: Vec<u8> =
        VIEWER.replace("# trans", "# d\u{e9}j\u{e0}: trans").chars().map(|letter| letter as u8).collect();
    assert!(matches!(import(&bytes, &scene(), &Options::default()), Ok(Imported::Scene(..))));
}

/// Ways to write keys: the text, and a value at a time.
fn writings() -> Vec<(&'static str, Channel, f64, KeyValue)> {
    use Channel::{Rotation, Scale, Translation};
    let quarter = rotation(DQuat::from_rotation_y(PI / 2.0));
    vec![
        (
            "translate_keys = {0: np.array((1, 2, 3)), 2: np.array([0, 1, 0], 'f')}",
            Translation,
            0.0,
            translation(1.0, 2.0, 3.0),
        ),
        (
            "translate_keys = {0: numpy.array([1, 2, 3], dtype=np.float32)}",
            Translation,
            0.0,
            translation(1.0, 2.0, 3.0),
        ),
        ("translate_keys = {0: vec3(1, 2, 3), 1: glm.vec3(0, 0, 1)}", Translation, 1.0, translation(0.0, 0.0, 1.0)),
        ("translate_keys = {0: vec(*(1, 2, 3))}", Translation, 0.0, translation(1.0, 2.0, 3.0)),
        ("translate_keys = {pi: vec(pi, 0, 0)}", Translation, PI, translation(PI as f32, 0.0, 0.0)),
        (
            "translate_keys = {0: vec(math.pi, np.pi / 2, 0)}",
            Translation,
            0.0,
            translation(PI as f32, (PI / 2.0) as f32, 0.0),
        ),
        ("translate_keys = {2*pi/3: vec(0, 0, 0)}", Translation, 2.0 * PI / 3.0, translation(0.0, 0.0, 0.0)),
        (
            "rotate_keys = {0: quaternion_mul(quaternion_from_euler(0, 0, 90), quaternion_from_axis_angle((0, 1, 0), 90))}",
            Rotation,
            0.0,
            rotation(DQuat::from_rotation_x(PI / 2.0) * DQuat::from_rotation_y(PI / 2.0)),
        ),
        ("translate_keys = [(0, vec(0, 0, 0)), (2, vec(1, 1, 0))]", Translation, 2.0, translation(1.0, 1.0, 0.0)),
        ("translate_keys = ([0, (0, 0, 0)], [2, (1, 1, 0)])", Translation, 2.0, translation(1.0, 1.0, 0.0)),
        ("translate_keys = dict([(0, vec(0, 0, 0)), (2, vec(1, 1, 0))])", Translation, 2.0, translation(1.0, 1.0, 0.0)),
        ("translate_keys = dict({2: vec(1, 1, 0)})", Translation, 2.0, translation(1.0, 1.0, 0.0)),
        ("h = 2.5\ntranslate_keys = {0: vec(0, h, -h / 2)}", Translation, 0.0, translation(0.0, 2.5, -1.25)),
        (
            "scale_keys = {0: 2}\nkeynode = KeyFrameControlNode({0: vec(0, 1, 0)}, {}, scale_keys)\nkeynode.add(TexturedPyramid())",
            Scale,
            0.0,
            scale(2.0),
        ),
        (
            "KeyFrameControlNode({0: vec(0, 0, 0)}, {0: quaternion_from_euler(90, 0, 0)}, {0: 1, 2: 3})",
            Scale,
            2.0,
            scale(3.0),
        ),
        (
            "animation.TransformKeyFrames(rotate_keys={1: quaternion()}, scale_keys={0: 1}, translate_keys={3: vec(0, 5, 0)})",
            Translation,
            3.0,
            translation(0.0, 5.0, 0.0),
        ),
        (
            "def main():\n    h = 3\n    translate_keys = {0: vec(0, h, 0)}\n    viewer.run()",
            Translation,
            0.0,
            translation(0.0, 3.0, 0.0),
        ),
        (
            "translate_keys_sun = {0: vec(1, 0, 0)}\nrotate_keys_sun = {0: quaternion()}\nscale_keys_sun = {0: 4}",
            Scale,
            0.0,
            scale(4.0),
        ),
        (
            "translate_UFO = {0: vec(0, 0, 0), 20: vec(0.8,1,-.85)}\nrotate_UFO = {0: quaternion_from_euler(0,0,0)}\n\
             keynode = KeyFrameControlNode(translate_UFO,rotate_UFO,{0:1, 15:0.7})",
            Scale,
            15.0,
            scale(0.7),
        ),
        ("scale_keys = {0: 1, 10: 0}", Scale, 10.0, scale(1e-6)),
        ("scale_keys = {0: vec(2)}", Scale, 0.0, scale(2.0)),
        (
            "rotate_keys = {0: np.array((0.5, 0.5, -0.5, 0.5))}",
            Rotation,
            0.0,
            rotation(DQuat::from_xyzw(0.5, -0.5, 0.5, 0.5)),
        ),
        ("turns = {0: quaternion_from_axis_angle(axis=vec(0, 2, 0), radians=pi/2)}", Rotation, 0.0, quarter),
    ]
}

/// Arithmetic, names, and what was cut out of a program.
fn other_writings() -> Vec<(&'static str, Channel, f64, KeyValue)> {
    use Channel::{Rotation, Scale, Translation};
    vec![
        // Arithmetic.
        ("{0: 7 // 2 + 7 % 4 * 2**3 - -1}", Scale, 0.0, scale(28.0)),
        (
            "{0: 2 * vec(1, 2, 3) + vec(0, 1, 0) - (1, 1, 1) / vec(1, 2, 4)}",
            Translation,
            0.0,
            translation(1.0, 4.5, 5.75),
        ),
        ("{0: vec(sin(radians(30)), cos(math.pi), sqrt(abs(-4)))}", Translation, 0.0, translation(0.5, -1.0, 2.0)),
        (
            "p = vec(1, 2, 3)\ntranslate_keys = {0: p, 1: vec(p[2], p[0], 0)}",
            Translation,
            1.0,
            translation(3.0, 1.0, 0.0),
        ),
        (
            "rotate_keys = {0: -quaternion_from_euler(0, 180, 0)}",
            Rotation,
            0.0,
            rotation(DQuat::from_xyzw(0.0, -1.0, 0.0, 0.0)),
        ),
        // Names, and keys that come later.
        (
            "a, b = 1, 2\nx = y = {0: vec(a, b, 0)}\nKeyFrameControlNode(y, None, None)",
            Translation,
            0.0,
            translation(1.0, 2.0, 0.0),
        ),
        (
            "t: dict = {}\nt[0] = vec(0, 0, 1)\nt[4] = vec(0, 4, 0)\nKeyFrameControlNode(t, {}, {})",
            Translation,
            4.0,
            translation(0.0, 4.0, 0.0),
        ),
        ("t = []\nt.append((0, vec(0, 0, 1)))\nKeyFrameControlNode(t, {}, {0: 1})", Scale, 0.0, scale(1.0)),
        (
            "class A:\n    def __init__(self):\n        self.t = {0: vec(0, 0, 1)}\n        self.n = KeyFrameControlNode(self.t, {}, {})",
            Translation,
            0.0,
            translation(0.0, 0.0, 1.0),
        ),
        (
            "class A(KeyFrameControlNode):\n    def __init__(self):\n        super().__init__({0: vec(0, 0, 1)}, {}, {2: 3})",
            Scale,
            2.0,
            scale(3.0),
        ),
        (
            "for i in range(2):\n    n = KeyFrameControlNode({0: vec(0, 0, 1)}, {0: quaternion()}, {2: 3})",
            Scale,
            2.0,
            scale(3.0),
        ),
        ("viewer.add(KeyFrames({0: vec(0, 0, 1)}))", Translation, 0.0, translation(0.0, 0.0, 1.0)),
        (
            "with open('a') as f:\n    t = {0: vec(0, 0, 1)}\n    print(f'{f}')",
            Translation,
            0.0,
            translation(0.0, 0.0, 1.0),
        ),
        // Cut out of a program.
        ("translate_keys = {0: vec(0, 0, 1)}\n    scale_keys = {0: 2}", Scale, 0.0, scale(2.0)),
        ("    translate_keys = {0: vec(0, 0, 1)}\n    scale_keys = {0: 2}", Scale, 0.0, scale(2.0)),
        ("from a import *\n# keys\ntranslate_keys={0: (0, 0, 1)},\nscale_keys={0: 2}", Scale, 0.0, scale(2.0)),
        ("translate_keys = {0: vec(0, 0, 1)} scale_keys = {0: 2}", Scale, 0.0, scale(2.0)),
    ]
}

#[test]
fn every_way_to_write_keys_is_read() {
    for (text, channel, seconds, expected) in writings().into_iter().chain(other_writings()) {
        let (scene, _) = read(text, None);
        let times = scene.key_seconds(scene.find("keyed").unwrap(), channel);
        assert!(times.iter().any(|time| (time - seconds).abs() < 1e-6), "{text}: {times:?}");
        assert_near(value(&scene, channel, seconds), expected, text);
    }
}

#[test]
fn a_half_turn_has_no_negative_speck_for_its_w() {
    let (scene, _) = read(
        "rotate_keys = {0: quaternion_from_euler(180, 0, 0), 1: quaternion_from_axis_angle((1, 0, 0), 180)}",
        None,
    );
    for seconds in [0.0, 1.0] {
        let [.., w] = numbers(value(&scene, Channel::Rotation, seconds))[..] else { panic!("four numbers") };
        assert!(w >= 0.0, "{w}");
    }
}

const THREE: &str = "\
def main():
    sun = KeyFrameControlNode({0: vec(1, 0, 0)}, {0: quaternion()}, {0: 1})
    knight = KeyFrameControlNode(
        translate_keys={0: vec(0, camera.x + 3, 30)},
        rotate_keys={0: quaternion()}, scale_keys={0: 1})
    moon = KeyFrameControlNode({0: vec(3, 0, 0)}, {0: quaternion()}, {0: 1})
";

#[test]
fn of_several_groups_one_is_chosen() {
    assert_eq!(
        refusal(THREE, None),
        "line 2 column 31: there are 3 groups of keys, expected --group with the number of one: 1 in line 2 (main.sun); \
         2 in line 4 (main.knight, which cannot be read); 3 in line 6 (main.moon)"
    );
    let (scene, report) = read(THREE, Some(3));
    assert_eq!(value(&scene, Channel::Translation, 0.0), translation(3.0, 0.0, 0.0));
    assert!(report.contains("note: line 6: group 3 of 3 groups of keys that were found in viewer.py"), "{report}");
    assert!(
        report.contains("warning: group 2 is left out: line 4 column 35: \"camera.x + 3\" is known only when"),
        "{report}"
    );
    assert!(
        refusal(THREE, Some(2)).starts_with("line 4 column 35: \"camera.x + 3\" is known only when the program runs")
    );
    for group in [0, 4] {
        let sentence = refusal(THREE, Some(group));
        assert!(
            sentence.contains(&format!("there is no group {group}, expected --group with the number of one: 1 in")),
            "{sentence}"
        );
    }
    // The only whole one needs no choice.
    let (whole, _) = read(&THREE.replace("vec(3, 0, 0)", "keys[i]"), None);
    assert_eq!(value(&whole, Channel::Translation, 0.0), translation(1.0, 0.0, 0.0));
    let first = Options::of_keyframes();
    assert!(matches!(import(THREE.as_bytes(), &super::samples::scene(), &first), Ok(Imported::Scene(..))));
    // Dictionaries without a call are told apart by their names, and by the second of a kind.
    for (text, groups) in [
        ("translate_a = {0: vec(0, 0, 0)}\ntranslate_b = {0: vec(1, 0, 0)}\nscale_a = {0: 1}\nscale_b = {0: 2}", 2),
        ("{0: 1}\n{0: 2}\n{0: 3}", 3),
        ("t = {0: vec(0, 0, 0)}\ndef f():\n    t = {0: vec(1, 0, 0)}", 2),
        (&"translate_keys = {0: vec(0, 0, 0)}\n".repeat(30), 30),
    ] {
        assert!(refusal(text, None).contains(&format!("there are {groups} groups of keys")), "{text}");
    }
    assert!(refusal(&"translate_keys = {0: vec(0, 0, 0)}\n".repeat(30), None).ends_with("; and 10 more"));
}

#[test]
fn what_is_known_only_when_the_program_runs_is_refused() {
    let node = |keys: &str| format!("KeyFrameControlNode({keys}, {{0: quaternion()}}, {{0: 1}})");
    for (before, keys, found) in [
        ("", "{0: vec(camera.x, 0, 0)}", "camera.x"),
        ("", "{0: vec(camera.height() + 3, 0, 0)}", "camera.height() + 3"),
        ("", "keys[i]", "keys[i]"),
        ("", "make_keys()", "make_keys()"),
        ("", "{i: vec(i, 0, 0) for i in range(4)}", "{i: vec(i, 0, 0) for i in range(4)}"),
        ("", "{0: vec(0, 0, 0), **others}", "others"),
        ("", "{0: vec(0, 0, 0) if x else vec(1, 0, 0)}", "vec(0, 0, 0) if x else vec(1, 0, 0)"),
        ("", "{0: (1, 2) + (3,)}", "(1, 2) + (3,)"),
        ("t = {}\nfor i in range(4):\n    t[i] = vec(i, 0, 0)\n", "t", "t[i]"),
        ("t = {0: vec(0, 0, 0)}\nt.update(others)\n", "t", "t.update(others)"),
        ("h = 1\nfor i in range(4):\n    h += 1\n", "{0: vec(h, 0, 0)}", "h"),
        ("h = 1\nif x:\n    h = 2\n", "{0: vec(h, 0, 0)}", "h"),
        ("h = 1\ndef f():\n    global h\n    h = 2\n", "{0: vec(h, 0, 0)}", "h"),
        ("h = input()\n", "{0: vec(h, 0, 0)}", "h"),
        ("math = other()\n", "{0: vec(math.pi, 0, 0)}", "math.pi"),
        ("i = 1\nx = [i for i in y]\n", "{0: vec(i, 0, 0)}", "i"),
    ] {
        let sentence = refusal(&format!("import a\n{before}{}", node(keys)), None);
        assert!(
            sentence.contains(&format!(": {found:?} is known only when the program runs")),
            "{before}{keys}: {sentence}"
        );
    }
    // These are no keys, whatever is not known of them.
    for text in [
        "positions = []\nfor x in y:\n    positions.append((x, 1))",
        "KEYS = {glfw.KEY_W: 'up'}\nsizes = {}\nsizes[x] = y",
        "class A(Node):\n    def __init__(self, shader):\n        super().__init__(shader, {'a': 1}, [(0, 1)], {})",
        "class A(Node):\n    def __init__(self, t, r, s):\n        self.keys = TransformKeyFrames(t, r, s)",
        "def f():\n    faces = {0: (0, 1, 2), 1: (2, 3, 0)}\n    rows = [(0, 1), (2, 3)]",
        "print({1: 2})\ndef f(x={1: 2}):\n    pass",
        "node = KeyFrameControlNode({}, {}, {})",
        "node = KeyFrameControlNode(*random_keys())",
        "# translate_keys = {0: vec(0, 0, 0)}\n'''translate_keys = {0: vec(0, 0, 0)}'''",
    ] {
        let sentence = import(text.as_bytes(), &scene(), &Options::default()).unwrap_err().to_string();
        assert!(sentence.contains("the program has no keys"), "{text}: {sentence}");
    }
    // A name that a function uses stands for what the module gave it, unless it gave it two values.
    let function = "\ndef f():\n    return KeyFrameControlNode({0: vec(h, 0, 0)}, {}, {})\n";
    assert_eq!(
        value(&read(&format!("h = 2{function}"), None).0, Channel::Translation, 0.0),
        translation(2.0, 0.0, 0.0)
    );
    assert!(refusal(&format!("h = 2{function}h = 3"), None).contains("\"h\" is known only when"));
    assert!(refusal("h = 2\ndef g(h):\n    return {0: vec(h, 0, 0)}", None).contains("\"h\" is known only when"));
}

#[test]
fn deep_and_long_programs_need_no_more_than_the_stack() {
    let deep = 100_000;
    let nested =
        |open: &str, inside: &str, close: &str| format!("x = {}{inside}{}", open.repeat(deep), close.repeat(deep));
    for text in [
        nested("(", "1", ")"),
        nested("[", "", ""),
        nested("{0: ", "1", "}"),
        nested("f(", "1", ")"),
        nested("-", "1", ""),
        nested("not ", "1", ""),
        nested("2**", "1", ""),
        nested("1 + ", "1", ""),
        nested("a.", "a", ""),
        nested("a", "", "()"),
        nested("a", "", "[0]"),
        nested("lambda a, b: ", "1", ""),
        nested("(yield 1, ", "1", ""),
        nested("yield 1, yield 1, ", "1", ""),
        nested("a if b else ", "1", ""),
        nested("f\"{", "1", "}\""),
        nested("await ", "1", ""),
        format!("x = 1\n{}", "if a: ".repeat(deep)),
        format!("x = 1\n{}", "class A: ".repeat(deep)),
        (0..1000).fold("x = 1\n".to_owned(), |text, depth| text + &" ".repeat(depth) + "if a:\n"),
    ] {
        let sentence = refusal(&text, None);
        let is_told = sentence.contains("nests too deep") || sentence.contains(", expected ");
        assert!(is_told, "{}: {sentence}", &text[..40]);
    }
    // As deep as is allowed.
    for text in [
        nested_to(199, "(", "1", ")"),
        nested_to(95, "f(-a.b[", "1", "])"),
        nested_to(700, "1 + ", "1", ""),
        nested_to(1400, "-", "1", ""),
        nested_to(600, "lambda: ", "1", ""),
        nested_to(280, "a if b else ", "1", ""),
        (0..100).fold(String::new(), |text, depth| text + &" ".repeat(depth) + "if a:\n")
            + &" ".repeat(100)
            + "f(((((1)))))",
    ] {
        assert!(refusal(&text, None).contains("the program has no keys"), "{}: {}", &text[..40], refusal(&text, None));
    }
    // Many things side by side are no depth.
    let flat = format!("x = [{}]\ny = f(\n{})\nelse_ = 1\n", "1, ".repeat(20_000), "'a'\n".repeat(5_000));
    assert!(refusal(&flat, None).contains("the program has no keys"));
}

fn nested_to(depth: usize, open: &str, inside: &str, close: &str) -> String {
    format!("x = {}{inside}{}", open.repeat(depth), close.repeat(depth))
}
