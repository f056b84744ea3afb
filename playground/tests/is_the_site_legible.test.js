// Does every page of the site fit a wide and a narrow screen, light and dark, without a serious fault of accessibility? `make doc` writes the site.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join, relative } from "node:path";
import { pathToFileURL } from "node:url";
import { test } from "node:test";
import { browser, faults, ROOT } from "./browser.js";

const SITE = join(ROOT, "target/site");

/** The pages of the guide: those that mdBook wrote. */
function pages(folder) {
    return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
        const path = join(folder, entry.name);
        if (entry.isDirectory()) {
            return ["c", "python", "rust"].includes(relative(SITE, path)) ? [] : pages(path);
        }
        return entry.name.endsWith(".html") && !["toc.html", "404.html", "playground.html"].includes(entry.name) ? [path] : [];
    });
}

const SCREENS = {
    wide: { viewport: { width: 1280, height: 960 } },
    narrow: { viewport: { width: 390, height: 844 }, colorScheme: "dark" },
};
// Each holds what others hold: a table, code, a picture, formulas, links in sentences; of the C reference headers and a struct.
const REFERENCE = ["c/index.html", "c/trajbell_8h.html", "c/move_8h.html", "c/structatraj__move.html"];
const GUIDE = ["index.html", "docs/README.html", "docs/for-firmware.html", "docs/planner.html", "examples/06_retarget.html"];

for (const [name, options] of Object.entries(SCREENS)) {
    test(`every page fits, and axe finds no serious fault: ${name}`, async () => {
        const files = [...pages(SITE).map((path) => relative(SITE, path)), ...REFERENCE];
        assert.ok(files.length > 40, `${files.length} pages`);
        const context = await browser.newContext(options);
        const page = await context.newPage();
        for (const file of files) {
            await page.goto(pathToFileURL(join(SITE, file)).href, { waitUntil: "load" });
            const wide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
            assert.ok(!wide, `${file} is wider than the window`);
            if ([...GUIDE, ...REFERENCE].includes(file)) {
                await page.screenshot({ path: join(ROOT, "target/site-pictures", `${name}-${file.replaceAll("/", "-")}.png`) });
                assert.deepEqual(await faults(page), [], file);
            }
        }
        await context.close();
    });
}
