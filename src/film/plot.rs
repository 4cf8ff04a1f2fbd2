//! Small plots of numbers over time, drawn pixel by pixel, so that they have the same bytes on all systems.

use super::letters::{HEIGHT, text_width, write_text};
use crate::colour::Colour;
use crate::picture::Image;

/// A curve of a plot.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotCurve {
    /// Its colour.
    pub colour: Colour,
    /// Times and numbers, in ascending order of times.
    pub points: Vec<[f64; 2]>,
}

/// Curves over one time. Both axes begin at 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// The time at the right end, more than 0.
    pub length: f64,
    /// The number at the upper end, more than 0. What is above it is cut off.
    pub top: f64,
    /// Times that have a line.
    pub lines: Vec<f64>,
    /// The curves.
    pub curves: Vec<PlotCurve>,
}

/// The end of an axis that numbers up to `largest` fit on, with room above: one to three digits, the same for near numbers.
#[must_use]
pub fn axis_end(largest: f64) -> f64 {
    const LEADING: [f64; 9] = [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
    let wanted = largest * 1.05;
    if !(wanted.is_finite() && wanted > 1e-3) {
        return 1.0;
    }
    let power = wanted.log10().floor() as i32;
    let leading = wanted / 10_f64.powi(power);
    let leading = LEADING.into_iter().find(|&end| leading <= end).unwrap_or(10.0);
    if power < 0 { leading / 10_f64.powi(-power) } else { leading * 10_f64.powi(power) }
}

/// A plot's place in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PlotPlace {
    left: u32,
    top: u32,
    width: u32,
    height: u32,
    scale: u32,
}

impl PlotPlace {
    /// The pixels of the axes and of all that is between them, in a rectangle with numbers of at most `digits` letters beside them.
    pub fn within([left, top]: [u32; 2], [width, height]: [u32; 2], scale: u32, digits: &str) -> Self {
        let indent = text_width(digits, scale) + 2 * scale;
        let above = (HEIGHT / 2) * scale;
        Self {
            left: left + indent,
            top: top + above,
            width: width.saturating_sub(indent + 2 * scale).max(2),
            height: height.saturating_sub(above + HEIGHT * scale).max(2),
            scale,
        }
    }

    /// The pixel, perhaps between two, of a time and a number.
    fn at(&self, plot: &Plot, [time, number]: [f64; 2]) -> [f64; 2] {
        let part = |of: f64, whole: f64| if whole > 0.0 { of / whole } else { 0.0 };
        let [right, down] = [self.width, self.height].map(|side| f64::from(side - 1));
        let x = f64::from(self.left) + right * part(time, plot.length).clamp(0.0, 1.0);
        [x, f64::from(self.top) + down * (1.0 - part(number, plot.top))]
    }

    /// Draws the axes with their numbers, the lines and the curves.
    pub fn draw(&self, image: &mut Image, plot: &Plot) {
        let line = Colour::LINE.to_pixel();
        let bottom = self.top + self.height - 1;
        for (y, number) in [(self.top, plot.top), (bottom, 0.0)] {
            for x in self.left..self.left + self.width {
                cover(image, [x, y], line, 1.0);
            }
            let text = number.to_string();
            let left = self.left.saturating_sub(2 * self.scale + text_width(&text, self.scale));
            let top = y.saturating_sub(HEIGHT / 2 * self.scale);
            write_text(image, [left, top], &text, self.scale, Colour::DIM.to_pixel());
        }
        // More lines than this hide what they are for.
        if plot.lines.len() <= self.width as usize / 6 {
            for &time in &plot.lines {
                let x = self.at(plot, [time, 0.0])[0].round() as u32;
                (self.top..=bottom).for_each(|y| cover(image, [x, y], line, 1.0));
            }
        }
        for curve in &plot.curves {
            self.draw_curve(image, plot, curve);
        }
    }

    fn draw_curve(&self, image: &mut Image, plot: &Plot, curve: &PlotCurve) {
        let radius = 0.375 + 0.375 * f64::from(self.scale);
        let mut covered = vec![0.0_f64; self.width as usize * self.height as usize];
        let points: Vec<[f64; 2]> = curve.points.iter().map(|&point| self.at(plot, point)).collect();
        for ends in points.windows(2) {
            let [[x0, y0], [x1, y1]] = [ends[0], ends[1]];
            let reach = radius + 1.0;
            let span = |low: f64, high: f64, first: u32, count: u32| {
                let place = |at: f64| (at - f64::from(first)).clamp(0.0, f64::from(count)) as u32;
                place(low.floor())..place(high.ceil() + 1.0)
            };
            let rows = span(y0.min(y1) - reach, y0.max(y1) + reach, self.top, self.height);
            for row in rows {
                for column in span(x0.min(x1) - reach, x0.max(x1) + reach, self.left, self.width) {
                    let at = [f64::from(self.left + column), f64::from(self.top + row)];
                    let coverage = (radius + 0.5 - distance(at, [x0, y0], [x1, y1])).clamp(0.0, 1.0);
                    let of_pixel = &mut covered[row as usize * self.width as usize + column as usize];
                    *of_pixel = of_pixel.max(coverage);
                }
            }
        }
        for (row, covered) in (self.top..).zip(covered.chunks(self.width as usize)) {
            for (column, &coverage) in (self.left..).zip(covered) {
                cover(image, [column, row], curve.colour.to_pixel(), coverage);
            }
        }
    }

    /// Marks a time: by a line, and by a dot on each curve.
    pub fn mark(&self, image: &mut Image, plot: &Plot, time: f64) {
        let accent = Colour::ACCENT.to_pixel();
        let x = self.at(plot, [time, 0.0])[0];
        for y in self.top..self.top + self.height {
            cover(image, [x.round() as u32, y], accent, 0.6);
        }
        let radius = 1.0 + f64::from(self.scale);
        for curve in &plot.curves {
            let Some(number) = number_at(&curve.points, time) else { continue };
            let centre = [x, self.at(plot, [time, number.min(plot.top)])[1]];
            let from = centre.map(|at| (at - radius - 1.0).max(0.0) as u32);
            let to = centre.map(|at| (at + radius + 2.0).max(0.0) as u32);
            for y in from[1]..to[1] {
                for x in from[0]..to[0] {
                    let away = distance([f64::from(x), f64::from(y)], centre, centre);
                    cover(image, [x, y], accent, (radius + 0.5 - away).clamp(0.0, 1.0));
                }
            }
        }
    }
}

/// The number of a curve at a time, between its points in proportion; `None` beyond them.
fn number_at(points: &[[f64; 2]], time: f64) -> Option<f64> {
    let after = points.partition_point(|point| point[0] < time);
    let [time_after, number_after] = *points.get(after)?;
    if time_after <= time {
        return Some(number_after);
    }
    let [time_before, number_before] = *points.get(after.checked_sub(1)?)?;
    let part = (time - time_before) / (time_after - time_before);
    Some(number_before + part * (number_after - number_before))
}

/// The distance of a point from a line between two ends.
fn distance([x, y]: [f64; 2], [x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) -> f64 {
    let (along_x, along_y) = (x1 - x0, y1 - y0);
    let square = along_x * along_x + along_y * along_y;
    let part = if square > 0.0 { ((x - x0) * along_x + (y - y0) * along_y) / square } else { 0.0 };
    let part = part.clamp(0.0, 1.0);
    (x - x0 - part * along_x).hypot(y - y0 - part * along_y)
}

/// Mixes a colour into a pixel; outside of the picture there is none.
fn cover(image: &mut Image, [x, y]: [u32; 2], colour: [u8; 4], coverage: f64) {
    if x >= image.width || y >= image.height || coverage <= 0.0 {
        return;
    }
    let start = 4 * (y as usize * image.width as usize + x as usize);
    for (below, over) in image.rgba[start..start + 4].iter_mut().zip(colour) {
        *below = (f64::from(*below) + (f64::from(over) - f64::from(*below)) * coverage).round() as u8;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_end_at_round_numbers_above_what_they_show() {
        for (largest, end) in [
            (90.0, 100.0),
            (94.9, 100.0),
            (97.0, 150.0),
            (0.0, 1.0),
            (-1.0, 1.0),
            (f64::NAN, 1.0),
            (7.9, 10.0),
            (0.25, 0.3),
            (1234.0, 1500.0),
        ] {
            assert_eq!(axis_end(largest), end, "{largest}");
        }
    }

    fn plot(points: Vec<[f64; 2]>) -> Plot {
        Plot { length: 2.0, top: 100.0, lines: vec![1.0], curves: vec![PlotCurve { colour: Colour::BLUE, points }] }
    }

    fn blank() -> Image {
        Image { width: 100, height: 50, rgba: Colour::BACKDROP.to_pixel().repeat(5000) }
    }

    #[test]
    fn a_flat_curve_is_a_flat_line_at_its_number() {
        let plot = plot(vec![[0.0, 75.0], [2.0, 75.0]]);
        let place = PlotPlace::within([0, 0], [100, 50], 1, "100");
        let mut image = blank();
        place.draw(&mut image, &plot);
        let y = place.top + (f64::from(place.height - 1) * 0.25).round() as u32;
        let blue = |x: u32, y: u32| image.pixel(x, y) == Some(Colour::BLUE.to_pixel());
        let columns = || place.left..place.left + place.width;
        // Its line is a pixel and a half high, so that one row is wholly covered wherever the number lies.
        let row = (y - 1..=y + 1).filter(|y| columns().all(|x| blue(x, *y))).count();
        assert_eq!(row, 1);
        for far in [y - 4, y + 4] {
            assert!(columns().all(|x| !blue(x, far)));
        }
    }

    #[test]
    fn what_is_above_the_end_of_the_axis_is_cut_off() {
        let place = PlotPlace::within([0, 0], [100, 50], 1, "100");
        let mut image = blank();
        place.draw(&mut image, &plot(vec![[0.0, 900.0], [2.0, 900.0]]));
        assert!(!image.rgba.chunks(4).any(|pixel| pixel == Colour::BLUE.to_pixel()));
    }

    #[test]
    fn the_mark_is_at_its_time_and_on_the_curve() {
        let plot = plot(vec![[0.0, 0.0], [2.0, 100.0]]);
        let place = PlotPlace::within([0, 0], [100, 50], 1, "100");
        for (time, part) in [(0.0, 0.0), (0.5, 0.25), (2.0, 1.0)] {
            let mut image = blank();
            place.draw(&mut image, &plot);
            let before = image.clone();
            place.mark(&mut image, &plot, time);
            let x = place.left + (f64::from(place.width - 1) * part).round() as u32;
            let y = place.top + (f64::from(place.height - 1) * (1.0 - part)).round() as u32;
            assert_eq!(image.pixel(x, y), Some(Colour::ACCENT.to_pixel()), "{time}");
            let changed: Vec<u32> =
                (0..100).filter(|&x| (0..50).any(|y| image.pixel(x, y) != before.pixel(x, y))).collect();
            assert!(changed.iter().all(|changed| changed.abs_diff(x) <= 3), "{time}: {changed:?}");
        }
        assert_eq!(number_at(&[], 1.0), None);
        assert_eq!(number_at(&[[0.0, 1.0]], 1.0), None);
        assert_eq!(number_at(&[[0.0, 1.0], [2.0, 3.0]], 1.0), Some(2.0));
    }
}
