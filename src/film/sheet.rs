//! Contact sheets: pictures side by side in rows, each with a caption.

use super::letters::{HEIGHT, text_width, write_text};
use crate::colour::Colour;
use crate::picture::Image;

/// The gap between and around pictures, in pixels.
const GAP: u32 = 4;
/// The colour of the gaps.
const GAP_COLOUR: [u8; 4] = opaque(Colour::BACKDROP);
/// The colour of captions.
const TEXT_COLOUR: [u8; 4] = opaque(Colour::TEXT);

const fn opaque(colour: Colour) -> [u8; 4] {
    let [red, green, blue] = colour.to_bytes();
    [red, green, blue, 0xff]
}

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
    sheet.rgba = GAP_COLOUR.repeat(sheet.width as usize * sheet.height as usize);
    let row_bytes = 4 * width as usize;
    for (cell_index, cell) in (0..grid.columns * grid.rows).zip(cells) {
        let left = GAP + cell_index % grid.columns * (width + GAP);
        let top = GAP + cell_index / grid.columns * (height + caption_height + GAP);
        for (y, row) in (top..).zip(cell.picture.rgba.chunks_exact(row_bytes.max(4))) {
            let start = 4 * (y as usize * sheet.width as usize + left as usize);
            sheet.rgba[start..start + row_bytes].copy_from_slice(row);
        }
        let fits = |parts: &usize| text_width(&cell.caption[..*parts].join("  "), scale) <= width;
        let parts = (0..=cell.caption.len()).rev().find(fits).unwrap_or(0);
        let text = cell.caption[..parts].join("  ");
        let indent = (width - text_width(&text, scale).min(width)) / 2;
        write_text(&mut sheet, [left + indent, top + height + 2 * scale], &text, scale, TEXT_COLOUR);
    }
    sheet
}
