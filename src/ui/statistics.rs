//! Frame statistics: a line of numbers in the status line or, without one, over the scene.

use super::words::Words;

use crate::words::texts;

/// What a picture of the window costs, as means over a short time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Pictures a second.
    pub pictures: f64,
    /// Ticks of the animation clock a second that were taken.
    pub ticks: f64,
    /// Milliseconds a picture in which events were taken in.
    pub input_ms: f64,
    /// Milliseconds a picture in which poses were evaluated.
    pub evaluation_ms: f64,
    /// Milliseconds a picture in which the scene was placed in the world.
    pub frame_ms: f64,
    /// Milliseconds a picture in which the panels were laid out and cut into triangles.
    pub ui_ms: f64,
    /// Milliseconds a picture from the first command for the GPU until the picture was handed to the display.
    pub drawing_ms: f64,
}

impl Statistics {
    /// The statistics as one line of text.
    #[must_use]
    pub fn sentence(&self, words: Words) -> String {
        let whole = |number: f64| format!("{number:.0}");
        let tenths = |number: f64| format!("{number:.1}");
        words.message(texts::statistics_line(
            whole(self.pictures),
            whole(self.ticks),
            tenths(self.input_ms),
            tenths(self.evaluation_ms),
            tenths(self.frame_ms),
            tenths(self.ui_ms),
            tenths(self.drawing_ms),
        ))
    }
}
