//! Completions of shells and pages for `man`.

use inbetween::cli::command_reference;

use crate::sandbox::Sandbox;

fn commands() -> Vec<String> {
    let reference = command_reference();
    reference.lines().filter_map(|line| Some(line.strip_prefix("### inbetween ")?.to_owned())).collect()
}

#[test]
fn every_shell_gets_completions_of_every_command() {
    let sandbox = Sandbox::new();
    for shell in ["bash", "zsh", "fish", "powershell"] {
        let script = sandbox.run(&["completions", shell]).succeeds();
        for command in commands() {
            assert!(script.contains(&command), "{shell}: {command}");
        }
        assert!(script.contains("tolerance-rotation") && !script.contains("panic-at"), "{shell}");
    }
    sandbox.run(&["completions", "nosuch"]).misuses();
}

/// What bash proposes after some words is what can stand there.
#[cfg(target_os = "linux")]
#[test]
fn bash_completes_commands_options_and_values() {
    let sandbox = Sandbox::new();
    sandbox.write("completions", sandbox.run(&["completions", "bash"]).succeeds());
    let proposed = |words: &[&str]| -> Vec<String> {
        let quoted: Vec<String> = words.iter().map(|word| format!("'{word}'")).collect();
        let script = format!(
            "source ./completions; COMP_WORDS=({}); COMP_CWORD={}; _inbetween inbetween '{}' '{}'; printf '%s\\n' \"${{COMPREPLY[@]}}\"",
            quoted.join(" "),
            words.len() - 1,
            words[words.len() - 1],
            words[words.len() - 2],
        );
        let output =
            std::process::Command::new("bash").args(["-c", &script]).current_dir(sandbox.path("")).output().unwrap();
        assert_eq!(String::from_utf8_lossy(&output.stderr), "");
        String::from_utf8(output.stdout).unwrap().lines().map(str::to_owned).collect()
    };
    assert_eq!(proposed(&["inbetween", "conv"]), ["convert"]);
    assert_eq!(proposed(&["inbetween", "render", "--mani"]), ["--manifest"]);
    assert_eq!(proposed(&["inbetween", "sample", "--format", ""]), ["json", "csv"]);
}

#[test]
fn man_has_a_page_for_each_command() {
    let sandbox = Sandbox::new();
    let said = sandbox.run(&["man", "share/man1"]).succeeds();
    let commands = commands();
    assert!(said.starts_with(&format!("{} pages in ", commands.len() + 1)), "{said}");
    let page = |name: &str| sandbox.read(&format!("share/man1/{name}.1"));
    for command in &commands {
        let page = page(&format!("inbetween-{command}"));
        assert!(page.contains(".SH SYNOPSIS") && page.contains("Examples:"), "{command}");
    }
    assert!(page("inbetween").contains("inbetween\\-check(1)"));
    assert_eq!(std::fs::read_dir(sandbox.path("share/man1")).unwrap().count(), commands.len() + 1);
}
