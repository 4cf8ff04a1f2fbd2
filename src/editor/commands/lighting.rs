//! The command of the scene's lighting.

use super::line::Line;
use super::row::{Binding, Changes, Group, Row, Submenu};
use super::values::one_of;
use crate::editor::{Command, Edit, SceneEdit};
use crate::lighting::BuiltInLighting;
use crate::words::texts;

/// The section of its menu in the menu View, with what else is looked at.
const SECTION: u8 = 4;

const fn command(lighting: BuiltInLighting) -> Command {
    Command::Edit(Edit::Scene(SceneEdit::SetLighting(lighting)))
}

const fn lighting_of(command: &Command) -> Option<BuiltInLighting> {
    match command {
        Command::Edit(Edit::Scene(SceneEdit::SetLighting(lighting))) => Some(*lighting),
        _ => None,
    }
}

pub(super) fn rows() -> Vec<Row> {
    let of = |id, lighting| Binding::new(Group::View, id, command(lighting)).within(Submenu::Lighting, SECTION);
    vec![
        Row::of(Changes::Document, "lighting", |command| lighting_of(command).is_some())
            .refused(texts::ACT_EDIT_THE_SCENE)
            .binding(
                of("lighting-day", BuiltInLighting::Day).ticked(|editor, _| editor.is_lit_by(BuiltInLighting::Day)),
            )
            .binding(
                of("lighting-evening", BuiltInLighting::Evening)
                    .ticked(|editor, _| editor.is_lit_by(BuiltInLighting::Evening)),
            )
            .binding(
                of("lighting-studio", BuiltInLighting::Studio)
                    .ticked(|editor, _| editor.is_lit_by(BuiltInLighting::Studio)),
            )
            .line(Line::new(
                "lighting day|evening|studio",
                "the light of the scene",
                |arguments| {
                    let &[name] = arguments.words else { return Ok(None) };
                    let all = BuiltInLighting::ALL.into_iter().map(|lighting| (lighting, lighting.name()));
                    Ok(Some(command(one_of(name, "a lighting", all)?)))
                },
                |command, _| lighting_of(command).map(|lighting| lighting.name().to_owned()),
            )),
    ]
}
