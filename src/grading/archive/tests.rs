//! Archives in memory, with links, bounds, and what cannot be read.

use std::io::Write as _;

use super::*;

#[test]
fn the_first_bytes_tell_the_kind() {
    assert_eq!(ArchiveKind::of(b"PK\x03\x04..."), Some(ArchiveKind::Zip));
    assert_eq!(ArchiveKind::of(b"Rar!\x1a\x07\x01\0"), Some(ArchiveKind::Other("RAR")));
    assert_eq!(ArchiveKind::of(b"7z\xbc\xaf\x27\x1c").map(ArchiveKind::name).as_deref(), Some("a 7z archive"));
    let mut header = tar::Header::new_old();
    header.set_path("a.txt").expect("it is short");
    header.set_cksum();
    assert_eq!(ArchiveKind::of(header.as_bytes()), Some(ArchiveKind::Tar));
    for text in [&b""[..], &[0; 512], &[b'7'; 512], b"PKs are letters"] {
        assert_eq!(ArchiveKind::of(text), None);
    }
}

#[test]
fn links_lead_nowhere_but_inside() {
    assert_eq!(linked("a/b", "c"), Some("a/c".to_owned()));
    assert_eq!(linked("a/b", "../c"), Some("c".to_owned()));
    assert_eq!(linked("b", "../b"), None);
    assert_eq!(linked("a/b", "/etc/passwd"), None);
    assert_eq!(normalized("", "../../x/./y"), Some("x/y".to_owned()));
}

const ALL: Keep = Keep { largest: &|_| Some(1000), most: 10_000, through: 1 << 20 };

fn opened(bytes: &[u8], keep: &Keep) -> Result<Archive, String> {
    let kind = ArchiveKind::of(&bytes[..bytes.len().min(HEAD_BYTES)]).expect("an archive");
    Archive::open("class.tar", kind, Source::Memory(Cursor::new(bytes.into())), keep)
}

fn tar(add: impl FnOnce(&mut tar::Builder<Vec<u8>>)) -> Vec<u8> {
    let mut builder = tar::Builder::new(Vec::new());
    add(&mut builder);
    builder.into_inner().expect("it is in memory")
}

fn append(builder: &mut tar::Builder<Vec<u8>>, name: &str, bytes: &[u8]) {
    let mut header = tar::Header::new_gnu();
    header.set_size(bytes.len() as u64);
    builder.append_data(&mut header, name, bytes).expect("it is in memory");
}

fn link(builder: &mut tar::Builder<Vec<u8>>, name: &str, target: &str) {
    let mut header = tar::Header::new_gnu();
    header.set_entry_type(tar::EntryType::Symlink);
    header.set_size(0);
    builder.append_link(&mut header, name, target).expect("it is in memory");
}

fn zipped(name: &str, bytes: &[u8]) -> Vec<u8> {
    let mut writer = zip::ZipWriter::new(Cursor::new(Vec::new()));
    writer.start_file(name, zip::write::SimpleFileOptions::default()).expect("it is in memory");
    writer.write_all(bytes).expect("it is in memory");
    writer.add_symlink("a/link", "../b.txt", zip::write::SimpleFileOptions::default()).expect("it is in memory");
    writer.finish().expect("it is in memory").into_inner()
}

#[test]
fn a_tar_is_a_tree_of_names() {
    let bytes = tar(|builder| {
        append(builder, "./a/b/c.txt", b"text");
        append(builder, "a/long name 김.txt", &[b'x'; 1001]);
        link(builder, "a/in", "b/c.txt");
        link(builder, "a/out", "../../etc/passwd");
    });
    let archive = opened(&bytes, &ALL).expect("it is right");
    assert_eq!((archive.names(""), archive.names("a/b")), (vec!["a"], vec!["c.txt"]));
    assert_eq!(archive.names("a"), ["b", "in", "long name 김.txt", "out"]);
    assert_eq!(archive.read("a/b/c.txt", 2), Ok(b"te".to_vec()));
    assert_eq!(archive.read("a/long name 김.txt", 2), Err(Unread::Large));
    assert!(matches!(archive.item("a/in"), Some(Item::Link(Some(target))) if target == "a/b/c.txt"));
    assert!(matches!(archive.item("a/out"), Some(Item::Link(None))));
    assert!(archive.read("a/in", 2).is_err() && archive.read("nothing", 2).is_err());
}

#[test]
fn names_of_a_tar_are_judged_without_dots() {
    let bytes = tar(|builder| {
        append(builder, "./a/b.json", b"text");
        append(builder, "./.git/config", b"text");
    });
    let is_wanted = |path: &str| (!path.split('/').any(|part| part.starts_with('.'))).then_some(100);
    let archive = opened(&bytes, &Keep { largest: &is_wanted, ..ALL }).expect("it is right");
    assert_eq!(archive.read("a/b.json", 9), Ok(b"text".to_vec()));
    assert!(archive.read(".git/config", 9).is_err());
}

#[test]
fn what_is_kept_of_a_tar_is_bounded() {
    let bytes = tar(|builder| (0..4).for_each(|number| append(builder, &format!("{number}.txt"), &[b'x'; 900])));
    let some = opened(&bytes, &Keep { most: 2000, ..ALL }).expect("it is right");
    assert_eq!([some.read("1.txt", 1).is_ok(), some.read("2.txt", 1).is_ok()], [true, false]);
    let sentence = opened(&bytes, &Keep { through: 3000, ..ALL }).expect_err("it is longer");
    assert_eq!(sentence, "it unpacks to more than 0 MiB");
    let sentence = opened(&bytes[..1000], &ALL).expect_err("it is cut off");
    assert!(sentence.starts_with("the tar is broken or cut off: "), "{sentence}");
}

#[test]
fn gzip_packs_one_file_or_a_tar() {
    let packed = |bytes: &[u8]| {
        let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        packer.write_all(bytes).expect("it is in memory");
        packer.finish().expect("it is in memory")
    };
    let archive = opened(&packed(&tar(|builder| append(builder, "a.txt", b"text"))), &ALL).expect("it is right");
    assert_eq!(archive.names(""), ["a.txt"]);
    let bytes = packed(b"text");
    let source = Source::Memory(Cursor::new(bytes.clone().into()));
    let archive = Archive::open("up/a.txt.GZ", ArchiveKind::Gzip, source, &ALL).expect("it is right");
    assert_eq!((archive.names(""), archive.read("a.txt", 9)), (vec!["a.txt"], Ok(b"text".to_vec())));
    assert!(opened(&bytes[..bytes.len() - 9], &ALL).is_err());
}

#[test]
fn what_a_zip_cannot_give_is_said() {
    let mut bytes = zipped("a/b.txt", b"some text, some text, some text");
    let archive = opened(&bytes, &ALL).expect("it is right");
    assert_eq!(archive.read("a/b.txt", 4), Ok(b"some".to_vec()));
    assert!(matches!(archive.item("a/link"), Some(Item::Link(Some(target))) if target == "b.txt"));
    let at = |bytes: &[u8], mark: &[u8]| bytes.windows(4).position(|window| window == mark).expect("it has headers");
    let (local, central) = (at(&bytes, b"PK\x03\x04"), at(&bytes, b"PK\x01\x02"));
    bytes[local + 8] = 12;
    bytes[central + 10] = 12;
    let unread = opened(&bytes, &ALL).expect("its list is right").read("a/b.txt", 4);
    assert_eq!(unread, Err(Unread::Problem("it is packed with bzip2, and only Deflate is unpacked".to_owned())));
    bytes[local + 6] |= 1;
    bytes[central + 8] |= 1;
    let unread = opened(&bytes, &ALL).expect("its list is right").read("a/b.txt", 4);
    assert_eq!(unread, Err(Unread::Problem("it needs a password".to_owned())));
    assert_eq!(opened(&bytes[..60], &ALL).expect_err("it is cut off"), "the zip is broken or cut off");
    let sentence = opened(b"7z\xbc\xaf\x27\x1c", &ALL).expect_err("it is of another kind");
    assert_eq!(sentence, "it is a 7z archive, and only zip, tar and tar.gz are opened");
}

/// A zip whose names are these bytes, as programs write it that know nothing of UTF-8.
fn zip_of_names(names: &[&[u8]]) -> Vec<u8> {
    let mut writer = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let stand_in = |index: usize, name: &[u8]| format!("{index:\u{7e}<width$}", width = name.len());
    for (index, name) in names.iter().enumerate() {
        writer.start_file(stand_in(index, name), zip::write::SimpleFileOptions::default()).expect("it is in memory");
        writer.write_all(b"text").expect("it is in memory");
    }
    let mut bytes = writer.finish().expect("it is in memory").into_inner();
    for (index, name) in names.iter().enumerate() {
        let stand_in = stand_in(index, name);
        while let Some(at) = bytes.windows(name.len()).position(|window| window == stand_in.as_bytes()) {
            bytes[at..at + name.len()].copy_from_slice(name);
        }
    }
    bytes
}

#[test]
fn names_of_zips_are_decoded() {
    // 김철수/걷기.txt of Korean Windows, and a name in UTF-8.
    let korean =
        zip_of_names(&[b"\xb1\xe8\xc3\xb6\xbc\xf6/\xb0\xc8\xb1\xe2.txt", "이수진.txt".as_bytes(), b"plain.txt"]);
    let archive = opened(&korean, &ALL).expect("it is right");
    assert_eq!(archive.names(""), ["plain.txt", "김철수", "이수진.txt"]);
    assert_eq!(archive.read("김철수/걷기.txt", 9), Ok(b"text".to_vec()));
    // Müller.txt and élan.txt of code page 437: the second would be Korean too.
    let western = opened(&zip_of_names(&[b"M\x81ller.txt", b"\x82lan.txt"]), &ALL).expect("it is right");
    assert_eq!(western.names(""), ["Müller.txt", "élan.txt"]);
    // A name that is none of code page 949, in a zip that is of it.
    let mixed = opened(&zip_of_names(&[b"\xb0\xc8\xb1\xe2.txt", b"caf\x82.txt"]), &ALL).expect("it is right");
    assert_eq!(mixed.names(""), ["café.txt", "걷기.txt"]);
}
