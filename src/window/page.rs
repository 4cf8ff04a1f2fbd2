//! The same program in a page of a browser. `assets/page/page.js` is what it asks of the browser.
//!
//! A page may not wait: its device opens later, and its files are in memory. What it writes is downloaded, or written in place where a
//! browser allows that; settings and journals the browser keeps. One thread does all.

pub mod clipboard;
pub mod desktop;
pub mod dialog;
pub mod export;

use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use egui_winit::accesskit_winit;
use js_sys::{Array, Uint8Array};
use wasm_bindgen::prelude::{Closure, JsCast as _, JsValue, wasm_bindgen};
use winit::event_loop::{ActiveEventLoop, EventLoop, EventLoopProxy};
use winit::platform::web::{EventLoopExtWebSys as _, WindowAttributesExtWebSys as _};
use winit::window::{Window, WindowAttributes};

use super::shell::Shell;
use super::{ForTests, UserEvent};
use crate::editor::{Beginning, Command, Editor, FileCommand, NEW_FILE, Severity};
use crate::files::begun;
use crate::render::{Gpu, GpuError};
use crate::scene::{DEFAULT_SCENE, built_in_scene};
use crate::storage;
use crate::storage::page::KEPT;
use crate::storage::page::fs::{self, Change};
use crate::ui::PathPurpose;
use crate::ui::words::Words;
use crate::words::{Message, texts};

#[wasm_bindgen(module = "/assets/page/page.js")]
extern "C" {
    /// What the browser kept, and the files that the address names, as pairs of a path and its bytes.
    #[wasm_bindgen(catch)]
    async fn load() -> Result<JsValue, JsValue>;
    /// Where the file is that the address asks for as `file`, `scene` or `compare`; empty if there is none.
    fn asked(key: &str) -> String;
    /// Why the address does not show all that it asks for: triples of `other-site`, `refused`, `silent` or `alone`, the file's address, and
    /// what the web site says.
    fn problems() -> Array;
    /// Keeps bytes of a file, from an offset on; at 0 it is a new file.
    fn keep(path: &str, offset: f64, bytes: &[u8]);
    /// Keeps a file no longer.
    fn forget(path: &str);
    /// Marks a journal as in use as long as the page is open.
    fn hold(path: &str);
    /// Hands a file to the user.
    fn save(name: &str, bytes: &[u8]);
    /// Asks for a file to open, with these endings, and calls back with its name and bytes.
    pub(super) fn choose(endings: &str, chosen: &Closure<dyn FnMut(String, Vec<u8>)>);
    /// Calls back with each dropped file.
    fn on_drop(dropped: &Closure<dyn FnMut(String, Vec<u8>)>);
    /// Calls back with each text that is pasted while the keyboard is with a field.
    fn on_paste(pasted: &Closure<dyn FnMut(String)>);
    /// Calls back when the canvas loses what draws on it (`false`), and when it has it again (`true`).
    fn on_context(changed: &Closure<dyn FnMut(bool)>);
    /// Whether the canvas has lost what draws on it.
    pub(super) fn is_context_lost() -> bool;
    /// Says whether the keyboard is with a field, which takes what is pasted.
    fn set_typing(is_typing: bool);
    /// Says whether leaving the page would lose something.
    fn set_unsaved(is_unsaved: bool);
    /// Gives the system's clipboard a text.
    pub(super) fn copy(text: &str);
    /// Says the status line to a screen reader.
    fn tell(text: &str);
    /// The window is there.
    fn begun_now();
    /// The page cannot go on.
    fn ended(reason: &str);
    /// The user's language, such as `ko-KR`.
    pub(super) fn language() -> String;
}

type Device = Result<(Gpu, wgpu::Surface<'static>), GpuError>;

/// What an open device waits with for the event loop.
struct Waiting {
    window: Arc<Window>,
    reader: Option<accesskit_winit::Adapter>,
    device: Device,
}

/// A window without a device.
type Lost = (Arc<Window>, Option<accesskit_winit::Adapter>);

/// What the browser was told last.
#[derive(Default)]
struct Told {
    status: String,
    is_unsaved: bool,
    is_typing: bool,
}

thread_local! {
    static WAITING: RefCell<Option<Waiting>> = const { RefCell::new(None) };
    /// What is said once the window is there.
    static PROBLEMS: RefCell<Vec<Message>> = const { RefCell::new(Vec::new()) };
    static LOST: RefCell<Option<Lost>> = const { RefCell::new(None) };
    static TOLD: RefCell<Told> = RefCell::default();
}

/// Opens the program in the page that it was loaded by, and returns.
pub fn start() {
    std::panic::set_hook(Box::new(|panic| {
        keep_changes(&storage::page::fs::take_changes());
        ended(&panic.to_string());
    }));
    wasm_bindgen_futures::spawn_local(async {
        let loaded = match load().await {
            Ok(loaded) => loaded,
            Err(reason) => return ended(&format!("{reason:?}")),
        };
        for pair in loaded.unchecked_into::<Array>().iter() {
            let pair = pair.unchecked_into::<Array>();
            let path = pair.get(0).as_string().unwrap_or_default();
            fs::put(Path::new(&path), pair.get(1).unchecked_into::<Uint8Array>().to_vec());
        }
        open();
    });
}

fn open() {
    let event_loop = match EventLoop::with_user_event().build() {
        Ok(event_loop) => event_loop,
        Err(error) => return ended(&error.to_string()),
    };
    let [file, scene, compared] = ["file", "scene", "compare"]
        .map(|key| Some(PathBuf::from(asked(key))).filter(|path| !path.as_os_str().is_empty()));
    let (mut editor, mut said) = (None, address_problems());
    if let Some(scene) = scene {
        match begun(&Beginning::SceneFile(scene), Path::new("")) {
            Ok(begun) => editor = Some(begun.editor),
            Err(reason) => said.push(reason),
        }
    }
    PROBLEMS.set(said);
    let mut at_start = Vec::new();
    let editor = editor.unwrap_or_else(|| {
        let scene = built_in_scene(DEFAULT_SCENE).expect("the default scene is built in");
        Editor::new(Arc::new(scene), PathBuf::from(NEW_FILE))
    });
    if let Some(file) = file {
        at_start.extend(PathPurpose::Open.command(file));
    }
    at_start.extend(compared.map(|path| Command::File(FileCommand::CompareWith(path))));
    let proxy = event_loop.create_proxy();
    let dropped = Closure::new(move |name: String, bytes: Vec<u8>| came(&proxy, &name, bytes));
    on_drop(&dropped);
    dropped.forget();
    let proxy = event_loop.create_proxy();
    let pasted = Closure::new(move |text: String| {
        let _ = proxy.send_event(UserEvent::Pasted(text));
    });
    on_paste(&pasted);
    pasted.forget();
    let proxy = event_loop.create_proxy();
    let changed = Closure::new(move |is_back: bool| {
        let event = if is_back { UserEvent::DeviceBack } else { UserEvent::DeviceLost };
        let _ = proxy.send_event(event);
    });
    on_context(&changed);
    changed.forget();
    let shell = Shell::new(editor, at_start, event_loop.create_proxy(), ForTests::default());
    event_loop.spawn_app(shell);
}

/// Why the address does not show all that it asks for.
fn address_problems() -> Vec<Message> {
    let of = |problem: JsValue| {
        let problem = problem.unchecked_into::<Array>();
        let [why, address, said] = [0, 1, 2].map(|part| problem.get(part).as_string().unwrap_or_default());
        match why.as_str() {
            "other-site" => texts::page_other_site(address),
            "refused" => texts::page_refused(address, said),
            "alone" => texts::page_compare_alone(address),
            _ => texts::page_silent(address),
        }
    };
    problems().iter().map(of).collect()
}

/// Puts a file that the user gave where the program finds it.
fn came(proxy: &EventLoopProxy<UserEvent>, name: &str, bytes: Vec<u8>) {
    let path = PathBuf::from(name);
    fs::put(&path, bytes);
    // Without a loop nobody opens it.
    let _ = proxy.send_event(UserEvent::FileCame(path));
}

/// Opens a file that was dropped.
pub fn file_came(shell: &mut Shell, path: PathBuf) {
    if let Some(command) = PathPurpose::Open.command(path) {
        shell.apply(command);
    }
}

/// Brings a text to the field that has the keyboard.
pub fn pasted(shell: &mut Shell, text: String) {
    if let Some(stage) = &mut shell.stage {
        stage.input.egui_input_mut().events.push(egui::Event::Paste(text.replace("\r\n", "\n")));
    }
}

/// The device is gone. Where the browser took it away, it says when another one can be opened.
pub fn device_lost(shell: &mut Shell) {
    if is_context_lost() {
        keep_window(shell);
    } else {
        device_back(shell);
    }
}

fn keep_window(shell: &mut Shell) {
    // What was on a lost device goes now: later the browser would take it for another device's.
    shell.suspend_export();
    if let Some(lost) = shell.lose_device() {
        LOST.set(Some(lost));
    }
}

/// Opens a device again.
pub fn device_back(shell: &mut Shell) {
    keep_window(shell);
    if let Some((window, reader)) = LOST.take() {
        open_device(window, reader, shell.proxy.clone());
    }
}

/// The window: the page's canvas.
pub fn attributes() -> WindowAttributes {
    let document = web_sys::window().and_then(|window| window.document());
    let canvas = document.and_then(|document| document.get_element_by_id("scene"));
    WindowAttributes::default().with_canvas(canvas.and_then(|canvas| canvas.dyn_into().ok()))
}

/// Opens a device for the canvas; it comes as [`UserEvent::DeviceOpened`].
pub fn open_device(window: Arc<Window>, reader: Option<accesskit_winit::Adapter>, proxy: EventLoopProxy<UserEvent>) {
    wasm_bindgen_futures::spawn_local(async move {
        let device = Gpu::for_page(Arc::clone(&window)).await;
        WAITING.set(Some(Waiting { window, reader, device }));
        let _ = proxy.send_event(UserEvent::DeviceOpened);
    });
}

/// Goes on with the device.
pub fn device_opened(shell: &mut Shell, event_loop: &ActiveEventLoop) {
    let Some(Waiting { window, reader, device }) = WAITING.take() else { return };
    match &device {
        Ok(_) => begun_now(),
        Err(error) => ended(&error.to_string()),
    }
    shell.device_opened(event_loop, window, device, reader);
    shell.resume_export();
    for problem in PROBLEMS.take() {
        shell.editor.say(problem.with_severity(Severity::Error));
    }
}

/// Hands on what changed since the last time: files to the user or to the browser, what the status line says, whether anything is unsaved.
pub fn hand_on(shell: &Shell) {
    keep_changes(&fs::take_changes());
    TOLD.with_borrow_mut(|told| {
        let is_unsaved = shell.editor.has_unsaved_changes();
        if is_unsaved != std::mem::replace(&mut told.is_unsaved, is_unsaved) {
            set_unsaved(is_unsaved);
        }
        let is_typing = shell.stage.as_ref().is_some_and(|stage| shell.ui.has_keyboard(&stage.context));
        if is_typing != std::mem::replace(&mut told.is_typing, is_typing) {
            set_typing(is_typing);
        }
        let text = shell
            .editor
            .status()
            .map(|message| Words::new(shell.settings_file.settings.language).message(message))
            .unwrap_or_default();
        if text != told.status {
            tell(&text);
            told.status = text;
        }
    });
}

fn keep_changes(changes: &[Change]) {
    let mut written: Vec<&Path> = Vec::new();
    for change in changes {
        match change {
            Change::Written(path) if path.starts_with(KEPT) => {
                if path.extension().is_some_and(|ending| ending == "journal") {
                    hold(&path.to_string_lossy());
                }
                keep(&path.to_string_lossy(), 0.0, &fs::read(path).unwrap_or_default());
            }
            Change::Appended(path, offset, bytes) => keep(&path.to_string_lossy(), *offset as f64, bytes),
            Change::Removed(path) if path.starts_with(KEPT) => forget(&path.to_string_lossy()),
            Change::Removed(_) => {}
            Change::Written(path) if written.contains(&path.as_path()) => {}
            Change::Written(path) => written.push(path),
        }
    }
    for path in written {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        save(&name, &fs::read(path).unwrap_or_default());
    }
}
