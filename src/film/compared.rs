//! Pictures that compare: the same moment in several views, or in one with ghosts, with labels and plots of a speed below.

use super::letters::{HEIGHT, can_write, text_width, write_text};
use super::plot::{Plot, PlotPlace};
use super::sheet::GAP;
use crate::colour::Colour;
use crate::picture::{Image, Rows};

/// How what is compared is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ComparedAs {
    /// Each in a view of its own.
    #[default]
    SideBySide,
    /// The first as it is, the others as ghosts in the same view.
    Ghosts,
}

impl ComparedAs {
    /// Both, with their names on the command line.
    pub const NAMED: [(&'static str, Self); 2] = [("side-by-side", Self::SideBySide), ("ghosts", Self::Ghosts)];

    /// The colours of labels and curves, in the order in which they are compared; of ghosts, those of the ghosts as well.
    #[must_use]
    pub const fn colours(self) -> [Colour; COMPARED_AT_MOST] {
        match self {
            Self::SideBySide => [Colour::BLUE; COMPARED_AT_MOST],
            Self::Ghosts => [Colour::TEXT, Colour::BLUE, Colour::GREEN, Colour::RED],
        }
    }
}

/// The most that one picture compares.
pub const COMPARED_AT_MOST: usize = 4;

/// The least width of a label and of a plot, in pixels.
const LEAST_WIDTH: u32 = 80;
/// The least height of a view, in pixels.
const LEAST_HEIGHT: u32 = 48;

/// A plot has this part of the height of a view with its label and plot, if that is enough.
const PLOTS_PART: u32 = 6;

/// Where everything is in a picture that compares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ComparedLayout {
    how: ComparedAs,
    /// How many are compared.
    count: u32,
    size: [u32; 2],
    grid: [u32; 2],
    view: [u32; 2],
    plot_height: u32,
    /// Pixels of a pixel of letters.
    scale: u32,
}

const fn line_height(scale: u32) -> u32 {
    (HEIGHT + 4) * scale
}

const fn least_plot_height(scale: u32) -> u32 {
    20 + 20 * scale
}

impl ComparedLayout {
    /// The layout of a picture of a size. Views are arranged so that they are as large as they can be. `None` if there is no room.
    #[must_use]
    pub fn new(how: ComparedAs, count: u32, size: [u32; 2]) -> Option<Self> {
        let views = Self::views(how, count);
        let grids = (1..=views).rev().filter(|columns| views.is_multiple_of(*columns));
        let layouts = grids.filter_map(|columns| Self::in_grid(how, count, size, [columns, views / columns]));
        // The first of equals, which has the most columns.
        layouts.reduce(|best, next| if next.room() > best.room() { next } else { best })
    }

    /// The size of a picture with views of a size.
    #[must_use]
    pub fn size_of_views(how: ComparedAs, count: u32, view: [u32; 2]) -> [u32; 2] {
        let [columns, rows] = match Self::views(how, count) {
            4 => [2, 2],
            views => [views, 1],
        };
        Self::size_of_grid(how, count, [columns, rows], view)
    }

    /// The smallest size of a picture whose views are in one row.
    #[must_use]
    pub fn least_size(how: ComparedAs, count: u32) -> [u32; 2] {
        let views = Self::views(how, count);
        let width = LEAST_WIDTH * if views == 1 { count } else { 1 };
        Self::size_of_grid(how, count, [views, 1], [width, LEAST_HEIGHT])
    }

    const fn views(how: ComparedAs, count: u32) -> u32 {
        match how {
            ComparedAs::SideBySide => count,
            ComparedAs::Ghosts => 1,
        }
    }

    /// How large letters are: by the width that each label has.
    const fn scale(how: ComparedAs, count: u32, view_width: u32) -> u32 {
        let width = view_width * Self::views(how, count) / count;
        if width < 240 { 1 } else { (width + 80) / 320 + 1 }
    }

    fn size_of_grid(how: ComparedAs, count: u32, [columns, rows]: [u32; 2], [width, height]: [u32; 2]) -> [u32; 2] {
        let scale = Self::scale(how, count, width);
        let above = height + line_height(scale);
        let cell = above + least_plot_height(scale).max(above / (PLOTS_PART - 1));
        [columns * (width + GAP) + GAP, rows * (cell + GAP) + GAP + line_height(scale)]
    }

    fn in_grid(how: ComparedAs, count: u32, size: [u32; 2], grid: [u32; 2]) -> Option<Self> {
        let [columns, rows] = grid;
        let width = size[0].checked_sub(GAP * (columns + 1))? / columns;
        let label_width = width * (columns * rows) / count;
        let scale = Self::scale(how, count, width);
        let cell = size[1].checked_sub(GAP * (rows + 1) + line_height(scale))? / rows;
        let plot_height = least_plot_height(scale).max(cell / PLOTS_PART);
        let height = cell.checked_sub(line_height(scale) + plot_height)?;
        (label_width >= LEAST_WIDTH && height >= LEAST_HEIGHT).then_some(Self {
            how,
            count,
            size,
            grid,
            view: [width, height],
            plot_height,
            scale,
        })
    }

    /// The width of the largest rectangle with sides of 4 to 3 that fits into a view, times 3.
    fn room(&self) -> u32 {
        (3 * self.view[0]).min(4 * self.view[1])
    }

    /// How what is compared is shown.
    #[must_use]
    pub const fn how(&self) -> ComparedAs {
        self.how
    }

    /// Width and height of the whole picture, in pixels.
    #[must_use]
    pub const fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Width and height of each view, in pixels.
    #[must_use]
    pub const fn view(&self) -> [u32; 2] {
        self.view
    }

    /// The top left pixel of each view.
    fn corners(&self) -> impl Iterator<Item = [u32; 2]> + use<> {
        let Self { size, grid: [columns, rows], view: [width, _], .. } = *self;
        // What is left of a division is shared between both sides.
        let spare = (size[0] - columns * (width + GAP) - GAP) / 2;
        let cell = self.cell_height() + GAP;
        (0..columns * rows)
            .map(move |index| [GAP + spare + index % columns * (width + GAP), GAP + index / columns * cell])
    }

    const fn cell_height(&self) -> u32 {
        self.view[1] + line_height(self.scale) + self.plot_height
    }

    fn plots(&self, digits: &str) -> Vec<PlotPlace> {
        let [width, height] = self.view;
        let place = |[left, top]: [u32; 2]| {
            let top = top + height + line_height(self.scale);
            PlotPlace::within([left, top], [width, self.plot_height], self.scale, digits)
        };
        self.corners().map(place).collect()
    }

    /// The left and top of a label's letters, in pixels.
    fn place_of_label(&self, index: u32, label: &str) -> [u32; 2] {
        let views = Self::views(self.how, self.count);
        let corner = self.corners().nth((index % views) as usize).unwrap_or_default();
        let (width, before) = match self.how {
            ComparedAs::SideBySide => (self.view[0], 0),
            ComparedAs::Ghosts => (self.view[0] / self.count, index),
        };
        let indent = width.saturating_sub(text_width(label, self.scale)) / 2;
        [corner[0] + before * width + indent, corner[1] + self.view[1] + 2 * self.scale]
    }
}

/// All of a picture that compares but the views: what all frames of a film have in common.
pub struct ComparedBoard {
    layout: ComparedLayout,
    ground: Image,
    /// Where the plots are, and what each shows.
    plots: Vec<(PlotPlace, Plot)>,
}

impl ComparedBoard {
    /// A board with a label for each of those that are compared; `plot` has a curve for each. Below everything stands the first of the
    /// captions that fits and of whose letters all can be written.
    #[must_use]
    pub fn new(layout: ComparedLayout, labels: &[String], plot: &Plot, captions: &[String]) -> Self {
        let [width, height] = layout.size;
        let mut ground =
            Image { width, height, rgba: Colour::BACKDROP.to_pixel().repeat(width as usize * height as usize) };
        for ((index, label), colour) in (0..).zip(labels).zip(layout.how.colours()) {
            let colour = if layout.how == ComparedAs::Ghosts { colour } else { Colour::TEXT };
            write_text(&mut ground, layout.place_of_label(index, label), label, layout.scale, colour.to_pixel());
        }
        let shown =
            layout.plots(&plot.top.to_string()).into_iter().enumerate().map(|(index, place)| match layout.how {
                ComparedAs::SideBySide => {
                    (place, Plot { curves: plot.curves.iter().skip(index).take(1).cloned().collect(), ..plot.clone() })
                }
                ComparedAs::Ghosts => (place, plot.clone()),
            });
        let plots: Vec<(PlotPlace, Plot)> = shown.collect();
        for (place, plot) in &plots {
            place.draw(&mut ground, plot);
        }
        let fits = |caption: &&String| can_write(caption) && text_width(caption, layout.scale) + 2 * GAP <= width;
        if let Some(caption) = captions.iter().find(fits) {
            let left = (width - text_width(caption, layout.scale)) / 2;
            let top = height - line_height(layout.scale) + layout.scale;
            write_text(&mut ground, [left, top], caption, layout.scale, Colour::DIM.to_pixel());
        }
        Self { layout, ground, plots }
    }

    /// The layout.
    #[must_use]
    pub const fn layout(&self) -> &ComparedLayout {
        &self.layout
    }

    /// The whole picture: its views, and a mark in the plots at a time.
    #[must_use]
    pub fn picture(&self, views: &[Rows<'_>], time: Option<f64>) -> Image {
        let mut picture = self.ground.clone();
        for (corner, view) in self.layout.corners().zip(views) {
            picture.paste(corner, view);
        }
        if let Some(time) = time {
            for (place, plot) in &self.plots {
                place.mark(&mut picture, plot, time);
            }
        }
        picture
    }
}

#[cfg(test)]
mod tests {
    use super::super::plot::PlotCurve;
    use super::*;

    const BOTH: [ComparedAs; 2] = [ComparedAs::SideBySide, ComparedAs::Ghosts];

    fn plot(count: usize) -> Plot {
        let curves = (0..count).map(|at| PlotCurve {
            colour: Colour::BLUE,
            points: vec![[0.0, 10.0 * at as f64], [1.0, 10.0 * at as f64]],
        });
        Plot { length: 1.0, top: 100.0, lines: Vec::new(), curves: curves.collect() }
    }

    fn view(layout: &ComparedLayout, level: u8) -> Image {
        let [width, height] = layout.view();
        Image { width, height, rgba: [level, level, level, 255].repeat(width as usize * height as usize) }
    }

    #[test]
    fn usual_sizes_have_views_of_their_size_and_even_sides() {
        for (how, count, expected) in [
            (ComparedAs::SideBySide, 2, [652, 352]),
            (ComparedAs::SideBySide, 3, [976, 352]),
            (ComparedAs::SideBySide, 4, [652, 678]),
            (ComparedAs::Ghosts, 3, [648, 608]),
        ] {
            let size_of_view = if how == ComparedAs::Ghosts { [640, 480] } else { [320, 240] };
            let size = ComparedLayout::size_of_views(how, count, size_of_view);
            assert_eq!(size, expected, "{how:?} {count}");
            assert_eq!(ComparedLayout::new(how, count, size).unwrap().view(), size_of_view, "{how:?} {count}");
        }
    }

    #[test]
    fn the_least_size_is_large_enough_and_a_pixel_less_is_not() {
        for how in BOTH {
            for count in 2..=4 {
                let [width, height] = ComparedLayout::least_size(how, count);
                assert!(ComparedLayout::new(how, count, [width, height]).is_some(), "{how:?} {count}");
                for smaller in [[width - 1, height], [width, height - 1]] {
                    assert_eq!(ComparedLayout::new(how, count, smaller), None, "{how:?} {count}");
                }
            }
        }
        assert_eq!(ComparedLayout::new(ComparedAs::SideBySide, 4, [1, 1]), None);
    }

    #[test]
    fn wide_pictures_have_views_in_a_row_and_high_ones_in_a_column() {
        let columns = |size| ComparedLayout::new(ComparedAs::SideBySide, 4, size).unwrap().grid[0];
        assert_eq!([columns([1200, 300]), columns([640, 640]), columns([300, 1600])], [4, 2, 1]);
    }

    #[test]
    fn views_labels_and_plots_do_not_overlap_and_none_is_cut() {
        for how in BOTH {
            for (count, size) in [(2, [205, 125]), (2, [640, 480]), (3, [977, 353]), (4, [700, 131]), (4, [1921, 1081])]
            {
                let Some(layout) = ComparedLayout::new(how, count, size) else { panic!("{how:?} {count} {size:?}") };
                let [width, height] = layout.view();
                let mut boxes: Vec<[u32; 4]> = layout.corners().map(|[x, y]| [x, y, x + width, y + height]).collect();
                for index in 0..count {
                    let label = "catmull-rom";
                    let [x, y] = layout.place_of_label(index, label);
                    boxes.push([x, y, x + text_width(label, layout.scale), y + HEIGHT * layout.scale]);
                }
                let footer = size[1] - line_height(layout.scale);
                for corner in layout.corners() {
                    let top = corner[1] + height + line_height(layout.scale);
                    boxes.push([corner[0], top, corner[0] + width, top + layout.plot_height]);
                }
                for (index, a) in boxes.iter().enumerate() {
                    assert!(a[2] <= size[0] && a[3] <= footer, "{how:?} {count} {size:?}: {a:?}");
                    for b in &boxes[..index] {
                        let apart = a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1];
                        assert!(apart, "{how:?} {count} {size:?}: {a:?} {b:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn each_label_is_under_its_view_to_the_pixel() {
        let labels = ["linear", "catmull-rom", "matrix"].map(str::to_owned);
        for how in BOTH {
            let layout = ComparedLayout::new(how, 3, [652, 300]).unwrap();
            let board = ComparedBoard::new(layout, &labels, &plot(3), &[]);
            let picture =
                board.picture(&vec![view(&layout, 200).rows(); if how == ComparedAs::Ghosts { 1 } else { 3 }], None);
            for (index, label) in (0..).zip(&labels) {
                let [left, top] = layout.place_of_label(index, label);
                let size = [text_width(label, layout.scale), HEIGHT * layout.scale];
                let mut expected = Image {
                    width: size[0],
                    height: size[1],
                    rgba: Colour::BACKDROP.to_pixel().repeat(size[0] as usize * size[1] as usize),
                };
                let colour = if how == ComparedAs::Ghosts { how.colours()[index as usize] } else { Colour::TEXT };
                write_text(&mut expected, [0, 0], label, layout.scale, colour.to_pixel());
                for y in 0..size[1] {
                    for x in 0..size[0] {
                        assert_eq!(picture.pixel(left + x, top + y), expected.pixel(x, y), "{how:?} {label} {x} {y}");
                    }
                }
                if how == ComparedAs::SideBySide {
                    let corner = layout.corners().nth(index as usize).unwrap();
                    assert!(left >= corner[0] && left + size[0] <= corner[0] + layout.view()[0]);
                }
            }
        }
    }

    #[test]
    fn views_are_where_they_belong_and_the_mark_moves() {
        let layout = ComparedLayout::new(ComparedAs::SideBySide, 4, [652, 678]).unwrap();
        let board = ComparedBoard::new(layout, &[const { String::new() }; 4], &plot(4), &[]);
        let views: Vec<Image> = (0..4).map(|index| view(&layout, 50 * index)).collect();
        let rows: Vec<Rows<'_>> = views.iter().map(Image::rows).collect();
        let [none, early, late] = [None, Some(0.2), Some(0.8)].map(|time| board.picture(&rows, time));
        for (corner, level) in layout.corners().zip([0, 50, 100, 150]) {
            let last = [corner[0] + layout.view()[0] - 1, corner[1] + layout.view()[1] - 1];
            for [x, y] in [corner, last] {
                assert_eq!(early.pixel(x, y), Some([level, level, level, 255]));
            }
        }
        assert!(none != early && early != late);
    }

    #[test]
    fn the_caption_is_the_first_that_can_be_written_and_fits() {
        let layout = ComparedLayout::new(ComparedAs::SideBySide, 2, [205, 125]).unwrap();
        let with = |captions: &[&str]| {
            let captions: Vec<String> = captions.iter().map(|&caption| caption.to_owned()).collect();
            ComparedBoard::new(layout, &[], &plot(2), &captions).ground
        };
        let expected = with(&["arm  0-1 s"]);
        assert!(expected != with(&[]));
        assert!(with(&["팔  0-1 s", "arm  0-1 s"]) == expected);
        assert!(with(&[&"long".repeat(20), "arm  0-1 s", "other"]) == expected);
    }
}
