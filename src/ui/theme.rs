//! Design tokens: named colours for the dark and the light theme, and named measures.

use egui::epaint::Shadow;

use crate::colour::Colour;
use egui::style::{Selection, WidgetVisuals};
use egui::{
    Color32, Context, CornerRadius, FontFamily, FontId, Margin, Stroke, Style, TextStyle, Theme, Ui, Visuals, vec2,
};

/// Height of a row of a list or form, in points.
pub const ROW: f32 = 22.0;
/// Height of the menu bar, in points.
pub const MENU_BAR: f32 = 24.0;
/// Height of the transport, in points.
pub const TRANSPORT: f32 = 32.0;
/// Height of the timeline at first, in points.
pub const TIMELINE: f32 = 200.0;
/// Height of the status line, in points.
pub const STATUS: f32 = 22.0;
/// Width of the right panel, in points.
pub const SIDE: f32 = 260.0;
/// The grid that distances are multiples of, in points.
pub const GRID: f32 = 4.0;
/// Size of text, in points.
pub const TEXT: f32 = 13.0;
/// Size of labels, in points.
pub const SMALL: f32 = 11.0;
/// Radius of corners, in points.
pub const CORNER: u8 = 4;

/// The width of a dialog that wants this much, in points: in a narrow window it is less.
#[must_use]
pub fn dialog_width(ui: &Ui, wanted: f32) -> f32 {
    wanted.min(ui.ctx().content_rect().width() - 12.0 * GRID)
}

/// A named colour, opaque.
const fn shown(colour: Colour) -> Color32 {
    let [red, green, blue] = colour.to_bytes();
    Color32::from_rgb(red, green, blue)
}

/// What each colour is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tokens {
    /// The background of fields and of the unplayed part of the timeline.
    pub window: Color32,
    /// Panels, menus, dialogs.
    pub panel: Color32,
    /// Buttons.
    pub raised: Color32,
    /// The widget under the pointer.
    pub hovered: Color32,
    /// Lines between areas and around fields.
    pub line: Color32,
    /// The border of the widget under the pointer.
    pub strong_line: Color32,
    /// Text.
    pub text: Color32,
    /// Text that matters less.
    pub dim: Color32,
    /// The current keyframe, the playhead, the selection.
    pub accent: Color32,
    /// Text in the accent's colour.
    pub accent_text: Color32,
    /// The background of selected items.
    pub accent_fill: Color32,
    /// What is selected in the timeline.
    pub selected: Color32,
    /// Messages of success.
    pub information: Color32,
    /// Messages of refusals and failures.
    pub error: Color32,
    /// The curves of x, y and z.
    pub axes: [Color32; 3],
    /// Behind text that stands over the scene.
    pub over_scene: Color32,
    /// Over everything that a dialog keeps waiting.
    pub shade: Color32,
}

impl Tokens {
    /// For a dark system.
    pub const DARK: Self = Self {
        window: shown(Colour::BACKDROP),
        panel: Color32::from_rgb(0x22, 0x25, 0x2a),
        raised: Color32::from_rgb(0x2c, 0x30, 0x37),
        hovered: Color32::from_rgb(0x37, 0x3c, 0x45),
        line: shown(Colour::LINE),
        strong_line: Color32::from_rgb(0x4a, 0x50, 0x5b),
        text: shown(Colour::TEXT),
        dim: shown(Colour::DIM),
        accent: shown(Colour::ACCENT),
        accent_text: shown(Colour::ACCENT),
        accent_fill: Color32::from_rgb(0x48, 0x38, 0x21),
        selected: shown(Colour::BLUE),
        information: shown(Colour::BLUE),
        error: Color32::from_rgb(0xe9, 0x73, 0x6a),
        axes: [Color32::from_rgb(0xea, 0x78, 0x6f), Color32::from_rgb(0x7f, 0xc4, 0x6b), shown(Colour::BLUE)],
        over_scene: Color32::from_rgba_premultiplied(0x17, 0x19, 0x1c, 0xd8),
        shade: Color32::from_black_alpha(0x78),
    };

    /// For a light system.
    pub const LIGHT: Self = Self {
        window: Color32::from_rgb(0xf4, 0xf5, 0xf7),
        panel: Color32::from_rgb(0xff, 0xff, 0xff),
        raised: Color32::from_rgb(0xee, 0xf0, 0xf3),
        hovered: Color32::from_rgb(0xe2, 0xe5, 0xea),
        line: Color32::from_rgb(0xd9, 0xdc, 0xe1),
        strong_line: Color32::from_rgb(0xb4, 0xba, 0xc4),
        text: Color32::from_rgb(0x22, 0x25, 0x2a),
        dim: Color32::from_rgb(0x62, 0x68, 0x73),
        accent: Color32::from_rgb(0xc9, 0x73, 0x0b),
        accent_text: Color32::from_rgb(0xa0, 0x58, 0x00),
        selected: Color32::from_rgb(0x1f, 0x6f, 0xb0),
        accent_fill: Color32::from_rgb(0xfd, 0xee, 0xd8),
        information: Color32::from_rgb(0x1b, 0x6f, 0xb3),
        error: Color32::from_rgb(0xc2, 0x3b, 0x30),
        axes: [
            Color32::from_rgb(0xb0, 0x34, 0x2a),
            Color32::from_rgb(0x28, 0x6c, 0x2b),
            Color32::from_rgb(0x18, 0x64, 0x9f),
        ],
        over_scene: Color32::from_rgba_premultiplied(0xe4, 0xe5, 0xe7, 0xe6),
        shade: Color32::from_black_alpha(0x50),
    };

    /// Those of a theme.
    #[must_use]
    pub const fn of_theme(theme: Theme) -> &'static Self {
        match theme {
            Theme::Dark => &Self::DARK,
            Theme::Light => &Self::LIGHT,
        }
    }

    /// The current ones.
    #[must_use]
    pub fn of(ui: &Ui) -> &'static Self {
        if ui.visuals().dark_mode { &Self::DARK } else { &Self::LIGHT }
    }
}

/// Monospace for numbers, as large as text.
#[must_use]
pub fn number_font() -> FontId {
    FontId::new(12.5, FontFamily::Monospace)
}

/// The font of labels.
#[must_use]
pub fn small_font() -> FontId {
    FontId::new(SMALL, FontFamily::Proportional)
}

/// The font of text.
#[must_use]
pub fn text_font() -> FontId {
    FontId::new(TEXT, FontFamily::Proportional)
}

/// Installs the fonts and both themes. The system or the settings decide which theme shows.
pub fn install(context: &Context) {
    super::fonts::install(context);
    context.options_mut(|options| {
        options.fallback_theme = Theme::Dark;
        // The table has keys of its own for it.
        options.zoom_with_keyboard = false;
    });
    for theme in [Theme::Dark, Theme::Light] {
        context.style_mut_of(theme, |style| dress(style, theme));
    }
}

fn dress(style: &mut Style, theme: Theme) {
    let tokens = Tokens::of_theme(theme);
    style.text_styles = [
        (TextStyle::Small, small_font()),
        (TextStyle::Body, text_font()),
        (TextStyle::Button, text_font()),
        (TextStyle::Heading, FontId::new(15.0, FontFamily::Proportional)),
        (TextStyle::Monospace, number_font()),
    ]
    .into();
    style.drag_value_text_style = TextStyle::Monospace;
    let spacing = &mut style.spacing;
    spacing.item_spacing = vec2(GRID, GRID);
    spacing.button_padding = vec2(8.0, 3.0);
    spacing.interact_size = vec2(32.0, ROW);
    spacing.menu_margin = Margin::same(4);
    spacing.window_margin = Margin::same(16);
    spacing.indent = 16.0;
    spacing.tooltip_width = 320.0;
    style.interaction.tooltip_delay = 0.35;
    style.interaction.selectable_labels = false;
    style.animation_time = 0.08;
    style.visuals = visuals(tokens, theme);
}

fn visuals(tokens: &Tokens, theme: Theme) -> Visuals {
    let corner = CornerRadius::same(CORNER);
    let widget = |fill, line, text| WidgetVisuals {
        bg_fill: fill,
        weak_bg_fill: fill,
        bg_stroke: Stroke::new(1.0, line),
        corner_radius: corner,
        fg_stroke: Stroke::new(1.0, text),
        expansion: 0.0,
    };
    let mut visuals = match theme {
        Theme::Dark => Visuals::dark(),
        Theme::Light => Visuals::light(),
    };
    visuals.widgets.noninteractive = widget(tokens.panel, tokens.line, tokens.text);
    visuals.widgets.inactive = widget(tokens.raised, tokens.raised, tokens.text);
    visuals.widgets.hovered = widget(tokens.hovered, tokens.strong_line, tokens.text);
    visuals.widgets.active = widget(tokens.hovered, tokens.accent, tokens.text);
    visuals.widgets.open = widget(tokens.hovered, tokens.strong_line, tokens.text);
    visuals.selection = Selection { bg_fill: tokens.accent_fill, stroke: Stroke::new(1.0, tokens.accent_text) };
    visuals.weak_text_color = Some(tokens.dim);
    visuals.hyperlink_color = tokens.information;
    visuals.error_fg_color = tokens.error;
    visuals.warn_fg_color = tokens.accent_text;
    visuals.extreme_bg_color = tokens.window;
    visuals.faint_bg_color = tokens.raised;
    visuals.panel_fill = tokens.panel;
    visuals.window_fill = tokens.panel;
    visuals.window_stroke = Stroke::new(1.0, tokens.line);
    visuals.window_corner_radius = CornerRadius::same(2 * CORNER);
    visuals.menu_corner_radius = corner;
    let shadow = Shadow { offset: [0, 4], blur: 12, spread: 0, color: tokens.shade };
    visuals.window_shadow = shadow;
    visuals.popup_shadow = shadow;
    visuals.disabled_alpha = 0.45;
    visuals
}

#[cfg(test)]
mod tests {
    use super::*;

    fn luminance(colour: Color32) -> f32 {
        let linear = egui::Rgba::from(colour);
        0.2126 * linear.r() + 0.7152 * linear.g() + 0.0722 * linear.b()
    }

    #[track_caller]
    fn check_contrast(text: Color32, behind: Color32, least: f32) {
        let (a, b) = (luminance(text) + 0.05, luminance(behind) + 0.05);
        let contrast = (a / b).max(b / a);
        assert!(contrast >= least, "{text:?} on {behind:?} has contrast {contrast:.2}, not {least}");
    }

    #[test]
    fn text_can_be_read() {
        for tokens in [Tokens::DARK, Tokens::LIGHT] {
            let [x, y, z] = tokens.axes;
            let texts = [tokens.text, tokens.dim, tokens.information, tokens.error, tokens.accent_text];
            for text in texts.into_iter().chain([tokens.selected, x, y, z]) {
                check_contrast(text, tokens.panel, 4.5);
                check_contrast(text, tokens.window, 4.5);
            }
            for behind in [tokens.accent_fill, tokens.raised] {
                check_contrast(tokens.accent_text, behind, 4.5);
            }
            // As much of the scene as shines through: from black to white.
            for scene in [Color32::BLACK, Color32::WHITE] {
                for text in [tokens.text, tokens.accent_text, tokens.error] {
                    check_contrast(text, scene.blend(tokens.over_scene), 3.0);
                }
            }
            check_contrast(tokens.text, tokens.hovered, 4.5);
            for axis in [x, y, z] {
                check_contrast(axis, tokens.raised, 4.5);
            }
            check_contrast(tokens.text, tokens.accent_fill, 4.5);
            check_contrast(tokens.accent, tokens.panel, 3.0);
        }
    }
}
