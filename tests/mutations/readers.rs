//! Every reader, with good inputs, and with what is true of whatever it gives.

use std::fs;
use std::path::Path;

use inbetween::diagnosis::{Listing, Sequence, diagnose, samples_from_csv};
use inbetween::grading::{Marks, Parsed, Rubric, Submission};
use inbetween::journal;
use inbetween::keyframe::{Keyframe, KeyframeFile, keyframes_from_json};
use inbetween::picture::{Image, png_size};
use inbetween::references::read_list;
use inbetween::scene::{SceneGraph, scene_from_json, scene_to_json};
use inbetween::script;
use inbetween::settings::Settings;
use inbetween::text_layouts::{FieldOrder, GroupChoice, Imported, JointList, Options, import};

use super::{originals, samples};

/// Reads an input.
pub type Read = Box<dyn Fn(&[u8])>;

/// A reader of one kind of input.
pub struct Reader {
    pub name: &'static str,
    pub originals: Vec<Vec<u8>>,
    /// Reads an input, and checks what came of it.
    pub read: Read,
    /// The most bytes that reading may take, the input's own among them.
    pub most_bytes: fn(&[u8]) -> usize,
    /// The most allocations for each byte of the input.
    pub most_steps_per_byte: usize,
}

/// What a text may take: three times its size, and 16 MiB.
fn of_text(bytes: &[u8]) -> usize {
    3 * bytes.len() + (16 << 20)
}

/// What a zip may take: its bound of 64 MiB, the last file of 16 MiB in a buffer of twice that, and what a text takes.
fn of_zip(bytes: &[u8]) -> usize {
    (64 << 20) + (32 << 20) + of_text(bytes)
}

/// What a PNG may take: 20 bytes a pixel and one MiB, and what a text takes.
fn of_png(bytes: &[u8]) -> usize {
    let [width, height] = png_size(bytes).unwrap_or_default().map(|side| side as usize);
    20 * width * height + (1 << 20) + of_text(bytes)
}

fn text(name: &'static str, originals: Vec<Vec<u8>>, read: impl Fn(&[u8]) + 'static) -> Reader {
    Reader { name, originals, read: Box::new(read), most_bytes: of_text, most_steps_per_byte: 8 }
}

/// All of them. Those that read a file get one in a folder that is kept.
pub fn all() -> Vec<Reader> {
    let scene: &'static SceneGraph = Box::leak(Box::new(samples::scene()));
    let folder: &'static Path =
        Box::leak(tempfile::tempdir().expect("there is a folder for it").keep().into_boxed_path());
    for name in ["reference.json", "hotkeys.txt"] {
        fs::copy(originals::grading().join(name), folder.join(name)).expect("it is in the package");
    }
    let rubric = Rubric::load(&originals::grading().join("rubric.json"), scene).expect("it is good");
    let rubric: &'static Rubric = Box::leak(Box::new(rubric));
    let submission = move |name: &str, bytes: &[u8]| {
        let submission = Submission::in_memory(name, bytes.to_vec());
        let parsed = Parsed::new(submission.read(&rubric.keyframe_file), &rubric.keyframe_file, scene);
        let marks = Marks::of(&submission, &parsed, rubric, scene);
        assert!(marks.points() >= 0.0 && marks.points() <= marks.out_of(), "{marks:?}");
        marks.items.iter().for_each(|item| check_sentence(&item.reason));
        marks.notes.iter().for_each(|note| check_sentence(&note.text));
    };
    let script = |bytes: &[u8], scene: &SceneGraph| match script::parse(bytes, scene) {
        Ok(lines) => assert!(lines.len() <= bytes.split(|&byte| byte == b'\n').count()),
        Err(problems) => problems.iter().for_each(|problem| check_sentence(&problem.to_string())),
    };
    vec![
        text("keyframe file", originals::keyframe_files(), move |bytes| match keyframes_from_json(bytes, scene) {
            Ok(file) => check_keyframes(&file),
            Err(problems) => problems.iter().for_each(|problem| check_sentence(&problem.to_string())),
        }),
        text("scene", originals::scenes(), |bytes| {
            match scene_from_json(&String::from_utf8_lossy(bytes)) {
                // What was read can be written and read again.
                Ok(scene) => assert_eq!(scene_from_json(&scene_to_json(&scene)).as_ref(), Ok(&scene)),
                Err(error) => check_sentence(&error.to_string()),
            }
        }),
        text("keyframes as text", originals::texts(), move |bytes| {
            let order = (bytes.len() % 3 == 0).then_some(FieldOrder::QuaternionFirst);
            let options = Options { order, salvage: bytes.len() % 2 == 0, ..Options::default() };
            check_import(bytes, scene, &options);
        }),
        text("Python keys", originals::programs(), move |bytes| {
            check_import(bytes, scene, &Options::default());
            check_import(bytes, scene, &Options { group: GroupChoice::Number(2), ..Options::default() });
        }),
        text("samples", vec![include_bytes!("../data/diagnosis/correct.csv")[..3000].to_vec()], move |bytes| {
            check_samples(bytes, scene);
        }),
        text("trace", vec![originals::TRACE.into()], move |bytes| submission("trace.jsonl", bytes)),
        text("rubric", originals::rubrics().into(), move |bytes| {
            for name in ["mutant.json", "mutant.toml"] {
                let path = folder.join(name);
                fs::write(&path, bytes).expect("the folder is writable");
                if let Err(error) = Rubric::load(&path, scene) {
                    error.sentences().iter().for_each(|sentence| check_sentence(sentence));
                }
            }
        }),
        text("settings", originals::settings(), |bytes| match Settings::from_json(bytes) {
            Ok(settings) => assert_eq!(Settings::from_json(settings.to_json().as_bytes()), Ok(settings)),
            Err(error) => check_sentence(&error.to_string()),
        }),
        text("list of pictures", vec![originals::PICTURES.into()], move |bytes| {
            let path = folder.join("pictures.json");
            fs::write(&path, bytes).expect("the folder is writable");
            match read_list(&path) {
                Ok(shots) => assert!(!shots.is_empty()),
                Err(error) => error.sentences().iter().for_each(|sentence| check_sentence(sentence)),
            }
        }),
        text("script", vec![originals::SCRIPT.into()], move |bytes| {
            script(bytes, scene);
        }),
        Reader {
            // Commands have their own bounds; a script that is run allocates for what it does, not for how long it is.
            most_steps_per_byte: 200,
            ..text("graded script", vec![originals::SCRIPT.into()], move |bytes| submission("script.txt", bytes))
        },
        Reader {
            most_steps_per_byte: 200,
            ..text("journal", originals::journals(folder), |bytes| {
                let (editor, played) = journal::play_alone(bytes);
                assert!(played.lines <= bytes.split(|&byte| byte == b'\n').count());
                assert_eq!(played.passed_over, 0, "a line panicked");
                let _ = journal::survey(bytes);
                assert!(editor.document().keyframes.len() <= bytes.len());
            })
        },
        text("list of joints", vec![scene.rbt_paths().collect::<Vec<_>>().join("\n").into()], move |bytes| {
            if let Err(error) = JointList::from_text(bytes, scene) {
                check_sentence(&error.to_string());
            }
        }),
        Reader {
            most_bytes: of_png,
            ..text("picture", originals::pngs(), |bytes| match Image::from_png(bytes) {
                Ok(image) => assert_eq!(image.rgba.len(), 4 * image.width as usize * image.height as usize),
                Err(error) => check_sentence(&error.to_string()),
            })
        },
        Reader {
            most_bytes: of_zip,
            most_steps_per_byte: 200,
            ..text("zip", originals::zips(), move |bytes| submission("one.zip", bytes))
        },
    ]
}

/// Sentences are not empty, and have no words of libraries or of the source.
fn check_sentence(sentence: &str) {
    assert!(!sentence.trim().is_empty());
    for word in ["invalid type", "struct ", "EOF", "usize", "u64", "f32", "(os error", "variant `", "missing field"] {
        assert!(!sentence.contains(word) || sentence.contains('"'), "{sentence}");
    }
}

fn check_keyframes(file: &KeyframeFile) {
    for rbt in file.keyframes.iter().flat_map(|keyframe| keyframe.pose.iter()) {
        assert!(rbt.is_finite() && (rbt.rotation.length() - 1.0).abs() < 2e-6, "{rbt:?}");
    }
}

fn check_import(bytes: &[u8], scene: &SceneGraph, options: &Options) {
    match import(bytes, scene, options) {
        Ok(Imported::KeyframeFile(file) | Imported::Text(file, _)) => check_keyframes(&file),
        Ok(Imported::Scene(text, _)) => {
            let scene = scene_from_json(&text);
            assert!(scene.is_ok(), "{scene:?}");
        }
        Err(error) => {
            assert!(!error.sentences().is_empty());
            error.sentences().iter().for_each(|sentence| check_sentence(sentence));
        }
    }
}

fn check_samples(bytes: &[u8], scene: &SceneGraph) {
    match samples_from_csv(bytes, scene.rbt_count(), 2000) {
        Err(error) => check_sentence(&error.to_string()),
        Ok(samples) => {
            assert!(!samples.rows.is_empty());
            let is_good = |row: &inbetween::diagnosis::Row| {
                row.node.get() < scene.rbt_count() && row.key_time.is_finite() && row.key_time >= 0.0
            };
            assert!(samples.rows.iter().all(is_good));
            let keyframes = vec![Keyframe::new(scene.rest_pose().clone()); 5];
            let diagnosis = diagnose(&Sequence::new(&keyframes).expect("they are enough"), &samples, Listing::All);
            assert!(
                diagnosis.candidates.iter().all(|candidate| candidate.residual >= 0.0),
                "{:?}",
                diagnosis.candidates
            );
            assert!(!diagnosis.best().name.is_empty());
        }
    }
}
