//! The examples that the help of each command shows, and the page of the manual that says more.

/// What stands below a command's help.
struct Below {
    command: &'static str,
    /// A page of the manual.
    page: &'static str,
    /// Whole lines for a shell, with nothing quoted.
    examples: &'static [&'static str],
}

const ALL: [Below; 22] = [
    Below {
        command: "check",
        page: "command-line",
        examples: &["inbetween check walk.json", "inbetween check --quiet submissions/*.txt"],
    },
    Below {
        command: "convert",
        page: "texts",
        examples: &[
            "inbetween convert student.txt -o walk.json",
            "inbetween convert walk.json -o walk.csv --exact",
            "inbetween convert submissions/*.txt -o converted/",
        ],
    },
    Below {
        command: "info",
        page: "farms",
        examples: &["inbetween info walk.json", "inbetween info walk.json --fps 25 --json", "inbetween info *.json"],
    },
    Below {
        command: "nodes",
        page: "command-line",
        examples: &["inbetween nodes", "inbetween nodes --scene cylinder --json"],
    },
    Below {
        command: "sample",
        page: "command-line",
        examples: &[
            "inbetween sample walk.json --at 0,0.5,1",
            "inbetween sample walk.json --fps 30 -o walk.csv",
            "inbetween convert student.txt -o - | inbetween sample - --fps 30",
        ],
    },
    Below {
        command: "render",
        page: "films",
        examples: &[
            "inbetween render walk.json -o walk.png --at 0.5",
            "inbetween render walk.json -o walk.mp4 --size 1280x720",
            "inbetween render walk.json -o frames/ --fps 30 --frames 0-59",
            "inbetween render walk.json -o compared.gif --compare linear,catmull-rom,nlerp,matrix",
        ],
    },
    Below { command: "join", page: "farms", examples: &["inbetween join frames/ --fps 30 -o walk.mp4"] },
    Below {
        command: "import",
        page: "models",
        examples: &[
            "inbetween import robot.glb -o robot.json --keyframes motion.json",
            "inbetween import robot.glb -o robot.json --animation Walking --timed",
            "inbetween import capture.bvh -o captured.json --keyframes motion.json",
            "inbetween import capture.bvh -o captured.json --keyframes motion.json --every 10",
        ],
    },
    Below {
        command: "export",
        page: "models",
        examples: &[
            "inbetween export walk.json -o walk.glb",
            "inbetween export walk.json -o walk.gltf --curves cubic --tolerance 0.1,0.001",
            "inbetween export walk.json -o walk.bvh --fps 120",
        ],
    },
    Below {
        command: "retarget",
        page: "models",
        examples: &[
            "inbetween retarget capture.bvh --onto two-robots:robot1 -o walk.json",
            "inbetween retarget capture.bvh --onto two-robots -o walk.json --write-map map.json",
            "inbetween retarget walk.json --onto two-robots:robot2 -o other.json",
        ],
    },
    Below {
        command: "share",
        page: "browser",
        examples: &[
            "inbetween share walk.json -o walk-page",
            "inbetween share mine.json --compare reference.json -o page",
            "inbetween share mine.zip --report rubric.json -o page",
        ],
    },
    Below {
        command: "verify",
        page: "ci",
        examples: &["inbetween verify pictures/", "inbetween verify pictures/ --update --only walk*"],
    },
    Below {
        command: "compare",
        page: "films",
        examples: &[
            "inbetween compare reference.png actual.png -o difference.png",
            "inbetween compare reference.png one.png two.png --json",
            "inbetween compare references/ actual/ --quiet",
        ],
    },
    Below {
        command: "script",
        page: "scripts",
        examples: &["inbetween script wave.txt --keyframes wave.json", "inbetween script wave.txt --strict --trace"],
    },
    Below {
        command: "recover",
        page: "recovery",
        examples: &["inbetween recover --list", "inbetween recover -o rescued.json"],
    },
    Below {
        command: "diagnose",
        page: "grading",
        examples: &[
            "inbetween diagnose walk.json samples.csv",
            "inbetween diagnose walk.json --mistake sixth-in-integers --film mistake.gif",
        ],
    },
    Below {
        command: "diff",
        page: "grading",
        examples: &[
            "inbetween diff reference.json student.txt",
            "inbetween diff reference.json submissions/*.txt --quiet",
        ],
    },
    Below { command: "grade", page: "grading", examples: &["inbetween grade rubric.toml submissions.zip -o graded/"] },
    Below {
        command: "completions",
        page: "command-line",
        examples: &[
            "inbetween completions bash > ~/.local/share/bash-completion/completions/inbetween",
            "inbetween completions fish > ~/.config/fish/completions/inbetween.fish",
        ],
    },
    Below { command: "man", page: "command-line", examples: &["inbetween man ~/.local/share/man/man1"] },
    Below { command: "help", page: "command-line", examples: &["inbetween help sample", "inbetween help grading"] },
    Below {
        command: "",
        page: "first-steps",
        examples: &["inbetween", "inbetween walk.json", "inbetween --scene cylinder spin.json"],
    },
];

/// What stands below the help of a command; of the program itself, whose name here is empty, if there is no such command.
pub fn below(command: &str) -> String {
    let [.., program] = &ALL;
    let Below { page, examples, .. } = ALL.iter().find(|below| below.command == command).unwrap_or(program);
    format!("Examples:\n  {}\n\nManual: inbetween help {page}", examples.join("\n  "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::arguments::command;
    use crate::manual;

    /// The arguments of the programs of a line.
    fn runs(line: &str) -> Vec<Vec<&str>> {
        let without_redirection = line.split(" > ").next().unwrap_or_default();
        without_redirection.split(" | ").map(|run| run.split(' ').collect()).collect()
    }

    #[test]
    fn every_command_has_examples_that_can_be_read() {
        let program = command();
        let commands: Vec<&str> = program.get_subcommands().map(clap::Command::get_name).chain([""]).collect();
        let listed: Vec<&str> = ALL.iter().map(|below| below.command).collect();
        for command in &commands {
            assert!(listed.contains(command), "{command} has no examples");
        }
        assert_eq!(listed.len(), commands.len());
        for Below { command: name, page, examples } in &ALL {
            assert!(manual::page(page).is_some(), "{name}: there is no page {page}");
            assert!(!examples.is_empty(), "{name}");
            for line in *examples {
                let runs = runs(line);
                let is_about = |run: &Vec<&str>| name.is_empty() || run.get(1) == Some(name);
                assert!(runs.iter().any(is_about), "{name}: {line}");
                for run in runs {
                    let read = command().try_get_matches_from(&run);
                    assert!(read.is_ok(), "{line}: {}", read.unwrap_err());
                }
            }
        }
    }
}
