//! Files that are replaced, overwritten and written to directly; drafts of killed programs; stamps.

use std::fs;
use std::io::Write as _;

use tempfile::{TempDir, tempdir};

use super::*;

/// A folder and its entries' names, for "nothing else is there".
fn names(folder: &TempDir) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn a_file_is_replaced_whole_and_nothing_else_is_left() {
    let folder = tempdir().unwrap();
    let path = folder.path().join("a.json");
    for content in [b"first".as_slice(), b"second", b""] {
        write(&path, content).unwrap();
        assert_eq!(fs::read(&path).unwrap(), content);
    }
    drop(Draft::new(&path).unwrap());
    assert_eq!((fs::read(&path).unwrap(), names(&folder)), (Vec::new(), vec!["a.json".to_owned()]));
}

#[test]
fn a_draft_of_a_killed_program_is_removed_and_one_in_use_is_not() {
    let folder = tempdir().unwrap();
    let path = folder.path().join("film.mp4");
    // A killed program leaves its draft, whose lock goes with it.
    let (_, left) =
        tempfile::Builder::new().prefix(&*draft_prefix_of(&path)).tempfile_in(&folder).unwrap().keep().unwrap();
    let used = Foreign::new(&path).unwrap();
    assert!(!left.exists());
    let mut second = Draft::new(&path).unwrap();
    assert!(used.path().exists());
    second.write_all(b"second").unwrap();
    second.commit().unwrap();
    fs::write(used.path(), b"first").unwrap();
    used.commit().unwrap();
    assert_eq!((fs::read(&path).unwrap(), names(&folder)), (b"first".to_vec(), vec!["film.mp4".to_owned()]));
}

fn draft_prefix_of(path: &Path) -> String {
    let draft = Foreign::new(path).unwrap();
    let name = draft.path().file_name().unwrap().to_str().unwrap().to_owned();
    name.rsplit_once('-').unwrap().0.to_owned() + "-"
}

#[test]
fn a_name_of_255_bytes_can_be_written() {
    let folder = tempdir().unwrap();
    let path = folder.path().join("n".repeat(250) + ".json");
    write(&path, b"all").unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"all");
    for ending in [".bak", ".bak2"] {
        let kept = keep_copy(&path).unwrap().unwrap();
        let expected = "n".repeat(250) + ".json";
        assert_eq!(kept.file_name().unwrap().to_str().unwrap(), format!("{}{ending}", &expected[..255 - ending.len()]));
        assert_eq!(fs::read(kept).unwrap(), b"all");
    }
}

#[test]
fn a_stamp_notices_what_others_write() {
    let folder = tempdir().unwrap();
    let path = folder.path().join("a.json");
    let (stamp, _) = write_stamped(&path, |file| file.write_all(b"mine")).unwrap();
    assert!(stamp.looks_same(&path) && stamp.is_same(&path));
    assert!(Stamp::of(&path, b"mine").is_same(&path));
    // The same length, so that only the content tells.
    fs::write(&path, b"your").unwrap();
    assert!(!stamp.is_same(&path));
    fs::remove_file(&path).unwrap();
    assert!(!stamp.looks_same(&path) && !stamp.is_same(&path));
}

#[test]
fn what_other_programs_did_to_known_files_is_told() {
    let folder = tempdir().unwrap();
    let path = folder.path().join("a.json");
    let mut known = KnownFiles::default();
    fs::write(&path, b"old").unwrap();
    assert_eq!((known.change(&path), known.suspect(&path)), (None, None), "nothing is known of it");
    known.begin(&path);
    assert_eq!((known.change(&path), known.suspect(&path)), (None, None));
    fs::write(&path, b"newer").unwrap();
    assert_eq!(known.change(&path), Some(OutsideChange::Changed));
    assert_eq!(known.suspect(&path), Stamp::unread(&path));
    known.read(&path, b"newer");
    assert_eq!(known.change(&path), Some(OutsideChange::Changed), "nobody took it in");
    known.read(&path, b"newer");
    known.took_in();
    assert_eq!(known.change(&path), None);
    // The same content again, at another time.
    fs::write(&path, b"newer").unwrap();
    fs::File::options().write(true).open(&path).unwrap().set_modified(std::time::UNIX_EPOCH).unwrap();
    assert_eq!((known.change(&path), known.suspect(&path).is_some()), (None, true));
    fs::remove_file(&path).unwrap();
    assert_eq!((known.change(&path), known.suspect(&path)), (None, None), "what is gone cannot be lost");
}

#[test]
fn a_file_that_was_not_there_at_first_has_appeared() {
    let folder = tempdir().unwrap();
    let path = folder.path().join("a.json");
    let mut known = KnownFiles::default();
    known.begin(&path);
    assert_eq!(known.change(&path), None);
    fs::write(&path, b"other").unwrap();
    assert_eq!((known.change(&path), known.knows(&path)), (Some(OutsideChange::Appeared), false));
    let (stamp, _) = write_stamped(&path, |file| file.write_all(b"mine")).unwrap();
    known.wrote(&path, stamp);
    assert_eq!((known.change(&path), known.knows(&path)), (None, true));
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::{FileTypeExt as _, MetadataExt as _, PermissionsExt as _, symlink};

    use super::*;

    fn mode(path: &Path) -> u32 {
        fs::symlink_metadata(path).unwrap().mode() & 0o777
    }

    #[test]
    fn the_mode_stays_and_a_new_file_has_that_of_the_umask() {
        let folder = tempdir().unwrap();
        let (ours, plain) = (folder.path().join("a"), folder.path().join("b"));
        fs::write(&plain, b"").unwrap();
        write(&ours, b"").unwrap();
        assert_eq!(mode(&ours), mode(&plain));
        fs::set_permissions(&ours, fs::Permissions::from_mode(0o640)).unwrap();
        write(&ours, b"again").unwrap();
        assert_eq!(mode(&ours), 0o640);
    }

    #[test]
    fn a_read_only_file_is_refused_for_root_too() {
        let folder = tempdir().unwrap();
        let path = folder.path().join("kept.json");
        fs::write(&path, b"kept").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
        let error = write(&path, b"new").unwrap_err();
        assert_eq!(error.to_string(), "it is read-only");
        assert_eq!(fs::read(&path).unwrap(), b"kept");
    }

    #[test]
    fn a_link_stays_one_and_a_dangling_one_gets_its_target() {
        let folder = tempdir().unwrap();
        fs::create_dir(folder.path().join("not")).unwrap();
        let (link, target) = (folder.path().join("link.json"), folder.path().join("not").join("yet.json"));
        symlink("not/yet.json", &link).unwrap();
        for content in [b"one".as_slice(), b"two"] {
            write(&link, content).unwrap();
            assert!(link.is_symlink());
            assert_eq!(fs::read(&target).unwrap(), content);
        }
        let plain = folder.path().join("plain");
        fs::write(&plain, b"").unwrap();
        assert_eq!(mode(&target), mode(&plain));
    }

    #[test]
    fn links_in_a_circle_are_refused() {
        let folder = tempdir().unwrap();
        let (one, two) = (folder.path().join("one"), folder.path().join("two"));
        symlink(&two, &one).unwrap();
        symlink(&one, &two).unwrap();
        assert!(write(&one, b"").is_err());
        assert!(one.is_symlink() && two.is_symlink());
    }

    #[test]
    fn a_pipe_is_written_into() {
        let folder = tempdir().unwrap();
        let pipe = folder.path().join("pipe.y4m");
        rustix::fs::mkfifoat(rustix::fs::CWD, &pipe, rustix::fs::Mode::from_raw_mode(0o600)).unwrap();
        let reader = {
            let pipe = pipe.clone();
            std::thread::spawn(move || fs::read(pipe).unwrap())
        };
        write(&pipe, b"frames").unwrap();
        assert_eq!(reader.join().unwrap(), b"frames");
        assert!(fs::symlink_metadata(&pipe).unwrap().file_type().is_fifo());
        assert!(is_stream(&pipe));
    }

    #[test]
    fn other_names_of_a_file_are_counted() {
        let folder = tempdir().unwrap();
        let (path, other) = (folder.path().join("a.json"), folder.path().join("b.json"));
        fs::write(&path, b"old").unwrap();
        fs::hard_link(&path, &other).unwrap();
        let (_, committed) = write_stamped(&path, |file| file.write_all(b"new")).unwrap();
        assert_eq!(committed.other_links, 1);
        assert_eq!(fs::read(&other).unwrap(), b"old");
    }
}
