//! Draws the report's pictures, and makes them small: a class has hundreds.

use std::slice;

use serde::{Deserialize, Serialize};

use super::rubric::Rubric;
use crate::export::{ExportError, Painter, Size};
use crate::film::SmallPng;
use crate::markup::base64;
use crate::picture::Image;
use crate::pose::Pose;
use crate::scene::SceneGraph;

/// The usual width and height of a drawn picture in pixels.
pub const SIZE: Size = Size { width: 180, height: 135 };
/// How long a picture of a film is shown, in milliseconds.
const FRAME_MS: u16 = 220;
/// From so many poses the colours are chosen.
const MOST_SAMPLES: usize = 4;
/// Channels that differ by no more are alike: the sky is drawn with as much noise.
const ALIKE: u8 = 6;

/// One picture or film, ready for the page.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct ReportPicture {
    /// The PNG, or animated PNG, in base 64.
    pub base64: String,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// What it shows, for people who see it.
    pub caption: String,
    /// What it shows, for people who do not.
    pub alt: String,
    /// Whether a row begins with it.
    pub starts_row: bool,
}

/// Draws and encodes. All pictures share the colours of a few.
pub struct Studio {
    painter: Painter,
    encoder: SmallPng,
}

impl Studio {
    /// A studio on a painter. The colours are those of the rubric's reference or, without one, of the scene.
    ///
    /// # Errors
    /// [`ExportError`]: the GPU fails.
    pub fn new(mut painter: Painter, rubric: &Rubric, scene: &SceneGraph) -> Result<Self, ExportError> {
        let keyframes = rubric.reference.as_ref().map_or(&[][..], |reference| reference.list.as_slice());
        let step = keyframes.len().div_ceil(MOST_SAMPLES).max(1);
        let poses = keyframes.iter().step_by(step).map(|keyframe| &keyframe.pose).chain([scene.rest_pose()]);
        let mut samples = Vec::new();
        for pose in poses {
            samples.push(painter.loose_pose(scene, pose, pose)?);
        }
        Ok(Self { painter, encoder: SmallPng::new(&samples) })
    }

    /// Draws a pose as another program showed it; see [`Painter::loose_pose`].
    ///
    /// # Errors
    /// [`ExportError`]: the GPU fails.
    pub fn draw(&mut self, scene: &SceneGraph, pose: &Pose, right: &Pose) -> Result<Image, ExportError> {
        Ok(self.painter.loose_pose(scene, pose, right)?)
    }

    /// A picture, or a film of several of one size; there is at least one.
    ///
    /// # Errors
    /// [`ExportError`]: the pictures cannot be encoded.
    pub fn picture(&mut self, images: &[Image], caption: String) -> Result<ReportPicture, ExportError> {
        let alt =
            if images.len() > 1 { format!("Film of {} pictures. {caption}", images.len()) } else { caption.clone() };
        encoded(&mut self.encoder, images, caption, alt)
    }

    /// Where two pictures of one size differ: bright on the second, which is dimmed.
    ///
    /// # Errors
    /// [`ExportError`]: the picture cannot be encoded.
    pub fn difference(own: &Image, right: &Image, caption: String, at: &str) -> Result<ReportPicture, ExportError> {
        let pixels = own.rgba.as_chunks::<4>().0.iter().zip(right.rgba.as_chunks::<4>().0);
        let rgba = pixels.flat_map(|(own, right)| difference(*own, *right)).collect();
        let image = Image { rgba, ..*right };
        let alt = format!("Where both differ, bright on the dimmed reference: {at}");
        encoded(&mut SmallPng::new(slice::from_ref(&image)), slice::from_ref(&image), caption, alt)
    }
}

fn encoded(
    encoder: &mut SmallPng,
    images: &[Image],
    caption: String,
    alt: String,
) -> Result<ReportPicture, ExportError> {
    let png = encoder.encode(images, FRAME_MS)?;
    let (width, height) = images.first().map_or((0, 0), |first| (first.width, first.height));
    Ok(ReportPicture { base64: base64(&png), width, height, caption, alt, starts_row: false })
}

/// The colour where two pixels differ, in few levels, or of the second one, dimmed.
fn difference(own: [u8; 4], right: [u8; 4]) -> [u8; 4] {
    let off = (0..3).map(|channel| own[channel].abs_diff(right[channel])).max().unwrap_or(0);
    if off > ALIKE {
        let bright = 95_u8.saturating_add(off.saturating_mul(2)) | 0b1111;
        return [bright, bright / 2, bright / 4, u8::MAX];
    }
    let [red, green, blue, _] = right.map(u16::from);
    let [dim, ..] = ((red + 2 * green + blue) / 16).to_le_bytes();
    let dim = dim & !0b11;
    [dim, dim, dim, u8::MAX]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_no_difference() {
        assert_eq!(difference([100, 100, 100, 255], [104, 98, 100, 255]), [24, 24, 24, 255]);
        let [red, green, blue, _] = difference([100, 100, 100, 255], [120, 100, 100, 255]);
        assert!(red > 130 && red > green && green > blue);
        assert_eq!(difference([0, 0, 0, 255], [255, 255, 255, 255]), [255, 127, 63, 255]);
    }
}
