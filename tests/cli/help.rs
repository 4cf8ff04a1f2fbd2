//! `inbetween help`: commands, pages of the manual, and what is neither.

use inbetween::manual;

use crate::sandbox::Sandbox;

#[test]
fn the_help_of_a_command_is_that_of_its_option() {
    let sandbox = Sandbox::new();
    for command in ["check", "render", "script", "help"] {
        assert_eq!(sandbox.run(&["help", command]).succeeds(), sandbox.run(&[command, "--help"]).succeeds());
    }
}

#[test]
fn every_page_is_printed_and_listed() {
    let sandbox = Sandbox::new();
    let list = sandbox.run(&["help"]).succeeds();
    assert!(list.starts_with(&sandbox.run(&["--help"]).succeeds()));
    for name in manual::names() {
        assert!(list.contains(&format!("\n  {name} ")), "{name} is not listed");
        let page = sandbox.run(&["help", &name]).succeeds();
        let title = page.lines().next().unwrap();
        assert_eq!(page.lines().nth(1), Some("=".repeat(title.len()).as_str()), "{name}");
    }
}

/// The help of a command names the page that says more, and that page is there.
#[test]
fn commands_name_pages() {
    let sandbox = Sandbox::new();
    let named = |command: &str| {
        let help = sandbox.run(&[command, "--help"]).succeeds();
        let page = help.lines().find_map(|line| line.strip_prefix("Manual: inbetween help "));
        page.map_or_else(|| panic!("{command} names no page"), str::to_owned)
    };
    for command in ["convert", "sample", "render", "verify", "compare", "script", "diagnose", "diff", "grade"] {
        assert!(manual::page(&named(command)).is_some(), "{command}");
    }
}

#[test]
fn an_unknown_topic_is_wrong_usage_with_a_suggestion() {
    let sandbox = Sandbox::new();
    for (topic, suggestion) in [("chekc", "'check'"), ("gradin", "'grading'"), ("SUMMARY", "grading")] {
        let outcome = sandbox.run(&["help", topic]);
        assert!(outcome.stderr.contains(suggestion), "{}", outcome.stderr);
        outcome.misuses();
    }
}

#[test]
fn the_version_says_in_full_what_a_report_of_a_fault_needs() {
    let sandbox = Sandbox::new();
    let version = format!("inbetween {}\n", env!("CARGO_PKG_VERSION"));
    for short in [&["--version"][..], &["-V"]] {
        assert_eq!(sandbox.run(short).succeeds(), version);
    }
    let said = sandbox.run(&["--version", "--verbose"]).succeeds();
    let facts = said.strip_prefix(&version).unwrap_or_else(|| panic!("{said}"));
    let labels: Vec<&str> = facts.lines().filter_map(|line| Some(line.split_once(": ")?.0)).collect();
    assert_eq!(labels, ["commit", "build", "system", "session", "adapter", "driver", "API"], "{said}");
    assert!(facts.lines().all(|line| !line.ends_with(": ")), "{said}");
    assert!(facts.contains("rustc 1."), "{said}");
    sandbox.run(&["--verbose"]).misuses();
}

#[cfg(target_os = "linux")]
#[test]
fn without_an_adapter_the_version_says_so_and_all_is_well() {
    let sandbox = Sandbox::new();
    let mut command = sandbox.command(&["--version", "--verbose"]);
    command.env("VK_DRIVER_FILES", "/nonexistent.json");
    let said = Sandbox::outcome(command).succeeds();
    assert!(said.contains("\nadapter: no GPU adapter was found: "), "{said}");
}

#[test]
fn the_licences_of_what_the_program_is_made_of_are_a_topic() {
    let sandbox = Sandbox::new();
    assert!(sandbox.run(&["help"]).succeeds().contains("inbetween help licences"));
    assert_eq!(sandbox.run(&["help", "licences"]).succeeds(), inbetween::notices::text());
}
