//! The cases written by hand: `=== NAME`, or `=== NAME > FILE` where the file has another name, directives, and the text of a script
//! or file.
//!
//! Directives begin with `@ `:
//!
//! * `run ARGUMENTS`: the arguments of the program, with `{}` for the case's file. Before the first case of a group it is for all that
//!   follow; within a case it is for that case, and there can be several.
//! * `with NAME = BASE`: a further file in the case's folder.
//! * `link NAME = TARGET`: a symbolic link in the case's folder.
//! * `env NAME=VALUE`: a variable of the environment of all runs.
//! * `from BASE`: the text is that of `bases.rs`, changed by the directives that follow it.
//! * `replace OLD => NEW`: the first OLD becomes NEW. `every OLD => NEW`: each does.
//! * `lines COUNT`: only the first lines are kept. `cut COUNT`: the last bytes go. `append TEXT`, `prepend TEXT`.
//!
//! `\n` in directives is a line's end, and `\xNN` a byte, in the text too.

use crate::bases;

/// Something to run in a folder of its own.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its name.
    pub name: String,
    /// The name of its file.
    pub file: String,
    /// The file's bytes.
    pub bytes: Vec<u8>,
    /// Further files.
    pub with: Vec<(String, Vec<u8>)>,
    /// Symbolic links, and their targets.
    pub links: Vec<(String, String)>,
    /// The arguments of each run, with `{}` for the file.
    pub runs: Vec<String>,
    /// Variables of the environment, and their values.
    pub environment: Vec<(String, String)>,
}

impl Case {
    /// A case with one run.
    pub fn new(name: String, bytes: Vec<u8>, run: &str) -> Self {
        Self {
            file: name.clone(),
            name,
            bytes,
            with: Vec::new(),
            links: Vec::new(),
            runs: vec![run.to_owned()],
            environment: Vec::new(),
        }
    }
}

pub const RUN_SCRIPT: &str = "script {} --trace --state state.json";

/// The scripts.
pub fn scripts(text: &str) -> Vec<Case> {
    cases(text, RUN_SCRIPT)
}

/// Whole commands, right and wrong.
pub fn programs(text: &str) -> Vec<Case> {
    cases(text, "")
}

/// The bad files.
pub fn files(text: &str) -> Vec<Case> {
    cases(text, "")
}

fn cases(text: &str, run: &str) -> Vec<Case> {
    let mut group = vec![run.to_owned()];
    let mut cases: Vec<Case> = Vec::new();
    let mut sections = text.split("=== ");
    let head = sections.next().unwrap_or_default();
    take_group(head, &mut group);
    for section in sections {
        let (name, body) = section.split_once('\n').expect("a case has a line of its own");
        // What stands after a blank line and `@@` belongs to the next group.
        let (body, next) = body.split_once("\n@@\n").map_or((body, ""), |(body, next)| (body, next));
        cases.push(case(name.trim(), body, &group));
        take_group(next, &mut group);
    }
    let mut names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
    names.sort_unstable();
    let twice = names.windows(2).find(|pair| pair[0] == pair[1]);
    assert_eq!(twice, None, "a name stands twice");
    cases
}

fn take_group(text: &str, group: &mut Vec<String>) {
    let runs: Vec<String> = text.lines().filter_map(|line| line.strip_prefix("@ run ")).map(str::to_owned).collect();
    if !runs.is_empty() {
        *group = runs;
    }
}

fn case(name: &str, body: &str, group: &[String]) -> Case {
    let (name, file) = name.split_once(" > ").unwrap_or((name, name));
    let mut case = Case {
        name: name.to_owned(),
        file: file.to_owned(),
        bytes: Vec::new(),
        with: Vec::new(),
        links: Vec::new(),
        runs: Vec::new(),
        environment: Vec::new(),
    };
    let mut literal: Vec<&str> = Vec::new();
    for line in body.lines() {
        let Some(directive) = line.strip_prefix("@ ") else {
            literal.push(line);
            continue;
        };
        let (word, rest) = directive.split_once(' ').unwrap_or((directive, ""));
        match word {
            "run" => case.runs.push(rest.to_owned()),
            "with" => {
                let (file, base) = rest.split_once(" = ").expect("with NAME = BASE");
                case.with.push((file.to_owned(), bases::base(base).into_bytes()));
            }
            "link" => {
                let (file, target) = rest.split_once(" = ").expect("link NAME = TARGET");
                case.links.push((file.to_owned(), target.to_owned()));
            }
            "env" => {
                let (variable, value) = rest.split_once('=').expect("env NAME=VALUE");
                case.environment.push((variable.to_owned(), value.to_owned()));
            }
            "from" => case.bytes = bases::base(rest).into_bytes(),
            _ => case.bytes = changed(name, &case.bytes, word, rest),
        }
    }
    if case.runs.is_empty() {
        case.runs = group.to_vec();
    }
    if case.bytes.is_empty() {
        while literal.last().is_some_and(|line| line.is_empty()) {
            literal.pop();
        }
        case.bytes = bytes(&literal.iter().map(|line| format!("{line}\n")).collect::<String>());
    } else {
        assert!(literal.iter().all(|line| line.is_empty()), "{name} has a base and a text: {literal:?}");
    }
    case
}

fn changed(name: &str, old: &[u8], word: &str, rest: &str) -> Vec<u8> {
    let count = || rest.parse::<usize>().unwrap_or_else(|_| panic!("{name}: {word} {rest}"));
    match word {
        "lines" => old.split_inclusive(|&byte| byte == b'\n').take(count()).flatten().copied().collect(),
        "cut" => old[..old.len() - count()].to_vec(),
        "append" => [old, &bytes(&rest.replace("\\n", "\n"))].concat(),
        "prepend" => [&bytes(&rest.replace("\\n", "\n")), old].concat(),
        "replace" | "every" => {
            let (from, to) = rest.split_once("=>").unwrap_or_else(|| panic!("{name}: {rest}"));
            let (from, to) =
                (bytes(&from.trim_end().replace("\\n", "\n")), bytes(&to.trim_start().replace("\\n", "\n")));
            let mut new = Vec::new();
            let mut rest = old;
            while let Some(at) = rest.windows(from.len()).position(|window| window == from) {
                new.extend_from_slice(&rest[..at]);
                new.extend_from_slice(&to);
                rest = &rest[at + from.len()..];
                if word == "replace" {
                    break;
                }
            }
            assert!(rest.len() < old.len(), "{name}: there is no {:?}", String::from_utf8_lossy(&from));
            new.extend_from_slice(rest);
            new
        }
        _ => panic!("{name}: {word} is no directive"),
    }
}

/// A text's bytes, with `\xNN` as one byte.
fn bytes(text: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once("\\x") {
        bytes.extend_from_slice(before.as_bytes());
        bytes.push(u8::from_str_radix(&after[..2], 16).expect("\\x has two hexadecimal digits"));
        rest = &after[2..];
    }
    bytes.extend_from_slice(rest.as_bytes());
    bytes
}
