//! The list of pictures that a folder of references is made from: `pictures.json`.

use std::collections::HashSet;
use std::path::{Component, Path};

use serde::Deserialize;

use crate::files::{self, FileError};
use crate::flip::DEFAULT_TOLERANCE;
use crate::interpolation::Interpolation;

/// The list's name in its folder.
pub const LIST_NAME: &str = "pictures.json";

const FORMAT: &str = "inbetween.pictures";
const VERSION: u32 = 1;
/// The largest list that is read: 16 MiB.
const LARGEST_BYTES: u64 = 16 << 20;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    format: String,
    version: u32,
    pictures: Vec<Shot>,
}

/// One picture that the list asks for.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Shot {
    /// What the picture is called, and its files after it.
    pub name: String,
    /// The keyframe file, relative to the folder; without it, the scene's rest pose.
    pub file: Option<String>,
    /// A built-in scene, or a scene file relative to the folder.
    pub scene: Option<String>,
    /// The key time.
    pub at: Option<f64>,
    /// The keyframe of the list, instead of a key time.
    pub keyframe: Option<i64>,
    /// The time of the timed keys, in seconds.
    #[serde(default)]
    pub seconds: f64,
    /// Width and height in pixels.
    #[serde(default = "usual_size")]
    pub size: [u32; 2],
    /// The interpolation to use instead of the file's.
    interpolation: Option<String>,
    /// Samples a pixel, 1 or 4.
    #[serde(default = "usual_samples")]
    pub samples: u32,
    /// The eye, or turntable.
    pub camera: Option<String>,
    /// The largest score that counts as the same.
    #[serde(default = "usual_tolerance")]
    pub tolerance: f32,
    reference: Option<String>,
}

fn usual_size() -> [u32; 2] {
    [320, 240]
}

fn usual_samples() -> u32 {
    1
}

fn usual_tolerance() -> f32 {
    DEFAULT_TOLERANCE
}

impl Shot {
    /// The reference's name in the folder: NAME.png, unless the list says another.
    #[must_use]
    pub fn reference(&self) -> String {
        self.reference.clone().unwrap_or_else(|| format!("{}.png", self.name))
    }

    /// The interpolation that replaces the file's.
    #[must_use]
    pub fn interpolation(&self) -> Option<Interpolation> {
        self.interpolation.as_deref().and_then(Interpolation::from_name)
    }

    fn problem(&self) -> Option<String> {
        let is_plain = |path: &String| {
            let mut parts = Path::new(path).components();
            !path.is_empty() && parts.all(|part| matches!(part, Component::Normal(_) | Component::CurDir))
        };
        if self.name.is_empty() || self.name.contains(['/', '\\']) || !is_plain(&self.name) {
            return Some("the name names files, so it is not empty and has no / and no \\".to_owned());
        }
        for path in [&self.file, &self.scene, &self.reference].into_iter().flatten() {
            if !is_plain(path) {
                return Some(format!("{path:?} leads out of the folder"));
            }
        }
        if let Some(name) = self.interpolation.as_ref().filter(|_| self.interpolation().is_none()) {
            return Some(format!("unknown interpolation {name:?}"));
        }
        if self.at.is_some() && self.keyframe.is_some() {
            return Some("\"at\" and \"keyframe\" cannot go together".to_owned());
        }
        if self.file.is_none() && (self.at.is_some() || self.keyframe.is_some()) {
            return Some("\"at\" and \"keyframe\" need a \"file\"".to_owned());
        }
        if !matches!(self.samples, 1 | 4) {
            return Some(format!("samples is {}, expected 1 or 4", self.samples));
        }
        if !(0.0..=1.0).contains(&self.tolerance) {
            return Some(format!("tolerance is {}, expected 0 to 1", self.tolerance));
        }
        None
    }
}

/// Reads the list.
///
/// # Errors
/// [`FileError`] with every problem.
pub fn read_list(path: &Path) -> Result<Vec<Shot>, FileError> {
    let location = path.display();
    let bytes = files::read(path, LARGEST_BYTES)?;
    let list: List =
        serde_json::from_slice(&bytes).map_err(|error| FileError::new(&location, crate::json::sentence(&error)))?;
    if list.format != FORMAT || list.version != VERSION {
        let found = format!("{:?} version {}", list.format, list.version);
        return Err(FileError::new(&location, format!("the format is {found}, expected {FORMAT:?} version {VERSION}")));
    }
    let mut names = HashSet::new();
    let mut sentences = Vec::new();
    for picture in &list.pictures {
        let twice = (!names.insert(&picture.name)).then(|| "stands twice".to_owned());
        for problem in picture.problem().into_iter().chain(twice) {
            sentences.push(format!("{location}: picture {:?}: {problem}", picture.name));
        }
    }
    if list.pictures.is_empty() {
        sentences.push(format!("{location}: there are no pictures"));
    }
    if sentences.is_empty() { Ok(list.pictures) } else { Err(FileError::of_sentences(sentences)) }
}
