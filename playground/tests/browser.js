// Headless Chromium with the page in it.
import assert from "node:assert/strict";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";
const QUIET = ["disable-gpu", "disable-quic", "no-first-run", "disable-background-networking", "disable-component-update", "disable-sync"];

export const ROOT = fileURLToPath(new URL("../../", import.meta.url));
export const OUT = `${ROOT}target/playground/`;
const PAGE = new URL("../../target/playground/index.html", import.meta.url).href;

/** The browser of a file of tests, with a new, empty profile. */
const home = await mkdtemp(join(tmpdir(), "atraj-playground-"));
export const browser = await chromium.launch({
    executablePath: CHROMIUM,
    args: ["--no-sandbox", ...QUIET.map((flag) => `--${flag}`)],
    env: { ...process.env, HOME: home },
});
after(async () => {
    await browser.close();
    await rm(home, { recursive: true, force: true });
});

/** A test on a page that must not complain. */
export function onPage(name, hash, act, options = {}) {
    test(name, async () => {
        const { page, complaints } = await open(hash, options);
        await act(page);
        assert.deepEqual(complaints, []);
        await page.context().close();
    });
}

/** Opens the page at an address. `complaints` collects what the console says, and every address that the page asks for. */
export async function open(hash = "", options = {}) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 960 }, ...options });
    context.setDefaultTimeout(5000);
    const page = await context.newPage();
    const complaints = [];
    page.on("console", (message) => complaints.push(message.text()));
    page.on("pageerror", (error) => complaints.push(String(error)));
    page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || complaints.push(request.url()));
    await page.goto(PAGE + hash);
    await settled(page);
    return { page, complaints };
}

/** The serious and critical faults. The page forbids scripts of others, so axe-core comes by the debugger. */
export async function faults(page) {
    await page.evaluate(await readFile(`${ROOT}playground/node_modules/axe-core/axe.min.js`, "utf8"));
    const { violations, passes } = await page.evaluate(() => globalThis.axe.run());
    assert.ok(passes.length > 20);
    return violations
        .filter(({ impact }) => impact === "serious" || impact === "critical")
        .flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id} at ${target}`));
}

/** Waits until the page has drawn, and has written its address and its code. */
export async function settled(page) {
    const isSettled = () => page.evaluate(() => globalThis.atraj?.isSettled());
    for (const deadline = Date.now() + 10000; !(await isSettled()); ) {
        if (Date.now() > deadline) {
            throw new Error("the page does not settle");
        }
        await page.waitForTimeout(20);
    }
}
