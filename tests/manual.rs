//! The README and the manual: their tables are the program's, their links resolve, and what they show as files can be read.

use std::fs;
use std::path::{Path, PathBuf};

use inbetween::cli::command_reference;
use inbetween::diagnosis::markdown as mistakes;
use inbetween::editor::keymap;
use inbetween::manual::{self, Block, Link, Page};
use inbetween::scene::{DEFAULT_SCENE, built_in_scene, scene_from_json};
use inbetween::script::markdown as script_lines;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn folder() -> PathBuf {
    root().join("assets/manual")
}

fn pages() -> Vec<Page> {
    manual::names().iter().map(|name| manual::page(name).unwrap_or_else(|| panic!("there is no page {name}"))).collect()
}

/// The page's block of this name is what was made.
#[track_caller]
fn check_block(page: &str, name: &str, made: &str) {
    let path = folder().join(page);
    let text = fs::read_to_string(&path).expect("the page");
    let (begin, end) = (format!("<!-- {name}: begin -->\n"), format!("<!-- {name}: end -->"));
    let (before, rest) = text.split_once(&begin).expect("the block begins");
    let (block, after) = rest.split_once(&end).expect("the block ends");
    if std::env::var_os("UPDATE_GOLDENS").is_none() {
        assert_eq!(block, made, "{page}: the {name} have changed: UPDATE_GOLDENS=1 cargo test --test manual");
    } else if block != made {
        fs::write(path, format!("{before}{begin}{made}{end}{after}")).expect("the page can be written");
    }
}

#[test]
fn tables_are_made_from_the_program() {
    check_block("hotkeys.md", "keys", &keymap::markdown());
    check_block("scripts.md", "lines", &script_lines());
    check_block("mistakes.md", "mistakes", &mistakes());
    // Blank lines end the comments, so that Markdown begins anew.
    check_block("command-line.md", "commands", &format!("\n{}\n", command_reference()));
}

#[test]
fn the_window_and_the_terminal_can_show_every_page() {
    let pages = pages();
    assert!(pages.len() >= 14);
    for page in &pages {
        assert_eq!(manual::problems(manual::markdown(page.name).unwrap()), [], "{}", page.name);
        assert!(matches!(page.blocks[0], Block::Heading { level: 1, .. }), "{} has no title", page.name);
        let text = manual::text(page, 80);
        for line in text.lines().filter(|line| line.chars().count() > 80) {
            // What cannot be broken: code, and single words.
            assert!(line.starts_with("    ") || !line.trim_start_matches("* ").contains(' '), "{}: {line}", page.name);
        }
    }
}

#[test]
fn every_file_of_the_manual_is_a_page_of_the_contents() {
    let mut found: Vec<String> = fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter_map(|name| name.strip_suffix(".md").map(str::to_owned))
        .filter(|name| name != "SUMMARY")
        .collect();
    let mut listed = manual::names();
    found.sort();
    listed.sort();
    assert_eq!(found, listed);
}

#[test]
fn links_in_the_manual_resolve() {
    let pages = pages();
    let mut links = 0;
    for page in &pages {
        let anchors: Vec<&str> = page.anchors().collect();
        for (at, anchor) in anchors.iter().enumerate() {
            assert!(!anchors[..at].contains(anchor), "{}: two headings have the anchor {anchor}", page.name);
        }
        for link in page.links() {
            links += 1;
            match link {
                Link::Page { name, anchor } => {
                    let name = if name.is_empty() { page.name } else { name };
                    let target = pages.iter().find(|page| page.name == name);
                    let is_summary = name == "SUMMARY" && anchor.is_none();
                    assert!(target.is_some() || is_summary, "{}: there is no page {name}", page.name);
                    if let (Some(target), Some(anchor)) = (target, anchor) {
                        let has = target.anchors().any(|known| known == anchor);
                        assert!(has, "{}: {name} has no heading #{anchor}", page.name);
                    }
                }
                // The window cannot open addresses, so that the manual has none.
                Link::File(path) => assert!(folder().join(path).exists(), "{}: there is no {path}", page.name),
            }
        }
    }
    assert!(links > 30);
}

/// Where the links and pictures of a Markdown text lead.
fn destinations(markdown: &str) -> Vec<&str> {
    markdown.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(destination, _)| destination).collect()
}

#[test]
fn pictures_and_links_of_files_exist() {
    let mut files = vec![root().join("README.md"), root().join(".github/CONTRIBUTING.md"), root().join("CHANGELOG.md")];
    files.extend(pages().iter().map(|page| folder().join(page.name).with_extension("md")));
    let mut count = 0;
    for file in files {
        let text = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        for destination in destinations(&text).into_iter().filter(|destination| !destination.starts_with("https://")) {
            let path = destination.split('#').next().unwrap();
            let target = file.parent().unwrap().join(path);
            assert!(path.is_empty() || target.exists(), "{}: there is no {destination}", file.display());
            count += 1;
        }
    }
    assert!(count > 60);
}

#[test]
fn the_readme_is_short_and_pictures_are_small() {
    let words = fs::read_to_string(root().join("README.md")).unwrap().split_whitespace().count();
    assert!(words <= 900, "the README has {words} words");
    let pictures = fs::read_dir(folder().join("pictures")).unwrap();
    let bytes: u64 = pictures.map(|entry| entry.unwrap().metadata().unwrap().len()).sum();
    assert!(bytes <= 4 << 20, "the pictures have {bytes} bytes");
}

/// The JSON example of a page that is of a format.
fn example(page: &str, format: &str) -> String {
    let page = manual::page(page).unwrap();
    let is_wanted = |code: &&String| code.contains(&format!("\"format\": \"{format}\""));
    let codes: Vec<String> = page
        .blocks
        .into_iter()
        .filter_map(|block| if let Block::Code(code) = block { Some(code) } else { None })
        .collect();
    codes.iter().find(is_wanted).unwrap_or_else(|| panic!("no example of {format}")).clone()
}

#[test]
fn examples_of_files_can_be_read() {
    let scene = scene_from_json(&example("file-formats", "inbetween.scene")).unwrap_or_else(|error| panic!("{error}"));
    assert!(scene.is_timed());
    let settings = example("file-formats", "inbetween.settings");
    assert!(inbetween::settings::Settings::from_json(settings.as_bytes()).is_ok());
    // Its list of nodes is shortened, and nothing else is wrong with it.
    let keyframes = example("file-formats", "inbetween.keyframes");
    let scene = built_in_scene(DEFAULT_SCENE).unwrap();
    let errors = inbetween::keyframe::keyframes_from_json(keyframes.as_bytes(), &scene).err().unwrap();
    assert!(errors.iter().all(|error| error.to_string().contains("missing")), "{errors:?}");
}
