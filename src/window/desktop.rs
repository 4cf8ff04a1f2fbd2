//! What the desktop prefers where the window system does not say it, as X11 does not: light or dark, by the settings portal of XDG. And
//! its file manager.

use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;

use egui::Theme;
use winit::event_loop::EventLoopProxy;

use super::UserEvent;

/// Asks the desktop, in a thread of its own, since an answer may take its time; it comes as [`UserEvent::DesktopTheme`]. Where there is
/// no portal, or no preference, none comes.
pub fn ask_theme(proxy: EventLoopProxy<UserEvent>) {
    thread::spawn(move || {
        if let Some(theme) = theme() {
            // Where the window is gone, so is the question.
            let _ = proxy.send_event(UserEvent::DesktopTheme(theme));
        }
    });
}

/// Shows the folder of a file in the system's file manager, or the folder itself. Where there is none that starts, comes
/// [`UserEvent::NoFileManager`].
pub fn show_folder(path: &Path, proxy: EventLoopProxy<UserEvent>) {
    let path = crate::storage::absolute(path);
    let folder = if crate::storage::is_folder(&path) { path } else { path.parent().unwrap_or(&path).to_owned() };
    let program = if cfg!(windows) {
        "explorer"
    } else if cfg!(target_os = "macos") {
        "open"
    } else {
        "xdg-open"
    };
    thread::spawn(move || {
        let mut command = Command::new(program);
        command.arg(&folder).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        // Windows' explorer says 1 where all is well.
        let is_shown = command.status().is_ok_and(|status| status.success() || cfg!(windows));
        if !is_shown {
            // Where the window is gone, nobody asks any more.
            let _ = proxy.send_event(UserEvent::NoFileManager(folder));
        }
    });
}

#[cfg(any(not(unix), target_os = "macos"))]
fn theme() -> Option<Theme> {
    None
}

#[cfg(all(unix, not(target_os = "macos")))]
fn theme() -> Option<Theme> {
    pollster::block_on(async {
        let bus = zbus::Connection::session().await.ok()?;
        let reply = bus
            .call_method(
                Some("org.freedesktop.portal.Desktop"),
                "/org/freedesktop/portal/desktop",
                Some("org.freedesktop.portal.Settings"),
                "Read",
                &("org.freedesktop.appearance", "color-scheme"),
            )
            .await
            .ok()?;
        of_scheme(&reply.body().deserialize().ok()?)
    })
}

/// The portal's `color-scheme`: 1 is dark, 2 is light, all else no preference. It may be wrapped more than once.
#[cfg(all(unix, not(target_os = "macos")))]
fn of_scheme(value: &zbus::zvariant::Value<'_>) -> Option<Theme> {
    use zbus::zvariant::Value;
    match value {
        Value::Value(inner) => of_scheme(inner),
        Value::U32(1) => Some(Theme::Dark),
        Value::U32(2) => Some(Theme::Light),
        _ => None,
    }
}

#[cfg(all(test, unix, not(target_os = "macos")))]
mod tests {
    use zbus::zvariant::Value;

    use super::*;

    #[test]
    fn schemes_are_themes() {
        for (scheme, expected) in [(0, None), (1, Some(Theme::Dark)), (2, Some(Theme::Light)), (3, None)] {
            let plain = Value::U32(scheme);
            assert_eq!(of_scheme(&plain), expected, "{scheme}");
            let wrapped = Value::Value(Box::new(Value::Value(Box::new(plain))));
            assert_eq!(of_scheme(&wrapped), expected, "{scheme}, wrapped");
        }
        assert_eq!(of_scheme(&Value::from("dark")), None);
    }
}
