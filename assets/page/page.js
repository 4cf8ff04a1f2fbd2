// What the program asks of the browser. `src/window/page.rs` says what each function is for.

const STORE = "files";
const kept = open_store();
const canvas = document.getElementById("scene");
// Handles of files that the browser lets the page write in place, by their names.
const handles = new Map();
// What the address asks for, or else the page itself, as `inbetween share` writes it.
const query = new URLSearchParams(location.search);
const shown = { ...window.shown, ...Object.fromEntries(query) };
let is_unsaved = false;
let is_typing = false;

// The store of kept files: pieces of bytes by [path, offset]; without one nothing is kept.
function open_store() {
    return new Promise((resolve) => {
        const request = indexedDB.open("inbetween", 1);
        request.onupgradeneeded = () => request.result.createObjectStore(STORE);
        request.onsuccess = () => resolve(request.result);
        request.onerror = () => resolve(null);
    }).catch(() => null);
}

function settled(request) {
    return new Promise((resolve, reject) => {
        request.onsuccess = () => resolve(request.result);
        request.onerror = () => reject(request.error);
    });
}

const lock_name = (path) => `inbetween ${path}`;

// Files that other pages hold are theirs.
async function held_elsewhere() {
    const { held = [] } = (await navigator.locks?.query()) ?? {};
    return new Set(held.map((lock) => lock.name));
}

async function kept_files() {
    const store = await kept;
    if (!store) return [];
    const objects = store.transaction(STORE).objectStore(STORE);
    const [keys, values] = await Promise.all([settled(objects.getAllKeys()), settled(objects.getAll())]);
    const pieces = new Map();
    keys.forEach(([path], index) => pieces.set(path, [...(pieces.get(path) ?? []), values[index]]));
    const held = await held_elsewhere();
    const files = [...pieces].filter(([path]) => !held.has(lock_name(path)));
    return Promise.all(files.map(async ([path, all]) => [path, new Uint8Array(await new Blob(all).arrayBuffer())]));
}

// The last part of an address. A file may have # in its name: it begins no part of a page here.
function name_of(address) {
    const last = address.split("?")[0].split("/").pop();
    try {
        return decodeURIComponent(last);
    } catch {
        return last;
    }
}

// What a file that the address asks for is called here. Two of one name are told apart.
function path_of(key) {
    const name = name_of(shown[key]);
    return key === "compare" && shown.file && name_of(shown.file) === name ? `compared/${name}` : name;
}

// Why the address does not show all that it asks for: `other-site`, `refused`, `silent` or `alone`, the address of the file, and what the
// web site says.
const failed = [];
// Where the files are that the address asks for, by `scene`, `file` and `compare`.
const paths = new Map();

async function asked_file(key, path) {
    const address = shown[key];
    const fail = (why, said = "") => {
        failed.push([why, address, said]);
        return [];
    };
    try {
        const url = new URL(address.replaceAll("#", "%23"), location.href);
        if (url.origin !== location.origin) return fail("other-site");
        const answer = await fetch(url);
        if (!answer.ok) return fail("refused", `${answer.status} ${answer.statusText}`.trim());
        const bytes = new Uint8Array(await answer.arrayBuffer());
        paths.set(key, path);
        return [[path, bytes]];
    } catch {
        return fail("silent");
    }
}

export async function load() {
    const keys = ["scene", "file", "compare"].filter((key) => shown[key]);
    const files = await Promise.all(keys.map((key) => asked_file(key, path_of(key))));
    if (shown.compare && !shown.file) failed.push(["alone", shown.compare, ""]);
    return [...(await kept_files().catch(() => [])), ...files.flat()];
}

export function problems() {
    return failed;
}

export function asked(key) {
    return paths.get(key) ?? "";
}

async function with_store(act) {
    const store = await kept;
    if (store) act(store.transaction(STORE, "readwrite").objectStore(STORE));
}

// Each file's pieces: an array sorts after every number.
const pieces_of = (path) => IDBKeyRange.bound([path], [path, []]);

export function keep(path, offset, bytes) {
    const piece = bytes.slice();
    with_store((objects) => {
        if (offset === 0) objects.delete(pieces_of(path));
        objects.put(piece, [path, offset]);
    });
}

export function forget(path) {
    with_store((objects) => objects.delete(pieces_of(path)));
}

export function hold(path) {
    navigator.locks?.request(lock_name(path), () => new Promise(() => {}));
}

export function save(name, bytes) {
    const content = bytes.slice();
    const handle = handles.get(name);
    if (handle) write_in_place(handle, content).catch(() => download(name, content));
    else download(name, content);
}

async function write_in_place(handle, content) {
    const file = await handle.createWritable();
    await file.write(content);
    await file.close();
}

function download(name, content) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([content]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

async function given(file, take) {
    take(file.name, new Uint8Array(await file.arrayBuffer()));
}

export function choose(endings, chosen) {
    if (window.showOpenFilePicker) {
        window.showOpenFilePicker({ id: "inbetween" }).then(async ([handle]) => {
            handles.set(handle.name, handle);
            await given(await handle.getFile(), chosen);
        }, () => chosen("", new Uint8Array()));
        return;
    }
    const input = document.createElement("input");
    input.type = "file";
    input.accept = endings;
    input.onchange = () => given(input.files[0], chosen);
    input.oncancel = () => chosen("", new Uint8Array());
    input.click();
}

export function on_drop(dropped) {
    window.addEventListener("dragover", (event) => event.preventDefault());
    window.addEventListener("drop", (event) => {
        event.preventDefault();
        for (const item of event.dataTransfer.items) {
            const file = item.getAsFile();
            if (!file) continue;
            handles.delete(file.name);
            item.getAsFileSystemHandle?.().then((handle) => handle && handles.set(handle.name, handle), () => {});
            given(file, dropped);
        }
    });
}

export function on_paste(pasted) {
    // Where a field has the keyboard, the browser keeps the keys that paste, and gives the text.
    window.addEventListener("keydown", (event) => {
        const pastes = (event.ctrlKey || event.metaKey) && !event.altKey && event.key.toLowerCase() === "v";
        if (pastes && is_typing && has_keyboard()) event.stopImmediatePropagation();
    }, { capture: true });
    document.addEventListener("paste", (event) => {
        if (!is_typing || !has_keyboard()) return;
        event.preventDefault();
        const text = event.clipboardData.getData("text/plain");
        if (text) pasted(text);
    });
}

export function set_typing(value) {
    is_typing = value;
    if (is_typing) show_keys();
    else if (document.activeElement === keys) canvas.focus();
}

// A touch screen shows its keyboard only for a field of the browser: `keys`. What is typed there goes to the canvas as keys. The field has
// one letter ahead, so that the key that deletes always finds one.
const keys = document.getElementById("keys");
const AHEAD = " ";
let handed_on = AHEAD;
let is_touched = false;

const has_keyboard = () => [canvas, keys].includes(document.activeElement);

function show_keys() {
    if (!is_touched) return;
    // A keyboard that was put away comes back for a field that gets the focus anew.
    canvas.focus();
    keys.value = handed_on = AHEAD;
    keys.focus({ preventScroll: true });
}

function press(key, more = {}) {
    const { code, ctrlKey, shiftKey, altKey, metaKey } = more;
    for (const type of ["keydown", "keyup"]) canvas.dispatchEvent(new KeyboardEvent(type, { key, code, ctrlKey, shiftKey, altKey, metaKey }));
}

window.addEventListener("pointerdown", (event) => { is_touched = event.pointerType !== "mouse"; }, { capture: true });
// Some browsers show the keyboard only while a finger is handled.
window.addEventListener("pointerup", () => { if (is_typing) show_keys(); });
// To the program the canvas and the field are one.
window.addEventListener("blur", (event) => {
    if (event.target === canvas && event.relatedTarget === keys) event.stopImmediatePropagation();
}, { capture: true });
for (const type of ["focus", "blur"]) {
    keys.addEventListener(type, (event) => {
        if (event.relatedTarget !== canvas) canvas.dispatchEvent(new FocusEvent(type));
    });
}
keys.addEventListener("keydown", (event) => {
    const makes_text = event.isComposing || event.keyCode === 229 || [...event.key].length === 1;
    if (makes_text && !event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    press(event.key, event);
});
keys.addEventListener("input", (event) => {
    // A syllable that is being composed changes: what is no longer there is deleted.
    const [old, text] = [[...handed_on], [...keys.value]];
    let same = 0;
    while (same < old.length && old[same] === text[same]) same++;
    for (let letter = same; letter < old.length; letter++) press("Backspace");
    for (const letter of text.slice(same)) press(letter === "\n" ? "Enter" : letter);
    handed_on = keys.value;
    if (!event.isComposing && !handed_on.startsWith(AHEAD)) keys.value = handed_on = AHEAD;
});

export function on_context(changed) {
    canvas.addEventListener("webglcontextlost", (event) => {
        // Without this it is not given back.
        event.preventDefault();
        changed(false);
    });
    canvas.addEventListener("webglcontextrestored", () => changed(true));
}

export function is_context_lost() {
    return canvas.getContext("webgl2")?.isContextLost() ?? true;
}

export function set_unsaved(value) {
    is_unsaved = value;
}

window.addEventListener("beforeunload", (event) => {
    if (is_unsaved) event.preventDefault();
});

export function copy(text) {
    navigator.clipboard?.writeText(text).catch(() => {});
}

export function tell(text) {
    document.getElementById("said").textContent = text;
}

export function begun_now() {
    document.getElementById("loading").hidden = true;
    canvas.focus();
}

export function ended(reason) {
    is_unsaved = false;
    const place = document.getElementById("loading");
    place.hidden = false;
    place.textContent = `Inbetween cannot go on: ${reason}. Load the page again: what was not saved is kept in this browser, and is offered.`;
}

export function language() {
    return navigator.language;
}
