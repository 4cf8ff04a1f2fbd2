//! A page has no desktop: the browser says which colours are preferred, and there is no file manager.

use std::path::Path;

use winit::event_loop::EventLoopProxy;

use crate::window::UserEvent;

/// The window says it already.
pub fn ask_theme(_: EventLoopProxy<UserEvent>) {}

/// There is no file manager: comes [`UserEvent::NoFileManager`].
pub fn show_folder(path: &Path, proxy: EventLoopProxy<UserEvent>) {
    let _ = proxy.send_event(UserEvent::NoFileManager(path.to_owned()));
}
