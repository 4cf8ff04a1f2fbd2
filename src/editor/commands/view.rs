//! Commands of view, camera and ghosts.

use glam::Vec3;

use super::line::{ArgumentError, Ending, Line};
use super::poses::{node, node_text};
use super::row::{Binding, Changes, Group, Menu, Row, Submenu};
use super::values::{numbers, numbers_text, one_of, rbt_path_text, vector_text};
use crate::editor::{Command, Eye, Pivot, Side, ViewCommand, WorkEye};
use crate::text::listed;

/// The section of the menu with ways to look.
const LOOKS: u8 = 4;

fn binding(id: &'static str, command: ViewCommand) -> Binding {
    Binding::new(Group::View, id, Command::View(command))
}

pub(super) fn rows() -> Vec<Row> {
    [eyes(), looks(), shown(), panels()].concat()
}

fn eyes() -> Vec<Row> {
    let next = binding("eye-next", ViewCommand::NextEye);
    let pick = binding("pick", ViewCommand::StartPicking);
    let sky = binding("sky-mode", ViewCommand::ToggleSkyMode);
    vec![
        Row::listed(Changes::Session, next.hotkeys(&["v"]).within(Submenu::Look, LOOKS)),
        Row::of(Changes::Session, "eye", |command| matches!(command, Command::View(ViewCommand::SetEye(_))))
        .binding(binding("eye-recorded", ViewCommand::SetEye(Eye::Recorded(0))).hotkeys(&["0"]).within(Submenu::Look, LOOKS))
        .line(
            Line::new(
                "eye PATH|work",
                "looks from an eye of the scene, or from the work eye, which keyframes do not record",
                |arguments| {
                    match arguments.words {
                        [] => return Ok(None),
                        ["work"] => return Ok(Some(Command::View(ViewCommand::SetEye(Eye::Work)))),
                        _ => {}
                    }
                    let rbt = arguments.rbt(arguments.text)?;
                    let eyes = arguments.scene.eyes();
                    let eye = eyes.iter().position(|&eye| eye == rbt).ok_or_else(|| ArgumentError::Eye {
                        path: arguments.text.to_owned(),
                        expected: listed(
                            &eyes.iter().map(|&eye| arguments.scene.rbt_path(eye)).collect::<Vec<_>>(),
                            "or",
                        ),
                    })?;
                    Ok(Some(Command::View(ViewCommand::SetEye(Eye::Recorded(eye)))))
                },
                |command, scene| {
                    let Command::View(ViewCommand::SetEye(eye)) = command else { return None };
                    let Eye::Recorded(eye) = eye else { return Some("work".to_owned()) };
                    rbt_path_text(*scene.eyes().get(*eye)?, scene)
                },
            )
            .ending(Ending::NodePath),
        ),
        work_eye(),
        Row::listed(Changes::Session, pick.hotkeys(&["p"]).ticked(|editor, _| editor.session.is_picking)),
        Row::of(Changes::Session, "select", |command| matches!(command, Command::View(ViewCommand::Choose(_)))).line(
            Line::new(
                "select PATH",
                "chooses the node to move: any path that `inbetween nodes` prints, or `none`",
                |arguments| {
                    let chosen = match arguments.words {
                        [] => return Ok(None),
                        ["none"] => None,
                        _ => Some(arguments.rbt(arguments.text)?),
                    };
                    Ok(Some(Command::View(ViewCommand::Choose(chosen))))
                },
                |command, scene| {
                    let Command::View(ViewCommand::Choose(chosen)) = command else { return None };
                    chosen.map_or_else(|| Some("none".to_owned()), |rbt| rbt_path_text(rbt, scene))
                },
            )
            .ending(Ending::NodePath),
        ),
        Row::of(Changes::Session, "select-also", |command| matches!(command, Command::View(ViewCommand::ChooseAlso(_))))
            .line(
                Line::new(
                    "select-also PATH",
                    "adds a node to the chosen ones, or takes it out if it is one of them; the last one added is the one whose numbers show",
                    |arguments| {
                        if arguments.words.is_empty() {
                            return Ok(None);
                        }
                        Ok(Some(Command::View(ViewCommand::ChooseAlso(arguments.rbt(arguments.text)?))))
                    },
                    |command, scene| {
                        let Command::View(ViewCommand::ChooseAlso(rbt)) = command else { return None };
                        rbt_path_text(*rbt, scene)
                    },
                )
                .ending(Ending::NodePath),
            ),
        pivots(),
        Row::listed(Changes::Session, sky.hotkeys(&["m"]))
            .can(|editor, _| editor.session.eye == Eye::Recorded(0) && editor.session.chosen.is_empty()),
    ]
}

fn pivots() -> Row {
    let choice = |id, pivot| binding(id, ViewCommand::SetPivot(pivot));
    Row::of(Changes::Session, "pivot", |command| matches!(command, Command::View(ViewCommand::SetPivot(_))))
        .binding(choice("pivot-own", Pivot::Own).ticked(|editor, _| editor.session.pivot == Pivot::Own))
        .binding(choice("pivot-common", Pivot::Common).ticked(|editor, _| editor.session.pivot == Pivot::Common))
        .line(Line::new(
            "pivot own|common",
            "what several chosen nodes turn about: each about its own origin, or all about the mean of their origins",
            |arguments| {
                let &[word] = arguments.words else { return Ok(None) };
                let pivot = one_of(word, "a pivot", Pivot::NAMES.into_iter())?;
                Ok(Some(Command::View(ViewCommand::SetPivot(pivot))))
            },
            |command, _| {
                let Command::View(ViewCommand::SetPivot(pivot)) = command else { return None };
                Pivot::NAMES.into_iter().find(|(named, _)| named == pivot).map(|(_, name)| name.to_owned())
            },
        ))
}

/// Where the work eye goes.
fn looks() -> Vec<Row> {
    let side = |id, side, key| binding(id, ViewCommand::LookFrom(side)).hotkeys(&[key]).within(Submenu::Look, LOOKS);
    let listed = |id, command, keys: &[&str]| binding(id, command).hotkeys(keys).within(Submenu::Look, LOOKS);
    let sides = Row::of(Changes::Session, "look", |command| matches!(command, Command::View(ViewCommand::LookFrom(_))))
        .binding(side("look-front", Side::Front, "1"))
        .binding(side("look-back", Side::Back, "Ctrl+1"))
        .binding(side("look-right", Side::Right, "3"))
        .binding(side("look-left", Side::Left, "Ctrl+3"))
        .binding(side("look-top", Side::Top, "7"))
        .binding(side("look-bottom", Side::Bottom, "Ctrl+7"))
        .line(Line::new(
            "look front|back|right|left|top|bottom",
            "looks with the work eye from a side of its target; robots face the front",
            |arguments| {
                let &[word] = arguments.words else { return Ok(None) };
                let side = one_of(word, "a side", Side::NAMES.into_iter())?;
                Ok(Some(Command::View(ViewCommand::LookFrom(side))))
            },
            |command, _| {
                let Command::View(ViewCommand::LookFrom(side)) = command else { return None };
                Side::NAMES.into_iter().find(|(named, _)| named == side).map(|(_, name)| name.to_owned())
            },
        ));
    vec![
        sides,
        from_node(),
        Row::listed(Changes::Session, listed("show-chosen", ViewCommand::ShowChosen, &["z"]))
            .can(|editor, _| !editor.session.chosen.is_empty())
            .word("show-chosen", "brings the chosen nodes in sight of the work eye"),
        Row::listed(Changes::Session, listed("show-all", ViewCommand::ShowAll, &["Shift+Z"]))
            .word("show-all", "brings all shapes in sight of the work eye"),
        Row::listed(Changes::Session, listed("level-eye", ViewCommand::LevelEye, &[]))
            .word("level-eye", "puts the work eye at the height of what it looks at"),
        Row::listed(Changes::Session, listed("reset-work-eye", ViewCommand::ResetWorkEye, &[]))
            .word("reset-work-eye", "puts the work eye where it was at first"),
    ]
}

fn from_node() -> Row {
    let chosen = ViewCommand::LookFromNode(None);
    Row::of(Changes::Session, "look-from", |command| matches!(command, Command::View(ViewCommand::LookFromNode(_))))
        .binding(binding("look-from", chosen).within(Submenu::Look, LOOKS))
        .can(|editor, command| {
            let is_named = matches!(command, Command::View(ViewCommand::LookFromNode(Some(_))));
            is_named || !editor.session.chosen.is_empty()
        })
        .line(
            Line::new(
                "look-from [PATH]",
                "puts the work eye at a node's origin, looking along its -Z axis with the horizon level; without a path, at the chosen node",
                |arguments| Ok(Some(Command::View(ViewCommand::LookFromNode(node(arguments, arguments.text)?)))),
                |command, scene| {
                    let Command::View(ViewCommand::LookFromNode(node)) = command else { return None };
                    node_text(*node, scene, &[])
                },
            )
            .ending(Ending::NodePath),
        )
}

fn work_eye() -> Row {
    Row::of(Changes::Session, "work-eye", |command| matches!(command, Command::View(ViewCommand::SetWorkEye(_)))).line(
        Line::new(
            "work-eye YAW PITCH DISTANCE X Y Z",
            "puts the work eye on a sphere around the point X Y Z, which it looks at: around by YAW and up by PITCH degrees, DISTANCE units away",
            |arguments| {
                let Ok(words) = <&[&str; 6]>::try_from(arguments.words) else { return Ok(None) };
                let ranges = [
                    ("yaw", -180.0..=180.0),
                    ("pitch", -90.0..=90.0),
                    ("distance", f64::from(*WorkEye::DISTANCES.start())..=f64::from(*WorkEye::DISTANCES.end())),
                ];
                for (word, (what, range)) in words.iter().zip(&ranges) {
                    arguments.number_in(word, what, range)?;
                }
                let [yaw_degrees, pitch_degrees, distance, x, y, z] = numbers(words)?;
                let target_in_world = Vec3::new(x, y, z);
                let eye = WorkEye { yaw_degrees, pitch_degrees, distance, target_in_world };
                Ok(Some(Command::View(ViewCommand::SetWorkEye(eye))))
            },
            |command, _| {
                let Command::View(ViewCommand::SetWorkEye(eye)) = command else { return None };
                let angles = [eye.yaw_degrees, eye.pitch_degrees, eye.distance];
                eye.in_range().filter(|kept| kept == eye)?;
                Some(format!("{} {}", numbers_text(&angles, " "), vector_text(eye.target_in_world)))
            },
        ),
    )
}

fn shown() -> Vec<Row> {
    let arcball = binding("arcball", ViewCommand::ToggleArcball);
    let path = binding("motion-path", ViewCommand::ToggleMotionPath);
    let inset = binding("inset", ViewCommand::ToggleInset);
    let ghosts = binding("ghosts-next", ViewCommand::NextGhosts);
    vec![
        Row::listed(Changes::Session, arcball.hotkeys(&["a"]).ticked(|editor, _| editor.session.shows_arcball)),
        Row::listed(Changes::Session, path.hotkeys(&["Alt+P"]).ticked(|editor, _| editor.session.shows_motion_path)),
        Row::listed(Changes::Session, ghosts.repeating_hotkeys(&["Shift+G"])),
        Row::listed(Changes::Session, inset.section(LOOKS).ticked(|editor, _| editor.session.shows_inset)),
        Row::of(Changes::Session, "inset-set", |command| matches!(command, Command::View(ViewCommand::SetInset(_))))
            .line(Line::new(
                "inset on|off",
                "whether the window shows what the recorded camera sees in a corner, while the work eye is in force",
                |arguments| {
                    let &[word] = arguments.words else { return Ok(None) };
                    let is_on = one_of(word, "a state", [(true, "on"), (false, "off")].into_iter())?;
                    Ok(Some(Command::View(ViewCommand::SetInset(is_on))))
                },
                |command, _| {
                    let Command::View(ViewCommand::SetInset(is_on)) = command else { return None };
                    Some(if *is_on { "on" } else { "off" }.to_owned())
                },
            )),
    ]
}

fn panels() -> Vec<Row> {
    let help = binding("help", ViewCommand::ToggleHelp);
    let panels = binding("panels", ViewCommand::TogglePanels);
    let cancel = Binding::new(Group::View, "cancel", Command::Cancel);
    vec![
        Row::listed(
            Changes::Session,
            help.hotkeys(&["h"]).menu(Menu::Help).ticked(|editor, _| editor.session.shows_help),
        ),
        Row::listed(Changes::Session, panels.hotkeys(&["F11"]).ticked(|editor, _| editor.session.shows_panels)),
        Row::listed(Changes::Document, cancel.hotkeys(&["Esc"]).menu(Menu::Edit).section(9)).can(|editor, _| {
            let session = &editor.session;
            editor.is_dragging() || session.is_picking || session.shows_help || !session.chosen.is_empty()
        }),
    ]
}
