// `node web-test.cjs PAGE PROGRAM SHOTS [PART…]`: see web-test.
const { chromium } = require("playwright-core");
const { execFileSync, spawnSync } = require("child_process");
const fs = require("fs");
const http = require("http");
const os = require("os");
const path = require("path");

const [, , page_folder, program_path, shots, ...wanted] = process.argv;
const program = path.resolve(program_path);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "web-test-"));
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm", ".json": "application/json" };
const FLAGS = [
    "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--no-sandbox", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
];
// The largest FLIP mean of two pictures of one moment, and the largest share of pixels that differ strikingly. The program draws by the
// driver that Chromium draws by: another one rounds differently, which nobody sees, but FLIP's mean does.
const [MEAN, STRIKING] = [0.003, 0.001];
const DRIVER = "/usr/lib/chromium/vk_swiftshader_icd.json";

// What is served beside the page and the animations.
const served = new Map();
const server = http.createServer((request, answer) => {
    const name = decodeURIComponent(new URL(request.url, "http://x").pathname);
    const found = [path.join(page_folder, name === "/" ? "index.html" : name), path.join("assets/animations", name)].find((file) => fs.existsSync(file));
    if (!found && !served.has(name)) return answer.writeHead(404).end();
    const bytes = served.get(name) ?? fs.readFileSync(found);
    answer.writeHead(200, { "content-type": TYPES[path.extname(found ?? name)] ?? "application/octet-stream", "content-length": bytes.length });
    answer.end(bytes);
});

let [passed, failed] = [0, 0];
function check(holds, what) {
    console.log(`${holds ? "ok" : "FAILED"}: ${what}`);
    holds ? passed++ : failed++;
}

const animation = (name) => fs.readFileSync(`assets/animations/${name}`, "utf8");

const script = (lines) => {
    fs.writeFileSync(path.join(folder, "keys.txt"), lines.join("\n"));
    execFileSync(program, ["script", "keys.txt"], { cwd: folder });
    return fs.readFileSync(path.join(folder, "animation.json"));
};

// What the consoles of all pages say: errors and warnings. Hints of the browser's GL on its own speed are none of the page's faults.
const said = [];

async function browser(name, more = {}) {
    const context = await chromium.launchPersistentContext(path.join(folder, name), {
        executablePath: "/usr/bin/chromium", args: FLAGS, viewport: { width: 1280, height: 800 }, acceptDownloads: true, locale: "en-GB", ...more,
    });
    context.open = async (query = "") => {
        const page = await context.newPage();
        const is_said = (message) => ["error", "warning"].includes(message.type()) && !message.text().startsWith("performance warning");
        page.on("console", (message) => is_said(message) && said.push(message.text()));
        page.on("pageerror", (error) => said.push(String(error)));
        const start = Date.now();
        await page.goto(address + query);
        await page.waitForFunction(() => document.getElementById("loading").hidden, null, { timeout: 120_000 });
        page.opened = Date.now() - start;
        await page.waitForTimeout(1500);
        return page;
    };
    return context;
}

let address;
const status = (page) => page.textContent("#said");
const shot = (page, name) => page.screenshot({ path: path.join(shots, `${name}.png`) });
// Waits for some time, and for pictures: on a busy machine they take longer.
async function rest(page, ms = 400) {
    await page.waitForTimeout(ms);
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
}

async function press(page, ...keys) {
    for (const key of keys) {
        await page.keyboard.press(key);
        await rest(page, 120);
    }
}

// What is downloaded after something was done, and its name.
async function downloaded(page, act, timeout = 120_000) {
    const [download] = await Promise.all([page.waitForEvent("download", { timeout }), act()]);
    return [download.suggestedFilename(), fs.readFileSync(await download.path())];
}

// A picture of the page once it is refined and changes no more.
async function settled(page, name) {
    let picture = await shot(page, name);
    for (let look = 0; look < 40; look++) {
        await rest(page, 1500);
        const next = await shot(page, name);
        if (next.equals(picture)) return picture;
        picture = next;
    }
    throw new Error(`${name} does not settle`);
}

const written = async (page) => (await downloaded(page, () => page.keyboard.press("w")))[1];

const drop = (page, name, text) => page.evaluate(([name, text]) => {
    const data = new DataTransfer();
    data.items.add(new File([text], name));
    window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, cancelable: true }));
}, [name, text]);

async function drag(page, [x, y], [by_x, by_y]) {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + by_x, y + by_y, { steps: 8 });
    await page.mouse.up();
    await rest(page);
}

// The paths of the nodes whose places differ in the last two keyframes.
function moved(bytes) {
    const { nodes, keyframes } = JSON.parse(bytes);
    const [before, after] = keyframes.slice(-2).map((keyframe) => keyframe.pose);
    return nodes.filter((_, index) => JSON.stringify(before[index]) !== JSON.stringify(after[index]));
}

// How two PNG files differ.
function compared(one, other) {
    const { stdout } = spawnSync(program, ["compare", "--json", one, other], { encoding: "utf8" });
    return JSON.parse(stdout);
}

async function files(context) {
    const page = await context.open();
    console.log(`the page opened in ${page.opened} ms`);
    await shot(page, "empty");
    await press(page, "n", "n", "n", "n");
    await rest(page, 500);
    const [name, bytes] = await downloaded(page, () => page.keyboard.press("w"));
    check(name === "animation.json", `w downloads animation.json (${name})`);
    check(bytes.equals(script(["key n", "key n", "key n", "key n", "key w"])), "its bytes are those of the same script");
    check(/written|wrote/i.test(await status(page)), `the status line is said (${await status(page)})`);

    await drop(page, "handshake.json", animation("handshake.json"));
    await rest(page, 800);
    await shot(page, "dropped");
    check((await written(page)).toString() === animation("handshake.json"), "a dropped file is opened, and written with the same bytes");
    await press(page, "y");
    await rest(page, 1500);
    await shot(page, "playing");
    await press(page, "y");
    const [picture] = await downloaded(page, () => page.keyboard.press("s"));
    check(picture === "inbetween-0001.png", "s takes a screenshot");

    await press(page, "n", "n");
    await rest(page, 1500);
    await page.close({ runBeforeUnload: false });
    const second = await context.open();
    await shot(second, "recovery");
    const kept = await second.evaluate(async () => {
        const request = indexedDB.open("inbetween", 1);
        await new Promise((resolve) => { request.onsuccess = resolve; });
        const keys = request.result.transaction("files").objectStore("files").getAllKeys();
        await new Promise((resolve) => { keys.onsuccess = resolve; });
        return keys.result.map(([file]) => file);
    });
    check(kept.some((file) => file.endsWith(".journal")), `journals are kept (${new Set(kept).size} files)`);
    await second.close();
}

// Refined pictures on both sides: the page's own of what it shows, and the program's of the same key time.
async function pictures(context) {
    const page = await context.open("?file=walk.json");
    // From the eye that keyframes record, without the arcball around it.
    await press(page, "0", "a", ".");
    let ticks = 0;
    for (const tick of [0, 7, 22, 40, 61]) {
        for (; ticks < tick; ticks++) await page.keyboard.press("ArrowRight");
        await rest(page);
        const [, png] = await downloaded(page, () => page.keyboard.press("s"));
        const [ours, theirs, usual] = ["page", "program", "usual"].map((side) => path.join(shots, `walk-${tick}-${side}.png`));
        fs.writeFileSync(ours, png);
        const size = `${png.readUInt32BE(16)}x${png.readUInt32BE(20)}`;
        // walk.json has 250 ms between keyframes, which are 15 ticks.
        const at = String(tick / 15);
        const render = (to, env) => {
            const options = ["--at", at, "--size", size, "--quality", "good", "--quiet"];
            execFileSync(program, ["render", "assets/animations/walk.json", "-o", to, ...options], { env: { ...process.env, ...env } });
        };
        render(theirs, { VK_DRIVER_FILES: DRIVER, VK_ICD_FILENAMES: DRIVER });
        const { mean, striking, score } = compared(ours, theirs);
        check(mean <= MEAN && striking <= STRIKING, `tick ${tick}: FLIP mean ${mean}, ${100 * striking} % of pixels above 0.3, worst thousandth ${score} (${size})`);
        render(usual, {});
        const other = compared(ours, usual);
        check(other.striking <= STRIKING, `tick ${tick}: nothing strikes beside the usual driver's picture (worst thousandth ${other.score}, mean ${other.mean})`);
    }
    await page.close();
}

async function gestures(context) {
    const page = await context.open();
    await press(page, "n");
    await drag(page, [700, 110], [120, 30]);
    await shot(page, "orbited");
    await press(page, "n");
    check(moved(await written(page)).length === 0, "a drag on nothing looks around and poses nothing");
    await press(page, "1");
    await rest(page, 500);
    await drag(page, [455, 190], [10, 70]);
    await shot(page, "posed");
    await press(page, "n");
    const posed = moved(await written(page));
    check(posed.length === 1 && posed[0].startsWith("robot1/"), `a drag on a limb poses it (${posed})`);
    await press(page, "Control+z", "Control+z", "n");
    check(moved(await written(page)).length === 0, "Ctrl+Z takes it back");
    await page.close();
}

// The canvas loses what draws on it, and has it again after so many milliseconds.
const lose = (page, ms) => page.evaluate(async (ms) => {
    const loss = document.getElementById("scene").getContext("webgl2").getExtension("WEBGL_lose_context");
    loss.loseContext();
    await new Promise((resolve) => setTimeout(resolve, ms));
    loss.restoreContext();
}, ms);

async function lost_context(context) {
    const page = await context.open();
    await drop(page, "walk.json", animation("walk.json"));
    await rest(page, 800);
    await press(page, "n", ".");
    const before = await settled(page, "before-loss");
    const quiet = said.length;
    for (const ms of [50, 1200]) {
        await lose(page, ms);
        // Keys count again when there is a picture.
        await rest(page, 2000);
        await press(page, ".");
        await rest(page, 1000);
        await press(page, ",");
    }
    const after = await settled(page, "after-loss");
    const notices = said.splice(quiet);
    check(notices.every((notice) => /context.?lost|loseContext/i.test(notice)), `a lost context gives no error but the browser's notice (${notices})`);
    check(await page.evaluate(() => document.getElementById("loading").hidden), "the page goes on");
    const [one, other] = ["before", "after"].map((when) => path.join(shots, `${when}-loss.png`));
    const { score } = compared(one, other);
    check(score < 0.06, `the picture comes back (${score}; ${before.length} and ${after.length} bytes)`);
    const count = JSON.parse(await written(page)).keyframes.length;
    check(count === JSON.parse(animation("walk.json")).keyframes.length + 1, `nothing is lost (${count} keyframes)`);
    await page.close();
}

// Fingers on a touch screen, each with an id and a place.
async function touch(page, type, ...points) {
    page.session ??= await page.context().newCDPSession(page);
    await page.session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([id, x, y]) => ({ id, x, y })) });
    await rest(page, 30);
}

async function touch_screen() {
    const context = await browser("phone", { viewport: { width: 400, height: 800 }, hasTouch: true, isMobile: true });
    const page = await context.open();
    await shot(page, "phone");
    await press(page, "n", "1");
    await rest(page, 600);
    await shot(page, "phone-front");
    const one = async ([x, y], [by_x, by_y]) => {
        await touch(page, "touchStart", [1, x, y]);
        for (let step = 1; step <= 12; step++) await touch(page, "touchMove", [1, x + (by_x * step) / 12, y + (by_y * step) / 12]);
        await touch(page, "touchEnd");
        await rest(page);
    };
    // The right leg of the left robot.
    const limb = [62, 300];
    await one(limb, [50, -20]);
    await shot(page, "phone-posed");
    await press(page, "n");
    const posed = moved(await written(page));
    check(posed.length === 1 && posed[0].startsWith("robot1"), `a finger poses (${posed})`);

    const before = await shot(page, "phone-before-pinch");
    const [x, y] = limb;
    await touch(page, "touchStart", [1, x, y]);
    await touch(page, "touchStart", [1, x, y], [2, x + 80, y]);
    // Two fingers that rest are no long touch, which opens a menu.
    await rest(page, 1200);
    for (let step = 1; step <= 12; step++) await touch(page, "touchMove", [1, x - 4 * step, y], [2, x + 80 + 4 * step, y]);
    await touch(page, "touchEnd");
    await rest(page, 800);
    const after = await shot(page, "phone-pinched");
    check(!before.equals(after), "two fingers zoom");
    await press(page, "n");
    check(moved(await written(page)).length === 0, "two fingers pose nothing");
    await one([300, 330], [-60, -50]);
    await shot(page, "phone-orbited");
    await press(page, "n");
    check(moved(await written(page)).length === 0, "a finger on nothing looks around");

    // The button at the right end of the transport.
    const button = [382, 800 - 22 - 200 - 16];
    await page.touchscreen.tap(...button);
    await rest(page, 800);
    await shot(page, "phone-side");
    await page.touchscreen.tap(...button);
    await page.touchscreen.tap(20, 12);
    await rest(page, 800);
    await shot(page, "phone-menu");
    await context.close();
    await typed_by_touch();
    const korean = await browser("korean", { viewport: { width: 400, height: 800 }, locale: "ko-KR" });
    const second = await korean.open("?file=walk.json");
    await shot(second, "phone-korean");
    await press(second, "Control+e");
    await rest(second, 800);
    await shot(second, "phone-export");
    await korean.close();
}

// A touch screen's keyboard types into a field of the browser, in which syllables are composed.
async function typed_by_touch() {
    const context = await browser("keys", { viewport: { width: 800, height: 900 }, hasTouch: true });
    const page = await context.open();
    page.session = await page.context().newCDPSession(page);
    const place = () => page.evaluate(() => document.activeElement.id);
    await press(page, "n");
    await page.touchscreen.tap(400, 120);
    check(await place() === "scene", "a tap on the scene shows no keyboard");
    await press(page, "F2");
    await rest(page, 500);
    check(await place() === "keys", `a field that is tapped or opened shows the keyboard (${await place()})`);
    await press(page, "Control+a", "Backspace", "Backspace");
    for (const text of ["ㅎ", "하", "한"]) {
        await page.session.send("Input.imeSetComposition", { text, selectionStart: 1, selectionEnd: 1 });
        await rest(page, 100);
    }
    await page.keyboard.insertText("한");
    await page.keyboard.type(" leg!");
    await press(page, "Backspace", "ArrowLeft", "ArrowLeft", "ArrowLeft");
    await page.keyboard.type("1 ");
    await shot(page, "typed-by-touch");
    await press(page, "Enter");
    await rest(page, 500);
    check(await place() === "scene", `then it goes away (${await place()})`);
    const [{ name }] = JSON.parse(await written(page)).keyframes;
    check(name === "한 1 leg", `what a touch screen's keyboard types comes to the field (${name})`);
    await context.close();
}

const clipboard = (page) => page.evaluate(() => navigator.clipboard.readText());

async function text_fields(context) {
    await context.grantPermissions(["clipboard-read", "clipboard-write"]);
    const page = await context.open();
    await press(page, "Control+n", "n");
    await page.evaluate(() => navigator.clipboard.writeText("from elsewhere"));
    await press(page, "F2");
    await rest(page, 500);
    await press(page, "Control+a", "Control+v");
    await shot(page, "pasted");
    await press(page, "Enter");
    check(JSON.parse(await written(page)).keyframes[0].name === "from elsewhere", "Ctrl+V pastes the system's text into a field");
    await press(page, "F2");
    await rest(page, 500);
    await press(page, "Control+a");
    await page.keyboard.type("typed here");
    await press(page, "Control+a", "Control+c");
    await rest(page, 500);
    await press(page, "Escape");
    await rest(page, 500);
    check(await clipboard(page) === "typed here", `Ctrl+C copies (${await clipboard(page)})`);
    await press(page, "Control+c", "Control+v");
    check(JSON.parse(await written(page)).keyframes.length === 2, "outside of fields they copy and paste keyframes");
    await page.close();
}

// Keys that both the browser and the program have: Playwright's do not reach the browser, so what counts is whether they would.
async function keys_of_the_browser(context) {
    const page = await context.open();
    await page.evaluate(() => window.addEventListener("keydown", (event) => {
        if (event.key !== "Control") window.is_taken = event.defaultPrevented;
    }));
    const is_taken = async (key) => {
        await press(page, key);
        const taken = await page.evaluate(() => window.is_taken);
        await press(page, "Escape");
        return taken;
    };
    const all = ["Control+r", "Control+1", "Control+s", "Control+z", "F1"];
    for (const key of all) check(await is_taken(key), `${key} is the program's while the canvas has the focus`);
    await page.evaluate(() => document.getElementById("scene").blur());
    for (const key of all) check(!(await is_taken(key)), `${key} is the browser's otherwise`);
    await page.close();
}

async function addresses(context) {
    served.set("/copy/walk.json", Buffer.from(animation("handshake.json")));
    served.set("/no-keyframes.json", Buffer.from('{"some": "thing"}'));
    const named = await context.open("?file=walk.json");
    await shot(named, "file");
    const [name, walk] = await downloaded(named, () => named.keyboard.press("w"));
    check(name === "walk.json" && walk.toString() === animation("walk.json"), "?file= opens a file of the web site");
    await named.close();
    served.set("/순이 C#1.json", Buffer.from(animation("walk.json")));
    const other = await context.open(`?file=${encodeURIComponent("순이 C#1.json")}`);
    check(/순이 C#1.json/.test(await status(other)), `a name may have letters of addresses (${await status(other)})`);
    await other.close();
    const both = await context.open("?file=walk.json&compare=copy/walk.json");
    check(/compared\/walk.json/.test(await status(both)), `two files of one name are compared (${await status(both)})`);
    await both.close();
    for (const [query, sentence] of [
        ["?file=none.json", /none.json cannot be shown: the web site says 404/],
        ["?scene=none.json", /none.json cannot be shown: the web site says 404/],
        ["?file=walk.json&compare=none.json", /none.json cannot be shown: the web site says 404/],
        ["?file=https://example.org/walk.json", /https:\/\/example.org\/walk.json is on another web site/],
        ["?file=no-keyframes.json", /no-keyframes.json/],
        ["?scene=walk.json", /walk.json/],
        ["?compare=walk.json", /walk.json.*needs \?file=/],
    ]) {
        const quiet = said.length;
        const page = await context.open(query);
        check(sentence.test(await status(page)), `${query}: ${await status(page)}`);
        // The browser itself says which addresses do not exist.
        const more = said.splice(quiet).filter((line) => !/404/.test(line));
        check(more.length === 0, `${query}: the console is silent (${more})`);
        await press(page, "n", "n");
        check(JSON.parse(await written(page)).keyframes.length >= 2, `${query}: the page is usable`);
        await page.close();
    }
}

// Width, height and number of frames of a GIF or an APNG.
function film_size(bytes) {
    if (bytes.toString("latin1", 1, 4) === "PNG") {
        const frames = bytes.indexOf("acTL");
        return [bytes.readUInt32BE(16), bytes.readUInt32BE(20), frames < 0 ? 1 : bytes.readUInt32BE(frames + 4)];
    }
    const table = (flags) => (flags & 0x80 ? 3 << ((flags & 7) + 1) : 0);
    let [at, frames] = [13 + table(bytes[10]), 0];
    const skip_blocks = () => {
        while (bytes[at]) at += bytes[at] + 1;
        at++;
    };
    while (bytes[at] !== 0x3b && at < bytes.length) {
        if (bytes[at] === 0x21) {
            at += 2;
        } else {
            frames++;
            at += 11 + table(bytes[at + 9]);
        }
        skip_blocks();
    }
    return [bytes.readUInt16LE(6), bytes.readUInt16LE(8), frames];
}

async function films(context) {
    served.set("/short.json", Buffer.from(script(["key n", "select robot2/head", "rotate y 40", "key n", "rotate y 40", "key n", "key n", "ms 400", "key w"])));
    fs.writeFileSync(path.join(folder, "short.json"), served.get("/short.json"));
    // The dialog's first field is the path; its list of formats stands above it.
    const [formats, apng] = [[620, 225], [560, 276]];
    for (const [ending, loses] of [["gif", false], ["apng", false], ["gif", true]]) {
        const page = await context.open("?file=short.json");
        await press(page, "Control+e");
        await rest(page, 800);
        if (ending === "apng") {
            await page.mouse.move(...formats);
            await rest(page);
            await page.mouse.click(...formats);
            await rest(page, 1500);
            await shot(page, "export-formats");
            await page.mouse.move(...apng);
            await rest(page);
            await page.mouse.click(...apng);
            await rest(page, 1500);
        }
        await shot(page, `export-${ending}`);
        const [name, bytes] = await downloaded(page, async () => {
            await page.keyboard.press("Enter");
            if (!loses) return;
            await rest(page, 500);
            await shot(page, "exporting");
            await lose(page, 300);
        }, 300_000);
        fs.writeFileSync(path.join(shots, `film-${loses}.${ending}`), bytes);
        const reference = path.join(folder, `reference.${ending}`);
        execFileSync(program, ["render", path.join(folder, "short.json"), "-o", reference, "--quiet"]);
        const [found, expected] = [film_size(bytes), film_size(fs.readFileSync(reference))].map(String);
        const how = loses ? ", and goes on after a lost context" : "";
        check(name.endsWith(`.${ending}`) && found === expected, `a film is exported${how} (${name}: ${found}; the program's: ${expected})`);
        await rest(page, 1000);
        await shot(page, `exported-${ending}`);
        await page.close();
    }
    const page = await context.open("?file=walk.json");
    await press(page, "Control+e");
    await rest(page, 800);
    await page.keyboard.press("Enter");
    await rest(page, 1500);
    await shot(page, "before-cancel");
    await page.mouse.click(862, 81);
    await rest(page, 2500);
    await shot(page, "cancelled");
    check(/cancelled/.test(await status(page)), `an export is cancelled (${await status(page)})`);
    await page.close();
}

async function about(context) {
    const page = await context.open();
    await press(page, "Control+Shift+p");
    await page.keyboard.type("about");
    await rest(page, 500);
    await press(page, "Enter");
    await rest(page, 500);
    await shot(page, "about");
    // The link to the licences.
    await page.mouse.click(525, 321);
    await rest(page, 800);
    await shot(page, "licences");
    const licences = fs.readFileSync(path.join(page_folder, "THIRD-PARTY.txt"), "utf8");
    for (const part of ["The page's script inbetween.js", "web-sys 0.", "The standard library of Rust"]) {
        check(licences.includes(part), `the licences name ${part}`);
    }
    await page.close();
}

const PARTS = { files, pictures, gestures, lost_context, touch_screen, text_fields, keys_of_the_browser, addresses, films, about };

async function main() {
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    address = `http://127.0.0.1:${server.address().port}/`;
    for (const [name, part] of Object.entries(PARTS)) {
        if (wanted.length && !wanted.includes(name)) continue;
        console.log(`-- ${name}`);
        const context = await browser(name);
        await part(context).catch((error) => check(false, `${name}: ${error.stack}`));
        await context.close();
    }
    check(said.length === 0, `the console is silent${said.length ? `: ${[...new Set(said)].slice(0, 5).join(" | ")}` : ""}`);
}

main().catch((error) => check(false, error.stack)).finally(() => {
    server.close();
    fs.rmSync(folder, { recursive: true, force: true });
    console.log(`${passed} passed, ${failed} failed`);
    process.exit(failed ? 1 : 0);
});
