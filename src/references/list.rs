//! The list of pictures that a folder of references is made from: `pictures.json`.

use std::collections::HashSet;
use std::path::{Component, Path};

use serde::{Deserialize, Deserializer};

use super::shot::{Shot, When};
use crate::decode;
use crate::files::{self, FileError};
use crate::film::{FrameNumbers, MOST_FRAMES_PER_SECOND, Quality};
use crate::flip::DEFAULT_TOLERANCE;
use crate::interpolation::Interpolation;
use crate::lighting::BuiltInLighting;
use crate::words::{Message, texts};

/// The list's name in its folder.
pub const LIST_NAME: &str = "pictures.json";

const FORMAT: &str = "inbetween.pictures";
const VERSION: u32 = 1;
/// The largest list that is read: 16 MiB.
const LARGEST_BYTES: u64 = 16 << 20;
/// The most pictures that a list asks for.
const MOST_PICTURES: usize = 100_000;
const USUAL_SIZE: [u32; 2] = [320, 240];
const USUAL_SAMPLES: u32 = 1;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    format: String,
    version: u32,
    #[serde(default)]
    defaults: Defaults,
    pictures: Vec<Entry>,
}

/// What pictures have that do not say otherwise.
#[derive(Clone, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Defaults {
    file: Option<String>,
    scene: Option<String>,
    fps: Option<u32>,
    seconds: Option<f64>,
    size: Option<[u32; 2]>,
    interpolation: Option<String>,
    samples: Option<u32>,
    quality: Option<NamedQuality>,
    lighting: Option<String>,
    camera: Option<String>,
    tolerance: Option<f32>,
}

/// One or several pictures.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    name: String,
    #[serde(default)]
    file: FileOfEntry,
    scene: Option<String>,
    at: Option<KeyTimes>,
    keyframe: Option<i64>,
    frames: Option<String>,
    fps: Option<u32>,
    seconds: Option<f64>,
    size: Option<[u32; 2]>,
    interpolation: Option<String>,
    samples: Option<u32>,
    quality: Option<NamedQuality>,
    lighting: Option<String>,
    camera: Option<String>,
    tolerance: Option<f32>,
    reference: Option<String>,
}

#[derive(Clone, Deserialize)]
#[serde(untagged, expecting = "decode.kind.key-times")]
enum KeyTimes {
    One(f64),
    Many(Vec<f64>),
}

/// A quality by its name or its number of sub-frames.
#[derive(Clone, Deserialize)]
#[serde(untagged, expecting = "decode.kind.quality")]
enum NamedQuality {
    Name(String),
    SubFrames(u64),
}

impl NamedQuality {
    fn quality(&self) -> Result<Quality, Message> {
        let text = match self {
            Self::Name(name) => name.clone(),
            Self::SubFrames(count) => count.to_string(),
        };
        Quality::parse(&text).ok_or_else(|| texts::references_quality(text, Quality::MOST))
    }
}

/// The keyframe file of an entry.
#[derive(Clone, Default)]
enum FileOfEntry {
    /// That of the defaults, if there is one.
    #[default]
    OfDefaults,
    /// This one; `null` is none.
    Own(Option<String>),
}

impl<'de> Deserialize<'de> for FileOfEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Option::deserialize(deserializer).map(Self::Own)
    }
}

impl Entry {
    /// The pictures, each with what its name has after the entry's.
    fn moments(&self, fps: Option<u32>) -> Result<Vec<(String, When)>, Message> {
        let asked = [self.at.is_some(), self.keyframe.is_some(), self.frames.is_some()];
        if asked.iter().filter(|is_asked| **is_asked).count() > 1 {
            return Err(texts::REFERENCES_ONE_MOMENT.into());
        }
        if self.fps.is_some() && self.frames.is_none() {
            return Err(texts::REFERENCES_FPS_NEEDS_FRAMES.into());
        }
        // Adding zero makes a zero of minus zero.
        let moments: Vec<(String, When)> = match (&self.at, self.keyframe, &self.frames) {
            (Some(KeyTimes::Many(all)), ..) => {
                all.iter().map(|at| (format!("-{}", at + 0.0), When::At(at + 0.0))).collect()
            }
            (Some(KeyTimes::One(at)), ..) => vec![(String::new(), When::At(at + 0.0))],
            (None, Some(index), _) => vec![(String::new(), When::Keyframe(index))],
            (None, None, Some(frames)) => {
                let fps = fps.ok_or(texts::REFERENCES_FRAMES_NEED_FPS)?;
                if !(1..=MOST_FRAMES_PER_SECOND).contains(&fps) {
                    return Err(texts::references_fps(fps.to_string(), MOST_FRAMES_PER_SECOND.to_string()));
                }
                let numbers = FrameNumbers::parse(frames).map_err(|error| error.message())?.of_film(MOST_PICTURES);
                let numbers = numbers.map_err(|number| texts::references_frame_beyond(number, MOST_PICTURES - 1))?;
                numbers.into_iter().map(|number| (format!("-{number:05}"), When::Frame { number, fps })).collect()
            }
            (None, None, None) => vec![(String::new(), When::At(0.0))],
        };
        let is_one = moments.iter().all(|(suffix, _)| suffix.is_empty());
        if self.reference.is_some() && !is_one {
            return Err(texts::REFERENCES_ONE_REFERENCE.into());
        }
        Ok(moments)
    }

    /// The pictures that it asks for.
    fn shots(self, defaults: &Defaults) -> Result<Vec<Shot>, Message> {
        if self.name.contains(['/', '\\']) || !is_plain(&self.name) {
            return Err(texts::REFERENCES_NAME.into());
        }
        let moments = self.moments(self.fps.or(defaults.fps))?;
        let needs_file = self.at.is_some() || self.keyframe.is_some();
        let file = match self.file {
            FileOfEntry::OfDefaults => defaults.file.clone(),
            FileOfEntry::Own(file) => file,
        };
        let scene = self.scene.or_else(|| defaults.scene.clone());
        for path in [&file, &scene, &self.reference].into_iter().flatten() {
            if !is_plain(path) {
                return Err(texts::references_leads_out(format!("{path:?}")));
            }
        }
        if needs_file && file.is_none() {
            return Err(texts::REFERENCES_NEEDS_FILE.into());
        }
        let interpolation = self.interpolation.or_else(|| defaults.interpolation.clone());
        let interpolation = interpolation.map(|name| {
            Interpolation::from_name(&name).ok_or_else(|| texts::references_unknown_interpolation(format!("{name:?}")))
        });
        let samples = self.samples.or(defaults.samples).unwrap_or(USUAL_SAMPLES);
        if !matches!(samples, 1 | 4) {
            return Err(texts::references_samples(samples.to_string()));
        }
        let quality = self.quality.as_ref().or(defaults.quality.as_ref()).map(NamedQuality::quality).transpose()?;
        let quality = quality.unwrap_or_default();
        if samples > 1 && quality.is_refined() {
            return Err(texts::REFERENCES_SAMPLES_OF_REFINED.into());
        }
        let lighting = self.lighting.or_else(|| defaults.lighting.clone());
        let lighting = lighting.map(|name| {
            BuiltInLighting::from_name(&name).ok_or_else(|| texts::references_lighting(format!("{name:?}")))
        });
        let tolerance = self.tolerance.or(defaults.tolerance).unwrap_or(DEFAULT_TOLERANCE);
        if !(0.0..=1.0).contains(&tolerance) {
            return Err(texts::references_tolerance(tolerance.to_string()));
        }
        let shot = Shot {
            name: self.name,
            file,
            scene,
            when: When::At(0.0),
            seconds: self.seconds.or(defaults.seconds).unwrap_or_default(),
            size: self.size.or(defaults.size).unwrap_or(USUAL_SIZE),
            interpolation: interpolation.transpose()?,
            samples,
            quality,
            lighting: lighting.transpose()?,
            camera: self.camera.or_else(|| defaults.camera.clone()),
            tolerance,
            reference: String::new(),
        };
        let one = |(suffix, when): (String, When)| {
            let name = shot.name.clone() + &suffix;
            let reference = self.reference.clone().unwrap_or_else(|| format!("{name}.png"));
            Shot { name, when, reference, ..shot.clone() }
        };
        Ok(moments.into_iter().map(one).collect())
    }
}

/// Whether a path stays within its folder, and prints as one line.
fn is_plain(path: &str) -> bool {
    let mut parts = Path::new(path).components();
    !path.is_empty()
        && !path.contains(char::is_control)
        && parts.all(|part| matches!(part, Component::Normal(_) | Component::CurDir))
}

/// Reads the list: every picture that it asks for, in its order.
///
/// # Errors
/// [`FileError`] with every problem.
pub fn read_list(path: &Path) -> Result<Vec<Shot>, FileError> {
    let location = path.display();
    let bytes = files::read(path, LARGEST_BYTES)?;
    let list: List = decode::json(&bytes).map_err(|error| FileError::new(&location, error))?;
    if list.format != FORMAT || list.version != VERSION {
        let found = format!("{:?} version {}", list.format, list.version);
        let expected = format!("{FORMAT:?} version {VERSION}");
        return Err(FileError::new(&location, texts::references_format(found, expected)));
    }
    let mut names = HashSet::new();
    let mut shots = Vec::new();
    let mut sentences = Vec::new();
    let mut problem = |name: &str, problem: Message| {
        sentences.push(texts::references_picture(path.display(), format!("{name:?}"), problem).to_string());
    };
    for entry in list.pictures {
        let name = entry.name.clone();
        match entry.shots(&list.defaults) {
            Ok(of_entry) => {
                for shot in of_entry {
                    if !names.insert(shot.name.clone()) {
                        problem(&shot.name, texts::REFERENCES_TWICE.into());
                    }
                    shots.push(shot);
                }
            }
            Err(error) => problem(&name, error),
        }
        if shots.len() > MOST_PICTURES {
            return Err(FileError::new(&location, texts::references_too_many(MOST_PICTURES.to_string())));
        }
    }
    if shots.is_empty() && sentences.is_empty() {
        sentences.push(format!("{location}: {}", texts::REFERENCES_NONE));
    }
    if sentences.is_empty() { Ok(shots) } else { Err(FileError::of_sentences(sentences)) }
}
