//! A bar above the view with a sentence and answers. It takes no keyboard focus of its own and stays until it is answered.

use egui::{Align, Button, Frame, Label, Layout, Margin, Panel, RichText, Ui};

use super::icons::was_pressed;
use super::theme::Tokens;
use super::words::Words;
use crate::words::{Message, Phrase};

/// Shows a bar. `tip` is shown while the pointer rests on the sentence. The answers stand at the right end, the first of them leftmost.
pub(super) fn show<A: Copy>(
    ui: &mut Ui,
    name: &'static str,
    said: Message,
    tip: String,
    answers: &[(Phrase, A)],
) -> Option<A> {
    let tokens = Tokens::of(ui);
    let words = Words::of(ui);
    let frame = Frame::new().fill(tokens.panel).inner_margin(Margin::symmetric(12, 6));
    let bar = Panel::top(name).frame(frame).show(ui, |ui| {
        let mut answer = None;
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            for (text, meant) in answers.iter().rev() {
                if was_pressed(&ui.add(Button::new(words.say(*text)))) {
                    answer = Some(*meant);
                }
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                ui.add(Label::new(RichText::new(words.message(said)).color(tokens.text)).truncate()).on_hover_text(tip);
            });
        });
        answer
    });
    bar.inner
}
