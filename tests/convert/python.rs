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
        ("{0: vec(0, 0)}", "line 1 column 5: found \"vec(0, 0)}\", expected a translation, as in vec(0, 1, 0)"),
        (
            "{0: vec(0, 0, 0) 1: vec(0, 0, 0)}",
            "line 1 column 18: found \"1: vec(0, 0, 0)}\", expected \",\" or \"}\" after the value",
        ),
        ("{0: vec(0, 0, 0),\n 0.0: vec(1, 0, 0)}", "line 2 column 2: a second key at 0 s, expected one at each time"),
        ("{0: vec(0, nan, 0)}", "line 1 column 12: \"nan\" is not finite, expected a number"),
        ("{0: vec(0, 1e99, 0)}", "line 1 column 12: \"1e99\" is not finite, expected a number"),
        ("{0: vec(0, 0, 0)", "line 1 column 17: found the end of the file, expected \",\" or \"}\" after the value"),
        ("{0: 1, 1: 0}", "line 1 column 11: found \"0}\", expected a scale above 0, at most 1e6"),
        (
            "{0: quaternion(1, 1, 0, 0)}",
            "line 1 column 5: found \"quaternion(1, 1, 0, 0)}\", expected x, y, z and w of a unit quaternion",
        ),
        (
            "{0: quaternion(), 1: 2}",
            "line 1 column 22: found \"2}\", expected a rotation: quaternion, quaternion_from_euler or quaternion_from_axis_angle",
        ),
        (
            "keys = {0: 1}",
            "line 1 column 1: found \"keys = {0: 1}\", expected translate_keys, rotate_keys or scale_keys",
        ),
        (
            "scale_keys = {}",
            "line 1 column 16: found the end of the file, expected translate_keys, rotate_keys or scale_keys with at least one key",
        ),
        (
            "{0: lambda()}",
            "line 1 column 5: found \"lambda()}\", expected vec, quaternion, quaternion_from_euler, quaternion_from_axis_angle, or a number",
        ),
        (
            "{0: 1}\n{0: 2}",
            "line 2 column 1: found a second dictionary of the same kind, expected one each of translate_keys, rotate_keys and scale_keys",
        ),
    ] {
        assert_eq!(refusal(text), sentence);
    }
    assert!(refusal(format!("{{0: {}", "(".repeat(1_000_000))).contains("fewer parentheses"));
    let many = "{0: 1".to_owned() + &", 0: 1".repeat(20_000);
    assert!(refusal(many).contains("more than 20000 keys"));
}
