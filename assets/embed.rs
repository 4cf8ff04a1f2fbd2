//! The build script: lists the files of some folders under `assets/`, so that a new file there needs no line of code.
//!
//! For each folder it writes `$OUT_DIR/FOLDER.rs`: an array of `(name, text)`, sorted by name, for `include!`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// The folders, and the ending of the files that are embedded from each.
const FOLDERS: [(&str, &str); 2] = [("manual", "md"), ("words", "txt")];

fn main() {
    let package = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    println!("cargo::rerun-if-changed=assets/embed.rs");
    for (folder, ending) in FOLDERS {
        println!("cargo::rerun-if-changed=assets/{folder}");
        let list = list(&package.join("assets").join(folder), ending);
        fs::write(out.join(format!("{folder}.rs")), list).expect("the output folder can be written");
    }
}

/// The array's source text.
fn list(folder: &Path, ending: &str) -> String {
    let files = fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok).map(|entry| entry.path());
    let mut files: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|found| found == ending)).collect();
    files.sort();
    let mut text = String::from("[\n");
    for path in files {
        let name = path.file_stem().and_then(|stem| stem.to_str()).expect("names in assets are ASCII");
        let path = path.to_str().expect("the package's folder is named in UTF-8");
        let _ = writeln!(text, "    ({name:?}, include_str!({path:?})),");
    }
    text.push(']');
    text
}
