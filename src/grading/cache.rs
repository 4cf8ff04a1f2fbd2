//! Results of earlier runs, by the hash of all that they follow from. One text: a line for each result.

use std::collections::{HashMap, HashSet};
use std::fmt::Write as _;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

use super::hash::Hashed;
use super::rubric::Rubric;
use super::submission::{Contents, Skipped};
use crate::export::Size;
use crate::scene::{SceneGraph, scene_to_json};

/// Results that this run did not ask for are kept up to so many bytes: 64 MiB.
const MOST_UNUSED_BYTES: usize = 64 << 20;
/// No more bytes are kept in all than are read again: 512 MiB.
pub const MOST_KEPT_BYTES: usize = 512 << 20;

/// A hash, in hexadecimal digits.
pub type Key = String;

/// The pictures that are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub struct Images {
    /// The most of a submission.
    pub most: u8,
    /// Width and height of each in pixels.
    pub size: (u32, u32),
}

impl Images {
    /// The size of each.
    #[must_use]
    pub const fn size(self) -> Size {
        Size { width: self.size.0, height: self.size.1 }
    }
}

/// What all results of a run follow from, beside the submissions.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
pub struct Basis {
    /// What tells builds of the program apart.
    pub program: Key,
    /// The hashes of the rubric and of the files that it names.
    pub rubric: Vec<Key>,
    /// The hash of the scene.
    pub scene: Key,
    /// The pictures that are drawn; `None` for none.
    pub images: Option<Images>,
}

impl Basis {
    /// The basis of a run.
    #[must_use]
    pub fn new(program: Key, rubric: &Rubric, scene: &SceneGraph, images: Option<Images>) -> Self {
        let rubric = rubric.hashes().map(|file| file.sha256).collect();
        Self { program, rubric, scene: hash(&[scene_to_json(scene).as_bytes()]), images }
    }
}

/// Results by keys.
#[derive(Clone, Debug, Default)]
pub struct Cache {
    /// The hash of the basis.
    base: Key,
    /// Earlier results by key, and their order.
    old: HashMap<Key, String>,
    order: Vec<Key>,
    /// The results of this run.
    used: Vec<(Key, String)>,
}

impl Cache {
    /// The results in a text that an earlier run wrote; what is broken is left out.
    #[must_use]
    pub fn new(text: &[u8], basis: &Basis) -> Self {
        let base = serde_json::to_string(basis).expect("a basis has keys that are text");
        let mut cache = Self { base: hash(&[base.as_bytes()]), ..Self::default() };
        for line in text.split(|byte| *byte == b'\n') {
            let Some((key, value)) = std::str::from_utf8(line).ok().and_then(whole) else { continue };
            cache.add(key.to_owned(), value.to_owned());
        }
        cache
    }

    /// Adds a result of another run.
    pub fn add(&mut self, key: Key, value: String) {
        if self.old.insert(key.clone(), value).is_none() {
            self.order.push(key);
        }
    }

    /// Whether it holds nothing of earlier runs.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.old.is_empty()
    }

    /// The key of what follows from these parts.
    #[must_use]
    pub fn key(&self, parts: &[&[u8]]) -> Key {
        let parts: Vec<&[u8]> = std::iter::once(self.base.as_bytes()).chain(parts.iter().copied()).collect();
        hash(&parts)
    }

    /// The key of the contents of a submission whose files have these hashes, in their order.
    pub(super) fn key_of(&self, contents: &Contents, files: &[Hashed]) -> Key {
        let skipped = |Skipped { name, why }: &Skipped| format!("{name} {why:?}");
        let texts: Vec<String> =
            contents.skipped.iter().map(skipped).chain([format!("{:?}", contents.problem)]).collect();
        let mut parts: Vec<&[u8]> = vec![b"submission"];
        parts.extend(files.iter().flat_map(|file| [file.name.as_bytes(), file.sha256.as_bytes()]));
        parts.push(b"skipped");
        parts.extend(texts.iter().map(String::as_bytes));
        self.key(&parts)
    }

    /// An earlier result; `None` if there is none that can be read.
    #[must_use]
    pub fn get<T: DeserializeOwned>(&self, key: &str) -> Option<T> {
        serde_json::from_str(self.old.get(key)?).ok()
    }

    /// A result of this run.
    pub fn keep(&mut self, key: Key, value: &impl Serialize) {
        if let Ok(value) = serde_json::to_string(value) {
            self.used.push((key, value));
        }
    }

    /// The results of this run, with their keys.
    #[must_use]
    pub fn used(&self) -> &[(Key, String)] {
        &self.used
    }

    /// The text for the next run: the results of this run, and earlier ones within a bound. `None` if it would say the same as before.
    #[must_use]
    pub fn text(&self) -> Option<String> {
        let used: HashSet<&str> = self.used.iter().map(|(key, _)| key.as_str()).collect();
        if used.iter().all(|key| self.old.contains_key(*key)) {
            return None;
        }
        let mut unused = 0;
        let old = self.order.iter().filter(|key| !used.contains(key.as_str())).map(|key| (key, &self.old[key]));
        let old = old.take_while(|(_, value)| {
            unused += value.len();
            unused <= MOST_UNUSED_BYTES
        });
        let mut text = String::new();
        // Equal submissions have one result.
        let mut written = HashSet::new();
        for (key, value) in self.used.iter().map(|(key, value)| (key, value)).chain(old) {
            let line = format!("{key} {} {value}\n", hash(&[key.as_bytes(), value.as_bytes()]));
            if text.len() + line.len() <= MOST_KEPT_BYTES && written.insert(key) {
                text.push_str(&line);
            }
        }
        Some(text)
    }
}

/// Key and value of a line whose hash is right.
fn whole(line: &str) -> Option<(&str, &str)> {
    let (key, rest) = line.split_once(' ')?;
    let (sum, value) = rest.split_once(' ')?;
    (hash(&[key.as_bytes(), value.as_bytes()]) == sum).then_some((key, value))
}

/// The hash of parts; with their lengths, so that parts cannot run into each other.
#[must_use]
pub fn hash(parts: &[&[u8]]) -> Key {
    let mut hash = Sha256::new();
    for part in parts {
        hash.update((part.len() as u64).to_le_bytes());
        hash.update(part);
    }
    hash.finalize().iter().fold(Key::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}
