//! Commands of the keyframe list.

use super::line::Line;
use super::row::{Binding, Changes, Group, Row};
use super::values::keyframe;
use crate::editor::{Command, Edit, Editor};
use crate::words::texts;

fn listed(id: &'static str, edit: Edit, keys: &[&str]) -> Row {
    Row::listed(Changes::Document, Binding::new(Group::Keyframes, id, Command::Edit(edit)).hotkeys(keys))
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
    let stepping = |id, edit, keys: &[&str]| {
        let binding = Binding::new(Group::Keyframes, id, Command::Edit(edit)).repeating_hotkeys(keys);
        Row::listed(Changes::Document, binding).refused(texts::ACT_GO_TO_ANOTHER_KEYFRAME)
    };
    vec![
        listed("keyframe-display", Edit::DisplayCurrent, &["Space", "c"])
            .refused(texts::ACT_DISPLAY_A_KEYFRAME)
            .can(has_keyframes),
        listed("keyframe-update", Edit::UpdateCurrent, &["u"]).refused(texts::ACT_UPDATE_A_KEYFRAME),
        stepping("keyframe-next", Edit::GoToNext, &[">", "."]).can(is_before_last),
        stepping("keyframe-previous", Edit::GoToPrevious, &["<", ","]).can(is_after_first),
        listed("keyframe-first", Edit::GoToFirst, &[]).refused(texts::ACT_GO_TO_ANOTHER_KEYFRAME).can(is_after_first),
        listed("keyframe-last", Edit::GoToLast, &[]).refused(texts::ACT_GO_TO_ANOTHER_KEYFRAME).can(is_before_last),
        Row::of(Changes::Document, "go", |command| matches!(command, Command::Edit(Edit::GoTo(_))))
            .refused(texts::ACT_GO_TO_ANOTHER_KEYFRAME)
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
        listed("keyframe-delete", Edit::DeleteCurrent, &["d"]).refused(texts::ACT_DELETE_A_KEYFRAME).can(has_keyframes),
        listed("keyframe-new", Edit::CreateKeyframe, &["n"]).refused(texts::ACT_CREATE_A_KEYFRAME),
        listed("pose-rest", Edit::ResetPose, &["r"]).refused(texts::ACT_RETURN_TO_THE_REST_POSE),
    ]
}
