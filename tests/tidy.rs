//! The architecture's rules, checked by reading the sources.
//!
//! `tidy/source.rs` parses them. Which module may import which is read from the table in `src/lib.rs`, its only home.

#[path = "tidy/source.rs"]
mod source;

use std::collections::BTreeMap;

use source::{Source, files, source, sources};

/// Asserts that only some modules of the top level name any of these paths.
#[track_caller]
fn only(paths: &[&str], allowed: &[&str]) {
    for source in sources() {
        for path in paths {
            assert!(
                allowed.contains(&source.room()) || !source.names(path),
                "src/{} names {path}, which only {allowed:?} may",
                source.name
            );
        }
    }
}

#[test]
fn only_the_window_names_winit() {
    only(&["winit", "egui_winit"], &["window"]);
}

#[test]
fn only_render_and_window_name_wgpu() {
    only(&["wgpu", "egui_wgpu"], &["render", "window"]);
}

#[test]
fn only_ui_and_window_name_egui() {
    only(&["egui"], &["ui", "window"]);
}

#[test]
fn only_the_command_line_names_clap() {
    only(&["clap"], &["cli"]);
}

/// All others ask it.
const MAY_TOUCH_FILES: [&str; 1] = ["storage"];

/// Methods of `Path` that ask the file system. The names of the rest are those of other types too.
const ASKING: [&str; 7] =
    ["exists", "try_exists", "is_file", "canonicalize", "symlink_metadata", "read_dir", "read_link"];

#[test]
fn only_storage_touches_the_file_system() {
    only(&["std::fs", "atomic_write_file", "tempfile"], &MAY_TOUCH_FILES);
    for source in sources().iter().filter(|source| !MAY_TOUCH_FILES.contains(&source.room())) {
        for method in ASKING {
            assert!(!source.methods.contains(method), "src/{} asks the file system by .{method}()", source.name);
        }
    }
}

#[test]
fn the_wall_clock_is_read_in_one_function_each() {
    only(&["std::time::Instant", "web_time::Instant"], &["window", "cli"]);
    // Files have times, which are compared and never asked of the clock.
    only(&["std::time::SystemTime", "web_time::SystemTime"], &["window", "cli", "storage"]);
    for room in ["window", "cli"] {
        let of_room = sources().iter().filter(|source| source.room() == room);
        let now = ["std::time::Instant::now", "web_time::Instant::now"];
        let readings: usize = of_room.flat_map(|source| now.map(|now| source.calls.get(now))).flatten().sum();
        assert!(readings <= 1, "{room} reads the clock in {readings} places");
    }
}

/// Statics hold constants, and caches that are filled once with what never differs.
#[test]
fn no_mutable_global_state() {
    // What they guard is the process's own: its standard error, and what a signal must clear away.
    // And the files of a page, which stand for a file system.
    const GUARDS: [(&str, &str); 4] = [
        ("render/quiet.rs", "REDIRECTING"),
        ("unfinished.rs", "ALL"),
        ("storage/page.rs", "HELD"),
        ("storage/page/fs.rs", "FILES"),
    ];
    // What the C library drops when Xlib ends the process is a value of a thread; so is what the browser hands to a page.
    const LOCAL: [&str; 2] = ["window/ending.rs", "window/page.rs"];
    const INNER_MUTABILITY: [&str; 6] = ["Cell", "RefCell", "UnsafeCell", "Mutex", "RwLock", "Once"];
    for source in sources() {
        let may_be_local = LOCAL.contains(&source.name.as_str());
        for shared in ["Rc", "RefCell"] {
            assert!(may_be_local || !source.names_part(shared), "src/{} names {shared}", source.name);
        }
        for local in ["thread_local", "lazy_static"] {
            assert!(
                may_be_local && local == "thread_local" || !source.macros.contains(local),
                "src/{} calls {local}!",
                source.name
            );
        }
        for (name, is_mutable, types) in &source.statics {
            let is_inner = |part: &str| INNER_MUTABILITY.contains(&part) || part.starts_with("Atomic");
            if GUARDS.contains(&(source.name.as_str(), name.as_str())) {
                continue;
            }
            let changes = types.iter().find(|path| path.split("::").any(is_inner));
            assert!(!is_mutable && changes.is_none(), "src/{}: the static {name} can change: {changes:?}", source.name);
        }
    }
}

/// The modules of the table in `src/lib.rs`: for each the row, the level, and the place in its row.
fn table() -> BTreeMap<String, (usize, u8, usize)> {
    let lib = include_str!("../src/lib.rs");
    let rows = lib.lines().filter_map(|line| line.strip_prefix("//! | ")).enumerate();
    let mut table = BTreeMap::new();
    for (row, line) in rows {
        let mut cells = line.split(" | ");
        let Some(Ok(level)) = cells.next().map(str::parse) else { continue };
        let modules = cells.next().expect("a row has modules").split("[`").skip(1);
        for (place, module) in modules.filter_map(|module| module.split('`').next()).enumerate() {
            let twice = table.insert(module.to_owned(), (row, level, place));
            assert_eq!(twice, None, "{module} stands twice in the table of src/lib.rs");
        }
    }
    assert!(table.len() > 20, "the table of src/lib.rs is not read: {table:?}");
    table
}

/// The import that a file may not have: one of a module that is neither on a lower level nor before its own in its row.
fn wrong_import<'a>(source: &'a Source, table: &BTreeMap<String, (usize, u8, usize)>) -> Option<&'a str> {
    let own = table.get(source.room());
    // `lib` and `main` stand above all.
    let &(row, level, place) = own?;
    source.rooms_named().into_iter().find(|other| {
        table.get(*other).is_some_and(|&(other_row, other_level, other_place)| {
            let is_before = other_row == row && other_place < place;
            *other != source.room() && other_level >= level && !is_before
        })
    })
}

#[test]
fn modules_import_only_from_below() {
    let table = table();
    for source in sources() {
        let is_known = table.contains_key(source.room()) || matches!(source.room(), "lib" | "main" | "page_build");
        assert!(is_known, "src/{} is in a module that the table of src/lib.rs does not have", source.name);
        let wrong = wrong_import(source, &table);
        assert_eq!(wrong, None, "src/{} imports from a module that is not below it", source.name);
    }
}

#[track_caller]
fn parsed(name: &str, text: &str) -> Source {
    source(name.to_owned(), &syn::parse_file(text).unwrap())
}

#[test]
fn every_way_to_import_is_seen() {
    let table = table();
    for text in [
        "use crate::render;",
        "use crate::{scene, render};",
        "use crate::{scene::SceneGraph, render::{self, Renderer as Draws}};",
        "use super::super::render::Renderer;",
        "use super::super::*; fn draw(renderer: super::super::render::Renderer) {}",
        "fn draw() { crate::render::draw() }",
        "fn draw() { println!(\"{}\", crate::render::draw()) }",
        "#[cfg(test)] mod tests; fn draw() -> crate::render::Renderer { todo!() }",
        "#[cfg(test)] mod tests { fn nothing() {} } use crate::render::Renderer;",
        "mod inner { use super::super::super::render::Renderer; }",
    ] {
        assert_eq!(wrong_import(&parsed("editor/apply.rs", text), &table), Some("render"), "{text}");
    }
    for text in [
        "use crate::scene;",
        "use super::document::Document;",
        "// use crate::render;",
        "#[cfg(test)] mod tests { use crate::render; }",
        "#[cfg(test)] use crate::render;",
    ] {
        assert_eq!(wrong_import(&parsed("editor/apply.rs", text), &table), None, "{text}");
    }
    for text in [
        "use std::fs;",
        "use std::{env, fs};",
        "use std::fs::File;",
        "use std::{env, fs}; fn list() { fs::read_dir(\".\"); }",
        "use std::fs as files; fn list() { files::read_to_string(\".\"); }",
        "fn list() { std::fs::read_dir(\".\"); }",
        "fn list() { assert!(std::fs::read_dir(\".\").is_ok()); }",
    ] {
        assert!(parsed("ui/menu.rs", text).names("std::fs"), "{text}");
    }
    let clock = parsed("cli/grade.rs", "use std::time::Instant; fn f() { Instant::now(); vec![Instant::now()]; }");
    assert_eq!(clock.calls.get("std::time::Instant::now"), Some(&2));
}

#[test]
fn render_can_draw_whatever_there_is() {
    for source in sources().iter().filter(|source| source.room() == "render") {
        for above in ["crate::editor", "crate::ui"] {
            assert!(!source.names(above), "src/{} names {above}", source.name);
        }
    }
}

#[test]
fn films_know_no_editor() {
    const MAY_KNOW: [&str; 7] = [
        "view.rs",
        "view/editor.rs",
        "view/gizmo.rs",
        "view/motion_path.rs",
        "view/frustum.rs",
        "view/limb_balls.rs",
        "view/comparison.rs",
    ];
    for source in sources() {
        let is_below =
            ["frame", "film", "export", "view"].contains(&source.room()) && !MAY_KNOW.contains(&&*source.name);
        assert!(!is_below || !source.rooms_named().contains("editor"), "src/{} names the editor", source.name);
    }
}

#[test]
fn files_are_one_idea_each() {
    for (name, text) in files() {
        let lines = text.lines().count();
        assert!(lines <= 600, "src/{name} has {lines} lines, and none has more than 600");
    }
}

#[test]
fn unwrap_is_for_tests() {
    assert!(parsed("rbt.rs", "fn f() { println!(\"{}\", x.unwrap()) }").methods.contains("unwrap"));
    for source in sources() {
        assert!(!source.methods.contains("unwrap"), "src/{} calls .unwrap()", source.name);
        for unfinished in ["todo", "unimplemented", "dbg"] {
            assert!(!source.macros.contains(unfinished), "src/{} calls {unfinished}!", source.name);
        }
    }
}

#[test]
fn every_module_opens_with_what_it_is() {
    for (name, text) in files() {
        assert!(text.starts_with("//!"), "src/{name} does not say what it is");
    }
}

#[test]
fn no_test_is_switched_off() {
    for (name, text) in files() {
        assert!(!text.contains(concat!("#[", "ignore")), "src/{name} switches a test off");
    }
}
