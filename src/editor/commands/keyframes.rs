//! Commands of the keyframe list.

use super::line::Line;
use super::row::{Binding, Changes, Group, Row};
use super::values::keyframe;
use crate::editor::{Command, Edit, Editor};

fn listed(id: &'static str, edit: Edit, name: &'static str, help: &'static str, keys: &[&str]) -> Row {
    Row::listed(Changes::Document, Binding::new(Group::Keyframes, id, Command::Edit(edit), name, help).hotkeys(keys))
}

fn has_keyframes(editor: &Editor, _: &Command) -> bool {
    !editor.document.keyframes.is_empty()
}

fn is_after_first(editor: &Editor, _: &Command) -> bool {
    editor.document.keyframes.current().is_some_and(|current| current.get() > 0)
}

fn is_before_last(editor: &Editor, _: &Command) -> bool {
    editor.document.keyframes.current() != editor.document.keyframes.last()
}

pub(super) fn rows() -> Vec<Row> {
    let stepping = |id, edit, name, help, keys: &[&str]| {
        let binding = Binding::new(Group::Keyframes, id, Command::Edit(edit), name, help).repeating_hotkeys(keys);
        Row::listed(Changes::Document, binding).refused("go to another keyframe")
    };
    vec![
        listed(
            "keyframe-display",
            Edit::DisplayCurrent,
            "Display keyframe",
            "Copy the current keyframe to the scene",
            &["Space", "c"],
        )
        .refused("display a keyframe")
        .can(has_keyframes),
        listed(
            "keyframe-update",
            Edit::UpdateCurrent,
            "Update keyframe",
            "Update the current keyframe from the scene",
            &["u"],
        )
        .refused("update a keyframe"),
        stepping(
            "keyframe-next",
            Edit::GoToNext,
            "Next keyframe",
            "Go to the next keyframe and copy it to the scene",
            &[">", "."],
        )
        .can(is_before_last),
        stepping(
            "keyframe-previous",
            Edit::GoToPrevious,
            "Previous keyframe",
            "Go to the previous keyframe and copy it to the scene",
            &["<", ","],
        )
        .can(is_after_first),
        listed(
            "keyframe-first",
            Edit::GoToFirst,
            "First keyframe",
            "Go to the first keyframe and copy it to the scene",
            &[],
        )
        .refused("go to another keyframe")
        .can(is_after_first),
        listed(
            "keyframe-last",
            Edit::GoToLast,
            "Last keyframe",
            "Go to the last keyframe and copy it to the scene",
            &[],
        )
        .refused("go to another keyframe")
        .can(is_before_last),
        Row::of(Changes::Document, "go", |command| matches!(command, Command::Edit(Edit::GoTo(_))))
            .refused("go to another keyframe")
            .can(|editor, command| {
                let Command::Edit(Edit::GoTo(index)) = command else { return false };
                editor.document.keyframes.get(*index).is_some()
            })
            .line(Line::new(
                "go KEYFRAME",
                "makes a keyframe current and copies it to the scene",
                |arguments| {
                    let &[index] = arguments.words else { return Ok(None) };
                    Ok(Some(Command::Edit(Edit::GoTo(keyframe(index)?))))
                },
                |command, _| {
                    let Command::Edit(Edit::GoTo(index)) = command else { return None };
                    Some(index.get().to_string())
                },
            )),
        listed("keyframe-delete", Edit::DeleteCurrent, "Delete keyframe", "Delete the current keyframe", &["d"])
            .refused("delete a keyframe")
            .can(has_keyframes),
        listed(
            "keyframe-new",
            Edit::CreateKeyframe,
            "New keyframe",
            "New keyframe from the scene, after the current one",
            &["n"],
        )
        .refused("create a keyframe"),
        listed("pose-rest", Edit::ResetPose, "Rest pose", "Return the scene to its rest pose", &["r"])
            .refused("return to the rest pose"),
    ]
}
