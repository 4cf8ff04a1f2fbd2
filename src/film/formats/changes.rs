//! What changes from one picture of a film to the next.

use std::borrow::Cow;

/// The smallest rectangle (left, top, width, height) in which two pictures differ, at least one pixel, and the second's pixels in it,
/// transparent if unchanged.
pub fn changes(before: &[u8], after: &[u8], picture_width: u16) -> ([u16; 4], Cow<'static, [u8]>) {
    let width = usize::from(picture_width);
    let (mut left, mut right, mut top, mut bottom) = (width, 0, usize::MAX, 0);
    for (y, (before, after)) in before.chunks_exact(width).zip(after.chunks_exact(width)).enumerate() {
        if before == after {
            continue;
        }
        let differs = |x: &usize| before[*x] != after[*x];
        left = left.min((0..width).find(differs).unwrap_or(width));
        right = right.max((0..width).rev().find(differs).unwrap_or(0));
        top = top.min(y);
        bottom = y;
    }
    if top == usize::MAX {
        return ([0, 0, 1, 1], Cow::Owned(vec![u8::MAX]));
    }
    let mut pixels = Vec::with_capacity((right - left + 1) * (bottom - top + 1));
    for y in top..=bottom {
        let row = y * width + left..=y * width + right;
        let pairs = before[row.clone()].iter().zip(&after[row]);
        pixels.extend(pairs.map(|(before, after)| if before == after { u8::MAX } else { *after }));
    }
    let side = |length: usize| u16::try_from(length).expect("it lies in the picture");
    ([side(left), side(top), side(right - left + 1), side(bottom - top + 1)], Cow::Owned(pixels))
}
