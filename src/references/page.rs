//! The page that shows what `verify` found: reference, actual picture and difference of each picture that is not as it should be.
//!
//! The pictures are files beside the page. Its Content Security Policy allows its own style and script by their hashes, and nothing else.

use std::fmt::Write as _;
use std::path::Path;

use super::{Row, Verdict};
use crate::markup::{escaped, policy_hash};

/// The page's name in the folder of what is drawn.
pub const PAGE_NAME: &str = "index.html";

const STYLE: &str = include_str!("page/style.css");
const SCRIPT: &str = include_str!("page/script.js");

/// The page. `summary` is its heading, and `folder` that of the references.
#[must_use]
pub fn page(rows: &[Row<'_>], summary: &str, folder: &Path) -> String {
    let (good, bad): (Vec<&Row<'_>>, Vec<&Row<'_>>) = rows.iter().partition(|row| row.verdict.is_good());
    let (style, script) = (policy_hash(STYLE), policy_hash(SCRIPT));
    let mut text = format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self' file:; style-src {style}; script-src \
         {script}\">\n<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n<style>{STYLE}</style></head><body>\n\
         <h1 class=\"{1}\">{0}</h1>\n<p>Reference pictures of {2}</p>\n",
        escaped(summary),
        if bad.is_empty() { "good" } else { "bad" },
        escaped(&folder.display().to_string()),
    );
    for row in bad {
        push_failure(&mut text, row);
    }
    if !good.is_empty() {
        let _ = writeln!(
            text,
            "<details><summary>{} as they should be</summary>\n<table><tr><th>picture</th><th>score</th><th>tolerance</th></tr>",
            good.len()
        );
        for row in good {
            let Verdict::Compared { scores, tolerance } = &row.verdict else { continue };
            let (link, name) = (address(&row.shot.drawn_name()), escaped(&row.shot.name));
            let _ = writeln!(
                text,
                "<tr><td><a href=\"{link}\">{name}</a></td><td>{:.6}</td><td>{tolerance}</td></tr>",
                scores.score
            );
        }
        text.push_str("</table></details>\n");
    }
    let _ = writeln!(text, "<script>{SCRIPT}</script>\n</body></html>");
    text
}

/// A picture that is not as it should be, with what there is of the three.
fn push_failure(text: &mut String, row: &Row<'_>) {
    let (shot, verdict) = (row.shot, &row.verdict);
    let _ = writeln!(text, "<section><h2>{}</h2>\n<p>{}</p>", escaped(&shot.name), escaped(&verdict.to_string()));
    let [reference, actual, difference] =
        [shot.reference_copy_name(), shot.drawn_name(), shot.difference_name()].map(|name| address(&name));
    let reference = ("reference", reference);
    let actual = ("actual", actual);
    let (class, pictures) = match verdict {
        Verdict::Undrawn(_) => ("", vec![]),
        Verdict::Missing(_) | Verdict::Unreadable(_) => ("", vec![actual]),
        Verdict::Incomparable(_) => ("", vec![reference, actual]),
        Verdict::Compared { .. } => (" both", vec![reference, actual, ("difference", difference)]),
    };
    if !pictures.is_empty() {
        let _ = writeln!(text, "<div class=\"three{class}\">");
        for (caption, address) in pictures {
            let alt = escaped(&format!("{caption} of {}", shot.name));
            let _ = writeln!(
                text,
                "<figure><figcaption>{caption}</figcaption><img src=\"{address}\" alt=\"{alt}\" loading=\"lazy\"></figure>"
            );
        }
        text.push_str("</div>\n");
    }
    text.push_str("</section>\n");
}

/// A file's name as a relative address.
fn address(name: &str) -> String {
    let mut address = String::with_capacity(name.len());
    for byte in name.bytes() {
        if byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_' | b'.' | b'~') {
            address.push(char::from(byte));
        } else {
            let _ = write!(address, "%{byte:02X}");
        }
    }
    address
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_one_name() {
        assert_eq!(address("a b#1?.png"), "a%20b%231%3F.png");
        assert_eq!(address("걷기.png"), "%EA%B1%B7%EA%B8%B0.png");
        assert_eq!(address("javascript:x"), "javascript%3Ax");
    }
}
