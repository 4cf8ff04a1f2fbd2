//! Graphs.
use super::hit::Target;
use super::paint::Look;
use crate::editor::{Command, Editor};
use egui::{Painter, Response, Ui};

#[derive(Clone, Debug, Default)]
pub struct Graphs {}

impl Graphs {
    pub const fn is_dragging(&self) -> bool {
        false
    }
    pub fn pointer(&mut self, _ui: &Ui, _r: &Response, _t: &Target<'_>, _e: &Editor, _c: &mut Vec<Command>) -> bool {
        false
    }
    pub fn paint(&self, _p: &Painter, _l: &Look<'_>) {}
    pub fn legend(&mut self, _ui: &Ui, _l: &Look<'_>) {}
    pub fn tip(&self, _r: &Response, _l: &Look<'_>) -> bool {
        false
    }
}
