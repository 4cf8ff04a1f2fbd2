//! What is typed, completed and shown.

use super::*;

fn dialog(purpose: PathPurpose, typed: &str) -> PathDialog {
    let mut dialog = PathDialog::new(purpose, Path::new(typed));
    dialog.typed = typed.to_owned();
    let entry = |name: &str, is_folder| FolderEntry { name: name.to_owned(), is_folder };
    let entries = vec![
        entry("walk.json", false),
        entry("walk-2.json", false),
        entry("notes.pdf", false),
        entry("Lessons", true),
        entry(".git", true),
        entry("걷기.json", false),
    ];
    dialog.put(Listing { folder: dialog.folder(), entries: Ok(entries), home: None });
    dialog
}

fn names(dialog: &PathDialog) -> Vec<String> {
    dialog.shown().into_iter().map(|entry| entry.name).collect()
}

#[test]
fn what_is_typed_names_a_folder_and_narrows_it() {
    let open = |typed| dialog(PathPurpose::Open, typed);
    assert_eq!(open("walk").folder(), Path::new("."));
    assert_eq!(open("a/b/walk").folder(), Path::new("a/b/"));
    assert_eq!(open("/").folder(), Path::new("/"));
    assert_eq!(names(&open("a/")), ["Lessons", "walk-2.json", "walk.json", "걷기.json"]);
    assert_eq!(names(&open("a/WA")), ["walk-2.json", "walk.json"]);
    assert_eq!(names(&open("a/.")), [".git"]);
    // A file that is named whole hides no others, and neither does a name that is to be saved.
    assert_eq!(names(&open("a/walk.json")).len(), 4);
    assert_eq!(names(&dialog(PathPurpose::SaveAs, "a/new.json")).len(), 4);
}

#[test]
fn tab_completes_what_is_common() {
    let completed = |typed| dialog(PathPurpose::Open, typed).completed();
    assert_eq!(completed("a/w").as_deref(), Some("a/walk"));
    assert_eq!(completed("a/walk"), None);
    assert_eq!(completed("a/walk-").as_deref(), Some("a/walk-2.json"));
    assert_eq!(completed("L").as_deref(), Some("Lessons/"));
    assert_eq!(completed("걷").as_deref(), Some("걷기.json"));
    assert_eq!(completed("notes"), None);
}

#[test]
fn places_keep_the_name_that_is_to_be_saved() {
    let mut save = dialog(PathPurpose::SaveAs, "a/new.json");
    save.go_to(Path::new("/home/me"));
    assert_eq!(save.typed, "/home/me/new.json");
    let mut open = dialog(PathPurpose::Open, "a/walk.json");
    open.go_to(&above(Path::new("a/")));
    assert_eq!(open.typed, "./");
    for (folder, expected) in [("/a/b/", "/a"), ("/", "/"), (".", ".."), ("../", "../.."), ("a/b", "a")] {
        assert_eq!(above(Path::new(folder)), Path::new(expected), "{folder}");
    }
}
