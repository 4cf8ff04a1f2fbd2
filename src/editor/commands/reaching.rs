//! Commands that reach with limbs.

use glam::Vec3;

use super::line::{Ending, Line};
use super::row::{Binding, Changes, Group, Menu, Row};
use super::values::{double, number_text, numbers, one_of, rbt_path_text, vector_text};
use crate::editor::{Command, Edit, ViewCommand};
use crate::words::texts;

pub(super) fn rows() -> Vec<Row> {
    [reaching(), feet()].concat()
}

fn reaching() -> Vec<Row> {
    let edit = |id, owns| Row::of(Changes::Document, id, owns).refused(texts::ACT_REACH).continuous();
    vec![
        edit("reach", |command| matches!(command, Command::Edit(Edit::Reach(..)))).line(
            Line::new(
                "reach X Y Z PATH",
                "brings the end of a limb to a point in world space, or as near as its bones and limits allow; the path is that of the limb's last node, such as an elbow or a knee",
                |arguments| {
                    let Some((words, path)) = arguments.then_text() else { return Ok(None) };
                    let point = Vec3::from(numbers::<3>(&words)?);
                    Ok(Some(Command::Edit(Edit::Reach(arguments.rbt(path)?, point))))
                },
                |command, scene| {
                    let &Command::Edit(Edit::Reach(rbt, target)) = command else { return None };
                    Some(format!("{} {}", vector_text(target), rbt_path_text(rbt, scene)?))
                },
            )
            .ending(Ending::NodePath),
        ),
        edit("reach-by", |command| matches!(command, Command::Edit(Edit::ReachBy(..)))).line(
            Line::new(
                "reach-by X Y Z PATH",
                "the same, by so much from where the end is",
                |arguments| {
                    let Some((words, path)) = arguments.then_text() else { return Ok(None) };
                    let offset = Vec3::from(numbers::<3>(&words)?);
                    Ok(Some(Command::Edit(Edit::ReachBy(arguments.rbt(path)?, offset))))
                },
                |command, scene| {
                    let &Command::Edit(Edit::ReachBy(rbt, by)) = command else { return None };
                    Some(format!("{} {}", vector_text(by), rbt_path_text(rbt, scene)?))
                },
            )
            .ending(Ending::NodePath),
        ),
        edit("pole", |command| matches!(command, Command::Edit(Edit::TurnPole(..)))).line(
            Line::new(
                "pole DEGREES PATH",
                "turns a limb about the line from its root to its end: the elbow or knee goes around, and the end stays",
                |arguments| {
                    let Some(([degrees], path)) = arguments.then_text() else { return Ok(None) };
                    let degrees = double(degrees)?;
                    Ok(Some(Command::Edit(Edit::TurnPole(arguments.rbt(path)?, degrees))))
                },
                |command, scene| {
                    let &Command::Edit(Edit::TurnPole(rbt, degrees)) = command else { return None };
                    Some(format!("{} {}", number_text(degrees), rbt_path_text(rbt, scene)?))
                },
            )
            .ending(Ending::NodePath),
        ),
    ]
}

fn feet() -> Vec<Row> {
    let keep = Binding::new(Group::View, "keep-feet", Command::View(ViewCommand::ToggleKeepFeet)).menu(Menu::Edit);
    vec![
        Row::listed(Changes::Session, keep.ticked(|editor, _| editor.session.keeps_feet)),
        Row::of(Changes::Session, "keep-feet-set", |command| {
            matches!(command, Command::View(ViewCommand::SetKeepFeet(_)))
        })
        .line(Line::new(
            "keep-feet on|off",
            "whether feet stay in place while the body above them moves",
            |arguments| {
                let &[word] = arguments.words else { return Ok(None) };
                let is_on = one_of(word, "a state", [(true, "on"), (false, "off")].into_iter())?;
                Ok(Some(Command::View(ViewCommand::SetKeepFeet(is_on))))
            },
            |command, _| {
                let Command::View(ViewCommand::SetKeepFeet(is_on)) = command else { return None };
                Some(if *is_on { "on" } else { "off" }.to_owned())
            },
        )),
    ]
}
