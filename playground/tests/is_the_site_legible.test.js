// Does every page of the site fit a wide and a narrow screen, light and dark, without a serious fault of accessibility? `make doc` writes the site.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, relative } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { ROOT, start } from "./browser.js";

const SITE = join(ROOT, "target/site");
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

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

let browser, close;

before(async () => ({ browser, close } = await start()));
after(() => close());

const SCREENS = {
    wide: { viewport: { width: 1280, height: 960 } },
    narrow: { viewport: { width: 390, height: 844 }, colorScheme: "dark" },
};
// Each holds what others hold: a table, code, a picture, formulas, links in sentences.
const SPECIMENS = ["index.html", "docs/README.html", "docs/for-firmware.html", "docs/planner.html", "examples/06_retarget.html"];

for (const [name, options] of Object.entries(SCREENS)) {
    test(`every page fits: ${name}`, async () => {
        const all = pages(SITE);
        assert.ok(all.length > 40, `${all.length} pages`);
        const context = await browser.newContext(options);
        const page = await context.newPage();
        for (const path of [...all, join(SITE, "c/index.html"), join(SITE, "c/trajbell_8h.html")]) {
            await page.goto(pathToFileURL(path).href, { waitUntil: "load" });
            const wide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
            assert.ok(!wide, `${relative(SITE, path)} is wider than the window`);
        }
        await context.close();
    });

    test(`axe finds no serious fault: ${name}`, async () => {
        const context = await browser.newContext(options);
        const page = await context.newPage();
        for (const file of SPECIMENS) {
            await page.goto(pathToFileURL(join(SITE, file)).href, { waitUntil: "load" });
            await page.screenshot({ path: join(ROOT, "target/site-pictures", `${name}-${file.replaceAll("/", "-")}.png`) });
            await page.evaluate(axe);
            const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
            const serious = violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
            assert.deepEqual(
                serious.map(({ id, nodes }) => `${file}: ${id}: ${nodes.length}, ${nodes[0].html.slice(0, 200)}`),
                [],
            );
        }
        await context.close();
    });
}
