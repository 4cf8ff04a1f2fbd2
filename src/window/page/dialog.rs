//! The browser's dialog for a file to open. For a file to save, the program asks for its name.

use std::path::PathBuf;
use std::time::Duration;

use wasm_bindgen::prelude::Closure;
use winit::event_loop::EventLoopProxy;

use crate::editor::MODEL_ENDINGS;
use crate::storage::page::fs;
use crate::ui::PathPurpose;
use crate::ui::words::Words;
use crate::window::UserEvent;

/// An answer that comes faster is none: the program asks itself.
pub const TOO_FAST_FOR_A_USER: Duration = Duration::from_millis(1);

/// Asks for a path; the answer comes as [`UserEvent::PathChosen`].
pub fn ask(purpose: PathPurpose, proposed: PathBuf, _: Words, proxy: EventLoopProxy<UserEvent>) {
    let answer = move |path, took| {
        let proposed = proposed.clone();
        let _ = proxy.send_event(UserEvent::PathChosen { purpose, proposed, path, took });
    };
    if purpose.is_saving() || purpose.is_folder() {
        answer(None, Duration::ZERO);
        return;
    }
    let models = MODEL_ENDINGS.map(|ending| format!(".{ending}")).join(",");
    let endings = match purpose {
        PathPurpose::Compare => ".json,.txt,.csv".to_owned(),
        PathPurpose::Open => format!(".json,.txt,.csv,{models}"),
        _ => format!(".json,{models}"),
    };
    let chosen = Closure::new(move |name: String, bytes: Vec<u8>| {
        let path = (!name.is_empty()).then(|| PathBuf::from(name));
        if let Some(path) = &path {
            fs::put(path, bytes);
        }
        answer(path, Duration::MAX);
    });
    super::choose(&endings, &chosen);
    chosen.forget();
}
