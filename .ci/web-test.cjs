// `node web-test.cjs PAGE PROGRAM SHOTS`: see web-test.
const { chromium } = require("playwright-core");
const { execFileSync } = require("child_process");
const fs = require("fs");
const http = require("http");
const os = require("os");
const path = require("path");

const [, , page_folder, program, shots] = process.argv;
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "web-test-"));
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm", ".json": "application/json" };
const FLAGS = [
    "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--no-sandbox", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
];

const server = http.createServer((request, answer) => {
    const name = decodeURIComponent(new URL(request.url, "http://x").pathname);
    const file = [path.join(page_folder, name === "/" ? "index.html" : name), path.join("assets/animations", name)].find((file) => fs.existsSync(file));
    if (!file) return answer.writeHead(404).end();
    const bytes = fs.readFileSync(file);
    answer.writeHead(200, { "content-type": TYPES[path.extname(file)] ?? "application/octet-stream", "content-length": bytes.length });
    answer.end(bytes);
});

let [passed, failed] = [0, 0];
function check(holds, what) {
    console.log(`${holds ? "ok" : "FAILED"}: ${what}`);
    holds ? passed++ : failed++;
}

const script = (lines) => {
    const text = path.join(folder, "keys.txt");
    fs.writeFileSync(text, lines.join("\n"));
    execFileSync(path.resolve(program), ["script", "keys.txt"], { cwd: folder });
    return fs.readFileSync(path.join(folder, "animation.json"));
};

async function main() {
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    const address = `http://127.0.0.1:${server.address().port}/`;
    const context = await chromium.launchPersistentContext(path.join(folder, "profile"), {
        executablePath: "/usr/bin/chromium", args: FLAGS, viewport: { width: 1280, height: 800 }, acceptDownloads: true, locale: "en-GB",
    });
    const said = [];
    const open = async (query = "") => {
        const page = await context.newPage();
        // Hints of the browser's GL on its own speed are none of the page's faults.
        const is_said = (message) => ["error", "warning"].includes(message.type()) && !message.text().startsWith("performance warning");
        page.on("console", (message) => is_said(message) && said.push(message.text()));
        page.on("pageerror", (error) => said.push(String(error)));
        const start = Date.now();
        await page.goto(address + query);
        await page.waitForFunction(() => document.getElementById("loading").hidden, null, { timeout: 120_000 });
        page.opened = Date.now() - start;
        return page;
    };
    const status = (page) => page.textContent("#said");
    const shot = (page, name) => page.screenshot({ path: path.join(shots, `${name}.png`) });
    const press = async (page, ...keys) => {
        for (const key of keys) {
            await page.keyboard.press(key);
            await page.waitForTimeout(120);
        }
    };
    const downloaded = async (page, key) => {
        const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press(key)]);
        return [download.suggestedFilename(), fs.readFileSync(await download.path())];
    };
    const drop = (page, name, text) => page.evaluate(([name, text]) => {
        const data = new DataTransfer();
        data.items.add(new File([text], name));
        window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, cancelable: true }));
    }, [name, text]);

    const page = await open();
    console.log(`the page opened in ${page.opened} ms`);
    await page.waitForTimeout(1500);
    await shot(page, "empty");

    await press(page, "n", "n", "n", "n");
    await page.waitForTimeout(500);
    const [name, bytes] = await downloaded(page, "w");
    check(name === "animation.json", `w downloads animation.json (${name})`);
    check(bytes.equals(script(["key n", "key n", "key n", "key n", "key w"])), "its bytes are those of the same script");
    check(/written|wrote/i.test(await status(page)), `the status line is said (${await status(page)})`);

    const handshake = fs.readFileSync("assets/animations/handshake.json", "utf8");
    await drop(page, "handshake.json", handshake);
    await page.waitForTimeout(800);
    await shot(page, "dropped");
    const [, again] = await downloaded(page, "w");
    check(again.toString() === handshake, "a dropped file is opened, and written with the same bytes");
    await press(page, "y");
    await page.waitForTimeout(1500);
    await shot(page, "playing");
    await press(page, "y");

    await press(page, "s").catch(() => {});
    const picture = await page.waitForEvent("download", { timeout: 60_000 }).catch(() => null);
    check(picture?.suggestedFilename() === "inbetween-0001.png", "s takes a screenshot");

    await press(page, "n", "n");
    await page.waitForTimeout(1500);
    await page.close({ runBeforeUnload: false });
    const second = await open();
    await second.waitForTimeout(1500);
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

    const named = await open("?file=walk.json");
    await named.waitForTimeout(1500);
    await shot(named, "file");
    const [walk_name, walk] = await downloaded(named, "w");
    check(walk_name === "walk.json" && walk.equals(fs.readFileSync("assets/animations/walk.json")), "?file= opens a file of the web site");
    await named.close();

    check(said.length === 0, `the console is silent${said.length ? `: ${[...new Set(said)].slice(0, 5).join(" | ")}` : ""}`);
    await context.close();
}

main().catch((error) => {
    console.error(error);
    failed++;
}).finally(() => {
    server.close();
    fs.rmSync(folder, { recursive: true, force: true });
    console.log(`${passed} passed, ${failed} failed`);
    process.exit(failed ? 1 : 0);
});
