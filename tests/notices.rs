//! The notices name everything of others that is in the program.

use std::process::Command;

use inbetween::notices;

/// The crates that the program for a system is made of, as `NAME VERSION`.
fn crates(target: &str) -> Vec<String> {
    let arguments =
        ["tree", "--offline", "--locked", "--edges", "normal,no-proc-macro", "--prefix", "none", "--format", "{p}"];
    let mut cargo = Command::new(env!("CARGO"));
    let output = cargo.current_dir(env!("CARGO_MANIFEST_DIR")).args(arguments).args(["--target", target]).output();
    let output = output.expect("cargo starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("it is UTF-8");
    // `png v0.18.1`, and more for what is not from the registry.
    let mut crates: Vec<String> = text
        .lines()
        .filter_map(|line| line.split_once(" v"))
        .filter(|(name, _)| *name != env!("CARGO_PKG_NAME"))
        .map(|(name, rest)| format!("{name} {}", rest.split(' ').next().unwrap_or_default()))
        .collect();
    crates.sort();
    crates.dedup();
    crates
}

#[cfg(target_os = "linux")]
#[test]
fn every_crate_that_the_program_is_made_of_is_named() {
    let crates = crates("x86_64-unknown-linux-gnu");
    assert!(crates.len() > 150, "{crates:?}");
    let named: Vec<&str> = notices::lines().iter().flat_map(|line| line.split(", ")).collect();
    let missing: Vec<_> = crates.iter().filter(|name| !named.contains(&name.as_str())).collect();
    assert!(missing.is_empty(), "run .ci/notices: {missing:?} are not in assets/licences/THIRD-PARTY.txt");
}

/// Crates that only the page has. Cargo cannot say what a page is made of where it has not loaded these.
#[test]
fn crates_of_the_page_are_named() {
    let lock = include_str!("../Cargo.lock").replace("\r\n", "\n");
    let named: Vec<&str> = notices::lines().iter().flat_map(|line| line.split(", ")).collect();
    for name in ["js-sys", "wasm-bindgen", "wasm-bindgen-futures", "wasm-bindgen-shared", "web-sys", "web-time"] {
        let (_, rest) = lock.split_once(&format!("name = \"{name}\"\nversion = \"")).expect(name);
        let version = rest.split('"').next().unwrap_or_default();
        assert!(named.contains(&format!("{name} {version}").as_str()), "run .ci/notices: {name} {version} is missing");
    }
}

#[test]
fn what_crates_do_not_tell_is_there() {
    for part in [
        "The standard library of Rust",
        "The page's script inbetween.js",
        "Font of the Korean letters",
        "Font Ubuntu-Light",
        "Font Hack",
        "libwebp\n",
    ] {
        assert!(notices::text().contains(&format!("\n{part}")), "{part}");
    }
    for licence in
        ["SIL OPEN FONT LICENSE Version 1.1", "Permission is hereby granted, free of charge", "Apache License"]
    {
        assert!(notices::text().contains(licence), "{licence}");
    }
}
