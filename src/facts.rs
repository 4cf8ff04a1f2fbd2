//! What a report of a fault needs to say of this program and of the system that it runs on: a line a fact, always in English.

use std::path::Path;

use crate::storage;

/// A label and what is so.
pub type Fact = (&'static str, String);

/// The program's version.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Of the program: the commit that it was built from (`unknown` in debug builds and without git), and how; of the system: its name and
/// kernel, and the desktop's session. Those of the adapter are [`crate::render::adapter_facts`].
#[must_use]
pub fn facts() -> Vec<Fact> {
    let built = [env!("INBETWEEN_TARGET"), env!("INBETWEEN_PROFILE"), env!("INBETWEEN_RUSTC")].join(", ");
    vec![
        ("commit", env!("INBETWEEN_COMMIT").to_owned()),
        ("build", built),
        ("system", system()),
        ("session", session(|name| std::env::var(name).ok())),
    ]
}

/// The facts as lines, below the program's name and version.
#[must_use]
pub fn lines(facts: &[Fact]) -> String {
    let lines = facts.iter().map(|(label, fact)| format!("{label}: {fact}\n"));
    std::iter::once(format!("inbetween {VERSION}\n")).chain(lines).collect()
}

/// `Debian GNU/Linux 12 (bookworm), Linux 6.1.0, x86_64`; elsewhere `windows, x86_64`.
fn system() -> String {
    let architecture = std::env::consts::ARCH;
    if !cfg!(target_os = "linux") {
        let system = if cfg!(target_arch = "wasm32") { "browser" } else { std::env::consts::OS };
        return format!("{system}, {architecture}");
    }
    let text = |path: &str| {
        let bytes = storage::read(Path::new(path), 1 << 16).ok()?;
        Some(String::from_utf8_lossy(&bytes).into_owned())
    };
    let name = text("/etc/os-release").as_deref().and_then(name_in);
    let release = text("/proc/sys/kernel/osrelease").unwrap_or_default();
    let kernel = format!("Linux {}", release.trim());
    let parts = [name.as_deref(), Some(kernel.trim()), Some(architecture)];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// The system's name in the text of `os-release`.
fn name_in(text: &str) -> Option<String> {
    let value = text.lines().find_map(|line| line.strip_prefix("PRETTY_NAME="))?;
    let name = value.trim().trim_matches(['"', '\'']);
    (!name.is_empty()).then(|| name.to_owned())
}

/// The window system that the environment names, and the desktop: `wayland (GNOME)`, `x11`, `none`.
fn session(variable: impl Fn(&str) -> Option<String>) -> String {
    let set = |name: &str| variable(name).filter(|value| !value.is_empty());
    let system = if set("WAYLAND_DISPLAY").or_else(|| set("WAYLAND_SOCKET")).is_some() {
        "wayland"
    } else if set("DISPLAY").is_some() {
        "x11"
    } else if cfg!(any(windows, target_os = "macos")) {
        "the system's own"
    } else {
        "none"
    };
    match set("XDG_CURRENT_DESKTOP") {
        Some(desktop) => format!("{system} ({desktop})"),
        None => system.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_has_its_name_from_os_release() {
        let debian = "ID=debian\nPRETTY_NAME=\"Debian GNU/Linux 12 (bookworm)\"\n";
        assert_eq!(name_in(debian).as_deref(), Some("Debian GNU/Linux 12 (bookworm)"));
        assert_eq!(name_in("PRETTY_NAME=Void\n").as_deref(), Some("Void"));
        assert_eq!(name_in("NAME=x\n"), None);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_session_is_what_the_environment_names() {
        #[track_caller]
        fn check(set: &[(&str, &str)], expected: &str) {
            let variable = |name: &str| {
                let found = set.iter().find(|(known, _)| *known == name);
                found.map(|(_, value)| (*value).to_owned())
            };
            assert_eq!(session(variable), expected);
        }
        check(&[], "none");
        check(&[("DISPLAY", ":0")], "x11");
        check(
            &[("DISPLAY", ":0"), ("WAYLAND_DISPLAY", "wayland-0"), ("XDG_CURRENT_DESKTOP", "GNOME")],
            "wayland (GNOME)",
        );
        check(&[("DISPLAY", ""), ("XDG_CURRENT_DESKTOP", "KDE")], "none (KDE)");
    }
}
