//! From Markdown to blocks.

use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag, TagEnd};

use super::{Block, Entry, Link, Part, Span, Style};

/// Markdown that the window and the terminal cannot show, as the parser names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem(pub String);

/// The blocks of a page. What cannot be shown is left out.
pub fn blocks(markdown: &str) -> Vec<Block> {
    read(markdown).blocks
}

/// What of a page cannot be shown: nested lists, quotes, and the like.
#[must_use]
pub fn problems(markdown: &str) -> Vec<Problem> {
    read(markdown).problems
}

/// The parts and pages that `SUMMARY.md` lists.
pub fn contents(summary: &str) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    for block in blocks(summary) {
        match block {
            Block::Heading { text, .. } => parts.push(Part { title: plain(&text), pages: Vec::new() }),
            Block::Item { text, .. } => {
                let title = plain(&text);
                let name = text.into_iter().find_map(|span| match span.link {
                    Some(Link::Page { name, .. }) => Some(name),
                    _ => None,
                });
                if let (Some(part), Some(name)) = (parts.last_mut(), name) {
                    part.pages.push(Entry { name, title });
                }
            }
            _ => {}
        }
    }
    // The summary's own title has no pages.
    parts.retain(|part| !part.pages.is_empty());
    parts
}

/// The text of spans, without styles.
pub fn plain(spans: &[Span]) -> String {
    spans.iter().map(|span| span.text.as_str()).collect()
}

/// The anchor of a heading, as GitHub and mdBook make it.
fn anchor(heading: &str) -> String {
    let kept = |letter: &char| letter.is_alphanumeric() || matches!(letter, ' ' | '-' | '_');
    heading.trim().to_lowercase().chars().filter(kept).map(|letter| if letter == ' ' { '-' } else { letter }).collect()
}

fn link(destination: &str) -> Link {
    let (file, anchor) = match destination.split_once('#') {
        Some((file, anchor)) => (file, Some(anchor.to_owned())),
        None => (destination, None),
    };
    match file.strip_suffix(".md").filter(|name| !name.contains('/')) {
        Some(name) => Link::Page { name: name.to_owned(), anchor },
        None => Link::File(destination.to_owned()),
    }
}

/// A list that is open.
#[derive(Clone, Copy)]
struct List {
    /// The number of the next item, in a numbered list.
    next: Option<u64>,
}

/// What the parser is in.
#[derive(Default)]
struct Reader {
    blocks: Vec<Block>,
    problems: Vec<Problem>,
    spans: Vec<Span>,
    style: Style,
    link: Option<Link>,
    /// The list that is open.
    list: Option<List>,
    code: Option<String>,
    /// The cells of the table's row that is open.
    row: Vec<Vec<Span>>,
    /// The rows that are closed; the first is the table's head.
    rows: Vec<Vec<Vec<Span>>>,
}

fn read(markdown: &str) -> Reader {
    let mut reader = Reader::default();
    for event in Parser::new_ext(markdown, Options::ENABLE_TABLES) {
        reader.take(event);
    }
    reader
}

impl Reader {
    fn take(&mut self, event: Event<'_>) {
        match event {
            Event::Start(tag) => self.start(tag),
            Event::End(tag) => self.end(tag),
            Event::Text(text) => match &mut self.code {
                Some(code) => code.push_str(&text),
                None => self.push(&text, self.style),
            },
            Event::Code(text) => self.push(&text, Style::Code),
            Event::SoftBreak | Event::HardBreak => self.push(" ", self.style),
            // Marks of generated tables.
            Event::Html(text) if text.trim_start().starts_with("<!--") => {}
            other => self.problems.push(Problem(format!("{other:?}"))),
        }
    }

    fn push(&mut self, text: &str, style: Style) {
        match self.spans.last_mut() {
            Some(last) if last.style == style && last.link == self.link => last.text.push_str(text),
            _ => self.spans.push(Span { text: text.to_owned(), style, link: self.link.clone() }),
        }
    }

    fn start(&mut self, tag: Tag<'_>) {
        match tag {
            Tag::Heading { .. } | Tag::Paragraph | Tag::HtmlBlock | Tag::TableRow | Tag::TableCell | Tag::TableHead => {
            }
            Tag::Emphasis => self.style = Style::Emphasis,
            Tag::Strong => self.style = Style::Strong,
            Tag::Image { .. } => self.style = Style::Picture,
            Tag::Link { dest_url, .. } => self.link = Some(link(&dest_url)),
            Tag::CodeBlock(_) => self.code = Some(String::new()),
            Tag::List(next) if self.list.is_none() => self.list = Some(List { next }),
            Tag::Item => self.spans.clear(),
            Tag::Table(_) => {}
            other => self.problems.push(Problem(format!("{other:?}"))),
        }
    }

    fn end(&mut self, tag: TagEnd) {
        match tag {
            TagEnd::Emphasis | TagEnd::Strong | TagEnd::Image => self.style = Style::Plain,
            TagEnd::Link => self.link = None,
            TagEnd::Heading(level) => {
                let text = std::mem::take(&mut self.spans);
                let level = match level {
                    HeadingLevel::H1 => 1,
                    HeadingLevel::H2 => 2,
                    _ => 3,
                };
                self.blocks.push(Block::Heading { level, anchor: anchor(&plain(&text)), text });
            }
            // An item's paragraph ends with the item.
            TagEnd::Paragraph if self.list.is_some() => {}
            TagEnd::Paragraph => {
                let text = std::mem::take(&mut self.spans);
                self.blocks.push(Block::Paragraph(text));
            }
            TagEnd::Item => {
                let text = std::mem::take(&mut self.spans);
                let number = self.list.and_then(|list| list.next);
                self.list = Some(List { next: number.map(|number| number + 1) });
                self.blocks.push(Block::Item { number, text });
            }
            TagEnd::List(_) => self.list = None,
            TagEnd::CodeBlock => {
                let code = self.code.take().unwrap_or_default();
                self.blocks.push(Block::Code(code.trim_end().to_owned()));
            }
            TagEnd::TableCell => {
                let cell = std::mem::take(&mut self.spans);
                self.row.push(cell);
            }
            TagEnd::TableHead | TagEnd::TableRow => self.rows.push(std::mem::take(&mut self.row)),
            TagEnd::Table => {
                let mut rows = std::mem::take(&mut self.rows).into_iter();
                self.blocks.push(Block::Table { head: rows.next().unwrap_or_default(), rows: rows.collect() });
            }
            _ => {}
        }
    }
}
