//! Contact sheets: pictures side by side in rows, each with a caption.

use super::letters::{HEIGHT, text_width, write_text};
use crate::colour::Colour;
use crate::picture::Image;

/// The gap between and around pictures, in pixels.
pub(super) const GAP: u32 = 4;

/// From this picture width on, in pixels, letters are twice as large.
const WIDE: u32 = 240;

/// Columns and rows of a contact sheet, at least one each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// Number of columns.
    pub columns: u32,
    /// Number of rows.
    pub rows: u32,
}

/// A picture of a contact sheet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The picture, of the same size as all others.
    pub picture: Image,
    /// The caption in parts. Parts that do not fit are left out.
    pub caption: Vec<String>,
}

/// Arranges pictures of one size row by row from the top left, each above its caption. Remaining cells are empty.
#[must_use]
pub fn contact_sheet(grid: Grid, cells: &[Cell]) -> Image {
    let (width, height) = cells.first().map_or((0, 0), |cell| (cell.picture.width, cell.picture.height));
    let scale = if width >= WIDE { 2 } else { 1 };
    let caption_height = if cells.iter().any(|cell| !cell.caption.is_empty()) { (HEIGHT + 4) * scale } else { 0 };
    let whole = |count: u32, side: u32| count * (side + GAP) + GAP;
    let mut sheet = Image {
        width: whole(grid.columns, width),
        height: whole(grid.rows, height + caption_height),
        rgba: Vec::new(),
    };
    sheet.rgba = Colour::BACKDROP.to_pixel().repeat(sheet.width as usize * sheet.height as usize);
    for (cell_index, cell) in (0..grid.columns * grid.rows).zip(cells) {
        let left = GAP + cell_index % grid.columns * (width + GAP);
        let top = GAP + cell_index / grid.columns * (height + caption_height + GAP);
        sheet.paste([left, top], &cell.picture.rows());
        let fits = |parts: &usize| text_width(&cell.caption[..*parts].join("  "), scale) <= width;
        let parts = (0..=cell.caption.len()).rev().find(fits).unwrap_or(0);
        let text = cell.caption[..parts].join("  ");
        let indent = (width - text_width(&text, scale).min(width)) / 2;
        write_text(&mut sheet, [left + indent, top + height + 2 * scale], &text, scale, Colour::TEXT.to_pixel());
    }
    sheet
}
