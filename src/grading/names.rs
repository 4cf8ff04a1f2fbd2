//! What names of files say: what need not be read, what is a copy, and what the rubric prefers.

use std::borrow::Cow;

use glob::{MatchOptions, Pattern};
use unicode_normalization::{IsNormalized, UnicodeNormalization as _, is_nfc_quick};

/// The name without folders.
#[must_use]
pub fn file_name(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or_default()
}

/// The ending of a name in small letters, without its dot; empty without one.
#[must_use]
pub fn ending(path: &str) -> String {
    file_name(path).rsplit_once('.').map_or_else(String::new, |(_, ending)| ending.to_ascii_lowercase())
}

/// The composed form of a text: letters with accents and syllables in one piece, as most systems write them.
#[must_use]
pub fn composed(text: &str) -> Cow<'_, str> {
    match is_nfc_quick(text.chars()) {
        IsNormalized::Yes => Cow::Borrowed(text),
        IsNormalized::No | IsNormalized::Maybe => Cow::Owned(text.nfc().collect()),
    }
}

/// A student's number as it is compared: in small letters.
#[must_use]
pub fn id_key(id: &str) -> String {
    composed(id.trim()).to_lowercase()
}

/// Whether a name belongs to the system or to tools, and never to a student's work.
#[must_use]
pub fn is_hidden(name: &str) -> bool {
    let of_systems = ["thumbs.db", "ehthumbs.db", "desktop.ini", "__macosx", "$recycle.bin", "icon\r"];
    name.starts_with('.') || of_systems.contains(&name.to_lowercase().as_str())
}

/// Kinds of files that are not read, in the plural, with their endings.
const NOT_READ: [(&str, &str, &[&str]); 6] = [
    (
        "source",
        "sources",
        &[
            "c", "cc", "cpp", "cxx", "h", "hh", "hpp", "hxx", "inl", "ipp", "m", "mm", "cs", "java", "js", "jsx", "ts",
            "tsx", "rs", "go", "swift", "kt", "vert", "frag", "geom", "comp", "glsl", "vs", "fs", "vshader", "fshader",
            "gshader", "shader", "hlsl", "cu", "cmake", "pro", "sln", "vcxproj", "vcproj", "filters", "user", "props",
            "pbxproj", "plist", "bat", "cmd", "sh", "ps1", "css", "html", "htm",
        ],
    ),
    (
        "object file",
        "object files",
        &[
            "o", "obj", "a", "lib", "so", "dll", "dylib", "exe", "pdb", "ilk", "idb", "ipdb", "iobj", "pch", "gch",
            "d", "tlog", "sdf", "suo", "db", "class", "jar", "pyc", "pyd", "wasm", "bin", "ds_store",
        ],
    ),
    (
        "video or sound",
        "videos or sounds",
        &[
            "mp4", "mov", "avi", "mkv", "webm", "wmv", "m4v", "flv", "mpg", "mpeg", "3gp", "gif", "mp3", "wav", "ogg",
            "flac", "m4a",
        ],
    ),
    (
        "picture",
        "pictures",
        &[
            "png", "jpg", "jpeg", "bmp", "ppm", "pgm", "tga", "tif", "tiff", "webp", "svg", "ico", "psd", "heic",
            "heif", "hdr", "exr", "dds",
        ],
    ),
    (
        "document",
        "documents",
        &[
            "pdf", "doc", "docx", "ppt", "pptx", "xls", "xlsx", "odt", "odp", "ods", "numbers", "pages", "rtf", "md",
            "tex", "hwp", "hwpx", "ipynb", "epub",
        ],
    ),
    (
        "3D model",
        "3D models",
        &["fbx", "blend", "blend1", "stl", "ply", "gltf", "glb", "dae", "3ds", "usd", "usdz", "bvh"],
    ),
];

/// The kind of a file that is not read, because its ending tells that it holds nothing to grade: singular and plural.
#[must_use]
pub fn kind_not_read(path: &str) -> Option<(&'static str, &'static str)> {
    let ending = ending(path);
    NOT_READ.iter().find(|(_, _, endings)| endings.contains(&ending.as_str())).map(|(one, many, _)| (*one, *many))
}

/// Endings that keyframe files often have.
const KEYFRAME_ENDINGS: [&str; 11] =
    ["json", "txt", "csv", "dat", "key", "keys", "kf", "anim", "frames", "keyframes", "py"];

/// Whether the ending is one that keyframe files often have.
#[must_use]
pub fn has_keyframe_ending(path: &str) -> bool {
    KEYFRAME_ENDINGS.contains(&ending(path).as_str())
}

/// Whether the ending is one of samples, of a trace or of a script.
#[must_use]
pub fn has_ending_of_results(path: &str) -> bool {
    ["csv", "jsonl", "script"].contains(&ending(path).as_str())
}

/// Whether the name, without folders and ending, speaks of animation or keyframes.
#[must_use]
pub fn speaks_of_keyframes(path: &str) -> bool {
    let name = file_name(path).to_lowercase();
    ["anim", "keyframe", "key_frame", "key-frame", "key frame"].iter().any(|word| name.contains(word))
}

/// Whether the name, or a folder's name, says that it is a copy, a backup, an earlier try or somebody else's.
#[must_use]
pub fn is_old(path: &str) -> bool {
    path.split('/').any(|part| part.ends_with('~') || has_number_in_parentheses(part) || words(part).any(is_old_word))
}

fn is_old_word(word: &str) -> bool {
    let word = word.trim_end_matches(|c: char| c.is_ascii_digit()).to_lowercase();
    ["old", "copy", "backup", "bak", "ref", "try"].contains(&word.as_str())
}

/// `animation (1).txt`, as browsers name what they download again.
fn has_number_in_parentheses(name: &str) -> bool {
    let Some((_, rest)) = name.split_once('(') else { return false };
    rest.split_once(')').is_some_and(|(number, _)| {
        !number.is_empty() && number.len() < 4 && number.bytes().all(|byte| byte.is_ascii_digit())
    })
}

/// The words of a name: pieces between signs, and between a small letter and a capital.
fn words(name: &str) -> impl Iterator<Item = &str> {
    name.split(|c: char| !c.is_alphanumeric()).flat_map(|piece| {
        let mut words = Vec::new();
        let mut start = 0;
        let mut was_small = false;
        for (at, c) in piece.char_indices() {
            if was_small && c.is_uppercase() {
                words.push(&piece[start..at]);
                start = at;
            }
            was_small = c.is_lowercase();
        }
        words.push(&piece[start..]);
        words
    })
}

/// The names that a rubric prefers for keyframe files, the best first.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PreferredNames(Vec<Pattern>);

impl PreferredNames {
    /// Reads patterns: `*` and `?` stand for other characters, case does not matter.
    ///
    /// # Errors
    /// The first that is no pattern: a sentence.
    pub fn new(patterns: &[String]) -> Result<Self, String> {
        let pattern = |text: &String| {
            Pattern::new(&composed(text).to_lowercase())
                .map_err(|error| format!("{text:?} is no pattern: {}", error.msg))
        };
        Ok(Self(patterns.iter().map(pattern).collect::<Result<_, _>>()?))
    }

    /// The place of the first pattern that fits; without one, a number larger than all places.
    #[must_use]
    pub fn place(&self, path: &str) -> usize {
        let (path, options) = (composed(path).to_lowercase(), MatchOptions::new());
        let fits = |pattern: &Pattern| {
            let text = if pattern.as_str().contains('/') { &path } else { file_name(&path) };
            pattern.matches_with(text, options)
        };
        self.0.iter().position(fits).unwrap_or(self.0.len())
    }

    /// Whether any pattern fits.
    #[must_use]
    pub fn fit(&self, path: &str) -> bool {
        self.place(path) < self.0.len()
    }

    /// The order of files of one kind, the likeliest first: by the rubric's patterns, the depth of folders, copies last, names that speak
    /// of keyframes first, then by name.
    #[must_use]
    pub fn rank(&self, path: &str) -> impl Ord + use<> {
        let depth = path.matches('/').count();
        (self.place(path), depth, is_old(path), !speaks_of_keyframes(path), path.to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn copies_and_tries_are_known_by_whole_words() {
        for old in [
            "animation copy.txt",
            "aaa_old.txt",
            "animation.ref.txt",
            "animation (1).txt",
            "animation.txt~",
            "try2.txt",
            "animationOld.json",
            "OLD/animation.txt",
            "anim.bak",
            "backup/a.txt",
        ] {
            assert!(is_old(old), "{old}");
        }
        for new in ["gold.txt", "prefix.txt", "country.json", "copyright.txt", "folder/hold.txt", "f(x).txt", "refs"] {
            assert!(!is_old(new), "{new}");
        }
    }

    #[test]
    fn endings_of_other_kinds_are_not_read() {
        for (path, kind) in [("a/walk.BVH", "3D model"), ("Fox.glb", "3D model"), ("notes.pdf", "document")] {
            assert_eq!(kind_not_read(path).map(|(one, _)| one), Some(kind), "{path}");
        }
        assert_eq!(kind_not_read("walk.json"), None);
    }

    #[test]
    fn the_rubric_decides_before_folders_and_names() {
        let preferred = PreferredNames::new(&["animation.txt".to_owned(), "*.json".to_owned()]).expect("patterns");
        let mut names = ["b.json", "src/Animation.TXT", "anim_final.txt", "old/b.json", "a.json", "z.txt", "a.txt"];
        names.sort_by_key(|name| preferred.rank(name));
        assert_eq!(names, ["src/Animation.TXT", "a.json", "b.json", "old/b.json", "anim_final.txt", "a.txt", "z.txt"]);
        assert!(PreferredNames::new(&["[".to_owned()]).is_err());
    }

    #[test]
    fn decomposed_names_are_the_same() {
        let preferred = PreferredNames::new(&["re\u{301}sume\u{301}.txt".to_owned()]).expect("a pattern");
        assert!(preferred.fit("r\u{e9}sum\u{e9}.txt"));
        assert_eq!(composed("\u{1100}\u{1161}"), "가");
    }
}
