//! A part of a class as one machine grades it, and all parts together: the values that results are written of.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::cache::{Basis, Cache, Key, hash};
use super::gather::{PassedOver, System};
use super::hash::Hashed;
use super::kept::Kept;
use super::marks::Marks;
use super::overrides::Overrides;
use super::rubric::Rubric;
use super::submission::Submission;
use crate::decode::{self, DecodeError};
use crate::files::FileError;
use crate::scene::{SceneGraph, scene_from_json, scene_to_json};
use crate::words::{Message, texts};

/// The format's name.
const FORMAT: &str = "inbetween.shard";

/// The most parts of a class.
pub const MOST_SHARDS: usize = 10_000;

/// Which part of a class: every `of`-th submission.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub struct ShardNumber {
    /// The number of the part, from 1 to `of`.
    pub number: usize,
    /// How many parts there are.
    pub of: usize,
}

impl ShardNumber {
    /// Whether the submission of an index among those of the class belongs to this part.
    #[must_use]
    pub const fn has(self, index: usize) -> bool {
        index % self.of == self.number - 1
    }
}

/// A submission of a part, without its files.
#[derive(Clone, Debug, Deserialize, Serialize)]
struct ShardSubmission {
    name: String,
    student: Option<String>,
    id: Option<String>,
    system: Option<System>,
    is_late: bool,
    days_late: Option<u32>,
    files: Vec<Hashed>,
    key: Key,
}

/// What all versions of the format have.
#[derive(Deserialize)]
struct Form {
    format: String,
    version: u64,
}

/// A graded part of a class.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Shard {
    format: String,
    version: u64,
    part: ShardNumber,
    basis: Basis,
    /// The hash of the names of all submissions of the class.
    class: Key,
    /// The rubric and its files: names, and a character for each byte.
    rubric: Vec<(String, String)>,
    /// The overrides beside the rubric, a character for each byte.
    overrides: Option<String>,
    scene: String,
    passed_over: Vec<PassedOver>,
    submissions: Vec<ShardSubmission>,
    /// What is kept of submissions and of films, by key.
    results: Vec<(Key, String)>,
}

/// A class as it was graded: all that results are written of.
#[derive(Debug)]
pub struct GradedClass {
    /// What all results follow from.
    pub basis: Basis,
    /// The scene.
    pub scene: SceneGraph,
    /// The rubric.
    pub rubric: Rubric,
    /// A teacher's points beside the rubric.
    pub overrides: Option<Overrides>,
    /// The marks of all submissions with their pictures, in their order.
    pub marks: Vec<Marks>,
    /// What was passed over.
    pub passed_over: Vec<PassedOver>,
    /// What is kept of them, and films that were drawn.
    pub cache: Cache,
}

/// A character for each byte: files are mostly plain text, and any bytes survive.
fn as_text(bytes: &[u8]) -> String {
    bytes.iter().copied().map(char::from).collect()
}

fn as_bytes(text: &str) -> Option<Vec<u8>> {
    text.chars().map(|c| u8::try_from(c).ok()).collect()
}

/// A sentence with the names of two files.
type Sentence = fn(&str, &str) -> Message;

impl Shard {
    /// A part as text; `names` are those of all submissions of the class.
    #[must_use]
    pub fn written(part: ShardNumber, names: &[String], class: &GradedClass) -> String {
        let submission = |marks: &Marks| ShardSubmission {
            name: marks.name.clone(),
            student: marks.student.clone(),
            id: marks.id.clone(),
            system: marks.system,
            is_late: marks.is_late,
            days_late: marks.days_late,
            files: marks.files.clone(),
            key: marks.key.clone(),
        };
        let shard = Self {
            format: FORMAT.to_owned(),
            version: 1,
            part,
            basis: class.basis.clone(),
            class: hash_of_names(names),
            rubric: class.rubric.sources.iter().map(|(name, bytes)| (name.clone(), as_text(bytes))).collect(),
            overrides: class.overrides.as_ref().map(|overrides| as_text(&overrides.source)),
            scene: scene_to_json(&class.scene),
            passed_over: class.passed_over.clone(),
            submissions: class.marks.iter().map(submission).collect(),
            results: class.cache.used().to_vec(),
        };
        serde_json::to_string(&shard).expect("a shard has keys that are text") + "\n"
    }

    /// Reads a part. `name` is that of its file.
    ///
    /// # Errors
    /// [`FileError`]: it is no part of a class, or one of another version.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, FileError> {
        let bad = |error: DecodeError| FileError::new(name, error);
        let Form { format, version } = decode::json(bytes).map_err(bad)?;
        if format != FORMAT || version != 1 {
            return Err(FileError::new(name, texts::grade_shard_form(&format, version)));
        }
        decode::json(bytes).map_err(bad)
    }

    /// Why this part and another one do not go together.
    fn differs(&self, other: &Self) -> Option<Sentence> {
        let (one, two) = (&self.basis, &other.basis);
        let sentences: [(bool, Sentence); 7] = [
            (one.program != two.program, |one, two| texts::grade_shards_programs(one, two)),
            (one.rubric != two.rubric, |one, two| texts::grade_shards_rubrics(one, two)),
            (one.scene != two.scene, |one, two| texts::grade_shards_scenes(one, two)),
            (one.images != two.images, |one, two| texts::grade_shards_images(one, two)),
            (self.overrides != other.overrides, |one, two| texts::grade_shards_overrides(one, two)),
            (self.part.of != other.part.of, |one, two| texts::grade_shards_counts(one, two)),
            (self.class != other.class || self.passed_over != other.passed_over, |one, two| {
                texts::grade_shards_classes(one, two)
            }),
        ];
        sentences.into_iter().find(|(differs, _)| *differs).map(|(_, sentence)| sentence)
    }

    /// The class of parts, each with the name of its file. `program` tells this build of the program apart.
    ///
    /// # Errors
    /// A sentence with the names of files: parts of different classes or runs, one that is missing or there twice, one that is broken.
    pub fn merged(parts: &[(String, Self)], program: &Key) -> Result<GradedClass, FileError> {
        let Some((first_name, first)) = parts.first() else {
            return Err(FileError::new("--merge", texts::GRADE_SHARD_BROKEN));
        };
        let broken = |name: &str| FileError::new(name, texts::GRADE_SHARD_BROKEN);
        if first.basis.program != *program {
            return Err(FileError::new(first_name, texts::GRADE_SHARD_OTHER_PROGRAM));
        }
        let mut in_order: Vec<Option<&(String, Self)>> = vec![None; first.part.of.min(MOST_SHARDS)];
        for part in parts {
            let (name, shard) = part;
            if let Some(sentence) = first.differs(shard) {
                return Err(FileError::of_sentences(vec![sentence(first_name, name).to_string()]));
            }
            let place =
                shard.part.number.checked_sub(1).and_then(|at| in_order.get_mut(at)).ok_or_else(|| broken(name))?;
            if let Some((other, _)) = place.replace(part) {
                let ShardNumber { number, of } = shard.part;
                return Err(FileError::of_sentences(vec![
                    texts::grade_shards_doubled(other, name, number, of).to_string(),
                ]));
            }
        }
        let missing: Vec<String> = (1..)
            .zip(&in_order)
            .filter(|(_, part)| part.is_none())
            .map(|(number, _): (usize, _)| number.to_string())
            .collect();
        if !missing.is_empty() {
            return Err(FileError::new("--merge", texts::grade_shards_missing(missing.join(", "), first.part.of)));
        }
        let scene = scene_from_json(&first.scene).map_err(|_| broken(first_name))?;
        let (own_name, _) = first.rubric.first().ok_or_else(|| broken(first_name))?;
        let rubric = Rubric::read(Path::new(own_name), &scene, |name, _| {
            let source = first.rubric.iter().find(|(known, _)| known == name);
            source.and_then(|(_, text)| as_bytes(text)).ok_or_else(|| broken(first_name))
        })?;
        let overrides = first.overrides.as_deref().map(|text| {
            Overrides::read(Path::new(first_name), &as_bytes(text).ok_or_else(|| broken(first_name))?, &rubric)
        });
        let overrides = overrides.transpose()?;
        let mut cache = Cache::new(b"", &first.basis);
        let mut marks: Vec<(usize, Marks)> = Vec::new();
        for (name, shard) in in_order.into_iter().flatten() {
            for (key, value) in &shard.results {
                cache.add(key.clone(), value.clone());
            }
            for (at, submission) in shard.submissions.iter().enumerate() {
                let restored = submission.restored(&cache, &rubric).ok_or_else(|| broken(name))?;
                marks.push((at * shard.part.of + shard.part.number - 1, restored));
            }
        }
        marks.sort_by_key(|(index, _)| *index);
        let marks: Vec<Marks> = marks.into_iter().map(|(_, marks)| marks).collect();
        let names: Vec<String> = marks.iter().map(|marks| marks.name.clone()).collect();
        if hash_of_names(&names) != first.class {
            return Err(broken(first_name));
        }
        let (basis, passed_over) = (first.basis.clone(), first.passed_over.clone());
        Ok(GradedClass { basis, scene, rubric, overrides, marks, passed_over, cache })
    }
}

impl ShardSubmission {
    fn restored(&self, cache: &Cache, rubric: &Rubric) -> Option<Marks> {
        let Self { name, student, id, system, is_late, days_late, files, key } = self.clone();
        let submission = Submission { name, student, id, system, is_late, days_late, roots: Vec::new() };
        let marks = cache.get::<Kept>(&key)?.restored(&submission, rubric)?;
        Some(Marks { files, key, ..marks })
    }
}

fn hash_of_names(names: &[String]) -> Key {
    let parts: Vec<&[u8]> = names.iter().map(String::as_bytes).collect();
    hash(&parts)
}
