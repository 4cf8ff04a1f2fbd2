//! Commands of the handles around the chosen node: turns and moves by axes, and what is held in a drag.

use super::line::{ArgumentError, Line};
use super::row::{Binding, Changes, Group, Menu, Row, Submenu};
use super::values::{double, number_text, one_of};
use crate::editor::gizmo::{Axis, GizmoAxes, Handle, HandleKind, Pull, SnapSteps};
use crate::editor::{Command, Edit, GestureCommand, ViewCommand};
use crate::words::texts;

fn axis(word: &str) -> Result<Axis, ArgumentError> {
    let found = Axis::ALL.into_iter().find(|axis| axis.name() == word);
    found.ok_or_else(|| ArgumentError::Axis { word: word.to_owned() })
}

fn axes(word: &str) -> Result<GizmoAxes, ArgumentError> {
    one_of(word, "a kind of axes", GizmoAxes::ALL.into_iter().map(|axes| (axes, axes.name())))
}

/// The section of the menu with the axes of the handles.
const AXES: u8 = 6;

const KINDS: [(HandleKind, &str); 3] =
    [(HandleKind::Turn, "turn"), (HandleKind::Move, "move"), (HandleKind::Plane, "plane")];

fn read_turn(words: &[&str]) -> Result<Option<Pull>, ArgumentError> {
    let &[about, degrees, of] = words else { return Ok(None) };
    Ok(Some(Pull::Turn { axis: axis(about)?, degrees: double(degrees)?, axes: axes(of)? }))
}

fn read_move(words: &[&str]) -> Result<Option<Pull>, ArgumentError> {
    let &[x, y, z, of] = words else { return Ok(None) };
    Ok(Some(Pull::Move { by: [double(x)?, double(y)?, double(z)?], axes: axes(of)? }))
}

fn pull_text(pull: Pull) -> String {
    match pull {
        Pull::Turn { axis, degrees, axes } => format!("{} {} {}", axis.name(), number_text(degrees), axes.name()),
        Pull::Move { by, axes } => {
            let [x, y, z] = by.map(number_text);
            format!("{x} {y} {z} {}", axes.name())
        }
    }
}

pub(super) fn rows() -> Vec<Row> {
    [edits(), held(), shown()].concat()
}

fn edits() -> Vec<Row> {
    let pull = |id, owns: fn(&Command) -> bool, refused| {
        Row::of(Changes::Document, id, owns)
            .refused(refused)
            .continuous()
            .can(|editor, _| !editor.session.chosen.is_empty())
    };
    vec![
        pull(
            "turn",
            |command| matches!(command, Command::Edit(Edit::PullChosen(Pull::Turn { .. }))),
            texts::ACT_TURN_A_NODE,
        )
        .line(
            Line::new(
                "turn AXIS DEGREES local|parent|world|view",
                "turns the chosen nodes about `x`, `y` or `z` of their own axes, their parents', the world's or the view's",
                |arguments| Ok(read_turn(arguments.words)?.map(|pull| Command::Edit(Edit::PullChosen(pull)))),
                |command, _| {
                    let Command::Edit(Edit::PullChosen(pull @ Pull::Turn { .. })) = command else { return None };
                    Some(pull_text(*pull))
                },
            )
            .angles(|arguments| arguments.words.get(1).and_then(|word| word.parse().ok()).into_iter().collect()),
        ),
        pull(
            "shift",
            |command| matches!(command, Command::Edit(Edit::PullChosen(Pull::Move { .. }))),
            texts::ACT_MOVE_A_NODE,
        )
        .line(Line::new(
            "shift X Y Z local|parent|world|view",
            "moves the chosen nodes along their own axes, their parents', the world's or the view's",
            |arguments| Ok(read_move(arguments.words)?.map(|pull| Command::Edit(Edit::PullChosen(pull)))),
            |command, _| {
                let Command::Edit(Edit::PullChosen(pull @ Pull::Move { .. })) = command else { return None };
                Some(pull_text(*pull))
            },
        )),
    ]
}

fn held() -> Vec<Row> {
    let grab = |id, handle| {
        Binding::new(Group::View, id, Command::Gesture(GestureCommand::Grab(handle))).menu(Menu::Edit).section(6)
    };
    let part = |id, owns| Row::of(Changes::Document, id, owns).can(|editor, _| editor.is_dragging());
    vec![
        Row::of(Changes::Document, "drag-grab", |command| matches!(command, Command::Gesture(GestureCommand::Grab(_))))
            .refused(texts::ACT_MOVE_A_NODE)
            .can(|editor, _| !editor.session.chosen.is_empty())
            .binding(grab("turn-begin", Handle::TURN_IN_VIEW).hotkeys(&["Ctrl+R"]))
            .binding(grab("move-begin", Handle::MOVE_IN_VIEW).hotkeys(&["Ctrl+G"]))
            .line(Line::new(
                "drag-grab turn|move|plane AXIS local|parent|world|view",
                "begins a drag that holds a handle: a ring, an arrow, or the square of the two other axes",
                |arguments| {
                    let &[kind, about, of] = arguments.words else { return Ok(None) };
                    let kind = one_of(kind, "a kind of handle", KINDS.into_iter())?;
                    let handle = Handle { kind, axis: axis(about)?, axes: axes(of)? };
                    Ok(Some(Command::Gesture(GestureCommand::Grab(handle))))
                },
                |command, _| {
                    let Command::Gesture(GestureCommand::Grab(handle)) = command else { return None };
                    let (_, kind) = KINDS.into_iter().find(|(kind, _)| *kind == handle.kind)?;
                    Some(format!("{kind} {} {}", handle.axis.name(), handle.axes.name()))
                },
            )),
        part("drag-pull", |command| matches!(command, Command::Gesture(GestureCommand::Pull(_)))).line(
            Line::new(
                "drag-pull turn AXIS DEGREES local|parent|world|view, or move X Y Z local|parent|world|view",
                "how far a drag has turned or moved the chosen nodes since it began",
                |arguments| {
                    let pull = match arguments.words {
                        ["turn", rest @ ..] => read_turn(rest)?,
                        ["move", rest @ ..] => read_move(rest)?,
                        _ => None,
                    };
                    Ok(pull.map(|pull| Command::Gesture(GestureCommand::Pull(pull))))
                },
                |command, _| {
                    let Command::Gesture(GestureCommand::Pull(pull)) = command else { return None };
                    let kind = if matches!(pull, Pull::Turn { .. }) { "turn" } else { "move" };
                    Some(format!("{kind} {}", pull_text(*pull)))
                },
            ),
        ),
        part("drag-lock", |command| matches!(command, Command::Gesture(GestureCommand::Lock(_)))).line(Line::new(
            "drag-lock AXIS",
            "holds the ring or arrow of an axis from now on, as `x`, `y` and `z` do in a drag; again: of the world's or the node's own",
            |arguments| {
                let &[word] = arguments.words else { return Ok(None) };
                Ok(Some(Command::Gesture(GestureCommand::Lock(axis(word)?))))
            },
            |command, _| {
                let Command::Gesture(GestureCommand::Lock(axis)) = command else { return None };
                Some(axis.name().to_owned())
            },
        )),
        part("drag-type", |command| {
            matches!(command, Command::Gesture(GestureCommand::Type(_) | GestureCommand::Erase))
        })
        .line(Line::new(
            "drag-type 0 to 9|.|-|erase",
            "types the number that the drag goes by: degrees or units; `-` changes its sign",
            |arguments| {
                let &[word] = arguments.words else { return Ok(None) };
                let typed = match *word.as_bytes() {
                    [character @ (b'0'..=b'9' | b'.' | b'-')] => GestureCommand::Type(char::from(character)),
                    _ if word == "erase" => GestureCommand::Erase,
                    _ => {
                        let (word, expected) = (word.to_owned(), "0 to 9, ., - or erase".to_owned());
                        return Err(ArgumentError::Choice { word, what: "what can be typed in a drag", expected });
                    }
                };
                Ok(Some(Command::Gesture(typed)))
            },
            |command, _| match command {
                Command::Gesture(GestureCommand::Type(character)) => Some(character.to_string()),
                Command::Gesture(GestureCommand::Erase) => Some("erase".to_owned()),
                _ => None,
            },
        )),
    ]
}

fn shown() -> Vec<Row> {
    let binding = |id, command| Binding::new(Group::View, id, Command::View(command));
    let gizmo = binding("gizmo", ViewCommand::ToggleGizmo);
    let next = binding("gizmo-axes-next", ViewCommand::NextGizmoAxes);
    let of = |id, axes| binding(id, ViewCommand::SetGizmoAxes(axes)).within(Submenu::Axes, AXES);
    vec![
        Row::listed(Changes::Session, gizmo.hotkeys(&["Shift+H"]).ticked(|editor, _| editor.session.shows_gizmo)),
        Row::listed(Changes::Session, next.repeating_hotkeys(&["Shift+X"]).within(Submenu::Axes, AXES)),
        Row::of(Changes::Session, "gizmo-axes", |command| {
            matches!(command, Command::View(ViewCommand::SetGizmoAxes(_)))
        })
        .binding(
            of("gizmo-axes-local", GizmoAxes::Local).ticked(|editor, _| editor.session.gizmo_axes == GizmoAxes::Local),
        )
        .binding(
            of("gizmo-axes-parent", GizmoAxes::Parent)
                .ticked(|editor, _| editor.session.gizmo_axes == GizmoAxes::Parent),
        )
        .binding(
            of("gizmo-axes-world", GizmoAxes::World).ticked(|editor, _| editor.session.gizmo_axes == GizmoAxes::World),
        )
        .binding(
            of("gizmo-axes-view", GizmoAxes::View).ticked(|editor, _| editor.session.gizmo_axes == GizmoAxes::View),
        )
        .line(Line::new(
            "gizmo-axes local|parent|world|view",
            "whose axes the handles around the chosen node go by",
            |arguments| {
                let &[word] = arguments.words else { return Ok(None) };
                Ok(Some(Command::View(ViewCommand::SetGizmoAxes(axes(word)?))))
            },
            |command, _| {
                let Command::View(ViewCommand::SetGizmoAxes(axes)) = command else { return None };
                Some(axes.name().to_owned())
            },
        )),
        Row::of(Changes::Session, "snap", |command| matches!(command, Command::View(ViewCommand::SetSnapSteps(_))))
            .line(Line::new(
                "snap DEGREES UNITS",
                "the steps of turns and of moves in drags with Shift",
                |arguments| {
                    let &[degrees, units] = arguments.words else { return Ok(None) };
                    let degrees = arguments.number_in(degrees, "step in degrees", &SnapSteps::DEGREES)?;
                    let units = arguments.number_in(units, "step in units", &SnapSteps::UNITS)?;
                    Ok(Some(Command::View(ViewCommand::SetSnapSteps(SnapSteps { degrees, units }))))
                },
                |command, _| {
                    let Command::View(ViewCommand::SetSnapSteps(snap)) = command else { return None };
                    Some(format!("{} {}", number_text(snap.degrees), number_text(snap.units)))
                },
            )),
    ]
}
