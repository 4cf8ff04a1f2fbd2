//! Contact sheets: pictures side by side in rows.

use crate::render::Image;

/// Pixels between pictures and around them.
const GAP: u32 = 4;
/// What is between them.
const GAP_COLOUR: [u8; 4] = [0x1b, 0x1d, 0x21, 0xff];

/// Columns and rows of a contact sheet, at least one each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// Pictures in a row.
    pub columns: u32,
    /// Rows.
    pub rows: u32,
}

/// Pictures of one size in their order, row by row from the top left; places left over are empty.
#[must_use]
pub fn contact_sheet(grid: Grid, pictures: &[Image]) -> Image {
    let (width, height) = pictures.first().map_or((0, 0), |picture| (picture.width, picture.height));
    let whole = |count: u32, side: u32| count * (side + GAP) + GAP;
    let (sheet_width, sheet_height) = (whole(grid.columns, width), whole(grid.rows, height));
    let mut rgba = GAP_COLOUR.repeat(sheet_width as usize * sheet_height as usize);
    let row_bytes = 4 * width as usize;
    for (place, picture) in (0..grid.columns * grid.rows).zip(pictures) {
        let left = GAP + place % grid.columns * (width + GAP);
        let top = GAP + place / grid.columns * (height + GAP);
        for (y, row) in (top..).zip(picture.rgba.chunks_exact(row_bytes.max(4))) {
            let start = 4 * (y as usize * sheet_width as usize + left as usize);
            rgba[start..start + row_bytes].copy_from_slice(row);
        }
    }
    Image { width: sheet_width, height: sheet_height, rgba }
}
