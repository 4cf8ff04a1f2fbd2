//! The fonts: egui's own, and one for Hangul behind them.

use std::sync::Arc;

use egui::{Context, FontData, FontDefinitions, FontTweak};

/// The syllables of KS X 1001; `OFL.txt` beside it is its licence.
static HANGUL: &[u8] = include_bytes!("../../assets/fonts/hangul.ttf");

/// Installs the fonts.
pub fn install(context: &Context) {
    let mut fonts = FontDefinitions::default();
    // It stands a little high beside the Latin letters.
    let tweak = FontTweak { y_offset_factor: 0.02, ..FontTweak::default() };
    fonts.font_data.insert("hangul".to_owned(), Arc::new(FontData { tweak, ..FontData::from_static(HANGUL) }));
    for names in fonts.families.values_mut() {
        // Before the fonts of pictures, which have letters too.
        names.insert(1.min(names.len()), "hangul".to_owned());
    }
    context.set_fonts(fonts);
}
