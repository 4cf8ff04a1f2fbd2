//! A page as plain text for a terminal.

use super::parse::plain;
use super::{Block, Link, Page, Span, Style};

/// Characters between the columns of a table.
const GAP: usize = 2;
/// How narrow a column can get, in characters.
const NARROWEST: usize = 6;

/// The page as lines of at most `width` characters, but for code, which stays as it is.
#[must_use]
pub fn text(page: &Page, width: usize) -> String {
    let mut lines: Vec<String> = Vec::new();
    let mut was_item = false;
    for block in &page.blocks {
        let is_item = matches!(block, Block::Item { .. });
        let is_first = lines.is_empty();
        let follows_item = is_item && was_item;
        if !is_first && !follows_item {
            lines.push(String::new());
        }
        was_item = is_item;
        match block {
            Block::Heading { level, text, .. } => heading(*level, &plain(text), &mut lines),
            Block::Paragraph(text) => lines.extend(wrap(&written(text), width)),
            Block::Item { number, text } => {
                let mark = number.map_or_else(|| "* ".to_owned(), |number| format!("{number}. "));
                let indent = " ".repeat(mark.len());
                for (row, line) in wrap(&written(text), width - mark.len()).into_iter().enumerate() {
                    lines.push(format!("{}{line}", if row == 0 { &mark } else { &indent }));
                }
            }
            Block::Code(code) => lines.extend(code.lines().map(|line| format!("    {line}").trim_end().to_owned())),
            Block::Table { head, rows } => table(head, rows, width, &mut lines),
        }
    }
    lines.push(String::new());
    lines.join("\n")
}

/// Column widths that fit into `room`: the wide columns give way first, none below a sixth of its equal share.
///
/// `natural` and `room` are in one unit, characters or points.
#[must_use]
pub fn column_widths(natural: &[usize], room: usize) -> Vec<usize> {
    let mut cap = natural.iter().copied().max().unwrap_or_default();
    let least = (room / natural.len().max(1) / 6).max(1);
    let capped = |cap: usize| natural.iter().map(move |width| (*width).min(cap));
    while cap > least && capped(cap).sum::<usize>() > room {
        cap -= 1;
    }
    capped(cap).collect()
}

fn heading(level: u8, text: &str, lines: &mut Vec<String>) {
    lines.push(text.to_owned());
    let underline = match level {
        1 => "=",
        2 => "-",
        _ => return,
    };
    lines.push(underline.repeat(text.chars().count()));
}

/// The text of spans with what a terminal can show of their styles: code in quotes, the names of linked pages, captions.
fn written(spans: &[Span]) -> String {
    let mut text = String::new();
    for span in spans {
        match span.style {
            Style::Code => text.extend(["`", &span.text, "`"]),
            Style::Picture => text.extend(["[Picture: ", &span.text, "]"]),
            Style::Plain | Style::Emphasis | Style::Strong => text.push_str(&span.text),
        }
        if let Some(Link::Page { name, .. }) = &span.link {
            text.extend([" (inbetween help ", name, ")"]);
        }
    }
    text
}

/// Lines of at most `width` characters; a longer word has a line of its own.
fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    let mut used = 0;
    for word in text.split_whitespace() {
        let length = word.chars().count();
        let line = lines.last_mut().expect("there is at least one line");
        if line.is_empty() {
            line.push_str(word);
            used = length;
        } else if used + 1 + length <= width {
            line.push(' ');
            line.push_str(word);
            used += 1 + length;
        } else {
            lines.push(word.to_owned());
            used = length;
        }
    }
    lines
}

fn table(head: &[Vec<Span>], rows: &[Vec<Vec<Span>>], width: usize, lines: &mut Vec<String>) {
    let texts = |row: &[Vec<Span>]| row.iter().map(|cell| written(cell)).collect::<Vec<_>>();
    let all: Vec<Vec<String>> = std::iter::once(head).chain(rows.iter().map(Vec::as_slice)).map(texts).collect();
    let natural: Vec<usize> = (0..head.len())
        .map(|column| all.iter().map(|row| row[column].chars().count()).max().unwrap_or_default().max(NARROWEST))
        .collect();
    let gaps = GAP * head.len().saturating_sub(1);
    let widths = column_widths(&natural, width.saturating_sub(gaps));
    for (at, row) in all.iter().enumerate() {
        let cells: Vec<Vec<String>> = row.iter().zip(&widths).map(|(cell, width)| wrap(cell, *width)).collect();
        let height = cells.iter().map(Vec::len).max().unwrap_or_default();
        for line in 0..height {
            let mut text = String::new();
            for (cell, width) in cells.iter().zip(&widths) {
                let part = cell.get(line).map_or("", String::as_str);
                text.push_str(part);
                text.push_str(&" ".repeat((width + GAP).saturating_sub(part.chars().count())));
            }
            lines.push(text.trim_end().to_owned());
        }
        if at == 0 {
            lines.push("-".repeat(widths.iter().sum::<usize>() + gaps));
        }
    }
}
