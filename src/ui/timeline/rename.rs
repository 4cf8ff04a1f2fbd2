//! The field that a keyframe's name is typed into.

use egui::{Id, Key, Rect, Role, TextEdit, Ui, WidgetInfo, pos2, vec2};

use super::Timeline;
use super::hit::Target;
use crate::editor::{Command, Edit, Editor, TimelineEdit};
use crate::keyframe::KeyframeIndex;
use crate::ui::theme::ROW;
use crate::ui::words::Words;
use crate::words::texts;

/// Width of the field that a name is typed into.
const NAME_FIELD: f32 = 120.0;

/// A name that is being typed.
#[derive(Clone, Debug)]
pub struct Renaming {
    keyframe: KeyframeIndex,
    typed: String,
    is_new: bool,
}

impl Timeline {
    /// Shows the field for a keyframe's name.
    pub(super) fn start_renaming(&mut self, editor: &Editor, keyframe: Option<KeyframeIndex>) {
        let Some(index) = keyframe else { return };
        let Some(keyframe) = editor.document().keyframes.get(index) else { return };
        let typed = keyframe.name.as_deref().unwrap_or_default().to_owned();
        self.renaming = Some(Renaming { keyframe: index, typed, is_new: true });
    }

    /// Shows the field while a name is being typed.
    pub(super) fn rename_field(
        &mut self,
        ui: &mut Ui,
        target: &Target<'_>,
        editor: &Editor,
        commands: &mut Vec<Command>,
    ) {
        let Some(renaming) = &mut self.renaming else { return };
        let index = renaming.keyframe.get();
        if index >= target.columns.len() || editor.is_playing() {
            self.renaming = None;
            return;
        }
        let tracks = target.layout.tracks;
        let x = target.scale.x_of(target.columns.time(index)) - 12.0;
        let x = x.min(tracks.right() - NAME_FIELD - 4.0).max(tracks.left() + 4.0);
        let area = Rect::from_min_size(pos2(x, target.layout.ruler.top() + 8.0), vec2(NAME_FIELD, ROW + 2.0));
        let id = Id::unique("name of a keyframe");
        let hint = Words::of(ui).message(texts::name_of_keyframe(index.to_string()));
        let field = TextEdit::singleline(&mut renaming.typed)
            .id(id)
            .hint_text(&hint)
            .char_limit(100)
            .align(egui::Align2::LEFT_CENTER);
        let response = ui.put(area, field);
        response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, &hint));
        if std::mem::take(&mut renaming.is_new) {
            response.request_focus();
            select_all(ui, id, renaming.typed.chars().count());
            return;
        }
        if !response.lost_focus() {
            return;
        }
        let is_cancelled = ui.input(|input| input.key_pressed(Key::Escape));
        if let Some(Renaming { keyframe, typed, .. }) = self.renaming.take().filter(|_| !is_cancelled) {
            let before = editor.document().keyframes.get(keyframe).and_then(|keyframe| keyframe.name.as_deref());
            if before.unwrap_or_default() != typed.trim() {
                commands.push(Command::Edit(Edit::Timeline(TimelineEdit::RenameKeyframe(keyframe, typed))));
            }
        }
    }
}

fn select_all(ui: &Ui, id: Id, characters: usize) {
    let mut state = egui::text_edit::TextEditState::load(ui.ctx(), id).unwrap_or_default();
    let all = egui::text::CCursorRange::two(egui::text::CCursor::new(0), egui::text::CCursor::new(characters));
    state.cursor.set_char_range(Some(all));
    state.store(ui.ctx(), id);
}
