//! Chooses between Wayland and X11 on Linux: the one that answers, even if variables of other sessions are left over.
//!
//! winit allows one event loop per process and decides by the variables alone, so the choice is made first.

use winit::event_loop::EventLoopBuilder;

use super::UserEvent;

/// Has the builder ask the window system that answers, where the variables name one that does not.
#[cfg(all(unix, not(target_os = "macos")))]
pub fn choose(builder: &mut EventLoopBuilder<UserEvent>) {
    use winit::platform::wayland::EventLoopBuilderExtWayland as _;
    use winit::platform::x11::EventLoopBuilderExtX11 as _;

    match linux::choice(&linux::Asked::of_environment(), &linux::Sockets) {
        linux::Choice::Usual => {}
        linux::Choice::X11 => drop(builder.with_x11()),
        linux::Choice::Wayland => drop(builder.with_wayland()),
    }
}

/// Elsewhere there is one window system.
#[cfg(not(all(unix, not(target_os = "macos"))))]
pub fn choose(_: &mut EventLoopBuilder<UserEvent>) {}

/// A sentence's part on the variables that name a display, for where none answers: `WAYLAND_DISPLAY is "wayland-0", DISPLAY is not set`.
#[must_use]
pub fn variables() -> String {
    let variable = |name| match std::env::var_os(name) {
        Some(value) => format!("{name} is \"{}\"", value.display()),
        None => format!("{name} is not set"),
    };
    ["WAYLAND_DISPLAY", "DISPLAY"].map(variable).join(", ")
}

#[cfg(all(unix, not(target_os = "macos")))]
mod linux {
    use std::env;
    use std::os::unix::net::UnixStream;
    use std::path::PathBuf;

    /// The name of Wayland's socket where no variable names one.
    const DEFAULT_WAYLAND: &str = "wayland-0";

    /// What the environment asks for; an empty variable counts as none, as winit has it.
    #[derive(Clone, Debug, Default, PartialEq, Eq)]
    pub struct Asked {
        /// Whether a Wayland connection was handed to this process, open.
        pub has_open_wayland: bool,
        /// `WAYLAND_DISPLAY`.
        pub wayland: Option<PathBuf>,
        /// `XDG_RUNTIME_DIR`, where Wayland's sockets are.
        pub runtime_folder: Option<PathBuf>,
        /// `DISPLAY`.
        pub x11: Option<String>,
    }

    impl Asked {
        /// What this process's variables say.
        pub fn of_environment() -> Self {
            let variable = |name| env::var_os(name).filter(|value| !value.is_empty());
            Self {
                has_open_wayland: variable("WAYLAND_SOCKET").is_some(),
                wayland: variable("WAYLAND_DISPLAY").map(PathBuf::from),
                runtime_folder: variable("XDG_RUNTIME_DIR").map(PathBuf::from),
                x11: variable("DISPLAY").and_then(|display| display.into_string().ok()),
            }
        }

        fn wayland_socket(&self, name: PathBuf) -> Option<PathBuf> {
            if name.is_absolute() { Some(name) } else { Some(self.runtime_folder.as_ref()?.join(name)) }
        }
    }

    /// What winit is told.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Choice {
        /// Nothing: it goes by the variables.
        Usual,
        /// X11, though Wayland's variable is set.
        X11,
        /// Wayland, though its variable is not set.
        Wayland,
    }

    /// Checks whether a display answers.
    pub trait Answers {
        /// Whether a Wayland compositor listens on a socket.
        fn wayland(&self, socket: &std::path::Path) -> bool;
        /// Whether an X server answers.
        fn x11(&self, display: &str) -> bool;
    }

    /// The machine's own sockets.
    pub struct Sockets;

    impl Answers for Sockets {
        fn wayland(&self, socket: &std::path::Path) -> bool {
            UnixStream::connect(socket).is_ok()
        }

        fn x11(&self, display: &str) -> bool {
            x11rb::connect(Some(display)).is_ok()
        }
    }

    /// Which window system to ask. The usual start asks none: a socket that answers is found by one call.
    pub fn choice(asked: &Asked, answers: &impl Answers) -> Choice {
        if asked.has_open_wayland {
            return Choice::Usual;
        }
        match (&asked.wayland, &asked.x11) {
            (Some(name), Some(display)) => {
                let socket = asked.wayland_socket(name.clone());
                let is_wayland = socket.is_some_and(|socket| answers.wayland(&socket));
                if !is_wayland && answers.x11(display) { Choice::X11 } else { Choice::Usual }
            }
            (None, Some(display)) => {
                let socket = asked.wayland_socket(PathBuf::from(DEFAULT_WAYLAND));
                let is_wayland = socket.is_some_and(|socket| answers.wayland(&socket));
                if is_wayland && !answers.x11(display) { Choice::Wayland } else { Choice::Usual }
            }
            (_, None) => Choice::Usual,
        }
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        struct Table {
            wayland: &'static str,
            x11: &'static str,
        }

        impl Answers for Table {
            fn wayland(&self, socket: &std::path::Path) -> bool {
                socket == std::path::Path::new(self.wayland)
            }

            fn x11(&self, display: &str) -> bool {
                display == self.x11
            }
        }

        #[track_caller]
        fn check(wayland: Option<&str>, x11: Option<&str>, answering: [&'static str; 2], expected: Choice) {
            let asked = Asked {
                has_open_wayland: false,
                wayland: wayland.map(PathBuf::from),
                runtime_folder: Some(PathBuf::from("/run/user/1")),
                x11: x11.map(str::to_owned),
            };
            let [wayland, x11] = answering;
            assert_eq!(choice(&asked, &Table { wayland, x11 }), expected);
        }

        #[test]
        fn a_variable_that_nobody_answers_is_passed_over() {
            const SOCKET: &str = "/run/user/1/wayland-0";
            check(Some("wayland-0"), Some(":1"), [SOCKET, ":1"], Choice::Usual);
            check(Some("wayland-0"), Some(":1"), ["", ":1"], Choice::X11);
            check(Some("/elsewhere/way"), Some(":1"), ["/elsewhere/way", ":1"], Choice::Usual);
            check(Some("wayland-1"), Some(":1"), [SOCKET, ":1"], Choice::X11);
            check(None, Some(":1"), [SOCKET, ""], Choice::Wayland);
            check(None, Some(":1"), [SOCKET, ":1"], Choice::Usual);
            check(None, Some(":1"), ["", ""], Choice::Usual);
            check(Some("wayland-0"), Some(":1"), ["", ""], Choice::Usual);
            check(Some("wayland-0"), None, ["", ""], Choice::Usual);
            check(None, None, [SOCKET, ":1"], Choice::Usual);
        }

        #[test]
        fn a_connection_that_was_handed_over_is_taken() {
            let asked = Asked { has_open_wayland: true, x11: Some(":1".to_owned()), ..Asked::default() };
            assert_eq!(choice(&asked, &Table { wayland: "", x11: ":1" }), Choice::Usual);
        }
    }
}
