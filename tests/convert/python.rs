//! Python dictionaries of keys, to a scene with a control node.

use glam::{Quat, Vec3};
use inbetween::rotation_rules::rotation_from_euler_degrees;
use inbetween::scene::{Channel, KeyValue, SceneGraph, scene_from_json};
use inbetween::text_layouts::{Imported, Options, import};

use super::refusal;
use super::samples::{PYTHON, scene};

/// The scene that a text of keys becomes.
struct Keyed(SceneGraph);

#[track_caller]
fn keys(text: &str) -> Keyed {
    match import(text.as_bytes(), &scene(), &Options::default()) {
        Ok(Imported::Scene(text, _)) => Keyed(scene_from_json(&text).unwrap()),
        other => panic!("{other:?}"),
    }
}

impl Keyed {
    fn count(&self, channel: Channel) -> usize {
        self.0.key_seconds(self.0.find("keyed").unwrap(), channel).len()
    }

    fn value(&self, channel: Channel, seconds: f64) -> KeyValue {
        self.0.key_value_at(self.0.find("keyed").unwrap(), channel, seconds).unwrap()
    }

    fn rotation(&self, seconds: f64) -> Quat {
        match self.value(Channel::Rotation, seconds) {
            KeyValue::Rotation(rotation) => rotation,
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn all_three_kinds() {
    for text in [PYTHON.to_owned(), PYTHON.replace('\n', "\r\n"), format!("\u{feff}{PYTHON}")] {
        let keys = keys(&text);
        let translation = |seconds| keys.value(Channel::Translation, seconds);
        assert_eq!(translation(1.0), KeyValue::Translation(Vec3::new(0.5, 0.5, 0.0)));
        assert_eq!(translation(9.0), KeyValue::Translation(Vec3::new(0.0, -0.85, 0.0)));
        assert!(keys.rotation(2.0).dot(rotation_from_euler_degrees([180.0, 45.0, 90.0])).abs() > 0.999_999);
        assert!(keys.rotation(3.0).dot(Quat::from_rotation_y(std::f32::consts::FRAC_PI_2)).abs() > 0.999_999);
        assert_eq!(keys.rotation(4.0), Quat::from_xyzw(0.0, 0.0, 0.6, 0.8));
        assert_eq!(keys.value(Channel::Scale, 2.0), KeyValue::Scale(Vec3::new(0.5, 1.0, 2.0)));
        assert_eq!(keys.count(Channel::Scale), 3);
    }
}

#[test]
fn a_dictionary_without_a_name_is_told_by_its_values() {
    assert_eq!(keys("{0: vec(0, 0, 0), 2: vec(1, 1, 0)}").count(Channel::Translation), 2);
    assert_eq!(keys("{ 0 : 1, 2: .5, }").value(Channel::Scale, 2.0), KeyValue::Scale(Vec3::splat(0.5)));
    assert_eq!(keys("{0: quaternion(), -1: quaternion(w=1)}").count(Channel::Rotation), 2);
    assert_eq!(keys("translate_keys={0: (0, 1, 2), 1: [0, 1, 2]}, scale_keys={}").count(Channel::Translation), 2);
    let radians = keys("{0: quaternion_from_axis_angle((0, 0, 2), radians=1.5707963)}").rotation(0.0);
    assert!(radians.dot(Quat::from_rotation_z(std::f32::consts::FRAC_PI_2)) > 0.999_999);
}

#[test]
fn what_is_wrong_has_its_place() {
    for (text, sentence) in [
        ("{0: vec(0, 0)}", "line 1 column 5: found \"vec(0, 0)\", expected a translation, as in vec(0, 1, 0)"),
        (
            "translate_keys = {0: vec(1, 2, 3, 4, 5)}",
            "line 1 column 22: found \"vec(1, 2, 3, 4, 5)\", expected numbers, as in vec(0, 1, 0)",
        ),
        ("{0: vec(0, 0, 0),\n 0.0: vec(1, 0, 0)}", "line 2 column 2: a second key at 0 s, expected one at each time"),
        ("{0: vec(0, nan, 0)}", "line 1 column 12: \"nan\" is not finite, expected a number"),
        ("{0: vec(0, 1e999, 0)}", "line 1 column 12: \"1e999\" is not finite, expected a number"),
        ("{0: vec(0, 1 / 0, 0)}", "line 1 column 12: \"1 / 0\" is not finite, expected a number"),
        (
            "{0: vec(0, 1e99, 0)}",
            "line 1 column 5: found \"vec(0, 1e99, 0)\", expected coordinates between -1e6 and 1e6",
        ),
        ("{0: 1, 1: -1}", "line 1 column 11: found \"-1\", expected a scale from 0 to 1e6"),
        (
            "{0: quaternion(1, 1, 0, 0)}",
            "line 1 column 5: found \"quaternion(1, 1, 0, 0)\", expected x, y, z and w of a unit quaternion",
        ),
        ("{0: (1, 1, 0, 0)}", "line 1 column 5: found \"(1, 1, 0, 0)\", expected w, x, y and z of a unit quaternion"),
        (
            "{0: quaternion(), 1: 2}",
            "line 1 column 22: found \"2\", expected a rotation: quaternion, quaternion_from_euler or quaternion_from_axis_angle",
        ),
        ("scale_keys = {'a': 1}", NO_KEYS),
        ("scale_keys = {}", NO_KEYS),
        ("x = 1", NO_KEYS),
        (
            "translate_keys = {0: vec(camera.x + 3, 0, 30)}",
            "line 1 column 26: \"camera.x + 3\" is known only when the program runs, expected numbers, or calls such as vec(0, 1, 0) \
             and quaternion_from_euler(0, 90, 0)",
        ),
        // What is no Python.
        ("{0: vec(0, 0, 0) 1: vec(0, 0, 0)}", "line 1 column 18: found \"1: vec(0, 0, 0)}\", expected \",\""),
        ("def main()\n    pass", "line 1 column 11: found the end of the line, expected \":\""),
        ("{0: lambda()}", "line 1 column 11: found \"()}\", expected \":\""),
        ("x = 1\n2 = x", "line 2 column 1: found \"2 = x\", expected valid Python"),
        ("x = 'a\ny = 1", "line 1 column 5: found \"'a\", expected a closing quotation mark"),
        ("x =", "line 1 column 4: found the end of the file, expected a value"),
        ("{0: vec(0, 0, 0)", "line 1 column 17: found the end of the file, expected a closing bracket"),
    ] {
        assert_eq!(refusal(text), sentence, "{text}");
    }
    let many = "{0: 1".to_owned() + &", 0: 1".repeat(20_000);
    assert!(refusal(many.clone() + "}").contains("more than 20000 keys"));
    assert!(refusal(many).contains("expected a closing bracket"));
    assert!(refusal(format!("x = {{0: \"{}\"}}", "a".repeat(5 << 20))).contains("at most 4 MiB"));
}

const NO_KEYS: &str = "line 1 column 1: the program has no keys, expected dictionaries such as translate_keys = {0: vec(0, 0, 0), 2: vec(1, 1, 0)}";
