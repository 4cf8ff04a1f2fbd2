//! The JSON Schemas say what the program reads: they take every sample file, and nothing that the program's reader refuses for its form.

use std::fs;
use std::path::Path;

use boon::{Compiler, SchemaIndex, Schemas};
use inbetween::grading::{Overrides, Rubric};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{Easing, keyframes_from_json};
use inbetween::pose_file::{PoseFile, shipped_poses};
use inbetween::references::read_list;
use inbetween::scene::{SceneGraph, scene_from_json};
use inbetween::settings::{Settings, ThemeChoice, WindowPlace};
use inbetween::words::Language;
use serde_json::{Value, json};

fn asset(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets").join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn schema(name: &str) -> Value {
    serde_json::from_str(&asset(&format!("schemas/{name}.schema.json"))).unwrap()
}

/// A compiled schema.
struct Validator {
    schemas: Schemas,
    index: SchemaIndex,
}

impl Validator {
    /// Why a value does not fit; `None` if it does.
    fn problem(&self, value: &Value) -> Option<String> {
        self.schemas.validate(value, self.index).err().map(|error| error.to_string())
    }

    fn is_valid(&self, value: &Value) -> bool {
        self.problem(value).is_none()
    }
}

/// Compiling checks the schema against that of schemas.
fn validator(name: &str) -> Validator {
    let address = format!("http://localhost/{name}.schema.json");
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    compiler.add_resource(&address, schema(name)).unwrap();
    let index = compiler.compile(&address, &mut schemas).unwrap_or_else(|error| panic!("{name}: {error}"));
    Validator { schemas, index }
}

fn value(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

fn scene(name: &str) -> SceneGraph {
    scene_from_json(&asset(&format!("scenes/{name}.json"))).unwrap()
}

/// A reader of the program: whether it takes a text.
type Reader = Box<dyn Fn(&str) -> bool>;

fn reader_of_keyframes(scene: &str) -> Reader {
    let scene = self::scene(scene);
    Box::new(move |text| keyframes_from_json(text.as_bytes(), &scene).is_ok())
}

fn reader_of_scenes() -> Reader {
    Box::new(|text| scene_from_json(text).is_ok())
}

fn reader_of_settings() -> Reader {
    Box::new(|text| Settings::from_json(text.as_bytes()).is_ok())
}

fn reader_of_poses() -> Reader {
    Box::new(|text| PoseFile::from_json(text.as_bytes()).is_ok())
}

fn reader_of_pictures() -> Reader {
    let folder = tempfile::tempdir().unwrap();
    Box::new(move |text| {
        let path = folder.path().join("pictures.json");
        fs::write(&path, text).unwrap();
        read_list(&path).is_ok()
    })
}

/// Every changed copy of a value, with whether it has a field that no format has. Of long arrays only the start is changed.
fn changes(value: &Value) -> Vec<(Value, bool)> {
    let mut changed = Vec::new();
    match value {
        Value::Object(fields) => {
            let with = |name: &str, field: Option<Value>| {
                let mut fields = fields.clone();
                match field {
                    Some(field) => fields.insert(name.to_owned(), field),
                    None => fields.remove(name),
                };
                Value::Object(fields)
            };
            changed.push((with("no such field", Some(json!(1))), true));
            for (name, field) in fields {
                changed.push((with(name, None), false));
                let inner = changes(field).into_iter();
                changed.extend(inner.map(|(field, is_unknown)| (with(name, Some(field)), is_unknown)));
            }
        }
        Value::Array(items) => {
            changed.push((Value::Array(items.iter().skip(1).cloned().collect()), false));
            for at in 0..items.len().min(3) {
                changed.extend(changes(&items[at]).into_iter().map(|(item, is_unknown)| {
                    let mut items = items.clone();
                    items[at] = item;
                    (Value::Array(items), is_unknown)
                }));
            }
        }
        _ => {}
    }
    let others = [json!(true), json!("\u{1}/"), json!(-3), json!(1e7), json!([]), json!([1]), json!({"a": 1})];
    // The readers also take an object's values as an array, in the order of fields. No one writes that, and no schema allows it.
    let others = others.into_iter().filter(|other| !(value.is_object() && other.is_array()));
    changed.extend(others.map(|other| (other, false)));
    changed
}

/// The start of a text, for a message.
fn start(text: &str) -> String {
    text.chars().take(400).collect()
}

/// The schema takes the sample, and of its changed copies none that the reader would not refuse for its form.
#[track_caller]
fn check(schema: &str, text: &str, reads: &Reader) {
    let validator = validator(schema);
    let sample = value(text);
    assert_eq!(validator.problem(&sample), None, "{schema} refuses a sample");
    assert!(reads(text));
    let (mut refused, mut count) = (0, 0);
    for (changed, has_unknown_field) in changes(&sample) {
        let text = changed.to_string();
        let (is_valid, is_read) = (validator.is_valid(&changed), reads(&text));
        assert!(is_valid || !is_read, "{schema} refuses what the program reads: {}", start(&text));
        // A field without a meaning is refused, but for maps whose names are free.
        assert!(!has_unknown_field || is_valid == is_read, "{schema} takes a field that is not read: {}", start(&text));
        refused += usize::from(!is_valid);
        count += 1;
    }
    assert!(refused * 2 > count, "{schema} refuses only {refused} of {count} changed copies");
}

#[test]
fn keyframe_files() {
    for name in ["handshake", "walk", "wave"] {
        let mut sample = value(&asset(&format!("animations/{name}.json")));
        // One keyframe is changed as another is.
        sample["keyframes"].as_array_mut().unwrap().truncate(2);
        check("keyframes", &sample.to_string(), &reader_of_keyframes("two-robots"));
        assert!(validator("keyframes").is_valid(&value(&asset(&format!("animations/{name}.json")))));
    }
    check("keyframes", &asset("animations/orbits-tour.json"), &reader_of_keyframes("orbits"));
    assert!(validator("keyframes").is_valid(&value(&asset("grading/reference.json"))));
}

#[test]
fn keyframe_files_of_version_2() {
    let mut sample = value(&asset("animations/wave.json"));
    sample["version"] = json!(2);
    for (at, easing) in Easing::all().enumerate() {
        let keyframe = &mut sample["keyframes"][at % 2];
        keyframe["name"] = json!("a name");
        keyframe["duration"] = json!(1.5);
        keyframe["easing"] = json!(easing.name());
        assert!(validator("keyframes").is_valid(&sample), "{}", easing.name());
    }
    sample["version"] = json!(1);
    assert!(!validator("keyframes").is_valid(&sample));
}

#[test]
fn scene_files() {
    assert!(validator("scene").is_valid(&value(&asset("scenes/orbits.json"))));
    for name in ["cylinder", "two-robots"] {
        check("scene", &asset(&format!("scenes/{name}.json")), &reader_of_scenes());
    }
    let mut wrong = value(&asset("scenes/cylinder.json"));
    wrong["nodes"][2]["scale"] = json!(2);
    assert!(!validator("scene").is_valid(&wrong), "a control node has a scale");
    let mut hidden = value(&asset("scenes/cylinder.json"));
    hidden["version"] = json!(2);
    hidden["nodes"][2]["in_paths"] = json!(false);
    assert!(validator("scene").is_valid(&hidden));
    let mut joint = value(&asset("scenes/cylinder.json"));
    joint["version"] = json!(3);
    joint["nodes"][0]["stands"] = json!(true);
    assert!(!validator("scene").is_valid(&joint), "what stands has no end");
    joint["nodes"][0]["reach"] = json!([0, 1, 0]);
    assert!(validator("scene").is_valid(&joint));
    joint["nodes"][2]["reach"] = json!([0, 1, 0]);
    assert!(!validator("scene").is_valid(&joint), "a control node reaches");
}

#[test]
fn poses() {
    for pose in [2, 5] {
        check("pose", &shipped_poses()[pose].to_json(), &reader_of_poses());
    }
}

#[test]
fn settings() {
    let mut settings =
        Settings { theme: ThemeChoice::Light, language: Language::of_code("ko").unwrap(), ..Settings::default() };
    settings.keys.insert("New keyframe".to_owned(), vec!["Ctrl+K".to_owned(), "n".to_owned()]);
    settings.used(Path::new("folder/걷기.json"));
    settings.resized("side", Some(300.0));
    settings.window = Some(WindowPlace::new([900.0, 600.0], Some([-3, 40])));
    check("settings", &settings.to_json(), &reader_of_settings());
}

#[test]
fn lists_of_pictures() {
    let list = json!({
        "format": "inbetween.pictures", "version": 1,
        "defaults": {"file": "wave.json", "fps": 25, "size": [64, 48], "tolerance": 0.1, "scene": "cylinder", "samples": 4,
                     "seconds": 1.5, "interpolation": "linear", "camera": "turntable"},
        "pictures": [
            {"name": "at", "at": [0, 0.5], "file": "a/b.json", "size": [32, 24]},
            {"name": "film", "frames": "0-50:10", "fps": 5, "tolerance": 0.5, "samples": 1, "interpolation": "catmull-rom"},
            {"name": "key", "keyframe": 3, "reference": "third.png", "camera": "sky", "seconds": 2, "scene": "cylinder"},
            {"name": "rest", "file": null},
        ],
    });
    check("pictures", &list.to_string(), &reader_of_pictures());
}

/// A value without null as TOML writes it within a line.
fn toml(value: &Value) -> String {
    match value {
        Value::Object(fields) => {
            let fields = fields.iter().map(|(name, value)| format!("{} = {}", json!(name), toml(value)));
            format!("{{{}}}", fields.collect::<Vec<_>>().join(", "))
        }
        Value::Array(items) => format!("[{}]", items.iter().map(toml).collect::<Vec<_>>().join(", ")),
        other => other.to_string(),
    }
}

#[test]
fn overrides() {
    let rubric = json!({"format": "inbetween.rubric", "version": 1, "points": {"readable": 5, "linear_playback": 20}, "late": {}});
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rubric.json");
    fs::write(&path, rubric.to_string()).unwrap();
    let rubric = Rubric::load(&path, &scene("two-robots")).unwrap();
    let reads: Reader = Box::new(move |text| {
        let Value::Object(fields) = value(text) else { return false };
        let lines = fields.iter().map(|(name, value)| format!("{} = {}", json!(name), toml(value)));
        let text = lines.collect::<Vec<_>>().join("\n");
        Overrides::read(Path::new("overrides.toml"), text.as_bytes(), &rubric).is_ok()
    });
    let sample = json!({"format": "inbetween.overrides", "version": 1, "students": {
        "00420": {"points": {"readable": 2.5, "linear_playback": 0}, "comment": "Shown to me.", "late_days": 2},
    }});
    check("overrides", &sample.to_string(), &reads);
}

#[test]
fn rubrics() {
    let validator = validator("rubric");
    let sample = value(&asset("grading/rubric.json"));
    assert!(validator.is_valid(&sample));
    let toml: Value = toml::from_str(&asset("grading/rubric.toml")).unwrap();
    assert_eq!(toml, sample);
    let mut partial = sample.clone();
    partial["bands"] = json!([{"translation": 0.01, "rotation_degrees": 1, "share": 0.5}]);
    for switch in ["share_of_frames", "follow_through", "align_keyframes"] {
        partial[switch] = json!(true);
    }
    assert!(validator.is_valid(&partial));
    partial["bands"][0]["share"] = json!(1);
    assert!(!validator.is_valid(&partial));
    let free = json!({"format": "inbetween.rubric", "version": 1, "points": {"linear_playback": 1}});
    assert!(validator.is_valid(&free));
    let mut assumed = free.clone();
    assumed["playback"] = json!("assumed");
    assert!(!validator.is_valid(&assumed));
    let broken: [(&str, Value); 10] = [
        ("/playback", json!("played")),
        ("/samples_per_interval", json!(-1)),
        ("/format", json!("inbetween.rubrics")),
        ("/version", json!(2)),
        ("/fps", json!(0)),
        ("/fps", json!(2.5)),
        ("/tolerances/translation", json!(-1)),
        ("/points/readable", json!("10")),
        ("/points", json!({"readabel": 1})),
        ("/script", Value::Null),
    ];
    for (pointer, with) in broken {
        let mut changed = sample.clone();
        *changed.pointer_mut(pointer).unwrap() = with;
        assert!(!validator.is_valid(&changed), "{pointer}: {}", changed.pointer(pointer).unwrap());
    }
    for missing in ["format", "version", "reference", "points", "script"] {
        let mut changed = sample.clone();
        changed.as_object_mut().unwrap().remove(missing);
        assert!(!validator.is_valid(&changed), "{missing} is missing");
    }
}

#[test]
fn requirements_of_rubrics() {
    let validator = validator("rubric");
    let rubric = |points: Value, requirements: Value| json!({"format": "inbetween.rubric", "version": 1, "points": points, "requirements": requirements});
    let points = json!({"minimum_keyframes": 1, "minimum_nodes_moved": 1, "uses_catmull_rom": 1, "above_ground": 1, "no_jumps": 1,
        "script_runs": 1});
    let numbers = json!({"minimum_keyframes": 8, "minimum_nodes_moved": 4, "lowest_y": -2.05, "largest_step": 0.5,
        "largest_step_degrees": 30});
    assert_eq!(validator.problem(&rubric(points.clone(), numbers.clone())), None);
    assert!(validator.is_valid(&rubric(points.clone(), json!({}))));
    for (name, number) in numbers.as_object().unwrap() {
        assert!(validator.is_valid(&rubric(points.clone(), json!({name: number}))), "{name}");
        assert!(!validator.is_valid(&rubric(json!({"readable": 1}), json!({name: number}))), "{name} without points");
        for wrong in [json!("8"), json!(1e7)] {
            assert!(!validator.is_valid(&rubric(points.clone(), json!({name: wrong}))), "{name}: {wrong}");
        }
    }
}

#[test]
fn names_are_the_programs() {
    let names = |schema: &Value, pointer: &str| -> Vec<String> {
        serde_json::from_value(schema.pointer(pointer).unwrap().clone()).unwrap()
    };
    let keyframes = schema("keyframes");
    let easings: Vec<&str> = Easing::all().map(Easing::name).collect();
    assert_eq!(names(&keyframes, "/$defs/keyframe/properties/easing/enum"), easings);
    assert_eq!(names(&keyframes, "/properties/interpolation/enum"), Interpolation::ALL.map(Interpolation::name));
    let settings = schema("settings");
    let themes = ThemeChoice::ALL.map(|theme| serde_json::to_value(theme).unwrap());
    assert_eq!(settings.pointer("/properties/theme/enum").unwrap(), &json!(themes));
}
