//! The blocks of a page as widgets.

use egui::{Align, FontFamily, FontId, Frame, Label, Layout, Margin, RichText, Stroke, Ui, UiBuilder, pos2, vec2};

use crate::manual::{Block, Link, Span, Style, column_widths};
use crate::ui::theme::{CORNER, TEXT, Tokens, number_font};
use crate::ui::words::Words;
use crate::words::texts;

/// Size of text, in points: larger than that of the panels, as it is read longer.
const SIZE: f32 = TEXT + 1.0;
/// Sizes of headings, from the page's title down, in points.
const HEADINGS: [f32; 3] = [22.0, 17.0, 14.5];
/// Room between the columns of a table, in points.
const GAP: f32 = 14.0;

/// Shows blocks from top to bottom, and scrolls to the heading with an anchor. The result is the link that was clicked.
pub fn show(ui: &mut Ui, blocks: &[Block], anchor: Option<&str>) -> Option<Link> {
    let mut clicked = None;
    ui.spacing_mut().item_spacing = vec2(0.0, 3.0);
    for (at, block) in blocks.iter().enumerate() {
        let is_item = |block: &Block| matches!(block, Block::Item { .. });
        let follows_item = at.checked_sub(1).is_some_and(|before| is_item(&blocks[before]));
        if at > 0 {
            ui.add_space(if is_item(block) && follows_item { 1.0 } else { 6.0 });
        }
        match block {
            Block::Heading { level, anchor: own, text } => heading(ui, *level, text, anchor == Some(own)),
            Block::Paragraph(text) => spans(ui, text, &mut clicked),
            Block::Item { number, text } => item(ui, *number, text, &mut clicked),
            Block::Code(code) => lines(ui, code),
            Block::Table { head, rows } => table(ui, head, rows, &mut clicked),
        }
    }
    ui.add_space(24.0);
    clicked
}

fn heading(ui: &mut Ui, level: u8, text: &[Span], is_target: bool) {
    let size = HEADINGS[usize::from(level.clamp(1, 3)) - 1];
    if level > 1 {
        ui.add_space(8.0);
    }
    let text: String = text.iter().map(|span| span.text.as_str()).collect();
    let colour = if level == 3 { Tokens::of(ui).accent_text } else { Tokens::of(ui).text };
    let response = ui.add(Label::new(RichText::new(text).size(size).color(colour)).wrap());
    if is_target {
        response.scroll_to_me_animation(Some(Align::TOP), egui::style::ScrollAnimation::none());
    }
}

/// Text that wraps.
fn spans(ui: &mut Ui, spans: &[Span], clicked: &mut Option<Link>) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(0.0, 3.0);
        ui.spacing_mut().interact_size.y = SIZE;
        for span in spans {
            let text = styled(ui, span);
            match &span.link {
                Some(link @ Link::Page { .. }) => {
                    if ui.link(text).clicked() {
                        *clicked = Some(link.clone());
                    }
                }
                // There is no such file in an installed program.
                Some(Link::File(path)) => {
                    ui.label(text).on_hover_text(path.trim_start_matches("../"));
                }
                None => {
                    ui.label(text);
                }
            }
        }
    });
}

fn styled(ui: &Ui, span: &Span) -> RichText {
    let tokens = Tokens::of(ui);
    let text = match span.style {
        Style::Picture => Words::of(ui).message(texts::manual_picture(&span.text)),
        _ => span.text.clone(),
    };
    let text = RichText::new(text).size(SIZE);
    let is_link = matches!(span.link, Some(Link::Page { .. }));
    let colour = if is_link { tokens.information } else { tokens.text };
    match span.style {
        Style::Plain => text.color(colour),
        Style::Emphasis => text.color(colour).italics(),
        Style::Strong => text.color(tokens.accent_text),
        Style::Code => text.font(FontId::new(SIZE - 1.0, FontFamily::Monospace)).color(colour).code(),
        Style::Picture => text.color(tokens.dim).italics(),
    }
}

fn item(ui: &mut Ui, number: Option<u64>, text: &[Span], clicked: &mut Option<Link>) {
    ui.horizontal_top(|ui| {
        let mark = number.map_or_else(|| "•".to_owned(), |number| format!("{number}."));
        let (rect, _) = ui.allocate_exact_size(vec2(22.0, SIZE + 3.0), egui::Sense::hover());
        let at = rect.right_top() + vec2(-6.0, 2.0);
        let font = FontId::new(SIZE, FontFamily::Proportional);
        ui.painter().text(at, egui::Align2::RIGHT_TOP, mark, font, Tokens::of(ui).dim);
        ui.vertical(|ui| spans(ui, text, clicked));
    });
}

/// Lines as they are; long ones wrap.
fn lines(ui: &mut Ui, code: &str) {
    let tokens = Tokens::of(ui);
    Frame::new().fill(tokens.window).corner_radius(CORNER).inner_margin(Margin::symmetric(10, 8)).show(ui, |ui| {
        ui.set_width(ui.available_width());
        let text = RichText::new(code).font(number_font()).color(tokens.text);
        ui.add(Label::new(text).selectable(true).wrap());
    });
}

fn table(ui: &mut Ui, head: &[Vec<Span>], rows: &[Vec<Vec<Span>>], clicked: &mut Option<Link>) {
    let tokens = Tokens::of(ui);
    let room = ui.available_width() - GAP * head.len().saturating_sub(1) as f32;
    let natural: Vec<usize> = (0..head.len())
        .map(|column| {
            let cells = rows.iter().map(|row| &row[column]).chain([&head[column]]);
            cells.map(|cell| width(ui, cell)).max().unwrap_or_default()
        })
        .collect();
    let widths = column_widths(&natural, room as usize);
    let line = |ui: &mut Ui, colour| {
        let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 3.0), egui::Sense::hover());
        ui.painter().hline(rect.x_range(), rect.center().y, Stroke::new(1.0, colour));
    };
    row(ui, head, &widths, clicked);
    line(ui, tokens.strong_line);
    for cells in rows {
        row(ui, cells, &widths, clicked);
        line(ui, tokens.line);
    }
}

/// Width of a cell that does not wrap, in points.
fn width(ui: &Ui, cell: &[Span]) -> usize {
    let width = |span: &Span| {
        let text = egui::WidgetText::from(styled(ui, span));
        let galley = text.into_galley(ui, Some(egui::TextWrapMode::Extend), f32::INFINITY, egui::TextStyle::Body);
        galley.size().x
    };
    cell.iter().map(width).sum::<f32>().ceil() as usize + 4
}

/// Cells side by side, as high as the highest of them.
fn row(ui: &mut Ui, cells: &[Vec<Span>], widths: &[usize], clicked: &mut Option<Link>) {
    let start = ui.available_rect_before_wrap().min;
    let mut x = start.x;
    let mut bottom = start.y;
    for (cell, width) in cells.iter().zip(widths) {
        let rect = egui::Rect::from_min_size(pos2(x, start.y), vec2(*width as f32, f32::INFINITY));
        let builder = UiBuilder::new().max_rect(rect).layout(Layout::top_down(Align::Min));
        let used = ui.scope_builder(builder, |ui| spans(ui, cell, clicked)).response.rect;
        bottom = bottom.max(used.bottom());
        x += *width as f32 + GAP;
    }
    ui.advance_cursor_after_rect(egui::Rect::from_min_max(start, pos2(start.x + ui.available_width(), bottom)));
}
