//! Commands that move and rotate nodes: by values or by drags.

use glam::{Quat, Vec3};

use super::line::{Arguments, Ending, Line};
use super::row::{Changes, Row};
use super::values::{
    axis, double, number, number_text, numbers, one_of, radians, rbt, rbt_path_text, rbt_text, rotation_text,
    same_bits, vector_text,
};
use crate::editor::{Command, Edit, GestureCommand};
use crate::rbt::Rbt;
use crate::rotation_rules::rotation_about_axis;
use crate::words::{Phrase, texts};

const fn edit_of(command: &Command) -> Option<&Edit> {
    match command {
        Command::Edit(edit) => Some(edit),
        _ => None,
    }
}

/// An edit of a pose, which a drag makes again and again.
fn edit_with(id: &'static str, refused: Phrase, owns: fn(&Command) -> bool) -> Row {
    Row::of(Changes::Document, id, owns).refused(refused).continuous()
}

pub(super) fn rows() -> Vec<Row> {
    [chosen(), named(), drags()].concat()
}

fn chosen() -> Vec<Row> {
    vec![
        edit_with("rotate", texts::ACT_TURN_A_NODE, |command| {
            matches!(edit_of(command), Some(Edit::RotateChosen { .. }))
        })
        .can(|editor, _| !editor.session.chosen.is_empty())
        .line(
            Line::new(
                "rotate AXIS DEGREES",
                "turns the chosen nodes: each about its own `x`, `y` or `z`, or all about the common centre (see `pivot`)",
                |arguments| {
                    let &[about, degrees] = arguments.words else { return Ok(None) };
                    let (axis_in_node, radians) = (axis(about)?, radians(degrees)?);
                    Ok(Some(Command::Edit(Edit::RotateChosen { axis_in_node, radians })))
                },
                |command, _| {
                    let Some(&Edit::RotateChosen { axis_in_node, radians: by }) = edit_of(command) else { return None };
                    let is_axis = |axis: Vec3| same_bits(&axis.to_array(), &axis_in_node.to_array());
                    let axes = [("x", Vec3::X), ("y", Vec3::Y), ("z", Vec3::Z)];
                    let (about, _) = axes.into_iter().find(|(_, axis)| is_axis(*axis))?;
                    // Some angles in radians have no exact value in degrees; of others a rounded one reads back to the same bits.
                    let degrees = by.to_degrees();
                    let is_exact = |text: &String| radians(text).is_ok_and(|read| read.to_bits() == by.to_bits());
                    let degrees =
                        [(degrees * 1e6).round() / 1e6, degrees].map(number_text).into_iter().find(is_exact)?;
                    Some(format!("{about} {degrees}"))
                },
            )
            .angles(last_word),
        )
        .line(Line::new(
            "rotate-by X Y Z RADIANS",
            "turns the chosen nodes about an axis of their own, which is a unit vector",
            |arguments| {
                let Ok(&[x, y, z, by]) = <&[&str; 4]>::try_from(arguments.words) else { return Ok(None) };
                let axis_in_node = Vec3::from(numbers(&[x, y, z])?);
                Ok(Some(Command::Edit(Edit::RotateChosen { axis_in_node, radians: double(by)? })))
            },
            |command, _| {
                let Some(&Edit::RotateChosen { axis_in_node, radians }) = edit_of(command) else { return None };
                Some(format!("{} {}", vector_text(axis_in_node), number_text(radians)))
            },
        )),
        edit_with("translate", texts::ACT_MOVE_A_NODE, |command| {
            matches!(edit_of(command), Some(Edit::TranslateChosen(_)))
        })
        .can(|editor, _| !editor.session.chosen.is_empty())
        .line(Line::new(
            "translate X Y Z",
            "moves the chosen nodes, each in its parent's space",
            |arguments| {
                let Ok(words) = arguments.words.try_into() else { return Ok(None) };
                Ok(Some(Command::Edit(Edit::TranslateChosen(Vec3::from(numbers::<3>(words)?)))))
            },
            |command, _| {
                let Some(&Edit::TranslateChosen(by)) = edit_of(command) else { return None };
                Some(vector_text(by))
            },
        )),
    ]
}

fn named() -> Vec<Row> {
    vec![
        edit_with("set-translation", texts::ACT_MOVE_A_NODE, |command| {
            matches!(edit_of(command), Some(Edit::SetTranslation(..)))
        })
        .line(
            Line::new(
                "set-translation X Y Z PATH",
                "places a node, in its parent's space",
                |arguments| {
                    let Some((words, path)) = arguments.then_text() else { return Ok(None) };
                    let translation = Vec3::from(numbers::<3>(&words)?);
                    Ok(Some(Command::Edit(Edit::SetTranslation(arguments.rbt(path)?, translation))))
                },
                |command, scene| {
                    let Some(&Edit::SetTranslation(rbt, to)) = edit_of(command) else { return None };
                    Some(format!("{} {}", vector_text(to), rbt_path_text(rbt, scene)?))
                },
            )
            .ending(Ending::NodePath),
        ),
        edit_with("set-rotation", texts::ACT_TURN_A_NODE, |command| {
            matches!(edit_of(command), Some(Edit::SetRotation(..)))
        })
        .line(
            Line::new(
                "set-rotation X Y Z W PATH",
                "turns a node: a quaternion, which is normalised",
                |arguments| {
                    let Some((words, path)) = arguments.then_text() else { return Ok(None) };
                    let rotation = Quat::from_array(numbers::<4>(&words)?);
                    Ok(Some(Command::Edit(Edit::SetRotation(arguments.rbt(path)?, rotation))))
                },
                |command, scene| {
                    let Some(&Edit::SetRotation(rbt, to)) = edit_of(command) else { return None };
                    Some(format!("{} {}", rotation_text(to), rbt_path_text(rbt, scene)?))
                },
            )
            .ending(Ending::NodePath),
        ),
    ]
}

fn drags() -> Vec<Row> {
    // The four commands of a drag share one line.
    let drag = Line::new(
        "drag begin|end|cancel|move X Y Z|turn AXIS DEGREES",
        "what comes between `begin` and `end` is one step of undo, as with the mouse; `move` and `turn` go along the view's axes",
        |arguments| {
            let gesture = match *arguments.words {
                ["begin"] => GestureCommand::Begin,
                ["end"] => GestureCommand::Commit,
                ["cancel"] => GestureCommand::Abort,
                ["move", x, y, z] => GestureCommand::Move(Rbt::from_translation(Vec3::from(numbers(&[x, y, z])?))),
                ["turn", about, degrees] => {
                    let rotation = rotation_about_axis(axis(about)?, radians(degrees)?);
                    GestureCommand::Move(Rbt::from_rotation(rotation))
                }
                _ => return Ok(None),
            };
            Ok(Some(Command::Gesture(gesture)))
        },
        |command, _| match command {
            Command::Gesture(GestureCommand::Begin) => Some("begin".to_owned()),
            Command::Gesture(GestureCommand::Commit) => Some("end".to_owned()),
            Command::Gesture(GestureCommand::Abort) => Some("cancel".to_owned()),
            Command::Gesture(GestureCommand::Move(motion)) => {
                Some(format!("move {}", vector_text(translation_alone(*motion)?)))
            }
            _ => None,
        },
    )
    .angles(|arguments| if let ["turn", ..] = arguments.words { last_word(arguments) } else { Vec::new() });
    let part = |id, owns| Row::of(Changes::Document, id, owns).can(|editor, _| editor.gesture.is_some());
    vec![
        Row::of(Changes::Document, "drag-begin", |command| matches!(command, Command::Gesture(GestureCommand::Begin)))
            .refused(texts::ACT_MOVE_A_NODE)
            .line(drag.clone()),
        part("drag-end", |command| matches!(command, Command::Gesture(GestureCommand::Commit))).line(drag.clone()),
        part("drag-cancel", |command| matches!(command, Command::Gesture(GestureCommand::Abort))).line(drag.clone()),
        part("drag-move", |command| {
            matches!(command, Command::Gesture(GestureCommand::Move(_) | GestureCommand::MoveTo { .. }))
        })
        .line(drag)
        .line(
            Line::new(
                "drag-by X Y Z QX QY QZ QW",
                "a motion of a drag along and about the view's axes: a translation and a quaternion",
                |arguments| {
                    let Ok(words) = arguments.words.try_into() else { return Ok(None) };
                    Ok(Some(Command::Gesture(GestureCommand::Move(rbt(words)?))))
                },
                |command, _| {
                    let Command::Gesture(GestureCommand::Move(motion)) = command else { return None };
                    Some(rbt_text(*motion))
                },
            ),
        )
        .line(Line::new(
            "drag-to move|turn X Y Z QX QY QZ QW…",
            "where a drag has led each chosen node, in its parent's space: a translation and a quaternion; `move` or `turn` is what undo calls it",
            |arguments| {
                let [kind, numbers @ ..] = arguments.words else { return Ok(None) };
                let (places, []) = numbers.as_chunks::<7>() else { return Ok(None) };
                if places.is_empty() {
                    return Ok(None);
                }
                let is_turn = one_of(kind, "a kind of drag", [(false, "move"), (true, "turn")].into_iter())?;
                Ok(Some(Command::Gesture(GestureCommand::MoveTo { placed: places.iter().map(rbt).collect::<Result<_, _>>()?, is_turn })))
            },
            |command, _| {
                let Command::Gesture(GestureCommand::MoveTo { placed, is_turn }) = command else { return None };
                let places: Vec<String> = placed.iter().copied().map(rbt_text).collect();
                let kind = if *is_turn { "turn" } else { "move" };
                (!places.is_empty()).then(|| format!("{kind} {}", places.join(" ")))
            },
        )),
        edit_with("wheel", texts::ACT_MOVE_A_NODE, |command| matches!(edit_of(command), Some(Edit::Wheel(_))))
            .line(Line::new(
                "wheel UNITS",
                "moves the chosen nodes, or the eye, forward along the view, in scene units",
                |arguments| {
                    let &[units] = arguments.words else { return Ok(None) };
                    let by = Vec3::new(0.0, 0.0, -number(units)?);
                    Ok(Some(Command::Edit(Edit::Wheel(Rbt::from_translation(by)))))
                },
                |command, _| {
                    let Some(&Edit::Wheel(motion)) = edit_of(command) else { return None };
                    let by = translation_alone(motion)?;
                    same_bits(&[by.x, by.y], &[0.0, 0.0]).then(|| number_text(-by.z))
                },
            ))
            .line(Line::new(
                "wheel-by X Y Z QX QY QZ QW",
                "moves the chosen nodes, or the eye, along and about the view's axes: a translation and a quaternion",
                |arguments| {
                    let Ok(words) = arguments.words.try_into() else { return Ok(None) };
                    Ok(Some(Command::Edit(Edit::Wheel(rbt(words)?))))
                },
                |command, _| {
                    let Some(&Edit::Wheel(motion)) = edit_of(command) else { return None };
                    Some(rbt_text(motion))
                },
            )),
    ]
}

/// The angle that stands last in a line.
fn last_word(arguments: &Arguments<'_>) -> Vec<f64> {
    arguments.words.last().and_then(|word| word.parse().ok()).into_iter().collect()
}

/// The translation of a motion that turns nothing.
fn translation_alone(motion: Rbt) -> Option<Vec3> {
    same_bits(&motion.rotation.to_array(), &Quat::IDENTITY.to_array()).then_some(motion.translation)
}
