//! The pictures of a page: each distinct one is in it once, however often it is shown.

use std::collections::HashMap;
use std::fmt::Write as _;

use super::super::studio::ReportPicture;
use crate::markup::escaped;

/// Gives each distinct picture a class of the page's style sheet. Many submissions show the same pictures, and all those of the reference
/// are alike.
#[derive(Debug, Default)]
pub struct Sheet<'a> {
    numbers: HashMap<&'a str, usize>,
    pictures: Vec<&'a ReportPicture>,
}

impl<'a> Sheet<'a> {
    /// A picture with its caption.
    pub fn figure(&mut self, picture: &'a ReportPicture) -> String {
        let next = self.pictures.len();
        let number = *self.numbers.entry(&picture.base64).or_insert(next);
        if number == next {
            self.pictures.push(picture);
        }
        format!(
            "<figure class=\"f{number}\"><span role=\"img\" aria-label=\"{}\"></span><figcaption>{}</figcaption></figure>\n",
            escaped(&picture.alt),
            escaped(&picture.caption)
        )
    }

    /// The style sheet with all pictures that were shown; empty if there were none.
    pub fn style(&self) -> String {
        if self.pictures.is_empty() {
            return String::new();
        }
        let mut text = String::from("<style>\n");
        for (number, ReportPicture { base64, width, height, .. }) in self.pictures.iter().enumerate() {
            let _ = writeln!(
                text,
                ".f{number}{{--w:{width}px;--r:{width}/{height}}}.f{number} span{{background-image:url(data:image/png;base64,{base64})}}"
            );
        }
        text.push_str("</style>\n");
        text
    }
}
