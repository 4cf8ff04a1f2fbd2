//! What screen readers hear of widgets that are drawn by hand.

use egui::{Response, Role, WidgetInfo};

/// Says that a widget is one of several to choose from, and whether it is chosen. `role` is that of an item, such as a row of a list.
pub fn item(response: &Response, role: Role, is_enabled: bool, is_selected: bool, name: impl ToString) {
    let name = name.to_string();
    response.widget_info(|| WidgetInfo::selected(role, is_enabled, is_selected, &name));
    // What egui says is that a button is pressed; of items, readers ask whether they are selected.
    response.ctx.accesskit_node_builder(response.id, |node| {
        node.clear_toggled();
        node.set_selected(is_selected);
    });
}
