//! Commands of the timeline: the selected keyframes, their intervals, names and copies.

use super::line::{Ending, Line};
use super::row::{Binding, Changes, Group, Row};
use super::values::{
    index, keyframe, keyframes, keyframes_text, name_text, number_text, numbers, one_of, rbt_path_text, read_quoted,
    rotation_text, vector_text,
};
use crate::editor::{
    ClipboardCommand, Command, Edit, Editor, SceneEdit, SelectionCommand, TimelineEdit, WindowCommand,
};
use crate::keyframe::{DURATION_RANGE, Easing, Retiming, StretchEnd};
use crate::words::texts;
use glam::{Quat, Vec3};

fn edit(edit: TimelineEdit) -> Command {
    Command::Edit(Edit::Timeline(edit))
}

const fn edit_of(command: &Command) -> Option<&TimelineEdit> {
    match command {
        Command::Edit(Edit::Timeline(edit)) => Some(edit),
        _ => None,
    }
}

fn binding(id: &'static str, command: Command, keys: &[&str]) -> Binding {
    Binding::new(Group::Timeline, id, command).hotkeys(keys)
}

fn has_keyframes(editor: &Editor, _: &Command) -> bool {
    !editor.document.keyframes.is_empty()
}

/// An edit of the timeline without parameters, and the script line that is its word.
fn listed_edit(binding: Binding, word: &'static str, does: &'static str) -> Row {
    Row::listed(Changes::Document, binding).refused(texts::ACT_EDIT_THE_TIMELINE).can(has_keyframes).word(word, does)
}

/// An edit of the timeline with parameters.
fn edit_with(id: &'static str, owns: fn(&Command) -> bool) -> Row {
    Row::of(Changes::Document, id, owns).refused(texts::ACT_EDIT_THE_TIMELINE).can(has_keyframes)
}

pub(super) fn rows() -> Vec<Row> {
    [selection(), edits(), intervals(), times(), nodes(), window()].concat()
}

fn selection() -> Vec<Row> {
    vec![
        Row::of(Changes::Session, "select-keyframes", |command| {
            matches!(command, Command::Selection(SelectionCommand::Keyframes(_)))
        })
        .line(Line::new(
            "select-keyframes KEYFRAME…|none",
            "selects keyframes for the lines below: `1 2`, `1-4 7`",
            |arguments| {
                let selected = match arguments.words {
                    [] => return Ok(None),
                    ["none"] => Vec::new(),
                    words => keyframes(words)?,
                };
                Ok(Some(Command::Selection(SelectionCommand::Keyframes(selected))))
            },
            |command, _| {
                let Command::Selection(SelectionCommand::Keyframes(selected)) = command else { return None };
                Some(keyframes_text(selected))
            },
        )),
        edit_with("move", |command| matches!(edit_of(command), Some(TimelineEdit::MoveKeyframes(_))))
            .ends_scrub()
            .line(Line::new(
                "move PLACE",
                "moves the selected keyframes (or the current one, here and below) to before the keyframe in this place",
                |arguments| {
                    let &[to] = arguments.words else { return Ok(None) };
                    Ok(Some(edit(TimelineEdit::MoveKeyframes(index(to)?))))
                },
                |command, _| {
                    let Some(TimelineEdit::MoveKeyframes(to)) = edit_of(command) else { return None };
                    Some(to.to_string())
                },
            )),
    ]
}

fn edits() -> Vec<Row> {
    let copy = binding("keyframes-copy", Command::Clipboard(ClipboardCommand::CopyKeyframes), &["Ctrl+C"]);
    let cut = binding("keyframes-cut", edit(TimelineEdit::CutKeyframes), &["Ctrl+X"]);
    let paste = binding("keyframes-paste", edit(TimelineEdit::PasteKeyframes), &["Ctrl+V"]);
    let duplicate = binding("keyframes-duplicate", edit(TimelineEdit::DuplicateKeyframes), &["Ctrl+D"]);
    let delete = binding("keyframes-delete", edit(TimelineEdit::DeleteKeyframes), &["Delete"]);
    let reverse = binding("keyframes-reverse", edit(TimelineEdit::ReverseKeyframes), &[]);
    vec![
        Row::listed(Changes::Session, copy).can(has_keyframes).word("copy", "copies them"),
        listed_edit(cut, "cut", "copies and deletes them").ends_scrub(),
        listed_edit(paste, "paste", "inserts what was copied after the last of them")
            .ends_scrub()
            .can(|editor, _| editor.has_copied_keyframes()),
        listed_edit(duplicate, "duplicate", "inserts copies after them").ends_scrub(),
        listed_edit(delete, "delete", "deletes them")
            .ends_scrub()
            .can(|editor, command| has_keyframes(editor, command) || !editor.session.selected_keys.is_empty()),
        listed_edit(reverse, "reverse", "reverses their order; with fewer than two selected, of all").ends_scrub(),
    ]
}

fn intervals() -> Vec<Row> {
    vec![
        edit_with("easing", |command| matches!(edit_of(command), Some(TimelineEdit::SetEasing(_)))).line(Line::new(
            "easing NAME",
            "how the intervals run that begin at them: `linear`, `hold`, `sine-in-out` and so on",
            |arguments| {
                let &[name] = arguments.words else { return Ok(None) };
                let all = Easing::all().map(|easing| (easing, easing.name()));
                Ok(Some(edit(TimelineEdit::SetEasing(one_of(name, "an easing", all)?))))
            },
            |command, _| {
                let Some(TimelineEdit::SetEasing(easing)) = edit_of(command) else { return None };
                Some(easing.name().to_owned())
            },
        )),
        edit_with("rename", |command| matches!(edit_of(command), Some(TimelineEdit::RenameKeyframe(..)))).line(
            Line::new(
                "rename KEYFRAME [NAME]",
                "names a keyframe; a name with `#` stands in double quotes",
                |arguments| {
                    let (index, name) = arguments.text.split_once(char::is_whitespace).unwrap_or((arguments.text, ""));
                    if index.is_empty() {
                        return Ok(None);
                    }
                    let name = name.trim();
                    let name = read_quoted(name).unwrap_or_else(|| name.to_owned());
                    Ok(Some(edit(TimelineEdit::RenameKeyframe(keyframe(index)?, name))))
                },
                |command, _| {
                    let Some(TimelineEdit::RenameKeyframe(index, name)) = edit_of(command) else { return None };
                    let index = index.get();
                    Some(if name.is_empty() { index.to_string() } else { format!("{index} {}", name_text(name)) })
                },
            )
            .ending(Ending::Name),
        ),
        edit_with("duration", |command| matches!(edit_of(command), Some(TimelineEdit::SetDuration { .. })))
            .continuous()
            .line(Line::new(
                "duration KEYFRAME STEPS [ripple-free]",
                "the length of the interval that begins at a keyframe, in units of the ms between keyframes; with \
                 `ripple-free` the next interval gives what it takes",
                |arguments| {
                    let (index, steps, ripple_free) = match *arguments.words {
                        [index, steps] => (index, steps, false),
                        [index, steps, "ripple-free"] => (index, steps, true),
                        _ => return Ok(None),
                    };
                    let keyframe = keyframe(index)?;
                    let duration = arguments.number_in(steps, "duration", &DURATION_RANGE)?;
                    Ok(Some(edit(TimelineEdit::SetDuration { keyframe, duration, ripple_free })))
                },
                |command, _| {
                    let Some(TimelineEdit::SetDuration { keyframe, duration, ripple_free }) = edit_of(command) else {
                        return None;
                    };
                    let end = if *ripple_free { " ripple-free" } else { "" };
                    Some(format!("{} {}{end}", keyframe.get(), number_text(duration)))
                },
            )),
    ]
}

/// Moves in time; the order of the list stays.
fn times() -> Vec<Row> {
    /// An hour, either way.
    const LONGEST_MS: i32 = 3_600_000;
    const WORDS: [(StretchEnd, &str); 2] = [(StretchEnd::Start, "start"), (StretchEnd::End, "end")];
    vec![
        edit_with("retime", |command| matches!(edit_of(command), Some(TimelineEdit::RetimeKeyframes(_))))
            .continuous()
            .line(Line::new(
                "retime MS [start|end] [ripple]",
                "moves them in time by whole milliseconds; with `start` or `end` that end of them, and what is between in \
                 proportion; with `ripple` what follows (or comes before the start) moves along",
                |arguments| {
                    let [ms, words @ ..] = arguments.words else { return Ok(None) };
                    let by_ms = arguments.whole_in(ms, "number of milliseconds", &(-LONGEST_MS..=LONGEST_MS))?;
                    let (end, ripples) = match *words {
                        [] => (None, false),
                        ["ripple"] => (None, true),
                        [end] => (Some(end), false),
                        [end, "ripple"] => (Some(end), true),
                        _ => return Ok(None),
                    };
                    let end = end.map(|end| one_of(end, "an end", WORDS.into_iter())).transpose()?;
                    Ok(Some(edit(TimelineEdit::RetimeKeyframes(Retiming { by_ms, end, ripples }))))
                },
                |command, _| {
                    let Some(TimelineEdit::RetimeKeyframes(retiming)) = edit_of(command) else { return None };
                    let end = WORDS.into_iter().find(|(end, _)| retiming.end == Some(*end)).map(|(_, word)| word);
                    let ripples = retiming.ripples.then_some("ripple");
                    let ms = retiming.by_ms.to_string();
                    Some([Some(ms.as_str()), end, ripples].into_iter().flatten().collect::<Vec<_>>().join(" "))
                },
            )),
    ]
}

/// Changes of a node in a keyframe of the list.
fn nodes() -> Vec<Row> {
    vec![
        edit_with("set-keyframe-translation", |command| {
            matches!(edit_of(command), Some(TimelineEdit::SetTranslationInKeyframe(..)))
        })
        .continuous()
        .line(
            Line::new(
                "set-keyframe-translation KEYFRAME X Y Z PATH",
                "places a node in a keyframe of the list",
                |arguments| {
                    let Some(([index, x, y, z], path)) = arguments.then_text() else { return Ok(None) };
                    let (index, translation) = (keyframe(index)?, Vec3::from(numbers(&[x, y, z])?));
                    Ok(Some(edit(TimelineEdit::SetTranslationInKeyframe(index, arguments.rbt(path)?, translation))))
                },
                |command, scene| {
                    let Some(TimelineEdit::SetTranslationInKeyframe(index, rbt, to)) = edit_of(command) else {
                        return None;
                    };
                    Some(format!("{} {} {}", index.get(), vector_text(*to), rbt_path_text(*rbt, scene)?))
                },
            )
            .ending(Ending::NodePath),
        ),
        edit_with("set-keyframe-rotation", |command| {
            matches!(edit_of(command), Some(TimelineEdit::SetRotationInKeyframe(..)))
        })
        .continuous()
        .line(
            Line::new(
                "set-keyframe-rotation KEYFRAME X Y Z W PATH",
                "turns a node in a keyframe of the list",
                |arguments| {
                    let Some(([index, x, y, z, w], path)) = arguments.then_text() else { return Ok(None) };
                    let (index, rotation) = (keyframe(index)?, Quat::from_array(numbers(&[x, y, z, w])?));
                    Ok(Some(edit(TimelineEdit::SetRotationInKeyframe(index, arguments.rbt(path)?, rotation))))
                },
                |command, scene| {
                    let Some(TimelineEdit::SetRotationInKeyframe(index, rbt, to)) = edit_of(command) else {
                        return None;
                    };
                    Some(format!("{} {} {}", index.get(), rotation_text(*to), rbt_path_text(*rbt, scene)?))
                },
            )
            .ending(Ending::NodePath),
        ),
    ]
}

/// Commands of the timeline panel itself, and those of control nodes, whose keys it shows.
fn window() -> Vec<Row> {
    let control = binding("control-node-above", Command::Edit(Edit::Scene(SceneEdit::PutControlAboveChosen)), &[]);
    let rename = binding("keyframe-rename", Command::Window(WindowCommand::RenameCurrent), &["F2"]);
    let fit = |id, command, keys: &[&str]| {
        let binding = binding(id, Command::Window(command), keys);
        Row::listed(Changes::Window, binding.section(8)).can(has_keyframes)
    };
    vec![
        Row::listed(Changes::Document, control)
            .refused(texts::ACT_EDIT_THE_SCENE)
            .can(|editor, _| !editor.session.chosen.is_empty()),
        Row::listed(Changes::Window, rename.section(8))
            .can(|editor, command| !editor.is_playing() && has_keyframes(editor, command)),
        fit("timeline-fit-all", WindowCommand::FitTimeline, &["f"]),
        fit("timeline-fit-selection", WindowCommand::FitSelection, &["Shift+F"]),
    ]
}
