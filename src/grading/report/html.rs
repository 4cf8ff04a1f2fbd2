//! Pictures as HTML.

use super::super::studio::ReportPicture;
use crate::markup::escaped;

/// A picture with its caption.
pub fn figure(picture: &ReportPicture) -> String {
    format!(
        "<figure><img src=\"data:image/png;base64,{}\" width=\"{}\" height=\"{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>\n",
        picture.base64,
        picture.width,
        picture.height,
        escaped(&picture.alt),
        escaped(&picture.caption)
    )
}
