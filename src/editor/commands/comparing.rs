//! Commands of ghosts: neighbouring keyframes, other interpolations, the animation of another file.

use super::line::{Ending, Line};
use super::row::{Binding, Changes, Group, Row};
use super::values::{file, file_text, one_of, quoted};
use crate::editor::{Command, FileCommand, ViewCommand};
use crate::frame::MOST_GHOSTS;
use crate::keyframe::Blend;

fn binding(id: &'static str, command: Command) -> Binding {
    Binding::new(Group::View, id, command)
}

pub(super) fn rows() -> Vec<Row> {
    [ghosts(), interpolations(), other_file()].concat()
}

fn ghosts() -> Vec<Row> {
    const WORDS: [(bool, &str); 2] = [(true, "chosen"), (false, "all")];
    let of_chosen = binding("ghosts-of-chosen", Command::View(ViewCommand::ToggleGhostsOfChosen));
    vec![
        Row::listed(Changes::Session, of_chosen.ticked(|editor, _| editor.session.ghosts_of_chosen)),
        Row::of(Changes::Session, "ghosts-of", |command| {
            matches!(command, Command::View(ViewCommand::SetGhostsOfChosen(_)))
        })
        .line(Line::new(
            "ghosts-of chosen|all",
            "whether ghosts are only of the chosen node and what is below it",
            |arguments| {
                let &[word] = arguments.words else { return Ok(None) };
                let is_on = one_of(word, "a choice of ghosts", WORDS.into_iter())?;
                Ok(Some(Command::View(ViewCommand::SetGhostsOfChosen(is_on))))
            },
            |command, _| {
                let Command::View(ViewCommand::SetGhostsOfChosen(is_on)) = command else { return None };
                WORDS.into_iter().find(|(word, _)| word == is_on).map(|(_, word)| word.to_owned())
            },
        )),
        Row::of(Changes::Session, "ghosts", |command| matches!(command, Command::View(ViewCommand::SetGhosts(_))))
            .line(Line::new(
                "ghosts COUNT",
                "how many neighbouring keyframes on each side are shown as ghosts, 0 to 20",
                |arguments| {
                    let &[count] = arguments.words else { return Ok(None) };
                    let count = arguments.whole_in(count, "number of ghosts", &(0..=MOST_GHOSTS))?;
                    Ok(Some(Command::View(ViewCommand::SetGhosts(count))))
                },
                |command, _| {
                    let Command::View(ViewCommand::SetGhosts(count)) = command else { return None };
                    Some(count.to_string())
                },
            )),
    ]
}

fn interpolations() -> Vec<Row> {
    let toggle = binding("interpolations-compare", Command::View(ViewCommand::ToggleComparison));
    vec![
        Row::listed(Changes::Session, toggle.ticked(|editor, _| !editor.session.compared_blends.is_empty())),
        Row::of(Changes::Session, "compare-interpolations", |command| {
            matches!(command, Command::View(ViewCommand::CompareBlends(_)))
        })
        .line(Line::new(
            "compare-interpolations NAME…|all|none",
            "shows as ghosts the poses of `linear`, `catmull-rom`, `nlerp` or `matrix` wherever a sample is shown",
            |arguments| {
                let blends = match arguments.words {
                    [] => return Ok(None),
                    ["all"] => Blend::ALL.to_vec(),
                    ["none"] => Vec::new(),
                    words => {
                        let names = || Blend::ALL.into_iter().map(|blend| (blend, blend.name()));
                        let blend = |word: &&str| {
                            Blend::from_name(word).map_or_else(|| one_of(word, "an interpolation", names()), Ok)
                        };
                        words.iter().map(blend).collect::<Result<_, _>>()?
                    }
                };
                Ok(Some(Command::View(ViewCommand::CompareBlends(blends))))
            },
            |command, _| {
                let Command::View(ViewCommand::CompareBlends(blends)) = command else { return None };
                let names: Vec<_> = blends.iter().map(|blend| blend.name()).collect();
                Some(if names.is_empty() { "none".to_owned() } else { names.join(" ") })
            },
        )),
    ]
}

fn other_file() -> Vec<Row> {
    let choose = Binding::new(Group::File, "compare-choose", Command::File(FileCommand::ChooseCompare));
    let end = Binding::new(Group::File, "compare-end", Command::View(ViewCommand::EndCompareWith));
    vec![
        Row::listed(Changes::Session, choose.section(6)),
        Row::of(Changes::Session, "compare-with", |command| {
            matches!(command, Command::File(FileCommand::CompareWith(_)) | Command::View(ViewCommand::EndCompareWith))
        })
        .binding(end.section(6))
        .can(|editor, command| matches!(command, Command::File(_)) || editor.compared.is_some())
        .line(
            Line::new(
                "compare-with FILE|none",
                "shows the animation of another file beside this one, as ghosts; a keyframe file or a text",
                |arguments| {
                    if arguments.text == "none" {
                        return Ok(Some(Command::View(ViewCommand::EndCompareWith)));
                    }
                    Ok(file(arguments.text).map(|path| Command::File(FileCommand::CompareWith(path))))
                },
                |command, _| match command {
                    Command::View(ViewCommand::EndCompareWith) => Some("none".to_owned()),
                    Command::File(FileCommand::CompareWith(path)) => {
                        file_text(path).map(|text| if text == "none" { quoted(&text) } else { text })
                    }
                    _ => None,
                },
            )
            .ending(Ending::FilePath(None)),
        ),
    ]
}
