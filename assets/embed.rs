//! The build script: lists the files of some folders under `assets/`, so that a new file there needs no line of code, and makes the
//! messages' constants and functions. It packs the notices, which are long and seldom read.
//!
//! For each folder it writes `$OUT_DIR/FOLDER.rs`: an array of `(name, text)`, sorted by name, for `include!`. Of `words/en.txt` it
//! makes `$OUT_DIR/texts.rs`, and of the notices `$OUT_DIR/notices.deflate` (RFC 1951). It also says which commit is built, and how.

#[path = "../src/words/file.rs"]
mod file;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use file::LanguageFile;

/// The folders, and the ending of the files that are embedded from each.
const FOLDERS: [(&str, &str); 2] = [("manual", "md"), ("words", "txt")];

/// The notices of what others made.
const NOTICES: &str = "assets/licences/THIRD-PARTY.txt";

fn main() {
    let package = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    println!("cargo::rerun-if-changed=assets/embed.rs");
    println!("cargo::rerun-if-changed=src/words/file.rs");
    for (folder, ending) in FOLDERS {
        println!("cargo::rerun-if-changed=assets/{folder}");
        let list = list(&files(&package.join("assets").join(folder), ending));
        fs::write(out.join(format!("{folder}.rs")), list).expect("the output folder can be written");
    }
    let languages = files(&package.join("assets/words"), "txt");
    let mut english = String::new();
    for path in &languages {
        println!("cargo::rerun-if-changed={}", path.display());
        let text = fs::read_to_string(path).expect("words are UTF-8");
        if let Err(problem) = LanguageFile::parse(&text) {
            panic!("{}: {problem}", path.display());
        }
        if path.ends_with("en.txt") {
            english = text;
        }
    }
    fs::write(out.join("texts.rs"), texts(&english)).expect("the output folder can be written");
    println!("cargo::rerun-if-changed={NOTICES}");
    let notices = fs::read_to_string(package.join(NOTICES)).expect("notices are UTF-8");
    let packed = miniz_oxide::deflate::compress_to_vec(notices.as_bytes(), 9);
    fs::write(out.join("notices.deflate"), packed).expect("the output folder can be written");
    say_how_it_is_built(&package);
}

/// Sets the variables of `src/facts.rs`: `INBETWEEN_COMMIT`, `INBETWEEN_TARGET`, `INBETWEEN_PROFILE` and `INBETWEEN_RUSTC`.
fn say_how_it_is_built(package: &Path) {
    let variable = |name: &str| env::var(name).unwrap_or_default();
    let rustc = Command::new(variable("RUSTC")).arg("--version").output();
    let rustc = rustc.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned()).unwrap_or_default();
    // cargo tells `debug` or `release` alone; the folder is called as the profile is: TARGET/PROFILE/build/PACKAGE/out.
    let out = PathBuf::from(variable("OUT_DIR"));
    let folder = out.ancestors().nth(3).and_then(|folder| folder.file_name()?.to_str().map(str::to_owned));
    let profile = folder.unwrap_or_else(|| variable("PROFILE"));
    println!("cargo::rustc-env=INBETWEEN_COMMIT={}", commit(package, variable("PROFILE") == "debug"));
    println!("cargo::rustc-env=INBETWEEN_TARGET={}", variable("TARGET"));
    println!("cargo::rustc-env=INBETWEEN_PROFILE={profile}");
    println!("cargo::rustc-env=INBETWEEN_RUSTC={rustc}");
}

/// The commit that is built: what `INBETWEEN_COMMIT` says, else what git says of the checkout. `unknown` in debug builds, which would
/// have to be made anew after each commit, and where there is neither.
fn commit(package: &Path, is_debug: bool) -> String {
    println!("cargo::rerun-if-env-changed=INBETWEEN_COMMIT");
    let told = env::var("INBETWEEN_COMMIT").ok().filter(|commit| !commit.is_empty());
    let git = |arguments: &[&str]| {
        let output = Command::new("git").arg("-C").arg(package).args(arguments).output().ok()?;
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    };
    let of_checkout = || {
        if is_debug {
            return None;
        }
        // A folder inside of another project's checkout is none.
        let top = fs::canonicalize(git(&["rev-parse", "--show-toplevel"])?).ok()?;
        if fs::canonicalize(package).ok()? != top {
            return None;
        }
        for file in ["HEAD", "logs/HEAD"] {
            let path = package.join(git(&["rev-parse", "--git-path", file])?);
            if path.exists() {
                println!("cargo::rerun-if-changed={}", path.display());
            }
        }
        git(&["rev-parse", "HEAD"])
    };
    told.or_else(of_checkout).unwrap_or_else(|| "unknown".to_owned())
}

/// The files of a folder with an ending, sorted.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let files = fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok).map(|entry| entry.path());
    let mut files: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|found| found == ending)).collect();
    files.sort();
    files
}

/// The array's source text.
fn list(files: &[PathBuf]) -> String {
    let mut text = String::from("[\n");
    for path in files {
        let name = path.file_stem().and_then(|stem| stem.to_str()).expect("names in assets are ASCII");
        let path = path.to_str().expect("the package stands in a folder whose name is UTF-8");
        let _ = writeln!(text, "    ({name:?}, include_str!({path:?})),");
    }
    text.push(']');
    text
}

/// The ids, and a constant or a function for each.
fn texts(english: &str) -> String {
    let file = LanguageFile::parse(english).expect("en.txt was read before");
    let singulars =
        |id: &str| file::singular_of(id).is_some_and(|plural| file.texts.iter().any(|(id, _)| *id == plural));
    let texts: BTreeMap<&str, &str> = file.texts.iter().copied().filter(|(id, _)| !singulars(id)).collect();
    let mut source = format!("/// Every id, sorted.\npub(super) static IDS: [&str; {}] = [\n", texts.len());
    for id in texts.keys() {
        let _ = writeln!(source, "    {id:?},");
    }
    source.push_str("];\n");
    for (index, (id, text)) in texts.iter().enumerate() {
        let name = id.replace(['.', '-'], "_");
        let arguments = arguments(text);
        let _ = write!(source, "\n#[doc = {:?}]\n", format!("`` {text} ``"));
        if arguments.is_empty() {
            let _ = writeln!(source, "pub const {}: Phrase = Phrase({index});", name.to_uppercase());
            continue;
        }
        let list = |each: fn(&str) -> String| arguments.iter().map(|name| each(name)).collect::<Vec<_>>().join(", ");
        let parameters = list(|name| format!("{name}: impl Into<Argument>"));
        let given = list(|name| format!("({name:?}, {name}.into())"));
        let _ = writeln!(source, "#[must_use]\npub fn {name}({parameters}) -> Message {{");
        let _ = writeln!(source, "    Message::new({index}, vec![{given}])\n}}");
    }
    source
}

/// The names of a text's arguments, each once, in the order in which the text first names them.
fn arguments(text: &str) -> Vec<&str> {
    let mut names = Vec::new();
    for piece in file::pieces(text).unwrap_or_default() {
        if let file::Piece::Argument(name) = piece
            && !names.contains(&name)
        {
            names.push(name);
        }
    }
    names
}
