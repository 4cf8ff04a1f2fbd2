//! Which part of the 3D view an exported picture shows: a small drawing of both, and a sentence.

use egui::{Color32, Rect, RichText, Sense, Stroke, StrokeKind, Ui, Vec2, vec2};

use super::theme::Tokens;
use super::words::Words;
use crate::words::{Message, texts};

/// The room of the drawing, in points.
pub(super) const ROOM: Vec2 = vec2(96.0, 40.0);
/// Shapes whose sides differ by less than this part are the same to the eye.
const SAME: f32 = 0.02;

/// Draws a picture of `size` pixels over a view of `view` points. The camera sees the same height in both.
pub(super) fn show(ui: &mut Ui, size: [u32; 2], view: Vec2) {
    let tokens = Tokens::of(ui);
    let (rect, _) = ui.allocate_exact_size(ROOM, Sense::hover());
    let [picture, seen] = [aspect(size), view.x / view.y.max(1.0)].map(|aspect| aspect.clamp(0.1, 10.0));
    let height = ROOM.y.min(ROOM.x / picture.max(seen));
    let of = |aspect: f32| Rect::from_center_size(rect.center(), vec2(aspect * height, height));
    ui.painter().rect(of(picture), 0.0, tokens.accent_fill, Stroke::new(1.0, tokens.accent), StrokeKind::Inside);
    ui.painter().rect(of(seen), 0.0, Color32::TRANSPARENT, Stroke::new(1.0, tokens.dim), StrokeKind::Inside);
    let text = Words::of(ui).message(sentence(size, picture, seen));
    ui.add(egui::Label::new(RichText::new(text).small().color(tokens.dim)).wrap());
}

#[expect(clippy::cast_precision_loss, reason = "pictures are small")]
fn aspect([width, height]: [u32; 2]) -> f32 {
    width as f32 / height.max(1) as f32
}

fn sentence(size: [u32; 2], picture: f32, seen: f32) -> Message {
    let ratio = ratio(size);
    if (picture / seen - 1.0).abs() < SAME {
        texts::export_shape_same(ratio)
    } else if picture < seen {
        texts::export_shape_narrower(ratio)
    } else {
        texts::export_shape_wider(ratio)
    }
}

/// The sides' ratio as one says it: `16:9`; `1.43:1` where whole numbers would be large.
fn ratio(size: [u32; 2]) -> String {
    let [width, height] = size.map(|side| side.max(1));
    let (mut divisor, mut rest) = (width, height);
    while rest > 0 {
        (divisor, rest) = (rest, divisor % rest);
    }
    let (x, y) = (width / divisor, height / divisor);
    if x.max(y) <= 32 { format!("{x}:{y}") } else { format!("{:.2}:1", aspect(size)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_as_one_says_them() {
        for (size, expected) in
            [([640, 480], "4:3"), ([1920, 1080], "16:9"), ([100, 100], "1:1"), ([1000, 699], "1.43:1"), ([0, 5], "1:5")]
        {
            assert_eq!(ratio(size), expected);
        }
    }

    #[test]
    fn what_is_cut_is_said() {
        let said = |size, seen| sentence(size, aspect(size), seen).to_string();
        assert!(said([640, 480], 2.0).contains("cut"), "{}", said([640, 480], 2.0));
        assert!(said([640, 320], 2.01).contains("4:2") || said([640, 320], 2.01).contains("2:1"));
        assert_ne!(said([640, 320], 1.0), said([640, 320], 2.0));
    }
}
