//! The manual: Markdown pages under `assets/manual`, embedded as text and parsed into blocks that the window draws and the terminal prints.
//!
//! Nothing here knows who shows a page. A picture is its caption.

mod parse;
mod text;

pub use parse::{Problem, problems};
pub use text::{column_widths, text};

/// The pages' names and Markdown, sorted by name; `SUMMARY` lists them in reading order.
static FILES: &[(&str, &str)] = &include!(concat!(env!("OUT_DIR"), "/manual.rs"));

/// The file that lists the pages.
const SUMMARY: &str = "SUMMARY";

/// A part of the table of contents.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Its heading.
    pub title: String,
    /// Its pages, in reading order.
    pub pages: Vec<Entry>,
}

/// A page in the table of contents.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The file's name without its ending; the topic of `inbetween help`.
    pub name: String,
    /// What the table of contents calls it.
    pub title: String,
}

/// A page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Page {
    /// The file's name without its ending.
    pub name: &'static str,
    /// What it is made of, from top to bottom.
    pub blocks: Vec<Block>,
}

/// A part of a page that stands on lines of its own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Block {
    /// A heading.
    Heading {
        /// 1 for the page's title, 2 and 3 below it.
        level: u8,
        /// What links to it end with, after `#`.
        anchor: String,
        /// Its text.
        text: Vec<Span>,
    },
    /// A paragraph.
    Paragraph(Vec<Span>),
    /// An item of a list.
    Item {
        /// Its number in a numbered list.
        number: Option<u64>,
        /// Its text.
        text: Vec<Span>,
    },
    /// Lines that are shown as they are.
    Code(String),
    /// A table.
    Table {
        /// The cells of the first row.
        head: Vec<Vec<Span>>,
        /// The cells of the other rows, as many in each as in the first.
        rows: Vec<Vec<Vec<Span>>>,
    },
}

/// A run of text in one style.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Span {
    /// The text.
    pub text: String,
    /// How it is set.
    pub style: Style,
    /// Where a click leads.
    pub link: Option<Link>,
}

/// How a run of text is set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// As text.
    #[default]
    Plain,
    /// Emphasised: names of menu items.
    Emphasis,
    /// Strong.
    Strong,
    /// In the fixed-width font: what is typed, and names in files.
    Code,
    /// The caption of a picture.
    Picture,
}

/// Where a link leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Link {
    /// To a page of the manual.
    Page {
        /// The page's name.
        name: String,
        /// The heading's anchor; the page's start if there is none.
        anchor: Option<String>,
    },
    /// To a file of the project, by its path from the folder of the manual.
    File(String),
}

/// The table of contents.
#[must_use]
pub fn contents() -> Vec<Part> {
    parse::contents(markdown(SUMMARY).unwrap_or_default())
}

/// The names of all pages, in reading order.
#[must_use]
pub fn names() -> Vec<String> {
    contents().into_iter().flat_map(|part| part.pages).map(|entry| entry.name).collect()
}

/// The page of this name, if there is one.
#[must_use]
pub fn page(name: &str) -> Option<Page> {
    let (name, markdown) = FILES.iter().find(|(known, _)| *known == name && name != SUMMARY)?;
    Some(Page { name, blocks: parse::blocks(markdown) })
}

/// The Markdown of a page.
#[must_use]
pub fn markdown(name: &str) -> Option<&'static str> {
    FILES.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
}

impl Page {
    /// The anchors of the page's headings, from top to bottom.
    pub fn anchors(&self) -> impl Iterator<Item = &str> {
        self.blocks.iter().filter_map(|block| match block {
            Block::Heading { anchor, .. } => Some(anchor.as_str()),
            _ => None,
        })
    }

    /// The page's links, from top to bottom.
    pub fn links(&self) -> impl Iterator<Item = &Link> {
        self.spans().filter_map(|span| span.link.as_ref())
    }

    fn spans(&self) -> impl Iterator<Item = &Span> {
        self.blocks.iter().flat_map(|block| -> Box<dyn Iterator<Item = &Span>> {
            match block {
                Block::Heading { text, .. } | Block::Paragraph(text) | Block::Item { text, .. } => {
                    Box::new(text.iter())
                }
                Block::Code(_) => Box::new(std::iter::empty()),
                Block::Table { head, rows } => Box::new(head.iter().chain(rows.iter().flatten()).flatten()),
            }
        })
    }
}

#[cfg(test)]
mod tests;
