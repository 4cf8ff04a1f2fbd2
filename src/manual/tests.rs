//! Blocks from Markdown, and a page as text.

use super::*;

const MARKDOWN: &str = "\
# A title

Some *text* with `code` and a [link](other.md#part-two), two\nlines.

1. One
2. Two

![A caption](pictures/a.png)

| key | does |
|---|---|
| `a` | a long sentence that does not fit into a line of the terminal |
| `b\\|c` | short |

```console
$ inbetween
```
";

#[test]
fn markdown_becomes_blocks() {
    let blocks = parse::blocks(MARKDOWN);
    assert_eq!(parse::problems(MARKDOWN), []);
    assert!(matches!(&blocks[0], Block::Heading { level: 1, anchor, .. } if anchor == "a-title"));
    let Block::Paragraph(text) = &blocks[1] else { panic!("{:?}", blocks[1]) };
    assert_eq!(text[1], Span { text: "text".to_owned(), style: Style::Emphasis, link: None });
    let link = Link::Page { name: "other".to_owned(), anchor: Some("part-two".to_owned()) };
    assert_eq!(text[5], Span { text: "link".to_owned(), style: Style::Plain, link: Some(link) });
    assert!(matches!(&blocks[3], Block::Item { number: Some(2), .. }));
    assert!(matches!(&blocks[4], Block::Paragraph(text) if text[0].style == Style::Picture));
    let Block::Table { head, rows } = &blocks[5] else { panic!("{:?}", blocks[5]) };
    assert_eq!((head.len(), rows.len(), parse::plain(&rows[1][0])), (2, 2, "b|c".to_owned()));
    assert_eq!(blocks[6], Block::Code("$ inbetween".to_owned()));
}

#[test]
fn what_cannot_be_shown_is_a_problem() {
    for markdown in ["> a quote\n", "* a\n  * b\n", "<b>bold</b>\n", "a\n\n---\n"] {
        assert!(!parse::problems(markdown).is_empty(), "{markdown}");
    }
}

#[test]
fn a_page_is_text_that_fits() {
    let page = Page { name: "a", blocks: parse::blocks(MARKDOWN) };
    let expected = "\
A title
=======

Some text with `code` and a link
(inbetween help other), two lines.

1. One
2. Two

[Picture: A caption]

key     does
----------------------------------------
`a`     a long sentence that does not
        fit into a line of the terminal
`b|c`   short

    $ inbetween
";
    assert_eq!(text(&page, 40), expected);
}

#[test]
fn wide_columns_give_way_first() {
    assert_eq!(column_widths(&[5, 10], 20), [5, 10]);
    assert_eq!(column_widths(&[5, 100, 40], 45), [5, 20, 20]);
    assert_eq!(column_widths(&[], 45), [0; 0]);
}
